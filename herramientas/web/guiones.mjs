// Los guiones: todo lo que se le hace a un programa es una orden de la opción -guion («tecla d», «arrastra 10 20»,
// «espera 16»…), y así lo que hace una persona se puede repetir.
import { corta } from './textos.mjs';

const ESPERA_MAXIMA = 10000; // ms seguidos que lleva un enlace
export const LIMITES = { ordenes: 10000, ms: 60000, letras: 200 }; // de un guion: todas, todas las esperas, una orden
const PASO = 100;                   // ms: una espera se repite a pasos

/// Con qué caso se empieza: con el que no tiene guion, que enseña cómo arranca el programa; lo que se anima, andando.
export const casoInicial = ({ casos, anima }) =>
  casos.find(c => !c.guion) ?? { ...casos[0], ...anima && { guion: '' } };

/// Las órdenes de un guion de fuera, una a una y cada una con su escala, para darlas poco a poco. Lo que pasa de los
/// límites se quita, y `recortado` lo dice. Un enlace no escribe ficheros, que podrían ser los de la página, ni cambia
/// el tamaño, que es el de ella. Lo mal escrito se deja: de eso se queja el programa.
export function leeGuion(guion) {
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
      for (let ms = 0; ms < dura || ms === 0; ms += PASO) {
        ordenes.push({ orden: `espera ${Math.min(dura - ms, PASO)}`, escala });
      }
    }
  }
  return { ordenes, recortado };
}

/// Da cada orden mientras `da` responda que sí, y cada `tanda` ms deja que la página respire.
export async function repite(ordenes, da, respira, { tanda = 50, ahora = () => performance.now() } = {}) {
  let desde = ahora();
  for (const orden of ordenes) {
    if (!da(orden)) return;
    if (ahora() - desde < tanda) continue;
    await respira();
    desde = ahora();
  }
}

/// Lo que se ha hecho con un programa, como órdenes de un guion que lo repite.
export class Hecho {
  ordenes = [];
  #escala = '';

  constructor(anima) { this.anima = anima; }

  /// La escala, que es la de la ventana en que se ha dado la orden, se escribe delante de las del ratón si ha cambiado.
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

/// Para lo que se anima: los ms enteros que han pasado desde la vez anterior. Lo que sobra queda para la siguiente, y
/// de una pausa de la página (otra pestaña delante) solo cuenta el principio.
export class Reloj {
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
