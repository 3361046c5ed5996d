// La vista grande: una imagen en toda la ventana o, con p, en toda la pantalla, y nunca mayor de lo que se dibujó.
// ← y → pasan por las demás. Lo que lleva a un sitio de la página, y no a una imagen, se ve como está en ella.
import { crea, esDelNavegador, todos, una } from './documento.mjs';

const RITMO = 100; // ms de cada cuadro
const grande = una('dialog'), cuadro = una('.cuadro', grande);
let actual;                     // el enlace de la que se ve
let animacion = { para() {} };

/// Las de la página, en su orden.
const imagenes = () => todos('figure a');

/// La dirección de una figura: la suya o, si es la única, la del programa.
const direccion = enlace => '#' + (enlace.closest('figure').id || enlace.closest('article').id);

/// Un píxel de la imagen es uno de la pantalla, o menos si no cabe.
const aSuTalla = e => { e.style.width = `${(e.naturalWidth ?? e.width) / devicePixelRatio}px`; };

/// Los cuadros de una animación, uno tras otro en un lienzo; parada, si quien mira pide menos movimiento.
class Animacion {
  lienzo = crea('canvas');
  #cuadros;
  #reloj;
  #i = 0;

  constructor(rutas) {
    this.#cuadros = rutas.map(src => Object.assign(new Image(), { src }));
    this.#cuadros[0].onload = () => {
      const { naturalWidth: width, naturalHeight: height } = this.#cuadros[0];
      aSuTalla(Object.assign(this.lienzo, { width, height }));
      this.#pinta();
    };
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.alterna();
  }

  get anda() { return Boolean(this.#reloj); }

  #pinta() {
    const esta = this.#cuadros[this.#i];
    if (esta.complete && this.lienzo.width) this.lienzo.getContext('2d').drawImage(esta, 0, 0);
  }

  para() { this.#reloj = clearInterval(this.#reloj); }

  alterna() {
    if (this.anda) return this.para();
    this.#reloj = setInterval(() => {
      if (!this.#cuadros[(this.#i + 1) % this.#cuadros.length].complete) return; // aún no ha llegado
      this.#i = (this.#i + 1) % this.#cuadros.length;
      this.#pinta();
    }, RITMO);
  }
}

function ponImagen(enlace) {
  const cuadros = enlace.dataset.cuadros?.split(' ');
  animacion.para();
  animacion = cuadros ? new Animacion(cuadros) : { para() {}, alterna() {} };
  if (enlace.hash) return cuadro.replaceChildren(...[...enlace.children].map(e => e.cloneNode(true)));
  const { alt } = una('img', enlace);
  const imagen = animacion.lienzo ?? crea('img', { src: enlace.href, onload: () => aSuTalla(imagen) });
  cuadro.replaceChildren(Object.assign(imagen, { alt, role: 'img', ariaLabel: alt }));
}

function ensena(enlace) {
  const figura = enlace.closest('figure'), articulo = enlace.closest('article');
  const titulo = una('h3', articulo).textContent, nombre = una('b', figura)?.textContent;
  actual = enlace;
  ponImagen(enlace);
  una('h2', grande).textContent = nombre ? `${titulo}: ${nombre}` : titulo;
  una('.mira', grande).textContent = una('.mira', figura)?.textContent ?? '';
  una('.mandos', grande).textContent = todos('.controles li', articulo).map(li => li.textContent).join(' · ');
  grande.classList.remove('negro');
  // la dirección es la de la que se ve, y con «Atrás» se vuelve a donde se estaba
  history[grande.open ? 'replaceState' : 'pushState'](null, '', direccion(enlace));
  if (grande.open) return;
  grande.showModal();
  grande.focus(); // y no el botón de cerrar
}

function pasa(pasos) {
  const vecina = imagenes()[imagenes().indexOf(actual) + pasos];
  if (vecina) ensena(vecina);
}

const delCapitulo = () => todos('figure a', actual.closest('.capitulo'));

/// Un diálogo no puede ponerse a toda pantalla: lo hace la página, y el diálogo se abre encima.
async function proyecta() {
  if (document.fullscreenElement) return document.exitFullscreen();
  const primera = grande.open ? actual : imagenes().find(a => a.getBoundingClientRect().bottom > 100);
  await document.documentElement.requestFullscreen?.();
  if (grande.open) grande.close();
  ensena(primera ?? imagenes()[0]);
}

const alterna = clase => () => grande.classList.toggle(clase);
const siguiente = () => pasa(1), anterior = () => pasa(-1);
// AvPág, RePág y el punto: los mandos de presentación
const TECLAS = {
  ArrowRight: siguiente, PageDown: siguiente, ArrowLeft: anterior, PageUp: anterior,
  Home: () => ensena(delCapitulo()[0]), End: () => ensena(delCapitulo().at(-1)),
  b: alterna('negro'), '.': alterna('negro'), '?': alterna('con-teclas'), ' ': () => animacion.alterna(), p: proyecta,
};

document.addEventListener('keydown', suceso => {
  if (esDelNavegador(suceso) || suceso.target.closest('input')) return;
  const hace = grande.open ? TECLAS[suceso.key] : suceso.key === 'p' && proyecta;
  if (!hace || (suceso.key === ' ' && suceso.target.closest('button'))) return;
  suceso.preventDefault();
  hace();
});

for (const enlace of imagenes())
  enlace.addEventListener('click', suceso => {
    suceso.preventDefault();
    ensena(enlace);
  });
una('.anterior').addEventListener('click', anterior);
una('.siguiente').addEventListener('click', siguiente);
una('.cierra').addEventListener('click', () => grande.close());
addEventListener('popstate', () => { if (grande.open) grande.close(); });
grande.addEventListener('close', () => {
  animacion.para();
  actual.scrollIntoView({ block: 'center' });
  actual.focus({ preventScroll: true });
});

let xInicial;
grande.addEventListener('touchstart', suceso => { xInicial = suceso.touches[0].clientX; }, { passive: true });
grande.addEventListener('touchend', suceso => {
  const recorrido = suceso.changedTouches[0].clientX - xInicial;
  if (Math.abs(recorrido) > 40) pasa(recorrido < 0 ? 1 : -1);
});
