"""Dónde se aparta una entrega: lo que explica la suya lo ha podido escribir cualquiera."""
import copy
import json
import os
import random
import re
import subprocess
from pathlib import PurePath
from types import SimpleNamespace

import pytest

from base.fuentes import en_lineas
from ejercicios.corrige import cuadro, donde
from mentira import BUILD, RAIZ, sin_ventana

# Con trazos, con plantilla, y con otro framebuffer
PROGRAMAS = "ch03_transformaciones/grua", "ch07_realismo/espejo_plantilla", "ch09_imagen/convolucion_variable"
HOSTILES = None, True, -5, 1e300, 1 << 900, "", "nan", "x" * (1 << 20), [], {}, [[]], "<script>", 1.5, "\x1b[2J\n"


@pytest.fixture(scope="module", params=PROGRAMAS)
def datos(request, tmp_path_factory):
    """Lo que cuenta uno de los nuestros, de tres píxeles."""
    carpeta = tmp_path_factory.mktemp("cuadro")
    entorno = {"LD_PRELOAD": BUILD / cuadro.DELANTE, "LAB_EXPLICA": cuadro.FICHERO, "LAB_EXPLICA_SUMAS": "1"}
    entorno |= {"LAB_EXPLICA_PIXELES": "120,90 60,120 130,60"}
    orden = [sin_ventana(BUILD) / request.param, "-geometry", "240x180", "-ppm", "i.ppm"]
    subprocess.run(orden, env={**os.environ, **entorno}, cwd=carpeta, check=True)
    return (carpeta / cuadro.FICHERO).read_bytes()


def nudos(que, ruta=()):
    """Los sitios en que hay algo."""
    yield ruta
    dentro = que.items() if isinstance(que, dict) else enumerate(que) if isinstance(que, list) else ()
    for clave, suyo in dentro:
        yield from nudos(suyo, (*ruta, clave))


def con(que, ruta, otro):
    nuevo = copy.deepcopy(que)
    if not ruta:
        return otro
    dentro = nuevo
    for clave in ruta[:-1]:
        dentro = dentro[clave]
    dentro[ruta[-1]] = otro
    return nuevo


def compara(suyo, esperado):
    """Todo lo que se dice de cada píxel."""
    nada = donde.Shaders({})
    comparaciones = [donde.Comparacion(suyo, esperado, i, nada, nada) for i in range(len(suyo["pixeles"]))]
    return [c.primera() for c in comparaciones]


def test_de_lo_mismo_no_se_dice_nada(datos):
    leido = cuadro.lee(datos)
    assert len(leido["pixeles"]) == 3 and any(p["historia"] for p in leido["pixeles"])
    assert compara(leido, copy.deepcopy(leido)) == [None] * 3


def test_un_cuadro_estropeado_no_vale_o_se_compara(datos):
    """De cada cosa, cambiada por algo hostil: o no se lee, o lo que se dice se puede escribir y no es lo mismo."""
    leido = cuadro.lee(datos)
    entero, azar, valen = json.loads(datos), random.Random(1), 0
    todos = list(nudos({**entero, "sospechas": []}))
    for _ in range(150):
        ruta = azar.choice(todos)
        malo = cuadro.lee(json.dumps(con(entero, ruta, azar.choice(HOSTILES))).encode())
        if malo is None:
            continue
        valen += 1
        for hallado in compara(malo, leido) if len(malo["pixeles"]) == 3 else []:
            assert not hallado or json.dumps(hallado, allow_nan=False)
            assert not hallado or not re.search(r"(?:vale|en) (.+) y se espera \1$", hallado["dice"])
    assert 10 < valen < 140
    for malo in (b"", b"{", b"[" * 100000, b"null", b"\xff", datos[:-5], datos + b" " * cuadro.BYTES):
        assert cuadro.lee(malo) is None


# --- lo que se dice: con un hecho cambiado solo, ese, que sabe quien lo ha cambiado ------------------------------


@pytest.fixture(scope="module")
def busca():
    """Quien busca dónde se apartan dos cuadros, con los shaders del laboratorio y sin jugar nada."""
    suyo = SimpleNamespace(raiz=RAIZ, build=BUILD, visible=[])
    programa = SimpleNamespace(raices=[], capitulo=SimpleNamespace(nombre="ch03_transformaciones"))
    return donde.Donde(SimpleNamespace(arbitro=None, compilador=suyo, programa=programa))


def escrito(n, tipo):
    return ("sí" if n else "no") if tipo == "bool" else donde.cifra(0.0 if abs(n) < 1e-6 else n)


def cambios(orden):
    """De cada hecho que le llega: dónde está en ella, lo que se pone y lo que se lee."""
    cableado, (antes, numero, tras) = orden["cableado"], re.split(r"(\d+)(?=\D*$)", orden["llamada"])
    for i, u in enumerate(cableado["uniformes"]):
        otro = [u["valor"][0] + 7, *u["valor"][1:]]
        es, debe = (re.escape(escrito(v[0], u["tipo"])) for v in (otro, u["valor"]))
        columna = ", en su columna 1," if u["tipo"].startswith("mat") else ""
        vale = rf"vale \(?{es}\b.* y se espera \(?{debe}\b.*"
        yield ("cableado", "uniformes", i, "valor"), otro, f"el uniform «{re.escape(u['nombre'])}»{columna} {vale}"
    for i, a in enumerate(cableado["atributos"]):
        ninguno, suyo = f"al atributo «{a['nombre']}» no le llega ningún array", ("cableado", "atributos", i)
        yield from (((*suyo, "activo"), False, ninguno), ((*suyo, "bufer"), 0, ninguno))
        yield (*suyo, "suma"), "x", f"array de «{a['nombre']}» no es lo que se espera"
        llegan = f"«{a['nombre']}» le llegan 7 números por vértice y se esperan {a['componentes']}"
        yield (*suyo, "componentes"), 7, llegan
    yield ("cableado", "sumaIndices"), "x", "los índices no son los que se esperan"
    for i, t in enumerate(cableado["texturas"]):
        for hecho in t.keys() - {"sampler", "suma"}:
            otro = {"unidad": 7, "talla": [7]}.get(hecho, "OTRO")
            debe = {"incompleta": "", "talla": "×".join(map(str, t["talla"]))}.get(hecho, t[hecho])
            dice = f"la textura de «{t['sampler']}» .*({otro}|7) ?(y se espera )?{debe}$"
            yield ("cableado", "texturas", i, hecho), otro, dice
        yield ("cableado", "texturas", i, "suma"), "x", f"la textura de «{t['sampler']}» no es lo que se espera"
    for i, e in enumerate(orden["estado"]):
        yield ("estado", i, "valor"), "OTRO", f"{e['nombre']} es «OTRO» y se espera «{re.escape(e['valor'])}»"
    yield ("titulo",), "7 puntos", f"se pide dibujar 7 puntos y se espera {orden['titulo']}"
    yield ("llamada",), f"{antes}777{tras}", f"{antes.partition('(')[0]} recibe 777 y se espera {numero}"


def de_sucesos(suceso):
    """Y de cada hecho de lo que hace en el píxel: al que es otra cosa, y al que debía serlo."""
    uno, otro = ("no ", "sí"), ("", "no")
    for hecho, como in (("profundidadDespues", "la profundidad en"), ("plantillaDespues", "la plantilla en")):
        debe = suceso[hecho] or 0
        dos = donde.cifra(debe + 1), donde.cifra(debe)
        yield {hecho: debe + 1}, *(f"deja {como} {a} y se espera {b}" for a, b in (dos, dos[::-1]))
    dos = "(7, 8, 9)", donde.valor(suceso["despues"][:3])
    yield {"despues": [7, 8, 9, 255]}, *(re.escape(f"deja {a} y se espera {b}") for a, b in (dos, dos[::-1]))
    for veredicto in ("cara", "recorte", "descartado", "plantilla", "profundidad"):
        prueba = "el discard del shader" if veredicto == "descartado" else f"la .*{veredicto}"
        yield {"veredicto": veredicto}, *(f"{a}pasa aquí {prueba} y en lo esperado {b}" for a, b in (uno, otro))
    yield {"orden": -1}, *(f"{a}cubre este píxel y en lo esperado {b}" for a, b in (uno, otro))


def de_pasos(sombreado):
    """Y de cada paso de sus shaders, y la palabra que está en su línea."""
    vertices = [(("vertices", k), v) for k, v in enumerate(sombreado["vertices"])]
    for ruta, etapa in [(("fragmento",), sombreado["fragmento"]), *vertices]:
        for k, p in enumerate(etapa["lineas"]):
            if not p["valor"]:
                continue
            otro = [1 - p["valor"][0] if p["tipo"] == "bool" else p["valor"][0] + 7, *p["valor"][1:]]
            es, debe = (re.escape(escrito(v[0], p["tipo"])) for v in (otro, p["valor"]))
            quien = {
                "argumento": f"el parámetro {p['nombre']} de {p['funcion']}",
                "devuelve": f"lo que devuelve {p['funcion']}",
                "condicion": f"«{p['nombre']}»",
            }.get(p["clase"], p["nombre"])
            es_de_fuera = p["clase"] == "entrada"
            sitio = "^al? .*shader .* llega otra cosa:" if es_de_fuera else r"en la línea (\d+) de ([\w.]+),"
            dice = rf"{sitio}.* {re.escape(quien)}(?:, en su.*)? vale \(?{es}\b.* y se espera \(?{debe}\b"
            palabra = p["funcion"] if p["clase"] == "argumento" else re.search(r"[\w.]+", p["nombre"])[0]
            yield (*ruta, "lineas", k, "valor"), otro, dice, palabra


def lo_que_pinta(leido, lab):
    """Lo último que pinta cada píxel, si no es borrar: dónde está él, lo que hace allí y la orden."""
    for i, pixel in enumerate(leido["pixeles"]):
        j, suceso = [(j, s) for j, s in enumerate(pixel["historia"]) if s["veredicto"] == "escrito"][-1]
        n, orden = next((n, o) for n, o in enumerate(leido["ordenes"]) if o["n"] == suceso["orden"])
        otro = con(leido, ("pixeles", i, "historia", j, "despues"), [7, 8, 9, 255])
        compara_ = lambda suyo, esperado=leido, i=i: donde.Comparacion(suyo, esperado, i, lab, lab)
        if orden["cableado"]:
            cuantas = sum(bool(o["cableado"]) for o in leido["ordenes"][: n + 1])
            quien = rf"(el trazo.* \(|)lo {cuantas}\.º que se dibuja"
            yield ("pixeles", i), j, suceso, ("ordenes", n), orden, quien, otro, compara_


def test_con_un_hecho_cambiado_se_dice_ese(datos, busca):
    """De cada hecho de lo que pinta un píxel: cuál, lo que es, lo que debía y desde dónde se pide. De lo que se traza,
    por dónde va o de qué color."""
    leido, lab = cuadro.lee(datos), busca.lab
    for pixel, j, suceso, aqui, orden, quien, otro, compara_ in lo_que_pinta(leido, lab):
        trazo = compara_(leido).es_de_encima(orden)
        for ruta, cosa, debe in cambios(orden):
            hallado = compara_(con(otro, (*aqui, *ruta), cosa)).primera()
            debe = "debía ser de color .*|no va por donde debe" if trazo else debe
            assert re.search(f"{quien}.* ({debe})$", hallado["dice"]), hallado
            de = orden["cableado"]["uniformes"][ruta[2]] if "uniformes" in ruta and not trazo else orden
            assert hallado["pila"] == leido["pilas"][de["pila"]]
        for cambio, *deben in de_sucesos(suceso):
            suyo = con(leido, (*pixel, "historia", j), {**suceso, **cambio})
            for dos, debe in zip(((suyo, leido), (leido, suyo)), deben):
                hallado = compara_(*dos).primera()
                assert re.search(f"{quien}.* {debe}$", hallado["dice"]), hallado
        for n, antes in enumerate(leido["ordenes"]):  # lo de otro framebuffer, antes que la textura que se pinta en él
            if antes["framebuffer"] == donde.VENTANA or not antes["cableado"]:
                continue
            otro = con(otro, (*aqui, "cableado", "texturas", 0, "suma"), "x")
            for ruta, cosa, debe in cambios(antes):
                dicho = compara_(con(otro, ("ordenes", n, *ruta), cosa)).primera()["dice"]
                assert re.search(quien if "texturas" in ruta else f"lo {n + 1}\\.º.* {debe}", dicho), dicho
            pedida = compara_(con(otro, ("programas", 0, "frag"), "// ni vacío"))
            assert pedida.primera() and pedida.se_sombrea
        sin = con(leido, ("ordenes",), [o for o in leido["ordenes"] if o is not orden])
        debe = {
            "falta": quien if trazo else f"algo, después de .* se dibujen {orden['titulo']}",
            "sobra": f"{quien}.*:",
        }
        for dos, (que, dice) in zip(((sin, leido), (leido, sin)), debe.items()):
            hallado = compara_(*dos).primera()
            assert hallado["que"] == que and re.match(f"{que} {dice}", hallado["dice"]), hallado


def test_con_un_paso_o_un_shader_cambiado_se_dice_ese(datos, busca):
    """De cada paso de un shader: cuál, sus dos valores, y la línea en que está escrito."""
    leido, lab = cuadro.lee(datos), busca.lab
    for pixel, _, suceso, _, orden, _, otro, compara_ in lo_que_pinta(leido, lab):
        pedida = compara_(con(otro, (*pixel, "sombreado"), None))
        assert pedida.primera()["que"] == "suceso" and pedida.se_sombrea == ((orden["n"], suceso["primitiva"]),) * 2
        for ruta, cosa, debe, palabra in de_pasos(leido[pixel[0]][pixel[1]]["sombreado"]):
            dicho = compara_(con(otro, (*pixel, "sombreado", *ruta), cosa)).primera()["dice"]
            hallado = re.search(debe, dicho)
            assert hallado, (debe, dicho)
            for linea, fichero in [hallado.groups()] if hallado.groups() else ():
                textos = [f.read_text().splitlines() for f in RAIZ.glob(f"c*/**/{fichero}")]
                assert any(palabra in texto[int(linea) - 1] for texto in textos), dicho
        k = next(k for k, p in enumerate(leido["programas"]) if p["programa"] == orden["programa"])
        frags = {t: PurePath(ll[-1][0]).name for t, ll in lab.hechos.items() if t and ll[-1][0].endswith(".frag")}
        suyo = frags[lab.clave(en_lineas(leido["programas"][k]["frag"]))]
        for frag, nombre in frags.items():
            if nombre != suyo:
                dicho = compara_(con(otro, ("programas", k, "frag"), frag)).primera()["dice"]
                assert f"el shader es {nombre} y se espera {suyo}" in dicho


def test_lo_que_se_juega_para_explicarlo(datos, busca, monkeypatch):
    """De dos imágenes, y lo que explica cada uno de su cuadro: si no es el de su imagen, o no se explica, no se dice
    nada; si es el de la esperada, que falta volver a dibujar; y antes lo que se sabe de dónde sale, aunque no pinte."""
    leido, solucion, guion = cuadro.lee(datos), object(), object()
    busca.compilador.solucion, pedido = solucion, []
    busca.compilador.linea_de_una_llamada = lambda ficheros, jugador, pila: "p.cpp:7"

    def con_otro_color(aparta):
        suyo = copy.deepcopy(leido)
        for p, a in zip(suyo["pixeles"], aparta):
            p["color"] = [c + a if c < 128 else c - a for c in p["color"]]
        return suyo

    def imagen(de, ancho=240):
        pinta = {tuple(p["pixel"]): bytes(int(c) for c in p["color"][:3]) for p in de["pixeles"]}
        return ancho, 180, b"".join(pinta.get((x, y), bytes(3)) for y in range(180) for x in range(ancho))

    def dice(suyo, esperado, una, otra):
        cuadros = {solucion: esperado, "yo": suyo}

        def explica(quien, _, pixeles, **mas):
            pedido.append(mas)
            suyos = [p for p in cuadros[quien]["pixeles"] if tuple(p["pixel"]) in pixeles] if cuadros[quien] else []
            return cuadros[quien] and {**cuadros[quien], "pixeles": suyos}

        monkeypatch.setattr(busca, "explica", explica)
        return busca.busca("yo", {}, guion, imagen(una), otra)

    mal, peor = con_otro_color((90, 60, 30)), con_otro_color((91, 61, 31))
    sin_redibujar = dice(leido, leido, leido, imagen(mal))
    assert "glutPostRedisplay" in sin_redibujar["dice"] and sin_redibujar["pixel"] == leido["pixeles"][0]["pixel"]
    assert dice(mal, leido, leido, imagen(mal, 200)) is None and dice(leido, leido, leido, imagen(leido)) is None
    for suyo, esperado in ((None, leido), (mal, None), (peor, leido), (mal, peor), ({**mal, "pixeles": []}, leido)):
        assert dice(suyo, esperado, leido, imagen(mal)) is None
    for pixel, j, suceso, aqui, orden, *_ in lo_que_pinta(leido, busca.lab):
        suyo, este = con(mal, (*pixel, "historia", j, "despues"), [7, 8, 9, 255]), leido["pixeles"][pixel[1]]["pixel"]
        pedido.clear()
        assert dice(con(suyo, (*pixel, "sombreado"), None), leido, leido, imagen(mal))["pixel"] == este
        sombrea = {"LAB_EXPLICA_SOMBREA": f"{orden['n']},{suceso['primitiva']}"}
        assert pedido[:4] == [{}, {}, sombrea, sombrea]
        suyo = con(suyo, (*aqui, "cableado", "sumaIndices"), "x")
        de_array = dice(suyo, leido, leido, imagen(mal))
        assert de_array["pixel"] == este and de_array["dice"].endswith("(se pide en p.cpp:7)")
        n, otra = next((n, o) for n, o in enumerate(leido["ordenes"]) if o["cableado"] and o is not orden)
        suyo = con(suyo, ("ordenes", n, "cableado", "uniformes", 0, "valor", 0), 7.5)
        de_otra = dice(suyo, leido, leido, imagen(mal))
        assert re.search(r"«\w+».* vale \(?7.5.*\(se envía en p.cpp:7\)", de_otra["dice"]) and de_otra["pixel"] is None


def traza(*pasos):
    """De «x = 3» en la línea 2: que es lo que declara, si es la primera vez."""
    suya = {"clase": "asigna", "tipo": "float", "funcion": "main"}
    return {"lineas": [{"linea": n, "nombre": x, "valor": [v], **suya} for n, x, v in pasos]}


BUCLE = "suma = 0.0;\nfor (int i = 0; i < 2; i++)\n    suma += f(i);\nc = suma;"
VUELTAS = (2, "i", 0), (3, "st", 7), (3, "suma", 1), (2, "i", 1), (3, "st", 8), (3, "suma", 3), (4, "c", 3)


def test_el_primer_paso_que_se_aparta():
    """En otro orden, o en dos veces, da lo mismo; si no, la línea que yerra: la última vuelta, la de más o la primera
    de que sale."""
    al_reves = (2, "i", -1), (3, "st", 8), (3, "suma", 2), (2, "i", -2), (3, "st", 7), (3, "suma", 3), (4, "c", 3)
    dice = lambda *pasos: donde.primer_paso(traza(*pasos), traza(*VUELTAS), [BUCLE, BUCLE])
    assert dice(*al_reves) is None and dice(*VUELTAS[:5], (3, "suma", 2), (4, "suma", 3), (5, "c", 3)) is None
    assert dice(*al_reves[:5], (3, "suma", 4), (4, "c", 4)) == (5, [3], [])
    assert dice(*VUELTAS[:6], (4, "suma", 1.5), (5, "c", 1.5)) == (6, [3], [])
    suelto = *VUELTAS[:6], (4, "mitad", 0), (5, "d", 0), (6, "c", 0)
    i, esperado, sueltos = dice(*suelto)
    fuente = "\n\n\nmitad = 1 / 2;\nd = suma * mitad;\nc =\n d;"
    assert (i, esperado) == (8, [3]) and donde.de_que_sale(traza(*suelto)["lineas"], sueltos, i, fuente) == [6, 7]


def test_un_shader_que_se_incluye_a_si_mismo_acaba():
    muchas = '#include "b.glsl"\n' * 3000
    shaders = donde.Shaders({"a.frag": muchas, "b.glsl": muchas, "c.frag": '#include "c.frag"', "d.frag": "uno\ndos"})
    assert shaders.sitio("uno\ndos\n", 2) == ("d.frag", 2) and shaders.sitio("otro", 3) == ("", 3)
