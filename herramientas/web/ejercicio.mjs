// Un ejercicio: el programa con lo de quien lo hace, unos shaders o los ficheros de la carpeta de ./lab nuevo, y, al
// lado, el original. Lo que se hace con uno se hace con el otro.
import { deEjercicio, Taller } from './almacen.mjs';
import { boton, crea, todos, una } from '../base/documento.mjs';
import { haceZip } from './carpeta.mjs';
import { Corrector } from './corrector.mjs';
import { guarda } from './descarga.mjs';
import { esFuente, esShader } from './fuentes.mjs';
import { BASTA, compara, pixeles, porciento } from './imagenes.mjs';
import { BIEN } from './nota.mjs';
import { arranca } from './programa.mjs';
import { ponResueltos } from './resueltos.mjs';

const veredicto = una('.veredicto'), parecido = una('.parecido output');

function dictamina(texto, clase = '') {
  if (veredicto.textContent !== texto) veredicto.textContent = texto;
  veredicto.className = `veredicto ${clase}`;
}

/// Lo de una carpeta, mientras no se ha compilado: un lienzo sin nada.
function sinCompilar({ lienzo, ancho, alto }) {
  Object.assign(lienzo, { width: ancho, height: alto });
  return { lienzo, leidos: new Set(), vivo: true, fallo: false, vacio: true, escribe() {}, opciones: () => [],
    cierra: () => lienzo.remove(),
    orden: texto => {
      const [, width, height] = texto.match(/^tamano (\d+) (\d+)/) ?? [];
      if (width) Object.assign(lienzo, { width, height });
    } };
}

export class Ejercicio {
  #escena;
  #empiezaCaso;
  #recien;    // se acaba de llegar: si lo de antes no vale en un caso, se empieza por él
  #revision;  // la última; se deja si se escribe otra cosa
  #pendiente; // una comparación
  #resuelto = false; // lo escrito
  #esperadas = new Map();
  #modulos = new Map();

  /// `datos` son los de EJERCICIOS; `empiezaCaso(caso)` lo cambia en la escena.
  constructor(datos, { escena, empiezaCaso, recien }) {
    Object.assign(this, datos);
    this.taller = new Taller('localStorage', `ejercicio ${this.codigo}`, this.codigo, ruta => this.#enSuCapitulo(ruta));
    this.#escena = escena;
    this.#empiezaCaso = empiezaCaso;
    this.#recien = recien;
  }

  // --- sus ficheros: los de un ejercicio de shaders, en su sitio; los de una carpeta, en ella ---

  /// Dónde está en el laboratorio lo que va en esa ruta.
  #enSuCapitulo(ruta) { return this.carpeta ? ruta.replace(this.carpeta, this.programa.capitulo) : ruta; }

  /// Y al revés: la del fichero de su carpeta de que habla un error.
  rutaDe(ruta) {
    const suya = `${this.carpeta}/${ruta.split('/').pop()}`;
    return suya in this.pide ? suya : ruta;
  }

  /// El programa, como si estuviera en su carpeta.
  get suyo() { return { ...this.programa, capitulo: this.carpeta ?? this.programa.capitulo }; }

  /// Si lo escrito hay que compilarlo: no, mientras se pidan y se cambien solo shaders.
  get seCompila() {
    return Boolean(this.carpeta) && [...Object.keys(this.pide), ...this.taller.cambios.keys()].some(esFuente);
  }

  /// Lo que en el laboratorio no se ve, porque es lo que se pide: sin texto.
  get queNoSeVe() {
    return Object.fromEntries(Object.keys(this.pide).map(ruta => [this.#enSuCapitulo(ruta), undefined]));
  }

  /// Los que se compilan.
  async fuentes() {
    return Object.fromEntries(Object.entries(await this.taller.escritos()).filter(([ruta]) => esFuente(ruta)));
  }

  /// Lo escrito, en marcha; si hay que compilarlo, con lo compilado.
  async arranca({ textos, compilado, ...como }) {
    const escritos = await textos ?? await this.taller.textos();
    if (!this.carpeta) return arranca(this.programa, { ...como, textos: escritos });
    if (this.seCompila && !compilado) return sinCompilar(como);
    // el original los busca como los de su capítulo
    const alias = (ruta, texto) => this.seCompila ? {} : { [`${this.carpeta}/${this.#enSuCapitulo(ruta)}`]: texto };
    const otros = Object.assign({}, ...Object.entries(escritos).map(e => alias(...e)));
    const sesion = await arranca(this.suyo, { ...como, ...this.seCompila && { compilado },
      raices: [`/lab/${this.carpeta}`], textos: { ...this.queNoSeVe, ...escritos, ...otros } });
    return Object.assign(Object.create(sesion), { escribe: (ruta, texto) => {
      for (const e of Object.entries({ [ruta]: texto, ...alias(ruta, texto) })) sesion.escribe(...e);
    } });
  }

  /// Otros, en lugar de lo escrito: los de una carpeta, con el nombre que tenga, o unos shaders.
  async abre({ fuentes: { ...fuentes }, carpeta }) {
    const principal = `${this.programa.nombre}.cpp`, otro = `${carpeta}.cpp`;
    if (this.carpeta && !fuentes[principal] && fuentes[otro]) {
      fuentes[principal] = fuentes[otro];
      delete fuentes[otro];
    }
    const ruta = f => this.carpeta ? `${this.carpeta}/${f}` : Object.keys(this.pide).find(r => r.endsWith(`/${f}`));
    const suyos = Object.entries(fuentes).filter(([f]) => ruta(f));
    const piden = Object.keys(this.pide).map(r => r.split('/').pop());
    if (!suyos.length) throw new Error(`Ahí no está ${piden.join(', ')}.`);
    this.taller.cambios.clear();
    for (const [f, texto] of suyos) this.taller.apunta(ruta(f), texto, await this.taller.original(ruta(f)));
  }

  /// El de esos fuentes, que hace `compila()` si no se ha hecho ya: los de la solución, una vez.
  modulo(fuentes, compila) {
    if (!this.#modulos.has(fuentes)) this.#modulos.set(fuentes, compila());
    return this.#modulos.get(fuentes);
  }

  // --- lo que se ve ---

  /// Lo que se pide. `cambiaDeVista` enseña la solución u otra vez lo escrito, y dice si es la solución; `corrige()` la
  /// corrige.
  pon(cambiaDeVista, corrige) {
    dictamina('');
    parecido.textContent = '…';
    for (const cuadro of todos('.cuadro')) cuadro.replaceChildren();
    const pide = Object.entries(this.pide).map(([fichero, que]) =>
      crea('p', { className: 'enunciado' }, crea('code', { textContent: fichero.split('/').pop() }), `: ${que}.`));
    if (this.carpeta) {
      const enunciado = crea('div', { className: 'enunciado' });
      deEjercicio(this.codigo).then(datos => { enunciado.innerHTML = datos.enunciado; });
      pide.unshift(crea('summary', { textContent: 'Lo que se pide' }), enunciado,
        crea('p', {}, `Falta lo que va entre cada «// ${this.codigo}: …» y su «// fin de ${this.codigo}»:`));
    }
    if (Object.keys(this.pide).some(esShader))
      pide.push(crea('p', {}, 'En un shader, un número real lleva punto: 1.0 y no 1.'));
    const ver = boton('Ver la solución', async () => {
      ver.textContent = await cambiaDeVista() ? 'Volver a lo mío' : 'Ver la solución';
    });
    const descarga = boton(this.carpeta ? 'Descarga mi carpeta' : 'Descarga mi shader', () => this.descarga(), {
      className: 'descarga', title: 'Lo escrito, para ./lab corrige. Si se suelta en la página, se abre' });
    una('.tarea').replaceChildren(crea(this.carpeta ? 'details' : 'div', { open: true }, ...pide),
      boton('Corregir', corrige, { className: 'corrige', title: 'La nota que da ./lab corrige' }),
      ...this.oculto ? [] : [ver], descarga);
    una('.correccion').hidden = true;
  }

  /// Lo escrito: cada shader, con su nombre, o la carpeta, en un .zip.
  async descarga() {
    const textos = await this.taller.escritos();
    if (!this.carpeta)
      return Object.keys(this.pide).forEach(ruta => guarda(new Blob([textos[ruta]]), ruta.split('/').pop()));
    const { sueltos } = await deEjercicio(this.codigo), todos = { ...textos };
    for (const [f, texto] of Object.entries(sueltos)) todos[`${this.carpeta}/${f}`] = texto;
    const suyos = Object.entries(todos).map(([ruta, texto]) => [ruta.replace('mios/', ''), texto]);
    guarda(haceZip(Object.fromEntries(suyos)), `${this.programa.nombre}.zip`);
  }

  deja() {
    this.olvidaRevision();
    clearTimeout(this.#pendiente);
  }

  /// Un programa en marcha que son dos: el que se ve y el original.
  async conObjetivo(suyo, opciones) {
    const { width: ancho, height: alto } = suyo.lienzo;
    const lienzo = crea('canvas', { role: 'img', ariaLabel: 'El objetivo' });
    una('.objetivo').replaceChildren(lienzo);
    const original = await arranca(this.programa, { lienzo, ancho, alto, ...opciones });
    if (original.fallo) return original;
    return Object.assign(Object.create(suyo), {
      objetivo: lienzo,
      opciones: () => (suyo.vacio ? original : suyo).opciones(),
      orden: texto => {
        suyo.orden(texto);
        if (texto !== 'especial F5') original.orden(texto);
        this.comparaPronto();
      },
      cierra() {
        suyo.cierra();
        original.cierra();
      },
    });
  }

  comparaPronto() { this.#pendiente ??= setTimeout(() => this.comparaYa(), 150); }

  comparaYa() {
    this.#pendiente = undefined;
    const { sesion, errores } = this.#escena;
    if (!sesion?.vivo) return;
    if (sesion.vacio) {
      parecido.textContent = '—';
      una('.diferencia').replaceChildren();
      return dictamina('Lo tuyo se ve al compilarlo: «Compilar», o Ctrl+Intro en el editor.');
    }
    const { width, height } = sesion.lienzo, imagen = new ImageData(width, height);
    const parte = compara(pixeles(sesion.lienzo), pixeles(sesion.objetivo), imagen.data);
    const lienzo = crea('canvas', { width, height, role: 'img', ariaLabel: 'En qué se diferencian' });
    lienzo.getContext('2d').putImageData(imagen, 0, 0);
    una('.diferencia').replaceChildren(lienzo);
    if (parecido.textContent !== porciento(parte)) parecido.textContent = porciento(parte);
    if (errores.length) dictamina('El shader tiene un error: la imagen es la de antes.', 'mal');
    else if (this.#revision || this.#resuelto && parte >= BASTA) return;
    else if (parte < BASTA) dictamina('');
    else if (this.carpeta) dictamina('Lo que se ve coincide: «Corregir» mira lo demás.');
    else this.#revisa();
  }

  /// Quien lo corrige con esos textos o, si hay que compilarlos, con lo compilado, mientras `sigue()`. Lo que juega el
  /// original es lo mismo siempre.
  async corrector(sigue, textos, compilado) {
    return new Corrector(await deEjercicio(this.codigo), { sigue, esperadas: this.#esperadas,
      suyo: como => this.arranca({ ...como, textos, compilado }), original: como => arranca(this.programa, como) });
  }

  /// Lo escrito coincide en lo que se está viendo: falta saber si coincide en todos los casos, y tras lo que se hace en
  /// cada uno.
  async #revisa() {
    const esta = this.#revision = {}, sigue = () => this.#revision === esta, { casos } = this.programa;
    dictamina('Comparando cada caso…');
    const corrector = await this.corrector(sigue, await this.taller.textos());
    const hecha = await corrector.corrige().catch(error => { if (error.name !== 'AbortError') throw error; });
    if (!hecha || !sigue()) return;
    const suyas = caso => caso.guion.split(';').filter(o => o.trim()).length; // sus órdenes; las demás son gestos
    const fallan = casos.filter((caso, i) => hecha.guiones[i].en <= suyas(caso));
    if (fallan.length && this.#recien) { // se empieza por donde hay algo que hacer
      this.olvidaRevision();
      return this.#empiezaCaso(fallan[0]);
    }
    for (const [i, b] of todos('.casos-botones button').entries())
      b.dataset.coincide = fallan.includes(casos[i]) ? 'no' : 'si';
    this.#recien = false;
    const otro = hecha.guiones.findIndex(g => g.parecido < BIEN), { en, ordenes } = hecha.guiones[otro] ?? {};
    this.#acaba(casos.length, fallan.length,
      otro >= 0 && `${casos[otro].titulo}, y después ${corrector.enPalabras(ordenes.slice(en - 1, en))}`);
  }

  #acaba(casos, fallan, otro) {
    const varios = casos > 1, faltan = varios ? `en ${fallan} de los ${casos} casos` : 'al empezar';
    if (fallan) dictamina(`Falta que coincida ${faltan}.`);
    else if (otro) dictamina(`Falta que coincida también así: ${otro}.`);
    else this.resuelve(varios ? `Resuelto: coincide en los ${casos} casos.` : 'Resuelto.');
  }

  /// Lo escrito saca 100.
  resuelve(dice = 'Resuelto.') {
    this.#resuelto = true;
    ponResueltos(this.codigo);
    dictamina(dice, 'bien');
  }

  /// Lo escrito ha cambiado.
  olvidaRevision() {
    this.#recien = this.#resuelto = false;
    this.#revision = undefined;
    for (const b of todos('.casos-botones button')) delete b.dataset.coincide;
  }
}
