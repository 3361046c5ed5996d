// web.mjs RAÍZ BUILD PÁGINA: la página de los programas (./lab web), con file://. Cada caso del catálogo se dibuja con
// su guion y es como su golden; lo demás, en uso.mjs, pantalla.mjs, editor.mjs y explica.mjs. Con
// LAB_OPENGL=swiftshader, solo los casos y sobre el que Chromium lleva dentro: con polygon offset sus mallas cambian de
// una vez a otra.
import assert from 'node:assert/strict';
import { CAPITULOS, enNavegadores, SWIFTSHADER } from './navegador.mjs';
import { delCapitulo, distintos } from './casos.mjs';
import { edicion } from './editor.mjs';
import { explica } from './explica.mjs';
import { pantalla } from './pantalla.mjs';
import { uso } from './uso.mjs';

const casos = CAPITULOS.map(({ nombre }) => [`cada caso de ${nombre} es como su golden`, async p => {
  await p.carga();
  assert.deepEqual(await distintos(p, delCapitulo(nombre), SWIFTSHADER), []);
}]);

enNavegadores(SWIFTSHADER ? ['chromium'] : ['chromium', 'firefox'],
  { ...Object.fromEntries(casos), ...SWIFTSHADER ? {} : { ...uso, ...pantalla, ...edicion, ...explica } });
