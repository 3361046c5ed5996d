// La página de los programas; lo que no toca el documento está en web_partes.js. Un programa en marcha es una instancia de
// lab.js, y todo lo que se le hace es una orden del guion (las de la opción -guion): «tecla d», «arrastra 10 20», «espera 16»… Así
// lo que hace una persona se puede repetir, y va en el enlace: #grua;tecla d;tecla d
const todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
const una = (selector, raiz = document) => raiz.querySelector(selector);
const crea = (etiqueta, propiedades = {}, ...hijos) => {
  const e = Object.assign(document.createElement(etiqueta), propiedades);
  e.append(...hijos);
  return e;
};

// --- los datos: datos/NOMBRE.js llama a llega(NOMBRE, bytes comprimidos en base64) -----------------------------------

const llegados = {};
const llega = (nombre, base64) => { llegados[nombre] = base64; };

const pide = nombre => new Promise((bien, mal) => {
  const falta = () => mal(new Error(`no se puede leer datos/${nombre}.js`));
  document.head.append(crea('script', { src: `datos/${nombre}.js`, onload: () => llegados[nombre] ? bien() : falta(), onerror: falta }));
});

const bytes = recuerda(async nombre => {
  await pide(nombre);
  const base64 = llegados[nombre];
  delete llegados[nombre];
  return descomprime(base64);
});
const enTexto = async nombre => new TextDecoder().decode(await bytes(nombre));
const json = async nombre => JSON.parse(await enTexto(nombre));
const ejecuta = js => document.head.append(crea('script', { textContent: js }));
/// El laboratorio, que son lab.js y lab.wasm: define Laboratorio y devuelve el módulo compilado.
const laboratorio = recuerda(async () => {
  const [modulo] = await Promise.all([bytes('wasm').then(b => WebAssembly.compile(b)), enTexto('js').then(ejecuta)]);
  return modulo;
});

/// Lo que guarda el navegador en sessionStorage, mientras no se cierra la pestaña, o en localStorage; puede no permitirlo.
function recuerdo(almacen, clave, texto) {
  try {
    return texto === undefined ? window[almacen].getItem(clave) : window[almacen].setItem(clave, texto);
  } catch {
    return null;
  }
}

/// Los shaders que se tocan: los de la pestaña o, en un ejercicio, los suyos, que parten de su esqueleto.
class Taller {
  constructor(almacen, clave, codigo) {
    Object.assign(this, { almacen, clave, codigo, cambios: new Map(leeCambios(recuerdo(almacen, clave))) });
  }

  async esqueleto() { return this.codigo ? (await json('esqueletos'))[this.codigo] : {}; }
  async textos() { return { ...await this.esqueleto(), ...Object.fromEntries(this.cambios) }; }
  async original(ruta) { return (await this.esqueleto())[ruta] ?? solucion(ruta); }

  apunta(ruta, texto, original) {
    if (texto === original) this.cambios.delete(ruta);
    else this.cambios.set(ruta, texto);
    recuerdo(this.almacen, this.clave, JSON.stringify([...this.cambios]));
  }
}

const esShader = ruta => /\.(vert|frag|glsl)$/.test(ruta);
const solucion = async ruta => (await json(esShader(ruta) ? 'shaders' : 'codigo'))[ruta];
const libre = new Taller('sessionStorage', 'cambios');
let taller = libre;

// --- un programa en marcha --------------------------------------------------------------------------------------------

/// Arranca un programa en un lienzo. `di(línea)` recibe lo que escribe; `titulo(texto)`, el de la ventana; `ficheros`, los
/// que se le dan además de los del laboratorio; `textos`, los shaders que no son los originales. Devuelve lo que se puede hacer con él.
async function arranca(programa,
  { lienzo, ancho, alto, textos = {}, ficheros = {}, suavizado = true, di = () => {}, titulo = () => {} }) {
  const [modulo, shaders, suyos] = await Promise.all([laboratorio(), json('shaders'), textos, ...programa.texturas.map(bytes)]);
  const lab = await Laboratorio({
    canvas: lienzo, suavizado, thisProgram: programa.nombre, print: di, printErr: di, titulo,
    instantiateWasm: (lo, recibe) => { WebAssembly.instantiate(modulo, lo).then(recibe); return {}; },
  });
  const escribe = (ruta, datos) => {
    lab.FS.mkdirTree(ruta.replace(/\/[^/]*$/, ''));
    lab.FS.writeFile(ruta, datos);
  };
  for (const [ruta, texto] of Object.entries({ ...shaders, ...suyos })) escribe('/lab/' + ruta, texto);
  for (const t of programa.texturas) escribe(`/lab/assets/${t}`, await bytes(t));
  for (const [ruta, datos] of Object.entries(ficheros)) escribe(ruta, datos);
  const leidos = new Set(), abre = lab.FS.open;
  lab.FS.open = (ruta, ...resto) => { leidos.add(String(ruta)); return abre(ruta, ...resto); };

  let estado = lab.callMain(['-geometry', `${ancho}x${alto}`, ...Object.keys(ficheros)]) || 0;
  return {
    lienzo, leidos,
    get vivo() { return !estado; },
    get fallo() { return estado > 0; }, // −1: ha terminado bien
    escribe: (ruta, texto) => escribe('/lab/' + ruta, texto),
    lee: ruta => lab.FS.readFile(ruta),
    /// Un trozo de guion. Si el programa termina, deja de estar vivo.
    orden(texto) {
      if (estado) return;
      try {
        if (lab.ccall('glutOrden', 'number', ['string'], [texto])) estado = -1;
      } catch (error) {
        if (error.name !== 'ExitStatus') di(String(error));
        estado = error.status || 1;
      }
    },
    opciones: () => estado ? [] : lab.ccall('glutOpciones', 'string').split('\n').filter(Boolean),
    cierra() {
      estado ||= -1;
      lienzo.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext(); // solo puede haber 16 vivos
      lienzo.remove();
    },
  };
}

// --- la página de un programa ------------------------------------------------------------------------------------------

const pagina = una('#programa'), marco = una('.lienzo'), telon = una('.telon'), consola = una('.consola');
let suavizado = true, actual, sesion, gestos, tiempo, hecho, propias = [], turno = 0, errores = [], escrito = [];

const avisa = texto => { una('.aviso').textContent = texto; };

function cubre(texto) {
  telon.hidden = false;
  una('p', telon).textContent = texto;
}

/// Lo que escribe el programa: los errores de los shaders van al editor y lo demás se enseña.
function di(linea) {
  linea = linea.replace(/guion, orden \d+/, 'guion'); // las órdenes se dan de una en una
  escrito = [...escrito.slice(-9), linea];
  if (ejercicio && linea.includes('el uniform «')) return; // lo que aún no se usa
  const error = leeError(linea, actual.capitulo);
  if (error) return errores.push(error);
  consola.hidden = false;
  consola.append((consola.textContent ? '\n' : '') + linea);
  while (consola.childNodes.length > 200) consola.firstChild.remove();
  consola.scrollTop = consola.scrollHeight;
}

const talla = () => tallaDe(marco.getBoundingClientRect(), devicePixelRatio);

/// Empieza el programa actual y repite un guion.
async function empieza(guionInicial = '') {
  const mio = ++turno, lienzo = crea('canvas', { tabIndex: 0 });
  lienzo.style.touchAction = actual.raton ? 'none' : 'pan-y'; // si no se arrastra en él, el dedo pasa la página
  lienzo.setAttribute('role', 'application');
  lienzo.setAttribute('aria-label', `${actual.titulo}: las teclas van al programa`);
  const teniaFoco = marco.contains(document.activeElement);
  sesion?.cierra();
  sesion = undefined;
  todos('canvas', marco).forEach(c => c.remove());
  marco.prepend(lienzo);
  hecho = new Hecho(actual.anima);
  errores = [];
  escrito = [];
  telon.hidden = true;
  consola.hidden = true;
  consola.replaceChildren();
  una('.estado').textContent = '';
  avisa('');
  atiende(lienzo);
  let nueva;
  const ficheros = Object.fromEntries(propias.map(({ nombre, datos }) => ['/propias/' + nombre, datos]));
  try {
    nueva = await arranca(actual, {
      lienzo, ...talla(), textos: taller.textos(), ficheros, suavizado,
      di: linea => { if (mio === turno) di(linea); },
      titulo: texto => { if (mio === turno) una('.estado').textContent = texto; },
    });
    if (ejercicio && mio === turno) nueva = await conObjetivo(nueva, ficheros);
  } catch (error) {
    if (mio === turno) cubre(`No se puede arrancar el programa: ${error.message ?? error}`);
    return;
  }
  // hasta que no acaba de repetirse el guion no hay sesión: lo que se haga en la página no se mezcla con él
  const { ordenes, recortado } = leeGuion(guionInicial);
  await repite(ordenes, ({ orden, escala }) => mio === turno && atiendeOrden(nueva, orden, escala), () => {
    avisa('Repitiendo el guion…');
    return new Promise(sigue => setTimeout(sigue));
  });
  if (mio !== turno) return nueva.cierra();
  sesion = nueva;
  avisa(recortado ? 'El guion es demasiado largo: se ha repetido solo una parte.' : '');
  performance.mark('imagen');
  if (teniaFoco) lienzo.focus({ preventScroll: true });
  mira();
  ajusta();
  anota();
  tiempo = new Reloj(performance.now());
  pulso();
  if (ejercicio) comparaPronto();
}

/// Da una orden a un programa y la anota para el enlace. Falso si con ella ha terminado: eso no hay que repetirlo.
function atiendeOrden(programa, orden, escala) {
  programa.orden(escala ? `${escala};${orden}` : orden);
  if (programa.vivo) hecho.apunta(orden, escala || `escala ${programa.lienzo.width} ${programa.lienzo.height}`);
  return programa.vivo;
}

/// Da una orden al programa en marcha, si lo hay.
function manda(orden) {
  if (!sesion?.vivo) return false;
  const vive = atiendeOrden(sesion, orden);
  if (!vive) mira();
  return vive;
}

/// Si el programa ha terminado, lo dice.
function mira() {
  if (sesion.vivo || actual.consola) return;
  cubre(sesion.fallo ? escrito.slice(-3).join('\n') || 'El programa ha fallado' : 'El programa ha terminado');
}

/// Una vez por cuadro: el ratón que se ha movido y, si el programa se anima, el tiempo que ha pasado.
function pulso(ahora = performance.now()) {
  if (!sesion?.vivo) return;
  gestos.suelta();
  const ms = tiempo.pasa(ahora);
  if (actual.anima && ms) manda(`espera ${ms}`);
  cancelAnimationFrame(pulso.cuadro);
  if (actual.anima) pulso.cuadro = requestAnimationFrame(pulso);
}

/// Los sucesos del lienzo, a órdenes.
function atiende(lienzo) {
  const suyos = gestos = new Gestos({
    da: orden => sesion?.lienzo === lienzo && manda(orden), luego: requestAnimationFrame.bind(window), sigue: actual.sigue });
  const punto = suceso => {
    const r = lienzo.getBoundingClientRect();
    return { id: suceso.pointerId, x: (suceso.clientX - r.left) * lienzo.width / r.width, y: (suceso.clientY - r.top) * lienzo.height / r.height };
  };

  lienzo.addEventListener('keydown', suceso => {
    const orden = ordenDeTecla(suceso);
    if (!orden) return;
    suceso.preventDefault();
    if (orden === 'especial F11') return completa();
    if (orden === 'especial F5') return recarga();
    manda(orden);
  });
  lienzo.addEventListener('pointerdown', suceso => {
    lienzo.focus({ preventScroll: true });
    lienzo.setPointerCapture(suceso.pointerId);
    if (suceso.isPrimary) suceso.preventDefault();
    const menu = suceso.button === 2 && sesion?.opciones().length;
    const derecho = una('.derecho')?.getAttribute('aria-pressed') === 'true';
    suyos.baja(punto(suceso), menu ? '' : BOTONES[derecho && suceso.button < 3 ? 2 : suceso.button]);
    if (menu) ensenaMenu(suceso.clientX, suceso.clientY);
  });
  lienzo.addEventListener('pointermove', suceso => suyos.mueve(punto(suceso)));
  for (const fin of ['pointerup', 'pointercancel']) lienzo.addEventListener(fin, suceso => suyos.sube(punto(suceso)));
  lienzo.addEventListener('wheel', suceso => {
    suceso.preventDefault();
    suyos.gira(punto(suceso), suceso.deltaY, suceso.deltaMode);
  }, { passive: false });
  lienzo.addEventListener('contextmenu', suceso => suceso.preventDefault());

  // El navegador puede quitar el contexto (se ha reiniciado la tarjeta, hay demasiadas páginas): al devolverlo, se repite todo.
  lienzo.addEventListener('webglcontextlost', suceso => {
    if (sesion?.lienzo !== lienzo) return;
    suceso.preventDefault();
    const repetible = hecho.ordenes.join(';');
    lienzo.addEventListener('webglcontextrestored', () => {
      if (lienzo.isConnected) empieza(repetible).then(() => avisa('El navegador ha devuelto la tarjeta gráfica: todo sigue donde estaba.'));
    });
    turno++;
    sesion = undefined;
    cubre('El navegador ha perdido la tarjeta gráfica. Cuando la recupere, el programa seguirá donde estaba.');
  });
}

function ajusta() {
  const { ancho, alto } = talla();
  if (sesion?.vivo && (sesion.lienzo.width !== ancho || sesion.lienzo.height !== alto)) manda(`tamano ${ancho} ${alto}`);
}
new ResizeObserver(ajusta).observe(marco);

function completa() {
  if (document.fullscreenElement) document.exitFullscreen();
  else marco.requestFullscreen?.().then(() => una('canvas', marco).focus());
}

// --- ejercicios: el programa con el shader de quien lo hace y, al lado, el original. Lo que se hace con uno se hace con el otro --------

const EJERCICIOS = PROGRAMAS.flatMap(programa => programa.ejercicios.map(e => ({ ...e, programa, enlace: `ejercicio/${e.codigo}` })));
const veredicto = una('.veredicto');
let ejercicio, viendo = false, recien = false, revision, objetivos, pendiente, resueltos = new Set();

function enlazaEjercicio(e) {
  return crea('a', { className: 'a-ejercicio', href: `#ejercicio/${e.codigo}`, title: e.que });
}

/// Los resueltos, que quizá lo han sido en otra pestaña, en todos los enlaces.
function ponResueltos(...nuevos) {
  resueltos = new Set([...resueltos, ...leeResueltos(recuerdo('localStorage', 'resueltos')), ...nuevos]);
  if (nuevos.length) recuerdo('localStorage', 'resueltos', [...resueltos].join(' '));
  for (const a of todos('a.a-ejercicio[href*="/"]')) {
    const codigo = a.hash.split('/')[1];
    a.textContent = `Ejercicio ${codigo}${resueltos.has(codigo) ? ' ✓' : ''}`;
    a.ariaLabel = `Ejercicio ${codigo}${resueltos.has(codigo) ? ', resuelto' : ''}`;
  }
  una('.cuenta').textContent = `hay ${EJERCICIOS.length}, y has resuelto ${EJERCICIOS.filter(e => resueltos.has(e.codigo)).length}`;
}

/// Un programa en marcha que son dos: el que se ve y el de los shaders originales.
async function conObjetivo(suyo, ficheros) {
  const lienzo = crea('canvas', { role: 'img', ariaLabel: 'El objetivo' });
  una('.objetivo').replaceChildren(lienzo);
  const original = await arranca(actual, { lienzo, ancho: suyo.lienzo.width, alto: suyo.lienzo.height, ficheros, suavizado });
  return Object.assign(Object.create(suyo), {
    objetivo: lienzo,
    orden(texto) {
      suyo.orden(texto);
      if (texto !== 'especial F5') original.orden(texto);
      comparaPronto();
    },
    cierra() {
      suyo.cierra();
      original.cierra();
    },
  });
}

function pixeles(lienzo) {
  const { width, height } = lienzo, pincel = crea('canvas', { width, height }).getContext('2d', { willReadFrequently: true });
  pincel.drawImage(lienzo, 0, 0);
  return pincel.getImageData(0, 0, width, height).data;
}

function comparaPronto() {
  pendiente ??= setTimeout(comparaYa, 150);
}

function comparaYa() {
  pendiente = undefined;
  if (!ejercicio || !sesion?.vivo) return;
  const { width, height } = sesion.lienzo, imagen = new ImageData(width, height);
  const parte = compara(pixeles(sesion.lienzo), pixeles(sesion.objetivo), imagen.data);
  const lienzo = crea('canvas', { width, height, role: 'img', ariaLabel: 'En qué se diferencian' });
  lienzo.getContext('2d').putImageData(imagen, 0, 0);
  una('.diferencia').replaceChildren(lienzo);
  const dice = una('.parecido output');
  if (dice.textContent !== porciento(parte)) dice.textContent = porciento(parte);
  if (errores.length) dictamina('El shader tiene un error: la imagen es la de antes.', 'mal');
  else if (!revision && parte >= BASTA) revisa();
  else if (!revision) dictamina('');
}

function dictamina(texto, clase = '') {
  if (veredicto.textContent !== texto) veredicto.textContent = texto;
  veredicto.className = `veredicto ${clase}`;
}

/// Lo que dibuja un caso con esos shaders; nada, si no arranca.
async function imagenDe({ guion }, textos) {
  const lienzo = crea('canvas'), programa = await arranca(actual, { lienzo, ancho: 240, alto: 180, textos });
  programa.orden(guion);
  const imagen = programa.vivo && pixeles(lienzo);
  programa.cierra();
  return imagen;
}

/// Lo escrito coincide en lo que se está viendo: falta saber si coincide en todos los casos. Se deja si se escribe otra cosa.
async function revisa() {
  const esta = revision = {}, textos = taller.textos(), { casos } = actual, fallan = [];
  dictamina('Comparando cada caso…');
  for (const caso of casos) {
    const objetivo = await objetivos(caso), lograda = revision === esta && await imagenDe(caso, textos);
    if (revision !== esta) return;
    const coincide = lograda && compara(lograda, objetivo) >= BASTA;
    if (!coincide && recien) { // se empieza por donde hay algo que hacer
      olvidaRevision();
      return empiezaCaso(caso);
    }
    if (!coincide) fallan.push(caso);
    const b = todos('.casos-botones button')[casos.indexOf(caso)];
    if (b) b.dataset.coincide = coincide ? 'si' : 'no';
  }
  recien = false;
  if (fallan.length) return dictamina(casos.length > 1 ? `Falta que coincida en ${fallan.length} de los ${casos.length} casos.` : 'Falta que coincida al empezar.');
  ponResueltos(ejercicio.codigo);
  dictamina(casos.length > 1 ? `Resuelto: coincide en los ${casos.length} casos.` : 'Resuelto.', 'bien');
}

/// Lo escrito ha cambiado.
function olvidaRevision() {
  recien = false;
  revision = undefined;
  for (const b of todos('.casos-botones button')) delete b.dataset.coincide;
}

function ponEjercicio(guion) {
  pagina.classList.toggle('en-ejercicio', Boolean(ejercicio));
  taller = ejercicio ? new Taller('localStorage', `ejercicio ${ejercicio.codigo}`, ejercicio.codigo) : libre;
  viendo = false;
  const salir = ejercicio && crea('a', { className: 'a-ejercicio', href: '#' + actual.nombre, textContent: `Salir a «${actual.titulo}»` });
  una('.a-ejercicios', pagina).replaceChildren(...salir ? [salir] : actual.ejercicios.map(enlazaEjercicio));
  ponResueltos();
  if (!ejercicio) return;
  olvidaRevision();
  recien = guion === undefined;
  objetivos = recuerda(caso => imagenDe(caso, {}));
  dictamina('');
  una('.parecido output').textContent = '…';
  for (const cuadro of todos('.cuadro')) cuadro.replaceChildren();
  const pide = Object.entries(ejercicio.pide).map(([fichero, que]) =>
    crea('p', { className: 'enunciado' }, crea('code', { textContent: fichero.split('/').pop() }), `: ${que}.`));
  const ver = boton('Ver la solución', async () => {
    await aplicaYa();
    viendo = !viendo;
    ver.setAttribute('aria-pressed', viendo);
    await abre(abierto);
  });
  ver.setAttribute('aria-pressed', false);
  una('.tarea').replaceChildren(crea('div', {}, ...pide), ver);
}

// --- proyectar: el programa, su título, a qué hay que mirar y sus mandos, a toda pantalla ---------------------------------

let casoActual;
const escena = una('.escena');

function proyecta() {
  if (document.fullscreenElement) document.exitFullscreen();
  else escena.requestFullscreen?.().then(() => una('canvas', marco)?.focus());
}

/// Al caso que sigue o al que va delante; tras los de un programa, el programa vecino.
function pasa(paso) {
  const caso = actual.casos[actual.casos.indexOf(casoActual) + paso], vecino = PROGRAMAS[PROGRAMAS.indexOf(actual) + paso];
  if (caso) empiezaCaso(caso);
  else if (vecino) location.hash = vecino.nombre;
}

// Las flechas son del programa que las nombra; AvPág y RePág, que es lo que mandan los mandos de presentación, nunca.
document.addEventListener('keydown', suceso => {
  if (pagina.hidden || suceso.ctrlKey || suceso.altKey || suceso.metaKey) return;
  const flechas = !actual.mandos.some(m => m.teclas.some(([, orden]) => orden === 'especial DERECHA'));
  const paso = { PageDown: 1, PageUp: -1, ...flechas && { ArrowRight: 1, ArrowLeft: -1 } }[suceso.key];
  if (document.fullscreenElement === escena && paso) {
    suceso.preventDefault();
    suceso.stopPropagation();
    pasa(paso);
  } else if (suceso.key === 'p' && !suceso.target.closest('canvas, input, .editor')) proyecta();
}, { capture: true });

// --- mandos, menú, acciones --------------------------------------------------------------------------------------------

function boton(texto, hace, propiedades = {}) {
  return crea('button', { type: 'button', textContent: texto, onclick: hace, ...propiedades });
}

/// Un botón que, pulsado sin soltar, repite como una tecla.
function teclaDePantalla(texto, orden) {
  let reloj;
  const para = () => clearTimeout(reloj);
  const otra = () => { if (b.isConnected && manda(orden)) reloj = setTimeout(otra, 60); };
  const b = boton(texto, () => orden === 'especial F5' ? recarga() : manda(orden), {
    onpointerdown: () => { para(); reloj = setTimeout(otra, 450); }, onpointerup: para, onpointerleave: para, onpointercancel: para });
  return b;
}

function ponMandos() {
  const mandos = actual.mandos.map(({ teclas, hace, menu }) => {
    const texto = crea('span', { textContent: hace }), m = crea('span', { className: 'mando' });
    for (const [nombre, orden] of teclas) m.append(Object.assign(teclaDePantalla(nombre, orden), { ariaLabel: `${nombre}: ${hace}` }));
    if (menu) m.append(boton('Menú', suceso => {
      const r = suceso.currentTarget.getBoundingClientRect();
      ensenaMenu(r.left, r.bottom);
    }));
    else m.append(texto);
    return m;
  });
  if (actual.derecho) mandos.push(crea('span', { className: 'mando' }, boton('Botón derecho', suceso => {
    const b = suceso.currentTarget;
    b.setAttribute('aria-pressed', b.getAttribute('aria-pressed') !== 'true');
  }, { className: 'derecho' })));
  una('.mandos').replaceChildren(...mandos);
}

const opciones = una('.opciones');
function ensenaMenu(x, y) {
  const rutas = sesion?.opciones() ?? [];
  if (!rutas.length) return; // aún no hay programa, o ya no
  opciones.replaceChildren(...rutas.map(opcion =>
    boton(opcion.replaceAll('/', ' › '), () => { opciones.hidePopover(); manda(`menu ${opcion}`); }, { role: 'menuitem' })));
  opciones.showPopover();
  opciones.style.left = `${Math.max(Math.min(x, innerWidth - opciones.offsetWidth - 8), 8)}px`;
  opciones.style.top = `${Math.max(Math.min(y, innerHeight - opciones.offsetHeight - 8), 8)}px`;
  opciones.firstChild.focus();
}
opciones.addEventListener('keydown', suceso => {
  const paso = { ArrowDown: 1, ArrowUp: -1 }[suceso.key], lista = todos('button', opciones);
  if (!paso) return;
  lista[(lista.indexOf(document.activeElement) + paso + lista.length) % lista.length].focus();
  suceso.preventDefault();
});

for (const b of todos('.otra-vez')) b.onclick = () => empiezaCaso();
una('.completa').onclick = completa;
una('.proyecta').onclick = proyecta;
una('.guarda').onclick = () => sesion?.lienzo.toBlob(png => {
  const enlace = crea('a', { href: URL.createObjectURL(png), download: `${actual.nombre}.png` });
  enlace.click();
  setTimeout(() => URL.revokeObjectURL(enlace.href), 1000);
});
una('.enlace').onclick = async () => {
  history.replaceState(null, '', hazEnlace(ejercicio?.enlace ?? actual.nombre, hecho.ordenes));
  ruta = location.hash;
  try {
    await navigator.clipboard.writeText(location.href);
    avisa('Enlace copiado: lleva el programa y lo que se ha hecho con él.');
  } catch {
    avisa('El enlace está en la barra de direcciones.');
  }
};

function empiezaCaso(caso = casoInicial(actual)) {
  propias = [];
  ensenaCaso(caso);
  return empieza(caso.guion);
}

function ensenaCaso(caso) {
  casoActual = caso;
  for (const p of todos('.mira', pagina)) p.textContent = caso?.mira ?? '';
  for (const b of todos('.casos-botones button')) b.setAttribute('aria-pressed', b.textContent === caso?.titulo);
}

function ponCasos() {
  const botones = actual.casos.map(caso => boton(caso.titulo, () => empiezaCaso(caso)));
  una('.casos-botones').replaceChildren(...(botones.length > 1 ? botones : []));
}

// --- ficheros propios ---------------------------------------------------------------------------------------------------

/// La imagen de un fichero como PPM, que es lo que leen los programas.
async function aPpm(fichero) {
  const datos = new Uint8Array(await fichero.arrayBuffer());
  if (esPpm(datos)) return datos;
  const imagen = await createImageBitmap(fichero, { colorSpaceConversion: 'none' });
  const { width, height } = quepa(imagen), pincel = crea('canvas', { width, height }).getContext('2d');
  pincel.drawImage(imagen, 0, 0, width, height);
  return ppmDe(pincel.getImageData(0, 0, width, height).data, width, height);
}

async function abreFicheros(ficheros) {
  if (!actual?.admite || !ficheros.length) return;
  const nuevas = [], programa = actual;
  for (const fichero of ficheros) {
    const nombre = `${++abreFicheros.cuenta}-` + nombreLlano(fichero.name);
    try {
      if (actual.admite === 'modelo') nuevas.push({ nombre, datos: new Uint8Array(await fichero.arrayBuffer()) });
      else nuevas.push({ nombre: nombre.replace(/\.[^.]*$/, '') + '.ppm', datos: await aPpm(fichero) });
    } catch {
      return avisa(`«${fichero.name}» no es una imagen que este navegador sepa leer.`);
    }
  }
  if (programa !== actual) return; // mientras se leían se ha ido a otro
  const cuantas = actual.admite === 'imagenes' ? 2 : 1;
  propias = [...propias, ...nuevas].slice(-cuantas);
  if (propias.length < cuantas) return avisa('Falta otra imagen: este programa usa dos.');
  await empieza();
}

abreFicheros.cuenta = 0; // dos ficheros pueden llamarse igual

const entrada = una('.fichero input');
entrada.onchange = () => abreFicheros([...entrada.files]).then(() => { entrada.value = ''; });
una('.fichero').addEventListener('keydown', suceso => {
  if (suceso.key === 'Enter' || suceso.key === ' ') entrada.click();
});
addEventListener('dragover', suceso => suceso.preventDefault());
addEventListener('drop', suceso => {
  suceso.preventDefault();
  if (actual && !actual.admite) avisa('Este programa no lee ficheros.');
  else abreFicheros([...suceso.dataTransfer.files]);
});

// --- el editor ----------------------------------------------------------------------------------------------------------

let editor, abierto = '', reloj = 0;
async function ponEditor() {
  if (!editor) {
    const { css, js } = await json('editor');
    if (editor) return;
    document.head.prepend(crea('style', { textContent: css }));
    ejecuta(js);
    editor = CodeMirror(una('.editor'), { theme: 'lab', lineNumbers: true, lineWrapping: true, indentUnit: 4, matchBrackets: true,
      extraKeys: { Tab: false, 'Shift-Tab': false }, screenReaderLabel: 'Editor' });
    editor.on('change', (_, { origin }) => {
      if (origin === 'setValue' || viendo || !esShader(abierto)) return;
      clearTimeout(reloj);
      reloj = setTimeout(aplicaYa, 250);
    });
  }
}

function anota() { // los ficheros del programa: los que nombra y los que ha leído
  const leidos = [...sesion?.leidos ?? []].map(r => r.replace(/^\/lab\//, '')).filter(r => /^ch/.test(r) && esShader(r));
  const todas = ordenaFuentes([...leidos, ...actual.fuentes], actual.capitulo);
  const rutas = ejercicio ? delEjercicio(Object.keys(ejercicio.pide), todas) : todas;
  const pestana = ruta => boton(ruta.split('/').pop(), () => abre(ruta), { title: ruta });
  una('.pestanas').replaceChildren(...rutas.map(ruta => Object.assign(pestana(ruta), { ruta })));
  const [mal] = sesion.vivo ? [] : errores; // no ha podido arrancar
  abre([mal?.ruta, abierto].find(r => rutas.includes(r)) ?? rutas[0])
    .then(() => mal && editor.scrollIntoView({ line: mal.linea, ch: 0 }, 99), error => avisa(`No se pueden ver los ficheros: ${error.message}`));
}

async function abre(ruta) {
  await aplicaYa();
  abierto = ruta;
  for (const b of todos('.pestanas button')) b.setAttribute('aria-pressed', b.ruta === ruta);
  await ponEditor();
  const texto = viendo ? await solucion(ruta) : taller.cambios.get(ruta) ?? await taller.original(ruta);
  if (ruta !== abierto) return;
  editor.setOption('readOnly', viendo || !esShader(ruta));
  if (editor.ruta !== ruta || editor.getValue() !== texto) {
    editor.ruta = ruta;
    editor.setOption('mode', esShader(ruta) ? 'x-shader/x-fragment' : 'text/x-c++src');
    editor.swapDoc(CodeMirror.Doc(texto, editor.getOption('mode')));
    const marca = ejercicio && texto.split('\n').findIndex(l => esMarca(l));
    if (marca > 0) {
      editor.setCursor(marca + 1, 99, { scroll: false });
      editor.scrollTo(0, editor.heightAtLine(marca, 'local') - 60);
    }
  }
  marca();
}

/// Si esa línea es una de las dos entre las que se escribe el ejercicio.
const esMarca = linea => RegExp(`^ *// (fin de ${ejercicio?.codigo}$|${ejercicio?.codigo}: )`).test(linea);

/// Enseña en el editor los errores del último intento.
function marca() {
  const estado = una('.fichero-estado');
  editor.operation(() => {
    editor.eachLine(l => {
      editor.removeLineClass(l, 'background', 'linea-mala');
      if (ejercicio && esMarca(l.text)) editor.addLineClass(l, 'background', 'linea-marca');
      for (const w of [...l.widgets ?? []]) w.clear();
    });
    for (const { ruta, linea, mensaje } of errores.filter(e => e.ruta === abierto && e.linea <= editor.lineCount())) {
      editor.addLineClass(linea - 1, 'background', 'linea-mala');
      editor.addLineWidget(linea - 1, crea('div', { className: 'mensaje-malo', textContent: mensaje }));
    }
  });
  for (const b of todos('.pestanas button')) {
    b.classList.toggle('cambiado', taller.cambios.has(b.ruta));
    b.classList.toggle('mal', errores.some(e => e.ruta === b.ruta));
  }
  const mal = errores[0];
  estado.classList.toggle('mal', Boolean(mal));
  estado.replaceChildren(viendo ? 'Así está en el programa. Lo que has escrito sigue guardado.'
    : mal ? (mal.ruta ? `${mal.ruta}, línea ${mal.linea}: ${mal.mensaje}` : mal.mensaje)
    : !esShader(abierto) ? 'Solo para leer: lo que se puede cambiar aquí son los shaders.'
    : taller.cambios.has(abierto) ? 'Cambiado.' : 'Se aplica según se escribe.');
  if (!viendo && taller.cambios.has(abierto)) estado.append(boton(ejercicio ? 'Borrar lo escrito' : 'Volver al original', vuelve));
}

/// Lo que se acaba de escribir, sin esperar más: al cuarto de segundo o al irse a otro fichero.
function aplicaYa() {
  if (!reloj) return;
  clearTimeout(reloj);
  reloj = 0;
  return aplica();
}

async function aplica() {
  olvidaRevision();
  const programa = actual, suyo = taller, ruta = abierto, texto = editor.getValue();
  suyo.apunta(ruta, texto, await suyo.original(ruta));
  if (programa !== actual || suyo !== taller) return;
  if (!sesion?.vivo) return empieza(hecho.ordenes.join(';')); // quizá no arrancaba por este error
  sesion.escribe(ruta, texto);
  recarga();
}

/// F5: el programa vuelve a leer sus shaders, y lo que diga de ellos se enseña.
function recarga() {
  errores = [];
  manda('especial F5');
  if (editor) marca();
}

async function vuelve() {
  editor.setValue(await taller.original(abierto));
  clearTimeout(reloj);
  reloj = 0;
  await aplica();
}

// --- el catálogo y las rutas ---------------------------------------------------------------------------------------------

const busca = una('input[type=search]');
const fichas = new Map(todos('.tarjetas li').map((li, i) => [li, llano([PROGRAMAS[i].nombre, una('h2', li.closest('section')).textContent,
  li.textContent, ...PROGRAMAS[i].casos.map(c => c.mira)].join(' '))]));
busca.addEventListener('input', () => {
  for (const [li, contenido] of fichas) li.hidden = !casa(contenido, busca.value);
  for (const capitulo of todos('.capitulo')) capitulo.hidden = !una('li:not([hidden])', capitulo);
  una('.nada').hidden = una('.tarjetas li:not([hidden])') !== null;
});
document.addEventListener('keydown', suceso => {
  if (suceso.key === '/' && pagina.hidden && document.activeElement !== busca) {
    suceso.preventDefault();
    busca.focus();
  }
});

let ruta;
function navega() {
  if (location.hash === ruta) return;
  ruta = location.hash;
  aplicaYa();
  const { ejercicio: pedido, nombre, guion } = leeEnlace(ruta);
  ejercicio = pedido ? EJERCICIOS.find(e => e.codigo.toLowerCase() === nombre.toLowerCase()) : undefined;
  actual = pedido ? ejercicio?.programa : programaDe(nombre, PROGRAMAS);
  turno++;
  sesion?.cierra();
  sesion = undefined;
  propias = [];
  una('#catalogo').hidden = Boolean(actual);
  pagina.hidden = !actual;
  opciones.hidePopover();
  if (!actual) {
    ponResueltos();
    document.title = 'Síntesis de imagen y animación';
    const capitulo = nombre && PROGRAMAS.find(p => p.capitulo.split('_')[0] === nombre || p.capitulo === nombre)?.capitulo;
    una('#no-esta').hidden = !nombre || Boolean(capitulo);
    una('#no-esta').textContent = `No hay ningún ${pedido ? 'ejercicio' : 'programa'} «${corta(nombre, 60)}».`;
    if (capitulo) document.getElementById(capitulo).scrollIntoView();
    return;
  }
  scrollTo(0, 0);
  document.title = ejercicio ? `Ejercicio ${ejercicio.codigo}: ${ejercicio.que}` : actual.titulo;
  for (const titulo of [una('h1', pagina), una('h2.proyectado')]) titulo.textContent = document.title;
  const [referencias, libro] = document.getElementById('libro:' + actual.nombre).content.cloneNode(true).children;
  una('.de-que').replaceChildren(referencias);
  una('.del-libro', pagina).replaceChildren(libro);
  pagina.classList.toggle('de-consola', actual.consola);
  Object.assign(una('.de-capitulo'), { href: '#' + actual.capitulo, textContent: una(`#${actual.capitulo} h2`).textContent });
  const lista = ejercicio ? EJERCICIOS : PROGRAMAS, i = lista.indexOf(ejercicio ?? actual);
  for (const [clase, vecino] of [['.anterior', lista[i - 1]], ['.siguiente', lista[i + 1]]]) {
    una(clase).hidden = !vecino;
    if (vecino) una(clase).href = '#' + (vecino.enlace ?? vecino.nombre);
    una(clase + ' span').textContent = vecino?.titulo ?? vecino?.que ?? '';
  }
  una('.fichero').hidden = !actual.admite;
  una('.fichero span').textContent = actual.admite === 'modelo' ? 'Abrir un modelo .vf'
    : actual.admite === 'imagenes' ? 'Abrir dos imágenes' : 'Abrir una imagen';
  entrada.accept = actual.admite === 'modelo' ? '.vf' : 'image/*,.ppm';
  abierto = '';
  ponMandos();
  ponCasos();
  ponEjercicio(guion);
  if (guion === undefined) return empiezaCaso();
  ensenaCaso();
  empieza(guion);
}
addEventListener('hashchange', navega);
navega();
