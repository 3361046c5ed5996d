// El panel que explica un píxel: quién ha querido pintarlo, qué le ha pasado a cada uno, y el shader del que ha ganado,
// línea a línea con sus valores.
import { boton, crea, una } from '../base/documento.mjs';
import { conInclusiones } from './primitivas.mjs';

const DICE = {
  escrito: 'escrito', cara: 'no: de espaldas', recorte: 'no: fuera del recorte', descartado: 'no: discard',
  plantilla: 'no: plantilla', profundidad: 'no: hay algo delante', mascara: 'no: no se escribe el color',
};
const DEVUELVE = 10; // su clase, en glsl.h
const VECES = 6; // de una línea que se ejecuta muchas, las que se enseñan

/// Un número como se lee.
export function cifra(n) {
  if (Number.isNaN(n)) return 'NaN';
  return Math.abs(n) === Infinity ? (n > 0 ? '∞' : '−∞') : String(Number(n.toPrecision(4))).replace('-', '−');
}

const SI_NO = ['no', 'sí'];

/// Lo que vale: «0.36», «(1, 0, 0)», «sí».
export function valorDicho({ tipo, valor }) {
  const partes = valor.map(n => /^b/.test(tipo) ? SI_NO[n] : cifra(n));
  return partes.length === 1 ? partes[0] : `(${partes.join(', ')})`;
}

/// Lo que se ha apuntado en cada línea del texto, con lo que se repite al final: { línea: ['x = 1', …] }.
export function porLinea(lineas) {
  const dichas = {};
  for (const l of lineas) {
    if (l.tipo === 'void' && !/^(discard|case|default)/.test(l.nombre)) continue;
    const suyas = dichas[l.linea] ??= [];
    const nombre = l.clase === DEVUELVE ? 'devuelve' : `${l.nombre} =`;
    suyas.push(l.valor.length ? `${nombre} ${valorDicho(l)}` : l.nombre);
  }
  for (const linea of Object.keys(dichas)) {
    const todas = dichas[linea], sobran = todas.length - VECES;
    if (sobran > 0) dichas[linea] = [...todas.slice(0, VECES - 1), `… y ${sobran} más`, todas.at(-1)];
  }
  return dichas;
}

/// De qué fichero es cada línea de ese texto; si no se encuentra, de ninguno.
export function lineasDe(texto, textos) {
  const cuerpo = texto.replace(/^[\s\S]*?\n#line 2\n/, '').replace(/\n$/, ''); // sin la cabecera de ES
  for (const ruta of Object.keys(textos).filter(r => r.endsWith('.frag'))) {
    const lineas = conInclusiones(ruta, textos);
    if (lineas.slice(1).map(l => l.texto).join('\n') === cuerpo) return lineas;
  }
  return ['#version 140', ...cuerpo.split('\n')].map((t, i) => ({ ruta: '', linea: i + 1, texto: t }));
}

const muestra = color => crea('i', { className: 'muestra', style: `background: rgb(${color.join(' ')})` });
const conColor = color => crea('span', { className: 'color' }, muestra(color), `(${color.join(', ')})`);

function fila({ orden, titulo, veredicto, color, despues, mezcla }) {
  const celda = (...dentro) => crea('td', {}, ...dentro);
  return crea('tr', { className: veredicto }, celda(String(orden)), celda(titulo),
    celda(...color ? [conColor(color)] : []),
    celda(DICE[veredicto] + (mezcla && veredicto === 'escrito' ? ', mezclado' : '')),
    celda(...veredicto === 'escrito' ? [conColor(despues)] : []));
}

function listado({ texto, lineas, sinSeguir }, textos) {
  const dichas = porLinea(lineas), codigo = crea('div', { className: 'codigo' });
  let ruta;
  for (const [i, l] of lineasDe(texto, textos).entries()) {
    if (/^\s*(\/\/.*|#version.*)?$/.test(l.texto)) continue; // no se ejecuta
    if (l.ruta !== ruta) codigo.append(crea('h3', { textContent: ruta = l.ruta }));
    const valores = dichas[i + 1] ?? [], mal = valores.some(v => /NaN|∞/.test(v));
    const quiza = sinSeguir.find(s => s.linea === i + 1);
    codigo.append(crea('div', { className: valores.length ? 'hecha' : '' },
      crea('span', { className: 'numero', textContent: l.linea }), crea('code', { textContent: l.texto }),
      crea('samp', { className: mal ? 'mal' : '',
        textContent: valores.join(' · ') + (quiza ? ` (${quiza.motivo})` : '') })));
  }
  return codigo;
}

/// Lo que se ha averiguado del píxel (x, y), en ese elemento. `textos`: los shaders, por su ruta.
export function ensenaPixel(sitio, { x, y, historia, color, shader }, textos) {
  cierraPixel(sitio);
  const tabla = crea('table', {}, crea('thead', {}, crea('tr', {}, ...['orden', 'quién', 'da', 'se escribe', 'queda']
    .map(t => crea('th', { textContent: t })))), crea('tbody', {}, ...historia.map(fila)));
  sitio.replaceChildren(
    crea('h2', {}, `El píxel (${x}, ${y})`, ...color ? [' es ', conColor(color)] : []),
    boton('Cerrar', () => cierraPixel(sitio)),
    historia.length ? crea('div', {}, tabla) : crea('p', { textContent: 'Ninguna orden lo toca.' }),
    ...shader ? [crea('h2', {}, 'El shader que se lo ha dado'), listado(shader, textos)] : []);
  sitio.hidden = false;
  sitio.scrollIntoView({ block: 'nearest' });
  const { width, height } = una('.lienzo canvas'), sitioDe = (v, n) => `${100 * (v + 0.5) / n}%`;
  const style = `left: ${sitioDe(x, width)}; top: ${sitioDe(y, height)}`;
  una('.lienzo').append(crea('i', { className: 'aqui', style }));
}

export function cierraPixel(sitio = una('.explicacion')) {
  una('.lienzo .aqui')?.remove();
  sitio.hidden = true;
  sitio.replaceChildren();
}
