// Lo que se hace en el lienzo, a órdenes para el programa.
import { una } from '../base/documento.mjs';
import { BOTONES, Gestos } from './gestos.mjs';
import { completa } from './proyeccion.mjs';
import { ordenDeTecla } from './teclas.mjs';

/// `sigue` es si el programa atiende al ratón sin pulsar.
export function atiende(lienzo, escena, sigue) {
  const da = orden => escena.sesion?.lienzo === lienzo && escena.manda(orden);
  const gestos = new Gestos({ da, luego: requestAnimationFrame.bind(window), sigue });
  atiendeTeclas(lienzo, escena);
  atiendePuntero(lienzo, escena, gestos);
  return gestos;
}

function atiendeTeclas(lienzo, escena) {
  lienzo.addEventListener('keydown', suceso => {
    const orden = ordenDeTecla(suceso);
    if (!orden) return;
    suceso.preventDefault();
    if (orden === 'especial F11') completa();
    else if (orden === 'especial F5') escena.recarga();
    else escena.manda(orden);
  });
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
