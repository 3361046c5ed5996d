// Compilar el programa que se ve: el botón, la barra de lo que se trae la primera vez y la lista de lo que dice clang.
import { boton, crea, una } from '../base/documento.mjs';
import { Compilador, cuantoPesa, SE_COMPILA } from './compilador.mjs';
import { json } from './datos.mjs';
import { esFuente } from './fuentes.mjs';
import { motivoDe } from './programa.mjs';

const compila = una('.compila'), cancela = una('.cancela'), barra = una('.trae'), estado = una('.compila-estado'),
  lista = una('ul.dichos');

export class Compilacion {
  dichos = [];  // los del último intento
  compilador = new Compilador();
  #modulos = new Map(); // de cada programa, el que se ha compilado y de qué cambios
  #haciendo;
  #trayendo;
  #adelantado = false;

  /// `visto()` es lo que se ve; cuando hay algo que enseñar llama a `alDecir()`, y si ha salido, a `alCompilar()`.
  constructor({ visto, alDecir, alCompilar, vaA }) {
    Object.assign(this, { visto, alDecir, alCompilar, vaA });
    if (SE_COMPILA) compila.textContent = `Compilar (la primera vez se traen ${cuantoPesa()})`;
  }

  /// El módulo del programa, si se ha compilado, mientras haya algo escrito en los fuentes; de un ejercicio, siempre.
  modulo({ nombre }, taller, ejercicio) {
    if (ejercicio) return this.#modulos.get(ejercicio.enlace)?.modulo;
    return this.#cambios(taller).length ? this.#modulos.get(nombre)?.modulo : undefined;
  }

  /// Si el módulo de un ejercicio es de lo que hay escrito.
  async alDia(ejercicio) {
    return this.#modulos.get(ejercicio.enlace)?.de === JSON.stringify(await ejercicio.fuentes());
  }

  #cambios(taller) { return [...taller.cambios].filter(([ruta]) => esFuente(ruta)); }

  async originales() { return { ...await json('codigo'), ...await json('comun') }; }

  /// De uno en uno: el que se pide mientras tanto va después, con lo que entonces haya escrito.
  hazlo() {
    const antes = this.#haciendo ?? Promise.resolve();
    this.#haciendo = antes.then(() => this.#haz());
    return this.#haciendo;
  }

  async #haz() {
    const { programa, taller, ejercicio } = this.visto();
    if (!SE_COMPILA || !programa || ejercicio && !ejercicio.carpeta) return;
    const sigue = () => this.visto().taller === taller && this.visto().programa === programa;
    const suyos = await ejercicio?.fuentes(), cambios = suyos ? Object.entries(suyos) : this.#cambios(taller);
    try {
      await this.#trae();
      if (sigue()) estado.textContent = 'Compilando…';
      const hecho = await this.conEsos(programa, ejercicio, cambios);
      if (hecho.modulo)
        this.#modulos.set(ejercicio?.enlace ?? programa.nombre, { modulo: hecho.modulo, de: JSON.stringify(suyos) });
      if (!sigue()) return;
      this.ultimo = hecho;
      this.#di(hecho.dichos, hecho.modulo);
      if (hecho.modulo) await this.alCompilar();
    } catch (error) {
      if (!sigue()) return;
      estado.textContent = error.name === 'AbortError' ? 'No se ha traído: al pedirlo otra vez se empieza de nuevo.'
        : `No se puede compilar: ${error.message}`;
    }
  }

  /// Lo que dice el compilador del programa con esos fuentes: [ruta, texto]…
  async conEsos(programa, ejercicio, cambios) {
    const fuentes = { ...await this.originales(), ...ejercicio?.queNoSeVe, ...Object.fromEntries(cambios) };
    const hay = Object.fromEntries(Object.entries(fuentes).filter(([, texto]) => texto !== undefined));
    return this.compilador.compila({ ...programa, carpeta: ejercicio?.carpeta }, hay, cambios.map(([ruta]) => ruta));
  }

  /// Se va a compilar: que lo que es de todos esté hecho. Lo que falle se dirá al compilar.
  async adelanta() {
    if (!SE_COMPILA || this.#adelantado) return;
    this.#adelantado = true;
    try {
      await this.#trae();
      await this.compilador.adelanta();
    } catch {
      estado.textContent = '';
    }
  }

  /// De una vez, lo pida quien lo pida.
  #trae() {
    this.#trayendo ??= this.#traeYa().finally(() => { this.#trayendo = undefined; });
    return this.#trayendo;
  }

  async #traeYa() {
    if (this.compilador.listo) return;
    const corta = new AbortController();
    cancela.onclick = () => corta.abort();
    barra.hidden = cancela.hidden = false;
    try {
      await this.compilador.prepara((bytes, de) => {
        Object.assign(barra, { value: bytes, max: de });
        estado.textContent = `Trayendo el compilador, una vez: ${Math.round(bytes / 1e6)} de ${cuantoPesa()}`;
      }, corta.signal);
      compila.textContent = 'Compilar';
      estado.textContent = '';
    } finally {
      barra.hidden = cancela.hidden = true;
    }
  }

  #di(dichos, sale) {
    const errores = dichos.filter(d => d.clase === 'error').length, avisos = dichos.length - errores;
    const cuantos = (n, que) => n ? `${n} ${que}${n > 1 ? (que === 'error' ? 'es' : 's') : ''}` : '';
    const todos = [cuantos(errores, 'error'), cuantos(avisos, 'aviso')].filter(Boolean).join(' y ');
    const { ejercicio } = this.visto();
    const sigue = !ejercicio?.carpeta || this.#modulos.has(ejercicio.enlace) ? ': sigue el de antes' : '';
    this.#ensena(dichos, sale ? `Compilado${todos && `, con ${todos}`}.` : `${todos}${sigue}.`);
    const primero = !sale && dichos.find(d => d.clase === 'error' && d.ruta);
    if (primero) this.vaA(primero);
  }

  /// El programa compilado ha fallado con ese error: en qué línea, si se sabe.
  async falla(error) {
    const { programa, taller, ejercicio } = this.visto();
    if (!this.modulo(programa, taller, ejercicio)) return;
    const sitio = await this.compilador.busca(error);
    if (sitio.ruta && this.visto().programa === programa)
      this.#ensena([{ ...sitio, clase: 'error', mensaje: `Aquí ha fallado: ${motivoDe(error)}` }], 'Ha fallado.');
  }

  #ensena(dichos, texto) {
    estado.textContent = texto;
    this.dichos = dichos;
    lista.replaceChildren(...dichos.map(d => crea('li', {}, boton(
      `${d.ruta ? `${d.ruta.split('/').pop()}:${d.linea}: ` : ''}${d.mensaje}`, () => d.ruta && this.vaA(d),
      { className: d.clase === 'error' ? 'mensaje-malo' : 'mensaje-aviso' }))));
    this.alDecir();
  }

  /// Lo dicho era de otro programa.
  olvida() {
    this.dichos = [];
    lista?.replaceChildren();
    if (estado) estado.textContent = '';
  }
}
