// Un cuadro explicado (base/cuadro.mjs), sin navegador: lo que de él se dice en la terminal (explica/palabras.py) está
// en la página, en su sitio, y cada orden enseña lo suyo.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { muestraCuadro } from '../../herramientas/base/cuadro.mjs';
import { dePython } from './navegador.mjs';

/// Lo poco de un elemento que hace falta para escribir la página y leerla.
export class Nodo {
  hijos = [];
  como = { class: '' };
  classList = { add() {}, toggle() {} };

  constructor(etiqueta) { this.etiqueta = etiqueta; }
  append(...hijos) { this.hijos.push(...hijos); }
  replaceChildren(...hijos) { this.hijos = hijos; }
  setAttribute(cual, valor) { this.como[cual] = valor; }
  addEventListener(cual, hace) { this[cual] = hace; }
  getBoundingClientRect() { return {}; }
  get children() { return this.hijos.filter(h => h instanceof Nodo); }
  get textContent() { return this.hijos.map(h => h.textContent ?? h).join('').replaceAll('−', '-'); }
  de(que) {
    const es = n => n.etiqueta === que || n.como.class.split(' ').includes(que);
    return this.children.flatMap(h => [...es(h) ? [h] : [], ...h.de(que)]);
  }
}

Object.assign(globalThis, { requestAnimationFrame() {}, ResizeObserver: class { observe() {} } });

/// De un píxel, lo que da --json y lo que se dice: con mezcla, bucles, otro framebuffer y pruebas que no se pasan.
const EXPLICADOS = dePython(`import contextlib, io, json, sys, tempfile
from pathlib import Path
from base import catalogo
from explica import orden
raiz, build, *cuales = sys.argv[1:]
programas, hechos = {p.nombre: p for p in catalogo.lee_programas(Path(build))}, []
for nombre, *suyas in map(str.split, cuales):
    with tempfile.TemporaryDirectory() as t, contextlib.redirect_stdout(io.StringIO()) as dicho:
        sys.argv = ["", raiz, build, t, programas[nombre].capitulo.nombre, nombre, nombre, nombre, *suyas]
        sys.argv += ["--json", f"{t}/suyo"]
        orden.main()
        hechos.append([nombre, json.loads(Path(t, "suyo").read_text()), dicho.getvalue()])
print(json.dumps(hechos))`, 'orden_transparencia 240 340', 'convolucion 600 420', 'espejo_plantilla 260 330',
'espejo 260 330', 'antialiasing 480 300');

/// Cada trozo de cada línea de la terminal, de las que siguen a la que empieza así, está en la fila que le toca.
function estan(dicho, empieza, filas) {
  const suyas = dicho.split(empieza)[1]?.split('\n').slice(1) ?? [], fin = suyas.findIndex(l => !/^ *\d+ {2}/.test(l));
  for (const [i, linea] of suyas.slice(0, fin).entries())
    for (const trozo of linea.replace(/e-0/g, 'e-').trim().split(/ · |: | {2}| → (?=\()| de (?=\d)|, nivel| \+ /))
      assert.ok(filas[i]?.textContent.includes(trozo.replaceAll('−', '-')), `«${trozo}» no está en la fila ${i}`);
}

test('un cuadro: lo que dice la terminal está en la página, y cada orden enseña lo suyo', () => {
  globalThis.document = { createElement: e => new Nodo(e), createElementNS: (_, e) => new Nodo(e) };
  for (const [nombre, datos, dicho] of EXPLICADOS) {
    const { historia, ordenes, pixel, sombreado } = datos, pagina = new Nodo('main');
    muestraCuadro(datos, pagina);
    const filas = pagina.de('sucesos')[0].de('tr').slice(1);
    assert.equal(filas.length, historia.length, nombre);
    estan(dicho, /en \(\d+, \d+\): .*/, filas);
    estan(dicho.replace(/ · \w+\.cpp:\d+[^:\n]*/g, ''), /^(?:Sin esa prueba|No dibujan).*/m,
      pagina.de('ul').find(ul => !ul.como.class)?.de('li'));
    const veces = [];
    for (const { en } of sombreado?.fragmento.lineas ?? []) veces[en] = (veces[en] ?? 0) + 1;
    assert.deepEqual([...(pagina.de('fuente')[1]?.textContent ?? '').matchAll(/… (\d+) en total/g)].map(m => +m[1]),
      veces.filter(n => n > 12));
    for (const [i, o] of ordenes.entries()) {
      pagina.de('tira')[0].de('button')[i].click();
      const [suya] = pagina.de('una-orden'), antes = ordenes.slice(0, i).findLast(a => a.estado.length);
      for (const dice of [`${o.n} · ${o.titulo}`, o.llamada, `, en ${o.framebuffer}`, o.sitio.texto, ...o.pruebas])
        assert.ok(suya.textContent.includes(dice.replaceAll('−', '-')), `orden ${o.n}: ${dice}`);
      assert.deepEqual(suya.de('puesto').flatMap(p => p.de('dd').map(dd => dd.como.class === 'cambia')),
        o.estado.map(e => Boolean(antes) && antes.estado.find(a => a.nombre === e.nombre)?.valor !== e.valor));
      const deSuyo = que => ordenes.slice(0, i + 1).findLast(a => a.framebuffer === o.framebuffer && a[que])?.[que];
      assert.deepEqual(suya.de('img').map(img => img.como.src),
        ['miniatura', 'profundidad', 'plantilla'].map(deSuyo).filter(Boolean), `orden ${o.n}`);
      assert.equal(suya.de('pixel').length, +(pixel && o.framebuffer === 'la ventana' && Boolean(deSuyo('miniatura'))));
    }
  }
  const [[, datos]] = EXPLICADOS, pagina = new Nodo('main'); // una matriz, que en GLSL va por columnas
  Object.assign(datos.sombreado.fragmento.lineas.find(l => l.valor[0]), { tipo: 'mat2x3', valor: [1, 2, 3, 4, 5, 6] });
  muestraCuadro(datos, pagina);
  assert.deepEqual(pagina.de('matriz')[0].de('tr').map(fila => fila.textContent), ['14', '25', '36']);
});
