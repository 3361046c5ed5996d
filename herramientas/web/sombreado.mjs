// El shader de un fragmento y el de sus vértices, línea a línea: reescritos para que apunten lo que hacen
// (herramientas/explica/glsl.h), se dibuja esa primitiva en framebuffers de float, o se recogen sus vértices.
import { bytes, ejecuta, recuerda } from './datos.mjs';
import { deVerdad, quita, sinTocar, soloEn } from './estado.mjs';
import { Gemelo, shadersDe } from './gemelo.mjs';
import { primitivasDe } from './ordenes.mjs';
import { valor } from './primitivas.mjs';

const SALIDAS = 6, HUECOS = 4, MAXIMO = 4000; // de las que se dibujan cada vez; y pasos, como mucho
const CLASES = ['entrada', 'global', 'declara', 'asigna', 'condicion', 'vuelta', 'caso', 'entra', 'argumento', 'sale',
  'devuelve', 'vuelve', 'descarta', 'salida']; // las de glsl.h
const NADA = `#version 300 es
precision highp float;
out vec4 nada;
void main() { nada = vec4(0.0); }
`;

/// explica.js y explica.wasm, que son herramientas/explica/web.cpp: (texto, si es de vértices) → { fuente, notas,
/// sinSeguir }.
export const reescritor = recuerda(async () => {
  const [wasm, js] = await Promise.all([bytes('explica-wasm'), bytes('explica-js')]);
  ejecuta(new TextDecoder().decode(js));
  const modulo = await Reescritor({ wasmBinary: wasm }), tipos = ['string', 'number', 'number'];
  return (texto, deVertices) =>
    JSON.parse(modulo.ccall('explicaReescribe', 'string', tipos, [texto, SALIDAS, Number(deVertices)]));
});

/// Lo apuntado en orden, juntando los pasos de un mismo valor.
function enLineas(ids, apuntado, notas) {
  const lineas = [];
  for (let k = 0; k < ids.length && ids[k] >= 0;) {
    const nota = notas[ids[k]];
    if (k + nota.pasos > ids.length) break; // ha quedado cortado
    lineas.push({ ...nota, clase: CLASES[nota.clase], en: nota.linea,
      valor: valor(nota.tipo, apuntado.slice(4 * k, 4 * (k + nota.pasos))) });
    k += nota.pasos;
  }
  return lineas;
}

/// Las trazas de ese shader, tantas como listas da `ejecuta(desde)`: de cada una, lo que sale, 4 × SALIDAS números.
function trazas({ notas, sinSeguir }, cuantas, ejecuta) {
  const ids = Array.from({ length: cuantas }, () => []), apuntado = ids.map(() => []), dados = ids.map(() => 0);
  for (let desde = 0, total = 1; desde < Math.min(total, MAXIMO); desde += HUECOS) {
    for (const [i, sale] of ejecuta(desde).entries()) {
      ids[i].push(...sale.slice(0, HUECOS));
      dados[i] = sale[4] + 65536 * sale[5];
      total = Math.max(total, dados[i]);
      apuntado[i].push(...sale.slice(8, 8 + 4 * HUECOS));
    }
  }
  const apuntables = [...new Set(notas.filter(n => n.funcion).map(n => n.linea))];
  return ids.map((suyos, i) => ({ lineas: enLineas(suyos, apuntado[i], notas), pasos: dados[i], motivo: '', apuntables,
    sinSeguir: sinSeguir.map(s => ({ ...s, en: s.linea })) }));
}

const sinTraza = motivo => ({ lineas: [], pasos: 0, motivo, apuntables: [], sinSeguir: [] });

function deFragmento(gl, programa, reescribe, { x, y }, pinta) {
  const hecho = reescribe(shadersDe(gl, programa)[1], false);
  const gemelo = hecho.fuente && new Gemelo(gl, programa, { frag: hecho.fuente });
  if (!gemelo?.vale) return sinTraza('no sé seguir este shader');
  const marco = gl.createFramebuffer(), colores = Array.from({ length: SALIDAS }, () => gl.createRenderbuffer());
  const renderbuffer = gl.getParameter(gl.RENDERBUFFER_BINDING), sale = new Float32Array(4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, marco);
  const sitios = colores.map((color, i) => {
    gl.bindRenderbuffer(gl.RENDERBUFFER, color);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.RENDERBUFFER, color);
    return gl.COLOR_ATTACHMENT0 + i;
  });
  gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
  gl.drawBuffers(sitios);
  quita(gl);
  soloEn(gl, x, y);
  gl.colorMask(true, true, true, true);
  const [traza] = trazas(hecho, 1, desde => {
    gemelo.usa({ explica_desde: desde });
    pinta();
    return [sitios.flatMap(sitio => {
      gl.readBuffer(sitio);
      gl.readPixels(x, y, 1, 1, gl.RGBA, gl.FLOAT, sale);
      return [...sale];
    })];
  });
  gl.deleteFramebuffer(marco);
  for (const color of colores) gl.deleteRenderbuffer(color);
  gemelo.borra();
  return traza;
}

/// Recoge, sin rasterizar, `cada` números de cada uno de esos vértices: uno a uno, que con transform feedback ES no
/// dibuja por índices. Lo que devuelve lo hace cada vez que se llama.
function recogida(gl, indices, cada) {
  const transformacion = gl.createTransformFeedback(), bufer = gl.createBuffer(),
    salida = new Float32Array(cada * indices.length);
  const estaba = gl.getParameter(gl.TRANSFORM_FEEDBACK_BINDING),
    generico = gl.getParameter(gl.TRANSFORM_FEEDBACK_BUFFER_BINDING);
  gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, transformacion);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, bufer);
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, salida.byteLength, gl.STREAM_READ);
  gl.enable(gl.RASTERIZER_DISCARD);
  const recoge = () => {
    gl.beginTransformFeedback(gl.POINTS);
    for (const indice of indices) deVerdad(gl).drawArrays(gl.POINTS, indice, 1);
    gl.endTransformFeedback();
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, salida);
    return Array.from(indices, (_, i) => [...salida.subarray(cada * i, cada * (i + 1))]);
  };
  const acaba = () => {
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, estaba);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, generico);
    gl.deleteTransformFeedback(transformacion);
    gl.deleteBuffer(bufer);
  };
  return { recoge, acaba };
}

/// gl_Position de esos vértices con el programa en curso.
export function posicionesDe(gl, indices) {
  const gemelo = new Gemelo(gl, gl.getParameter(gl.CURRENT_PROGRAM), { frag: NADA, recoge: ['gl_Position'] });
  if (!gemelo.vale || !indices.length) return [];
  return sinTocar(gl, () => {
    const { recoge, acaba } = recogida(gl, indices, 4);
    gemelo.usa();
    const hechas = recoge();
    acaba();
    gemelo.borra();
    return hechas;
  });
}

function deVertices(gl, programa, reescribe, indices) {
  const hecho = reescribe(shadersDe(gl, programa)[0], true);
  const salidas = Array.from({ length: SALIDAS }, (_, i) => `explica_${i}`);
  const gemelo = hecho.fuente && new Gemelo(gl, programa, { vert: hecho.fuente, frag: NADA, recoge: salidas });
  if (!gemelo?.vale) return [];
  const { recoge, acaba } = recogida(gl, indices, 4 * SALIDAS);
  const hechas = trazas(hecho, indices.length, desde => {
    gemelo.usa({ explica_desde: desde });
    return recoge();
  });
  acaba();
  gemelo.borra();
  return hechas.map((traza, i) => ({ ...traza, indice: indices[i] }));
}

const hallado = ({ lineas }, clase, nombre) => lineas.findLast(l => l.clase === clase && l.nombre === nombre)?.valor;

/// Lo que pesa cada vértice en el centro del píxel (x, y), con perspectiva y sin ella: sin dividir por w, que en uno de
/// detrás de la cámara no es positiva. `vista`: el viewport.
export function pesosDe(posiciones, [x, y], [x0, y0, ancho, alto]) {
  const X = 2 * (x + 0.5 - x0) / ancho - 1, Y = 2 * (y + 0.5 - y0) / alto - 1;
  const reparte = pesos => pesos.map(p => p / (pesos[0] + pesos[1] + pesos[2]));
  const a = posiciones.map(p => [p[0] - X * p[3], p[1] - Y * p[3]]);
  const con = reparte([0, 1, 2].map(i => {
    const b = a[(i + 1) % 3], c = a[(i + 2) % 3];
    return b[0] * c[1] - b[1] * c[0];
  }));
  return [con, reparte(con.map((p, i) => p * posiciones[i][3]))];
}

/// Cada entrada del fragmento que dan los vértices: lo que sale de mezclarlos y lo que se ha apuntado.
function interpola(vertices, fragmento, pesos, fuente) {
  return fragmento.lineas.filter(l => l.clase === 'entrada' && /^(float|vec)/.test(l.tipo)).flatMap(({ nombre,
    valor }) => {
    const deCada = vertices.map(v => hallado(v, 'salida', nombre));
    if (deCada.some(v => v?.length !== valor.length)) return [];
    // la del último
    const suyos = RegExp(`\\bflat\\s+in\\s+\\w+\\s[^;]*\\b${nombre}\\b`).test(fuente) ? [0, 0, 1] : pesos;
    const interpolado = valor.map((_, k) => deCada.reduce((suma, v, i) => suma + suyos[i] * v[k], 0));
    return [{ nombre, interpolado, valor }];
  });
}

/// De la primitiva de una orden, en el píxel (x, y) desde abajo: { fragmento, vertices, pesos, … }, como lo dice
/// herramientas/explica/sombreado.cpp.
export function sombrea(gl, orden, primitiva, { x, y }, reescribe, pinta) {
  const { indices, cada } = primitivasDe(gl, orden), programa = gl.getParameter(gl.CURRENT_PROGRAM);
  const suyos = [...indices.slice(cada * primitiva, cada * (primitiva + 1))], vista = gl.getParameter(gl.VIEWPORT);
  const fragmento = sinTocar(gl, () => deFragmento(gl, programa, reescribe, { x, y }, pinta));
  const vertices = sinTocar(gl, () => deVertices(gl, programa, reescribe, suyos));
  const posiciones = vertices.map(v => hallado(v, 'salida', 'gl_Position'));
  const datos = { orden: orden.n, primitiva, fragmento, vertices };
  if (posiciones.length !== 3 || posiciones.some(p => !p)) return datos;
  const [pesos, pesosSinPerspectiva] = pesosDe(posiciones, [x, y], vista);
  return { ...datos, pesos, pesosSinPerspectiva, entradas: interpola(vertices, fragmento, pesos, shadersDe(gl,
    programa)[1]) };
}
