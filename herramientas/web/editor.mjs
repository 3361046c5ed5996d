// El editor de los shaders y, si se compilan en la página, de los fuentes: las pestañas, lo que se escribe y los
// errores en su línea.
import { boton, crea, todos, una } from '../base/documento.mjs';
import { ejecuta, json } from './datos.mjs';
import { esShader } from './fuentes.mjs';

const OPCIONES = { theme: 'lab', lineNumbers: true, lineWrapping: true, indentUnit: 4, matchBrackets: true,
  gutters: ['CodeMirror-linenumbers', 'dichos'],
  extraKeys: { Tab: false, 'Shift-Tab': false }, screenReaderLabel: 'Editor' };
const estado = una('.fichero-estado');

/// Al escribir llama a `alEscribir()` y, cuando está apuntado en el taller, a `alCambiar(ruta, texto)`.
export class Editor {
  cm;           // el de CodeMirror, que se descarga la primera vez
  abierto = ''; // el fichero que se ha pedido
  ruta;         // el que enseña cm
  #programa;
  #taller;
  #ejercicio; // su código, en un ejercicio
  #compila;   // si en él se compila
  #viendo = false; // la solución
  #errores = [];
  #reloj = 0;

  /// `alCompilar()`, si se puede, es lo que hace Ctrl+Intro.
  constructor({ alEscribir, alCambiar, alCompilar }) { Object.assign(this, { alEscribir, alCambiar, alCompilar }); }

  /// Si se puede cambiar: en un ejercicio de shaders, solo ellos.
  cambiable(ruta) { return esShader(ruta) || Boolean(this.alCompilar && this.#compila); }

  /// Lo que viene es de ese programa o ejercicio, y se guarda en ese taller.
  estrena(programa, taller, ejercicio) {
    this.#programa = programa;
    this.#taller = taller;
    this.#ejercicio = ejercicio?.codigo;
    this.#compila = !ejercicio || Boolean(ejercicio.carpeta);
    this.#viendo = false;
    this.abierto = '';
  }

  /// Va a esa línea.
  async vaA({ ruta, linea }) {
    await this.abre(ruta);
    this.cm.focus();
    this.cm.setCursor(linea - 1, 0, { scroll: false });
    this.cm.scrollIntoView(null, 99); // que debajo quepa lo que se dice de ella
  }

  /// Una pestaña para cada fichero y, si hay `mas()`, otra que trae los que da. Si el programa no ha arrancado por un
  /// error, se abre por él.
  async ensena(rutas, errores, vivo, mas) {
    this.#errores = errores;
    const pestana = ruta =>
      Object.assign(boton(ruta.split('/').pop(), () => this.abre(ruta), { title: ruta }), { ruta });
    const otras = boton('common/…', async () => otras.replaceWith(...(await mas()).map(pestana)), {
      title: 'Los de common/ que usa' });
    una('.pestanas').replaceChildren(...rutas.map(pestana), ...mas ? [otras] : []);
    const [mal] = vivo ? [] : errores;
    await this.abre([mal?.ruta, this.abierto].find(r => rutas.includes(r)) ?? rutas[0]);
    if (mal) this.cm.scrollIntoView({ line: mal.linea, ch: 0 }, 99);
  }

  async abre(ruta) {
    await this.aplicaYa();
    this.abierto = ruta;
    for (const b of todos('.pestanas button')) b.setAttribute('aria-pressed', b.ruta === ruta);
    await this.#descarga();
    const taller = this.#taller;
    const texto = this.#viendo ? await taller.solucion(ruta) : taller.cambios.get(ruta) ?? await taller.original(ruta);
    if (ruta !== this.abierto) return;
    this.cm.setOption('readOnly', this.#viendo || !this.cambiable(ruta));
    if (this.ruta !== ruta || this.cm.getValue() !== texto) this.#pon(ruta, texto);
    this.marca();
  }

  async #descarga() {
    if (this.cm) return;
    const { css, js } = await json('editor');
    if (this.cm) return;
    document.head.prepend(crea('style', { textContent: css }));
    ejecuta(js);
    const compila = { 'Ctrl-Enter': () => this.alCompilar?.(), 'Cmd-Enter': () => this.alCompilar?.() };
    this.cm = CodeMirror(una('.editor'), { ...OPCIONES, extraKeys: { ...OPCIONES.extraKeys, ...compila } });
    this.cm.on('change', (_, { origin }) => {
      if (origin === 'setValue' || this.#viendo || !this.cambiable(this.abierto)) return;
      clearTimeout(this.#reloj);
      this.#reloj = setTimeout(() => this.aplicaYa(), 250);
    });
  }

  #pon(ruta, texto) {
    this.ruta = ruta;
    this.cm.setOption('mode', esShader(ruta) ? 'x-shader/x-fragment' : 'text/x-c++src');
    this.cm.swapDoc(CodeMirror.Doc(texto, this.cm.getOption('mode')));
    const marca = this.#ejercicio && texto.split('\n').findIndex(l => this.esMarca(l));
    if (!(marca > 0)) return;
    this.cm.setCursor(marca + 1, 99, { scroll: false });
    this.cm.scrollTo(0, this.cm.heightAtLine(marca, 'local') - 60);
  }

  /// Si esa línea es una de las dos entre las que se escribe el ejercicio.
  esMarca(linea) { return RegExp(`^ *// (fin de ${this.#ejercicio}$|${this.#ejercicio}: )`).test(linea); }

  /// Enseña los errores del último intento.
  marca(errores = this.#errores) {
    this.#errores = errores;
    if (!this.cm) return;
    this.cm.operation(() => {
      this.cm.clearGutter('dichos');
      this.cm.eachLine(l => this.#limpia(l));
      for (const { ruta, linea, mensaje, clase } of errores) {
        if (ruta !== this.abierto || linea > this.cm.lineCount() || !linea) continue;
        const [fondo, dicho] = clase === 'aviso' ? ['linea-avisada', 'mensaje-aviso'] : ['linea-mala', 'mensaje-malo'];
        this.cm.addLineClass(linea - 1, 'background', fondo);
        this.cm.setGutterMarker(linea - 1, 'dichos',
          crea('span', { className: dicho, textContent: '●', title: mensaje }));
        this.cm.addLineWidget(linea - 1, crea('div', { className: dicho, textContent: mensaje }));
      }
    });
    for (const b of todos('.pestanas button')) {
      b.classList.toggle('cambiado', this.#taller.cambios.has(b.ruta));
      b.classList.toggle('mal', errores.some(e => e.ruta === b.ruta && e.clase !== 'aviso'));
    }
    this.#diEstado(errores.find(e => e.clase !== 'aviso'));
  }

  #limpia(l) {
    for (const clase of ['linea-mala', 'linea-avisada']) this.cm.removeLineClass(l, 'background', clase);
    if (this.#ejercicio && this.esMarca(l.text)) this.cm.addLineClass(l, 'background', 'linea-marca');
    for (const w of [...l.widgets ?? []]) w.clear();
  }

  #diEstado(mal) {
    const cambiado = this.#taller.cambios.has(this.abierto);
    estado.classList.toggle('mal', Boolean(mal));
    estado.replaceChildren(this.#viendo ? 'Así está en el programa. Lo que has escrito sigue guardado.'
      : mal ? (mal.ruta ? `${mal.ruta}, línea ${mal.linea}: ${mal.mensaje}` : mal.mensaje)
      : !this.cambiable(this.abierto) ? 'Solo para leer: lo que se puede cambiar aquí son los shaders.'
      : cambiado && !this.#taller.guardado ? 'Cambiado, y este navegador no lo puede guardar: al cerrar se pierde.'
      : cambiado ? 'Cambiado.'
      : esShader(this.abierto) ? 'Se aplica según se escribe.' : 'Al compilarlo (Ctrl+Intro) se ve lo que cambies.');
    if (this.#viendo || !cambiado) return;
    estado.append(boton(this.#ejercicio ? 'Borrar lo escrito' : 'Volver al original', () => this.#vuelve()));
  }

  /// Lo que se acaba de escribir, sin esperar más: al cuarto de segundo o al irse a otro fichero.
  aplicaYa() {
    if (!this.#reloj) return;
    clearTimeout(this.#reloj);
    this.#reloj = 0;
    return this.#aplica();
  }

  async #aplica() {
    const programa = this.#programa, taller = this.#taller, ruta = this.abierto, texto = this.cm.getValue();
    this.alEscribir();
    taller.apunta(ruta, texto, await taller.original(ruta));
    if (programa === this.#programa && taller === this.#taller) return this.alCambiar(ruta, texto);
  }

  async #vuelve() {
    this.cm.setValue(await this.#taller.original(this.abierto));
    clearTimeout(this.#reloj);
    this.#reloj = 0;
    await this.#aplica();
  }

  /// La solución, y otra vez lo escrito.
  async cambiaDeVista() {
    await this.aplicaYa();
    this.#viendo = !this.#viendo;
    this.abre(this.abierto);
    return this.#viendo;
  }
}
