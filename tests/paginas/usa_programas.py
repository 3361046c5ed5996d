"""Usar los programas en la página: teclas, ratón, dedos, botones, menú y enlaces, también contra los golden; lo que se
hace mientras se carga, enlaces hostiles y descargas que fallan; ficheros buenos y malos; una ventana diminuta y una
enorme; y el contexto perdido y devuelto."""
import base64
import re
import subprocess
import time

import direcciones
import navegador
from navegador import AVPAG, CASOS, DERECHA, FIN, INICIO, TAB, exige
from persona import FICHERO, baja, sube, va

ROJO_VERDE_AZUL_BLANCO = b"P6\n2 2\n255\n" + bytes([255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255])
PNG = subprocess.run("pnmtopng", input=ROJO_VERDE_AZUL_BLANCO, capture_output=True, check=True).stdout
BUSQUEDAS_DE_PROGRAMA = 3  # basta con las primeras: el buscador es el mismo
EN_PROPIAS = "[...sesion?.leidos ?? []].find(r => r.startsWith('/propias/'))"


def entradas(p):
    teclas(p)
    raton_y_dedos(p)
    mandos(p)


def teclas(p):
    p.abre("#grua")
    p.js("una('canvas').focus()")
    p.n.tecla(*"d" * 7)
    p.es("grua-girada", "la tecla d, siete veces,")
    p.js("una('.enlace').click()")
    p.ve("location.hash.includes('grua;tecla%20d%20%C3%977')", "el enlace lleva lo que se ha hecho")
    p.n.tecla(TAB)
    p.ve("document.activeElement.tagName === 'BUTTON'", "con Tab se sale del lienzo a los botones")
    for enlace in ("#E3.5" + ";tecla d;tecla%20d" * 3 + ";tecla d", "#grua;tecla d ×7"):
        p.abre(enlace)
        p.es("grua-girada", "el enlace con su guion")
    p.abre("#grua")
    p.js("for (let i = 0; i < 7; ++i) conTexto('.mando button', 'd').click()")
    p.es("grua-girada", "el botón d, siete veces,")
    for _ in range(2):
        p.elige(".casos-botones button", "Desde otro lado")
        p.exige("hecho.ordenes.length > 2 && sesion?.vivo", "el botón de un caso lo repite")
        p.es("grua-orbitada", "el botón de un caso")
    p.elige(".casos-botones button", "Girada")
    p.exige(
        "location.hash === '#grua-girada' && hecho.ordenes.length === 7 && sesion?.vivo", "cada caso tiene dirección"
    )
    p.js("history.back()")
    p.exige(
        "visto.caso.fichero === 'grua-orbitada' && hecho.ordenes.length > 2 && sesion?.vivo",
        "y «Atrás» vuelve al de antes",
    )


def guion_de(caso):
    return next(c.guion for c in CASOS if c.fichero == caso)


def raton_y_dedos(p):
    arrastre = (60, 90), (100, 80), (160, 60)
    rueda = "hecho.ordenes.some(o => o.startsWith('rueda'))"
    for densidad in (2, 1):
        p.n.talla(1280, 800, densidad)
        p.abre("#grua", f"width: {240 / densidad}px; height: {180 / densidad}px")
        p.arrastra([(x / densidad, y / densidad) for x, y in arrastre])
        p.rueda(160 // densidad, 60 // densidad, -100)
        p.exige(rueda, "la rueda llega")
        p.es("grua-orbitada", f"el ratón y la rueda, con {densidad} píxeles de la pantalla en cada uno")
    p.abre("#grua")
    p.arrastra(arrastre, dedo=True)
    p.pinza(40, 47)
    p.exige(rueda, "la pinza llega")
    p.es("grua-orbitada", "un dedo y una pinza")
    for programa, caso, boton, que in (
        ("seleccion", "seleccion-esfera", 0, "un clic"),
        ("sombras", "sombras-luz_baja", 2, "el botón derecho"),
    ):
        p.abre(f"#{programa}")
        p.arrastra(re.findall(r"(?:abajo|arrastra) (\d+) (\d+)", guion_de(caso)), boton)
        p.es(caso, que)
    p.abre("#eventos;" + guion_de("eventos"))
    p.es("eventos", "un enlace con ratón")  # la imagen dice dónde ha sido cada suceso
    enlace = "#eventos;escala 240 180;boton IZQUIERDO abajo 145 115;arrastra 175 108;tecla a;rueda -1 20 30"
    p.abre(enlace, "width: 480px; height: 270px")
    p.js("una('.enlace').click()")
    exige(p.da("decodeURIComponent(location.hash)") == enlace, "el enlace de una ventana de otra forma vale para todas")
    p.ve("una('.estado').textContent.endsWith('-1 90 45')", "y en ella el ratón está donde debe")


def mandos(p):
    p.abre("#menu")
    p.elige(".mando button", "Menú")
    p.elige(".opciones button", "Paralela › Perfil")
    p.es("menu-perfil", "una opción del menú")
    p.abre("#luces_animadas")
    antes = p.imagen()
    p.exige("/^espera \\d{3,}$/.test(hecho.ordenes.join())", "el enlace lleva cuánto se ha animado")
    exige(p.imagen() != antes, "y lo que se anima se mueve solo")
    for enlace, botones in (
        ("#tiras", "1234567890u"),
        ("#bezier", "n←→↑↓uU"),
    ):  # «1 a 9» son nueve; «o n y flechas», cinco
        p.abre(enlace)
        p.ve(f"todos('.mando button').map(b => b.textContent).join('') === '{botones}'", f"{enlace} tiene sus botones")
    p.abre("#grua;tecla d")
    p.ve("una('.estado').textContent.startsWith('Grúa de obra: giro')", "el título de la ventana se ve")
    p.js(
        """HTMLAnchorElement.prototype.click = function () {
          fetch(this.href).then(r => r.blob()).then(b => { window.bajado = this.download + ' ' + b.type })
        };
        una('.guarda').click()"""
    )
    p.exige("window.bajado === 'grua.png image/png'", "la imagen se guarda")


def pantalla_completa(p):
    p.abre("#grua;tecla d")
    p.pulsa(".completa")
    ocupa = "sesion?.lienzo.width === marco.clientWidth"
    p.exige(f"document.fullscreenElement === marco && {ocupa}", "la pantalla completa lo es")
    p.js("document.exitFullscreen()")
    p.exige("sesion.lienzo.width === 240", "y se sale de ella")
    p.js("document.activeElement.blur()")
    p.n.talla(1920, 1080)
    p.n.tecla("p")
    p.exige(f"document.fullscreenElement === una('.escena') && {ocupa}", "p proyecta el programa")
    navegador.proyectable(p.n, ".escena")
    p.n.tecla(AVPAG)
    sin_ordenes = "hecho.ordenes.length === 0"
    p.exige(f"sesion?.vivo && visto.caso === visto.programa.casos[0] && {sin_ordenes}", "AvPág pasa al caso siguiente")
    for _ in p.da("visto.programa.casos"):
        p.n.tecla(DERECHA)
    vecino = list(navegador.PROGRAMAS)[list(navegador.PROGRAMAS).index("grua") + 1]
    p.exige(
        f"sesion?.vivo && visto.programa.nombre === '{vecino}' && document.fullscreenElement",
        "y tras el último, la flecha, que la grúa no usa, al programa siguiente",
    )
    teclas_proyectando(p)
    p.js("document.exitFullscreen()")


def teclas_proyectando(p):
    """Inicio y Fin, en el capítulo; b y el punto, en negro, salvo que sean del programa; ?, la ayuda. Cada una, dos
    veces."""
    suyos = [q.nombre for q in navegador.PROGRAMAS.values() if q.capitulo.nombre == "ch08_texturas_avanzadas"]
    p.va_a("#bump")
    for tecla, cual in ((FIN, suyos[-1]), (INICIO, suyos[0])):
        for _ in range(2):
            p.n.tecla(tecla)
            p.exige(
                f"visto.programa.nombre === '{cual}' && sesion?.vivo", f"{cual} es el primero o el último del capítulo"
            )
    clase = "una('.escena').classList.contains('{}')"
    for enlace, suyas in (("#grua", ""), ("#bump", "b"), ("#volumen_vista", ".")):
        p.va_a(enlace)
        p.exige(f"'#' + visto.programa.nombre === '{enlace}' && sesion?.vivo", f"{enlace}, proyectado")
        for tecla, que in (("b", "negro"), (".", "negro"), ("?", "con-teclas")):
            for debe in (tecla not in suyas, False):
                p.n.tecla(tecla)
                p.ve(f"{clase.format(que)} === {str(debe).lower()}", f"{enlace}: «{tecla}» proyectando: {que}, {debe}")
        p.n.tecla("?")
        dicha = p.da("una('.teclas').offsetParent && una('.teclas').textContent")
        exige(dicha and all((f" {t} " in f" {dicha}") != (t in suyas) for t in "b."), f"{enlace}, la ayuda: {dicha}")
        p.n.tecla("?")
    p.va_a("#tetera-malla")
    p.exige("una('h2.proyectado').textContent === 'La tetera de Utah: La malla'", "proyectado se dice qué caso es")


def fin(p):
    p.abre("#grua")
    p.ve("una('#programa .enunciado').textContent.includes('cubos de lado uno')", "el enunciado de su ejercicio")
    navegador.accesible(p.n, "la página de un programa")
    p.va_a("")
    navegador.accesible(p.n, "la página de todos")
    p.termina("#grua")
    p.js("una('.telon button').click()")
    p.exige("sesion?.vivo && telon.hidden", "y se puede empezar de nuevo")
    p.va_a("#grua;tecla nada")
    p.exige("!telon.hidden && /tecla nada/.test(telon.textContent)", "un guion mal escrito se dice")
    for enlace in ("no_existe", "%", "%E0%A4%A", "a" * 100000):
        p.va_a("#" + enlace)
        dice = enlace if len(enlace) <= 60 else enlace[:60] + "…"
        p.exige(f"una('#no-esta').textContent.includes('«{dice}»')", f"#{enlace[:9]} se dice que no está")


def adversidades(p):
    mientras_carga(p)
    empezar_muchas_veces(p)
    tarjeta(p)
    imagen_que_tarda(p)
    enlaces_hostiles(p)
    descarga_que_falla(p)


# El próximo programa no acaba de cargar hasta que se llama a carga().
LENTO = """window.carga = undefined;
const rapido = WebAssembly.instantiate;
WebAssembly.instantiate = async (...todo) => {
  WebAssembly.instantiate = rapido;
  await new Promise(sigue => { window.carga = sigue });
  return rapido(...todo);
};
"""


def mientras_carga(p):
    p.abre("#grua")
    p.js(LENTO + "una('.otra-vez').click()")
    p.exige("window.carga", "un programa que tarda en cargar")
    p.va_a("#camara")
    p.exige("sesion?.vivo", "se va a otro sin esperar a que acabe")
    titulo = p.js("const antes = una('.estado').textContent; carga(); return antes")
    time.sleep(1)
    exige(titulo and not titulo.startswith("Grúa"), "es el otro")
    exige(p.da("una('.estado').textContent") == titulo, "y el primero no escribe en la página del otro")
    p.js(LENTO + "location.hash = '#grua'")
    p.exige("window.carga && visto.programa.nombre === 'grua'", "vuelve")
    x, y = p.lienzo()
    p.actua("mouse", [va(x + 60, y + 90), baja()])
    p.js("marco.style.setProperty('width', '260px', 'important')")
    time.sleep(0.3)
    p.js("carga()")
    p.exige("sesion?.vivo", "se carga con el ratón pulsado")
    p.actua("mouse", [va(x + 160, y + 60, 40), sube()])
    p.js("escena.gestos.suelta()")
    p.ve("sesion.vivo && !hecho.ordenes.length", "y arrastrar entonces no hace nada")
    p.exige("sesion.lienzo.width === 260", "y se dibuja del tamaño que ha tomado la página mientras")


def empezar_muchas_veces(p):
    p.js(
        """window.viejo = escena.gestos;
        for (let i = 0; i < 9; ++i) una('.otra-vez').click();"""
    )
    uno = "sesion?.lienzo.isConnected && sesion.vivo && todos('canvas').length === 1"
    p.exige(uno, "empezar nueve veces seguidas es empezar una")
    p.js(
        """viejo.gira({ id: 1, x: 1, y: 1 }, 99, 0);
        todos('.mando button')[0].dispatchEvent(new Event('pointerdown'))"""
    )
    p.exige("hecho.ordenes.length > 2", "una tecla de la pantalla se repite")
    repite = "new Set(hecho.ordenes).size === 1 && hecho.ordenes[0] === 'tecla a'"
    p.ve(repite, "y un lienzo que ya no está no da nada")
    p.va_a("#camara")
    p.exige("visto.programa.nombre === 'camara' && sesion?.vivo", "se va a otro programa con esa tecla pulsada")
    time.sleep(0.2)
    p.ve("!hecho.ordenes.length", "y ya no le llega")


# Los lienzos que piden la tarjeta.
USAN = """window.usan = new Set();
const da = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (que, ...mas) {
  if (que === 'webgl2') usan.add(this);
  return da.call(this, que, ...mas);
};
"""


def tarjeta(p):
    """Quien ya no está en la página la suelta: un navegador da pocas."""
    for enlace in ("#grua", "#ejercicio/L5.1"):
        p.abre(enlace)
        p.js(USAN)
        for _ in range(4):
            p.js("una('.otra-vez').click()")
            p.exige("sesion?.vivo", f"{enlace} empieza otra vez")
        sueltan = "[...usan].every(c => c.isConnected || c.getContext('webgl2').isContextLost())"
        p.exige(f"usan.size > 3 && {sueltan}", f"{enlace}: los que ya no están sueltan la tarjeta")


def imagen_que_tarda(p):
    p.abre("#convolucion")
    p.js(
        """const lee = createImageBitmap;
        window.createImageBitmap = async (...todo) => {
          await new Promise(sigue => { window.sigue = sigue });
          return lee(...todo);
        }"""
    )
    p.suelta_fichero("foto.png", PNG)
    p.exige("window.sigue", "una imagen que tarda en leerse")
    p.va_a("#grua")
    p.exige("visto.programa.nombre === 'grua' && sesion?.vivo", "no impide irse")
    p.js("window.antes = sesion; sigue()")
    time.sleep(0.5)
    p.ve(f"sesion?.vivo && sesion === antes && !{EN_PROPIAS}", "y no es para el otro programa")


def enlaces_hostiles(p):
    for orden in ("a" * 100000, "%25", "%"):
        p.va_a("#grua;" + orden)
        breve = "telon.textContent.length < 2000 && /guion «[a%]/.test(telon.textContent)"
        p.exige(f"!telon.hidden && {breve}", f"«{orden[:9]}…» se dice que no es una orden")
    shader = "lab/ch03_transformaciones/objeto"
    p.abre(f"#grua;captura /{shader}.frag;captura {shader}.vert;tecla d ×7")
    for tipo in ("frag", "vert"):
        texto = base64.b64decode(p.js(FICHERO, f"/{shader}.{tipo}"))
        exige(texto.startswith(b"#"), f"un enlace no escribe ficheros: objeto.{tipo}")
    p.es("grua-girada", "y lo demás que dice se hace")
    lento = p.espera_js(
        """let lento = 0, ahora = performance.now();
        const tope = ahora + 3000;
        location.hash = '#banderas;espera 1000000000 ×10000;tecla r ×10000';
        while (ahora < tope) {
          await new Promise(sigue => setTimeout(sigue));
          lento = Math.max(lento, performance.now() - ahora);
          ahora = performance.now();
        }
        return lento"""
    )
    exige(lento < 5000, f"un guion larguísimo deja vivir a la página: {lento:.0f} ms sin responder")
    p.termina("#menu")
    p.elige(".mando button", "Menú")
    p.ve("!una('.opciones').matches(':popover-open')", "y ya no se abre nada")


def descarga_que_falla(p):
    shaders = p.web.parent / "datos/shaders.js"
    fuera = shaders.rename(f"{shaders}.fuera")
    p.n.abre(p.web, "#grua")
    p.exige("/no se puede leer datos.shaders.js/.test(telon.textContent)", "lo que no se puede descargar se dice")
    fuera.rename(shaders)
    p.js("una('.telon button').click()")
    p.exige("sesion?.vivo && telon.hidden", "y se puede volver a intentar")
    p.n.registro()  # ese error sí tiene que estar


def ficheros_y_tallas(p):
    ficheros(p)
    for talla, ancho in (("width: 1px; height: 1px", 1), ("width: 9000px; height: 6750px", 4096)):
        p.abre("#grua", talla)
        p.exige(f"sesion?.lienzo.width === {ancho} && sesion.vivo", f"con {talla} el lienzo mide {ancho}")
    p.abre("#grua" + ";tecla d" * 7)
    p.js("window.quita = una('canvas').getContext('webgl2').getExtension('WEBGL_lose_context'); quita.loseContext()")
    p.exige("!telon.hidden && /perdido/.test(telon.textContent)", "que se ha perdido el contexto se dice")
    p.js("quita.restoreContext()")
    p.exige("sesion?.vivo && telon.hidden", "y al volver, sigue")
    p.es("grua-girada", "el contexto devuelto")


def ficheros(p):
    p.abre("#convolucion")
    antes = p.imagen()
    p.suelta_fichero("apuntes.txt", b"hola")
    p.exige("/apuntes.txt.*no es una imagen/.test(una('.aviso').textContent)", "lo que no es una imagen se dice")
    exige(p.imagen() == antes, "y el programa sigue")
    p.suelta_fichero("mal.ppm", b"P6 999 999 255\n\0\0")
    p.exige("!telon.hidden && /mal.ppm/.test(telon.textContent)", "un PPM cortado se dice")
    p.js("una('.telon button').click()")
    p.exige("sesion?.vivo", "y se puede seguir")
    p.suelta_fichero("foto.png", PNG)
    p.exige(EN_PROPIAS, "una imagen propia se abre")
    exige(base64.b64decode(p.js(FICHERO, p.da(EN_PROPIAS))) == ROJO_VERDE_AZUL_BLANCO, "tal como es")
    exige(p.imagen() != antes, "y se ve")
    p.abre("#malla_vf")
    p.suelta_fichero("nada.vf", b"no")
    p.exige("!telon.hidden && /nada.vf/.test(telon.textContent)", "un modelo que no lo es se dice")
    p.abre("#grua")
    p.suelta_fichero("foto.png", PNG)
    p.exige("/no lee ficheros/.test(una('.aviso').textContent)", "un programa que no lee ficheros lo dice")


def pagina(p):
    p.n.abre(p.web)
    direcciones.busquedas(p.n, "la lista")
    p.va_a("#grua")
    p.exige("sesion?.vivo", "se va a un programa")
    direcciones.busquedas(p.n, "un programa", BUSQUEDAS_DE_PROGRAMA)
    p.va_a("#grua")
    direcciones.copias(p.n, "un programa")
    for enlace, marcado in (("#ch05_iluminacion", "ch05_iluminacion"), ("#l5.1", "sombreado")):
        p.va_a(enlace)
        p.exige(f"una('.programas [aria-current]')?.hash === '#{marcado}'", f"el índice señala adónde lleva {enlace}")
        p.ve("una('#no-esta').hidden", f"{enlace} está")
    for ancho, alto in ((360, 740), (1280, 800), (1920, 1080)):
        p.n.talla(ancho, alto)
        for enlace in ("", "#grua", "#grua_zbuffer", "#convolucion_variable", "#ejercicio/L5.3", "#info_opengl"):
            p.va_a(enlace)
            p.espera("!visto.programa || cm && (sesion?.vivo || visto.programa.consola)")
            navegador.nada_se_sale(p.n, f"nada de «{enlace}»", ancho)
            if enlace.startswith("#ejercicio"):
                cabe = "todos('.lienzo, .cuadro, .parecido').every(e => e.getBoundingClientRect().bottom < innerHeight)"
                que = f"en una ventana de {ancho}×{alto} se ven las tres imágenes y cuánto coinciden"
                p.ve(f"scrollY === 0 && {cabe}", que)
    p.ve("consola.textContent.includes('OpenGL: 3.1 (imitado')", "info_opengl escribe lo que hay")
    p.n.devtools("Emulation.clearDeviceMetricsOverride")
    pedido = p.da("performance.getEntriesByType('resource').map(r => r.name)")
    fuera = [url for url in pedido if not url.startswith(("file:", "data:", "blob:"))]
    exige(not fuera, f"no se pide nada a otro servidor: {fuera[:3]}")
