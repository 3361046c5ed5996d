// Lo que comparten las pruebas de las páginas, que se llaman con RAÍZ BUILD y lo que se abre: los navegadores, una
// página nueva para cada prueba, lo que una persona hace en ella y con qué se mira lo que se ve.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';

export const [RAIZ, BUILD, ABRE] = process.argv.slice(2);
export const { capitulos: CAPITULOS, casos: CASOS, programas: PROGRAMAS } =
  JSON.parse(readFileSync(`${BUILD}/catalogo.json`));
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

/// Cada prueba de la tabla { nombre: hace(p) }, en cada uno de esos navegadores y en una página sin estrenar, que no
/// tiene que escribir ningún error en su consola.
export function enNavegadores(cuales, pruebas) {
  for (const cual of cuales) {
    describe(cual, () => {
      let navegador;
      after(() => navegador?.close());
      for (const [nombre, hace] of Object.entries(pruebas)) {
        it(nombre, async () => {
          navegador ??= await deNpm('puppeteer-core').launch({ ...NAVEGADORES[cual], headless: false,
            protocolTimeout: 400000, defaultViewport: { width: 1280, height: 800 } });
          const contexto = await navegador.createBrowserContext();
          try {
            const p = await new Persona(cual).estrena(await contexto.newPage());
            await hace(p);
            assert.deepEqual(p.errores, [], 'la consola está vacía');
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
    estado: () => una('.fichero-estado'), explicacion: () => una('.explicacion'),
    aviso: () => una('.aviso').textContent,
  };
  for (const [nombre, get] of Object.entries(alias)) Object.defineProperty(globalThis, nombre, { get });
  globalThis.todos = (selector, raiz = document) => [...raiz.querySelectorAll(selector)];
  globalThis.una = (selector, raiz = document) => raiz.querySelector(selector);
  globalThis.conTexto = (selector, texto) => todos(selector).find(e => e.textContent === texto);
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

  async arrastra(puntos, button = 'left') {
    const { mouse } = this.pagina;
    await mouse.move(...await this.punto(...puntos[0]));
    await mouse.down({ button });
    for (const otro of puntos.slice(1)) await mouse.move(...await this.punto(...otro));
    await mouse.up({ button });
  }

  /// Como quien teclea al principio de esa línea (desde 1) del editor.
  escribe(linea, texto) {
    return this.da((linea, texto) => cm.replaceRange(texto, { line: linea - 1, ch: 0 }, undefined, '+input'), linea,
      texto);
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

  /// Nada se sale a lo ancho, ni con el texto del navegador al doble, que es lo que cambia quien ve poco.
  async nadaSeSale(que = '') {
    for (const [texto, debe] of [['200%', '32px'], ['100%', '16px']]) {
      const [letra, sobra] = await this.da(texto => {
        document.documentElement.style.fontSize = texto;
        return [getComputedStyle(document.body).fontSize, document.documentElement.scrollWidth - innerWidth];
      }, texto);
      assert.ok(letra === debe && sobra <= 0, `${que}, con el texto al ${texto}, de ${letra}, se sale ${sobra}`);
    }
  }

  /// Lo que se enseña grande está entero en la pantalla, y en una de 1080 líneas se lee desde la última fila.
  async seProyecta(selector) {
    const [r, pantalla, chicos] = await this.da(selector => {
      const { left, top, right, bottom } = una(`${selector} :is(canvas, img)`).getBoundingClientRect();
      const textos = todos(':is(h2, p, output, .mando span)', una(selector));
      return [[left, top, right, bottom], [innerWidth, innerHeight], textos
        .filter(e => e.offsetParent && e.textContent.trim() && parseFloat(getComputedStyle(e).fontSize) < 28)
        .map(e => `${e.className} ${getComputedStyle(e).fontSize}`)];
    }, selector);
    const dentro = r[0] >= -0.5 && r[1] >= -0.5 && r[2] <= pantalla[0] + 0.5 && r[3] <= pantalla[1] + 0.5;
    assert.ok(dentro && r[2] - r[0] > pantalla[0] / 2, `${selector} va de ${r} en ${pantalla}`);
    if (pantalla[1] >= 1080) assert.deepEqual(chicos, []);
  }
}

/// Que esa imagen es como el golden del caso. `otro`, con qué tolerancia si es de otro OpenGL.
export function comoGolden(caso, ppm, otro) {
  const { capitulo } = PROGRAMAS.find(p => p.nombre === caso.programa), fallos = `${BUILD}/fallos/web`;
  mkdirSync(fallos, { recursive: true });
  const tolera = otro === undefined ? caso.tolerancia : caso.otro;
  const golden = `${RAIZ}/tests/golden/${capitulo}/${caso.fichero}.ppm`;
  const c = spawnSync(`${BUILD}/herramientas/comparador/compara`, [golden, '/dev/stdin',
    otro === undefined ? '--amplia' : '--otro', '--deja', `${fallos}/${caso.fichero}`,
    ...tolera ? ['--tolerancia', tolera] : []], { input: ppm, encoding: 'utf8' });
  assert.equal(c.status, 0, `${caso.fichero}: ${c.stdout}${c.stderr}`);
}

/// Lo que escribe una orden de Python con los módulos de herramientas/, de JSON.
export const dePython = (codigo, ...datos) =>
  JSON.parse(execFileSync('python3', ['-B', '-c', codigo, RAIZ, BUILD, ...datos],
    { env: { ...process.env, PYTHONPATH: `${RAIZ}/herramientas:${RAIZ}/tests/paginas` }, maxBuffer: 1e8 }));
