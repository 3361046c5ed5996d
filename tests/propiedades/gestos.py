"""Lo que se cumple con un gesto: corto, en ventanas de otra forma; y largo, hasta su tope."""
from mandos import GOLDEN, TOPES
from programa import arrastre, distintos
from vista import FORMAS

LEJOS = 2000  # píxeles: más allá de cualquier tope
PASO, PASOS = 4, 7  # píxeles, y cuántos, con que se vuelve de un tope
CERCA = 12  # píxeles de lo pulsado a un extremo de lo que se pinta
SALTO = 100  # de cada mil colores, los que cambian de más en un paso


def gestos(p):
    """El mismo gesto, medido en el alto de 4:3 que cabe en la ventana, deja lo mismo en una de cualquier forma: cada
    arrastre y, donde se editan puntos, cada flecha."""
    if "arrastre" not in p.rasgos or p.cualquiera:
        return
    hechos = [arrastre(60, 45, 78, 36, b) for b in (["IZQUIERDO"] if p.opciones else ["IZQUIERDO", "DERECHO"])]
    if {"especial ARRIBA", "tecla n"} <= {*p.teclas}:
        hechos += [["tecla n", flecha] for flecha in ("especial DERECHA", "especial ARRIBA")]
    guion = ["escala {} {}".format(*FORMAS[0]), "captura", *(o for gesto in hechos for o in (*gesto, "captura"))]
    tallas = [f"{ancho}x{alto}" for ancho, alto in FORMAS]
    vistas = [p.vistas(guion, talla=talla, LAB_SIN_ENCIMA="rotulo") for talla in tallas]
    (antes, *esta), *otras = [[v.centro(*FORMAS[0]) for v in suyas] for suyas in vistas]
    for talla, (nada, *otra) in zip(tallas[1:], otras):
        for gesto, una, suya in zip(hechos, esta, otra):
            if distintos(antes, nada, 3) <= 1 < distintos(una, suya, 3):
                yield gesto[-1].split()[1], f"a {talla}, «{'; '.join(gesto)}» no hace lo que a 4:3"
                break


def topes(p):
    """Arrastrado hasta el tope de arriba o de abajo, de él no se pasa y se vuelve poco a poco: si se pasa del polo, la
    vertical da media vuelta. A los lados no hay tope, salvo donde lo dice topes.tsv."""
    if "arrastre" not in p.rasgos or p.cualquiera:
        return
    lleva = "boton IZQUIERDO abajo 60 45", "boton IZQUIERDO arriba 60 45"
    for hacia, lado in (1, "derecha"), (-1, "izquierda"):
        pasos = [f"arrastra 60 {45 + hacia * (LEJOS - PASO * i)}" for i in (1, *range(PASOS + 1))]
        de_lado = [f"arrastra {60 + hacia * (LEJOS + PASO * i)} 45" for i in range(2)]
        guion = [o for orden in (lleva[0], *pasos, *de_lado) for o in (orden, "captura")]
        antes, *vistas = [v.centro(*v.talla) for v in p.vistas([*guion, lleva[1]], LAB_SIN_ENCIMA="1")]
        una, otra, *vistas, ultima, aun_mas = vistas
        if antes != una != otra:
            yield "tope", f"con «{pasos[0]}» no se ha llegado al tope: con «{pasos[1]}» se mueve"
        if vistas[-1] != ultima and (ultima == aun_mas) != (f"{p.nombre}\tarrastra {lado}" in TOPES):
            yield "tope", f"hacia «{lado}» {'' if ultima == aun_mas else 'no '}hay tope, y {GOLDEN.name} dice otra cosa"
        cambian = [distintos(a, b) for a, b in zip([otra, *vistas], vistas)]
        if any(b > 3 * max(a, c) + SALTO for a, b, c in zip(cambian, cambian[1:], cambian[2:])):
            yield "salto", f"al volver poco a poco de donde lleva «{pasos[1]}» hay un salto: {cambian}"


def pulsado(p):
    """Si al pulsar aparece algo pintado encima, está donde se ha pulsado."""
    for x, y in ((60, 9), (31, 70)) if {"raton", "arrastre"} & p.rasgos else ():
        pulsa = [f"boton IZQUIERDO {como} {x} {y}" for como in ("abajo", "arriba")]
        nada, vista = p.vistas(["captura", *pulsa, "captura"])
        nuevos = [punto for pintado in vista.encima if pintado not in nada.encima for punto in pintado.puntos]
        if nuevos and not any(abs(px - x) < CERCA and abs(vista.talla[1] - py - y) < CERCA for px, py in nuevos):
            yield "sitio", f"pulsado en ({x}, {y}), lo que aparece está en {nuevos}"


def cifras(p):
    """Cada modo enseña lo mismo cuando se llega de los de antes y de los de después, y otra vez desde sí."""
    suyas = [tecla for tecla in p.teclas if tecla[:-1] == "tecla " and tecla[-1].isdigit()]
    guion = [o for tecla in (*suyas, *reversed(suyas)) for o in (tecla, "captura")]
    vistas = p.vistas(guion) if len(suyas) > 1 else []
    for tecla, ida, vuelta in zip(suyas, vistas, reversed(vistas)):
        if distintos(ida.centro(*ida.talla), vuelta.centro(*vuelta.talla)) > 1:
            yield tecla, "no deja lo mismo si se viene de otra"
