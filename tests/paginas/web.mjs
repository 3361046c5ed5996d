// web.mjs RAÍZ BUILD PÁGINA: la página de los programas (./lab web), con file://. Cada caso del catálogo se dibuja con
// su guion y es como su golden; lo demás, en uso.mjs, pantalla.mjs, editor.mjs y explica.mjs. Con
// LAB_OPENGL=swiftshader, solo los casos y sobre el que Chromium lleva dentro: con polygon offset sus mallas cambian de
// una vez a otra.
import assert from 'node:assert/strict';
import { CAPITULOS, CASOS, comoGolden, enNavegadores, PROGRAMAS, SWIFTSHADER } from './navegador.mjs';
import { edicion } from './editor.mjs';
import { explica } from './explica.mjs';
import { pantalla } from './pantalla.mjs';
import { uso } from './uso.mjs';

/// En la página: lo que se dibuja con ese guion, y lo que se escribe.
async function dibuja(nombre, guion) {
  const programa = JSON.parse(una('#programas').textContent).find(p => p.nombre === nombre), escrito = [];
  const s = await pagina.arranca(programa, { lienzo: document.createElement('canvas'), ancho: 240, alto: 180,
    suavizado: false, di: linea => escrito.push(linea) });
  s.orden(guion);
  s.orden('captura /imagen.ppm');
  let ppm = '';
  if (s.vivo) for (const b of s.lee('/imagen.ppm')) ppm += String.fromCharCode(b);
  s.cierra();
  return [btoa(ppm), escrito.join('\n')];
}

const casos = CAPITULOS.map(({ nombre }) => [`cada caso de ${nombre} es como su golden`, async p => {
  const suyos = PROGRAMAS.filter(q => q.capitulo === nombre && !q.consola).map(q => q.nombre), mal = [];
  await p.carga();
  for (const caso of CASOS.filter(c => suyos.includes(c.programa))) {
    const [ppm, escrito] = await p.da(dibuja, caso.programa, caso.guion);
    try {
      assert.ok(ppm, `${caso.fichero} no se dibuja: ${escrito}`);
      comoGolden(caso, Buffer.from(ppm, 'base64'), SWIFTSHADER);
    } catch (error) {
      mal.push(error.message);
    }
  }
  assert.deepEqual(mal, []);
}]);

enNavegadores(SWIFTSHADER ? ['chromium'] : ['chromium', 'firefox'],
  { ...Object.fromEntries(casos), ...SWIFTSHADER ? {} : { ...uso, ...pantalla, ...edicion, ...explica } });
