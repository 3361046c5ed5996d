// taller.mjs RAÍZ BUILD PÁGINA: compilar en la página. Cada programa, sin cambiar, da sus golden; y cada error de los
// que comete quien empieza (errores.tsv) queda en su línea.
import assert from 'node:assert/strict';
import { delCapitulo, distintos } from './casos.mjs';
import { CAPITULOS, conServidor, enNavegadores, lee } from './navegador.mjs';

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

/// En el editor de la grúa, eso en lugar de aquello; y lo compila.
async function cambia(p, de, a) {
  await p.reescribe(GRUA, texto => texto.replace(de, () => a));
  await p.da(() => pagina.compilacion.hazlo());
}

// Lo que se hace mal al pulsar una tecla, y en qué línea de lo añadido se nota.
const MAL = {
  'un bucle sin fin': ['while (tecla)\n        estado.postura.giro += 1;', 0],
  'un bucle sin fin y sin nada': ['while (tecla) {\n    }', 0],
  'una recursión sin fondo': ['struct F { static int f(int n) { return n < 0 ? 0 : 1 + f(n + 1) * 2; } };\n' +
    '    ponTitulo(formatea("%d", F::f(tecla)));', 0],
  'un índice que se sale de un vector': ['std::vector<int> v(3);\n    ponTitulo(formatea("%d", v[tecla]));', 1],
  'un índice que se sale de un array': ['int v[3] = {1, 2, 3};\n    ponTitulo(formatea("%d", v[tecla]));', 1],
  'una llamada de OpenGL que no vale': ['glEnable(GLenum(tecla));', 0],
  'la memoria que se acaba': ['std::vector<double> v;\n    while (tecla)\n        v.push_back(1);', 2],
};
const SITIO = 'if (teclaComun(tecla)';

const uso = {
  'se compila con Ctrl+Intro, sigue donde estaba, y nada se pide antes': async p => {
    const pedidos = [];
    p.pagina.on('request', pedido => pedidos.push(pedido.url()));
    await p.abre('#grua');
    await p.da(() => { for (const tecla of 'ddw') escena.manda('tecla ' + tecla); });
    const antes = await p.imagen();
    await p.reescribe(GRUA, texto => texto.replace('ponFondo(CIELO)', 'ponFondo(glm::vec3(1, 0, 0))'));
    assert.deepEqual(pedidos.filter(url => /datos.(taller|comun|llvm)/.test(url)), [], 'antes no se trae nada');
    await p.da(() => cm.focus());
    await p.pagina.keyboard.down('Control');
    await p.teclas('Enter');
    await p.pagina.keyboard.up('Control');
    await p.acaba('compila', () => una('.compila-estado').textContent === 'Compilado.');
    assert.notDeepEqual(await p.imagen(), antes);
    await p.exige('lo hecho se ha repetido', () => hecho.ordenes.join() === 'tecla d,tecla d,tecla w' && sesion.vivo);
    await p.talla(390, 700);
    const mala = linea(lee(GRUA).split('ponFondo')[0]) - 1;
    await cambia(p, 'ponFondo(glm::vec3(1, 0, 0));', 'ponFondo(rojo);');
    await p.exige('un error queda en su línea, en el margen y en la lista, y sigue el de antes', donde => {
      const { bgClass, gutterMarkers } = cm.lineInfo(donde);
      return sesion.vivo && bgClass === 'linea-mala' && gutterMarkers.dichos && una('ul.dichos button.mensaje-malo');
    }, mala);
    await p.acaba('y se va allí, con lo dicho a la vista', donde => cm.hasFocus() && cm.getCursor().line === donde &&
      una('.CodeMirror-linewidget').getBoundingClientRect().bottom < innerHeight, mala);
    await p.esParaTodos();
    for (const enlace of ['#camara', '#grua;tecla d ×2;tecla w']) {
      await p.va(enlace);
      await p.acaba(enlace, de => de.startsWith(`#${visto.programa.nombre}`) && sesion?.vivo && editor.ruta, enlace);
      await p.exige('lo dicho era de lo dejado', () => !una('.mensaje-malo, .linea-mala, .fichero-estado.mal'));
    }
    await cambia(p, 'ponFondo(rojo)', 'ponFondo(CIELO)');
    assert.deepEqual(await p.imagen(), antes, 'y como estaba');
  },

  'lo que hace mal un programa se dice en su línea, y la página sigue': async p => {
    const mal = [], debe = linea(lee(GRUA).split(SITIO)[0]);
    await p.abre('#grua');
    for (const [que, [hace, salto]] of Object.entries(MAL)) {
      await p.reescribe(GRUA, () => lee(GRUA).replace(SITIO, () => `${hace}\n    ${SITIO}`));
      const desde = await p.da(async () => {
        await pagina.compilacion.hazlo();
        const desde = performance.now();
        escena.manda('tecla d');
        return performance.now() - desde;
      });
      await p.acaba(`${que}: se dice`, () => pagina.compilacion.dichos.some(d => d.mensaje.startsWith('Aquí')));
      const [{ ruta, linea: en }] = await p.da(() => pagina.compilacion.dichos);
      if (ruta !== GRUA || en !== debe + salto || desde > 5000)
        mal.push(`${que}: ${ruta}:${en}, y no ${debe + salto}; en ${desde} ms`);
    }
    assert.deepEqual(mal, []);
  },

  'lo que se trae se guarda, y mientras sea de la misma versión no se pide': p => conServidor(async puesto => {
    const pedidos = [];
    await p.pagina.setCacheEnabled(false); // la del navegador, que tampoco lo pediría
    for (const version of 'aababb') {
      puesto.pagina = html => html.replace(/(id="taller">.*?"version": ?")[^"]*/s, `$1${version}`);
      puesto.descargado.length = 0;
      await p.carga('#grua', `${puesto.raiz}/index.html`);
      await p.acaba('arranca', () => sesion?.vivo);
      await p.da(() => pagina.compilacion.compilador.prepara(() => {}, new AbortController().signal));
      pedidos.push(puesto.descargado.some(url => /datos.(taller|llvm)/.test(url)));
    }
    assert.deepEqual(pedidos, [true, false, true, true, true, false]);
  }),

  'cada error queda en su línea, y en español': async p => {
    const original = lee(GRUA), mal = [];
    await p.carga();
    const filas = lee('tests/paginas/errores.tsv').trimEnd().split('\n')
      .map(fila => fila.replaceAll('\\n', '\n').split('\t'));
    for (const [que, de, a, dice, salto = '0'] of filas) {
      const donde = original.indexOf(de), debe = linea(original.slice(0, donde)) + Number(salto);
      const [sale, dichos] = await p.da(compila, 'grua', { [GRUA]: original.replace(de, () => a) });
      const primero = dichos.find(d => d.clase === 'error');
      const enIngles = primero?.mensaje.match(/.\((.*)\)$/)?.[1]; // tras lo que es, en español
      if (donde < 0 || sale || primero?.ruta !== GRUA || primero.linea !== debe || !enIngles?.includes(dice))
        mal.push(`${que}: línea ${debe}: ${JSON.stringify(primero)} ${sale}`);
    }
    const orbita = 'common/orbita.h', otra = lee(orbita).replace('elevacionMinima', 'elevacionPrimera');
    const [, dichos] = await p.da(compila, 'sombreado', { [orbita]: otra });
    assert.ok(dichos.some(d => d.ruta === 'common/orbita.cpp'), 'con una cabecera, se compila lo que la incluye');
    assert.deepEqual(mal, []);
  },
};

enNavegadores(['chromium'], { ...uso, ...Object.fromEntries(programas) });
