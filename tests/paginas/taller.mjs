// taller.mjs RAÍZ BUILD PÁGINA: compilar en la página. Cada programa, sin cambiar, da sus golden; y cada error de los
// que comete quien empieza (errores.tsv) queda en su línea.
import assert from 'node:assert/strict';
import { delCapitulo, distintos } from './casos.mjs';
import { CAPITULOS, enNavegadores, lee } from './navegador.mjs';

const GRUA = 'ch03_transformaciones/grua.cpp';
const linea = texto => texto.split('\n').length;

/// En la página: compila ese programa con lo que hay en el laboratorio, menos esos textos.
async function compila(nombre, cambios) {
  const { compilador } = pagina.compilacion, programa = JSON.parse(una('#programas').textContent)
    .find(p => p.nombre === nombre);
  await compilador.prepara(() => {}, new AbortController().signal);
  const fuentes = { ...await pagina.compilacion.originales(), ...cambios };
  const { modulo, dichos } = await compilador.compila(programa, fuentes, Object.keys(cambios));
  globalThis.modulos = { [nombre]: modulo };
  return [Boolean(modulo), dichos];
}

const programas = CAPITULOS.map(({ nombre, programas }) => [`los programas de ${nombre}, compilados, dan sus golden`,
  async p => {
    const mal = [], conImagen = delCapitulo(nombre);
    await p.carga();
    for (const { nombre: programa } of programas) {
      const [sale, dichos] = await p.da(compila, programa, {});
      if (!sale || dichos.length) mal.push(`${programa}: ${JSON.stringify(dichos)}`);
      else if (conImagen.includes(programa)) mal.push(...await distintos(p, [programa], true));
    }
    assert.deepEqual(mal, []);
  }]);

const uso = {
  'cada error queda en su línea': async p => {
    const original = lee(GRUA), mal = [];
    await p.carga();
    const filas = lee('tests/paginas/errores.tsv').trimEnd().split('\n')
      .map(fila => fila.replaceAll('\\n', '\n').split('\t'));
    for (const [que, de, a, dice, salto = '0'] of filas) {
      const donde = original.indexOf(de), debe = linea(original.slice(0, donde)) + Number(salto);
      const [sale, dichos] = await p.da(compila, 'grua', { [GRUA]: original.replace(de, () => a) });
      const primero = dichos.find(d => d.clase === 'error');
      if (donde < 0 || sale || primero?.ruta !== GRUA || primero.linea !== debe || !primero.mensaje.includes(dice))
        mal.push(`${que}: línea ${debe}: ${JSON.stringify(primero)} ${sale}`);
    }
    assert.deepEqual(mal, []);
  },
};

enNavegadores(['chromium'], { ...uso, ...Object.fromEntries(programas) });
