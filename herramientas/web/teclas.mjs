// Del teclado a órdenes.

const TECLAS = {
  Escape: 'Esc', Enter: 'Intro', Backspace: 'Retroceso', Delete: 'Supr', ' ': 'Espacio', ';': 'PuntoYComa',
};
const ESPECIALES = {
  ArrowLeft: 'IZQUIERDA', ArrowRight: 'DERECHA', ArrowUp: 'ARRIBA', ArrowDown: 'ABAJO', Home: 'INICIO', End: 'FIN',
  PageUp: 'REPAG', PageDown: 'AVPAG', Insert: 'INSERTAR',
};

export function ordenDeTecla({ key, ctrlKey, metaKey, altKey }) {
  if (ctrlKey || metaKey || (altKey && key.length > 1)) return ''; // son del navegador
  if (TECLAS[key]) return `tecla ${TECLAS[key]}`;
  if (ESPECIALES[key]) return `especial ${ESPECIALES[key]}`;
  if (/^F([1-9]|1[01])$/.test(key)) return `especial ${key}`;
  return /^[!-~]$/.test(key) ? `tecla ${key}` : '';
}
