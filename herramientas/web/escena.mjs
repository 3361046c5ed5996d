// El programa que se ve: empieza, recibe órdenes, se anima y termina.
import { avisa, crea, todos, una } from '../base/documento.mjs';
import { atiende } from './entrada.mjs';
import { leeError } from './fuentes.mjs';
import { Hecho, leeGuion, Reloj, repite } from './guiones.mjs';
import { tallaDe } from './imagenes.mjs';
import { abreMenu } from './menu.mjs';
import { ERROR_DE_OPENGL } from './nota.mjs';
import { arranca, motivoDe } from './programa.mjs';

const marco = una('.lienzo'), telon = una('.telon'), consola = una('.consola');

function cubre(texto) {
  telon.hidden = false;
  una('p', telon).textContent = texto;
}

const calla = () => { consola.hidden = true; consola.replaceChildren(); };
const ponTitulo = texto => { una('.estado').textContent = texto; };
const talla = () => tallaDe(marco.getBoundingClientRect(), devicePixelRatio);

/// Cuando un programa ha arrancado llama a `alArrancar`; cuando ha vuelto a leer sus shaders, a `alRecargar`; si ha
/// fallado, a `alFallar(error)`, y si es que no hay con qué dibujar, a `sinWebGL()`.
export class Escena {
  suavizado = true;
  quieta = false; // si el tiempo no pasa
  sesion;       // el programa en marcha; no lo hay hasta que acaba de repetirse su guion
  gestos;       // los del lienzo
  hecho;        // lo que se ha hecho con él
  errores = []; // los de sus shaders, del último intento
  #pedido;
  #turno = 0;
  #escrito = [];
  #ultima = '';    // la orden
  #aparte = false; // de lo que escribe un guion que se repite queda lo de su última orden; lo demás es de otra imagen
  #reloj;
  #cuadro;

  constructor({ alArrancar, alRecargar, alFallar, sinWebGL }) {
    Object.assign(this, { alArrancar, alRecargar, alFallar, sinWebGL });
    new ResizeObserver(() => this.#ajusta()).observe(marco);
  }

  /// Empieza un programa y repite un guion. De lo pedido, `textos()` da los ficheros que no son los originales;
  /// `compilado()`, el programa, si no lo es; `ficheros` son los que se le dan; `arranca`, si lo hay, es quien lo pone
  /// en marcha, y `acompana(sesión, opciones)` devuelve otra sesión que hace más.
  async empieza(pedido, guion = '') {
    const turno = ++this.#turno, vale = () => turno === this.#turno;
    const teniaFoco = marco.contains(document.activeElement), lienzo = this.#prepara(pedido);
    let nueva;
    try {
      nueva = await this.#arranca(lienzo, vale);
    } catch (error) {
      if (!vale()) return;
      cubre(`No se puede arrancar el programa: ${pedido.compilado?.() ? motivoDe(error) : error.message ?? error}`);
      return this.alFallar(error);
    }
    // hasta que no acaba de repetirse el guion no hay sesión: lo que se haga en la página no se mezcla con él
    const { ordenes, recortado } = leeGuion(guion);
    if (ordenes.length) calla();
    await repite(ordenes, ({ orden, escala }) => {
      this.#aparte = true;
      return vale() && this.#da(nueva, orden, escala);
    }, () => {
      avisa('Repitiendo el guion…');
      return new Promise(sigue => setTimeout(sigue));
    });
    if (!vale()) return nueva.cierra();
    this.#aparte = false;
    this.sesion = nueva;
    avisa(recortado ? 'El guion es demasiado largo: se ha repetido solo una parte.' : '');
    if (teniaFoco) lienzo.focus({ preventScroll: true });
    this.#mira();
    this.#ajusta();
    this.alArrancar();
    this.#reloj = new Reloj(performance.now());
    this.#pulso();
  }

  /// Desde el principio, todo lo que se ha hecho.
  repite() { return this.empieza(this.#pedido, this.hecho.ordenes.join(';')); }

  cierra() {
    this.#turno++;
    this.sesion?.cierra();
    this.sesion = undefined;
  }

  /// Todo como antes de arrancar, con un lienzo nuevo.
  #prepara(pedido) {
    const { titulo, anima, raton, sigue } = pedido.programa, lienzo = crea('canvas', { tabIndex: 0 });
    lienzo.style.touchAction = raton ? 'none' : 'pan-y'; // si no se arrastra en él, el dedo pasa la página
    lienzo.setAttribute('role', 'application');
    lienzo.setAttribute('aria-label', `${titulo}: las teclas van al programa`);
    this.sesion?.cierra();
    todos('canvas, img', marco).forEach(c => c.remove());
    marco.prepend(lienzo);
    this.#escrito = [];
    this.sesion = undefined;
    this.hecho = new Hecho(anima);
    this.errores = [];
    this.gestos = atiende(lienzo, this, sigue);
    this.#pedido = pedido;
    this.#siSePierde(lienzo);
    telon.hidden = true;
    this.#aparte = false;
    calla();
    ponTitulo('');
    avisa('');
    return lienzo;
  }

  /// El error con que ha acabado. El de OpenGL no dice dónde: se repite, preguntando tras cada llamada.
  async #error({ error, estado }) {
    if (error || estado !== ERROR_DE_OPENGL || !this.#pedido.compilado?.()) return error;
    try {
      const otra = await this.#arranca(crea('canvas'), () => false, { vigilado: true });
      for (const orden of [...this.hecho.ordenes, this.#ultima]) otra.orden(orden);
      otra.cierra();
      return otra.error;
    } catch (suyo) {
      return suyo;
    }
  }

  async #arranca(lienzo, vale, mas = {}) {
    const { programa, textos, ficheros, acompana, compilado } = this.#pedido;
    const sesion = await (this.#pedido.arranca ?? (como => arranca(programa, como)))({
      lienzo, ...talla(), textos: textos(), ficheros, suavizado: this.suavizado,
      compilado: compilado?.(),
      di: linea => { if (vale()) this.#di(linea); },
      titulo: texto => { if (vale()) ponTitulo(texto); },
      ...mas,
    });
    return acompana && vale() ? acompana(sesion, { ficheros, suavizado: this.suavizado }) : sesion;
  }

  /// Lo que escribe el programa: los errores de los shaders se apuntan y lo demás se enseña.
  #di(linea) {
    linea = linea.replace(/guion, orden \d+/, 'guion'); // las órdenes se dan de una en una
    this.#escrito = [...this.#escrito.slice(-9), linea];
    if (this.#pedido.acompana && linea.includes('el uniform «')) return; // en un ejercicio, lo que aún no se usa
    const error = leeError(linea, this.#pedido.programa.capitulo);
    if (error) return this.errores.push({ ...error, ruta: this.#pedido.rutaDe?.(error.ruta) ?? error.ruta });
    if (this.#aparte) calla();
    this.#aparte = false;
    consola.hidden = false;
    consola.append((consola.textContent ? '\n' : '') + linea);
    while (consola.childNodes.length > 200) consola.firstChild.remove();
    consola.scrollTop = consola.scrollHeight;
  }

  /// Da una orden a un programa y la anota para el enlace. Falso si con ella ha terminado: eso no hay que repetirlo.
  #da(sesion, orden, escala) {
    this.#ultima = escala ? `${escala};${orden}` : orden;
    sesion.orden(this.#ultima);
    if (sesion.vivo) this.hecho.apunta(orden, escala || `escala ${sesion.lienzo.width} ${sesion.lienzo.height}`);
    return sesion.vivo;
  }

  /// Da una orden al programa en marcha, si lo hay.
  manda(orden) {
    if (!this.sesion?.vivo) return false;
    const vive = this.#da(this.sesion, orden);
    if (!vive) this.#mira();
    return vive;
  }

  /// F5: el programa vuelve a leer sus shaders.
  recarga() {
    this.errores = [];
    this.manda('especial F5');
    this.alRecargar();
  }

  /// Un shader que ha cambiado. Si no hay programa, quizá no arrancaba por él.
  cambia(ruta, texto) {
    if (!this.sesion?.vivo) return this.repite();
    this.sesion.escribe(ruta, texto);
    this.recarga();
  }

  opciones() { return this.sesion?.opciones() ?? []; } // las del menú: aún no hay programa, o ya no
  ensenaMenu(x, y) { abreMenu(x, y, this.opciones(), opcion => this.manda(`menu ${opcion}`)); }

  /// Si el programa ha terminado, lo dice.
  #mira() {
    const { vivo, fallo } = this.sesion;
    if (vivo || this.#pedido.programa.consola) return;
    cubre(fallo ? this.#escrito.slice(-3).join('\n') || 'El programa ha fallado' : 'El programa ha terminado');
    if (fallo && !this.sesion.lienzo.getContext('webgl2')) {
      cubre('Este navegador no da WebGL 2, y sin él solo se ve su imagen: activa en él la aceleración gráfica, ' +
        'actualízalo o prueba con otro.');
      this.sinWebGL();
    } else if (fallo) this.#error(this.sesion).then(error => this.alFallar(error));
  }

  /// Una vez por cuadro: el ratón que se ha movido y, si el programa se anima, el tiempo que ha pasado.
  #pulso(ahora = performance.now()) {
    if (!this.sesion?.vivo) return;
    this.gestos.suelta();
    const ms = this.#reloj.pasa(ahora), { anima } = this.#pedido.programa;
    if (anima && ms && !this.quieta) this.manda(`espera ${ms}`);
    cancelAnimationFrame(this.#cuadro);
    if (anima) this.#cuadro = requestAnimationFrame(t => this.#pulso(t));
  }

  #ajusta() {
    if (!this.sesion?.vivo) return;
    const { lienzo } = this.sesion, { ancho, alto } = talla();
    if (lienzo.width !== ancho || lienzo.height !== alto) this.manda(`tamano ${ancho} ${alto}`);
  }

  /// El navegador puede quitar el contexto (se ha reiniciado la tarjeta, hay demasiadas páginas): al devolverlo, se
  /// repite todo.
  #siSePierde(lienzo) {
    lienzo.addEventListener('webglcontextlost', suceso => {
      const perdida = this.sesion;
      if (perdida?.lienzo !== lienzo) return;
      suceso.preventDefault();
      lienzo.addEventListener('webglcontextrestored', () => {
        const seVe = lienzo.isConnected;
        perdida.cierra(); // se dibuja en otro, y lo devuelto es de este
        if (!seVe) return;
        this.repite().then(() => avisa('El navegador ha devuelto la tarjeta gráfica: todo sigue donde estaba.'));
      });
      this.#turno++;
      this.sesion = undefined;
      cubre('El navegador ha perdido la tarjeta gráfica. Cuando la recupere, el programa seguirá donde estaba.');
    });
  }
}
