// Del ratón, los dedos y la rueda a órdenes.

export const BOTONES = ['IZQUIERDO', 'CENTRAL', 'DERECHO'];
const lugar = ({ x, y }) => `${Math.round(x)} ${Math.round(y)}`;

/// Los puntos, { id, x, y }, son píxeles del lienzo. `da(orden)` dice si el programa la ha recibido; `luego(función)`
/// la llama en el próximo cuadro; `sigue` es si el programa atiende al ratón sin pulsar.
export class Gestos {
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
    // si aún se está cargando no hay nada que arrastrar
    if (this.da(`boton ${boton} abajo ${lugar(punto)}`)) this.#pulsado = boton;
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
