"""Lo que se dice en la terminal de un cuadro explicado."""

SE_DICEN = "entrada", "declara", "asigna", "condicion", "salida"
FALTAN = 3  # de lo que no está
LECTURAS = 6
MAXIMO = 30  # líneas; todas están en la página


def rgb(color):
    return "({:g}, {:g}, {:g})".format(*(round(c, 1) for c in color[:3])) if color else "nada"


def de_orden(orden):
    """«12 triángulos · liso.frag · mezcla · grua.cpp:64, dibuja → dibujaSuelo»."""
    donde = [orden["sitio"]["dice"]] if "sitio" in orden else []
    return " · ".join([orden["titulo"], *filter(None, [orden.get("frag")]), *orden["pruebas"], *donde])


def de_primitiva(suceso):
    """«triángulo 11.º de »: el primero es el 1.º; de un punto, también su gl_VertexID, que se cuenta desde 0."""
    if "tipo" not in suceso:
        return ""
    numero = f" (gl_VertexID {suceso['vertices'][0]})" * (len(suceso["vertices"]) == 1)
    return f"{suceso['tipo']} {suceso['primitiva'] + 1}.º{numero} de "


def de_suceso(suceso, orden):
    quien = de_primitiva(suceso) + de_orden(orden)
    cambia = f" → {rgb(suceso['despues'])}" if suceso["veredicto"] in ("escrito", "ajeno") else ""
    return f"{suceso['orden']:>4}  {quien}: {suceso['dice']}{cambia}"


def de_sospecha(sospecha, ordenes):
    suyo = sospecha.get("sitio") or ordenes.get(sospecha["orden"], {}).get("sitio")
    return f"aviso: {sospecha['dice']}. {sospecha['prueba']}" + (f" Es {suyo['dice']}." if suyo else "")


def cifra(numero):
    return {"nan": "NaN", "inf": "∞", "-inf": "−∞"}.get(numero) or f"{numero:.4g}"


def valor(numeros):
    return cifra(numeros[0]) if len(numeros) == 1 else f"({', '.join(map(cifra, numeros))})"


def de_linea(linea):
    return f"      {linea['fichero']}:{linea['linea']}: {linea['nombre']} = {valor(linea['valor'])}"


def raros(lineas):
    """Las que dan NaN o infinito."""
    return [linea for linea in lineas if any(isinstance(n, str) for n in linea["valor"])]


def de_sombreado(lineas):
    """Del fragmento que gana, lo que vale cada cosa en main y, si algo no es un número, dónde empieza."""
    suyas = [linea for linea in lineas if linea["valor"] and linea["clase"] in SE_DICEN]
    filas = [de_linea(linea) for linea in suyas if linea["funcion"] in ("main", "")][:MAXIMO]
    return filas + [f"      lo primero que no es un número:{de_linea(raro)[5:]}" for raro in raros(lineas)[:1]]


def de_lectura(lectura):
    """De una textura, dónde, qué da, con qué filtro y de qué niveles: «textura.frag:10: texture(Img, st) en (0.5, 1) =
    (0.2, 0, 0.7, 1): GL_LINEAR, λ = −2.9, nivel 0»."""
    en = f" en {valor(lectura['coordenadas'])}" if "coordenadas" in lectura else ""
    de = f"      {lectura['fichero']}:{lectura['linea']}: {lectura['escrito']}{en} = {valor(lectura['valor'])}: "
    if lectura["motivo"]:
        return de + lectura["motivo"]
    niveles = [f"nivel {n['nivel']}" + f" · {cifra(n['peso'])}" * (n["peso"] < 1) for n in lectura["niveles"]]
    cara = f"cara {lectura['cara']}, " * bool(lectura["cara"])
    return f"{de}{cara}{lectura['filtro']}, λ = {cifra(lectura['lambda'])}, {' + '.join(niveles)}"


def sin_seguir(sombreado):
    """Por qué de un shader, o de una línea, no se dice nada."""
    trazas = [sombreado.get("fragmento"), *sombreado.get("vertices", [])[:1]]
    filas = [f"      {t['motivo']}" for t in trazas if t and t["motivo"]]
    donde = {}
    for suya in (suya for t in trazas if t for suya in t["sinSeguir"]):
        donde.setdefault((suya["motivo"], suya["fichero"]), set()).add(suya["linea"])
    return filas + [f"      {f}:{', '.join(map(str, sorted(n)))}: {que}" for (que, f), n in donde.items()][:MAXIMO]


def lo_que_falta(historia, ordenes):
    """Lo que habría estado ahí si no fuera por una prueba, de más cerca a más lejos; si no hay nada, qué órdenes no
    dibujan y por qué."""
    habria = [s for s in historia if s.get("soloEsa")]
    if habria:
        cerca = sorted(habria, key=lambda s: s.get("profundidad", 1))[:FALTAN]
        return [
            "Sin esa prueba habría estado, de más cerca a más lejos:",
            *(de_suceso(s, ordenes[s["orden"]]) for s in cerca),
        ]
    nada = [o for o in ordenes.values() if o.get("nada")][:FALTAN]
    return ["No dibujan nada:", *(f"{o['n']:>4}  {de_orden(o)}: {o['nada']}" for o in nada)] if nada else []


def de_pixel(datos, ordenes):
    """Su historia y, de quien gana, sus valores y lo que lee."""
    sombreado = datos.get("sombreado", {})
    lecturas = [de_lectura(lectura) for lectura in sombreado.get("lecturas", [])]
    mas = [f"      y {len(lecturas) - LECTURAS} lecturas más, en la página"] * (len(lecturas) > LECTURAS)
    return [
        *(de_suceso(suceso, ordenes[suceso["orden"]]) for suceso in datos["historia"]),
        *de_sombreado(datos["lineas"]),
        *lecturas[:LECTURAS],
        *mas,
        *sin_seguir(sombreado),
    ]


def de_texel(texel, ordenes):
    x, y = texel["pixel"]
    que = f"el texel ({x}, {y}) que lee la orden {texel['lee']} se pinta en el framebuffer {texel['framebuffer']}"
    return [f"{que}: {rgb(texel['color'])}", *de_pixel(texel, ordenes)]


def cuadro(datos):
    """La historia del píxel o, si no se pide ninguno, las órdenes."""
    ordenes = {orden["n"]: orden for orden in datos["ordenes"]}
    filas = [de_sospecha(sospecha, ordenes) for sospecha in datos["sospechas"]]
    if datos["pixel"]:
        x, y = datos["pixel"]
        filas += [f"{datos['programa']} en ({x}, {y}): {rgb(datos['color'])}"]
        filas += [] if datos["historia"] else ["      ninguna orden de este cuadro lo toca"]
        filas += de_pixel(datos, ordenes)
        filas += lo_que_falta(datos["historia"], ordenes)
        return "\n".join([*filas, *(fila for texel in datos["texels"] for fila in de_texel(texel, ordenes))])
    filas += [f"{datos['programa']}: {len(ordenes)} órdenes"]
    return "\n".join([*filas, *(f"{n:>4}  {de_orden(orden)}" for n, orden in ordenes.items())])
