"""Una corrección, o las de una clase, como se escriben: en texto, para VPL, en JUnit, en una tabla y en una página.
Todo lo que en ella hay ya está limpio (lector.limpio)."""
import csv
import html
import io
import os
import re
from contextlib import suppress
from pathlib import Path
from xml.sax.saxutils import quoteattr

from markupsafe import Markup

from base import guiones, paginas


def lineas(c):
    """Lo que hay que decirle a quien la entregó. De cada guion que falla, dónde, si no se ha dicho ya."""
    frases, dichos = [*c["dice"]], []
    for fallo in c["fallos"]:
        frases.append(fallo["que"])
        if (donde := fallo["donde"]) and donde["dice"] not in dichos:
            frases.append(en_donde(fallo))
            dichos.append(donde["dice"])
    return [*frases, *por_piezas(c), *c.get("avisos", [])] or ["todo bien"]


FUERA = "lo que falla está fuera de ellas, o en cómo se juntan"


def por_piezas(c):
    """De dónde sale la nota, si no es 100 y no es solo lo entero; y si lo es, por qué."""
    if c.get("entero"):
        return [f"la nota es la de lo entero, y no pieza a pieza: {c['entero']}"]
    partes = [f"«{corta(p['pide'])}», {cuanto(p['nota'])}" for p in c.get("piezas", ())]
    return [f"pieza a pieza: {'; '.join(partes + [FUERA] * todas_bien(c))}"] if partes else []


def todas_bien(c):
    return all(p["nota"] == 100 for p in c["piezas"])


def corta(frase, letras=60):
    return frase if len(frase) <= letras else f"{frase[:letras].rpartition(' ')[0]}…"


def cuanto(nota):
    return "bien" if nota == 100 else f"{nota:g} de 100"


def en_donde(fallo):
    donde = fallo["donde"]
    pixel = "; es en el píxel ({}, {}) de la ventana de {}×{}" if donde["pixel"] else ""
    return f"lo primero que se aparta: {donde['dice']}{pixel.format(*donde['pixel'] or (), *donde['ventana'])}"


ORDEN = re.compile("«((?:tecla|especial|boton|arrastra|mueve|rueda|menu|tamano) [^»]+)»")


def en_html(frase):
    """Para quien no sabe cómo se escribe un guion: sus órdenes, en palabras, y lo que es código, como código."""

    def en_palabras(orden):
        with suppress(ValueError, IndexError):  # no lo es, que lo ha escrito alguien
            return f"«{guiones.en_palabras(orden[1])}»"
        return orden[0]

    return Markup(re.sub("`([^`]+)`", r"<code>\1</code>", html.escape(ORDEN.sub(en_palabras, frase))))


def para_verlo(c, suya):
    """Con qué orden se explica dónde falla la de mios/SUYA."""
    ordenes = [f["donde"]["explica"] for f in c["fallos"] if suya and f["donde"]]
    return f"./lab explica mios/{suya} {ordenes[0]}".strip() if ordenes else ""


def en_texto(c, suya=""):
    ver = para_verlo(c, suya)
    frases = "\n".join(f"  {linea}" for linea in (*lineas(c), *([f"para verlo por dentro: {ver}"] if ver else ())))
    cuantos = f"{c['bien']} de {c['guiones']} guiones; semilla {c['semilla']}"
    return f"{c['entrega']}, {c['ejercicio']}: {c['nota']:g} de 100 ({cuantos})\n{frases}\n  reglas: {c['reglas']}"


def en_vpl(c):
    """Como lo lee el Virtual Programming Lab de Moodle: los comentarios y, la última, la nota, en la escala que tenga
    la actividad."""
    desde, hasta = (float(os.environ.get(f"VPL_GRADE{que}") or vale) for que, vale in (("MIN", 0), ("MAX", 100)))
    titulo = f"-{c['ejercicio']}: {c['bien']} de {c['guiones']} guiones, semilla {c['semilla']}"
    comentarios = [f"Comment :=>>{linea}" for linea in (titulo, *lineas(c), f"Reglas: {c['reglas']}")]
    return "\n".join([*comentarios, f"Grade :=>> {desde + (hasta - desde) * c['nota'] / 100:.5g}"])


def en_junit(correcciones):
    """Una prueba por entrega, que falla si no está todo bien."""
    pruebas = []
    for c in correcciones:
        mal = "" if c["nota"] == 100 else f"<failure message={quoteattr('; '.join(lineas(c)))}/>"
        clase, nombre = f"corrige.{c['ejercicio']}", quoteattr(c["entrega"])
        pruebas.append(f'  <testcase classname="{clase}" name={nombre}>{mal}</testcase>')
    fallan = sum(c["nota"] < 100 for c in correcciones)
    suma = f'<testsuite name="corrige" tests="{len(correcciones)}" failures="{fallan}">'
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', suma, *pruebas, "</testsuite>\n"])


def celda(texto):
    """La de una tabla: si empieza como una fórmula, que no lo sea."""
    return "'" + texto if texto[:1] in tuple("=+-@") else texto


def en_csv(correcciones):
    """Como se abre al pulsarlo en una hoja de cálculo en castellano: dice que está en UTF-8, y lleva punto y coma, que
    la coma es de los decimales."""
    tabla = io.StringIO()
    filas = csv.writer(tabla, delimiter=";")
    filas.writerow(["entrega", "ejercicio", "nota", "bien", "guiones", "semilla", "dice", "reglas"])
    for c in correcciones:
        numeros = (f"{c['nota']:g}".replace(".", ","), c["bien"], c["guiones"], c["semilla"])
        filas.writerow([celda(c["entrega"]), c["ejercicio"], *numeros, celda("; ".join(lineas(c))), c["reglas"]])
    return f"\ufeff{tabla.getvalue()}"


def plantilla():
    return paginas.plantilla(Path(__file__).with_name("corrige.html"))


def pagina(c, programa, ref, suya="", quien="", de=None):
    """La de una corrección, con todo dentro. SUYA: su carpeta de mios/, si la corrige quien la lee. DE: la plantilla,
    si se hacen muchas."""
    datos = {"suya": suya, "quien": quien or c["entrega"], "programa": programa, "ref": ref}
    datos |= {"en_donde": en_donde, "ver": para_verlo(c, suya), "en_palabras": guiones.en_palabras, "en_html": en_html}
    datos |= {"por_piezas": por_piezas, "todas_bien": todas_bien, "cuanto": cuanto, "FUERA": FUERA}
    return (de or plantilla()).render(c=c, **datos)
