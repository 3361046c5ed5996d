#!/usr/bin/env python3
"""comprueba_galeria.py RAÍZ BUILD: dibuja la galería en una carpeta temporal y la recorre en Chromium, con file://.

Todas las imágenes cargan, y las animadas se mueven, salvo para quien pide menos movimiento; la vista grande se abre,
pasa con las flechas y se cierra con Esc; el buscador encuentra con acentos y sin ellos; los fuentes se ven; nada se
sale de un teléfono de 360 píxeles, ni con el texto al doble; la consola no da ningún error.
"""
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import gestos
import navegador
from navegador import AVPAG, BUILD, CASOS, DERECHA, ESC, IZQUIERDA, RAIZ, espera, exige

TITULO = "return document.querySelector('dialog h2').textContent"
ABIERTA = "return document.querySelector('dialog').open"


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
    exige(n.js("return actual === document.querySelector('figure a')"), "← en la primera se queda en ella")
    alto = n.js("return document.querySelector('dialog img').getBoundingClientRect().height")
    exige(alto > 700, f"en una ventana de 900 la imagen grande mide {alto}")
    n.tecla(ESC)
    exige(not n.js(ABIERTA), "Esc cierra la vista grande")


def comprueba_animadas(n):
    n.js("document.querySelector('figure source').parentElement.parentElement.click()")
    fuente = "return document.querySelector('dialog img').currentSrc.endsWith('.anima.png')"
    exige(espera(n, fuente), "la vista grande de una animada también se mueve")
    cabe = """const caja = selector => document.querySelector(selector).getBoundingClientRect();
        return caja('dialog img').bottom <= caja('.pie').top + 1 && caja('.pie').bottom <= innerHeight"""
    exige(n.js(cabe), "y cabe entera sobre su pie")
    fotos = set()
    for _ in range(20):
        fotos.add(n.foto())
        time.sleep(0.1)
    exige(len(fotos) > 1, "una animada cambia con el tiempo")
    n.tecla(ESC)
    quietas = (
        "[...document.querySelectorAll('figure:not(.captura) img')].every(i => i.complete && i.naturalWidth === 1440)"
    )
    for valor in ("reduce", ""):
        n.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": valor}])
        if valor:
            exige(espera(n, f"return {quietas}"), "con menos movimiento, todas están quietas")


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


def comprueba_buscador(n):
    visibles = "return [...document.querySelectorAll('article')].filter(a => a.offsetParent).map(a => a.id)"
    n.tecla("/")
    n.tecla(*"grua obra")
    exige(n.js(visibles) == ["grua"], "«grua obra» encuentra solo la grúa de obra")
    busca = "const i = document.querySelector('input'); i.value = arguments[0]; i.dispatchEvent(new Event('input'))"
    n.js(busca, "INCLINACION")
    hallados = n.js(visibles)
    exige("camara" in hallados and "tiras" not in hallados, "«INCLINACION» encuentra «inclinación»")
    n.js(busca, "")


def comprueba_tallas(n):
    navegador.accesible(n, "la galería")
    n.js("for (const d of document.querySelectorAll('details')) d.open = true")
    for ancho in (360, 800, 1920):
        n.talla(ancho, 800)
        navegador.nada_se_sale(n, "nada", ancho)


def main():
    with tempfile.TemporaryDirectory() as carpeta, navegador.chromium("--headless=new", "--disable-gpu") as n:
        destino = Path(carpeta, "galería (1)")
        dibuja = [sys.executable, "-B", RAIZ / "herramientas", "galeria.dibuja", RAIZ, BUILD, destino]
        if subprocess.run(dibuja).returncode:
            sys.exit("la galería no se ha dibujado entera")
        n.talla(1440, 900)
        n.abre(destino / "index.html")
        comprueba_imagenes(n)
        comprueba_vista_grande(n)
        if any(caso.anima for caso in CASOS):
            comprueba_animadas(n)
        comprueba_proyeccion(n)
        comprueba_textos(n)
        comprueba_buscador(n)
        gestos.de_la_galeria(n, lambda: n.abre(destino / "index.html"))
        comprueba_tallas(n)
        registro = n.registro()
        exige(not registro, f"la consola está vacía: {registro[:1]}")
    navegador.acaba()


if __name__ == "__main__":
    main()
