#!/usr/bin/env python3
"""comprueba_web.py RAÍZ BUILD WEB [caso… | persona | ejercicios]: la página de los programas (./lab web), en Chromium sobre llvmpipe y abierta con file://.
Con LAB_OPENGL=swiftshader, sobre el SwiftShader que lleva dentro, y solo los casos, con el comparador en --otro.

Cada caso del catálogo se dibuja con su guion y se compara con su golden, con el comparador y la tolerancia de siempre. Después,
lo que hace una persona: teclas, ratón, dedos, botones, menú y enlaces, también contra los golden; un shader cambiado bien y
mal; los ejercicios; ficheros buenos y malos; enlaces hostiles, descargas que fallan y lo que se hace mientras se carga; una ventana diminuta y una
enorme; y el contexto perdido y devuelto.
"""
import base64
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import navegador  # que sabe dónde está catalogo
from navegador import Navegador, catalogo, espera, exige, procesos

# De lo demás, SwiftShader no vale de juez: con polygon offset sus mallas cambian de una vez a otra.
SWIFTSHADER = os.environ.get("LAB_OPENGL") == "swiftshader"
ANGLE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader") if SWIFTSHADER else ("--use-angle=gl",)
OPCIONES = (
    "--use-gl=angle",
    *ANGLE,
    "--ignore-gpu-blocklist",
    "--disable-gpu-watchdog",
    "--window-size=1280,900",
    "--no-first-run",
)

DIBUJA = """
const [nombre, guion, acaba] = arguments;
(async () => {
  const programa = PROGRAMAS.find(p => p.nombre === nombre), escrito = [];
  const s = await arranca(programa, { lienzo: document.createElement('canvas'), ancho: 240, alto: 180, suavizado: false,
    di: linea => escrito.push(linea) });
  s.orden(guion);
  s.orden('captura /imagen.ppm');
  const bien = s.vivo;
  let texto = '';
  if (bien) for (const b of s.lee('/imagen.ppm')) texto += String.fromCharCode(b);
  s.cierra();
  return { bien, escrito: escrito.join('\\n'), ppm: btoa(texto) };
})().then(acaba, error => acaba({ bien: false, escrito: String(error), ppm: '' }));
"""

OPENGL = "const gl = document.createElement('canvas').getContext('webgl2'); return gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL)"


def lee_casos(build):
    return [caso for programa in catalogo.lee_programas(build) if not programa.consola for caso in programa.casos]


def compara(raiz, build, capitulo, fichero, ppm, carpeta, tolerancia=""):
    obtenida = carpeta / f"{fichero}.ppm"
    obtenida.write_bytes(base64.b64decode(ppm))
    fallos = build / "fallos/web"
    fallos.mkdir(parents=True, exist_ok=True)
    opciones = ["--tolerancia", tolerancia] if tolerancia else []
    return subprocess.run(
        [
            build / "herramientas/comparador/compara",
            raiz / "tests/golden" / capitulo / f"{fichero}.ppm",
            obtenida,
            "--otro" if SWIFTSHADER else "--amplia",
            "--deja",
            fallos / fichero,
            *opciones,
        ],
        capture_output=True,
        text=True,
    )


def compara_casos(n, raiz, build, carpeta, pedidos):
    bien = total = 0
    for caso in lee_casos(build):
        capitulo, programa, fichero = caso.programa.capitulo.nombre, caso.programa.nombre, caso.fichero
        if pedidos and fichero not in pedidos and programa not in pedidos:
            continue
        total += 1
        r = n.pide("/execute/async", script=DIBUJA, args=[programa, caso.guion])
        if not r["bien"]:
            exige(False, f"{fichero} se dibuja: {r['escrito']}")
            continue
        c = compara(raiz, build, capitulo, fichero, r["ppm"], carpeta, caso.otro if SWIFTSHADER else caso.tolerancia)
        print(f"{fichero}: {(c.stdout + c.stderr).strip()}", flush=True)
        bien += c.returncode == 0
        exige(c.returncode == 0, f"{fichero} es como su golden")
    print(f"{bien} de {total} casos como su golden; {n.js(OPENGL)}")


class Persona:
    """Lo que se hace en la página con teclas, ratón y dedos. El lienzo mide 240×180, como los golden."""

    def __init__(self, n, raiz, build, pagina, carpeta):
        self.n, self.raiz, self.build, self.pagina, self.carpeta = n, raiz, build, pagina, carpeta

    def abre(self, enlace, talla="width: 240px; height: 180px"):
        self.n.pide("/url", url="about:blank")
        self.n.pide("/url", url=self.pagina.as_uri())
        self.n.js(
            """suavizado = false; // los golden no tienen muestras
            const e = document.createElement('style'); e.textContent = `.lienzo { ${arguments[0]} !important }`;
            document.head.append(e); location.hash = arguments[1]""",
            talla,
            enlace,
        )
        exige(self.espera("sesion?.vivo"), f"{enlace} arranca")

    def termina(self, enlace):
        self.abre(enlace)
        self.n.js("una('canvas').focus()")
        self.n.tecla(navegador.ESC)
        exige(
            self.espera("!telon.hidden && /ha terminado/.test(telon.textContent)"), f"{enlace}: Esc termina y se dice"
        )

    def espera(self, condicion):
        return espera(self.n, f"return Boolean({condicion})")

    def imagen(self):
        self.n.js("gestos.suelta(); sesion.orden('captura /imagen.ppm')")
        return self.n.js(
            "let t = ''; for (const b of sesion.lee('/imagen.ppm')) t += String.fromCharCode(b); return btoa(t)"
        )

    def es(self, capitulo, fichero, que):
        c = compara(self.raiz, self.build, capitulo, fichero, self.imagen(), self.carpeta)
        exige(c.returncode == 0, f"{que} deja {fichero}: {c.stdout}")

    def actua(self, tipo, *acciones):
        comun = {"type": "pointer", "parameters": {"pointerType": tipo}}
        self.n.pide(
            "/actions", actions=[{"id": f"{tipo}{i}", "actions": list(a), **comun} for i, a in enumerate(acciones)]
        )

    def lienzo(self):
        self.n.js("scrollTo(0, 0)")
        return self.n.js(
            "const r = una('canvas').getBoundingClientRect(); return [Math.round(r.left), Math.round(r.top)]"
        )

    def arrastra(self, puntos, boton=0, dedo=False):
        x0, y0 = self.lienzo()
        mueve = [{"type": "pointerMove", "duration": 40, "x": x0 + x, "y": y0 + y} for x, y in puntos]
        acciones = [
            mueve[0],
            {"type": "pointerDown", "button": boton},
            *mueve[1:],
            {"type": "pointerUp", "button": boton},
        ]
        self.actua("touch" if dedo else "mouse", acciones)

    def pinza(self, antes, despues):
        x0, y0 = self.lienzo()
        dedos = [
            [
                {"type": "pointerMove", "duration": 0, "x": x0 + 120 + lado * antes, "y": y0 + 90},
                {"type": "pointerDown", "button": 0},
                {"type": "pointerMove", "duration": 50, "x": x0 + 120 + lado * despues, "y": y0 + 90},
                {"type": "pointerUp", "button": 0},
            ]
            for lado in (-1, 1)
        ]
        self.actua("touch", *dedos)

    def pulsa(self, selector):
        """Un clic de verdad: hay cosas que el navegador no deja hacer sin él."""
        x, y = self.n.js(
            """const b = una(arguments[0]); b.scrollIntoView({ block: 'center' });
            const r = b.getBoundingClientRect(); return [r.x + 9, r.y + 9].map(Math.round)""",
            selector,
        )
        self.actua(
            "mouse",
            [
                {"type": "pointerMove", "duration": 0, "x": x, "y": y},
                {"type": "pointerDown", "button": 0},
                {"type": "pointerUp", "button": 0},
            ],
        )

    def escribe(self, donde, texto):
        """Como quien teclea al principio de la línea `donde` (desde 1) del editor."""
        self.n.js(
            """const lugar = { line: arguments[0] - 1, ch: 0 };
            editor.scrollIntoView(lugar); editor.replaceRange(arguments[1], lugar, undefined, '+input')""",
            donde,
            texto,
        )

    def suelta_fichero(self, nombre, base64_):
        self.n.js(
            """const datos = new DataTransfer();
            datos.items.add(new File([Uint8Array.from(atob(arguments[1]), c => c.charCodeAt(0))], arguments[0]));
            marco.dispatchEvent(new DragEvent('drop', { dataTransfer: datos, bubbles: true, cancelable: true }))""",
            nombre,
            base64_,
        )


ROJO_VERDE_AZUL_BLANCO = b"P6\n2 2\n255\n" + bytes([255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255])
PNG = base64.b64encode(
    subprocess.run("pnmtopng", input=ROJO_VERDE_AZUL_BLANCO, capture_output=True, check=True).stdout
).decode()


def prueba_entradas(p):
    n = p.n
    p.abre("#grua")
    n.js("una('canvas').focus()")
    for _ in range(7):
        n.tecla("d")
    p.es("ch03_transformaciones", "grua-girada", "la tecla d, siete veces,")
    n.js("una('.enlace').click()")
    exige("grua;tecla%20d%20%C3%977" in n.js("return location.hash"), "el enlace lleva lo que se ha hecho")
    n.tecla("\ue004")  # Tab
    exige(n.js("return document.activeElement.tagName") == "BUTTON", "con Tab se sale del lienzo a los botones")

    for enlace in ("#E3.5" + ";tecla d;tecla%20d" * 3 + ";tecla d", "#grua;tecla d ×7"):
        p.abre(enlace)
        p.es("ch03_transformaciones", "grua-girada", "el enlace con su guion")
    p.abre("#grua")
    n.js("for (let i = 0; i < 7; ++i) todos('.mando button').find(b => b.textContent === 'd').click()")
    p.es("ch03_transformaciones", "grua-girada", "el botón d, siete veces,")
    n.js("todos('.casos-botones button').find(b => b.textContent === 'orbitada').click()")
    exige(p.espera("hecho.ordenes.length > 2 && sesion?.vivo"), "el botón de un caso lo repite")
    p.es("ch03_transformaciones", "grua-orbitada", "el botón de un caso")

    p.abre("#grua")
    p.arrastra([(60, 90), (100, 80), (160, 60)])
    x0, y0 = p.lienzo()
    n.pide(
        "/actions",
        actions=[
            {
                "type": "wheel",
                "id": "rueda",
                "actions": [
                    {"type": "scroll", "x": x0 + 160, "y": y0 + 60, "deltaX": 0, "deltaY": -100, "duration": 0}
                ],
            }
        ],
    )
    exige(p.espera("hecho.ordenes.some(o => o.startsWith('rueda'))"), "la rueda llega")
    p.es("ch03_transformaciones", "grua-orbitada", "el ratón y la rueda")
    p.abre("#grua")
    p.arrastra([(60, 90), (100, 80), (160, 60)], dedo=True)
    p.pinza(40, 47)
    exige(p.espera("hecho.ordenes.some(o => o.startsWith('rueda'))"), "la pinza llega")
    p.es("ch03_transformaciones", "grua-orbitada", "un dedo y una pinza")
    p.abre("#seleccion")
    p.arrastra([(180, 112)])
    p.es("ch10_interaccion", "seleccion-esfera", "un clic")
    p.abre("#eventos;" + next(c.guion for c in lee_casos(p.build) if c.fichero == "eventos"))
    p.es("ch10_interaccion", "eventos", "un enlace con ratón")  # la imagen dice dónde ha sido cada suceso
    enlace = "#eventos;escala 240 180;boton IZQUIERDO abajo 145 115;arrastra 175 108;tecla a;rueda -1 20 30"
    p.abre(enlace, "width: 480px; height: 270px")
    n.js("una('.enlace').click()")
    exige(
        n.js("return decodeURIComponent(location.hash)") == enlace,
        "el enlace de una ventana de otra forma vale para todas",
    )
    exige(n.js("return una('.estado').textContent").endswith("-1 90 45"), "y en ella el ratón está donde debe")
    p.abre("#sombras")
    p.arrastra([(120, 20), (120, 330)], boton=2)
    p.es("ch07_realismo", "sombras-luz_baja", "el botón derecho")

    p.abre("#menu")
    n.js("todos('.mando button').find(b => b.textContent === 'Menú').click()")
    n.js("todos('.opciones button').find(b => b.textContent === 'Paralela › Perfil').click()")
    p.es("ch10_interaccion", "menu-perfil", "una opción del menú")

    p.abre("#luces_animadas")
    antes = p.imagen()
    time.sleep(0.5)
    exige(p.imagen() != antes, "lo que se anima se mueve solo")
    exige(n.js("return /^espera \\d+$/.test(hecho.ordenes.join())"), "y el enlace lleva cuánto")
    p.abre("#tiras")
    botones = [*"123456789", *"0u"]
    exige(n.js("return todos('.mando button').map(b => b.textContent)") == botones, "«1 a 9» son nueve botones")
    p.abre("#bezier")
    exige(
        n.js("return todos('.mando button').map(b => b.textContent).join('')") == "n←→↑↓uU",
        "«(o n y flechas)» son cinco botones",
    )

    p.abre("#grua;tecla d")
    exige(n.js("return una('.estado').textContent").startswith("Grúa de obra: giro"), "el título de la ventana se ve")
    n.js(
        """HTMLAnchorElement.prototype.click = function () {
        fetch(this.href).then(r => r.blob()).then(b => { window.bajado = this.download + ' ' + b.type }) }"""
    )
    n.js("una('.guarda').click()")
    exige(p.espera("window.bajado === 'grua.png image/png'"), "la imagen se guarda")
    p.pulsa(".completa")
    exige(
        p.espera("document.fullscreenElement === marco && sesion.lienzo.width === marco.clientWidth"),
        "la pantalla completa lo es",
    )
    n.js("document.exitFullscreen()")
    exige(p.espera("sesion.lienzo.width === 240"), "y se sale de ella")
    n.js("document.activeElement.blur()")
    n.talla(1920, 1080)
    n.tecla("p")
    exige(
        p.espera("document.fullscreenElement === escena && sesion.lienzo.width === marco.clientWidth"),
        "p proyecta el programa",
    )
    navegador.proyectable(n, ".escena")
    n.tecla("\ue00f")
    exige(
        p.espera("sesion?.vivo && casoActual === actual.casos[0] && hecho.ordenes.length === 0"),
        "AvPág pasa al caso siguiente",
    )
    for _ in p.n.js("return actual.casos"):
        n.tecla(navegador.DERECHA)
    exige(
        p.espera(
            "sesion?.vivo && actual === PROGRAMAS[PROGRAMAS.findIndex(q => q.nombre === 'grua') + 1] && document.fullscreenElement"
        ),
        "y tras el último, la flecha, que la grúa no usa, al programa siguiente",
    )
    n.js("document.exitFullscreen()")
    p.abre("#grua")
    exige("cubos de lado uno" in n.js("return una('.enunciado', pagina).textContent"), "el enunciado de su ejercicio")
    navegador.accesible(n, "la página de un programa")
    n.js("location.hash = ''")
    navegador.accesible(n, "la página de todos")

    p.termina("#grua")
    n.js("una('.telon button').click()")
    exige(p.espera("sesion?.vivo && telon.hidden"), "y se puede empezar de nuevo")
    n.js("location.hash = '#grua;tecla nada'")
    exige(p.espera("!telon.hidden && /tecla nada/.test(telon.textContent)"), "un guion mal escrito se dice")
    for enlace in ("#no_existe", "#%", "#%E0%A4%A", "#" + "a" * 100000):
        n.js("location.hash = arguments[0]", enlace)
        exige(
            p.espera("una('#no-esta').textContent.includes(corta(leeEnlace(location.hash).nombre, 60))"),
            f"{enlace[:9]} se dice que no está",
        )


def prueba_adversidades(p):
    n = p.n
    p.abre("#grua")
    n.js(
        """window.rapido = arranca;
        window.lento = async (...todo) => { await new Promise(sigue => { window.carga = sigue }); return rapido(...todo) };
        arranca = lento;
        una('.otra-vez').click();
        arranca = rapido;
        location.hash = '#camara'"""
    )
    exige(p.espera("sesion?.vivo"), "se va a otro programa sin esperar a que acabe de cargar el primero")
    titulo = n.js("const antes = una('.estado').textContent; carga(); return antes")
    time.sleep(1)
    exige(
        n.js("return una('.estado').textContent") == titulo and not titulo.startswith("Grúa"),
        "y el primero no escribe en la página del otro",
    )
    n.js("arranca = lento; location.hash = '#grua'")
    exige(p.espera("actual.nombre === 'grua' && una('canvas')"), "vuelve")
    x, y = p.lienzo()
    p.actua(
        "mouse",
        [{"type": "pointerMove", "duration": 0, "x": x + 60, "y": y + 90}, {"type": "pointerDown", "button": 0}],
    )
    n.js("arranca = rapido; marco.style.setProperty('width', '260px', 'important')")
    time.sleep(0.3)
    n.js("carga()")
    exige(p.espera("sesion?.vivo"), "se carga con el ratón pulsado")
    p.actua(
        "mouse",
        [{"type": "pointerMove", "duration": 40, "x": x + 160, "y": y + 60}, {"type": "pointerUp", "button": 0}],
    )
    exige(n.js("gestos.suelta(); return sesion.vivo && !hecho.ordenes.length"), "y arrastrar entonces no hace nada")
    exige(n.js("return sesion.lienzo.width") == 260, "y se dibuja del tamaño que ha tomado la página mientras")

    n.js(
        "window.viejo = gestos; window.lienzos = []; for (let i = 0; i < 9; ++i) { lienzos.push(una('canvas')); una('.otra-vez').click() }"
    )
    exige(
        p.espera("sesion?.lienzo.isConnected && sesion.vivo && todos('canvas').length === 1"),
        "empezar nueve veces seguidas es empezar una",
    )

    exige(p.espera("lienzos.every(c => c.getContext('webgl2').isContextLost())"), "y los demás sueltan la tarjeta")
    n.js("viejo.gira({ id: 1, x: 1, y: 1 }, 99, 0); todos('.mando button')[0].dispatchEvent(new Event('pointerdown'))")
    time.sleep(0.6)
    exige(
        n.js("return new Set(hecho.ordenes).size === 1 && hecho.ordenes[0] === 'tecla a'"),
        "una tecla de la pantalla se repite; un lienzo que ya no está no da nada",
    )
    n.js("location.hash = '#camara'")
    exige(p.espera("actual.nombre === 'camara' && sesion?.vivo"), "se va a otro programa con esa tecla pulsada")
    time.sleep(0.2)
    exige(n.js("return !hecho.ordenes.length"), "y ya no le llega")

    p.abre("#convolucion")
    n.js(
        "window.lee = aPpm; aPpm = async fichero => { await new Promise(sigue => { window.sigue = sigue }); return lee(fichero) }"
    )
    p.suelta_fichero("foto.png", PNG)
    exige(p.espera("window.sigue"), "una imagen que tarda en leerse")
    n.js("location.hash = '#grua'")
    exige(p.espera("actual.nombre === 'grua' && sesion?.vivo"), "no impide irse")
    n.js("sigue()")
    time.sleep(0.5)
    exige(
        n.js("return !propias.length && sesion?.vivo && ![...sesion.leidos].some(r => r.startsWith('/propias'))"),
        "y no es para el otro programa",
    )

    for orden in ("a" * 100000, "%25", "%"):
        n.js("location.hash = '#grua;' + arguments[0]", orden)
        exige(
            p.espera("!telon.hidden && telon.textContent.length < 2000 && /guion «[a%]/.test(telon.textContent)"),
            f"«{orden[:9]}…» se dice que no es una orden",
        )
    p.abre(
        "#grua;captura /lab/ch03_transformaciones/objeto.frag;captura lab/ch03_transformaciones/objeto.vert;tecla d ×7"
    )
    exige(
        n.js("return ['frag', 'vert'].every(t => sesion.lee(`/lab/ch03_transformaciones/objeto.${t}`)[0] === 35)"),
        "un enlace no escribe ficheros",
    )
    p.es("ch03_transformaciones", "grua-girada", "y lo demás que dice se hace")
    lento = n.pide(
        "/execute/async",
        script="""const acaba = arguments[0], tope = performance.now() + 3000;
        let antes = performance.now(), lento = 0;
        location.hash = '#banderas;espera 1000000000 ×10000;tecla r ×10000';
        const mira = () => {
          lento = Math.max(lento, performance.now() - antes);
          antes = performance.now();
          if (antes < tope) setTimeout(mira); else acaba(lento);
        };
        mira()""",
        args=[],
    )
    exige(lento < 5000, f"un guion larguísimo deja vivir a la página: {lento:.0f} ms sin responder")
    p.termina("#menu")
    n.js("todos('.mando button').find(b => b.textContent === 'Menú').click()")
    exige(n.js("return !opciones.matches(':popover-open')"), "y ya no se abre nada")

    shaders = p.pagina.parent / "datos/shaders.js"
    shaders.rename(f"{shaders}.fuera")
    n.pide("/url", url="about:blank")
    n.pide("/url", url=p.pagina.as_uri() + "#grua")
    exige(
        p.espera("/no se puede leer datos.shaders.js/.test(telon.textContent)"), "lo que no se puede descargar se dice"
    )
    Path(f"{shaders}.fuera").rename(shaders)
    n.js("una('.telon button').click()")
    exige(p.espera("sesion?.vivo && telon.hidden"), "y se puede volver a intentar")
    n.pide("/se/log", type="browser")  # ese error sí tiene que estar


def edita_phong(p):
    p.abre("#componentes_phong")
    exige(p.espera("editor?.ruta && editor.lineCount() > 5"), "el editor se abre")
    p.n.js("abre('ch05_iluminacion/phong.glsl')")
    exige(p.espera("editor.ruta === 'ch05_iluminacion/phong.glsl'"), "se ve phong.glsl")


def prueba_editor(p):
    n = p.n
    edita_phong(p)
    caso = n.js("return una('.casos-botones [aria-pressed=true]').textContent + ' ' + una('.mira').textContent")
    exige(caso.startswith("c La reflexión especular"), "lo que hay que mirar es lo que se ve al empezar")
    original, linea = p.imagen(), n.js(
        "return editor.getValue().split('\\n').findLastIndex(l => /^\\s*return /.test(l)) + 1"
    )
    p.escribe(linea, "esto no compila;\n")
    exige(p.espera("una('.linea-mala')"), "un error se marca en el editor")
    exige(
        n.js("return editor.lineInfo(arguments[0] - 1).bgClass", linea) == "linea-mala",
        f"se marca la línea {linea}, que es la mala",
    )
    exige(f"phong.glsl, línea {linea}: " in n.js("return una('.fichero-estado').textContent"), "y se dice cuál es")
    exige(p.imagen() == original, "con un error sigue la imagen que había")
    n.js("editor.undo()")
    exige(
        p.espera("!una('.linea-mala') && !una('.fichero-estado').classList.contains('mal')"),
        "corregido, deja de decirse",
    )
    n.js("editor.redo()")
    exige(p.espera("una('.linea-mala')"), "y estropeado otra vez, se vuelve a decir")
    n.pide("/refresh")
    exige(
        p.espera("!telon.hidden && una('.linea-mala')"),
        "al volver a abrir la página el cambio sigue, y su error se dice",
    )
    primera = "editor.coordsChar({ left: 0, top: editor.getScrollInfo().top }, 'local').line"
    exige(p.espera(f"editor.ruta.endsWith('phong.glsl') && {primera} > 10"), "y el fichero se abre por esa línea")
    n.js("todos('.fichero-estado button').at(-1).click()")
    exige(p.espera("sesion?.vivo && telon.hidden"), "vuelto al original, el programa arranca")
    edita_phong(p)
    p.escribe(linea, "    return vec3(1.0, 0.0, 0.0);\n")
    exige(p.espera("/Cambiado/.test(una('.fichero-estado').textContent)"), "un cambio bueno se aplica solo")
    exige(p.imagen() != original, "y se ve")
    n.js("una('.fichero-estado button').click()")
    exige(
        p.espera("!taller.cambios.size && recuerdo('sessionStorage', 'cambios') === '[]'"),
        "se puede volver al original",
    )
    exige(p.imagen() == original, "y vuelve la imagen")
    n.js("todos('.pestanas button').find(b => b.textContent.endsWith('.cpp')).click()")
    exige(p.espera("editor.ruta.endsWith('.cpp') && editor.getOption('readOnly')"), "un .cpp se lee y no se cambia")


# De cada ejercicio, algo mal hecho que compila. Los de L8.4, L9.1, L9.3 y L12.1 solo se notan en uno de los casos.
MAL_HECHO = {
    "L1.2": ("1.0, 0.0, 0.0", "0.0, 0.0, 1.0"),
    "L3.1": ("N * vNormal", "vNormal"),
    "L5.1": ("2.0 * N * NdotL", "N * NdotL"),
    "L5.2": ("N * vNormal", "vNormal"),
    "L5.3": ("ecPosicion, normal)", "ecPosicion, -normal)"),
    "L6.3": ("nuevaCoordTextura)", "nuevaCoordTextura.ts)"),
    "L8.1": ("reflect(haciaPunto, normalize", "reflect(-haciaPunto, normalize"),
    "L8.3": ("&&", "||"),
    "L8.4": ("p).r * S2", "p * S2).r"),
    "L9.1": ("/ 3.0", "/ 2.0"),
    "L9.2": ("colorA, colorB", "colorB, colorA"),
    "L9.3": ("dentro || !ceroFuera", "true"),
    "L12.1": ("- centro", "- 0.5"),
}

ESCRIBE = """
const [mal, bien, acaba] = arguments;
(async () => {
  for (const ruta of Object.keys(ejercicio.pide)) {
    await abre(ruta);
    editor.replaceRange((await solucion(ruta)).replace(bien, mal), { line: 0, ch: 0 }, { line: editor.lineCount(), ch: 0 }, '+input');
    await aplicaYa();
  }
})().then(acaba, error => acaba(String(error)));
"""


def parecido(p):
    """La parte que coincide de lo que se ve, cuando ya se ha mirado si también lo demás; y lo que se dice."""
    p.n.js("comparaYa()")
    p.espera("sesion?.vivo && !veredicto.textContent.startsWith('Comparando')")
    p.n.js("comparaYa()")
    texto, dicho = p.n.js("return [una('.parecido output').textContent, veredicto.textContent]")
    return float(texto.removesuffix("\xa0%")), dicho


def prueba_ejercicio(p, codigo):
    n, resuelto = p.n, "return leeResueltos(localStorage.getItem('resueltos')).has(arguments[0])"
    p.abre("#ejercicio/" + codigo)
    p.espera("/%/.test(una('.parecido output').textContent) && editor?.ruta")
    n.js("if (actual.anima) manda('tecla Espacio')")
    antes, dicho = parecido(p)
    exige(antes < 90, f"{codigo}, sin hacer, coincide el {antes} %: {dicho}")

    imagen, linea = p.imagen(), n.js("return editor.getValue().split('\\n').findIndex(l => esMarca(l)) + 2")
    p.escribe(linea, "esto no compila;\n")
    exige(p.espera("una('.linea-mala')"), f"{codigo}: un error se marca en el editor")
    exige(f"línea {linea}: " in n.js("return una('.fichero-estado').textContent"), f"{codigo}: y se dice en qué línea")
    exige(
        parecido(p) == (antes, "El shader tiene un error: la imagen es la de antes."),
        f"{codigo}: con un error no cambia nada",
    )
    exige(p.imagen() == imagen, f"{codigo}: y sigue la imagen que había")

    n.pide("/execute/async", script=ESCRIBE, args=[MAL_HECHO[codigo][1], MAL_HECHO[codigo][0]])
    coincide, dicho = parecido(p)
    exige(n.js("return !errores.length"), f"{codigo}: lo mal hecho compila")
    exige(coincide < 99.9 or dicho.startswith("Falta"), f"{codigo}: lo mal hecho coincide el {coincide} %: {dicho}")
    exige(not n.js(resuelto, codigo), f"{codigo}: y no está resuelto")

    n.pide("/execute/async", script=ESCRIBE, args=["", ""])
    coincide, dicho = parecido(p)
    exige(coincide == 100 and dicho.startswith("Resuelto"), f"{codigo}: hecho, coincide el {coincide} %: {dicho}")
    exige(n.js(resuelto, codigo), f"{codigo}: y el navegador lo recuerda")
    for caso in n.js("return actual.casos.map(c => c.titulo)"):
        n.pide(
            "/execute/async",
            script="empiezaCaso(actual.casos.find(c => c.titulo === arguments[0])).then(arguments[1])",
            args=[caso],
        )
        exige(parecido(p)[0] == 100, f"{codigo}: hecho, «{caso}» es igual")
    n.js("[...'dv2+'].forEach(t => manda('tecla ' + t))")
    exige(parecido(p)[0] == 100, f"{codigo}: y con las mismas teclas, también")


def prueba_ejercicios(p):
    n = p.n
    n.js("localStorage.clear()")
    exige(sorted(n.js("return EJERCICIOS.map(e => e.codigo)")) == sorted(MAL_HECHO), "están todos los ejercicios")
    for codigo in MAL_HECHO:
        prueba_ejercicio(p, codigo)
    n.pide("/refresh")
    exige(p.espera("sesion?.vivo ") and parecido(p)[0] == 100, "al volver, lo escrito sigue")
    n.js("location.hash = ''")
    exige(
        n.js(
            "return todos('.tarjetas .a-ejercicio').every(a => a.textContent.endsWith('✓') && /resuelto/.test(a.ariaLabel))"
        ),
        "y en la lista se ve que están resueltos",
    )
    exige(n.js("return una('.cuenta').textContent").endswith(f"resuelto {len(MAL_HECHO)}"), "todos")
    p.abre("#sombreado")
    exige(
        n.js("return todos('.a-ejercicio', pagina).map(a => a.textContent).join()")
        == "Ejercicio L5.1 ✓,Ejercicio L5.2 ✓,Ejercicio L5.3 ✓",
        "desde el programa se va a los suyos",
    )
    exige(n.js("return todos('canvas').length === 1 && !pendiente"), "y fuera de ellos no hay más que el programa")

    p.abre("#ejercicio/L9.2")
    exige(p.espera("editor?.ruta"), "el editor se abre")
    p.escribe(1, "// lo mío\n")
    ver = "todos('.tarea button')[0].click()"
    n.js(ver)
    exige(
        p.espera(
            "editor.getOption('readOnly') && /mix\\(/.test(editor.getValue()) && !/lo mío/.test(editor.getValue())"
        ),
        "la solución se ve, y no se cambia",
    )
    n.js(ver)
    exige(p.espera("!editor.getOption('readOnly') && /lo mío/.test(editor.getValue())"), "y lo de uno sigue")
    n.js("todos('.fichero-estado button')[0].click()")
    exige(
        p.espera("!taller.cambios.size && !/mix\\(/.test(editor.getValue())") and parecido(p)[0] < 90,
        "se puede volver a empezar",
    )
    p.abre("#ejercicio/L5.2;tecla v")
    exige(
        n.js("return casoActual === undefined && hecho.ordenes.join() === 'tecla v'"), "un enlace lleva lo que se hace"
    )
    navegador.accesible(n, "la página de un ejercicio")
    n.js("location.hash = '#ejercicio/L99.1'")
    exige(p.espera("una('#no-esta').textContent === 'No hay ningún ejercicio «L99.1».'"), "el que no está se dice")

    sin = n.pide(
        "/goog/cdp/execute",
        cmd="Page.addScriptToEvaluateOnNewDocument",
        params={
            "source": "for (const a of ['localStorage', 'sessionStorage']) Object.defineProperty(window, a, { get() { throw new DOMException('no', 'SecurityError') } })"
        },
    )
    p.abre("#ejercicio/L9.2")
    p.espera("editor?.ruta")
    n.pide("/execute/async", script=ESCRIBE, args=["", ""])
    exige(
        parecido(p)[1].startswith("Resuelto") and n.js("return resueltos.has('L9.2')"),
        "donde no se puede guardar nada, también se resuelve",
    )
    n.pide("/goog/cdp/execute", cmd="Page.removeScriptToEvaluateOnNewDocument", params=sin)


def prueba_ficheros_y_tallas(p):
    n = p.n
    p.abre("#convolucion")
    antes = p.imagen()
    p.suelta_fichero("apuntes.txt", "aG9sYQ==")
    exige(
        p.espera("/apuntes.txt.*no es una imagen/.test(una('.aviso').textContent)"),
        "un fichero que no es una imagen se dice",
    )
    exige(p.imagen() == antes, "y el programa sigue")
    p.suelta_fichero("mal.ppm", "UDYgOTk5IDk5OSAyNTUKAAA=")
    exige(p.espera("!telon.hidden && /mal.ppm/.test(telon.textContent)"), "un PPM cortado se dice")
    n.js("una('.telon button').click()")
    exige(p.espera("sesion?.vivo"), "y se puede seguir")
    p.suelta_fichero("foto.png", PNG)
    exige(
        p.espera("sesion?.leidos.size && [...sesion.leidos].some(r => r.startsWith('/propias/'))"),
        "una imagen propia se abre",
    )
    exige(
        n.js("return [...sesion.lee([...sesion.leidos].find(r => r.startsWith('/propias/')))]")
        == [*ROJO_VERDE_AZUL_BLANCO],
        "tal como es",
    )
    exige(p.imagen() != antes, "y se ve")
    p.abre("#malla_vf")
    p.suelta_fichero("nada.vf", "bm8=")
    exige(p.espera("!telon.hidden && /nada.vf/.test(telon.textContent)"), "un modelo que no lo es se dice")
    p.abre("#grua")
    p.suelta_fichero("foto.png", PNG)
    exige(p.espera("/no lee ficheros/.test(una('.aviso').textContent)"), "un programa que no lee ficheros lo dice")

    for talla, ancho in (("width: 1px; height: 1px", 1), ("width: 9000px; height: 6750px", 4096)):
        p.abre("#grua", talla)
        exige(
            p.espera(f"sesion?.lienzo.width === {ancho}") and p.espera("sesion.vivo"),
            f"con {talla} el lienzo mide {ancho}",
        )
    p.abre("#grua" + ";tecla d" * 7)
    n.js("window.quita = una('canvas').getContext('webgl2').getExtension('WEBGL_lose_context'); quita.loseContext()")
    exige(p.espera("!telon.hidden && /perdido/.test(telon.textContent)"), "que se ha perdido el contexto se dice")
    n.js("quita.restoreContext()")
    exige(p.espera("sesion?.vivo && telon.hidden"), "y al volver, sigue")
    p.es("ch03_transformaciones", "grua-girada", "el contexto devuelto")


def prueba_pagina(p):
    n = p.n
    n.pide("/url", url="about:blank")
    n.pide("/url", url=p.pagina.as_uri())
    n.js("busca.value = 'INCLINACION camara'; busca.dispatchEvent(new Event('input'))")
    visibles = n.js("return todos('.tarjetas li').filter(l => l.offsetParent).map(l => una('a', l).hash)")
    exige("#camara" in visibles and "#tiras" not in visibles, "el buscador encuentra, sin acentos")
    n.js("busca.value = ''; busca.dispatchEvent(new Event('input'))")
    for ancho, alto in ((360, 740), (1280, 800), (1920, 1080)):
        n.talla(ancho, alto)
        for enlace in ("", "#grua", "#grua_zbuffer", "#convolucion_variable", "#ejercicio/L5.3", "#info_opengl"):
            n.js("location.hash = arguments[0]", enlace)
            p.espera("!actual || editor && (sesion?.vivo || actual.consola)")
            navegador.nada_se_sale(n, f"nada de «{enlace}»", ancho)
            if enlace.startswith("#ejercicio"):
                exige(
                    n.js(
                        "return scrollY === 0 && todos('.lienzo, .cuadro, .parecido').every(e => e.getBoundingClientRect().bottom < innerHeight)"
                    ),
                    f"en una ventana de {ancho}×{alto} se ven las tres imágenes y cuánto coinciden",
                )
    exige("OpenGL: 3.1 (imitado" in n.js("return consola.textContent"), "info_opengl escribe lo que hay")
    n.pide("/goog/cdp/execute", cmd="Emulation.clearDeviceMetricsOverride", params={})
    fuera = n.js(
        "return performance.getEntriesByType('resource').map(r => r.name).filter(r => !/^(file|data|blob):/.test(r))"
    )
    exige(not fuera, f"no se pide nada a otro servidor: {fuera[:3]}")


PRUEBAS = {"ejercicios": (prueba_ejercicios, prueba_pagina)}
PRUEBAS["persona"] = (
    prueba_entradas,
    prueba_adversidades,
    prueba_editor,
    prueba_ejercicios,
    prueba_ficheros_y_tallas,
    prueba_pagina,
)
PRUEBAS[""] = PRUEBAS["persona"]


def main():
    raiz, build, web, *pedidos = sys.argv[1:]
    raiz, build, web = Path(raiz).resolve(), Path(build).resolve(), Path(web).resolve()
    fijo = procesos.entorno(build)
    with navegador.pantalla({**os.environ, **fijo}) as entorno, tempfile.TemporaryDirectory() as carpeta:
        n = Navegador(Path(carpeta, "perfil"), OPCIONES, entorno)
        try:
            n.pide("/timeouts", script=60000)
            n.pide("/url", url=(web / "index.html").as_uri())
            if pedidos not in (["persona"], ["ejercicios"]):
                compara_casos(n, raiz, build, Path(carpeta), pedidos)
            persona = Persona(n, raiz, build, web / "index.html", Path(carpeta))
            if not SWIFTSHADER:
                for prueba in PRUEBAS.get(" ".join(pedidos), ()):
                    n.talla(1280, 800)  # cada una empieza en un portátil, y no como dejó la ventana la de antes
                    prueba(persona)
            registro = [
                r["message"] for r in n.pide("/se/log", type="browser") if "CONTEXT_LOST_WEBGL" not in r["message"]
            ]
            exige(not registro, f"la consola está vacía: {registro[:3]}")
        finally:
            n.cierra()
    navegador.acaba()


if __name__ == "__main__":
    main()
