// Cargar un programa y hacerlo andar: una instancia de lab.js.
import { bytes, json, laboratorio } from './datos.mjs';

/// Las de WebGL 2 que nadie ha usado al hacer la página están solo con su otro nombre. Una excepción, que en JavaScript
/// es un número, dice por dónde se ha llegado a ella.
function ponTodas(funciones, alLanzar) {
  const lanza = funciones.__cxa_throw;
  funciones.__cxa_throw = (...que) => {
    alLanzar(new Error('excepción'));
    lanza(...que);
  };
  for (const [nombre, suya] of Object.entries(funciones))
    if (nombre.startsWith('emscripten_gl')) funciones[nombre.slice(11)] ??= suya;
}

/// La llamada de OpenGL que da un error acaba ahí. Cuál es ya lo ha dicho el programa.
function vigila(funciones) {
  const pregunta = funciones.glGetError ?? funciones.emscripten_glGetError;
  for (const [nombre, suya] of Object.entries(funciones)) {
    const [, llamada] = nombre.match(/^(?:emscripten_)?(gl[A-Z]\w+)$/) ?? [];
    if (llamada && llamada !== 'glGetError') funciones[nombre] = (...que) => {
      const hecho = suya(...que);
      if (pregunta()) throw Object.assign(new Error(`${llamada} da un error`), { name: 'OpenGL' });
      return hecho;
    };
  }
}

// De lo que puede hacer mal un programa compilado en la página, qué se dice. Los demás motivos son suyos.
const MOTIVOS = [
  [/no acaba/, 'no acaba: lleva unos segundos en lo mismo. ¿Un bucle sin fin?'],
  [/call stack|recursion/, 'una función se llama a sí misma sin parar, y se ha llenado la pila.'],
  [/divi(de|sion) by zero/, 'divide un entero entre cero.'],
  [/unreachable/, 'un índice se sale de su array, se divide entre cero o una función que da algo acaba sin return.'],
  [/out of bounds/, 'se lee o se escribe donde no hay nada: un puntero nulo o un índice que se sale.'],
  [/Cannot enlarge|OOM|bad_alloc/, 'se ha acabado la memoria.'],
  [/Aborted/, 'ha terminado con abort: mira lo que ha escrito.'],
  [/excepción/, 'ha lanzado una excepción: .at() que se sale, std::stoi de lo que no es un número, falta memoria…'],
];
const SE_ESPERA = 4000; // ms, a lo que hace con una orden

/// Los ms que se espera a un guion: lo de cada orden y cuatro veces el tiempo que pasa en él.
const espera = guion => guion.split(';').reduce((ms, orden) => {
  const [, pasan = 0] = orden.match(/espera (\d+)/) ?? [], [, veces = 1] = orden.match(/×(\d+)/) ?? [];
  return ms + veces * (SE_ESPERA + 4 * pasan);
}, 0);

/// Lo que se dice de un error de los que acaban un programa.
export const motivoDe = error =>
  MOTIVOS.find(([que]) => que.test(String(error?.message ?? error)))?.[1] ?? String(error);

/// Arranca un programa en un lienzo. `titulo(texto)` recibe el de la ventana; `ficheros` son los que se le dan además
/// de los del laboratorio; `textos`, los que no son los originales (sin texto, los que no están); `raices`, dónde los
/// busca antes; `compilado`, el módulo del que se ha compilado en la página, si no es el original; `argumentos` y
/// `entorno`, los suyos; `vigilado`, si acaba en la llamada de OpenGL que da un error. De lo que escribe, `di(línea,
/// si es un error)`. Devuelve lo que se puede hacer con él.
export async function arranca(programa, { lienzo, ancho, alto, textos = {}, ficheros = {}, suavizado = true, compilado,
  raices = programa.raices, argumentos = [], entorno = {}, vigilado, di = () => {}, titulo = () => {} }) {
  const [modulo, shaders, suyos] =
    await Promise.all([compilado ?? laboratorio(), json('shaders'), textos, ...programa.texturas.map(bytes)]);
  let lanzada;
  const lab = await (compilado ? LaboratorioDelTaller : Laboratorio)({
    canvas: lienzo, suavizado, thisProgram: programa.nombre, print: linea => di(linea), titulo,
    printErr: linea => di(linea, true),
    preRun: ({ ENV }) => Object.assign(ENV, entorno, raices.length && { LAB_RAIZ: raices.join(':') }),
    instantiateWasm: (lo, recibe) => {
      if (compilado) ponTodas(lo.env, error => { lanzada = error; });
      if (vigilado) vigila(lo.env);
      WebAssembly.instantiate(modulo, lo).then(recibe);
      return {};
    },
  });
  const escribe = (ruta, datos) => {
    lab.FS.mkdirTree(ruta.replace(/\/[^/]*$/, ''));
    lab.FS.writeFile(ruta, datos);
  };
  for (const [ruta, texto] of Object.entries({ ...shaders, ...suyos }))
    if (texto !== undefined) escribe('/lab/' + ruta, texto);
  for (const t of programa.texturas) escribe(`/lab/assets/${t}`, await bytes(t));
  for (const [ruta, datos] of Object.entries(ficheros)) escribe(ruta, datos);
  const leidos = new Set(), abre = lab.FS.open;
  lab.FS.open = (ruta, ...resto) => { leidos.add(String(ruta)); return abre(ruta, ...resto); };

  if (compilado) Error.stackTraceLimit = 50; // para saber desde qué línea suya se ha llegado a lo que falla
  const da = (hace, guion = '') => {
    lab.hasta = performance.now() + espera(guion);
    try {
      return hace();
    } catch (error) {
      throw typeof error === 'number' ? lanzada ?? error : error;
    }
  };
  let estado = da(() => lab.callMain(['-geometry', `${ancho}x${alto}`, ...argumentos, ...Object.keys(ficheros)])) || 0;
  return {
    lienzo, leidos,
    get vivo() { return !estado; },
    get fallo() { return estado > 0; }, // −1: ha terminado bien
    get estado() { return estado; },
    escribe: (ruta, texto) => escribe('/lab/' + ruta, texto),
    lee: ruta => lab.FS.readFile(ruta),
    /// Un trozo de guion. Si el programa termina, deja de estar vivo.
    orden(texto) {
      if (estado) return;
      try {
        if (da(() => lab.ccall('glutOrden', 'number', ['string'], [texto]), texto)) estado = -1;
      } catch (error) {
        if (error.name !== 'ExitStatus') {
          di(compilado ? motivoDe(error) : String(error));
          this.error = error;
        }
        estado = error.status || 1;
      }
    },
    opciones: () => estado ? [] : lab.ccall('glutOpciones', 'string').split('\n').filter(Boolean),
    redibuja: () => da(() => lab.ccall('glutRedibuja')), // el mismo cuadro
    acabaDeDibujar: () => lienzo.getContext('webgl2')?.readPixels(0, 0, 1, 1, 0x1908, 0x1401, new Uint8Array(4)),
    /// El cuadro que se ve, explicado, y, si se da, ese píxel suyo: herramientas/explica/cuadro.h.
    async explica([x, y] = [-1, -1]) {
      lab.hasta = Infinity; // lo dibuja muchas veces, y ya se ha visto que acaba
      lab.ccall('explicaPregunta');
      while (!estado && !lab.ccall('explicaResponde')) await new Promise(sigue => setTimeout(sigue));
      if (estado) throw new Error('el programa ha terminado'); // y no respondería nunca
      const medidas = [lienzo.width, lienzo.height, x, y];
      return JSON.parse(lab.ccall('explicaCuadroVivo', 'string', medidas.map(() => 'number'), medidas));
    },
    cierra() {
      estado ||= -1;
      lienzo.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext(); // solo puede haber 16 vivos
      lienzo.remove();
    },
  };
}
