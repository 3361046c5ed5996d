// Los mandos de un programa, en botones.
import { boton, crea, una } from '../base/documento.mjs';

/// Un botón que, pulsado sin soltar, repite como una tecla.
function teclaDePantalla([nombre, orden], hace, escena) {
  let reloj;
  const para = () => clearTimeout(reloj);
  const otra = () => { if (b.isConnected && escena.manda(orden)) reloj = setTimeout(otra, 60); };
  const b = boton(nombre, () => orden === 'especial F5' ? escena.recarga() : escena.manda(orden), {
    ariaLabel: `${nombre}: ${hace}`,
    onpointerdown: () => { para(); reloj = setTimeout(otra, 450); },
    onpointerup: para, onpointerleave: para, onpointercancel: para,
  });
  return b;
}

const delMenu = escena => boton('Menú', suceso => {
  const r = suceso.currentTarget.getBoundingClientRect();
  escena.ensenaMenu(r.left, r.bottom);
});

/// Mientras está pulsado, el dedo hace de botón derecho.
const derecho = () => boton('Botón derecho', suceso => {
  const b = suceso.currentTarget;
  b.setAttribute('aria-pressed', b.getAttribute('aria-pressed') !== 'true');
}, { className: 'derecho' });

export function ponMandos(programa, escena) {
  const mando = (...partes) => crea('span', { className: 'mando' }, ...partes);
  const mandos = programa.mandos.map(({ teclas, hace, menu }) => mando(
    ...teclas.map(tecla => teclaDePantalla(tecla, hace, escena)),
    menu ? delMenu(escena) : crea('span', { textContent: hace })));
  if (programa.derecho) mandos.push(mando(derecho()));
  una('.mandos').replaceChildren(...mandos);
}
