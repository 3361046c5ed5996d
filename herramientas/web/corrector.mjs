// Corregir en la página: lo escrito y el original juegan los mismos guiones que en ./lab corrige, que los escribe
// herramientas/ejercicios/en_pagina.py, y los compara herramientas/comparador, que va en lab.wasm.
import { crea } from '../base/documento.mjs';
import { laboratorio, recuerda } from './datos.mjs';
import { acabaMal, acorta, aparte, BIEN, CASI, nota, parte } from './nota.mjs';

const ANCHO = 240, ALTO = 180;
const CUELGUES = 2;   // tras los que no se juega más
const INTENTOS = 24;  // para acortar un guion
// los rótulos no se piden: se ven los trazos, que en las curvas son lo que se pide
const COMO = { ancho: ANCHO, alto: ALTO, suavizado: false, entorno: { LAB_SIN_ENCIMA: 'rotulo' },
  argumentos: ['-titulos', '/titulos'] };
const respira = () => new Promise(sigue => setTimeout(sigue));

const comparador = recuerda(async () => {
  const modulo = await laboratorio();
  return Laboratorio({ thisProgram: 'compara', print: () => {}, printErr: () => {},
    instantiateWasm: (lo, recibe) => { WebAssembly.instantiate(modulo, lo).then(recibe); return {}; } });
});

const cabecera = ppm => new TextDecoder().decode(ppm.subarray(0, 300)).match(/^(?:P6|#.*|\d+ \d+)\n/gm).join('');

/// De dos imágenes, la primera la esperada: BIEN, si son la misma con esa tolerancia; CASI, si una persona las tendría
/// por la misma; si no, 0.
async function seParecen(una, otra, tolerancia) {
  if (una.length === otra.length && una.every((b, i) => b === otra[i])) return BIEN;
  if (cabecera(una) !== cabecera(otra)) return 0;
  const lab = await comparador('');
  lab.FS.writeFile('/una', una);
  lab.FS.writeFile('/otra', otra);
  const vale = como => lab.callMain(['/una', '/otra', `--${como}`]) === 0;
  return vale(tolerancia) ? BIEN : vale('otro') ? CASI : 0;
}

/// Un programa que juega: se le da una orden y deja una imagen. `arranca(opciones)` lo pone en marcha.
class Jugador {
  texto = [];
  dicho = [];
  estado = 0;
  #escala = '';

  static async empieza(arranca) {
    const jugador = new Jugador(), { texto, dicho } = jugador;
    const di = (linea, esError) => (esError ? dicho : texto).push(linea.trimEnd());
    try {
      jugador.sesion = await arranca({ ...COMO, lienzo: crea('canvas'), di });
      jugador.mira();
    } catch (error) {
      jugador.acaba(error, 1);
    }
    return jugador;
  }

  acaba(error, estado) {
    this.cuelga = /no acaba/.test(error?.message);
    this.error = error;
    this.estado = estado;
  }

  get vivo() { return Boolean(this.sesion?.vivo); }

  da(orden) {
    if (!this.vivo) return;
    if (orden.startsWith('escala')) this.#escala = `${orden}; `;
    this.sesion.orden(this.#escala + orden);
    this.mira();
  }

  mira() { if (this.sesion.fallo) this.acaba(this.sesion.error, this.sesion.estado); }

  /// La que se ve, si aún la hay.
  imagen() {
    this.da('captura /imagen.ppm');
    return this.vivo ? this.sesion.lee('/imagen.ppm') : undefined;
  }

  get titulos() {
    const escritos = this.sesion ? new TextDecoder().decode(this.sesion.lee('/titulos')).split('\n') : [];
    const titulos = escritos.map(t => t.trimEnd()).filter((t, i) => t && t !== escritos[i - 1]?.trimEnd());
    return titulos.map(t => t.replace(/^título: /, '').replaceAll('-0°', '0°'));
  }

  cierra() { this.sesion?.cierra(); }
}

export class Corrector {
  /// `datos`, los de ejercicios.js; `suyo` y `original`, cómo arranca cada uno; `sigue()`, si aún hace falta.
  constructor(datos, { suyo, original, sigue }) { Object.assign(this, datos, { suyo, original, sigue }); }

  /// Los dos juegan esas órdenes: { parecido, el de las imágenes que menos se parecen; en, en cuál se apartan antes, e
  /// imagenes, las dos; aparte, si llega al final; y de lo suyo, cuelga, error y dicho }.
  async juega(ordenes) {
    if (!this.sigue()) throw new DOMException('ya no hace falta', 'AbortError');
    const [debe, es] = await Promise.all([this.original, this.suyo].map(a => Jugador.empieza(a)));
    const hecho = { parecido: BIEN }, todas = ['', ...ordenes];
    const empeora = (parecido, i, imagenes) => {
      if (parecido < BIEN && hecho.en === undefined) Object.assign(hecho, { en: i, imagenes });
      hecho.parecido = Math.min(hecho.parecido, parecido);
    };
    try {
      for (const [i, orden] of todas.entries()) {
        for (const jugador of orden ? [debe, es] : []) jugador.da(orden);
        if (!es.vivo) {
          empeora(0, i);
          break;
        }
        if (hecho.parecido) {
          const imagenes = [debe.imagen(), es.imagen()];
          empeora(imagenes[1] ? await seParecen(...imagenes, this.reglas.tolerancia) : 0, i, imagenes);
        }
        if (i % 4 === 3) await respira();
      }
      if (acabaMal(debe, es)) empeora(0, ordenes.length);
      if (es.vivo) hecho.aparte = aparte(debe, es);
      const dicho = es.dicho.filter(linea => !debe.dicho.includes(linea));
      return Object.assign(hecho, { cuelga: es.cuelga, error: es.error, dicho });
    } finally {
      debe.cierra();
      es.cierra();
    }
  }

  /// Todos los guiones: { nota, la de lo entero; guiones, con lo de cada uno; otros, lo que cuenta una vez; reglas }.
  /// `avanza(n, de)` según se juegan.
  async corrige(avanza = () => {}) {
    const guiones = this.guiones.map(g => ({ ...g }));
    let otros = {}, cuelgan = 0;
    for (const [i, guion] of guiones.entries()) {
      avanza(i, guiones.length);
      const { aparte: suyo, ...hecho } = await this.juega(guion.ordenes);
      Object.assign(guion, hecho);
      otros = { ...suyo, ...otros };
      if (hecho.cuelga && ++cuelgan >= CUELGUES) break;
    }
    return { nota: nota(guiones, otros, this.reglas), guiones, otros, reglas: this.reglas };
  }

  /// Lo que vale lo que arranca así, de 0 a 1: 0 si hace lo mismo que lo que arranca como diga `hazNada()`, si lo hay.
  async parte(suyo, hazNada) {
    const con = (suyo, original) => new Corrector(this, { suyo, original, sigue: this.sigue }).corrige();
    const suya = parte((await con(suyo, this.original)).guiones, this.reglas);
    const nada = suya < 1 && await hazNada();
    const esNada = nada && (await con(suyo, nada)).guiones.every(g => (g.parecido ?? BIEN) === BIEN);
    return esNada ? 0 : suya;
  }

  /// Del guion que antes falla: { ordenes, las que bastan; cómo se dice; pixel, el que más se aparta, de la ventana de
  /// siempre; con qué error, qué ha dicho, y si es casi igual }.
  async primero(guiones) {
    const falla = guiones.filter(g => g.parecido < BIEN).sort((a, b) => a.en - b.en || b.vale - a.vale)[0];
    if (!falla) return undefined;
    let ultimo = falla, ordenes = falla.ordenes.slice(0, falla.en);
    const seAparta = async ordenes => {
      const hecho = await this.juega(ordenes);
      if (hecho.parecido < BIEN) ultimo = hecho;
      return hecho.parecido < BIEN;
    };
    if (!falla.cuelga && ordenes.length) ordenes = await acorta(ordenes, seAparta, INTENTOS);
    const { imagenes, error, dicho, parecido } = ultimo;
    return { ordenes, dice: this.enPalabras(ordenes), pixel: pixelDe(imagenes), error, dicho, casi: parecido === CASI };
  }

  /// Lo que hace una persona.
  enPalabras(ordenes) {
    const dichas = ordenes.filter(o => !o.startsWith('escala')).map(orden => {
      const [una, veces] = orden.split(' ×');
      return this.palabras[una] + (veces ? ` ${veces} veces` : '');
    });
    return dichas.length ? dichas.join('; ') : 'nada más abrirlo';
  }
}

/// El que más se aparta, en una ventana de 960×720; ninguno, si no son de la talla en que se juega.
function pixelDe([una, otra] = []) {
  if (!una || !otra || !cabecera(una).includes(`\n${ANCHO} ${ALTO}\n`) || una.length !== otra.length) return undefined;
  let peor = 0, donde = 0;
  for (let i = una.length - 3 * ANCHO * ALTO; i < una.length; ++i) {
    const aparta = Math.abs(una[i] - otra[i]);
    if (aparta > peor) [peor, donde] = [aparta, Math.floor((i - una.length + 3 * ANCHO * ALTO) / 3)];
  }
  return [4 * (donde % ANCHO) + 2, 4 * Math.floor(donde / ANCHO) + 2];
}
