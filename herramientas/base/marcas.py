"""Los ejercicios que se hacen dentro de un fichero del laboratorio: lo que hay que escribir va entre dos marcas, con
lo que pide.

    // L5.2: el color del vértice: phong, en su punto y con su normal
    nuevoColor = phong(material, La, luz, P.xyz, N * vNormal);
    // de partida: nuevoColor = material.Ka * La;
    // fin de L5.2

El punto de partida de quien lo hace es el mismo fichero sin lo de en medio, salvo lo que dice «de partida», si hace
falta algo en su lugar. En uno de quien enseña (ejercicios/propios.py), en vez del código va el nombre de su carpeta.

marcas.py RAÍZ CARPETA: deja en CARPETA los shaders de RAÍZ, con todos sus ejercicios por hacer.
"""
import difflib
import re
import sys
from pathlib import Path

TROZO = re.compile(
    r"^(?P<abre> *// (?P<codigo>[EL]\d+\.\d+|[a-z0-9_]+): (?P<pide>.+)\n)"
    r"(?P<hecho>(?:.*\n)*?)"
    r"(?P<cierra> *// fin de (?P=codigo)\n)",
    re.MULTILINE,
)
PARTIDA = re.compile(r"^( *)// de partida: (.+\n)", re.MULTILINE)


def fin_de_nadie(texto, codigo):
    """(línea, cómo está escrito) del comentario más parecido a «// fin de CODIGO» que no cierra nada, o None."""
    debe = f"// fin de {codigo}"
    abiertos = re.findall(r"^[ \t]*// (\S+): ", texto, re.M)
    hay = {}
    for n, renglon in enumerate(texto.splitlines(), 1):
        escrito = renglon.strip()
        if re.match(r"/[/*]?\s*fin\b", escrito, re.I) and escrito not in [f"// fin de {c}" for c in abiertos]:
            hay.setdefault(escrito, n)
    return next(((hay[e], e) for e in difflib.get_close_matches(debe, hay, 1, 0.7)), None)


def que_piden(textos):
    """Cada ejercicio de esos ficheros, con lo que pide en cada uno."""
    piden = {}
    for fichero, texto in textos.items():
        for trozo in TROZO.finditer(texto):
            piden.setdefault(trozo["codigo"], {})[fichero] = trozo["pide"]
    return piden


def esqueleto(texto, *codigos):
    """El fichero con esos ejercicios por hacer; sin decir cuáles, todos."""

    def vacia(trozo):
        if codigos and trozo["codigo"] not in codigos:
            return trozo[0]
        partida = "".join(sangria + linea for sangria, linea in PARTIDA.findall(trozo["hecho"]))
        return trozo["abre"] + (partida or "\n") + trozo["cierra"]

    return TROZO.sub(vacia, texto)


def ocultos(raiz):
    """Los que las páginas no enseñan resueltos: los códigos de RAÍZ/ocultos.txt, si está."""
    lista = raiz / "ocultos.txt"
    return re.sub("#.*", "", lista.read_text()).split() if lista.exists() else []


def publico(raiz, fichero):
    """Lo que se enseña de un fuente."""
    suyos = ocultos(raiz)
    texto = (raiz / fichero).read_text()
    return esqueleto(texto, *suyos) if suyos else texto


def main():
    raiz, carpeta = map(Path, sys.argv[1:])
    for shader in raiz.glob("c*/**/*.*"):
        if shader.suffix in (".vert", ".frag", ".glsl"):
            destino = carpeta / shader.relative_to(raiz)
            destino.parent.mkdir(parents=True, exist_ok=True)
            destino.write_text(esqueleto(shader.read_text()))


if __name__ == "__main__":
    main()
