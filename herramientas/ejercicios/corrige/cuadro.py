"""Lo que cuenta de su cuadro un programa al que se le pone delante herramientas/explica. Si el programa es de otro, lo
puede haber escrito él: se lee hasta un límite, y vale si todo es de lo que debe ser; de lo que sobra no queda nada."""
import json

DELANTE = "herramientas/explica/libexplica.so"
FICHERO = "cuadro.json"
BYTES = 8 << 20
LARGA = 1 << 20  # de un texto
RAROS = {"nan": float("nan"), "-nan": float("nan"), "inf": float("inf"), "-inf": float("-inf")}


# Un entero es el de una orden, una línea o una medida: -1, si no hay.
PASO = {"linea": int, "clase": str, "nombre": str, "tipo": str, "funcion": str, "valor": [float]}
TRAZA = {"lineas": [PASO]}
SUCESO = {
    "orden": int,
    "veredicto": str,
    "primitiva?": int,
    "tipo?": str,
    "color?": [float],
    "despues?": [float],
    "profundidadDespues?": float,
    "plantillaDespues?": float,
}
ATRIBUTO = {"nombre": str, "activo": bool, "bufer": int, "componentes": int, "suma": str}
UNIFORME = {"nombre": str, "tipo": str, "valor": [float], "pila": int}
TEXTURA = {
    "sampler": str,
    "unidad": int,
    "talla": [int],
    **{que: str for que in ("formato", "reduce", "amplia", "repite", "incompleta", "suma")},
}
CABLEADO = {"atributos": [ATRIBUTO], "uniformes": [UNIFORME], "texturas": [TEXTURA], "sumaIndices": str}
ORDEN = {
    "n": int,
    "pila": int,
    "llamada": str,
    "titulo": str,
    "framebuffer": str,
    "estado": [{"nombre": str, "valor": str}],
    "programa?": int,
    "fragmentos?": int,
    "cableado?": CABLEADO,
}
SOMBREADO = {"orden": int, "primitiva": int, "fragmento?": TRAZA, "vertices?": [{**TRAZA, "indice": int}]}
PIXEL = {"pixel": [int], "color": [float], "historia": [SUCESO], "sombreado?": SOMBREADO}
CUADRO = {
    "ordenes": [ORDEN],
    "programas": [{"programa": int, "vert?": str, "frag?": str}],
    "pixeles": [PIXEL],
    "pilas": [{"llamadas": [int]}],
}


def numero(que):
    if isinstance(que, str) and que in RAROS:
        return RAROS[que]
    if type(que) in (int, float) and abs(que) < 1e39:  # True no lo es
        return que
    raise ValueError


def cumple(que, forma):
    """Solo lo que dice la forma, o ValueError. Una clave con ? puede faltar, o ser nula: queda en None."""
    if forma is float:
        return numero(que)
    if type(que) is not (forma if isinstance(forma, type) else type(forma)):
        raise ValueError
    if forma is int and not -1 <= que < 1 << 31 or forma is str and len(que) >= LARGA:
        raise ValueError
    if isinstance(forma, type):
        return que
    if isinstance(forma, list):
        return [cumple(uno, forma[0]) for uno in que]
    hecho = {}
    for clave, suya in forma.items():
        nombre = clave.removesuffix("?")
        falta = nombre != clave and que.get(nombre) is None
        if not falta and nombre not in que:
            raise ValueError
        hecho[nombre] = None if falta else cumple(que[nombre], suya)
    return hecho


def lee(datos):
    """El cuadro, o None si no lo es."""
    if len(datos) > BYTES:
        return None
    try:
        return cumple(json.loads(datos), CUADRO)
    except (ValueError, RecursionError):
        return None
