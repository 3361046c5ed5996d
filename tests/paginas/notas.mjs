// notas.mjs RAÍZ BUILD PÁGINA: lo que se hace bien y lo que se hace mal de cada ejercicio saca en la página lo que en
// ./lab corrige (notas.py), con los mismos guiones.
import assert from 'node:assert/strict';
import { haceZip } from '../../herramientas/web/carpeta.mjs';
import { redondea } from '../../herramientas/web/nota.mjs';
import { dePython, enNavegadores } from './navegador.mjs';

const pregunta = (que, ...datos) => dePython(`import json, sys
from pathlib import Path
import notas
raiz, build, *resto = sys.argv[1:]
print(json.dumps(notas.${que}(Path(raiz), Path(build), *resto), default=lambda x: x.nombre))`, ...datos);

/// En la página: la nota de lo que hay en ella, con esos guiones.
async function nota(datos) {
  Object.assign(await pagina.deEjercicio(visto.ejercicio.codigo), datos);
  const { nota, piezas = [], dice = [] } = await pagina.correccion.hazla(visto.ejercicio) ?? {};
  return [nota ?? una('.correccion').textContent, ...piezas.map(p => 100 * p.parte),
    ...dice.filter(d => d.startsWith('parece '))];
}

/// Esos ficheros, con los finales de línea de Windows, en un .zip que se suelta en ella.
async function suelta(p, ficheros) {
  const principal = await p.da(() => visto.programa.nombre), hay = Object.entries(ficheros).map(([r, t]) =>
    [`entrega/${r.split('/').pop().replace(`${principal}.cpp`, 'entrega.cpp')}`, t.replace(/\n/g, '\r\n')]);
  await p.da(() => { visto.taller.cambios.clear(); una('.aviso').textContent = ''; });
  await p.suelta('entrega.zip', Buffer.from(await haceZip(Object.fromEntries(hay)).arrayBuffer()));
  await p.acaba('se abre', () => una('.aviso').textContent.startsWith('Abierto'));
}

enNavegadores(['chromium'], Object.fromEntries(Object.keys(pregunta('programas')).map(codigo => [
  `${codigo}, lo mismo que ./lab corrige`, async p => {
    const { datos, entregas } = pregunta('de', codigo), notas = {}, debe = {};
    await p.abre(`#ejercicio/${codigo}`);
    for (const [nombre, { ficheros, nota: suya, piezas, dice }] of Object.entries(entregas)) {
      await suelta(p, ficheros);
      notas[nombre] = (await p.da(nota, datos)).map(uno => Number.isFinite(uno) ? redondea(uno) : uno);
      debe[nombre] = [suya, ...piezas.map(p => p.nota), ...dice];
    }
    assert.deepEqual(notas, debe);
  }])));
