// Los ficheros de un programa: cuáles se enseñan y qué errores dice de ellos.
import { NAVEGADOR, enEspanol } from './en_espanol.mjs';
import { corta } from './textos.mjs';

export const esShader = ruta => /\.(vert|frag|glsl)$/.test(ruta);
export const esFuente = ruta => /\.(cpp|h)$/.test(ruta);

const TIPOS = ['frag', 'vert', 'glsl', 'cpp', 'h'];

/// Los ficheros de un programa en el orden de sus pestañas: los de su capítulo, y de ellos los shaders, delante.
export function ordenaFuentes(rutas, capitulo) {
  const puesto = ruta => TIPOS.indexOf(ruta.split('.').pop()) + (ruta.startsWith(capitulo) ? 0 : TIPOS.length);
  return [...new Set(rutas)].sort((a, b) => puesto(a) - puesto(b));
}

/// Las cabeceras que incluye, también por las suyas, de esos textos { ruta: texto }; de cada una, también su fuente.
export function incluidas(ruta, textos, hay = new Set()) {
  for (const [, nombre] of textos[ruta]?.matchAll(/^#include "(?:.*\/)?(.*)"/gm) ?? [])
    for (const otra of Object.keys(textos).filter(r => r.endsWith('/' + nombre) && !hay.has(r))) {
      hay.add(otra);
      incluidas(otra, textos, hay);
    }
  return hay;
}

/// Los ficheros de la carpeta de un ejercicio: delante, los que se piden.
export function deLaCarpeta(piden, textos) {
  const rutas = Object.keys(textos).filter(ruta => esShader(ruta) || esFuente(ruta));
  return [...piden, ...ordenaFuentes(rutas.filter(ruta => !piden.includes(ruta)), 'mios/')];
}

/// Los shaders que se enseñan en un ejercicio: los suyos, su pareja y los que se incluyen.
export function delEjercicio(suyos, rutas) {
  const tallo = ruta => ruta.replace(/\.\w+$/, '');
  const pareja = ruta => !/\.(h|cpp)$/.test(ruta) && suyos.some(s => tallo(s) === tallo(ruta));
  return [...new Set([...suyos, ...rutas.filter(r => r.endsWith('.glsl') || pareja(r))])];
}

const ERROR = /([\w./]+\.(?:vert|frag|glsl))(?::| no compila: ERROR: 0:)(\d+): (.*?)(?: — «.*»)?$/;

/// El error de un shader que dice una línea de lo que escribe un programa, si lo dice.
export function leeError(linea, capitulo) {
  const mal = corta(linea, 1000).match(ERROR);
  if (mal) {
    const [, ruta, n, dice] = mal, mensaje = enEspanol(NAVEGADOR, dice);
    return { ruta: ruta.includes('/') ? ruta : `${capitulo}/${ruta}`, linea: +n, mensaje };
  }
  if (/no enlazan|#include/.test(linea)) return { ruta: '', linea: 0, mensaje: linea };
}
