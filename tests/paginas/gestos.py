"""Lo que se pregunta a las dos páginas de todo lo que hay en ellas: cada botón, dos veces; cada tecla, sola y con Ctrl,
Alt y Meta; cada letra, en el buscador; cada esquina, cada dedo y cada pestaña."""
import base64
import string
import time

from navegador import CASOS, ESC, exige
from persona import FICHERO

INTRO = "\ue007"
TECLAS = [*string.ascii_letters, *string.digits, *"+-/.,", "Enter", "PageDown", "PageUp", "Home", "End", "Escape"]
TECLAS += [f"Arrow{hacia}" for hacia in ("Left", "Right", "Up", "Down")] + [f"F{i}" for i in (1, 5, 12)]
# Lo que se ve, sin lo que se mueve solo.
NOMBRES = """const se_ven = s =>
  [...document.querySelectorAll(s)].filter(e => e.checkVisibility({ visibilityProperty: true }));
const clase = e => e.tagName + e.className + e.parentElement.className; // de cada una, los dos primeros
const pulsables = () => se_ven('button, summary').filter(e => !e.closest('.mandos, .telon'))
  .filter((e, i, todos) => todos.slice(0, i).filter(otro => clase(otro) === clase(e)).length < 2);
const textos = s => se_ven(s).map(e => e.textContent.trim());
const sena = () => JSON.stringify([location.hash, Boolean(document.fullscreenElement), scrollX,
  textos('h1, dialog[open] h2, [aria-pressed=true], details[open] > summary, :popover-open'),
  se_ven('input').map(i => i.value), document.querySelectorAll('article:not([hidden]), canvas').length]);
"""


def js(n, codigo, *argumentos):
    return n.js(NOMBRES + codigo, *argumentos)


def quieta(n):
    """Cómo está la página cuando ya no cambia."""
    antes = None
    while antes != (antes := js(n, "return sena()")):
        time.sleep(0.15)
    return antes


def cada_boton_dos_veces(n, donde, abre):
    """Pulsado otra vez, un botón deshace lo que ha hecho o no hace más; y con Esc se sale de lo que abre."""
    abre()
    for i in range(js(n, "return pulsables().length")):
        antes = quieta(n)
        nombre = js(
            n,
            """window.probado = pulsables()[arguments[0]];
            probado.focus();
            return probado.textContent.trim() || probado.className""",
            i,
        )
        n.tecla(INTRO)
        una = quieta(n)
        if js(n, "return se_ven('*').includes(probado) && !document.querySelector('dialog[open]')"):
            js(n, "probado.focus()")
            n.tecla(INTRO)
            exige((otra := quieta(n)) in (antes, una), f"«{nombre}» de {donde}, dos veces: {antes} {una} {otra}")
        else:
            n.tecla(ESC)
            js(
                n, "return document.fullscreenElement && document.exitFullscreen()"
            )  # es del navegador, y no de WebDriver
            exige(quieta(n) == antes, f"de lo que abre «{nombre}» de {donde} se sale con Esc")
        if quieta(n) != antes:
            abre()


def teclas_del_navegador(n, donde, con, lienzo=False):
    """Las que llevan eso apretado no son de la página."""
    for modificador in con:
        suyas = js(
            n,
            """const [teclas, con, lienzo] = arguments, donde = document.querySelector(lienzo ? 'canvas' : 'body');
            const antes = sena();
            return teclas.filter(key => {
              const suceso = new KeyboardEvent('keydown', { key, [con]: true, bubbles: true, cancelable: true });
              return !donde.dispatchEvent(suceso) || sena() !== antes;
            })""",
            TECLAS,
            modificador,
            lienzo,
        )
        exige(not suyas and not js(n, "return document.fullscreenElement"), f"{donde}: con {modificador}, {suyas}")


def se_escribe(n, donde):
    """En cada campo de texto, cada letra se escribe y no hace nada más."""
    antes = quieta(n)
    campos = js(n, "window.campos = se_ven('input[type=search], textarea'); return campos.map(c => c.className)")
    for i, campo in enumerate(campos):
        js(n, "window.campo = campos[arguments[0]]; window.cm = campo.closest('.CodeMirror')?.CodeMirror", i)
        js(n, "campo.focus(); cm?.setCursor(0, 0)")
        n.tecla(*string.ascii_letters, "/", "-")
        escrito = js(n, "return cm ? cm.getLine(0) : campo.value")
        exige(escrito.startswith(string.ascii_letters + "/-"), f"en «{campo}» de {donde} se escribe todo: {escrito}")
        abierto = "return document.fullscreenElement || document.querySelector('dialog[open]')"
        exige(not js(n, abierto), f"y lo que se escribe en «{campo}» de {donde} no abre nada")
        js(n, "cm?.undo(); campo.value = ''; campo.dispatchEvent(new Event('input')); campo.blur()")
        exige(quieta(n) == antes, f"y borrado, {donde} está como estaba")
    return len(campos)


def de_la_galeria(n, abre):
    abre()
    teclas_del_navegador(n, "galería", ("ctrlKey", "altKey", "metaKey"))
    se_escribe(n, "la galería")
    va = """const target = document.querySelector('dialog');
        const toque = x => [new Touch({ identifier: 1, target, clientX: x, clientY: 300 })];
        const da = (que, toques, x) => target
          .dispatchEvent(new TouchEvent(que, { touches: toques, changedTouches: toque(x) }));
        da('touchstart', toque(300), 300); da('touchend', [], 300 + arguments[0]);
        return document.querySelector('dialog h2').textContent"""
    n.js("document.querySelectorAll('figure a')[1].click()")
    vistos = [n.js(va, hacia) for hacia in (20, -20, -100, -100, 100, 100)]
    a, b, c, d, e, f = vistos
    exige(a == b == f and c == e and len({a, c, d}) == 3, f"el dedo pasa a un lado y a otro: {vistos}")
    n.tecla(ESC)

    def con_fuentes():
        abre()
        js(n, "document.querySelector('.fuentes').open = true")

    cada_boton_dos_veces(n, "la galería", con_fuentes)


# --- la página de los programas -------------------------------------------------------------------------------------


def de_la_pagina(p):
    def abre():
        p.abre("#menu")
        p.exige("editor.ruta", "el editor se abre")

    p.n.abre(p.web)
    teclas_del_navegador(p.n, "lista", ("ctrlKey", "altKey", "metaKey"))
    se_escribe(p.n, "la lista")
    p.abre("#componentes_phong")
    p.exige("editor.ruta && !cm.getOption('readOnly')", "el editor se abre")
    exige(se_escribe(p.n, "un programa") == 2, "se escribe en el buscador y en el editor")
    cada_boton_dos_veces(p.n, "un programa", abre)
    teclas_del_navegador(p.n, "programa", ("ctrlKey", "altKey", "metaKey"))
    teclas_del_navegador(p.n, "lienzo", ("ctrlKey", "metaKey"), lienzo=True)
    teclas(p)
    menu(p)
    enlaces(p)
    cada_fuente(p)
    otra_vez(p)
    lo_ultimo(p)
    sin_respuesta(p)


# Las teclas que el navegador da a cada orden de un programa.
DEL_NAVEGADOR = """const nombres = {
  Espacio: ' ', Intro: 'Enter', Esc: 'Escape', IZQUIERDA: 'ArrowLeft', DERECHA: 'ArrowRight', ARRIBA: 'ArrowUp',
  ABAJO: 'ArrowDown', INICIO: 'Home', FIN: 'End', REPAG: 'PageUp', AVPAG: 'PageDown', INSERTAR: 'Insert',
};
const quita = key =>
  !una('canvas').dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
"""


def teclas(p):
    """Las del programa van a él y no mueven la página; las demás son del navegador. Y las de la pantalla se sueltan."""
    p.abre("#grua")
    suyas = [orden.split()[1] for orden in p.da("visto.programa.mandos.flatMap(m => m.teclas.map(t => t[1]))")]
    quedan = p.js(DEL_NAVEGADOR + "return arguments[0].filter(t => !quita(nombres[t] ?? t))", suyas)
    exige(not quedan, f"las teclas que van al programa no mueven la página: {quedan}")
    ajenas = p.js(
        DEL_NAVEGADOR + "return ['Tab', 'F12', 'ñ', 'ArrowDown', 'z', 'Shift', 'CapsLock', 'Dead'].filter(quita)"
    )
    exige(not ajenas, f"y las que no, son del navegador: {ajenas}")
    boton = """const b = conTexto('.mando button', 'd');
        const da = que => b.dispatchEvent(new PointerEvent(que, { bubbles: true }));"""
    for fin in ("pointerup", "pointerleave", "pointercancel"):
        p.js(boton + "da('pointerdown')")
        antes = p.da("hecho.ordenes.length")
        p.exige(f"hecho.ordenes.length > {antes}", "una tecla de la pantalla se repite")
        p.js(boton + "da(arguments[0])", fin)
        antes = p.da("hecho.ordenes.length")
        time.sleep(0.3)
        p.ve(f"hecho.ordenes.length === {antes}", f"y deja de repetirse con {fin}")


def menu(p):
    p.abre("#menu")
    abierto = "escena.ensenaMenu(...arguments); const o = una('.opciones'), r = o.getBoundingClientRect();"
    for ancho in (360, 1280):
        p.n.talla(ancho, 700)
        for x, y in ((0, 0), (ancho, 0), (0, 700), (ancho, 700), (ancho // 2, 350)):
            dentro = "r.left >= 0 && r.top >= 0 && r.right <= innerWidth && r.bottom <= innerHeight"
            cabe = p.js(f"{abierto} o.hidePopover(); return {dentro}", x, y)
            exige(cabe, f"el menú abierto en ({x}, {y}) de {ancho}×700 cabe")
    p.n.talla(1280, 800)
    for tecla in ("ArrowUp", "ArrowDown"):
        vuelta = p.js(
            abierto
            + f"""const n = todos('button', o).length, vistos = todos('button', o).map(() => {{
                document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {{ key: '{tecla}', bubbles: true }}));
                return document.activeElement;
              }});
            const primero = vistos.at(-1) === o.firstChild;
            o.hidePopover();
            return primero && new Set(vistos).size === n && vistos.every(v => o.contains(v))""",
            9,
            9,
        )
        exige(vuelta, f"con {tecla} se pasa por todas las opciones del menú y se vuelve a la primera")


def enlaces(p):
    """El enlace que se copia lleva a lo que se ve, esté como esté la página."""
    casos = [f"#{c.programa.nombre};{c.guion}" for c in CASOS if c.fichero in ("grua-girada", "eventos")]
    for enlace in ("#grua", "#grua;tecla d", "#menu", "#ejercicio/L5.1", "#ejercicio/L5.2;tecla v", *casos):
        p.abre(enlace)
        ve = "JSON.stringify([visto.programa.nombre, visto.ejercicio?.codigo, una('.estado').textContent])"
        antes = p.da(ve)
        p.js("una('.enlace').click()")
        p.abre(p.da("location.hash"))
        exige(p.da(ve) == antes, f"el enlace copiado en {enlace} lleva a {p.da(ve)} y no a {antes}")


def cada_fuente(p):
    """Cada fichero que se enseña tiene su texto."""
    p.abre("#grua")
    vacios = p.espera_js(
        """const programas = JSON.parse(una('#programas').textContent), vacios = [];
        for (const ruta of new Set(programas.flatMap(q => q.fuentes))) {
          await editor.abre(ruta);
          if (!editor.cm.getValue().trim()) vacios.push(ruta);
        }
        return vacios"""
    )
    exige(vacios == [], f"de cada fichero que se enseña está su texto: {vacios[:3]}")
    for donde in ("todos('.pestanas button')", "todos('.pestanas button').toReversed()"):
        p.abre("#grua")
        p.exige("editor.ruta", "el editor se abre")
        queda = p.espera_js(
            f"""const rutas = {donde}.map(b => b.ruta);
            await Promise.all(rutas.map(ruta => editor.abre(ruta)));
            const texto = editor.cm.getValue(), ultima = rutas.at(-1);
            await editor.abre(rutas[0]);
            await editor.abre(ultima);
            return rutas.length > 2 && editor.abierto === ultima && texto === editor.cm.getValue()"""
        )
        exige(queda is True, f"de las pestañas que se pulsan seguidas, queda la última: {queda}")


def otra_vez(p):
    """El mismo fichero se puede abrir con el botón cuantas veces se quiera: el navegador no avisa de él si el campo no
    queda vacío."""
    p.abre("#convolucion")
    for vez in (1, 2):
        p.js(
            """const datos = new DataTransfer(), campo = una('.fichero input');
            datos.items.add(new File(['P6 2 1 255\\nabcdef'], 'foto.ppm'));
            campo.files = datos.files;
            campo.dispatchEvent(new Event('change'))"""
        )
        p.exige(f"sesion?.vivo && sesion.leidos.has('/propias/{vez}-foto.ppm')", f"un fichero se abre la vez {vez}")
        p.exige("una('.fichero input').value === ''", "y se puede volver a abrir")


def lo_ultimo(p):
    """Lo escrito en un shader justo antes de irse a otro programa queda en él."""
    p.abre("#componentes_phong")
    p.exige("editor.ruta && cm.lineCount() > 5", "el editor se abre")
    p.js(
        """window.suyo = editor.ruta;
        cm.replaceRange('// mío\\n', { line: 1, ch: 0 }, undefined, '+input');
        location.hash = 'grua'"""
    )
    p.exige("visto.programa.nombre === 'grua' && sesion?.vivo", "se va a otro programa")
    p.ve(
        "/mío/.test(visto.taller.cambios.get(suyo)) && visto.taller.cambios.size === 1", "y lo escrito queda en el suyo"
    )


def sin_respuesta(p):
    """Con un shader que no deja acabar de dibujar, volver a abrir la página basta."""
    p.js("sessionStorage.clear()")  # los shaders que se han cambiado antes
    p.abre("#grua")
    p.exige("editor.ruta", "el editor se abre")
    p.js(
        """window.apuntado = [];
        const pon = Storage.prototype.setItem;
        Storage.prototype.setItem = function (clave, texto) {
          if (/dibujando/.test(clave)) apuntado.push(texto);
          pon.call(this, clave, texto);
        }"""
    )
    antes = p.imagen()
    p.espera_js(
        """await editor.abre('ch03_transformaciones/objeto.frag');
        const bueno = cm.getValue(), malo = bueno.replace(/(colorFragmento = )[^;]*;/, '$1vec4(1.0, 0.0, 0.0, 1.0);');
        cm.replaceRange(malo, { line: 0, ch: 0 }, { line: cm.lineCount(), ch: 0 }, '+input');
        await editor.aplicaYa()"""
    )
    p.exige("apuntado.join() === 'sí,'", "mientras se dibuja lo escrito, está apuntado, y después ya no")
    exige(p.imagen() != antes, "lo escrito se ve")
    for se_queda, es in (("sí", True), ("", False)):
        p.js("sessionStorage.setItem('cambios, dibujando', arguments[0])", se_queda)
        p.n.pide("/refresh")
        p.exige("sesion?.vivo && editor.ruta", "la página se abre otra vez")
        p.exige(
            f"/dejó de responder/.test(una('.aviso').textContent) === {str(es).lower()}", "y dice si dejó de responder"
        )
        p.ve("visto.taller.cambios.size === 1", "lo escrito no se pierde")
        usado = base64.b64decode(p.js(FICHERO, "/lab/ch03_transformaciones/objeto.frag"))
        exige((b"vec4(1.0, 0.0, 0.0" in usado) != es, "y lo que no se llegó a ver no se usa hasta que se cambia")
