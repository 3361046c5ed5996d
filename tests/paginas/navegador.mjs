// Lo que comparten las pruebas de las páginas, que se llaman con RAÍZ BUILD y lo que se abre: los navegadores, una
// página nueva para cada prueba, lo que una persona hace en ella y con qué se mira lo que se ve.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { after, describe, it } from 'node:test';
import { tmpdir } from 'node:os';
import { pathToFileURL } from 'node:url';

export const [RAIZ, BUILD, ABRE] = process.argv.slice(2);
export const CAPITULOS = JSON.parse(readFileSync(`${BUILD}/catalogo.json`));
export const PROGRAMAS = CAPITULOS.flatMap(c => c.programas.map(p => ({ ...p, capitulo: c.nombre })));
export const CASOS = PROGRAMAS.flatMap(p => p.casos.map(c => ({ ...c, programa: p.nombre })));
export const SWIFTSHADER = process.env.LAB_OPENGL === 'swiftshader';
export const lee = (...ruta) => readFileSync([RAIZ, ...ruta].join('/'), 'utf8');
export const espera = ms => new Promise(sigue => setTimeout(sigue, ms));
const deNpm = createRequire(`${BUILD}/paginas/package.json`);
const PACIENCIA = 90000; // ms: con la máquina ocupada, lo que se ve en un segundo tarda mucho más

const GL = SWIFTSHADER ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'] : ['--use-angle=gl'];
const NAVEGADORES = {
  chromium: { executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--use-gl=angle', ...GL,
    '--ignore-gpu-blocklist', '--disable-gpu-watchdog', '--window-size=1280,900',
    '--disable-ipc-flooding-protection'] }, // el freno desoye una dirección si ha habido doscientas en diez segundos
  firefox: { executablePath: '/usr/bin/firefox-esr', browser: 'firefox',
    extraPrefsFirefox: { 'webgl.force-enabled': true, 'gfx.x11-egl.force-enabled': true } },
};

/// Cada prueba de la tabla { nombre: hace(p) }, en cada uno de esos navegadores y en una página sin estrenar, que se
/// tiene que quedar bien.
export function enNavegadores(cuales, pruebas) {
  for (const cual of cuales) {
    describe(cual, () => {
      let navegador;
      after(() => navegador?.close());
      for (const [nombre, hace] of Object.entries(pruebas)) {
        it(`${cual}: ${nombre}`, async () => {
          navegador ??= await deNpm('puppeteer-core').launch({ ...NAVEGADORES[cual], headless: false,
            protocolTimeout: 400000, defaultViewport: { width: 1280, height: 800 } });
          const contexto = await navegador.createBrowserContext();
          try {
            const p = await new Persona(cual).estrena(await contexto.newPage());
            await hace(p);
            await p.quedaBien();
          } finally {
            await contexto.close();
          }
        });
      }
    });
  }
}

/// Los nombres que usan las pruebas dentro de la página.
function nombra() {
  const alias = {
    escena: () => pagina.escena, editor: () => pagina.editor, visto: () => pagina.visto, cm: () => pagina.editor.cm,
    sesion: () => pagina.escena.sesion, hecho: () => pagina.escena.hecho, dialogo: () => una('dialog'),
    telon: () => una('.telon'), consola: () => una('.consola'), marco: () => una('.lienzo'),
    estado: () => una('.fichero-estado'), aviso: () => una('.aviso').textContent,
  };
  for (const [nombre, get] of Object.entries(alias)) Object.defineProperty(globalThis, nombre, { get });
  globalThis.todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
  globalThis.una = (selector, raiz = document) => raiz.querySelector(selector);
  globalThis.conTexto = (selector, texto) => todos(selector).find(e => e.textContent === texto);
  const bajo = e => /auto|scroll/.test(getComputedStyle(e).overflowY) && e.clientHeight < Math.min(60, e.scrollHeight);
  globalThis.malPuesto = () => todos('[hidden]').filter(e => getComputedStyle(e).display !== 'none')
    .map(e => `se ve ${e.outerHTML}`).concat(document.documentElement.scrollWidth > innerWidth ? 'se sale' : [],
      todos('body :not(textarea)').filter(e => bajo(e) && e.checkVisibility()).map(e => `apenas se ve ${e.outerHTML}`));
  globalThis.lienzos = new Set(); // los que tienen OpenGL
  const da = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (que, ...mas) {
    if (que === 'webgl2') lienzos.add(this);
    return da.call(this, que, ...mas);
  };
  globalThis.cuadro = () => new Promise(hecho => requestAnimationFrame(() => setTimeout(hecho, 30)));
}

/// Quien usa una página. El lienzo le mide 240×180, como los golden.
class Persona {
  errores = [];

  constructor(cual) { this.cual = cual; }

  async estrena(pagina) {
    this.pagina = pagina;
    pagina.setDefaultTimeout(PACIENCIA);
    await pagina.evaluateOnNewDocument(nombra);
    pagina.on('request', pedido => { // sin red: solo ficheros, o el servidor de una prueba
      if (!/^(file|data|blob|about):|^http:\/\/127\.0\.0\.1:/.test(pedido.url())) this.errores.push(pedido.url());
    });
    pagina.on('pageerror', error => this.errores.push(String(error)));
    pagina.on('console', dicho => {
      const texto = dicho.text();
      if (dicho.type() === 'error' && !/CONTEXT_LOST_WEBGL|favicon/.test(texto)) this.errores.push(texto);
    });
    return this;
  }

  // --- en la página ---

  da(hace, ...datos) { return this.pagina.evaluate(hace, ...datos); }

  async exige(que, hace, ...datos) {
    assert.ok(await this.da(hace, ...datos), que);
  }

  /// Que acabe cumpliéndose.
  async acaba(que, hace, ...datos) {
    await this.pagina.waitForFunction(hace, { polling: 100 }, ...datos)
      .catch(error => assert.fail(`${que}: ${error.message}; ${hace}`));
  }

  async carga(enlace = '', url = pathToFileURL(`${ABRE}/index.html`).href) {
    await this.pagina.goto('about:blank'); // si solo cambia el enlace no se vuelve a cargar
    await this.pagina.goto(url + enlace);
  }

  /// Un programa, en un lienzo de esa talla y sin muestras, que los golden no tienen.
  async abre(enlace, talla = 'width: 240px; height: 180px') {
    await this.carga();
    await this.da((enlace, talla) => {
      escena.suavizado = false;
      const estilo = document.createElement('style');
      estilo.textContent = `.lienzo { ${talla.replaceAll(';', ' !important;')} !important }`;
      document.head.append(estilo);
      location.hash = enlace;
    }, enlace, talla);
    await this.acaba(`${enlace.slice(0, 99)} arranca`, () => sesion?.vivo);
  }

  va(enlace) { return this.da(enlace => { location.hash = enlace; }, enlace); }

  /// A toda pantalla se tiene esa: sin gestor de ventanas, Firefox no pasa de la suya.
  async pantalla(width, height) {
    await this.talla(width, height);
    if (this.cual === 'firefox')
      await this.pagina.browser().setWindowBounds(await this.pagina.windowId(), { width, height });
  }

  async termina(enlace) {
    await this.abre(enlace);
    await this.da(() => una('canvas').focus());
    await this.teclas('Escape');
    await this.acaba('Esc lo termina, y se dice', () => !telon.hidden && /ha terminado/.test(telon.textContent));
  }

  talla(width, height, deviceScaleFactor = 1) {
    return this.pagina.setViewport({ width, height, deviceScaleFactor });
  }

  // --- teclas y ratón ---

  async teclas(...teclas) {
    for (const tecla of teclas) await this.pagina.keyboard.press(tecla);
  }

  /// Un clic de verdad: hay cosas que el navegador no deja hacer sin él.
  async pulsa(selector, texto) {
    const e = await this.pagina.evaluateHandle((s, t) => t ? conTexto(s, t) : una(s), selector, texto);
    await e.asElement().click();
  }

  /// Un punto del lienzo, en la ventana.
  punto(x, y) {
    return this.da((x, y) => {
      una('canvas').scrollIntoView({ block: 'center' });
      const r = una('canvas').getBoundingClientRect();
      return [Math.round(r.left) + x, Math.round(r.top) + y];
    }, x, y);
  }

  /// Cada dedo va de un punto del lienzo a otro, todos a la vez.
  async dedos(caminos) {
    const dedos = [];
    for (const [primero] of caminos)
      dedos.push(await this.pagina.touchscreen.touchStart(...await this.punto(...primero)));
    for (let i = 1; i < caminos[0].length; ++i)
      for (const [k, dedo] of dedos.entries()) await dedo.move(...await this.punto(...caminos[k][i]));
    for (const dedo of dedos) await dedo.end();
  }

  /// Un fichero, soltado en el lienzo.
  suelta(nombre, bytes) {
    return this.da((nombre, bytes) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(bytes)], nombre));
      marco.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }, nombre, [...bytes]);
  }

  /// Lo que descarga ese botón: su nombre y lo que es, como texto.
  descarga(selector) {
    return this.da(selector => new Promise(hecho => {
      HTMLAnchorElement.prototype.click = function () {
        fetch(this.href).then(r => r.text()).then(texto => hecho([this.download, texto]));
      };
      una(selector).click();
    }), selector);
  }

  /// Como quien teclea al principio de esa línea (desde 1) del editor.
  escribe(linea, texto) {
    return this.da((linea, texto) => {
      cm.scrollIntoView({ line: linea - 1, ch: 0 }); // de las que no se ven no hay nada en la página
      cm.replaceRange(texto, { line: linea - 1, ch: 0 }, undefined, '+input');
    }, linea, texto);
  }

  /// Todo el texto de ese fichero del editor, por el que da `cambia`.
  async reescribe(ruta, cambia) {
    const texto = await this.da(ruta => editor.abre(ruta).then(() => cm.getValue()), ruta);
    await this.da(texto => {
      cm.replaceRange(texto, { line: 0, ch: 0 }, { line: cm.lineCount(), ch: 0 }, '+input');
      return editor.aplicaYa();
    }, cambia(texto));
  }

  // --- lo que se ve ---

  async lee(fichero) {
    return Buffer.from(await this.da(fichero => {
      let t = '';
      for (const b of sesion.lee(fichero)) t += String.fromCharCode(b);
      return btoa(t);
    }, fichero), 'base64');
  }

  async imagen() {
    await this.da(() => { escena.gestos.suelta(); sesion.orden('captura /imagen.ppm'); });
    return this.lee('/imagen.ppm');
  }

  async es(fichero) { comoGolden(CASOS.find(c => c.fichero === fichero), await this.imagen()); }

  /// Sin nada que axe-core tenga por serio.
  async esParaTodos() {
    await this.da(readFileSync(deNpm.resolve('axe-core/axe.min.js'), 'utf8'));
    assert.deepEqual(await this.da(async () => {
      // lo que no cabe en el editor se recorre desde su textarea, que está al lado
      const delEditor = v => v.id === 'scrollable-region-focusable' &&
        v.nodes.every(n => n.target[0].endsWith('.CodeMirror-scroll'));
      const { violations } = await axe.run();
      return violations.filter(v => ['serious', 'critical'].includes(v.impact) && !delEditor(v))
        .map(v => `${v.id} (${v.nodes.length}): ${v.nodes[0].target} ${v.nodes[0].failureSummary}`);
    }), []);
  }

  /// Haya pasado lo que haya pasado: nada en la consola, ningún lienzo de los de antes con la tarjeta, lo escondido no
  /// se ve, nada se sale a lo ancho y lo que se puede pulsar no lo tapa nada.
  async quedaBien() {
    assert.deepEqual(this.errores, [], 'la consola está vacía');
    await this.acaba('los lienzos que ya no están sueltan la tarjeta', () =>
      [...lienzos].every(c => c.isConnected || c.getContext('webgl2').isContextLost()));
    assert.deepEqual(await this.da(() => {
      const pegado = e => e && (getComputedStyle(e).position === 'sticky' || pegado(e.parentElement)); // se corre
      const encima = una('dialog[open]') ?? document.fullscreenElement ?? document, mal = malPuesto();
      for (const e of todos('button, a[href], input, select, summary', encima)) {
        const [r] = e.getClientRects(), hay = r && document.elementFromPoint(r.x + r.width / 2, r.y + r.height / 2);
        if (!hay || !e.checkVisibility({ visibilityProperty: true }) || getComputedStyle(e).opacity === '0') continue;
        if (e.contains(hay) || hay.closest('label')?.control === e || pegado(hay)) continue;
        mal.push(['tapa', hay.outerHTML, e.outerHTML]);
      }
      return mal.map(String).map(s => s.slice(0, 400));
    }), []);
  }

  /// Nada se sale ni se ve lo escondido, ni con el texto al doble, como lo pone quien ve poco; y lo sangrado lo está.
  async nadaSeSale(que = '') {
    for (const [texto, debe] of [['200%', '32px'], ['100%', '16px']]) {
      const [letra, mal, pegado] = await this.da(texto => {
        document.documentElement.style.fontSize = texto;
        const junta = e => /^ {2}/.test(e.firstChild?.data) && !getComputedStyle(e).whiteSpace.startsWith('pre');
        return [getComputedStyle(document.body).fontSize, malPuesto(), todos('*').find(junta)?.textContent];
      }, texto);
      assert.ok(letra === debe && !mal.length && !pegado, `${que}, al ${texto}, de ${letra}, ${mal}, «${pegado}»`);
    }
  }

  /// El lienzo o la imagen de ese elemento, a toda pantalla, la llena o, si no, cabe: nada lo tapa ni se sale de ella,
  /// y en una de 1080 líneas se lee desde la última fila.
  async seProyecta(selector, [width, height], como = 'cabe') {
    const [caja, pantalla, fuera, chicos] = await this.da(async selector => {
      await cuadro();
      const grande = una(`${selector} :is(canvas, img)`);
      const { left, top, width, height } = grande.getBoundingClientRect();
      const forma = (grande.naturalWidth ?? grande.width) / (grande.naturalHeight ?? grande.height);
      const ancho = Math.min(width, height * forma), alto = ancho / forma; // lo que se ve, que no se deforma
      const x = left + (width - ancho) / 2, y = top + (height - alto) / 2, caja = [x, y, x + ancho, y + alto];
      const esquinas = [[x + 2, y + 2], [x + ancho - 2, y + 2], [x + 2, y + alto - 2], [x + ancho - 2, y + alto - 2]]
        .filter(esquina => document.elementFromPoint(...esquina) !== grande);
      const textos = todos(':is(h2, p, output, .mando span)', una(selector))
        .filter(e => e.checkVisibility() && e.textContent.trim());
      const seSalen = textos.filter(e => e.getBoundingClientRect().bottom > innerHeight + 1).map(e => e.textContent);
      return [caja.map(Math.round), [innerWidth, innerHeight], [...esquinas, ...seSalen], textos
        .filter(e => parseFloat(getComputedStyle(e).fontSize) < 28)
        .map(e => `${e.className} ${getComputedStyle(e).fontSize}`)];
    }, selector);
    assert.deepEqual([pantalla, fuera], [[width, height], []], `${caja}`);
    if (como === 'llena') return assert.deepEqual(caja, [0, 0, width, height]);
    const [izquierda, arriba, derecha, abajo] = caja;
    assert.ok(izquierda >= 0 && arriba >= 0 && derecha <= width && abajo <= height &&
      derecha - izquierda > width / (como === 'dos' ? 3 : 2), `va de ${caja} en ${pantalla}`);
    if (height >= 1080) assert.deepEqual(chicos, []);
  }
}

/// Con la carpeta de la página servida, y en /otra.html lo que ponga: { raiz, otra, descargado }; `pagina` la cambia.
export async function conServidor(hace) {
  const tipos = { html: 'text/html', js: 'text/javascript' }, puesto = { otra: '', descargado: [], pagina: t => t };
  const servidor = createServer(({ url }, responde) => {
    puesto.descargado.push(url);
    const cabeceras = { 'Content-Type': `${tipos[url.split('.').pop()]}; charset=utf-8`,
      'Cache-Control': 'max-age=60' }; // lo que un servidor de ficheros suele decir
    const suyo = url === '/otra.html' ? puesto.otra : readFileSync(ABRE + url);
    responde.writeHead(200, cabeceras).end(url === '/index.html' ? puesto.pagina(String(suyo)) : suyo);
  });
  await new Promise(listo => servidor.listen(0, '127.0.0.1', listo));
  puesto.raiz = `http://127.0.0.1:${servidor.address().port}`;
  try {
    await hace(puesto);
  } finally {
    servidor.closeAllConnections();
    servidor.close();
  }
}

/// Que esa imagen es como el golden del caso. `otro`: si es de otro OpenGL.
export function comoGolden(caso, ppm, otro) {
  const { capitulo } = PROGRAMAS.find(p => p.nombre === caso.programa), fallos = `${BUILD}/fallos/web`;
  const obtenida = `${tmpdir()}/${caso.fichero}.ppm`, tolera = otro ? caso.otro : caso.tolerancia;
  mkdirSync(fallos, { recursive: true });
  writeFileSync(obtenida, ppm);
  const c = spawnSync(`${BUILD}/herramientas/comparador/compara`, [
    `${RAIZ}/tests/golden/${capitulo}/${caso.fichero}.ppm`, obtenida, otro ? '--otro' : '--amplia', '--deja',
    `${fallos}/${caso.fichero}`, ...tolera ? ['--tolerancia', tolera] : []], { encoding: 'utf8' });
  rmSync(obtenida);
  assert.equal(c.status, 0, `${caso.fichero}: ${c.stdout}${c.stderr}`);
}

/// Lo que escribe una orden de Python con los módulos de herramientas/, de JSON.
export const dePython = (codigo, ...datos) =>
  JSON.parse(execFileSync('python3', ['-B', '-c', codigo, RAIZ, BUILD, ...datos],
    { env: { ...process.env, PYTHONPATH: `${RAIZ}/herramientas:${RAIZ}/tests/paginas` }, maxBuffer: 1e8 }));
