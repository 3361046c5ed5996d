// web.mjs RAÍZ BUILD PÁGINA: la página de los programas (./lab web), con file://. Cada caso del catálogo se dibuja con
// su guion y es como su golden; lo demás, en uso.mjs, pantalla.mjs, editor.mjs y explica.mjs. Con
// LAB_OPENGL=swiftshader, solo los casos y sobre el que Chromium lleva dentro: con polygon offset sus mallas cambian de
// una vez a otra.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';
import { ABRE, CAPITULOS, enNavegadores, RAIZ, SWIFTSHADER } from './navegador.mjs';
import { delCapitulo, distintos } from './casos.mjs';
import { edicion } from './editor.mjs';
import { explica } from './explica.mjs';
import { pantalla } from './pantalla.mjs';
import { pasea } from './paseo.mjs';
import { uso } from './uso.mjs';

const casos = CAPITULOS.map(({ nombre }) => [`cada caso de ${nombre} es como su golden`, async p => {
  await p.carga();
  assert.deepEqual(await distintos(p, delCapitulo(nombre), SWIFTSHADER), []);
}]);

/// El ordenador que la ha hecho no está en nada de lo que se sirve.
async function noDiceDonde() {
  for (const f of readdirSync(`${ABRE}/datos`).filter(f => !/^taller-\d/.test(f))) { // que son trozos
    const [, datos] = readFileSync(`${ABRE}/datos/${f}`, 'latin1').match(/","(.*)"/);
    assert.ok(!inflateSync(Buffer.from(datos, 'base64')).includes(RAIZ), f);
  }
}

const SITIOS = ['', '#grua-girada', '#grua;tecla d', '#ejercicio/L5.1', '#ejercicio/L5.2', '#sombras', '#menu',
  '#convolucion', '#luces_animadas', '#info_opengl', '#no_esta', '#cap5', '#l5.1', '#ejercicio/nada', '#incrusta/grua'];
const paseo = { 'un paseo al azar': p => pasea(p, { pasos: 60, sitios: SITIOS, lista: () => !visto.programa ||
  (sesion || !telon.hidden) && editor.ruta && editor.ruta === editor.abierto && !/^(Mirando|Repitiendo)/.test(aviso) &&
  !(visto.ejercicio && una('.marcador').textContent.includes('…')) }) };

enNavegadores(SWIFTSHADER ? ['chromium'] : ['chromium', 'firefox'],
  { ...Object.fromEntries(casos), ...SWIFTSHADER ? {} : { ...uso, ...pantalla, ...edicion, ...explica } });
if (!SWIFTSHADER) enNavegadores(['chromium'], { ...paseo, 'no dice dónde se ha hecho': noDiceDonde });
