// Elegir un píxel del lienzo: con un clic, o con las flechas e Intro. Mientras, no le llega nada al programa.
import { avisa, enCampo, esDelNavegador, una } from '../base/documento.mjs';
import { cierraExplicado, marca } from './explicado.mjs';

const marco = una('.lienzo'), mando = una('.explica');
const FLECHAS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const SALTO = 10; // píxeles, con mayúsculas
let pixel; // el que se elegiría; ninguno, si no se está eligiendo

const lienzo = () => una('canvas', marco);
const dentro = (v, n) => Math.min(Math.max(Math.floor(v), 0), n - 1);

export function apunta(si) {
  mando.setAttribute('aria-pressed', si);
  marco.classList.toggle('apunta', si);
  pixel = undefined;
  if (!si) return;
  cierraExplicado();
  pixel = [dentro(lienzo().width / 2, lienzo().width), dentro(lienzo().height / 2, lienzo().height)];
  marca(pixel);
  lienzo().focus({ preventScroll: true });
  avisa('Pulsa un punto de la imagen; o muévete con las flechas (con mayúsculas, más) y pulsa Intro. Esc lo deja.');
}

function deja() {
  apunta(false);
  cierraExplicado();
  avisa('');
  mando.focus();
}

/// `elige([x, y])`: del lienzo, desde arriba a la izquierda. `hay()`: si hay de qué.
export function atiendePunteria(elige, hay) {
  const elegido = cual => { apunta(false); elige(cual); };
  const alterna = () => { if (pixel) deja(); else if (hay()) apunta(true); };
  mando.onclick = alterna;
  marco.addEventListener('pointerdown', suceso => {
    if (!pixel || suceso.target !== lienzo()) return;
    suceso.stopPropagation();
    suceso.preventDefault();
    const { width, height } = lienzo(), r = lienzo().getBoundingClientRect();
    elegido([dentro((suceso.clientX - r.left) * width / r.width, width),
      dentro((suceso.clientY - r.top) * height / r.height, height)]);
  }, true);
  marco.addEventListener('keydown', suceso => {
    if (!pixel || suceso.target !== lienzo() || esDelNavegador(suceso) || suceso.key === 'Tab') return;
    suceso.stopPropagation();
    suceso.preventDefault();
    const paso = FLECHAS[suceso.key], salto = suceso.shiftKey ? SALTO : 1;
    if (suceso.key === 'Enter') elegido(pixel);
    else if (/^(Escape|x)$/.test(suceso.key)) deja();
    else if (paso) marca(pixel = [[0, 'width'], [1, 'height']].map(([i, n]) => dentro(pixel[i] + salto * paso[i],
      lienzo()[n])));
  }, true);
  document.addEventListener('keydown', suceso => {
    const deOtro = enCampo(suceso) || suceso.target.closest('.explicacion') || document.fullscreenElement;
    if (suceso.key === 'x' && !esDelNavegador(suceso) && !deOtro && hay()) alterna();
  });
}
