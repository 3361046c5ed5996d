// Lo que guarda el navegador: los ficheros cambiados y los ejercicios resueltos. Puede haberlo guardado otra página.
import { json, recuerda } from './datos.mjs';
import { esShader } from './fuentes.mjs';

/// En sessionStorage, mientras no se cierra la pestaña, o en localStorage. Con un texto, lo guarda y dice si ha podido:
/// puede estar lleno, o no permitirlo el navegador.
export function recuerdo(almacen, clave, texto) {
  try {
    if (texto === undefined) return globalThis[almacen].getItem(clave);
    globalThis[almacen].setItem(clave, texto);
    return true;
  } catch {
    return null;
  }
}

/// Los ficheros cambiados: parejas de ruta y texto.
export function leeCambios(texto) {
  try {
    const pares = JSON.parse(texto ?? '[]');
    return pares.every(par => par.length === 2 && par.every(t => typeof t === 'string')) ? pares : [];
  } catch {
    return [];
  }
}

/// Los códigos de los ejercicios resueltos.
export const leeResueltos = texto =>
  new Set((texto ?? '').split(' ').filter(codigo => /^([EL]\d+\.\d+|[a-z0-9_]+)$/.test(codigo)));

/// Lo que hace falta para hacer cada ejercicio y para corregirlo (herramientas/ejercicios/en_pagina.py).
const deTodos = recuerda(() => json('ejercicios'));
export const deEjercicio = async codigo => (await deTodos(''))[codigo];

/// Un fichero tal como está en el programa.
export const solucion = async ruta =>
  (await json(esShader(ruta) ? 'shaders' : ruta.startsWith('common/') ? 'comun' : 'codigo'))[ruta];

/// Los ficheros que se tocan: los de la pestaña o, en un ejercicio, los suyos, que parten de su esqueleto.
export class Taller {
  guardado = true; // lo último que se ha apuntado

  /// `codigo`, el del ejercicio; `deDonde(ruta)`, dónde está en el laboratorio lo que se hace en esa ruta.
  constructor(almacen, clave, codigo, deDonde = ruta => ruta) {
    Object.assign(this, { almacen, clave, codigo, deDonde });
    this.relee();
    this.aparte = this.cambios.size > 0 && Boolean(recuerdo(almacen, this.#dibujando));
  }

  get #dibujando() { return `${this.clave}, dibujando`; }

  /// Que se va a dibujar con lo cambiado, o que ya se ha visto. Un shader puede dejar la página sin responder: quien la
  /// abre otra vez sin haberlo visto lo encuentra escrito, pero aparte, y ve lo de antes hasta que lo cambie.
  dibuja(empieza) { recuerdo(this.almacen, this.#dibujando, empieza ? 'sí' : ''); }

  relee() { this.cambios = new Map(leeCambios(recuerdo(this.almacen, this.clave))); }

  async esqueleto() { return this.codigo ? (await deEjercicio(this.codigo)).esqueleto : {}; }
  async escritos() { return { ...await this.esqueleto(), ...Object.fromEntries(this.cambios) }; }
  async textos() { return this.aparte ? this.esqueleto() : this.escritos(); }
  async solucion(ruta) { return await solucion(this.deDonde(ruta)) ?? ''; }
  async original(ruta) { return (await this.esqueleto())[ruta] ?? await solucion(ruta) ?? ''; }

  apunta(ruta, texto, original) {
    this.aparte = false;
    if (texto === original) this.cambios.delete(ruta);
    else this.cambios.set(ruta, texto);
    this.guardado = Boolean(recuerdo(this.almacen, this.clave, JSON.stringify([...this.cambios])));
  }
}
