// Las primitivas que dibuja una orden de OpenGL, sueltas: los índices de cada una, seguidos.

const [PUNTOS, LINEAS, , TIRA_LINEAS, TRIANGULOS, TIRA, ABANICO] = [0, 1, 2, 3, 4, 5, 6];

/// De los vértices de una llamada, `indices`, y su modo: { suelto, cada, indices }, que se dibuja con el modo `suelto`,
/// `cada` vértices por primitiva. El último de cada una es el que da los `flat`, como en la llamada; en una tira se
/// conserva el giro.
export function sueltas(modo, indices) {
  const n = indices.length, salida = [];
  if (modo === PUNTOS || modo === LINEAS || modo === TRIANGULOS) {
    const cada = { [PUNTOS]: 1, [LINEAS]: 2, [TRIANGULOS]: 3 }[modo];
    return { suelto: modo, cada, indices: indices.slice(0, n - n % cada) };
  }
  if (modo === TIRA || modo === ABANICO) {
    for (let i = 0; i + 2 < n; ++i) {
      const [a, b] = modo === ABANICO ? [0, i + 1] : i % 2 ? [i + 1, i] : [i, i + 1];
      salida.push(indices[a], indices[b], indices[i + 2]);
    }
    return { suelto: TRIANGULOS, cada: 3, indices: salida };
  }
  for (let i = 0; i + 1 < n; ++i) salida.push(indices[i], indices[i + 1]);
  if (modo !== TIRA_LINEAS && n > 2) salida.push(indices[n - 1], indices[0]);
  return { suelto: LINEAS, cada: 2, indices: salida };
}

/// Los números, de menor a mayor, de 0 a n − 1 que cumplen: `alguno(desde, hasta)` dice si lo hace alguno de ese tramo.
export function cuales(n, alguno) {
  const halla = (desde, hasta) => desde >= hasta || !alguno(desde, hasta) ? []
    : hasta - desde === 1 ? [desde]
    : [...halla(desde, (desde + hasta) >> 1), ...halla((desde + hasta) >> 1, hasta)];
  return halla(0, n);
}

/// El valor de un tipo de GLSL, de lo que llevan los pasos que ocupa, cuatro números cada uno: glsl.h dice cómo.
export function valor(tipo, pasos) {
  const [, letra, filasDeVector] = tipo.match(/^([iub]?)vec(\d)$/) ?? [];
  const [, columnas, filas = columnas] = tipo.match(/^mat(\d)(?:x(\d))?$/) ?? [];
  if (columnas) return Array.from({ length: columnas * filas }, (_, k) => pasos[4 * Math.floor(k / filas) + k % filas]);
  if (tipo === 'void') return [];
  const n = Number(filasDeVector ?? 1), entero = letra === 'i' || letra === 'u' || tipo === 'int' || tipo === 'uint';
  return Array.from({ length: n }, (_, k) => pasos[k] + (entero ? 65536 * pasos[(n > 2 ? 4 : n) + k] : 0));
}

/// Las líneas de un shader con sus #include en su sitio, como las da common/shader.cpp: { fichero, linea, texto }.
export function conInclusiones(ruta, textos, pila = []) {
  return textos[ruta].replace(/^\ufeff/, '').replace(/\n$/, '').split('\n').flatMap((texto, i) => {
    const [, incluido] = texto.match(/^\s*#include\s*"(.+)"\s*$/) ?? [];
    return incluido && textos[incluido] !== undefined && !pila.includes(incluido)
      ? conInclusiones(incluido, textos, [...pila, ruta]) : { fichero: ruta, linea: i + 1, texto };
  });
}

/// De qué fichero es cada línea de ese texto; si no se encuentra, de ninguno. `tipo`: vert o frag.
export function lineasDe(texto, textos, tipo) {
  const cuerpo = texto.replace(/^[\s\S]*?\n#line 2\n/, '').replace(/\n$/, ''); // sin la cabecera de ES
  for (const ruta of Object.keys(textos).filter(r => r.endsWith(`.${tipo}`))) {
    const lineas = conInclusiones(ruta, textos);
    if (lineas.slice(1).map(l => l.texto).join('\n') === cuerpo) return lineas;
  }
  return ['#version 140', ...cuerpo.split('\n')].map((t, i) => ({ fichero: '', linea: i + 1, texto: t }));
}
