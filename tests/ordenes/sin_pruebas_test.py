"""Cada orden es la primera de alguien: el laboratorio de verdad, con lo que ya está compilado en $LAB_BUILD, sin
tests/ y sin GoogleTest. Lo que escriben va a una copia: lo de quien lo prueba no se toca."""
import json
import os
import re
import shlex
import shutil
import subprocess
from threading import Thread

import pytest
from mentira import BUILD, RAIZ, se_encierra

DE_LAS_PRUEBAS = {"tests", "fallos", "mutantes", "web", "windows", "asan", "corrige", "cache_shaders", "osmesa"}


class SinPruebas:
    """./lab, donde de la carpeta solo queda lo que hace falta, y escribe en las de `sitio`."""

    def __init__(self, sitio):
        self.sitio = sitio
        for carpeta in ("build", "mios", "explica", "galeria", "informe", "ejercicios", "aqui"):
            (sitio / carpeta).mkdir()
        shutil.copytree(RAIZ / "docs", sitio / "docs")
        subprocess.run(["cp", "-a", *(f for f in BUILD.iterdir() if f.name not in DE_LAS_PRUEBAS), sitio / "build"])
        suyas = {f.name for f in sitio.iterdir()} - {"aqui"}
        quedan = {f.name for f in RAIZ.iterdir()} - suyas - {"tests", "web", "windows", ".git"}
        self.jaula = ["bwrap", "--dev-bind", "/", "/", "--tmpfs", RAIZ]
        self.jaula += [p for nombre in quedan for p in ("--ro-bind", RAIZ / nombre, RAIZ / nombre)]
        self.jaula += [p for nombre in suyas for p in ("--bind", sitio / nombre, RAIZ / nombre)]
        gtest = re.findall(r"^GTest_DIR:PATH=(/.*)", (BUILD / "CMakeCache.txt").read_text(), re.M)
        self.jaula += [p for carpeta in gtest for p in ("--tmpfs", carpeta)]
        self.entorno = {c: v for c, v in os.environ.items() if "DISPLAY" not in c and not c.startswith("LAB_")}
        self.entorno |= {"LAB_SIN_INSTALAR": "1", "TMPDIR": "/tmp", "PYTHONDONTWRITEBYTECODE": "1"}

    def __call__(self, orden, estado=0, dice="", **entorno):
        orden = [*self.jaula, "--chdir", self.sitio / "aqui", RAIZ / "lab", *shlex.split(orden)]
        r = subprocess.run(orden, env=self.entorno | entorno, text=True, stdin=subprocess.DEVNULL, capture_output=True)
        dicho = r.stdout + r.stderr
        raro = "Traceback" in dicho or "\033" in dicho  # por dónde va, solo se dice en una terminal
        assert r.returncode == estado and dice in dicho and not raro, f"{r.returncode}\n{dicho}"
        hechas = [h.replace(str(RAIZ), str(self.sitio)) for h in re.findall(r"Hecha: ([^\n:]+?)(?: \(.*)?\n", dicho)]
        assert all(map(os.path.getsize, hechas)), hechas  # están, y con algo
        return dicho

    def deja(self, fichero, empieza):
        """Si ha dejado ese fichero, que no estaba, y nada más."""
        [hecho] = (self.sitio / "aqui").iterdir()
        bien = hecho.name == fichero and hecho.read_bytes().startswith(empieza)
        hecho.unlink()
        return bien


def sin_pruebas(carpeta):
    """El laboratorio en esa carpeta, si se puede."""
    if BUILD.parent != RAIZ or not (BUILD / "catalogo.json").exists():
        pytest.skip("lo compilado no está en su carpeta")
    if not se_encierra():
        pytest.skip("aquí no se puede encerrar nada")
    lab = SinPruebas(carpeta)
    if not se_encierra(*lab.jaula):  # que es otra jaula dentro de esta
        pytest.skip("aquí no se puede encerrar nada en lo que ya está encerrado")
    return lab


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    return sin_pruebas(tmp_path_factory.mktemp("lab"))


def test_lista_y_documentos(lab):
    lab("ayuda", dice="./lab galeria")
    lab("lista", dice="Grúa de obra")
    antes = {f: f.read_bytes() for f in (lab.sitio / "docs").iterdir() if f.is_file()}
    lab("lista --docs")
    assert antes == {f: f.read_bytes() for f in antes}


@pytest.mark.parametrize("orden", ["prueba", "dora grua", "muta --comprueba"])
def test_sin_pruebas_no_se_prueba(lab, orden):
    assert lab(orden, 1) == f"lab: {orden.split()[0]}: hace falta la carpeta tests/\n"


def test_nuevo_y_corrige(lab):
    lab("nuevo E3.5 x", dice="/mios/x")
    for como in "x", "mios/x", "./mios/x/", "mios/x/x.cpp", f"{RAIZ}/mios/x", f"{RAIZ}/mios/x/x.cpp":
        lab(f"ver {como} --vigila -ppm f.ppm")
        assert lab.deja("f.ppm", b"P6")
    lab("corrige x --guiones 1", 1, "x, E3.5: 0 de 100 (")
    assert "punto de partida" in (lab.sitio / "mios/x/correccion/index.html").read_text()
    orden = ["script", "-qec", shlex.join([*map(str, lab.jaula), str(RAIZ / "lab"), *"corrige x --guiones 1".split()])]
    dicho = subprocess.run([*orden, "/dev/null"], env=lab.entorno, capture_output=True).stdout
    assert b"\r\x1b[K[6/6] juega la entrega\r\x1b[K" in dicho and b"\x1b[Kx, E3.5: 0 de 100 (" in dicho


def test_ver(lab):
    lab("ver E3.5", dice="lo he dibujado en grua.png")
    assert lab.deja("grua.png", b"\x89PNG")
    lab("ver grua -volando", 2, "no entiendo «-volando»")
    assert lab("ver ch12 -volando", 2).count("no entiendo «-volando»") > 1, "de un capítulo, todos"
    os.mkfifo(fifo := lab.sitio / "guion")
    abierto = Thread(target=lab, args=(f"ver grua -ppm f.ppm -guion @{fifo}",))
    abierto.start()
    with fifo.open("w"):  # ya lo está leyendo: con un programa abierto se puede seguir trabajando
        assert subprocess.run(["flock", "-n", lab.sitio / "build/.cerrojo", "true"]).returncode == 0
    abierto.join()
    assert lab.deja("f.ppm", b"P6")
    lab("ver info_opengl", dice="GLSL: ")


def test_explica(lab):
    """Un píxel de la grúa, que es de su base; y uno de más."""
    dicho = lab("explica E3.5 120 90 -geometry 240x180 -guion 'tecla d' --json f.json", dice="grua en (120, 90): (")
    assert re.search(r"\n   1  borra color, profundidad · grua.cpp:\d+, dibuja: borrado → \(222, 237, 250\)\n", dicho)
    assert lab.deja("f.json", b'{\n "programa": "grua"')
    assert "muestraCuadro" in (lab.sitio / "explica/grua.html").read_text()
    for fuera in ("1200 179", "1199 180"):
        lab(f"explica grua {fuera} -geometry 1200x180", 1, f"{fuera} está fuera de la ventana, de 1200×180")
    lab("explica grua 1199 179 -geometry 1200x180")
    lab("explica info_opengl", 1, "info_opengl escribe texto y no dibuja nada")
    lab("explica grua -guion 'tecla Esc'", 1, "¿pulsa Esc el guion?")


DOCUMENTOS = [RAIZ / "README.md", *sorted((RAIZ / "docs").glob("*.md"))]
EJEMPLOS = [e for f in DOCUMENTOS for e in re.findall(r"\./lab (explica \w+ \d+ \d+[^`\n]*)", f.read_text())]


@pytest.mark.parametrize("orden", dict.fromkeys(EJEMPLOS))
def test_los_ejemplos_de_explica(lab, orden):
    """Los de README y docs/ explican lo que dicen, y no el fondo: al píxel le han dado color varias órdenes."""
    lab(f"{orden} --json e.json")
    historia = json.loads((lab.sitio / "aqui/e.json").read_text())["historia"]
    (lab.sitio / "aqui/e.json").unlink()
    assert len({paso["orden"] for paso in historia if paso["veredicto"] == "escrito"}) > 2, historia


def test_donde_no_se_puede_abrir_una_ventana_dibuja(lab):
    """En una pantalla que no existe, y en una sin OpenGL."""
    lab("ver grua", dice="lo he dibujado en grua.png", DISPLAY=":987")
    assert lab.deja("grua.png", b"\x89PNG")
    if not shutil.which("Xvfb"):
        pytest.skip("no hay Xvfb")
    orden = ["Xvfb", "-displayfd", "1", "-extension", "GLX", "-nolisten", "tcp"]
    with subprocess.Popen(orden, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as pantalla:
        lab("ver grua", dice="lo he dibujado en grua.png", DISPLAY=f":{pantalla.stdout.readline().strip()}")
        pantalla.terminate()
    assert lab.deja("grua.png", b"\x89PNG")


def test_mide(lab, tmp_path):
    lab("mide --ensayo", dice="variantes")
    os.symlink("/bin/false", tmp_path / "gnuplot")
    lab("mide rotacion", 1, "no se ha podido medir todo: rotacion", PATH=f"{tmp_path}:{os.environ['PATH']}")
