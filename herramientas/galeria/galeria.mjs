// La galería: adónde llevan sus direcciones, el buscador, el índice y los fuentes.
import { crea, descifra, todos, una } from '../base/documento.mjs';
import { atiendeBuscador } from '../base/buscador.mjs';
import { sigueEnLado } from '../base/lado.mjs';

atiendeBuscador(async () => JSON.parse(una('#indice').textContent));
sigueEnLado('.capitulo, article');

/// Una dirección escrita a mano: #l5.1 es #L5.1, y #5, #ch5 o #cap5, un capítulo. Si no es de nada, se dice.
function llega() {
  const pedida = descifra(location.hash.slice(1)), noEsta = una('#no-esta');
  const exacta = document.getElementById(pedida), numero = /^(?:ch|cap)?0*(\d+)$/i.exec(pedida)?.[1];
  const otra = exacta ?? todos('main [id]').find(e => e.id.toLowerCase() === pedida.toLowerCase()
    || e.id.startsWith(`ch${numero?.padStart(2, '0')}_`));
  noEsta.hidden = !pedida || Boolean(otra);
  noEsta.textContent = `Aquí no hay nada que se llame «${pedida.slice(0, 60)}».`;
  if (otra && !exacta) location.replace('#' + otra.id);
  else if (!noEsta.hidden) noEsta.scrollIntoView();
}
addEventListener('hashchange', llega);
llega();

// Los fuentes: cada fichero coloreado es un guion que se trae al pedirlo; otra cosa, de file:// no se puede leer.
const traidos = new Map();
globalThis.fuente = (ruta, html) => traidos.set(ruta, html);

async function abre(boton) {
  for (const otro of todos('button', boton.parentElement)) otro.setAttribute('aria-pressed', otro === boton);
  const ruta = boton.dataset.fuente, guion = `fuentes/${ruta}.js`;
  if (!traidos.has(ruta))
    await new Promise(llega => document.head.append(crea('script', { src: guion, onload: llega, onerror: llega })));
  if (boton.getAttribute('aria-pressed') === 'true')
    una('pre', boton.closest('.fuentes')).innerHTML = traidos.get(ruta) ?? `No está ${guion}.`;
}
for (const detalle of todos('.fuentes'))
  detalle.addEventListener('toggle', () => {
    if (detalle.open && !una('[aria-pressed]', detalle)) abre(una('button', detalle));
  });
for (const boton of todos('.pestanas button')) boton.addEventListener('click', () => abre(boton));
