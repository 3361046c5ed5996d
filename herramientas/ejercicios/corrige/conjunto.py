"""Una clase entera: cómo se llama cada uno, en qué se han equivocado, quién se parece a quién, y lo que se le devuelve
a cada uno, que Moodle recoge en un .zip con los nombres de carpeta que dio."""
import io
import re
import zipfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

from base import guiones, paginas
from base.procesos import escribe as escribe_fichero
from ejercicios.corrige import informes, parecidos
from ejercicios.corrige.aula import de_moodle
from ejercicios.corrige.clase import fichero_de
from ejercicios.corrige.lector import limpio

AQUI = Path(__file__).parent
COMENTARIOS, SUYO = "comentarios", "correccion.html"
MODULOS = "documento.mjs", "proyector.mjs"
NOMBRES = 8  # que se dicen de los que cometen un error
CON_IMAGEN = 40  # errores que se enseñan
PAREJAS = 60  # que se enseñan
NO_SE_VE = "el título no es el que debía", "no escribe lo que debía"  # en ninguna imagen
# Lo que es lo mismo aunque a cada uno se le diga con sus palabras; None, lo que no es un error.
ES_LO_MISMO = {
    r"no compila\b": "no compila",
    r"se cae\b": "se cae",
    "tarda más de|es muy lento|se queda esperando": "no acaba a tiempo",
    r"acaba con un error.*\.(vert|frag|geom|glsl):\d": "un shader no compila",
    "acaba con un error": "acaba con un error",
    "acaba por su cuenta": "acaba por su cuenta",
    "no ha dejado nada": "no ha dejado nada",
    "hay más de|son más de|entre todos los|no se puede leer|en (el|«)": "no se puede leer",
    "«.*» (pasa de|no es un|no se puede|está en un)": "no se puede leer",
    "no hay ningún fuente|no hay nada": "no hay ningún fuente",
    "el título es": NO_SE_VE[0],
    "debía escribir": NO_SE_VE[1],
    "el (compilador|programa) avisa|su carpeta es de otro|se empezó con otra versión": None,
}
# Lo que solo es un síntoma: si se sabe de qué, es eso.
SINTOMA = re.compile("|".join(("«.*» no hace nada|no responde a|está mal al cambiar", *NO_SE_VE)))
Y_QUE = "; y que "  # lo que une dos errores conocidos
DE_DONDE = {
    "uniform": "un uniform no vale lo que debe",
    "linea": "una línea de un shader no da lo que debe",
    "shader": "se dibuja con otro shader",
    "textura": "una textura no es la que debe",
    "array": "los vértices no son los que deben",
    "trazo": "los vértices no son los que deben",
    "falta": "falta algo por dibujar",
    "sobra": "se dibuja algo de más",
}


@dataclass(eq=False)
class Hecha:
    quien: str  # como se lee
    carpeta: str  # como se llama
    pagina: str  # dirección de la suya, desde la de la clase
    c: dict


@dataclass
class Error:
    dice: str
    de: list
    tras: list
    imagenes: list


def quienes(correcciones):
    """Cada una con su nombre, sin lo que le pone Moodle, si basta para saber quién es."""
    hechas, leidos = {}, {carpeta: de_moodle(carpeta.name) for carpeta in correcciones}
    cortos = {q: limpio(m["quien"]) if m else correcciones[q]["entrega"] for q, m in leidos.items()}
    veces = Counter(cortos.values())
    for carpeta, c in correcciones.items():
        m, quien = leidos[carpeta], cortos[carpeta]
        if veces[quien] > 1 and m and m["numero"]:
            quien = f"{quien} ({m['numero']})"
        pagina = quote(f"{COMENTARIOS}/{Path(fichero_de(carpeta)).stem}.html")
        hechas[carpeta] = Hecha(quien, carpeta.name, pagina, c)
    return hechas


def causas(c):
    """De qué errores es una corrección, como se dicen para toda la clase: lo que se sabe o, si no, lo que se ve."""
    dichas = {}
    for dice in c["dice"]:
        uno, *otros = dice.split(Y_QUE)
        for parte in (uno, *(f"parece que {otro}" for otro in otros)):
            dichas[next((como for patron, como in ES_LO_MISMO.items() if re.match(patron, parte)), parte)] = True
    dichas.pop(None, None)
    se_saben = [dice for dice in dichas if not SINTOMA.match(dice)]
    return se_saben or [*dichas] or [de_un_fallo(f) for f in c["fallos"][:1]] or c["dice"][:1]


def de_un_fallo(fallo):
    """De qué es uno que no se sabe de qué error es."""
    dice = DE_DONDE.get(fallo["donde"] and fallo["donde"]["que"])
    cuando, _, como = fallo["que"].partition(": ")
    return dice or (f"no se ve como debe: {como}" if como else cuando)


def por_causa(hechas):
    """{causa: de quiénes}, antes la de más; cada uno está en una, la que tengan más."""
    tienen = {h: causas(h.c) for h in hechas if h.c["nota"] < 100}
    de = {}
    while tienen:
        veces = Counter(dice for suyas in tienen.values() for dice in suyas)
        causa = min(veces, key=lambda dice: (-veces[dice], dice))
        de[causa] = [h for h in tienen if causa in tienen[h]]
        tienen = {h: suyas for h, suyas in tienen.items() if causa not in suyas}
    return de


def errores(hechas):
    """En qué se han equivocado, antes lo que más, con lo de quien lo deja más claro: a quien no le pasa otra cosa."""
    hallados = []
    for dice, suyas in por_causa(hechas).items():
        claras = sorted(suyas, key=lambda h: (len(h.c["dice"]), -h.c["nota"]))
        fallo = next((f for h in claras for f in h.c["fallos"] if f["imagenes"]), {"tras": [], "imagenes": []})
        if dice in NO_SE_VE or len(hallados) >= CON_IMAGEN:
            fallo = {"tras": [], "imagenes": []}
        hallados.append(Error(dice, suyas, fallo["tras"], fallo["imagenes"]))
    return hallados


def resumen(hechas):
    """Su media y cuántas hay de cada diez puntos; las de 100, aparte."""
    notas = [h.c["nota"] for h in hechas]
    barras = [0] * 11
    for nota in notas:
        barras[int(nota // 10)] += 1
    tramos = [*(f"{10 * i}–{10 * i + 9}" for i in range(10)), "100"]
    return {"media": sum(notas) / max(1, len(notas)), "barras": list(zip(tramos, barras)), "mas": max(1, *barras)}


def las_que_se_parecen(hechas, leidas, dados):
    """Cada pareja, con los textos de las dos."""
    textos = {hechas[carpeta]: leidas[carpeta] for carpeta in hechas if carpeta in leidas}
    halladas = parecidos.parejas(textos, dados)
    for p in halladas[:PAREJAS]:
        p.lados = [(h, list(parecidos.al_lado(textos[h], marcadas))) for h, marcadas in zip((p.una, p.otra), p.lineas)]
        p.cuantas = min(sum(map(len, marcadas.values())) for marcadas in p.lineas)
    return halladas[:PAREJAS], len(halladas[PAREJAS:])


def en_zip(paginas_):
    """{carpeta de Moodle: su página}, en el .zip que Moodle recoge: siempre el mismo si es lo mismo."""
    datos = io.BytesIO()
    with zipfile.ZipFile(datos, "w", zipfile.ZIP_DEFLATED) as z:
        for carpeta, pagina in sorted(paginas_.items()):
            fichero = zipfile.ZipInfo(f"{carpeta}/{SUYO}")
            fichero.external_attr = 0o644 << 16
            z.writestr(fichero, pagina, zipfile.ZIP_DEFLATED)
    return datos.getvalue()


def de_vuelta(nombre, hoja):
    """En qué carpetas recoge Moodle lo de uno: la que dio o, si la tarea es de grupos, una por cada uno del suyo,
    porque el número que da es el del grupo y Moodle busca el de una persona."""
    m = de_moodle(nombre)
    if hoja and hoja.de_grupos and m:
        return hoja.carpetas(nombre)
    if not m or not m["numero"]:
        return []
    return [nombre if nombre.isprintable() else f"{limpio(m['quien'])}_{m['numero']}_assignsubmission_file_"]


def escribe(destino, correcciones, banco, leidas, hoja=None):
    """La página de la clase, la de cada uno, la de las que se parecen y lo que recoge Moodle."""
    hechas = quienes(correcciones)
    de, vuelven = informes.plantilla(), {}
    for carpeta, h in hechas.items():
        pagina = informes.pagina(h.c, banco.programa, banco.ref, quien=h.quien, de=de)
        escribe_fichero(destino / COMENTARIOS / f"{Path(fichero_de(carpeta)).stem}.html", pagina)
        vuelven |= dict.fromkeys(de_vuelta(h.carpeta, hoja), pagina)
    if vuelven:
        escribe_fichero(destino / "comentarios.zip", en_zip(vuelven))
    for de_antes in "parecidos.html", "proyectar.html":  # que ahora puede no haber
        (destino / de_antes).unlink(missing_ok=True)
    parejas, hay_mas = las_que_se_parecen(hechas, leidas, banco.dados)
    datos = {"programa": banco.programa, "ref": banco.ref, "parejas": parejas, "hay_mas": hay_mas}
    if parejas:
        escribe_fichero(destino / "parecidos.html", paginas.plantilla(AQUI / "parecidos.html").render(**datos))
    todas = list(hechas.values())
    hay = errores(todas)
    datos |= {"de_varios": [e for e in hay if e.de[1:]], "de_uno": [e for e in hay if not e.de[1:]], "hechas": todas}
    datos |= {"lineas": informes.lineas, "en_palabras": guiones.en_palabras, "en_html": informes.en_html}
    datos |= {"NOMBRES": NOMBRES, "guion": paginas.junta(AQUI, MODULOS), **resumen(todas)}
    for suya in ("index.html", "proyectar.html") if hay else ("index.html",):
        plantilla = paginas.plantilla(AQUI / ("clase.html" if suya == "index.html" else suya))
        escribe_fichero(destino / suya, plantilla.render(**datos))
