"""Lo que se le da a quien aprende (./lab nuevo, que es reparte.py): una carpeta, MIOS/NOMBRE. Con un ejercicio (E3.5, o
la carpeta de uno de quien enseña: propios.py), su esqueleto: los ficheros de la solución sin lo que se pide, que dicen
las marcas (base/marcas.py). Con un programa, una copia para jugar con ella."""
import hashlib
import re
import shutil
from pathlib import Path

from base import catalogo, controles, fuentes, libro, marcas, paginas
from base.procesos import Fallo
from ejercicios import propios, reglas

# en la carpeta: «E3.5 ch03_transformaciones/grua», o solo el programa si no se corrige
EJERCICIO = propios.EJERCICIO
DE_PARTIDA = "partida"  # y en su segunda línea, el punto de partida que se dio


def version(de_partida):
    """La de un punto de partida: si cambia, es otra."""
    return hashlib.sha1(repr(sorted(de_partida.items())).encode()).hexdigest()[:12]


def deja(texto, referencia=""):
    """Un fuente sin lo que pide ese ejercicio. De los demás, o de todos si no es ninguno, desaparecen las marcas y se
    queda lo suyo."""

    def trozo(marcado):
        if marcado["codigo"] == referencia:
            return marcas.esqueleto(marcado[0], referencia)
        return marcas.PARTIDA.sub("", marcado["hecho"])

    return marcas.TROZO.sub(trozo, texto)


def pide(texto, referencia):
    """Lo que dicen sus marcas que va en cada sitio."""
    return [marcado["pide"] for marcado in marcas.TROZO.finditer(texto) if marcado["codigo"] == referencia]


def suyos(raiz, programa):
    """Su fuente, su cabecera y sus shaders; de uno propio, todo lo suyo."""
    return [f.name for f in programa.ficheros(raiz) if f.suffix in propios.DADOS]


def del_capitulo(raiz, programa):
    """Los ficheros de su capítulo que usa, cada uno con su texto."""
    partida = [programa.carpeta / f for f in suyos(raiz, programa)]
    usa = [f for f in alcanzados(raiz, programa, *partida) if f.suffix != ".cpp" or f in partida]
    return {f.name: propios.lee_texto(raiz / f) for f in usa}


def alcanzados(raiz, programa, *ficheros):
    return [f for f in fuentes.alcanza(raiz, *ficheros) if f.parent == programa.carpeta]


def de_la_carpeta(raiz, programa, referencia=""):
    """Los que van a la carpeta de quien aprende: los suyos, los marcados o, si no es un ejercicio, sus shaders, y los
    que llevan de unos a otros, que si no incluirían los del capítulo."""
    textos = del_capitulo(raiz, programa)

    def es_propio(fichero):
        return bool(pide(textos[fichero], referencia)) if referencia else fichero.endswith((".vert", ".frag"))

    propios = {*suyos(raiz, programa), *filter(es_propio, textos)}

    def lleva(fichero):
        return any(f.name in propios for f in alcanzados(raiz, programa, programa.carpeta / fichero))

    return {f: textos[f] for f in sorted(textos) if lleva(f)}


def aqui(textos, programa):
    """Los mismos, con los shaders que van con ellos buscados al lado."""
    capitulo = programa.capitulo.nombre
    nuevos = {}
    for fichero, texto in textos.items():
        for otro in textos:
            texto = texto.replace(f'"{capitulo}/{otro}"', f'"{otro}"')
        nuevos[fichero] = texto.replace(f'"{capitulo}"', '""')  # shader_basico, que no usa common/
    return nuevos


def textos(raiz, programa, referencia):
    """Los ficheros que tiene quien lo hace, enteros: de uno de la página, solo los que se piden."""
    return (pedidos if es_de_shaders(referencia) else de_la_carpeta)(raiz, programa, referencia)


def sin_marcas(ficheros, programa, referencia="", por_hacer=""):
    """Esos ficheros como le llegan, con lo que pide ese ejercicio por hacer."""
    hechos = {f: deja(texto, por_hacer) for f, texto in ficheros.items()}
    return hechos if es_de_shaders(referencia) else aqui(hechos, programa)


def esqueleto(raiz, programa, referencia):
    """De cada fichero, su texto sin lo que se pide; del principal, tampoco lo que cuenta del resultado."""
    ficheros = sin_marcas(textos(raiz, programa, referencia), programa, referencia, referencia)
    principio = f"// {programa.titulo}: {como_se_llama(referencia)}, que cuenta ENUNCIADO.md.\n"
    if (principal := programa.fuente.name) in ficheros:
        ficheros[principal] = re.sub(r"\A(?:// (?!Controles: ).*\n)+", principio, ficheros[principal])
    return ficheros


def solucion(raiz, programa, referencia=""):
    """Los mismos, enteros."""
    return sin_marcas(textos(raiz, programa, referencia), programa, referencia)


def como_se_llama(referencia):
    return f"el {libro.nombre(referencia)}" if es_del_libro(referencia) else "el ejercicio"


def es_del_libro(referencia):
    return bool(re.fullmatch(r"E\d+\.\d+", referencia))


def es_de_shaders(referencia):
    """Los de la página: se piden dentro de unos shaders, y solo ellos se entregan."""
    return bool(re.fullmatch(r"L\d+\.\d+", referencia))


def pedidos(raiz, programa, referencia):
    """Los ficheros en que está lo que se pide, por su ruta, enteros."""
    return {str(f): (raiz / f).read_text() for f in privados(raiz, programa, referencia)}


def shaders(raiz):
    todos = [f for tipo in fuentes.SHADERS for f in raiz.glob(f"ch*/*{tipo}")]
    return [(f.relative_to(raiz), f.read_text()) for f in sorted(todos)]


def privados(raiz, programa, referencia):
    """Los ficheros del laboratorio en que está lo que se pide. Los de la página pueden ser de otro que los carga."""
    if es_de_shaders(referencia):
        return [f for f, texto in shaders(raiz) if pide(texto, referencia)]
    return [
        programa.fuente.with_name(f) for f, texto in del_capitulo(raiz, programa).items() if pide(texto, referencia)
    ]


def ejercicios(raiz, programas):
    """El programa de cada ejercicio que se puede corregir: los que tienen alguna marca."""
    return {r: p for p in programas for r in p.referencias if (es_del_libro(r) or p.raices) and privados(raiz, p, r)}


def encabezado(raiz, programa, referencia):
    """Lo que se pide: del libro, en nuestras palabras; de uno propio, en las de su ENUNCIADO.md."""
    if es_del_libro(referencia):
        cosa = next(c for c in libro.cosas(raiz) if c.codigo == referencia)
        return f"# Ejercicio {referencia[1:]}: {cosa.que}\n\n{cosa.enunciado}"
    suyo = programa.carpeta / propios.ENUNCIADO
    if not suyo.is_file():
        raise Fallo(f"nuevo: falta {suyo}, que es lo que se le da a quien lo hace")
    return propios.lee_texto(suyo).strip()


def enunciado(raiz, programa, referencia, nombre, ficheros):
    textos = del_capitulo(raiz, programa)
    piden = {f: pide(textos[f], referencia) for f in ficheros}
    incluyen = {h for f in piden if piden[f] for h in re.findall(r'^#include "(.+)"$', textos[f], re.MULTILINE)}
    huecos = [(f"{nombre}.cpp" if f == programa.fuente.name else f, que) for f in piden for que in piden[f]]
    return paginas.plantilla(Path(__file__).with_name("enunciado.md")).render(
        encabezado=encabezado(raiz, programa, referencia),
        referencia=referencia,
        reglas=reglas.del_programa(programa),
        programa=programa,
        nombre=nombre,
        huecos=huecos,
        con_shader=any(f.endswith(fuentes.SHADERS) for f, _ in huecos),
        dados=", ".join(f"`{h}`" for h in sorted(incluyen - {*ficheros})),
        imagen_de=imagen_de,
        controles=[c.texto for c in controles.lee(raiz, programa)],
    )


def imagen_de(caso):
    """Cómo se llama, en esperado/, la de adónde hay que llegar: la de otro caso, de otra manera."""
    llamadas = []
    for otro in caso.programa.casos:
        suya = re.sub("[^a-z0-9]+", "_", catalogo.llano(otro.titulo or "al abrirlo")).strip("_") or "caso"
        while suya in llamadas:
            suya += "_otro"
        llamadas.append(suya)
        if otro is caso:
            return f"{suya}.png"


def ejercicio_pedido(pedido, hay):
    """De cualquiera de las maneras en que se dice uno de esos ejercicios, su referencia; un número, el del libro."""
    escritas = pedido, catalogo.abrevia(pedido).upper(), f"E{pedido}"
    return next((e for e in escritas if e in hay), escritas[1])


def elige(raiz, programas, pedido):
    """La referencia, vacía si no es un ejercicio, y el programa."""
    hay = ejercicios(raiz, programas)
    referencia = ejercicio_pedido(pedido, hay)
    if referencia in hay:
        return referencia, hay[referencia]
    if re.fullmatch(r"E?\d+\.\d+", referencia) and not any(p.es(pedido) for p in programas):
        raise Fallo(f"nuevo: no hay ejercicio «{pedido}»; se corrigen {', '.join(hay)}")
    elegidos = catalogo.resuelve(programas, pedido)
    if len(elegidos) > 1:
        raise Fallo(f"nuevo: «{pedido}» son varios programas; elige uno: {', '.join(p.nombre for p in elegidos)}")
    if es_de_shaders(referencia) and privados(raiz, elegidos[0], referencia):
        raise Fallo(
            f"nuevo: {referencia} se hace en la página, que lo da empezado: ./lab web, y después "
            f"web/index.html#ejercicio/{referencia}; ./lab nuevo {elegidos[0].nombre} da una copia del programa"
        )
    if elegidos[0].raices:
        raise Fallo(f"nuevo: en {elegidos[0].carpeta} no hay nada entre «// {pedido}: …» y «// fin de {pedido}»")
    if referencia in elegidos[0].referencias and referencia.startswith("E") and not referencia.startswith("EC"):
        raise Fallo(
            f"nuevo: el {libro.nombre(referencia)} no tiene programa que corregir; para jugar con el que más "
            f"se le acerca, ./lab nuevo {elegidos[0].nombre}. Se corrigen {', '.join(hay)}"
        )
    return "", elegidos[0]


def carpeta_de(raiz, programa, referencia, nombre):
    """Los ficheros de la carpeta de quien lo hace o, si no es un ejercicio, de la copia."""
    textos = esqueleto(raiz, programa, referencia) if referencia else solucion(raiz, programa)
    origen = f"{programa.capitulo.nombre}/{programa.nombre}"
    ficheros = {f"{nombre}.cpp" if f == programa.fuente.name else f: texto for f, texto in textos.items()}
    ficheros[EJERCICIO] = f"{referencia} {origen}\n".lstrip()
    if referencia:
        ficheros[EJERCICIO] += f"{DE_PARTIDA} {version(textos)}\n"
        ficheros[propios.ENUNCIADO] = enunciado(raiz, programa, referencia, nombre, textos)
    return ficheros


def crea(raiz, programas, mios, pedido, nombre="", con=lambda carpeta: None):
    """MIOS/NOMBRE, entera o nada, CON lo que se le añada."""
    referencia, programa = elige(raiz, programas, pedido)
    nombre = nombre or programa.nombre
    if not re.fullmatch("[a-z0-9_]+", nombre):
        raise Fallo(f"nuevo: «{nombre}» no vale de nombre: solo minúsculas sin acento, cifras y _")
    carpeta = mios / nombre
    if carpeta.exists():
        raise Fallo(
            f"nuevo: ya existe {carpeta}, y no se toca: ponle otro nombre a la nueva, ./lab nuevo {pedido} NOMBRE"
        )
    ficheros = carpeta_de(raiz, programa, referencia, nombre)
    parcial = mios / f".{nombre}.parcial"
    shutil.rmtree(parcial, ignore_errors=True)
    try:
        parcial.mkdir(parents=True)
        for fichero, texto in ficheros.items():
            (parcial / fichero).write_text(texto)
        con(parcial)
        parcial.rename(carpeta)
    finally:
        shutil.rmtree(parcial, ignore_errors=True)
    return referencia, carpeta
