// Los ficheros de quien mira, para los programas que admiten una imagen, dos o un modelo.
import { avisa, una } from '../base/documento.mjs';
import { aPpm } from './imagenes.mjs';
import { nombreLlano } from './textos.mjs';

const entrada = una('.fichero input');
const PIDE = { modelo: 'Abrir un modelo .vf', imagenes: 'Abrir dos imágenes', imagen: 'Abrir una imagen' };

/// Cuando están los que el programa necesita llama a `alTenerlos`.
export class Propios {
  #programa;
  #suyos = [];
  #cuenta = 0; // dos ficheros pueden llamarse igual

  /// De lo que se suelta en la página, `esDeOtro(dataTransfer)` se queda lo que no es para un programa.
  constructor(alTenerlos, esDeOtro) {
    this.alTenerlos = alTenerlos;
    entrada.onchange = () => this.#abre([...entrada.files]).then(() => { entrada.value = ''; });
    una('.fichero').addEventListener('keydown', suceso => {
      if (suceso.key === 'Enter' || suceso.key === ' ') entrada.click();
    });
    addEventListener('dragover', suceso => suceso.preventDefault());
    addEventListener('drop', suceso => {
      suceso.preventDefault();
      if (esDeOtro(suceso.dataTransfer)) return;
      if (this.#programa && !this.#programa.admite) avisa('Este programa no lee ficheros.');
      else this.#abre([...suceso.dataTransfer.files]);
    });
  }

  /// Como se le dan al programa: de cada ruta, su contenido.
  get ficheros() { return Object.fromEntries(this.#suyos.map(({ nombre, datos }) => ['/propias/' + nombre, datos])); }

  olvida() { this.#suyos = []; }

  estrena(programa) {
    this.#programa = programa;
    this.olvida();
    if (!programa) return;
    una('.fichero').hidden = !programa.admite;
    una('.fichero span').textContent = PIDE[programa.admite] ?? '';
    entrada.accept = programa.admite === 'modelo' ? '.vf' : 'image/*,.ppm';
  }

  async #lee(fichero, admite) {
    const nombre = `${++this.#cuenta}-` + nombreLlano(fichero.name);
    if (admite === 'modelo') return { nombre, datos: new Uint8Array(await fichero.arrayBuffer()) };
    return { nombre: nombre.replace(/\.[^.]*$/, '') + '.ppm', datos: await aPpm(fichero) };
  }

  async #abre(ficheros) {
    const programa = this.#programa, nuevos = [];
    if (!programa?.admite || !ficheros.length) return;
    for (const fichero of ficheros) {
      try {
        nuevos.push(await this.#lee(fichero, programa.admite));
      } catch {
        return avisa(`«${fichero.name}» no es una imagen que este navegador sepa leer.`);
      }
    }
    if (programa !== this.#programa) return; // mientras se leían se ha ido a otro
    const cuantos = programa.admite === 'imagenes' ? 2 : 1;
    this.#suyos = [...this.#suyos, ...nuevos].slice(-cuantos);
    if (this.#suyos.length < cuantos) return avisa('Falta otra imagen: este programa usa dos.');
    await this.alTenerlos();
  }
}
