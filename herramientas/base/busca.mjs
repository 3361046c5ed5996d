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

/// Las que están en todas partes y no dicen qué se busca («girar la cámara»); «a» e «y» no: son teclas y ejes.
const VACIAS = new Set('al como con de del el en es la las lo los para por que se un una'.split(' '));

/// Sin ellas, si hay otras.
function llenas(suyas) {
  const dicen = suyas.filter(palabra => !VACIAS.has(palabra));
  return dicen.length ? dicen : suyas;
}

/// Lo que se quita de una palabra para que case con otra de su familia: seleccionar, selección.
const FINAL = /(ar|er|ir|an|en|ando|iendo|ado|ada|cion|os|as|es|o|a)$/;

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

/// Cómo suena, para quien lo ha oído y no sabe cómo se escribe: «fong» es Phong y «bécier», Bézier.
const suena = palabra => palabra.replace(/ph/g, 'f').replace(/[cz](?=[ei])|z/g, 's').replace(/qu|ck|c/g, 'k')
  .replace(/v/g, 'b').replace(/y/g, 'i').replace(/h/g, '').replace(/(.)\1/g, '$1');

/// Si solo sobra, falta o cambia una letra, o dos vecinas van al revés.
function porUnaLetra(una, otra) {
  let i = 0;
  while (i < una.length && una[i] === otra[i]) ++i;
  const [a, b] = [una.slice(i), otra.slice(i)];
  return a.slice(1) === b.slice(1) || a.slice(1) === b || a === b.slice(1) ||
    (a[0] === b[1] && a[1] === b[0] && a.slice(2) === b.slice(2));
}

/// Como casaCon, para una palabra que no está en ningún sitio.
function seParece(buscada) {
  const suya = suena(buscada);
  return hay => buscada.length < 4 ? 0 : suena(hay) === suya ? 0.5 : porUnaLetra(buscada, hay) ? 0.3 : 0;
}

const DE_SINONIMO = 0.9; // lo que vale lo hallado con otras palabras

export class Indice {
  #entradas;
  #donde = new Map(); // las zonas en que está cada palabra
  #sinonimos;

  /// `datos` son los que escribe base/indice.py.
  constructor({ entradas, ficheros, sinonimos }) {
    const zona = (clase, enlace, texto, vale, suyas) => {
      const nueva = { clase, enlace, texto, vale, entera: palabras(texto).join(' '), palabras: suyas };
      for (const palabra of suyas.keys()) {
        if (!this.#donde.get(palabra)?.push(nueva)) this.#donde.set(palabra, [nueva]);
      }
      return nueva;
    };
    const deFichero = Object.fromEntries(Object.entries(ficheros).map(([ruta, texto]) =>
      [ruta, new Map(texto.split(' ').map(identificador => [llano(identificador), identificador]))]));
    this.#sinonimos = Object.entries(sinonimos).map(([frase, otras]) => [llano(frase), otras.split('|').map(llano)]);
    this.#entradas = entradas.map(({ titulo, zonas, fuentes }) => ({ titulo, zonas: [
      ...zonas.map(([clase, enlace, texto]) => zona(clase, enlace, texto, VALE[clase], new Set(palabras(texto)))),
      // el propio vale más que los que incluye
      ...fuentes.map((ruta, i) => zona('fuente', zonas[0][1], ruta, VALE.fuente / (1 + i / 4), deFichero[ruta])),
    ] }));
  }

  #esta(palabra) {
    return [...this.#donde.keys()].some(casaCon(palabra));
  }

  /// Cuánto casa con una palabra cada una que haya; si no casa ninguna, cuánto se le parece.
  #casa(buscada) {
    return this.#esta(buscada) ? casaCon(buscada) : seParece(buscada);
  }

  /// Si no está y se parece a una de las que tienen sinónimos, esa.
  #bienEscrita(palabra) {
    const parece = seParece(palabra), deSinonimos = this.#sinonimos.flatMap(([frase]) => frase.split(' '));
    return deSinonimos.includes(palabra) || this.#esta(palabra) ? palabra : deSinonimos.find(parece) ?? palabra;
  }

  /// Lo buscado y lo mismo con otras palabras: [palabras, cuánto vale lo que se halle con ellas].
  #formas(suyas) {
    const entero = ` ${suyas.map(palabra => this.#bienEscrita(palabra)).join(' ')} `;
    return [[suyas, 1], ...this.#sinonimos.flatMap(([frase, otras]) => !entero.includes(` ${frase} `) ? []
      : otras.map(otra => [palabras(entero.replace(` ${frase} `, ` ${otra} `)), DE_SINONIMO]))];
  }

  /// Lo que vale una palabra en cada zona en que casa con alguna.
  #vale(casa) {
    const valen = new Map();
    for (const [hay, zonas] of this.#donde) {
      const cuanto = casa(hay);
      if (cuanto) for (const z of zonas) valen.set(z, Math.max(valen.get(z) ?? 0, cuanto * z.vale));
    }
    return valen;
  }

  /// Lo que tiene más palabras de las buscadas, o sinónimos, y la mitad al menos, de mejor a peor: { titulo, enlace,
  /// clase, texto, palabra, leFalta }, con la zona en que mejor está lo buscado y, si es un fuente, el identificador.
  busca(buscado) {
    const mejores = new Map();
    let pocas = Infinity; // las que faltan donde menos
    for (const [suyas, cuanto] of this.#formas(palabras(buscado))) {
      const casan = llenas(suyas).map(palabra => this.#casa(palabra)), valen = casan.map(casa => this.#vale(casa));
      for (const entrada of valen.length ? this.#entradas : []) {
        const hallado = this.#mide(entrada, valen, suyas.join(' ')), { faltan } = hallado, vale = cuanto * hallado.vale;
        if (2 * faltan > valen.length || valen.length === faltan || faltan > pocas) continue;
        if (faltan < pocas) mejores.clear();
        pocas = faltan;
        if (!(mejores.get(entrada)?.vale >= vale)) mejores.set(entrada, { ...hallado, vale, casan });
      }
    }
    const leFalta = pocas > 0;
    return [...mejores.values()].sort((a, b) => b.vale - a.vale).map(({ titulo, zona, vale, casan }) => ({ titulo, vale,
      enlace: zona.enlace, clase: zona.clase, texto: zona.texto, palabra: this.#mejor(zona, casan), leFalta }));
  }

  /// De cada palabra vale la zona en que mejor está, y algo las demás; y más, si lo buscado es el texto entero de una.
  #mide({ titulo, zonas }, valen, entero) {
    const suma = numeros => numeros.reduce((a, b) => a + b, 0);
    const deCada = valen.map(enZona => zonas.map(z => enZona.get(z) ?? 0));
    const faltan = deCada.filter(suyos => !Math.max(...suyos)).length;
    const deZona = zonas.map((_, i) => suma(deCada.map(suyos => suyos[i])));
    const vale = suma(deCada.map(suyos => Math.max(...suyos) + 0.05 * suma(suyos)));
    const entera = zonas.find(z => z.entera === entero);
    const zona = entera ?? zonas[deZona.indexOf(Math.max(...deZona))];
    return { titulo, zona, faltan, vale: vale + (entera ? VALE.título : 0) };
  }

  /// El identificador de un fuente que mejor casa.
  #mejor({ clase, palabras: hay }, casan) {
    if (clase !== 'fuente') return '';
    const cuanto = palabra => Math.max(...casan.map(casa => casa(palabra)));
    return hay.get([...hay.keys()].reduce((a, b) => cuanto(b) > cuanto(a) ? b : a));
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
