// La página de los programas (./lab web): va a lo que pide el enlace y junta las partes, que no saben de ella y le
// cuentan lo que pasa con alArrancar, alEscribir… pagina.py las mete todas en un guion, y lo que exporta esta se ve
// desde la consola del navegador y desde las pruebas como pagina.escena, pagina.editor…
import { atiendeBuscador } from '../base/buscador.mjs';
import { acomodaLado, sigueEnLado } from '../base/lado.mjs';
import { Taller } from './almacen.mjs';
import { ensenaCatalogo } from './catalogo.mjs';
import { loSoltado } from './carpeta.mjs';
import { Compilacion } from './compilacion.mjs';
import { SE_COMPILA } from './compilador.mjs';
import { Correccion } from './correccion.mjs';
import { json } from './datos.mjs';
import { avisa, todos, una } from '../base/documento.mjs';
import { guarda } from './descarga.mjs';
import { explicaCuadro } from './cuadro_vivo.mjs';
import { Editor } from './editor.mjs';
import { Ejercicio } from './ejercicio.mjs';
import { casoDe, enEnlace, hazEnlace, leeEnlace, pixelEn, programaDe } from './enlaces.mjs';
import { atiendeTeclado } from './entrada.mjs';
import { Escena } from './escena.mjs';
import { ensenaCaso, ensenaImagen, ponCasos, ponFicha } from './ficha.mjs';
import { cierraExplicado, ensena } from './explicado.mjs';
import { deLaCarpeta, delEjercicio, esShader, incluidas, ordenaFuentes } from './fuentes.mjs';
import { casoInicial } from './guiones.mjs';
import { copiaLinea, incrusta, lineaDe } from './incrustado.mjs';
import { ponMandos } from './mandos.mjs';
import { cierraMenu } from './menu.mjs';
import { EJERCICIOS, PROGRAMAS } from './programas.mjs';
import { Propios } from './propios.mjs';
import { apunta, atiendePunteria } from './punteria.mjs';
import { atiendeProyeccion, completa, proyecta } from './proyeccion.mjs';

export { deEjercicio } from './almacen.mjs';
export { arranca } from './programa.mjs';

/// Lo que se ve: { programa, ejercicio, taller, caso, explicado }; nada, en el catálogo.
export let visto = {};
const libre = new Taller('sessionStorage', 'cambios');
let ruta; // a la que se ha ido
let sitio = 0; // por dónde se dejó el catálogo
let explicando = Promise.resolve();

export const escena = new Escena({ alArrancar, alRecargar, alFallar: error => compilacion.falla(error),
  sinWebGL: () => ensenaImagen(visto.programa) });
export const editor = new Editor({
  alEscribir: () => {
    visto.ejercicio?.olvidaRevision();
    correccion.olvida();
    if (visto.ejercicio?.seCompila) compilacion.adelanta();
  },
  alCambiar: (fichero, texto) => esShader(fichero) ? conCuidado(() => escena.cambia(fichero, texto)) : editor.marca(),
  alCompilar: SE_COMPILA && compila,
});
export const compilacion = new Compilacion({
  visto: () => visto,
  alDecir: () => editor.marca(errores()),
  alCompilar: () => conCuidado(() => escena.repite()),
  vaA: sitio => editor.vaA(sitio),
});
export const correccion = new Correccion({ compilacion,
  ensena: async (guion, pixel) => {
    ensenaCaso(); // no es ninguno
    await empieza(guion);
    una('.cuadros').scrollIntoView({ block: 'nearest' }); // en un teléfono no se vería
    await explicaEn(pixel);
  } });
const propios = new Propios(() => empieza(), abreSoltado);

/// Los de los shaders y los de los fuentes.
const errores = () => [...escena.errores, ...compilacion.dichos];

/// Lo que está escrito, aunque se acabe de teclear. En una función, que se alza: el editor la nombra antes.
async function compila() {
  await editor.aplicaYa();
  return compilacion.hazlo();
}

function empieza(guion) {
  dejaDeExplicar();
  const { programa, ejercicio, taller } = visto;
  const deEjercicio = ejercicio && { programa: ejercicio.suyo, arranca: opciones => ejercicio.arranca(opciones),
    acompana: (sesion, opciones) => ejercicio.conObjetivo(sesion, opciones), rutaDe: ruta => ejercicio.rutaDe(ruta) };
  return conCuidado(() =>
    escena.empieza({ programa, textos: () => taller.textos(), ficheros: propios.ficheros,
      compilado: () => compilacion.modulo(programa, taller, ejercicio), ...deEjercicio }, guion));
}

/// Lo de un ejercicio que se ha soltado en la página: va a él y lo abre. Falso, si no es eso.
function abreSoltado(dataTransfer) {
  const lee = loSoltado(dataTransfer);
  if (lee) abreCarpeta(lee).catch(({ message }) => {
    if (visto.programa) avisa(message);
    else Object.assign(una('#no-esta'), { hidden: false, textContent: message }).scrollIntoView();
  });
  return Boolean(lee);
}

async function abreCarpeta(lee) {
  const hay = await lee(), suyo = hay.codigo && EJERCICIOS.find(e => e.codigo === hay.codigo);
  if (hay.codigo && !suyo) throw new Error(`La carpeta es de «${hay.codigo}», que no es un ejercicio de esta página.`);
  if (!suyo && !visto.ejercicio) throw new Error('No se sabe de qué ejercicio es: entra en él y suéltalo allí.');
  await editor.aplicaYa();
  if (suyo && visto.ejercicio?.codigo !== suyo.codigo) {
    location.hash = suyo.enlace;
    navega();
  }
  const { ejercicio, taller } = visto;
  if (taller.cambios.size && !confirm('Aquí ya hay algo escrito. ¿Cambiarlo por lo que se ha soltado?')) return;
  await ejercicio.abre(hay);
  ejercicio.olvidaRevision();
  correccion.olvida();
  await empiezaCaso();
  avisa(`Abierto: ${Object.keys(hay.fuentes).join(', ')}.`);
}

async function corrige() {
  await editor.aplicaYa();
  return correccion.hazla(visto.ejercicio);
}

/// Hace algo con lo escrito, apuntado hasta que se ve: leer un píxel, que es lo que hace la sesión, espera a eso.
async function conCuidado(hace) {
  const { taller } = visto;
  taller.dibuja(true);
  await hace();
  escena.sesion?.acabaDeDibujar?.();
  taller.dibuja(false);
  if (taller.aparte && visto.taller === taller)
    avisa('Con lo escrito en los shaders la página dejó de responder: esto es sin ello, hasta que lo cambies.');
}

export function empiezaCaso(caso = casoInicial(visto.programa)) {
  propios.olvida();
  visto.caso = caso;
  ensenaCaso(caso);
  return empieza(caso.guion);
}

/// Los ficheros del programa: los que nombra y los que ha leído.
function alArrancar() {
  const { programa, ejercicio, taller } = visto, { leidos, vivo } = escena.sesion;
  const shaders = [...leidos].map(r => r.replace(/^\/lab\//, '')).filter(r => /^ch/.test(r) && esShader(r));
  const todas = ordenaFuentes([...shaders, ...programa.fuentes], programa.capitulo);
  const rutas = ejercicio?.carpeta ? taller.escritos().then(textos => deLaCarpeta(Object.keys(ejercicio.pide), textos))
    : ejercicio ? delEjercicio(Object.keys(ejercicio.pide), todas) : todas;
  Promise.resolve(rutas).then(rutas => taller === visto.taller &&
    editor.ensena(rutas, errores(), vivo, SE_COMPILA && !ejercicio && (() => deComun(programa))))
    .catch(error => avisa(`No se pueden ver los ficheros: ${error.message}`));
  ejercicio?.comparaPronto();
}

/// Los fuentes de common/ que usa un programa.
async function deComun({ capitulo, nombre }) {
  const suyos = incluidas(`${capitulo}/${nombre}.cpp`, await compilacion.originales());
  return ordenaFuentes([...suyos].filter(r => r.startsWith('common/')), capitulo);
}

function alRecargar() {
  editor.marca(errores());
  if (explicado()) explica(explicado().pixel, false);
}

/// Un caso de un programa, en su dirección: con «Atrás» se vuelve al que se veía. En un ejercicio no la tiene.
function vaACaso(caso, va = enlace => { location.hash = enlace; }) {
  const enlace = '#' + caso.fichero;
  if (visto.ejercicio || location.hash === enlace) empiezaCaso(caso);
  else va(enlace);
}

/// Al caso que sigue o al que va delante; tras los de un programa, el programa vecino.
function pasa(paso) {
  const { programa, caso } = visto, queSigue = (lista, uno) => lista[lista.indexOf(uno) + paso];
  const otro = queSigue(programa.casos, caso), vecino = queSigue(PROGRAMAS, programa);
  if (otro) vaACaso(otro, enlace => location.replace(enlace));
  else if (vecino) location.replace('#' + vecino.nombre);
}

/// Al primer programa de su capítulo o al último.
function salta(cual) {
  const suyos = PROGRAMAS.filter(p => p.capitulo === visto.programa.capitulo);
  location.replace('#' + suyos.at(cual).nombre);
}

function navega() {
  if (location.hash === ruta) return;
  ruta = location.hash;
  if (!una('#catalogo').hidden) sitio = scrollY;
  editor.aplicaYa();
  const { ejercicio: esEjercicio, nombre, guion, pixel, incrusta: solo } = leeEnlace(ruta);
  const datos = esEjercicio ? EJERCICIOS.find(e => e.codigo.toLowerCase() === nombre.toLowerCase()) : undefined;
  const programa = esEjercicio ? datos?.programa : programaDe(nombre, PROGRAMAS);
  const caso = programa && casoDe(nombre, programa);
  incrusta(solo && programa);
  if (caso && visto.programa === programa && !visto.ejercicio && guion === undefined)
    return empiezaCaso(caso).then(() => explicaEn(pixel));
  visto.ejercicio?.deja();
  correccion.olvida();
  escena.cierra();
  visto = { programa };
  compilacion.olvida();
  una('#catalogo').hidden = Boolean(programa);
  una('#programa').hidden = !programa;
  document.body.classList.toggle('en-programa', Boolean(programa));
  (programa ? una('.migas') : document.body).prepend(una('.indice'));
  acomodaLado();
  cierraMenu();
  dejaDeExplicar();
  propios.estrena(programa);
  if (!programa) return ensenaCatalogo(nombre, esEjercicio, sitio);
  entra(datos, caso, guion).then(() => explicaEn(pixel));
}

/// En el programa que se ve o, si es un ejercicio, con esos datos.
function entra(datos, caso, guion) {
  const { programa } = visto;
  const ejercicio = datos && new Ejercicio(datos, { escena, empiezaCaso, recien: guion === undefined });
  visto = { programa, ejercicio, taller: ejercicio?.taller ?? libre };
  ponFicha(programa, ejercicio);
  editor.estrena(programa, visto.taller, ejercicio);
  ponMandos(programa, escena);
  ponCasos(programa, vaACaso);
  ejercicio?.pon(() => editor.cambiaDeVista(), corrige);
  if (ejercicio?.seCompila && compilacion.compilador.listo && !compilacion.modulo(programa, visto.taller, ejercicio))
    compila();
  if (guion !== undefined) ensenaCaso();
  const empezado = guion === undefined ? empiezaCaso(caso) : empieza(guion);
  // en el disco no hay que esperar a que escriba para traerlo
  return empezado.then(() => { if (ejercicio?.seCompila && location.protocol === 'file:') compilacion.adelanta(); });
}

function guardaImagen() {
  escena.sesion?.lienzo.toBlob(png => guarda(png, `${visto.programa.nombre}.png`));
}

/// El enlace de lo que se ve.
function enlaceDe() {
  const { pixel, ordenes = escena.hecho.ordenes } = explicado() ?? {};
  const nombre = (visto.ejercicio?.enlace ?? visto.programa.nombre) + (pixel ? enEnlace(pixel, escena.sesion.lienzo)
    : '');
  return hazEnlace(nombre, ordenes);
}

async function copiaEnlace() {
  history.replaceState(null, '', enlaceDe());
  ruta = location.hash;
  try {
    await navigator.clipboard.writeText(location.href);
    avisa('Enlace copiado: lleva el programa y lo que se ha hecho con él.');
  } catch {
    avisa('El enlace está en la barra de direcciones.');
  }
}

/// Cómo se ha dibujado el cuadro que se ve y, si se da, por qué tiene ese color el píxel [x, y] del lienzo, desde
/// arriba a la izquierda. Con `llama`, se va allí. `enlazado`, si lo dice un enlace: el de su ventana.
export function explica(pixel, llama = true, enlazado = undefined) {
  // de uno en uno: todos dibujan en el mismo lienzo
  explicando = explicando.then(() => explicaYa(pixel, llama, enlazado));
  return explicando;
}

async function explicaYa(pixel, llama, enlazado) {
  const { sesion } = escena, { taller } = visto;
  if (!sesion?.vivo) return;
  if (sesion.vacio) return avisa('Lo tuyo se explica cuando está compilado.');
  if (llama) avisa(pixel ? 'Mirando ese píxel…' : 'Mirando cómo se dibuja…');
  const estaba = escena.quieta, ordenes = [...escena.hecho.ordenes];
  escena.quieta = true;
  try {
    const datos = await explicaCuadro(sesion, pixel);
    if (sesion !== escena.sesion) return;
    const textos = { ...await json('shaders'), ...await taller.textos() };
    visto.explicado = { pixel, ordenes };
    const alCerrar = () => { visto.explicado = undefined; una('.explica').focus(); };
    ensena(datos, textos, { llama, enlazado, alCerrar });
    if (llama) avisa('');
    return datos;
  } catch (error) {
    if (sesion === escena.sesion) avisa(`No se puede explicar: ${error.message}`);
  } finally {
    escena.quieta = estaba;
  }
}

/// Lo que se está enseñando de él: { pixel, ordenes }, lo que se había hecho hasta entonces.
const explicado = () => una('.explicacion').hidden ? undefined : visto.explicado;

/// El píxel de un enlace, si lo lleva.
function explicaEn(pixel) {
  const lienzo = escena.sesion?.lienzo, suyo = pixel && lienzo && pixelEn(pixel, lienzo);
  if (suyo) return explica(suyo, true, pixel);
  if (pixel && lienzo) avisa(`El píxel ${pixel.join(', ')} no está en la ventana, de 960×720.`);
}

function dejaDeExplicar() {
  visto.explicado = undefined;
  apunta(false);
  cierraExplicado();
}

atiendeTeclado(escena, () => visto.programa);
atiendePunteria(explica, () => escena.sesion?.vivo && !visto.programa.consola);
una('.explica-cuadro').onclick = () => explica();
if (SE_COMPILA) una('.compila').onclick = compila;
for (const b of todos('.otra-vez')) b.onclick = () => empiezaCaso();
una('.completa').onclick = completa;
una('.proyecta').onclick = proyecta;
una('.guarda').onclick = guardaImagen;
una('.enlace').onclick = copiaEnlace;
una('.incrusta').onclick = () =>
  copiaLinea(lineaDe(hazEnlace(visto.programa.nombre, escena.hecho.ordenes), visto.programa.titulo));
atiendeProyeccion(() => visto.programa, { pasa, salta });
atiendeBuscador(() => json('indice'));
sigueEnLado('#catalogo .capitulo');
addEventListener('hashchange', navega);
addEventListener('storage', ({ key }) => { // lo ha guardado otra pestaña
  if (!visto.ejercicio || key !== visto.taller.clave) return;
  visto.taller.relee();
  editor.abre(editor.abierto);
  escena.repite().then(() => avisa('Este ejercicio está abierto en otra pestaña y ha cambiado: es lo que se ve aquí.'));
});
navega();
