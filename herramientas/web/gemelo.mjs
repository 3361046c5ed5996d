// Un programa de GLSL como otro, con algún shader cambiado y los mismos valores en sus uniforms.

/// De cada programa, lo que se envía a cada uniform que no tiene porque nada lo usa, [función, …datos], y dónde ata
/// cada atributo: su gemelo puede usarlos.
export const enviados = new WeakMap(), atados = new WeakMap();

/// El texto del vertex shader y el del fragment shader.
export function shadersDe(gl, programa) {
  const todos = gl.getAttachedShaders(programa);
  return [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].map(tipo =>
    gl.getShaderSource(todos.find(s => gl.getShaderParameter(s, gl.SHADER_TYPE) === tipo)));
}

/// Los uniforms activos, cada elemento de un array por su lado: { nombre, tipo, donde }.
export function uniformsDe(gl, programa) {
  return Array.from({ length: gl.getProgramParameter(programa, gl.ACTIVE_UNIFORMS) }, (_, i) => {
    const { name, type: tipo, size } = gl.getActiveUniform(programa, i);
    return Array.from({ length: size }, (_, k) => {
      const nombre = name.replace(/\[0\]$/, `[${k}]`);
      return { nombre, tipo, donde: gl.getUniformLocation(programa, nombre) };
    });
  }).flat().filter(u => u.donde);
}

/// Los atributos activos que da un array: { nombre, tipo, donde }.
export function atributosDe(gl, programa) {
  return Array.from({ length: gl.getProgramParameter(programa, gl.ACTIVE_ATTRIBUTES) }, (_, i) => {
    const { name: nombre, type: tipo } = gl.getActiveAttrib(programa, i);
    return { nombre, tipo, donde: gl.getAttribLocation(programa, nombre) };
  }).filter(a => a.donde >= 0);
}

function ponUniform(gl, tipo, donde, v) {
  const matriz = { [gl.FLOAT_MAT2]: '2', [gl.FLOAT_MAT3]: '3', [gl.FLOAT_MAT4]: '4' }[tipo];
  if (matriz) return gl[`uniformMatrix${matriz}fv`](donde, false, v);
  const lista = typeof v === 'object' ? [...v].map(Number) : [Number(v)];
  const letra = v instanceof Float32Array || tipo === gl.FLOAT ? 'f' : v instanceof Uint32Array ? 'ui' : 'i';
  gl[`uniform${lista.length}${letra}v`](donde, lista);
}

export class Gemelo {
  /// `recoge`: los que se recogen con transform feedback.
  constructor(gl, original, { vert = shadersDe(gl, original)[0], frag = shadersDe(gl, original)[1], recoge }) {
    Object.assign(this, { gl, original, programa: gl.createProgram() });
    for (const [tipo, texto] of [[gl.VERTEX_SHADER, vert], [gl.FRAGMENT_SHADER, frag]]) {
      const shader = gl.createShader(tipo);
      gl.shaderSource(shader, texto);
      gl.compileShader(shader);
      gl.attachShader(this.programa, shader);
      gl.deleteShader(shader);
    }
    for (const [nombre, donde] of [...atados.get(original) ?? []]) gl.bindAttribLocation(this.programa, donde, nombre);
    for (const { nombre, donde } of atributosDe(gl, original)) gl.bindAttribLocation(this.programa, donde, nombre);
    if (recoge) gl.transformFeedbackVaryings(this.programa, recoge, gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(this.programa);
    this.vale = gl.getProgramParameter(this.programa, gl.LINK_STATUS);
  }

  /// `mas`: otros uniforms, enteros.
  usa(mas = {}) {
    const { gl, original, programa } = this;
    gl.useProgram(programa);
    for (const { nombre, tipo, donde } of uniformsDe(gl, programa)) {
      const suyo = gl.getUniformLocation(original, nombre);
      if (suyo) ponUniform(gl, tipo, donde, gl.getUniform(original, suyo));
    }
    for (const [nombre, [f, ...datos]] of enviados.get(original) ?? [])
      gl[f](gl.getUniformLocation(programa, nombre), ...datos);
    for (const [nombre, v] of Object.entries(mas)) gl.uniform1i(gl.getUniformLocation(programa, nombre), v);
  }

  /// A ese uniform, un valor que no es el de entrada.
  cambia(nombre) {
    const { gl, programa } = this, { tipo, donde } = uniformsDe(gl, programa).find(u => u.nombre === nombre);
    const vale = gl.getUniform(programa, donde), otro = i => 1 + (5 * i % 16) / 4;
    ponUniform(gl, tipo, donde, typeof vale === 'object' ? vale.map((_, i) => otro(i)) : otro(0));
  }

  borra() { this.gl.deleteProgram(this.programa); }
}
