// Las órdenes que escriben píxeles: lo que se ha llamado, con qué estado, y de dónde le llega lo que dibuja.
import { estadoActual, nombreDe, nombreModo, ORDENES, deVerdad, pruebasActuales, tipoDe } from './estado.mjs';
import { atados, atributosDe, enviados, uniformsDe } from './gemelo.mjs';
import { sueltas } from './primitivas.mjs';

const BUFERES = [['COLOR', 'color'], ['DEPTH', 'profundidad'], ['STENCIL', 'plantilla']];
const QUE_ES = ['', 'punto', 'segmento', 'triángulo'];

/// Mientras se redibuja, cada orden que llega pasa por `llega({ n, f, datos, hazla })`.
export function interpone(gl, redibuja, llega) {
  const verdad = deVerdad(gl);
  let n = 0;
  for (const f of ORDENES) gl[f] = (...datos) => llega({ n: ++n, f, datos, hazla: () => verdad[f](...datos) });
  try {
    redibuja();
  } finally {
    for (const f of ORDENES) delete gl[f];
  }
}

export const dibuja = ({ f }) => f.startsWith('draw');
export const buferesDe = ({ f, datos }) => datos[f === 'clear' ? 0 : 8];
export const vaciada = gl => gl.isEnabled(gl.RASTERIZER_DISCARD) || gl.getParameter(gl.TRANSFORM_FEEDBACK_ACTIVE);

/// Los vértices de una orden, por sus números, en primitivas sueltas: { suelto, cada, indices, tipo }.
export function primitivasDe(gl, { f, datos: [modo, ...resto] }) {
  let vertices;
  if (f === 'drawArrays') {
    vertices = Uint32Array.from({ length: resto[1] }, (_, i) => resto[0] + i);
  } else {
    const [n, tipo, desde] = resto;
    vertices = new ({ [gl.UNSIGNED_BYTE]: Uint8Array, [gl.UNSIGNED_SHORT]: Uint16Array }[tipo] ?? Uint32Array)(n);
    gl.getBufferSubData(gl.ELEMENT_ARRAY_BUFFER, desde, vertices);
  }
  const hechas = sueltas(modo, vertices);
  return { ...hechas, tipo: QUE_ES[hechas.cada], cuantas: hechas.indices.length / hechas.cada };
}

function llamada(gl, { f, datos }) {
  const buferes = cuales => BUFERES.filter(([b]) => cuales & gl[`${b}_BUFFER_BIT`]).map(([b]) => `GL_${b}_BUFFER_BIT`);
  if (f === 'clear') return `glClear(${buferes(datos[0]).join(' | ')})`;
  if (f === 'blitFramebuffer')
    return `glBlitFramebuffer(${datos.slice(0, 8).join(', ')}, ${buferes(datos[8]).join(' | ')}, ` +
      `${nombreDe(gl, datos[9])})`;
  const [modo, ...resto] = datos;
  if (f === 'drawElements') resto[1] = nombreDe(gl, resto[1]);
  return `gl${f[0].toUpperCase()}${f.slice(1)}(${[nombreModo(modo), ...resto].join(', ')})`;
}

function titulo(gl, orden) {
  if (orden.f === 'blitFramebuffer') return 'copia de un framebuffer';
  if (orden.f === 'clear')
    return `borra ${BUFERES.filter(([b]) => orden.datos[0] & gl[`${b}_BUFFER_BIT`]).map(([, que]) => que).join(', ')}`;
  const { cuantas, tipo } = primitivasDe(gl, orden);
  return `${cuantas} ${tipo}${cuantas === 1 ? '' : 's'}`;
}

/// Lo mismo que de ella dice herramientas/explica/ordenes.cpp.
export function describe(gl, orden) {
  const marco = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING), [, , ancho, alto] = gl.getParameter(gl.VIEWPORT);
  const talla = marco ? [ancho, alto] : [gl.drawingBufferWidth, gl.drawingBufferHeight];
  return {
    n: orden.n, llamada: llamada(gl, orden), titulo: titulo(gl, orden), pruebas: pruebasActuales(gl, dibuja(orden)),
    framebuffer: marco ? `framebuffer ${marco.name}, de ${ancho}×${alto}` : 'la ventana', talla,
    ...dibuja(orden) ? { estado: estadoActual(gl), programa: gl.getParameter(gl.CURRENT_PROGRAM)?.name }
      : { estado: [] },
  };
}

// --- el cableado ----------------------------------------------------------------------------------------------------

/// Los uniforms a que se ha dado valor, que WebGL no lo dice: se apunta desde que se abre la página.
const sitios = new WeakMap(); // de cada sitio, su programa y su nombre
const dados = new WeakMap();  // de cada programa, sus nombres
let preguntado = {};          // el último uniform que no está por el que pregunta un programa, por sus nombres

export const faltaUniform = (programa, nombre) => { preguntado = { programa, nombre }; };

/// Una copia de los números que se dan, que Emscripten los da como un trozo de toda su memoria.
function copia(datos) {
  const i = datos.findIndex(ArrayBuffer.isView), [desde = 0, n = Infinity] = datos.slice(i + 1);
  return i < 0 ? datos : [...datos.slice(0, i), datos[i].slice(desde, desde + n)];
}

export function apuntaUniforms({ prototype }) {
  const tapa = (nombre, antes) => {
    const deVerdad = prototype[nombre];
    prototype[nombre] = function (...datos) {
      const sale = deVerdad.apply(this, datos);
      antes(datos, sale, this);
      return sale;
    };
  };
  const en = (mapa, programa, vacio) => mapa.get(programa) ?? mapa.set(programa, vacio).get(programa);
  for (const f of Object.getOwnPropertyNames(prototype).filter(n => /^uniform(Matrix)?\d/.test(n)))
    tapa(f, ([sitio, ...datos], _, gl) => {
      const { programa, nombre } = sitios.get(sitio) ?? {}, falta = preguntado;
      preguntado = {};
      if (programa) return en(dados, programa, new Set()).add(nombre);
      const actual = falta.nombre && gl.getParameter(gl.CURRENT_PROGRAM);
      if (!actual || actual.name !== falta.programa) return;
      en(enviados, actual, new Map()).set(falta.nombre, [f, ...copia(datos)]);
    });
  tapa('getUniformLocation', ([programa, nombre], sitio) => { if (sitio) sitios.set(sitio, { programa, nombre }); });
  tapa('bindAttribLocation', ([programa, donde, nombre]) => en(atados, programa, new Map()).set(nombre, donde));
  tapa('linkProgram', ([programa]) => { // vuelven a valer 0
    dados.delete(programa);
    enviados.delete(programa);
  });
}

function dado(programa, nombre) {
  const suyos = dados.get(programa), lista = nombre.replace(/\[\d+\]$/, '');
  return Boolean(suyos && (suyos.has(nombre) || nombre !== lista && (suyos.has(lista) || suyos.has(`${lista}[0]`))));
}

const PRIMEROS = 3;

function atributo(gl, { nombre, tipo, donde }) {
  const de = cual => gl.getVertexAttrib(donde, gl[`VERTEX_ATTRIB_ARRAY_${cual}`]);
  const bufer = de('BUFFER_BINDING'), componentes = de('SIZE'), paso = de('STRIDE'), primeros = [];
  const desplazamiento = gl.getVertexAttribOffset(donde, gl.VERTEX_ATTRIB_ARRAY_POINTER);
  if (de('ENABLED') && bufer && de('TYPE') === gl.FLOAT) {
    const estaba = gl.getParameter(gl.COPY_READ_BUFFER_BINDING);
    gl.bindBuffer(gl.COPY_READ_BUFFER, bufer);
    const bytes = gl.getBufferParameter(gl.COPY_READ_BUFFER, gl.BUFFER_SIZE);
    for (let i = 0; i < PRIMEROS; ++i) {
      const desde = desplazamiento + i * (paso || 4 * componentes), valor = new Float32Array(componentes);
      if (desde + valor.byteLength > bytes) break;
      gl.getBufferSubData(gl.COPY_READ_BUFFER, desde, valor);
      primeros.push([...valor]);
    }
    gl.bindBuffer(gl.COPY_READ_BUFFER, estaba);
  }
  return { nombre, tipo: tipoDe(gl, tipo), activo: de('ENABLED'), bufer: bufer?.name ?? 0, componentes,
    de: nombreDe(gl, de('TYPE')), paso, desplazamiento, primeros };
}

const ENLAZADAS = { sampler2D: '2D', sampler2DShadow: '2D', usampler2D: '2D', sampler3D: '3D',
  samplerCube: 'CUBE_MAP' };

function textura(gl, programa, { nombre, tipo, donde }) {
  const objetivo = ENLAZADAS[tipoDe(gl, tipo)], unidad = gl.getUniform(programa, donde);
  const activa = gl.getParameter(gl.ACTIVE_TEXTURE), de = cual => nombreDe(gl,
    gl.getTexParameter(gl[`TEXTURE_${objetivo}`], gl[`TEXTURE_${cual}`]));
  gl.activeTexture(gl.TEXTURE0 + unidad);
  const hay = gl.getParameter(gl[`TEXTURE_BINDING_${objetivo}`]);
  const datos = { sampler: nombre, unidad, textura: hay?.name ?? 0, objetivo: `GL_TEXTURE_${objetivo}`, talla: [],
    formato: '',
    incompleta: hay ? '' : 'no hay ninguna en esa unidad',
    ...hay ? { reduce: de('MIN_FILTER'), amplia: de('MAG_FILTER'), repite: `${de('WRAP_S')}, ${de('WRAP_T')}` }
      : { reduce: '', amplia: '', repite: '' } };
  gl.activeTexture(activa);
  return datos;
}

const lista = valor => typeof valor === 'object' ? [...valor].map(Number) : [Number(valor)];

/// De dónde le llega a la orden lo que dibuja, como lo dice herramientas/explica/cableado.cpp. De una textura, WebGL no
/// dice su tamaño ni su formato.
export function cableadoDe(gl) {
  const programa = gl.getParameter(gl.CURRENT_PROGRAM);
  const uniforms = uniformsDe(gl, programa), nombreDeBufer = cual => gl.getParameter(gl[cual])?.name ?? 0;
  return {
    indices: nombreDeBufer('ELEMENT_ARRAY_BUFFER_BINDING'), vao: nombreDeBufer('VERTEX_ARRAY_BINDING'),
    atributos: atributosDe(gl, programa).map(a => atributo(gl, a)),
    uniformes: uniforms.map(({ nombre, tipo, donde }) => ({ nombre, tipo: tipoDe(gl, tipo),
      valor: lista(gl.getUniform(programa, donde)), dado: dado(programa, nombre) })),
    texturas: uniforms.filter(u => tipoDe(gl, u.tipo) in ENLAZADAS).map(u => textura(gl, programa, u)),
  };
}
