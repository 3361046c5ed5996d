// «Corregir»: lo que se dice mientras se juega y lo que ha salido.
import { deEjercicio } from './almacen.mjs';
import { boton, crea, una } from '../base/documento.mjs';
import { hazEnlace } from './enlaces.mjs';
import { esFuente, leeError } from './fuentes.mjs';
import { porQue } from './motivos.mjs';
import { BIEN, CASI, nota, parte, redondea } from './nota.mjs';
import { conTodas, estan, porPiezas, SoloLoEntero } from './piezas.mjs';
import { motivoDe } from './programa.mjs';

const panel = una('.correccion');
const COMO_AL_EMPEZAR = 'se ve lo mismo que en el punto de partida';
const cifra = n => n.toLocaleString('es');
const linea = (...dice) => crea('p', {}, ...dice);
const donde = ({ ruta, linea }) => ruta ? `${ruta.split('/').pop()}, línea ${linea}: ` : '';
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
    if (ejercicio.seCompila && !await compilacion.alDia(ejercicio)) {
      ejercicio.corrector(sigue).then(corrector => corrector.adelanta());
      await compilacion.hazlo();
    }
    if (!sigue()) return undefined;
    if (ejercicio.seCompila && !await compilacion.alDia(ejercicio)) {
      const malo = compilacion.dichos.find(d => d.clase === 'error');
      if (!malo) throw new Error('no se ha compilado.');
      this.#pon(linea(crea('b', { textContent: '0' }), ` de 100: no compila. ${donde(malo)}${malo.mensaje}`));
      return { nota: 0 };
    }
    const compilado = compilacion.modulo(ejercicio.programa, ejercicio.taller, ejercicio);
    const corrector = await ejercicio.corrector(sigue, await ejercicio.taller.escritos(), compilado);
    const datos = await deEjercicio(ejercicio.codigo), arranca = this.#arranca(ejercicio);
    const avanza = (n, de) => this.#pon(linea(`Corrigiendo: ${n + 1} de ${de} guiones…`));
    const hecha = await corrector.corrige({ avanza, hazNada: () => arranca(datos.esqueleto) });
    Object.assign(hecha, await this.#piezas(ejercicio, datos, arranca, corrector, hecha));
    if (hecha.nota === 100) ejercicio.resuelve();
    const resumen = this.#resumen(hecha), fallo = [];
    const pon = (...dice) => { if (sigue()) this.#pon(...resumen.slice(0, -1), ...dice, ...fallo, resumen.at(-1)); };
    pon();
    const primero = await corrector.primero(hecha.guiones);
    if (primero) fallo.push(...this.#fallo(primero, ejercicio));
    const mira = datos.errores && (primero || Object.keys(hecha.otros).length);
    if (mira) pon(linea('Mirando si es un error conocido…'));
    hecha.dice = mira ? await this.#motivos(ejercicio, datos, arranca, corrector, hecha) : [];
    pon(...hecha.dice.map(dice => linea(crea('b', { textContent: `${dice[0].toUpperCase()}${dice.slice(1)}.` }))));
    return hecha;
  }

  /// Cómo arranca el programa con esos textos, o nada, si no compilan: { como, y lo que se añade }.
  #arranca(ejercicio) {
    const { compilacion } = this;
    return async (textos, mas = {}) => {
      const fuentes = Object.entries(textos).filter(([ruta]) => esFuente(ruta));
      const compilado = ejercicio.seCompila && await ejercicio.modulo(JSON.stringify(fuentes),
        async () => (await compilacion.conEsos(ejercicio.programa, ejercicio, fuentes)).modulo);
      return !ejercicio.seCompila || compilado ? como => ejercicio.arranca({ ...como, textos, compilado,
        entorno: { ...como.entorno, ...mas } }) : undefined;
    };
  }

  /// Qué errores conocidos son, como lo dice ./lab corrige: los de lo entero o, si no, los de cada pieza.
  async #motivos(ejercicio, datos, arranca, corrector, { guiones, piezas }) {
    const { errores: { textos, defectos, pares }, huecos = [], solucion, esqueleto } = datos;
    if (estan(esqueleto, await ejercicio.taller.escritos())) return [COMO_AL_EMPEZAR];
    const con = (...suyos) => {
      const cambiados = { ...textos }, deAtras = (uno, otro) => otro.cambia[0] - uno.cambia[0];
      for (const { en, cambia: [desde, hasta, por] } of suyos.filter(d => d.en).sort(deAtras))
        cambiados[en] = cambiados[en].slice(0, desde) + por + cambiados[en].slice(hasta);
      return arranca(cambiados, { LAB_MUTANTE: suyos.map(d => d.numero ?? '').join() });
    };
    const sePlanta = d => d.en || ejercicio.seCompila;
    const deErrores = defectos.map(d => ({ dice: d.dice, arranca: () => sePlanta(d) ? con(d) : undefined }));
    const deHuecos = huecos.map(({ pide, partida }, i) => ({ dice: `parece que falta: ${pide}`,
      arranca: () => arranca(conTodas(solucion, j => j === i ? partida : huecos[j].hecha)) }))
      .filter((_, i) => piezas?.[i].parte !== 1);
    const dos = (i, j) => ({ dice: `${defectos[i].dice}; y que ${defectos[j].dice.replace('parece que ', '')}`,
      arranca: () => con(defectos[i], defectos[j]) });
    const de = guiones => porQue(corrector, guiones, { variantes: [...deHuecos, ...deErrores],
      defectos: deErrores, pares, dos, esqueleto: { dice: '', arranca: () => arranca(esqueleto) } });
    const junto = dichos => dichos.filter(Boolean).slice(0, 3).join('; o ');
    const acaban = guiones.some(({ partida, ordenes }) => partida && (partida.estado ||
      partida.imagenes.length <= ordenes.length));
    const entero = acaban ? [] : await de(guiones);
    if (junto(entero)) return [junto(entero)];
    const deCada = [];
    for (const { pide, falta, parte, guiones } of piezas ?? [])
      if (parte < 1) deCada.push(falta ? `parece que falta: ${pide}` : junto(await de(guiones)));
    const dichos = deCada.filter(Boolean);
    return dichos.length ? dichos : entero.length ? [COMO_AL_EMPEZAR] : [];
  }

  /// Lo que vale cada pieza, y la nota con ellas; o por qué no se sabe.
  async #piezas(ejercicio, datos, arranca, corrector, { guiones, otros, reglas }) {
    if (!datos.huecos || parte(guiones, reglas) === 1) return {};
    if (!datos.solucion) return { entero: 'la solución no está en la página' };
    const escritos = await ejercicio.taller.escritos();
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
    const n = guiones.filter(g => g.aMedias).length;
    const aMedias = n ? `; ${n > 1 ? `${n} casos se ven bien y fallan` : 'un caso se ve bien y falla'} al seguir` : '';
    return [
      linea(crea('b', { textContent: cifra(nota) }), ` de 100: ${bien}${casi ? `; ${casi}, casi` : ''}${aMedias}.`),
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
    const mal = dicho.map(texto => leeError(texto, programa.capitulo)).find(mal => mal?.ruta);
    const seVe = casi ? 'se ve casi igual.' : 'no se ve lo mismo.';
    const que = error ? motivoDe(error) : mal ? `no compila. ${donde(mal)}${mal.mensaje}` : seVe;
    const botones = [boton('Verlo', () => this.ensena(guion.join('; ')))];
    if (lugar) botones.push(boton('Explicar ese píxel en lo tuyo', () => this.ensena(guion.join('; '), lugar)));
    if (lugar && !oculto)
      botones.push(crea('a', { target: '_blank', textContent: 'Y en el objetivo ↗',
        href: hazEnlace(`${programa.nombre}/explica/${lugar}`, guion) }));
    return [linea('Falla primero así: ', crea('b', { textContent: dice }), `: ${que}`),
      ...dicho.length && !mal ? [crea('p', { className: 'dicho', textContent: dicho.slice(0, 2).join('\n') })] : [],
      crea('p', { className: 'acciones' }, ...botones)];
  }
}
