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

/// #grua;tecla d;tecla d. Sin punto y coma no lleva guion. Y #ejercicio/L5.1, que puede llevarlo.
export function leeEnlace(hash) {
  const [, ejercicio, nombre, guion] = descifra(hash.slice(1)).match(/^(ejercicio\/)?([^;]*)(?:;(.*))?$/s);
  return { ejercicio: Boolean(ejercicio), nombre, guion };
}

export function hazEnlace(nombre, ordenes) {
  const grupos = []; // las seguidas e iguales, con ×N
  for (const orden of ordenes) {
    if (grupos.at(-1)?.orden === orden && !orden.includes('×')) ++grupos.at(-1).veces;
    else grupos.push({ orden, veces: 1 });
  }
  const textos = grupos.map(({ orden, veces }) => veces > 1 ? `${orden} ×${veces}` : orden);
  return '#' + encodeURI([nombre, ...textos].join(';')).replaceAll('#', '%23');
}
