"""Lo que se cumple en cualquier ventana y con el ratón."""
import functools
import itertools
import os
import random
import re
import tempfile
import threading
from pathlib import Path

from programa import CONTRARIAS, TALLA, arrastre, distintos, lee_ppm, parecidas

OTRAS = ("1 1", "200 2", "100 130", "100 100")  # de la última solo cambia el alto, y encoge


def conmutan(p, una, otra):
    """Si da igual el orden de dos teclas, o manda la última."""
    (_, a, ab), (_, b, ba) = ([f.se_ve() for f in p.diario(par)] for par in ((una, otra), (otra, una)))
    relativa = any({una, otra} & set(c.ordenes) for c in p.controles if set(c.teclas) in CONTRARIAS)
    return ab == ba or (ab, ba) == (b, a) or (relativa and (ab == b or ba == a))


def eligen(p):
    """Los grupos de teclas que eligen entre sí; las cifras son uno, que suele empezar con 1."""
    sueltos = [c for c in p.controles if c.teclas and not c.termina and not {"↑", "v"} & set(c.teclas)]
    grupos = [c.ordenes for c in sueltos if set(c.ordenes) <= set(p.teclas)]
    cifras = [o for grupo in grupos for o in grupo if o[-1] in "234567890"]
    return [grupo for grupo in [*(g for g in grupos if not g[0][-1].isdigit()), cifras] if grupo]


def tallas(p):
    """Lo hecho en una ventana y llevado a otra es lo mismo que hecho en esa y en el orden contrario; o de dos teclas
    manda la última."""
    azar = random.Random(f"{p.nombre} {p.semilla}")
    final = OTRAS[-1].replace(" ", "x")
    guion = [azar.choice(grupo) for grupo in eligen(p)]
    mandan = [o for o in p.mandos if o == "tecla v" or o.startswith("menu ")]  # siempre al final
    bien = True
    for cola in [[], *([[azar.choice(mandan)]] if mandan else [])]:
        llevada = p.ventana([*guion, *cola, *(f"tamano {talla}" for talla in OTRAS)])
        if not parecidas(llevada, p.ventana([*guion[::-1], *cola], final)):
            bien = False
            if not parecidas(llevada, p.ventana([*guion, *cola], final)):
                con = "; ".join(guion + cola)
                yield "talla", f"una ventana de {TALLA} llevada a {OTRAS} no se ve como una de {final}, con {con}"
    for una, otra in () if bien else itertools.combinations(guion, 2):
        if not conmutan(p, una, otra):
            yield f"{una}, {otra}", f"de «{una}» y «{otra}», ni da igual el orden ni manda la última"


def arrastres(p):
    """Arrastrar en un paso o en tres, tocando mientras otro botón, deja lo mismo; y en horizontal, de una vez o
    soltando a la mitad."""
    if "arrastre" not in p.rasgos or p.cualquiera:
        return
    botones = ["IZQUIERDO"] if p.opciones else ["IZQUIERDO", "DERECHO"]  # el derecho abre el menú
    caminos = [(60, 45, 90, 60), (30, 60, 42, 30), (100, 45, 70, 60)]
    una = [o for boton in botones for puntos in caminos for o in arrastre(*puntos, boton)]
    tres = []
    for boton, puntos in itertools.product(botones, caminos):
        abajo, *resto = arrastre(*puntos, boton, 3)
        x, y = puntos[:2]
        tres += [abajo, f"boton CENTRAL abajo {x} {y}", f"boton CENTRAL arriba {x} {y}", *resto]
    for boton in [] if "clic" in p.dice else botones:  # pulsar otra vez elegiría otra cosa
        una += arrastre(40, 45, 80, 45, boton)
        tres += arrastre(40, 45, 60, 45, boton) + arrastre(60, 45, 80, 45, boton)
    if not parecidas(p.ventana(una), p.ventana(tres)):
        yield "pasos", f"arrastrar en uno o en tres pasos, o soltando a la mitad, no deja lo mismo: {'; '.join(una)}"


# Alta y ancha: su centro cae en los mismos cuartetos de píxeles que a 4:3.
FORMAS = [tuple(map(int, TALLA.split("x"))), (120, 602), (400, 90)]
MENUDAS = [(61, 45), (90, 200), (320, 60), (480, 360), (700, 150)]  # con la ayuda puesta


@functools.cache
def en_formas(p):
    """De cada tecla, la escena sola tras ella en cada forma; y lo que se ve con la ayuda en otras tallas."""
    mira = [[f"tamano {ancho} {alto}", "captura"] for ancho, alto in FORMAS + MENUDAS]
    una, menudas = sum(mira[: len(FORMAS)], []), sum(mira[len(FORMAS) :], [])
    guion = una + [o for tecla in p.teclas for o in (tecla, *una)] + ["especial F1", *menudas]
    vistas = p.vistas(guion, LAB_SIN_ENCIMA="1")
    n = len(FORMAS)
    return {tecla: vistas[n * i : n * (i + 1)] for i, tecla in enumerate(["", *p.teclas])}, vistas[-len(MENUDAS) :]


def franja(p):
    """Las escenas se componen para 4:3: en el centro de una ventana alta o ancha está lo mismo, píxel a píxel."""
    for tecla, vistas in en_formas(p)[0].items():
        if not all(v.entera() for v in vistas):  # partida, los paneles se colocan de otra manera
            continue
        esta, *otras = (v.centro(*FORMAS[0]) for v in vistas)
        for otra, (ancho, alto) in zip(otras, FORMAS[1:]):
            if (cuantos := distintos(esta, otra, 3)) > 1:
                yield tecla, f"tras «{tecla}», lo del centro de {ancho}×{alto} no es lo de 4:3: {cuantos:.0f} ‰"


def cerca(p):
    """De lo más cerca que lleva la rueda, desde cualquier lado, el plano de cerca no corta nada."""
    if "rueda" not in p.rasgos:
        return
    teclas = [tecla for grupo in eligen(p) for tecla in grupo]
    guion = ["rueda +1 60 45 ×20", "captura", *(o for tecla in teclas for o in (tecla, "captura"))]
    for sube in (-22, -19, 82):
        guion += [*arrastre(60, 45, 60, 45 + sube), "captura"]
        guion += [*arrastre(34, 45, 86, 45), "captura"] * 6
    for x, y in () if p.opciones else ((60, 22), (95, 45)):
        guion += [*arrastre(60, 45, x, y, "DERECHO"), "captura"]
    con, sin = (p.vistas(guion, *opciones, LAB_SIN_ENCIMA="1") for opciones in ((), ("-sin_planos",)))
    for i, (una, otra) in enumerate(zip(con, sin)):
        if (cuantos := distintos(una.centro(*una.talla), otra.centro(*otra.talla))) > 1:
            hasta = [n for n, o in enumerate(guion) if o == "captura"][i]
            ordenes = "; ".join(o for o in guion[:hasta] if o != "captura")
            yield "plano", f"el plano de cerca o el de lejos corta la escena: {cuantos:.0f} ‰ tras {ordenes}"
            return


def sigue(antes, despues, x, y):
    """Cómo de lejos de ahí queda lo más cercano de lo que ha cambiado, en píxeles; nada, si no ha cambiado nada."""
    habia = {(round(a), round(b)) for p in antes.encima for a, b in p.puntos}
    nuevos = [q for p in despues.encima for q in p.puntos if (round(q[0]), round(q[1])) not in habia]
    return min((max(abs(a - x), abs(b - y)) for a, b in nuevos), default=None)


def tocado(p):
    """Lo que se elige con un clic queda bajo el puntero, en una ventana de cualquier forma."""
    if "clic elige el" not in p.dice:
        return
    antes = [o for o in p.teclas if o == "tecla n"]  # donde se ve lo que se toca
    for (ancho, alto), con in itertools.product(((120, 90), (120, 200), (120, 120), (200, 112)), ((), ("tecla v",))):
        if set(con) - set(p.teclas):
            continue
        empieza = [*antes, *con]
        talla = f"{ancho}x{alto}"
        guion, adonde = [*empieza, "captura"], []
        rejilla = [(ancho * i / 6, alto * j / 6) for i in range(1, 6) for j in range(1, 6)]
        for x, y in rejilla:
            x, y = int(x), int(alto - y)
            adonde.append((x + 0.5, alto - y - 0.5))
            guion += [f"boton IZQUIERDO abajo {x} {y}", f"boton IZQUIERDO arriba {x} {y}", "captura", "captura"]
        vistas = p.vistas(guion, talla=talla, LAB_SIN_ENCIMA="1")
        lejos = [sigue(vistas[2 * i], vistas[2 * i + 1], *q) for i, q in enumerate(adonde)]
        hay = [d for d in lejos if d is not None]
        if not hay or max(hay) > 2:
            yield f"{ancho}x{alto} {con}", f"a {talla} {con} no queda bajo el puntero: {lejos}"


CUBO = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
CARAS = "1 2 4 3,5 7 8 6,1 5 6 2,3 4 8 7,1 3 7 5,2 6 8 4".split(",")


def modelo(p):
    """El mismo modelo en otro sitio o de otro tamaño (exactos en float) da la misma imagen."""
    if p.admite != "modelo":
        return
    imagenes = {}
    with tempfile.TemporaryDirectory() as carpeta:
        for escala, lejos in ((1, 0), (1, 2**23), (2.0**20, 0), (2.0**-20, 0)):
            vertices = [f"v {x * escala + lejos!r} {y * escala + lejos!r} {z * escala + lejos!r}" for x, y, z in CUBO]
            Path(carpeta, "cubo.vf").write_text("\n".join([*vertices, *(f"f {cara}" for cara in CARAS), ""]))
            p.ejecuta_en(carpeta, ["cubo.vf"])
            imagenes[escala, lejos] = Path(carpeta, "imagen.ppm").read_bytes().split(b"\n255\n", 1)[1]
    for (escala, lejos), imagen in imagenes.items():
        if distintos(imagen, imagenes[1, 0]) > 1:
            yield "modelo", f"un cubo de lado {escala} en {lejos} no se ve como uno de lado 1 en el origen"
    maximo = int(re.search(r"MAXIMO_NUMERADO = (\d+)", (p.raiz / "ch02_modelado/encuadre_malla.h").read_text())[1])
    for n in (maximo, maximo + 1):  # una tira de triángulos, con tantos vértices
        with tempfile.NamedTemporaryFile("w", suffix=".vf") as tira:
            triangulos = [f"f {i} {i + 1} {i + 2}" for i in range(1, n - 1)]
            tira.write("\n".join([*(f"v {i // 2} {i % 2} 0" for i in range(n)), *triangulos, ""]))
            tira.flush()
            (v,) = p.vistas(["captura"], tira.name)
        if any(q.texto.isdigit() for q in v.encima) != (n == maximo):
            yield "máximo", f"se numeran hasta {maximo} vértices, y con {n} no es así"


def foto(p):
    """Una foto, que llega por una tubería, ocupa los píxeles enteros más próximos a lo que mide a esa escala, y está en
    medio."""
    if not p.admite.startswith("imagen"):
        return
    ancho, alto, altos = 41, 30, range(60, 80)
    with tempfile.TemporaryDirectory() as carpeta:
        datos = b"P6\n%d %d\n255\n" % (ancho, alto) + bytes((200, 120, 40)) * ancho * alto
        fotos = [Path(carpeta, f"foto{i}.ppm") for i in range(2 if p.admite == "imagenes" else 1)]
        for foto in fotos:
            os.mkfifo(foto)
            threading.Thread(target=foto.write_bytes, args=(datos,), daemon=True).start()
        guion = [o for h in altos for o in (f"tamano 200 {h}", f"captura {carpeta}/{h}")]
        p.ejecuta([*map(str, fotos), "-guion", "; ".join(guion)])
        for h in altos:
            fila = lee_ppm(Path(carpeta, str(h)))[h // 2]
            puntos = [fila[i : i + 3] for i in range(0, len(fila), 3)]
            dentro = [x for x, punto in enumerate(puntos) if punto != puntos[0]]
            son, debe = dentro[-1] - dentro[0] + 1 if dentro else 0, int(ancho * h / alto + 0.5)
            if son != debe or dentro[0] != (200 - debe) // 2:
                yield "foto", f"de {ancho}×{alto} en 200×{h} ocupa {son} columnas y no {debe}"
                return
