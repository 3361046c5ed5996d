#!/usr/bin/env python3
"""propiedades.py RAÍZ BUILD PROGRAMA… [--ordenes N] [--semilla N] [--solo PROPIEDAD]: lo que todo programa cumple,
sin escribir nada para ninguno. Lo que se puede hacer con él lo dice su línea «// Controles:», y lo que ha pasado, su
diario (-ayuda).

Lo que un programa no cumple está en EXCEPCIONES con su motivo; una que ya no haga falta también es un fallo.
"""
import argparse
import itertools
import random
import re
import shlex
import sys
from pathlib import Path

from dados import dados
from dicho import dicho
from estropeados import estropeados
from gestos import cifras, gestos, pulsado, topes
from mandos import comparacion, comunes, limites, mandos, nombres, raras, vuelta
from programa import TALLA, Programa, Termina, arrastre
from tiempo import conmuta, lento, pausa
from rotulos import rotulos, tapan
from vista import arrastres, cerca, foto, franja, modelo, tallas, tocado
from base import catalogo, controles, guiones

TAMANOS = ["120 90", "150 90", "100 100", "61 45", "4 90", "1 1", "200 2"]
BYTES = 64 << 20  # lo que cabe en la GPU más modesta con otros programas abiertos
INTENTOS = 100  # de acortar un guion que falla


def guion_al_azar(p):
    """Sucesos suyos, con tamaños, F5 y teclas que no son suyas entre ellos."""
    azar = random.Random(f"{p.nombre} {p.semilla}")
    guion = []
    while len(guion) < p.ordenes:
        guion += controles.sucesos_al_azar(azar, p.controles, p.rasgos, p.opciones, 120, 90)
        cual = azar.random()
        if cual < 0.3 and p.ajenas:
            guion.append(azar.choice(p.ajenas))
        elif cual < 0.4:
            guion += [f"tamano {azar.choice(TAMANOS)}", "especial F5"]
    return guion


def del_paso(p, orden, antes, fila, temporizadores):
    """Lo que no debe pasar tras ninguna orden."""
    if fila.repetida:
        yield "repetir", "el mismo cuadro dibujado otra vez es distinto"
    if fila.cambiado:
        yield "estado", f"el cuadro no deja OpenGL como estaba: {fila.cambiado}"
    if orden == "especial F5" and fila.distinta(antes) and not p.cualquiera:
        yield "F5", "releer lo mismo cambia algo"
    if orden == "especial F5" and fila.objetos != antes.objetos:
        yield "objetos", f"releer lo mismo deja otros objetos: {antes.objetos} → {fila.objetos}"
    if orden in p.ajenas and fila.distinta(antes):
        yield "ajena", f"«{orden}» hace algo y no está en «// Controles:»"
    if fila.bytes > BYTES:
        yield "bytes", f"ocupa {fila.bytes} bytes"
    if fila.temporizadores > max(temporizadores, 1):
        yield "temporizadores", f"esperan {fila.temporizadores} temporizadores"


def del_guion(p, guion):
    """En qué y cuál: lo que va mal al jugarlo, en una ventana de float, donde ningún color deja de ser un número."""
    try:
        filas = p.diario(guion, **p.finitos)
    except Termina as error:
        return {"termina": error}
    p.titulo = filas[0].titulo
    pasos = zip(["", *guion], filas[:1] + filas, filas)
    hallados = [del_paso(p, *paso, filas[0].temporizadores) for paso in pasos]
    return dict(itertools.chain.from_iterable(hallados))


def paseo(p):
    """Sucesos al azar. De lo que va mal, con las menos órdenes con las que aún lo va."""
    guion = guion_al_azar(p)
    for en_que in del_guion(p, guion):

        def minimo():
            corto = guiones.acorta(guion, lambda menos: en_que in del_guion(p, menos), INTENTOS)
            como = f"DISPLAY= ./lab ver {p.nombre} -geometry {TALLA} -diario -guion {shlex.quote('; '.join(corto))}"
            return f"{del_guion(p, corto)[en_que]}\n  {como}"

        yield en_que, minimo


def rondas(p):
    """Los objetos de OpenGL son los mismos tras una ronda de todo que tras tres, y con lo mismo a la vista ocupan lo
    mismo."""
    ronda = [*p.mandos, "tamano 150 90", *p.mandos[::-1], "especial F5", "tamano 120 90", "especial F5"]
    if "arrastre" in p.rasgos:
        ronda += arrastre(40, 30, 70, 52)
    quieta = ["tamano 150 90", "especial F5", "tamano 120 90", "especial F5"]
    filas = p.diario(ronda * 3 + quieta * 2)
    una, tres = filas[len(ronda)], filas[3 * len(ronda)]
    if una.objetos != tres.objetos:
        son = "buferes texturas programas shaders framebuffers renderbuffers vaos"
        yield "objetos", f"tras una ronda hay {una.objetos} ({son}) y tras tres {tres.objetos}"
    antes, despues = filas[-1 - len(quieta)].bytes, filas[-1].bytes
    if antes != despues:
        yield "bytes", f"cambiar de tamaño y releer ocupa más cada vez: {antes} y {despues} bytes"


PROPIEDADES = paseo, nombres, raras, limites, comparacion, vuelta, tallas, franja, rotulos, tapan, cerca, arrastres
PROPIEDADES += tocado, pausa, lento, conmuta, modelo, foto, rondas, comunes, mandos, cifras, gestos, topes, pulsado
PROPIEDADES += estropeados, dados, dicho  # dicho mira lo de los demás
SORTEADA = tapan  # sin --todo se pide una parte, y una excepción puede no hacer falta

# (programa, propiedad, en qué, expresión regular): por qué no
EXCEPCIONES = {
    ("primer_programa", "paseo", "repetir|ajena|F5"): "i solo cambia el color de borrado: se ve al borrar otra vez",
    ("primer_programa", "comunes", "F1|F2|-ayuda|F12|argumentos"): "no usa common/: lo suyo sería más largo que él",
    ("primer_programa", "vuelta", "tecla d"): "dibuja otra vez lo mismo, que es lo que enseña",
    ("primer_programa", "vuelta", "tecla i"): "cambia lo que se verá al dibujar, que es lo que enseña",
    ("primer_programa", "tallas", "tecla i, tecla [ds]"): "lo mismo: se ve al borrar otra vez",
    ("shader_basico", "comunes", "F1|F2|-ayuda|F12|argumentos"): "tampoco: es el listado del libro",
    ("shader_basico", "estropeados", "F3"): "es el listado del libro: no vigila",
    ("errores_shader", "estropeados", "F[35]"): "enseña los errores de unos shaders estropeados",
    ("errores_shader", "paseo", "F5"): "releer vuelve a escribir el error, o que no lo hay",
    ("giro_eje", "topes", "tope"): "el ratón no orbita: lleva el eje, sin fin",
    ("tiras", "cifras", "tecla ."): "la malla que trae tiene dos tiras: las demás cifras dejan lo que había",
    ("varias_luces", "cifras", "tecla ."): "cada luz se enciende y se apaga",
    ("tiras", "mandos", "tecla [3-9]"): "la malla que trae tiene dos tiras: son para la del usuario",
    ("eventos", "comunes", "F1"): "también enseña esa tecla",
    ("eventos", "tallas", "talla"): "escribe el tamaño de cada suceso",
    ("materiales", "vuelta", "tecla t"): "vuelve a todos: con n se ve uno",
    ("captura", "vuelta", "tecla g"): "vuelve a guardar lo mismo",
    ("captura", "tallas", "talla|tecla g, .*"): "lo guardado es de cuando se guardó",
    ("morphing", "pausa", "título"): "así empieza: lo que se ve es que t no cambia",
    ("continuidad", "pausa", "título"): "así empieza: lo que se ve es que u no cambia",
    ("superficie_bezier", "tallas", "tecla [mf], tecla [-+]"): "cambian una cosa distinta en cada modo",
    ("shader_basico", "franja", ""): "el listado del libro no mira la forma de la ventana",
    ("figura_color", "franja", ""): "el cuadrado ocupa lo que puede",
    ("bump", "franja", "|tecla b"): "la ampliación va en una esquina de la ventana",
    ("zbuffer", "franja", "tecla c"): "la imagen hecha en la CPU se estira hasta llenar la ventana",
    ("profundidad", "franja", "tecla [23]"): "lo que se ve es el error de la profundidad, que cambia con el píxel",
    ("sombras", "franja", "tecla [opws]"): "sin desplazamiento ni plantilla, los planos que coinciden se mezclan",
    ("sombreado", "franja", "|tecla [123]"): "en una ventana alta se reparten de otra manera",
    ("repeticion", "franja", "|tecla [1234]"): "el dibujo llena la ventana",
    ("espejo_plantilla", "franja", "|tecla p"): "en una ventana ancha se ve de más cerca",
    ("camara", "tapan", "tapa [pS]"): "«p» está en la cámara, que es lo que nombra, y «S», junto a ella, en su flecha",
    ("captura", "franja", "tecla [gadqews]"): "lo guardado es de cuando se guardó",
    ("ampliacion", "tapan", "tapa .*"): "el rótulo de una imagen va sobre ella, que con × 1 llena la ventana",
    ("objeto_animado", "tapan", "tapa [XZ]"): "el avión pasa por delante de los ejes en que se mueve",
    ("ampliacion", "franja", "|tecla [-+fr]"): "amplía los píxeles de la ventana",
    **{
        (nombre, "franja", "tecla r"): "una foto ocupa lo que puede: su forma no es 4:3"
        for nombre in "efectos remolino mezcla diferencia convolucion convolucion_variable volteo".split()
    },
    **{
        (nombre, "foto", "foto"): "pega la foto en algo, que no está entero o tiene otra forma"
        for nombre in "textura_objeto repeticion filtrado coordenadas textura_ondulada".split()
    },
    **{
        (nombre, "cerca", "plano"): "un punto que se lleva hacia la cámara llega más cerca que la superficie"
        for nombre in "superficie_hermite superficie_bezier".split()
    },
    ("ampliacion", "foto", "foto"): "amplía los píxeles de la ventana: su foto se dibuja dos veces",
    ("primer_programa", "dicho", "primero"): "con s la imagen no cambia hasta que se dibuja, y es lo que enseña",
    ("profundidad", "dicho", "números"): "el título da el cociente, y lo escrito, los dos planos",
    ("temporizador", "lento", "hora"): "cuenta los disparos, y en uno lento son menos: es lo que enseña",
}


def comprueba(p, solo):
    fallos = []
    for propiedad in PROPIEDADES:
        nombre = propiedad.__name__
        if solo and nombre not in solo.split(","):
            continue
        admitidos = {clave[2] for clave in EXCEPCIONES if clave[:2] == (p.nombre, nombre)}
        sobran = set(admitidos)
        try:
            for en_que, que in propiedad(p):
                suyas = {a for a in admitidos if re.fullmatch(a, en_que)}
                sobran -= suyas
                if not suyas:
                    fallos.append(f"{p.nombre}, {nombre}: {que() if callable(que) else que}")
        except Termina as error:
            fallos.append(f"{p.nombre}, {nombre}: {error}")
        if propiedad == SORTEADA and not p.todo:
            continue
        fallos += [f"{p.nombre}, {nombre}: ya cumple «{a}» y sigue en EXCEPCIONES" for a in sobran]
    print("\n".join(fallos[:20]) + ("\n…" if len(fallos) > 20 else ""))
    return bool(fallos)


def main():
    lee = argparse.ArgumentParser()
    lee.add_argument("raiz", type=Path)
    lee.add_argument("build", type=Path)
    lee.add_argument("programas", nargs="*")
    lee.add_argument("--ordenes", type=int, default=50)
    lee.add_argument("--semilla", type=int, default=1)
    lee.add_argument("--solo")
    lee.add_argument("--todo", action="store_true", help="cada tecla, y no unas al azar")
    opciones = lee.parse_args()
    opciones.raiz, opciones.build = opciones.raiz.resolve(), opciones.build.resolve()
    todos = [p for p in catalogo.lee_programas(opciones.build) if not p.consola]
    elegidos = [Programa(p, opciones) for p in todos if not opciones.programas or p.nombre in opciones.programas]
    sys.exit(any([comprueba(p, opciones.solo) for p in elegidos]))


if __name__ == "__main__":
    main()
