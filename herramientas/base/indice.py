"""El índice en que busca el buscador de las páginas (base/busca.mjs): lo que se dice de cada capítulo y de cada
programa, por zonas, y los identificadores de cada fuente."""
import html
import re
from pathlib import Path

from base import controles, fuentes, libro, marcas

SINONIMOS = Path(__file__).with_name("sinonimos.tsv")  # lo que se busca y no está escrito así en ningún sitio
APARTE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)  # comentarios y cadenas
PALABRA = re.compile(r"[A-Za-z_]\w{2,}")
ETIQUETA = re.compile(r"<[^>]+>")


def identificadores(texto):
    """Los del código, cada uno una vez."""
    return " ".join(dict.fromkeys(PALABRA.findall(APARTE.sub(" ", texto))))


def llano(en_html):
    return html.unescape(ETIQUETA.sub("", en_html))


def zonas(raiz, del_libro, programa):
    """Cada una, [qué es, a qué enlace lleva, su texto]; lo que vale cada clase lo dice busca.mjs."""
    suyo = programa.nombre
    yield "nombre", suyo, suyo
    yield "título", suyo, programa.titulo
    for codigo, que in del_libro.referencias(programa):
        yield "libro", codigo, que[:1].upper() + que[1:]
    for caso in programa.casos:
        yield "imagen", caso.fichero, ": ".join(filter(None, (caso.titulo, caso.mira)))
    yield "teclas", suyo, " · ".join(c.texto for c in controles.lee(raiz, programa))
    yield "explicación", suyo, del_libro.explicacion(programa)
    for codigo, enunciado, respuesta in del_libro.ejercicios(programa):
        yield "enunciado", codigo, llano(enunciado)
        yield "respuesta", codigo, llano(respuesta)
    for errata in del_libro.erratas_de(programa):
        yield "errata", suyo, llano(errata)


def hace(raiz, capitulos, del_libro):
    """Lo que la página lleva en JSON."""
    entradas, ficheros = [], {}
    for capitulo in capitulos:
        titulo = f"{capitulo.numero}. {capitulo.titulo}"
        suyas = [["capítulo", capitulo.nombre, f"{titulo} (capítulo {capitulo.numero})"]]
        suyas += [["errata", capitulo.nombre, llano(e)] for e in del_libro.otras_erratas(capitulo)]
        entradas.append({"titulo": titulo, "zonas": suyas, "fuentes": []})
        for p in capitulo.programas:
            suyos = [str(f) for f in fuentes.alcanza(raiz, p.fuente)]
            ficheros.update((f, identificadores(marcas.publico(raiz, f))) for f in suyos if f not in ficheros)
            con_texto = [z for z in zonas(raiz, del_libro, p) if z[2]]
            entradas.append({"titulo": p.titulo, "zonas": con_texto, "fuentes": suyos})
    sinonimos = {frase: otras for frases, otras in libro.filas(SINONIMOS) for frase in frases.split("|")}
    return {"entradas": entradas, "ficheros": ficheros, "sinonimos": sinonimos}
