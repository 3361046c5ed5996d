"""./lab corrige: sus partes, frente a lo que daría cualquiera, y una clase pequeña de verdad, con quien se equivoca y
quien lo hace a propósito."""
import base64
import dataclasses
import itertools
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

import pytest

from aula_test import COLUMNAS, celdas, una_hoja
from banco import BUILD, MOODLE, RAIZ, REF, UNO, con_catalogo, con_comparador, con_jaula
from banco import banco_falso, carpeta_de, en_tar, orden
from base import catalogo, guiones, marcas, procesos
from base.defectos import Mutante
from base.fuentes import SHADERS
from ejercicios import nuevo, reglas
from ejercicios.corrige import clase as de_clase, compilador, entrega, informes, injerto, jaula, lector, motivos
from ejercicios.corrige import orden as orden_, partidas, veredicto
from ejercicios.corrige.arbitro import BIEN, CASI, Arbitro, aparte
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.partidas import Guion, Partida
from ejercicios.reglas import Reglas
from copias import copia
from mentira import ejecutable, espera_a, faltan, siembra, sin_ventana

GRUA = sin_ventana(BUILD) / "ch03_transformaciones/grua"

CALLADO = {"text": True, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}


# --- las partes -------------------------------------------------------------------------------------------------


def test_acorta_un_guion():
    azar = random.Random(1)
    for _ in range(50):
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
    assert [len(t) for t in tallas] == [0, 1] * 10
    assert {o for t in tallas for o in t} == {f"tamano {t}" for t in partidas.TALLAS}
    assert {g.ordenes[-3:] for g in hechos[0]} == {partidas.FINAL}
    muchos = partidas.guiones_al_azar("E1 1", 9, pulsan[:2], lambda azar: ["tecla z"])
    assert {guiones.sin_veces(g.ordenes[0]) for g in muchos} == set(mandos[:2])
    pocos = list(partidas.guiones_al_azar("E1 1", 3, pulsan, lambda azar: ["tecla z"]))
    assert {guiones.sin_veces(o) for g in pocos for o in g.ordenes} >= set(mandos)  # aunque sean más que los guiones


def ppm(ancho, alto, sobra=b"", comentario=b"# sello\n"):
    return b"P6\n" + comentario + b"%d %d\n255\n" % (ancho, alto) + bytes(3 * ancho * alto) + sobra


def test_una_imagen_de_otro():
    assert partidas.lee_ppm(ppm(4, 3)) == (4, 3, bytes(36))
    bien, tallas = ppm(4, 3), (b"-4 3\n255", b"0 0\n255", b"99999 99999\n255", b"4 3 255")
    malas = [b"", b"P6", bien[:-1], ppm(4, 3, b"x"), bien.replace(b"P6", b"P5"), bien.replace(b"255", b"65535")]
    malas += [ppm(4, 3, comentario=b"#" * 10000 + b"\n"), *(b"P6\n" + talla + b"\n" + bytes(36) for talla in tallas)]
    assert [partidas.lee_ppm(mala) for mala in malas] == [None] * len(malas)


def test_de_un_tar_solo_sale_lo_que_debe():
    normal, *raros = "REGTYPE SYMTYPE LNKTYPE FIFOTYPE CHRTYPE DIRTYPE".split()
    bueno = en_tar("", ("./000.ppm", b"a", normal), ("./estado", b"0", normal))
    assert jaula.desempaqueta(bueno) == {"000.ppm": b"a", "estado": b"0"}
    fuera = [(n, b"x", normal) for n in ("../000.ppm", "/etc/000.ppm", "a/000.ppm", "0000.ppm", "otro")]
    assert not jaula.desempaqueta(en_tar("", *(("000.ppm", b"", tipo) for tipo in raros), *fuera))
    assert jaula.desempaqueta(en_tar("", ("estado", b"0", normal), ("estado", b"1", normal))) == {"estado": b"0"}
    azar = random.Random(1)
    for _ in range(300):  # estropeado de cualquier manera, no rompe nada
        malo = bytearray(bueno)
        for _ in range(azar.randint(1, 40)):
            malo[azar.randrange(1100)] = azar.randrange(256)
        jaula.desempaqueta(bytes(malo[: azar.randrange(len(malo))]))


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


def test_lo_que_cuenta_una_vez():
    for texto, que, otro in (
        ("sobra\ngiro 1 una\nde más\notra", [], {}),
        ("otra\nuna", ["texto"], {}),
        ("una\notra", ["título"], {"titulos": ("uno", "dos")}),
        ("una\notra", ["título", "estado"], {"titulos": (), "estado": 1}),
    ):
        assert list(aparte(partida(1, texto="una\notra"), partida(1, texto=texto, **otro))) == que


@con_comparador
def test_dos_imagenes_son_la_misma(tmp_path):
    """De la tolerancia más estrecha a la más ancha, cada una admite lo que la anterior y algo más."""
    arbitro = Arbitro.__new__(Arbitro)
    arbitro.temporal, arbitro.build = tmp_path, BUILD
    gris, *grises = (bytes([nivel]) * 3000 for nivel in (100, 101, 103, 110))
    otras = gris, *grises[:2], bytes([160] * 3) + gris[3:], grises[2], gris[30:] + bytes(30)
    admiten = {}
    for arbitro.tolerancia in reglas.TOLERANCIAS:
        arbitro.parecidas = {}
        admiten[arbitro.tolerancia] = [arbitro.parecido((100, 10, gris), (100, 10, otra)) for otra in otras]
    assert admiten == {
        "redondeo": [BIEN, BIEN, CASI, CASI, 0, 0],
        "amplia": [BIEN, BIEN, BIEN, CASI, 0, 0],
        "otro": [BIEN, BIEN, BIEN, BIEN, 0, 0],
    }
    assert not arbitro.parecido((100, 10, gris), (50, 20, gris)) and not list(tmp_path.iterdir())


def test_la_nota_es_la_parte_de_los_guiones_que_salen_bien():
    casos, otros = [Guion("caso", (), True)], [Guion(f"al azar {i}", ("tecla a",)) for i in range(398)]
    jugados, hecha, en = [], {}, lambda ficheros, jugador, errores: f"p.cpp:{len(errores)}"

    def nota(obtenida):
        def juega(variante, guion, *_):
            jugados.append(guion)
            return obtenida(guion) if variante == "entrega" else partida(1)

        jugados.clear()
        parecido = lambda una, otra: BIEN if una == otra else CASI * (otra[2][0] == 7)
        arbitro = SimpleNamespace(juega=juega, parecido=parecido)
        arbitro.difiere = lambda *p: Arbitro.difiere(arbitro, *p)
        banco = SimpleNamespace(todos=casos + otros, arbitro=arbitro, reglas=Reglas(), sin_hacer=lambda: None)
        banco.compilador = SimpleNamespace(solucion="solución", avisos=lambda *_: [*"abc"], linea_en_que_cae=en)
        correccion = veredicto.Correccion(banco, entrega.Entrega({}))
        correccion.jugador, correccion.muestra, correccion.explica = "entrega", lambda fallan: [], lambda *_: []
        correccion.avisos, correccion.por_piezas = lambda: [], lambda: ([], "")
        hecha.update(correccion.compara())
        return hecha["nota"]

    assert [nota(lambda g, i=i: partida(i)) for i in (1, 2, 7)] == [100, 0, 50]  # la última, por poco
    assert nota(lambda g: partida(1, titulos=())) == 95  # en todos
    assert nota(lambda g: partida(2 if g.caso else 1)) == 99.5  # un caso vale por dos
    assert nota(lambda g: partida(1, estado=134 if g.caso else 0, errores="x" * 7 * g.caso)) == 95
    cae, _, *avisos = hecha["dice"]
    assert "se cae" in cae and ", en p.cpp:7" in cae and avisos == ["el compilador avisa: a", "el compilador avisa: b"]
    casos += [Guion(f"caso {i}", (), True) for i in range(2000)]
    assert nota(lambda g: partida(2 if g is otros[0] else 1)) == 99.9  # con un fallo no es 100
    assert nota(lambda g: partida(1, estado=124)) == 0 and len(jugados) == len(casos + otros) + veredicto.CUELGUES


# un hueco, y lo que vale, que de tres guiones se ve en uno
HECHOS = dict.fromkeys(("bien;", "bien ( );", "usa(bien);"), 1) | dict.fromkeys(("// nada", "como si nada;"), 0)
HECHOS |= dict.fromkeys(("mal;", "usa(mal);"), 2 / 3)
PIEZAS = {}  # lo que se recuerda de cada una, que es de toda la clase


def por_piezas(carpeta, entregado, huecos=50, pesos="iguales"):
    """La corrección de esos tres huecos, en un mundo en que el guion i solo ve el i. Lo que usa() está fuera."""
    solucion = marcado(*["// de partida: // nada\nbien;"] * 3)
    trozos = [("p.cpp", t) for t in marcas.TROZO.finditer(solucion)]
    jugador = lambda textos, c: partidas.Jugador("", None, [c / "fuentes"], {"es": textos}, True, ["p.cpp"])
    nada = [solucion.replace(t[0], marcas.esqueleto(t[0])) for _, t in trozos]

    def compila(ficheros, donde, intentos=()):
        if "usa(" in str(ficheros) and "void usa" not in str(ficheros) or "no compila" in str(ficheros):
            raise lector.Rechazo("no compila")
        return jugador(ficheros, donde)

    def juega(suyo, guion, *_):
        texto = injerto.texto_de(suyo.entorno["es"]["p.cpp"])
        hecho = next((t["hecho"] for t in marcas.TROZO.finditer(texto) if t["pide"].endswith(guion.nombre)), "")
        hecho = hecho.replace("// de partida: // nada\n", "").replace("    // de partida: // nada\n", "")
        bien = "bien" in hecho and not ("usa" in hecho and "void usa(al revés)" in texto)
        return partida(1 if bien else 2 if "nada" in hecho else 3)

    arbitro = SimpleNamespace(juega=juega, parecido=lambda una, otra: BIEN * (una == otra))
    arbitro.difiere = lambda *p: Arbitro.difiere(arbitro, *p)
    comun = {"ref": REF, "sin_solucion": "", "sin_hacer": lambda: None, "piezas": PIEZAS, "temporal": carpeta}
    banco = SimpleNamespace(**comun, arbitro=arbitro, reglas=Reglas(huecos=huecos, pesos=pesos))
    banco.todos = [Guion(str(i), ()) for i in range(3)]
    banco.motivos = SimpleNamespace(trozos=lambda: trozos, textos=lambda: {"p.cpp": solucion}, limpio=lambda t: t)
    banco.motivos.por_que = lambda jugadas, *_: sorted({f"parece {p.imagenes[0][2][0]}" for p in jugadas.values()})[1:]
    banco.motivos.sin_hacer = lambda i: jugador({"p.cpp": nada[i]}, carpeta)
    banco.compilador = SimpleNamespace(compila=compila, solucion=jugador({"p.cpp": solucion}, carpeta))
    suya = entrega.Entrega({"p.cpp": entregado.encode()}, intentos=[["p.cpp"]])
    suya.alcance = entrega.Alcance(suya.ficheros)
    hecha = veredicto.Correccion(banco, suya)
    hecha.muestra, hecha.explica, hecha.avisos = lambda fallan: [], lambda *_: [], lambda: []
    return hecha.hazla()


def test_cada_pieza_vale_lo_que_saca_sola(tmp_path):
    """De tres huecos, hechos de cada manera: bien, de otra, mal, sin hacer, con algo de fuera; y en otro orden."""
    for como in itertools.product(HECHOS, repeat=3):
        hecha = por_piezas(tmp_path, marcado(*como, fuera="void usa();"))
        valen = [HECHOS[c] for c in como]
        entero = sum("bien" in c for c in como) / 3
        bien = min(valen.count(1), 2) / 3  # si lo están todas, lo que falla está fuera de ellas
        debe = 100 if entero == 1 else min(99.9, round(max(50 * entero + 50 * sum(valen) / 3, 100 * bien), 1))
        assert hecha["nota"] == debe, como
        assert [p["nota"] for p in hecha["piezas"]] == ([round(100 * v, 1) for v in valen] if entero < 1 else [])
        faltan = [f"parece que falta: haz eso {i}" for i, c in enumerate(como) if c == "// nada"]
        otros = [f"parece {2 if 'nada' in c else 3}" for c in como if HECHOS[c] < 1 and c != "// nada"]
        assert sorted(hecha["dice"]) == sorted(faltan + otros) and hecha["entero"] == ""
    mal = marcado("mal;", "bien;", "// nada")
    otro_orden = "int main() {\n" + "".join(t[0] for t in [*marcas.TROZO.finditer(mal)][::-1]).replace("    //", "\t//")
    for escrito in (mal, otro_orden, mal.replace("\n", "\r\n")):
        assert [p["nota"] for p in por_piezas(tmp_path, escrito)["piezas"]] == [66.7, 100, 0]
    de_otra = por_piezas(tmp_path, marcado("usa(bien);", "mal;", "bien;", fuera="void usa(al revés);"))
    assert [p["nota"] for p in de_otra["piezas"]] == [66.7, 66.7, 100]
    assert por_piezas(tmp_path, mal, pesos="0 1 0")["nota"] == round(50 / 3 + 50, 1)
    assert por_piezas(tmp_path, mal, huecos=0)["nota"] == 33.3
    assert por_piezas(tmp_path, mal, huecos=100)["nota"] == round(500 / 9, 1)
    sin_marca = mal.replace(f"// fin de {REF}", "", 1)
    mal_escrita = mal.replace(f"// fin de {REF}", f"// fin del {REF}", 1)
    for escrito, porque in (
        (mal_escrita, f"«// fin de {REF}»; en p.cpp:5, «// fin del {REF}» no es de nadie"),
        (sin_marca, f"no está entera la marca «// {REF}: haz eso 0»"),
        ("no compila", "no compila"),
    ):
        hecha = por_piezas(tmp_path, escrito)
        assert not hecha.get("piezas") and porque in hecha["entero"]
        assert porque in informes.lineas({**hecha, "avisos": []})[-1]


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
        todos.defectos, todos.compiladas, todos.parejas = [], lambda: None, lambda *_: []
        return motivos.Motivos.por_que(todos, entregado, entregado, jugados[:1])

    assert dice("uno", "dos", "tres", "cuatro") == ["tres"]  # antes, la exacta
    assert dice("uno", "dos", "cuatro") == ["uno", "cuatro"] and dice("dos") == []
    hace["esqueleto"] = 5, 5, 5
    assert dice("dos") == [""] and dice("tres") == ["", "tres"]


def test_de_dos_en_dos_los_que_pueden_ser():
    """Del mismo hueco, si tocan casi lo mismo que la entrega; de dos, los gemelos, con que toquen parte."""
    fuente = marcado("a = 1;\nb = 2;", "c = 3;\nd = 4;")
    lista = ("a", "x"), ("b", "y"), ("c", "x"), ("d", "z")
    suyos = [Mutante("l", i, i, "p.cpp", f"{v} = «{i}»", "0", imita, "", v) for i, (v, imita) in enumerate(lista, 1)]
    suyos.append(Mutante("l", 9, 9, "p.cpp", "«a = 1»", "0", "x", "", "e"))  # estropea lo del primero
    todos = SimpleNamespace(defectos=suyos, programa=SimpleNamespace(raices=[1]), textos=lambda: {"p.cpp": fuente})
    todos.trozos = lambda: [("p.cpp", t) for t in marcas.TROZO.finditer(fuente)]
    todos.pares = lambda suyos: motivos.Motivos.pares(todos, suyos)
    todos.de_dos = lambda _, *par: "".join(m.dice for m in par)

    def prueba(tocado, *tocan):
        return [quien for _, quien in motivos.Motivos.parejas(todos, None, tocado, dict(zip(suyos, tocan)))]

    assert prueba(0b1111, 0b0011, 0b1100, 0b0111, 0b1000) == ["ac", "ab", "cd"]
    assert "ae" not in prueba(0b1111, 0b0011, 0, 0, 0, 0b1100)
    assert prueba(0b1111, 0b0001, 0b0010, 0b0001, 0b0010) == ["ac"]


def test_una_entrega_lenta_se_deja(monkeypatch):
    reloj = itertools.count(0, veredicto.TOPE / 4)
    monkeypatch.setattr(veredicto.time, "monotonic", lambda: next(reloj))
    arbitro = SimpleNamespace(juega=lambda *_: partida(1), difiere=lambda *_: None)
    todos = [Guion(str(i), ()) for i in range(20)]
    banco = SimpleNamespace(todos=todos, arbitro=arbitro, reglas=Reglas(), sin_hacer=None)
    banco.compilador = SimpleNamespace(solucion="solución")
    lenta = veredicto.Correccion(banco, None)
    lenta.jugador, lenta.por_piezas = "entrega", lambda: ([], "")
    hecho = lenta.compara()
    assert hecho["nota"] == 25
    assert hecho["dice"] == ["es muy lento: a los 5 minutos se ha dejado, con 5 de los 20 guiones jugados"]


def test_lo_que_no_responde():
    guion = Guion("", ("tecla a", "tecla b ×3", "arrastra 5 6", "tecla a"))
    esperada = {guion: partida(0, 1, 2, 3, 4)}

    def dice(*imagenes, muestra=(), casi=False, donde=1):
        banco = SimpleNamespace(arbitro=None, motivos=SimpleNamespace(por_que=lambda *_: []))
        banco.de_partida = {"p.cpp": ""}, "p.cpp"
        correccion = veredicto.Correccion(banco, entrega.Entrega({"p.cpp": b"int main() {}"}))
        correccion.partidas, correccion.esperadas = {guion: partida(*imagenes)}, esperada
        correccion.es_casi = lambda _: casi
        return correccion.explica({guion: donde}, muestra)

    assert dice(0, 1, 1, 3, 4) == ["«tecla b» no hace nada"]
    assert dice(0, 0, 2, 2, 4) == ["«arrastra» no hace nada"]
    assert dice(0, 0, 0, 0, 0) == ["no responde a nada de lo que debería"] and dice(0, 1, 2, 9, 4) == []
    assert dice(0, 1, 2, 9, 4, muestra=[{"tras": ["tamano 3 4"]}]) == ["está mal al cambiar el tamaño de la ventana"]
    assert dice(0, 1, 1, 3, 4, donde=0) == [] and dice(0, 1, 2, 9, 4, casi=True) == [veredicto.POR_POCO]


def test_un_numero_con_pocas_cifras():
    """Solo si lo es de verdad, lo ha escrito quien lo entrega y no está en un comentario."""
    dado = {"p.h": "float a = 0.33;"}
    for escrito, dice in {"3.14f": "3.14", "0.017": "0.017", "1.0/.33": "", "0.67": "0.67", "1.57": "1.57"}.items():
        dicho = motivos.pocas_cifras({"p.h": f"/*\n3.14*/\n{escrito}".encode()}, dado)
        assert dicho.endswith(f"p.h:3, {dice}?" if dice else "")
    for escrito in ("3.1415926f", "0.25", "3.5", "0.34", "v.xy", "normalize(a)"):
        assert not motivos.pocas_cifras({"p.h": escrito.encode()}, dado)


def test_donde_se_apartan_dos_imagenes():
    def imagen(dentro, fuera, *sitio, lado=5):
        hay = (all(d <= k < d + lado for k, d in zip(divmod(i, 30), sitio)) for i in range(600))
        return 30, 20, b"".join(bytes([dentro if algo else fuera] * 3) for algo in hay)

    assert veredicto.en_que(imagen(9, 1, 6, 7), imagen(50, 80, 6, 7)) == "las formas están bien; los colores, no"
    assert veredicto.en_que(imagen(9, 1, 0, 0, lado=18), imagen(1, 1, 0, 0)) == "casi toda la imagen"
    filas, columnas = {0: "arriba", 8: "", 15: "abajo"}, {0: "a la izquierda", 13: "", 25: "a la derecha"}
    for y, x in itertools.product(filas, columnas):
        debe = f"{filas[y]} {columnas[x]}".strip() or "en el centro"
        assert veredicto.en_que(imagen(9, 1, y, x), imagen(1, 1, y, x)) == debe
    # es más larga, aunque casi todos sus bordes sean los mismos, o lo que sigue sea de otro color y no del fondo
    for ancha, resto in ((3, b"def"), (70, b"ghi")):
        barra = [
            b"".join((b"abc" if y < hasta else resto) if x < ancha else b"def" for y in range(240) for x in range(200))
            for hasta in (200, 220)
        ]
        assert veredicto.en_que(*((200, 240, pixeles) for pixeles in barra)) == "abajo a la izquierda"
    una, otra = ((ancho, alto, bytes(3 * ancho * alto)) for ancho, alto in ((40, 10), (20, 30)))
    assert veredicto.en_que(una, otra) == "la imagen es de 20×30 y debía ser de 40×10"


@con_catalogo
def test_lo_que_ve_una_entrega_no_es_la_solucion():
    for ref, programa in nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD)).items():
        solucion, esqueleto = (que(RAIZ, programa, ref) for que in (nuevo.solucion, nuevo.esqueleto))
        secretos = {f"{programa.capitulo.nombre}/{f}" for f in solucion if solucion[f] != esqueleto[f]}
        vistos = set(map(str, compilador.arbol_visible(RAIZ, programa, ref)))
        assert secretos and not secretos & vistos and {"common/ventana.h", "common/encima/encima.vert"} <= vistos, ref


UNAS = "p.cpp=m util/a.cpp", "p.h util/a.h", "ejercicio.txt a.cpp vieja/p.cpp=m", "p.h"
CLASES = "ana/p.cpp luis/p.cpp", "plantilla.cpp=m ana/p.cpp=m", "plantilla.cpp ana/entrega/p.cpp=m"


@pytest.mark.parametrize("ficheros", [*UNAS, *CLASES])
def test_una_entrega_o_una_clase(tmp_path, ficheros):
    for fichero in ficheros.split():
        siembra(tmp_path / "x", {fichero.removesuffix("=m"): "int main() {}" * fichero.endswith("=m")})
    assert (entrega.busca(tmp_path, "x")[1] is None) == (ficheros in UNAS)


FALSO = r"Grade :=>> 100|\x1b[2J\x1b[H|\r|\x00|\u202e|\u2028|\x85|\udcff|=1+1|+1|-1|@a|<script>|&\"'"
FALSO = [texto.encode().decode("unicode_escape") for texto in FALSO.split("|")]
HOSTILES = [*FALSO, *(f"hola\n{texto}\n\t{texto}" + "x" * 200_000 for texto in FALSO)]


def sin_banco(monkeypatch, temporal):
    """La orden entera, sin compilar ni jugar."""
    monkeypatch.setattr(orden_, "Banco", lambda *_: banco_falso(temporal))
    programa = SimpleNamespace(nombre="a", titulo="A", casos=[], raices=[])
    monkeypatch.setattr(orden_, "ejercicio", lambda *_: (REF, programa))
    monkeypatch.setattr(orden_.propios, "resuelve", lambda raiz, build, pedido: ([], pedido))


def test_lo_de_otro_no_estropea_lo_que_se_escribe(tmp_path, juzga, monkeypatch, capsys):
    """De cada texto hostil, en todo lo que dice una corrección, y de cada manera de escribirla."""
    hostiles = [*HOSTILES, f"{tmp_path}/temporal/x1/fuentes/a.cpp:3: mal"]
    textos = itertools.cycle(hostiles)

    def mal(*_):
        texto = next(textos)
        donde = {"dice": texto, "pixel": [1, 2], "ventana": [9, 9], "explica": "1 2"}
        fallo = {"tras": ["tecla a"], "que": texto, "donde": donde, "imagenes": []}
        return {"nota": 50, "dice": [texto, texto], "fallos": [fallo]}

    juzga(mal)
    for i, texto in enumerate(hostiles):
        nombre = (texto[:60] + str(i)).replace("/", "").replace("\0", "")
        carpeta_de(tmp_path / "clase" / nombre, UNO)
    sin_banco(monkeypatch, tmp_path / "temporal")

    def pide(*palabras):
        monkeypatch.setattr(sys, "argv", ["x", str(RAIZ), str(tmp_path / "build"), *map(str, palabras)])
        assert orden_.main() == 1
        return "".join(capsys.readouterr())

    escrito = pide(tmp_path / "clase", REF, "--sin-jaula", "--junit", tmp_path / "j.xml", "--deja", tmp_path / "d")
    monkeypatch.setattr(orden_, "Jaula", lambda _: SimpleNamespace(comprueba=lambda: None))
    for carpeta in sorted((tmp_path / "clase").iterdir()):
        vpl = pide(carpeta, REF, "--vpl")
        assert [ll.partition(":=>>")[0] for ll in vpl.splitlines()] == ["Comment "] * 6 + ["Grade "]
        escrito += vpl + pide(carpeta, REF, "--sin-jaula", "--json", tmp_path / "una.json")
    d = tmp_path / "d"
    ficheros = [tmp_path / "j.xml", d / "notas.csv", d / "index.html", *d.glob("*.json"), *d.glob("comentarios/*.html")]
    escrito += "".join(f.read_text("utf-8-sig").replace("\r\n", "\n") for f in ficheros)
    assert {c for c in escrito if not c.isprintable()} <= {"\n"}
    assert max(map(len, escrito.replace(Reglas().en_palabras, "").split("\n"))) < 4 * lector.LETRAS + 450
    assert len(xml.parse(tmp_path / "j.xml").getroot()) == len(list(d.glob("*.json"))) == len(hostiles)
    assert (d / "notas.csv").read_bytes().startswith(b"\xef\xbb\xbf"), "una hoja de cálculo no sabría qué letras son"
    filas = celdas((d / "notas.csv").read_bytes(), "utf-8-sig", separador=";")
    assert len(filas) == len(hostiles) + 1 and not [c for f in filas for c in f if c[:1] in tuple("=+-@")]
    assert (d / "index.html").read_text().count("<script") == 1 and str(tmp_path / "temporal") not in escrito


@pytest.mark.parametrize("pide", re.findall(r"^\| `(-[^`]+)`", (RAIZ / "docs/corrige.md").read_text(), re.M))
@pytest.mark.parametrize("que,n", [("clase", "0"), ("clase", "3"), (f"clase/ana_1{MOODLE}", "3")])
def test_cada_opcion_hace_algo_o_se_dice_que_no(tmp_path, juzga, monkeypatch, capsys, pide, que, n):
    """De lo que se escribe, de lo que se dice y de lo que recibe quien corrige, algo es otra cosa que sin ella."""
    juzga(lambda *_: {"nota": 50, "dice": ["mal"]})
    sin_banco(monkeypatch, tmp_path)
    llega, clase_, jaula_ = [], de_clase.clase, SimpleNamespace(comprueba=lambda: None)
    monkeypatch.setattr(orden_, "Banco", lambda *como: llega.append(repr(como[5:])) or banco_falso(tmp_path))
    monkeypatch.setattr(orden_, "Jaula", lambda _: jaula_)
    monkeypatch.setattr(de_clase, "clase", lambda *como: llega.append(como[3]) or clase_(*como))
    fila = "Participante 1", "ana", "", "", "3,00", "10,00", "Sí", "-", "-", ""
    hay = {"HOJA.csv": "\n".join(f'"{f}"' for f in map('","'.join, (COLUMNAS, fila))), "FICHERO": "caso = 5\n"}
    hay[f"clase/ana_1{MOODLE}/p.cpp"] = UNO["p.cpp"]

    def hace(*palabras):
        shutil.rmtree(tmp_path / "aqui", ignore_errors=True)
        siembra(tmp_path / "aqui", hay)
        monkeypatch.chdir(tmp_path / "aqui")
        monkeypatch.setattr(sys, "argv", ["x", str(RAIZ), str(tmp_path / "build"), que, REF, *palabras])
        llega.clear()
        try:
            orden_.main()
        except procesos.Fallo as fallo:
            return str(fallo)
        return {f: f.read_bytes() for f in Path().rglob("*") if f.is_file()}, capsys.readouterr(), [*llega]

    opcion, *valor = pide.replace("N", n).split()
    con = ["--moodle", "HOJA.csv"] if (opcion, que) == ("--cambia-notas", "clase") else []
    una, otra = hace(*con), hace(*con, opcion, *valor)
    assert una == hace(*con) and (una != otra or opcion == "-j" and que != "clase")
    assert not isinstance(otra, str) or opcion in otra


def test_como_acaba_una_partida():
    """Y tras qué orden: hay una imagen antes de la primera y otra tras cada una."""
    guion, tras = Guion("", ("tecla a", "tecla b")), (" sin dibujar nada", " al hacer «tecla a»", " al hacer «tecla b»")
    acaban = {
        "se queda esperando": {"estado": 124, "segundos": 0.1},
        "un bucle que no acaba": {"estado": 152, "segundos": 10.0},
        "escribe demasiado": {"estado": -1, "escrito": 1 << 25},
        "que se llama a sí misma sin fin": {"estado": 139},
        "pide más memoria": {"estado": 134, "errores": "  what():  std::bad_alloc\n"},
        "no ha dejado nada": {"estado": -1},
    }
    for dice, como in acaban.items():
        for n in range(4):
            dicho = motivos.como_acaba(dataclasses.replace(partida(*range(n)), limite=10, **como), guion)
            donde = [f"{t}:" in dicho.replace(",", ":") for t in tras]
            assert dice in dicho and donde == [n == i and "no ha dejado nada" != dice for i in range(3)]


def marcado(*hechos, pide="haz eso {}", fuera=""):
    """Un programa con esos huecos, y algo fuera de ellos."""
    huecos = (f"// {REF}: {pide.format(i)}\n{h}\n// fin de {REF}\n" for i, h in enumerate(hechos))
    return f"{fuera}\nint main() {{\n{''.join(huecos)}}}\n"


def test_lo_de_otra_version_se_pone_en_el_punto_de_partida_de_hoy():
    """Lo que pide lo mismo; si no, lo que está en su sitio; y si tampoco, lo más parecido."""
    hoy = {"p.cpp": marcado("", "", fuera="// hoy")}
    for suyos, quedan in (
        (marcado("uno", "dos", fuera="// ayer"), ("uno", "dos")),
        (marcado("uno", "dos", pide="otra cosa {}"), ("uno", "dos")),
        (marcado("uno").replace("\n", "\r\n"), ("uno", "uno")),
        (marcado("uno", pide="nada que ver").replace("int main", "int x"), ("", "")),
    ):
        otra = injerto.injertada(entrega.Entrega({"mi p.cpp": suyos.encode(), "q.h": b""}), hoy, REF)
        assert otra.ficheros["p.cpp"].decode() == marcado(*quedan, fuera="// hoy") and "q.h" in otra.ficheros
    assert injerto.injertada(entrega.Entrega({"p.cpp": b"int main() {}"}), hoy, REF) is None


def test_cuando_se_injerta(tmp_path, juzga):
    """Si se sabe que se empezó con otra versión y así sale mejor; y si no se sabe, si no dibuja nada."""
    hoy = {"p.cpp": marcado("", fuera="// hoy")}, "p.cpp"
    juzga(lambda banco, suya: {"nota": 80 if b"// hoy" in suya.ficheros["p.cpp"] else 30, "dice": []})
    for version, nota in (("", 80), ("otra", 80), (nuevo.version(hoy[0]), 30)):
        dice = f"{REF} x\n{f'partida {version}' * bool(version)}"
        siembra(tmp_path / "e", {"p.cpp": marcado("uno"), "ejercicio.txt": dice})
        hecha = de_clase.corrige(banco_falso(tmp_path, de_partida=hoy), tmp_path / "e")
        assert hecha["nota"] == nota and (injerto.SE_CORRIGE in hecha["dice"]) == (nota == 80)
    (tmp_path / "e/ejercicio.txt").unlink()
    assert de_clase.corrige(banco_falso(tmp_path, de_partida=hoy), tmp_path / "e")["nota"] == 30
    juzga(lambda banco, suya: {"nota": 20 if b"// hoy" in suya.ficheros["p.cpp"] else 30, "dice": []})
    siembra(tmp_path / "e", {"ejercicio.txt": f"{REF} x\n"})
    hecha = de_clase.corrige(banco_falso(tmp_path, de_partida=hoy), tmp_path / "e")
    assert hecha["nota"] == 30 and hecha["dice"] == [injerto.SE_EMPEZO]


def test_en_que_ventana_es_un_pixel():
    debe = {"pixel": [42, 82], "ventana": [960, 720], "explica": '42 82 -guion "tecla g"'}
    assert veredicto.en_su_ventana(("tecla g",), [10, 20], (240, 180)) == debe
    otra = veredicto.en_su_ventana(("tamano 120 160",), [10, 20], (120, 160))
    assert otra["ventana"] == [120, 160] and otra["explica"] == '10 20 -geometry 240x180 -guion "tamano 120 160"'


# --- lo guardado: lo mismo que sin guardar, y otra vez si cambia algo, lo que sea --------------------------------


def test_lo_que_ya_se_ha_corregido(tmp_path, juzga):
    """La huella de una corrección: con cada cosa que entra en ella cambiada sola, se hace otra vez; y con nada, no."""
    hechas = []
    juzga(lambda banco, entregado: hechas.append(1) or {"nota": 5, "dice": []})
    sitio, nota = tmp_path / "e", tmp_path / "nota.json"
    carpeta_de(sitio, UNO)

    def se_hace(**banco):
        antes = len(hechas)
        assert de_clase.corrige(banco_falso(tmp_path, **banco), sitio, nota)["nota"] == 5
        return len(hechas) > antes

    assert se_hace() and not se_hace()
    otro = [Guion("caso", (), True), Guion("al azar", ("tecla b",))]
    cambios = {"clave": "w"}, {"semilla": "2"}, {"todos": otro}, {"reglas": Reglas(casi=3)}
    for cambio in (*cambios, {"de_partida": ({**UNO, "q.h": ""}, "p.cpp")}):
        assert se_hace(**cambio) and not se_hace(**cambio) and se_hace(), cambio
    for cambio in ({"p.cpp": "int main() { }"}, {"p.h": "x"}, {"q.h": ""}, {"ejercicio.txt": "E4.4 x"}):
        siembra(sitio, cambio)
        assert se_hace() and not se_hace(), cambio
    sitio = sitio.rename(tmp_path / "p")  # con otro nombre puede ser otro el fuente que se compila
    assert se_hace()
    for malo in ("{", "[]", "{}"):
        nota.write_text(malo)
        assert se_hace(), malo
    for contenido in (b"\0", bytes(2 << 20)):  # quien entrega otra cosa que tampoco vale lee lo de ahora
        (sitio / "p.cpp").write_bytes(contenido)
        dicho = [de_clase.corrige(banco_falso(tmp_path), sitio, f)["dice"] for f in (nota, None)]
        assert dicho[0] == dicho[1] and dicho[0]


@pytest.mark.skipif(not GRUA.exists(), reason="no está compilado")
def test_la_clave_la_cambia_todo_lo_que_corrige(tmp_path, monkeypatch):
    """De ella son lo jugado y la huella: quien corrige, lo que se ve, con qué se enlaza, la solución, quien dibuja y lo
    de partida, cada uno cambiado solo. Lo jugado se guarda donde dice, por quien y por el guion, y lo viejo se borra.
    """
    programa = nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD))[REF]
    lee, tocado, sello, esqueleto, jugadas = Path.read_bytes, [], [b""], nuevo.esqueleto, []
    deja = lambda *_: jugadas.append(1) or en_tar("", ("000.ppm", b"P6" + sello[0], "REGTYPE"))
    monkeypatch.setattr(Path, "read_bytes", lambda f: lee(f) + (b"x" if str(f) in tocado else b""))
    monkeypatch.setattr(Arbitro, "juega_de_nuevo", deja)

    def otro_banco():
        return Banco(RAIZ, tmp_path / "build", REF, programa, tmp_path, None, "1", Reglas(guiones=0))

    (tmp_path / "build").mkdir()
    for f in BUILD.iterdir():
        if f.name != "corrige":
            (tmp_path / "build" / f.name).symlink_to(f)
    vieja = tmp_path / f"build/corrige/{REF}/vieja"
    vieja.mkdir(parents=True)
    os.utime(vieja, (time.time() - 3 * 86400,) * 2)
    otra = vieja.with_name("de_otro")  # que puede estar usándola
    otra.mkdir()
    banco = otro_banco()
    assert {*vieja.parent.iterdir()} == {otra, banco.arbitro.cache} and otro_banco().clave == banco.clave
    jugadas.clear()
    for quien, tecla, veces in (("una", "a", 1), ("una", "a", 1), ("una", "b", 2), ("otra", "b", 3), ("otra", "b", 3)):
        banco.arbitro.juega(partidas.Jugador(quien, None, []), Guion("", (f"tecla {tecla}",)))
        assert len(jugadas) == veces
    ficheros = [f"{RAIZ}/herramientas/{f}" for f in ("ejercicios/corrige/arbitro.py", "base/guiones.py")]
    ficheros += f"{RAIZ}/common/encima/encima.vert", f"{tmp_path}/build/herramientas/comparador/compara"
    ficheros.append(f"{tmp_path}/build/libcomun.a")
    claves = [banco.clave]
    for tocado[:] in [[f] for f in (*ficheros, str(banco.compilador.solucion.programa))]:
        claves.append(otro_banco().clave)
    tocado.clear()
    sello[0] = b"otro OpenGL"
    claves.append(otro_banco().clave)
    monkeypatch.setattr(nuevo, "esqueleto", lambda *que: {**esqueleto(*que), "otro.h": ""})
    claves.append(otro_banco().clave)
    assert len(set(claves)) == len(claves), claves


def test_una_entrega_tan_lenta_como_la_solucion_acaba(tmp_path):
    """Tarde lo que tarde la solución: el doble cabe en el límite, que siempre lo hay, y el de reloj es mayor."""
    arbitro = Arbitro.__new__(Arbitro)
    arbitro.build, arbitro.cache, arbitro.compilador = tmp_path, tmp_path / "nada", SimpleNamespace(ve=[])
    suya = partidas.Jugador("entrega", tmp_path / "programa", [tmp_path], ajeno=True)

    def limites(segundos):
        def ajeno(orden, puestos, *_, **__):
            puesto.append(puestos)
            return b""

        puesto, arbitro.recinto = [], SimpleNamespace(ajeno=ajeno)
        esperada = dataclasses.replace(partida(1), segundos=segundos)
        assert arbitro.juega(suya, Guion("", ()), esperada).limite == pytest.approx(puesto[0]["procesador"], abs=1)
        return puesto[0]["procesador"], puesto[0]["segundos"]

    for segundos in (0, 0.01, 1, 7.5, 30, 300):
        procesador, reloj = limites(segundos)
        assert max(1, 2 * segundos) <= procesador < reloj <= 60 + 20 * segundos


def test_lo_que_no_se_ha_podido_corregir_se_dice(tmp_path, juzga, monkeypatch, capsys):
    juzga(lambda _, suya: time.sleep(0.3 * (b"tarda" in suya.ficheros["p.h"])) or {"nota": 100, "dice": []})
    for nombre, dentro in zip("abc", ("// tarda", "", "")):  # la primera, y no por eso es la última
        carpeta_de(tmp_path / "c" / nombre, UNO | {"p.h": dentro})
    carpetas, deja = sorted((tmp_path / "c").iterdir()), tmp_path / "c/d"  # lo que se deja no es de nadie
    (deja / "b.json").mkdir(parents=True)  # donde iría la de b
    hechas, fallos = de_clase.clase(banco_falso(tmp_path), carpetas, deja, 2)
    assert [c["entrega"] for c in hechas.values()] == ["a", "c"] and [f[:11] for f in fallos] == ["b: no puedo"]
    sin_banco(monkeypatch, tmp_path)
    pide = ["x", str(RAIZ), str(tmp_path), str(tmp_path / "c"), REF, "--sin-jaula", "--deja", str(deja)]
    monkeypatch.setattr(sys, "argv", pide)
    sueltos = "x.cpp", "y.h", "z.frag"
    for n in range(len(sueltos) + 1):  # y lo que se deja
        siembra(tmp_path / "c", dict.fromkeys(sueltos[:n], ""))
        with pytest.raises(procesos.Fallo, match="no se han podido corregir 1: b: no puedo"):
            orden_.main()
        dicho = capsys.readouterr().err
        assert re.findall("se dejan: (.*)", dicho) == [", ".join(sueltos[:n])] * bool(n) and "[  3/3] " in dicho


MAL = {
    "": "di qué entrega",
    "x --semila 3": "no entiendo «--semila»",
    "x --guiones -1": "no entiendo «--guiones -1»",
    "x --moodle": "falta lo que sigue a --moodle",
    "x --vpl --sin-jaula": "leería la solución",
}


@pytest.mark.parametrize("palabras", MAL)
def test_lo_que_no_se_entiende(palabras):
    with pytest.raises(procesos.Fallo, match=MAL[palabras]) as error:
        orden_.opciones(["--programa", *palabras.split()])  # ./lab pregunta antes qué programa es
    assert "--programa" not in str(error.value)


def test_sin_bwrap_no_se_corrige(tmp_path):
    (tmp_path / "a.cpp").touch()
    with tempfile.TemporaryDirectory() as falsos:
        os.chmod(falsos, 0o755)  # lo ejecuta nobody
        ejecutable(Path(falsos, "bwrap"), "echo 'bwrap: No permissions to create new namespace' >&2\nexit 1")
        for ruta, dice in ((f"{falsos}:{os.environ['PATH']}", "No permissions"), ("/noesta", "no encuentro bwrap")):
            hecho = subprocess.run(orden(tmp_path, REF), text=True, capture_output=True, env={"PATH": ruta})
            assert (hecho.returncode, faltan(hecho.stderr, dice, "--sin-jaula", "Traceback")) == (1, ["Traceback"])
    assert [f.name for f in tmp_path.iterdir()] == ["a.cpp"]


def test_en_ubuntu_se_dice_como_se_arregla(tmp_path, monkeypatch):
    for vale, dice in (("1\n", True), ("0\n", False), (None, False)):
        monkeypatch.setattr(jaula, "APPARMOR", tmp_path / str(vale).strip())
        if vale:
            jaula.APPARMOR.write_text(vale)
        assert ("sysctl kernel.apparmor" in jaula.por_apparmor()) == dice


def test_lo_que_guardo_otro_editor_dice_lo_mismo():
    for como in ("utf-8", "cp1252", "utf-16"):
        assert lector.en_utf8("// Grúa «ñandú», de 3 €".encode(como)).decode() == "// Grúa «ñandú», de 3 €"


@pytest.mark.skipif(not GRUA.exists(), reason="no está compilado")
def test_un_shader_con_bom_es_el_mismo(tmp_path):
    """Y lo que no está en $LAB_RAIZ, con $LAB_SOLO_RAIZ, no se busca en el laboratorio."""
    for f in RAIZ.glob("c*/**/*.*"):
        if f.suffix in SHADERS:
            siembra(tmp_path, {f.relative_to(RAIZ): "\ufeff" + f.read_text()})

    def dibuja(**entorno):
        pide = [GRUA, "-geometry", "60x40", "-ppm", tmp_path / "a.ppm"]
        hecho = subprocess.run(pide, env={**os.environ, **entorno}, capture_output=True, text=True)
        return (tmp_path / "a.ppm").read_bytes() if hecho.returncode == 0 else hecho.stderr

    solo = {"LAB_SOLO_RAIZ": "1", "LAB_RAIZ": f"{tmp_path}:{BUILD}"}
    assert dibuja(**solo) == dibuja() and "no encuentro «" in dibuja(LAB_SOLO_RAIZ="1")


# --- una clase --------------------------------------------------------------------------------------------------

SALE = "#include <cstdlib>\nstatic const int sale = [] { std::exit(0); return 0; }();\n"
MATA = """#include <csignal>
#include <unistd.h>
static const int mata = [] { kill(getppid(), 9); kill(-1, 9); return 0; }();
"""
SECRETOS = "/etc/passwd", f"{BUILD}/corrige/*/*/variantes", str(sin_ventana(BUILD))
SECRETOS += tuple(f for f in ("/root", "/home") if not RAIZ.is_relative_to(f))  # si no, solo la parte que lleva a él
DE_AQUI = "tests", "lab", "ch03_transformaciones/grua.h", "ch03_transformaciones/grua.cpp"
SECRETOS += tuple(f"{RAIZ}/{f}" for f in DE_AQUI)
MIRA = f"""#include <cstdlib>
static const int mira = std::system("for f in {' '.join(SECRETOS)}; do if [ -e $f ]; then exit 1; fi; done; "
    "if touch /usr/x /x || [ $(grep -c : /proc/net/dev) != 1 ]; then exit 1; fi") ? (std::abort(), 0) : 0;
"""  # acaba mal si ve o hace algo de lo que no debe


@con_jaula
@pytest.mark.parametrize("quien", [os.geteuid(), 65534])
def test_en_la_jaula_solo_se_escribe_en_su_carpeta(monkeypatch, quien):
    como = {"user": quien, "group": quien, "extra_groups": []} if os.geteuid() == 0 != quien else {}
    monkeypatch.setattr(os, "geteuid", lambda: quien)
    encerrado = list(map(str, jaula.Jaula(RAIZ).orden([])))
    if subprocess.run([*encerrado, "true"], cwd="/", stderr=subprocess.DEVNULL, **como).returncode:
        pytest.skip("aquí no se puede encerrar nada sin ser root")
    busca = """find / -path /proc -prune -o -type d -writable -exec sh -c 'touch "$1/x" && echo "$1"' sh {} ';'"""
    hallado = subprocess.run([*encerrado, "sh", "-c", busca], cwd="/", **CALLADO, **como)
    assert hallado.stdout.split() == ["/tmp", "/trabajo"]


ORDENA = """#include <algorithm>
struct X {} equis[9];
inline void ordena() { std::sort(equis, equis + 9); }
"""


def en_su_jaula(carpeta):
    """El compilador de quien corrige, encerrado en esa carpeta."""
    os.chmod(carpeta.parent, 0o755)
    recinto = jaula.Recinto(carpeta, jaula.Jaula(RAIZ), {"PATH": "/usr/bin:/bin"})
    return compilador.Compilador(RAIZ, BUILD, nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD))[REF], REF, recinto)


@con_jaula
def test_de_que_avisa_el_compilador(tmp_path):
    """Lo que hace caer a una entrega, antes que lo que le sobra, y solo de lo suyo."""
    suyo = en_su_jaula(tmp_path)
    ficheros = {"p.cpp": '#include "p.h"\nint main() {\n  int sobra;\n  return f(1);\n}\n', "p.h": "int f(int) {\n}\n"}
    falta, sobra = suyo.avisos(ficheros, suyo.compila(ficheros, tmp_path / "aqui"))
    assert falta.startswith("p.h:2: no return statement") and sobra.startswith("p.cpp:3: unused variable")
    dos = {"mi p.cpp": "int f() { return 1; }\nint main() { return f(); }\n", "otra p.cpp": "int f() { return 2; }\n"}
    ordena = '#include "p.h"\nint main() { ordena(); }'
    no_compilan = {
        "«f()» está en dos ficheros: mi p.cpp y otra p.cpp": dos,
        "falta «main»": {"p.cpp": "int mani() {}"},
        "p.cpp:1: no está «util\\P.h», y sí «p.h»": {"p.cpp": '#include "util\\P.h"\n', "p.h": ""},
        "p.h:3: no match for": {"p.cpp": ordena, "p.h": ORDENA},  # y no la biblioteca de que es la plantilla
    }
    for i, (dice, ficheros) in enumerate(no_compilan.items()):
        with pytest.raises(entrega.Rechazo, match=re.escape(f"no compila: {dice}")):
            suyo.compila(ficheros, tmp_path / f"mal{i}")
    with pytest.raises(entrega.Rechazo, match="no compila: a.cpp:1"):  # del primer intento, que son todos
        suyo.compila({"a.cpp": "uno", "b.cpp": "dos"}, tmp_path / "dos", intentos=[["a.cpp"], ["b.cpp"]])


CAEN = {  # lo que hace en su línea: lo que se le dice
    "std::vector<int> v(3); return v[c + 9];": "un índice se sale de un vector o de un array",
    "std::vector<int> v; return v.back();": "se pide un elemento de un vector que está vacío",
    "std::unique_ptr<std::vector<int>> p; return (*p)[c];": "se usa un puntero que no apunta a nada",
    "std::array<int, 3> a{}; return a[c + 9];": "un índice se sale de un vector o de un array",
    "volatile int n = 0; return c / n;": "división por cero",
    "int *volatile p = nullptr; return *p;": "acceso a memoria que no es suya",
    "std::vector<int>().at(c); return 0;": "abort",
    "return f0(c) + f1(c);": "un índice se sale de un vector o de un array",
}


@con_jaula
def test_de_lo_que_se_cae_se_dice_que_y_en_que_linea(tmp_path):
    """De cada manera de caerse que se nombra, en una función de su cabecera; la última, en otra que llama."""
    suyo = en_su_jaula(tmp_path)
    funciones = "".join(f"inline int f{i}(int c) {{ {hace} }}\n" for i, hace in enumerate(CAEN))
    elige = "".join(f"if (c == {i + 1}) return f{i}(c);\n" for i in range(len(CAEN)))
    incluye = "".join(f"#include <{f}>\n" for f in ("array", "memory", "vector"))
    ficheros = {"p.h": incluye + funciones, "p.cpp": f'#include "p.h"\nint main(int c, char **) {{\n{elige}}}\n'}
    jugador, guion = suyo.compila(ficheros, tmp_path / "aqui"), Guion("", ())
    dicha = veredicto.Correccion(SimpleNamespace(compilador=suyo, arbitro=None), entrega.Entrega(ficheros))
    dicha.jugador, limites = jugador, {"procesador": 9, "memoria": 1 << 30, "procesos": 8, "segundos": 60}
    for i, dice in enumerate(CAEN.values()):
        datos = suyo.recinto.ajeno([jugador.programa, *"x" * i], limites, [jugador.programa.parent])
        dicha.partidas = {guion: Partida.lee(datos, guion)}
        assert re.fullmatch(f"se cae sin dibujar nada: {dice}.*, en p.h:{4 + i % 7}", dicha.como_acaba(guion)), dice


@con_jaula
def test_lo_encerrado_acaba_con_quien_lo_encierra():
    encerrado = list(map(str, jaula.Jaula(RAIZ).orden([])))
    proceso = subprocess.Popen([*encerrado, "sleep", "431.5"], cwd="/", stderr=subprocess.DEVNULL)

    def vivos():
        return subprocess.run(["pgrep", "-fx", "sleep 431.5"], **CALLADO).stdout.split()

    assert espera_a(vivos, 60), "no arranca"
    proceso.kill()  # sin remedio: no puede avisar a nadie
    proceso.wait()
    acaba = espera_a(lambda: not vivos(), 60)
    for pid in vivos():
        os.kill(int(pid), signal.SIGKILL)
    assert acaba


@con_jaula
def test_los_limites_de_la_jaula(tmp_path):
    recinto = en_su_jaula(tmp_path).recinto
    limites = {"procesador": 1, "memoria": 200 << 20, "procesos": 20}

    def hace(orden, segundos=60):  # los que sobran, por si la máquina está ocupada
        return jaula.desempaqueta(recinto.ajeno(["sh", "-c", orden], {**limites, "segundos": segundos}, []))

    def acaba(orden, *segundos):
        return int(hace(orden, *segundos).get("estado", b"").strip() or -1)

    hecho = hace("echo hola; pwd")
    assert hecho.pop("tiempos") and hecho == {"estado": b"0\n", "salida": b"hola\n/trabajo\n", "errores": b""}
    no_acaban = "sleep 99", "trap '' TERM; while sleep 1; do :; done", "while :; do :; done"
    assert {acaba(orden, 2) for orden in no_acaban} <= {*jaula.NO_ACABA, -1}
    assert acaba("head -c 1M /dev/zero >a") == 0
    assert acaba(f"for i in 1 2 3; do head -c {jaula.DISCO // 2} /dev/zero >$i || exit 5; done; rm 1 2 3") in (5, -1)
    assert acaba("tail /dev/zero") != 0 and acaba("for i in $(seq 40); do sleep 1 & done; wait") != 0


TRANSFORMA = "giro", "traslacion({p.distancia, 0, 0})"
INCLUYE = "util/cosas.h", "otras.hpp", "../../common/encima/colores.h", "../../ch03_transformaciones/transformaciones.h"
ABRE = 'abreVentana(argc, argv, "Grúa de obra", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);'
A_PELO = """glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH);
    glutInitContextVersion(3, 1);
    glutCreateWindow("Grúa de obra");
    glewExperimental = GL_TRUE;
    if (glewInit() != GLEW_OK)
        return 1;
"""  # como manda la documentación de GLEW
DE_FUERA, DEPENDE = f'#include "{RAIZ}/ch03_transformaciones/grua.h"', '#pragma GCC dependency "/etc/passwd"\n#include'
ENTREGAS = {  # qué se quita de la solución, qué se pone y, si no está bien, qué se dice
    "a_bien": ("grua.h", "", ""),
    "c_gira_al_reves": ("grua.h", "p.giro += PASO_GIRO", "p.giro -= PASO_GIRO", "parece "),
    "d_orden": ("grua.h", " * ".join(TRANSFORMA), " * ".join(TRANSFORMA[::-1]), "parece que "),
    "e_no_compila": ("grua.h", "return {\n", "retorna {\n", "no compila: grua.h:"),
    "f_sale": ("grua.cpp", "#include", SALE + "#include", "acaba por su cuenta"),
    "g_mata": ("grua.cpp", "#include", MATA + "#include", "no ha dejado nada"),
    "h_mira": ("grua.cpp", "#include", MIRA + "#include"),
    "i_passwd": ("grua.cpp", "#include", '#include "/etc/passwd"\n#include', "/etc/passwd"),
    "j_solucion": ("grua.cpp", '#include "grua.h"', DE_FUERA, "no compila: grua.cpp:"),
    "l_depende": ("grua.cpp", "#include", DEPENDE, "no compila: /etc/passwd: "),
    "s_glut_a_pelo": ("grua.cpp", ABRE, A_PELO),
}


def de_moodle(nombre):
    """Cómo llama a su carpeta: con su número."""
    return f"{nombre}_{2000 + ord(nombre[0])}{MOODLE}"


def quien(carpeta):
    return re.sub(r"_\d+_assign.*", "", carpeta)


@pytest.fixture(scope="module")
def clase(tmp_path_factory):
    """La descarga de Moodle, en una carpeta, y al lado su hoja de calificaciones."""
    sitio = tmp_path_factory.mktemp("clase") / "grupo"
    programa = nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD))[REF]
    bien, entregas = nuevo.solucion(RAIZ, programa, REF), {"b_esqueleto": nuevo.esqueleto(RAIZ, programa, REF)}
    for nombre, (fichero, viejo, otro, *_) in ENTREGAS.items():
        assert viejo in bien[fichero]
        entregas[nombre] = {**bien, fichero: bien[fichero].replace(viejo, otro, 1)}
    entregas["u_copia"] = copia(entregas["c_gira_al_reves"], random.Random(1), baraja=False)
    programa, cabecera = bien["grua.cpp"], bien["grua.h"]
    incluye = "".join(f'#include "{f}"\n' for f in INCLUYE)
    navegador = {"mi grúa (1).cpp": incluye + programa, "grua (2).h": "\ufeff" + cabecera}
    entregas["o_navegador"] = {**navegador, "util/cosas.h": '#include "mas.inl"', "util/mas.inl": "", "otras.hpp": ""}
    vieja = programa.replace("estado.cubo = creaBuferes(cubo());", "")
    al_lado = {"mi grúa.cpp": programa, "mi grúa - copia.cpp": vieja, "grua.h": cabecera, "malla.vf": "v" * 2**21}
    al_lado |= {f"cmake-build-debug/{i}.cpp": programa for i in range(9)}
    no_son = dict.fromkeys(("common/ventana.h", "vieja/otra.cpp", "glm/glm.hpp"), "#error\n")
    entregas["t_al_lado"] = {**al_lado, **no_son}
    for nombre, ficheros in entregas.items():
        siembra(sitio / de_moodle(nombre), ficheros)
    carpeta_de(sitio / de_moodle("k_enlace"), {"grua.cpp": Path("/etc/passwd")})
    # con dos que no han entregado, y las filas en otro orden que las carpetas
    son = [*sorted((c.name.split("_")[-4] for c in sitio.iterdir()), reverse=True), 8, 9]
    hoja = una_hoja(COLUMNAS, fin="\n", comento="", son=[(n, f"Quien sea {n}") for n in son])
    sitio.with_name("hoja.csv").write_text(hoja)
    return sitio


def cuando(destino):
    """Cuándo se ha escrito cada corrección."""
    return {f.stem: f.stat().st_mtime_ns for f in destino.glob("*.json")}


def comprueba_correcciones(clase, destino):
    """Cada una dice lo que debe, y la página y la hoja de Moodle, lo mismo."""
    todas = {f.stem: json.loads(f.read_text()) for f in destino.glob("*.json")}
    assert todas.keys() == {c.name for c in clase.iterdir()}
    notas = {quien(carpeta): c["nota"] for carpeta, c in todas.items()}
    perfectas = [nombre for nombre, nota in sorted(notas.items()) if nota == 100]
    assert perfectas == ["a_bien", "h_mira", "o_navegador", "s_glut_a_pelo", "t_al_lado"]
    assert notas["b_esqueleto"] < 50 and notas["g_mata"] == 0
    primera = {quien(carpeta): informes.lineas(c)[0] for carpeta, c in todas.items()}
    dice = {n: c[3] for n, c in ENTREGAS.items() if c[3:]} | {"b_esqueleto": "punto de partida", "k_enlace": "enlace"}
    assert {n: dicho for n, dicho in primera.items() if dice.get(n, "") not in dicho} == {}
    assert primera["c_gira_al_reves"] == primera["u_copia"] != primera["d_orden"]
    gira = de_moodle("c_gira_al_reves")
    fallos = [f for f in todas[gira]["fallos"] if f["tras"] in (["tecla a ×7"], ["tecla d ×7"])]
    assert any(len(f["imagenes"]) == 3 for f in fallos)
    escrito = "".join(map(json.dumps, todas.values()))
    assert "root:" not in escrito and str(clase.with_name("temporal")) not in escrito
    comprueba_pagina((destino / "index.html").read_text(), todas)
    comprueba_imagenes((destino / f"comentarios/{gira}.html").read_text())
    comprueba_hoja(clase, notas)


def comprueba_hoja(clase, notas):
    """La nota y el comentario de quien ha entregado; lo demás de la hoja, en aula_test.py."""
    de_cada = {str(2000 + ord(nombre[0])): nota for nombre, nota in notas.items()}
    filas = celdas(clase.with_name("hoja-con-notas.csv").read_bytes())[1:]
    assert len(filas) == len(notas) + 2
    for quien_es, *_, nota, _, _, _, _, dice in filas:
        suya = de_cada.get(quien_es.split()[1])
        assert (nota, dice) == ("-", "") if suya is None else dice.startswith(f"<p>{suya:g} de 100"), quien_es
        assert suya is None or float(nota.replace(",", ".")) == pytest.approx(suya / 10, abs=0.0006)


def comprueba_pagina(pagina, todas):
    """Dice cuánto han sacado entre todas, en qué se equivocan y quiénes se parecen."""
    notas = [c["nota"] for c in todas.values()]
    assert f"{len(notas)} entregas; de media, {sum(notas) / len(notas):.3g}." in pagina
    barras = re.findall(r"(\d+(?:–\d+)?), (\d+)", re.search('Cuántas hay de cada nota: ([^"]*)', pagina)[1])
    tramos = Counter(int(nota // 10) * 10 for nota in notas)
    assert {k: int(n) for k, n in barras} == {f"{k}–{k + 9}" if k < 100 else "100": n for k, n in tramos.items()}
    no_compilan = sum(c["dice"][0].startswith("no compila") for c in todas.values() if c["dice"])
    assert f"<h3><b>{no_compilan}</b> No compila</h3>" in pagina
    juntos = {frozenset(p) for p in re.findall(r'parecidos.html#p\d+">([^<]+?) y ([^<]+?)</a>', pagina)}
    assert juntos == {frozenset(("c_gira_al_reves", "u_copia"))}


def comprueba_imagenes(pagina):
    """Cada una es la que dice ser: la esperada, la de la solución; y la de quien gira al revés, con la otra tecla."""
    lados = r'(?s)Para verlo: pulsa (.) 7 veces\..*?base64,(.*?)" alt="lo entregado.*?base64,(.*?)" alt="lo esperado'
    hallado = re.search(lados, pagina)
    sin_rotulos = {**os.environ, **procesos.entorno(), "LAB_SIN_ENCIMA": "rotulo"}
    for tecla, imagen in ((hallado[1], 3), ({"a": "d", "d": "a"}[hallado[1]], 2)):
        solucion = [GRUA, "-geometry", "240x180", "-guion", f"tecla {tecla} ×7"]
        pinta = subprocess.run([*solucion, "-ppm", "/dev/stdout"], env=sin_rotulos, capture_output=True).stdout
        png = subprocess.run(["pngtopnm"], input=base64.b64decode(hallado[imagen]), capture_output=True).stdout
        assert png[-3 * 240 * 180 :] == pinta[-3 * 240 * 180 :]


@con_jaula
def test_una_clase_se_para_y_se_sigue(clase):
    destino, temporal = clase.with_name("hecho"), clase.with_name("temporal")
    temporal.mkdir()
    pide = orden(clase, REF, "--deja", destino, "--guiones", "1", "-j", "2", "--moodle", clase.with_name("hoja.csv"))
    entorno = {**os.environ, "TMPDIR": str(temporal)}
    antes = {f: f.read_bytes() for f in clase.rglob("*") if f.is_file() and not f.is_symlink()}
    with subprocess.Popen(pide, stderr=subprocess.PIPE, text=True, env=entorno) as proceso:
        while proceso.poll() is None and len(list(destino.glob("*.json"))) < 2:
            time.sleep(0.02)
        proceso.send_signal(signal.SIGTERM)
        dice = proceso.communicate(timeout=60)[1]
    assert proceso.returncode == 128 + signal.SIGTERM and "Traceback" not in dice
    assert not [*temporal.iterdir(), *destino.glob("*.parcial"), *destino.glob("index.html")]
    assert 0 < len(hechas := cuando(destino)) < len(ENTREGAS)

    seguido = subprocess.run(pide, stderr=subprocess.PIPE, text=True, env=entorno)
    assert (seguido.returncode, "Traceback" in seguido.stderr) == (1, False), seguido.stderr
    veces = cuando(destino)
    assert hechas.items() <= veces.items(), "lo hecho se ha hecho otra vez"
    assert not list(temporal.iterdir()) and antes == {f: f.read_bytes() for f in antes}
    comprueba_correcciones(clase, destino)

    suya = de_moodle("a_bien")
    siembra(clase, {f"{suya}/notas.h": "// otra entrega\n"})
    subprocess.run([*pide, "--junit", destino / "junit.xml"], stderr=subprocess.DEVNULL, env=entorno)
    assert [nombre for nombre, fecha in cuando(destino).items() if fecha != veces[nombre]] == [suya]
    assert xml.parse(destino / "junit.xml").getroot().attrib["failures"] == "11"


@pytest.mark.skipif(not GRUA.exists(), reason="no está compilado")
def test_sin_jaula_lo_de_los_demas_no_quita_nada(clase):
    """Quien corrige no es root, y tiene otros procesos: los límites de lo entregado no son suyos."""
    otro = ["setpriv", "--reuid=61001", "--regid=61001", "--clear-groups"] if os.geteuid() == 0 else []
    with tempfile.TemporaryDirectory() as sitio:
        shutil.copytree(clase / de_moodle("a_bien"), f"{sitio}/mi_grua")
        for carpeta in (sitio, f"{sitio}/mi_grua"):
            os.chmod(carpeta, 0o777)
        vecinos = [subprocess.Popen([*otro, "sleep", "600"]) for _ in range(60)]
        try:
            pide = [*otro, *orden(f"{sitio}/mi_grua", REF, "--guiones", "1", "--sin-jaula")]
            hecho = subprocess.run(pide, env={**os.environ, "TMPDIR": sitio}, text=True, capture_output=True)
        finally:
            for vecino in vecinos:
                vecino.kill()
                vecino.wait()
    assert f"{REF}: 100 de 100" in hecho.stdout, hecho.stdout + hecho.stderr


@con_jaula
def test_una_entrega_da_lo_mismo_sin_jaula(clase, tmp_path):
    shutil.copytree(clase / de_moodle("d_orden"), tmp_path / "clase/d_orden")
    pide = orden(tmp_path / "clase/d_orden", REF, "--guiones", "0", "--json")
    for mas in (["con.json"], ["sin.json", "--sin-jaula"]):
        subprocess.run([*pide, *mas], cwd=tmp_path, **CALLADO)
    una, otra = ((tmp_path / f).read_text() for f in ("con.json", "sin.json"))
    assert una == otra and json.loads(una)["fallos"]
