"""Lo que se pregunta a cada orden de `./lab ayuda`, a cada opción y a cada variable LAB_*, en un laboratorio de mentira
(falso.sh): que acabe mal y lo diga en español, sin dejar nada a medias, con el disco lleno, sin permiso, sin salida,
sin red o en una carpeta que CMake no admite; y que una opción cambie lo suyo y nada más."""
import os
import re
import resource
import signal
import subprocess
import tempfile
from pathlib import Path

import pytest
from mentira import siembra
from ordenes_test import RAIZ, Lab

AYUDA = subprocess.check_output([RAIZ / "lab", "ayuda"], text=True)
ORDENES = re.findall(r"^\./lab (\w+)", AYUDA, re.M)
# Con qué se prueba cada una, que sale bien.
EJEMPLOS = dict(zip(ORDENES, ORDENES)) | {
    "prueba": "prueba",
    "ver": "ver a",
    "explica": "explica a",
    "nuevo": "nuevo l1.1 copia",
    "lista": "lista --docs",
    "mide": "mide t",
    "dora": "dora todo",
    "muta": "muta --comprueba",
    "corrige": "corrige clase E1.2",
    "ejercicio": "ejercicio comprueba uno",
}
SIN_PREPARAR = {"paquetes", "ayuda"}  # no compilan ni escriben nada
PREPARAN = [orden for orden in ORDENES if orden not in SIN_PREPARAR]
NO_ES_ESPANOL = re.compile(
    r"line \d+: |: \w+ error|Traceback|Exception|No such|Permission|cannot|failed|File too|No space"
)
# Un corrector que solo dice cómo se le llama: el de verdad, en corrige_test; y el que comprueba, en propios_test.
CORRECTOR = """import os, subprocess, sys
from base.procesos import principal
def main():
    libre = subprocess.call(["flock", "-n", sys.argv[2] + "/.cerrojo", "true"]) == 0
    print("a" if "--programa" in sys.argv else [os.getcwd(), libre, sys.argv[3:]])
principal(main)
"""


class Preguntado(Lab):
    def __init__(self, sitio):
        super().__init__(sitio)
        siembra(self.raiz, {".gitignore": (RAIZ / ".gitignore").read_text()})
        siembra(self.raiz, {"tests/golden/ch01_uno/a.txt": "de antes", "tests/golden/ch01_uno/b.txt": "de ahora\n"})
        suyos = "corrige/orden.py", "comprueba.py"
        siembra(self.raiz, {f"herramientas/ejercicios/{f}": CORRECTOR for f in suyos})
        self.git("init", "-q")
        self.git("add", "-A")
        (sitio / "llamadas").touch()

    def git(self, *orden):
        return subprocess.check_output(["git", "-C", self.raiz, *orden], text=True, stderr=subprocess.DEVNULL)

    def hay(self):
        """Lo que hay en cada fichero, menos en build/, que es de usar y tirar."""
        de = [self.raiz, self.sitio / "aqui"]
        todos = [
            f for carpeta in de for f in carpeta.rglob("*") if not {".git", "build"} & set(f.relative_to(carpeta).parts)
        ]
        return {f: f.read_bytes() for f in todos if f.is_file()}

    def vuelve(self, antes):
        """Lo que hay, otra vez como antes."""
        hay = self.hay()
        for f in hay.keys() - antes.keys():
            f.unlink()
        for carpeta in sorted(self.raiz.glob("mios/*")):
            carpeta.rmdir()
        for f, datos in antes.items():
            if hay.get(f) != datos:
                f.parent.mkdir(parents=True, exist_ok=True)
                f.write_bytes(datos)

    def hace(self, orden, stdout=subprocess.PIPE, antes_de=None, quien=None, **entorno):
        (self.sitio / "llamadas").write_text("")
        como = {"stdin": subprocess.DEVNULL, "stdout": stdout, "stderr": subprocess.PIPE, "timeout": 60}
        return subprocess.run(**self.orden(orden, **entorno), **como, **(quien or {}), preexec_fn=antes_de)

    def falla(self, orden, dice="", stdout_rota=False, o_bien=None, **como):
        """Si acaba mal y lo dice: al final, una línea suya; y ninguna de otro."""
        r = self.hace(orden, **como)
        if o_bien is not None and r.returncode == 0:  # no le ha hecho falta lo que no hay
            assert self.hay() == o_bien
            return
        ultima = (r.stderr.splitlines() or [""])[-1]
        bien = r.returncode in (1, 2) and re.match(r"(lab|a): ", ultima) and dice in ultima
        bien = bien or stdout_rota and r.returncode in (128 + signal.SIGPIPE, -signal.SIGPIPE)
        assert bien and not NO_ES_ESPANOL.search(r.stderr), f"{orden}: {r.returncode}\n{r.stderr}"
        self.no_deja_nada()


@pytest.fixture
def lab():
    with tempfile.TemporaryDirectory() as sitio:
        os.chmod(sitio, 0o755)  # lo mira otro usuario
        yield Preguntado(Path(sitio))


def test_cada_orden_sale_bien_y_deja_git_limpio(lab):
    """Desde la carpeta del laboratorio, que es donde se llama."""
    for orden, ejemplo in EJEMPLOS.items():
        como = lab.orden(ejemplo, LAB_SIN_INSTALAR="" if orden == "windows" else "1") | {"cwd": lab.raiz}
        r = subprocess.run(**como, capture_output=True)
        assert r.returncode == 0, f"{orden}: {r.stderr}"
        sucio = [fila[3:] for fila in lab.git("status", "--porcelain").splitlines() if fila[1] != " "]
        assert all(orden == "lista" and f.startswith("docs/") for f in sucio), f"{orden} deja {sucio}"
        lab.git("add", "-A")


def limite(bytes_):
    """Como un disco lleno: ningún fichero pasa de ahí. El otro es de los programas de mentira."""

    def pon():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (bytes_, resource.RLIM_INFINITY))

    return pon


@pytest.mark.parametrize("orden", PREPARAN)
def test_disco_lleno(lab, orden):
    """Con sitio para los ficheros pequeños y no para los grandes: cada uno está como estaba o entero."""
    antes = lab.hay()
    assert lab.hace(EJEMPLOS[orden], LAB_SIN_INSTALAR="" if orden == "windows" else "1").returncode == 0
    despues = lab.hay()
    tallas = [len(datos) for f, datos in despues.items() if antes.get(f) != datos]
    # el zip de Windows sale también sin las imágenes de la galería, que no caben
    for talla in {0, 0 if orden == "windows" else max(tallas, default=1) - 1}:
        lab.vuelve(antes)
        lab.falla(EJEMPLOS[orden], o_bien=despues, antes_de=limite(talla))
        for f, datos in lab.hay().items():
            assert datos in (antes.get(f), despues.get(f)) or f.name in (".hecho.json", "index.html"), f"{f} a medias"


@pytest.mark.parametrize("orden", PREPARAN)
def test_sin_permiso(lab, orden):
    otro = {} if os.geteuid() else {"user": 65534, "group": 65534, "extra_groups": []}
    antes = lab.hay()
    lab.temporal.chmod(0o777)
    (lab.sitio / "llamadas").chmod(0o666)
    subprocess.run(["chmod", "-R", "a-w", lab.raiz], check=True)
    lab.falla(EJEMPLOS[orden], "no puedo escribir", quien=otro, XDG_CACHE_HOME="/proc")
    if orden in ("galeria", "nuevo", "web", "lista", "mide"):  # con dónde, sale bien y todo queda allí
        cache, ejemplo = lab.sitio / "cache", EJEMPLOS[orden].removesuffix(" --docs")
        cache.mkdir()
        cache.chmod(0o777)
        assert lab.hace(ejemplo, quien=otro, XDG_CACHE_HOME=str(cache)).returncode == 0
        assert lab.hay() == antes and list(cache.rglob("build"))
    subprocess.run(["chmod", "-R", "u+w", lab.raiz], check=True)


@pytest.mark.parametrize("orden", ORDENES)
def test_sin_salida(lab, orden):
    """Llena, cerrada o que nadie lee. Lo que no escribe nada en ella no se entera."""
    antes = lab.hay()
    escribe = lab.hace(EJEMPLOS[orden], LAB_SIN_INSTALAR="" if orden == "windows" else "1").stdout
    lee, nadie = os.pipe()
    os.close(lee)
    with open("/dev/full", "w") as llena, os.fdopen(nadie, "w") as rota:
        for salida, cierra in ((llena, None), (rota, None), (None, lambda: os.close(1))):
            lab.vuelve(antes)
            como = {"stdout": salida, "antes_de": cierra, "stdout_rota": salida == rota}
            if escribe:
                lab.falla(EJEMPLOS[orden], "no puedo escribir", **como)
            else:
                assert lab.hace(EJEMPLOS[orden], salida, cierra).returncode == 0


def test_donde_cmake_no_puede(lab):
    for signo in ';:"\\#\n':
        lab.raiz = lab.raiz.rename(lab.sitio / f"a{signo}b")
        antes = sorted(lab.sitio.rglob("*"))
        for orden in PREPARAN:
            lab.falla(EJEMPLOS[orden], "CMake no sabe trabajar en una carpeta con")
        assert sorted(lab.sitio.rglob("*")) == antes


@pytest.mark.parametrize("orden", PREPARAN)
def test_sin_red(lab, orden):
    antes = lab.hay()
    lab.falla(EJEMPLOS[orden], "(¿hay red?)", LAB_SIN_INSTALAR="", FALLA="red")
    assert lab.hay() == antes


@pytest.mark.parametrize("orden", PREPARAN)
def test_matada_sin_remedio(lab, orden):
    """Con KILL no puede recoger nada, pero la siguiente sale bien."""
    proceso = lab.empieza(EJEMPLOS[orden], "configura")
    os.killpg(proceso.pid, signal.SIGKILL)
    proceso.communicate()
    for nieto in lab.nietos():
        os.kill(nieto, signal.SIGKILL)
    assert lab.libre(espera=30)
    assert lab.hace(EJEMPLOS[orden], LAB_SIN_INSTALAR="" if orden == "windows" else "1").returncode == 0


VARIOS = {  # de las que hacen lo mismo con varias cosas, lo que puede fallar de cada una
    "ver ch01": ("programa a", "programa b"),
    "galeria": ("programa a", "programa b"),
    "dora todo": ("caso a.base", "caso a.dos", "caso b.base"),
    "dora a b": ("caso a.base", "caso a.dos", "caso b.base"),
}


@pytest.mark.parametrize("orden", VARIOS)
def test_uno_malo_de_varios(lab, orden):
    """Sea el que sea, lo demás se hace, y el estado es el de que algo ha ido mal; también si antes se ha compilado otra
    vez porque los avisos eran errores."""
    antes, con_avisos = lab.hay(), [{}] if orden.startswith("dora") else [{}, {"AVISOS": "1"}]

    def hechas(estado, **como):
        lab.vuelve(antes)
        (lab.build / "sin_avisos").unlink(missing_ok=True)
        assert (lab.hace(orden, **como).returncode != 0) == estado, como
        return sorted(ll for quien in ("a", "b", "casos.sh") for ll in map(str, lab.llamadas(quien)))

    for avisos in con_avisos:
        bien = hechas(False, **avisos)
        assert len(bien) >= len(VARIOS[orden])
        for malo in VARIOS[orden]:
            # el que falla no llega a lo que viene detrás
            assert len(hechas(True, FALLA=malo, **avisos)) >= len(VARIOS[orden]), malo


# --- cada opción y cada variable cambia lo suyo ---------------------------------------------------------------------


def llamadas(lab, orden):
    """Lo que llama cada orden y los ficheros que deja, menos los de quien se ha llamado antes."""
    assert lab.hace(orden).returncode == 0, orden
    filas = (lab.sitio / "llamadas").read_text().replace("\0", " ").replace(str(lab.raiz), "R").split(" \n ")
    return {fila.strip() for fila in filas} | {
        str(f.relative_to(lab.sitio)) for f in lab.hay() if f.parent.name == "aqui"
    }


# De cada opción de la ayuda, la orden sin ella y con ella, y lo que solo está en una de las dos.
OPCIONES = {
    "--asan": ("prueba", "prueba --asan", "asan"),
    "--junit": ("prueba", "prueba --junit r.xml", "r.xml"),
    "-I": ("prueba", "prueba -I 2,,3", "ctest"),
    "-R": ("prueba", "prueba -R uno", "ctest"),
    "--comprueba": ("lista", "muta --comprueba", ""),
    "--tsv": ("lista", "lista --tsv", ""),
    "-ayuda": ("ver a", "ver a -ayuda", "-ayuda"),
    "--vigila": ("ver a", "ver a --vigila", "vigilando"),
    "-guion": ("explica a", "explica a -guion x", "-guion"),
    "-geometry": ("explica a", "explica a -geometry 80x40", "-geometry"),
    "--json": ("explica a", "explica a --json e.json", "e.json"),
}
OTRAS = {"--cambios", "--apunta", "--docs", "--ensayo", "--mira"}  # sus propias pruebas: test_prueba_lo_que_cambia…


def test_cada_opcion_de_la_ayuda_cambia_lo_suyo(lab):
    de_lab = re.sub(r"\./lab corrige .*?(?=\./lab paquetes)", "", AYUDA, flags=re.S)  # las suyas, abajo
    assert set(re.findall(r"(?<![\w-])(--?[a-zA-Z]+)\b", de_lab)) == OPCIONES.keys() | OTRAS
    for opcion, (sin, con, cambia) in OPCIONES.items():
        sin, con = llamadas(lab, sin), llamadas(lab, con)
        distintas = sin ^ con
        assert bool(distintas) == bool(cambia) and all(
            cambia in d or d in sin for d in distintas
        ), f"{opcion}: {distintas}"


def listas():
    """Los paquetes que el guion pone en cada PAQUETES_*."""
    guion = (RAIZ / "lab").read_text()
    return {n: set(p.split()) for n, p in re.findall(r"^PAQUETES_(\w+)=\(([^)]*)\)", guion, re.M)}


VARIABLES = {  # lo que añade a los paquetes, y a qué orden le cambia algo
    "LAB_SIN_INSTALAR": ((), ""),
    "LAB_NAVEGADOR": (("NAVEGADOR", "WEB"), ""),
    "LAB_WINDOWS": (("WINE",), "x86_64"),
    "LAB_OPENGL": ((), ""),
    "LAB_PARES": ((), "-DLAB_PARES=1"),
}


def test_cada_variable_de_la_ayuda_cambia_lo_suyo(lab):
    assert set(re.findall(r"\bLAB_\w+", AYUDA)) == VARIABLES.keys()
    nada = set(lab.hace("paquetes").stdout.split())
    for variable, (arreglos, _) in VARIABLES.items():
        valor = "zink" if variable == "LAB_OPENGL" else "1"
        mas = set().union(*(listas()[a] for a in arreglos)) | ({"mesa-vulkan-drivers"} if valor == "zink" else set())
        assert set(lab.hace("paquetes", **{variable: valor}).stdout.split()) == nada | mas, variable
        assert not mas or mas - nada
    for pares in ("", "1"):
        assert lab.hace("mide t", LAB_PARES=pares).returncode == 0
        configura = [ll for ll in lab.llamadas("cmake") if "--preset" in ll]
        assert any("-DLAB_PARES=1" in ll for ll in configura) == bool(pares)
    assert lab.hace("mide t", LAB_SIN_INSTALAR="").returncode == 0
    instala = next(set(ll) for ll in lab.llamadas("apt-get") if "install" in ll)
    assert listas()["MEDIDAS"] <= instala and not listas()["PARES"] & instala


def test_corrige_recibe_sus_opciones(lab):
    """Todas las de la ayuda, en la carpeta de quien llama y sin el cerrojo."""
    suyas = re.findall(r"(?<!\w)(--?[a-z][\w-]*)", AYUDA.split("./lab corrige", 1)[1].split("./lab paquetes")[0])
    assert {"--semilla", "--vpl", "-j", "--sin-jaula"} <= set(suyas)
    orden = " ".join(["clase", "E1.2", *suyas])
    assert lab.hace(f"corrige {orden}").stdout == f"{[str(lab.sitio / 'aqui'), True, orden.split()]}\n"
