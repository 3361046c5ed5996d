// De cada manera de llegar a toda la pantalla, el lienzo ocupa lo que debe y se ve entero; dentro de otra página, los
// programas son solo su imagen.
import assert from 'node:assert/strict';
import { conServidor, PROGRAMAS } from './navegador.mjs';

async function arranca(p, enlace) {
  await p.carga(enlace);
  await p.acaba('arranca', () => sesion?.vivo);
}

// Cada manera: el enlace, lo que se pulsa, y si el lienzo llena la pantalla o cabe en ella.
const MANERAS = {
  'con el botón Pantalla completa': ['#espejo', p => p.pulsa('.completa'), 'llena'],
  'con F11': ['#espejo', async p => { await p.da(() => una('canvas').focus()); await p.teclas('F11'); }, 'llena'],
  'con el botón Proyectar': ['#espejo', p => p.pulsa('.proyecta'), 'cabe'],
  'con la tecla p, con muchos mandos': ['#efectos', p => p.teclas('p'), 'cabe'],
  'con la tecla p, en un ejercicio': ['#ejercicio/L5.1', p => p.teclas('p'), 'cabe'],
  'incrustado': ['#incrusta/espejo', undefined, 'llena'],
};
const aTodaPantalla = Object.entries(MANERAS).map(([manera, [enlace, pulsa, como]]) =>
  [`a toda pantalla, ${manera}`, async p => {
    for (const talla of [[1920, 1080], [1024, 768]]) {
      await p.pantalla(...talla);
      await arranca(p, enlace);
      await pulsa?.(p);
      if (pulsa) await p.acaba('llega', () => document.fullscreenElement);
      await p.seProyecta(pulsa ? ':fullscreen' : '.escena', talla, como);
      await p.acaba('y se dibuja de esa talla', () => {
        const { width, height } = una('canvas').getBoundingClientRect();
        return sesion.lienzo.width === Math.round(width) && sesion.lienzo.height === Math.round(height);
      });
      if (!pulsa) continue;
      await p.da(() => document.exitFullscreen());
      await p.acaba('y se sale', () => una('canvas').getBoundingClientRect().width < innerWidth);
    }
  }]);

const proyectando = {
  'proyectando, AvPág pasa al caso siguiente y, tras el último, al programa siguiente': async p => {
    await arranca(p, '#grua;tecla d');
    await p.teclas('p');
    await p.acaba('p proyecta', () => document.fullscreenElement === una('.escena'));
    await p.teclas('b', 'PageDown');
    await p.acaba('al primer caso, y se ve', () => sesion?.vivo && visto.caso === visto.programa.casos[0] &&
      !hecho.ordenes.length && !una('.negro'));
    for (const caso of (await p.da(() => visto.programa.casos.map(c => c.fichero))).slice(1)) {
      await p.teclas('ArrowRight'); // que la grúa no usa
      await p.acaba(caso, caso => sesion?.vivo && visto.caso.fichero === caso, caso);
    }
    await p.teclas('ArrowRight');
    const vecino = PROGRAMAS[PROGRAMAS.findIndex(q => q.nombre === 'grua') + 1].nombre;
    await p.acaba(vecino, vecino => sesion?.vivo && visto.programa.nombre === vecino && document.fullscreenElement,
      vecino);
    await p.va('#tetera-malla');
    await p.acaba('se dice qué caso es', () => una('h2.proyectado').textContent === 'La tetera de Utah: La malla');
  },

  'proyectando, Inicio y Fin van por el capítulo': async p => {
    const suyos = PROGRAMAS.filter(q => q.capitulo === 'ch08_texturas_avanzadas').map(q => q.nombre);
    await arranca(p, '#bump');
    await p.pulsa('.proyecta');
    await p.acaba('proyecta', () => document.fullscreenElement);
    for (const [tecla, cual] of [['End', suyos.at(-1)], ['End', suyos.at(-1)], ['Home', suyos[0]]]) {
      await p.teclas(tecla);
      await p.acaba(cual, cual => visto.programa.nombre === cual && sesion?.vivo, cual);
    }
  },
};

// --- en otra página ---

const OTRA = '<!DOCTYPE html><title>Otra</title><link rel=icon href=data:,><body style="height: 4000px">' +
  '<input id=suyo>%<script>teclas = []; addEventListener("keydown", s => teclas.push(s.key))</script>';

const incrustado = {
  'tres programas dentro de otra página, con la línea que da el botón': p => conServidor(async puesto => {
    const lineas = [], url = `${puesto.raiz}/index.html`;
    for (const enlace of ['#grua;tecla d ×7', '#luces_animadas', '#espejo_plantilla;tecla p']) {
      await p.carga(enlace, url);
      await p.acaba(enlace, () => sesion?.vivo);
      lineas.push(await p.da(async () => {
        let copiado;
        const value = { writeText: async texto => { copiado = texto; } };
        Object.defineProperty(navigator, 'clipboard', { configurable: true, value });
        una('.incrusta').click();
        await cuadro();
        return copiado;
      }));
    }
    puesto.otra = OTRA.replace('%', () => lineas.join(''));
    puesto.descargado.length = 0;
    await p.talla(1280, 2400); // los que no se ven no se cargan
    await p.carga('', `${puesto.raiz}/otra.html`);
    await p.acaba('arrancan', () => frames.length === 3 &&
      [0, 1, 2].every(i => frames[i].pagina?.escena.sesion?.vivo));
    const datos = puesto.descargado.filter(url => url.includes('/datos/'));
    assert.equal(new Set(datos).size, datos.length, `lo que comparten se descarga una vez: ${datos.sort()}`);
    assert.deepEqual(await p.da(() => [0, 1, 2].map(i =>
      frames[i].pagina.escena.hecho.ordenes.filter(o => o.startsWith('tecla')).length)), [7, 0, 1]);
    await p.exige('sin quitar el foco a la página', () => document.activeElement === document.body && scrollY === 0);
    await p.exige('cada uno es solo su imagen, en todo su sitio', () => [0, 1, 2].every(i => {
      const { document: suyo, innerWidth: ancho, innerHeight: alto } = frames[i];
      const r = suyo.querySelector('canvas').getBoundingClientRect();
      return r.width === ancho && r.height === alto && todos('*', suyo.body).filter(e =>
        e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().width)
        .every(e => e.closest('.lienzo'));
    }));
    const rueda = () => p.da(() => !frames[0].document.querySelector('canvas')
      .dispatchEvent(new frames[0].WheelEvent('wheel', { deltaY: 99, bubbles: true, cancelable: true })));
    assert.equal(await rueda(), false, 'sin haber entrado en él, mueve la página de fuera');
    await p.da(() => { frames[0].focus(); frames[0].document.querySelector('canvas').focus(); });
    assert.equal(await rueda(), true, 'y habiendo entrado, es suya');
    for (const donde of ['canvas', 'body']) {
      await p.da(donde => {
        frames[0].document.activeElement.blur();
        frames[0].document.querySelector(donde).focus();
      }, donde);
      await p.teclas('d', ' ', 'p', 'x', '/');
    }
    await p.exige('sus teclas no salen de él', () => !teclas.length && scrollY === 0 && !document.fullscreenElement);
    const ordenes = await p.da(() => frames[0].pagina.escena.hecho.ordenes);
    assert.ok(ordenes.filter(o => o === 'tecla d').length === 9 && ordenes.includes('tecla x'), ordenes.join());
    await p.da(() => {
      globalThis.avisos = [];
      addEventListener('message', ({ data }) => avisos.push(data));
    });
    for (const tecla of ['PageDown', 'ArrowLeft', 'Escape']) {
      await p.da(() => { frames[0].focus(); frames[0].document.querySelector('canvas').focus(); });
      await p.teclas(tecla);
      await p.exige(`${tecla} es de la página de fuera`, () => document.hasFocus() && !frames[0].document.hasFocus());
    }
    await p.exige('que sabe qué se le pide, y el programa sigue', () =>
      avisos.join() === '{"method":"next"},{"method":"left"}' && frames[0].pagina.escena.sesion.vivo);
    await p.da(() => suyo.focus());
    await p.teclas('d');
    await p.exige('y las de fuera son de fuera', () => teclas.join() === 'd' && suyo.value === 'd');
  }),

};

// --- la página ---

/// De qué enlaces no se ven a la vez, al abrirlos, la imagen y diez líneas del editor.
async function apretados(p, enlaces) {
  const mal = [];
  await p.carga();
  for (const enlace of enlaces) {
    await p.va(enlace);
    await p.acaba(`${enlace} se abre`, enlace => location.hash === enlace && sesion?.vivo && editor.abierto &&
      editor.ruta === editor.abierto, enlace);
    for (const ancho of [1024, 1366]) {
      await p.talla(ancho, 768);
      const caben = await p.da(() => {
        const { top, bottom } = una('.editor').getBoundingClientRect();
        return una('.lienzo').getBoundingClientRect().bottom < innerHeight &&
          Math.min(bottom, innerHeight) - top > 10 * cm.defaultTextHeight();
      });
      if (!caben) mal.push(`${enlace}, a ${ancho}`);
    }
  }
  return mal;
}

const paginaAbierta = {
  'en un portátil se ven a la vez la imagen y el editor': async p => {
    await p.carga();
    const enlaces = await p.da(() => JSON.parse(una('#programas').textContent).filter(q => !q.consola)
      .flatMap(q => [q.nombre, ...q.ejercicios.map(e => `ejercicio/${e.codigo}`)]));
    assert.deepEqual(await apretados(p, enlaces.filter((_, i) => i % 4 === 0).map(e => `#${e}`)), []);
  },

  'sin WebGL 2 se ve la imagen, se dice qué probar y no queda ningún mando': async p => {
    await p.carga();
    await p.da(() => {
      const da = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (que, ...mas) {
        return que === 'webgl2' ? null : da.call(this, que, ...mas);
      };
      for (const a of todos('.tarjetas a')) a.innerHTML = `<img src="data:,${a.hash}">`; // la de la galería
    });
    for (const [enlace, programa] of [['#grua', 'grua'], ['#ejercicio/E4.2', 'grua_vistas']]) {
      await p.va(enlace);
      await p.acaba('se ve y se dice', programa => /WebGL 2.*prueba/.test(telon.innerText) && editor.ruta &&
        todos('.mesa img').map(i => i.src).join() === `data:,#${programa}` && una('.mesa img').checkVisibility(),
        programa);
      assert.deepEqual(await p.da(() => todos(':is(.escena, .tarea) button').filter(b => b.checkVisibility())
        .map(b => b.textContent)), enlace === '#grua' ? [] : ['Ver la solución', 'Descarga mi carpeta']);
    }
  },
};

export const pantalla = { ...Object.fromEntries(aTodaPantalla), ...proyectando, ...incrustado, ...paginaAbierta };
