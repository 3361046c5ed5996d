// A qué lleva un enlace: #grua;tecla d;tecla d
import { descifra } from '../base/documento.mjs';

/// Por su nombre, por lo que es en el libro o por una de sus imágenes: grua, E3.5, grua-girada.
export function programaDe(nombre, programas) {
  const n = nombre.toLowerCase();
  return programas.find(p => p.nombre === n)
    ?? programas.find(p => n && p.referencia.toLowerCase().split(' ').includes(n))
    ?? programas.find(p => casoDe(nombre, p));
}

/// El caso de la imagen de ese nombre, si es suya.
export const casoDe = (nombre, { casos }) => casos.find(c => c.fichero === nombre.toLowerCase());

/// #grua;tecla d;tecla d. Sin punto y coma no lleva guion. Y #ejercicio/L5.1, que puede llevarlo. Detrás del nombre,
/// /explica/480,360 es el píxel que se explica, de una ventana como las de siempre. Con incrusta/ delante va sin la
/// página alrededor, y su guion se puede escribir como en cualquier dirección: #incrusta/grua?tecla=d&tecla=w.
export function leeEnlace(hash) {
  const [, que, nombre, x, y, signo, guion] = descifra(hash.slice(1))
    .match(/^(ejercicio\/|incrusta\/)?([^;?]*?)(?:\/explica\/(\d{1,4}(?:\.\d)?),(\d{1,4}(?:\.\d)?))?(?:([;?])(.*))?$/s);
  const ordenes = signo === '?' ? guion.replaceAll('&', ';').replaceAll('=', ' ') : guion;
  return { ejercicio: que === 'ejercicio/', nombre, guion: ordenes, ...x && { pixel: [Number(x), Number(y)] },
    ...que === 'incrusta/' && { incrusta: true } };
}

const SIEMPRE = [960, 720]; // como se abre la ventana de un programa
const escala = ({ width, height }) => Math.min(width / SIEMPRE[0], height / SIEMPRE[1]);

/// El píxel de un lienzo de esa talla en que está el de un enlace, que es de la ventana de siempre, o al revés: como
/// la orden `escala`. Ninguno si cae fuera.
export function pixelEn([x, y], lienzo) {
  const { width, height } = lienzo, k = escala(lienzo);
  const [a, b] = [[x, SIEMPRE[0], width], [y, SIEMPRE[1], height]].map(([v, de, en]) =>
    Math.floor(en / 2 + (v + 0.5 - de / 2) * k));
  return a >= 0 && b >= 0 && a < width && b < height ? [a, b] : undefined;
}

/// En la ventana de siempre, con una décima, ese píxel de un lienzo.
export function enLaVentana([x, y], lienzo) {
  const { width, height } = lienzo, k = escala(lienzo);
  return [[x, SIEMPRE[0], width], [y, SIEMPRE[1], height]].map(([v, de, en]) =>
    Math.max(Math.round(10 * (de / 2 + (v + 0.5 - en / 2) / k - 0.5)) / 10, 0));
}

/// Lo que se escribe en un enlace para que lleve a él.
export const enEnlace = (pixel, lienzo) => `/explica/${enLaVentana(pixel, lienzo).join()}`;

export function hazEnlace(nombre, ordenes) {
  const grupos = []; // las seguidas e iguales, con ×N
  for (const orden of ordenes) {
    if (grupos.at(-1)?.orden === orden && !orden.includes('×')) ++grupos.at(-1).veces;
    else grupos.push({ orden, veces: 1 });
  }
  const textos = grupos.map(({ orden, veces }) => veces > 1 ? `${orden} ×${veces}` : orden);
  return '#' + encodeURI([nombre, ...textos].join(';')).replaceAll('#', '%23');
}
