"""En qué línea de un programa está lo que llama a OpenGL. De cada llamada hay una pila (herramientas/explica/pila.h),
que son direcciones del ejecutable: qué función y qué línea son lo dice addr2line, que viene con g++."""
import re
from pathlib import Path

DIRECCIONES = 4000  # por las que se pregunta, como mucho
SIN_NOMBRE = re.compile(r"operator\(\)|\{lambda|_FUN\b")


def pregunta(ejecutable, pilas):
    """Lo que hay que ejecutar: de cada dirección escribe la función y el sitio, y de las que van dentro de otra."""
    todas = sorted({d for pila in pilas for d in pila["llamadas"]})[:DIRECCIONES]
    return ["addr2line", "-Cfia", "-e", ejecutable, *map(hex, todas)]


def nombre_de(funcion):
    """Sin parámetros ni plantillas; nada, si no lo tiene."""
    if SIN_NOMBRE.search(funcion):
        return ""
    funcion = funcion.replace("(anonymous namespace)::", "")
    while (sin := re.sub("<[^<>]*>", "", funcion)) != funcion:
        funcion = sin
    return (funcion.partition("(")[0].split() or [""])[-1]


def lee(respuesta):
    """{dirección: [(función, ruta, línea)…]}, de dentro a fuera."""
    dichas, marcos, funcion = {}, [], None
    for renglon in respuesta.splitlines():
        if re.fullmatch("0x[0-9a-f]{1,16}", renglon):
            marcos, funcion = dichas.setdefault(int(renglon, 16), []), None
        elif funcion is None:
            funcion = nombre_de(renglon)
        else:
            ruta, _, linea = re.sub(r" \(discriminator \d+\)$", "", renglon).rpartition(":")
            marcos.append((funcion, ruta, int(linea) if linea.isdigit() else 0))
            funcion = None
    return dichas


def sitio(marcos, es_suyo):
    """De una pila, de dentro a fuera, la línea del fuente del programa desde la que se llama, con las funciones en que
    está, de fuera a dentro, hasta la primera que no es suya, o ninguna; y cuál de ellas es la que se llama ahí."""
    suyos = [i for i, (_, ruta, linea) in enumerate(marcos) if linea and es_suyo(ruta)]
    if not suyos:
        return None
    es = next((i for i in suyos if marcos[i][1].endswith(".cpp")), suyos[0])  # y no en una cabecera a que llama
    ajeno = [suyos[0] - 1] if suyos[0] and not marcos[suyos[0] - 1][1].startswith("/usr/") else []
    cadena = [(i, marcos[i][0]) for i in [*reversed(suyos), *ajeno] if marcos[i][0]]
    cadena = [par for k, par in enumerate(cadena) if not k or par[1] != cadena[k - 1][1]]
    llama = next((funcion for i, funcion in cadena if i < es), "")
    nombres = [funcion for _, funcion in cadena]
    if len(nombres) > 1 and nombres[0] == "main":
        del nombres[0]
    _, ruta, linea = marcos[es]
    dice = f"{Path(ruta).name}:{linea}" + (", " + " → ".join(nombres) if nombres else "")
    return {"ruta": ruta, "linea": linea, "llama": llama, "dice": dice}


def sitios(pilas, respuesta, es_suyo):
    """El de cada pila, o None."""
    dichas = lee(respuesta)
    return [sitio([m for d in pila["llamadas"] for m in dichas.get(d, [])], es_suyo) for pila in pilas]
