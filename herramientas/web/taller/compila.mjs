// Compilar y enlazar un programa con el clang de npm. Lo que en todos es igual (cabeceras, objetos) lo tiene en /usr
// (taller.py); los fuentes están en /lab, y lo que se hace, en /obra.
import { Exit, runLLVM } from '@yowasp/clang';

const COMO = `--target=wasm32-unknown-emscripten -DEMSCRIPTEN -D__EMSCRIPTEN_major__=3 -D__EMSCRIPTEN_minor__=1
  -D__EMSCRIPTEN_tiny__=6 -D_LIBCPP_ABI_VERSION=2 -fno-threadsafe-statics -Dunix -D__unix -D__unix__ -nostdinc -nostdinc++
  -fignore-exceptions -O1 -std=c++17 -Wall -Wextra -Wno-pointer-bool-conversion -fno-caret-diagnostics
  -isystem /usr/sis/compat -isystem /usr/sis/c++/v1 -isystem /usr/include -isystem /usr/sis -isystem /usr/gl -I/lab -I/lab/common
  -I/lab/common/encima -DLAB_FUENTES="/lab" -DLAB_GENERADO="/lab"`.split(/\s+/);
// Las que incluyen todos, como en herramientas/cmake/programa.cmake: analizadas una vez.
const PRECOMPILADAS = `GL/glew.h GL/freeglut.h glm/glm.hpp glm/gtc/matrix_transform.hpp glm/gtc/type_ptr.hpp algorithm array
  cmath cstdio cstdlib functional string vector`.split(/\s+/);
const PRE_H = { '/pre.h': PRECOMPILADAS.map(h => `#include <${h}>\n`).join('') };
const EXPORTA = ['main', 'glutOrden', 'glutOpciones', 'glutRedibuja', 'explicaPregunta', 'explicaResponde',
  'explicaCuadroVivo'];
const ENLAZA = `--wrap=glutSwapBuffers --wrap=glutMotionFunc --wrap=glutPassiveMotionFunc --strip-all
  --allow-undefined-file=/obra/da --export=stackSave --export=stackRestore --export=stackAlloc
  --export=__wasm_call_ctors --export=__errno_location --export=malloc --export=free --export=__cxa_is_pointer_type
  --export=__cxa_can_catch --export=setThrew --export-table -z stack-size=5242880 --initial-memory=16777216 --no-entry
  --max-memory=2147483648 --global-base=1024`.split(/\s+/);

let da; // las funciones que el JavaScript da
let objetosHechos = []; // los de main, GLUT y lo demás, los de common/ y los de los controles
let precompilada;
const hechos = new Map(); // de cada orden de compilar, la de clang por dentro

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

async function compila(ruta, fuentes) {
  const capitulo = ruta.split('/')[0];
  const pre = ['-include-pch', '/obra/pre.pch', '-Xclang', '-fno-pch-timestamp', '-Xclang',
    '-fno-validate-pch'];
  const { bien, obra, dicho } = await clang([...COMO, `-I/lab/${capitulo}`, ...pre, '-c', `/lab/${ruta}`, '-o',
    '/obra/salida.o'], { ...fuentes, ...PRE_H, '/obra/pre.pch': precompilada });
  return { objeto: bien && obra['salida.o'], dicho };
}

/// La cabecera precompilada, por la salida: escrita en un fichero, cada trozo lo copia entero.
async function precompila() {
  const { bien, escrito, dicho } = await clang([...COMO, '-x', 'c++-header', '-fpch-instantiate-templates', '-Xclang',
    '-fno-pch-timestamp', '/pre.h', '-o', '-'], PRE_H);
  if (!bien) throw new Error(dicho);
  return new Uint8Array(await new Blob(escrito).arrayBuffer());
}

/// De común/, los que hay que volver a compilar: los cambiados y los que incluyen algo cambiado.
function porCompilar(programa, fuentes, cambiados) {
  const incluidos = ruta => [...fuentes[ruta]?.matchAll(/^#include "(?:.*\/)?(.*)"/gm) ?? []]
    .flatMap(([, nombre]) => Object.keys(fuentes).filter(r => r.endsWith('/' + nombre)));
  const cambia = (ruta, visto = new Set()) => cambiados.includes(ruta) || (!visto.has(ruta) && visto.add(ruta) &&
    incluidos(ruta).some(r => cambia(r, visto)));
  return [programa, ...Object.keys(fuentes).filter(r => /^common\/.*\.cpp$/.test(r) && cambia(r))];
}

/// El programa de esa ruta, con esos fuentes { ruta: texto }, de los que han cambiado algunos: { wasm, si sale; dicho, lo que dicen clang y quien enlaza; tarda, en ms, cada cosa }.
export async function hazlo({ programa, fuentes, cambiados }) {
  const enLab = Object.fromEntries(Object.entries(fuentes).map(([ruta, texto]) => ['/lab/' + ruta, texto]));
  const objetos = {}, tarda = {}, desde = performance.now();
  let dicho = '', falla = false;
  precompilada ??= await precompila();
  tarda.precompila = performance.now() - desde;
  const rutas = porCompilar(programa, fuentes, cambiados);
  for (const ruta of rutas) {
    const suyo = await compila(ruta, enLab);
    dicho += suyo.dicho;
    falla ||= !suyo.objeto;
    objetos[`/obra/${ruta.replaceAll('/', '-')}.o`] = suyo.objeto;
  }
  tarda.compila = performance.now() - desde - tarda.precompila;
  if (falla) return { dicho, tarda };
  const enlazado = await enlaza(programa, objetos, rutas);
  tarda.enlaza = performance.now() - desde - tarda.precompila - tarda.compila;
  return { dicho: dicho + enlazado.dicho, wasm: enlazado.wasm, tarda };
}

async function enlaza(programa, objetos, rutas) {
  const controles = `/usr/obj/controles/${programa.split('/').pop().replace('.cpp', '.o')}`;
  const suyos = objetosHechos.filter(o => o === controles || /obj\/\w+\.o$/.test(o));
  const comun = objetosHechos.filter(o => /obj\/comun/.test(o) && !rutas.some(r => o === `/usr/obj/comun/${r}.o`));
  const { obra, dicho } = await ejecuta(['wasm-ld', '-o', '/obra/salida.wasm', ...suyos, ...Object.keys(objetos),
    '--start-lib', ...comun, '--end-lib', ...ENLAZA, ...EXPORTA.map(f => `--export-if-defined=${f}`)], { ...objetos, '/obra/da': da });
  return { wasm: obra?.['salida.wasm'], dicho };
}

/// Antes de nada: las funciones que da el JavaScript y los objetos que hay.
export function prepara(funciones, objetos) {
  da = funciones.join('\n');
  objetosHechos = objetos;
}
