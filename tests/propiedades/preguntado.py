"""Lo que ./lab explica dice de cada orden, contra lo que OpenGL contesta a quien le pregunta por todo, en números
(casos/pregunta.cpp): cada constante vale lo que en las cabeceras de OpenGL, cada tipo es el que está en el shader y no
falta ninguna orden. Y explicarlas no cambia nada de lo que OpenGL contesta, las veces que el cuadro se dibuje."""
import os
import re
import subprocess
from pathlib import Path

CABECERAS = "".join(Path("/usr/include/GL", cual).read_text("latin1") for cual in ("gl.h", "glext.h"))
GL = {nombre: int(valor, 0) for nombre, valor in re.findall(r"#define (GL_\w+)\s+(0x[\dA-Fa-f]+|\d)\s", CABECERAS)}
ESTADO = {  # lo que se pregunta para cada cosa, y cuántos números es
    "glViewport": "VIEWPORT×4",
    "GL_CULL_FACE": "CULL_FACE_MODE×1 FRONT_FACE×1",
    "GL_SCISSOR_TEST": "SCISSOR_BOX×4",
    "GL_STENCIL_TEST": "STENCIL_FUNC×1 STENCIL_REF×1 STENCIL_VALUE_MASK×1 STENCIL_FAIL×1 STENCIL_PASS_DEPTH_FAIL×1 "
    "STENCIL_PASS_DEPTH_PASS×1",
    "GL_DEPTH_TEST": "DEPTH_FUNC×1",
    "glDepthRange": "DEPTH_RANGE×2",
    "GL_BLEND": "BLEND_EQUATION_RGB×1 BLEND_SRC_RGB×1 BLEND_DST_RGB×1 BLEND_SRC_ALPHA×1 BLEND_DST_ALPHA×1",
    "glPolygonMode": "POLYGON_MODE×1",
    "GL_POLYGON_OFFSET_FILL": "POLYGON_OFFSET_FACTOR×1 POLYGON_OFFSET_UNITS×1",
}
SUELTAS = "PRIMITIVE_RESTART COLOR_WRITEMASK DEPTH_WRITEMASK VERTEX_ARRAY_BINDING DRAW_FRAMEBUFFER_BINDING"
SIN_DECIR = """STENCIL_WRITEMASK STENCIL_BACK_WRITEMASK STENCIL_BACK_FUNC STENCIL_BACK_FAIL STENCIL_CLEAR_VALUE
DEPTH_CLEAR_VALUE COLOR_CLEAR_VALUE BLEND_COLOR BLEND_EQUATION_ALPHA ACTIVE_TEXTURE READ_FRAMEBUFFER_BINDING
PIXEL_PACK_BUFFER_BINDING PIXEL_UNPACK_BUFFER_BINDING PACK_ALIGNMENT RASTERIZER_DISCARD READ_BUFFER"""  # se quedan
SE_PREGUNTAN = re.findall(r"\b[A-Z_]{4,}", " ".join([*ESTADO, *ESTADO.values(), SUELTAS, SIN_DECIR]).replace("GL_", ""))
PRUEBAS = {"recorte": "SCISSOR_TEST", "plantilla": "STENCIL_TEST", "quita": "CULL_FACE", "mezcla": "BLEND"}
BORRA = {"color": 0x4000, "profundidad": 0x100, "plantilla": 0x400}
CUANTAS = "n", "n // 2", "n * (n > 1)", "n - 1", "n // 3", "n - 2", "n - 2"  # primitivas, de cada modo


def numeros(texto):
    """Los que se dicen, con nombre o sin él; los que une una |, en uno."""
    salen = []
    for une, dicho in re.findall(r"(\| )?((?<!\w)-?\d[\w.]*(?:(?<=e)[-+]\d+)?|GL_\w+)", texto):
        vale = GL.get(dicho, -7) if dicho[0] == "G" else int(dicho, 16) if dicho[:2] == "0x" else float(dicho)
        salen += [int(salen.pop()) | vale] if une else [vale]
    return salen


def iguales(dichos, hay):
    """Con las cifras que se dicen; los enteros, con signo o sin él."""
    pares = [(float(a), b) for a, b in zip(dichos, hay)]
    bien = (a == b or abs(a - b) <= 1e-5 * abs(b) or a - b == 1 << 32 or a != a and b != b for a, b in pares)
    return len(dichos) == len(hay) and all(bien)


def preguntando(build, carpeta, *detras):
    """Con qué se ejecuta, y lo que va DETRÁS, para que lo() dé lo que contesta OpenGL."""
    entorno = {"LD_PRELOAD": " ".join(map(str, [build / "tests/libpregunta.so", *detras]))}
    entorno["PREGUNTA_ESTADO"] = " ".join(str(GL[f"GL_{nombre}"]) for nombre in SE_PREGUNTAN)
    return entorno | {"PREGUNTA": str(carpeta / "pregunta.txt")}


def contestado(carpeta):
    """De cada orden, su nombre y sus números y, de cada clase de cosa, {nombre: números}."""
    ordenes = []
    for que, nombre, *resto in map(str.split, (carpeta / "pregunta.txt").read_text().splitlines()):
        if que == "orden":
            ordenes.append({"estado": {}, "atributo": {}, "uniform": {}, "textura": {}})
        ordenes[-1].setdefault(que, {})[nombre] = [*map(float, resto)]
    for orden in ordenes:
        orden["estado"] = dict(zip(SE_PREGUNTAN, orden["estado"].values()))
    return ordenes


def pregunta(orden, build, carpeta, **entorno):
    entorno |= preguntando(build, carpeta)
    subprocess.run(orden, env={**os.environ, **entorno}, cwd=carpeta, check=True, capture_output=True)
    return contestado(carpeta)


def fallos_de_estado(orden, hay):
    dichos = {e["nombre"]: e["valor"] for e in orden["estado"]}
    for nombre, cuales in ESTADO.items():
        suyos = [n for cual, cuantos in re.findall(r"(\w+)×(\d)", cuales) for n in hay[cual][: int(cuantos)]]
        apagado = nombre[:3] == "GL_" and not hay[nombre[3:]][0]
        if dichos[nombre] != "no" if apagado else not iguales(numeros(dichos[nombre]), suyos):
            yield f"{nombre} es {not apagado and suyos} y se dice {dichos[nombre]}"
    mascara = "".join(c if v else "-" for c, v in zip("rgba", hay["COLOR_WRITEMASK"]))
    if (dichos["glColorMask"], dichos["glDepthMask"] == "escribe") != (mascara, bool(hay["DEPTH_WRITEMASK"][0])):
        yield f"se escribe {mascara} y profundidad, {hay['DEPTH_WRITEMASK']}, y se dice {dichos}"
    puestas = {prueba for prueba, cual in PRUEBAS.items() if hay[cual][0]}
    puestas |= {"sin"} if mascara == "----" or not hay["DEPTH_TEST"][0] else set()
    if {prueba.split()[0] for prueba in orden["pruebas"]} != puestas:
        yield f"hay {puestas} y se dice {orden['pruebas']}"


def fallos_de_orden(orden, suya):
    [(nombre, hechos)], hay, titulo = suya["orden"].items(), suya["estado"], orden["titulo"]
    if orden["llamada"].split("(")[0] != nombre or not iguales(numeros(orden["llamada"]), hechos):
        yield f"se llama a {nombre} {hechos}"
    elif nombre == "glClear" and sum(BORRA[que] for que in re.findall(r"\w+", titulo)[1:]) != hechos[0]:
        yield f"no es «{titulo}»"
    elif nombre != "glClear" and hay["VERTEX_ARRAY_BINDING"][0] and not hay["PRIMITIVE_RESTART"][0]:
        cuantas = eval(CUANTAS[int(hechos[0])], {"n": int(hechos[1 if nombre == "glDrawElements" else 2])})
        if not iguales(numeros(titulo), [max(cuantas, 0)]):
            yield f"«{titulo}» y son {cuantas}"
    donde = hay["DRAW_FRAMEBUFFER_BINDING"][0]
    if numeros(orden["framebuffer"])[:3] != ([donde, *orden["talla"]] if donde else []):
        yield f"se dibuja en {donde}, de {orden['talla']}, y se dice {orden['framebuffer']}"


def fallos_de_cableado(cableado, suya, textos):
    """De cada cosa que lee su programa: de dónde le llega, cuánto vale y de qué tipo es."""
    atributos, uniformes = ({c["nombre"]: c for c in cableado[que]} for que in ("atributos", "uniformes"))
    if atributos.keys() != suya["atributo"].keys() or suya["uniform"].keys() - uniformes.keys():
        yield f"se dice {[*atributos]}, {[*uniformes]} y hay {[*suya['atributo']]}, {[*suya['uniform']]}"
        return
    for nombre, a in atributos.items():
        dicho = [a["desplazamiento"], a["activo"], a["componentes"], GL[a["de"]], a["paso"]]
        if not iguales(dicho, suya["atributo"][nombre]):
            yield f"{a} y es {suya['atributo'][nombre]}"
    for nombre, hay in suya["uniform"].items():
        if not iguales(uniformes[nombre]["valor"], hay[: len(uniformes[nombre]["valor"]) or 1]):
            yield f"{uniformes[nombre]} y es {hay}"
    for t in (t for t in cableado["texturas"] if t["objetivo"] == "GL_TEXTURE_2D"):
        dicho = [t["textura"], *t["talla"], *numeros("{formato} {reduce} {amplia} {repite}".format(**t))]
        hay = suya["textura"][str(t["unidad"])]
        if t["unidad"] != suya["uniform"].get(t["sampler"], [t["unidad"]])[0] or hay[0] and not iguales(dicho, hay):
            yield f"{t} y es {hay}"
    for nombre, cosa in (atributos | uniformes).items():
        if not re.search(rf"\b{cosa['tipo']}\b[^;{{}}()]*\b{re.findall('[A-Za-z_]+[0-9]*', nombre)[-1]}", textos):
            yield f"{nombre} no es un {cosa['tipo']}"


def fallos(cuadro, suyas, explicadas):
    """`suyas`: las que da pregunta, del mismo cuadro; y las mismas, al explicarlo."""
    for i, explicada in enumerate(explicadas):
        hay = [
            (q, *c) for q, suyo in suyas[i % len(suyas)].items() for c in suyo.items() if c not in explicada[q].items()
        ]
        if any(nombre != "VERTEX_ARRAY_BINDING" for _, nombre, _ in hay):  # hay quien crea otro en cada cuadro
            yield f"al explicarlo, en la orden {i + 1}, no es {hay}"
            break
    dichas = [o for o in cuadro["ordenes"] if re.match(r"(glClear|glDrawArrays|glDrawElements)\(", o["llamada"])]
    if len(suyas) != len(dichas):
        yield f"se dicen {len(dichas)} órdenes de {len(suyas)}"
    textos = {p["programa"]: str(p.get("vert", "")) + str(p.get("frag", "")) for p in cuadro["programas"]}
    for orden, suya in zip(dichas, suyas):
        de_esta = [*fallos_de_orden(orden, suya), *(fallos_de_estado(orden, suya["estado"]) if orden["estado"] else [])]
        if "programa" in orden:
            de_esta += fallos_de_cableado(orden["cableado"], suya, textos[orden["programa"]])
        yield from (f"la orden {orden['n']}, {orden['llamada']}: {fallo}" for fallo in de_esta)
