// La lista de todos los programas y su buscador.
import { todos, una } from './documento.mjs';
import { PROGRAMAS } from './programas.mjs';
import { ponResueltos } from './resueltos.mjs';
import { casa, corta, llano } from './textos.mjs';

const busca = una('input[type=search]'), pagina = una('#programa'), noEsta = una('#no-esta');

const contenido = (li, { nombre, casos }) =>
  llano([nombre, una('h2', li.closest('section')).textContent, li.textContent, ...casos.map(c => c.mira)].join(' '));
const fichas = new Map(todos('.tarjetas li').map((li, i) => [li, contenido(li, PROGRAMAS[i])]));

busca.addEventListener('input', () => {
  for (const [li, suyo] of fichas) li.hidden = !casa(suyo, busca.value);
  for (const capitulo of todos('.capitulo')) capitulo.hidden = !una('li:not([hidden])', capitulo);
  una('.nada').hidden = una('.tarjetas li:not([hidden])') !== null;
});

document.addEventListener('keydown', suceso => {
  if (suceso.ctrlKey || suceso.altKey || suceso.metaKey) return;
  if (suceso.key !== '/' || !pagina.hidden || document.activeElement === busca) return;
  suceso.preventDefault();
  busca.focus();
});

/// Todos, por el capítulo de ese nombre; si no lo hay, dice que no está.
export function ensenaCatalogo(nombre, esEjercicio) {
  ponResueltos();
  document.title = 'Síntesis de imagen y animación';
  const capitulo = nombre && PROGRAMAS.map(p => p.capitulo).find(c => c === nombre || c.split('_')[0] === nombre);
  noEsta.hidden = !nombre || Boolean(capitulo);
  noEsta.textContent = `No hay ningún ${esEjercicio ? 'ejercicio' : 'programa'} «${corta(nombre, 60)}».`;
  if (capitulo) document.getElementById(capitulo).scrollIntoView();
}
