"""De qué ficheros está hecho un programa: los que nombra cada uno, y un shader con lo que incluye ya dentro. Todas
las rutas, desde RAÍZ.

fuentes.py RAÍZ CARPETA: deja en CARPETA cada shader de RAÍZ con lo que incluye ya dentro: ch01_intro-figura.vert
"""
import re
import sys
from pathlib import Path

SHADERS = ".vert", ".frag", ".glsl"
NOMBRADO = re.compile(r'"([\w./]+\.(?:h|cpp|vert|frag|glsl))"')
INCLUYE = re.compile(r'[ \t\v\f]*#include[ \t\v\f]*"([^"]+)"[ \t\v\f]*$')  # de GLSL, como lo hace common/shader.cpp
COMENTARIO = re.compile(r"//[^\n]*|/\*.*?(\*/|\Z)", re.S)
LINEAS, HONDO = 20000, 8  # de un shader con lo que incluye


def nombra(raiz, fichero):
    """Los que ese nombra entre comillas, cabeceras y shaders, a su lado o, de los capítulos, desde RAÍZ."""
    for nombre in NOMBRADO.findall((raiz / fichero).read_text()):
        for candidato in (fichero.parent / nombre, Path(nombre)):
            suyo = candidato.parent == fichero.parent and fichero.parts[0] != "common"
            if (suyo or candidato.parts[0].startswith("ch")) and (raiz / candidato).is_file():
                yield candidato


def alcanza(raiz, *ficheros):
    """Esos, los que nombran, y así con cada uno, en ese orden."""
    vistos = {}

    def ve(fichero):
        if fichero not in vistos:
            vistos[fichero] = True
            for otro in nombra(raiz, fichero):
                ve(otro)

    for fichero in ficheros:
        ve(fichero)
    return list(vistos)


def en_lineas(texto):
    texto = (texto if "\n" in texto else texto.replace("\r", "\n")).removeprefix("\ufeff")
    return [linea.rstrip("\r") for linea in texto.removesuffix("\n").split("\n")] if texto else []


def con_sitios(lee, shader):
    """(fichero, número, texto) de cada línea de un shader con lo que incluye ya dentro, hasta un límite, que lo puede
    haber escrito otro y no acabar nunca. De lo que se incluye, lee() da el fichero y su texto."""
    salen, quedan = [], LINEAS

    def pon(nombre, hondo):
        nonlocal quedan
        fichero, texto = lee(nombre)
        lineas = en_lineas(texto)
        codigo = COMENTARIO.sub(lambda m: re.sub(".", " ", m[0]), "\n".join(lineas)).split("\n")
        for numero, (linea, suyo) in enumerate(zip(lineas, codigo), 1):
            quedan -= 1
            if quedan < 0:
                return
            if hondo and suyo.strip() and (incluye := INCLUYE.match(linea)):
                pon(incluye[1], hondo - 1)
            else:
                salen.append((fichero, numero, linea))

    pon(shader, HONDO)
    return salen


def con_inclusiones(raiz, shader, textos=None):
    """Su texto, con el de cada #include en su sitio. De los que estén en TEXTOS vale ese, y no el del fichero."""

    def lee(fichero):
        return fichero, (textos or {}).get(fichero) or (raiz / fichero).read_text()

    return "".join(f"{linea}\n" for *_, linea in con_sitios(lee, str(shader)))


def main():
    raiz, carpeta = map(Path, sys.argv[1:])
    for shader in raiz.glob("c*/**/*.*"):
        if shader.suffix in (".vert", ".frag"):
            ruta = shader.relative_to(raiz)
            (carpeta / "-".join(ruta.parts)).write_text(con_inclusiones(raiz, ruta))


if __name__ == "__main__":
    main()
