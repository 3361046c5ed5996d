'use strict';
const todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
const una = (selector, raiz = document) => raiz.querySelector(selector);

// La vista grande: una imagen en toda la ventana o, con p, en toda la pantalla; ← y → pasan por las que se ven en la
// página.
const grande = una('dialog');
let actual;

function ensena(enlace) {
  actual = enlace;
  const figura = enlace.closest('figure'), articulo = enlace.closest('article');
  const titulo = una('h3', articulo).textContent;
  const nombre = una('b', figura)?.textContent;
  una('picture', grande).replaceWith(una('picture', enlace).cloneNode(true));
  una('h2', grande).textContent = nombre ? `${titulo}: ${nombre}` : titulo;
  una('.mira', grande).textContent = una('.mira', figura)?.textContent ?? '';
  una('.mandos', grande).textContent = todos('.controles li', articulo).map(li => li.textContent).join(' · ');
  if (grande.open) return;
  grande.showModal();
  grande.focus(); // y no el botón de cerrar
}

function pasa(pasos) {
  const visibles = todos('figure a').filter(a => a.offsetParent || a === actual);
  const vecina = visibles[visibles.indexOf(actual) + pasos];
  if (vecina) ensena(vecina);
}

// Un diálogo no puede ponerse a toda pantalla: lo hace la página, y el diálogo se abre encima.
async function proyecta() {
  if (document.fullscreenElement) return document.exitFullscreen();
  const asoma = a => a.offsetParent && a.getBoundingClientRect().bottom > una('nav').offsetHeight + 50;
  const primera = grande.open ? actual : todos('figure a').find(asoma);
  await document.documentElement.requestFullscreen?.();
  if (grande.open) grande.close();
  ensena(primera ?? una('figure a'));
}

for (const enlace of todos('figure a'))
  enlace.addEventListener('click', suceso => {
    suceso.preventDefault();
    ensena(enlace);
  });
una('.anterior').addEventListener('click', () => pasa(-1));
una('.siguiente').addEventListener('click', () => pasa(1));
una('.cierra').addEventListener('click', () => grande.close());
grande.addEventListener('close', () => {
  actual.scrollIntoView({ block: 'center' });
  actual.focus({ preventScroll: true });
});
let xInicial;
grande.addEventListener('touchstart', suceso => { xInicial = suceso.touches[0].clientX; }, { passive: true });
grande.addEventListener('touchend', suceso => {
  const recorrido = suceso.changedTouches[0].clientX - xInicial;
  if (Math.abs(recorrido) > 40) pasa(recorrido < 0 ? 1 : -1);
});

// El buscador: quedan los programas que tienen todas las palabras, con acentos o sin ellos.
const busca = una('input');
const llano = texto => texto.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase();
const texto = new Map(todos('article').map(articulo =>
  [articulo, llano(una('h2', articulo.parentElement).textContent + ' ' + una('.ficha', articulo).textContent +
    todos('figcaption', articulo).map(pie => pie.textContent).join(' '))]));

busca.addEventListener('input', () => {
  const palabras = llano(busca.value).split(/\s+/);
  for (const [articulo, contenido] of texto) articulo.hidden = !palabras.every(palabra => contenido.includes(palabra));
  for (const capitulo of todos('.capitulo')) capitulo.hidden = !una('article:not([hidden])', capitulo);
  una('.nada').hidden = una('article:not([hidden])') !== null;
});

document.addEventListener('keydown', suceso => {
  if (suceso.ctrlKey || suceso.altKey || suceso.metaKey) return;
  // AvPág y RePág: los mandos de presentación
  if (grande.open && ['ArrowRight', 'PageDown'].includes(suceso.key)) pasa(1);
  else if (grande.open && ['ArrowLeft', 'PageUp'].includes(suceso.key)) pasa(-1);
  else if (suceso.key === 'p' && document.activeElement !== busca) proyecta();
  else if (!grande.open && suceso.key === '/' && document.activeElement !== busca) {
    suceso.preventDefault();
    busca.focus();
  }
});

// Los fuentes: cada fichero está una vez en la página y se copia donde se pide.
function abre(boton) {
  for (const otro of todos('button', boton.parentElement)) otro.setAttribute('aria-pressed', otro === boton);
  const fuente = document.getElementById('fuente:' + boton.dataset.fuente);
  una('pre', boton.closest('.fuentes')).replaceChildren(fuente.content.cloneNode(true));
}
for (const detalle of todos('.fuentes'))
  detalle.addEventListener('toggle', () => {
    if (detalle.open && !una('[aria-pressed]', detalle)) abre(una('button', detalle));
  });
for (const boton of todos('.pestanas button')) boton.addEventListener('click', () => abre(boton));
