"""Guiones como listas de órdenes: lo que se les puede quitar o repetir sin saber de qué programa son."""
import re


def sin_veces(orden):
    """«tecla d ×7» es «tecla d», y de lo del ratón basta qué es."""
    palabras = re.sub(" ×\\d+$", "", orden).split()
    return " ".join(palabras) if palabras[0] in ("tecla", "especial", "menu") else palabras[0]


TECLAS = {"IZQUIERDA": "←", "DERECHA": "→", "ARRIBA": "↑", "ABAJO": "↓", "PuntoYComa": ";", "Espacio": "espacio"}
TECLAS |= {",": "coma", ".": "punto"}  # entre otras no se verían


def en_palabras(orden):
    """Lo que hace una persona: de «tecla d ×7», «pulsa d 7 veces»."""
    una, _, veces = orden.partition(" ×")
    que, *resto = una.split()
    if que in ("tecla", "especial"):
        return f"pulsa {TECLAS.get(resto[0], resto[0])}" + (f" {veces} veces" if veces else "")
    if que == "boton":
        boton, como, *donde = resto
        return f"{'pulsa' if como == 'abajo' else 'suelta'} el botón {boton.lower()} en {', '.join(donde)}"
    if que == "menu":
        return f"elige en el menú {' → '.join(una.partition(' ')[2].split('/'))}"
    hace = {
        "arrastra": "arrastra hasta {}, {}",
        "mueve": "lleva el ratón a {}, {}",
        "rueda": "gira la rueda {} en {}, {}",
        "tamano": "pon la ventana a {} × {}",
        "espera": "espera {} ms",
    }
    return hace[que].format(*resto) if que in hace else una


def enumera(cosas):
    return " y ".join(filter(None, (", ".join(cosas[:-1]), *cosas[-1:])))


def en_breve(guion, orbita=False):
    """Lo que hace una persona, sin los píxeles: de «tecla 1; tecla m ×2; arrastra 9 9», «pulsa 1 y m 2 veces;
    arrastra». ORBITA: si es lo que hace el ratón."""
    hace = [("", [])]  # cada cosa que se hace seguida, y a qué
    boton = ""

    def anade(que, a_que=""):
        if que != hace[-1][0]:
            hace.append((que, []))
        hace[-1][1].extend(filter(None, [a_que]))

    for orden in filter(None, map(str.strip, guion.split(";"))):
        una, _, veces = orden.partition(" ×")
        que, *resto = una.split()
        if que in ("tecla", "especial"):
            anade("pulsa", TECLAS.get(resto[0], resto[0]) + (f" {veces} veces" if veces else ""))
        elif que == "menu":
            anade("elige en el menú", una.partition(" ")[2].replace("/", " → "))
        elif que == "espera" and resto != ["0"]:
            anade("espera", f"{float(resto[0]) / 1000:g} s")
        elif que == "boton" and resto[1] == "abajo":
            boton = "" if resto[0] == "IZQUIERDO" else f" con el botón {resto[0].lower()}"
            anade(f"haz clic{boton}")
        elif que == "arrastra":
            if hace[-1][0].startswith("haz clic"):
                hace.pop()
            anade(f"arrastra{boton or ' para orbitar' * orbita}")
        elif que == "mueve":
            anade("mueve el ratón")
        elif que == "rueda":
            anade("gira la rueda", "hacia delante" if resto[0].startswith("+") else "hacia atrás")
    return "; ".join(f"{que} {enumera(a_que)}".rstrip() for que, a_que in hace[1:])


def menos_veces(orden):
    """La misma orden, repetida menos veces: de menos a más."""
    una, por, n = orden.rpartition(" ×")
    if not por or not n.isdigit():
        return []
    veces = sorted({1, 2, int(n) // 4, int(n) // 2} - {0, int(n)})
    return [f"{una} ×{v}" if v > 1 else una for v in veces]


def acorta(ordenes, falla, intentos):
    """Las menos órdenes con las que aún falla(ordenes), que con todas falla (delta debugging); después, repetidas
    menos veces. Como mucho se prueba esas veces."""

    def prueba(candidatas):
        nonlocal intentos
        intentos -= 1
        return intentos >= 0 and falla(candidatas)

    ordenes = tuple(ordenes)
    if len(ordenes) > 1 and prueba(ordenes[-1:]):  # casi siempre basta la última
        ordenes = ordenes[-1:]
    trozos = 2
    while len(ordenes) > 1 and intentos > 0:
        largo = -(-len(ordenes) // trozos)
        quitadas = (ordenes[:i] + ordenes[i + largo :] for i in range(0, len(ordenes), largo))
        menos = next((q for q in quitadas if prueba(q)), None)
        if menos is not None:
            ordenes, trozos = menos, max(trozos - 1, 2)
        elif largo == 1:
            break
        else:
            trozos = min(2 * trozos, len(ordenes))
    for i, orden in enumerate(ordenes):
        candidatas = ((*ordenes[:i], menos, *ordenes[i + 1 :]) for menos in menos_veces(orden))
        ordenes = next((c for c in candidatas if prueba(c)), ordenes)
    return ordenes
