// Lo que vale lo entregado: lo de herramientas/ejercicios/corrige/arbitro.py y veredicto.py, en la página, con la
// misma nota.

/// Cuánto se parecen dos imágenes.
export const BIEN = 1, CASI = 0.5;
export const ERROR_DE_OPENGL = 3; // con que acaba quien da alguno

/// Las líneas que se esperan y no están, en su orden, entre las escritas, que pueden ser más.
export function faltan(esperado, escrito) {
  const escritas = escrito.values();
  const esta = linea => {
    for (const otra of escritas) if (otra.includes(linea)) return true;
    return false;
  };
  return esperado.filter(linea => linea && !esta(linea));
}

/// De lo que no es la imagen ni cuenta en cada guion, en qué se apartan dos partidas: { qué: cómo se dice }.
export function aparte(esperada, obtenida) {
  const hay = {}, [debian, son] = [esperada.titulos, obtenida.titulos];
  const i = [...Array(Math.max(debian.length, son.length)).keys()].find(i => debian[i] !== son[i]);
  if (i >= 0) hay.titulo = `el título es «${son[i] ?? '(ninguno)'}» y debía ser «${debian[i] ?? '(ninguno)'}»`;
  const [falta] = faltan(esperada.texto, obtenida.texto);
  if (falta) hay.texto = `debía escribir «${falta}»`;
  if (obtenida.estado !== esperada.estado) hay.estado = `acaba con estado ${obtenida.estado}`;
  return hay;
}

/// Si, aunque las imágenes sean las mismas, no acaba como debe.
export const acabaMal = (esperada, { estado, cuelga }) =>
  estado !== esperada.estado && (cuelga || estado === ERROR_DE_OPENGL);

const suma = numeros => numeros.reduce((a, b) => a + b, 0);

/// De un guion jugado, `parecido` y, si es un caso que se ve bien y falla al seguirlo, `aMedias`; de los que no, nada.
const vale = ({ parecido, aMedias }, { casi, medias }) =>
  parecido === BIEN ? 1 : parecido === CASI ? casi / 100 : aMedias ? medias / 100 : 0;

/// La de los guiones, con lo que pesa cada uno: de 0 a 1.
export const parte = (guiones, reglas) =>
  suma(guiones.map(g => g.pesa * vale(g, reglas))) / suma(guiones.map(g => g.pesa));

/// Esa, junto con la de cada pieza, si se sabe, y sin lo que quita lo demás. Con un fallo que cueste algo no es 100.
export function nota(guiones, otros, reglas, piezas = []) {
  const entero = parte(guiones, reglas);
  const pesan = suma(piezas.map(p => p.pesa)), media = suma(piezas.map(p => p.pesa * p.parte)) / pesan;
  const mal = suma(piezas.filter(p => p.parte < 1).map(p => p.pesa)) || // o lo de fuera, como la que menos
    Math.min(...piezas.map(p => p.pesa).filter(Boolean));
  const puntos = piezas.length ? Math.max(entero + reglas.huecos / 100 * (media - entero), 1 - mal / pesan) : entero;
  const cuestan = suma(Object.keys(otros).map(que => reglas[que]));
  const todo = guiones.every(g => vale(g, reglas) === 1);
  return Math.min(redondea(puntos * (100 - cuestan)), todo && !cuestan ? 100 : 99.9);
}

/// A una cifra, como Python: lo que está justo en medio va a la que es par.
export function redondea(x) {
  const suyo = Number(x.toFixed(9)); // lo que mueve sumar en otro orden, no
  return Number((suyo % 1 === 0.25 ? suyo - 0.05 : suyo).toFixed(1));
}

/// Las menos órdenes con las que aún `falla(órdenes)`, que con todas falla; después, repetidas menos veces. Como mucho
/// se prueba esas veces.
export async function acorta(ordenes, falla, intentos) {
  const prueba = async candidatas => --intentos >= 0 && await falla(candidatas);
  if (ordenes.length > 1 && await prueba(ordenes.slice(-1))) ordenes = ordenes.slice(-1); // casi siempre basta
  for (let largo = Math.ceil(ordenes.length / 2); ordenes.length > 1 && intentos > 0;) {
    let menos;
    for (let i = 0; i < ordenes.length && !menos; i += largo) {
      const candidatas = [...ordenes.slice(0, i), ...ordenes.slice(i + largo)];
      if (candidatas.length && await prueba(candidatas)) menos = candidatas;
    }
    if (!menos && largo === 1) break;
    ordenes = menos ?? ordenes;
    largo = Math.min(menos ? largo : Math.ceil(largo / 2), Math.ceil(ordenes.length / 2));
  }
  for (const i of ordenes.keys()) {
    const [una, veces] = ordenes[i].split(' ×');
    for (const otras of veces ? [una, `${una} ×2`] : []) {
      const candidatas = Object.assign([...ordenes], { [i]: otras });
      if (!await prueba(candidatas)) continue;
      ordenes = candidatas;
      break;
    }
  }
  return ordenes;
}
