// Los enlaces a los ejercicios, que dicen cuáles están resueltos.
import { leeResueltos, recuerdo } from './almacen.mjs';
import { crea, todos, una } from '../base/documento.mjs';
import { EJERCICIOS } from './programas.mjs';

let resueltos = new Set();

export const enlazaEjercicio = ({ codigo, que }) =>
  crea('a', { className: 'a-ejercicio', href: `#ejercicio/${codigo}`, title: que });

/// Los resueltos, que quizá lo han sido en otra pestaña, en todos los enlaces.
export function ponResueltos(...nuevos) {
  resueltos = new Set([...resueltos, ...leeResueltos(recuerdo('localStorage', 'resueltos')), ...nuevos]);
  if (nuevos.length) recuerdo('localStorage', 'resueltos', [...resueltos].join(' '));
  for (const a of todos('a.a-ejercicio[href*="/"]')) {
    const codigo = a.hash.split('/')[1];
    a.textContent = `Ejercicio ${codigo}${resueltos.has(codigo) ? ' ✓' : ''}`;
    a.ariaLabel = `Ejercicio ${codigo}${resueltos.has(codigo) ? ', resuelto' : ''}`;
  }
  const cuantos = EJERCICIOS.filter(e => resueltos.has(e.codigo)).length;
  una('.cuenta').textContent = `hay ${EJERCICIOS.length}, y has resuelto ${cuantos}`;
}
