// Un programa en marcha sin la página alrededor, para el <iframe> de otra: #incrusta/espejo;tecla d. El teclado es del
// programa mientras el navegador está en él, menos las flechas, AvPág y RePág que no use y Esc, que son de la otra.
import { avisa, una } from '../base/documento.mjs';

const incrustado = () => document.body.classList.contains('incrustado');

export function incrusta(si) {
  document.body.classList.toggle('incrustado', Boolean(si));
  una('.suelto').href = location.hash.replace('#incrusta/', '#');
}

/// La línea que lo pone en otra página, de un enlace de esta.
export function lineaDe(enlace, titulo) {
  const cita = texto => texto.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
  const direccion = location.href.replace(/#.*$/s, '') + enlace.replace('#', '#incrusta/');
  return `<iframe src="${cita(direccion)}" title="${cita(titulo)}" width="960" height="720" ` +
    'style="border: 0; max-width: 100%" loading="lazy" allow="fullscreen"></iframe>';
}

export async function copiaLinea(linea) {
  try {
    await navigator.clipboard.writeText(linea);
    avisa('Copiado: pégalo en el HTML de la otra página.');
  } catch {
    avisa(linea);
    getSelection().selectAllChildren(una('.aviso'));
  }
}

// Lo que cada una le pide a unas diapositivas (los mensajes que atiende reveal.js).
const DEVUELTAS = {
  ArrowLeft: 'left', ArrowRight: 'right', ArrowUp: 'up', ArrowDown: 'down', PageUp: 'prev', PageDown: 'next',
  Escape: '',
};

/// Si la tecla es para la página de fuera, que se queda con el teclado.
export function devuelve({ key }) {
  const method = DEVUELTAS[key];
  if (method === undefined) return false;
  document.activeElement.blur();
  parent.focus();
  if (method) parent.postMessage(JSON.stringify({ method }), '*');
  return true;
}

// Al entrar en él, el foco va al lienzo.
addEventListener('focus', () => { if (incrustado()) una('.lienzo canvas')?.focus({ preventScroll: true }); });
// Y la rueda, sin haber entrado en él, es de la página de fuera.
una('.lienzo').addEventListener('wheel', suceso => {
  if (incrustado() && !una('.lienzo').contains(document.activeElement)) suceso.stopPropagation();
}, { capture: true });
