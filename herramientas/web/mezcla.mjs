// Lo que debe quedar en un píxel, hecho otra vez: el color del shader mezclado con el que hay. Como lo hace
// herramientas/explica/pixel.cpp.
import { nombreDe } from './estado.mjs';

function factor(cual, canal, origen, destino, k) {
  const [, menos, de, que] = cual.match(/^GL_(ONE_MINUS_)?(SRC|DST|CONSTANT)_(COLOR|ALPHA)/) ?? [];
  if (cual === 'GL_SRC_ALPHA_SATURATE') return canal === 3 ? 1 : Math.min(origen[3], 1 - destino[3]);
  if (!de) return cual === 'GL_ONE' ? 1 : 0;
  const suyo = { SRC: origen, DST: destino, CONSTANT: k }[de][que === 'ALPHA' ? 3 : canal];
  return menos ? 1 - suyo : suyo;
}

const combina = (ecuacion, a, fa, b, fb) => ({
  GL_FUNC_SUBTRACT: a * fa - b * fb, GL_FUNC_REVERSE_SUBTRACT: b * fb - a * fa, GL_MIN: Math.min(a, b),
    GL_MAX: Math.max(a, b),
}[ecuacion] ?? a * fa + b * fb);

/// `color`: el del shader, de 0 a 1; `antes` y `despues`: los del píxel, de 0 a 255.
export function mezcla(gl, color, antes, despues) {
  const si = gl.isEnabled(gl.BLEND), llama = n => nombreDe(gl, gl.getParameter(gl[n])), acota = v =>
    Math.min(Math.max(v, 0), 1);
  const k = gl.getParameter(gl.BLEND_COLOR), escribe = gl.getParameter(gl.COLOR_WRITEMASK);
  const origen = color.map(v => si ? Math.round(acota(v) * 255) / 255 : acota(v)); // se mezcla con los bits que hay
  const destino = antes.map(v => v / 255), de = (c, que) => llama(`BLEND_${que}_${c === 3 ? 'ALPHA' : 'RGB'}`);
  const factorDe = (que, sin) => origen.map((_, c) => si ? factor(de(c, que), c, origen, destino, k) : sin);
  const factorOrigen = factorDe('SRC', 1), factorDestino = factorDe('DST', 0);
  const suma = origen.map((v, c) => !escribe[c] ? antes[c] : 255 * acota(si
    ? combina(de(c, 'EQUATION'), v, factorOrigen[c], destino[c], factorDestino[c]) : v));
  return { si, ecuacion: llama('BLEND_EQUATION_RGB'), factorOrigen, factorDestino, origen, destino, suma,
    cuadra: suma.slice(0, 3).every((v, c) => !(Math.abs(v - despues[c]) > 1)) };
}
