"""Lo que cuenta de su cuadro un programa al que se le pone delante herramientas/explica. Si el programa es de otro, lo
puede haber escrito él: se lee hasta un límite, y vale si todo es de lo que debe ser; de lo que sobra no queda nada."""
import json

DELANTE = "herramientas/explica/libexplica.so"
FICHERO = "cuadro.json"
BYTES = 8 << 20
LARGA = 1 << 20  # de un texto
RAROS = {"nan": float("nan"), "-nan": float("nan"), "inf": float("inf"), "-inf": float("-inf")}


def numero(que):
    if isinstance(que, str) and que in RAROS:
        return RAROS[que]
    if type(que) in (int, float) and abs(que) < 1e39:  # True no lo es
        return que
    raise ValueError


def forma(vale):
    def comprueba(que):
        if vale(que):
            return que
        raise ValueError

    return comprueba


natural = forma(lambda que: type(que) is int and -1 <= que < 1 << 31)
texto = forma(lambda que: isinstance(que, str) and len(que) < LARGA)
logico = forma(lambda que: isinstance(que, bool))
NUMEROS = [numero]
PASO = {"linea": natural, "clase": texto, "nombre": texto, "tipo": texto, "funcion": texto, "valor": NUMEROS}
TRAZA = {"lineas": [PASO]}
SUCESO = {
    "orden": natural,
    "veredicto": texto,
    "primitiva?": natural,
    "tipo?": texto,
    "color?": NUMEROS,
    "despues?": NUMEROS,
    "profundidadDespues?": numero,
    "plantillaDespues?": numero,
}
ATRIBUTO = {"nombre": texto, "activo": logico, "bufer": natural, "componentes": natural, "suma": texto}
UNIFORME = {"nombre": texto, "tipo": texto, "valor": NUMEROS}
TEXTURA = {
    "sampler": texto,
    "unidad": natural,
    "talla": [natural],
    **{que: texto for que in ("formato", "reduce", "amplia", "repite", "incompleta", "suma")},
}
CABLEADO = {"atributos": [ATRIBUTO], "uniformes": [UNIFORME], "texturas": [TEXTURA], "sumaIndices": texto}
ORDEN = {
    "n": natural,
    "llamada": texto,
    "titulo": texto,
    "framebuffer": texto,
    "estado": [{"nombre": texto, "valor": texto}],
    "programa?": natural,
    "fragmentos?": natural,
    "cableado?": CABLEADO,
}
SOMBREADO = {"orden": natural, "primitiva": natural, "fragmento?": TRAZA, "vertices?": [{**TRAZA, "indice": natural}]}
PIXEL = {"pixel": [natural], "color": NUMEROS, "historia": [SUCESO], "sombreado?": SOMBREADO}
CUADRO = {
    "ordenes": [ORDEN],
    "programas": [{"programa": natural, "vert?": texto, "frag?": texto}],
    "pixeles": [PIXEL],
}


def cumple(que, forma):
    """Solo lo que dice la forma, o ValueError. Una clave con ? puede faltar, o ser nula: queda en None."""
    if callable(forma):
        return forma(que)
    if not isinstance(que, type(forma)):
        raise ValueError
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
