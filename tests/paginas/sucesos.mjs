// Lo que la página hace con cada suceso del ratón y del teclado, sin navegador: lo que se pulsa se suelta, lo que se
// pone se quita, y de cada punto del lienzo sale su píxel.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Nodo } from './cuadro.mjs';

class Clases extends Set {
  contains(clase) { return this.has(clase); }
  remove(...clases) { for (const clase of clases) this.delete(clase); }
  toggle(clase, si = !this.has(clase)) { return si ? this.add(clase) : this.delete(clase); }
}

/// De cada selector, siempre el mismo; y nadie por encima.
class Elemento extends Nodo {
  #dentro = {};
  classList = new Clases();
  isConnected = true;
  style = {};
  textContent = '';

  getAttribute(cual) { return String(this.como[cual]); }
  querySelector(cual) { return this.#dentro[cual] ??= new Elemento(); }
  getBoundingClientRect() { return { left: 30, top: 20, width: 240, height: 180 }; }
  focus() {}
  remove() {}
  closest() {}
  setPointerCapture() {}

  /// Falso si alguien se lo queda.
  pasa(que, datos = {}) {
    const suceso = { target: this, currentTarget: this, button: 0, pointerId: 1, ...datos, stopPropagation() {},
      preventDefault() { this.quedado = true; } };
    for (const oye of [this[que], this[`on${que}`]]) oye?.(suceso);
    return !suceso.quedado;
  }
}

const pagina = new Elemento(), una = pagina.querySelector.bind(pagina), lienzo = una('.lienzo'), relojes = [];
lienzo.querySelector = () => lienzo; // hace también de su marco
pagina.querySelector = que => que === '.lienzo canvas' ? lienzo : que === '.lienzo .aqui' ? undefined : una(que);
pagina.createElement = () => new Elemento();
const enVentana = new Elemento(); // lo que oye las teclas antes que nadie
let semilla = 1;
export const azar = n => (semilla = semilla * 48271 % 2147483647) % n; // siempre los mismos
const elige = lista => lista[azar(lista.length)];

/// Con ese documento, los módulos, que al importarlos lo miran; el tiempo pasa con corre().
const conPagina = hace => async () => {
  const { setTimeout, clearTimeout } = globalThis;
  Object.assign(globalThis, { document: pagina, window: globalThis, requestAnimationFrame() {},
    addEventListener: (...oye) => enVentana.addEventListener(...oye), setTimeout: hace => relojes.push(hace),
    clearTimeout: cual => { delete relojes[cual - 1]; } });
  const modulos = ['entrada', 'punteria', 'mandos', 'proyeccion'].map(m => import(`../../herramientas/web/${m}.mjs`));
  hace(Object.assign({}, ...await Promise.all(modulos)));
  Object.assign(globalThis, { setTimeout, clearTimeout, document: undefined });
};
const corre = () => relojes.splice(0).forEach(hace => hace?.());

test('se elige el píxel de debajo del puntero o adonde llevan las flechas, y nunca cae fuera', conPagina(modulos => {
  const FLECHAS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], Home: [0, 0] };
  const dentro = (v, n) => Math.max(0, Math.min(n - 1, Math.floor(v))), elegidos = [], hechos = [];
  modulos.atiendePunteria(pixel => { elegidos.push(pixel); }, () => true);
  for (let vez = 0; vez < 200; ++vez) {
    const [width, height] = elige([[240, 180], [1, 1], [480, 90], [7, 1000]]);
    let [x, y] = [dentro(width / 2, width), dentro(height / 2, height)];
    Object.assign(lienzo, { width, height });
    assert.ok(lienzo.pasa('pointerdown') && lienzo.pasa('keydown', { key: 'Enter' }), 'aún es del programa');
    una('.explica').onclick();
    for (let n = azar(30); n > 0; --n) {
      const key = elige(Object.keys(FLECHAS)), shiftKey = azar(2) > 0, salto = shiftKey ? 10 : 1;
      assert.ok(!lienzo.pasa('keydown', { key, shiftKey }), 'ya no lo es');
      [x, y] = [dentro(x + salto * FLECHAS[key][0], width), dentro(y + salto * FLECHAS[key][1], height)];
      assert.equal(lienzo.hijos.at(-1).style, `left: ${100 * (x + 0.5) / width}%; top: ${100 * (y + 0.5) / height}%`);
    }
    const [clientX, clientY] = [azar(300), azar(240)], como = azar(4);
    if (como === 1) [x, y] = [(clientX - 30) * width / 240, (clientY - 20) * height / 180];
    if (como < 2) hechos.push([dentro(x, width), dentro(y, height)]);
    [() => lienzo.pasa('keydown', { key: 'Enter' }), () => lienzo.pasa('pointerdown', { clientX, clientY }),
      () => lienzo.pasa('keydown', { key: elige(['Escape', 'x']) }), una('.explica').onclick][como]();
    assert.deepEqual([elegidos, lienzo.classList.has('apunta'), una('.explica').getAttribute('aria-pressed')],
      [hechos, false, 'false']);
  }
}));

test('cada tecla es de quien tiene el foco o, si el programa la usa, suya; con Ctrl o Meta, del navegador', conPagina(
  ({ atiendeTeclado }) => {
    const dadas = [], escena = { manda: orden => dadas.push(orden), recarga: () => dadas.push('especial F5') };
    const mandos = [{ teclas: [['d', 'tecla d'], ['Espacio', 'tecla Espacio'], ['←', 'especial IZQUIERDA']] }];
    const ORDENES = { d: 'tecla d', ' ': 'tecla Espacio', ArrowLeft: 'especial IZQUIERDA', ArrowDown: 'especial ABAJO',
      z: 'tecla z', Enter: 'tecla Intro', Escape: 'tecla Esc', F1: 'especial F1', F5: 'especial F5',
      F10: 'especial F10', Tab: '', F12: '' };
    let programa;
    pagina.body = new Elemento();
    pagina.querySelector = (antes => que => que === '.apunta' ? undefined : antes(que))(pagina.querySelector);
    atiendeTeclado(escena, () => programa);
    for (let vez = 0; vez < 2000; ++vez) {
      const foco = elige(['body', 'canvas', 'button', 'a', 'summary', 'select', 'input', '.editor', '.opciones']);
      const target = { closest: que => que.split(', ').includes(foco) }, key = elige(Object.keys(ORDENES));
      const cualquiera = !azar(4), con = elige(['', '', 'ctrlKey', 'metaKey', 'altKey']);
      const conAlt = con === 'altKey' && foco === 'canvas' && key.length === 1; // con AltGr se escribe, y es suya
      const orden = con && !conAlt ? '' : ORDENES[key];
      programa = azar(9) ? { mandos, cualquiera } : undefined;
      const loUsa = /^(Escape|F\d+)$/.test(key) ? foco === 'canvas' : cualquiera || 'd ArrowLeft'.includes(key);
      const loPulsa = /^(button|a|summary)$/.test(foco) && /^( |Enter)$/.test(key);
      const suya = programa && orden && loUsa && !loPulsa && !/select|input|editor|opciones/.test(foco);
      const quedada = !pagina.pasa('keydown', { key, target, [con]: true, getModifierState: () => false });
      assert.deepEqual([quedada, dadas.splice(0)], suya ? [true, [orden]] : [false, []], `${con} ${key} en ${foco}`);
    }
  }));

test('cada botón y la rueda llegan como son, en su sitio; lo que se pulsa se suelta, y hasta ahí se repite', conPagina(
  ({ atiende, ponMandos }) => {
    const dadas = [], lienzo = Object.assign(new Elemento(), { width: 480, height: 90 }), escena = { sesion: { lienzo },
      opciones: () => menu ? ['a'] : [], manda: orden => dadas.push(orden), recarga: () => dadas.push('recarga'),
      ensenaMenu: (...donde) => dadas.push(`menú ${donde}`) };
    let menu = false;
    const gestos = atiende(lienzo, escena, false), BOTONES = ['IZQUIERDO', 'CENTRAL', 'DERECHO'];
    const hace = (que, datos) => { lienzo.pasa(que, datos); gestos.suelta(); return dadas.splice(0); };
    for (let vez = 0; vez < 100; ++vez) {
      const pulsado = !azar(3), button = azar(3), [clientX, clientY] = [30 + azar(240), 20 + azar(180)];
      const suyo = BOTONES[pulsado ? 2 : button], sitio = `${(clientX - 30) * 2} ${Math.round((clientY - 20) / 2)}`;
      menu = !azar(3);
      una('.derecho').setAttribute('aria-pressed', pulsado);
      const hechas = ['pointerdown', 'pointermove', elige(['pointerup', 'pointercancel'])]
        .flatMap(que => hace(que, { button, clientX, clientY }));
      assert.deepEqual(hechas, menu && button === 2 ? [`menú ${clientX},${clientY}`]
        : [`boton ${suyo} abajo ${sitio}`, `arrastra ${sitio}`, `boton ${suyo} arriba ${sitio}`]);
      for (const [deltaY, gira] of [[100, '-1'], [-100, '+1']])
        assert.deepEqual(hace('wheel', { clientX, clientY, deltaY, deltaMode: 0 }), [`rueda ${gira} ${sitio}`]);
    }
    ponMandos({ derecho: true, mandos: [{ teclas: [['d', 'tecla d'], ['F5', 'especial F5']], hace: '' }] }, escena);
    const [{ hijos: [d, f5] }, { hijos: [boton] }] = una('.mandos').hijos;
    for (const [i, fin] of ['pointerup', 'pointerleave', '', 'pointercancel'].entries()) {
      d.isConnected = true;
      for (let dedos = 1 + i % 2; dedos > 0; --dedos) d.pasa('pointerdown');
      for (let n = azar(4); n >= 0; --n) corre();
      assert.ok(dadas.splice(0).every(orden => orden === 'tecla d') && relojes.length === 1, 'se repite');
      d.pasa(fin);
      d.isConnected = Boolean(fin); // si no, se ha ido a otro programa
      corre();
      assert.deepEqual([dadas, relojes], [[], []], fin);
    }
    for (const b of [d, f5]) b.pasa('click');
    assert.deepEqual(dadas, ['tecla d', 'recarga']);
    const puesto = [1, 2, 3].map(() => boton.pasa('click') && boton.getAttribute('aria-pressed'));
    assert.deepEqual(puesto, ['true', 'false', 'true']);
  }));

test('proyectando, lo que se pasa se ve, cada tecla del programa es suya y al salir nada queda', conPagina(modulos => {
  const escena = una('.escena'), hechas = [], clases = () => ['negro', 'con-teclas'].map(c => escena.classList.has(c));
  let programa;
  modulos.atiendeProyeccion(() => programa, Object.fromEntries(['pasa', 'salta'].map(que =>
    [que, n => hechas.push(`${que} ${n}`)])));
  const PASAN = { PageDown: 'pasa 1', PageUp: 'pasa -1', Home: 'salta 0', End: 'salta -1', ArrowRight: 'pasa 1',
    ArrowLeft: 'pasa -1' };
  for (let vez = 0; vez < 600; ++vez) {
    const suyas = ['b', '.', '?', 'especial DERECHA', 'x'].filter(() => azar(2)), [negro, ayuda] = clases();
    programa = azar(9) && { mandos: [{ teclas: suyas.map(t => [t, t]) }] };
    pagina.fullscreenElement = azar(9) ? escena : undefined;
    const key = elige([...Object.keys(PASAN), 'b', '.', '?', 'x']), ctrlKey = !azar(9);
    const quedada = !enVentana.pasa('keydown', { key, ctrlKey });
    const deOtro = !programa || !pagina.fullscreenElement || ctrlKey || key === 'x' ||
      suyas.includes(/^Arrow/.test(key) ? 'especial DERECHA' : key);
    assert.deepEqual([quedada, hechas.splice(0).join(), ...clases()], deOtro ? [false, '', negro, ayuda]
      : [true, PASAN[key] ?? '', /^[b.]$/.test(key) && !negro, ayuda !== (key === '?')], `${key}, con ${suyas}`);
    const dice = ` ${escena.querySelector('.teclas').textContent} `;
    if (!deOtro) for (const t of ['b', '.']) assert.equal(dice.includes(` ${t} `), !suyas.includes(t), dice);
    if (!pagina.fullscreenElement) pagina.pasa('fullscreenchange');
    assert.ok(pagina.fullscreenElement || !clases().includes(true));
  }
}));
