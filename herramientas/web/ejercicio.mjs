// Un ejercicio: el programa con el shader de quien lo hace y, al lado, el original. Lo que se hace con uno se hace con
// el otro.
import { Taller } from './almacen.mjs';
import { boton, crea, todos, una } from '../base/documento.mjs';
import { recuerda } from './datos.mjs';
import { guarda } from './descarga.mjs';
import { BASTA, compara, pixeles, porciento } from './imagenes.mjs';
import { arranca } from './programa.mjs';
import { ponResueltos } from './resueltos.mjs';

/// Lo que, además de empezar, se hace en cada caso, y cómo se dice: la cámara al otro lado, con la luz detrás de lo que
/// ilumina, y cada tecla. Solo se juzga lo que lo escrito puede cambiar: lo que se ve.
const gestos = ({ raton, mandos }) => [
  ...raton
    ? [['boton IZQUIERDO abajo 10 90; arrastra 330 90; boton IZQUIERDO arriba 330 90', 'girado con el ratón']] : [],
  ...mandos.flatMap(({ teclas }) => teclas).map(([tecla, orden]) => [orden, `tras pulsar ${tecla}`])];

const veredicto = una('.veredicto'), parecido = una('.parecido output');

function dictamina(texto, clase = '') {
  if (veredicto.textContent !== texto) veredicto.textContent = texto;
  veredicto.className = `veredicto ${clase}`;
}

export class Ejercicio {
  #escena;
  #empiezaCaso;
  #recien;    // se acaba de llegar: si lo de antes no vale en un caso, se empieza por él
  #revision;  // la última; se deja si se escribe otra cosa
  #pendiente; // una comparación
  #objetivos = recuerda(caso => this.#imagenesDe(caso, {}));

  /// `datos` son los de EJERCICIOS; `empiezaCaso(caso)` lo cambia en la escena.
  constructor(datos, { escena, empiezaCaso, recien }) {
    Object.assign(this, datos, { taller: new Taller('localStorage', `ejercicio ${datos.codigo}`, datos.codigo) });
    this.#escena = escena;
    this.#empiezaCaso = empiezaCaso;
    this.#recien = recien;
  }

  /// Lo que se pide. `cambiaDeVista` enseña la solución u otra vez lo escrito, y dice si es la solución.
  pon(cambiaDeVista) {
    dictamina('');
    parecido.textContent = '…';
    for (const cuadro of todos('.cuadro')) cuadro.replaceChildren();
    const pide = Object.entries(this.pide).map(([fichero, que]) =>
      crea('p', { className: 'enunciado' }, crea('code', { textContent: fichero.split('/').pop() }), `: ${que}.`));
    pide.push(crea('p', {}, 'Un número real lleva punto: 1.0 y no 1.'));
    const ver = boton('Ver la solución', async () => ver.setAttribute('aria-pressed', await cambiaDeVista()));
    ver.setAttribute('aria-pressed', false);
    const descarga = boton('Descarga mi shader', () => this.descarga(), { className: 'descarga',
      title: 'Lo que has escrito, para entregarlo: ./lab corrige lo corrige' });
    una('.tarea').replaceChildren(crea('div', {}, ...pide), ver, descarga);
  }

  /// Lo escrito, cada shader con su nombre.
  async descarga() {
    const textos = await this.taller.textos();
    for (const ruta of Object.keys(this.pide)) guarda(new Blob([textos[ruta]]), ruta.split('/').pop());
  }

  deja() {
    this.olvidaRevision();
    clearTimeout(this.#pendiente);
  }

  /// Un programa en marcha que son dos: el que se ve y el de los shaders originales.
  async conObjetivo(suyo, opciones) {
    const { width: ancho, height: alto } = suyo.lienzo;
    const lienzo = crea('canvas', { role: 'img', ariaLabel: 'El objetivo' });
    una('.objetivo').replaceChildren(lienzo);
    const original = await arranca(this.programa, { lienzo, ancho, alto, ...opciones });
    return Object.assign(Object.create(suyo), {
      objetivo: lienzo,
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
    const { width, height } = sesion.lienzo, imagen = new ImageData(width, height);
    const parte = compara(pixeles(sesion.lienzo), pixeles(sesion.objetivo), imagen.data);
    const lienzo = crea('canvas', { width, height, role: 'img', ariaLabel: 'En qué se diferencian' });
    lienzo.getContext('2d').putImageData(imagen, 0, 0);
    una('.diferencia').replaceChildren(lienzo);
    if (parecido.textContent !== porciento(parte)) parecido.textContent = porciento(parte);
    if (errores.length) dictamina('El shader tiene un error: la imagen es la de antes.', 'mal');
    else if (!this.#revision && parte >= BASTA) this.#revisa();
    else if (!this.#revision) dictamina('');
  }

  /// Lo que dibuja un caso con esos shaders, y tras cada gesto; nada desde que deja de andar.
  async #imagenesDe({ guion }, textos) {
    const lienzo = crea('canvas'), sesion = await arranca(this.programa, { lienzo, ancho: 240, alto: 180, textos });
    const imagenes = [guion, ...gestos(this.programa).map(([orden]) => orden)].map(orden => {
      sesion.orden(orden);
      return sesion.vivo && pixeles(lienzo);
    });
    sesion.cierra();
    return imagenes;
  }

  /// Lo escrito coincide en lo que se está viendo: falta saber si coincide en todos los casos.
  async #revisa() {
    const esta = this.#revision = {}, textos = this.taller.textos(), { casos } = this.programa, fallan = [];
    let otro;
    dictamina('Comparando cada caso…');
    for (const caso of casos) {
      const objetivos = await this.#objetivos(caso);
      const logradas = this.#revision === esta && await this.#imagenesDe(caso, textos);
      if (this.#revision !== esta) return;
      const [coincide, ...demas] = objetivos.map((o, i) => !o || logradas[i] && compara(logradas[i], o) >= BASTA);
      const mal = demas.indexOf(false);
      if (coincide && mal >= 0) otro ??= `${caso.titulo}, ${gestos(this.programa)[mal][1]}`;
      if (!coincide && this.#recien) { // se empieza por donde hay algo que hacer
        this.olvidaRevision();
        return this.#empiezaCaso(caso);
      }
      if (!coincide) fallan.push(caso);
      const b = todos('.casos-botones button')[casos.indexOf(caso)];
      if (b) b.dataset.coincide = coincide ? 'si' : 'no';
    }
    this.#recien = false;
    this.#acaba(casos.length, fallan.length, otro);
  }

  #acaba(casos, fallan, otro) {
    const varios = casos > 1;
    if (fallan) {
      dictamina(varios ? `Falta que coincida en ${fallan} de los ${casos} casos.` : 'Falta que coincida al empezar.');
    } else if (otro) {
      dictamina(`Falta que coincida también así: ${otro}.`);
    } else {
      ponResueltos(this.codigo);
      dictamina(varios ? `Resuelto: coincide en los ${casos} casos.` : 'Resuelto.', 'bien');
    }
  }

  /// Lo escrito ha cambiado.
  olvidaRevision() {
    this.#recien = false;
    this.#revision = undefined;
    for (const b of todos('.casos-botones button')) delete b.dataset.coincide;
  }
}
