// La galería: adónde llevan sus direcciones, el buscador, el índice y los fuentes.
import { descifra, todos, una } from '../base/documento.mjs';
import { atiendeBuscador } from '../base/buscador.mjs';
import { sigueEnLado } from '../base/lado.mjs';

atiendeBuscador(async () => JSON.parse(una('#indice').textContent));
sigueEnLado('.capitulo, article');

/// Una dirección escrita a mano: #l5.1 es #L5.1. Si no es de nada, se dice.
function llega() {
  const pedida = descifra(location.hash.slice(1)), noEsta = una('#no-esta');
  const exacta = document.getElementById(pedida);
  const otra = exacta ?? todos('main [id]').find(e => e.id.toLowerCase() === pedida.toLowerCase());
  noEsta.hidden = !pedida || Boolean(otra);
  noEsta.textContent = `Aquí no hay nada que se llame «${pedida.slice(0, 60)}».`;
  if (otra && !exacta) location.replace('#' + otra.id);
  else if (!noEsta.hidden) noEsta.scrollIntoView();
}
addEventListener('hashchange', llega);
llega();

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
