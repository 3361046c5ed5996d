"""Cada orden de ./lab en un laboratorio de mentira, que no compila ni dibuja nada (falso.sh): lo que llama, lo que
escribe y dónde, con qué estado acaba y qué deja cuando algo falla o llega una señal. Siempre en una carpeta con el
peor nombre posible."""
import base64
import json
import os
import re
import shlex
import shutil
import signal
import struct
import subprocess
import time
import zipfile
import zlib
from pathlib import Path

import pytest
from mentira import caso, ejecutable, faltan, programa, siembra

RAIZ = Path(__file__).parents[2]
PEOR = "x' `touch pwned` 'y $(touch pwned) ñ [h] & (2)"


HAY = {
    "../cm/lib/codemirror.js": "lib/codemirror.js",
    "../cm/lib/codemirror.css": "lib/codemirror.css",
    "../cm/mode/clike/clike.js": "mode/clike/clike.js",
    "../cm/addon/edit/matchbrackets.js": "addon/edit/matchbrackets.js",
    "../debian.sources": "Types: deb\nURIs: http://archivo\n",
    "../debian.list": "# x\ndeb http://archivo bookworm main\n",
    "LICENSE": "",
    "ch01_uno/a.cpp": "// Controles: a gira · Esc termina.\n",
    "ch01_uno/a.vert": "uno",
    "ch01_uno/b.cpp": "// Controles: ninguno.\n",
    "docs/erratas.md": "",
    "docs/evidencia.json": """{"programas": {"a": {"maximo": 1}}, "casos": {},
        "defectos": {"ch01": {"plantados": 2, "notados": 1, "sin_golden": 1}}}""",
    "docs/libro.tsv": "L1.1\tuno\nL1.10\tdiez\nF1.1\tfigura\tsin motivo\n",
    "docs/soluciones.md": "",
    "docs/porques.tsv": "",
    "herramientas/base/entorno.txt": "GALLIUM_DRIVER=llvmpipe\n",
    "tests/capitulos/ch01_test.cpp": "",
    "tests/casos_dificiles/casos.tsv": "",
    "tests/casos/senala.tsv": "",
    "tests/mutantes/ch01.tsv": "ch01_uno/a.cpp\tgira\tx\ti\nch01_uno/b.cpp\tninguno\tx\ti\n",
}
FALSOS = """cmake ninja ctest gnuplot id dpkg-query apt-get apt-cache sudo em++ falso.sh x86_64-w64-mingw32-g++-posix
    x86_64-w64-mingw32-strip"""


class Lab:
    def __init__(self, sitio):
        self.sitio, self.raiz = sitio, sitio / PEOR
        self.build, self.temporal = self.raiz / "build", sitio / "tmp"
        sin = shutil.ignore_patterns("__pycache__", "errores")  # errores/ es de los programas de verdad
        shutil.copytree(RAIZ / "herramientas", self.raiz / "herramientas", ignore=sin)
        shutil.copy(RAIZ / "lab", self.raiz)
        siembra(self.raiz, HAY)
        for carpeta in ("bin", "tmp", "aqui", *(f"{PEOR}/{c}" for c in ("assets", "tests/golden"))):
            (sitio / carpeta).mkdir()
        for f in ("lab", "herramientas/web/pagina.py"):
            self.cambia(f, "/usr/share/javascript/codemirror", str(sitio / "cm"))
        self.cambia("herramientas/windows/paquete.py", "/usr/share/doc", str(sitio / "doc"))
        for paquete in ("g++-mingw-w64-x86-64-posix", "mingw-w64-common", "libglm-dev", "fonts-dejavu-core"):
            siembra(sitio / "doc" / paquete, {"copyright": paquete})
        self.cambia("herramientas/pruebas/muta.py", "MINIMO = 150", "MINIMO = 2")
        self.falso = Path(shutil.copy(RAIZ / "tests/ordenes/falso.sh", sitio))  # quien no lee RAIZ también lo llama
        for quien in (*(f"bin/{q}" for q in FALSOS.split()), f"{PEOR}/tests/casos/casos.sh"):
            (sitio / quien).symlink_to(self.falso)
        # como el de conda, que no tiene los paquetes del sistema
        ejecutable(sitio / "bin/python3", "echo 'este Python no es el del sistema' >&2\nexit 1")
        dos = {"guion": "tecla a; tecla '", "tolerancia": "1 2 3", "anima": "2 tecla a"}
        self.catalogo = {
            "capitulos": [{"nombre": "ch01_uno", "titulo": "Uno"}],
            "programas": [programa("a", "L1.1 E1.2", "A <b>"), programa("b", "L1.10", "B")],
            "casos": [caso("a"), caso("b"), caso("a", "dos", **dos)],
        }
        self.cataloga()
        fuera = "DISPLAY", "WAYLAND_DISPLAY", "DORA", "PYTHONUNBUFFERED"
        self.entorno = {c: v for c, v in os.environ.items() if not c.startswith("LAB_") and c not in fuera}
        self.entorno |= {"PATH": f"{sitio}/bin:{os.environ['PATH']}", "APUNTES": str(sitio), "LAB_SIN_INSTALAR": "1"}
        self.entorno |= {"TMPDIR": str(self.temporal), "PYTHONDONTWRITEBYTECODE": "1"}

    def orden(self, orden, **entorno):
        """Con qué se ejecuta ./lab ORDEN desde otra carpeta."""
        como = {"cwd": self.sitio / "aqui", "env": {**self.entorno, **entorno}, "text": True}
        return {"args": [self.raiz / "lab", *shlex.split(orden)], **como}

    def cataloga(self):
        """Y se configura otra vez."""
        siembra(self.raiz, {"catalogo.json": json.dumps(self.catalogo)})
        (self.build / "catalogo.json").unlink(missing_ok=True)

    def cambia(self, fichero, viejo, nuevo):
        (self.raiz / fichero).write_text((self.raiz / fichero).read_text().replace(viejo, nuevo))

    def __call__(self, orden, estado=0, dice="", salida=None, **entorno):
        """La ejecuta. Sin trazas de Python, con ese estado y, en lo que avisa, ese texto."""
        (self.sitio / "llamadas").unlink(missing_ok=True)
        como = {"capture_output": True, "stdin": subprocess.DEVNULL, "timeout": 60}
        r = subprocess.run(**self.orden(orden, **entorno), **como)
        bien = r.returncode == estado and "Traceback" not in r.stderr and dice in r.stderr
        assert bien, f"{orden}: {r.returncode}\n{r.stdout}\n{r.stderr}"
        assert salida is None or r.stdout == salida
        self.no_deja_nada()
        return r

    def llamadas(self, quien):
        """Los argumentos de cada vez que se ha llamado."""
        fichero = self.sitio / "llamadas"
        apuntado = fichero.read_text().replace("\v", "\n") if fichero.exists() else ""
        todas = [ll.split("\0")[:-1] for ll in apuntado.split("\f\0")[:-1]]
        return [ll[1:] for ll in todas if ll[0] == quien]

    def libre(self, espera=0, cerrojo=".cerrojo"):
        return subprocess.run(["flock", "-w", str(espera), self.build / cerrojo, "true"]).returncode == 0

    def no_deja_nada(self):
        quedan = [*self.temporal.iterdir(), *self.raiz.rglob("*.parcial"), *self.sitio.rglob("pwned")]
        assert not quedan

    def empieza(self, orden, para, **entorno):
        """La ejecuta hasta que llega a esa etapa, de la que no pasa."""
        como = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "start_new_session": True}
        proceso = subprocess.Popen(**self.orden(orden, PARA=para, **entorno), **como)
        limite = time.monotonic() + 60
        while not self.nietos():
            if proceso.poll() is not None or time.monotonic() > limite:
                proceso.kill()
                raise AssertionError(f"{orden} no llega a {para}: {proceso.communicate()}")
            time.sleep(0.01)
        return proceso

    def nietos(self):
        """Los procesos que han puesto en marcha los que no acaban."""
        fichero = self.sitio / "nietos"
        return [int(pid) for pid in fichero.read_text().split()] if fichero.exists() else []

    def interrumpe(self, proceso, senal):
        """Como la terminal, INT va al grupo de ./lab; TERM, solo a él."""
        (os.killpg if senal == signal.SIGINT else os.kill)(proceso.pid, senal)
        try:
            errores = proceso.communicate(timeout=60)[1]
            assert proceso.returncode == 128 + senal and "Traceback" not in errores, f"{proceso.returncode} {errores}"
        finally:
            vivos = [nieto for nieto in self.nietos() if vivo(nieto)]
            for nieto in vivos:
                os.kill(nieto, signal.SIGKILL)
            proceso.kill()
        assert not vivos, "queda en marcha lo que había puesto en marcha"
        assert self.libre(espera=30), "queda el cerrojo"  # quien lo hereda puede tardar un momento en morir
        self.no_deja_nada()


def vivo(pid):
    for _ in range(3000):
        try:
            if Path(f"/proc/{pid}/stat").read_text().split()[2] == "Z":
                return False
        except OSError:
            return False
        time.sleep(0.01)
    return True


@pytest.fixture
def lab(tmp_path):
    return Lab(tmp_path)


ERRORES = """
nada         | 2 | no conozco la orden «nada»
lista --csv  | 1 | no entiendo «--csv»
lista --tsv x| 1 | no entiendo «x»
galeria x    | 1 | no entiendo «x»
web x        | 1 | no entiendo «x»
ver          | 1 | falta el programa
ver ch1      | 1 | no hay ningún programa «ch1»; los más parecidos: b, a
ver 1.1      | 1 | no hay ningún programa
explica      | 1 | explica: falta el programa
explica ch01 | 1 | «ch01» son varios programas; elige uno: a b
explica a 3  | 1 | con la X, 3, falta la Y
explica a x  | 1 | no entiendo «x»
explica a 1 2 3                | 1 | no entiendo «3»
explica a -guion               | 1 | falta lo que sigue a -guion
dora         | 1 | di qué casos
dora a-x     | 1 | «a-x» no es un caso de a
prueba -R    | 1 | falta lo que sigue a -R
prueba a     | 1 | para elegir pruebas, -R a
prueba --x   | 1 | no entiendo «--x»
mide x       | 1 | no hay ninguna técnica «x»; hay t
muta x       | 1 | no hay ningún mutante en «x»
corrige      | 1 | di qué entrega
corrige noesta E3.5            | 1 | no hay ninguna carpeta «noesta»
corrige clase                  | 1 | di qué ejercicio es
corrige clase E9.9             | 1 | «E9.9» no es un ejercicio
corrige clase/ana              | 1 | no dice de qué ejercicio es
corrige clase E1.2 --guiones x | 1 | no entiendo
"""


def test_ayuda_y_errores(lab):
    assert lab("", salida=lab("ayuda").stdout).stdout.startswith("./lab galeria")
    clase = lab.sitio / "aqui/clase"
    (clase / "ana").mkdir(parents=True)
    for fila in ERRORES.strip().splitlines():
        orden, estado, dice = map(str.strip, fila.split("|"))
        lab(orden, int(estado), dice, salida="")
    assert [f.name for f in clase.rglob("*")] == ["ana"] and not lab.llamadas("bwrap")


def test_sin_pruebas(lab):
    """Sin tests/, solo las tres que son de ellas no tienen qué hacer."""
    lab("lista --docs")
    antes = {f: f.read_text() for f in (lab.raiz / "docs").iterdir()}
    shutil.rmtree(lab.raiz / "tests")
    for orden in ("prueba", "dora a", "muta --comprueba"):
        lab(orden, 1, f"lab: {orden.split()[0]}: hace falta la carpeta tests/\n")
    for orden in ("web", "windows", "mide t"):
        lab(orden, dice="Hech", LAB_SIN_INSTALAR="")
    lab("lista --docs")
    assert antes == {f: f.read_text() for f in (lab.raiz / "docs").iterdir()}


def test_lista(lab):
    lab("lista --tsv", salida="ch01_uno\ta\tL1.1 E1.2\tA <b>\nch01_uno\tb\tL1.10\tB\n")
    assert lab("lista").stdout.startswith("ch01_uno               a                      L1.1 E1.2      A <b>\n")
    lab("lista --docs", salida="")
    programas = lab.raiz / "docs/programas.md"
    assert not faltan(
        programas.read_text(), "| L1.1 | uno | [a](../ch01_uno/a.cpp) |", "| F1.1 | figura | sin motivo |"
    )
    comprueba = [
        "/usr/bin/python3",
        "-B",
        lab.raiz / "herramientas",
        "documentos.escribe",
        lab.raiz,
        lab.build,
        "comprueba",
    ]
    assert subprocess.run(comprueba).returncode == 0
    programas.write_text("otra cosa")
    assert subprocess.run(comprueba, capture_output=True).returncode == 1
    enlace = lab.sitio / "aqui" / "lab"
    enlace.symlink_to(lab.raiz / "lab")
    assert subprocess.run([enlace, "lista"], env=lab.entorno, capture_output=True, cwd=lab.sitio).returncode == 0


def test_compila_lo_que_hace_falta(lab):
    for orden in ("ver a", "galeria"):  # por dónde va, solo en una terminal
        assert faltan(lab(orden).stderr, "[1/2]", "un aviso\n") == ["[1/2]"]
    (lab.build / "catalogo.json").unlink()
    lab("galeria")
    assert lab.llamadas("cmake")[0] == ["--preset", "release", "-B", str(lab.build)]
    lab("galeria")
    assert [ll[0] for ll in lab.llamadas("cmake")] == ["--build", "--build"]  # ya está configurado
    for falta in ("catalogo.json", "sin_ventana", "CMakeCache.txt"):
        (lab.build / falta).unlink()
        lab("lista")
        assert len(lab.llamadas("cmake")) == 1, falta
    for orden in ("ver a", "galeria"):
        dicho = lab(orden, 1, "falla compila", FALLA="compila").stderr
        assert len(lab.llamadas("cmake")) == 2
        assert faltan(dicho, "ninja: error: falta algo\n", "ninja: nada") == ["ninja: nada"]
    # por los avisos: se compila otra vez sin que sean errores
    lab("galeria", 1, "falla compila", FALLA="compila", PORQUE="[-Werror=cpp]")
    pide = [ll[-1] for ll in lab.llamadas("cmake")]
    assert pide == ["build.ninja", "sin_ventana", "-DLAB_AVISOS_SON_ERRORES=OFF", "sin_ventana"]
    lab("lista", 0)
    for otra in ("/otra", f"{lab.raiz}-2025", str(lab.raiz)[:-1]):  # también si un nombre es parte del otro
        siembra(lab.build, {"CMakeCache.txt": f"CMAKE_HOME_DIRECTORY:INTERNAL={otra}\n", "resto": ""})
        lab("lista")
        assert not (lab.build / "resto").exists() and (lab.build / ".cerrojo").exists()
    (lab.build / "catalogo.json").unlink()
    lab("lista", 1, "CMake no ha podido configurar", FALLA="configura")


def test_galeria(lab):
    destino = lab.raiz / "galeria/ch01_uno"
    png, animada, pagina = destino / "a.png", destino / "a-dos.anima.webp", lab.raiz / "galeria/index.html"

    def hechas(estado=0, **entorno):
        dicho = lab("galeria", estado, **entorno).stderr
        dibujadas = "1(?= imagen$)|[2-9](?= imágenes$)|sin cambios|.*falla.*"
        return [h for _, h in sorted(re.findall(rf"ch01_uno/(\w+): ({dibujadas})", dicho, re.M))]

    def talla(fichero):
        return struct.unpack_from(">II", fichero.read_bytes(), 16)

    def talla_webp(fichero):
        datos = fichero.read_bytes()
        if datos[12:16] == b"VP8 ":  # los cuadros son iguales, y no se mueve
            return struct.unpack_from("<HH", datos, 26)
        return tuple(1 + int.from_bytes(datos[i : i + 3], "little") for i in (24, 27))

    assert hechas() == ["2", "1"] and talla(png) == (36, 27) and talla_webp(animada) == (12, 9)
    # lo que escribe cada caso: el que tiene guion, solo lo de su última orden
    for esperado in ["2", "1"], ["sin cambios", "sin cambios"]:
        assert esperado == ["2", "1"] or hechas() == esperado
        son = "A &lt;b&gt;", "salida de a", "tras la orden", "la ventana de a</span>", "título: la", "otra orden"
        assert [pagina.read_text().count(s) for s in son] == [4, 1, 1, 2, 0, 0]
    png.unlink()
    assert hechas() == ["1", "sin cambios"]
    animada.write_bytes(b"")
    assert hechas() == ["1", "sin cambios"] and animada.stat().st_size
    lab.catalogo["casos"][1]["guion"] = "tecla b"
    lab.catalogo["programas"][1]["captura"] = "TRUE"
    siembra(lab.raiz, {"ch01_uno/b.png": "así se ve"})
    lab.cataloga()
    assert hechas() == ["sin cambios", "1"] and (destino / "b.captura.png").read_text() == "así se ve"
    for donde, fichero in ((lab.raiz, "ch01_uno/a.vert"), (lab.build, "assets/t.rgb")):  # que solo los lee a
        siembra(donde, {fichero: "dos"})
        assert hechas() == ["2", "sin cambios"]
    (lab.raiz / "ch01_uno/a.vert").unlink()
    assert hechas() == ["2", "sin cambios"]
    # lo que no se puede dibujar no deja la imagen de antes, lo dice la página y se hace en cuanto se pueda
    programa = lab.build / "osmesa/ch01_uno/a"
    ejecutable(programa, "echo falla con esto >&2\necho y más >&2\nexit 3")
    assert hechas(1)[0].startswith("a ha fallado: falla con esto") and not png.exists() and not animada.exists()
    assert "falla con esto" in pagina.read_text()
    # ni sale bien si lo que no se puede dibujar es uno de sus casos
    ejecutable(programa, f'case "$*" in *-anima*|*tecla*) echo no este >&2; exit 3;; esac\nexec {lab.falso} "$@"')
    assert hechas(1)[0].startswith("a-dos ha fallado: no este") and png.exists() and not animada.exists()
    programa.unlink()
    programa.symlink_to(lab.falso)
    assert hechas() == ["2", "sin cambios"]


def test_la_galeria_se_puede_mirar_mientras_se_dibuja(lab):
    """b no acaba hasta que ve la página, con a; ni c, hasta que la ha visto b."""
    pagina, vista = lab.raiz / "galeria/index.html", lab.sitio / "vista.html"
    lab.catalogo["programas"].append(programa("c", "L1.10", "C"))
    lab.catalogo["casos"].append(caso("c"))
    siembra(lab.raiz, {"ch01_uno/c.cpp": "// Controles: ninguno.\n"})
    lab.cataloga()
    lab("lista")
    suya = shlex.quote(str(pagina))
    mira = f"until [ -e {suya} ]; do sleep 0.02; done\ncp {suya} {vista}\necho acabo >&2\nexit 3"
    ejecutable(lab.build / "osmesa/ch01_uno/b", mira)
    ejecutable(lab.build / "osmesa/ch01_uno/c", f"until [ -e {vista} ]; do sleep 0.02; done\nexit 3")
    lab("galeria", 1, dice="b ha fallado: acabo")
    a_medias, entera = vista.read_text(), pagina.read_text()
    assert not faltan(a_medias, 'http-equiv="refresh"', "faltan 2 programas", "ch01_uno/a.png")
    assert a_medias.count("Aún no está dibujada") == 2
    assert len(faltan(entera, "refresh", "faltan 2 programas", "Aún no está")) == 3


DE_LA_PAGINA = "js wasm explica-js explica-wasm shaders esqueletos codigo indice editor t.rgb"


def test_web(lab):
    lab("web", dice="la página irá sin las imágenes que faltan", FALLA="programa")
    lab("web", dice=": se descargan 2 MB\n", LAB_SIN_INSTALAR="")
    assert "irá sin" not in lab("web", dice="Hecha: ").stderr
    web = lab.raiz / "web"
    miniatura = web / "ch01_uno/a.jpg"
    datos = {f.name for f in (web / "datos").iterdir()}
    assert datos == {f"{n}.js" for n in DE_LA_PAGINA.split()}
    empaquetado = (web / "datos/shaders.js").read_text().split('"')[3]
    assert json.loads(zlib.decompress(base64.b64decode(empaquetado))) == {"ch01_uno/a.vert": "uno"}
    assert not faltan((web / "index.html").read_text(), '"nombre":"a"', '"anima":true')
    assert miniatura.read_bytes()[:2] == b"\xff\xd8"
    cuando = miniatura.stat().st_mtime_ns
    lab("web")
    assert miniatura.stat().st_mtime_ns == cuando
    os.utime(lab.raiz / "galeria/ch01_uno/a.png", (2e9, 2e9))
    lab("web")
    assert miniatura.stat().st_mtime_ns != cuando
    (web / "datos/viejo.js").touch()
    lab("web", 1, "falla rasgos", FALLA="rasgos")
    assert (web / "datos/viejo.js").exists()  # si no sale, queda la de antes entera
    lab("web")
    assert {f.name for f in (web / "datos").iterdir()} == datos


EN_EL_ZIP = """LEEME.txt index.html imagenes/ch01_uno/a.jpg imagenes/ch01_uno/b.jpg ch01_uno/a.vert assets/t.rgb
    programas/a.exe programas/b.exe programas/uno.dll programas/libstdc++-6.dll programas/libgcc_s_seh-1.dll
    programas/libwinpthread-1.dll licencias/dejavu.txt licencias/freeglut.txt licencias/gcc.txt licencias/glew.txt
    licencias/glm.txt licencias/laboratorio.txt licencias/mingw-w64.txt"""


def test_windows(lab):
    lab("windows", 1, "faltan los fuentes de FreeGLUT y GLEW")
    lab("windows", 1, "falla fuentes", FALLA="fuentes", LAB_SIN_INSTALAR="")
    hecho = lab.raiz / "windows/laboratorio-windows.zip"
    assert not (lab.build / "windows/fuentes").exists()  # o todos o ninguno
    lab("windows", dice="Hecho: ", LAB_SIN_INSTALAR="")
    assert "source" in lab.llamadas("apt-get")[-1] and not (lab.build / "windows/apt").exists()
    assert "Descargo" not in lab("windows", dice="Hecho: ").stderr
    usada = lab.sitio / "usada"  # la lista de apt, como la de la máquina pero con los fuentes
    assert usada.read_text() == "Types: deb-src\nURIs: http://archivo\n"
    shutil.rmtree(lab.build / "windows/fuentes")
    lab("windows", LAB_SIN_INSTALAR="", LISTA="debian.list")
    assert usada.read_text() == "deb-src http://archivo bookworm main\n"
    with zipfile.ZipFile(hecho) as contenido:
        hay = {f.removeprefix("laboratorio/"): contenido.read(f) for f in contenido.namelist()}
    assert hay.keys() == set(EN_EL_ZIP.split())
    licencias = [texto for f, texto in hay.items() if f.startswith("licencias/")]
    assert len(set(licencias)) == len(licencias)  # cada una, la suya
    assert b"\r\n" in hay["LEEME.txt"] and hay["programas/libstdc++-6.dll"] == b"aligerada\n"
    dice = "A &lt;b&gt;", 'src="imagenes/ch01_uno/a.jpg"', "a.exe", "<li>a gira</li>"
    assert not faltan(hay["index.html"].decode(), *dice)
    antes = hecho.read_bytes()
    lab("windows", 1, "no compila", FALLA="compila")
    assert hecho.read_bytes() == antes


def test_mide(lab):
    lab("mide t", dice="Hecho: ")
    informe, ensayo = lab.raiz / "informe", "herramientas/mide/ensayo.tsv"
    assert (informe / "t.tsv").read_text().splitlines()[1] == "a\t-\t0.5\t-\t2 1 3"
    assert (informe / "t.svg").read_text().startswith("<svg>set terminal svg") and (informe / "index.html").exists()
    lab("mide t", 1, "t ha fallado: error: falla mide", FALLA="mide")
    siembra(lab.raiz, {ensayo: "t\ta\t0.7\n"})
    lab("mide --ensayo", 1, "«a» se equivoca 0.5 y se esperaba 0.7")
    siembra(lab.raiz, {ensayo: "t\ta\t0.5\n"})
    shutil.rmtree(informe)
    lab("mide --ensayo", dice="t: 1 variantes")
    assert not informe.exists()
    (lab.sitio / "bin/gnuplot").unlink()
    if not shutil.which("gnuplot"):
        lab("mide t", 1, "lab: no encuentro gnuplot")
        assert [ll[0] for ll in lab.llamadas("mide")] == ["--lista"]  # antes de medir nada


def test_prueba(lab):
    siembra(lab.build, {"fallos/viejo.ppm": "P6"})
    lab("prueba -R 'uno|dos' -V")
    [opciones] = lab.llamadas("ctest")[:1]
    assert lab.llamadas("cmake")[0][-1] == "-DLAB_AVISOS_SON_ERRORES=ON"
    assert opciones[:2] == ["--test-dir", str(lab.build)] and opciones[-3:] == ["-R", "uno|dos", "-V"]
    assert not (lab.build / "fallos").exists()
    lab("prueba --junit resultados.xml -I 2,,3")
    assert lab.llamadas("ctest")[0][-2:] == ["-I", "2,,3"]
    assert 'name="uno"' in (lab.sitio / "aqui/resultados.xml").read_text()
    lab("prueba --junit no/existe.xml", 1, "no puedo escribir")
    lab("prueba --junit mal.xml", 8, f"está en {lab.build}/fallos/index.html\n", MAL="1")
    assert 'status="fail"' in (lab.sitio / "aqui/mal.xml").read_text()
    imagenes = {f"a-{que}{tipo}" for que in ("esperada", "obtenida", "diferencia") for tipo in (".ppm", ".png")}
    assert {f.name for f in (lab.build / "fallos/osmesa").iterdir()} == imagenes
    pagina = (lab.build / "fallos/index.html").read_text()
    assert faltan(pagina, 'src="osmesa/a-obtenida.png"', "DISTINTAS: &lt;b&gt;", 'id="uno"') == ['id="uno"']
    lab("prueba")
    lab("prueba --junit nada.xml", 3, "falla ctest", FALLA="ctest")  # sin el informe de antes
    assert not (lab.sitio / "aqui/nada.xml").exists()
    lab("prueba -N", 1, "LAB_OPENGL: no conozco «otra»", LAB_OPENGL="otra")
    lab("prueba --asan")
    assert lab.llamadas("cmake")[0][:4] == ["--preset", "asan", "-B", f"{lab.build}/asan"]
    assert lab.llamadas("ctest")[0][1] == f"{lab.build}/asan"


def test_prueba_lo_que_cambia(lab):
    for asan in ("", " --asan"):  # lo que ha pasado de una manera no ha pasado de la otra
        for se_hace in (True, False):
            dicho = lab(f"prueba{asan} --cambios").stderr
            assert any("--parallel" in ll for ll in lab.llamadas("ctest")) == se_hace
            assert ("Todas las pruebas han pasado ya con lo que hay" in dicho) != se_hace
    siembra(lab.raiz, {"docs/soluciones.md": "otra"})
    lab("prueba --cambios")
    assert lab.llamadas("ctest")[1][-2:] == ["-R", "^(.*)$"]
    lab("prueba --cambios -R x", 1, "sobra -R")


def test_ver(lab):
    aqui = lab.sitio / "aqui"
    lab("ver l1.1", dice="lo he dibujado en a.png", salida="salida de a\n")
    assert (aqui / "a.png").read_bytes()[1:4] == b"PNG" and not (lab.raiz / "a.png").exists()
    lab("ver ch01 -x 'y z'", dice="a: A <b>")
    assert [ll[-2:] for ll in lab.llamadas("a") + lab.llamadas("b")] == [["-x", "y z"]] * 2
    lab("ver ch01", 3, "falla programa", FALLA="programa")
    assert len(lab.llamadas("a") + lab.llamadas("b")) == 2  # el que falla no impide ver los demás
    (aqui / "a.png").unlink()
    lab("ver a -x 'y z'", DISPLAY=":9")
    assert lab.llamadas("a") == [["-x", "y z"]] and not (aqui / "a.png").exists()
    lab("ver a", 4, "otra cosa", DISPLAY=":9", ESTADO="4", ESCRIBE="otra cosa")
    lab("ver a -x", 1, "failed to open display", DISPLAY=":9", ESTADO="1", ESCRIBE="failed to open display")
    assert len(lab.llamadas("a")) == 2  # y sin ventana
    lab.catalogo["programas"][1]["consola"] = "TRUE"
    lab.cataloga()
    (aqui / "b.png").unlink()
    lab("ver b")
    assert lab.llamadas("b") == [[]] and not (aqui / "b.png").exists()
    proceso = lab.empieza("ver a", "programa")
    assert lab.libre()  # con la ventana abierta se puede seguir trabajando
    lab.interrumpe(proceso, signal.SIGTERM)


def test_lo_de_mios_se_ve_como_lo_demas(lab):
    dice = "una copia, para jugar con ella. Para verla, ./lab ver mios/mi_a"
    lab("nuevo l1.1 mi_a", salida=f"{lab.raiz}/mios/mi_a: {dice}\n")
    lab("nuevo l1.1 mi_a", 1, "ya existe")
    suyo = lab.build / "osmesa/mios/mi_a/a"
    suyo.parent.mkdir(parents=True)
    suyo.symlink_to(lab.falso)
    lab("ver mi_a", dice="lo he dibujado en mi_a.png", salida=f"salida de a con {lab.raiz}/mios/mi_a\n")
    assert (lab.sitio / "aqui/mi_a.png").exists() and "mio_mi_a_osmesa" in lab.llamadas("cmake")[-1]
    lab("ver mios/mi_a/", 1, "mios/mi_a no compila", FALLA="compila")
    (lab.raiz / "mios/b").mkdir()  # se llama como un programa, que va antes
    lab("ver b", salida="salida de b\n")
    for que in ("mios/b", "mios/c"):
        lab(f"ver {que}", 1, "no encuentro")
    (lab.raiz / "mios/mi_a/ejercicio.txt").unlink()
    lab("ver mi_a", 1, "falta")


def test_dora(lab):
    golden = lab.raiz / "tests/golden"
    assert lab("dora a b").stdout.count("1|llvmpipe|") == 3
    casos = [[str(lab.build), "osmesa", *caso.split()] for caso in ("a base", "a dos", "b base")]
    assert lab.llamadas("casos.sh") == casos
    lab("dora a-dos")
    assert lab.llamadas("cmake")[-1][3:] == ["compara", "a_osmesa"]
    assert len(lab.llamadas("casos.sh")) == 1
    siembra(golden, {"ch01_uno/a.pasos": ""})
    lab("dora a-dos b a")
    assert [c[1:] for c in lab.llamadas("casos.sh") if c[1] == "pasos"] == [["pasos", "a"]]
    lab("dora visto", 1, "antes, ./lab dora todo, o")
    siembra(golden, {"ch01_uno/a.txt": "de antes\n", "ch01_uno/b.txt": "de ahora\n"})
    lab("dora todo", 1, "hay casos que no se pueden dibujar", FALLA="caso")
    lab("dora visto", salida="Ningún golden cambia\n")
    lab("dora todo", salida=f"Cambian 1: míralos en {lab.build}/dora/index.html; si están bien, ./lab dora visto\n")
    assert [c[1:] for c in lab.llamadas("casos.sh")][-1] == ["pasos", "a"] and len(lab.llamadas("casos.sh")) == 4
    pagina = (lab.build / "dora/index.html").read_text()
    assert "-de antes\n+de ahora" in pagina and 'id="ch01_uno/b"' not in pagina
    assert (golden / "ch01_uno/a.txt").read_text() == "de antes\n"
    siembra(lab.raiz, {"ch01_uno/z.cpp": ""})
    lab("dora visto", 1, "ch01_uno/z.cpp ha cambiado después de dibujarse")
    (lab.raiz / "ch01_uno/z.cpp").unlink()
    lab("dora visto", salida="Hechos: ch01_uno/a\n")
    assert (golden / "ch01_uno/a.txt").read_text() == "de ahora\n"
    lab("dora todo", salida="Ningún golden cambia\n")
    siembra(golden, {"ch01_uno/a.txt": "de antes\n", "ch01_uno/b.txt": "de antes\n"})
    assert "Cambian 1: " in lab("dora --mira b").stdout
    lab("dora visto", salida="Hechos: ch01_uno/b\n")
    shutil.rmtree(golden)
    lab("dora a", 1, "no puedo escribir en")


def test_de_uno_en_uno(lab):
    def otro(segundos, cerrojo=".cerrojo"):
        proceso = subprocess.Popen(["flock", lab.build / cerrojo, "sleep", segundos])
        while lab.libre(cerrojo=cerrojo):
            time.sleep(0.01)
        return proceso

    lab("lista")
    uno = otro("0.5")
    lab("lista", dice="Hay otro ./lab trabajando")
    assert uno.wait() == 0
    (lab.build / "mutantes").mkdir()
    uno = otro("0.5", "mutantes/.cerrojo")
    lab("muta --comprueba", dice="Hay otro ./lab trabajando")  # los mutantes tienen el suyo
    assert uno.wait() == 0
    uno = otro("20")
    lab("lista", LAB_CERROJO=str(lab.build))  # lo tiene quien nos llama
    espera = subprocess.Popen([lab.raiz / "lab", "lista"], env=lab.entorno, stderr=subprocess.PIPE)
    assert b"espero a que acabe" in espera.stderr.readline()
    espera.terminate()
    assert espera.wait(10) == 143
    uno.kill()


def test_instala(lab):
    lab("lista")
    assert not lab.llamadas("apt-get") and not lab.llamadas("dpkg-query")
    lab("prueba", dice="Instalo los paquetes que faltan: ", LAB_SIN_INSTALAR="")
    ponen = lab.llamadas("apt-get")[-1]
    assert faltan(ponen, "install", "python3-pytest", "shellcheck", "netpbm", "g++", "cmake") == ["g++", "cmake"]
    lab("lista", dice="Instalo con sudo", LAB_SIN_INSTALAR="", FALSO_ID="1000")
    assert lab.llamadas("sudo")[-1][:3] == ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    assert len(lab.llamadas("sudo")) == 2 and not lab.llamadas("apt-get")  # también ponerse al día
    (lab.sitio / "bin/sudo").unlink()
    if not shutil.which("sudo"):
        lab("lista", 1, "faltan paquetes y no hay sudo", LAB_SIN_INSTALAR="", FALSO_ID="1000")


def test_en_otros_sistemas(lab):
    """Sin apt-get, ni con qué compilar, dice cómo se llaman los paquetes; y los dice todos."""
    tabla = [fila.split("\t") for fila in (RAIZ / "herramientas/base/paquetes.tsv").read_text().splitlines()]
    assert {len(fila) for fila in tabla} == {3}
    lista = r"^(?:PAQUETES(?:_PRUEBAS|_MEDIDAS)?|OPCIONAL)=\(?([^)#\n]+(?:\n  [^)]+)*)"
    listas = re.findall(lista, (RAIZ / "lab").read_text(), re.M)
    assert len(listas) == 4 and set(" ".join(listas).split()) == {fila[0] for fila in tabla[1:]}
    lab("lista")
    solo = lab.sitio / "solo"
    solo.mkdir()
    for quien in ("bash", "dirname", "readlink", "find", "mkdir", "flock", "awk"):
        (solo / quien).symlink_to(shutil.which(quien))
    dicho = lab("lista", 1, "solo sé instalar en Debian y derivados", LAB_SIN_INSTALAR="", PATH=str(solo)).stderr
    assert re.search(r"libglew-dev +glew-devel +glew\n", dicho)
    assert faltan(dicho, "libosmesa6-dev", "shellcheck") == ["shellcheck"]


ETAPAS = {
    "galeria": "configura compila programa",
    "web": "configura programa rasgos",
    "mide t": "configura compila mide",
    "prueba": "configura compila ctest",
    "ver a": "configura compila programa",
    "explica a": "configura compila programa",
    "dora a": "configura compila caso",
    "muta": "configura compila prueba",
    "windows": "configura fuentes compila programa",
    "lista": "configura",
    "nuevo l1.1": "configura",
    "corrige mios/x": "configura",
}
SENALES = [(orden, etapa, i + j) for i, orden in enumerate(ETAPAS) for j, etapa in enumerate(ETAPAS[orden].split())]


@pytest.mark.parametrize("orden,para,cual", SENALES)
def test_una_senal_lo_acaba_todo(lab, orden, para, cual):
    descarga = {"LAB_SIN_INSTALAR": ""} if orden == "windows" else {}
    lab.interrumpe(lab.empieza(orden, para, **descarga), (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)[cual % 3])
    if orden in ("galeria", "web"):  # y se puede seguir
        lab(orden, dice="Hecha: ")
