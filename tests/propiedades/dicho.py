"""Lo que se cumple en lo que un programa dice: los títulos, los rótulos y lo que escribe."""
import re

# −0, lo que no es un número, unos paréntesis vacíos, un separador al final o tras otro; y en un título, que es un
# renglón y no una columna ni una matriz, un blanco de más o un separador al principio.
MAL = r"(?<![\d.])[-−]0(\.0+)?(?![\d.])|\b(nan|inf)\b|\( *\)|[+,·]$|[+,:·] ?[+,·]|�"
MAL_ROTULO, MAL_TITULO = re.compile(MAL, re.A), re.compile(MAL + r"|  |^[ +,:·]|[ :]$|: ?:", re.A)
NUMERO = r"\d+(?:\.\d+)?"


def numeros_de(lineas):
    """Los que hay en esas líneas, y cuántos hay en cada lista: «5, 6» son dos, y «ninguna», cero."""
    listas = [linea.rpartition(":")[2].split(",") for linea in lineas]
    cuantos = {"0" if "ningun" in lista[0] else str(len(lista)) for lista in listas}
    return cuantos.union(re.findall(NUMERO, " ".join(lineas)))


def dicho(p):
    """De todo lo que se ha hecho con él hasta ahora."""
    for fila in {f.titulo: f for filas in p.diarios for f in filas}.values():
        if MAL_TITULO.search(fila.titulo):
            yield "título", f"título mal escrito: «{fila.titulo}»"
    for texto in sorted(p.rotulos):
        lineas = texto.split("\\n")  # lo que hace cada tecla, en la segunda columna de F1, se parte por donde cabe
        if not lineas[0].startswith("  ") and (mal := next(filter(MAL_ROTULO.search, lineas), None)):
            yield "rótulo", f"rótulo mal escrito: «{mal}»"
    for antes, fila in ((a, b) for filas in p.diarios for a, b in zip(filas, filas[1:])):
        if fila.escrito and fila.titulo != antes.titulo:
            sobran = set(re.findall(NUMERO, fila.titulo)) - numeros_de(fila.escrito)
            if sobran:
                yield "números", f"el título, «{fila.titulo}», dice {sobran}, que no es lo que escribe: {fila.escrito}"
                break
    for primera, fila in ((filas[0], f) for filas in p.diarios for f in filas):
        if fila.imagen == primera.imagen and fila.titulo.startswith(primera.titulo + ":"):
            yield "primero", f"el primer título, «{primera.titulo}», no dice el estado, «{fila.titulo}»"
            break
