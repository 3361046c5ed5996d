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

/// La primera, si las dos imágenes son la misma: así se guarda una.
const laMisma = (una, otra) => una?.length === otra.length && una.every((b, i) => b === otra[i]) ? una : otra;

/// Lo que deja un programa con unas órdenes: las imágenes que hay al empezar y tras cada una, los títulos, lo que
/// escribe (texto) y lo que dice (dicho), y cómo acaba.
class Partida {
  imagenes = [];
  titulos = [];
  texto = [];
  dicho = [];
  estado = 0;

  /// `arranca(opciones)` lo pone en marcha; tras cada imagen `sigue(imagen, i)` dice si hace falta otra, o lanza.
  static async juega(arranca, ordenes, sigue) {
    const partida = new Partida(), { imagenes, texto, dicho } = partida;
    const di = (linea, esError) => (esError ? dicho : texto).push(linea.trimEnd());
    let sesion, escala = '';
    try {
      sesion = await arranca({ ...COMO, lienzo: crea('canvas'), di });
    } catch (error) {
      return partida.#acaba(error, 1);
    }
    try {
      for (const [i, orden] of ['', ...ordenes].entries()) {
        if (orden.startsWith('escala')) escala = `${orden}; `;
        if (orden) sesion.orden(escala + orden);
        sesion.orden('captura /imagen.ppm');
        if (!sesion.vivo) break;
        imagenes.push(laMisma(imagenes.at(-1), sesion.lee('/imagen.ppm')));
        if (!await sigue(imagenes[i], i)) break;
        if (i % 4 === 3) await respira();
      }
      partida.#titula(new TextDecoder().decode(sesion.lee('/titulos')).split('\n'));
      partida.vivo = sesion.vivo;
      return sesion.fallo ? partida.#acaba(sesion.error, sesion.estado) : partida;
    } finally {
      sesion.cierra();
    }
  }

  #acaba(error, estado) { return Object.assign(this, { error, estado, cuelga: /no acaba/.test(error?.message) }); }

  #titula(escritos) {
    const titulos = escritos.map(t => t.trimEnd()).filter((t, i) => t && t !== escritos[i - 1]?.trimEnd());
    this.titulos = titulos.map(t => t.replace(/^título: /, '').replaceAll('-0°', '0°'));
  }
}

export class Corrector {
  /// `datos`, los de ejercicios.js; `suyo` y `original`, cómo arranca cada uno; `sigue()`, si aún hace falta;
  /// `esperadas`, lo que ha jugado ya el original.
  constructor(datos, { suyo, original, sigue, esperadas = new Map() }) {
    Object.assign(this, datos, { suyo, original, sigue, esperadas });
  }

  /// La partida de lo que arranca así, mientras haga falta y `vale(imagen, i)`.
  juega(arranca, ordenes, vale = () => true) {
    return Partida.juega(arranca, ordenes, (imagen, i) => {
      if (!this.sigue()) throw new DOMException('ya no hace falta', 'AbortError');
      return vale(imagen, i);
    });
  }

  /// La del original, que se guarda: no se deja a medias, que otra corrección puede esperarla.
  esperada(ordenes) {
    const clave = ordenes.join(';');
    if (!this.esperadas.has(clave)) this.esperadas.set(clave, Partida.juega(this.original, ordenes, () => true));
    return this.esperadas.get(clave);
  }

  /// Las de todos los guiones: mientras se compila lo suyo.
  async adelanta() { for (const { ordenes } of this.guiones) if (this.sigue()) await this.esperada(ordenes); }

  /// { parecido, el de las imágenes que menos se parecen; en, en cuál se apartan antes, e imagenes, las dos; aparte, si
  /// llega al final; y de lo suyo, la partida, cuelga, error y dicho }.
  async compara(debe, es) {
    const dicho = es.dicho.filter(linea => !debe.dicho.includes(linea));
    const hecho = { parecido: BIEN, partida: es, cuelga: es.cuelga, error: es.error, dicho };
    const empeora = (parecido, i) => {
      if (parecido < BIEN && hecho.en === undefined)
        Object.assign(hecho, { en: i, imagenes: [debe.imagenes[i], es.imagenes[i]] });
      hecho.parecido = Math.min(hecho.parecido, parecido);
    };
    for (let i = 0; i < debe.imagenes.length && hecho.parecido; ++i)
      empeora(await this.seParecen(debe.imagenes[i], es.imagenes[i]), i);
    if (acabaMal(debe, es)) empeora(0, debe.imagenes.length - 1);
    return es.vivo ? { ...hecho, aparte: aparte(debe, es) } : hecho;
  }

  seParecen(una, otra) { return otra ? seParecen(una, otra, this.reglas.tolerancia) : 0; }

  /// Lo que arranca así juega esas órdenes hasta que se aparta de esa partida: { suya; igual, si no se aparta; exacta,
  /// si las imágenes son las mismas }.
  async deja(arranca, ordenes, partida) {
    let igual = true, exacta = true;
    const suya = await this.juega(arranca, ordenes, async (imagen, i) => {
      exacta &&= laMisma(partida.imagenes[i], imagen) !== imagen;
      igual = exacta || await this.seParecen(imagen, partida.imagenes[i]) === BIEN;
      return igual;
    });
    return { suya, exacta, igual: igual && !acabaMal(suya, partida) };
  }

  /// Todos los guiones, jugados por lo que arranca así: { nota, la de lo entero; guiones, con lo de cada uno; otros, lo
  /// que cuenta una vez; reglas }. `avanza(n, de)` según se juegan; `hazNada()` dice cómo arranca lo de partida.
  async corrige({ avanza = () => {}, suyo = this.suyo, hazNada = () => {} } = {}) {
    const guiones = this.guiones.map(g => ({ ...g }));
    let otros = {}, cuelgan = 0;
    for (const [i, guion] of guiones.entries()) {
      avanza(i, guiones.length);
      const debe = await this.esperada(guion.ordenes);
      const { aparte: suyas, ...hecho } = await this.compara(debe, await this.juega(suyo, guion.ordenes));
      Object.assign(guion, hecho, { aMedias: await this.#aMedias({ ...guion, ...hecho }, debe, hazNada) });
      otros = { ...suyas, ...otros };
      if (hecho.cuelga && ++cuelgan >= CUELGUES) break;
    }
    return { nota: nota(guiones, otros, this.reglas), guiones, otros, reglas: this.reglas };
  }

  /// Si es un caso que falla al seguirlo y lo suyo se ve bien, y en lo de partida no.
  async #aMedias({ parecido, suyas, ordenes, partida }, debe, hazNada) {
    const bien = async ({ imagenes }) => await this.seParecen(debe.imagenes[suyas], imagenes[suyas]) === BIEN;
    if (parecido || suyas === undefined || !this.reglas.medias || !await bien(partida)) return false;
    const nada = await hazNada();
    return Boolean(nada) && !await bien(await this.juega(nada, ordenes.slice(0, suyas)));
  }

  /// Lo que vale lo que arranca así: { parte, de 0 a 1; guiones }. 0 si hace lo mismo que lo que arranca como diga
  /// `hazNada()`, si lo hay.
  async parte(suyo, hazNada) {
    const { guiones } = await this.corrige({ suyo, hazNada }), suya = parte(guiones, this.reglas);
    const nada = suya < 1 && await hazNada();
    let esNada = Boolean(nada);
    for (const { ordenes, partida } of guiones)
      if (esNada && partida) esNada = (await this.deja(nada, ordenes, partida)).igual;
    return { parte: esNada ? 0 : suya, guiones };
  }

  /// Del guion que antes falla: { ordenes, las que bastan; cómo se dice; pixel, el que más se aparta, de la ventana de
  /// siempre; con qué error, qué ha dicho, y si es casi igual }.
  async primero(guiones) {
    const falla = guiones.filter(g => g.parecido < BIEN).sort((a, b) => a.en - b.en || b.pesa - a.pesa)[0];
    if (!falla) return undefined;
    let ultimo = falla, ordenes = falla.ordenes.slice(0, falla.en);
    const seAparta = async ordenes => {
      const hecho = await this.compara(await this.juega(this.original, ordenes), await this.juega(this.suyo, ordenes));
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
