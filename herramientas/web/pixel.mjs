// La historia de un píxel del lienzo: se dibuja el cuadro otra vez y, en cada orden que llega a la ventana, se mira qué
// primitivas lo cubren, que se dibujan aparte y se leen, y qué prueba no pasa cada una. Si pasa la plantilla y la
// profundidad, que en WebGL no se leen, se pregunta (occlusion query): dice si pasó algún fragmento, y en otro turno
// del navegador.
import { bytes, ejecuta, recuerda } from './datos.mjs';
import { cuales, sueltas, valor } from './primitivas.mjs';

const SALIDAS = 6, HUECOS = 4, MAXIMO = 4000; // de las que se dibujan cada vez; y pasos, como mucho
const MARCA = `#version 300 es
precision highp float;
out vec4 marca;
void main() { marca = vec4(1.0); }
`;

/// explica.js y explica.wasm, que son herramientas/explica/web.cpp: (texto) → { fuente, notas, sinSeguir }.
const reescritor = recuerda(async () => {
  const [wasm, js] = await Promise.all([bytes('explica-wasm'), bytes('explica-js')]);
  ejecuta(new TextDecoder().decode(js));
  const modulo = await Reescritor({ wasmBinary: wasm });
  const tipos = ['string', 'number', 'number'];
  return texto => JSON.parse(modulo.ccall('explicaReescribe', 'string', tipos, [texto, SALIDAS, 0]));
});

/// Un programa como ese, con otro fragment shader y los mismos valores en sus uniforms.
class Gemelo {
  constructor(gl, original, frag) {
    Object.assign(this, { gl, original, programa: gl.createProgram() });
    const [vert] = shadersDe(gl, original);
    for (const [tipo, texto] of [[gl.VERTEX_SHADER, vert], [gl.FRAGMENT_SHADER, frag]]) {
      const shader = gl.createShader(tipo);
      gl.shaderSource(shader, texto);
      gl.compileShader(shader);
      gl.attachShader(this.programa, shader);
      gl.deleteShader(shader);
    }
    for (let i = 0; i < gl.getProgramParameter(original, gl.ACTIVE_ATTRIBUTES); ++i) {
      const { name } = gl.getActiveAttrib(original, i), donde = gl.getAttribLocation(original, name);
      if (donde >= 0) gl.bindAttribLocation(this.programa, donde, name);
    }
    gl.linkProgram(this.programa);
    this.vale = gl.getProgramParameter(this.programa, gl.LINK_STATUS);
  }

  usa(mas = {}) {
    const { gl, original, programa } = this;
    gl.useProgram(programa);
    for (let i = 0; i < gl.getProgramParameter(programa, gl.ACTIVE_UNIFORMS); ++i) {
      const { name, type, size } = gl.getActiveUniform(programa, i);
      for (let k = 0; k < size; ++k) {
        const nombre = size > 1 ? name.replace(/\[0\]$/, `[${k}]`) : name;
        const suyo = gl.getUniformLocation(original, nombre);
        if (suyo) ponUniform(gl, type, gl.getUniformLocation(programa, nombre), gl.getUniform(original, suyo));
      }
    }
    for (const [nombre, v] of Object.entries(mas)) gl.uniform1i(gl.getUniformLocation(programa, nombre), v);
  }
}

function ponUniform(gl, tipo, donde, v) {
  const matriz = { [gl.FLOAT_MAT2]: '2', [gl.FLOAT_MAT3]: '3', [gl.FLOAT_MAT4]: '4' }[tipo];
  if (matriz) return gl[`uniformMatrix${matriz}fv`](donde, false, v);
  const lista = typeof v === 'object' ? [...v].map(Number) : [Number(v)];
  const letra = v instanceof Float32Array || tipo === gl.FLOAT ? 'f' : v instanceof Uint32Array ? 'ui' : 'i';
  gl[`uniform${lista.length}${letra}v`](donde, lista);
}

/// El texto del vertex shader y el del fragment shader.
function shadersDe(gl, programa) {
  const todos = gl.getAttachedShaders(programa);
  return [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].map(tipo =>
    gl.getShaderSource(todos.find(s => gl.getShaderParameter(s, gl.SHADER_TYPE) === tipo)));
}

const PRUEBAS = ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'STENCIL_TEST', 'SCISSOR_TEST', 'SAMPLE_ALPHA_TO_COVERAGE'];

/// Hace algo y deja el estado como estaba.
function sinTocar(gl, hace) {
  const lee = nombre => gl.getParameter(gl[nombre]);
  const puestas = PRUEBAS.map(p => gl.isEnabled(gl[p])), recorte = lee('SCISSOR_BOX'), mascara = lee('COLOR_WRITEMASK');
  const fondo = lee('COLOR_CLEAR_VALUE'), profundidad = lee('DEPTH_WRITEMASK'), programa = lee('CURRENT_PROGRAM');
  const plantilla = [lee('STENCIL_WRITEMASK'), lee('STENCIL_BACK_WRITEMASK')];
  const indices = lee('ELEMENT_ARRAY_BUFFER_BINDING');
  const dibuja = lee('DRAW_FRAMEBUFFER_BINDING'), leido = lee('READ_FRAMEBUFFER_BINDING');
  try {
    return hace();
  } finally {
    PRUEBAS.forEach((p, i) => puestas[i] ? gl.enable(gl[p]) : gl.disable(gl[p]));
    gl.scissor(...recorte);
    gl.colorMask(...mascara);
    gl.clearColor(...fondo);
    gl.depthMask(profundidad);
    gl.stencilMaskSeparate(gl.FRONT, plantilla[0]);
    gl.stencilMaskSeparate(gl.BACK, plantilla[1]);
    gl.useProgram(programa);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, dibuja);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, leido);
  }
}

class Pixel {
  sucesos = [];
  #gemelos = new Map();
  #orden = 0;
  #marco; // donde se dibuja aparte

  /// x, y: desde abajo a la izquierda. `sombrea`: { orden, primitiva } de la que se quiere el shader paso a paso.
  constructor(gl, x, y, reescribe, sombrea) {
    Object.assign(this, { gl, x, y, reescribe, sombrea });
    const funciones = ['clear', 'drawArrays', 'drawElements', 'blitFramebuffer'];
    this.verdad = Object.fromEntries(funciones.map(f => [f, gl[f].bind(gl)]));
  }

  /// Lo que pasa mientras se dibuja.
  mira(redibuja) {
    const { gl, verdad } = this;
    const enVentana = hace => (...datos) => {
      ++this.#orden;
      if (gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING)) return verdad[hace](...datos);
      return this[hace](...datos);
    };
    const colores = this.#hazMarco(gl.RGBA8, 1);
    for (const f of Object.keys(verdad)) gl[f] = enVentana(f);
    try {
      redibuja();
    } finally {
      this.#deshaz(this.#marco, colores);
      for (const f of Object.keys(verdad)) delete gl[f];
      for (const g of this.#gemelos.values()) gl.deleteProgram(g.programa);
    }
    return this;
  }

  /// En #marco, uno con tantos colores del tamaño del lienzo.
  #hazMarco(formato, n) {
    const { gl } = this, colores = Array.from({ length: n }, () => gl.createRenderbuffer());
    const renderbuffer = gl.getParameter(gl.RENDERBUFFER_BINDING);
    sinTocar(gl, () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.#marco = gl.createFramebuffer());
      for (const [i, color] of colores.entries()) {
        gl.bindRenderbuffer(gl.RENDERBUFFER, color);
        gl.renderbufferStorage(gl.RENDERBUFFER, formato, gl.drawingBufferWidth, gl.drawingBufferHeight);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.RENDERBUFFER, color);
      }
      gl.drawBuffers(colores.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
      gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
    });
    return colores;
  }

  #deshaz(marco, colores) {
    this.gl.deleteFramebuffer(marco);
    colores.forEach(c => this.gl.deleteRenderbuffer(c));
  }

  clear(buferes) { this.#entera('clear', 'glClear', buferes, [buferes]); }
  blitFramebuffer(...datos) { this.#entera('blitFramebuffer', 'glBlitFramebuffer', datos[8], datos); }

  /// Lo que no se hace por primitivas: se apunta si llega al píxel.
  #entera(f, titulo, buferes, datos) {
    const { gl } = this, [x0, y0, x1, y1] = f === 'clear' ? [0, 0, Infinity, Infinity] : datos.slice(4, 8);
    const entre = (v, a, b) => v >= Math.min(a, b) && v < Math.max(a, b), antes = this.#lee();
    this.verdad[f](...datos);
    if (buferes & gl.COLOR_BUFFER_BIT && !this.#recortado() && entre(this.x, x0, x1) && entre(this.y, y0, y1))
      this.sucesos.push({ orden: this.#orden, titulo, veredicto: 'escrito', antes, despues: this.#lee() });
  }

  #recortado() {
    const { gl } = this, [x, y, ancho, alto] = gl.getParameter(gl.SCISSOR_BOX);
    return gl.isEnabled(gl.SCISSOR_TEST) && !(this.x >= x && this.x < x + ancho && this.y >= y && this.y < y + alto);
  }

  drawArrays(modo, primero, n) {
    this.#dibuja(modo, Uint32Array.from({ length: n }, (_, i) => primero + i));
  }

  drawElements(modo, n, tipo, desde) {
    const { gl } = this;
    const Tabla = { [gl.UNSIGNED_BYTE]: Uint8Array, [gl.UNSIGNED_SHORT]: Uint16Array }[tipo] ?? Uint32Array;
    const indices = new Tabla(n);
    gl.getBufferSubData(gl.ELEMENT_ARRAY_BUFFER, desde, indices);
    this.#dibuja(modo, Uint32Array.from(indices));
  }

  /// En el píxel, cada primitiva por su orden; fuera de él da igual: después se vuelve a dibujar el cuadro.
  #dibuja(modo, vertices) {
    const { gl } = this, { suelto, cada, indices } = sueltas(modo, vertices), n = indices.length / cada;
    const programa = gl.getParameter(gl.CURRENT_PROGRAM), bufer = gl.createBuffer();
    const pinta = (a, b) => this.verdad.drawElements(suelto, (b - a) * cada, gl.UNSIGNED_INT, 4 * cada * a);
    sinTocar(gl, () => {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, bufer);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(indices), gl.STREAM_DRAW);
      const marca = this.#gemelo(programa, 'marca', () => MARCA);
      const cubre = (a, b) => this.#aparte([], 0, () => { marca.usa(); pinta(a, b); }).some(c => c > 0);
      const todas = marca.vale ? cuales(n, cubre) : [];
      let hechas = 0;
      for (const k of todas) {
        this.#deVerdad(() => pinta(hechas, k)); // con varias muestras por píxel, también las que no cubren su centro
        this.#una(k, programa, marca, () => pinta(k, k + 1), cada);
        hechas = k + 1;
      }
      this.#deVerdad(() => pinta(hechas, n));
    });
    gl.deleteBuffer(bufer);
  }

  #una(primitiva, programa, marca, pinta, cada) {
    const { gl } = this, antes = this.#lee(), orden = this.#orden, puesta = p => gl.isEnabled(gl[p]);
    const conMarca = () => { marca.usa(); pinta(); }, conSuyo = () => { gl.useProgram(programa); pinta(); };
    if (this.sombrea?.orden === orden && this.sombrea.primitiva === primitiva)
      this.pasos = this.#pasos(programa, pinta);
    const [negro, blanco] = [0, 1].map(fondo => this.#aparte([], fondo, conSuyo));
    const descarta = negro.every(c => c === 0) && blanco.every(c => c === 255);
    const veredicto = puesta('CULL_FACE') && !this.#aparte(['CULL_FACE'], 0, conMarca).some(c => c > 0) ? 'cara'
      : this.#recortado() ? 'recorte' : descarta ? 'descartado'
      : gl.getParameter(gl.COLOR_WRITEMASK).some(Boolean) ? 'escrito' : 'mascara';
    const preguntas = {};
    for (const [prueba, dice] of [['STENCIL_TEST', 'plantilla'], ['DEPTH_TEST', 'profundidad']])
      if (puesta(prueba) && /escrito|mascara/.test(veredicto)) preguntas[dice] = this.#pregunta(prueba, conMarca);
    this.#deVerdad(pinta);
    const titulo = `${['', 'punto', 'línea', 'triángulo'][cada]} ${primitiva}`;
    this.sucesos.push({ orden, titulo, primitiva, veredicto, preguntas, color: descarta ? undefined : negro, antes,
      despues: this.#lee(), mezcla: puesta('BLEND') });
  }

  /// Tal como está todo, pero solo en el píxel.
  #deVerdad(pinta) {
    const { gl } = this;
    if (!this.#recortado()) sinTocar(gl, () => { this.#soloAqui(); pinta(); });
  }

  #soloAqui() {
    const { gl } = this;
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(this.x, this.y, 1, 1);
  }

  /// El color que deja algo en un framebuffer aparte, sobre ese gris y sin más pruebas que esas.
  #aparte(pruebas, fondo, hace) {
    const { gl } = this;
    return sinTocar(gl, () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.#marco);
      for (const p of PRUEBAS) if (!pruebas.includes(p)) gl.disable(gl[p]);
      this.#soloAqui();
      gl.colorMask(true, true, true, true);
      gl.clearColor(fondo, fondo, fondo, 1);
      this.verdad.clear(gl.COLOR_BUFFER_BIT);
      hace();
      return this.#lee(this.#marco);
    });
  }

  /// Si algo pasa esa prueba: se sabrá con `responde`.
  #pregunta(prueba, hace) {
    const { gl } = this, pregunta = gl.createQuery();
    sinTocar(gl, () => {
      for (const p of PRUEBAS) if (p !== prueba) gl.disable(gl[p]);
      this.#soloAqui();
      gl.colorMask(false, false, false, false);
      gl.depthMask(false);
      gl.stencilMask(0);
      gl.beginQuery(gl.ANY_SAMPLES_PASSED, pregunta);
      hace();
      gl.endQuery(gl.ANY_SAMPLES_PASSED);
    });
    return pregunta;
  }

  /// Lo que no se sabía mientras se dibujaba.
  async responde() {
    const { gl } = this;
    for (const s of this.sucesos)
      for (const [dice, pregunta] of Object.entries(s.preguntas ?? {})) {
        while (!gl.getQueryParameter(pregunta, gl.QUERY_RESULT_AVAILABLE))
          await new Promise(sigue => setTimeout(sigue));
        const pasa = gl.getQueryParameter(pregunta, gl.QUERY_RESULT);
        if (!pasa && /escrito|mascara/.test(s.veredicto)) s.veredicto = dice;
        gl.deleteQuery(pregunta);
      }
    return this;
  }

  #lee(framebuffer = null) {
    const { gl } = this, rgba = new Uint8Array(4), leido = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    const paquete = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.readPixels(this.x, this.y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, leido);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, paquete);
    return [...rgba.slice(0, 3)];
  }

  #gemelo(programa, que, frag) {
    const hechos = this.#gemelos, clave = this.#clave(programa) + que;
    if (!hechos.has(clave)) hechos.set(clave, new Gemelo(this.gl, programa, frag()));
    return hechos.get(clave);
  }

  #numeros = new Map();
  #clave(programa) {
    if (!this.#numeros.has(programa)) this.#numeros.set(programa, this.#numeros.size);
    return this.#numeros.get(programa);
  }

  /// El shader de ese fragmento, paso a paso: { texto, lineas, sinSeguir, pasos }.
  #pasos(programa, pinta) {
    const { gl, x, y } = this, [, texto] = shadersDe(gl, programa);
    const { fuente, notas, sinSeguir } = this.reescribe(texto);
    const reescrito = fuente && this.#gemelo(programa, 'pasos', () => fuente), sale = new Float32Array(4);
    if (!reescrito?.vale) return { texto, lineas: [], sinSeguir, pasos: 0 };
    return sinTocar(gl, () => {
      const otro = this.#marco, colores = this.#hazMarco(gl.RGBA32F, SALIDAS), apuntado = [], ids = [];
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.#marco);
      for (const p of PRUEBAS) gl.disable(gl[p]);
      this.#soloAqui();
      gl.colorMask(true, true, true, true);
      const lee = i => {
        gl.readBuffer(gl.COLOR_ATTACHMENT0 + i);
        gl.readPixels(x, y, 1, 1, gl.RGBA, gl.FLOAT, sale);
        return [...sale];
      };
      let total = 1;
      for (let desde = 0; desde < Math.min(total, MAXIMO); desde += HUECOS) {
        reescrito.usa({ explica_desde: desde });
        pinta();
        ids.push(...lee(0));
        const [p, q] = lee(1);
        total = p + 65536 * q;
        for (let h = 0; h < HUECOS; ++h) apuntado.push(...lee(2 + h));
      }
      this.#deshaz(this.#marco, colores);
      this.#marco = otro;
      return { texto, lineas: enLineas(ids, apuntado, notas), sinSeguir, pasos: total };
    });
  }
}

function enLineas(ids, apuntado, notas) {
  const lineas = [];
  for (let k = 0; k < ids.length && ids[k] >= 0;) {
    const nota = notas[ids[k]];
    lineas.push({ ...nota, valor: valor(nota.tipo, apuntado.slice(4 * k, 4 * (k + nota.pasos))) });
    k += nota.pasos;
  }
  return lineas;
}

/// Lo que le pasa al píxel (x, y), desde arriba a la izquierda, de un lienzo, al volver a dibujarlo:
/// { historia, color, shader }.
export async function explicaPixel(lienzo, x, y, redibuja) {
  const gl = lienzo.getContext('webgl2'), reescribe = await reescritor('');
  const mira = sombrea => new Pixel(gl, x, lienzo.height - 1 - y, reescribe, sombrea).mira(redibuja).responde();
  const { sucesos } = await mira(), ultimo = sucesos.findLast(s => s.veredicto === 'escrito');
  const shader = ultimo?.primitiva === undefined ? undefined : (await mira(ultimo)).pasos;
  redibuja();
  while (gl.getError() !== gl.NO_ERROR); // ninguno es del programa
  return { historia: sucesos, color: sucesos.findLast(s => s.despues)?.despues, shader };
}
