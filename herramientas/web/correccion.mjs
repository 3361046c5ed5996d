// «Corregir»: lo que se dice mientras se juega y lo que ha salido.
import { deEjercicio } from './almacen.mjs';
import { boton, crea, una } from '../base/documento.mjs';
import { hazEnlace } from './enlaces.mjs';
import { esFuente } from './fuentes.mjs';
import { BIEN, CASI, nota, parte, redondea } from './nota.mjs';
import { porPiezas, SoloLoEntero } from './piezas.mjs';
import { motivoDe } from './programa.mjs';

const panel = una('.correccion');
const cifra = n => n.toLocaleString('es');
const linea = (...dice) => crea('p', {}, ...dice);
const cuanto = parte => parte === 1 ? 'bien' : `${cifra(redondea(100 * parte))} de 100`;
const dichas = piezas => [...piezas.map(({ pide, parte }) => `«${pide}», ${cuanto(parte)}`),
  ...piezas.every(p => p.parte === 1) ? ['lo que falla está fuera de ellas, o en cómo se juntan'] : []].join('; ');

export class Correccion {
  #esta; // la que se hace; se deja si se escribe otra cosa

  /// `ensena(guion, píxel)` enseña eso en la escena, y lo explica si se da.
  constructor({ compilacion, ensena }) { Object.assign(this, { compilacion, ensena }); }

  /// Lo escrito ha cambiado, o se ve otra cosa.
  olvida() {
    if (this.#esta) panel.hidden = true;
    this.#esta = undefined;
    panel.classList.add('vieja');
  }

  /// La de lo escrito: { nota… }; nada, si no ha acabado.
  async hazla(ejercicio) {
    const esta = this.#esta = {}, sigue = () => this.#esta === esta;
    this.#pon(linea('Compilando…'));
    try {
      const hecha = await this.#juega(ejercicio, sigue);
      if (!sigue()) return undefined;
      this.#esta = undefined;
      panel.ariaBusy = false;
      return hecha;
    } catch (error) {
      if (error.name !== 'AbortError') this.#pon(linea(`No se puede corregir: ${error.message}`));
      return undefined;
    }
  }

  #pon(...que) {
    panel.hidden = false;
    panel.ariaBusy = Boolean(this.#esta); // lo que se dice mientras tanto no hay que leerlo cada vez
    panel.className = 'correccion';
    panel.replaceChildren(...que);
  }

  async #juega(ejercicio, sigue) {
    const { compilacion } = this;
    if (ejercicio.seCompila && !await compilacion.alDia(ejercicio)) await compilacion.hazlo();
    if (!sigue()) return undefined;
    if (ejercicio.seCompila && !await compilacion.alDia(ejercicio)) {
      const malos = compilacion.dichos.filter(d => d.clase === 'error');
      if (!malos.length) throw new Error('no se ha compilado.');
      this.#pon(linea(crea('b', { textContent: '0' }), ' de 100: no compila. ', malos[0].mensaje));
      return { nota: 0 };
    }
    const compilado = compilacion.modulo(ejercicio.programa, ejercicio.taller, ejercicio);
    const corrector = await ejercicio.corrector(sigue, await ejercicio.taller.escritos(), compilado);
    const hecha = await corrector.corrige((n, de) => this.#pon(linea(`Corrigiendo: ${n + 1} de ${de} guiones…`)));
    Object.assign(hecha, await this.#piezas(ejercicio, corrector, hecha));
    if (hecha.nota === 100) ejercicio.resuelve();
    const resumen = this.#resumen(hecha);
    this.#pon(...resumen);
    const primero = await corrector.primero(hecha.guiones);
    if (primero && sigue()) this.#pon(...resumen.slice(0, -1), ...this.#fallo(primero, ejercicio), resumen.at(-1));
    return hecha;
  }

  /// Lo que vale cada pieza, y la nota con ellas; o por qué no se sabe.
  async #piezas(ejercicio, corrector, { guiones, otros, reglas }) {
    const datos = await deEjercicio(ejercicio.codigo);
    if (!datos.huecos || parte(guiones, reglas) === 1) return {};
    if (!datos.solucion) return { entero: 'la solución no está en la página' };
    const { compilacion } = this, escritos = await ejercicio.taller.escritos();
    const arranca = async textos => {
      const fuentes = Object.entries(textos).filter(([ruta]) => esFuente(ruta));
      const compilado = ejercicio.seCompila &&
        (await compilacion.conEsos(ejercicio.programa, ejercicio, fuentes)).modulo;
      return !ejercicio.seCompila || compilado ? como => ejercicio.arranca({ ...como, textos, compilado }) : undefined;
    };
    const avanza = (i, de) => this.#pon(linea(`Corrigiendo, pieza a pieza: ${i + 1} de ${de}…`));
    try {
      const piezas = await porPiezas({ ...datos, codigo: ejercicio.codigo }, escritos,
        { arranca, avanza, juega: (suyo, nada) => corrector.parte(suyo, nada) });
      return { piezas, nota: nota(guiones, otros, reglas, piezas) };
    } catch (error) {
      if (error instanceof SoloLoEntero) return { entero: error.message };
      throw error;
    }
  }

  #resumen({ nota, guiones, otros, reglas, piezas, entero }) {
    const cuantos = parecido => guiones.filter(g => g.parecido === parecido).length, casi = cuantos(CASI);
    const bien = `${cuantos(BIEN)} de los ${guiones.length} guiones dan lo mismo`;
    return [
      linea(crea('b', { textContent: cifra(nota) }), ` de 100: ${bien}${casi ? `; ${casi}, casi` : ''}.`),
      ...piezas ? [linea(`Pieza a pieza: ${dichas(piezas)}.`)] : [],
      ...entero ? [linea(`La nota es la de lo entero, y no pieza a pieza: ${entero}.`)] : [],
      ...Object.entries(otros).filter(([que]) => que !== 'estado').map(([, dice]) => linea(`${dice}.`)),
      crea('details', {}, crea('summary', { textContent: 'Cómo se puntúa' }),
        linea(`Es lo de ./lab corrige, y los rótulos no cuentan. ${reglas.dichas}.`)),
    ];
  }

  #fallo({ ordenes, dice, pixel, error, dicho, casi }, { programa, oculto }) {
    const delRaton = ordenes.some(o => /^(boton|arrastra|mueve|rueda)/.test(o));
    const guion = [...delRaton && !ordenes[0].startsWith('escala') ? ['escala 240 180'] : [], ...ordenes];
    const enTalla = !ordenes.some(o => o.startsWith('tamano')), lugar = pixel && enTalla && pixel;
    const que = error ? motivoDe(error) : casi ? 'se ve casi igual: ¿pocas cifras?' : 'no se ve lo mismo.';
    const botones = [boton('Verlo', () => this.ensena(guion.join('; ')))];
    if (lugar) botones.push(boton('Explicar ese píxel en lo tuyo', () => this.ensena(guion.join('; '), lugar)));
    if (lugar && !oculto)
      botones.push(crea('a', { target: '_blank', textContent: 'Y en el objetivo ↗',
        href: hazEnlace(`${programa.nombre}/explica/${lugar}`, guion) }));
    return [linea('Falla primero así: ', crea('b', { textContent: dice }), `: ${que}`),
      ...dicho.length ? [crea('p', { className: 'dicho', textContent: dicho.slice(0, 2).join('\n') })] : [],
      crea('p', { className: 'acciones' }, ...botones)];
  }
}
