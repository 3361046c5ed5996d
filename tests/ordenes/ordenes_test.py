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
import subprocess
import time
import zipfile
import zlib
from pathlib import Path

import pytest

RAIZ = Path(__file__).parents[2]
PEOR = "x';touch pwned;'y $(touch pwned) \"ñ\" [h] & (2)"


class Lab:
    def __init__(self, sitio):
        self.sitio, self.raiz = sitio, sitio / PEOR
        self.build, self.temporal = self.raiz / "build", sitio / "tmp"
        for carpeta in (
            "bin",
            "tmp",
            "aqui",
            PEOR + "/ch01_uno",
            PEOR + "/docs",
            PEOR + "/assets",
            PEOR + "/tests/mutantes",
            PEOR + "/tests/casos",
            PEOR + "/tests/capitulos",
            PEOR + "/tests/golden",
            PEOR + "/tests/casos_dificiles",
            *(f"cm/{c}" for c in ("lib", "mode/clike", "addon/edit")),
        ):
            (sitio / carpeta).mkdir(parents=True)
        for f in ("lib/codemirror.js", "mode/clike/clike.js", "addon/edit/matchbrackets.js", "lib/codemirror.css"):
            (sitio / "cm" / f).write_text(f)
        shutil.copy(RAIZ / "lab", self.raiz)
        shutil.copytree(RAIZ / "herramientas", self.raiz / "herramientas", ignore=shutil.ignore_patterns("__pycache__"))
        for f in ("lab", "herramientas/web/pagina.py"):
            self.cambia(f, "/usr/share/javascript/codemirror", str(sitio / "cm"))
        self.cambia("herramientas/windows/paquete.py", "/usr/share/doc", str(sitio / "doc"))
        for paquete in ("g++-mingw-w64-x86-64-posix", "mingw-w64-common", "libglm-dev", "fonts-dejavu-core"):
            (sitio / "doc" / paquete).mkdir(parents=True)
            (sitio / "doc" / paquete / "copyright").touch()
        (self.raiz / "LICENSE").touch()
        self.cambia("herramientas/pruebas/muta.py", "MINIMO = 150", "MINIMO = 2")
        for quien in (
            "cmake",
            "ninja",
            "ctest",
            "gnuplot",
            "id",
            "dpkg-query",
            "apt-get",
            "apt-cache",
            "sudo",
            "em++",
            "falso.sh",
            "x86_64-w64-mingw32-g++-posix",
            "x86_64-w64-mingw32-strip",
        ):
            (sitio / "bin" / quien).symlink_to(RAIZ / "tests/ordenes/falso.sh")
        otro_python = sitio / "bin/python3"  # como el de conda, que no tiene los paquetes del sistema
        otro_python.write_text("#!/bin/sh\necho 'este Python no es el del sistema' >&2\nexit 1\n")
        otro_python.chmod(0o755)
        (self.raiz / "tests/casos/casos.sh").symlink_to(RAIZ / "tests/ordenes/falso.sh")
        for f, texto in (
            ("herramientas/base/entorno.txt", "GALLIUM_DRIVER=llvmpipe\n"),
            ("tests/capitulos/ch01_test.cpp", ""),
            ("ch01_uno/a.vert", "uno"),
            ("ch01_uno/a.cpp", '// Controles: a gira · Esc termina.\n#include "a.vert"\n'),
            ("ch01_uno/b.cpp", "// Controles: ninguno.\n"),
            ("tests/mutantes/ch01.tsv", "ch01_uno/a.cpp\tgira\tx\ti\nch01_uno/b.cpp\tninguno\tx\ti\n"),
            ("tests/casos_dificiles/casos.tsv", ""),
            ("docs/libro.tsv", "L1.1\tuno\nL1.10\tdiez\nF1.1\tfigura\tsin motivo\n"),
            ("docs/soluciones.md", ""),
            ("docs/erratas.md", ""),
            (
                "docs/evidencia.json",
                '{"programas": {"a": {"maximo": 1}}, "casos": {}, "defectos": {"ch01": {"plantados": 2, "notados": 1, "sin_golden": 1}}}',
            ),
        ):
            (self.raiz / f).write_text(texto)
        programa = {"capitulo": "ch01_uno", "contra": "", "pruebas": "", "pasa": "", "admite": "", "consola": ""}
        caso = {"guion": "", "tolerancia": "", "mira": "M", "borde": "", "anima": ""}
        self.catalogo = {
            "capitulos": [{"nombre": "ch01_uno", "titulo": "Uno"}],
            "programas": [
                {**programa, "nombre": "a", "ref": "L1.1 E1.2", "titulo": "A <b>"},
                {**programa, "nombre": "b", "ref": "L1.10", "titulo": "B"},
            ],
            "casos": [
                {**caso, "programa": "a", "nombre": "base", "fichero": "a"},
                {**caso, "programa": "b", "nombre": "base", "fichero": "b"},
                {
                    **caso,
                    "programa": "a",
                    "nombre": "dos",
                    "fichero": "a-dos",
                    "guion": "tecla a; tecla '",
                    "tolerancia": "1 2 3",
                    "anima": "2 tecla a",
                },
            ],
        }
        self.cataloga()
        (sitio / "debian.sources").write_text("Types: deb\nURIs: http://archivo\n")
        self.entorno = {
            c: v
            for c, v in os.environ.items()
            if not c.startswith("LAB_") and c not in ("DISPLAY", "WAYLAND_DISPLAY", "DORA")
        }
        self.entorno |= {
            "PATH": f"{sitio}/bin:{os.environ['PATH']}",
            "APUNTES": str(sitio),
            "TMPDIR": str(self.temporal),
            "LAB_SIN_INSTALAR": "1",
            "PYTHONDONTWRITEBYTECODE": "1",
        }

    def cataloga(self):
        (self.raiz / "catalogo.json").write_text(json.dumps(self.catalogo))

    def cambia(self, fichero, viejo, nuevo):
        (self.raiz / fichero).write_text((self.raiz / fichero).read_text().replace(viejo, nuevo))

    def __call__(self, orden, estado=0, dice="", salida=None, **entorno):
        """Ejecuta ./lab ORDEN desde otra carpeta. Sin trazas de Python, con ese estado y, en lo que avisa, ese texto."""
        (self.sitio / "llamadas").unlink(missing_ok=True)
        r = subprocess.run(
            [self.raiz / "lab", *shlex.split(orden)],
            cwd=self.sitio / "aqui",
            env={**self.entorno, **entorno},
            text=True,
            capture_output=True,
            stdin=subprocess.DEVNULL,
            timeout=60,
        )
        assert (r.returncode, "Traceback" in r.stderr) == (
            estado,
            False,
        ) and dice in r.stderr, f"{orden}: {r.returncode}\n{r.stdout}\n{r.stderr}"
        assert salida is None or r.stdout == salida
        self.no_deja_nada()
        return r

    def llamadas(self, quien):
        """Los argumentos de cada vez que se ha llamado."""
        fichero = self.sitio / "llamadas"
        todas = [ll.split("\0")[:-1] for ll in fichero.read_text().split("\n\0")[:-1]] if fichero.exists() else []
        return [ll[1:] for ll in todas if ll[0] == quien]

    def libre(self, espera=0):
        return subprocess.run(["flock", "-w", str(espera), self.build / ".cerrojo", "true"]).returncode == 0

    def no_deja_nada(self):
        assert (
            not list(self.temporal.iterdir())
            and not list(self.raiz.rglob("*.parcial"))
            and not list(self.sitio.rglob("pwned"))
        )

    def empieza(self, orden, para, **entorno):
        """Ejecuta ./lab ORDEN hasta que llega a esa etapa, de la que no pasa."""
        proceso = subprocess.Popen(
            [self.raiz / "lab", *shlex.split(orden)],
            cwd=self.sitio / "aqui",
            env={**self.entorno, "PARA": para, **entorno},
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
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


def test_ayuda_y_errores(lab):
    assert lab("", salida=lab("ayuda").stdout).stdout.startswith("./lab galeria")
    for orden, estado, dice in (
        ("nada", 2, "no conozco la orden «nada»"),
        ("lista --csv", 1, "no entiendo «--csv»"),
        ("lista --tsv x", 1, "no entiendo «x»"),
        ("galeria x", 1, "no entiendo «x»"),
        ("web x", 1, "no entiendo «x»"),
        ("ver", 1, "falta el programa"),
        ("ver ch1", 1, "no hay ningún programa «ch1»; los más parecidos: b, a"),
        ("ver 1.1", 1, "no hay ningún programa"),
        ("dora", 1, "di qué casos"),
        ("dora a-x", 1, "«a-x» no es un caso de a"),
        ("prueba -R", 1, "falta lo que sigue a -R"),
        ("prueba a", 1, "para elegir pruebas, -R a"),
        ("prueba --x", 1, "no entiendo «--x»"),
        ("mide x", 1, "no hay ninguna técnica «x»; hay t"),
        ("muta x", 1, "no hay ningún mutante en «x»"),
    ):
        lab(orden, estado, dice, salida="")


def test_lista(lab):
    lab("lista --tsv", salida="ch01_uno\ta\tL1.1 E1.2\tA <b>\nch01_uno\tb\tL1.10\tB\n")
    assert lab("lista").stdout.startswith("ch01_uno               a                      L1.1 E1.2      A <b>\n")
    lab("lista --docs", salida="")
    programas = (lab.raiz / "docs/programas.md").read_text()
    assert "| L1.1 | uno | [a](../ch01_uno/a.cpp) |" in programas and "| F1.1 | figura | sin motivo |" in programas
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
    (lab.raiz / "docs/programas.md").write_text("otra cosa")
    assert subprocess.run(comprueba, capture_output=True).returncode == 1
    enlace = lab.sitio / "aqui" / "lab"
    enlace.symlink_to(lab.raiz / "lab")
    assert subprocess.run([enlace, "lista"], env=lab.entorno, capture_output=True, cwd=lab.sitio).returncode == 0


def test_compila_lo_que_hace_falta(lab):
    assert "[1/2]" not in lab("galeria", dice="un aviso\n").stderr  # por dónde va, solo en una terminal
    assert lab.llamadas("cmake")[0] == ["--preset", "release", "-B", str(lab.build)]
    lab("galeria")
    assert [ll[0] for ll in lab.llamadas("cmake")] == ["--build", "--build"]  # ya está configurado
    for falta in ("catalogo.json", "sin_ventana", "CMakeCache.txt"):
        (lab.build / falta).unlink()
        lab("lista")
        assert len(lab.llamadas("cmake")) == 1, falta
    lab("galeria", 1, "falla compila", FALLA="compila")
    assert len(lab.llamadas("cmake")) == 2
    lab(
        "galeria", 1, "falla compila", FALLA="compila", PORQUE="-Werror"
    )  # por los avisos: se compila otra vez sin que sean errores
    assert [ll[-1] for ll in lab.llamadas("cmake")] == [
        "build.ninja",
        "sin_ventana",
        "-DLAB_AVISOS_SON_ERRORES=OFF",
        "sin_ventana",
    ]
    lab("lista", 0)
    (lab.build / "CMakeCache.txt").write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/otra\n")
    (lab.build / "resto").touch()
    lab("lista")
    assert not (lab.build / "resto").exists() and (lab.build / ".cerrojo").exists()
    (lab.build / "catalogo.json").unlink()
    lab("lista", 1, "CMake no ha podido configurar", FALLA="configura")


def test_galeria(lab):
    destino = lab.raiz / "galeria/ch01_uno"
    png, animada = destino / "a.png", destino / "a-dos.anima.png"

    def hechas(estado=0, **entorno):
        return dict(
            re.findall(r"ch01_uno/(\w+): (\d+|sin cambios|.*falla.*)", lab("galeria", estado, **entorno).stderr)
        )

    def talla(fichero):
        return [int.from_bytes(fichero.read_bytes()[i : i + 4], "big") for i in (16, 20)]

    assert hechas() == {"a": "2", "b": "1"} and talla(png) == [36, 27] and talla(animada) == [12, 9]
    pagina = (lab.raiz / "galeria/index.html").read_text()
    assert "A &lt;b&gt;" in pagina and "salida de a" in pagina
    assert (
        hechas() == {"a": "sin cambios", "b": "sin cambios"}
        and "salida de a" in (lab.raiz / "galeria/index.html").read_text()
    )
    png.unlink()
    assert hechas() == {"a": "1", "b": "sin cambios"}
    animada.write_bytes(b"")
    assert hechas() == {"a": "1", "b": "sin cambios"} and animada.stat().st_size
    lab.catalogo["casos"][1]["guion"] = "tecla b"
    lab.cataloga()
    (lab.build / "catalogo.json").unlink()
    assert hechas() == {"a": "sin cambios", "b": "1"}
    (lab.raiz / "ch01_uno/a.vert").write_text("dos")  # que solo lo lee a
    assert hechas() == {"a": "2", "b": "sin cambios"}
    (lab.raiz / "ch01_uno/a.vert").unlink()
    assert hechas() == {"a": "2", "b": "sin cambios"}
    # lo que no se puede dibujar no deja la imagen de antes, lo dice la página y se hace en cuanto se pueda
    programa = lab.build / "osmesa/ch01_uno/a"
    programa.unlink()
    programa.write_text("#!/bin/sh\necho falla con esto >&2\necho y más >&2\nexit 3\n")
    programa.chmod(0o755)
    assert hechas(1)["a"].startswith("a ha fallado: falla con esto") and not png.exists() and not animada.exists()
    assert "falla con esto" in (lab.raiz / "galeria/index.html").read_text()
    programa.unlink()
    programa.symlink_to(RAIZ / "tests/ordenes/falso.sh")
    assert hechas() == {"a": "2", "b": "sin cambios"}


def test_la_galeria_se_puede_mirar_mientras_se_dibuja(lab):
    """b no acaba hasta que ve la página, con a."""
    pagina, vista = lab.raiz / "galeria/index.html", lab.sitio / "vista.html"
    lab("lista")
    programa = lab.build / "osmesa/ch01_uno/b"
    programa.unlink()
    programa.write_text(
        f"#!/bin/sh\nuntil [ -e {shlex.quote(str(pagina))} ]; do sleep 0.02; done\ncp {shlex.quote(str(pagina))} {vista}\necho acabo >&2\nexit 3\n"
    )
    programa.chmod(0o755)
    lab("galeria", 1, dice="b ha fallado: acabo")
    a_medias, entera = vista.read_text(), pagina.read_text()
    assert (
        'http-equiv="refresh"' in a_medias
        and "falta un programa" in a_medias
        and "ch01_uno/a.png" in a_medias
        and a_medias.count("Aún no está dibujada") == 1
    )
    assert "refresh" not in entera and "falta un programa" not in entera and "Aún no está" not in entera


def test_web(lab):
    lab("web", dice="la página irá sin las imágenes que faltan", FALLA="programa")
    assert "irá sin" not in lab("web", dice="Hecha: ").stderr
    web = lab.raiz / "web"
    datos = {f.name for f in (web / "datos").iterdir()}
    assert datos == {f"{n}.js" for n in ("js", "wasm", "shaders", "esqueletos", "codigo", "editor", "t.rgb")}
    empaquetado = (web / "datos/shaders.js").read_text().split('"')[3]
    assert json.loads(zlib.decompress(base64.b64decode(empaquetado))) == {"ch01_uno/a.vert": "uno"}
    pagina = (web / "index.html").read_text()
    assert (
        '"nombre":"a"' in pagina
        and '"anima":true' in pagina
        and (web / "ch01_uno/a.jpg").read_bytes()[:2] == b"\xff\xd8"
    )
    miniatura = web / "ch01_uno/a.jpg"
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


def test_windows(lab):
    lab("windows", 1, "faltan los fuentes de FreeGLUT y GLEW")
    lab("windows", 1, "falla fuentes", FALLA="fuentes", LAB_SIN_INSTALAR="")
    fuentes = lab.build / "windows/fuentes"
    assert not fuentes.exists()  # o todos o ninguno
    lab("windows", dice="Hecho: ", LAB_SIN_INSTALAR="")
    assert "source" in lab.llamadas("apt-get")[-1] and not (lab.build / "windows/apt").exists()
    assert "Descargo" not in lab("windows", dice="Hecho: ").stderr
    with zipfile.ZipFile(lab.raiz / "windows/laboratorio-windows.zip") as contenido:
        ficheros = {f.removeprefix("laboratorio/") for f in contenido.namelist()}
        pagina = contenido.read("laboratorio/index.html").decode()
        assert (
            b"\r\n" in contenido.read("laboratorio/LEEME.txt")
            and contenido.read("laboratorio/programas/libstdc++-6.dll") == b"aligerada\n"
        )
    assert ficheros == {
        "LEEME.txt",
        "index.html",
        "imagenes/ch01_uno/a.jpg",
        "imagenes/ch01_uno/b.jpg",
        "ch01_uno/a.vert",
        "assets/t.rgb",
        *(
            f"programas/{f}"
            for f in ("a.exe", "b.exe", "uno.dll", "libstdc++-6.dll", "libgcc_s_seh-1.dll", "libwinpthread-1.dll")
        ),
        *(f"licencias/{n}.txt" for n in ("dejavu", "freeglut", "gcc", "glew", "glm", "laboratorio", "mingw-w64")),
    }
    assert (
        "A &lt;b&gt;" in pagina
        and 'src="imagenes/ch01_uno/a.jpg"' in pagina
        and "a.exe" in pagina
        and "<li>a gira</li>" in pagina
    )
    antes = (lab.raiz / "windows/laboratorio-windows.zip").read_bytes()
    lab("windows", 1, "no compila", FALLA="compila")
    assert (lab.raiz / "windows/laboratorio-windows.zip").read_bytes() == antes


def lleno(fichero):
    """Un disco sin sitio para ese fichero: /dev/full."""
    fichero.parent.mkdir(parents=True, exist_ok=True)
    Path(f"{fichero}.parcial").symlink_to("/dev/full")


@pytest.mark.parametrize(
    "orden,fichero",
    [
        ("galeria", "galeria/index.html"),
        ("galeria", "galeria/.hecho.json"),
        ("galeria", "galeria/ch01_uno/a.png"),
        ("web", "web/index.html"),
        ("web", "web/ch01_uno/a.jpg"),
        ("mide t", "informe/index.html"),
        ("mide t", "informe/t.tsv"),
        ("mide t", "informe/t.svg"),
        ("lista --docs", "docs/programas.md"),
    ],
)
def test_disco_lleno(lab, orden, fichero):
    lab(orden)
    antes = (lab.raiz / fichero).read_bytes()
    if fichero.endswith((".png", ".jpg")):  # para que se haga
        (lab.raiz / fichero).unlink()
        antes = None
    lleno(lab.raiz / fichero)
    lab(orden, 1, "no queda sitio en el disco")
    assert ((lab.raiz / fichero).read_bytes() if (lab.raiz / fichero).exists() else None) == antes


def test_corrige(lab):
    clase = lab.sitio / "aqui/clase"
    (clase / "ana").mkdir(parents=True)
    for orden, dice in (
        ("", "no entiendo"),
        ("noesta E3.5", "no hay ninguna carpeta «noesta»"),
        ("clase", "di qué ejercicio es"),
        ("clase E9.9", "«E9.9» no es un ejercicio"),
        ("clase/ana", "no dice de qué ejercicio es"),
        ("clase E1.2 --guiones x", "no entiendo"),
    ):
        lab(f"corrige {orden}", 1, dice)
    assert [f.name for f in clase.rglob("*")] == ["ana"] and not lab.llamadas("bwrap")


def test_mide(lab):
    lab("mide t", dice="Hecho: ")
    informe = lab.raiz / "informe"
    assert (
        informe / "t.tsv"
    ).read_text() == "variante\tgrupo\terror\tnota\ttiempo en cada ronda\na\t-\t0.5\t-\t2 1 3\n"
    assert (informe / "t.svg").read_text().startswith("<svg>set terminal svg") and "T" in (
        informe / "index.html"
    ).read_text()
    (lab.sitio / "bin/gnuplot").unlink()
    if not shutil.which("gnuplot"):
        lab("mide t", 1, "t ha fallado: no encuentro gnuplot")
    lab("mide t", 1, "t ha fallado: error: falla mide", FALLA="mide")
    (lab.raiz / "herramientas/mide/ensayo.tsv").write_text("t\ta\t0.7\n")
    lab("mide --ensayo", 1, "«a» se equivoca 0.5 y se esperaba 0.7")
    (lab.raiz / "herramientas/mide/ensayo.tsv").write_text("t\ta\t0.5\n")
    shutil.rmtree(informe)
    lab("mide --ensayo", dice="t: 1 variantes")
    assert not informe.exists()


def test_prueba(lab):
    (lab.build / "fallos").mkdir(parents=True)
    (lab.build / "fallos/viejo.ppm").write_text("P6")
    lab("prueba -R 'uno|dos' -V")
    assert lab.llamadas("cmake")[0][-1] == "-DLAB_AVISOS_SON_ERRORES=ON"
    opciones = lab.llamadas("ctest")[0]
    assert opciones[:2] == ["--test-dir", str(lab.build)] and opciones[-3:] == ["-R", "uno|dos", "-V"]
    assert not (lab.build / "fallos").exists()
    lab("prueba --junit resultados.xml -I 2,,3")
    assert (
        lab.llamadas("ctest")[0][-2:] == ["-I", "2,,3"]
        and 'name="uno"' in (lab.sitio / "aqui/resultados.xml").read_text()
    )
    lab("prueba --junit no/existe.xml", 1, "no puedo escribir")
    lab("prueba --junit mal.xml", 8, f"está en {lab.build}/fallos/index.html\n", MAL="1")
    assert 'status="fail"' in (lab.sitio / "aqui/mal.xml").read_text()
    assert {f.name for f in (lab.build / "fallos/osmesa").iterdir()} == {
        f"a-{que}.{tipo}" for que in ("esperada", "obtenida", "diferencia") for tipo in ("ppm", "png")
    }
    pagina = (lab.build / "fallos/index.html").read_text()
    assert 'src="osmesa/a-obtenida.png"' in pagina and "DISTINTAS: &lt;b&gt;" in pagina and 'id="uno"' not in pagina
    lab("prueba -N", 1, "LAB_OPENGL: no conozco «otra»", LAB_OPENGL="otra")
    paquetes = [set(lab("paquetes", LAB_OPENGL=opengl).stdout.split()) for opengl in ("", "zink")]
    assert "g++" in paquetes[0] and paquetes[1] - paquetes[0] == {"mesa-vulkan-drivers"} and not lab.llamadas("cmake")
    lab("prueba --cambios", dice="Todas las pruebas han pasado ya con lo que hay")
    assert not any("--parallel" in ll for ll in lab.llamadas("ctest"))
    (lab.raiz / "docs/soluciones.md").write_text("otra")
    lab("prueba --cambios")
    assert lab.llamadas("ctest")[1][-2:] == ["-R", "^(.*)$"]
    lab("prueba --cambios -R x", 1, "sobra -R")
    lab("prueba", 3, "falla ctest", FALLA="ctest")
    lab("prueba --asan")
    assert (
        lab.llamadas("cmake")[0][:4] == ["--preset", "asan", "-B", f"{lab.build}/asan"]
        and lab.llamadas("ctest")[0][1] == f"{lab.build}/asan"
    )


def test_ver(lab):
    aqui = lab.sitio / "aqui"
    lab("ver l1.1", dice="lo he dibujado en a.png", salida="salida de a\n")
    assert (aqui / "a.png").read_bytes()[1:4] == b"PNG" and not (lab.raiz / "a.png").exists()
    lab("ver ch01 -x 'y z'", dice="a: A <b>")
    assert [ll[-2:] for ll in lab.llamadas("a") + lab.llamadas("b")] == [["-x", "y z"]] * 2
    lab("ver ch01", 3, "falla programa", FALLA="programa")
    (aqui / "a.png").unlink()
    lab("ver a -x 'y z'", DISPLAY=":9")
    assert lab.llamadas("a") == [["-x", "y z"]] and not (aqui / "a.png").exists()
    lab("ver a", 4, "otra cosa", DISPLAY=":9", ESTADO="4", ESCRIBE="otra cosa")
    lab("ver a -x", 1, "failed to open display", DISPLAY=":9", ESTADO="1", ESCRIBE="failed to open display")
    assert len(lab.llamadas("a")) == 2  # y sin ventana
    lab.catalogo["programas"][1]["consola"] = "TRUE"
    lab.cataloga()
    (lab.build / "catalogo.json").unlink()
    (aqui / "b.png").unlink()
    lab("ver b")
    assert lab.llamadas("b") == [[]] and not (aqui / "b.png").exists()
    proceso = lab.empieza("ver a", "programa")
    assert lab.libre()  # con la ventana abierta se puede seguir trabajando
    lab.interrumpe(proceso, signal.SIGTERM)


def test_lo_de_mios_se_ve_como_lo_demas(lab):
    lab(
        "nuevo l1.1 mi_a",
        salida=f"{lab.raiz}/mios/mi_a: una copia, para jugar con ella. Para verla, ./lab ver mios/mi_a\n",
    )
    lab("nuevo l1.1 mi_a", 1, "ya existe")
    suyo = lab.build / "osmesa/mios/mi_a/a"
    suyo.parent.mkdir(parents=True)
    suyo.symlink_to(RAIZ / "tests/ordenes/falso.sh")
    lab("ver mi_a", dice="lo he dibujado en mi_a.png", salida=f"salida de a con {lab.raiz}/mios/mi_a\n")
    assert (lab.sitio / "aqui/mi_a.png").exists() and "mio_mi_a_osmesa" in lab.llamadas("cmake")[-1]
    lab("ver mios/mi_a/", 1, "mios/mi_a no compila", FALLA="compila")
    (lab.raiz / "mios/b").mkdir()  # se llama como un programa, que va antes
    lab("ver b", salida="salida de b\n")
    lab("ver mios/b", 1, "no encuentro")
    lab("ver mios/c", 1, "no encuentro")
    (lab.raiz / "mios/mi_a/ejercicio.txt").unlink()
    lab("ver mi_a", 1, "falta")


def test_dora(lab):
    assert lab("dora a b").stdout.count("1|llvmpipe|") == 3
    assert lab.llamadas("casos.sh") == [
        [str(lab.build), "osmesa", *caso.split()] for caso in ("a base", "a dos", "b base")
    ]
    lab("dora a-dos")
    assert lab.llamadas("cmake")[-1][3:] == ["compara", "compara_encima", "a_osmesa"]
    assert len(lab.llamadas("casos.sh")) == 1
    (lab.raiz / "tests/golden/ch01_uno").mkdir()
    (lab.raiz / "tests/golden/ch01_uno/a.pasos").touch()
    lab("dora a-dos b a")
    assert [c[1:] for c in lab.llamadas("casos.sh") if c[1] == "pasos"] == [["pasos", "a"]]
    shutil.rmtree(lab.raiz / "tests/golden/ch01_uno")
    if os.geteuid():  # root puede siempre
        (lab.raiz / "tests/golden").chmod(0o555)
        lab("dora a", 1, "no puedo escribir en")
        (lab.raiz / "tests/golden").chmod(0o755)
    (lab.raiz / "tests/golden").rmdir()
    lab("dora a", 1, "no puedo escribir en")


def test_de_uno_en_uno(lab):
    lab("lista")
    otro = subprocess.Popen(["flock", lab.build / ".cerrojo", "sleep", "0.5"])
    while lab.libre():
        time.sleep(0.01)
    lab("lista", dice="Hay otro ./lab trabajando")
    assert otro.wait() == 0
    otro = subprocess.Popen(["flock", lab.build / ".cerrojo", "sleep", "20"])
    while lab.libre():
        time.sleep(0.01)
    lab("lista", LAB_CERROJO=str(lab.build))  # lo tiene quien nos llama
    espera = subprocess.Popen([lab.raiz / "lab", "lista"], env=lab.entorno, stderr=subprocess.PIPE)
    assert b"espero a que acabe" in espera.stderr.readline()
    espera.terminate()
    assert espera.wait(10) == 143
    otro.kill()


def test_instala(lab):
    lab("lista")
    assert not lab.llamadas("apt-get") and not lab.llamadas("dpkg-query")
    lab("prueba", dice="Instalo los paquetes que faltan: ", LAB_SIN_INSTALAR="")
    ponen = lab.llamadas("apt-get")[-1]
    assert (
        "install" in ponen
        and {"python3-pytest", "shellcheck", "netpbm"} < set(ponen)
        and not {"g++", "cmake"} & set(ponen)
    )
    assert lab("lista", dice="Instalo con sudo", LAB_SIN_INSTALAR="", FALSO_ID="1000") and lab.llamadas("sudo")[-1][
        :3
    ] == ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    (lab.sitio / "bin/sudo").unlink()
    if not shutil.which("sudo"):
        lab("lista", 1, "faltan paquetes y no hay sudo", LAB_SIN_INSTALAR="", FALSO_ID="1000")


def test_en_otros_sistemas(lab):
    """Sin apt-get, ni con qué compilar, dice cómo se llaman los paquetes; y los dice todos."""
    tabla = [fila.split("\t") for fila in (RAIZ / "herramientas/base/paquetes.tsv").read_text().splitlines()]
    assert {len(fila) for fila in tabla} == {3}
    texto = (RAIZ / "lab").read_text()
    listas = [
        re.search(rf"^{lista}=\(?([^)#\n]+(?:\n  [^)]+)*)", texto, re.M)[1]
        for lista in ("PAQUETES", "PAQUETES_PRUEBAS", "PAQUETES_MEDIDAS", "OPCIONAL")
    ]
    assert {p for lista in listas for p in lista.split()} == {fila[0] for fila in tabla[1:]}
    lab("lista")
    (lab.sitio / "solo").mkdir()
    for quien in ("bash", "dirname", "readlink", "find", "mkdir", "flock", "awk"):
        (lab.sitio / "solo" / quien).symlink_to(shutil.which(quien))
    dicho = lab(
        "lista", 1, "solo sé instalar en Debian y derivados", LAB_SIN_INSTALAR="", PATH=str(lab.sitio / "solo")
    ).stderr
    assert (
        re.search(r"libglew-dev +glew-devel +glew\n", dicho) and "libosmesa6-dev" in dicho and "shellcheck" not in dicho
    )


@pytest.mark.parametrize(
    "orden,para,senal",
    [
        (orden, para, senal)
        for i, (orden, etapas) in enumerate(
            (
                ("galeria", "configura compila programa"),
                ("web", "configura programa rasgos"),
                ("mide t", "configura compila mide"),
                ("prueba", "configura compila ctest"),
                ("ver a", "configura compila programa"),
                ("dora a", "configura compila caso"),
                ("muta", "configura compila prueba"),
                ("windows", "configura fuentes compila programa"),
                ("lista", "configura"),
            )
        )
        for j, para in enumerate(etapas.split())
        for senal in [(signal.SIGINT, signal.SIGTERM)[(i + j) % 2]]
    ],
)
def test_una_senal_lo_acaba_todo(lab, orden, para, senal):
    descarga = {"LAB_SIN_INSTALAR": ""} if orden == "windows" else {}
    lab.interrumpe(lab.empieza(orden, para, **descarga), senal)
    if orden in ("galeria", "web"):  # y se puede seguir
        lab(orden, dice="Hecha: ")
