#!/usr/bin/env python3
"""comprueba_galeria.py RAÍZ BUILD: dibuja la galería en una carpeta temporal y la recorre en Chromium, con file://.

Todas las imágenes cargan, y las animadas se mueven, salvo para quien pide menos movimiento; la vista grande se abre,
pasa con las teclas, nunca enseña una imagen agrandada y se cierra con Esc; cada dirección lleva a lo suyo y el
buscador, a lo que se busca (direcciones.py, también en Firefox); los fuentes se ven; en papel, un capítulo es eso y
nada más; nada se sale de un teléfono de 360 píxeles, ni con el texto al doble; la consola no da ningún error.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import direcciones
import gestos
import navegador
from firefox import Firefox
from navegador import AVPAG, BUILD, CASOS, DERECHA, ESC, FIN, INICIO, IZQUIERDA, RAIZ, espera, exige

TITULO = "return document.querySelector('dialog h2').textContent"
ABIERTA = "return document.querySelector('dialog').open"
CUAL = "return location.hash.slice(1)"


def comprueba_imagenes(n):
    n.js("for (const i of document.images) i.loading = 'eager'")
    cargan = espera(n, "return [...document.querySelectorAll('figure img')].every(i => i.complete)")
    exige(cargan, "las imágenes acaban de cargar")
    animadas = sum(bool(caso.anima) for caso in CASOS)
    for anchura, cuantas, cuales in ((1440, len(CASOS) - animadas, "quietas"), (480, animadas, "animadas")):
        hay = n.js("return [...document.querySelectorAll('figure:not(.captura) img')].map(i => i.naturalWidth)").count(
            anchura
        )
        exige(hay == cuantas, f"hay {cuantas} imágenes {cuales} de {anchura} píxeles, y no {hay}")


def comprueba_vista_grande(n):
    n.js("document.querySelectorAll('figure a')[1].click()")
    exige(n.js(ABIERTA), "una imagen pulsada se ve en grande")
    segundo = n.js(TITULO)
    n.tecla(DERECHA)
    tercero = n.js(TITULO)
    exige(tercero and tercero != segundo, "→ pasa a la siguiente")
    n.tecla(IZQUIERDA)
    exige(n.js(TITULO) == segundo, "← vuelve a la anterior")
    n.tecla(IZQUIERDA, IZQUIERDA)
    exige(n.js(CUAL) == CASOS[0].fichero, "← en la primera se queda en ella")
    alto = n.js("return document.querySelector('dialog img').getBoundingClientRect().height")
    exige(alto > 700, f"en una ventana de 900 la imagen grande mide {alto}")
    n.tecla(ESC)
    exige(not n.js(ABIERTA), "Esc cierra la vista grande")
    n.js("document.querySelector('#grua-girada a').click()")
    exige(n.js(ABIERTA) and n.js(CUAL) == "grua-girada", "la dirección es la de la imagen que se ve")
    n.js("history.back()")
    exige(espera(n, "return !document.querySelector('dialog').open"), "y con «Atrás» se cierra")
    exige(n.js(CUAL) == CASOS[0].fichero, "donde se estaba")


def comprueba_teclas(n):
    """Cada una, dos veces; ninguna deja la pantalla en negro sin querer."""
    negro = "return document.querySelector('dialog').classList.contains('negro')"
    oculta = "return getComputedStyle(document.querySelector('dialog .cuadro')).visibility === 'hidden'"
    n.js("document.querySelector('#tetera-malla a').click()")
    suyas = [c.fichero for c in CASOS if c.programa.capitulo.nombre == "ch02_modelado"]
    for tecla, va in ((INICIO, suyas[0]), (FIN, suyas[-1])):
        for _ in range(2):
            n.tecla(tecla)
            exige(n.js(CUAL) == va, f"{va} es la primera o la última del capítulo, y no {n.js(CUAL)}")
    for tecla in "b.":
        for debe in (True, False):
            n.tecla(tecla)
            exige(n.js(negro) is debe and n.js(oculta) is debe, f"«{tecla}»: en negro, {debe}")
        n.tecla(tecla, IZQUIERDA)
        exige(not n.js(negro), f"y tras «{tecla}», pasar a otra la enseña")
    ayuda = "return Boolean(document.querySelector('dialog .teclas').offsetParent)"
    exige(
        [n.js(ayuda), n.tecla("?"), n.js(ayuda), n.tecla("?"), n.js(ayuda)][::2] == [False, True, False], "? y la ayuda"
    )
    n.tecla(ESC)


def comprueba_tallas_proyectadas(n):
    """Ninguna imagen se enseña mayor de lo que se dibujó: sus píxeles son los de la pantalla, o menos."""
    for ancho, alto, densidad in ((1920, 1080, 1), (2560, 1600, 1), (1440, 900, 2), (360, 740, 3)):
        n.devtools(
            "Emulation.setDeviceMetricsOverride", width=ancho, height=alto, deviceScaleFactor=densidad, mobile=False
        )
        mal = direcciones.promesa(
            n,
            """const mal = [];
            for (const id of pedido[0]) {
              const figura = document.getElementById(id);
              (figura.querySelector(':scope > a') ?? figura.querySelector('figure a')).click();
              const e = una('.cuadro > *'), suyo = () => e.naturalWidth ?? (e.width === 300 ? 0 : e.width);
              for (let i = 0; i < 100 && !suyo(); ++i) await cuadro();
              await cuadro();
              const r = e.getBoundingClientRect(), marco = una('.cuadro').getBoundingClientRect();
              const ancho = Math.min(r.width, r.height * 4 / 3) * devicePixelRatio;
              const cabe = r.width <= marco.width + 1 && r.height <= marco.height + 1;
              const llena = Math.abs(r.width - marco.width) < 2 || Math.abs(r.height - marco.height) < 2;
              if (!suyo() || ancho > suyo() + 1 || !cabe || !(llena || ancho > suyo() - 2))
                mal.push([id, ancho, suyo()]);
              una('dialog').close();
            }
            return mal""",
            [c.fichero for c in CASOS if c.anima] + ["grua", "tetera-malla", "menu-captura"],
        )
        exige(mal == [], f"a {ancho}×{alto}, ×{densidad}, nada se agranda ni se queda corto: {mal[:4]}")
    n.talla(1440, 900)


def comprueba_animadas(n):
    menos = "Emulation.setEmulatedMedia"
    cabe = """const caja = selector => document.querySelector(selector).getBoundingClientRect();
        return caja('.cuadro > *').bottom <= caja('.pie').top + 1 && caja('.pie').bottom <= innerHeight"""
    for caso in [c for c in CASOS if c.anima][:2]:
        n.js("document.getElementById(arguments[0]).querySelector('a').click()", caso.fichero)
        exige(espera(n, "return document.querySelector('dialog canvas')?.width === 1280"), "los cuadros se ven")
        exige(n.js(cabe), "y caben enteros sobre su pie")
        for anda in (True, False, True):
            fotos = set()
            for _ in range(12):
                fotos.add(n.foto())
                time.sleep(0.1)
            exige((len(fotos) > 1) is anda, f"{caso.fichero}: espacio la para y la sigue: {anda}")
            n.tecla(" ")
        n.tecla(ESC)
    quietas = (
        "[...document.querySelectorAll('figure:not(.captura) img')].every(i => i.complete && i.naturalWidth === 1440)"
    )
    n.devtools(menos, features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
    exige(espera(n, f"return {quietas}"), "con menos movimiento, todas están quietas")
    n.js("document.getElementById(arguments[0]).querySelector('a').click()", caso.fichero)
    espera(n, "return document.querySelector('dialog canvas')?.width === 1280")
    fotos = {n.foto(), time.sleep(0.5) or n.foto()}
    n.tecla(" ")
    fotos_luego = {time.sleep(0.3) or n.foto() for _ in range(4)}
    exige(len(fotos) == 1 and len(fotos_luego) > 1, "y en grande, hasta que se pide")
    n.tecla(ESC)
    n.devtools(menos, features=[])


def comprueba_papel(n):
    """Con la dirección de un capítulo o de un programa, en papel está solo eso, sin nada que se pulse."""
    se_ve = "[...document.querySelectorAll(s)].filter(e => e.checkVisibility()).map(e => e.id)"
    for elegido in (*direcciones.CAPITULOS, "grua", "grua-girada", "E3.5", ""):
        n.js("location.hash = arguments[0]", elegido)
        n.devtools("Emulation.setEmulatedMedia", media="print")
        capitulos, articulos = (n.js(f"const s = arguments[0]; return {se_ve}", s) for s in (".capitulo", "article"))
        de = {"": None, "grua": "grua", "grua-girada": "grua", "E3.5": "grua"}
        suyos = [
            p.nombre
            for p in navegador.PROGRAMAS.values()
            if de.get(elegido, elegido) in (None, p.nombre, p.capitulo.nombre)
        ]
        exige(articulos == suyos, f"en papel, «{elegido}»: {articulos}")
        exige(len(capitulos) == (1 if elegido else 12), f"en papel, «{elegido}», los capítulos: {capitulos}")
        pulsables = n.js(f"const s = 'button, nav, dialog, .fuentes, .respuesta, summary'; return {se_ve}")
        exige(not pulsables, f"en papel, «{elegido}», nada que se pulse: {pulsables[:3]}")
        n.devtools("Emulation.setEmulatedMedia", media="")


def comprueba_proyeccion(n):
    n.talla(1920, 1080)
    n.js("document.querySelector('#grua').scrollIntoView()")
    n.tecla("p")
    proyecta = espera(n, "return document.fullscreenElement && document.querySelector('dialog').open")
    exige(proyecta and n.js(TITULO).startswith("Grúa de obra"), "p proyecta lo que se está viendo")
    exige("giran" in n.js("return document.querySelector('dialog .mandos').textContent"), "con sus controles")
    navegador.proyectable(n, "dialog")
    n.tecla(AVPAG)  # la de los mandos de presentación
    exige(n.js(TITULO).startswith("Grúa de obra: Girada"), "AvPág pasa a la siguiente")
    n.tecla("p")
    exige(espera(n, "return !document.fullscreenElement"), "p deja la pantalla completa")
    n.tecla(ESC)
    n.talla(1440, 900)


def comprueba_textos(n):
    def texto(selector):
        return n.js("return document.querySelector(arguments[0]).textContent", selector)

    exige("cubos de lado uno" in texto("#grua .enunciado"), "el ejercicio de la grúa")
    exige("Cinco cubos" in texto("#grua .respuesta"), "y su respuesta")
    exige(texto("#shader_basico .erratas").count("Listado 1.3") == 3, "las erratas del listado 1.3")
    exige(n.js("return document.querySelector('#grua abbr').title") == "ejercicio 3.5: la grúa de obra", "qué es E3.5")
    n.js("document.querySelector('#grua .fuentes').open = true")
    fuente = "return document.querySelector('#grua pre').textContent.includes('glutMainLoop')"
    exige(espera(n, fuente), "el fuente se ve")


def comprueba_tallas(n):
    navegador.accesible(n, "la galería")
    n.js("for (const d of document.querySelectorAll('details')) d.open = true")
    for ancho in (360, 800, 1920):
        n.talla(ancho, 800)
        navegador.nada_se_sale(n, "nada", ancho)


def en_firefox(carpeta, pagina):
    f = Firefox(Path(carpeta, "perfil"), os.environ, "--headless")
    try:
        f.pide("WebDriver:Navigate", url=pagina.as_uri())
        direcciones.de_la_galeria(f, 5)
        direcciones.busquedas(f, "la galería, en Firefox")
        direcciones.copias(f, "la galería, en Firefox")
    finally:
        f.cierra()


def main():
    with tempfile.TemporaryDirectory() as carpeta, navegador.chromium("--headless=new", "--disable-gpu") as n:
        destino = Path(carpeta, "galería (1)")
        dibuja = [sys.executable, "-B", RAIZ / "herramientas", "galeria.dibuja", RAIZ, BUILD, destino]
        if subprocess.run(dibuja).returncode:
            sys.exit("la galería no se ha dibujado entera")
        n.pide("/timeouts", script=240000)  # axe recorre cinco megabytes
        n.talla(1440, 900)
        n.abre(destino / "index.html")
        comprueba_imagenes(n)
        comprueba_vista_grande(n)
        comprueba_teclas(n)
        comprueba_animadas(n)
        comprueba_tallas_proyectadas(n)
        comprueba_proyeccion(n)
        comprueba_textos(n)
        comprueba_papel(n)
        for ancho, cada in ((1440, 1), (1024, 7), (360, 7)):
            n.talla(ancho, 800)
            direcciones.de_la_galeria(n, cada)
        n.talla(1440, 900)
        direcciones.busquedas(n, "la galería")
        direcciones.copias(n, "la galería")
        gestos.de_la_galeria(n, lambda: n.abre(destino / "index.html"))
        comprueba_tallas(n)
        registro = n.registro()
        exige(not registro, f"la consola está vacía: {registro[:1]}")
        en_firefox(carpeta, destino / "index.html")
    navegador.acaba()


if __name__ == "__main__":
    main()
