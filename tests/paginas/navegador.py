"""Lo que comparten las pruebas de las páginas, que se llaman con RAÍZ BUILD delante de lo suyo: abrir Chromium,
esperar, apuntar lo que falla y comparar una imagen con su golden."""
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

RAIZ, BUILD = (Path(ruta).resolve() for ruta in sys.argv[1:3])
PROGRAMAS = {p.nombre: p for p in catalogo.lee_programas(BUILD)}
CASOS = [caso for p in PROGRAMAS.values() if not p.consola for caso in p.casos]

ESC, TAB, AVPAG, IZQUIERDA, DERECHA = "\ue00c", "\ue004", "\ue00f", "\ue012", "\ue014"  # teclas de WebDriver
INICIO, FIN = "\ue011", "\ue010"
AXE = "4.10.2"
AXE_SHA512 = (
    "444de6750ecfdc54527bb7aa096a1e43f67d417aed9e24a3a75c148ede67442d"
    "d6229cf9ad20af7baa377ec676682a49b6b663499823c170284cee64e2d108d3"
)


class Navegador:
    """Chromium, y lo poco de WebDriver que hace falta, sin más biblioteca que la de Python."""

    def __init__(self, perfil, opciones, entorno):
        self.chromedriver = subprocess.Popen(
            ["chromedriver", "--port=0"],
            stdout=subprocess.PIPE,
            text=True,
            env={**entorno, "TMPDIR": str(perfil.parent)},
        )
        puerto = next(m[1] for linea in self.chromedriver.stdout if (m := re.search(r"on port (\d+)\.", linea)))
        self.sesion = f"http://127.0.0.1:{puerto}/session"
        # sin el freno, que desoye una dirección si ha habido doscientas en diez segundos
        freno = "--disable-ipc-flooding-protection"
        argumentos = [*opciones, freno, "--no-sandbox", f"--user-data-dir={perfil}"]
        capacidades = {"goog:chromeOptions": {"args": argumentos}, "goog:loggingPrefs": {"browser": "ALL"}}
        self.sesion += "/" + self.pide("", capabilities={"alwaysMatch": capacidades})["sessionId"]

    def pide(self, ruta, metodo="POST", **datos):
        cuerpo = json.dumps(datos).encode() if metodo == "POST" else None
        cabeceras = {"Content-Type": "application/json"}
        peticion = urllib.request.Request(self.sesion + ruta, cuerpo, cabeceras, method=metodo)
        try:
            with urllib.request.urlopen(peticion, timeout=300) as respuesta:
                return json.load(respuesta)["value"]
        except urllib.error.HTTPError as error:  # chromedriver dice por qué en la respuesta
            raise RuntimeError(f"{ruta}: {json.load(error)['value']['message']}") from None

    def js(self, codigo, *argumentos):
        return self.pide("/execute/sync", script=codigo, args=argumentos)

    def espera_js(self, codigo, *argumentos):
        """Lo que acaba dando un código asíncrono."""
        funcion = f"(async function () {{ {codigo} }}).apply(null, arguments)"
        guion = f"const acaba = [...arguments].pop(); {funcion}.then(acaba, error => acaba(String(error)))"
        return self.pide("/execute/async", script=guion, args=argumentos)

    def devtools(self, orden, **opciones):
        return self.pide("/goog/cdp/execute", cmd=orden, params=opciones)

    def abre(self, fichero, enlace=""):
        self.pide("/url", url="about:blank")  # si solo cambia el enlace no se vuelve a cargar
        self.pide("/url", url=fichero.as_uri() + enlace)

    def tecla(self, *teclas):
        acciones = [{"type": tipo, "value": tecla} for tecla in teclas for tipo in ("keyDown", "keyUp")]
        self.pide("/actions", actions=[{"type": "key", "id": "teclado", "actions": acciones}])

    def talla(self, ancho, alto, densidad=1):
        como = {"deviceScaleFactor": densidad, "mobile": ancho < 500}
        self.devtools("Emulation.setDeviceMetricsOverride", width=ancho, height=alto, **como)

    def foto(self):
        return self.pide("/screenshot", "GET")

    def registro(self):
        """Lo que ha escrito en su consola desde la última vez."""
        return [linea["message"] for linea in self.pide("/se/log", type="browser")]

    def cierra(self):
        try:
            self.pide("", "DELETE")
        finally:
            self.chromedriver.terminate()
            self.chromedriver.wait()


@contextmanager
def chromium(*opciones, entorno=os.environ):
    """Un Navegador con un perfil vacío."""
    with tempfile.TemporaryDirectory() as carpeta:
        navegador = Navegador(Path(carpeta, "perfil"), opciones, entorno)
        try:
            yield navegador
        finally:
            navegador.cierra()


@contextmanager
def pantalla(entorno):
    """El entorno con una pantalla de Xvfb, que se cierra al acabar."""
    orden = ["Xvfb", "-displayfd", "1", "-screen", "0", "1920x1200x24", "-nolisten", "tcp"]
    xvfb = subprocess.Popen(orden, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        yield {**entorno, "DISPLAY": ":" + xvfb.stdout.readline().strip()}
    finally:
        xvfb.terminate()
        xvfb.wait()


# --- lo que se exige ------------------------------------------------------------------------------------------------

fallos = []


def exige(condicion, que):
    if not condicion:
        fallos.append(que)
        print(f"falla: {que}", flush=True)
        if os.environ.get("LAB_AL_PRIMERO"):  # a quien planta un defecto le basta
            acaba()


def acaba():
    """Con todo lo que ha fallado junto, al final de lo escrito."""
    sys.exit("Ha fallado:\n" + "\n".join(fallos) if fallos else 0)


def espera(navegador, codigo, segundos=90):
    """Lo que acaba dando; con la máquina ocupada, lo que se ve en un segundo tarda mucho más."""
    limite = time.monotonic() + segundos
    while not navegador.js(codigo) and time.monotonic() < limite:
        time.sleep(0.1)
    return navegador.js(codigo)


def como_golden(caso, ppm, otro, tolerancia, deja):
    """Si esa imagen es como el golden del caso, y lo que dice el comparador. `otro`: si es de otro OpenGL."""
    fallos_en = BUILD / "fallos" / deja
    fallos_en.mkdir(parents=True, exist_ok=True)
    golden = RAIZ / "tests/golden" / caso.programa.capitulo.nombre / f"{caso.fichero}.ppm"
    compara = BUILD / "herramientas/comparador/compara"
    opciones = ["--otro" if otro else "--amplia", "--deja", fallos_en / caso.fichero]
    if tolerancia:
        opciones += ["--tolerancia", tolerancia]
    with tempfile.NamedTemporaryFile(suffix=".ppm") as obtenida:
        obtenida.write(ppm)
        obtenida.flush()
        c = subprocess.run([compara, golden, obtenida.name, *opciones], capture_output=True, text=True)
    return c.returncode == 0, (c.stdout + c.stderr).strip()


def proyectable(n, selector):
    """En una pantalla de 1080 líneas, los textos de ese elemento se leen desde la última fila: 28 píxeles o más."""
    textos = f"[...document.querySelector('{selector}').querySelectorAll('h2, p, output, .mando span')]"
    chicos = n.js(
        f"""const letra = e => getComputedStyle(e).fontSize;
        return {textos}.filter(e => e.offsetParent && e.textContent.trim() && parseFloat(letra(e)) < 28)
          .map(e => e.className + ' ' + letra(e))"""
    )
    exige(not chicos, f"proyectado se lee todo: {chicos}")


def axe():
    """El guion de axe-core, que no es de Debian; se guarda en BUILD para otra vez."""
    guardado = BUILD / f"axe-core-{AXE}.js"
    if not guardado.is_file():
        url = f"https://registry.npmjs.org/axe-core/-/axe-core-{AXE}.tgz"
        with urllib.request.urlopen(url, timeout=60) as respuesta:
            paquete = respuesta.read()
        assert hashlib.sha512(paquete).hexdigest() == AXE_SHA512, "axe-core no es el que era"
        with tarfile.open(fileobj=io.BytesIO(paquete)) as tar:
            procesos.escribe(guardado, tar.extractfile("package/axe.min.js").read())
    return guardado.read_text()


def accesible(n, que):
    """Sin nada que axe-core tenga por serio."""
    n.js(axe())
    hallado = n.espera_js(
        """// lo que no cabe en el editor se recorre desde su textarea, que está al lado
        const delEditor = v => v.id === 'scrollable-region-focusable' &&
          v.nodes.every(n => n.target[0].endsWith('.CodeMirror-scroll'));
        const { violations } = await axe.run();
        return violations.filter(v => ['serious', 'critical'].includes(v.impact) && !delEditor(v))
          .map(v => `${v.id} (${v.nodes.length}): ${v.nodes[0].target} ${v.nodes[0].failureSummary}`)"""
    )
    exige(not hallado, f"{que} es para todos: {hallado}")


def nada_se_sale(n, que, ancho):
    """Ni con el texto del navegador al doble, que es lo que cambia quien ve poco."""
    pon_letra = (
        "document.documentElement.style.fontSize = arguments[0]; return getComputedStyle(document.body).fontSize"
    )
    for texto, esperada in (("200%", "32px"), ("100%", "16px")):
        letra = n.js(pon_letra, texto)
        exige(letra == esperada, f"el texto, al {texto}, es de {letra}")
        cabe = n.js(f"return document.documentElement.scrollWidth <= {ancho}")
        exige(cabe, f"{que} se sale de {ancho} píxeles, con el texto al {texto}")
