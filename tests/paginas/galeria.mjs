// galeria.mjs RAÍZ BUILD GALERÍA: la galería, con file://. Las imágenes cargan y las animadas se mueven; la vista
// grande pasa con las teclas y nunca enseña una imagen agrandada; cada dirección lleva a lo suyo; en papel, un capítulo
// es eso y nada más; nada se sale de un teléfono, y la pueden usar todos.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { seBusca, seCopia, sonDelNavegador } from './comun.mjs';
import { ABRE, CAPITULOS, CASOS, enNavegadores, espera, lee, PROGRAMAS } from './navegador.mjs';

const capituloDe = caso => PROGRAMAS.find(p => p.nombre === caso.programa).capitulo;
const ANIMADOS = CASOS.filter(c => c.anima).map(c => c.fichero);
const REFERENCIAS = new Set(PROGRAMAS.flatMap(p => p.ref.split(' ').filter(Boolean)));
const DIRECCIONES = [...CAPITULOS, ...PROGRAMAS].map(e => e.nombre)
  .concat(...REFERENCIAS, CASOS.map(c => c.fichero));
const aMano = (d, i) => /^ch\d/.test(d) ? ['', 'cap', 'ch'][i % 3] + +d.slice(2, 4) : i % 9 ? d : d.toLowerCase();
const primeroCon = referencia => PROGRAMAS.find(p => p.ref.split(' ').includes(referencia))?.nombre;

/// La imagen de ese caso, en grande.
const amplia = (p, id) => p.da(id => {
  const figura = document.getElementById(id);
  (una(':scope > a', figura) ?? una('figure a', figura)).click();
}, id);
const cual = p => p.da(() => location.hash.slice(1));

async function seMueve(p) {
  const foto = () => p.pagina.screenshot({ encoding: 'base64' }), primera = await foto();
  for (let i = 0; i < 6; ++i) {
    await espera(150);
    if (await foto() !== primera) return true;
  }
  return false;
}

const enLosDos = {
  'las imágenes cargan': async p => {
    await p.carga();
    await p.da(() => { for (const i of document.images) i.loading = 'eager'; });
    await p.acaba('todas', () => todos('figure img').every(i => i.complete));
    const anchos = await p.da(() => todos('figure:not(.captura) img').map(i => i.naturalWidth));
    const deConsola = CASOS.filter(c => PROGRAMAS.find(q => q.nombre === c.programa).consola);
    assert.equal(anchos.length, CASOS.length - deConsola.length);
    assert.equal(anchos.filter(a => a === 480).length, ANIMADOS.length, 'las animadas');
    assert.ok(anchos.every(a => [480, 720].includes(a)));
  },

  'de cada caso se dice qué es, qué mirar en él, el título de su ventana y lo que escribe': async p => {
    const hecho = JSON.parse(readFileSync(`${ABRE}/.hecho.json`));
    await p.carga();
    const dice = await p.da(ficheros => ficheros.map(f => document.getElementById(f)).map(e =>
      (e.matches('figure') ? e : una('figure', e)).textContent), CASOS.map(c => c.fichero));
    assert.deepEqual(CASOS.flatMap(({ fichero, titulo, mira, ...caso }, i) =>
      [titulo, mira, ...['ventana', 'salida'].map(que => hecho[`${capituloDe(caso)}/${fichero}.png`][que])]
        .filter(que => !dice[i].includes(que ?? '')).map(que => `${fichero}: ${que}`)), []);
  },

  'una imagen pulsada se ve en grande; las teclas, y con Esc o «Atrás» se cierra': async p => {
    await p.carga();
    await amplia(p, 'tetera-malla');
    const suyas = CASOS.filter(c => capituloDe(c) === 'ch02_modelado').map(c => c.fichero);
    const [antes, despues] = [-1, 1].map(paso => suyas[suyas.indexOf('tetera-malla') + paso]);
    for (const [tecla, debe] of [['ArrowRight', despues], ['ArrowLeft', 'tetera-malla'], ['PageUp', antes],
      ['PageDown', 'tetera-malla'], ['Home', suyas[0]], ['Home', suyas[0]], ['End', suyas.at(-1)],
      ['End', suyas.at(-1)]]) {
      await p.teclas(tecla);
      assert.equal(await cual(p), debe, tecla);
    }
    const oculta = () => p.da(() => getComputedStyle(una('.cuadro', dialogo)).visibility === 'hidden');
    for (const tecla of ['b', '.']) {
      for (const debe of [true, false, true]) {
        await p.teclas(tecla);
        assert.equal(await oculta(), debe, tecla);
      }
      await p.teclas('ArrowLeft');
      assert.equal(await oculta(), false, 'pasar a otra la enseña');
    }
    for (const debe of [true, false]) {
      await p.teclas('?');
      assert.equal(await p.da(() => Boolean(una('.teclas', dialogo).offsetParent)), debe, 'la ayuda');
    }
    const estaba = await cual(p);
    for (const [boton, tecla] of [['.anterior', ' '], ['.siguiente', 'Enter']]) { // el foco en él: lo pulsan
      await p.da(boton => una(boton, dialogo).focus(), boton);
      await p.teclas(tecla);
      assert.equal(await cual(p) === estaba, boton === '.siguiente', boton);
    }
    await p.teclas('Escape');
    await p.exige('Esc la cierra', () => !dialogo.open);
    await amplia(p, 'grua-girada');
    assert.equal(await cual(p), 'grua-girada');
    await p.teclas('ArrowLeft'); // las que se pasan no son otros sitios a los que volver
    await p.da(() => history.back());
    await p.acaba('con «Atrás» se cierra', () => !dialogo.open);
    assert.equal(await cual(p), estaba, 'donde se estaba');
  },

  'las animadas se mueven, y Espacio las para y las sigue': async p => {
    await p.carga();
    await amplia(p, ANIMADOS[0]);
    await p.acaba('los cuadros', () => una('dialog canvas')?.width === 1280);
    await p.acaba('caben enteros sobre su pie', () => {
      const caja = selector => una(selector).getBoundingClientRect();
      return caja('.cuadro > *').bottom <= caja('.pie').top + 1 && caja('.pie').bottom <= innerHeight + 1;
    });
    for (const anda of [true, false, true]) {
      assert.equal(await seMueve(p), anda);
      await p.teclas(' ');
    }
  },

  'ninguna se enseña mayor de lo que se dibujó, ni menor de lo que cabe, ni recortada': async p => {
    await p.carga();
    for (const [ancho, alto, densidad] of [[1920, 1080, 1], [2560, 1600, 1], [1440, 900, 2], [360, 740, 3]]) {
      await p.talla(ancho, alto, densidad);
      for (const id of [ANIMADOS[0], 'grua', 'tetera-malla', 'menu-captura']) {
        await amplia(p, id);
        await p.acaba(`${id} a ${ancho}×${alto}, ×${densidad}`, () => {
          const e = una('.cuadro > *'), dibujada = e.naturalWidth ?? (e.width === 300 ? 0 : e.width); // la de un lienzo
          const r = e.getBoundingClientRect(), marco = una('.cuadro').getBoundingClientRect();
          const vista = Math.min(r.width, r.height * 4 / 3) * devicePixelRatio;
          const llena = Math.abs(r.width - marco.width) < 2 || Math.abs(r.height - marco.height) < 2;
          return dibujada && vista <= dibujada + 1 && r.width <= marco.width + 1 && r.height <= marco.height + 1 &&
            (llena || vista > dibujada - 2) && getComputedStyle(e).objectFit === 'contain';
        });
        await p.da(() => dialogo.close());
      }
    }
  },

  'p proyecta lo que se está viendo, y AvPág, la de los mandos de presentación, pasa a la siguiente': async p => {
    const titulo = () => p.da(() => una('h2', dialogo).textContent);
    await p.carga();
    for (const talla of [[1024, 768], [1920, 1080]]) {
      await p.pantalla(...talla);
      await p.da(() => una('#grua').scrollIntoView());
      await p.teclas('p');
      await p.acaba('proyecta', () => document.fullscreenElement && dialogo.open && una('dialog img').complete);
      assert.match(await titulo(), /^Grúa de obra/);
      await p.seProyecta('dialog', talla);
      if (talla[0] < 1920) await p.teclas('p', 'Escape');
    }
    await p.exige('con sus controles', () => /giran/.test(una('.mandos', dialogo).textContent));
    await p.teclas('PageDown');
    assert.match(await titulo(), /^Grúa de obra: Girada/);
    await p.teclas('p');
    await p.acaba('y p deja la pantalla completa', () => !document.fullscreenElement);
  },

  'cada dirección lleva a lo suyo, y el índice lo señala': async p => {
    await p.carga();
    const entradas = () => p.da(() => history.length), antes = await entradas();
    await p.va('#5');
    await p.acaba('se corrige', () => location.hash === '#ch05_iluminacion');
    assert.equal(await entradas(), antes + 1, 'y «Atrás» no vuelve a ella');
    for (const [ancho, cada] of [[1440, 2], [360, 9]]) { // una mitad en cada navegador
      const pedidas = DIRECCIONES.filter((_, i) => i % cada === (p.cual === 'firefox' ? 1 : 0));
      await p.talla(ancho, 800);
      assert.deepEqual(await p.da(async pedidas => {
        const mal = [];
        for (const [pedida, escrita, quien] of pedidas) {
          location.hash = '#' + escrita;
          const e = document.getElementById(pedida), suyo = e?.closest('article, .capitulo').id;
          const primero = e?.matches('.capitulo') && una('article', e).id; // su título puede quedar por encima
          let bien = false, r, senalado;
          for (let cuadros = 0; !bien && cuadros < 20; ++cuadros) { // con la máquina ocupada, lo señala más tarde
            await cuadro();
            r = e?.getBoundingClientRect();
            const final = scrollY + innerHeight > document.body.scrollHeight - 2;
            senalado = todos('.programas [aria-current]').map(a => a.hash.slice(1)).join();
            const hay = e && document.elementFromPoint(r.x + Math.min(9, r.width / 2), r.y + Math.min(9, r.height / 2));
            const seVe = e?.closest('article, .capitulo').contains(hay); // lo que hay ahí es suyo, y no la barra
            bien = seVe && (final || (r.top > -2 && r.top < innerHeight * 0.15)) && una('#no-esta').hidden &&
              [quien ?? suyo, primero].includes(senalado) && decodeURIComponent(location.hash) === '#' + pedida;
          }
          if (!bien) mal.push([escrita, r?.top, senalado]);
        }
        return mal;
      }, pedidas.map((d, i) => [d, aMano(d, i), primeroCon(d)])), [], ancho);
    }
    for (const nada of ['no_esta', 'L99.1', '%', 'a'.repeat(1000)]) {
      await p.va('#' + nada);
      await p.acaba(`#${nada.slice(0, 9)} no está`, nada => una('#no-esta').offsetParent &&
        una('#no-esta').textContent.includes(nada.slice(0, 60)), nada);
    }
  },

  'se busca y se copia, y las teclas con Ctrl, Alt o Meta son del navegador': async p => {
    await p.carga();
    await seBusca(p);
    await seCopia(p);
    await sonDelNavegador(p);
  },

  'lo del libro y los fuentes': async p => {
    const texto = selector => p.da(selector => una(selector).textContent, selector);
    await p.carga();
    assert.match(await texto('#grua .enunciado'), /cubos de lado uno/);
    assert.match(await texto('#grua .respuesta'), /Cinco cubos/);
    assert.equal((await texto('#shader_basico .erratas')).split('Listado 1.3').length, 4, 'las del listado 1.3');
    assert.equal(await p.da(() => una('#grua abbr').title), 'ejercicio 3.5: la grúa de obra');
    await p.da(() => { una('#grua .fuentes').open = true; });
    await p.acaba('el fuente se ve', () => /glutMainLoop/.test(una('#grua pre').textContent));
    const fuentes = await p.da(() => { // el que ya se ve, el último
      const botones = todos('#grua .pestanas button');
      return [...botones, botones[0]].map(b => b.click() ?? b.dataset.fuente);
    });
    await p.acaba('y de los pulsados seguidos, el último', texto => una('#grua pre').textContent === texto,
      lee(fuentes.at(-1)));
  },

  'el dedo pasa a un lado y a otro': async p => {
    await p.carga();
    await p.da(() => todos('figure a')[1].click());
    const vistos = await p.da(() => [20, -20, -100, -100, 100, 100].map(hacia => {
      for (const [que, x] of [['touchstart', 300], ['touchend', 300 + hacia]]) {
        const dedo = [{ clientX: x }];
        dialogo.dispatchEvent(Object.assign(new Event(que), { touches: dedo, changedTouches: dedo }));
      }
      return una('h2', dialogo).textContent;
    }));
    const [a, b, c, d, e, f] = vistos;
    assert.ok(a === b && b === f && c === e && new Set([a, c, d]).size === 3, vistos.join());
  },

  'para todos, y nada se sale, con todo desplegado': async p => {
    await p.carga();
    await p.esParaTodos();
    await p.da(() => { for (const d of todos('details')) d.open = true; });
    for (const ancho of [360, 1920]) {
      await p.talla(ancho, 800);
      await p.nadaSeSale(`a ${ancho}`);
    }
  },
};

// Firefox no deja pedir que se imprima, ni menos movimiento, desde fuera.
const deChromium = {
  'en papel, un capítulo o un programa es eso, sin nada que se pulse': async p => {
    await p.carga();
    const SUYO = { '': '', 'grua-girada': 'grua', 'E3.5': 'grua' };
    for (const elegido of [...CAPITULOS.map(c => c.nombre), 'grua', 'grua-girada', 'E3.5', '']) {
      await p.va('#' + elegido);
      await p.pagina.emulateMediaType('print');
      const seVen = selector => p.da(s => todos(s).filter(e => e.checkVisibility()).map(e => e.id), selector);
      const suyo = SUYO[elegido] ?? elegido;
      assert.deepEqual(await seVen('article'), PROGRAMAS.filter(({ nombre, capitulo }) =>
        ['', nombre, capitulo].includes(suyo)).map(q => q.nombre), elegido);
      assert.equal((await seVen('.capitulo')).length, elegido ? 1 : CAPITULOS.length, elegido);
      assert.deepEqual(await seVen('button, nav, dialog, .fuentes, .respuesta, summary'), [], elegido);
      await p.pagina.emulateMediaType();
    }
  },

  'para quien pide menos movimiento todas están quietas, y en grande, hasta que se pide': async p => {
    await p.pagina.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
    await p.carga();
    await p.da(() => { for (const i of document.images) i.loading = 'eager'; });
    await p.acaba('quietas', () => todos('figure:not(.captura) img').every(i => i.complete && i.naturalWidth === 720));
    await amplia(p, ANIMADOS[0]);
    await p.acaba('los cuadros', () => una('dialog canvas')?.width === 1280);
    for (const anda of [false, true]) {
      assert.equal(await seMueve(p), anda);
      await p.teclas(' ');
    }
  },
};

enNavegadores(['chromium', 'firefox'], enLosDos);
enNavegadores(['chromium'], deChromium);
