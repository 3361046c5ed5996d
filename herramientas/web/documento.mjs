// Lo poco del documento que usan todos.

export const todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
export const una = (selector, raiz = document) => raiz.querySelector(selector);

export function crea(etiqueta, propiedades = {}, ...hijos) {
  const e = Object.assign(document.createElement(etiqueta), propiedades);
  e.append(...hijos);
  return e;
}

export const boton = (texto, hace, propiedades = {}) =>
  crea('button', { type: 'button', textContent: texto, onclick: hace, ...propiedades });

export const avisa = texto => { una('.aviso').textContent = texto; };
