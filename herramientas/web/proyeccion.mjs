// A toda pantalla: el lienzo solo o, al proyectar, el programa con su título, a qué hay que mirar y sus mandos.
import { una } from './documento.mjs';

const pagina = una('#programa'), escena = una('.escena'), marco = una('.lienzo');

function alterna(elemento) {
  if (document.fullscreenElement) document.exitFullscreen();
  else elemento.requestFullscreen?.().then(() => una('canvas', marco)?.focus());
}

export const completa = () => alterna(marco);
export const proyecta = () => alterna(escena);

/// La tecla p y, proyectando, las de pasar: `programa()` es el que se ve y `pasa(±1)` lo cambia. Las flechas son del
/// programa que las nombra; AvPág y RePág, que es lo que mandan los mandos de presentación, nunca.
export function atiendeProyeccion(programa, pasa) {
  document.addEventListener('keydown', suceso => {
    if (pagina.hidden || suceso.ctrlKey || suceso.altKey || suceso.metaKey) return;
    const flechas = !programa().mandos.some(m => m.teclas.some(([, orden]) => orden === 'especial DERECHA'));
    const paso = { PageDown: 1, PageUp: -1, ...flechas && { ArrowRight: 1, ArrowLeft: -1 } }[suceso.key];
    if (document.fullscreenElement === escena && paso) {
      suceso.preventDefault();
      suceso.stopPropagation();
      pasa(paso);
    } else if (suceso.key === 'p' && !suceso.target.closest('canvas, input, .editor')) proyecta();
  }, { capture: true });
}
