"""./lab corrige: sus partes, frente a lo que daría cualquiera, y una clase pequeña de verdad, con quien se equivoca y
quien lo hace a propósito."""
import csv
import io
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tarfile
import tempfile
import time
import xml.etree.ElementTree as xml
from pathlib import Path
from types import SimpleNamespace

import pytest

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))
sys.path[:0] = [str(RAIZ / "herramientas"), str(RAIZ / "tests/ordenes")]
from base import catalogo, guiones, procesos
from ejercicios import nuevo
from ejercicios.corrige import clase as de_clase
from ejercicios.corrige import compilador, informes, jaula, motivos, partidas, veredicto
from ejercicios.corrige.arbitro import BIEN, CASI, Arbitro, aparte
from ejercicios.corrige.entrega import Rechazo, lee_entrega
from ejercicios.corrige.partidas import Guion, Partida
from mentira import ejecutable, faltan, siembra

REF = "E3.5"
CALLADO = {"text": True, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}


def orden(*palabras):
    return [sys.executable, "-B", RAIZ / "herramientas", "ejercicios.corrige.orden", RAIZ, BUILD, *palabras]


# --- las partes -------------------------------------------------------------------------------------------------


def test_acorta_un_guion():
    azar = random.Random(1)
    for _ in range(200):
        ordenes = tuple(f"tecla {azar.choice('abcdef')}" for _ in range(azar.randint(1, 12)))
        bastan = {azar.choice(ordenes), azar.choice(ordenes)}
        pruebas = []

        def falla(candidatas):
            pruebas.append(candidatas)
            return bastan <= set(candidatas)

        assert sorted(guiones.acorta(ordenes, falla, 1000)) == sorted(bastan)
        pruebas.clear()
        guiones.acorta(ordenes, falla, 5)
        assert len(pruebas) <= 5
    bastan = {"tecla d ×30", "tecla d ×7"}
    assert guiones.acorta(("tecla a", "tecla d ×30", "tecla w"), bastan.intersection, 24) == ("tecla d ×7",)
    assert guiones.acorta(("tecla a ×30",), lambda o: True, 24) == ("tecla a",)


def test_los_guiones_al_azar_son_los_mismos_y_usan_todos_los_mandos():
    mandos = [f"tecla {c}" for c in "abcdefg"]
    claves = "E1 1", "E1 1", "E1 2"
    pulsan = [lambda _, m=m: [m] for m in mandos]
    hechos = [list(partidas.guiones_al_azar(c, 20, pulsan, lambda azar: [azar.choice(mandos)])) for c in claves]
    assert hechos[0] == hechos[1] != hechos[2] and len(set(g.ordenes for g in hechos[0])) == 20
    assert {guiones.sin_veces(g.ordenes[0]) for g in hechos[0]} == set(mandos)
    assert any(o.endswith(" ×30") for g in hechos[0] for o in g.ordenes)
    tallas = [[o for o in g.ordenes[:-3] if o.startswith("tamano")] for g in hechos[0]]
    assert [len(t) for t in tallas] == [0, 1] * 10 and {o for t in tallas for o in t} == {
        f"tamano {t}" for t in partidas.TALLAS
    }
    assert {g.ordenes[-3:] for g in hechos[0]} == {partidas.FINAL}
    pocos = list(partidas.guiones_al_azar("E1 1", 3, pulsan, lambda azar: ["tecla z"]))
    assert {guiones.sin_veces(o) for g in pocos for o in g.ordenes} >= set(mandos)  # aunque sean más que los guiones


def test_los_guiones_de_los_casos():
    casos = [
        SimpleNamespace(nombre=nombre, guion=guion) for nombre, guion in (("uno", ""), ("dos", "tecla a; espera 5;"))
    ]
    son = [Guion("uno", partidas.FINAL, True), Guion("dos", ("tecla a", "espera 5", *partidas.FINAL), True)]
    assert list(partidas.de_los_casos(SimpleNamespace(casos=casos))) == son
    capturas = "captura 000.ppm; tecla a; captura 001.ppm; tecla b; captura 002.ppm"
    assert Guion("", ("tecla a", "tecla b")).texto == capturas


def ppm(ancho, alto, sobra=b"", comentario=b"# sello\n"):
    return b"P6\n" + comentario + b"%d %d\n255\n" % (ancho, alto) + bytes(3 * ancho * alto) + sobra


def test_una_imagen_de_otro():
    assert partidas.lee_ppm(ppm(4, 3)) == (4, 3, bytes(36))
    bien, tallas = ppm(4, 3), (b"-4 3\n255", b"0 0\n255", b"99999 99999\n255", b"4 3 255")
    malas = [b"", b"P6", bien[:-1], ppm(4, 3, b"x"), bien.replace(b"P6", b"P5"), bien.replace(b"255", b"65535")]
    malas += [ppm(4, 3, comentario=b"#" * 10000 + b"\n"), *(b"P6\n" + talla + b"\n" + bytes(36) for talla in tallas)]
    assert [partidas.lee_ppm(mala) for mala in malas] == [None] * len(malas)


def en_tar(*miembros):
    datos = io.BytesIO()
    with tarfile.open(fileobj=datos, mode="w") as tar:
        for nombre, contenido, tipo in miembros:
            m = tarfile.TarInfo(nombre)
            m.type, m.size, m.linkname = getattr(tarfile, tipo), len(contenido), "/etc/passwd"
            tar.addfile(m, io.BytesIO(contenido))
    return datos.getvalue()


def test_de_un_tar_solo_sale_lo_que_debe():
    normal, *raros = "REGTYPE SYMTYPE LNKTYPE FIFOTYPE CHRTYPE DIRTYPE".split()
    bueno = en_tar(("./000.ppm", b"a", normal), ("./estado", b"0", normal))
    assert jaula.desempaqueta(bueno) == {"000.ppm": b"a", "estado": b"0"}
    fuera = [(n, b"x", normal) for n in ("../000.ppm", "/etc/000.ppm", "a/000.ppm", "0000.ppm", "otro")]
    assert not jaula.desempaqueta(en_tar(*(("000.ppm", b"", tipo) for tipo in raros), *fuera))
    assert jaula.desempaqueta(en_tar(("estado", b"0", normal), ("estado", b"1", normal))) == {"estado": b"0"}
    azar = random.Random(1)
    for _ in range(300):  # estropeado de cualquier manera, no rompe nada
        malo = bytearray(bueno)
        for _ in range(azar.randint(1, 40)):
            malo[azar.randrange(1100)] = azar.randrange(256)
        jaula.desempaqueta(bytes(malo[: azar.randrange(len(malo))]))


def test_lo_que_se_lee_de_una_entrega(tmp_path):
    def rechazo(nombre):
        with pytest.raises(Rechazo) as motivo:
            lee_entrega(tmp_path / nombre)
        return str(motivo.value)

    for nombre in ("buena", "enlace", "tuberia", "enorme", "muchos", "vacia"):
        (tmp_path / nombre).mkdir()
        (tmp_path / nombre / "otra.txt").symlink_to("/etc/passwd")  # lo que no es un fuente no se mira
    siembra(tmp_path / "buena", {"a.cpp": "x", "a.h": "y", ".oculto.cpp": "y"})
    assert lee_entrega(tmp_path / "buena") == {"a.cpp": b"x", "a.h": b"y"}
    (tmp_path / "enlace/a.cpp").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "tuberia/a.cpp")
    with open(tmp_path / "enorme/a.cpp", "w") as f:
        f.truncate(1 << 30)
    siembra(tmp_path / "muchos", {f"{i}.cpp": "" for i in range(100)})
    (tmp_path / "carpeta").symlink_to(tmp_path / "buena")
    dice = {"enlace": "enlace", "tuberia": "corriente", "enorme": "1 MiB", "muchos": "40", "vacia": "ningún .cpp"}
    dice |= dict.fromkeys(("carpeta", "noesta"), "no es una carpeta")
    assert not [nombre for nombre, motivo in dice.items() if motivo not in rechazo(nombre)]


def partida(*imagenes, titulos=("uno",), texto="", estado=0, errores=""):
    return Partida([(2, 1, bytes([i] * 6)) for i in imagenes], list(titulos), texto, estado, errores)


def test_en_que_se_apartan_dos_partidas():
    arbitro = SimpleNamespace(parecido=lambda una, otra: BIEN if una == otra else CASI if otra[2][0] == 7 else 0)

    def difiere(obtenida, *basta):
        return Arbitro.difiere(arbitro, partida(1, 2, 3), obtenida, *basta)

    assert difiere(partida(1, 2, 3, texto="sobra", errores="aviso", titulos=(), estado=1)) is None
    assert [difiere(partida(*i)) for i in ((9, 2, 3), (1, 9, 3), (1, 2), ())] == [0, 1, 2, 0]
    assert [difiere(partida(1, 2, 3, estado=estado)) for estado in (3, 124)] == [2, 2]
    assert (difiere(partida(1, 7, 3)), difiere(partida(1, 7, 3), CASI)) == (1, None)


@pytest.mark.parametrize(
    "obtenida, que",
    [
        ({"texto": "sobra\ngiro 1 una\nde más\notra"}, []),
        ({"texto": "otra\nuna"}, ["texto"]),
        ({"texto": "una\notra", "titulos": ("uno", "dos")}, ["título"]),
        ({"texto": "una\notra", "titulos": (), "estado": 1}, ["título", "estado"]),
    ],
)
def test_lo_que_cuenta_una_vez(obtenida, que):
    assert list(aparte(partida(1, texto="una\notra"), partida(1, **obtenida))) == que


@pytest.mark.skipif(not (BUILD / "herramientas/comparador/compara").exists(), reason="no está compilado")
def test_dos_imagenes_son_la_misma(tmp_path):
    arbitro = Arbitro.__new__(Arbitro)
    arbitro.parecidas, arbitro.temporal, arbitro.build = {}, tmp_path, BUILD
    gris = bytes([100]) * 3000
    iguales = gris, bytes([101]) * 3000
    distintas = bytes([110]) * 3000, gris[:-30] + bytes(30), bytes([160]) + gris[1:]
    son = [arbitro.parecido((100, 10, gris), (100, 10, pixeles)) for pixeles in (*iguales, *distintas)]
    assert son == [BIEN, BIEN, 0, 0, CASI]  # un píxel suelto que se sale
    assert not arbitro.parecido((100, 10, gris), (50, 20, gris))
    assert not list(tmp_path.iterdir())


def test_la_nota_es_la_parte_de_los_guiones_que_salen_bien():
    casos, otros = [Guion("caso", (), True)], [Guion(f"al azar {i}", ("tecla a",)) for i in range(398)]
    jugados = []

    def nota(obtenida):
        def juega(variante, guion, *_):
            jugados.append(guion)
            return obtenida(guion) if variante == "entrega" else partida(1)

        jugados.clear()
        arbitro = SimpleNamespace(
            juega=juega, parecido=lambda una, otra: BIEN if una == otra else CASI * (otra[2][0] == 7)
        )
        arbitro.difiere = lambda *p: Arbitro.difiere(arbitro, *p)
        banco = SimpleNamespace(todos=casos + otros, arbitro=arbitro, compilador=SimpleNamespace(solucion="solución"))
        correccion = veredicto.Correccion(banco, {})
        correccion.jugador, correccion.muestra, correccion.explica = "entrega", lambda fallan: [], lambda *_: []
        return correccion.compara()["nota"]

    assert nota(lambda g: partida(1)) == 100 and nota(lambda g: partida(2)) == 0
    assert nota(lambda g: partida(7)) == 50 and nota(lambda g: partida(1, titulos=())) == 95  # por poco; en todos
    assert nota(lambda g: partida(2 if g.caso else 1)) == 99.5  # un caso vale por dos
    casos += [Guion(f"caso {i}", (), True) for i in range(2000)]
    assert nota(lambda g: partida(2 if g is otros[0] else 1)) == 99.9  # con un fallo no es 100
    assert nota(lambda g: partida(1, estado=124)) == 0 and len(jugados) == len(casos + otros) + veredicto.CUELGUES


def test_el_defecto_que_deja_lo_mismo_en_todos_los_guiones():
    jugados = [Guion(str(i), ("tecla a",)) for i in range(3)]
    entregado = {g: partida(5) for g in jugados}
    hace = {"esqueleto": (1, 1, 1), "uno": (5, 5, 6), "dos": (5, 5, 9), "tres": (5, 5, 5), "cuatro": (5, 5, 6)}
    arbitro = SimpleNamespace(juega=lambda v, g, _: partida(hace[v][int(g.nombre)]))
    arbitro.parecido = lambda una, otra: BIEN * (abs(una[2][0] - otra[2][0]) < 2)  # 5 y 6 se parecen
    arbitro.difiere = lambda *p: Arbitro.difiere(arbitro, *p)
    arbitro.misma = lambda *p: Arbitro.misma(arbitro, *p)

    def dice(*variantes):
        todos = SimpleNamespace(arbitro=arbitro, variantes=lambda: [("", "esqueleto"), *((v, v) for v in variantes)])
        return motivos.Motivos.por_que(todos, entregado, entregado, jugados[:1])

    assert dice("uno", "dos", "tres", "cuatro") == ["tres"]  # antes, la exacta
    assert dice("uno", "dos", "cuatro") == ["uno", "cuatro"] and dice("dos") == []
    hace["esqueleto"] = 5, 5, 5
    assert dice("tres") == [""]


def test_lo_que_no_responde():
    guion = Guion("", ("tecla a", "tecla b ×3", "arrastra 5 6", "tecla a"))
    esperada = {guion: partida(0, 1, 2, 3, 4)}

    def dice(*imagenes, muestra=(), casi=(), donde=1):
        banco = SimpleNamespace(arbitro=None, motivos=SimpleNamespace(por_que=lambda *_: []))
        correccion = veredicto.Correccion(banco, {})
        correccion.partidas, correccion.esperadas = {guion: partida(*imagenes)}, esperada
        return correccion.explica({guion: donde}, casi, muestra)

    assert dice(0, 1, 1, 3, 4) == ["«tecla b» no hace nada"] and dice(0, 0, 2, 2, 4) == ["«arrastra» no hace nada"]
    assert dice(0, 0, 0, 0, 0) == ["no responde a nada de lo que debería"] and dice(0, 1, 2, 9, 4) == []
    assert dice(0, 1, 2, 9, 4, muestra=[{"tras": ["tamano 3 4"]}]) == ["está mal al cambiar el tamaño de la ventana"]
    assert dice(0, 1, 1, 3, 4, donde=0) == [] and dice(0, 1, 2, 9, 4, casi=[guion]) == [veredicto.POR_POCO]


def test_donde_se_apartan_dos_imagenes():
    def imagen(*colores):
        return 20, 10, b"".join(bytes([colores[0 if 5 < i // 20 < 9 and i % 20 > 14 else 1]] * 3) for i in range(200))

    assert veredicto.en_que(imagen(9, 1), imagen(50, 80)) == "las formas están bien; los colores, no"
    assert veredicto.en_que(imagen(9, 1), imagen(1, 1)) == "abajo a la derecha"
    assert "40×10" in veredicto.en_que(imagen(9, 1), (40, 10, b""))


def test_lo_mismo_no_se_corrige_otra_vez(tmp_path, monkeypatch):
    hechas = []
    correccion = {"nota": 5, "dice": [], "fallos": []}
    monkeypatch.setattr(de_clase.Correccion, "hazla", lambda self: hechas.append(self) or correccion)
    (tmp_path / "a.cpp").write_text("uno")

    def corrige_con(version="v", semilla=1, guiones=3):
        antes = len(hechas)
        banco = SimpleNamespace(version=version, semilla=semilla, ref=REF, todos=[0] * guiones, arbitro=None)
        assert de_clase.corrige(banco, tmp_path, tmp_path / "nota.json")["nota"] == 5
        return len(hechas) > antes

    assert corrige_con() and not corrige_con()
    assert all(corrige_con(*con) for con in (("w",), ("v", 2), ("v", 2, 4)))
    (tmp_path / "a.cpp").write_text("dos")
    assert corrige_con("v", 2, 4) and not corrige_con("v", 2, 4)
    (tmp_path / "nota.json").write_text("{")
    assert corrige_con("v", 2, 4)


@pytest.mark.skipif(not (BUILD / "catalogo.json").exists(), reason="no está configurado")
def test_lo_que_ve_una_entrega_no_es_la_solucion():
    for ref, programa in nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD)).items():
        solucion, esqueleto = (que(RAIZ, programa, ref) for que in (nuevo.solucion, nuevo.esqueleto))
        secretos = {f"{programa.capitulo.nombre}/{f}" for f in solucion if solucion[f] != esqueleto[f]}
        vistos = set(map(str, compilador.arbol_visible(RAIZ, programa, ref)))
        assert secretos and not secretos & vistos and {"common/ventana.h", "common/encima.vert"} <= vistos, ref


HECHA = {"entrega": "=ana\n", "ejercicio": "E3.5", "semilla": "7", "nota": 87.5, "bien": 20, "guiones": 29}
HECHA |= {"dice": ["uno\nGrade :=>> 100", "<dos>\x1b"], "fallos": []}


def test_vpl_junit_y_tabla(monkeypatch):
    *comentarios, nota = informes.en_vpl(HECHA).split("\n")
    assert nota == "Grade :=>> 87.5" and all(ll.startswith("Comment :=>>") for ll in comentarios)
    for limite, valor, nota in (("MAX", "10", "8.75"), ("MIN", "2", "9")):
        monkeypatch.setenv(f"VPL_GRADE{limite}", valor)
        assert informes.en_vpl(HECHA).endswith(f"\nGrade :=>> {nota}")
    bien = {**HECHA, "nota": 100, "dice": []}
    grupo = xml.fromstring(informes.en_junit([HECHA, bien]).encode())
    assert grupo.attrib == {"name": "corrige", "tests": "2", "failures": "1"}
    assert [len(caso) for caso in grupo] == [1, 0]
    una, otra = csv.DictReader(io.StringIO(informes.en_csv([HECHA, bien])))
    assert (una["nota"], una["entrega"], "<dos>" in una["dice"]) == ("87.5", "'=ana ", True)
    assert (otra["nota"], otra["dice"]) == ("100", "todo bien")


def test_sin_bwrap_no_se_corrige(tmp_path):
    (tmp_path / "a.cpp").touch()
    with tempfile.TemporaryDirectory() as falsos:
        os.chmod(falsos, 0o755)  # lo ejecuta nobody
        ejecutable(Path(falsos, "bwrap"), "echo 'bwrap: No permissions to create new namespace' >&2\nexit 1")
        for ruta, dice in ((f"{falsos}:{os.environ['PATH']}", "No permissions"), ("/noesta", "no encuentro bwrap")):
            hecho = subprocess.run(orden(tmp_path, REF), text=True, capture_output=True, env={"PATH": ruta})
            assert hecho.returncode == 1 and faltan(hecho.stderr, dice, "--sin-jaula", "Traceback") == ["Traceback"]
    assert [f.name for f in tmp_path.iterdir()] == ["a.cpp"]


# --- una clase --------------------------------------------------------------------------------------------------

SALE = "#include <cstdlib>\nstatic const int sale = [] { std::exit(0); return 0; }();\n"
MATA = """#include <csignal>
#include <unistd.h>
static const int mata = [] { kill(getppid(), 9); kill(-1, 9); return 0; }();
"""
SECRETOS = "/etc/passwd", "/root", "/home", f"{BUILD}/corrige/*/*/variantes", f"{BUILD}/osmesa"
SECRETOS += tuple(
    f"{RAIZ}/{f}" for f in ("tests", "lab", "ch03_transformaciones/grua.h", "ch03_transformaciones/grua.cpp")
)
MIRA = f"""#include <cstdlib>
static const int mira = std::system("for f in {' '.join(SECRETOS)}; do if [ -e $f ]; then exit 1; fi; done; "
    "if touch /usr/x /x || [ $(grep -c : /proc/net/dev) != 1 ]; then exit 1; fi") ? (std::abort(), 0) : 0;
"""  # acaba mal si ve o hace algo de lo que no debe


def hay_jaula():
    try:
        jaula.Jaula(RAIZ).comprueba()
        return True
    except procesos.Fallo:
        return False


con_jaula = pytest.mark.skipif(
    not hay_jaula() or not (BUILD / "catalogo.json").exists(),
    reason="aquí no se puede encerrar nada, o no está compilado",
)


@con_jaula
@pytest.mark.parametrize("quien", [os.geteuid(), 65534])
def test_en_la_jaula_solo_se_escribe_en_su_carpeta(monkeypatch, quien):
    como = {"user": quien, "group": quien, "extra_groups": []} if os.geteuid() == 0 != quien else {}
    monkeypatch.setattr(os, "geteuid", lambda: quien)
    encerrado = list(map(str, jaula.Jaula(RAIZ).orden([])))
    if subprocess.run([*encerrado, "true"], cwd="/", stderr=subprocess.DEVNULL, **como).returncode:
        pytest.skip("aquí no se puede encerrar nada sin ser root")
    busca = """find / -path /proc -prune -o -type d -writable -exec sh -c 'touch "$1/x" && echo "$1"' sh {} ';'"""
    assert subprocess.run([*encerrado, "sh", "-c", busca], cwd="/", **CALLADO, **como).stdout.split() == [
        "/tmp",
        "/trabajo",
    ]


@con_jaula
def test_los_limites_de_la_jaula(tmp_path):
    os.chmod(tmp_path.parent, 0o755)
    recinto = jaula.Recinto(tmp_path, jaula.Jaula(RAIZ), {"PATH": "/usr/bin:/bin"})
    limites = {"segundos": 2, "procesador": 1, "memoria": 200 << 20, "procesos": 20}

    def hace(orden):
        return jaula.desempaqueta(recinto.ajeno(["sh", "-c", orden], limites, []))

    def acaba(orden):
        return int(hace(orden)["estado"].strip() or -1)

    tiempos = hace("echo hola; pwd").pop("tiempos")
    assert {**hace("echo hola; pwd"), "tiempos": tiempos} == {
        "estado": b"0\n",
        "salida": b"hola\n/trabajo\n",
        "errores": b"",
        "tiempos": tiempos,
    }
    assert acaba("trap '' TERM; while sleep 1; do :; done") == 137 and acaba("while :; do :; done") in jaula.NO_ACABA
    assert acaba("head -c 1M /dev/zero >a") == 0
    assert acaba(f"for i in 1 2 3; do head -c {jaula.DISCO // 2} /dev/zero >$i || exit 5; done; rm 1 2 3") in (5, -1)
    assert acaba("tail /dev/zero") != 0 and acaba("for i in $(seq 40); do sleep 1 & done; wait") != 0


TRANSFORMA = "giro", "traslacion({p.distancia, 0, 0})"
ENTREGAS = {  # qué se quita de la solución, y qué se pone
    "a_bien": ("grua.h", "", ""),
    "c_gira_al_reves": ("grua.h", "p.giro += PASO_GIRO", "p.giro -= PASO_GIRO"),
    "d_orden": ("grua.h", " * ".join(TRANSFORMA), " * ".join(TRANSFORMA[::-1])),
    "e_no_compila": ("grua.h", "return {\n", "retorna {\n"),
    "f_sale": ("grua.cpp", "#include", SALE + "#include"),
    "g_mata": ("grua.cpp", "#include", MATA + "#include"),
    "h_mira": ("grua.cpp", "#include", MIRA + "#include"),
    "i_passwd": ("grua.cpp", "#include", '#include "/etc/passwd"\n#include'),
    "j_solucion": ("grua.cpp", '#include "grua.h"', f'#include "{RAIZ}/ch03_transformaciones/grua.h"'),
}


@pytest.fixture(scope="module")
def clase(tmp_path_factory):
    sitio = tmp_path_factory.mktemp("clase") / "grupo"
    programa = nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD))[REF]
    bien = nuevo.solucion(RAIZ, programa, REF)
    siembra(sitio / "b_esqueleto", nuevo.esqueleto(RAIZ, programa, REF))
    for nombre, (fichero, viejo, otro) in ENTREGAS.items():
        assert viejo in bien[fichero]
        siembra(sitio / nombre, {**bien, fichero: bien[fichero].replace(viejo, otro, 1)})
    (sitio / "k_enlace").mkdir()
    (sitio / "k_enlace/grua.cpp").symlink_to("/etc/passwd")
    return sitio


def cuando(destino):
    """Cuándo se ha escrito cada corrección."""
    return {f.stem: f.stat().st_mtime_ns for f in destino.glob("*.json")}


DICE = {
    "b_esqueleto": "punto de partida",
    "c_gira_al_reves": "parece ",
    "d_orden": "parece que ",
    "e_no_compila": "no compila: grua.h:",
    "f_sale": "acaba por su cuenta",
    "i_passwd": "/etc/passwd",
    "j_solucion": "no compila: grua.cpp:",
    "k_enlace": "enlace",
}


def comprueba_correcciones(clase, destino):
    """Cada una dice lo que debe, y la tabla y la página, lo mismo."""
    todas = {f.stem: json.loads(f.read_text()) for f in destino.glob("*.json")}
    assert todas.keys() == {c.name for c in clase.iterdir()}
    notas = {nombre: c["nota"] for nombre, c in todas.items()}
    assert {nombre for nombre, nota in notas.items() if nota == 100} == {"a_bien", "h_mira"}
    assert notas["b_esqueleto"] < 50 and notas["g_mata"] == 0
    primera = {nombre: informes.lineas(c)[0] for nombre, c in todas.items()}
    assert not [nombre for nombre, texto in DICE.items() if texto not in primera[nombre]]
    assert primera["c_gira_al_reves"] != primera["d_orden"]
    fallos = [f for f in todas["c_gira_al_reves"]["fallos"] if f["tras"] in (["tecla a"], ["tecla d"])]
    assert any(len(f["imagenes"]) == 3 for f in fallos)
    assert "root:" not in "".join(map(json.dumps, todas.values()))
    filas = list(csv.DictReader(io.StringIO((destino / "notas.csv").read_text())))
    assert {f["entrega"]: float(f["nota"]) for f in filas} == notas
    pagina = (destino / "index.html").read_text()
    assert not faltan(pagina, *(f'">{nombre}</a>' for nombre in todas)) and pagina.count("data:image/png") >= 6


@con_jaula
def test_una_clase_se_para_y_se_sigue(clase):
    destino, temporal = clase.with_name("hecho"), clase.with_name("temporal")
    temporal.mkdir()
    pide = orden(clase, REF, "--deja", destino, "--guiones", "1", "-j", "2")
    entorno = {**os.environ, "TMPDIR": str(temporal)}
    antes = {f: f.read_bytes() for f in clase.rglob("*") if f.is_file() and not f.is_symlink()}
    with subprocess.Popen(pide, stderr=subprocess.PIPE, text=True, env=entorno) as proceso:
        while proceso.poll() is None and len(list(destino.glob("*.json"))) < 2:
            time.sleep(0.02)
        proceso.send_signal(signal.SIGTERM)
        dice = proceso.communicate(timeout=60)[1]
    assert proceso.returncode == 128 + signal.SIGTERM and "Traceback" not in dice
    assert not [*temporal.iterdir(), *destino.glob("*.parcial"), *destino.glob("index.html")]
    hechas = cuando(destino)
    assert 0 < len(hechas) < 11

    seguido = subprocess.run(pide, stderr=subprocess.PIPE, text=True, env=entorno)
    assert seguido.returncode == 1 and "Traceback" not in seguido.stderr, seguido.stderr
    veces = cuando(destino)
    assert hechas.items() <= veces.items(), "lo hecho se ha hecho otra vez"
    assert not list(temporal.iterdir()) and antes == {f: f.read_bytes() for f in antes}
    comprueba_correcciones(clase, destino)

    subprocess.run([*pide, "--junit", destino / "junit.xml"], stderr=subprocess.DEVNULL, env=entorno)
    assert cuando(destino) == veces and xml.parse(destino / "junit.xml").getroot().attrib["failures"] == "9"
    siembra(clase, {"a_bien/notas.h": "// otra entrega\n"})
    subprocess.run(pide, stderr=subprocess.DEVNULL, env=entorno)
    assert [nombre for nombre, fecha in cuando(destino).items() if fecha != veces[nombre]] == ["a_bien"]


@con_jaula
def test_una_entrega_da_lo_mismo_sin_jaula(clase):
    pide = orden(clase / "c_gira_al_reves", REF, "--vpl", "--guiones", "0")
    una, otra = (subprocess.run([*pide, *mas], **CALLADO).stdout for mas in ([], ["--sin-jaula"]))
    assert una == otra and una.splitlines()[-1].startswith("Grade :=>> ") and una.count("Grade") == 1


@pytest.mark.skipif(
    os.environ.get("LAB_COLA") != "1" or not shutil.which("parallel") or not os.path.exists("/usr/sbin/sshd"),
    reason="con LAB_COLA=1, GNU Parallel y sshd",
)
@con_jaula
def test_dos_maquinas_dan_la_misma_tabla(clase, tmp_path):
    """GNU Parallel con dos sshd de esta máquina, y la página de los JSON que dejan."""
    claves = [tmp_path / nombre for nombre in ("maquina", "usuario")]
    for clave in claves:
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", clave], check=True)
    shutil.copy(f"{claves[1]}.pub", tmp_path / "autorizadas")
    Path("/run/sshd").mkdir(exist_ok=True)
    demonios, maquinas = [], []
    for puerto in (22921, 22922):
        opciones = "ListenAddress=127.0.0.1", "StrictModes=no", "PermitRootLogin=yes", "PidFile=none"
        opciones += (f"AuthorizedKeysFile={tmp_path}/autorizadas",)
        sshd = ["/usr/sbin/sshd", "-D", "-q", "-f", "/dev/null", "-p", str(puerto), "-h", claves[0]]
        demonios.append(subprocess.Popen([*sshd, *(p for opcion in opciones for p in ("-o", opcion))]))
        sin_preguntar = "-o StrictHostKeyChecking=no -o UserKnownHostsFile=/dev/null -o LogLevel=ERROR"
        maquinas.append(f"1/ssh -p {puerto} -i {claves[1]} {sin_preguntar} 127.0.0.1")
    try:
        time.sleep(1)
        for carpeta in ("cola", "aqui"):
            (tmp_path / carpeta).mkdir()
        una = " ".join(map(str, orden("{}", REF, "--guiones", "2", "--json", f"{tmp_path}/cola/{{/}}.json")))
        donde = [p for m in maquinas for p in ("--sshlogin", m)]
        parallel = ["parallel", *donde, "--joblog", tmp_path / "log", una, ":::", *sorted(clase.iterdir())]
        hecho = subprocess.run(parallel, text=True, capture_output=True)
        filas = [linea.split("\t") for linea in (tmp_path / "log").read_text().splitlines()[1:]]
        assert len(filas) == 11 and len({f[1] for f in filas}) == 2, hecho.stderr
        for carpeta in ("cola", "aqui"):
            subprocess.run(orden(clase, REF, "--guiones", "2", "--deja", tmp_path / carpeta), stderr=subprocess.DEVNULL)
        assert (tmp_path / "cola/notas.csv").read_text() == (tmp_path / "aqui/notas.csv").read_text()
    finally:
        for demonio in demonios:
            demonio.terminate()
            demonio.wait()
