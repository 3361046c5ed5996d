"""Las órdenes de ./lab: lo que entienden, lo que llaman y lo que dicen cuando no pueden. Lo que ejecutan es de mentira:
construye.corre y compañía apuntan con qué se las llama. Las de verdad, en sin_pruebas_test.py y copia_test.py."""
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from mentira import RAIZ, ejecutable, espera_a, siembra

sys.path.insert(0, str(RAIZ / "herramientas"))
import lab
from base import catalogo, construye, paquetes
from base.procesos import Fallo


@pytest.fixture
def taller(tmp_path, monkeypatch):
    """Uno en una carpeta vacía, y lo que ejecuta; `estados`, con qué acaba lo que lleve esa palabra."""
    raiz = tmp_path / "x' `touch pwned` $(touch pwned) ñ [h] & (2)"
    raiz.mkdir()
    t = construye.Taller(raiz)
    t.llamadas, t.estados = [], {}

    def corre(orden, **opciones):
        palabras = [str(p) for p in orden]
        t.llamadas.append(palabras)
        if "stdout" in opciones and hasattr(opciones["stdout"], "write"):
            opciones["stdout"].write("-- No hay OSMesa\nerror: no sé\n")
        return next((e for palabra, e in t.estados.items() if palabra in palabras), 0)

    monkeypatch.setattr(construye, "corre", corre)
    return t


def configurado(t, generador="Ninja", de=None):
    cache = f"CMAKE_HOME_DIRECTORY:INTERNAL={de or t.raiz}\nCMAKE_GENERATOR:INTERNAL={generador}\n"
    siembra(t.build, {"CMakeCache.txt": cache, "catalogo.json": "{}", "sin_ventana": "osmesa\n", "resto": ""})


# --- lo que se entiende ----------------------------------------------------------------------------------------------

NO_SE_ENTIENDE = {
    "vre grua": "no conozco la orden «vre»: ¿querías decir ver?",
    "lista --csv": "lista: no entiendo «--csv»; ./lab lista --help",
    "ver": "falta PROGRAMA",
    "prueba -R": "-R: falta lo que sigue",
    "prueba --tod": "no entiendo «--tod»",
}


@pytest.mark.parametrize("pedido,dice", NO_SE_ENTIENDE.items())
def test_lo_que_no_se_entiende(pedido, dice, capsys):
    with pytest.raises(SystemExit) as fin:
        lab.entiende(lab.elige_orden(pedido.split()[0]), pedido.split()[1:])
    assert fin.value.code not in (0, None) and dice in str(fin.value.code) + capsys.readouterr().err


def test_cada_orden_tiene_su_ayuda(capfd, monkeypatch):
    assert all(f"./lab {orden}" in lab.ayuda() for orden in lab.ORDENES)
    for orden in lab.ORDENES:
        with pytest.raises(SystemExit) as fin:
            lab.entiende(orden, ["grua", "--help"])
        dicho = capfd.readouterr().out
        assert fin.value.code == 0 and f"uso: ./lab {orden}" in dicho
        assert not re.search("usage|options|positional|show this", dicho)
    for pedida, es in ("galería", "galeria"), ("test", "prueba"), ("ver", "ver"):
        assert lab.elige_orden(pedida) == es
    monkeypatch.setattr(sys, "argv", ["lab", lab.__file__.split("/herramientas/")[0]])
    with pytest.raises(SystemExit) as fin:
        lab.elige_orden("--version")
    assert fin.value.code == 0 and re.search(r"laboratorio del 20\d\d-\d\d-\d\d \([0-9a-f]+\)", capfd.readouterr().out)


PARA_CTEST = {
    "": ["-LE", "^todo$"],
    "--todo": ["-LE", "^muestra$"],
    "-R uno|dos -V": ["-R", "uno|dos", "-V"],
    "-L todo": ["-L", "todo"],
    "-LE ventana": ["-LE", "ventana|^todo$"],
    "--rerun-failed": ["--rerun-failed", "-LE", "^todo$"],
}


@pytest.mark.parametrize("pedido,palabras", PARA_CTEST.items())
def test_lo_que_se_pasa_a_ctest(pedido, palabras):
    assert lab.Laboratorio.para_ctest(lab.analizador("prueba").parse_args(pedido.split())) == palabras


HACEN = "galeria|web|windows|lista --docs|mide|prueba|prueba --apunta|prueba --junit x|dora todo|muta|ver ch01"


@pytest.mark.parametrize("pedido", HACEN.split("|"))
def test_si_algo_falla_acaba_mal_o_se_dice(taller, tmp_path, monkeypatch, capsys, pedido):
    """Cada paso de cada orden, uno a uno: instalar, configurar, compilar, lo que ejecuta y a quien se lo pasa. Y lo que
    se pide en un fichero va adonde se está."""
    hechos, laboratorio = [], lab.Laboratorio(taller.raiz, tmp_path)
    laboratorio.t, laboratorio.build = taller, taller.build

    def paso(*que, **_):
        hechos.append(que)
        siembra(taller.build, {"pruebas.xml": "<x/>"})
        return int(len(hechos) == mal)

    def falla(*que, **_):
        if paso(*que):
            raise Fallo("mal")

    for quien, que in (paquetes, "instala"), (taller, "configura"), (taller, "compila"), (laboratorio, "pasa_a"):
        monkeypatch.setattr(quien, que, falla)
    programas = [catalogo.Programa(catalogo.Capitulo("ch01_x", ""), nombre, "") for nombre in "abc"]
    monkeypatch.setattr(catalogo, "lee_programas", lambda _: programas)
    monkeypatch.setattr(lab, "corre", paso)
    monkeypatch.setattr(lab, "CODEMIRROR", tmp_path)
    monkeypatch.setattr(lab.shutil, "which", str)
    monkeypatch.delenv("DISPLAY", raising=False)
    siembra(taller.build, {"sin_ventana": "osmesa", "compila.log": ""})
    orden, *palabras = pedido.split()
    for mal in range(20):
        hechos.clear()
        try:
            estado = getattr(laboratorio, orden)(lab.entiende(orden, palabras))
        except (Fallo, SystemExit) as fin:
            estado = getattr(fin, "code", 1)
        if mal > len(hechos):
            break
        assert bool(estado) == bool(mal) or "lab: " in capsys.readouterr().err, hechos[-1]
    assert 2 < mal < 19 and not estado and (tmp_path / "x").exists() == ("x" in palabras)


def test_las_ordenes_de_los_documentos_se_entienden():
    """Las de cada bloque y cada línea de README, CONTRIBUTING y docs/."""
    ficheros = [RAIZ / "README.md", RAIZ / "CONTRIBUTING.md", *sorted(RAIZ.glob("docs/**/*.*"))]
    dichas = [
        (f.name, orden)
        for f in ficheros
        if f.suffix in (".md", ".yml", "")
        for orden in re.findall(r"\./lab ([^`#\n|;()»]+)", f.read_text().replace("${{ matrix.parte }}", "1"))
    ]
    assert len(dichas) > 40
    for fichero, orden in dichas:
        palabras = re.split(r" (?:&&|>|2>|y) |[,.:] ", orden)[0].rstrip(".,: ").split()
        if palabras and not palabras[0].isupper() and palabras[0] != "de":  # «de verdad» no es una orden
            falta = ["x"] if palabras[0] in ("ver", "explica") else []
            assert lab.entiende(lab.elige_orden(palabras[0]), palabras[1:] or falta), (fichero, orden)


# --- paquetes --------------------------------------------------------------------------------------------------------


@pytest.fixture(params=["", "cmake not-installed\n", "cmake half-installed\n", "cmake config-files\n"])
def apt(monkeypatch, tmp_path, request):
    """Un Debian en que falta cmake, de cada manera: lo que se llama, con qué acaba y qué dice."""
    hay = SimpleNamespace(llamadas=[], estados={}, uid=1000, tiene={"apt-get", "dpkg-query", "sudo"}, puestos=set())
    hay.puestos |= {*paquetes.PARA_USAR, paquetes.OPCIONAL} - {"cmake"}

    def llama(como, registro, *palabras):
        hay.llamadas.append([*como, *palabras])
        registro.write_text(hay.estados.get("dice", "E: no\n"))
        return hay.estados.get(palabras[0], 0)

    monkeypatch.setattr(paquetes, "existe", lambda _: "update" in sum(hay.llamadas, []))  # hasta entonces no se sabe
    puestos = lambda: request.param + "".join(f"{p} installed\n" for p in hay.puestos)
    monkeypatch.setattr(paquetes, "apt", llama)
    monkeypatch.setattr(paquetes, "escrito", lambda quien, *_: puestos() if quien == "dpkg-query" else "")
    monkeypatch.setattr(paquetes.os, "getuid", lambda: hay.uid)
    monkeypatch.setattr(paquetes.shutil, "which", lambda quien: quien if quien in hay.tiene else None)
    monkeypatch.delenv("LAB_SIN_INSTALAR", raising=False)
    hay.instala = lambda: paquetes.instala(paquetes.PARA_USAR, tmp_path)
    return hay


def test_instala_lo_que_falta(apt, capsys, monkeypatch):
    apt.instala()
    assert apt.llamadas[-1][0] == "sudo" and apt.llamadas[-1][-1] == "cmake" and "g++" not in apt.llamadas[-1]
    assert "Instalo con sudo los paquetes que faltan: cmake" in capsys.readouterr().err
    apt.uid = 0
    apt.instala()
    assert apt.llamadas[-1][0] == "install"
    apt.puestos, apt.llamadas = apt.puestos - {paquetes.OPCIONAL}, []
    apt.instala()
    assert apt.llamadas[-1][-2:] == ["cmake", paquetes.OPCIONAL]
    for estados, dice in (({"install": 100}, "¿hay red?"), ({"dice": "W: Operation was interrupted"}, 130)):
        apt.estados = estados
        with pytest.raises((Fallo, SystemExit)) as fallo:
            apt.instala()
        assert dice == 130 == getattr(fallo.value, "code", 0) or dice in str(fallo.value)
    monkeypatch.setenv("LAB_SIN_INSTALAR", "1")
    with pytest.raises(Fallo, match="no instalo nada, y faltan cmake"):
        apt.instala()
    apt.puestos, apt.llamadas = apt.puestos | {"cmake"}, []
    apt.instala()
    assert not apt.llamadas


def test_donde_no_se_puede_instalar(apt, capsys):
    apt.tiene.remove("sudo")
    with pytest.raises(Fallo, match="no hay sudo; .*: apt-get install --no-install-recommends cmake"):
        apt.instala()
    apt.tiene.clear()
    with pytest.raises(Fallo, match="solo sé instalar en Debian"):
        apt.instala()
    assert re.search(r"libglew-dev +glew-devel +glew\n", capsys.readouterr().err)


def test_lo_que_la_imagen_copia_antes_basta_para_los_paquetes(tmp_path):
    """Lo de docs/ci/Containerfile: aún no hay más que eso."""
    primeras = (RAIZ / "docs/ci/Containerfile").read_text().partition("RUN ")[0]
    for de in re.findall(r"^COPY (\S+) ", primeras, re.M):
        (tmp_path / de).parent.mkdir(parents=True, exist_ok=True)
        copia = shutil.copytree if (RAIZ / de).is_dir() else shutil.copy
        copia(RAIZ / de, tmp_path / de)
    dicho = subprocess.run([tmp_path / "lab", "paquetes"], text=True, capture_output=True)
    assert dicho.returncode == 0 and "cmake" in dicho.stdout, dicho.stderr


# --- dónde se trabaja, configurar y compilar -------------------------------------------------------------------------


def test_solo_se_configura_si_hace_falta(taller):
    taller.configura("release", taller.build)
    assert taller.llamadas[-1][:3] == ["cmake", "--preset", "release"]
    configurado(taller)
    taller.configura("release", taller.build)
    assert taller.llamadas[-1][-1] == "build.ninja"
    taller.configura("release", taller.build, "-DX=1")
    assert taller.llamadas[-1][-1] == "-DX=1" and (taller.build / "resto").exists()
    for como in ({"de": "/otra"}, {"de": f"{taller.raiz}-2025"}, {"generador": "Unix Makefiles"}):
        configurado(taller, **como)
        taller.configura("release", taller.build)
        assert "--preset" in taller.llamadas[-1] and not (taller.build / "resto").exists(), como
    taller.estados = {"--preset": 1}
    with pytest.raises(Fallo, match="CMake no ha podido configurar"):
        taller.configura("release", taller.build)


def test_un_reloj_atrasado_no_lo_para_todo(taller, capsys):
    siembra(taller.raiz, {"CMakeLists.txt": "", "ch01/catalogo.toml": ""})
    os.utime(taller.raiz / "ch01/catalogo.toml", (time.time() + 9e4,) * 2)
    taller.configura("release", taller.build)
    assert "ch01/catalogo.toml tiene fecha futura" in capsys.readouterr().err
    assert (taller.raiz / "ch01/catalogo.toml").stat().st_mtime <= time.time() + 1


def test_lo_que_se_ensena_al_compilar(capsys):
    for linea in "[1/2] Building", "-- nada", "ninja: no work", "FAILED: a.o", "/usr/bin/c++ -Ia -o a.o -c a.cpp":
        construye.Taller.ensena(linea + "\n")
    assert capsys.readouterr().err == ""
    for linea in "/a.cpp:1: a", "ninja: error: falta", "ninja: build stopped: Error: No space left on device.":
        construye.Taller.ensena(linea + "\n")
        assert capsys.readouterr().err == linea + "\n"
    for pasos in 600, 21:
        construye.Taller.ensena(f"[1/{pasos}] Building CXX object a.o\n")
        minutos = max(1, round(pasos / 100 / len(os.sched_getaffinity(0))))
        assert f"Compilo: {pasos} pasos, unos {minutos} min " in capsys.readouterr().err


def test_carpetas(tmp_path):  # y donde no se puede escribir, en copia_test.py
    for signo in ';:"\\#\n':
        with pytest.raises(Fallo, match="CMake no sabe trabajar en una carpeta con"):
            construye.Taller(tmp_path / f"a{signo}b")


# --- de verdad: con un cmake que no acaba ----------------------------------------------------------------------------


@pytest.fixture
def pausado(tmp_path):
    """./lab lista en un laboratorio en que configurar no acaba."""
    raiz, bin_ = tmp_path / "lab", tmp_path / "bin"
    bin_.mkdir()
    shutil.copytree(RAIZ / "herramientas", raiz / "herramientas", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(RAIZ / "lab", raiz)
    ejecutable(bin_ / "python3", "exit 9")  # el de un entorno virtual, sin lo que pone Debian
    ejecutable(bin_ / "cmake", f"sleep 100 & echo $! >{tmp_path}/nieto; wait")
    entorno = {c: v for c, v in os.environ.items() if not c.startswith("LAB_")}
    entorno |= {"PATH": f"{bin_}:{os.environ['PATH']}", "LAB_SIN_INSTALAR": "1", "TMPDIR": str(tmp_path)}
    como = {"env": entorno, "stderr": subprocess.PIPE, "start_new_session": True, "text": True}
    empieza = lambda: subprocess.Popen([raiz / "lab", "lista"], **como)
    yield SimpleNamespace(raiz=raiz, nieto=tmp_path / "nieto", empieza=empieza)


def vivo(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def test_una_senal_lo_acaba_todo(pausado):
    proceso = pausado.empieza()
    assert espera_a(lambda: pausado.nieto.exists() and pausado.nieto.read_text())
    nieto = int(pausado.nieto.read_text())
    otro = pausado.empieza()
    assert "espero a que acabe" in otro.stderr.readline()  # de uno en uno
    otro.terminate()
    assert otro.wait(10) == 143
    proceso.send_signal(signal.SIGINT)
    assert proceso.wait(20) == 128 + signal.SIGINT and "Traceback" not in proceso.stderr.read()
    assert espera_a(lambda: not vivo(nieto))
    assert subprocess.run(["flock", "-w", "5", pausado.raiz / "build/.cerrojo", "true"]).returncode == 0
