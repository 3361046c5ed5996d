"""usos.py BUILD [USO…] [--todos]: cada uso de usos.inc en una de las dos bases de usos.cpp o, con --todos, en ambas, a
través de ./lab explica, que debe acabar bien y:

- de un error, decirlo con esas palabras en su primera sospecha;
- de lo legal, no sospechar nada, seguir todas sus líneas y cumplir en el píxel dibujado más cercano al centro lo mismo
  que en los programas del laboratorio (propiedades/explica.py);
- de cada caso de explica/casos.inc, apuntar lo que pasa y decir lo que no se sabe seguir.

Estado 1 si algo no se cumple.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

RAIZ = Path(__file__).parents[2]
sys.path.insert(0, str(RAIZ / "tests/propiedades"))
import explica, preguntado  # noqa: E402, E401

FILA = re.compile(r'^USO\((\w+), "(.*?)"', re.M)
CASO = re.compile(r'^\{("(?:\\.|[^"\\])*"(?:, "(?:\\.|[^"\\])*")*)\},$', re.M)
LISTA, CASOS = Path(__file__).with_suffix(".inc"), RAIZ / "tests/explica/casos.inc"
NO_SE_SABE = {  # y se dice, también en la terminal
    "lectura_de_dos": "según desde dónde se llama, es una textura u otra",
    "cubo_sin_usar": "depende de lo que el programa aún no usa («cielo»)",
    "listas": "no sé leer «{» en una expresión",
    "nombre_nuestro": "los nombres que empiezan por explica_ los pone esto",
}


def cerca_del_centro(imagen):
    """Un píxel que no es del fondo."""

    def es_fondo(p):
        return imagen[3 * (p[1] * explica.ANCHO + p[0]) :][:3] == imagen[-3:]

    todos = [(x, y) for x in range(0, explica.ANCHO, 3) for y in range(0, explica.ALTO, 3)]
    return min((p for p in todos if not es_fondo(p)), key=lambda p: (p[0] - 120) ** 2 + (p[1] - 90) ** 2)


def explicado(build, carpeta, pixel, entorno):
    """Lo que da ./lab explica y lo que escribe; si no acaba bien, lo que dice."""
    orden = [sys.executable, "-B", RAIZ / "herramientas", "explica.orden", RAIZ, build, carpeta]
    suyo = ["casos", "usos", "usos", "Usos", *map(str, pixel), "--json", carpeta / "e.json"]
    entorno = {**os.environ, **entorno, "LAB_EXPLICA_SUMAS": "1"}
    r = subprocess.run([*orden, *suyo], env=entorno, capture_output=True, text=True)
    if r.returncode:
        return None, f"acaba con {r.returncode}: {r.stderr.strip()}"
    return json.loads((carpeta / "e.json").read_text()), r.stdout


def fallos_de_texels(cuadro, canales):
    """Lo que se lee de una textura que se pinta en el cuadro se sigue: el texel queda del color que se lee, y se cumple
    lo de un píxel."""
    pintadas = {o["pinta"] for o in cuadro["ordenes"]}
    for quien in (cuadro, *cuadro["texels"]):
        sombreado = quien.get("sombreado", {})
        lecturas = [lectura for lectura in sombreado.get("lecturas", []) if lectura.get("textura") in pintadas]
        suyos = {t["textura"]: t for t in cuadro["texels"] if t["lee"] == sombreado.get("orden")}
        if {lectura["textura"] for lectura in lecturas} != suyos.keys():
            yield f"de {lecturas} se sigue {[*suyos]}"
        for textura, texel in suyos.items():
            leidos = (t for lectura in lecturas if lectura["textura"] == textura for t in lectura["texels"])
            [color, *_] = [t["color"] for t in leidos if t["texel"] == texel["pixel"]]
            if explica.distancia(color[:3], [c / 255 for c in texel["color"][:3]]) > 1e-6:
                yield f"se lee {color} de un texel de color {texel['color']}"
            yield from explica.fallos_de_historia(texel["historia"], canales)
            yield from explica.fallos_de_sombreado(texel)


def cuenta_de(build, carpeta, **entorno):
    """Lo que da de su cuadro, sin ./lab explica."""
    entorno |= {"LD_PRELOAD": str(build / "herramientas/explica/libexplica.so"), "LAB_EXPLICA": "e.json"}
    r = subprocess.run(build / "osmesa/casos/usos", env={**os.environ, **entorno}, cwd=carpeta, capture_output=True)
    assert Path(carpeta, "e.json").exists(), r.stderr
    return json.loads(Path(carpeta, "e.json").read_text(), parse_int=float)  # -0 no es 0


def fallos_de_error(build, carpeta, entorno, debe):
    cuadro = cuenta_de(build, carpeta, **entorno)
    dicha = next((f"{s['dice']}. {s['prueba']}" for s in cuadro["sospechas"]), "nada")
    suyo = re.sub(r"\{(.*?)\|(.*?)\}", lambda m: m[1 + (entorno["BASE"] == "grua")], debe)
    otras = sum("cableado" in o for o in cuadro["ordenes"]) - 1
    todas = dicha.replace(f"; otras {otras}, por lo mismo", "")
    partes = re.findall(r"(\d+) de sus (\d+)", dicha)
    if not re.fullmatch(re.escape(suyo).replace("\\#", "[0-9]+"), todas) or any(int(n) > int(de) for n, de in partes):
        return [f"no se dice «{suyo}» sino «{dicha}»"]
    for pide in re.findall(r"Pide el píxel (\d+) (\d+)", dicha):
        cuadro, dice = explicado(build, carpeta, pide, entorno)
        lineas = cuadro["sombreado"]["fragmento"]["lineas"]
        raro = next(s for s in lineas if any(isinstance(n, str) for n in s["valor"]))
        primero = f"lo primero que no es un número: {raro['fichero']}:{raro['linea']}: "
        if primero not in dice or f"aviso: {dicha}" not in dice:
            return [f"en {pide} no hay nada raro"]
    return []


def fallos_de(build, base, uso, debe):
    with tempfile.TemporaryDirectory() as carpeta:
        carpeta, entorno = Path(carpeta), {"BASE": base, "USO": uso}
        if debe:
            return fallos_de_error(build, carpeta, entorno, debe)
        programa = build / "osmesa/casos/usos"
        imagen = explica.dibuja([programa], carpeta, **entorno)
        suyas = preguntado.pregunta([programa, *explica.TALLA], build, carpeta, **entorno)
        entorno |= preguntado.preguntando(build, carpeta)
        cuadro, dice = explicado(build, carpeta, cerca_del_centro(imagen), entorno)
        explicadas = preguntado.contestado(carpeta)
    if not cuadro:
        return [dice]
    canales = explica.canales_de(cuadro)
    fallos = [f"se sospecha: {s['dice']}" for s in cuadro["sospechas"]] + [*fallos_de_texels(cuadro, canales)]
    fallos += [*preguntado.fallos(cuadro, suyas, explicadas), *explica.fallos_de_pixel(cuadro, imagen, canales)]
    fallos += ["nada cubre el píxel"] * (len(cuadro["historia"]) < 2)
    trazas = [t for t in [cuadro.get("sombreado", {}).get("fragmento")] if t]
    fallos += [f"no sigue la línea {s['linea']}: {s['motivo']}" for t in trazas for s in t["sinSeguir"]]
    dibujan = [s for s in cuadro["historia"] if "tipo" in s]
    fallos += [f"no se cuentan desde 1: {s}" for s in dibujan if f" {s['tipo']} {s['primitiva'] + 1}.º" not in dice]
    if uso not in NO_SE_SABE:
        return fallos
    fallos = [f for f in fallos if not f.startswith("no se") and not NO_SE_SABE[uso] in f]
    return fallos + ["no se dice lo que no se sabe"] * (NO_SE_SABE[uso] not in dice)


def cuenta(lineas):
    """«3 x:1.5 y:2 | 4 >f <f:2»: en la 3, x vale 1.5; en la 4 se entra en f y da 2. La línea se dice cuando cambia."""
    partes, antes = [], None
    for linea in lineas:
        clase, nombre = linea["clase"], linea["nombre"]
        if clase in ("entrada", "salida") or linea["tipo"] == "void" and nombre == "main":
            continue
        partes += [f"| {linea['linea']}"] * (linea["linea"] != antes)
        antes = linea["linea"]
        como = {"entra": f">{nombre}", "vuelve": f"<{nombre}", "devuelve": f"<{linea['funcion']}"}.get(clase, nombre)
        valor = ",".join(n if isinstance(n, str) else f"{n:.9g}" for n in linea["valor"])
        partes.append(como + f":{valor}" * bool(valor))
    return " ".join(partes).removeprefix("| ")


def fallos_de_caso(build, fila):
    """El fragment shader se mira aunque no gane, que quizá descarta."""
    de_global, cuerpo, pasa, no_se_sabe = (*json.loads(f"[{fila}]"), "")[:4]
    inicio = "#version 140\nuniform int uno; uniform float medio; out vec4 o; "
    fuente = f"{inicio}{de_global}\n#line 2\n\nvoid main() {{ {cuerpo}\n}}\n"
    with tempfile.TemporaryDirectory() as carpeta:
        pide = {"LAB_EXPLICA_PIXELES": "1,178", "LAB_EXPLICA_SOMBREA": "2,0"}
        cuadro = cuenta_de(build, carpeta, USO="caso", CASO=fuente, **pide)
    fragmento = cuadro["pixeles"][0]["sombreado"]["fragmento"]
    for linea in (linea for que in ("lineas", "sinSeguir") for linea in fragmento[que]):
        linea["linea"] = int(linea["linea"])
    hay = cuenta(fragmento["lineas"])
    debe = re.sub(r"(?<=[:,])-?\d+(?=[ ,]|$)", lambda n: f"{float(n[0]):.9g}", pasa)  # las cifras que se dan
    bien = fuente == cuadro["programas"][0]["frag"] and (hay == debe or debe[0] == "…" and hay.endswith(debe[1:]))
    dichas = [f"{s['linea']}: {s['motivo']}" for s in fragmento["sinSeguir"]]
    return [] if bien and dichas == [no_se_sabe] * bool(no_se_sabe) else [f"{cuerpo}: {hay} {dichas} y no {debe}"]


def main():
    build, *resto = sys.argv[1:]
    build, todos = Path(build).absolute(), "--todos" in resto
    filas = FILA.findall(LISTA.read_text())
    elegidas = [f for f in filas if not set(resto) - {"--todos"} or f[0] in resto]
    bases = lambda i: ("toro", "grua") if todos else ("toro", "grua")[i % 2 :][:1]
    trabajos = [(base, *fila) for i, fila in enumerate(elegidas) for base in bases(i)]
    casos = [] if set(resto) - {"--todos"} else CASO.findall(CASOS.read_text())
    with ThreadPoolExecutor(os.cpu_count()) as hilos:
        de_cada = list(hilos.map(lambda t: fallos_de(build, *t), trabajos))
        de_casos = [fallo for suyos in hilos.map(lambda fila: fallos_de_caso(build, fila), casos) for fallo in suyos]
    print("\n".join(de_casos), f"casos: bien {len(casos) - len(de_casos)} de {len(casos)}", sep="\n")
    for (base, uso, debe), fallos in zip(trabajos, de_cada):
        for fallo in fallos:
            print(f"{'error' if debe else 'legal'} {uso}, {base}: {fallo}")
    for que, bien in (("errores", True), ("usos legales", False)):
        suyos = [fallos for (*_, debe), fallos in zip(trabajos, de_cada) if bool(debe) == bien]
        print(f"{que}: bien {sum(not fallos for fallos in suyos)} de {len(suyos)}")
    return not trabajos or any([*de_cada, de_casos])


if __name__ == "__main__":
    sys.exit(main())
