"""Explicar en la página: se pregunta de cada programa, en dos píxeles suyos; de cada manera de pedirlo, con el ratón,
el teclado, un enlace; con un shader cambiado y en un ejercicio."""
import json
import os
import re
import subprocess
import tempfile
import zlib
from pathlib import Path

import navegador
from base import libro
from navegador import BUILD, ESC, IZQUIERDA, PROGRAMAS, RAIZ, exige

SIN_SOSPECHAS = {"tiras": "«diametroPunto»", "primer_programa": "no se dibuja nada"}  # con razón, y a propósito

# La historia acaba en el color de la imagen; el shader da el color que se le apunta, y nada cambia.
MIRA = """const { lienzo } = sesion, { width, height } = lienzo, gl = lienzo.getContext('webgl2');
const todo = new Uint8Array(4 * width * height), [x, y, sabido] = arguments, i = 4 * ((height - 1 - y) * width + x);
const lee = () => { gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, todo); return todo.join(); };
escena.quieta = true;
const antes = lee(), color = [...todo.slice(i, i + 3)], desde = performance.now();
const datos = await pagina.explica([x, y]), mal = [], tarda = performance.now() - desde;
if (!datos) return { mal: ['no lo explica: ' + una('.aviso').textContent] };
const { historia, sombreado, ordenes } = datos, escritos = historia.filter(s => s.veredicto === 'escrito');
const gana = escritos.at(-1), de = s => s.slice(0, 3).join();
if (de(datos.color) !== de(color) || de(gana.despues) !== de(color))
  mal.push(`es (${color}), se dice (${datos.color}) y la historia acaba en (${gana.despues})`);
if (lee() !== antes) mal.push('la imagen ha cambiado');
sesion.redibuja();
if (lee() !== antes) mal.push('la imagen, dibujada otra vez, ha cambiado');
if (gl.getError()) mal.push('queda un error de OpenGL');
if (!sesion.vivo) mal.push('el programa ha terminado');
for (const [k, s] of historia.entries()) {
  if (k && de(s.antes) !== de(historia[k - 1].despues)) mal.push(`la orden ${s.orden} encuentra otro color`);
  if (s.veredicto !== 'escrito' && de(s.antes) !== de(s.despues))
    mal.push(`la orden ${s.orden} no escribe y cambia el color`);
  if (s.mezcla && !s.mezcla.cuadra) mal.push(`la orden ${s.orden} deja (${s.despues}) y no (${s.mezcla.suma})`);
}
if (!sombreado !== (gana.primitiva === undefined)) mal.push('no es el shader de quien gana');
if (sombreado) {
  const { fragmento, vertices, entradas = [], pesos } = sombreado;
  const ultimo = fragmento.lineas.findLast(l => l.clase === 'salida')?.valor ?? [NaN];
  if (fragmento.pasos < 4000 && ultimo.some((v, k) => !(Math.abs(v - gana.color[k]) <= 1 / 255)))
    mal.push(`el shader apunta (${ultimo}) y da (${gana.color})`);
  for (const t of [fragmento, ...vertices])
    if (t.motivo || t.sinSeguir.length) mal.push(t.motivo + JSON.stringify(t.sinSeguir));
  if (vertices.length !== gana.vertices.length || (vertices.length === 3) !== Boolean(pesos))
    mal.push('faltan vértices');
  // la posición, en float, se redondea; en un triángulo de menos de un píxel eso cambia más los pesos
  const en = vertices.map(v => v.lineas.findLast(l => l.nombre === 'gl_Position').valor)
    .map(([x, y, , w]) => [x / w, y / w]);
  const [[x0, y0], [x1, y1], [x2, y2]] = pesos ? en : [[0, 0], [1, 0], [0, 1]];
  const alto = Math.abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) /
    Math.max(Math.hypot(x1 - x0, y1 - y0), Math.hypot(x2 - x1, y2 - y1), Math.hypot(x2 - x0, y2 - y0));
  for (const e of entradas) {
    const talla = Math.max(1, ...e.valor.map(Math.abs)), tolera = 1e-5 + 4 * 2 ** -23 / alto;
    if (e.valor.some((v, k) => !(Math.abs(v - e.interpolado[k]) <= tolera * talla)))
      mal.push(`${e.nombre} vale (${e.valor}) y de los vértices sale (${e.interpolado})`);
  }
  if (!todos('.explicacion .apunte').length) mal.push('no se ve ninguna línea');
  const { atributos, uniformes, texturas } = ordenes.find(o => o.n === gana.orden).cableado;
  const cosas = new Set([...atributos, ...uniformes].map(c => c.nombre).concat(texturas.map(t => t.sampler)));
  await new Promise(hecho => requestAnimationFrame(() => requestAnimationFrame(hecho)));
  const lineas = todos('.explicacion .cableado path').length;
  if (todos('.explicacion .cableado > div:first-child li').length !== cosas.size || lineas < cosas.size)
    mal.push(`de ${cosas.size} cosas salen ${lineas} líneas`);
}
const dichas = datos.sospechas.filter(s => !sabido || !s.dice.includes(sabido));
if (dichas.length) mal.push('se sospecha: ' + dichas.map(s => s.dice));
if (todos('.explicacion .tira li').length !== ordenes.length ||
  ordenes.some(o => o.cambian === undefined && o.framebuffer === 'la ventana'))
  mal.push('no están todas las órdenes');
return { mal, tarda, guion: hecho.ordenes.join(';'),
  dice: [historia.map(s => [s.orden, s.primitiva ?? -1, s.veredicto]), datos.sospechas.map(s => s.dice).sort()] };
"""


CADA = 3  # de los programas, uno se explica también con los otros enlaces; en ./lab prueba, solo ese


def cada_programa(p, uno_de):
    tiempos, comparados = [], 0
    for i, programa in enumerate([q for q in PROGRAMAS.values() if not q.consola]):
        if i % uno_de:
            continue
        p.abre(f"#{programa.nombre}")
        azar = zlib.crc32(programa.nombre.encode())
        for punto in ((40 + azar % 160, 40 + azar // 160 % 110), (120, 90)):
            visto = p.espera_js(MIRA, *punto, SIN_SOSPECHAS.get(programa.nombre))
            bien = isinstance(visto, dict) and visto["mal"] == []
            exige(bien, f"{programa.nombre}: el píxel {punto} se explica: {visto}")
            if bien:
                tiempos.append(visto["tarda"])
            for enlace in ("osmesa", "egl") if bien and i % CADA == 0 else ():
                comparados += 1
                otra = lo_que_dice(enlace, programa, visto["guion"], punto)
                exige(otra == visto["dice"], f"{programa.nombre}: {punto}, en {enlace}, {otra} y no {visto['dice']}")
    tiempos.sort()
    mediana = tiempos[len(tiempos) // 2]
    print(
        f"explicar un píxel, {len(tiempos)} veces: mediana {mediana:.0f} ms, la peor {tiempos[-1]:.0f} ms", flush=True
    )
    print(f"{comparados} historias comparadas con las de OSMesa y EGL", flush=True)


SOLO_ALLI = re.compile("determinante 0|0 vértices|no se dibuja nada")  # lo que un shader no puede causar


def lo_que_dice(enlace, programa, guion, punto):
    """Con ./lab explica, lo que le pasa a ese píxel de la ventana, [orden, primitiva, veredicto], y lo que se sospecha
    de lo que puede venir de un shader."""
    with tempfile.TemporaryDirectory() as carpeta:
        ejecutable = BUILD / enlace / programa.capitulo.nombre / programa.nombre
        pide = {"LAB_EXPLICA": "e.json", "LAB_EXPLICA_PIXELES": "{},{}".format(*punto)}
        entorno = {**os.environ, "LD_PRELOAD": str(BUILD / "herramientas/explica/libexplica.so"), **pide}
        orden = [ejecutable, "-geometry", "240x180", *(["-guion", guion] * bool(guion)), "-ppm", "i.ppm"]
        subprocess.run(orden, env=entorno, cwd=carpeta, check=True, capture_output=True)
        cuadro = json.loads(Path(carpeta, "e.json").read_text())
    [pixel] = cuadro["pixeles"]
    historia = [s for s in pixel["historia"] if s["framebuffer"] == 0]
    sospechas = [s["dice"] for s in cuadro["sospechas"] if not SOLO_ALLI.search(s["dice"])]
    return [[[s["orden"], s.get("primitiva", -1), s["veredicto"]] for s in historia], sorted(sospechas)]


# --- cómo se pide ----------------------------------------------------------------------------------------------------

INTRO, ARRIBA = "\ue007", "\ue013"
VISTO = "una('.explicacion > h2')?.textContent"
CERRADO = "una('.explicacion').hidden && !una('.lienzo .aqui') && !visto.explicado"


def de_cada_manera(p):
    """Con un clic, que no llega al programa; con el teclado solo; con un enlace, también el que se copia de él."""
    p.abre("#espejo_plantilla")
    apuntado = "una('.explica').getAttribute('aria-pressed') === 'true' && marco.classList.contains('apunta')"
    p.pulsa(".explica")
    p.exige(apuntado, "con el botón se apunta")
    antes = p.da("hecho.ordenes.length")
    x0, y0 = p.lienzo()
    donde = "const r = una('canvas').getBoundingClientRect(); return [arguments[0] - r.left, arguments[1] - r.top]"
    x, y = (int(v) for v in p.js(donde, x0 + 65, y0 + 82))
    p.arrastra([(65, 82)])
    p.exige(f"{VISTO} === 'El píxel ({x}, {y})'", f"un clic explica el píxel en que se da, ({x}, {y}): {p.da(VISTO)}")
    p.ve(f"hecho.ordenes.length === {antes}", "y no le llega al programa")
    p.ve("/no pasa la plantilla: hay 0 y se pide GL_EQUAL 1/.test(una('.explicacion').textContent)", "y dice por qué")
    p.ve("document.activeElement === una('.explicacion > h2')", "el foco va allí")
    p.n.tecla(ESC)
    p.exige(f"{CERRADO} && document.activeElement === una('.explica')", "Esc lo cierra, y se vuelve al botón")
    p.n.tecla("x")
    p.exige(f"{apuntado} && document.activeElement === una('canvas')", "con la tecla x se apunta")
    p.n.tecla(IZQUIERDA, IZQUIERDA, ARRIBA, INTRO)
    p.exige(f"{VISTO} === 'El píxel (118, 89)'", "con las flechas se va al píxel, e Intro lo explica")
    p.js("una('.enlace').click()")
    p.ve("location.hash.startsWith('#espejo_plantilla/explica/')", "el enlace lleva el píxel")
    for enlace in (p.da("location.hash"), "#espejo_plantilla/explica/474,358"):
        p.abre(enlace)
        p.exige(f"{VISTO} === 'El píxel (118, 89)'", f"{enlace} lo explica")
    for tecla in (ESC, "x"):
        p.abre("#espejo_plantilla")
        p.n.tecla("x")
        p.exige(apuntado, "x apunta")
        if tecla == "x":
            p.js("una('.explica').focus()")  # en el lienzo, las demás teclas no son de la página
        p.n.tecla(tecla)
        p.exige(f"{CERRADO} && !({apuntado})", "y se deja")
    p.pulsa(".explica-cuadro")
    p.exige(f"{VISTO} === 'El cuadro entero' && todos('.explicacion .tira li').length > 9", "y el cuadro entero")
    p.ve("todos('.explicacion .tira img').length > 5", "con sus miniaturas")
    laminas = "todos('.explicacion .laminas figcaption').map(f => f.textContent.split(':')[0])"
    p.js("todos('.explicacion .tira button').at(-1).click()")
    p.ve(
        f"['color', 'profundidad', 'plantilla'].every(que => {laminas}.includes(que))",
        "también la profundidad y la plantilla",
    )
    p.abre("#luces_animadas/explica/480,360")
    p.exige(f"/^El píxel/.test({VISTO})", "lo que se anima se explica")
    antes = p.da("hecho.ordenes.join()")
    p.exige(f"hecho.ordenes.join() !== '{antes}'", "y después sigue")
    p.abre("#grua/explica/9999,1")
    p.exige("/no está en la ventana/.test(una('.aviso').textContent)", "de un píxel que no hay se dice")


def con_shader_cambiado(p):
    """Lo escrito se explica según se escribe, y lo que suele dejar la ventana negra se dice."""
    p.abre("#sombreado/explica/250,210;tecla 3")
    p.exige("/NdotL = /.test(una('.explicacion').textContent)", "lo que vale N·L")
    escribe = """await editor.abre(arguments[0]);
        const lineas = cm.getValue().split('\\n'), i = lineas.findIndex(l => /^void main/.test(l));
        lineas.splice(i, 0, ...arguments[1]);
        lineas.splice(lineas.findLastIndex(l => /^}/.test(l)), 0, ...arguments[2]);
        cm.replaceRange(lineas.join('\\n'), { line: 0, ch: 0 }, { line: cm.lineCount(), ch: 0 }, '+input');
        await editor.aplicaYa()"""
    for antes, final, debe in (
        (["uniform float k;"], ["    colorFragmento *= k;"], "«k» lo usa el shader y nadie le ha dado valor: es 0"),
        ([], ["    discard;"], "el shader descarta todos sus fragmentos"),
        ([], ["    float nada = 0.0;", "    colorFragmento.r = nada / nada;"], "NaN"),
    ):
        p.abre("#sombreado/explica/250,210;tecla 3")
        p.exige("visto.explicado && editor.ruta", "explicado")
        p.espera_js(escribe, "ch05_iluminacion/sombreado_phong.frag", antes, final)
        p.exige(f"una('.explicacion').textContent.includes({debe!r})", f"con {final} se dice «{debe}»")
        sin_dar = "todos('.explicacion .cableado path.malo').length"
        p.exige(f"{sin_dar} === {len(antes)}", f"{antes} es, de las líneas, la que está mal: {p.da(sin_dar)}")
        p.js("sessionStorage.clear()")
    p.abre("#sombreado/explica/250,210;tecla 3")
    producto = "todos('.explicacion .apunte').map(a => a.textContent).find(a => a.startsWith('NdotL = '))"
    debe, phong = p.da(producto), "ch05_iluminacion/phong.glsl"
    medio = re.sub(r"    if \(NdotL > 0.0\) \{.*?\n    \}\n", "", (RAIZ / phong).read_text(), flags=re.DOTALL)
    p.espera_js("escena.cambia(...arguments); await pagina.explica(visto.explicado.pixel)", phong, medio)
    p.exige(f"{producto} === {debe!r}", f"a medio hacer, con la luz que aún nada usa, {debe}: {p.da(producto)}")
    p.abre("#ejercicio/L5.1/explica/250,210")
    p.exige(
        f"/^El píxel/.test({VISTO}) && todos('.explicacion .apunte').length", "en un ejercicio, lo de quien lo hace"
    )


def porques(p):
    """De cada pregunta de docs/porques.tsv, lo que se dice que se verá allí se ve."""
    for porque in libro.porques(RAIZ):
        p.abre("#" + porque.enlace)
        p.exige(f"/^El píxel/.test({VISTO})", f"{porque.enlace} se explica")
        texto = p.da(
            "una('.explicacion').textContent + todos('.explicacion .tira button').map(b => { b.click(); "
            "return una('.una-orden').textContent }).join()"
        )
        faltan = [t for t in re.findall("`(.+?)`", porque.mira) if t not in texto]
        exige(texto and not faltan, f"«{porque.pregunta}»: en {porque.enlace} se lee {faltan}")
    p.n.abre(p.web)
    p.ve(f"todos('.porques a').length === {len(libro.porques(RAIZ))}", "cada pregunta está en su capítulo")


def de_todo(p):
    """El panel, a cada ancho, en claro y en oscuro."""
    for ancho, alto in ((1440, 900), (1024, 768), (360, 740)):
        p.n.talla(ancho, alto)
        p.n.abre(p.web, "#espejo_plantilla/explica/260,330")
        p.exige(f"/^El píxel/.test({VISTO})", f"a {ancho} se explica")
        navegador.nada_se_sale(p.n, "nada de lo que explica un píxel", ancho)
        for esquema in ("light", "dark"):
            p.n.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": esquema}])
            navegador.accesible(p.n, f"lo que explica un píxel, {esquema}, a {ancho}")
    p.n.devtools("Emulation.clearDeviceMetricsOverride")
    p.n.devtools("Emulation.setEmulatedMedia", features=[])


def pedido(p):
    de_cada_manera(p)
    con_shader_cambiado(p)
    porques(p)
    de_todo(p)


def explica(p):
    cada_programa(p, CADA)
    pedido(p)


def explica_todos(p):
    cada_programa(p, 1)
    pedido(p)
