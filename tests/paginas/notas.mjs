// notas.mjs RAÍZ BUILD PÁGINA: lo que se hace bien y lo que se hace mal de cada ejercicio saca en la página lo que en
// ./lab corrige (notas.py), con los mismos guiones.
import assert from 'node:assert/strict';
import { dePython, enNavegadores } from './navegador.mjs';

const pregunta = (que, ...datos) => dePython(`import json, sys
from pathlib import Path
import notas
raiz, build, *resto = sys.argv[1:]
print(json.dumps(notas.${que}(Path(raiz), Path(build), *resto), default=lambda x: x.nombre))`, ...datos);

/// En la página: la nota de esos ficheros, con esos guiones.
async function nota(datos, fuentes) {
  const { ejercicio } = visto;
  Object.assign(await pagina.deEjercicio(ejercicio.codigo), datos);
  await ejercicio.abre({ fuentes, carpeta: '' });
  return (await pagina.correccion.hazla(ejercicio))?.nota ?? una('.correccion').textContent;
}

const SUELTOS = ruta => ruta.split('/').pop();

enNavegadores(['chromium'], Object.fromEntries(Object.keys(pregunta('programas')).map(codigo => [
  `${codigo}, lo mismo que ./lab corrige`, async p => {
    const { datos, entregas } = pregunta('de', codigo), notas = {}, debe = {};
    await p.abre(`#ejercicio/${codigo}`);
    for (const [nombre, { ficheros, nota: suya }] of Object.entries(entregas)) {
      const fuentes = Object.fromEntries(Object.entries(ficheros).map(([ruta, texto]) => [SUELTOS(ruta), texto]));
      notas[nombre] = await p.da(nota, datos, fuentes);
      debe[nombre] = suya;
    }
    assert.deepEqual(notas, debe);
  }])));
