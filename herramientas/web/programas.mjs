// Los programas y los ejercicios que hay, como los escribe pagina.py en la página.
import { una } from '../base/documento.mjs';

export const PROGRAMAS = JSON.parse(una('#programas').textContent);
export const EJERCICIOS = PROGRAMAS.flatMap(programa =>
  programa.ejercicios.map(e => ({ ...e, programa, enlace: `ejercicio/${e.codigo}` })));
