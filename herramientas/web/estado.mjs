// El estado de WebGL: cómo se llama cada cosa, qué hay puesto, y hacer algo dejándolo como estaba.

const PRUEBAS = ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'STENCIL_TEST', 'SCISSOR_TEST', 'SAMPLE_ALPHA_TO_COVERAGE',
  'RASTERIZER_DISCARD'];
const MODOS = ['POINTS', 'LINES', 'LINE_LOOP', 'LINE_STRIP', 'TRIANGLES', 'TRIANGLE_STRIP', 'TRIANGLE_FAN'];
export const nombreModo = modo => `GL_${MODOS[modo]}`;

const nombres = new Map();
/// GL_LEQUAL. El 0 y el 1, que son muchas cosas, como factores de una mezcla.
export function nombreDe(gl, valor) {
  if (!nombres.size)
    for (const n in gl) if (/^[A-Z]/.test(n) && gl[n] > 255 && !nombres.has(gl[n])) nombres.set(gl[n], `GL_${n}`);
  return ['GL_ZERO', 'GL_ONE'][valor] ?? nombres.get(valor) ?? String(valor);
}

/// De un tipo de GLSL: FLOAT_VEC3, vec3.
export function tipoDe(gl, tipo) {
  const [, forma] = nombreDe(gl, tipo).match(/^GL_(.*)$/) ?? [];
  const [, escalar, n] = forma?.match(/^(FLOAT|INT|UNSIGNED_INT|BOOL)(?:_VEC(\d))?$/) ?? [];
  if (escalar) {
    const [solo, letra] = { FLOAT: ['float', ''], INT: ['int', 'i'], UNSIGNED_INT: ['uint', 'u'], BOOL: ['bool',
      'b'] }[escalar];
    return n ? `${letra}vec${n}` : solo;
  }
  if (/^FLOAT_MAT/.test(forma)) return forma.replace('FLOAT_MAT', 'mat');
  const [, letra, , que, sombra] = forma?.match(/^((UNSIGNED_INT|INT)_)?SAMPLER_(2D|3D|CUBE)(_SHADOW)?$/) ?? [];
  const de = { UNSIGNED_INT_: 'u', INT_: 'i' }[letra] ?? '';
  return que ? `${de}sampler${que === 'CUBE' ? 'Cube' : que}${sombra ? 'Shadow' : ''}` : nombreDe(gl, tipo);
}

/// Las que escriben píxeles, aunque haya algo delante de ellas.
export const ORDENES = ['clear', 'drawArrays', 'drawElements', 'blitFramebuffer'];
export const deVerdad = gl =>
  Object.fromEntries(ORDENES.map(f => [f, WebGL2RenderingContext.prototype[f].bind(gl)]));

const refs = new WeakMap(); // de cada contexto, el valor que se pide a la plantilla por delante y por detrás
export const refDePlantilla = (gl, cara = 0) => (refs.get(gl) ?? [0, 0])[cara];

/// Se apunta según se pone: el que dice Firefox está acotado por el framebuffer que él tenga puesto, que no es este.
export function apuntaPlantilla({ prototype }) {
  const { stencilFunc, stencilFuncSeparate } = prototype;
  prototype.stencilFunc = function (funcion, ref, mira) {
    refs.set(this, [ref, ref]);
    stencilFunc.call(this, funcion, ref, mira);
  };
  prototype.stencilFuncSeparate = function (cara, funcion, ref, mira) {
    const [delante, detras] = [0, 1].map(i => refDePlantilla(this, i));
    refs.set(this, [cara === this.BACK ? delante : ref, cara === this.FRONT ? detras : ref]);
    stencilFuncSeparate.call(this, cara, funcion, ref, mira);
  };
}

export const pon = (gl, prueba, si) => si ? gl.enable(gl[prueba]) : gl.disable(gl[prueba]);
export function quita(gl, salvo = []) {
  for (const p of PRUEBAS) if (!salvo.includes(p)) gl.disable(gl[p]);
}

/// Hace algo y deja el estado como estaba.
export function sinTocar(gl, hace) {
  const lee = nombre => gl.getParameter(gl[nombre]), puestas = PRUEBAS.map(p => gl.isEnabled(gl[p]));
  const deCara = ['FUNC', 'VALUE_MASK', 'FAIL', 'PASS_DEPTH_FAIL', 'PASS_DEPTH_PASS', 'WRITEMASK'];
  const caras = ['', '_BACK'].map(cara => deCara.map(n => lee(`STENCIL${cara}_${n}`)));
  const plantillas = [0, 1].map(i => refDePlantilla(gl, i));
  const recorte = lee('SCISSOR_BOX'), mascara = lee('COLOR_WRITEMASK'), vista = lee('VIEWPORT');
  const fondo = lee('COLOR_CLEAR_VALUE'), escribe = lee('DEPTH_WRITEMASK'), funcion = lee('DEPTH_FUNC');
  const lejos = lee('DEPTH_CLEAR_VALUE'), programa = lee('CURRENT_PROGRAM'), vao = lee('VERTEX_ARRAY_BINDING');
  const factores = ['SRC_RGB', 'DST_RGB', 'SRC_ALPHA', 'DST_ALPHA'].map(n => lee(`BLEND_${n}`));
  const ecuaciones = [lee('BLEND_EQUATION_RGB'), lee('BLEND_EQUATION_ALPHA')];
  const unidad = lee('ACTIVE_TEXTURE'), textura = lee('TEXTURE_BINDING_2D'),
    indices = lee('ELEMENT_ARRAY_BUFFER_BINDING');
  const dibuja = lee('DRAW_FRAMEBUFFER_BINDING'), leido = lee('READ_FRAMEBUFFER_BINDING'),
    paquete = lee('PIXEL_PACK_BUFFER_BINDING');
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  try {
    return hace();
  } finally {
    PRUEBAS.forEach((p, i) => pon(gl, p, puestas[i]));
    [gl.FRONT, gl.BACK].forEach((cara, i) => {
      const [f, mira, falla, sinZ, conZ, mascaraSuya] = caras[i], ref = plantillas[i];
      gl.stencilFuncSeparate(cara, f, ref, mira);
      gl.stencilOpSeparate(cara, falla, sinZ, conZ);
      gl.stencilMaskSeparate(cara, mascaraSuya);
    });
    gl.scissor(...recorte);
    gl.colorMask(...mascara);
    gl.viewport(...vista);
    gl.clearColor(...fondo);
    gl.depthMask(escribe);
    gl.depthFunc(funcion);
    gl.clearDepth(lejos);
    gl.blendFuncSeparate(...factores);
    gl.blendEquationSeparate(...ecuaciones);
    gl.useProgram(programa);
    gl.bindVertexArray(vao);
    gl.activeTexture(unidad);
    gl.bindTexture(gl.TEXTURE_2D, textura);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, paquete);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, dibuja);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, leido);
  }
}

/// Lo que se dibuje solo puede llegar a ese píxel.
export function soloEn(gl, x, y) {
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(x, y, 1, 1);
}

/// Lo que está puesto: cada prueba, apagada o con lo que pide, como lo dice herramientas/explica/ordenes.cpp.
export function estadoActual(gl) {
  const lee = nombre => gl.getParameter(gl[nombre]), llama = nombre => nombreDe(gl, lee(nombre));
  const si = (prueba, texto) => gl.isEnabled(gl[prueba]) ? texto() : 'no';
  const llamadas = (...cuales) => cuales.map(llama).join(', ');
  return [
    ['glViewport', lee('VIEWPORT').join(' ')],
    ['GL_CULL_FACE', si('CULL_FACE', () => `${llama('CULL_FACE_MODE')}, de frente ${llama('FRONT_FACE')}`)],
    ['GL_SCISSOR_TEST', si('SCISSOR_TEST', () => lee('SCISSOR_BOX').join(' '))],
    ['GL_STENCIL_TEST', si('STENCIL_TEST', () => `${llama('STENCIL_FUNC')} ${refDePlantilla(gl)}, máscara ` +
      `${lee('STENCIL_VALUE_MASK') >>> 0}; ` +
      llamadas('STENCIL_FAIL', 'STENCIL_PASS_DEPTH_FAIL', 'STENCIL_PASS_DEPTH_PASS'))],
    ['GL_DEPTH_TEST', si('DEPTH_TEST', () => llama('DEPTH_FUNC'))],
    ['glDepthMask', lee('DEPTH_WRITEMASK') ? 'escribe' : 'no escribe'],
    ['GL_BLEND', si('BLEND', () => `${llama('BLEND_EQUATION_RGB')}: ${llamadas('BLEND_SRC_RGB', 'BLEND_DST_RGB')}; ` +
      `alfa ${llamadas('BLEND_SRC_ALPHA', 'BLEND_DST_ALPHA')}`)],
    ['glColorMask', mascaraColor(gl)],
    ['GL_POLYGON_OFFSET_FILL', si('POLYGON_OFFSET_FILL', () =>
      `${lee('POLYGON_OFFSET_FACTOR')} ${lee('POLYGON_OFFSET_UNITS')}`)],
  ].map(([nombre, valor]) => ({ nombre, valor }));
}

const mascaraColor = gl => gl.getParameter(gl.COLOR_WRITEMASK).map((si, i) => si ? 'rgba'[i] : '-').join('');

/// Lo que distingue una orden de otra, en pocas palabras.
export function pruebasActuales(gl, dibuja) {
  const lista = [], puesta = prueba => gl.isEnabled(gl[prueba]);
  if (puesta('SCISSOR_TEST')) lista.push('recorte');
  if (!dibuja) return lista;
  if (puesta('STENCIL_TEST'))
    lista.push(`plantilla ${nombreDe(gl, gl.getParameter(gl.STENCIL_FUNC)).slice(3)} ` +
      refDePlantilla(gl));
  if (puesta('CULL_FACE')) lista.push('quita caras');
  if (puesta('BLEND')) lista.push('mezcla');
  if (mascaraColor(gl) === '----') lista.push('sin color');
  if (!puesta('DEPTH_TEST')) lista.push('sin profundidad');
  return lista;
}
