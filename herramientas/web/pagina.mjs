// La página de los programas (./lab web): va a lo que pide el enlace y junta las partes, que no saben de ella y le
// cuentan lo que pasa con alArrancar, alEscribir… pagina.py las mete todas en un guion, y lo que exporta esta se ve
// desde la consola del navegador y desde las pruebas como pagina.escena, pagina.editor…
import { atiendeBuscador } from '../base/buscador.mjs';
import { acomodaLado, sigueEnLado } from '../base/lado.mjs';
import { Taller } from './almacen.mjs';
import { ensenaCatalogo } from './catalogo.mjs';
import { json } from './datos.mjs';
import { avisa, crea, todos, una } from '../base/documento.mjs';
import { Editor } from './editor.mjs';
import { Ejercicio } from './ejercicio.mjs';
import { casoDe, hazEnlace, leeEnlace, programaDe } from './enlaces.mjs';
import { Escena } from './escena.mjs';
import { ensenaCaso, ponCasos, ponFicha } from './ficha.mjs';
import { cierraPixel, ensenaPixel } from './explicado.mjs';
import { delEjercicio, esShader, ordenaFuentes } from './fuentes.mjs';
import { casoInicial } from './guiones.mjs';
import { ponMandos } from './mandos.mjs';
import { cierraMenu } from './menu.mjs';
import { explicaPixel } from './pixel.mjs';
import { EJERCICIOS, PROGRAMAS } from './programas.mjs';
import { Propios } from './propios.mjs';
import { atiendeProyeccion, completa, proyecta } from './proyeccion.mjs';

export { arranca } from './programa.mjs';

/// Lo que se ve: { programa, ejercicio, taller, caso }; nada, en el catálogo.
export let visto = {};
const libre = new Taller('sessionStorage', 'cambios');
let ruta; // a la que se ha ido

export const escena = new Escena({ alArrancar, alRecargar: () => editor.marca(escena.errores) });
export const editor = new Editor({
  alEscribir: () => visto.ejercicio?.olvidaRevision(),
  alCambiar: (fichero, texto) => conCuidado(() => escena.cambia(fichero, texto)),
});
const propios = new Propios(() => empieza());

function empieza(guion) {
  const { programa, ejercicio, taller } = visto;
  const acompana = ejercicio && ((sesion, opciones) => ejercicio.conObjetivo(sesion, opciones));
  return conCuidado(() =>
    escena.empieza({ programa, textos: () => taller.textos(), ficheros: propios.ficheros, acompana }, guion));
}

/// Hace algo con lo escrito, apuntado hasta que se ve: leer un píxel espera a que esté dibujado.
async function conCuidado(hace) {
  const { taller } = visto;
  taller.dibuja(true);
  await hace();
  escena.sesion?.lienzo.getContext('webgl2')?.readPixels(0, 0, 1, 1, 0x1908, 0x1401, new Uint8Array(4)); // RGBA, bytes
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
  const { programa, ejercicio } = visto, { leidos, vivo } = escena.sesion;
  const shaders = [...leidos].map(r => r.replace(/^\/lab\//, '')).filter(r => /^ch/.test(r) && esShader(r));
  const todas = ordenaFuentes([...shaders, ...programa.fuentes], programa.capitulo);
  editor.ensena(ejercicio ? delEjercicio(Object.keys(ejercicio.pide), todas) : todas, escena.errores, vivo)
    .catch(error => avisa(`No se pueden ver los ficheros: ${error.message}`));
  ejercicio?.comparaPronto();
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
  editor.aplicaYa();
  const { ejercicio: esEjercicio, nombre, guion } = leeEnlace(ruta);
  const datos = esEjercicio ? EJERCICIOS.find(e => e.codigo.toLowerCase() === nombre.toLowerCase()) : undefined;
  const programa = esEjercicio ? datos?.programa : programaDe(nombre, PROGRAMAS);
  const caso = programa && casoDe(nombre, programa);
  if (caso && visto.programa === programa && !visto.ejercicio && guion === undefined) return empiezaCaso(caso);
  visto.ejercicio?.deja();
  escena.cierra();
  visto = { programa };
  una('#catalogo').hidden = Boolean(programa);
  una('#programa').hidden = !programa;
  document.body.classList.toggle('en-programa', Boolean(programa));
  (programa ? una('.migas') : document.body).prepend(una('.indice'));
  acomodaLado();
  cierraMenu();
  cierraPixel();
  apunta(false);
  propios.estrena(programa);
  if (!programa) return ensenaCatalogo(nombre, esEjercicio);
  entra(datos, caso, guion);
}

/// En el programa que se ve o, si es un ejercicio, con esos datos.
function entra(datos, caso, guion) {
  const { programa } = visto;
  const ejercicio = datos && new Ejercicio(datos, { escena, empiezaCaso, recien: guion === undefined });
  visto = { programa, ejercicio, taller: ejercicio?.taller ?? libre };
  ponFicha(programa, ejercicio);
  editor.estrena(programa, visto.taller, ejercicio?.codigo);
  ponMandos(programa, escena);
  ponCasos(programa, vaACaso);
  ejercicio?.pon(() => editor.cambiaDeVista());
  if (guion === undefined) return empiezaCaso(caso);
  ensenaCaso();
  empieza(guion);
}

function guardaImagen() {
  escena.sesion?.lienzo.toBlob(png => {
    const enlace = crea('a', { href: URL.createObjectURL(png), download: `${visto.programa.nombre}.png` });
    enlace.click();
    setTimeout(() => URL.revokeObjectURL(enlace.href), 1000);
  });
}

async function copiaEnlace() {
  history.replaceState(null, '', hazEnlace(visto.ejercicio?.enlace ?? visto.programa.nombre, escena.hecho.ordenes));
  ruta = location.hash;
  try {
    await navigator.clipboard.writeText(location.href);
    avisa('Enlace copiado: lleva el programa y lo que se ha hecho con él.');
  } catch {
    avisa('El enlace está en la barra de direcciones.');
  }
}

/// Por qué el píxel (x, y) del lienzo, desde arriba a la izquierda, tiene ese color.
export async function explica(x, y) {
  const { sesion } = escena, { taller } = visto;
  if (!sesion?.vivo) return;
  avisa('Mirando ese píxel…');
  const estaba = escena.quieta;
  escena.quieta = true;
  try {
    const datos = await explicaPixel(sesion.lienzo, x, y, sesion.redibuja);
    ensenaPixel(una('.explicacion'), { x, y, ...datos }, { ...await json('shaders'), ...await taller.textos() });
    avisa('');
    return datos;
  } catch (error) {
    avisa(`No se puede explicar: ${error.message}`);
  } finally {
    escena.quieta = estaba;
  }
}

/// El próximo clic del lienzo no llega al programa: es el píxel que se explica.
function apunta(si) {
  una('.explica').setAttribute('aria-pressed', si);
  una('.lienzo').classList.toggle('apunta', si);
}

una('.lienzo').addEventListener('pointerdown', suceso => {
  if (una('.explica').getAttribute('aria-pressed') !== 'true' || suceso.target.localName !== 'canvas') return;
  suceso.stopPropagation();
  suceso.preventDefault();
  const lienzo = suceso.target, r = lienzo.getBoundingClientRect();
  const parte = (v, desde, mide, n) => Math.min(Math.max(Math.floor((v - desde) * n / mide), 0), n - 1);
  apunta(false);
  explica(parte(suceso.clientX, r.left, r.width, lienzo.width), parte(suceso.clientY, r.top, r.height, lienzo.height));
}, true);
una('.explica').onclick = () => apunta(una('.explica').getAttribute('aria-pressed') !== 'true');

for (const b of todos('.otra-vez')) b.onclick = () => empiezaCaso();
una('.completa').onclick = completa;
una('.proyecta').onclick = proyecta;
una('.guarda').onclick = guardaImagen;
una('.enlace').onclick = copiaEnlace;
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
