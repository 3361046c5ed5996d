// Lo poco del documento que usan todos los módulos de las páginas.

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

/// Las teclas que llevan algo apretado son del navegador.
export const esDelNavegador = ({ ctrlKey, altKey, metaKey }) => ctrlKey || altKey || metaKey;

/// Lo que se teclea donde se escribe o se elige es de quien escribe.
export const enCampo = ({ target }) => target.closest('input, textarea, select, .editor');

/// Los %XX de una dirección; los que no son nada se quedan como están, y ya dirá quien los lea que no los entiende.
export const descifra = texto => texto.replace(/(?:%[\da-f]{2})+/gi, cifrado => {
  try {
    return decodeURIComponent(cifrado);
  } catch {
    return cifrado;
  }
});
