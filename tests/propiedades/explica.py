"""explica.py RAÍZ BUILD [PROGRAMA…] [--pixeles N] [--casos] [--enlace ENLACE]: lo que se pide de ./lab explica en el
caso base de cada programa, o en todos sus casos, en N píxeles al azar, siempre los mismos: que el programa acabe bien,
que la imagen sea la misma que sin explicarla, que no se sospeche nada de ninguno, que lo que se dice de cada orden sea
lo que OpenGL contesta a quien se lo pregunta (preguntado.py) y lo que dice cada fallos_de….

Sin decir el enlace, con el que se usa sin ventana y, si hay otro, uno de cada diez programas con él. Estado 1 si algo
no se cumple.
"""
import argparse
import base64
import itertools
import json
import operator
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

RAIZ = Path(__file__).parents[2]
sys.path.insert(0, str(RAIZ / "herramientas"))
import preguntado  # noqa: E402
from base import catalogo, controles, llamadas  # noqa: E402

ANCHO, ALTO = 240, 180
TALLA = "-geometry", f"{ANCHO}x{ALTO}", "-ppm", "imagen.ppm"
SIN_SOSPECHAS = {  # lo que se sospecha, con razón, y aquí es así a propósito
    "escalado": "determinante 0",  # con un factor 0
    "normales": "determinante 0",  # aplastar un objeto
    "hermite": "0 vértices",  # de lo que aún no se ve
    "primer_programa": "no se dibuja nada",  # solo borra
    "zbuffer": "GL_DEPTH_TEST no está puesto",  # es lo que enseña
    "grua_zbuffer": "GL_DEPTH_TEST no está puesto",
    "volumen_vista": "el plano lejos la corta",  # es lo que enseña
    "tiras": "«diametroPunto»",  # solo hace falta cuando se dibujan los puntos
}
TALLAS = "960x3", "3x960", "1x1", "240x180"
COPIADO = "copiado de otro framebuffer"
PASAN = "escrito", "profundidad", "mascara"  # los que llegan al test de profundidad
VEREDICTOS = *PASAN, "ajeno", "cara", "descartado", "nada", "plantilla", "recorte"
OTRA_TEXTURA = "no sé de qué texels sale: solo sigo texture y textureLod de un sampler2D, sampler3D o samplerCube"
SALE_DE_LA_CARA = "el filtro sale de la cara, y en la de al lado no sé seguirlo"
ANISOTROPO = "el filtro anisótropo lee más texels, que no sigo"
PASOS = 4000  # los que apunta, como mucho, sombreado.cpp


def pixeles(imagen):
    """Los de un PPM, fila a fila desde arriba."""
    return imagen.read_bytes()[-3 * ANCHO * ALTO :]


IGUALAN = operator.lt, operator.eq, operator.le, operator.gt, operator.ne, operator.ge, lambda a, b: 0, lambda a, b: 1
FUNCIONES = "LESS EQUAL LEQUAL GREATER NOTEQUAL GEQUAL NEVER ALWAYS"
COMPARA = dict(zip((f"GL_{nombre}" for nombre in FUNCIONES.split()), IGUALAN))
CASI = 2e-6  # de profundidad: lo que puede cambiar al dibujar otra vez el triángulo solo


def fallos_de_tests(suceso):
    """Lo que dice de la plantilla y de la profundidad es lo que sale de comparar lo que pide con lo que había."""
    veredicto = suceso["veredicto"]
    if veredicto not in VEREDICTOS:
        yield f"no hay ningún veredicto «{veredicto}»"
    if "plantillaPide" in suceso and suceso["plantillaAntes"] is not None and veredicto not in ("cara", "recorte"):
        funcion, referencia = suceso["plantillaPide"].split()
        pasa = COMPARA[funcion](int(referencia), suceso["plantillaAntes"])
        if veredicto != "descartado" and pasa == (veredicto == "plantilla"):
            yield f"se pide {suceso['plantillaPide']} y había {suceso['plantillaAntes']}"
    suya, habia = suceso.get("profundidad"), suceso.get("profundidadAntes")
    if "profundidadPide" in suceso and suya is not None and habia is not None and veredicto in PASAN:
        pasa = COMPARA[suceso["profundidadPide"]](suya, habia)
        if abs(suya - habia) > CASI and pasa == (veredicto == "profundidad"):
            yield f"se pide {suceso['profundidadPide']}, {suya}, y había {habia}"
    son = {"profundidad": [suya, habia], "plantilla": [suceso.get("plantillaAntes")]}.get(veredicto, [])
    dichos = preguntado.numeros(suceso["dice"].partition(" (")[0])
    if any(abs(dicho - es) > 1e-5 for dicho, es in zip(dichos, son)):
        yield f"«{suceso['dice']}», y son {son}"


def fallos_de_mascara(suceso, canales):
    """Quien escribe cambia los canales que escribe su orden y ninguno más; si no mezcla, por los de su color."""
    if suceso["veredicto"] == "escrito" and "primitiva" in suceso and "color" not in suceso:
        yield "está escrito sin que el shader dé ningún color"
    if suceso["veredicto"] == "mascara" and canales or suceso["veredicto"] == "escrito" and not canales:
        yield f"escribe «{canales}»"
    mezcla = suceso.get("mezcla", {}).get("si", True)
    for canal, antes, despues, color in zip("rgb", suceso["antes"], suceso["despues"], suceso.get("color", [])):
        if canal not in canales and antes != despues:
            yield f"escribe «{canales}» y cambia {canal}"
        lejos = min(abs(255 * c - despues) for c in (color, min(max(color, 0), 1))) > 1
        if suceso["veredicto"] == "escrito" and canal in canales and not mezcla and lejos:
            yield f"deja {despues} en {canal} y su color es {color}"


def quien_gana(historia, lienzo=0):
    """La orden y la primitiva de que viene el color de la ventana, o de ese framebuffer: si lo último es una copia, de
    antes, en el otro. Lo que se mezcla y no cambia nada no cuenta, si hay otra cosa."""
    de_verdad = [s for s in historia if not s.get("mezcla", {}).get("si") or s["antes"] != s["despues"]]
    if len(de_verdad) < len(historia) and quien_gana(de_verdad, lienzo)[1] is not None:
        return quien_gana(de_verdad, lienzo)
    for suceso in reversed(historia):
        if suceso["framebuffer"] != lienzo or suceso["veredicto"] != "escrito":
            continue
        if "primitiva" in suceso or suceso["dice"] != COPIADO:
            return suceso["orden"], suceso.get("primitiva")
        lienzo = 1 - lienzo
    return None, None


def fallos_de_lo_que_falta(suceso, canales):
    """Sin lo primero que no pasa se vería si pasa lo demás, y la plantilla y la profundidad se pueden comparar; de lo
    que el shader descarta no se sabe la suya, pero de lo que nada tiene detrás, que está delante."""
    pruebas = "cara", "descartado", "plantilla", "profundidad"
    veredicto, suya, habia = (suceso.get(cual) for cual in ("veredicto", "profundidad", "profundidadAntes"))
    suya = suya if suya is not None or habia != 1 else 0.5
    if veredicto not in pruebas or "profundidadPide" in suceso and (None in (suya, habia) or abs(suya - habia) < CASI):
        return
    pasa = {"descartado": "color" in suceso}
    if "profundidadPide" in suceso:
        pasa["profundidad"] = COMPARA[suceso["profundidadPide"]](suya, habia)
    if "plantillaPide" in suceso:
        funcion, referencia = suceso["plantillaPide"].split()
        pasa["plantilla"] = COMPARA[funcion](int(referencia), suceso["plantillaAntes"])
    debe = bool(canales) and all(pasa.get(prueba, True) for prueba in pruebas if prueba != veredicto)
    if suceso["soloEsa"] != debe:
        yield f"sin esa prueba {'no ' * (not debe)}se vería: {suceso}"


def fallos_de_historia(historia, canales):
    """Entre dos sucesos de un framebuffer nadie más cambia el píxel, ni lo cambia el que no escribe; lo copiado es lo
    que había donde se dice, y cada mezcla, hecha otra vez con el color del shader, da lo que queda, a nivel y medio."""
    queda = {}
    for suceso in historia:
        antes, despues = suceso["antes"], suceso["despues"]
        quien = f"la orden {suceso['orden']}, {suceso['veredicto']}"
        if antes != queda.get(suceso["framebuffer"], antes):
            yield f"{quien}, encuentra {antes} y quedaba {queda[suceso['framebuffer']]}"
        if suceso["veredicto"] == "ajeno" and suceso["framebuffer"] == 0:
            yield f"{quien}, cambia la ventana"
        if suceso["veredicto"] not in ("escrito", "ajeno") and antes != despues:
            yield f"{quien}, cambia {antes} por {despues}"
        if suceso["dice"] == COPIADO and len(lienzos := {s["framebuffer"] for s in historia}) == 2:
            [origen] = lienzos - {suceso["framebuffer"]}
            if despues != queda.get(origen, despues):
                yield f"{quien}, copia {despues} y allí hay {queda[origen]}"
        yield from (f"{quien}: {fallo}" for fallo in fallos_de_tests(suceso))
        if "primitiva" in suceso:
            for fallos in fallos_de_mascara, fallos_de_lo_que_falta:
                yield from (f"{quien}: {fallo}" for fallo in fallos(suceso, canales[suceso["orden"]]))
        mezcla = suceso.get("mezcla", {})
        if not mezcla.get("cuadra", True):
            yield f"{quien}, deja {despues} y la mezcla es {mezcla}"
        queda[suceso["framebuffer"]] = despues


def fallos_de_sombreado(explicado):
    """El fragmento que gana, línea a línea, da su color, y le llega lo que sale de mezclar sus vértices (a 1e-5)."""
    sombreado = explicado.get("sombreado")
    orden, primitiva = quien_gana(explicado["historia"], explicado["framebuffer"])
    gana = (sombreado["orden"], sombreado["primitiva"]) if sombreado else (orden, None)
    if gana != (orden, primitiva) and len({s["framebuffer"] for s in explicado["historia"]}) <= 2:
        yield f"se explica {gana} y gana {orden, primitiva}"
    if not sombreado:
        return
    suceso = next(s for s in explicado["historia"] if all(s.get(c) == sombreado[c] for c in ("orden", "primitiva")))
    fragmento = sombreado["fragmento"]
    if fragmento["motivo"] or any(v["motivo"] for v in sombreado["vertices"]):
        yield f"no se siguen sus shaders: {fragmento['motivo']}"
        return
    for linea in (linea for traza in (fragmento, *sombreado["vertices"]) for linea in traza["lineas"]):
        if linea["nombre"] == "igual" and linea["valor"] != [1]:
            yield f"en la línea {linea['linea']}, lo que no se usa no vale lo que se le da"
    salida = [linea["valor"] for linea in fragmento["lineas"] if linea["clase"] == "salida"]
    if suceso.get("color") and fragmento["pasos"] < PASOS and distancia(salida[-1], suceso["color"]) > 1 / 255:
        yield f"el shader da {suceso['color']} y línea a línea, {salida}"
    for lectura in sombreado["lecturas"]:
        yield from fallos_de_lectura(lectura)
    for entrada in sombreado.get("entradas", []):
        talla = max(1, *(abs(n) for n in entrada["valor"]))
        if distancia(entrada["interpolado"], entrada["valor"]) > 1e-5 * talla:
            yield f"{entrada['nombre']} vale {entrada['valor']} y de los vértices sale {entrada['interpolado']}"


def fallos_de_lectura(lectura):
    """De una textura: sus texels, con su peso, suman lo leído, y no se dice otra cosa sin decir por qué."""
    texels = lectura.get("texels", [])
    pesos = sum(t["peso"] for t in texels)
    suma = [sum(t["peso"] * t["color"][c] for t in texels) for c in range(4)]
    contraste = max((max(c) - min(c) for c in zip(*(t["color"] for t in texels))), default=0)
    lejos = distancia(suma, lectura["valor"]) > 1.1 / 255 + contraste / 128 + 1e-6 if texels else True
    if lectura["escrito"].count("(") != lectura["escrito"].count(")"):
        yield f"«{lectura['escrito']}» no está entero"
    if lectura.get("cara"):
        eje = max(range(3), key=lambda k: abs(lectura["coordenadas"][k]))
        if lectura["cara"] != "+−"[lectura["coordenadas"][eje] < 0] + "XYZ"[eje]:
            yield f"{lectura['coordenadas']} no va a la cara {lectura['cara']}"
        if lectura["motivo"] == SALE_DE_LA_CARA:
            return
    sabido = lectura["motivo"] in ("", ANISOTROPO) and abs(pesos - 1) <= 1e-5 or lectura["motivo"] == OTRA_TEXTURA
    if lejos != bool(lectura["motivo"]) or not sabido:
        yield f"{lectura['escrito']} da {lectura['valor']}, y de pesos {pesos}, {suma}: {lectura['motivo']}"


def distancia(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def canales_de(cuadro):
    """Los que deja escribir glColorMask en cada orden."""
    de_color = ((o["n"], e["valor"]) for o in cuadro["ordenes"] for e in o["estado"] if e["nombre"] == "glColorMask")
    return {n: valor.strip("-") for n, valor in de_color}


def fallos_de_pixel(explicado, imagen, canales):
    """El color que se da es el de la imagen, y el último que escribe en la ventana su historia, también."""
    x, y = explicado["pixel"]
    suyo = list(imagen[3 * (y * ANCHO + x) :][:3])
    escritos = [s["despues"] for s in explicado["historia"] if s["framebuffer"] == 0 and s["veredicto"] == "escrito"]
    if explicado["color"][:3] != suyo:
        yield f"se dice {explicado['color']} y es {suyo}"
    if escritos and escritos[-1][:3] != suyo:
        yield f"lo último escrito es {escritos[-1]} y queda {suyo}"
    yield from fallos_de_historia(explicado["historia"], canales)
    yield from fallos_de_sombreado(explicado)


def fallos_de_lineas(cuadro, ejecutable):
    """De cada orden y de cada uniform dado, el renglón que se dice nombra a quien se dice que llama, o a OpenGL."""
    pregunta = llamadas.pregunta(ejecutable, cuadro["pilas"])
    respuesta = subprocess.run(pregunta, capture_output=True, text=True, check=True).stdout
    sitios = llamadas.sitios(cuadro["pilas"], respuesta, lambda ruta: ruta.startswith(f"{RAIZ}/ch"))
    leidas = {(ruta, n) for marcos in llamadas.lee(respuesta).values() for _, ruta, n in marcos if f"{RAIZ}/" in ruta}
    if leidas != {(ruta, int(n)) for ruta, n in re.findall(rf"^({RAIZ}/.*):(\d+)", respuesta, re.M)}:
        yield "no se lee cada línea que se dice"
    todas = {(o["pila"], o["llamada"].partition("(")[0]) for o in cuadro["ordenes"]}
    dados = (u for o in cuadro["ordenes"] for u in o.get("cableado", {}).get("uniformes", []) if u["dado"])
    for pila, funcion in sorted(todas | {(u["pila"], "glUniform") for u in dados}):
        suyo = sitios[pila]
        texto = suyo and Path(suyo["ruta"]).read_text().splitlines()[suyo["linea"] - 1]
        llama = suyo and (suyo["llama"] or funcion).rpartition("::")[2]
        if not suyo or llama not in texto:
            yield f"{funcion} se llama en {suyo}: «{texto}»"


def dibuja(orden, carpeta, **entorno):
    """Su imagen, que debe salir sin nada que decir."""
    r = subprocess.run([*orden, *TALLA], env={**os.environ, **entorno}, cwd=carpeta, capture_output=True, text=True)
    assert r.returncode == 0 and not r.stderr, f"acaba con {r.returncode}: {r.stderr}"
    return pixeles(carpeta / "imagen.ppm")


def fallos_de(build, orden, puntos, golden, sabido):
    """Los de lo que dibuja esa orden, en esos píxeles. `sabido`: lo que se puede sospechar."""
    with tempfile.TemporaryDirectory() as carpeta:
        carpeta = Path(carpeta)
        pide = preguntado.preguntando(build, carpeta, build / "herramientas/explica/libexplica.so")
        pide |= {"LAB_EXPLICA": "e.json", "LAB_EXPLICA_PIXELES": " ".join(f"{x},{y}" for x, y in puntos)}
        try:
            imagen = dibuja(orden, carpeta, **pide)
            explicadas = preguntado.contestado(carpeta)
            # sin explicar es la del golden, salvo lo que redondee otro OpenGL
            igual = golden and imagen == pixeles(golden) or imagen == dibuja(orden, carpeta)
        except AssertionError as fallo:
            return [str(fallo)]
        if not (carpeta / "e.json").exists():
            return ["no se explica"]
        cuadro = json.loads((carpeta / "e.json").read_text())
        suyas = preguntado.pregunta([*orden, *TALLA], build, carpeta)
    explicados = cuadro["pixeles"]
    fallos = [] if igual else ["la imagen no es la misma explicada"]
    dichas = [s["dice"] for s in cuadro["sospechas"] if not (sabido and sabido in s["dice"])]
    fallos += [f"se sospecha: {dice}" for dice in dichas]
    if [tuple(e["pixel"]) for e in explicados] != puntos:
        fallos.append("no están los píxeles que se piden")
    fallos += [*fallos_de_lineas(cuadro, orden[0]), *preguntado.fallos(cuadro, suyas, explicadas)]
    canales = canales_de(cuadro)
    sucesos = [s for e in explicados for s in e["historia"] if s["dice"] == "borrado" and s["framebuffer"] == 0]
    for n in {s["orden"] for s in sucesos if len(canales.get(s["orden"], "rgb")) > 2}:
        if len(colores := {repr(s["despues"]) for s in sucesos if s["orden"] == n}) > 1:
            fallos.append(f"la orden {n} borra de {' y de '.join(colores)}")
    return fallos + [f"{e['pixel']}: {fallo}" for e in explicados for fallo in fallos_de_pixel(e, imagen, canales)]


def fallos_de_caso(build, enlace, caso, cuantos):
    programa = caso.programa
    anda = "temporizador" in controles.atiende(build, programa)[0]  # el cuadro que se explica es el de entonces
    guion = "; ".join([caso.guion] * bool(caso.guion) + ["espera 730"] * anda)
    orden = [build / enlace / programa.capitulo.nombre / programa.nombre, *["-guion", guion] * bool(guion)]
    golden = None if anda else RAIZ / f"tests/golden/{programa.capitulo.nombre}/{caso.fichero}.ppm"
    sabido = SIN_SOSPECHAS.get(programa.nombre, "")
    cuantos *= 4 if programa.nombre == "enrejado" else 1  # a ver si toca un hueco
    fallos = fallos_de(build, orden, al_azar(caso.fichero, cuantos, golden), golden, sabido)
    return [f"{enlace}, {caso.fichero}: {fallo}" for fallo in fallos]


def fallos_de_imagenes(build, programa, talla):
    """Cada imagen tiene sus bytes, y lo que cambia una orden es lo que no es como antes; más lejos es más claro."""
    ancho, alto = map(int, talla.split("x"))
    puntos = [(ancho * i // 4, alto * j // 4) for i in range(4) for j in range(4)]
    with tempfile.TemporaryDirectory() as carpeta:
        pide = {"LAB_EXPLICA": "e.json", "LAB_EXPLICA_PIXELES": " ".join(f"{x},{y}" for x, y in puntos)}
        pide |= {"LD_PRELOAD": str(build / "herramientas/explica/libexplica.so"), "LAB_EXPLICA_IMAGENES": "1"}
        orden = [programa.ejecutable(build), "-geometry", talla, "-ppm", "imagen.ppm"]
        subprocess.run(orden, env={**os.environ, **pide}, cwd=carpeta, capture_output=True, check=True)
        cuadro = json.loads(Path(carpeta, "e.json").read_text())
        final = Path(carpeta, "imagen.ppm").read_bytes()[-3 * ancho * alto :]
    quedan, lejos, fallos = {}, [], []
    for orden, que in ((o, q) for o in cuadro["ordenes"] for q in ("miniatura", "profundidad", "plantilla") if q in o):
        dada, suya = orden[que], (orden["framebuffer"], que)
        imagen, antes = base64.b64decode(dada["datos"]), quedan.get(suya, b"")
        quedan[suya] = imagen
        if not imagen or len(imagen) != dada["ancho"] * dada["alto"] * dada["canales"]:
            fallos.append(f"de la orden {orden['n']}, una imagen de {len(imagen)} bytes")
        elif que == "miniatura" and [dada["ancho"], dada["alto"]] == orden["talla"]:
            cambian = [i // 3 for i in range(0, len(imagen), 3) if imagen[i : i + 3] != antes[i : i + 3]]
            filas, columnas = ([f(i, dada["ancho"]) for i in cambian] for f in (operator.floordiv, operator.mod))
            desde, hasta = ([cual(lado, default=0) for lado in (columnas, filas)] for cual in (min, max))
            hay = [len(cambian), *desde, *(b - a + 1 for a, b in zip(desde, hasta))]
            if [orden["cambian"], *orden["donde"]] != hay:
                fallos.append(f"la orden {orden['n']} cambia {hay} y se dice {orden['donde']}")
        elif que == "profundidad" and dada["ancho"] == orden["talla"][0] and len(tonos := {*imagen} - {255}) > 1:
            if not min(tonos) == 0 < 200 < max(tonos):
                fallos.append(f"la orden {orden['n']} no va de negro a casi blanco: de {min(tonos)} a {max(tonos)}")
    grises = quedan.get(("la ventana", "profundidad"))
    for (x, y), explicado in zip(puntos, cuadro["pixeles"] if grises and ancho <= ANCHO else ()):  # si no, va menor
        hondos = [s["profundidadDespues"] for s in explicado["historia"] if s["framebuffer"] == 0][-1:]
        lejos += ((hondo, grises[y * ancho + x]) for hondo in hondos)
    if ancho <= ANCHO and quedan.get(("la ventana", "miniatura"), final) != final:
        fallos.append("la última imagen no es la que se ve")
    if [gris for _, gris in sorted(lejos)] != sorted(gris for _, gris in lejos):
        fallos.append(f"no es más claro lo que está más lejos: {sorted(lejos)}")
    return [f"{programa.nombre}, a {talla}: {fallo}" for fallo in fallos]


def al_azar(de, cuantos, golden):
    """El último, donde cambia el color, que es donde se confunde de quién es."""
    azar = random.Random(de)
    *puntos, (x, y) = [(azar.randrange(ANCHO), azar.randrange(ALTO)) for _ in range(cuantos)]
    fila = pixeles(golden)[3 * ANCHO * y :] if golden else b""
    bordes = [i for i in range(1, ANCHO) if fila[3 * i :][:3] != fila[3 * i - 3 :][:3]]
    return [*puntos, (min(bordes, key=lambda i: abs(i - x), default=x), y)]


def main():
    lee = argparse.ArgumentParser()
    lee.add_argument("raiz")
    lee.add_argument("build", type=Path)
    lee.add_argument("programas", nargs="*")
    lee.add_argument("--pixeles", type=int, default=3)
    lee.add_argument("--casos", action="store_true")
    lee.add_argument("--enlace", default="")
    pedido = lee.parse_args()
    build, nombres = pedido.build.absolute(), pedido.programas
    elegidos = [p for p in catalogo.lee_programas(build) if not p.consola and (not nombres or p.nombre in nombres)]
    usado = (build / "sin_ventana").read_text().strip()
    por_enlace = {pedido.enlace or usado: elegidos}
    if not pedido.enlace and (build / "egl").is_dir():
        por_enlace.setdefault("egl", elegidos[::10])
    cuantos = None if pedido.casos else 1
    trabajos = [(enlace, c) for enlace, suyos in por_enlace.items() for p in suyos for c in p.casos[:cuantos]]
    with ThreadPoolExecutor(os.cpu_count()) as hilos:
        de_casos = hilos.map(lambda t: fallos_de_caso(build, *t, pedido.pixeles), trabajos)
        de_tallas = hilos.map(lambda t: fallos_de_imagenes(build, *t), itertools.product(elegidos[::10], TALLAS))
        fallos = [fallo for suyos in (*de_casos, *de_tallas) for fallo in suyos]
    print("\n".join(fallos))
    print(f"{len(trabajos)} cuadros, {len(trabajos) * pedido.pixeles} píxeles, {len(fallos)} fallos")
    return bool(fallos or not trabajos)


if __name__ == "__main__":
    sys.exit(main())
