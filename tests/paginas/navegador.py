#!/usr/bin/env python3
"""navegador.py RAÍZ BUILD: dibuja la galería en una carpeta temporal y la recorre en Chromium, abierta con file://.

Todas las imágenes cargan, y las animadas se mueven, salvo para quien pide menos movimiento; la vista grande se abre, pasa con las flechas y se cierra con Esc; el buscador encuentra con
acentos y sin ellos; los fuentes se ven; nada se sale de un teléfono de 360 píxeles, ni con el texto al doble; la consola no da ningún error.
"""
import hashlib
import io
import json
import os
import re
import subprocess
import sys
import tarfile
import tempfile
import time
import urllib.error
import urllib.request
from contextlib import contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
from base import catalogo, procesos

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


@contextmanager
def pantalla(entorno):
    """El entorno con una pantalla de Xvfb, que se cierra al acabar."""
    xvfb = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "1920x1200x24", "-nolisten", "tcp"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                            text=True)
    try:
        yield {**entorno, "DISPLAY": ":" + xvfb.stdout.readline().strip()}
    finally:
        xvfb.terminate()
        xvfb.wait()


fallos = []
AXE = "4.10.2", "444de6750ecfdc54527bb7aa096a1e43f67d417aed9e24a3a75c148ede67442dd6229cf9ad20af7baa377ec676682a49b6b663499823c170284cee64e2d108d3"


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


def proyectable(n, selector):
    """En una pantalla de 1080 líneas, los textos de ese elemento miden 28 píxeles o más: se leen desde la última fila."""
    chicos = n.js("""return [...arguments[0].querySelectorAll('h2, p, output, .mando span')].filter(e => e.offsetParent && e.textContent.trim() &&
        parseFloat(getComputedStyle(e).fontSize) < 28).map(e => e.className + ' ' + getComputedStyle(e).fontSize)""".replace(
            "arguments[0]", f"document.querySelector('{selector}')"))
    exige(not chicos, f"proyectado se lee todo: {chicos}")


def axe():
    """El guion de axe-core, que no es de Debian; se guarda en BUILD para otra vez."""
    guardado = Path(sys.argv[2], f"axe-core-{AXE[0]}.js")
    if not guardado.is_file():
        with urllib.request.urlopen(f"https://registry.npmjs.org/axe-core/-/axe-core-{AXE[0]}.tgz", timeout=60) as respuesta:
            paquete = respuesta.read()
        assert hashlib.sha512(paquete).hexdigest() == AXE[1], "axe-core no es el que era"
        with tarfile.open(fileobj=io.BytesIO(paquete)) as tar:
            procesos.escribe(guardado, tar.extractfile("package/axe.min.js").read())
    return guardado.read_text()


def accesible(n, que):
    """Sin nada que axe-core tenga por serio."""
    n.js(axe())
    hallado = n.pide("/execute/async", script="""const acaba = arguments[0];
        // lo que no cabe en el editor se recorre desde su textarea, que está al lado
        const delEditor = v => v.id === 'scrollable-region-focusable' && v.nodes.every(n => n.target[0].endsWith('.CodeMirror-scroll'));
        axe.run().then(r => acaba(r.violations.filter(v => ['serious', 'critical'].includes(v.impact) && !delEditor(v))
          .map(v => `${v.id} (${v.nodes.length}): ${v.nodes[0].target} ${v.nodes[0].failureSummary}`)))""", args=[])
    exige(not hallado, f"{que} es para todos: {hallado}")


def nada_se_sale(n, que, ancho):
    """Ni con el texto del navegador al doble, que es lo que cambia quien ve poco."""
    for texto in ("200%", "100%"):
        letra = n.js("document.documentElement.style.fontSize = arguments[0]; return getComputedStyle(document.body).fontSize", texto)
        exige(letra == ("32px" if texto == "200%" else "16px"), f"el texto, al {texto}, es de {letra}")
        exige(n.js(f"return document.documentElement.scrollWidth <= {ancho}"), f"{que} se sale de {ancho} píxeles, con el texto al {texto}")


def recorre(n, pagina, casos, animados):
    n.talla(1440, 900)
    n.pide("/url", url=pagina.as_uri())
    n.js("for (const i of document.images) i.loading = 'eager'")
    exige(espera(n, "return [...document.querySelectorAll('figure img')].every(i => i.complete)"), "las imágenes acaban de cargar")
    for anchura, cuantas, cuales in ((1440, casos - animados, "quietas"), (480, animados, "animadas")):
        exige(n.js(f"return [...document.querySelectorAll('figure:not(.captura) img')].filter(i => i.naturalWidth === {anchura}).length") == cuantas,
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
        exige(espera(n, "return [...document.querySelectorAll('figure:not(.captura) img')].every(i => i.complete && i.naturalWidth === 1440)"),
              "con menos movimiento, todas están quietas")
        n.menos_movimiento(False)

    n.talla(1920, 1080)
    n.js("document.querySelector('#grua').scrollIntoView()")
    n.tecla("p")
    exige(espera(n, "return document.fullscreenElement && document.querySelector('dialog').open") and n.js(titulo).startswith("Grúa de obra"), "p proyecta lo que se está viendo")
    exige("giran" in n.js("return document.querySelector('dialog .mandos').textContent"), "con sus controles")
    proyectable(n, "dialog")
    n.tecla("\ue00f")  # AvPág, la de los mandos de presentación
    exige(n.js(titulo).startswith("Grúa de obra: girada"), "AvPág pasa a la siguiente")
    n.tecla("p")
    exige(espera(n, "return !document.fullscreenElement"), "p deja la pantalla completa")
    n.tecla(ESC)
    n.talla(1440, 900)

    libro = "return document.querySelector('#grua .{}').textContent"
    exige("cubos de lado uno" in n.js(libro.format("enunciado")) and "Cinco cubos" in n.js(libro.format("respuesta")), "el ejercicio de la grúa y su respuesta")
    exige(n.js("return document.querySelector('#shader_basico .erratas').textContent").count("Listado 1.3") == 3, "las erratas del listado 1.3")
    exige(n.js("return document.querySelector('#grua abbr').title") == "ejercicio 3.5: la grúa de obra", "qué es E3.5")

    n.tecla("/")
    for letra in "grua obra":
        n.tecla(letra)
    visibles = "return [...document.querySelectorAll('article')].filter(a => a.offsetParent).map(a => a.id)"
    exige(n.js(visibles) == ["grua"], "«grua obra» encuentra solo la grúa de obra")
    busca = "const i = document.querySelector('input'); i.value = '{}'; i.dispatchEvent(new Event('input'))"
    n.js(busca.format("INCLINACION"))
    exige("camara" in n.js(visibles) and "tiras" not in n.js(visibles), "«INCLINACION» encuentra «inclinación»")
    n.js(busca.format(""))
    n.js("document.querySelector('#grua .fuentes').open = true")
    exige(espera(n, "return document.querySelector('#grua pre').textContent.includes('glutMainLoop')"), "el fuente se ve")

    accesible(n, "la galería")
    n.js("for (const d of document.querySelectorAll('details')) d.open = true")
    for ancho in (360, 800, 1920):
        n.talla(ancho, 800)
        nada_se_sale(n, "nada", ancho)
    registro = n.pide("/se/log", type="browser")
    exige(not registro, f"la consola está vacía: {registro[:1]}")


def main():
    raiz, build = map(Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as carpeta:
        destino = Path(carpeta, "galería (1)")
        if subprocess.run([sys.executable, "-B", raiz / "herramientas", "galeria.dibuja", raiz, build, destino]).returncode:
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
