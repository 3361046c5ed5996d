#!/usr/bin/env python3
"""navegador.py RAÍZ BUILD: dibuja la galería en una carpeta temporal y la recorre en Chromium, abierta con file://.

Todas las imágenes cargan, y las animadas se mueven, salvo para quien pide menos movimiento; la vista grande se abre, pasa con las flechas y se cierra con Esc; el buscador encuentra con
acentos y sin ellos; los fuentes se ven; nada se sale de un teléfono de 360 píxeles; la consola no da ningún error.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
import catalogo

ESC, IZQUIERDA, DERECHA = "\ue00c", "\ue012", "\ue014"  # teclas de WebDriver


class Navegador:
    """Lo poco de WebDriver que hace falta, sin más biblioteca que la de Python."""

    def __init__(self, perfil, opciones=("--headless=new", "--disable-gpu"), entorno=os.environ):
        self.chromedriver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True,
                                             env={**entorno, "TMPDIR": str(perfil.parent)})
        puerto = next(m[1] for linea in self.chromedriver.stdout if (m := re.search(r"on port (\d+)\.", linea)))
        self.sesion = f"http://127.0.0.1:{puerto}/session"
        argumentos = [*opciones, "--no-sandbox", f"--user-data-dir={perfil}"]
        capacidades = {"goog:chromeOptions": {"args": argumentos}, "goog:loggingPrefs": {"browser": "ALL"}}
        self.sesion += "/" + self.pide("", capabilities={"alwaysMatch": capacidades})["sessionId"]

    def pide(self, ruta, metodo="POST", **datos):
        cuerpo = json.dumps(datos).encode() if metodo == "POST" else None
        peticion = urllib.request.Request(self.sesion + ruta, cuerpo, {"Content-Type": "application/json"}, method=metodo)
        try:
            with urllib.request.urlopen(peticion, timeout=60) as respuesta:
                return json.load(respuesta)["value"]
        except urllib.error.HTTPError as error:  # chromedriver dice por qué en la respuesta
            raise RuntimeError(f"{ruta}: {json.load(error)['value']['message']}") from None

    def js(self, codigo, *argumentos):
        return self.pide("/execute/sync", script=codigo, args=argumentos)

    def tecla(self, tecla):
        acciones = [{"type": tipo, "value": tecla} for tipo in ("keyDown", "keyUp")]
        self.pide("/actions", actions=[{"type": "key", "id": "teclado", "actions": acciones}])

    def talla(self, ancho, alto):
        self.pide("/goog/cdp/execute", cmd="Emulation.setDeviceMetricsOverride",
                  params={"width": ancho, "height": alto, "deviceScaleFactor": 1, "mobile": ancho < 500})

    def menos_movimiento(self, si):
        self.pide("/goog/cdp/execute", cmd="Emulation.setEmulatedMedia",
                  params={"features": [{"name": "prefers-reduced-motion", "value": "reduce" if si else ""}]})

    def foto(self):
        return self.pide("/screenshot", "GET")

    def cierra(self):
        try:
            self.pide("", "DELETE")
        finally:
            self.chromedriver.terminate()
            self.chromedriver.wait()


fallos = []


def exige(condicion, que):
    if not condicion:
        fallos.append(que)
        print(f"falla: {que}")


def acaba():
    """Con todo lo que ha fallado junto, al final de lo escrito."""
    sys.exit("Ha fallado:\n" + "\n".join(fallos) if fallos else 0)


def espera(navegador, codigo):
    limite = time.monotonic() + 20
    while not navegador.js(codigo) and time.monotonic() < limite:
        time.sleep(0.1)
    return navegador.js(codigo)


def recorre(n, pagina, casos, animados):
    n.talla(1440, 900)
    n.pide("/url", url=pagina.as_uri())
    n.js("for (const i of document.images) i.loading = 'eager'")
    exige(espera(n, "return [...document.querySelectorAll('figure img')].every(i => i.complete)"), "las imágenes acaban de cargar")
    for anchura, cuantas, cuales in ((960, casos - animados, "quietas"), (480, animados, "animadas")):
        exige(n.js(f"return [...document.querySelectorAll('figure img')].filter(i => i.naturalWidth === {anchura}).length") == cuantas,
              f"hay {cuantas} imágenes {cuales} de {anchura} píxeles")

    titulo = "return document.querySelector('dialog h2').textContent"
    grande = "return document.querySelector('dialog').open"
    n.js("document.querySelectorAll('figure a')[1].click()")
    exige(n.js(grande), "una imagen pulsada se ve en grande")
    segundo = n.js(titulo)
    n.tecla(DERECHA)
    tercero = n.js(titulo)
    exige(tercero and tercero != segundo, "→ pasa a la siguiente")
    n.tecla(IZQUIERDA)
    exige(n.js(titulo) == segundo, "← vuelve a la anterior")
    n.tecla(IZQUIERDA)
    n.tecla(IZQUIERDA)
    exige(n.js("return actual === document.querySelector('figure a')"), "← en la primera se queda en ella")
    alto = n.js("return document.querySelector('dialog img').getBoundingClientRect().height")
    exige(alto > 700, f"en una ventana de 900 la imagen grande mide {alto}")
    n.tecla(ESC)
    exige(not n.js(grande), "Esc cierra la vista grande")

    if animados:
        n.js("document.querySelector('figure source').parentElement.parentElement.click()")
        fuente = "return document.querySelector('dialog img').currentSrc"
        exige(espera(n, f"{fuente}.endsWith('.anima.png')"), "la vista grande de una animada también se mueve")
        exige(n.js("return document.querySelector('dialog img').getBoundingClientRect().bottom <= "
                   "document.querySelector('.pie').getBoundingClientRect().top + 1 && "
                   "document.querySelector('.pie').getBoundingClientRect().bottom <= innerHeight"), "y cabe entera sobre su pie")
        primero, cambia = n.foto(), False
        for _ in range(20):
            time.sleep(0.1)
            cambia = cambia or n.foto() != primero
        exige(cambia, "una animada cambia con el tiempo")
        n.tecla(ESC)
        n.menos_movimiento(True)
        exige(espera(n, "return [...document.querySelectorAll('figure img')].every(i => i.complete && i.naturalWidth === 960)"),
              "con menos movimiento, todas están quietas")
        n.menos_movimiento(False)

    n.tecla("/")
    for letra in "grua obra":
        n.tecla(letra)
    visibles = "return [...document.querySelectorAll('article')].filter(a => a.offsetParent).map(a => a.id)"
    exige(n.js(visibles) == ["grua"], "«grua obra» encuentra solo la grúa de obra")
    busca = "const i = document.querySelector('input'); i.value = '{}'; i.dispatchEvent(new Event('input'))"
    n.js(busca.format("INCLINACION"))
    exige("camara" in n.js(visibles) and "tiras" not in n.js(visibles), "«INCLINACION» encuentra «inclinación»")
    n.js(busca.format(""))
    n.js("document.querySelector('#grua details').open = true")
    exige(espera(n, "return document.querySelector('#grua pre').textContent.includes('glutMainLoop')"), "el fuente se ve")

    n.js("for (const d of document.querySelectorAll('details')) d.open = true")
    for ancho in (360, 800, 1920):
        n.talla(ancho, 800)
        exige(n.js(f"return document.documentElement.scrollWidth <= {ancho}"), f"nada se sale de {ancho} píxeles")
    registro = n.pide("/se/log", type="browser")
    exige(not registro, f"la consola está vacía: {registro[:1]}")


def main():
    raiz, build = map(Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as carpeta:
        destino = Path(carpeta, "galería (1)")
        if subprocess.run([sys.executable, "-B", raiz / "herramientas/galeria.py", raiz, build, destino]).returncode:
            sys.exit("la galería no se ha dibujado entera")
        navegador = Navegador(Path(carpeta, "perfil"))
        try:
            casos = [c for p in catalogo.lee_programas(build) if not p.consola for c in p.casos]
            recorre(navegador, destino / "index.html", len(casos), sum(bool(caso.anima) for caso in casos))
        finally:
            navegador.cierra()
    acaba()


if __name__ == "__main__":
    main()
