"""Tocar los shaders en la página: cambiarlos bien y mal, y hacer los ejercicios, bien y mal."""
import navegador
from mal_hecho import MAL_HECHO
from navegador import RAIZ, exige

SIN_ERROR = "!una('.linea-mala') && !estado.classList.contains('mal')"


def edita_phong(p):
    p.abre("#componentes_phong")
    p.exige("editor.ruta && cm.lineCount() > 5", "el editor se abre")
    p.js("editor.abre('ch05_iluminacion/phong.glsl')")
    p.exige("editor.ruta === 'ch05_iluminacion/phong.glsl'", "se ve phong.glsl")


def editor(p):
    edita_phong(p)
    caso = p.da("una('.casos-botones [aria-pressed=true]').textContent + ' ' + una('.mira').textContent")
    exige(
        caso.startswith("Ambiente, difusa y especular La reflexión especular"),
        "lo que hay que mirar es lo que se ve al empezar",
    )
    linea = p.da("cm.getValue().split('\\n').findLastIndex(l => /^\\s*return /.test(l)) + 1")
    original = p.imagen()
    error(p, linea, original)
    edita_phong(p)
    p.escribe(linea, "    return vec3(1.0, 0.0, 0.0);\n")
    p.exige("/Cambiado/.test(estado.textContent)", "un cambio bueno se aplica solo")
    exige(p.imagen() != original, "y se ve")
    p.js("una('button', estado).click()")
    p.exige("!visto.taller.cambios.size && sessionStorage.getItem('cambios') === '[]'", "se puede volver al original")
    exige(p.imagen() == original, "y vuelve la imagen")
    p.js("todos('.pestanas button').find(b => b.textContent.endsWith('.cpp')).click()")
    p.exige("editor.ruta.endsWith('.cpp') && cm.getOption('readOnly')", "un .cpp se lee y no se cambia")


def error(p, linea, original):
    p.escribe(linea, "esto no compila;\n")
    p.exige("una('.linea-mala')", "un error se marca en el editor")
    p.ve(f"cm.lineInfo({linea} - 1).bgClass === 'linea-mala'", f"se marca la línea {linea}, que es la mala")
    p.ve(f"estado.textContent.includes('phong.glsl, línea {linea}: ')", "y se dice cuál es")
    exige(p.imagen() == original, "con un error sigue la imagen que había")
    p.js("cm.undo()")
    p.exige(SIN_ERROR, "corregido, deja de decirse")
    p.js("cm.redo()")
    p.exige("una('.linea-mala')", "y estropeado otra vez, se vuelve a decir")
    p.n.pide("/refresh")
    p.exige("!telon.hidden && una('.linea-mala')", "al volver a abrir la página el cambio sigue, y su error se dice")
    primera = "cm.coordsChar({ left: 0, top: cm.getScrollInfo().top }, 'local').line"
    p.exige(f"editor.ruta.endsWith('phong.glsl') && {primera} > 10", "y el fichero se abre por esa línea")
    p.js("todos('button', estado).at(-1).click()")
    p.exige("sesion?.vivo && telon.hidden", "vuelto al original, el programa arranca")


# --- ejercicios -----------------------------------------------------------------------------------------------------

ESCRIBE = """
for (const [ruta, texto] of Object.entries(arguments[0])) {
  await editor.abre(ruta);
  editor.cm.replaceRange(texto, { line: 0, ch: 0 }, { line: editor.cm.lineCount(), ch: 0 }, '+input');
  await editor.aplicaYa();
}
"""


def escribe_solucion(p, bien="", mal=""):
    """La del programa, con eso cambiado."""
    rutas = p.da("Object.keys(visto.ejercicio.pide)")
    p.espera_js(ESCRIBE, {ruta: (RAIZ / ruta).read_text().replace(bien, mal, 1) for ruta in rutas})


def parecido(p):
    """La parte que coincide de lo que se ve, cuando ya se ha mirado si también lo demás; y lo que se dice."""
    p.js("visto.ejercicio.comparaYa()")
    p.espera("sesion?.vivo && !una('.veredicto').textContent.startsWith('Comparando')")
    p.js("visto.ejercicio.comparaYa()")
    texto, dicho = p.da("[una('.parecido output').textContent, una('.veredicto').textContent]")
    return float(texto.removesuffix("\xa0%")), dicho


def ejercicio(p, codigo):
    resuelto = f"(localStorage.getItem('resueltos') ?? '').split(' ').includes('{codigo}')"
    p.abre("#ejercicio/" + codigo)
    p.espera("/%/.test(una('.parecido output').textContent) && editor.ruta")
    p.js("if (visto.programa.anima) escena.manda('tecla Espacio')")
    antes, dicho = parecido(p)
    exige(antes < 90, f"{codigo}, sin hacer, coincide el {antes} %: {dicho}")

    imagen, linea = p.imagen(), p.da("cm.getValue().split('\\n').findIndex(l => editor.esMarca(l)) + 2")
    p.escribe(linea, "esto no compila;\n")
    p.exige("una('.linea-mala')", f"{codigo}: un error se marca en el editor")
    p.ve(f"estado.textContent.includes('línea {linea}: ')", f"{codigo}: y se dice en qué línea")
    de_antes = antes, "El shader tiene un error: la imagen es la de antes."
    exige(parecido(p) == de_antes, f"{codigo}: con un error no cambia nada")
    exige(p.imagen() == imagen, f"{codigo}: y sigue la imagen que había")

    escribe_solucion(p, *MAL_HECHO[codigo])
    coincide, dicho = parecido(p)
    p.ve("!errores.length", f"{codigo}: lo mal hecho compila")
    exige(coincide < 99.9 or dicho.startswith("Falta"), f"{codigo}: lo mal hecho coincide el {coincide} %: {dicho}")
    p.ve(f"!{resuelto}", f"{codigo}: y no está resuelto")

    escribe_solucion(p)
    coincide, dicho = parecido(p)
    exige(coincide == 100 and dicho.startswith("Resuelto"), f"{codigo}: hecho, coincide el {coincide} %: {dicho}")
    p.ve(resuelto, f"{codigo}: y el navegador lo recuerda")
    for caso in p.da("visto.programa.casos.map(c => c.titulo)"):
        p.espera_js("await empiezaCaso(visto.programa.casos.find(c => c.titulo === arguments[0]))", caso)
        exige(parecido(p)[0] == 100, f"{codigo}: hecho, «{caso}» es igual")
    p.js("[...'dv2+'].forEach(t => escena.manda('tecla ' + t))")
    exige(parecido(p)[0] == 100, f"{codigo}: y con las mismas teclas, también")


def ejercicios(p):
    p.js("localStorage.clear()")
    suyos = p.da("JSON.parse(una('#programas').textContent).flatMap(q => q.ejercicios.map(e => e.codigo))")
    exige(sorted(suyos) == sorted(MAL_HECHO), "están todos los ejercicios")
    for codigo in MAL_HECHO:
        ejercicio(p, codigo)
    resueltos(p)
    solucion_a_la_vista(p)
    sin_guardar(p)


def resueltos(p):
    p.n.pide("/refresh")
    exige(p.espera("sesion?.vivo") and parecido(p)[0] == 100, "al volver, lo escrito sigue")
    p.va_a("")
    marca = "a.textContent.endsWith('✓') && /resuelto/.test(a.ariaLabel)"
    p.exige(f"todos('.tarjetas .a-ejercicio').every(a => {marca})", "y en la lista se ve que están resueltos")
    p.ve(f"una('.cuenta').textContent.endsWith('resuelto {len(MAL_HECHO)}')", "todos")
    p.abre("#sombreado")
    enlaces = "Ejercicio L5.1 ✓,Ejercicio L5.2 ✓,Ejercicio L5.3 ✓"
    p.ve(
        f"todos('#programa .a-ejercicio').map(a => a.textContent).join() === '{enlaces}'",
        "desde el programa se va a los suyos",
    )
    p.ve("todos('canvas').length === 1", "y fuera de ellos no hay más que el programa")


def solucion_a_la_vista(p):
    p.abre("#ejercicio/L9.2")
    p.exige("editor.ruta", "el editor se abre")
    p.escribe(1, "// lo mío\n")
    ver, texto = "todos('.tarea button')[0].click()", "cm.getValue()"
    p.js(ver)
    a_la_vista = f"cm.getOption('readOnly') && /mix\\(/.test({texto}) && !/lo mío/.test({texto})"
    p.exige(a_la_vista, "la solución se ve, y no se cambia")
    p.js(ver)
    p.exige(f"!cm.getOption('readOnly') && /lo mío/.test({texto})", "y lo de uno sigue")
    baja_lo_escrito(p)
    p.js("todos('button', estado)[0].click()")
    p.exige(f"!visto.taller.cambios.size && !/mix\\(/.test({texto})", "se puede borrar lo escrito")
    exige(parecido(p)[0] < 90, "y volver a empezar")
    p.abre("#ejercicio/L5.2;tecla v")
    p.ve("visto.caso === undefined && hecho.ordenes.join() === 'tecla v'", "un enlace lleva lo que se hace")
    navegador.accesible(p.n, "la página de un ejercicio")
    p.va_a("#ejercicio/L99.1")
    p.exige("una('#no-esta').textContent === 'No hay ningún ejercicio «L99.1».'", "el que no está se dice")


def baja_lo_escrito(p):
    """Con el nombre del shader, que es como lo espera ./lab corrige."""
    p.js(
        """window.bajado = []; const { click } = HTMLAnchorElement.prototype;
      HTMLAnchorElement.prototype.click = function () {
        if (!this.download) return click.call(this);
        fetch(this.href).then(r => r.text())
          .then(texto => bajado.push([this.download, texto === cm.getValue()].join()));
      };
      todos('.descarga')[0].click();"""
    )
    p.exige("bajado.join() === 'mezcla.frag,true'", "lo escrito se descarga con el nombre del shader")


def sin_guardar(p):
    prohibe = """for (const almacen of ['localStorage', 'sessionStorage'])
      Object.defineProperty(window, almacen, { get() { throw new DOMException('no', 'SecurityError') } })"""
    prohibido = p.n.devtools("Page.addScriptToEvaluateOnNewDocument", source=prohibe)
    p.abre("#ejercicio/L9.2")
    p.espera("editor.ruta")
    escribe_solucion(p)
    exige(parecido(p)[1].startswith("Resuelto"), "donde no se puede guardar nada, también se resuelve")
    p.ve("una('a.a-ejercicio[href$=\"L9.2\"]').textContent.endsWith('✓')", "y se dice")
    p.n.devtools("Page.removeScriptToEvaluateOnNewDocument", **prohibido)
