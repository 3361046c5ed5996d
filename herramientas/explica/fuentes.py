"""De qué fichero, y de qué línea de él, es cada línea de un shader que OpenGL recibe con los #include ya puestos."""
import os
from pathlib import Path

from base.fuentes import con_sitios


def carpetas(raiz):
    """Donde buscan los programas: antes en $LAB_RAIZ."""
    return [*(Path(c) for c in os.environ.get("LAB_RAIZ", "").split(":") if c), raiz]


def lineas(donde, fichero):
    """Las de ese shader, con lo que incluye en su sitio: (fichero, número, texto). Ninguna si no está."""

    def lee(nombre):
        ruta = next((c / nombre for c in donde if (c / nombre).is_file()), None)
        return nombre, ruta.read_text(errors="replace") if ruta else ""

    return con_sitios(lee, fichero)


def situa(lineas_, fuente):
    """A cada cosa que pasa en una línea de un shader, de qué fichero es y cuál es en él; `en`, la del shader entero."""
    return [{**cosa, "en": cosa["linea"], **sitio(fuente, cosa["linea"])} for cosa in lineas_]


def sitio(fuente, numero):
    suya = fuente[numero - 1] if 0 < numero <= len(fuente) else {"fichero": "", "linea": numero}
    return {"fichero": suya["fichero"], "linea": suya["linea"]}


def de_sospechas(sospechas, ordenes, programas):
    """De la que es de una línea de un shader, cuál es: el sitio de la sospecha, y no el de su orden."""
    for sospecha in (s for s in sospechas if s.get("linea")):
        programa = next(o["programa"] for o in ordenes if o["n"] == sospecha["orden"])
        fuente = next(p for p in programas if p["programa"] == programa)[sospecha["etapa"]]
        suya = sitio(fuente, sospecha["linea"])
        nombre = Path(suya["fichero"]).name
        dice = f"{nombre}:{suya['linea']}" if nombre else f"la línea {suya['linea']} del shader"
        sospecha["sitio"] = {"dice": dice, "texto": fuente[sospecha["linea"] - 1]["texto"].strip()}


def reconoce(raiz, programas):
    """Añade a cada programa de dónde sale cada línea de sus shaders. Devuelve el nombre de cada fragment shader."""
    donde = carpetas(raiz)
    hay = {}
    for carpeta in donde:
        for f in sorted({*carpeta.glob("*.*"), *carpeta.glob("c*/**/*.*")}):
            if f.suffix in (".vert", ".frag"):
                suyas = lineas(donde, str(f.relative_to(carpeta)))
                hay.setdefault(tuple(texto for *_, texto in suyas), suyas)
    nombres = {}
    for programa in programas:
        for etapa in ("vert", "frag"):
            textos = programa.get(etapa, "").splitlines()
            suyas = hay.get(tuple(textos)) or [("", n, texto) for n, texto in enumerate(textos, 1)]
            programa[etapa] = [{"fichero": f, "linea": n, "texto": texto} for f, n, texto in suyas]
        nombres[programa["programa"]] = Path(programa["frag"][-1]["fichero"]).name if programa["frag"] else ""
    return nombres
