// El menú de un programa, que se abre encima de la página.
import { boton, todos, una } from '../base/documento.mjs';

const menu = una('.opciones');

export const cierraMenu = () => menu.hidePopover();

export function abreMenu(x, y, opciones, elige) {
  if (!opciones.length) return;
  menu.replaceChildren(...opciones.map(opcion =>
    boton(opcion.replaceAll('/', ' › '), () => { cierraMenu(); elige(opcion); }, { role: 'menuitem' })));
  menu.showPopover();
  menu.style.left = `${Math.max(Math.min(x, innerWidth - menu.offsetWidth - 8), 8)}px`;
  menu.style.top = `${Math.max(Math.min(y, innerHeight - menu.offsetHeight - 8), 8)}px`;
  menu.firstChild.focus();
}

menu.addEventListener('keydown', suceso => {
  const paso = { ArrowDown: 1, ArrowUp: -1 }[suceso.key], lista = todos('button', menu);
  if (!paso) return;
  lista[(lista.indexOf(document.activeElement) + paso + lista.length) % lista.length].focus();
  suceso.preventDefault();
});
