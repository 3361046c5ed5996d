// La historia de un píxel del lienzo: en cada orden que llega a la ventana se mira qué primitivas lo cubren, que se
// dibujan aparte y se leen, y qué prueba no pasa cada una. Si pasa la plantilla y la profundidad se pregunta (occlusion
// query): dice si pasó algún fragmento, y en otro turno del navegador.
import { deVerdad, nombreDe, quita, refDePlantilla, sinTocar, soloEn } from './estado.mjs';
import { Gemelo } from './gemelo.mjs';
import { mezcla } from './mezcla.mjs';
import { buferesDe, dibuja, interpone, primitivasDe, vaciada } from './ordenes.mjs';
import { cuales } from './primitivas.mjs';
import { sombrea } from './sombreado.mjs';

const MARCA = `#version 300 es
precision highp float;
out vec4 marca;
void main() { marca = vec4(1.0); }
`;
const NADA = [0, 0, 0, 0];
const NINGUNO = [-12345, 0, 0, -1]; // el color que no da ningún shader
const seisCifras = n => String(Number(n?.toPrecision(6)));

/// Si algo pasa con esas pruebas y ese programa; lo dirá `responde`.
export function pregunta(gl, { salvo, programa }, hace) {
  const esta = gl.createQuery();
  sinTocar(gl, () => {
    quita(gl, salvo);
    gl.colorMask(false, false, false, false);
    gl.depthMask(false);
    gl.stencilMask(0);
    programa();
    gl.beginQuery(gl.ANY_SAMPLES_PASSED, esta);
    hace();
    gl.endQuery(gl.ANY_SAMPLES_PASSED);
  });
  return esta;
}

export async function responde(gl, esta) {
  while (!gl.getQueryParameter(esta, gl.QUERY_RESULT_AVAILABLE)) await new Promise(sigue => setTimeout(sigue));
  const pasa = Boolean(gl.getQueryParameter(esta, gl.QUERY_RESULT));
  gl.deleteQuery(esta);
  return pasa;
}

export class Pixel {
  sucesos = [];
  #gemelos = new Map();

  /// x, y: desde abajo a la izquierda. `sombreada`: { orden, primitiva } de la que se quiere el shader paso a paso.
  constructor(gl, { x, y, lector, reescribe, sombreada }) {
    Object.assign(this, { gl, x, y, lector, reescribe, sombreada, verdad: deVerdad(gl) });
  }

  /// Lo que pasa al redibujar.
  async mira(redibuja) {
    const { gl } = this;
    interpone(gl, redibuja, orden => {
      if (gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING)) orden.hazla();
      else if (!dibuja(orden)) this.#entera(orden);
      else if (vaciada(gl)) orden.hazla();
      else this.#dibuja(orden);
    });
    for (const g of this.#gemelos.values()) g.borra();
    for (const s of this.sucesos) {
      for (const [veredicto, esta] of s.preguntas ?? [])
        if (!await responde(gl, esta) && /escrito|mascara/.test(s.veredicto)) s.veredicto = veredicto;
      delete s.preguntas;
      s.dice = this.#dice(s);
      if (s.veredicto !== 'escrito') delete s.mezcla;
    }
    return this;
  }

  #dice({ veredicto, hecho, profundidad, profundidadAntes, plantillaAntes, plantillaPide, profundidadPide, cara }) {
    return {
      escrito: hecho ?? 'escrito', cara: `quitado por su cara (${cara})`, recorte: 'fuera del recorte (glScissor)',
      descartado: 'el shader lo descarta (discard)', mascara: 'no escribe color (glColorMask)',
      plantilla: `no pasa la plantilla: hay ${plantillaAntes ?? '?'} y se pide ${plantillaPide}`,
      profundidad: profundidad === undefined || profundidadAntes === undefined ? `oculto (${profundidadPide})`
        : `oculto: su profundidad es ${seisCifras(profundidad)} y había ${seisCifras(profundidadAntes)} ` +
          `(${profundidadPide})`,
    }[veredicto];
  }

  /// Lo que no se hace por primitivas: se apunta si llega al píxel.
  #entera(orden) {
    const { gl } = this, [x0, y0, x1, y1] = orden.f === 'clear' ? [0, 0, Infinity, Infinity] : orden.datos.slice(4, 8);
    const entre = (v, a, b) => v >= Math.min(a, b) && v < Math.max(a, b);
    if (!entre(this.x, x0, x1) || !entre(this.y, y0, y1)) return orden.hazla();
    const recortada = this.#recortado(), conColor = buferesDe(orden) & gl.COLOR_BUFFER_BIT;
    const tapada = orden.f === 'clear' && conColor && !gl.getParameter(gl.COLOR_WRITEMASK).some(Boolean);
    this.#apunta({ orden: orden.n, veredicto: recortada ? 'recorte' : tapada ? 'mascara' : 'escrito',
      hecho: orden.f === 'clear' ? 'borrado' : 'copiado de otro framebuffer' }, orden.hazla);
  }

  /// El suceso, con lo que hay en el píxel antes y después de hacerlo.
  #apunta(suceso, hace) {
    const antes = this.lector.pixel(this.x, this.y);
    hace();
    const despues = this.lector.pixel(this.x, this.y);
    this.sucesos.push(Object.assign(suceso, { framebuffer: 0, antes: antes.color, despues: despues.color,
      profundidadAntes: antes.profundidad, profundidadDespues: despues.profundidad,
      plantillaAntes: antes.plantilla, plantillaDespues: despues.plantilla }));
    return suceso;
  }

  #recortado() {
    const { gl } = this, [x, y, ancho, alto] = gl.getParameter(gl.SCISSOR_BOX);
    return gl.isEnabled(gl.SCISSOR_TEST) && !(this.x >= x && this.x < x + ancho && this.y >= y && this.y < y + alto);
  }

  /// En el píxel, cada primitiva por su orden; fuera de él da igual: después se vuelve a dibujar el cuadro.
  #dibuja(orden) {
    const { gl } = this, { suelto, cada, indices, tipo } = primitivasDe(gl, orden), n = indices.length / cada;
    const programa = gl.getParameter(gl.CURRENT_PROGRAM), bufer = gl.createBuffer();
    const pinta = (a, b) => this.verdad.drawElements(suelto, (b - a) * cada, gl.UNSIGNED_INT, 4 * cada * a);
    const conSueltas = hace => sinTocar(gl, () => { gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, bufer); hace(); });
    const { sombreada } = this;
    conSueltas(() => {
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(indices), gl.STREAM_DRAW);
      const marca = this.#marca(programa);
      const cubre = (a, b) => this.#aparte([], NADA, () => { marca.usa(); pinta(a, b); }).color[0] > 0;
      this.todas = marca.vale ? cuales(n, cubre) : [];
    });
    if (sombreada?.orden === orden.n)
      this.sombreado = sombrea(gl, orden, sombreada.primitiva, this, this.reescribe,
        () => conSueltas(() => pinta(sombreada.primitiva, sombreada.primitiva + 1)));
    conSueltas(() => {
      let hechas = 0;
      for (const k of this.todas) {
        this.#deVerdad(() => pinta(hechas, k)); // con varias muestras por píxel, también las que no cubren su centro
        const vertices = [...indices.slice(cada * k, cada * (k + 1))];
        this.#una({ orden: orden.n, tipo, primitiva: k, vertices }, programa, () => pinta(k, k + 1));
        hechas = k + 1;
      }
      this.#deVerdad(() => pinta(hechas, n));
    });
    gl.deleteBuffer(bufer);
  }

  #marca(programa) {
    if (!this.#gemelos.has(programa)) this.#gemelos.set(programa, new Gemelo(this.gl, programa, { frag: MARCA }));
    return this.#gemelos.get(programa);
  }

  #una(suceso, programa, pinta) {
    const { gl } = this, puesta = p => gl.isEnabled(gl[p]), marca = this.#marca(programa);
    const llama = cual => nombreDe(gl, gl.getParameter(gl[cual]));
    const conMarca = () => { marca.usa(); pinta(); }, da = this.#fragmento(programa, pinta);
    const vuelta = puesta('CULL_FACE') && !(this.#aparte(['CULL_FACE'], NADA, conMarca).color[0] > 0);
    const veredicto = vuelta ? 'cara' : this.#recortado() ? 'recorte' : !da ? 'descartado'
      : gl.getParameter(gl.COLOR_WRITEMASK).some(Boolean) ? 'escrito' : 'mascara';
    Object.assign(suceso, { veredicto, ...da, preguntas: [] }, vuelta && { cara: llama('CULL_FACE_MODE') });
    const pedida = { STENCIL_TEST: () => `${llama('STENCIL_FUNC')} ${refDePlantilla(gl)}`,
      DEPTH_TEST: () => llama('DEPTH_FUNC') };
    for (const [prueba, dice] of [['STENCIL_TEST', 'plantilla'], ['DEPTH_TEST', 'profundidad']]) {
      if (!puesta(prueba)) continue;
      suceso[`${dice}Pide`] = pedida[prueba]();
      if (!/escrito|mascara/.test(veredicto)) continue;
      const programa = () => { soloEn(gl, this.x, this.y); marca.usa(); };
      suceso.preguntas.push([dice, pregunta(gl, { salvo: [prueba], programa }, pinta)]);
    }
    this.#apunta(suceso, () => this.#deVerdad(pinta));
    if (da) suceso.mezcla = mezcla(gl, da.color, suceso.antes, suceso.despues);
    if (gl.getContextAttributes().antialias && !suceso.mezcla?.cuadra) delete suceso.mezcla; // lo cubre en parte
  }

  /// Tal como está todo, pero solo en el píxel.
  #deVerdad(pinta) {
    const { gl } = this;
    if (!this.#recortado()) sinTocar(gl, () => { soloEn(gl, this.x, this.y); pinta(); });
  }

  /// Lo que deja algo en el framebuffer aparte, sobre ese color y sin más pruebas que esas.
  #aparte(pruebas, fondo, hace) {
    const { gl, lector, x, y } = this, color = new Float32Array(4);
    return sinTocar(gl, () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, lector.aparte.marco);
      quita(gl, pruebas);
      if (pruebas.includes('DEPTH_TEST')) gl.enable(gl.DEPTH_TEST);
      gl.depthFunc(gl.ALWAYS);
      gl.depthMask(true);
      soloEn(gl, x, y);
      gl.colorMask(true, true, true, true);
      gl.clearBufferfv(gl.COLOR, 0, fondo);
      hace();
      gl.readPixels(x, y, 1, 1, gl.RGBA, gl.FLOAT, color);
      return { color: [...color] };
    });
  }

  /// Lo que da el shader en el píxel, { color, profundidad }, sin pruebas ni mezcla; nada si descarta.
  #fragmento(programa, pinta) {
    const { color } = this.#aparte(['DEPTH_TEST'], NINGUNO, () => { this.gl.useProgram(programa); pinta(); });
    if (color.every((c, i) => c === NINGUNO[i])) return;
    return { color, profundidad: this.lector.profundidades(this.lector.aparte.textura, this.x, this.y, 1, 1)[0] };
  }
}
