"""Lo que una persona hace en la página de los programas, con teclas, ratón y dedos, y lo que ve en ella."""
import base64

import navegador
from navegador import CASOS, ESC, espera, exige

# Lo que nombran los guiones de las pruebas, que se ejecutan en la página.
NOMBRES = """const todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
const una = (selector, raiz = document) => raiz.querySelector(selector);
const conTexto = (selector, texto) => todos(selector).find(e => e.textContent === texto);
const { escena, editor, visto, empiezaCaso } = pagina, { sesion, hecho, errores } = escena, { cm } = editor;
const telon = una('.telon'), consola = una('.consola'), marco = una('.lienzo'), estado = una('.fichero-estado');
"""
# El contenido de un fichero del programa, en base64.
FICHERO = "let t = ''; for (const b of sesion.lee(arguments[0])) t += String.fromCharCode(b); return btoa(t)"
ABRE = """escena.suavizado = false; // los golden no tienen muestras
const e = document.createElement('style');
e.textContent = `.lienzo { ${arguments[0]} !important }`;
document.head.append(e);
location.hash = arguments[1]"""
SUELTA_FICHERO = """const datos = new DataTransfer();
datos.items.add(new File([Uint8Array.from(atob(arguments[1]), c => c.charCodeAt(0))], arguments[0]));
marco.dispatchEvent(new DragEvent('drop', { dataTransfer: datos, bubbles: true, cancelable: true }))"""


def va(x, y, dura=0):
    return {"type": "pointerMove", "duration": dura, "x": x, "y": y}


def baja(boton=0):
    return {"type": "pointerDown", "button": boton}


def sube(boton=0):
    return {"type": "pointerUp", "button": boton}


class Persona:
    """El lienzo mide 240×180, como los golden."""

    def __init__(self, n, web):
        self.n, self.web = n, web

    # --- en la página ---

    def js(self, codigo, *argumentos):
        return self.n.js(NOMBRES + codigo, *argumentos)

    def espera_js(self, codigo, *argumentos):
        return self.n.espera_js(NOMBRES + codigo, *argumentos)

    def da(self, expresion):
        return self.js(f"return {expresion}")

    def espera(self, condicion):
        return espera(self, f"return Boolean({condicion})")

    def exige(self, condicion, que):
        """Que acabe cumpliéndose."""
        exige(self.espera(condicion), que)

    def ve(self, condicion, que):
        """Que se cumpla ya."""
        exige(self.da(condicion), que)

    def abre(self, enlace, talla="width: 240px; height: 180px"):
        self.n.abre(self.web)
        self.js(ABRE, talla, enlace)
        self.exige("sesion?.vivo", f"{enlace[:99]} arranca")

    def va_a(self, enlace):
        self.js("location.hash = arguments[0]", enlace)

    def termina(self, enlace):
        self.abre(enlace)
        self.js("una('canvas').focus()")
        self.n.tecla(ESC)
        self.exige("!telon.hidden && /ha terminado/.test(telon.textContent)", f"{enlace}: Esc termina y se dice")

    # --- lo que se ve ---

    def imagen(self):
        self.js("escena.gestos.suelta(); sesion.orden('captura /imagen.ppm')")
        return base64.b64decode(self.js(FICHERO, "/imagen.ppm"))

    def es(self, fichero, que):
        caso = next(c for c in CASOS if c.fichero == fichero)
        es, dicho = navegador.como_golden(caso, self.imagen(), False, "", "web")
        exige(es, f"{que} deja {fichero}: {dicho}")

    # --- ratón, dedos y ficheros ---

    def actua(self, tipo, *acciones):
        comun = {"type": "pointer", "parameters": {"pointerType": tipo}}
        self.n.pide("/actions", actions=[{"id": f"{tipo}{i}", "actions": a, **comun} for i, a in enumerate(acciones)])

    def lienzo(self):
        self.js("scrollTo(0, 0)")
        return self.js(
            "const r = una('canvas').getBoundingClientRect(); return [Math.round(r.left), Math.round(r.top)]"
        )

    def arrastra(self, puntos, boton=0, dedo=False):
        x0, y0 = self.lienzo()
        primero, *resto = [va(x0 + int(x), y0 + int(y), 40) for x, y in puntos]
        self.actua("touch" if dedo else "mouse", [primero, baja(boton), *resto, sube(boton)])

    def pinza(self, antes, despues):
        x0, y0 = self.lienzo()
        x, y = x0 + 120, y0 + 90
        dedos = [[va(x + lado * antes, y), baja(), va(x + lado * despues, y, 50), sube()] for lado in (-1, 1)]
        self.actua("touch", *dedos)

    def rueda(self, x, y, cuanto):
        x0, y0 = self.lienzo()
        giro = {"type": "scroll", "x": x0 + x, "y": y0 + y, "deltaX": 0, "deltaY": cuanto, "duration": 0}
        self.n.pide("/actions", actions=[{"type": "wheel", "id": "rueda", "actions": [giro]}])

    def pulsa(self, selector):
        """Un clic de verdad: hay cosas que el navegador no deja hacer sin él."""
        x, y = self.js(
            """const b = una(arguments[0]);
            b.scrollIntoView({ block: 'center' });
            const r = b.getBoundingClientRect();
            return [r.x + 9, r.y + 9].map(Math.round)""",
            selector,
        )
        self.actua("mouse", [va(x, y), baja(), sube()])

    def elige(self, selector, texto):
        """Pulsa el botón de ese texto."""
        self.js("conTexto(...arguments).click()", selector, texto)

    def escribe(self, donde, texto):
        """Como quien teclea al principio de la línea `donde` (desde 1) del editor."""
        self.js(
            """const lugar = { line: arguments[0] - 1, ch: 0 };
            cm.scrollIntoView(lugar);
            cm.replaceRange(arguments[1], lugar, undefined, '+input')""",
            donde,
            texto,
        )

    def suelta_fichero(self, nombre, datos):
        self.js(SUELTA_FICHERO, nombre, base64.b64encode(datos).decode())
