// A toda pantalla: el lienzo solo o, al proyectar, el programa con su título, a qué hay que mirar y sus mandos.
import { enCampo, esDelNavegador, una } from '../base/documento.mjs';

const pagina = una('#programa'), escena = una('.escena'), marco = una('.lienzo');

function alterna(elemento) {
  if (document.fullscreenElement) document.exitFullscreen();
  else elemento.requestFullscreen?.().then(() => una('canvas', marco)?.focus());
}

export const completa = () => alterna(marco);
export const proyecta = () => alterna(escena);

/// Las que no son del programa que se ve: AvPág y RePág, que es lo que mandan los mandos de presentación, nunca lo son.
function teclas({ mandos }, { pasa, salta }) {
  const suyas = new Set(mandos.flatMap(m => m.teclas.flat())), alterna = clase => () => escena.classList.toggle(clase);
  const flechas = suyas.has('especial DERECHA') ? {} : { ArrowRight: () => pasa(1), ArrowLeft: () => pasa(-1) };
  const otras = { b: alterna('negro'), '.': alterna('negro'), '?': alterna('con-teclas') };
  for (const tecla of Object.keys(otras)) if (suyas.has(tecla)) delete otras[tecla];
  const siempre = { PageDown: () => pasa(1), PageUp: () => pasa(-1), Home: () => salta(0), End: () => salta(-1) };
  return { ...siempre, ...flechas, ...otras };
}

function ayuda(hay) {
  const negro = ['b', '.'].filter(tecla => hay[tecla]).join(' o ');
  una('.teclas', escena).textContent = [hay.ArrowRight ? '← → o AvPág RePág pasan' : 'AvPág RePág pasan',
    'Inicio Fin, el primer programa del capítulo y el último', negro && `${negro} en negro`, 'F11 o Esc vuelve']
    .filter(Boolean).join(' · ');
}

/// La tecla p y, proyectando, las demás: `programa()` es el que se ve; `pasa(±1)` va a lo que sigue y `salta(0 o −1)`,
/// al principio o al final del capítulo.
export function atiendeProyeccion(programa, mueve) {
  document.addEventListener('fullscreenchange', () => escena.classList.remove('negro', 'con-teclas'));
  addEventListener('keydown', suceso => { // antes que el programa
    if (document.fullscreenElement !== escena || !programa() || esDelNavegador(suceso)) return;
    const hay = teclas(programa(), mueve), hace = hay[suceso.key];
    if (!hace) return;
    suceso.preventDefault();
    suceso.stopPropagation();
    if (!/^[b.]$/.test(suceso.key)) escena.classList.remove('negro');
    ayuda(hay);
    hace();
  }, { capture: true });
  document.addEventListener('keydown', suceso => {
    if (suceso.key === 'p' && !pagina.hidden && !esDelNavegador(suceso) && !enCampo(suceso)) proyecta();
  });
}
