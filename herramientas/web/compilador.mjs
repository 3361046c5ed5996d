// Compilar en la página: traer el compilador la primera vez, con su barra, guardarlo en el navegador y pedir cada
// programa al worker que lo tiene (taller/obrero.mjs). Lo que hace falta lo escribe taller.py.
import { una } from '../base/documento.mjs';
import { comprimidos, ejecuta, infla } from './datos.mjs';
import { leeDicho } from './dichos.mjs';

const datos = JSON.parse(una('#taller')?.textContent ?? 'null');
export const SE_COMPILA = Boolean(datos);
const MB = bytes => (bytes / 1e6).toLocaleString('es', { maximumFractionDigits: 1, minimumFractionDigits: 1 });
export const cuantoPesa = () => `${MB(datos.bytes)} MB`;

/// La base de datos del navegador, donde está lo que se trajo otra vez; en file:// está en el disco.
const abreBase = () => new Promise((bien, mal) => {
  const pide = indexedDB.open('taller', 1);
  pide.onupgradeneeded = () => pide.result.createObjectStore('traido');
  pide.onsuccess = () => bien(pide.result);
  pide.onerror = () => mal(pide.error);
});

/// Lo guardado con esa versión o, con `blobs`, lo guarda y olvida lo de antes. Nada si el navegador no deja.
async function recordado(blobs) {
  if (!location.protocol.startsWith('http')) return undefined;
  try {
    const base = await abreBase(), en = base.transaction('traido', 'readwrite').objectStore('traido');
    if (blobs) {
      en.clear();
      en.put(blobs, datos.version);
      return blobs;
    }
    return await new Promise((bien, mal) => {
      const pide = en.get(datos.version);
      pide.onsuccess = () => bien(pide.result);
      pide.onerror = () => mal(pide.error);
    });
  } catch {
    return undefined;
  }
}

/// Cada fichero, comprimido. `avanza(bytes, de)`; si `senal` se corta, un AbortError.
async function trae(avanza, senal) {
  const ya = await recordado();
  if (ya) return ya;
  const blobs = {};
  let bytes = 0;
  for (const nombre of datos.ficheros) {
    avanza(bytes, datos.bytes);
    senal.throwIfAborted();
    const suyos = await comprimidos(nombre);
    bytes += suyos.length;
    blobs[nombre] = new Blob([suyos]);
  }
  senal.throwIfAborted();
  return await recordado(blobs) ?? blobs;
}

export class Compilador {
  #obrero;
  #pedidos = 0;
  #esperan = new Map();

  get listo() { return Boolean(this.#obrero); }

  /// Lo deja listo. Lo traído se queda en el worker.
  async prepara(avanza, senal) {
    if (this.listo) return;
    const { taller, 'taller-arbol': arbol, ...blobs } = await trae(avanza, senal);
    const { obrero, programa, ...suyo } = JSON.parse(new TextDecoder().decode(await infla(taller)));
    ejecuta(programa); // define LaboratorioDelTaller
    const worker = new Worker(URL.createObjectURL(new Blob([obrero], { type: 'text/javascript' })));
    worker.onmessage = ({ data }) => {
      this.#esperan.get(data.n)?.(data);
      this.#esperan.delete(data.n);
    };
    const compilador = new Blob(datos.ficheros.filter(n => /^taller-\d/.test(n)).map(n => blobs[n]));
    worker.postMessage({ trae: { ...suyo,
      blobs: { ...blobs, 'llvm.core.wasm': compilador, 'llvm-resources.tar': arbol } } });
    this.#obrero = worker;
  }

  #pide(pedido) {
    const n = ++this.#pedidos;
    return new Promise((bien, mal) => {
      this.#esperan.set(n, hecho => hecho.error ? mal(new Error(hecho.error)) : bien(hecho));
      this.#obrero.postMessage({ n, ...pedido });
    });
  }

  /// Lo que se hace una vez, antes del primero.
  adelanta() { return this.#pide({ adelanta: true }); }

  /// El programa con esos fuentes { ruta: texto }, de los que algunos han cambiado: { modulo, si sale; dichos }. El de
  /// un ejercicio está en su carpeta, y usa también las cabeceras de su capítulo.
  async compila({ nombre, capitulo, carpeta = capitulo }, fuentes, cambiados) {
    const programa = `${carpeta}/${nombre}.cpp`;
    const { dicho, wasm, tarda } = await this.#pide({ programa, fuentes, cambiados, capitulo });
    return { modulo: wasm && await WebAssembly.compile(wasm), dichos: leeDicho(dicho, fuentes), tarda };
  }

  /// Donde ha fallado el último que se ha compilado: { ruta, linea }, si se sabe.
  busca(error) {
    const sitios = [...String(error?.stack).matchAll(/wasm-function\[\d+\]:(0x[\da-f]+)/g)].map(([, s]) => Number(s));
    return sitios.length ? this.#pide({ sitios: sitios.slice(0, 40) }) : {};
  }
}
