#!/usr/bin/env python3
"""firefox.py RAÍZ BUILD WEB: abre la página de los programas (./lab web) con file:// en Firefox y compara con el
golden, con --otro, lo que se ve al abrir diez programas: una captura de su lienzo. De tres, la historia de un píxel es
la de OSMesa; y otros tres se ven a la vez dentro de otra página.

En una pantalla de Xvfb: sin ninguna (--headless), Firefox no tiene WebGL 2.
"""
import base64
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import direcciones
import navegador
import usa_explica
import usa_incrustado
from navegador import PROGRAMAS, espera, exige

ELEGIDOS = "grua sombreado tetera volumen_vista sombras textura3d convolucion bezier superficie_bspline cubemap".split()
AJUSTES = """user_pref("webgl.force-enabled", true);
user_pref("gfx.x11-egl.force-enabled", true);
user_pref("marionette.port", 0);
"""
ABRE = """
pagina.escena.suavizado = false; // los golden no tienen muestras
const e = document.createElement('style');
e.textContent = `.escena { position: static }
  .lienzo { position: fixed; inset: 0 auto auto 0; z-index: 99; border: 0; border-radius: 0;
  width: 240px !important; height: 180px !important }`;
document.head.append(e);
location.hash = arguments[0];
"""


class Firefox:
    """Lo poco que hace falta de Marionette, su WebDriver de siempre: en un socket, cada mensaje de JSON con su longitud
    delante."""

    def __init__(self, perfil, entorno, *opciones):
        perfil.mkdir()
        (perfil / "user.js").write_text(AJUSTES)
        orden = [
            "firefox-esr",
            "--no-remote",
            "--marionette",
            "--profile",
            perfil,
            "--window-size",
            "1280,900",
            *opciones,
        ]
        suyo = {**entorno, "HOME": str(perfil), "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.proceso = subprocess.Popen(orden, env=suyo, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.pedidos = 0
        puerto, limite = perfil / "MarionetteActivePort", time.monotonic() + 120
        while not (puerto.exists() and puerto.read_text()):
            if self.proceso.poll() is not None or time.monotonic() > limite:
                self.proceso.kill()
                sys.exit("Firefox no arranca")
            time.sleep(0.1)
        self.canal = socket.create_connection(("127.0.0.1", int(puerto.read_text())), timeout=120).makefile("rwb")
        self.lee()  # el saludo
        self.pide("WebDriver:NewSession")

    def lee(self):
        cifras = b""
        while (letra := self.canal.read(1)) != b":":
            cifras += letra
        return json.loads(self.canal.read(int(cifras)))

    def pide(self, orden, **datos):
        self.pedidos += 1
        mensaje = json.dumps([0, self.pedidos, orden, datos]).encode()
        self.canal.write(b"%d:%s" % (len(mensaje), mensaje))
        self.canal.flush()
        _, _, error, resultado = self.lee()
        if error:
            raise RuntimeError(f"{orden}: {error['message']}")
        return resultado

    def js(self, codigo, *argumentos):
        # con eval: un guion de Marionette no ve las variables de la página
        llamada = f"(function () {{ {codigo} }})(...{json.dumps(argumentos)})"
        return self.pide("WebDriver:ExecuteScript", script="return window.eval(arguments[0])", args=[llamada])["value"]

    def tecla(self, *teclas):
        acciones = [{"type": tipo, "value": tecla} for tecla in teclas for tipo in ("keyDown", "keyUp")]
        self.pide("WebDriver:PerformActions", actions=[{"type": "key", "id": "teclado", "actions": acciones}])

    def captura(self, selector):
        elemento = self.pide("WebDriver:FindElement", using="css selector", value=selector)["value"]
        png = self.pide("WebDriver:TakeScreenshot", id=next(iter(elemento.values())), full=False)["value"]
        return subprocess.run("pngtopnm", input=base64.b64decode(png), capture_output=True, check=True).stdout

    def cierra(self):
        self.proceso.terminate()
        self.proceso.wait()


def va(f, url):
    f.pide("WebDriver:Navigate", url="about:blank")
    f.pide("WebDriver:Navigate", url=url)


def abre(f, pagina, enlace):
    va(f, pagina.as_uri())
    f.js(ABRE, enlace)
    arranca = espera(f, "return Boolean(pagina.escena.sesion?.vivo)")
    exige(arranca, f"{enlace} arranca")
    return arranca


def compara(f, pagina, programa):
    caso = programa.casos[0]
    if not abre(f, pagina, ";".join(["#" + programa.nombre, *filter(None, [caso.guion])])):
        return
    time.sleep(0.5)  # lo que tarda el navegador en enseñarlo
    es, dicho = navegador.como_golden(caso, f.captura("canvas"), True, caso.otro, "firefox")
    print(f"{caso.fichero}: {dicho}", flush=True)
    exige(es, f"{caso.fichero} es como su golden")


EXPLICADOS = ("grua", (120, 90), ""), ("espejo_plantilla", (65, 82), ""), ("zbuffer", (96, 86), "tecla z")


def explica(f, pagina):
    for nombre, (x, y), guion in EXPLICADOS:
        abre(f, pagina, f"#{nombre}/explica/{4 * x + 2},{4 * y + 2};{guion}")
        visto = "/^El píxel/.test(document.querySelector('.explicacion > h2')?.textContent)"
        exige(espera(f, f"return {visto}", 60), f"{nombre} se explica en Firefox")
        historia = direcciones.promesa(
            f,
            """const { historia } = await pagina.explica(pedido[0]);
            return historia.map(s => [s.orden, s.primitiva ?? -1, s.veredicto])""",
            [x, y],
        )
        debe = usa_explica.lo_que_dice("osmesa", PROGRAMAS[nombre], guion, (x, y))[0]
        exige(historia == debe, f"{nombre}: en Firefox la historia de ({x}, {y}) es {historia} y no {debe}")


def main():
    pagina = Path(sys.argv[3], "index.html").resolve()
    with navegador.pantalla(os.environ) as entorno, tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as carpeta:
        f = Firefox(Path(carpeta, "perfil"), entorno)
        try:
            for nombre in ELEGIDOS:
                compara(f, pagina, PROGRAMAS[nombre])
            explica(f, pagina)
            usa_incrustado.en_otra(f, lambda url: va(f, url), pagina, f.tecla)
        finally:
            f.cierra()
    navegador.acaba()


if __name__ == "__main__":
    main()
