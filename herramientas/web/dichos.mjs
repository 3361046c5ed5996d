// Lo que dicen clang y quien enlaza, cada cosa en su línea: { ruta, linea, columna, clase, mensaje }, con la ruta desde
// la raíz. La clase: error o aviso.
import { CLANG, enEspanol } from './en_espanol.mjs';

const DICHO = /^(\/\S+?):(\d+):(\d+): (fatal error|error|warning|note): (.*)$/;
const INCLUIDO = /^In file included from (\/lab\/\S+?):(\d+):/;
const CLASES = { 'fatal error': 'error', error: 'error', warning: 'aviso' };
const nuestra = ruta => ruta.startsWith('/lab/') && ruta.slice(5);

/// Donde se llama a eso: en una línea sangrada, que fuera de las funciones se declara.
function dondeSeUsa(nombre, texto) {
  const lineas = texto.split('\n'), usa = RegExp(`\\b${nombre}\\b`);
  const en = lineas.findIndex(l => /^\s/.test(l) && usa.test(l));
  return (en >= 0 ? en : lineas.findIndex(l => usa.test(l))) + 1;
}

function deEnlazar(linea, fuentes) {
  const [, que, simbolo] = linea.match(/(undefined|duplicate) symbol: (.*)/) ?? [];
  if (!que) return { ruta: '', linea: 0, clase: 'error', mensaje: linea.replace(/^wasm-ld: /, '') };
  const nombre = simbolo.match(/(\w+)(?:<.*>)?(?:\(|$)/)?.[1] ?? simbolo;
  const suyo = linea.match(/\/obra\/(\S+?)\.o/)?.[1];
  const rutas = Object.keys(fuentes), enSuyo = rutas.filter(r => !suyo || r.replaceAll('/', '-') === suyo);
  const ruta = [...enSuyo, ...rutas].find(r => dondeSeUsa(nombre, fuentes[r])) ?? enSuyo[0] ?? '';
  const porque = que === 'duplicate' ? 'está dos veces'
    : /^gl[A-Z]/.test(nombre) ? 'no está en WebGL 2, que es lo que hay en un navegador'
    : 'se usa y no está en ningún sitio';
  return { ruta, linea: ruta ? dondeSeUsa(nombre, fuentes[ruta]) : 0, clase: 'error',
    mensaje: `«${nombre}» ${porque} (${que} symbol: ${simbolo})` };
}

/// Los errores y los avisos de lo que se ha dicho. Lo que pasa dentro de una cabecera que no es nuestra es de la línea
/// nuestra que la incluye o que la usa, que se dice antes o después. `fuentes`: { ruta: texto }.
export function leeDicho(dicho, fuentes) {
  const salen = [];
  let incluido;
  for (const linea of dicho.split('\n')) {
    const [, fichero, n, columna, clase, mensaje] = linea.match(DICHO) ?? [];
    const [, desde, enLinea] = linea.match(INCLUIDO) ?? [];
    const ultimo = salen.at(-1);
    if (desde) {
      incluido = { ruta: nuestra(desde), linea: +enLinea };
    } else if (/^wasm-ld: error/.test(linea)) {
      salen.push(deEnlazar(linea, fuentes));
    } else if (clase === 'note') {
      if (ultimo && !ultimo.ruta && nuestra(fichero)) Object.assign(ultimo, { ruta: nuestra(fichero), linea: +n });
    } else if (clase) {
      const sitio = nuestra(fichero) ? { ruta: nuestra(fichero), linea: +n, columna: +columna } : incluido;
      salen.push({ ruta: '', linea: 0, ...sitio, clase: CLASES[clase], mensaje: enEspanol(CLANG, mensaje) });
      incluido = undefined;
    }
  }
  return [...new Map(salen.map(d => [JSON.stringify(d), d])).values()]; // una cabecera se compila en varios fuentes
}
