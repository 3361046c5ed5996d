// Los programas y los ejercicios que hay, como los escribe pagina.py en la página.
import { una } from '../base/documento.mjs';

const lee = id => JSON.parse(una(`#${id}`).textContent);

export const PROGRAMAS = lee('programas');
/// Los de quien enseña, los últimos: sus programas no están en la lista.
export const EJERCICIOS = [...PROGRAMAS, ...lee('ensenados')].flatMap(programa =>
  programa.ejercicios.map(e => ({ ...e, programa, enlace: `ejercicio/${e.codigo}` })));
