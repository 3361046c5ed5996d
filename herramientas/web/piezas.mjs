// La nota pieza a pieza: lo de herramientas/ejercicios/corrige/piezas.py, en la página.
const SANGRIA = /^[ \t]*(\/\/ .*?)[ \t]*$/gm; // la de una marca, que el editor puede cambiar
const COMENTARIO = /\/\/[^\n]*|\/\*[\s\S]*?\*\//g;

const pelado = texto => texto.replace(COMENTARIO, '').replace(/\s/g, '');
const enteros = texto => texto.replaceAll('\r\n', '\n').replace(SANGRIA, '    $1');

/// Los trozos de ese ejercicio, fichero a fichero.
function trozos(textos, codigo) {
  const trozo = new RegExp(`^( *// ${codigo}: (?<pide>.+)\n)(?<hecho>(?:.*\n)*?)( *// fin de ${codigo}\n)`, 'gm');
  return Object.entries(textos).sort(([a], [b]) => a < b ? -1 : 1)
    .flatMap(([, texto]) => [...enteros(texto).matchAll(trozo)].map(t => ({ entero: t[0], ...t.groups })))
    .filter(t => !t.hecho.includes(`// ${codigo}: `)); // sin cerrar, se ha comido la marca de otro
}

/// De cada uno de los que se piden, el que pide lo mismo o, si son tantos, el de su sitio.
function losDe(pedidos, hechos) {
  const piden = new Map(hechos.map(t => [t.pide, t])), mismos = pedidos.map(({ pide }) => piden.get(pide));
  const enSuSitio = hechos.length === pedidos.length && (mismos.includes(undefined) || piden.size < hechos.length);
  return enSuSitio ? hechos : mismos;
}

/// Por qué no se sabe lo que vale cada una.
export class SoloLoEntero extends Error {}

/// Los ficheros de la solución, con esas piezas: pieza(i).
export const conTodas = (solucion, pieza) => Object.fromEntries(Object.entries(solucion).map(([f, texto]) =>
  [f, texto.replace(/\0(\d+)\0\n/g, (_, j) => pieza(Number(j)))]));

/// Si todos esos ficheros están entre otros, sin mirar los comentarios ni los blancos.
export function estan(textos, escritos) {
  const suyos = new Set(Object.values(escritos).map(pelado));
  return Object.values(textos).every(texto => suyos.has(pelado(texto)));
}

/// De cada pieza de lo escrito, { pide, pesa, parte, de 0 a 1; falta, si es lo de partida; y guiones, si se juega }. De
/// `datos`, los de ejercicios.js: `solucion`, sus ficheros, con «\0i\0» donde va la pieza i, y `huecos`, de cada una
/// { pide, pesa, hecha, partida }. `arranca(textos)` dice cómo arranca un programa con esos ficheros, o nada si no
/// compilan; `juega(suyo, nada)`, { parte, guiones }, si no es lo mismo que lo que arranca como diga nada().
export async function porPiezas({ codigo, solucion, huecos }, escritos, { arranca, juega, avanza }) {
  const suyos = losDe(huecos, trozos(escritos, codigo)), falta = suyos.indexOf(undefined);
  if (falta >= 0)
    throw new SoloLoEntero(`no está entera la marca «// ${codigo}: ${huecos[falta].pide}», con su fin de ${codigo}`);
  const enLaSolucion = (i, suya) => conTodas(solucion, j => j === i ? suya : huecos[j].hecha);
  const conLasDemas = i => Object.fromEntries(Object.entries(escritos).map(([f, texto]) => [f, suyos.reduce(
    (hecho, t, j) => j === i ? hecho : hecho.replace(t.entero, () => huecos[j].hecha), enteros(texto))]));

  const parte = async i => {
    const { hecho } = suyos[i], { pide, hecha, partida } = huecos[i];
    if (pelado(hecho) === pelado(partida)) return { parte: 0, falta: true };
    if (pelado(hecho) === pelado(hecha)) return { parte: 1 };
    const suyo = await arranca(enLaSolucion(i, hecho)) ?? await arranca(conLasDemas(i)); // si usa lo de fuera
    if (!suyo) throw new SoloLoEntero(`sola no se puede probar «${pide}»: necesita lo que has escrito en otro sitio`);
    return juega(suyo, () => arranca(enLaSolucion(i, partida)));
  };
  const hechas = [];
  for (const [i, { pide, pesa }] of huecos.entries()) {
    avanza(i, huecos.length);
    hechas.push({ pide, pesa, ...await parte(i) });
  }
  return hechas;
}
