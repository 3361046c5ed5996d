// Del teclado a órdenes, y si el programa las usa.

const TECLAS = {
  Escape: 'Esc', Enter: 'Intro', Backspace: 'Retroceso', Delete: 'Supr', ' ': 'Espacio', ';': 'PuntoYComa',
};
const ESPECIALES = {
  ArrowLeft: 'IZQUIERDA', ArrowRight: 'DERECHA', ArrowUp: 'ARRIBA', ArrowDown: 'ABAJO', Home: 'INICIO', End: 'FIN',
  PageUp: 'REPAG', PageDown: 'AVPAG', Insert: 'INSERTAR',
};

// Con el bloqueo de mayúsculas, la tecla es la de sin él.
const sinBloqueo = letra => letra === letra.toLowerCase() ? letra.toUpperCase() : letra.toLowerCase();

export function ordenDeTecla(suceso) {
  const { key, ctrlKey, metaKey, altKey } = suceso;
  if (ctrlKey || metaKey || (altKey && key.length > 1)) return ''; // son del navegador
  if (TECLAS[key]) return `tecla ${TECLAS[key]}`;
  if (ESPECIALES[key]) return `especial ${ESPECIALES[key]}`;
  if (/^F([1-9]|1[01])$/.test(key)) return `especial ${key}`;
  return /^[!-~]$/.test(key) ? `tecla ${suceso.getModifierState('CapsLock') ? sinBloqueo(key) : key}` : '';
}

const DE_TODOS = /^(tecla Esc|especial F\d+)$/; // las de common/ventana.h, que fuera del lienzo son del navegador

/// Si es una tecla del programa: las de sus mandos, o cualquiera; y, con el foco en el lienzo, las de todos.
export function esSuya({ mandos, cualquiera }, orden, enLienzo) {
  if (DE_TODOS.test(orden)) return enLienzo;
  return cualquiera || mandos.some(({ teclas }) => teclas.some(([, suya]) => suya === orden));
}
