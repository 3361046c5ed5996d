// El cuadro que se ve, explicado, con los mismos datos que ./lab explica: se vuelve a dibujar unas veces, con algo
// delante de las órdenes que escriben píxeles.
import { crea } from '../base/documento.mjs';
import { sinTocar } from './estado.mjs';
import { shadersDe } from './gemelo.mjs';
import { Lector } from './lector.mjs';
import { cableadoDe, describe, dibuja, interpone, vaciada } from './ordenes.mjs';
import { Pixel, responde } from './pixel.mjs';
import { reescritor } from './sombreado.mjs';
import { delCableado, elegidas, importa, porQueNada } from './sospechas.mjs';

/// Un PNG de unos bytes RGBA, o de uno por píxel, fila a fila desde abajo, reducido de `paso` en `paso`.
function enPng(bytes, ancho, alto, paso = 1) {
  const imagen = new ImageData(ancho, alto), entera = crea('canvas', { width: ancho, height: alto });
  const rgba = bytes.length > ancho * alto ? bytes : Uint8Array.from({ length: 4 * bytes.length }, (_, i) =>
    i % 4 === 3 ? 255 : bytes[i >> 2]);
  for (let y = 0; y < alto; ++y)
    imagen.data.set(rgba.subarray(4 * ancho * (alto - 1 - y), 4 * ancho * (alto - y)), 4 * ancho * y);
  entera.getContext('2d').putImageData(imagen, 0, 0);
  if (paso === 1) return entera.toDataURL();
  const [width, height] = [ancho, alto].map(v => Math.max(Math.floor(v / paso), 1));
  const menor = crea('canvas', { width, height });
  menor.getContext('2d').drawImage(entera, 0, 0, width, height);
  return menor.toDataURL();
}

/// Los píxeles que cambian y el rectángulo en que están, desde arriba: { cambian, donde }.
function cambios(antes, ahora, ancho, alto) {
  const [a, b] = [antes, ahora].map(v => v && new Uint32Array(v.buffer));
  let cambian = 0, x0 = ancho, y0 = alto, x1 = -1, y1 = -1;
  for (let i = 0; i < b.length; ++i) {
    if (a && a[i] === b[i]) continue;
    const x = i % ancho, y = alto - 1 - (i - x) / ancho;
    ++cambian;
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  }
  return { cambian, ...cambian && { donde: [x0, y0, x1 - x0 + 1, y1 - y0 + 1] } };
}

const iguales = (a, b) => a?.length === b?.length && a.every((v, i) => v === b[i]);

/// De lo que llega más cerca a lo que más lejos sin ser el fondo, de negro a casi blanco.
function enGrises(z) {
  const llenos = z.filter(v => v < 1), menor = llenos.reduce((a, b) => Math.min(a, b), 1);
  const tramo = Math.max(llenos.reduce((a, b) => Math.max(a, b), 0) - menor, 1e-9);
  return Uint8Array.from(z, v => v < 1 ? 220 * (v - menor) / tramo : 255);
}

/// Lo que va quedando en cada framebuffer.
class Miniaturas {
  #vistos = new Map();
  #conPlantilla = false;

  constructor(gl, lector) { Object.assign(this, { gl, lector }); }

  apunta(orden) {
    const { gl } = this, marco = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING), [ancho, alto] = orden.talla;
    this.#conPlantilla ||= gl.isEnabled(gl.STENCIL_TEST);
    const visto = this.#vistos.get(marco) ?? {}, nuevo = this.lector.entero(marco, ancho, alto, this.#conPlantilla);
    this.#vistos.set(marco, { ...visto, ...nuevo });
    if (nuevo.color) Object.assign(orden, cambios(visto.color, nuevo.color, ancho, alto));
    if (orden.cambian) orden.miniatura = enPng(nuevo.color, ancho, alto, nuevo.paso);
    if (nuevo.profundidad && !iguales(nuevo.profundidad, visto.profundidad))
      orden.profundidad = enPng(enGrises(nuevo.profundidad), nuevo.ancho, nuevo.alto);
    const mayor = nuevo.plantilla ? Math.max(...nuevo.plantilla) : 0;
    if (nuevo.plantilla && !iguales(nuevo.plantilla, visto.plantilla) && (mayor || visto.plantilla))
      orden.plantilla = enPng(nuevo.plantilla.map(v => 255 * v / Math.max(mayor, 1)), nuevo.ancho, nuevo.alto);
  }

  get lisa() {
    const { color } = this.#vistos.get(null) ?? {};
    return Boolean(color) && color.every((v, i) => i % 4 === 3 || v === color[i % 4]);
  }
}

/// Cada orden, con lo que deja; y lo que se sospecha.
async function mira(gl, lector, redibuja) {
  const ordenes = [], programas = new Map(), miniaturas = new Miniaturas(gl, lector), todas = [], preguntas = new Map();
  interpone(gl, redibuja, orden => {
    const dicha = describe(gl, orden);
    if (dibuja(orden) && !vaciada(gl)) {
      const programa = gl.getParameter(gl.CURRENT_PROGRAM), esta = gl.createQuery();
      programas.set(programa.name, shadersDe(gl, programa));
      dicha.cableado = cableadoDe(gl);
      const uniformes = dicha.cableado.uniformes.filter(u =>
        u.dado || u.tipo.includes('sampler') || importa(gl, orden, u.nombre, lector));
      todas.push(...delCableado({ ...dicha.cableado, uniformes }, orden.n));
      const libre = !gl.getQuery(gl.ANY_SAMPLES_PASSED, gl.CURRENT_QUERY);
      if (libre) gl.beginQuery(gl.ANY_SAMPLES_PASSED, esta);
      orden.hazla();
      if (libre) gl.endQuery(gl.ANY_SAMPLES_PASSED);
      if (libre) preguntas.set(dicha, esta);
    } else {
      orden.hazla();
    }
    if (!vaciada(gl)) sinTocar(gl, () => miniaturas.apunta(dicha));
    ordenes.push(dicha);
  });
  let figuras = 0, escritas = 0, escrito = false;
  for (const [dicha, esta] of preguntas) {
    // common/encima
    const rotulo = dicha.cableado.texturas.some(t => t.sampler === 'atlas'), pasa = await responde(gl, esta);
    if (!pasa) dicha.fragmentos = 0;
    if (!rotulo) [figuras, escritas, escrito] = [figuras + 1, escritas + pasa, escrito || pasa];
  }
  const vacias = new Set(ordenes.filter(o => o.fragmentos === 0).map(o => o.n)), porQue = [];
  if (vacias.size) {
    interpone(gl, redibuja, orden => {
      if (vacias.has(orden.n)) porQue.push(porQueNada(gl, orden));
      orden.hazla();
    });
  }
  for (const di of porQue) todas.push(await di());
  const sospechas = elegidas(todas, { lisa: miniaturas.lisa, figura: !figuras || escritas > 0, escrito });
  return { ordenes, programas: [...programas].map(([programa, [vert, frag]]) => ({ programa, vert, frag })),
    sospechas };
}

/// El cuadro y, si se da, el píxel (x, y) desde arriba a la izquierda del lienzo, como lo enseña
/// herramientas/base/cuadro.mjs, con el texto de los shaders tal cual.
export async function explicaCuadro(lienzo, redibuja, pixel) {
  const gl = lienzo.getContext('webgl2'), { width, height } = lienzo;
  if (!gl.getExtension('EXT_color_buffer_float'))
    throw new Error('a este navegador le falta EXT_color_buffer_float, con que se mira lo que calcula un shader');
  const lector = new Lector(gl, width, height);
  try {
    const datos = { talla: [width, height], pixel: null, color: null, historia: [], ...await mira(gl, lector,
      redibuja) };
    if (!pixel) return datos;
    const [x, y] = [pixel[0], height - 1 - pixel[1]], que = { x, y, lector, reescribe: await reescritor('') };
    const { sucesos } = await new Pixel(gl, que).mira(redibuja), sombreada = sucesos.findLast(s =>
      s.veredicto === 'escrito');
    const sombreado = sombreada?.primitiva === undefined ? undefined
      : (await new Pixel(gl, { ...que, sombreada: { ...sombreada } }).mira(redibuja)).sombreado;
    redibuja();
    return { ...datos, pixel, color: lector.pixel(x, y).color, historia: sucesos, sombreado };
  } finally {
    lector.borra();
    while (gl.getError() !== gl.NO_ERROR); // ninguno es del programa
  }
}
