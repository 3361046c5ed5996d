"""Lo que se dice en la terminal de un cuadro explicado."""


def rgb(color):
    return "({:g}, {:g}, {:g})".format(*(round(c, 1) for c in color[:3])) if color else "nada"


def de_orden(orden):
    """«12 triángulos · liso.frag · mezcla»."""
    return " · ".join([orden["titulo"], *filter(None, [orden.get("frag")]), *orden["pruebas"]])


def de_suceso(suceso, orden):
    quien = f"{suceso['tipo']} {suceso['primitiva']} de {de_orden(orden)}" if "tipo" in suceso else de_orden(orden)
    cambia = f" → {rgb(suceso['despues'])}" if suceso["veredicto"] == "escrito" else ""
    return f"{suceso['orden']:>4}  {quien}: {suceso['dice']}{cambia}"


def cuadro(datos):
    """La historia del píxel o, si no se pide ninguno, las órdenes."""
    ordenes = {orden["n"]: orden for orden in datos["ordenes"]}
    filas = [f"aviso: {sospecha['dice']}" for sospecha in datos["sospechas"]]
    if datos["pixel"]:
        x, y = datos["pixel"]
        filas += [f"{datos['programa']} en ({x}, {y}): {rgb(datos['color'])}"]
        filas += [de_suceso(suceso, ordenes[suceso["orden"]]) for suceso in datos["historia"]]
        return "\n".join(filas)
    filas += [f"{datos['programa']}: {len(ordenes)} órdenes"]
    return "\n".join([*filas, *(f"{n:>4}  {de_orden(orden)}" for n, orden in ordenes.items())])
