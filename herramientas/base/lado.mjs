// El índice de los programas, a un lado de la página o, si no cabe, plegado encima; y los botones de copiar.
import { todos, una } from './documento.mjs';

const lado = una('.programas'), ancha = matchMedia('(width >= 80rem)');

/// Desplegado donde cabe, y en un programa, que lo quiere todo para él, no.
export const acomodaLado = () => { lado.open = ancha.matches && !document.body.classList.contains('en-programa'); };

/// Señala el enlace a lo que se está viendo.
export function marcaEnLado(id) {
  for (const a of todos('a', lado)) {
    if (a.hash !== `#${id}`) {
      a.removeAttribute('aria-current');
      continue;
    }
    a.setAttribute('aria-current', 'location');
    const nav = lado.parentElement, r = a.getBoundingClientRect(), { top, bottom } = nav.getBoundingClientRect();
    if (r.height && (r.top < top + 90 || r.bottom > bottom - 20)) nav.scrollTop += r.top - top - nav.clientHeight / 3;
  }
}

/// Al pasar por un capítulo o por un programa, lo señala: es el que está un poco por debajo del borde de arriba.
export function sigueEnLado(selector) {
  const vigia = new IntersectionObserver(pasan => {
    for (const { isIntersecting, target } of pasan) if (isIntersecting) marcaEnLado(target.id);
  }, { rootMargin: '-15% 0px -84% 0px' });
  for (const parte of todos(selector)) vigia.observe(parte);
}

lado.addEventListener('click', suceso => { if (suceso.target.closest('a')) acomodaLado(); });
ancha.addEventListener('change', acomodaLado);
acomodaLado();

/// El texto de al lado de un botón de copiar. Donde el navegador no deja, queda seleccionado.
async function copia(boton) {
  const codigo = boton.previousElementSibling;
  try {
    await navigator.clipboard.writeText(codigo.textContent);
    boton.textContent = 'Copiado';
    setTimeout(() => { boton.textContent = 'Copiar'; }, 1500);
  } catch {
    getSelection().selectAllChildren(codigo);
  }
}
document.addEventListener('click', ({ target }) => { if (target.matches('.copia')) copia(target); });
