// Leer de un framebuffer, también lo que WebGL no deja: la profundidad se copia a una textura y se dibuja, y la
// plantilla se saca bit a bit, con GL_EQUAL.
import { deVerdad, quita, sinTocar } from './estado.mjs';

const DE_VENTANA = ['DEPTH24_STENCIL8', 'DEPTH_COMPONENT24']; // WebGL no dice cuál es el suyo
const TODO = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
`;
const PROFUNDIDAD = `#version 300 es
precision highp float;
uniform highp sampler2D copia;
uniform int paso, x, y;
out vec4 z;
void main() { z = texelFetch(copia, ivec2(x, y) + paso * ivec2(gl_FragCoord.xy), 0); }
`;
const PLANO = `#version 300 es
precision highp float;
uniform float valor;
out vec4 color;
void main() { color = vec4(valor); }
`;

const MINIATURA = 240; // de ancho, como mucho

/// Los framebuffers aparte en que se dibuja y a que se copia, de ese tamaño.
export class Lector {
  #hechos = [];
  #copias = new Map(); // por su formato de profundidad
  #programas = new Map();

  constructor(gl, ancho, alto) {
    Object.assign(this, { gl, ancho, alto, vao: gl.createVertexArray(), verdad: deVerdad(gl) });
    this.aparte = this.#marco(gl.RGBA32F, 'DEPTH24_STENCIL8');
    this.salida = this.#marco(gl.RGBA32F);
  }

  borra() {
    for (const deshaz of this.#hechos) deshaz();
    for (const p of this.#programas.values()) this.gl.deleteProgram(p);
    this.gl.deleteVertexArray(this.vao);
  }

  /// Un framebuffer con ese color y, si se dice, una textura de ese formato de profundidad.
  #marco(color, profundidad) {
    const { gl, ancho, alto } = this, marco = gl.createFramebuffer(), renderbuffer = gl.createRenderbuffer();
    const textura = profundidad && gl.createTexture(), estaba = gl.getParameter(gl.RENDERBUFFER_BINDING);
    sinTocar(gl, () => {
      gl.bindFramebuffer(gl.FRAMEBUFFER, marco);
      gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, color, ancho, alto);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, renderbuffer);
      if (!profundidad) return;
      gl.bindTexture(gl.TEXTURE_2D, textura);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl[profundidad], ancho, alto);
      for (const f of ['MIN', 'MAG']) gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${f}_FILTER`], gl.NEAREST);
      const donde = /STENCIL/.test(profundidad) ? gl.DEPTH_STENCIL_ATTACHMENT : gl.DEPTH_ATTACHMENT;
      gl.framebufferTexture2D(gl.FRAMEBUFFER, donde, gl.TEXTURE_2D, textura, 0);
    });
    gl.bindRenderbuffer(gl.RENDERBUFFER, estaba);
    this.#hechos.push(() => {
      gl.deleteFramebuffer(marco);
      gl.deleteRenderbuffer(renderbuffer);
      gl.deleteTexture(textura ?? null);
    });
    return { marco, textura };
  }

  /// Cubre lo que haya con ese fragment shader.
  #cubre(frag, uniforms, antes = () => {}) {
    const { gl } = this;
    if (!this.#programas.has(frag)) this.#programas.set(frag, enlaza(gl, TODO, frag));
    const programa = this.#programas.get(frag);
    gl.useProgram(programa);
    gl.bindVertexArray(this.vao);
    for (const [nombre, v] of Object.entries(uniforms)) {
      const donde = gl.getUniformLocation(programa, nombre);
      if (nombre === 'valor') gl.uniform1f(donde, v);
      else gl.uniform1i(donde, v);
    }
    antes();
    this.verdad.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /// Lo que hay en ese framebuffer, RGBA de 0 a 255, fila a fila desde abajo. Nada si no se puede leer.
  colores(marco, x, y, ancho, alto) {
    const { gl } = this;
    return sinTocar(gl, () => {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, marco);
      const tipo = marco && this.#adjunto(marco, 'COLOR_ATTACHMENT0', 'COMPONENT_TYPE');
      const real = tipo === gl.FLOAT, rgba = new (real ? Float32Array : Uint8Array)(4 * ancho * alto);
      if (marco && (!tipo || tipo === gl.INT || tipo === gl.UNSIGNED_INT || this.#muestras(marco))) return;
      gl.readPixels(x, y, ancho, alto, gl.RGBA, real ? gl.FLOAT : gl.UNSIGNED_BYTE, rgba);
      return real ? Uint8ClampedArray.from(rgba, v => v * 255) : rgba;
    });
  }

  #adjunto(marco, cual, que) {
    const { gl } = this, de = (donde, nombre) => gl.getFramebufferAttachmentParameter(gl.READ_FRAMEBUFFER, gl[donde],
      nombre);
    if (de(cual, gl.FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) === gl.NONE) return 0;
    return de(cual, gl[`FRAMEBUFFER_ATTACHMENT_${que}`]);
  }

  #muestras(marco) {
    const { gl } = this;
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, marco);
    return gl.getParameter(gl.SAMPLES);
  }

  /// La profundidad y la plantilla de un framebuffer, copiadas para leerlas. Nada si no se puede.
  #copia(marco, x, y, ancho, alto) {
    const { gl } = this;
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, marco);
    let formatos = DE_VENTANA;
    if (marco) {
      const bits = this.#adjunto(marco, 'DEPTH_ATTACHMENT', 'DEPTH_SIZE');
      const plantilla = this.#adjunto(marco, 'STENCIL_ATTACHMENT', 'STENCIL_SIZE');
      if (!bits || this.#muestras(marco)) return;
      formatos = [{ 16: 'DEPTH_COMPONENT16', 24: 'DEPTH_COMPONENT24', 32: 'DEPTH_COMPONENT32F' }[bits]];
      if (plantilla) formatos = [bits === 24 ? 'DEPTH24_STENCIL8' : 'DEPTH32F_STENCIL8'];
    }
    for (const formato of formatos) {
      if (!this.#copias.has(formato)) this.#copias.set(formato, this.#marco(gl.RGBA8, formato));
      const copia = this.#copias.get(formato), rectangulo = [x, y, x + ancho, y + alto];
      const buferes = gl.DEPTH_BUFFER_BIT | (/STENCIL/.test(formato) ? gl.STENCIL_BUFFER_BIT : 0);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, marco);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, copia.marco);
      while (gl.getError());
      this.verdad.blitFramebuffer(...rectangulo, ...rectangulo, buferes, gl.NEAREST);
      if (!gl.getError()) return { ...copia, plantilla: /STENCIL/.test(formato) };
    }
  }

  /// Las de una textura, de `paso` en `paso` píxeles.
  profundidades(textura, x, y, ancho, alto, paso = 1) {
    const { gl } = this, z = new Float32Array(4 * ancho * alto);
    return sinTocar(gl, () => {
      quita(gl);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.salida.marco);
      gl.viewport(0, 0, ancho, alto);
      gl.colorMask(true, true, true, true);
      this.#cubre(PROFUNDIDAD, { x, y, paso, copia: gl.getParameter(gl.ACTIVE_TEXTURE) - gl.TEXTURE0 },
        () => gl.bindTexture(gl.TEXTURE_2D, textura));
      gl.readPixels(0, 0, ancho, alto, gl.RGBA, gl.FLOAT, z);
      return z.filter((_, i) => i % 4 === 0);
    });
  }

  /// Los valores de la plantilla de una copia.
  #plantillas({ marco }, x, y, ancho, alto) {
    const { gl } = this, rgba = new Uint8Array(4 * ancho * alto);
    gl.bindFramebuffer(gl.FRAMEBUFFER, marco);
    quita(gl);
    gl.colorMask(true, true, true, true);
    gl.depthMask(false);
    gl.viewport(0, 0, this.ancho, this.alto);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, y, ancho, alto);
    gl.clearColor(0, 0, 0, 0);
    this.verdad.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.KEEP);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE);
    for (let bit = 0; bit < 8; ++bit) {
      gl.stencilFunc(gl.EQUAL, 1 << bit, 1 << bit);
      this.#cubre(PLANO, { valor: (1 << bit) / 255 });
    }
    gl.readPixels(x, y, ancho, alto, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
    return rgba.filter((_, i) => i % 4 === 0);
  }

  /// { color, profundidad, plantilla } de un píxel de la ventana; de lo que no hay, nada.
  pixel(x, y) {
    const { gl } = this, hay = cual => gl.getContextAttributes()[cual];
    return sinTocar(gl, () => {
      const color = [...this.colores(null, x, y, 1, 1)];
      const copia = (hay('depth') || hay('stencil')) && this.#copia(null, x, y, 1, 1);
      return {
        color,
        profundidad: copia && hay('depth') ? this.profundidades(copia.textura, x, y, 1, 1)[0] : undefined,
        plantilla: copia?.plantilla && hay('stencil') ? this.#plantillas(copia, x, y, 1, 1)[0] : undefined,
      };
    });
  }

  /// Como `pixel`, de un framebuffer entero de ese tamaño: el color a su tamaño y lo demás reducido.
  entero(marco, ancho, alto, conPlantilla) {
    const { gl } = this, paso = Math.ceil(ancho / MINIATURA);
    return sinTocar(gl, () => {
      const color = this.colores(marco, 0, 0, ancho, alto);
      if (ancho > this.ancho || alto > this.alto || !(marco || gl.getContextAttributes().depth)) return { color, paso };
      const copia = this.#copia(marco, 0, 0, ancho, alto);
      const [n, m] = [ancho, alto].map(v => Math.max(Math.floor(v / paso), 1));
      const plantilla = copia?.plantilla && conPlantilla && this.#plantillas(copia, 0, 0, ancho, alto);
      return {
        color, paso, ancho: n, alto: m,
        profundidad: copia && this.profundidades(copia.textura, 0, 0, n, m, paso),
        plantilla: plantilla ? Uint8Array.from({ length: n * m }, (_, i) =>
          plantilla[Math.floor(i / n) * paso * ancho + i % n * paso]) : undefined,
      };
    });
  }
}

function enlaza(gl, vert, frag) {
  const programa = gl.createProgram();
  for (const [tipo, texto] of [[gl.VERTEX_SHADER, vert], [gl.FRAGMENT_SHADER, frag]]) {
    const shader = gl.createShader(tipo);
    gl.shaderSource(shader, texto);
    gl.compileShader(shader);
    gl.attachShader(programa, shader);
    gl.deleteShader(shader);
  }
  gl.linkProgram(programa);
  return programa;
}
