// Lo que la página hace con cada suceso del ratón y del teclado, sin navegador: lo que se pulsa se suelta, lo que se
// abre se cierra, lo que se pone se quita, y de cada punto del lienzo sale su píxel.
import assert from 'node:assert/strict';
import { test } from 'node:test';

/// Lo poco de un elemento que usan, sin nadie por encima: de cada selector, siempre el mismo.
class Elemento extends EventTarget {
  #clases = new Set();
  #como = new Map();
  #dentro = new Map();
  hijos = [];
  style = {};
  isConnected = true;
  classList = { toggle: (c, si = !this.#clases.has(c)) => si ? this.#clases.add(c) : this.#clases.delete(c),
    remove: (...c) => c.forEach(c => this.#clases.delete(c)), contains: c => this.#clases.has(c) };

  setAttribute(cual, valor) { this.#como.set(cual, String(valor)); }
  getAttribute(cual) { return this.#como.get(cual) ?? null; }
  append(...hijos) { this.hijos.push(...hijos); }
  replaceChildren(...hijos) { this.hijos = hijos; }
  querySelector(cual) { return this.#dentro.get(cual) ?? this.#dentro.set(cual, new Elemento()).get(cual); }
  querySelectorAll() { return this.hijos; }
  getBoundingClientRect() { return { left: 30, top: 20, right: 270, bottom: 200, width: 240, height: 180 }; }
  showPopover() { this.abierto = true; }
  hidePopover() { this.abierto = false; }
  focus() { document.activeElement = this; }
  remove() {}
  closest() {}
  setPointerCapture() {}
  get firstChild() { return this.hijos[0]; }
  /// Falso si alguien se lo ha quedado.
  pasa(que, datos = {}) {
    const suceso = Object.assign(new Event(que, { cancelable: true }), { button: 0, pointerId: 1, isPrimary: true }, datos);
    if (this[`on${que}`]) this.addEventListener(que, this[`on${que}`], { once: true });
    return this.dispatchEvent(suceso);
  }
}

const documento = new Elemento(), lienzo = documento.querySelector('.lienzo');
const crea = documento.querySelector.bind(documento); // el lienzo hace también de su marco
lienzo.querySelector = () => lienzo;
Object.assign(documento, { createElement: () => new Elemento(), body: new Elemento(),
  querySelector: que => que === '.lienzo canvas' ? lienzo : que === '.lienzo .aqui' ? undefined : crea(que) });

/// Con ese documento, los módulos, que al importarlos lo miran.
const conPagina = hace => async () => {
  Object.assign(globalThis, { document: documento, window: globalThis, addEventListener() {}, innerWidth: 300 });
  globalThis.innerHeight = 200;
  const modulos = ['entrada', 'punteria', 'menu', 'mandos', 'proyeccion'];
  hace(Object.assign({}, ...await Promise.all(modulos.map(m => import(`../../herramientas/web/${m}.mjs`)))));
  delete globalThis.document;
};

let semilla = 1;
const azar = n => (semilla = semilla * 48271 % 2147483647) % n, elige = lista => lista[azar(lista.length)];
const dentro = (v, n) => Math.max(0, Math.min(n - 1, Math.floor(v)));
const mando = documento.querySelector('.explica');
const FLECHAS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1], Home: [0, 0] };

test('el píxel que se elige es el que está bajo el puntero o adonde llevan las flechas, y nunca cae fuera', conPagina(({ atiendePunteria }) => {
  const elegidos = [], hechos = [];
  atiendePunteria(pixel => { elegidos.push(pixel); }, () => true);
  for (let vez = 0; vez < 200; ++vez) {
    const [width, height] = elige([[240, 180], [1, 1], [480, 90], [7, 1000]]);
    let [x, y] = [dentro(width / 2, width), dentro(height / 2, height)];
    Object.assign(lienzo, { width, height, hijos: [] });
    assert.ok(lienzo.pasa('pointerdown') && lienzo.pasa('keydown', { key: 'Enter' }), 'aún es del programa');
    mando.onclick();
    for (let n = azar(30); n > 0; --n) {
      const key = elige(Object.keys(FLECHAS)), shiftKey = azar(2) > 0, salto = shiftKey ? 10 : 1;
      assert.ok(!lienzo.pasa('keydown', { key, shiftKey }), 'ya no lo es');
      [x, y] = [dentro(x + salto * FLECHAS[key][0], width), dentro(y + salto * FLECHAS[key][1], height)];
      assert.equal(lienzo.hijos.at(-1).style, `left: ${100 * (x + 0.5) / width}%; top: ${100 * (y + 0.5) / height}%`);
    }
    const [clientX, clientY] = [azar(300), azar(240)], como = azar(4);
    if (como === 0) hechos.push([x, y]);
    if (como === 1) hechos.push([dentro((clientX - 30) * width / 240, width), dentro((clientY - 20) * height / 180, height)]);
    assert.equal(lienzo.getAttribute('class'), null);
    if (como === 0) lienzo.pasa('keydown', { key: 'Enter' });
    if (como === 1) lienzo.pasa('pointerdown', { clientX, clientY });
    if (como === 2) lienzo.pasa('keydown', { key: elige(['Escape', 'x']) });
    if (como === 3) mando.onclick();
    assert.deepEqual([elegidos, lienzo.classList.contains('apunta'), mando.getAttribute('aria-pressed')],
      [hechos, false, 'false']);
  }
}));

test('cada botón y la rueda llegan al programa como son, en su píxel; lo que se pulsa se suelta y se repite hasta ahí', conPagina(({ atiende, ponMandos }) => {
  const relojes = [], dadas = [], escena = { opciones: () => menu ? ['a'] : [], manda: orden => dadas.push(orden) > 0,
    ensenaMenu: (...donde) => dadas.push(`menú ${donde}`), recarga: () => dadas.push('recarga') };
  let menu = false;
  const lienzo = Object.assign(new Elemento(), { width: 480, height: 90 });
  escena.sesion = { lienzo };
  globalThis.requestAnimationFrame = () => {};
  const gestos = atiende(lienzo, escena, false), derecho = documento.querySelector('.derecho');
  const hace = (que, datos) => { lienzo.pasa(que, datos); gestos.suelta(); return dadas.splice(0); };
  for (const pulsado of [false, true, false]) {
    derecho.setAttribute('aria-pressed', pulsado);
    for (const [button, nombre] of ['IZQUIERDO', 'CENTRAL', 'DERECHO'].entries()) {
      for (menu of [false, true]) {
        const [clientX, clientY] = [30 + azar(240), 20 + azar(180)], suyo = pulsado ? 'DERECHO' : nombre;
        const sitio = `${(clientX - 30) * 2} ${Math.round((clientY - 20) / 2)}`, seAbre = menu && button === 2;
        const en = { button, clientX, clientY };
        assert.deepEqual(hace('pointerdown', en), [seAbre ? `menú ${clientX},${clientY}` : `boton ${suyo} abajo ${sitio}`]);
        assert.deepEqual(hace('pointermove', en), seAbre ? [] : [`arrastra ${sitio}`]);
        assert.deepEqual(hace(elige(['pointerup', 'pointercancel']), en), seAbre ? [] : [`boton ${suyo} arriba ${sitio}`]);
        const deltaY = (azar(2) * 2 - 1) * 100;
        assert.deepEqual(hace('wheel', { ...en, deltaY, deltaMode: 0 }), [`rueda ${deltaY < 0 ? '+1' : '-1'} ${sitio}`]);
      }
    }
  }
  const { setTimeout, clearTimeout } = globalThis;
  globalThis.setTimeout = hace => relojes.push(hace);
  globalThis.clearTimeout = cual => { delete relojes[cual - 1]; };
  const corre = () => relojes.splice(0).forEach(hace => hace?.());
  ponMandos({ derecho: true, mandos: [{ teclas: [['d', 'tecla d'], ['F5', 'especial F5']], hace: '', menu: false }] }, escena);
  const [{ hijos: [d, f5] }, { hijos: [boton] }] = documento.querySelector('.mandos').hijos;
  for (const fin of ['pointerup', 'pointerleave', 'pointercancel', 'quitado', 'pulsado otra vez y pointerup']) {
    d.pasa('pointerdown');
    for (let n = azar(4); n > 0; --n) corre();
    if (/otra/.test(fin)) d.pasa('pointerdown');
    if (fin === 'quitado') d.isConnected = false;
    else d.pasa(fin.split(' ').at(-1));
    dadas.length = 0;
    corre();
    corre();
    assert.deepEqual(dadas, [], fin);
    d.isConnected = true;
  }
  for (const [b, orden] of [[d, 'tecla d'], [f5, 'recarga']]) {
    b.pasa('click');
    assert.deepEqual(dadas.splice(0), [orden]);
  }
  const puesto = [1, 2, 3].map(() => boton.pasa('click') && boton.getAttribute('aria-pressed'));
  assert.deepEqual(puesto, ['true', 'false', 'true']);
  Object.assign(globalThis, { setTimeout, clearTimeout });
}));

test('el menú se cierra al elegir, y proyectando, lo que se pasa se ve y cada tecla del programa es suya', conPagina(({ abreMenu, atiendeProyeccion }) => {
  const menu = documento.querySelector('.opciones'), escena = documento.querySelector('.escena'), hechas = [];
  for (const opciones of [[], ['a'], ['a', 'b/c', 'd']]) {
    for (let i = 0; i < opciones.length; ++i) {
      abreMenu(azar(300), azar(200), opciones, opcion => hechas.push(opcion));
      assert.ok(menu.abierto && document.activeElement === menu.hijos[0]);
      for (let n = 0, en = 0; n < 9; ++n) {
        const key = elige(['ArrowDown', 'ArrowUp', 'x']);
        en += { ArrowDown: 1, ArrowUp: opciones.length - 1, x: 0 }[key];
        menu.pasa('keydown', { key });
        assert.equal(document.activeElement, menu.hijos[en % opciones.length], 'las flechas dan la vuelta');
      }
      menu.hijos[i].pasa('click');
      assert.deepEqual([menu.abierto, hechas.pop()], [false, opciones[i]]);
    }
  }
  let programa, oye;
  globalThis.addEventListener = (_, hace) => { oye = hace; };
  atiendeProyeccion(() => programa, { pasa: n => hechas.push(`pasa ${n}`), salta: n => hechas.push(`salta ${n}`) });
  const PASAN = { PageDown: 'pasa 1', PageUp: 'pasa -1', Home: 'salta 0', End: 'salta -1', ArrowRight: 'pasa 1',
    ArrowLeft: 'pasa -1' };
  for (let vez = 0; vez < 600; ++vez) {
    const suyas = ['b', '.', '?', 'especial DERECHA', 'x'].filter(() => azar(2)), negro = escena.classList.contains('negro');
    programa = azar(9) && { mandos: [{ teclas: suyas.map(t => [t, t]) }] };
    documento.fullscreenElement = azar(9) ? escena : undefined;
    const key = elige([...Object.keys(PASAN), 'b', '.', '?', 'x']), ctrlKey = !azar(9);
    const suceso = Object.assign(new Event('keydown', { cancelable: true }), { key, ctrlKey });
    oye(suceso);
    const deOtro = !programa || !documento.fullscreenElement || ctrlKey || key === 'x' ||
      suyas.includes(/^Arrow/.test(key) ? 'especial DERECHA' : key);
    assert.deepEqual([suceso.defaultPrevented, hechas.splice(0).join(), escena.classList.contains('negro')], deOtro
      ? [false, '', negro] : [true, PASAN[key] ?? '', /^[b.]$/.test(key) ? !negro : false], `${key}, con ${suyas}`);
    if (!documento.fullscreenElement) documento.pasa('fullscreenchange');
    assert.ok(documento.fullscreenElement || !escena.classList.contains('negro'), 'al salir ya no está en negro');
  }
}));
