// partes.mjs RAÍZ BUILD: los módulos de la página de los programas que no tocan el documento (herramientas/web/), y lo
// que le da web.py, con Node y sin navegador.
import { File } from 'node:buffer'; // Node.js 18 no la da sin pedirla
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { haceZip, leeZip } from '../../herramientas/web/carpeta.mjs';
import { leeCambios, leeResueltos, recuerdo, Taller } from '../../herramientas/web/almacen.mjs';
import { bytes, descomprime } from '../../herramientas/web/datos.mjs';
import { cifra } from '../../herramientas/base/cuadro.mjs';
import { Indice, llano, palabras, trozo } from '../../herramientas/base/busca.mjs';
import { casoDe, enEnlace, hazEnlace, leeEnlace, pixelEn, programaDe } from '../../herramientas/web/enlaces.mjs';
import { leeDicho } from '../../herramientas/web/dichos.mjs';
import { delEjercicio, leeError, ordenaFuentes } from '../../herramientas/web/fuentes.mjs';
import { BOTONES, Gestos } from '../../herramientas/web/gestos.mjs';
import { casoInicial, Hecho, leeGuion, LIMITES, Reloj, repite } from '../../herramientas/web/guiones.mjs';
import { compara, esPpm, porciento, ppmDe, quepa, tallaDe, TOLERA } from '../../herramientas/web/imagenes.mjs';
import { conInclusiones, lineasDe } from '../../herramientas/web/lineas.mjs';
import { acorta, aparte, nota } from '../../herramientas/web/nota.mjs';
import { ordenDeTecla } from '../../herramientas/web/teclas.mjs';
import { corta, nombreLlano } from '../../herramientas/web/textos.mjs';
import './cuadro.mjs';
import { CASOS, dePython, lee, PROGRAMAS } from './navegador.mjs';
import { azar } from './sucesos.mjs';

const ordenesDe = guion => leeGuion(guion).ordenes.map(o => o.orden);

/// Lo que da `hace` con los argumentos de cada fila, que es lo que está al final de la fila.
const tabla = (hace, ...filas) => {
  for (const fila of filas) assert.deepEqual(hace(...fila.slice(0, -1)), fila.at(-1), JSON.stringify(fila));
};

test('lo que no se puede guardar se sabe', () => {
  const hay = new Map(), caben = n => ({
    getItem: clave => hay.get(clave) ?? null,
    setItem: (clave, texto) => { if (texto.length > n) throw new Error('QuotaExceededError'); hay.set(clave, texto); },
  });
  globalThis.localStorage = caben(100);
  const taller = new Taller('localStorage', 'k'), otra = new Taller('localStorage', 'k');
  taller.apunta('a.frag', 'uno', 'original');
  otra.relee();
  assert.deepEqual([taller.guardado, otra.cambios.get('a.frag')], [true, 'uno']);
  for (const texto of ['original', 'uno']) { // lo que vuelve a como era no se ha cambiado
    taller.apunta('a.frag', texto, 'original');
    assert.equal(taller.cambios.has('a.frag'), texto === 'uno');
  }
  taller.apunta('a.frag', 'x'.repeat(200), 'original');
  assert.deepEqual([taller.guardado, new Taller('localStorage', 'k').cambios.get('a.frag')], [false, 'uno']);
  delete globalThis.localStorage;
  assert.deepEqual([recuerdo('localStorage', 'k'), recuerdo('localStorage', 'k', 'x')], [null, null]);
});

test('de lo que llega estropeado se dice el nombre', async () => {
  globalThis.document = { createElement: () => ({ append() {} }), head: { append: s => {
    globalThis.llega('wasm', Buffer.from('no es deflate').toString('base64'));
    s.onload();
  } } };
  await assert.rejects(bytes('wasm'), /^Error: datos\/wasm\.js está estropeado$/);
  delete globalThis.document;
});

const DE_WEB = `
import json, sys, tempfile
from pathlib import Path
raiz, build, elegidos = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]
from base import catalogo, indice, libro
from web import pagina as web
with tempfile.TemporaryDirectory() as carpeta:
    pagina = web.Pagina(raiz, build, None, Path(carpeta))
    pagina.empaqueta("a.b", {"ñ": [1]})
    paquete = (pagina.nuevos / "a.b.js").read_text()
programas = [p for p in catalogo.lee_programas(build) if p.nombre in elegidos]
vivos = {p.nombre: web.ProgramaVivo(raiz, build, p).datos() for p in programas}
print(json.dumps([paquete, vivos, indice.hace(raiz, catalogo.lee(build), libro.Libro(raiz))]))`;
const RASGOS = {
  info_opengl: 'consola', grua: 'raton mandos texturas', menu: 'raton mandos texturas',
  eventos: 'raton sigue mandos texturas', sombras: 'derecho raton mandos texturas',
  luces_animadas: 'anima raton mandos texturas', convolucion: 'mandos texturas admite',
};

const ELEGIDOS = [...Object.keys(RASGOS), 'bezier'];
const [paquete, datos, indice] = dePython(DE_WEB, ...ELEGIDOS);

test('lo que da web.py', async () => {
  const llegado = [];
  new Function('llega', paquete)((...todo) => llegado.push(...todo));
  assert.equal(llegado[0], 'a.b');
  assert.equal(new TextDecoder().decode(await descomprime(llegado[1])), '{"ñ": [1]}');
  const posibles = ['consola', 'derecho', 'anima', 'raton', 'sigue', 'mandos', 'texturas', 'admite'];
  for (const [nombre, suyos] of Object.entries(RASGOS)) {
    const tiene = posibles.filter(r => datos[nombre][r] !== false && datos[nombre][r].length !== 0);
    assert.equal(tiene.join(' '), suyos, nombre);
  }
  assert.deepEqual(datos.bezier.mandos[0].teclas, [['n', 'tecla n'], ['←', 'especial IZQUIERDA'],
    ['→', 'especial DERECHA'], ['↑', 'especial ARRIBA'], ['↓', 'especial ABAJO']]);
  assert.deepEqual(datos.convolucion.texturas, ['foto.rgb', 'letra.r8']);
  for (const { programa, titulo, fichero, guion, mira } of CASOS.filter(c => datos[c.programa]))
    assert.deepEqual(datos[programa].casos.find(c => c.fichero === fichero),
      { titulo: titulo || 'Al empezar', fichero, guion, mira });
  assert.equal(casoInicial(datos.grua).titulo, 'En reposo');
  tabla((anima, ...guiones) => casoInicial({ anima, casos: guiones.map(guion => ({ guion })) }).guion,
    [true, 'espera 9', ''], [false, 'tecla 1', 'tecla 2', 'tecla 1']);
});

test('cada dirección es de su programa, y cada imagen, de su caso', () => {
  const suyos = [{ nombre: 'sin_libro', referencia: '', casos: [] }, ...PROGRAMAS.map(({ nombre, ref }) =>
    ({ nombre, referencia: ref, casos: CASOS.filter(c => c.programa === nombre) }))];
  const lleva = (escrito, programa) => {
    for (const forma of [escrito, escrito.toUpperCase(), escrito.toLowerCase()])
      assert.equal(programaDe(forma, suyos), programa, forma);
  };
  for (const programa of suyos) {
    lleva(programa.nombre, programa);
    for (const codigo of programa.referencia.split(' ').filter(Boolean))
      lleva(codigo, suyos.find(p => p.referencia.split(' ').includes(codigo)));
    for (const caso of programa.casos) {
      lleva(caso.fichero, programa);
      for (const escrito of [caso.fichero, caso.fichero.toUpperCase()]) assert.equal(casoDe(escrito, programa), caso);
    }
    assert.equal(casoDe(programa.nombre + '-nada', programa), undefined);
  }
  tabla(buscado => programaDe(buscado, suyos)?.nombre, ['', undefined], ['3.5', undefined], ['grua-nada', undefined]);
});

const buscador = new Indice(indice), primeros = buscado => buscador.busca(buscado).slice(0, 3).map(h => h.enlace);

test('lo que buscaría un estudiante', () => {
  const filas = lee('tests/paginas/busquedas.tsv').split('\n').filter(f => f && f[0] !== '#');
  assert.ok(filas.length >= 20);
  for (const [buscado, ...salen] of filas.map(f => f.split('\t'))) {
    const hay = buscador.busca(buscado).slice(0, 6).map(h => h.enlace);
    assert.equal(hay[0], salen[0], buscado);
    assert.deepEqual(salen.filter(enlace => !hay.includes(enlace)), [], buscado);
    const sinAcentos = buscado.normalize('NFD').replace(/\p{M}/gu, '');
    for (const otro of [buscado.toUpperCase(), ` ${buscado} `, sinAcentos])
      assert.deepEqual(primeros(otro), hay.slice(0, 3), otro);
  }
});

test('todo se encuentra: cada nombre, título, referencia, pie, tecla e identificador, y se dice dónde', () => {
  const masLarga = titulo => palabras(titulo).sort((a, b) => b.length - a.length)[0];
  const CLASES = { L: 'listado', E: 'ejercicio', F: 'figura', T: 'tabla', Ec: 'ecuación', '§': 'apartado' };
  for (const { titulo, zonas, fuentes } of indice.entradas) {
    const lo = buscado => buscador.busca(buscado).find(h => h.titulo === titulo);
    assert.equal(buscador.busca(titulo)[0].titulo, titulo);
    const casi = buscador.busca(`${titulo} xyzzy${palabras(titulo).length > 4 ? ' plugh' : ''}`);
    assert.ok(casi.length && casi.every(h => h.leFalta), `${titulo}, con otras palabras que no están`);
    const larga = masLarga(titulo), i = 1 + azar(3);
    const [antes, letra, otra, resto] = [larga.slice(0, i), larga[i], larga[i + 1] ?? '', larga.slice(i + 2)];
    for (const mal of [antes + otra + resto, antes + letra + letra + otra + resto, `${antes}x${otra}${resto}`,
      antes + otra + letra + resto]) // una letra de menos, de más o cambiada, o dos vecinas al revés
      assert.ok(larga.length < 6 || lo(mal), `«${mal}», de ${titulo}`);
    const dos = [larga, masLarga(indice.entradas[azar(indice.entradas.length)].titulo)];
    const [unos, otros] = dos.map(palabra => buscador.busca(palabra).map(h => h.titulo));
    const los = buscador.busca(dos.join(' ')), tiene = h => unos.includes(h.titulo) && otros.includes(h.titulo);
    assert.ok(new Set(los.flatMap(h => [!h.leFalta, tiene(h)])).size === 1, `${dos}: lo que tiene las dos, si lo hay`);
    for (const [clase, enlace, texto] of zonas) {
      assert.doesNotMatch(texto, /&#?\w+;|<\/?\w+[^<]*>/, `${titulo}: el texto, sin HTML`);
      const hallado = lo(clase === 'imagen' ? texto : palabras(texto).slice(0, 3).join(' '));
      assert.ok(hallado, texto);
      if (clase === 'imagen') assert.deepEqual([hallado.clase, hallado.enlace, hallado.texto], [clase, enlace, texto]);
      if (clase !== 'libro') continue;
      const [, letra, numero] = enlace.match(/^(\D+)(.*)$/);
      const larga = CLASES[letra], escritos = [`${larga} ${numero}`, `${larga.slice(0, 3)}. ${numero}`];
      for (const buscado of [enlace, enlace.toLowerCase(), ...escritos])
        assert.equal(lo(buscado)?.enlace, enlace, buscado);
    }
    for (const ruta of fuentes) {
      const codigo = lee(ruta).replace(/"[^"\n]*"|\/\/.*|\/\*[^]*?\*\//g, ' ');
      const suyos = codigo.match(/\b[A-Za-z_]\w{2,}/g), identificador = suyos[azar(suyos.length)];
      assert.ok(lo(identificador), `${identificador} de ${ruta}`);
    }
  }
  const [mejor] = buscador.busca('glStencilFunc');
  assert.deepEqual([mejor.clase, mejor.palabra], ['fuente', 'glStencilFunc']);
  tabla(primeros, ['', []], ['   ', []], ['?¿', []], ['xyzzy', []], ['xyzzy plugh', []]);
});

test('cómo se lee lo que se busca, y qué trozo se enseña', () => {
  tabla(texto => palabras(texto).join(' '),
    ['Listado 5.1, «Ñandú».', 'l5.1 nandu'], ['FIG. 3.3 y ejercicio 11.5', 'f3.3 y e11.5'], ['3×3', '3x3'],
    ['§3.2 ecuación 4.1', '§3.2 ec4.1'], ['Capítulo 5. Tema 5', 'cap5 cap5'], ['enlistado 5', 'enlistado 5'],
    ['Z-Buffer GL_CLAMP', 'z buffer gl_clamp']);
  assert.equal(llano('Inclinación'), 'inclinacion');
  const largo = 'a'.repeat(200) + ' cámara ' + 'b'.repeat(200);
  for (const texto of [largo, 'Listado 5.1: la cámara', 'cámara ' + largo, 'nada', '']) {
    for (const buscado of ['CAMARA', 'Cámara', 'otra camara', 'x']) {
      const [antes, hallado, despues] = trozo(texto, buscado), todo = (antes + hallado + despues).replaceAll('…', '');
      assert.ok(texto.includes(todo) && todo.length <= 100, todo);
      assert.deepEqual([antes, despues].map(t => t.includes('…')), [!texto.startsWith(todo), !texto.endsWith(todo)]);
      assert.equal(hallado, /cámara/.test(texto) && buscado !== 'x' ? 'cámara' : '');
    }
  }
});

test('los enlaces: van y vuelven, y de los malos no se queja la página', () => {
  tabla(hash => Object.values(leeEnlace(hash)),
    ['', [false, '', undefined]], ['#grua', [false, 'grua', undefined]], ['#grua;', [false, 'grua', '']],
    ['#grua;a;b', [false, 'grua', 'a;b']], ['#E3.5%3Btecla%20d', [false, 'E3.5', 'tecla d']],
    ['#%', [false, '%', undefined]], ['#%E0%A4%A', [false, '%E0%A4%A', undefined]],
    ['#grua;tecla %;%C3%B1', [false, 'grua', 'tecla %;ñ']], ['#grua;a%0Ab', [false, 'grua', 'a\nb']],
    ['#ejercicio/L5.1;tecla v', [true, 'L5.1', 'tecla v']], ['#ejercicio%2FL5.1', [true, 'L5.1', undefined]],
    ['#ejercicio', [false, 'ejercicio', undefined]],
    ['#espejo/explica/240,140', [false, 'espejo', undefined, [240, 140]]],
    ['#espejo/explica/240.5,0;tecla p', [false, 'espejo', 'tecla p', [240.5, 0]]],
    ['#ejercicio/L5.1/explica/1,2', [true, 'L5.1', undefined, [1, 2]]],
    ['#espejo/explica/240', [false, 'espejo/explica/240', undefined]],
    ['#espejo/explica/-1,2', [false, 'espejo/explica/-1,2', undefined]],
    ['#incrusta/grua', [false, 'grua', undefined, true]],
    ['#incrusta/grua;tecla d ×2', [false, 'grua', 'tecla d ×2', true]],
    ['#incrusta/grua?tecla=d&rueda=+1 3 4', [false, 'grua', 'tecla d;rueda +1 3 4', true]]);
  tabla(pixelEn, [[240, 140], { width: 960, height: 720 }, [240, 140]], [[0, 0], { width: 1920, height: 1440 }, [1, 1]],
    [[959, 719], { width: 240, height: 180 }, [239, 179]],
    [[0, 0], { width: 100, height: 300 }, [0, 112]], [[960, 0], { width: 960, height: 720 }, undefined]);
  for (const lienzo of [{ width: 960, height: 720 }, { width: 700, height: 525 }, { width: 240, height: 180 },
    { width: 2100, height: 1575 }]) {
    for (let vez = 0; vez < 50; ++vez) { // el píxel de un enlace es el que se copió
      const pixel = [azar(lienzo.width), azar(lienzo.height)];
      const copiado = leeEnlace(`#grua${enEnlace(pixel, lienzo)}`).pixel;
      assert.deepEqual(pixelEn(copiado, lienzo), pixel);
    }
  }
  const posibles = 'tecla %;tecla #;tecla +;tecla &;menu Vista/Perfil ñ;rueda +1 3 4;tecla d;menu A ×2 ×1'.split(';');
  for (let vez = 0; vez < 200; ++vez) {
    const ordenes = Array.from({ length: azar(9) }, () => posibles[azar(azar(2) ? 2 : posibles.length)]);
    const { hash } = new URL(hazEnlace('grua', ordenes), 'file:///a');
    assert.deepEqual(ordenesDe(leeEnlace(hash).guion ?? ''), ordenes);
    const llanas = ordenes.filter(o => !/[%#&+]/.test(o)); // como en cualquier dirección: tecla=d&tecla=w
    const escritas = llanas.map(o => o.replace(' ', '=')).join('&');
    assert.deepEqual(ordenesDe(leeEnlace(`#incrusta/grua?${escritas}`).guion), llanas);
  }
  assert.equal(decodeURI(hazEnlace('grua', Array(7).fill('tecla d'))), '#grua;tecla d ×7');
  assert.equal(hazEnlace('grua', ['tecla #']).lastIndexOf('#'), 0);
});

test('un guion se parte en órdenes que duran poco, con límites', () => {
  const conEscala = leeGuion(' tecla  d ×2;;escala 4 3\nmueve 1 2; escala 8 6 ;tecla ;').ordenes;
  assert.deepEqual(conEscala.map(o => [o.orden, o.escala]),
    [['tecla d', ''], ['tecla d', ''], ['mueve 1 2', 'escala 4 3'], ['tecla', 'escala 8 6']]);
  tabla(ordenesDe,
    ['tecla ×2;tecla a ×0;tecla a ×x', ['tecla', 'tecla', 'tecla a ×0', 'tecla a ×x']],
    ['menu A ×2 ×2', ['menu A ×2 ×1', 'menu A ×2 ×1']],
    ['captura /lab/a.frag;tamano 9 9;captura a ×2;tecla b; captura a', ['tecla b']],
    ['espera 250;espera 0;espera -1', ['espera 100', 'espera 100', 'espera 50', 'espera 0', 'espera -1']]);
  const total = guion => ordenesDe(guion).reduce((suma, o) => suma + +o.split(' ')[1], 0);
  tabla(total, ['espera 1000000000', 10000], ['espera 9000 ×9', LIMITES.ms]);
  assert.ok(leeGuion('espera 10001').recortado && leeGuion('espera 9000 ×9').recortado);
  const muchas = ['tecla d;'.repeat(10001), 'tecla d ×9999;'.repeat(1e5)];
  const largos = ['tecla d ×10000;tecla d', 'espera 0 ×10000;espera 0', ...muchas];
  for (const { ordenes, recortado } of largos.map(leeGuion)) assert.ok(recortado && ordenes.length === LIMITES.ordenes);
  assert.ok(ordenesDe('a'.repeat(1e6))[0].length <= LIMITES.letras + 1);
  for (const { guion, fichero } of CASOS) {
    const suyas = guion.split(';').filter(o => o.trim() && !/escala|espera/.test(o));
    const veces = suyas.reduce((n, o) => n + +(o.match(/×(\d+)/)?.[1] ?? 1), 0);
    assert.equal(leeGuion(guion).recortado, false, fichero);
    assert.equal(ordenesDe(guion).filter(o => !/^espera/.test(o)).length, veces, fichero);
  }
});

test('un guion largo deja respirar a la página, y se puede dejar a medias', async () => {
  let reloj = 0, respiros = 0;
  const dadas = [], opciones = { tanda: 50, ahora: () => reloj };
  const respira = async () => { ++respiros; };
  await repite([...Array(100).keys()], n => { reloj += 10; dadas.push(n); return true; }, respira, opciones);
  assert.deepEqual([respiros, dadas.length, dadas[99]], [20, 100, 99]);
  await repite([1, 2, 3], n => { dadas.push(-n); return n < 2; }, respira, opciones);
  assert.deepEqual(dadas.slice(100), [-1, -2]);
});

test('el reloj no pierde ni gana tiempo, salvo el de una pausa', () => {
  const reloj = new Reloj(1000);
  let suma = 0;
  for (let ms = 1000; ms <= 3000; ms += 16.7) suma += reloj.pasa(ms);
  assert.ok(Math.abs(suma - 2000) < 18);
  for (const ms of [9e9, 9e9 - 5].map(ahora => reloj.pasa(ahora))) assert.ok(ms >= 0 && ms <= 100);
});

test('lo hecho, para el enlace', () => {
  const hecho = new Hecho(true);
  const da = (escala, ...ordenes) => ordenes.forEach(orden => hecho.apunta(orden, escala));
  da('escala 8 6', 'tecla a', 'tamano 9 9', 'especial F5', 'boton IZQUIERDO abajo 1 1', 'arrastra 2 2', 'arrastra 3 3',
    'espera 16', 'espera 17', 'rueda +1 3 3', 'rueda +1 3 3');
  da('escala 4 3', 'tecla a', 'mueve 1 1');
  da('escala 8 6', 'espera 9990', 'espera 16');
  assert.deepEqual(hecho.ordenes, ['tecla a', 'escala 8 6', 'boton IZQUIERDO abajo 1 1', 'arrastra 3 3', 'espera 33',
    'rueda +1 3 3', 'rueda +1 3 3', 'tecla a', 'escala 4 3', 'mueve 1 1', 'espera 10000']);
  const quieto = new Hecho(false);
  quieto.apunta('espera 16', 'escala 8 6');
  assert.deepEqual(quieto.ordenes, []);
});

test('cada tecla da una orden que el guion entiende', () => {
  const guion = lee('glut/sin_ventana/guion.cpp');
  const entiende = nombre => {
    const [, cuerpo] = guion.match(new RegExp(`${nombre} = \\{(.*?)\\};`, 's'));
    return [...cuerpo.matchAll(/\{"(.*?)"/g)].map(m => m[1]);
  };
  const claves = ['Escape', 'Enter', 'Backspace', 'Delete', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home',
    'End', 'PageUp', 'PageDown', 'Insert'];
  for (let i = 1; i <= 24; ++i) claves.push(`F${i}`);
  for (let letra = 32; letra < 127; ++letra) claves.push(String.fromCharCode(letra));
  const ordenDe = (key, ...con) =>
    ordenDeTecla({ key, [con]: true, getModifierState: cual => con.includes(cual) }); // CapsLock solo está ahí
  const dadas = claves.map(key => ordenDe(key)).filter(Boolean);
  assert.equal(new Set(dadas).size, 4 + 9 + 11 + 95);
  for (const orden of dadas) {
    const [que, tecla, ...nada] = orden.split(' ');
    const letra = que === 'tecla' && tecla.length === 1 && tecla !== ';';
    assert.ok(!nada.length && (letra || entiende(que === 'tecla' ? 'TECLAS' : 'ESPECIALES').includes(tecla)), orden);
  }
  tabla(ordenDe,
    ['Escape', '', 'tecla Esc'], ['ArrowUp', '', 'especial ARRIBA'], ['Delete', '', 'tecla Supr'],
    ['PageDown', '', 'especial AVPAG'], ['a', '', 'tecla a'], ['F5', '', 'especial F5'], ['@', 'altKey', 'tecla @'],
    ['Tab', '', ''], ['F12', '', ''], ['ñ', '', ''],
    ['r', 'ctrlKey', ''], ['r', 'metaKey', ''], ['ArrowLeft', 'altKey', ''],
    ['D', 'CapsLock', 'tecla d'], ['d', 'CapsLock', 'tecla D'], ['1', 'CapsLock', 'tecla 1']);
  assert.deepEqual(BOTONES.filter(b => !entiende('BOTONES').includes(b)), []);
});

function gestosCon(sigue) {
  const dadas = [], cuadro = [], g = { dadas, vivo: true };
  g.gestos = new Gestos({ da: orden => g.vivo && dadas.push(orden) > 0, luego: f => cuadro.push(f), sigue });
  g.haz = (que, x, y, ...resto) => {
    if (que === 'cuadro') cuadro.splice(0).forEach(f => f());
    else g.gestos[que]({ id: g.dedo, x, y }, ...resto);
  };
  return g;
}

/// Lo que se hace, en una línea: el dedo con que se sigue o un gesto con sus números y el botón.
function ordenesDeGestos(sigue, gestos) {
  const g = gestosCon(sigue);
  for (const gesto of gestos.split('; ')) {
    const [que, ...resto] = gesto.split(' ').map(t => Number.isNaN(+t) ? t : +t);
    if (que === 'dedo') [g.dedo] = resto;
    else g.haz(que, ...resto);
  }
  return g.dadas.join('; ');
}

test('ratón, dedos y rueda', () => {
  tabla(ordenesDeGestos,
    [false, 'baja 1.4 2.6 DERECHO; mueve 5 5; mueve 6 7; cuadro; mueve 8 8; sube 9 9; mueve 1 1; cuadro',
      'boton DERECHO abajo 1 3; arrastra 6 7; arrastra 8 8; boton DERECHO arriba 9 9'],
    [true, 'gira 3 4 30 0; gira 3 4 -9 0; gira 3 4 8 0; gira 3 4 91 0; gira 3 4 -2 1; gira 3 4 1 2; mueve 1 2; cuadro',
      'rueda -1 3 4; rueda +1 3 4; rueda -1 3 4; mueve 1 2'],
    [false, 'baja 0 0 IZQUIERDO; dedo 2; baja 100 0 IZQUIERDO; mueve 111 0; mueve 113 0; mueve 90 0; sube 90 0; ' +
      'dedo 1; mueve 50 50; cuadro',
      'boton IZQUIERDO abajo 0 0; boton IZQUIERDO arriba 0 0; rueda +1 113 0; rueda -1 90 0']);
});

/// Solo se suelta un botón pulsado y se pulsa uno que no lo está; con alguno se arrastra, y sin ninguno se mueve.
function sonPosibles(dadas) {
  const abajo = new Set();
  for (const orden of dadas) {
    const [que, boton, sentido] = orden.split(' ');
    assert.doesNotMatch(orden, /undefined|NaN/);
    if (que === 'rueda') continue;
    if (que === 'boton' && sentido === 'arriba') assert.ok(abajo.delete(boton), dadas.join(';'));
    else if (que === 'boton') assert.ok(!abajo.has(boton) && abajo.add(boton), dadas.join(';'));
    else assert.equal(que, abajo.size ? 'arrastra' : 'mueve', dadas.join(';'));
  }
}

test('haga lo que haga, y arranque el programa cuando sea, no se le da nada imposible', () => {
  for (let vez = 0; vez < 300; ++vez) {
    const g = gestosCon(azar(2) === 1), arranca = azar(8);
    for (let paso = 0; paso < 40; ++paso) {
      g.vivo = paso >= arranca;
      g.dedo = azar(3);
      const que = ['baja', 'mueve', 'sube', 'gira', 'cuadro'][azar(5)];
      g.haz(que, azar(200), azar(200), ...que === 'gira' ? [azar(300) - 150, azar(3)] : [BOTONES[azar(4)]]);
    }
    sonPosibles(g.dadas);
  }
});

test('dos imágenes: qué parte coincide, y dónde no', () => {
  const rgba = (...colores) => Uint8ClampedArray.from(colores.flatMap(color => [...color, 255]));
  const objetivo = rgba([0, 0, 0], [9, 9, 9], [200, 200, 200], [200, 200, 200]);
  const lograda = rgba([0, 0, 0], [9, 9 + TOLERA, 9], [200, 200, 200 - TOLERA - 1], [0, 200, 200]);
  const diferencia = new Uint8ClampedArray(16);
  tabla(compara,
    [lograda, objetivo, diferencia, 0.5], [lograda, objetivo, 0.5], [objetivo, lograda, 0.5], [objetivo, objetivo, 1]);
  const [a, b, c, d] = [0, 4, 8, 12].map(i => diferencia.subarray(i, i + 4));
  for (const [rojo, verde, azul, opaco] of [a, b]) assert.ok(rojo === verde && verde === azul && opaco === 255, 'gris');
  for (const [rojo, verde, , opaco] of [c, d]) assert.ok(rojo > verde + 60 && opaco === 255, 'rojo');
  assert.ok(d[1] < c[1], 'más rojo lo que más se aparta');
  tabla(porciento, [1, '100\u00a0%'], [0.99999, '99.9\u00a0%'], [0.9, '90\u00a0%'], [0, '0\u00a0%']);
});

test('los ejercicios: lo guardado y sus ficheros, y todos, en su orden', () => {
  tabla(texto => [...leeResueltos(texto)].join(' '),
    ['L5.1 L12.1 mi_ejercicio', 'L5.1 L12.1 mi_ejercicio'], ['', ''], [null, ''], ['{"a": 1} L5 <b> L5.1', 'L5.1']);
  tabla((suyos, rutas) => delEjercicio(suyos, rutas.split(' ')).join(' '),
    [['c/a.vert'], 'c/b.frag c/a.frag c/a.vert c/p.glsl c/a.cpp c/a.h', 'c/a.vert c/a.frag c/p.glsl']);
  tabla((rutas, capitulo) => ordenaFuentes(rutas.split(' '), capitulo).join(' '),
    ['c/b.h d/a.frag c/c.glsl c/b.cpp c/b.h c/a.vert', 'c', 'c/a.vert c/c.glsl c/b.cpp c/b.h d/a.frag']);
});

test('la carpeta, en un .zip que se lee con cualquiera', async () => {
  const textos = { 'grua/grua.cpp': 'int main() {}\n', 'grua/año.h': '// ñ\n', 'grua/ejercicio.txt': 'E3.5 c/grua\n' };
  const zip = haceZip(textos), base64 = Buffer.from(await zip.arrayBuffer()).toString('base64');
  const deflate = process.version.startsWith('v18') ? 0 : 8; // el de Node 18 no se lee aquí; en los navegadores, sí
  const [malo, leidos, deOtro] = dePython(`import base64, io, json, sys, zipfile
z, otro = zipfile.ZipFile(io.BytesIO(base64.b64decode(sys.argv[3]))), io.BytesIO()
leidos = {n: z.read(n).decode() for n in z.namelist()}
with zipfile.ZipFile(otro, "w") as c:  # con campos y notas de más, como los de macOS y los de zip -r
    c.comment = b"de otro"
    for nombre, texto in leidos.items():
        suyo = zipfile.ZipInfo(nombre)
        suyo.extra, suyo.comment = b"UT" + bytes([5, 0, 1, 65, 66, 67, 68]), b"nota"
        c.writestr(suyo, texto, int(sys.argv[4]))
print(json.dumps([z.testzip(), leidos, base64.b64encode(otro.getvalue()).decode()]))`, base64, deflate);
  assert.deepEqual([malo, leidos], [null, textos]);
  for (const datos of [zip, Buffer.from(deOtro, 'base64')]) {
    const hay = await leeZip(new File([datos], 'grua.zip'));
    for (const [ruta, texto] of Object.entries(textos)) assert.equal(await hay[ruta].text(), texto);
  }
  await assert.rejects(leeZip(new File(['no'], 'no.zip')), /está estropeado, o no es un .zip/);
});

test('lo que vale una entrega, como lo dice ./lab corrige', () => {
  const casos = dePython(`import json, random
from dataclasses import asdict
from types import SimpleNamespace
from ejercicios.corrige import arbitro, veredicto
from ejercicios.corrige.partidas import Guion
from ejercicios.reglas import Reglas
azar, casos = random.Random(1), []
for _ in range(2000):
    cuesta = lambda: azar.choice([0, 0.04, 12.5, 20])
    casi, medias = azar.choice([0, 30, 50, 100]), azar.choice([0, 50, 70, 100])
    reglas = Reglas(azar.choice([1, 2, 3.5]), azar.choice([0.5, 1]), 24, "amplia", casi, medias,
                    cuesta(), cuesta(), cuesta())
    todos = [Guion(str(i), (), azar.random() < 0.3) for i in range(azar.randint(1, 12))]
    son = {g: azar.choice([1, 1, 1, 0.5, 0, "a medias"]) for g in todos}
    valen = {1: 1, 0.5: casi / 100, 0: 0, "a medias": medias / 100}
    partida = lambda: SimpleNamespace(titulos=azar.choices("ab", k=azar.randint(0, 2)), estado=azar.choice([0, 0, 3]),
                                      texto="\\n".join(azar.choices(["a", "b", "ab", ""], k=azar.randint(0, 3))))
    debe, es = partida(), partida()
    otros = arbitro.aparte(debe, es)
    salen = [{"pesa": reglas.peso(g), "parecido": 0, "aMedias": True} if son[g] == "a medias" else
             {"pesa": reglas.peso(g), "parecido": son[g], "aMedias": False} for g in todos]
    casos.append([salen, vars(debe), vars(es), asdict(reglas),
                  [*otros.values()], veredicto.nota(todos, {g: valen[son[g]] for g in todos}, otros, reglas)])
print(json.dumps(casos))`);
  const enLineas = p => ({ ...p, texto: p.texto.split('\n') });
  for (const [guiones, debe, es, reglas, otros, suya] of casos) {
    const hay = aparte(enLineas(debe), enLineas(es));
    assert.deepEqual([Object.values(hay), nota(guiones, hay, reglas)], [otros, suya]);
  }
});

test('un guion se acorta hasta lo que basta', async () => {
  const basta = (...hacen) => ordenes => hacen.every(h => ordenes.some(o => o.split(' ×')[0] === h));
  for (const [ordenes, hacen, quedan] of [['a b c d e', 'e', 'e'], ['a b c d e f g', 'b f', 'b f'],
    ['a ×30 b ×5 c', 'a c', 'a c'], ['a', 'a', 'a']])
    assert.deepEqual(await acorta(ordenes.replaceAll(' ×', '_').split(' ').map(o => o.replace('_', ' ×')),
      basta(...hacen.split(' ')), 40), quedan.split(' '));
});

test('los errores de los shaders, y de cada cosa que dice clang, si es un error', () => {
  tabla(clase => leeDicho(`/lab/a.cpp:1:2: ${clase}: x`, {}).map(d => d.clase).join(),
    ['error', 'error'], ['fatal error', 'error'], ['warning', 'aviso'], ['note', '']);
  tabla(linea => leeError(linea, 'ch03_a'),
    ["lab: ch05_a/phong.glsl:47: 'P4' : undeclared identifier — «N = unitario(P4);»",
      { ruta: 'ch05_a/phong.glsl', linea: 47, mensaje: "«P4» no está declarado ('P4' : undeclared identifier)" }],
    ["objeto.frag no compila: ERROR: 0:3: 'x' : no", { ruta: 'ch03_a/objeto.frag', linea: 3, mensaje: "'x' : no" }],
    ["a.frag:3: '-' : types 'const int' and 'in highp float' — «1 - a»", { ruta: 'ch03_a/a.frag', linea: 3,
      mensaje: "un int no vale como float: un real lleva punto, 1.0 y no 1 " +
        "('-' : types 'const int' and 'in highp float')" }],
    ["a.frag:3: '/' : types 'highp float' and '2-component vector of int' — «e / t»", {
      ruta: 'ch03_a/a.frag', linea: 3, mensaje: 'uno es de enteros: vec2(…) lo hace de reales ' +
        "('/' : types 'highp float' and '2-component vector of int')" }],
    ['a.vert y a.frag no enlazan: eso', { ruta: '', linea: 0, mensaje: 'a.vert y a.frag no enlazan: eso' }],
    ['giro 12', undefined]);
  const desde = performance.now();
  for (const larga of ['a'.repeat(1e5), 'a.frag:1: ' + ' — «'.repeat(3e4)]) leeError(larga, '');
  assert.ok(performance.now() - desde < 5000);
});

test('tallas, imágenes, lo guardado y un número, como se lee', () => {
  tabla((width, height, densidad) => Object.values(tallaDe({ width, height }, densidad)),
    [240, 180, 1, [240, 180]], [240.4, 180, 1.5, [361, 270]], [240, 180, 3, [480, 360]], [0, 0, undefined, [1, 1]],
    [9000, 6750, 1, [4096, 3072]], [5000, 1, 2, [4096, 1]]);
  tabla((width, height) => Object.values(quepa({ width, height })),
    [100, 50, [100, 50]], [4096, 1024, [2048, 512]], [1, 9000, [1, 2048]]);
  const ppm = ppmDe(Uint8Array.of(1, 2, 3, 255, 4, 5, 6, 0), 1, 2);
  assert.equal(String.fromCharCode(...ppm), 'P6\n1 2\n255\n\x01\x02\x03\x04\x05\x06');
  assert.ok(esPpm(ppm) && !esPpm(Uint8Array.of(0x50, 0x35)));
  assert.equal(nombreLlano('../año 1.vf'), '.._a_o_1.vf');
  tabla(corta, ['abc', 3, 'abc'], ['abcd', 3, 'abc…'], ['', 0, '']);
  assert.deepEqual(leeCambios('[["a.frag","x"]]'), [['a.frag', 'x']]);
  tabla(leeCambios, ...[null, '', '{', '{}', '[1]', '[["a"]]', '[["a", 1]]', 'null'].map(malo => [malo, []]));
  tabla(n => cifra(n), [0.123456, '0.1235'], [-2, '−2'], [NaN, 'NaN'], [-Infinity, '−∞'], ['-nan', 'NaN'], ['inf', '∞'],
    [1e-7, '1e−7']);
});

test('cada línea de un shader, en su fichero', () => {
  const textos = { 'a.frag': '#version 140\n#include "b.glsl"\nmain\n',
    'b.glsl': '\ufeff/*\n#include "c.glsl"\n*/uno\n#include "c.glsl"\n', 'c.glsl': 'dos\n#include "a.frag"' };
  assert.deepEqual(conInclusiones('a.frag', textos).map(l => `${l.fichero}:${l.linea} ${l.texto}`),
    ['a.frag:1 #version 140', 'b.glsl:1 /*', 'b.glsl:2 #include "c.glsl"', 'b.glsl:3 */uno', 'c.glsl:1 dos',
      'c.glsl:2 #include "a.frag"', 'a.frag:3 main']);
  const es = '#version 300 es\nprecision highp float;\n#line 2\n' +
    '/*\n#include "c.glsl"\n*/uno\ndos\n#include "a.frag"\nmain\n';
  tabla((texto, i) => { const l = lineasDe(texto, textos, 'frag')[i]; return `${l.fichero}:${l.linea}`; },
    [es, 5, 'c.glsl:2'], [es, 6, 'a.frag:3'], [es + 'otro\n', 4, ':5']);
});
