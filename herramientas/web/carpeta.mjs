// La carpeta de un ejercicio, como la de ./lab nuevo: en un .zip que se guarda, o soltada en la página.

const TABLA = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let i = 0; i < 8; ++i) n = n & 1 ? n >>> 1 ^ 0xedb88320 : n >>> 1;
  return n;
});

const crc32 = bytes => ~bytes.reduce((crc, b) => TABLA[(crc ^ b) & 255] ^ crc >>> 8, -1) >>> 0;

/// Números de 2 y de 4 bytes, como van en un .zip: [tamaño, número]…
function enBytes(...numeros) {
  const vista = new DataView(new ArrayBuffer(numeros.reduce((n, [talla]) => n + talla, 0)));
  let donde = 0;
  for (const [talla, n] of numeros) {
    vista[talla === 2 ? 'setUint16' : 'setUint32'](donde, n, true);
    donde += talla;
  }
  return new Uint8Array(vista.buffer);
}

const DE_1980 = [[2, 0], [2, 0x21]]; // la hora y el día: los de cuando se hace, que lo mismo dé el mismo .zip
const UTF8 = [2, 0x800], SIN_COMPRIMIR = [2, 0];

/// Esos textos { ruta: texto }, sin comprimir.
export function haceZip(textos) {
  const locales = [], central = [];
  let donde = 0;
  for (const [ruta, texto] of Object.entries(textos)) {
    const [nombre, datos] = [ruta, texto].map(t => new TextEncoder().encode(t)), talla = [4, datos.length];
    const comun = [UTF8, SIN_COMPRIMIR, ...DE_1980, [4, crc32(datos)], talla, talla, [2, nombre.length], [2, 0]];
    const local = [enBytes([4, 0x04034b50], [2, 20], ...comun), nombre, datos];
    locales.push(...local);
    const y = [[2, 0], [2, 0], [2, 0], [4, 0], [4, donde]];
    central.push(enBytes([4, 0x02014b50], [2, 20], [2, 20], ...comun, ...y), nombre);
    donde += local.reduce((n, b) => n + b.length, 0);
  }
  const cuantos = [2, central.length / 2], largo = central.reduce((n, b) => n + b.length, 0);
  return new Blob([...locales, ...central,
    enBytes([4, 0x06054b50], [2, 0], [2, 0], cuantos, cuantos, [4, largo], [4, donde], [2, 0])]);
}

/// Los ficheros de un .zip: { ruta: File }. Lanza un error si no lo es.
export async function leeZip(fichero) {
  const bytes = new Uint8Array(await fichero.arrayBuffer()), vista = new DataView(bytes.buffer), hay = {};
  let fin = bytes.length - 22;
  while (fin >= 0 && vista.getUint32(fin, true) !== 0x06054b50) --fin;
  if (fin < 0) throw new Error(`«${fichero.name}» está estropeado, o no es un .zip`);
  const texto = (donde, largo) => new TextDecoder().decode(bytes.subarray(donde, donde + largo));
  for (let n = vista.getUint16(fin + 10, true), c = vista.getUint32(fin + 16, true); n > 0; --n) {
    const [como, talla, nombre, mas, nota, donde] = [[10, 2], [20, 4], [28, 2], [30, 2], [32, 2], [42, 4]]
      .map(([d, t]) => vista[t === 2 ? 'getUint16' : 'getUint32'](c + d, true));
    const desde = donde + 30 + vista.getUint16(donde + 26, true) + vista.getUint16(donde + 28, true);
    const datos = new Blob([bytes.subarray(desde, desde + talla)]);
    hay[texto(c + 46, nombre)] = como ? new Response(datos.stream().pipeThrough(new DecompressionStream('deflate-raw')))
      : datos;
    c += 46 + nombre + mas + nota;
  }
  return hay;
}

/// Los de una carpeta que se ha soltado, y los de dentro: en Chromium, que de file:// no lee entradas, por su asa; en
/// Firefox, que no las tiene, por su entrada.
async function deAsa(asa, ruta = asa.name, hay = {}) {
  if (asa.kind === 'file') hay[ruta] = await asa.getFile();
  else for await (const otra of asa.values()) await deAsa(otra, `${ruta}/${otra.name}`, hay);
  return hay;
}

async function deEntrada(entrada, hay = {}) {
  if (entrada.isFile) {
    hay[entrada.fullPath.slice(1)] = await new Promise((bien, mal) => entrada.file(bien, mal));
    return hay;
  }
  const lector = entrada.createReader(), lee = () => new Promise((bien, mal) => lector.readEntries(bien, mal));
  for (let trozo = await lee(); trozo.length; trozo = await lee()) // de cien en cien
    for (const otra of trozo) await deEntrada(otra, hay);
  return hay;
}

const FUENTE = /\.(cpp|h|vert|frag|glsl|vf)$/, MUCHO = 400;

/// Si lo soltado puede ser de un ejercicio (una carpeta, un .zip o unos fuentes), cómo leerlo. Hay que preguntarlo
/// según se suelta.
export function loSoltado(dataTransfer) {
  const cosas = [...dataTransfer.items].filter(i => i.kind === 'file'), ficheros = [...dataTransfer.files];
  const entradas = cosas.map(i => i.webkitGetAsEntry?.());
  if (entradas.some(e => e?.isDirectory)) {
    const asas = cosas.map(i => i.getAsFileSystemHandle?.());
    return () => Promise.all(asas.map((asa, i) => asa ? asa.then(a => deAsa(a)) : deEntrada(entradas[i]))).then(juntos);
  }
  if (ficheros.length === 1 && /\.zip$/i.test(ficheros[0].name)) return () => leeZip(ficheros[0]).then(textosDe);
  const suyos = ficheros.filter(f => /\.(cpp|h|vert|frag|glsl)$/.test(f.name));
  return suyos.length ? () => juntos(suyos.map(f => ({ [f.name]: f }))) : undefined;
}

const juntos = partes => textosDe(Object.assign({}, ...partes));

/// Sus textos, por su nombre, y { carpeta, cómo se llama la suya; codigo, el que dice su ejercicio.txt }.
async function textosDe(ficheros) {
  const vale = ruta => (FUENTE.test(ruta) || /(^|\/)ejercicio\.txt$/.test(ruta)) && !/(^|\/)(\.|__MACOSX)/.test(ruta);
  const rutas = Object.keys(ficheros).filter(vale);
  if (!rutas.length) throw new Error('Ahí no hay ningún fuente: se abre la carpeta de ./lab nuevo, o su .zip.');
  if (rutas.length > MUCHO) throw new Error(`Ahí hay ${rutas.length} fuentes: suelta solo la carpeta del ejercicio.`);
  const textos = {}, nombre = ruta => ruta.split('/').pop();
  for (const ruta of rutas) {
    if (textos[nombre(ruta)] !== undefined) throw new Error(`Hay dos «${nombre(ruta)}»: suelta una sola carpeta.`);
    textos[nombre(ruta)] = (await ficheros[ruta].text()).replaceAll('\r\n', '\n');
  }
  const { 'ejercicio.txt': dice, ...fuentes } = textos;
  return { fuentes, carpeta: rutas[0].split('/').at(-2) ?? '', codigo: dice?.split(' ')[0] };
}
