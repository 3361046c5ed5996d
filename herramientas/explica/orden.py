"""orden.py RAÍZ BUILD DESTINO CAPÍTULO PROGRAMA NOMBRE TÍTULO [X Y] [opciones]: ejecuta ese programa sin ventana con lo
que explica un cuadro puesto delante de OpenGL (entrada.cpp), lo dice en pocas palabras y deja DESTINO/NOMBRE.html.

X Y es un píxel, como los da el ratón; sin él, el cuadro entero. --json FICHERO deja ahí lo mismo en datos. Las demás
opciones, -guion y -geometry, son del programa.
"""
import json
import math
import os
import re
import sys
import tempfile
from pathlib import Path

from base import llamadas, paginas, procesos
from base.procesos import Fallo, escribe, principal
from explica import fuentes, palabras, png

PLANTILLA = Path(__file__).with_name("explica.html")
SEGUNDOS = 300
SEGUIDOS = 3  # texels de texturas que se pintan en el mismo cuadro
DEL_PROGRAMA = "-guion", "-geometry"
DE_NADIE = "common", "glut", "herramientas", "build"  # lo que en la raíz no es un programa


def opciones(palabras_):
    """El píxel («240,140» o nada), el fichero de --json y lo que va al programa."""
    numeros, fichero, suyas = [], "", []
    resto = iter(palabras_)
    for palabra in resto:
        if palabra in (*DEL_PROGRAMA, "--json"):
            valor = next(resto, "")
            if not valor:
                raise Fallo(f"explica: falta lo que sigue a {palabra}")
            if palabra == "--json":
                fichero = valor
            else:
                suyas += [palabra, valor]
        elif re.fullmatch("[0-9]{1,5}", palabra) and len(numeros) < 2:
            numeros.append(palabra)
        else:
            raise Fallo(f"explica: no entiendo «{palabra}»; es ./lab explica PROGRAMA [X Y], con los píxeles del ratón")
    if len(numeros) == 1:
        raise Fallo(f"explica: con la X, {numeros[0]}, falta la Y")
    return ",".join(numeros), fichero, suyas


def ejecuta(build, ejecutable, pixel, suyas, textura=""):
    """Lo que cuenta de su cuadro; con `textura`, solo de ese texel suyo."""
    with tempfile.TemporaryDirectory() as carpeta:
        hecho, delante = Path(carpeta, "cuadro.json"), Path(carpeta, "explica.so")
        delante.symlink_to(build / "herramientas/explica/libexplica.so")  # LD_PRELOAD no admite blancos
        entorno = {
            **os.environ,
            "LD_PRELOAD": " ".join([*os.environ.get("LD_PRELOAD", "").split(), "./explica.so"]),
            "LAB_EXPLICA": hecho.name,
            "LAB_EXPLICA_PIXELES": pixel,
            "LAB_EXPLICA_IMAGENES": "0" if textura else "1",
            "LAB_EXPLICA_TEXTURA": textura,
        }
        orden, error = [ejecutable, *suyas, "-ppm", "cuadro.ppm"], []
        try:
            procesos.ejecuta(orden, env=entorno, cwd=carpeta, timeout=SEGUNDOS, text=True)
        except Fallo as fallo:
            if not hecho.exists():
                raise
            dice = f"el programa acaba mal: {str(fallo).splitlines()[-1]}"
            error = [{"orden": 0, "dice": dice, "prueba": "Mira lo que se dice antes."}]
        if not hecho.exists():
            raise Fallo("explica: el programa acaba antes de que se pueda explicar su cuadro: ¿pulsa Esc el guion?")
        cuadro = json.loads(hecho.read_text(errors="replace"))  # con sus shaders, que pueden no estar en UTF-8
        return {**cuadro, "sospechas": cuadro["sospechas"] + error}


def pon_sitios(raiz, cuadro, ejecutable):
    """A cada orden y a cada uniform, la línea del programa en que se llama a OpenGL, con su texto."""
    pilas, textos = cuadro.pop("pilas"), {}
    respuesta = procesos.lanza(llamadas.pregunta(ejecutable, pilas), timeout=SEGUNDOS, text=True).stdout

    def es_suyo(ruta):
        return not ruta.startswith("/usr/") and not any(Path(ruta).is_relative_to(raiz / de) for de in DE_NADIE)

    def texto(ruta, linea):
        fichero = Path(ruta)
        if ruta not in textos:
            textos[ruta] = fichero.read_text(errors="replace").splitlines() if fichero.is_file() else []
        return next(iter(textos[ruta][linea - 1 : linea]), "").strip()

    todos = llamadas.sitios(pilas, respuesta, es_suyo)
    for cosa in (c for o in cuadro["ordenes"] for c in (o, *o.get("cableado", {}).get("uniformes", []))):
        numero = cosa.pop("pila")
        if numero >= 0 and (suyo := todos[numero]):
            cosa["sitio"] = {**suyo, "texto": texto(suyo["ruta"], suyo["linea"])}


def texels(cuadro, explicado):
    """De cada textura que lee quien gana y que se ha pintado antes en ese cuadro, el texel de en medio de los que más
    pesan en cada lectura; y quién la lee: (textura, (x, y), orden)."""
    sombreado = explicado.get("sombreado", {})
    pesan = {}
    for lectura in (suya for suya in sombreado.get("lecturas", []) if not suya["motivo"]):
        texel = max(lectura["texels"], key=lambda t: t["peso"])
        pintan = [o for o in cuadro["ordenes"] if o["pinta"] == lectura["textura"] and o["n"] < sombreado["orden"]]
        if pintan and texel["nivel"] == 0 and min(texel["texel"]) >= 0:
            pesan.setdefault(lectura["textura"], []).append(texel["texel"])
    for textura, suyos in pesan.items():
        medio = [sum(v) / len(suyos) for v in zip(*suyos)]
        yield textura, min(suyos, key=lambda t: math.dist(t, medio)), sombreado["orden"]


def sigue(cuadro, explicado, pregunta):
    """Los texels que lee, explicados como un píxel más de ese cuadro; y los que leen ellos. `pregunta` da uno."""
    hechos, quedan = [], [*texels(cuadro, explicado)]
    while quedan and len(hechos) < SEGUIDOS:
        textura, donde, orden = quedan.pop(0)
        [suyo] = pregunta("{},{}".format(*donde), f"{textura},{orden}")["pixeles"]
        hechos.append({**suyo, "textura": textura, "lee": orden})
        quedan += texels(cuadro, suyo)
    return hechos


def completa(raiz, cuadro, nombre, titulo, suyas):
    """Con los ficheros de que sale cada shader, las miniaturas en PNG y, arriba, lo del píxel."""
    de_orden = fuentes.reconoce(raiz, cuadro["programas"])
    for orden in cuadro["ordenes"]:
        for que in ("miniatura", "profundidad", "plantilla"):
            if que in orden:
                orden[que] = png.en_url(**orden[que])
        if "programa" in orden:
            orden["frag"] = de_orden[orden["programa"]]
    fuentes.de_sospechas(cuadro["sospechas"], cuadro["ordenes"], cuadro["programas"])
    cuadro["veces"]["imagen"] = png.en_url(**cuadro["veces"]["imagen"]) if cuadro["veces"] else None
    [pixel] = cuadro.pop("pixeles") or [{"pixel": None, "color": None, "historia": []}]
    for texel in cuadro["texels"]:
        texel["lineas"] = lineas(cuadro, texel.get("sombreado"))
    return {
        "programa": nombre,
        "titulo": titulo,
        "opciones": suyas,
        **pixel,
        "lineas": lineas(cuadro, pixel.get("sombreado")),
        **cuadro,
    }


def lineas(cuadro, sombreado):
    """Lo que vale cada cosa en el fragmento que gana, con su fichero y su línea; de paso, en sus vértices."""
    if not sombreado or "fragmento" not in sombreado:
        return []
    programa = next(o["programa"] for o in cuadro["ordenes"] if o["n"] == sombreado["orden"])
    suyo = next(p for p in cuadro["programas"] if p["programa"] == programa)
    for etapa, trazas in (("frag", [sombreado["fragmento"]]), ("vert", sombreado["vertices"])):
        for traza in trazas:
            for que in ("lineas", "sinSeguir"):
                traza[que] = fuentes.situa(traza[que], suyo[etapa])
    sombreado["lecturas"] = fuentes.situa(sombreado["lecturas"], suyo["frag"])
    return sombreado["fragmento"]["lineas"]


def main():
    raiz, build, destino, capitulo, programa, nombre, titulo, *resto = sys.argv[1:]
    raiz, build, destino = Path(raiz), Path(build), Path(destino)
    pixel, fichero, suyas = opciones(resto)
    ejecutable = build / (build / "sin_ventana").read_text().strip() / capitulo / programa
    cuadro = ejecuta(build, ejecutable, pixel, suyas)
    [explicado] = cuadro["pixeles"] or [{}]
    pregunta = lambda texel, textura: ejecuta(build, ejecutable, texel, suyas, textura)
    cuadro["texels"] = sigue(cuadro, explicado, pregunta)
    pon_sitios(raiz, cuadro, ejecutable)
    cuadro = completa(raiz, cuadro, nombre, titulo, suyas)
    if pixel and any(n >= largo for n, largo in zip(cuadro["pixel"], cuadro["talla"])):
        raise Fallo("explica: {} {} está fuera de la ventana, de {}×{}".format(*cuadro["pixel"], *cuadro["talla"]))
    pagina = destino / f"{nombre}.html"
    escribe(pagina, paginas.plantilla(PLANTILLA).render(cuadro=cuadro))
    if fichero:
        escribe(Path(fichero), json.dumps(cuadro, ensure_ascii=False, indent=1) + "\n")
    print(palabras.cuadro(cuadro))
    print(f"Hecha: {pagina}", file=sys.stderr)


if __name__ == "__main__":
    principal(main)
