// Compilar y enlazar un programa con el clang de npm. Lo que en todos es igual (cabeceras, objetos) lo tiene en /usr
// (taller.py); los fuentes están en /lab, y lo que se hace, en /obra.
import { incluidas } from '../fuentes.mjs';
import { Exit, runLLVM } from '@yowasp/clang';

const COMO = `--target=wasm32-unknown-emscripten -DEMSCRIPTEN -D__EMSCRIPTEN_major__=3 -D__EMSCRIPTEN_minor__=1
  -D__EMSCRIPTEN_tiny__=6 -D_LIBCPP_ABI_VERSION=2 -D_LIBCPP_DEBUG=0 -fno-threadsafe-statics -Dunix -D__unix -D__unix__
  -nostdinc -nostdinc++ -fignore-exceptions -O1 -std=c++17 -Wall -Wextra -Wno-pointer-bool-conversion
  -fno-caret-diagnostics -isystem /usr/sis/compat -isystem /usr/sis/c++/v1 -isystem /usr/include -isystem /usr/sis
  -isystem /usr/gl -I/lab -I/lab/common -I/lab/common/encima -DLAB_FUENTES="/lab"
  -DLAB_GENERADO="/lab"`.split(/\s+/);
// Para que un error no pare la página: se mira si un bucle no acaba (glut/sin_ventana/taller_web.cpp), y lo que en C++
// no está definido acaba el programa.
const VIGILADO = `-fno-finite-loops -fsanitize-coverage=trace-pc -mllvm -sanitizer-coverage-prune-blocks=0
  -fsanitize=bounds,return,unreachable,integer-divide-by-zero -fsanitize-trap=all`.split(/\s+/);
// Las que incluyen todos, como en herramientas/cmake/programa.cmake: analizadas una vez.
const PRECOMPILADAS = `GL/glew.h GL/freeglut.h glm/glm.hpp glm/gtc/matrix_transform.hpp glm/gtc/type_ptr.hpp algorithm
  array cmath cstdio cstdlib functional string vector`.split(/\s+/);
const PRE_H = { '/pre.h': PRECOMPILADAS.map(h => `#include <${h}>\n`).join('') };
const EXPORTA = ['main', 'glutOrden', 'glutOpciones', 'glutRedibuja', 'explicaPregunta', 'explicaResponde',
  'explicaCuadroVivo'];
const ENLAZA = `--wrap=glutSwapBuffers --wrap=glutMotionFunc --wrap=glutPassiveMotionFunc
  --allow-undefined-file=/obra/da --export=stackSave --export=stackRestore --export=stackAlloc
  --export=__wasm_call_ctors --export=__errno_location --export=malloc --export=free --export=__cxa_is_pointer_type
  --export=__cxa_can_catch --export=setThrew --export-table -z stack-size=5242880 --initial-memory=16777216 --no-entry
  --max-memory=1073741824 --global-base=1024`.split(/\s+/);

let da; // las funciones que el JavaScript da
let objetosHechos = []; // los de main, GLUT y lo demás, los de common/ y los de los controles
let precompilada; // su promesa
const hechos = new Map(); // de cada orden de compilar, la de clang por dentro

/// Cómo se llama el objeto de un fuente, o del que ya está hecho.
const enObra = ruta => `/obra/${ruta.replace(/^\/usr\/obj\/comun\/|\.o$/g, '').replaceAll('/', '-')}.o`;

function enArbol(ficheros) {
  const raiz = {};
  for (const [ruta, datos] of Object.entries(ficheros)) {
    const partes = ruta.split('/').filter(Boolean), carpeta = partes.slice(0, -1).reduce((c, p) => c[p] ??= {}, raiz);
    carpeta[partes.at(-1)] = datos;
  }
  return raiz;
}

/// Ejecuta uno, con esos ficheros, y da lo que deja en /obra, lo que escribe y lo que dice.
async function ejecuta(orden, ficheros) {
  const escrito = [], dicho = [];
  const a = lista => bytes => { if (bytes) lista.push(bytes.slice()); };
  const como = { stdout: a(escrito), stderr: a(dicho), decodeASCII: false, fetchProgress: () => {} };
  const hecho = { bien: true, escrito, obra: {} };
  try {
    hecho.obra = (await runLLVM(orden, enArbol({ '/obra/.': '', ...ficheros }), como)).obra;
  } catch (error) {
    if (!(error instanceof Exit)) throw error;
    hecho.bien = false;
  }
  return { ...hecho, dicho: await new Blob(dicho).text() };
}

/// Clang es dos: quien lee la orden y quien compila. Al primero solo se le pregunta una vez cada cosa.
async function clang(orden, ficheros) {
  const clave = orden.join(' ');
  if (!hechos.has(clave)) {
    const { dicho } = await ejecuta(['clang++', '-###', ...orden], ficheros);
    const linea = dicho.split('\n').find(l => l.includes('"-cc1"'));
    if (!linea) return { bien: false, dicho };
    const palabras = [...linea.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(m => m[1].replace(/\\(.)/g, '$1'));
    hechos.set(clave, palabras.filter(Boolean)); // la primera, la ruta de clang, no la hay
  }
  return ejecuta(hechos.get(clave), ficheros);
}

async function compila(ruta, fuentes, ...mas) {
  const carpeta = ruta.replace(/\/[^/]*$/, '');
  const pre = ['-include-pch', '/obra/pre.pch', '-Xclang', '-fno-pch-timestamp', '-Xclang',
    '-fno-validate-pch'];
  const { bien, obra, dicho } = await clang([...COMO, ...VIGILADO, `-I/lab/${carpeta}`, ...mas, ...pre, '-c',
    `/lab/${ruta}`, '-o', '/obra/salida.o'], { ...fuentes, ...PRE_H, '/obra/pre.pch': await precompilada });
  return { objeto: bien && obra['salida.o'], dicho };
}

/// La cabecera precompilada, por la salida: escrita en un fichero, cada trozo lo copia entero.
async function precompila() {
  const { bien, escrito, dicho } = await clang([...COMO, '-x', 'c++-header', '-fpch-instantiate-templates', '-Xclang',
    '-fno-pch-timestamp', '/pre.h', '-o', '-'], PRE_H);
  if (!bien) throw new Error(dicho);
  return new Uint8Array(await new Blob(escrito).arrayBuffer());
}

/// El programa, los demás de la carpeta de un ejercicio y, de common/, los que hay que volver a compilar: los cambiados
/// y los que incluyen algo cambiado.
function porCompilar(programa, fuentes, cambiados) {
  const cambia = ruta => [ruta, ...incluidas(ruta, fuentes)].some(r => cambiados.includes(r));
  const hayQue = ruta => /^mios\/.*\.cpp$/.test(ruta) || /^common\/.*\.cpp$/.test(ruta) && cambia(ruta);
  return [...new Set([programa, ...Object.keys(fuentes).filter(hayQue)])];
}

async function enlaza(programa, objetos, ...mas) {
  const controles = `/usr/obj/controles/${programa.split('/').pop().replace('.cpp', '.o')}`;
  const suyos = objetosHechos.filter(o => o === controles || /obj\/\w+\.o$/.test(o));
  const comun = objetosHechos.filter(o => /obj\/comun/.test(o) && !(enObra(o) in objetos));
  const { obra, dicho } = await ejecuta(['wasm-ld', '-o', '/obra/salida.wasm', ...suyos, ...Object.keys(objetos),
    '--start-lib', ...comun, '--end-lib', ...ENLAZA, ...EXPORTA.map(f => `--export-if-defined=${f}`), ...mas],
  { ...objetos, '/obra/da': da });
  return { wasm: obra['salida.wasm'], dicho };
}

/// Cada ruta con esas opciones, y enlazadas con esas otras. Sin acabar, si algo no compila.
async function haz(rutas, fuentes, alCompilar = [], alEnlazar = []) {
  const objetos = {}, desde = performance.now();
  let dicho = '', falla = false;
  for (const ruta of rutas) {
    const suyo = await compila(ruta, fuentes, ...alCompilar);
    dicho += suyo.dicho;
    falla ||= !suyo.objeto;
    objetos[enObra(ruta)] = suyo.objeto;
  }
  const tarda = { compila: performance.now() - desde };
  if (falla) return { dicho, tarda };
  const enlazado = await enlaza(rutas[0], objetos, ...alEnlazar);
  tarda.enlaza = performance.now() - desde - tarda.compila;
  return { dicho: dicho + enlazado.dicho, wasm: enlazado.wasm, tarda };
}

/// Lo que se hace una vez, antes del primero.
export async function adelanta() { await (precompilada ??= precompila()); }

let ultimo; // las rutas, los fuentes y las opciones del último

/// El programa de esa ruta, con esos fuentes { ruta: texto }, de los que han cambiado algunos: { wasm, si sale; dicho,
/// lo que dicen clang y quien enlaza; tarda, en ms, cada cosa }.
export async function hazlo({ programa, fuentes, cambiados, capitulo }) {
  const enLab = Object.fromEntries(Object.entries(fuentes).map(([ruta, texto]) => ['/lab/' + ruta, texto]));
  const desde = performance.now();
  await adelanta();
  const precompilado = performance.now() - desde;
  ultimo = [porCompilar(programa, fuentes, cambiados), enLab, [`-I/lab/${capitulo}`]];
  const hecho = await haz(...ultimo, ['--strip-all']);
  return { ...hecho, tarda: { precompila: precompilado, ...hecho.tarda } };
}

/// De los sitios del último wasm, desde dentro hacia fuera, el primero que es de un fuente: { ruta, linea }. Se vuelve
/// a hacer, igual y con sus líneas.
export async function busca({ sitios }) {
  const [rutas, fuentes, como] = ultimo, { wasm } = await haz(rutas, fuentes, [...como, '-gline-tables-only']);
  let codigo = 8; // donde empieza, que es desde donde cuentan las líneas
  for (let seccion = 0, largo = 0; seccion !== 10; codigo += seccion === 10 ? 0 : largo) {
    seccion = wasm[codigo++];
    largo = 0;
    for (let i = 0, b = 128; b & 128; i += 7) {
      b = wasm[codigo++];
      largo |= (b & 127) << i;
    }
  }
  const desdeCodigo = sitios.map(s => `0x${(s - codigo).toString(16)}`);
  const { escrito } = await ejecuta(['addr2line', '-i', '-e', '/obra/salida.wasm', ...desdeCodigo],
    { '/obra/salida.wasm': wasm });
  const [, ruta, linea] = (await new Blob(escrito).text()).match(/^\/lab\/(\S+?):(\d+)/m) ?? [];
  return { ruta, linea: Number(linea) };
}

/// Antes de nada: las funciones que da el JavaScript y los objetos que hay.
export function prepara(funciones, objetos) {
  da = funciones.join('\n');
  objetosHechos = objetos;
}
