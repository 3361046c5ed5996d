"""Las órdenes de ./lab que compilan y dibujan de verdad (lo demás, en ordenes_test.py), en una copia con lo mínimo: lo
que se estropea se nota y lo que se puede arreglar se arregla, también cuando su carpeta pasa a tener el peor nombre
posible. Cada prueba sigue donde la anterior."""
import contextlib
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from mentira import faltan, siembra

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))
sys.path.insert(0, str(RAIZ / "herramientas"))
from base import catalogo
from web.pagina import Pagina

SALE = "build", "galeria", "web", "informe", "mios", "windows", ".git"
GUION = r"""tecla a ×2; tecla '; tecla "; tecla $; tecla <; tecla \; tecla b"""
UNO, DOS, TRES = (f"ch01_intro/{p}.cpp" for p in ("primer_programa", "primer_programa_dos", "shader_basico"))
GOLDEN = "tests/golden/ch01_intro/"
CAPITULO = r"""capitulo("Título; con punto y coma")
programa(primer_programa REF "L1.1" TITULO "Uno")
  caso(primer_programa base
    MIRA "Mira; y \"[remira]\" \\")
programa(primer_programa_dos REF "L1.1" TITULO "Dos" CONTRA "a; b" PRUEBAS ch01.A.B ch01.C)
  caso(primer_programa_dos base GUION "tecla a ×2; tecla '; tecla \"; tecla $; tecla <; tecla \\; tecla b"
    BORDE "abajo derecha: llega" ANIMA "3 tecla i; tecla d"
    MIRA "Dos")
programa(shader_basico REF "L1.2" TITULO "Tres")
target_compile_definitions(shader_basico PRIVATE LAB_FUENTES="${CMAKE_SOURCE_DIR}")
  caso(shader_basico base
    MIRA "Tres")
"""
NUEVO = """programa(nuevo REF "E1.2" TITULO "Cuatro" CONTRA "una cuenta" PRUEBAS ch01.Nuevo.EsLoQueEs)
target_compile_definitions(nuevo PRIVATE LAB_FUENTES="${CMAKE_SOURCE_DIR}")
  caso(nuevo base
    MIRA "Es nuevo")
"""
PRUEBAS = """configure_file(${CMAKE_SOURCE_DIR}/herramientas/base/entorno.txt ${CMAKE_BINARY_DIR}/entorno.txt COPYONLY)
add_custom_target(finitos)
add_test(NAME imagen
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/casos/casos.sh ${CMAKE_BINARY_DIR} ${LAB_SIN_VENTANA} shader_basico)
"""
CON_PROGRAMA = """add_executable(ch01_test capitulos/ch01_test.cpp)
target_link_libraries(ch01_test PRIVATE comun)
target_compile_definitions(ch01_test PRIVATE PROGRAMA="${CMAKE_BINARY_DIR}/${LAB_SIN_VENTANA}/ch01_intro/")
"""
CH01_TEST = r"""#include <iostream>
#include <string>
#include <unistd.h>
int main(int, char **argv) {
    if (argv[1] == std::string("--gtest_list_tests"))
        return std::cout << "Programa.\n  Acaba\n", 0;
    const std::string imagen = std::string(getenv("TMPDIR")) + "/p.ppm"; // queda: quien la ejecuta lo borra
    return execl(PROGRAMA "primer_programa_dos", "", "-ppm", imagen.c_str(), nullptr);
}
"""
ASSETS = r"""#include <fstream>
#include <string>
int main(int, char **argv) { std::ofstream(std::string(argv[1]) + "/luz.rgb") << "luz"; }
"""


def sobra(carpeta, nombres):
    """De la raíz, lo que sale de los fuentes; los capítulos, menos el primero; los defectos y los apuntados, y las
    pruebas."""
    no = re.compile(r"ch(0[2-9]|1)|(errores|mutantes|plantados\.tsv|.*_test\.cpp)$")
    return [n for n in nombres if no.match(n) or (Path(carpeta) == RAIZ and n in SALE)]


class Copia:
    """Dos programas que son uno y otro más. Compila antes: sin optimizar, con lo que de common/ hay en BUILD, salvo lo
    que sabe en qué carpeta está, y con pocos assets/."""

    def __init__(self, sitio):
        self.sitio, self.raiz, self.temporal = sitio, sitio / "lab (1) g[h] ñ", sitio / "tmp"
        self.temporal.mkdir()
        self.entorno = {c: v for c, v in os.environ.items() if c not in ("DISPLAY", "WAYLAND_DISPLAY", "LAB_CERROJO")}
        self.entorno |= {"LAB_SIN_INSTALAR": "1", "TMPDIR": str(self.temporal)}
        shutil.copytree(RAIZ, self.raiz, ignore=sobra)
        for hecho in ("comun.dir", "glut_sin_ventana.dir"):  # en BUILD, otro usuario puede no poder leer
            shutil.copytree(BUILD / "CMakeFiles" / hecho, sitio / hecho)
        self.cambia("CMakePresets.json", '"Release"', '"None"')
        glut = f'file(GLOB glut "{sitio}/glut_sin_ventana.dir/glut/sin_ventana/*.o")\n'
        for f in ("CMakeLists.txt", "common/comun.cmake"):
            self.cambia(f, r"common/(?!rutas)(\w+\.cpp)", rf'"{sitio}/comun.dir/common/\1.o"')
            self.cambia(f, r"\$<TARGET_OBJECTS:glut_sin_ventana>", "${glut}")
            self.cambia(f, r"(?=add_library\(glut_egl)", glut)
            self.cambia(f, r"(target_precompile_headers\(precompilada PRIVATE)[^)]*", r"\1 <cstdio>")
        self.cambia("assets/CMakeLists.txt", r"set\(texturas[^)]*\)", "set(texturas luz)")
        self.cambia("tests/CMakeLists.txt", r"(?s)find_package\(GTest.*", PRUEBAS)
        siembra(self.raiz, {"assets/genera_assets.cpp": ASSETS, "ch01_intro/CMakeLists.txt": CAPITULO})
        siembra(self.raiz, {"herramientas/mide/CMakeLists.txt": ""})  # usa programas que aquí no están
        siembra(self.raiz, {"tests/propiedades/propiedades.py": ""})  # las cumple todo
        for uno in (UNO, f"{GOLDEN}primer_programa.ppm", f"{GOLDEN}primer_programa.txt"):
            shutil.copy(self.raiz / uno, self.raiz / uno.replace("programa.", "programa_dos."))

    def __call__(self, orden, estado=0, *dice, quien=None, **entorno):
        """Ejecuta ./lab ORDEN: con ese estado, y con cada uno de esos textos en lo que dice."""
        como = {"text": True, "stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        como |= {"cwd": self.raiz, "env": self.entorno | entorno, **(quien or {})}
        r = subprocess.run(["./lab", *orden.split()], **como)
        assert (r.returncode, faltan(r.stdout, *dice)) == (estado, []), f"{orden}: {r.stdout[-3000:]}"
        assert not list(self.temporal.iterdir())
        return r.stdout

    def cambia(self, fichero, viejo, nuevo):
        texto = (self.raiz / fichero).read_text()
        (self.raiz / fichero).write_text(re.sub(viejo, nuevo, texto, flags=re.M))

    def anade(self, fichero, texto):
        with open(self.raiz / fichero, "a") as f:
            f.write(texto)

    @contextlib.contextmanager
    def con(self, *ficheros):
        """Al salir, los deja como estaban."""
        antes = {f: (self.raiz / f).read_bytes() for f in ficheros}
        yield
        for f, datos in antes.items():
            (self.raiz / f).write_bytes(datos)

    def mutantes(self, *filas):
        siembra(self.raiz, {"tests/mutantes/ch01.tsv": "".join("\t".join(fila) + "\n" for fila in filas)})


@pytest.fixture(scope="module")
def lab():
    with tempfile.TemporaryDirectory() as sitio:
        os.chmod(sitio, 0o755)  # lo lee otro usuario
        yield Copia(Path(sitio))


def test_el_catalogo_es_lo_que_dice_cmake(lab):
    lab("prueba", 0, "100% tests passed")
    [capitulo] = catalogo.lee(lab.raiz / "build")
    uno, dos, tres = capitulo.programas
    assert (capitulo.titulo, uno.casos[0].mira) == ("Título; con punto y coma", 'Mira; y "[remira]" \\')
    assert (uno.pruebas, dos.contra, dos.pruebas) == ([], "a; b", ["ch01.A.B", "ch01.C"])
    [caso] = dos.casos
    assert (caso.guion, caso.borde, caso.anima) == (GUION, "abajo derecha: llega", "3 tecla i; tecla d")
    lee = """caso() { local "$@"; printf '%s\n' "$nombre" "$fichero" "$guion" "$tolerancia$otro$borde"; }; . "$0" """
    dado = subprocess.check_output(["bash", "-c", lee, lab.raiz / "build/casos/primer_programa_dos.sh"], text=True)
    assert dado.splitlines() == ["base", "primer_programa_dos", GUION, "abajo derecha: llega"]


def test_una_imagen_distinta_y_dora(lab):
    """Si falla, el estado no es 0 y quedan las imágenes; sin ninguna prueba, tampoco es 0. Y dora rehace lo que se
    nombra y nada más."""
    uno, dos, bueno = (lab.raiz / GOLDEN / Path(programa).with_suffix(".ppm").name for programa in (UNO, DOS, TRES))
    esperado = bueno.read_bytes()
    shutil.copy(uno, bueno)
    lab("prueba", 8, "lo que ha fallado, con sus imágenes, está en")
    assert list(lab.raiz.glob("build/fallos/*/*.png"))
    lab("prueba -R nada", 8, "No tests were found")
    uno.write_bytes(b"")
    dos.write_bytes(b"")
    lab("dora primer_programa shader_basico", 0, "primer_programa: ")
    (lab.sitio / "esperado.ppm").write_bytes(esperado)
    compara = lab.raiz / "build/herramientas/comparador/compara"
    assert subprocess.run([compara, lab.sitio / "esperado.ppm", bueno, "--amplia"]).returncode == 0
    assert uno.read_bytes() and not dos.read_bytes()


BUENO = (UNO, "glClearColor(1.0f, «1.0f», 0.0f", "0.0f", "rojo por amarillo")
NADIE = (UNO, "case 'd': «glutPostRedisplay();»", ";", "no dibuja")


def test_muta_dice_que_no_se_puede_plantar(lab):
    lab.cambia("herramientas/pruebas/muta.py", "^MINIMO = .*", "MINIMO = 4")
    lab.cambia("herramientas/pruebas/muta.py", "^META, .*", "META, META_SIN_IMAGEN, META_INDEPENDIENTE = 50, 25, 25")
    lab.mutantes(
        (UNO, "esto no está", "x", "signo"),
        (DOS, "falta una columna"),
        (TRES, "«3», GL_FLOAT", "3", "es igual"),
        (TRES, "«, 2, GL_FLOAT,» GL_FALSE", ", 3, GL_FLOAT,", "se pisa"),
        (TRES, "«2, GL_FLOAT, GL_FALSE», ", "3, GL_FLOAT, GL_TRUE", "con este"),
        ("ch01_intro/errores_shader.vert", "«nuevoColor» = color", "noEsta", "no compila"),
    )
    dice = f"ch01:1: «esto no está» está 0 veces en {UNO}", "ch01:2: son fichero, texto", f"{TRES}: se pisa con otro"
    dice += (
        "ch01:3: ««3», GL_FLOAT» está 0 veces",
        "ch01:6: no compila: ",
        f"ningún mutante en {Path(DOS).with_suffix('')}",
    )
    lab("muta --comprueba", 1, *dice)
    lab.mutantes(BUENO, (UNO, "return «0»", "0", "es igual"), (DOS, "return «0»", "1", "estado"))
    lab("muta --comprueba", 1, "ch01:2: no cambia nada", "hay 3 mutantes, y deben ser 4")


def test_muta_los_planta(lab):
    """Uno lo nota la prueba; otro, solo un golden; otros, nadie: uno dice por qué."""
    siembra(lab.raiz, {"tests/capitulos/ch01_test.cpp": CH01_TEST})
    lab.anade("tests/CMakeLists.txt", CON_PROGRAMA)
    notado = (DOS, "return «0»;", "1", "estado")
    tres = [BUENO, notado, (TRES, "«glDeleteShader(shader);» // marcado", ";", "no se borra", "no se ve")]
    lab.mutantes(*tres, (*NADIE[:2], "noEsta();", NADIE[3]))
    lab("muta", 1, "error: ‘noEsta’")
    lab.mutantes(*tres, NADIE)
    lab("muta", 1, "primer_programa_dos.base: falla sin ningún mutante")
    shutil.copy(lab.raiz / f"{GOLDEN}primer_programa.ppm", lab.raiz / f"{GOLDEN}primer_programa_dos.ppm")
    lab("muta ch01:4", 1, f"ch01:4      {UNO}, no dibuja: SOBREVIVE, nada lo ejecuta")
    lab.mutantes(*tres, (*NADIE, "nadie lo pulsa"))
    lab("muta ch01:4", 0, "nadie lo pulsa", "quedan 3 pendientes")
    lab("muta pendientes", 0, "| total | 4 | 2 | 50.0 | 1 | 25.0 | 1 | 25.0 |")
    lab("lista --docs")
    cuenta = '"ch01": {"hay": 4, "plantados": 4, "notados": 2, "sin_golden": 1, "encima": 0}'
    assert cuenta in (lab.raiz / "docs/evidencia.json").read_text()
    with lab.con("herramientas/pruebas/muta.py", "tests/mutantes/ch01.tsv"):
        lab.cambia(
            "herramientas/pruebas/muta.py", "^META, .*", "META, META_SIN_IMAGEN, META_INDEPENDIENTE = 50, 25, 26"
        )
        lab("muta", 1, "se deben notar el 50 %; sin mirar las imágenes, el 25 %; y sin lo de encima, el 26 %")
        lab.cambia("tests/mutantes/ch01.tsv", "\testado$", "\testado\tno se ve")
        lab("muta ch01:2", 1, "o se notan y tienen uno: ch01:2")


def dura(webp):
    """Su talla y los segundos que dura."""
    datos, lugar, ms = webp.read_bytes(), 12, 0
    while lugar < len(datos):
        tipo, largo = struct.unpack_from("<4sI", datos, lugar)
        if tipo == b"ANMF":
            ms += int.from_bytes(datos[lugar + 20 : lugar + 23], "little")
        lugar += 8 + largo + largo % 2
    return *(1 + int.from_bytes(datos[i : i + 3], "little") for i in (24, 27)), ms / 1000


def test_galeria(lab):
    """Un caso con ANIMA tiene además una animación y sus cuadros."""
    lab("galeria", 0, "Hecha: ")
    dibujado = lab.raiz / "galeria/ch01_intro"
    assert struct.unpack_from(">II", (dibujado / "shader_basico.png").read_bytes(), 16) == (1440, 1080)
    assert {f.name: dura(f) for f in dibujado.glob("*.webp")} == {"primer_programa_dos.anima.webp": (480, 360, 0.3)}
    tallas = {}
    for cuadro in dibujado.glob("*/*"):
        datos = cuadro.read_bytes()
        tallas[f"{cuadro.parent.name}/{cuadro.name}"] = struct.unpack_from("<HH", datos, datos.index(b"\x9d\x01*") + 3)
    assert tallas == {f"primer_programa_dos.anima/00{i}.webp": (1280, 960) for i in range(3)}
    enlaza = (
        'srcset="ch01_intro/primer_programa_dos.anima.webp" media="screen and (prefers-reduced-motion: no-preference)"'
    )
    assert enlaza in (lab.raiz / "galeria/index.html").read_text()
    with lab.con("ch01_intro/CMakeLists.txt"):
        lab.cambia("ch01_intro/CMakeLists.txt", "3 tecla i; tecla d", "cuatro")
        lab("galeria", 1, "ANIMA es el número de cuadros")


def test_lo_que_no_compila_no_impide_ver_lo_demas(lab):
    """Aunque los avisos fueran errores."""
    with lab.con(UNO, TRES):
        lab.anade(TRES, "static int noSeUsa() { return 0; }\n")
        lab("prueba", 1, "noSeUsa")
        lab("nuevo shader_basico mio")  # los de lo propio, ni entonces; y encuentra sus shaders
        lab.anade("mios/mio/mio.cpp", "static int tampocoSeUsa() { return 0; }\n")
        lab("ver mio", 0, "tampocoSeUsa")
        shutil.rmtree(lab.raiz / "mios")
        lab.anade(UNO, "int estoNoCompila(\n")
        lab("ver shader_basico", 0, "lo he dibujado en shader_basico.png")
        lab("galeria", 1, "no compila")


def test_se_arregla_de_lo_que_le_falte(lab):
    (lab.raiz / "build/CMakeFiles/rules.ninja").unlink()
    lab("lista", 0, "Tres")


def test_un_programa_mas(lab):
    """Con lo que dice CONTRIBUTING.md: su fuente, con sus shaders; sus líneas en el CMakeLists.txt del capítulo; su
    prueba; y sus defectos plantados. Lo demás sale de ahí."""
    for f in lab.raiz.glob("ch01_intro/shader_basico.*"):
        f.with_stem("nuevo").write_text(f.read_text().replace("shader_basico", "nuevo"))
    lab.anade("ch01_intro/CMakeLists.txt", NUEVO)
    lab.cambia("tests/capitulos/ch01_test.cpp", "Acaba", r"Acaba\\nNuevo.\\n  EsLoQueEs")
    lab("muta --comprueba", 1, "ningún mutante en ch01_intro/nuevo")
    defecto = "ch01_intro/nuevo.cpp", "«glDeleteShader(shader);» // marcado", ";", "no se borra", "no se ve"
    lab.anade("tests/mutantes/ch01.tsv", "\t".join(defecto) + "\n")
    lab("muta --comprueba", 0, "5 mutantes, y todos se pueden plantar")
    lab("dora nuevo", 0, "nuevo: nueva")
    lab("galeria", 0, "ch01_intro/nuevo: 1 imagen")
    assert '{"nuevo", ' in (lab.raiz / "build/generado/controles.inc").read_text()
    lab("lista --docs")
    hechas = (lab.raiz / carpeta for carpeta in ("build/web", "galeria", "web"))
    Pagina(lab.raiz, *hechas).escribe_indice(catalogo.lee(lab.raiz / "build"))
    for pagina, *dice in (
        ("galeria/index.html", '<article id="nuevo">', "Es nuevo"),
        ("docs/programas.md", "| [nuevo](../ch01_intro/nuevo.cpp) | E1.2 | Cuatro |"),
        ("web/index.html", '"nombre":"nuevo"', '"mira":"Es nuevo"', '"ch01_intro/nuevo.cpp","ch01_intro/nuevo.vert"'),
    ):
        assert not faltan((lab.raiz / pagina).read_text(), *dice), pagina


def test_un_programa_mas_tiene_sus_pruebas(lab):
    """Las de verdad, que no hace falta compilar."""
    (lab.raiz / "tests").rename(lab.sitio / "pocas")
    (lab.raiz / "tests").symlink_to(RAIZ / "tests")
    orden = ["cmake", "--preset", "release", "-S", lab.raiz, "-B", lab.sitio / "todas"]
    subprocess.run(orden, cwd=lab.raiz, check=True, capture_output=True)
    pruebas = subprocess.check_output(["ctest", "--test-dir", lab.sitio / "todas", "-N"], text=True)
    imagen = f"imagen.{(lab.raiz / 'build/sin_ventana').read_text().strip()}.nuevo.base"
    suyas = imagen, "encuadre.nuevo.base", "ventana.nuevo", "propiedades.nuevo"
    assert not faltan(pruebas, *(f": {nombre}\n" for nombre in suyas))
    (lab.raiz / "tests").unlink()
    (lab.sitio / "pocas").rename(lab.raiz / "tests")


def test_donde_no_se_puede_escribir(lab):
    """Trabaja en la caché, y si tampoco, lo dice en una línea."""
    otro = {} if os.geteuid() else {"user": 65534, "group": 65534, "extra_groups": []}
    cache = lab.sitio / "cache"
    cache.mkdir()
    cache.chmod(0o777)
    subprocess.run(["chmod", "-R", "a-w", lab.raiz], check=True)
    en_cache = f"trabajo en {cache}/laboratorio{lab.raiz}"
    lab("lista", 0, en_cache, quien=otro, TMPDIR="/tmp", XDG_CACHE_HOME=str(cache))
    lab("lista", 1, "no puedo escribir en", quien=otro, XDG_CACHE_HOME="/proc")
    subprocess.run(["chmod", "-R", "u+w", lab.raiz], check=True)


def test_movido_nada_de_lo_compilado_vale(lab):
    """Con & y ' en el nombre, Ninja no sabe de qué depende nada y lo compila todo cada vez: aquí, dos."""
    lab.raiz = lab.raiz.rename(lab.sitio / "lab (2) a&b c'd e$f g[h] ñ")
    lab("lista", 0, "Tres")
    cache = (lab.raiz / "build/CMakeCache.txt").read_text()
    assert f"CMAKE_HOME_DIRECTORY:INTERNAL={lab.raiz}\n" in cache
    assert not (lab.raiz / "build/ventana/ch01_intro/shader_basico").exists()
    lab("galeria", 0, "Hecha: ")
    lab("muta ch01:4", 0, "nadie lo pulsa")
