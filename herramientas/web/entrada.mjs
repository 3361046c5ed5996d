// Lo que se hace en el lienzo, a órdenes para el programa.
import { enCampo, esDelNavegador, una } from '../base/documento.mjs';
import { BOTONES, Gestos } from './gestos.mjs';
import { devuelve } from './incrustado.mjs';
import { completa } from './proyeccion.mjs';
import { esSuya, ordenDeTecla } from './teclas.mjs';

/// `sigue` es si el programa atiende al ratón sin pulsar.
export function atiende(lienzo, escena, sigue) {
  const da = orden => escena.sesion?.lienzo === lienzo && escena.manda(orden);
  const gestos = new Gestos({ da, luego: requestAnimationFrame.bind(window), sigue });
  atiendePuntero(lienzo, escena, gestos);
  return gestos;
}

/// Un botón o un enlace se pulsan con Espacio y con Intro.
const loPulsa = ({ key, target }) =>
  /^( |Enter)$/.test(key) && target.closest('button, a, summary, label, [role=button]');

/// La orden de esa tecla, si es del programa: las que usa lo son tenga quien tenga el foco, salvo que se esté
/// escribiendo, eligiendo o pulsando algo. Incrustado lo son todas, salvo las que se devuelven a la página de fuera.
function ordenSuya(suceso, programa) {
  const { target } = suceso, enLienzo = Boolean(target.closest('canvas')), orden = ordenDeTecla(suceso);
  const deOtro = enCampo(suceso) || loPulsa(suceso) || target.closest('.opciones') || una('.apunta');
  if (deOtro || (!enLienzo && esDelNavegador(suceso))) return '';
  const solo = document.body.classList.contains('incrustado');
  if (solo && !esSuya(programa, orden, false) && devuelve(suceso)) return '';
  return solo || esSuya(programa, orden, enLienzo) ? orden : '';
}

/// El teclado, antes que la página, para la que queda lo que el programa no usa. `programa()` es el que se ve.
export function atiendeTeclado(escena, programa) {
  document.addEventListener('keydown', suceso => {
    const orden = programa() && ordenSuya(suceso, programa());
    if (!orden) return;
    suceso.preventDefault();
    suceso.stopPropagation();
    if (orden === 'especial F11') completa();
    else if (orden === 'especial F5') escena.recarga();
    else escena.manda(orden);
  }, { capture: true });
}

function atiendePuntero(lienzo, escena, gestos) {
  const punto = ({ pointerId: id, clientX, clientY }) => {
    const r = lienzo.getBoundingClientRect();
    return { id, x: (clientX - r.left) * lienzo.width / r.width, y: (clientY - r.top) * lienzo.height / r.height };
  };
  lienzo.addEventListener('pointerdown', suceso => {
    lienzo.focus({ preventScroll: true });
    lienzo.setPointerCapture(suceso.pointerId);
    if (suceso.isPrimary) suceso.preventDefault();
    const menu = suceso.button === 2 && escena.opciones().length;
    const derecho = una('.derecho')?.getAttribute('aria-pressed') === 'true';
    gestos.baja(punto(suceso), menu ? '' : BOTONES[derecho && suceso.button < 3 ? 2 : suceso.button]);
    if (menu) escena.ensenaMenu(suceso.clientX, suceso.clientY);
  });
  lienzo.addEventListener('pointermove', suceso => gestos.mueve(punto(suceso)));
  for (const fin of ['pointerup', 'pointercancel']) lienzo.addEventListener(fin, suceso => gestos.sube(punto(suceso)));
  lienzo.addEventListener('wheel', suceso => {
    suceso.preventDefault();
    gestos.gira(punto(suceso), suceso.deltaY, suceso.deltaMode);
  }, { passive: false });
  lienzo.addEventListener('contextmenu', suceso => suceso.preventDefault());
}
