// clase.mjs RAÍZ BUILD CARPETA: la página de una clase corregida, en claro y en oscuro. La tabla se ordena por nombre y
// por nota, y otra vez al revés; nada se sale de un teléfono, tampoco de la
// página de cada una ni de la de las que se parecen, y lo pueden usar todos. En la de proyectar, cada error cabe en una
// pantalla, se lee desde la última fila y no dice de quién es.
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';
import { ABRE, dePython, enNavegadores } from './navegador.mjs';

const NOTAS = { 'Álvarez, Íñigo': 9.5, Zoé: 100, ana: 72.7, Núñez: 8.75, Nadal: 100, '<b>Ñíguez</b>': 0 };
const POR_NOMBRE = ['<b>Ñíguez</b>', 'Álvarez, Íñigo', 'ana', 'Nadal', 'Núñez', 'Zoé'];
const POR_NOTA = Object.values(NOTAS).sort((a, b) => a - b).map(String);

/// La de esas notas, con dos que se parecen.
dePython(`import json, sys
from pathlib import Path
from types import SimpleNamespace
from base import catalogo
from ejercicios.corrige import conjunto
build, carpeta, notas = sys.argv[2:]
PUNTO = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
COPIADO = "int main() {\\n" + "".join(f"  pinta({i}, {i} + 1, {'x' * i});\\n" for i in range(40)) + "}\\n"
def correccion(nombre, nota):
    fallo = {"que": "falla tras «tecla d»", "tras": ["tecla d"], "donde": None, "imagenes": [PUNTO] * 3}
    return {"entrega": nombre, "nota": nota, "bien": 2, "guiones": 5, "semilla": "1", "reglas": "las de siempre",
            "dice": ["se ve lo mismo que en el punto de partida" if nota < 9 else "y algo más"] if nota < 100 else [],
            "fallos": [fallo] if nota < 100 else [], "casos": {}}
notas = {Path(nombre): correccion(nombre, nota) for nombre, nota in json.loads(notas).items()}
grua = next(p for p in catalogo.lee_programas(Path(build)) if p.nombre == "grua")
leidas = {quien: {"grua.cpp": COPIADO} for quien in list(notas)[:2]}
conjunto.escribe(Path(carpeta), notas, SimpleNamespace(programa=grua, ref="E3.5", dados=()), leidas)
print("{}")`, ABRE, JSON.stringify(NOTAS));

enNavegadores(['chromium', 'firefox'], {
  'se ordena por nombre y por nota, y cada enlace lleva a la suya': async p => {
    await p.carga();
    await p.teclas('Tab');
    await p.exige('se llega con el tabulador', () => document.activeElement.matches('a, button'));
    for (const [columna, orden] of [POR_NOMBRE, POR_NOTA].entries()) {
      for (const [sentido, debe] of
          [['ascending', orden], ['descending', [...orden].reverse()], ['ascending', orden]]) {
        await p.da(columna => todos('th button')[columna].click(), columna);
        const [celdas, flechas] = await p.da(columna => [
          todos('tbody tr').map(f => columna ? String(parseFloat(f.cells[1].textContent)) : f.cells[0].textContent),
          todos('th').map(th => th.ariaSort ?? th.getAttribute('aria-sort'))], columna);
        assert.deepEqual(celdas, debe, sentido);
        assert.deepEqual(flechas, [0, 1, 2].map(i => i === columna ? sentido : null));
      }
    }
  },

  'cada error se proyecta en una pantalla, sin nombres': async p => {
    const talla = [1920, 1080];
    await p.carga('', pathToFileURL(`${ABRE}/proyectar.html`).href);
    const dice = await p.da(() => una('main').textContent);
    assert.deepEqual(Object.keys(NOTAS).filter(quien => dice.includes(quien)), []);
    await p.pantalla(...talla);
    await p.teclas('p');
    await p.acaba('proyecta', () => document.fullscreenElement && una('dialog').open && una('dialog img').complete);
    for (const [tecla, titulo] of [['', 'Se ve lo mismo que en el punto de partida'], ['ArrowRight', 'Y algo más']]) {
      if (tecla) await p.teclas(tecla);
      assert.equal(await p.da(() => una('dialog .dicho').textContent.trim()), titulo);
      assert.equal(await p.da(() => una('dialog h2').textContent), '2 de 6');
      await p.seProyecta('dialog', talla, 'dos');
    }
    await p.teclas('Home');
    assert.equal(await p.da(() => location.hash), '#e1');
  },
});

const temas = ['light', 'dark'].map(value => [`para todos, y nada se sale, en ${value}`, async p => {
  await p.pagina.emulateMediaFeatures([{ name: 'prefers-color-scheme', value }]);
  for (const pagina of ['index.html', 'proyectar.html', 'comentarios/ana.html', 'parecidos.html']) {
    await p.talla(1280, 900);
    await p.carga('', pathToFileURL(`${ABRE}/${pagina}`).href);
    await p.esParaTodos();
    await p.talla(360, 740);
    await p.nadaSeSale(pagina);
  }
}]);
enNavegadores(['chromium'], Object.fromEntries(temas));
