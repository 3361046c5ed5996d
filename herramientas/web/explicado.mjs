// El panel que explica un píxel o el cuadro entero: lo que se ha averiguado, con los ficheros de que sale cada shader.
import { boton, crea, una } from '../base/documento.mjs';
import { muestraCuadro } from '../base/cuadro.mjs';
import { enLaVentana } from './enlaces.mjs';
import { lineasDe } from './lineas.mjs';

const sitio = una('.explicacion');

/// Los datos de cuadro_vivo.mjs como los quiere cuadro.mjs: cada shader por líneas, y cada orden con el suyo.
export function conFicheros(datos, textos) {
  const programas = datos.programas.map(p =>
    ({ ...p, vert: lineasDe(p.vert, textos, 'vert'), frag: lineasDe(p.frag, textos, 'frag') }));
  const frag = new Map(programas.map(p => [p.programa, p.frag.at(-1).fichero.split('/').pop()]));
  const ordenes = datos.ordenes.map(o => ({ ...o, frag: frag.get(o.programa) }));
  const deLinea = s => { // la que es de una línea de un shader
    const { programa } = datos.ordenes.find(o => o.n === s.orden);
    const { fichero, linea, texto } = programas.find(p => p.programa === programa)[s.etapa][s.linea - 1];
    const dice = fichero ? `${fichero.split('/').pop()}:${linea}` : `la línea ${linea} del shader`;
    return { ...s, sitio: { dice, texto: texto.trim() } };
  };
  return { ...datos, programas, ordenes, sospechas: datos.sospechas.map(s => (s.linea ? deLinea(s) : s)) };
}

/// El píxel, y cuál es en la ventana de siempre, que es el de los enlaces y el de ./lab explica.
function titulo(pixel, enlazado = enLaVentana(pixel, una('.lienzo canvas'))) {
  const [suyo, suVentana] = [pixel, enlazado.map(Math.round)].map(de => de.join(', '));
  return `El píxel (${suyo})${suyo === suVentana ? '' : `, que en la ventana de 960×720 es el (${suVentana})`}`;
}

/// Lo que se ha averiguado, con el píxel señalado en el lienzo. `alCerrar` se llama al dejarlo. Con `llama`, va allí.
export function ensena(datos, textos, { alCerrar, llama, enlazado }) {
  cierraExplicado();
  const { pixel } = datos, dentro = crea('div');
  const cierra = () => { cierraExplicado(); alCerrar(); };
  sitio.replaceChildren(crea('h2', { tabIndex: -1 }, pixel ? titulo(pixel, enlazado) : 'El cuadro entero'),
    boton('Cerrar', cierra, { className: 'cierra', title: 'También con Esc' }), dentro);
  muestraCuadro(conFicheros(datos, textos), dentro, { conImagen: false });
  sitio.hidden = false;
  sitio.onkeydown = suceso => { if (suceso.key === 'Escape') cierra(); };
  if (pixel) marca(pixel);
  if (!llama) return;
  sitio.scrollIntoView({ block: 'nearest' });
  una('h2', sitio).focus({ preventScroll: true });
}

/// Señala en el lienzo el píxel (x, y).
export function marca([x, y]) {
  una('.lienzo .aqui')?.remove();
  const { width, height } = una('.lienzo canvas'), parte = (v, n) => `${100 * (v + 0.5) / n}%`;
  una('.lienzo').append(crea('i', { className: 'aqui', style: `left: ${parte(x, width)}; top: ${parte(y, height)}` }));
}

export function cierraExplicado() {
  una('.lienzo .aqui')?.remove();
  sitio.hidden = true;
  sitio.replaceChildren();
}
