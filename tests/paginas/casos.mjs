// Los casos del catálogo, dibujados en la página: con el programa que trae o con el que se compila en ella.
import assert from 'node:assert/strict';
import { CASOS, comoGolden, PROGRAMAS } from './navegador.mjs';

/// En la página: lo que se dibuja con ese guion, y lo que se escribe. Con lo compilado, si lo hay (globalThis.modulos).
async function dibuja(nombre, guion) {
  const programa = JSON.parse(una('#programas').textContent).find(p => p.nombre === nombre), escrito = [];
  const s = await pagina.arranca(programa, { lienzo: document.createElement('canvas'), ancho: 240, alto: 180,
    suavizado: false, compilado: globalThis.modulos?.[nombre], di: linea => escrito.push(linea) });
  s.orden(guion);
  s.orden('captura /imagen.ppm');
  let ppm = '';
  if (s.vivo) for (const b of s.lee('/imagen.ppm')) ppm += String.fromCharCode(b);
  s.cierra();
  return [btoa(ppm), escrito.join('\n')];
}

export const delCapitulo = nombre => PROGRAMAS.filter(q => q.capitulo === nombre && !q.consola).map(q => q.nombre);

/// Los casos de esos programas que no son como su golden, y por qué. `otro`: si es otro OpenGL.
export async function distintos(p, nombres, otro) {
  const mal = [];
  for (const caso of CASOS.filter(c => nombres.includes(c.programa))) {
    const [ppm, escrito] = await p.da(dibuja, caso.programa, caso.guion);
    try {
      assert.ok(ppm, `${caso.fichero} no se dibuja: ${escrito}`);
      comoGolden(caso, Buffer.from(ppm, 'base64'), otro);
    } catch (error) {
      mal.push(error.message);
    }
  }
  return mal;
}
