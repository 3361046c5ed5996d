// Lo que se descarga según hace falta: datos/NOMBRE.js, que escribe pagina.py y llama a llega(NOMBRE, bytes comprimidos
// en base64). Así también se lee de file://, donde no hay fetch.
import { crea } from '../base/documento.mjs';

const llegados = {};
globalThis.llega = (nombre, base64) => { llegados[nombre] = base64; };

/// Una función que hace cada cosa una vez. Lo que falla se olvida, para poder intentarlo de nuevo.
export function recuerda(hace, hechas = new Map()) {
  return cual => {
    if (!hechas.has(cual)) hechas.set(cual, hace(cual).catch(error => { hechas.delete(cual); throw error; }));
    return hechas.get(cual);
  };
}

const deBase64 = base64 => Uint8Array.from(atob(base64), c => c.charCodeAt(0));

export async function infla(blob) {
  const flujo = blob.stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(flujo).arrayBuffer());
}

export const descomprime = async base64 => infla(new Blob([deBase64(base64)]));

const pide = nombre => new Promise((bien, mal) => {
  const falta = () => mal(new Error(`no se puede leer datos/${nombre}.js`));
  const alCargar = () => llegados[nombre] ? bien() : falta();
  document.head.append(crea('script', { src: `datos/${nombre}.js`, onload: alCargar, onerror: falta }));
});

async function toma(nombre) {
  await pide(nombre);
  const base64 = llegados[nombre];
  delete llegados[nombre];
  return base64;
}

/// Tal como llegan.
export const comprimidos = async nombre => deBase64(await toma(nombre));

export const bytes = recuerda(async nombre => {
  const base64 = await toma(nombre);
  return descomprime(base64).catch(() => { throw new Error(`datos/${nombre}.js está estropeado`); });
});

const enTexto = async nombre => new TextDecoder().decode(await bytes(nombre));
export const json = async nombre => JSON.parse(await enTexto(nombre));
export const ejecuta = js => document.head.append(crea('script', { textContent: js }));

/// El laboratorio, que son lab.js y lab.wasm: define Laboratorio y devuelve el módulo compilado.
export const laboratorio = recuerda(async () => {
  const [modulo] = await Promise.all([bytes('wasm').then(b => WebAssembly.compile(b)), enTexto('js').then(ejecuta)]);
  return modulo;
});
