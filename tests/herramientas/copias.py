"""Lo que hace quien copia: otros nombres, otro orden, otros comentarios y otros renglones. Cuáles son sus nombres no se
lo pregunta a quien busca parecidos (parecidos.py): los que van tras un tipo."""
import re

from base.fuentes import COMENTARIO

TIPOS = "float|int|auto|double|bool|unsigned|mat[234]|d?vec[234]|ivec[234]|size_t|string"
DECLARA = re.compile(rf"\b(?:{TIPOS})\b\s*&?\s+(\w+)\s*(?=[=;,)(:])")
TEXTO = re.compile(r"""("(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')""")
NOMBRES = "mi", "valor", "aux", "tmp", "el"
DICHOS = "ahora", "esto hace lo suyo", "no tocar"


def tras_un_tipo(todo):
    """Lo que declara y no es campo de nada."""
    return {n for n in DECLARA.findall(todo) if n != "main" and not re.search(rf"(?:\.|->)\s*{n}\b", todo)}


def otros_nombres(ficheros, azar):
    todo = COMENTARIO.sub("", "\n".join(ficheros.values()))
    return {n: f"{azar.choice(NOMBRES)}{azar.choice('ABCDEFG')}{i}" for i, n in enumerate(sorted(tras_un_tipo(todo)))}


def renombra(texto, otro):
    """Fuera de los textos, que en los índices impares no se tocan."""
    partes = TEXTO.split(texto)
    partes[::2] = [re.sub(r"(?<![\w.#])\w+\b", lambda m: otro.get(m[0], m[0]), p) for p in partes[::2]]
    return "".join(partes)


def declaraciones(texto):
    """Las de fuera de todo, cada una entera."""
    hay, una, hondo = [], [], 0
    for linea in texto.split("\n"):
        una.append(linea)
        hondo += linea.count("{") - linea.count("}")
        if not hondo and linea.rstrip().endswith((";", "}")):
            hay.append("\n".join(una))
            una = []
    return [*hay, "\n".join(una)]


def en_otro_orden(texto, azar):
    """Las funciones y las declaraciones, barajadas, y lo que se incluye."""
    lineas = texto.split("\n")
    directivas = [linea for linea in lineas if linea.startswith("#")]
    hay = declaraciones("\n".join(linea for linea in lineas if not linea.startswith("#")))
    azar.shuffle(hay)
    azar.shuffle(directivas)
    return "\n".join(directivas + hay)


def con_otros_comentarios(texto, azar):
    lineas = []
    for linea in filter(str.strip, texto.split("\n")):
        dice = f"  // {azar.choice(DICHOS)}" if azar.random() < 0.2 and linea[-1] != "\\" and linea[0] != "#" else ""
        lineas.append(linea if linea[0] == "#" else " " * azar.choice((1, 3, 8)) + linea.strip() + dice)
    return "\n".join(lineas) + "\n"


def copia(ficheros, azar, baraja=True):
    """BARAJA: también el orden, que puede no compilar."""
    otro, copiados = otros_nombres(ficheros, azar), {}
    for fichero, texto in ficheros.items():
        texto = renombra(COMENTARIO.sub("", texto), otro)
        if baraja and fichero.endswith((".h", ".cpp")):
            texto = en_otro_orden(texto, azar)
        copiados[fichero] = con_otros_comentarios(texto, azar)
    return copiados
