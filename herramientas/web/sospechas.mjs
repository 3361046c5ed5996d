// Lo que suele estar mal cuando la ventana queda negra o no es lo que se esperaba. En la página solo cambian los
// shaders, y aquí está lo que puede venir de ellos, con las palabras de herramientas/explica/sospechas.cpp.
import { nombreDe, pon, quita, sinTocar } from './estado.mjs';
import { Gemelo } from './gemelo.mjs';
import { primitivasDe } from './ordenes.mjs';
import { pregunta, responde } from './pixel.mjs';
import { posicionesDe } from './sombreado.mjs';

const SEGURO = 2, SI_NO_SE_VE_NADA = 1; // con la ventana lisa se dice todo
const VERTICES = 256;                   // los que se miran
const SIN_DESCARTAR = `#version 300 es
precision highp float;
out vec4 nada;
void main() { nada = vec4(1.0); }
`;

/// Si lo que dibuja la orden depende de ese uniform: hay enlazadores que dejan lo que no sirve para nada.
export function importa(gl, orden, nombre, { aparte, ancho, alto }) {
  const gemelo = new Gemelo(gl, gl.getParameter(gl.CURRENT_PROGRAM), {});
  const pinta = cambia => sinTocar(gl, () => {
    const color = new Float32Array(4 * ancho * alto);
    gl.bindFramebuffer(gl.FRAMEBUFFER, aparte.marco);
    quita(gl);
    gl.colorMask(true, true, true, true);
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    gemelo.usa();
    if (cambia) gemelo.cambia(nombre);
    orden.hazla();
    gl.readPixels(0, 0, ancho, alto, gl.RGBA, gl.FLOAT, color);
    return color;
  });
  const [una, otra] = [false, true].map(pinta);
  gemelo.borra();
  return una.some((v, i) => v !== otra[i]);
}

/// De lo que le llega a una orden.
export function delCableado({ uniformes, texturas, atributos }, orden) {
  const salen = [], di = (gravedad, dice, prueba) => salen.push({ gravedad, orden, dice, prueba });
  for (const { nombre, tipo, valor, dado } of uniformes) {
    const quien = `el uniform «${nombre}» `;
    if (!valor.every(Number.isFinite)) di(SEGURO, `${quien}tiene algo que no es un número`, 'Mira de qué cuenta sale.');
    else if (!dado && !texturas.some(t => t.sampler === nombre && !t.incompleta))
      di(SEGURO, `${quien}lo usa el shader y nadie le ha dado valor: es 0`,
        'Falta enviarlo, se llama de otra manera o se ha enviado sin glUseProgram antes.');
    else if (tipo.startsWith('mat') && valor.every(v => v === 0))
      di(SEGURO, `${quien}es una matriz toda de ceros`, 'Debería ser al menos la identidad: glm::mat4(1).');
  }
  for (const { sampler, unidad, incompleta } of texturas)
    if (incompleta)
      di(SEGURO, `la textura de «${sampler}», en la unidad ${unidad}, está incompleta: ${incompleta}`,
        'De una textura incompleta se lee negro.');
  for (const { nombre, activo, bufer } of atributos)
    if (!activo || !bufer)
      di(SEGURO, `el atributo «${nombre}» lo lee el shader y no lo da ningún array`,
        'Falta glVertexAttribPointer o glEnableVertexAttribArray, con su VAO enlazado.');
  return salen;
}

const LADOS = [['a la izquierda', 'a la derecha'], ['por debajo', 'por encima'], ['más cerca que cerca',
  'más lejos que lejos']];

/// Por qué nada de eso cae en la ventana: [qué pasa, qué mirar].
export function fueraDe(puntos) {
  const todos = es => puntos.length && puntos.every(es);
  if (todos(p => !p.every(Number.isFinite)))
    return ['las posiciones de todos sus vértices son NaN o infinitas', 'Mira las matrices y lo que se divide.'];
  if (todos(([x, y, z]) => x === 0 && y === 0 && z === 0) || todos(p => p[3] === 0))
    return ['gl_Position es 0 en todos sus vértices', '¿Se ha enviado cada matriz, y después de glUseProgram?'];
  if (todos(p => p.join() === puntos[0].join()))
    return ['todos sus vértices caen en el mismo punto', 'Mira la matriz del modelo y el array de posiciones.'];
  if (todos(p => p[3] < 0))
    return ['todos sus vértices están detrás de la cámara (w < 0)',
      'Mira la posición de la cámara y hacia dónde mira.'];
  for (const [eje, lados] of LADOS.entries())
    for (const [lado, dice] of lados.entries())
      if (todos(p => lado ? p[eje] > p[3] : p[eje] < -p[3]))
        return [`todos sus vértices quedan fuera, ${dice}`, eje === 2
          ? 'Mira los planos cerca y lejos de la proyección.'
          : 'Mira la cámara y la matriz del modelo.'];
  return ['ninguna de sus primitivas cubre el centro de un píxel', '¿Son muy pequeñas, o están fuera de la ventana?'];
}

/// Se pregunta mientras se redibuja, y lo que devuelve se llama después: por qué esa orden no dibuja nada.
export function porQueNada(gl, orden) {
  const llevaba = Object.fromEntries(['CULL_FACE', 'SCISSOR_TEST', 'STENCIL_TEST', 'DEPTH_TEST'].map(p => [p,
    gl.isEnabled(gl[p])]));
  const programa = gl.getParameter(gl.CURRENT_PROGRAM), libre = new Gemelo(gl, programa, { frag: SIN_DESCARTAR });
  const llama = cual => nombreDe(gl, gl.getParameter(gl[cual]));
  const pasos = [
    [[], true, null],
    [['CULL_FACE'], true, [`todas sus caras se quitan (${llama('CULL_FACE_MODE')})`,
      'Mira el sentido de sus vértices, glFrontFace y glCullFace.']],
    [['CULL_FACE'], false, ['el shader descarta todos sus fragmentos (discard)', 'Mira de qué condición depende.']],
    [['CULL_FACE', 'SCISSOR_TEST'], false, ['queda toda fuera del recorte (glScissor)',
      'Mira glScissor, o falta glDisable(GL_SCISSOR_TEST).']],
    [['CULL_FACE', 'SCISSOR_TEST', 'STENCIL_TEST'], false, ['ningún fragmento pasa la plantilla',
      'Mira glStencilFunc y qué se ha escrito antes en ella.']],
  ].map(([pruebas, sinDescarte, dice]) => [dice, pregunta(gl, { salvo: pruebas, programa: () => {
    for (const p of pruebas) pon(gl, p, llevaba[p]);
    if (sinDescarte && libre.vale) libre.usa();
    else gl.useProgram(programa);
  } }, orden.hazla)]);
  const ultimo = [`ningún fragmento pasa el test de profundidad (${llama('DEPTH_FUNC')})`,
    'Mira glDepthFunc, glClearDepth y si hay algo delante.'];
  const puntos = posicionesDe(gl, primitivasDe(gl, orden).indices.slice(0, VERTICES));
  libre.borra();
  return async () => {
    const respuestas = [];
    for (const [dice, esta] of pasos) respuestas.push([dice, await responde(gl, esta)]);
    const [que, prueba] = (respuestas.find(([, pasa]) => !pasa) ?? [ultimo])[0] ?? fueraDe(puntos);
    const gravedad = /NaN|gl_Position/.test(que) ? SEGURO : SI_NO_SE_VE_NADA;
    return { gravedad, orden: orden.n, dice: `la orden ${orden.n} no dibuja nada: ${que}`, prueba };
  };
}

/// Las que se dicen, las más graves antes y cada una una vez. `lisa`: si la ventana queda de un color; `figura`: si se
/// ha escrito algo que no sea un rótulo, o no lo había.
export function elegidas(todas, { lisa, figura, escrito }) {
  const lista = lisa && escrito ? [...todas, { gravedad: 0, orden: 0,
    dice: 'se escriben fragmentos y todo queda del mismo color',
    prueba: '¿Es el del fondo el que da el shader? Mira el color y las luces.' }] : todas;
  const sin = dice => dice.replace(/orden \d+/, 'orden'), suyas = new Map(); // la misma en cada orden se dice una vez
  for (const s of lista) {
    const una = suyas.get(sin(s.dice));
    if (!una) suyas.set(sin(s.dice), { ...s, otras: 0 });
    else una.otras += una.dice !== s.dice;
  }
  return [...suyas.values()].filter(({ gravedad }) => lisa || !figura || gravedad >= SEGURO)
    .sort((a, b) => b.gravedad - a.gravedad).map(({ orden, dice, prueba, otras }) =>
      ({ orden, dice: otras ? `${dice}; otras ${otras}, por lo mismo` : dice, prueba }));
}
