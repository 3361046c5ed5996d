"""El laboratorio copiado a otra carpeta, con el peor nombre posible, sin tests/ y solo con el primer capítulo: compila
y dibuja de verdad, un programa más sale de su tabla y lo que se estropea se nota. Cada prueba sigue donde la
anterior."""
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
from mentira import RAIZ, faltan, siembra

sys.path.insert(0, str(RAIZ / "herramientas"))
from base import catalogo
from base.procesos import Fallo

SALE = "build", "galeria", "explica", "web", "informe", "mios", "windows", "tests", ".git"
UNO, TRES = "ch01_intro/primer_programa.cpp", "ch01_intro/shader_basico.cpp"
PROGRAMA = """[[programa]]
nombre = "{}"
ref = "{}"
titulo = "{}"
contra = "c"
pruebas = []
  [[programa.caso]]
  nombre = "base"
  mira = "{}"
"""
CATALOGO = r"""titulo = "Título; con punto y coma"
[[programa]]
nombre = "primer_programa"
ref = "L1.1"
titulo = "Uno"
contra = "a; b"
pruebas = []
  [[programa.caso]]
  nombre = "base"
  guion = '''tecla a ×2; tecla '; tecla "; tecla $; tecla <; tecla \; tecla b'''
  anima = "3 tecla i; tecla d"
  mira = '''Mira; y "[remira]" \'''
"""
CATALOGO += PROGRAMA.format("shader_basico", "L1.2", "Tres", "Tres")
ASSETS = r"""#include <fstream>
#include <string>
int main(int, char **argv) { std::ofstream(std::string(argv[1]) + "/luz.rgb") << "luz"; }
"""


class Copia:
    """Se compila sin optimizar y con pocos assets/: lo que tarda no es lo que se prueba."""

    def __init__(self, sitio):
        self.sitio, self.raiz, self.temporal = sitio, sitio / "lab (1) e$f g[h] ñ", sitio / "tmp"
        self.temporal.mkdir()
        self.cual = "./lab"  # o un enlace a él
        self.entorno = {c: v for c, v in os.environ.items() if c not in ("DISPLAY", "WAYLAND_DISPLAY", "LAB_CERROJO")}
        self.entorno |= {"LAB_SIN_INSTALAR": "1", "TMPDIR": str(self.temporal)}
        otros = re.compile(r"ch(0[2-9]|1)")

        def sobra(carpeta, nombres):
            return [n for n in nombres if otros.match(n) or (Path(carpeta) == RAIZ and n in SALE)]

        shutil.copytree(RAIZ, self.raiz, ignore=sobra)
        self.cambia("CMakePresets.json", '"Release"', '"None"')
        self.cambia("assets/CMakeLists.txt", r"set\(texturas[^)]*\)", "set(texturas luz)")
        siembra(self.raiz, {"assets/genera_assets.cpp": ASSETS, "ch01_intro/catalogo.toml": CATALOGO})
        siembra(self.raiz, {"herramientas/mide/CMakeLists.txt": ""})  # usa programas que aquí no están

    def __call__(self, orden, estado=0, *dice, quien=None, **entorno):
        """Ejecuta ./lab ORDEN: con ese estado, y con cada uno de esos textos en lo que dice."""
        como = {"text": True, "stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        como |= {"cwd": self.raiz, "env": self.entorno | entorno, **(quien or {})}
        r = subprocess.run([self.cual, *orden.split()], **como)
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


@pytest.fixture(scope="module")
def lab():
    with tempfile.TemporaryDirectory() as sitio:
        os.chmod(sitio, 0o755)  # lo lee otro usuario
        yield Copia(Path(sitio))


def test_galeria(lab):
    """Un caso que se mueve tiene además su animación y sus cuadros; lo que se escribe llega a la página como es."""
    lab("galeria", 0, "[ 2/2]", "Hecha: ")
    dibujado, pagina = lab.raiz / "galeria/ch01_intro", (lab.raiz / "galeria/index.html").read_text()
    assert struct.unpack_from(">II", (dibujado / "shader_basico.png").read_bytes(), 16) == (1440, 1080)
    assert (dibujado / "primer_programa.anima.webp").stat().st_size
    assert len(list(dibujado.glob("primer_programa.anima/*.webp"))) == 3
    assert not faltan(pagina, "Título; con punto y coma", "Mira; y &#34;[remira]&#34; \\")
    assert "sin cambios" in lab("galeria")


def test_un_catalogo_mal_escrito_se_dice(lab):
    for viejo, nuevo, dice in (
        ("3 tecla i; tecla d", "cuatro", "anima"),
        ('nombre = "shader_basico"', 'nombre = "Shader"', "Shader"),
        ('titulo = "Tres"', 'titulo = "Tres', "catalogo.toml"),
        ('titulo = "Tres"', 'titulo = "Tres"\nmas = 1', "shader_basico: sobra «mas»: de cada programa se dice nombre"),
        ('"shader_basico"', '"primer_programa"', "ya hay otro «primer_programa»"),
        (r'  \[\[programa.caso\]\]\n.*\n  mira = "Tres"', "caso = 7", "cada caso es una tabla"),
        ('mira = "Tres"', 'mira = "Tres"\n  otro = "3"', "base: falta motivo"),
    ):
        with lab.con("ch01_intro/catalogo.toml"):
            lab.cambia("ch01_intro/catalogo.toml", viejo, nuevo)
            with pytest.raises(Fallo, match=dice):
                catalogo.lee_capitulos(lab.raiz)
    with lab.con("ch01_intro/catalogo.toml"):
        lab.cambia("ch01_intro/catalogo.toml", 'mira = "Tres"', "")
        assert "Traceback" not in lab("lista", 1, "falta mira", "CMake no ha podido configurar")


def test_lo_que_no_compila_no_impide_ver_lo_demas(lab):
    """Aunque los avisos fueran errores."""
    with lab.con(UNO, TRES):
        lab.anade(TRES, "static int noSeUsa() { return 0; }\n")
        lab("ver shader_basico", 0, "noSeUsa", "lo he dibujado en shader_basico.png")
        lab.anade(UNO, "int estoNoCompila(\n")
        lab("ver shader_basico", 0, "lo he dibujado en shader_basico.png")
        lab("galeria", 1, "no compila")


def test_un_programa_mas(lab):
    """Con lo que dice CONTRIBUTING.md: sus ficheros y su tabla en el catálogo del capítulo. Lo demás sale de ahí."""
    for f in lab.raiz.glob("ch01_intro/shader_basico.*"):
        f.with_stem("nuevo").write_text(f.read_text().replace("shader_basico", "nuevo"))
    lab.anade("ch01_intro/catalogo.toml", PROGRAMA.format("nuevo", "E1.2", "Cuatro", "Es nuevo"))
    lab.cambia("ch01_intro/nuevo.cpp", r"\A", "#include <cstdio>\n")
    lab.cambia("ch01_intro/nuevo.cpp", "    glutMainLoop", '    std::puts("dice algo");\n    glutMainLoop')
    for dice in "1 imagen", "sin cambios":
        lab("galeria", 0, f"ch01_intro/nuevo: {dice}")
        pagina = (lab.raiz / "galeria/index.html").read_text()
        assert not faltan(pagina, '<article id="nuevo">', "Es nuevo", "dice algo"), dice
    lab("ver E1.2", 0, "lo he dibujado en nuevo.png")
    lab.cambia("ch01_intro/nuevo.cpp", "^// Controles: .*", "// Controles: k mueve algo.")
    lab("ver E1.2")
    lab("nuevo shader_basico mio")
    lab("ver mios/mio", 0, "lo he dibujado en mio.png")
    assert "mueve algo" in (lab.raiz / "build/controles/nuevo.cpp").read_text()


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
    (lab.raiz / "build/CMakeFiles/rules.ninja").unlink()
    lab("lista", 0, "Tres")  # se arregla de lo que le falte
    lab.raiz = lab.raiz.rename(lab.sitio / "lab (2) a&b c'd")
    (lab.sitio / "lab").symlink_to(lab.raiz / "lab")
    lab.cual = lab.sitio / "lab"
    lab("lista", 0, "Tres")
    assert f"CMAKE_HOME_DIRECTORY:INTERNAL={lab.raiz}\n" in (lab.raiz / "build/CMakeCache.txt").read_text()
    assert not (lab.raiz / "build/ventana/ch01_intro/shader_basico").exists()
