// partes.mjs RAÍZ BUILD: las partes de la página de los programas que no tocan el documento (web_partes.js), y lo que le da web.py,
// con Node y sin navegador.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { runInThisContext } from 'node:vm';

const [raiz, build] = process.argv.slice(2);
const lee = ruta => readFileSync(`${raiz}/${ruta}`, 'utf8');
runInThisContext(lee('herramientas/web/web_partes.js')); // como en la página, lo suyo queda a la vista
const { casos, programas } = JSON.parse(readFileSync(`${build}/catalogo.json`));
const ordenesDe = guion => leeGuion(guion).ordenes.map(o => o.orden);

let semilla = 1;
const azar = n => { // siempre los mismos
  semilla = (semilla * 48271) % 2147483647;
  return semilla % n;
};

test('lo que falla se olvida, y lo demás se hace una vez', async () => {
  let veces = 0;
  const trae = recuerda(async cual => { if (++veces === 1) throw new Error('sin red'); return cual + veces; });
  await assert.rejects(trae('a'), /sin red/);
  assert.deepEqual([await trae('a'), await trae('a'), await trae('b')], ['a2', 'a2', 'b3']);
});

test('lo que da web.py', async () => {
  const dado = JSON.parse(execFileSync('python3', ['-B', '-c', `
import json, sys, tempfile
from pathlib import Path
raiz, build = map(Path, sys.argv[1:])
sys.path.insert(0, str(raiz / "herramientas"))
from base import catalogo
from web import pagina as web
with tempfile.TemporaryDirectory() as carpeta:
    pagina = web.Pagina(raiz, build, None, Path(carpeta))
    pagina.empaqueta("a.b", {"ñ": [1]})
    paquete = (pagina.nuevos / "a.b.js").read_text()
elegidos = "info_opengl grua eventos sombras menu luces_animadas convolucion bezier"
print(json.dumps([paquete, {p.nombre: web.Programa(raiz, build, p).datos() for p in catalogo.lee_programas(build) if p.nombre in elegidos.split()}]))`,
  raiz, build]));
  const [paquete, datos] = dado, llegado = [];
  new Function('llega', paquete)((...todo) => llegado.push(...todo));
  assert.equal(llegado[0], 'a.b');
  assert.equal(new TextDecoder().decode(await descomprime(llegado[1])), '{"ñ": [1]}');
  const rasgos = ['consola', 'derecho', 'anima', 'raton', 'sigue', 'mandos', 'texturas', 'admite'];
  for (const [nombre, suyos] of Object.entries({ info_opengl: 'consola', grua: 'raton mandos texturas', eventos: 'raton sigue mandos texturas',
    sombras: 'derecho raton mandos texturas', menu: 'raton mandos texturas', luces_animadas: 'anima raton mandos texturas', convolucion: 'mandos texturas admite' }))
    assert.equal(rasgos.filter(r => datos[nombre][r] !== false && datos[nombre][r].length !== 0).join(' '), suyos, nombre);
  assert.deepEqual(datos.bezier.mandos[0].teclas, [['n', 'tecla n'], ['←', 'especial IZQUIERDA'], ['→', 'especial DERECHA'],
    ['↑', 'especial ARRIBA'], ['↓', 'especial ABAJO']]);
  assert.deepEqual(datos.convolucion.texturas, ['foto.rgb', 'letra.r8']);
  assert.deepEqual(datos.grua.casos[1], { titulo: 'girada', guion: 'tecla d ×7', mira: casos.find(c => c.fichero === 'grua-girada').mira });
  assert.equal(casoInicial(datos.grua).titulo, 'reposo');
  assert.equal(casoInicial({ anima: true, casos: [{ guion: 'espera 9' }] }).guion, '');
  assert.equal(casoInicial({ anima: false, casos: [{ guion: 'tecla 1' }, { guion: 'tecla 2' }] }).guion, 'tecla 1');
});

test('un programa, por su nombre o su referencia', () => {
  const suyos = programas.map(p => ({ nombre: p.nombre, referencia: p.ref }));
  for (const [buscado, nombre] of [['Grua', 'grua'], ['e3.5', 'grua'], ['F3.3', 'grua'], ['', undefined], ['3.5', undefined]])
    assert.equal(programaDe(buscado, [{ nombre: 'sin_libro', referencia: '' }, ...suyos])?.nombre, nombre);
  assert.ok(casa(llano('Cámara: Inclinación'), 'INCLINACION  camara') && !casa('camara', 'camara grua'));
  assert.deepEqual(ordenaFuentes(['ch03_a/b.h', 'ch05_b/a.frag', 'ch03_a/c.glsl', 'ch03_a/b.cpp', 'ch03_a/b.h', 'ch03_a/a.vert'], 'ch03_a'),
    ['ch03_a/a.vert', 'ch03_a/c.glsl', 'ch03_a/b.cpp', 'ch03_a/b.h', 'ch05_b/a.frag']);
});

test('los enlaces: van y vuelven, y de los malos no se queja la página', () => {
  for (const [hash, nombre, guion] of [['', '', undefined], ['#grua', 'grua', undefined], ['#grua;', 'grua', ''], ['#grua;a;b', 'grua', 'a;b'],
    ['#E3.5%3Btecla%20d', 'E3.5', 'tecla d'], ['#%', '%', undefined], ['#%E0%A4%A', '%E0%A4%A', undefined], ['#grua;tecla %;%C3%B1', 'grua', 'tecla %;ñ'],
    ['#grua;a%0Ab', 'grua', 'a\nb']])
    assert.deepEqual(leeEnlace(hash), { ejercicio: false, nombre, guion }, hash);
  assert.deepEqual([leeEnlace('#ejercicio/L5.1;tecla v'), leeEnlace('#ejercicio%2FL5.1'), leeEnlace('#ejercicio')],
    [{ ejercicio: true, nombre: 'L5.1', guion: 'tecla v' }, { ejercicio: true, nombre: 'L5.1', guion: undefined },
      { ejercicio: false, nombre: 'ejercicio', guion: undefined }]);
  const posibles = ['tecla %', 'tecla #', 'tecla +', 'tecla &', 'menu Vista/Perfil ñ', 'rueda +1 3 4', 'tecla d', 'menu A ×2 ×1'];
  for (let vez = 0; vez < 200; ++vez) {
    const ordenes = Array.from({ length: azar(9) }, () => posibles[azar(azar(2) ? 2 : posibles.length)]);
    assert.deepEqual(ordenesDe(leeEnlace(new URL(hazEnlace('grua', ordenes), 'file:///a').hash).guion ?? ''), ordenes);
  }
  assert.equal(decodeURI(hazEnlace('grua', Array(7).fill('tecla d'))), '#grua;tecla d ×7');
  assert.equal(hazEnlace('grua', ['tecla #']).lastIndexOf('#'), 0);
});

test('un guion se parte en órdenes que duran poco, con límites', () => {
  assert.deepEqual(leeGuion(' tecla  d ×2;;escala 4 3\nmueve 1 2; escala 8 6 ;tecla ;').ordenes, [['tecla d', ''], ['tecla d', ''],
    ['mueve 1 2', 'escala 4 3'], ['tecla', 'escala 8 6']].map(([orden, escala]) => ({ orden, escala })));
  assert.deepEqual(ordenesDe('tecla ×2;tecla a ×0;tecla a ×x;menu A ×2 ×2'),
    ['tecla', 'tecla', 'tecla a ×0', 'tecla a ×x', 'menu A ×2 ×1', 'menu A ×2 ×1']);
  assert.deepEqual(ordenesDe('captura /lab/a.frag;tamano 9 9;captura a ×2;tecla b; captura a'), ['tecla b']);
  assert.deepEqual(ordenesDe('espera 250;espera 0;espera -1'), ['espera 100', 'espera 100', 'espera 50', 'espera 0', 'espera -1']);
  const total = guion => ordenesDe(guion).reduce((suma, o) => suma + +o.split(' ')[1], 0);
  assert.deepEqual(['espera 1000000000', 'espera 9000 ×9'].map(total), [ESPERA_MAXIMA, LIMITES.ms]);
  assert.ok(leeGuion('espera 10001').recortado && leeGuion('espera 9000 ×9').recortado);
  for (const guion of ['tecla d;'.repeat(10001), 'tecla d ×10000;tecla d', 'espera 0 ×10000;espera 0', 'tecla d ×9999;'.repeat(1e5)])
    assert.ok(leeGuion(guion).recortado && leeGuion(guion).ordenes.length === LIMITES.ordenes);
  assert.ok(ordenesDe('a'.repeat(1e6))[0].length <= LIMITES.letras + 1);
  for (const { guion, fichero } of casos) {
    const veces = guion.split(';').filter(o => o.trim() && !/escala|espera/.test(o)).reduce((n, o) => n + +(o.match(/×(\d+)/)?.[1] ?? 1), 0);
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
  assert.deepEqual([reloj.pasa(9e9), reloj.pasa(9e9 - 5)].map(ms => ms <= 100 && ms >= 0), [true, true]);
});

test('lo hecho, para el enlace', () => {
  const hecho = new Hecho(true);
  for (const [orden, escala = 'escala 8 6'] of [['tecla a'], ['tamano 9 9'], ['especial F5'], ['boton IZQUIERDO abajo 1 1'], ['arrastra 2 2'], ['arrastra 3 3'],
    ['espera 16'], ['espera 17'], ['rueda +1 3 3'], ['rueda +1 3 3'], ['tecla a', 'escala 4 3'], ['mueve 1 1', 'escala 4 3'], ['espera 9990'], ['espera 16']])
    hecho.apunta(orden, escala);
  assert.deepEqual(hecho.ordenes, ['tecla a', 'escala 8 6', 'boton IZQUIERDO abajo 1 1', 'arrastra 3 3', 'espera 33', 'rueda +1 3 3', 'rueda +1 3 3',
    'tecla a', 'escala 4 3', 'mueve 1 1', 'espera 10000']);
  const quieto = new Hecho(false);
  quieto.apunta('espera 16', 'escala 8 6');
  assert.deepEqual(quieto.ordenes, []);
});

test('cada tecla da una orden que el guion entiende', () => {
  const guion = lee('common/glut_sin_ventana/guion.cpp');
  const tabla = nombre => [...guion.match(new RegExp(`${nombre} = \\{(.*?)\\};`, 's'))[1].matchAll(/\{"(.*?)"/g)].map(m => m[1]);
  const claves = ['Escape', 'Enter', 'Backspace', 'Delete', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End', 'PageUp', 'PageDown', 'Insert',
    ...Array.from({ length: 24 }, (_, i) => `F${i + 1}`), ...Array.from({ length: 95 }, (_, i) => String.fromCharCode(32 + i))];
  const dadas = claves.map(key => ordenDeTecla({ key })).filter(Boolean);
  assert.equal(new Set(dadas).size, 4 + 9 + 11 + 95);
  for (const orden of dadas) {
    const [que, tecla, ...nada] = orden.split(' ');
    const letra = que === 'tecla' && tecla.length === 1 && tecla !== ';';
    assert.ok(!nada.length && (letra || tabla(que === 'tecla' ? 'TECLAS' : 'ESPECIALES').includes(tecla)), orden);
  }
  assert.deepEqual(['Escape', 'ArrowUp', 'Delete', 'PageDown', 'a', 'F5'].map(key => ordenDeTecla({ key })),
    ['tecla Esc', 'especial ARRIBA', 'tecla Supr', 'especial AVPAG', 'tecla a', 'especial F5']);
  const ajenas = [{ key: 'Tab' }, { key: 'F12' }, { key: 'r', ctrlKey: true }, { key: 'r', metaKey: true }, { key: 'ArrowLeft', altKey: true }, { key: 'ñ' }];
  for (const ajena of ajenas) assert.equal(ordenDeTecla(ajena), '');
  assert.equal(ordenDeTecla({ key: '@', altKey: true }), 'tecla @');
  assert.deepEqual(BOTONES.filter(b => !tabla('BOTONES').includes(b)), []);
});

function gestosCon(sigue) {
  const dadas = [], cuadro = [], g = { dadas, vivo: true };
  g.gestos = new Gestos({ da: orden => g.vivo && dadas.push(orden) > 0, luego: f => cuadro.push(f), sigue });
  g.haz = (que, x, y, ...resto) => que === 'cuadro' ? cuadro.splice(0).forEach(f => f()) : g.gestos[que]({ id: g.dedo, x, y }, ...resto);
  return g;
}

test('ratón, dedos y rueda', () => {
  for (const [sigue, gestos, ordenes] of [
    [false, [['baja', 1.4, 2.6, 'DERECHO'], ['mueve', 5, 5], ['mueve', 6, 7], ['cuadro'], ['mueve', 8, 8], ['sube', 9, 9], ['mueve', 1, 1], ['cuadro']],
      ['boton DERECHO abajo 1 3', 'arrastra 6 7', 'arrastra 8 8', 'boton DERECHO arriba 9 9']],
    [true, [['gira', 3, 4, 30, 0], ['gira', 3, 4, -10, 0], ['gira', 3, 4, 29, 0], ['gira', 3, 4, 1, 0], ['gira', 3, 4, -2, 1], ['gira', 3, 4, 1, 2],
      ['mueve', 1, 2], ['cuadro']], ['rueda -1 3 4', 'rueda +1 3 4', 'rueda -1 3 4', 'mueve 1 2']],
    [false, [['baja', 0, 0, 'IZQUIERDO'], 2, ['baja', 100, 0, 'IZQUIERDO'], ['mueve', 111, 0], ['mueve', 113, 0], ['mueve', 90, 0], ['sube', 90, 0], 1,
      ['mueve', 50, 50], ['cuadro']], ['boton IZQUIERDO abajo 0 0', 'boton IZQUIERDO arriba 0 0', 'rueda +1 113 0', 'rueda -1 90 0']]]) {
    const g = gestosCon(sigue);
    for (const gesto of gestos) gesto.length ? g.haz(...gesto) : g.dedo = gesto;
    assert.deepEqual(g.dadas, ordenes);
  }
});

test('haga lo que haga, y arranque el programa cuando sea, no se le da nada imposible', () => {
  for (let vez = 0; vez < 300; ++vez) {
    const g = gestosCon(azar(2) === 1), arranca = azar(8);
    for (let paso = 0; paso < 40; ++paso) {
      g.vivo = paso >= arranca;
      g.dedo = azar(3);
      const que = ['baja', 'mueve', 'sube', 'gira', 'cuadro'][azar(5)];
      g.haz(que, azar(200), azar(200), ...que === 'gira' ? [azar(300) - 150, azar(3)] : [BOTONES[azar(4)]]);
    }
    const abajo = new Set();
    for (const orden of g.dadas) {
      const [que, boton, sentido] = orden.split(' ');
      if (que === 'boton') assert.equal(sentido === 'arriba' ? abajo.delete(boton) : !abajo.has(boton) && !!abajo.add(boton), true, g.dadas.join(';'));
      else if (que !== 'rueda') assert.equal(que, abajo.size ? 'arrastra' : 'mueve', g.dadas.join(';'));
      assert.doesNotMatch(orden, /undefined|NaN/);
    }
  }
});

test('dos imágenes: qué parte coincide, y dónde no', () => {
  const objetivo = Uint8ClampedArray.of(0, 0, 0, 255, 9, 9, 9, 255, 200, 200, 200, 255, 200, 200, 200, 255);
  const lograda = Uint8ClampedArray.of(0, 0, 0, 255, 9, 9 + TOLERA, 9, 255, 200, 200, 200 - TOLERA - 1, 255, 0, 200, 200, 255);
  const diferencia = new Uint8ClampedArray(16), pixel = i => diferencia.subarray(4 * i, 4 * i + 4);
  assert.equal(compara(lograda, objetivo, diferencia), 0.5);
  assert.deepEqual([compara(lograda, objetivo), compara(objetivo, lograda), compara(objetivo, objetivo)], [0.5, 0.5, 1]);
  for (const i of [0, 1]) assert.ok(pixel(i)[0] === pixel(i)[1] && pixel(i)[1] === pixel(i)[2] && pixel(i)[3] === 255, 'gris');
  for (const i of [2, 3]) assert.ok(pixel(i)[0] > pixel(i)[1] + 60 && pixel(i)[3] === 255, 'rojo');
  assert.ok(pixel(3)[1] < pixel(2)[1], 'más rojo lo que más se aparta');
  assert.deepEqual([1, 0.99999, 0.9, 0].map(porciento), ['100', '99.9', '90', '0'].map(n => n + '\u00a0%'));
});

test('los ejercicios: lo guardado y sus ficheros', () => {
  for (const [texto, codigos] of [['L5.1 L12.1', ['L5.1', 'L12.1']], ['', []], [null, []], ['{"a": 1} L5 <b> L5.1', ['L5.1']]])
    assert.deepEqual([...leeResueltos(texto)], codigos);
  assert.deepEqual(delEjercicio(['c/a.vert'], ['c/b.frag', 'c/a.frag', 'c/a.vert', 'c/p.glsl', 'c/a.cpp', 'c/a.h']), ['c/a.vert', 'c/a.frag', 'c/p.glsl']);
});

test('los errores de los shaders', () => {
  assert.deepEqual(leeError("lab: ch05_iluminacion/phong.glsl:47: 'P4' : undeclared identifier — «N = unitario(P4);»", 'ch03_a'),
    { ruta: 'ch05_iluminacion/phong.glsl', linea: 47, mensaje: "'P4' : undeclared identifier" });
  assert.deepEqual(leeError("objeto.frag no compila: ERROR: 0:3: 'x' : no", 'ch03_a'), { ruta: 'ch03_a/objeto.frag', linea: 3, mensaje: "'x' : no" });
  assert.equal(leeError('a.vert y a.frag no enlazan: eso', 'ch03_a').ruta, '');
  assert.equal(leeError('giro 12', 'ch03_a'), undefined);
  const desde = performance.now();
  for (const larga of ['a'.repeat(1e5), 'a.frag:1: ' + ' — «'.repeat(3e4)]) leeError(larga, '');
  assert.ok(performance.now() - desde < 5000);
});

test('tallas, imágenes y lo guardado', () => {
  const talla = (ancho, alto, densidad) => Object.values(tallaDe({ width: ancho, height: alto }, densidad));
  assert.deepEqual([talla(240, 180, 1), talla(240.4, 180, 1.5), talla(240, 180, 3), talla(0, 0), talla(9000, 6750, 1), talla(5000, 1, 2)],
    [[240, 180], [361, 270], [480, 360], [1, 1], [4096, 3072], [4096, 1]]);
  assert.deepEqual([quepa({ width: 100, height: 50 }), quepa({ width: 4096, height: 1024 }), quepa({ width: 1, height: 9000 })].map(Object.values),
    [[100, 50], [2048, 512], [1, 2048]]);
  const ppm = ppmDe(Uint8Array.of(1, 2, 3, 255, 4, 5, 6, 0), 1, 2);
  assert.equal(String.fromCharCode(...ppm), 'P6\n1 2\n255\n\x01\x02\x03\x04\x05\x06');
  assert.ok(esPpm(ppm) && !esPpm(Uint8Array.of(0x50, 0x35)));
  assert.equal(nombreLlano('../año 1.vf'), '.._a_o_1.vf');
  assert.deepEqual(leeCambios('[["a.frag","x"]]'), [['a.frag', 'x']]);
  for (const malo of [null, '', '{', '{}', '[1]', '[["a"]]', '[["a", 1]]', 'null']) assert.deepEqual(leeCambios(malo), [], malo);
});
