// Lo que hay alrededor de un programa o de un ejercicio: su título, qué dice el libro, sus vecinos y sus casos.
import { boton, crea, todos, una } from '../base/documento.mjs';
import { marcaEnLado } from '../base/lado.mjs';
import { EJERCICIOS, PROGRAMAS } from './programas.mjs';
import { enlazaEjercicio, ponResueltos } from './resueltos.mjs';

const pagina = una('#programa');

export function ponFicha(programa, ejercicio) {
  scrollTo(0, 0);
  document.title = !ejercicio ? programa.titulo : ejercicio.propio ? ejercicio.que
    : `Ejercicio ${ejercicio.codigo}: ${ejercicio.que}`;
  una('h1', pagina).textContent = document.title;
  const orden = una('.origen .orden');
  una('code', orden).textContent = `./lab ver ${programa.nombre}`;
  una('.copia', orden).ariaLabel = `Copiar ./lab ver ${programa.nombre}`;
  marcaEnLado(programa.nombre);
  const suyo = document.getElementById('libro:' + programa.nombre)?.content.cloneNode(true).children ?? [];
  pagina.classList.toggle('de-clase', Boolean(ejercicio?.propio)); // su solución no la tiene quien la mira
  // lo primero, al ponerlo en su sitio, deja de estar en la plantilla
  for (const donde of [una('.de-que'), una('.del-libro', pagina)]) donde.replaceChildren(...[suyo[0]].filter(Boolean));
  pagina.classList.toggle('de-consola', programa.consola);
  pagina.classList.toggle('en-ejercicio', Boolean(ejercicio));
  pagina.classList.remove('sin-webgl');
  pagina.classList.toggle('con-carpeta', Boolean(ejercicio?.carpeta));
  const capitulo = ejercicio?.propio ? 'ejercicios' : programa.capitulo;
  Object.assign(una('.de-capitulo'), { href: '#' + capitulo, textContent: una(`#${capitulo} h2`).textContent });
  ponVecinos(programa, ejercicio);
  const salida = ejercicio?.propio ? [] : [enlazaSalida(programa)];
  const enlaces = ejercicio ? salida : programa.ejercicios.map(enlazaEjercicio);
  una('.a-ejercicios', pagina).replaceChildren(...enlaces);
  ponResueltos();
}

const enlazaSalida = ({ nombre, titulo }) =>
  crea('a', { className: 'a-ejercicio', href: '#' + nombre, textContent: `Salir a «${titulo}»` });

function ponVecinos(programa, ejercicio) {
  const lista = ejercicio ? EJERCICIOS : PROGRAMAS;
  const i = ejercicio ? lista.findIndex(e => e.codigo === ejercicio.codigo) : lista.indexOf(programa);
  for (const [clase, vecino] of [['.anterior', lista[i - 1]], ['.siguiente', lista[i + 1]]]) {
    una(clase).hidden = !vecino;
    if (vecino) una(clase).href = '#' + (vecino.enlace ?? vecino.nombre);
    una(clase + ' span').textContent = vecino?.titulo ?? vecino?.que ?? '';
  }
}

/// Donde no hay WebGL 2: del programa se ve su imagen, y no lo que solo vale en marcha.
export function ensenaImagen({ nombre, casos }) {
  pagina.classList.add('sin-webgl');
  const suya = una(`.tarjetas a[href="#${nombre}"] img`); // ya está en el catálogo
  const donde = una('.en-ejercicio .objetivo') ?? una('.lienzo');
  todos('canvas, img', donde).forEach(e => e.remove());
  if (suya) donde.prepend(crea('img', { src: suya.src, alt: casos[0].mira }));
}

/// Un botón para cada caso, si hay varios.
export function ponCasos({ casos }, empiezaCaso) {
  const botones = casos.map(caso => boton(caso.titulo, () => empiezaCaso(caso)));
  una('.casos-botones').replaceChildren(...(botones.length > 1 ? botones : []));
}

/// Cuál se está viendo y qué hay que mirar en él.
export function ensenaCaso(caso) {
  const varios = todos('.casos-botones button').length > 1;
  una('h2.proyectado').textContent = caso && varios ? `${document.title}: ${caso.titulo}` : document.title;
  for (const p of todos('.mira', pagina)) p.textContent = caso?.mira ?? '';
  for (const b of todos('.casos-botones button')) b.setAttribute('aria-pressed', b.textContent === caso?.titulo);
}
