'use strict';
// Las partes de la página de los programas que no tocan el documento; las demás están en web.js. Se prueban con Node
// (tests/paginas/partes.mjs).

const LADO_MAXIMO = 4096;
const ESPERA_MAXIMA = 10000; // ms seguidos que lleva un enlace
const LIMITES = { ordenes: 10000, ms: 60000, letras: 200 }; // de un guion: todas, todas las esperas, una orden
const PASO = 100;            // ms: una espera se repite a pasos

const corta = (texto, letras) => texto.length > letras ? texto.slice(0, letras) + '…' : texto;
const llano = texto => texto.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase();
const casa = (contenido, buscado) => llano(buscado).split(/\s+/).every(palabra => contenido.includes(palabra));

/// Una función que hace cada cosa una vez. Lo que falla se olvida, para poder intentarlo de nuevo.
function recuerda(hace, hechas = new Map()) {
  return cual => {
    if (!hechas.has(cual)) hechas.set(cual, hace(cual).catch(error => { hechas.delete(cual); throw error; }));
    return hechas.get(cual);
  };
}

/// Lo que empaqueta web.py.
async function descomprime(base64) {
  const comprimidos = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  const flujo = new Blob([comprimidos]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(flujo).arrayBuffer());
}

/// Los shaders cambiados que guarda la pestaña; nada, si lo guardado es de otra página.
function leeCambios(texto) {
  try {
    const pares = JSON.parse(texto ?? '[]');
    return pares.every(par => par.length === 2 && par.every(t => typeof t === 'string')) ? pares : [];
  } catch {
    return [];
  }
}

// --- programas y enlaces ----------------------------------------------------------------------------------------------

/// Por su nombre o por lo que es en el libro: grua, E3.5.
function programaDe(nombre, programas) {
  const n = nombre.toLowerCase();
  return programas.find(p => p.nombre === n) ?? programas.find(p => n && p.referencia.toLowerCase().split(' ').includes(n));
}

/// Con qué caso se empieza: el de cómo arranca el programa, que es lo que enseña el que no tiene guion; lo que se anima, andando.
const casoInicial = ({ casos, anima }) => casos.find(c => !c.guion) ?? { ...casos[0], ...anima && { guion: '' } };

/// Los ficheros de un programa en el orden de sus pestañas: los de su capítulo, y de ellos los shaders, delante.
function ordenaFuentes(rutas, capitulo) {
  const puesto = ruta => ['frag', 'vert', 'glsl', 'cpp', 'h'].indexOf(ruta.split('.').pop()) + (ruta.startsWith(capitulo) ? 0 : 9);
  return [...new Set(rutas)].sort((a, b) => puesto(a) - puesto(b));
}

/// Los %XX; los que no son nada se quedan como están, y ya dirá quien los lea que no los entiende.
const descifra = texto => texto.replace(/(?:%[\da-f]{2})+/gi, cifrado => {
  try {
    return decodeURIComponent(cifrado);
  } catch {
    return cifrado;
  }
});

/// #grua;tecla d;tecla d. Sin punto y coma no lleva guion. Y #ejercicio/L5.1, que puede llevarlo.
function leeEnlace(hash) {
  const [, ejercicio, nombre, guion] = descifra(hash.slice(1)).match(/^(ejercicio\/)?([^;]*)(?:;(.*))?$/s);
  return { ejercicio: Boolean(ejercicio), nombre, guion };
}

function hazEnlace(nombre, ordenes) {
  const grupos = []; // las seguidas e iguales, con ×N
  for (const orden of ordenes) {
    if (grupos.at(-1)?.orden === orden && !orden.includes('×')) ++grupos.at(-1).veces;
    else grupos.push({ orden, veces: 1 });
  }
  const textos = grupos.map(({ orden, veces }) => veces > 1 ? `${orden} ×${veces}` : orden);
  return '#' + encodeURI([nombre, ...textos].join(';')).replaceAll('#', '%23');
}

// --- guiones ----------------------------------------------------------------------------------------------------------

/// Las órdenes de un guion de fuera, una a una y cada una con su escala, para darlas poco a poco. Lo que pasa de los límites se
/// quita, y `recortado` lo dice. Un enlace no escribe ficheros, que podrían ser los de la página, ni cambia el tamaño, que es el
/// de ella. Lo mal escrito se deja: de eso se queja el programa.
function leeGuion(guion) {
  const ordenes = [];
  let escala = '', quedan = LIMITES.ms, recortado = false;
  for (const parte of guion.split(/[;\n]/)) {
    const entera = corta(parte.trim(), LIMITES.letras).replace(/\s+/g, ' ');
    const [, una, por] = entera.match(/^(.+) ×(\d+)$/) ?? [];
    const repetida = por >= 1 && por <= LIMITES.ordenes;
    const orden = repetida ? una + (/ ×\S*$/.test(una) ? ' ×1' : '') : entera;
    const [que, n] = orden.split(' ');
    if (que === 'escala') escala = orden;
    if (!que || /^(escala|captura|tamano)$/.test(que)) continue;
    for (let veces = repetida ? +por : 1; veces > 0; --veces) {
      if (ordenes.length >= LIMITES.ordenes) return { ordenes, recortado: true };
      if (!/^espera \d+$/.test(orden)) {
        ordenes.push({ orden, escala });
        continue;
      }
      const dura = Math.min(+n, ESPERA_MAXIMA, quedan);
      recortado ||= dura < +n;
      quedan -= dura;
      for (let ms = 0; ms < dura || ms === 0; ms += PASO) ordenes.push({ orden: `espera ${Math.min(dura - ms, PASO)}`, escala });
    }
  }
  return { ordenes, recortado };
}

/// Da cada orden mientras `da` responda que sí, y cada `tanda` ms deja que la página respire.
async function repite(ordenes, da, respira, { tanda = 50, ahora = () => performance.now() } = {}) {
  let desde = ahora();
  for (const orden of ordenes) {
    if (!da(orden)) return;
    if (ahora() - desde < tanda) continue;
    await respira();
    desde = ahora();
  }
}

/// Lo que se ha hecho con un programa, como órdenes de un guion que lo repite.
class Hecho {
  ordenes = [];
  #escala = '';

  constructor(anima) { this.anima = anima; }

  /// La escala es la de la ventana en que se ha dado la orden: se escribe delante de las del ratón, si no es la que ya había.
  apunta(orden, escala) {
    const [que, n] = orden.split(' '), [anterior, previo] = (this.ordenes.at(-1) ?? '').split(' ');
    if (que === 'tamano' || orden === 'especial F5' || (que === 'espera' && !this.anima)) return;
    if (/^(boton|arrastra|mueve|rueda)$/.test(que) && escala !== this.#escala) {
      this.#escala = escala;
      this.ordenes.push(escala);
    } else if (que === anterior && que === 'espera') {
      orden = `espera ${Math.min(+previo + +n, ESPERA_MAXIMA)}`;
      this.ordenes.pop();
    } else if (que === anterior && /^(arrastra|mueve)$/.test(que)) {
      this.ordenes.pop();
    }
    this.ordenes.push(orden);
  }
}

/// Para lo que se anima: los ms enteros que han pasado desde la vez anterior. Lo que sobra queda para la siguiente, y de una pausa de
/// la página (otra pestaña delante) solo cuenta el principio.
class Reloj {
  #antes;
  #resto = 0;

  constructor(ahora) { this.#antes = ahora; }

  pasa(ahora) {
    const ms = Math.min(Math.max(ahora - this.#antes, 0), 100) + this.#resto;
    this.#antes = ahora;
    this.#resto = ms % 1;
    return Math.floor(ms);
  }
}

// --- ejercicios -------------------------------------------------------------------------------------------------------

const TOLERA = 3;    // niveles, de 255, en que pueden diferir dos píxeles que coinciden: el redondeo de otra manera de escribirlo
const BASTA = 0.999; // la parte de la imagen que tiene que coincidir: en un contorno, ese redondeo decide píxeles enteros

/// La parte de dos imágenes RGBA de igual talla que coincide. En `diferencia`, si se da, gris lo que coincide y rojo lo que no.
function compara(lograda, objetivo, diferencia) {
  let iguales = 0;
  for (let i = 0; i < objetivo.length; i += 4) {
    const [r, g, b] = [objetivo[i], objetivo[i + 1], objetivo[i + 2]];
    const error = Math.max(Math.abs(lograda[i] - r), Math.abs(lograda[i + 1] - g), Math.abs(lograda[i + 2] - b));
    if (error <= TOLERA) ++iguales;
    if (!diferencia) continue;
    const gris = 150 + 0.35 * (0.3 * r + 0.6 * g + 0.1 * b), rojo = error > TOLERA ? Math.min(0.5 + error / 128, 1) : 0;
    diferencia[i] = gris + rojo * (214 - gris);
    diferencia[i + 1] = gris + rojo * (40 - gris);
    diferencia[i + 2] = gris + rojo * (20 - gris);
    diferencia[i + 3] = 255;
  }
  return 4 * iguales / objetivo.length;
}

/// Hacia abajo: el 100 % es que coinciden todos.
const porciento = parte => `${Math.floor(parte * 1000) / 10}\u00a0%`;

/// Los shaders que se enseñan en un ejercicio: los suyos, su pareja y los que se incluyen.
function delEjercicio(suyos, rutas) {
  const tallo = ruta => ruta.replace(/\.\w+$/, '');
  return [...new Set([...suyos, ...rutas.filter(r => r.endsWith('.glsl') || (!/\.(h|cpp)$/.test(r) && suyos.some(s => tallo(s) === tallo(r))))])];
}

/// Los códigos de los ejercicios resueltos que guarda el navegador.
const leeResueltos = texto => new Set((texto ?? '').split(' ').filter(codigo => /^[EL]\d+\.\d+$/.test(codigo)));

// --- lo que escribe un programa -----------------------------------------------------------------------------------------

const ERROR = /([\w./]+\.(?:vert|frag|glsl))(?::| no compila: ERROR: 0:)(\d+): (.*?)(?: — «.*»)?$/;

/// El error de un shader que dice una línea, si lo dice.
function leeError(linea, capitulo) {
  const mal = corta(linea, 1000).match(ERROR);
  if (mal) return { ruta: mal[1].includes('/') ? mal[1] : `${capitulo}/${mal[1]}`, linea: +mal[2], mensaje: mal[3] };
  if (/no enlazan|#include/.test(linea)) return { ruta: '', linea: 0, mensaje: linea };
}

// --- sucesos del navegador a órdenes ------------------------------------------------------------------------------------

const TECLAS = { Escape: 'Esc', Enter: 'Intro', Backspace: 'Retroceso', Delete: 'Supr', ' ': 'Espacio', ';': 'PuntoYComa' };
const ESPECIALES = { ArrowLeft: 'IZQUIERDA', ArrowRight: 'DERECHA', ArrowUp: 'ARRIBA', ArrowDown: 'ABAJO', Home: 'INICIO', End: 'FIN',
  PageUp: 'REPAG', PageDown: 'AVPAG', Insert: 'INSERTAR' };

function ordenDeTecla({ key, ctrlKey, metaKey, altKey }) {
  if (ctrlKey || metaKey || (altKey && key.length > 1) || key === 'F12') return ''; // son del navegador
  if (TECLAS[key]) return `tecla ${TECLAS[key]}`;
  if (ESPECIALES[key]) return `especial ${ESPECIALES[key]}`;
  if (/^F([1-9]|1[01])$/.test(key)) return `especial ${key}`;
  return /^[!-~]$/.test(key) ? `tecla ${key}` : '';
}

const BOTONES = ['IZQUIERDO', 'CENTRAL', 'DERECHO'];
const lugar = ({ x, y }) => `${Math.round(x)} ${Math.round(y)}`;

/// El ratón, los dedos y la rueda. Los puntos, { id, x, y }, son píxeles del lienzo. `da(orden)` dice si el programa la ha
/// recibido; `luego(función)` la llama en el próximo cuadro; `sigue` es si el programa atiende al ratón sin pulsar.
class Gestos {
  #dedos = new Map();
  #pulsado = '';
  #pendiente = '';
  #distancia = 0;
  #giro = 0;

  constructor({ da, luego, sigue }) { Object.assign(this, { da, luego, sigue }); }

  baja(punto, boton) {
    this.#levanta(this.#dedos.values().next().value); // con otro dedo ya no arrastra: es una pinza, la rueda
    this.#dedos.set(punto.id, punto);
    if (this.#dedos.size === 2) this.#distancia = this.#separacion();
    if (this.#dedos.size > 1 || !boton) return;
    this.suelta();
    if (this.da(`boton ${boton} abajo ${lugar(punto)}`)) this.#pulsado = boton; // mientras carga no hay nada que arrastrar
  }

  mueve(punto) {
    if (this.#dedos.has(punto.id)) this.#dedos.set(punto.id, punto);
    if (this.#dedos.size === 2) {
      const razon = this.#separacion() / this.#distancia;
      if (!(razon > 1.12 || razon < 1 / 1.12)) return;
      this.#distancia = this.#separacion();
      this.da(`rueda ${razon > 1 ? '+1' : '-1'} ${lugar(punto)}`);
    } else if (this.#pulsado || (this.sigue && !this.#dedos.size)) {
      if (!this.#pendiente) this.luego(() => this.suelta());
      this.#pendiente = `${this.#pulsado ? 'arrastra' : 'mueve'} ${lugar(punto)}`;
    }
  }

  sube(punto) {
    this.#dedos.delete(punto.id);
    this.#levanta(punto);
  }

  gira(punto, delta, modo) {
    this.#giro += delta * [1, 33, 400][modo]; // un panel táctil da muchos giros pequeños
    if (Math.abs(this.#giro) < 50) return;
    this.da(`rueda ${this.#giro < 0 ? '+1' : '-1'} ${lugar(punto)}`);
    this.#giro = 0;
  }

  /// El último sitio del ratón, que espera al cuadro.
  suelta() {
    const orden = this.#pendiente;
    this.#pendiente = '';
    if (orden) this.da(orden);
  }

  #levanta(punto) {
    if (!this.#pulsado || !punto) return;
    this.suelta();
    this.da(`boton ${this.#pulsado} arriba ${lugar(punto)}`);
    this.#pulsado = '';
  }

  #separacion() {
    const [a, b] = this.#dedos.values();
    return Math.hypot(a.x - b.x, a.y - b.y);
  }
}

// --- tallas y ficheros propios ------------------------------------------------------------------------------------------

/// Los píxeles de un lienzo que ocupa ese sitio en una pantalla de esa densidad.
function tallaDe({ width, height }, densidad) {
  const e = Math.min(densidad || 1, 2, LADO_MAXIMO / Math.max(width, height, 1));
  return { ancho: Math.max(Math.round(width * e), 1), alto: Math.max(Math.round(height * e), 1) };
}

/// Una imagen más grande se reduce.
function quepa({ width, height }, lado = 2048) {
  const e = Math.min(1, lado / Math.max(width, height));
  return { width: Math.max(Math.round(width * e), 1), height: Math.max(Math.round(height * e), 1) };
}

const esPpm = datos => datos[0] === 0x50 && datos[1] === 0x36; // un P6

function ppmDe(rgba, width, height) {
  const cabecera = new TextEncoder().encode(`P6\n${width} ${height}\n255\n`), ppm = new Uint8Array(cabecera.length + 3 * width * height);
  ppm.set(cabecera);
  for (let i = 0; i < width * height; ++i) ppm.set(rgba.subarray(4 * i, 4 * i + 3), cabecera.length + 3 * i);
  return ppm;
}

const nombreLlano = nombre => nombre.replace(/[^\w.-]/g, '_');
