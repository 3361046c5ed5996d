// Buscar en el índice que hace base/indice.py, sin tocar el documento.

/// Lo que vale una palabra según dónde está.
const VALE = { capítulo: 12, nombre: 11, título: 10, libro: 9, imagen: 5, enunciado: 4, explicación: 4, respuesta: 3,
  teclas: 3, errata: 3, fuente: 2 };
const CLASES = { lis: 'l', eje: 'e', fig: 'f', tab: 't', ecu: 'ec', apa: '§', sec: '§', cap: 'cap', tem: 'cap' };
const REFERENCIA = RegExp(`(?<!\\p{L})(${Object.keys(CLASES).join('|')})\\p{L}*\\.? ?(?=\\d)`, 'gu');

const sinAcentos = texto => texto.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase();

/// Sin acentos ni mayúsculas, y las referencias, como se abrevian: «Listado 5.1» es l5.1 y «fig. 3.3», f3.3.
export const llano = texto => sinAcentos(texto).replaceAll('×', 'x').replace(REFERENCIA, (_, clase) => CLASES[clase]);

/// Un punto solo es de una palabra entre cifras.
export const palabras = texto => llano(texto).match(/§?[\p{L}\p{N}_]+(?:\.\d+)*/gu) ?? [];

/// Lo que se quita de una palabra para que case con otra de su familia: seleccionar, selección.
const FINAL = /(ar|er|ir|ando|iendo|ado|ada|cion|os|as|es|o|a)$/;

/// Cuánto casa con una palabra cada una que haya, de 0 a 1; un plural, también con su singular.
function casaCon(buscada) {
  const larga = buscada.length > 4, singular = buscada.replace(/e?s$/, ''), raiz = buscada.replace(FINAL, '');
  return hay => {
    if (hay.startsWith(buscada)) return hay === buscada ? 1 : 0.7;
    if (larga && hay.startsWith(singular)) return 0.6;
    if (buscada.length > 2 && hay.includes(buscada)) return 0.4;
    return raiz.length > 4 && hay.startsWith(raiz) ? 0.3 : 0;
  };
}

export class Indice {
  #entradas;
  #vocabulario;
  #sinonimos;

  /// `datos` son los que escribe base/indice.py.
  constructor({ entradas, ficheros, sinonimos }) {
    const zona = (clase, enlace, texto, vale, suyas) => ({ clase, enlace, texto, vale, palabras: suyas });
    const deFichero = Object.fromEntries(Object.entries(ficheros).map(([ruta, texto]) =>
      [ruta, new Map(texto.split(' ').map(identificador => [llano(identificador), identificador]))]));
    this.#sinonimos = new Map(Object.entries(sinonimos).map(par => par.map(llano)));
    this.#entradas = entradas.map(({ titulo, zonas, fuentes }) => ({ titulo, zonas: [
      ...zonas.map(([clase, enlace, texto]) => zona(clase, enlace, texto, VALE[clase], new Set(palabras(texto)))),
      // el propio vale más que los que incluye
      ...fuentes.map((ruta, i) => zona('fuente', zonas[0][1], ruta, VALE.fuente / (1 + i / 4), deFichero[ruta])),
    ] }));
    this.#vocabulario = new Set(this.#entradas.flatMap(e => e.zonas.flatMap(z => [...z.palabras.keys()])));
  }

  /// Las palabras que casan con una, o con la que significa lo mismo, y cuánto.
  #casan(buscada) {
    const variantes = [buscada, this.#sinonimos.get(buscada)].filter(Boolean).map(casaCon), casan = new Map();
    for (const hay of this.#vocabulario) {
      const cuanto = Math.max(...variantes.map(casa => casa(hay)));
      if (cuanto) casan.set(hay, cuanto);
    }
    return casan;
  }

  /// Lo que tiene todas las palabras, de mejor a peor: { titulo, enlace, clase, texto, palabra }, con la zona en que
  /// mejor está lo buscado y, si es un fuente, el identificador.
  busca(buscado) {
    const suyas = palabras(buscado).map(palabra => this.#casan(palabra)), entero = palabras(buscado).join(' ');
    if (!suyas.length) return [];
    return this.#entradas.map(entrada => this.#mide(entrada, suyas, entero)).filter(Boolean)
      .sort((a, b) => b.vale - a.vale);
  }

  /// De cada palabra vale la zona en que mejor está, y algo las demás; y más, si lo buscado es el título entero.
  #mide({ titulo, zonas }, suyas, entero) {
    const mejor = ({ palabras: hay }, casan) => {
      let maximo = 0;
      for (const palabra of hay.keys()) maximo = Math.max(maximo, casan.get(palabra) ?? 0);
      return maximo;
    };
    const de = zonas.map(z => suyas.map(casan => z.vale * mejor(z, casan)));
    const deCada = suyas.map((_, i) => de.map(valen => valen[i]));
    if (deCada.some(valen => !Math.max(...valen))) return;
    const suma = numeros => numeros.reduce((a, b) => a + b, 0), deZona = de.map(suma);
    const { enlace, clase, texto, palabras: hay } = zonas[deZona.indexOf(Math.max(...deZona))];
    const casaEn = palabra => Math.max(...suyas.map(casan => casan.get(palabra) ?? 0));
    const palabra = [...hay.keys()].reduce((a, b) => casaEn(b) > casaEn(a) ? b : a);
    const vale = suma(deCada.map(valen => Math.max(...valen) + 0.05 * suma(valen)));
    return { titulo, enlace, clase, texto, palabra: hay.get?.(palabra) ?? '',
      vale: vale + (palabras(titulo).join(' ') === entero ? VALE.título : 0) };
  }
}

/// El trozo de un texto en que está lo buscado, o alguna de sus palabras: lo de antes, lo hallado y lo que sigue.
export function trozo(texto, buscado, letras = 90) {
  const plano = sinAcentos(texto), agujas = [buscado.trim(), ...buscado.split(/\s+/)].map(sinAcentos);
  const aguja = agujas.find(a => a && plano.includes(a)) ?? '', lugar = Math.max(0, plano.indexOf(aguja));
  const desde = Math.max(0, Math.min(lugar - Math.round(letras / 3), texto.length - letras));
  const fin = lugar + aguja.length, hasta = Math.max(fin, desde + letras);
  return [(desde ? '…' : '') + texto.slice(desde, lugar), texto.slice(lugar, fin),
    texto.slice(fin, hasta) + (hasta < texto.length ? '…' : '')];
}
