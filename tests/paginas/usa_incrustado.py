"""Programas en marcha dentro de otra página, con la línea que da el botón: en un servidor de ficheros, tres a la
vez."""
import threading
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

from navegador import AVPAG, espera, exige

OTRA = "<!DOCTYPE html><title>Otra</title><body style='height: 4000px'><input id=suyo>{}<script>teclas = []; "
OTRA += "addEventListener('keydown', s => teclas.push(s.key))</script>"
ENLACES = "#grua;tecla d ×7", "#luces_animadas", "#espejo_plantilla;tecla p"
COPIA = """const value = { writeText: async texto => { copiado = texto } };
Object.defineProperty(navigator, 'clipboard', { configurable: true, value });
document.querySelector('.incrusta').click();"""
MARCOS = "const marcos = [0, 1, 2].map(i => frames[i]);"
ARRANCADAS = MARCOS + "return frames.length === 3 && marcos.every(f => f.pagina?.escena.sesion?.vivo)"


@contextmanager
def servida(web):
    """La carpeta de la página, y en /otra.html lo que se ponga en `puesto`: (dirección, puesto, lo que se descarga)."""
    puesto, descargado = {"otra": ""}, []

    class Sirve(SimpleHTTPRequestHandler):
        def __init__(self, *todo):
            super().__init__(*todo, directory=web.parent)

        def do_GET(self):
            if self.path != "/otra.html":
                return super().do_GET()
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(puesto["otra"].encode())

        def end_headers(self):
            self.send_header("Cache-Control", "max-age=60")  # lo que un servidor de ficheros suele decir
            super().end_headers()

        def log_message(self, *_):
            descargado.append(self.path)

    servidor = ThreadingHTTPServer(("127.0.0.1", 0), Sirve)
    threading.Thread(target=servidor.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{servidor.server_port}", puesto, descargado
    finally:
        servidor.shutdown()


def en_otra(n, va, web, tecla):
    """`va(dirección)` la abre; `tecla(…)` pulsa teclas de verdad."""
    with servida(web) as (raiz, puesto, descargado):
        lineas = []
        for enlace in ENLACES:
            va(f"{raiz}/index.html{enlace}")
            exige(espera(n, "return Boolean(window.pagina?.escena.sesion?.vivo)", 60), f"{enlace} arranca")
            n.js("window.copiado = ''; " + COPIA)
            exige(espera(n, "return Boolean(window.copiado)"), "la línea se copia")
            lineas.append(n.js("return copiado"))
        puesto["otra"] = OTRA.format("".join(lineas))
        descargado.clear()
        va(f"{raiz}/otra.html")
        exige(espera(n, ARRANCADAS, 90), f"arrancan los tres: {lineas}")
        pedidos = [ruta for ruta in descargado if "/datos/" in ruta]
        exige(len(pedidos) == len(set(pedidos)), f"lo que comparten se descarga una vez: {sorted(pedidos)}")
        hecho = n.js(
            MARCOS + "return marcos.map(f => f.pagina.escena.hecho.ordenes.filter(o => /^tecla/.test(o)).length)"
        )
        exige(hecho == [7, 0, 1], f"con lo que se había hecho: {hecho}")
        exige(
            n.js("return document.activeElement === document.body && scrollY === 0"), "sin quitar el foco a la página"
        )
        solos = """return marcos.every(f => [...f.document.body.querySelectorAll('*')]
            .filter(e => e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().width)
            .every(e => e.closest('.lienzo')) && f.document.querySelector('canvas').clientWidth === f.innerWidth)"""
        exige(n.js(MARCOS + solos), "y cada uno es solo su imagen, en todo su sitio")
        rueda = """const c = frames[0].document.querySelector('canvas');
            const como = { deltaY: 99, bubbles: true, cancelable: true };
            return !c.dispatchEvent(new frames[0].WheelEvent('wheel', como))"""
        exige(not n.js(rueda), "la rueda, sin haber entrado en él, mueve la página de fuera")
        n.js("frames[0].focus(); frames[0].document.querySelector('canvas').focus()")
        exige(n.js(rueda), "y habiendo entrado, es suya")
        for donde in ("canvas", "body"):
            n.js(
                "frames[0].document.activeElement.blur(); frames[0].document.querySelector(arguments[0]).focus()", donde
            )
            tecla("d", " ", AVPAG, "p", "x", "/")
        exige(
            n.js("return teclas.length === 0 && scrollY === 0 && !document.fullscreenElement"),
            "sus teclas no salen de él",
        )
        ordenes = n.js("return frames[0].pagina.escena.hecho.ordenes")
        exige(ordenes.count("tecla d") >= 8 and "especial AVPAG" in ordenes, f"y le llegan: {ordenes}")
        n.js("document.querySelector('#suyo').focus()")
        tecla("d")
        exige(n.js("return teclas.join() === 'd' && suyo.value === 'd'"), "y las de la página de fuera son de ella")


def incrustado(p):
    con_direccion(p)

    def va(url):
        for una in ("about:blank", url):  # si solo cambia el enlace no se vuelve a cargar
            p.n.pide("/url", url=una)

    en_otra(p.n, va, p.web, p.n.tecla)
    p.n.registro()  # a /favicon.ico no hay quien responda


def con_direccion(p):
    """También se escribe a mano, y lo que no hay se dice."""
    p.abre("#incrusta/grua?tecla=d&tecla=d")
    p.ve(
        "document.body.classList.contains('incrustado') && hecho.ordenes.length === 2",
        "la dirección lleva lo que se hace",
    )
    p.va_a(p.da("una('.suelto').hash"))
    p.exige("!document.body.classList.contains('incrustado') && hecho?.ordenes.length === 2", "y lo mismo en su página")
    p.va_a("#incrusta/no_esta")
    p.exige("!una('#no-esta').hidden && !document.body.classList.contains('incrustado')", "lo que no está se dice")
