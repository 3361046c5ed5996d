// Un paseo al azar: se haga lo que se haga en una página, al ir a otra dirección todo está en ella como al abrirla, y
// «Atrás» lleva a donde se estaba. Con LAB_SEMILLA, otro.
import assert from 'node:assert/strict';
import { espera } from './navegador.mjs';

const NO = '.enlace, .guarda, .descarga, .corrige, .compila, .copia, .a-galeria, .suelto, .incrusta, [href*="/E"]';
const TECLAS = ['PageDown', 'PageUp', 'Home', 'End', 'ArrowRight', 'ArrowLeft', ...'b.?pxdvr1', 'Enter', ' ', 'Escape'];
const TALLAS = [[1280, 800], [390, 844]];

/// En la página: lo que se ve en ella, a trozos, salvo lo que se recuerda: lo que se busca y lo que se ha desplegado.
function seVe() {
  const copia = document.body.cloneNode(true), suyos = todos('*', copia), programa = globalThis.pagina?.visto.programa;
  for (const [i, e] of todos('*', document.body).entries()) if (!e.checkVisibility()) suyos[i].remove();
  const fuera = 'script, style, .resultados, .CodeMirror, .compilar, details:not(.tarea *)';
  for (const e of todos(fuera + (programa?.anima ? ', .estado, .consola' : ''), copia)) e.remove();
  for (const e of todos('canvas', copia)) for (const talla of ['width', 'height']) e.removeAttribute(talla);
  const clases = (_, suyas) => ` class="${suyas.split(' ').sort().join(' ').trim()}"`.replace(' class=""', '');
  return [document.title, programa && `${cm.getOption('readOnly')} ${cm.getValue()}`, una(':popover-open')?.className,
    ...copia.outerHTML.replace(/ class="(.*?)"/g, clases).split(/\s*(?=<)/)];
}

/// En la página: lo que se puede pulsar, junto lo que está junto.
const pulsables = no => Object.values(Object.groupBy(todos('a[href^="#"], figure a, button, summary, canvas',
  una('dialog[open]') ?? document.fullscreenElement ?? document)
  .filter(e => e.checkVisibility({ visibilityProperty: true }) && !e.closest(no)),
  e => todos('*').indexOf(e.parentElement.closest('div, ul, ol, section, article, nav'))));

/// `lista()`, en la página, es si ha acabado de llegar adonde iba; `sitios`, adónde se va de golpe.
export async function pasea(p, { pasos, sitios, lista }) {
  const semilla = +(process.env.LAB_SEMILLA ?? 1), hecho = [], historia = [''], visto = [], abiertas = new Map();
  let azar = semilla * 7919 + 1, talla = TALLAS[0], antes = '';
  const entre = n => (azar = azar * 48271 % 2147483647) % n, elige = lista => lista[entre(lista.length)];
  const asentada = async () => {
    await p.acaba(`llega, tras ${hecho.join('; ')}`, lista);
    for (let antes, ahora; ; antes = ahora, await espera(100))
      if (JSON.stringify(ahora = await p.da(seVe)) === JSON.stringify(antes)) return ahora;
  };
  const HACE = {
    async pulsa() {
      const hay = await p.pagina.evaluateHandle(`(${pulsables})('${NO}')`);
      const e = (await hay.evaluateHandle((hay, ...azar) => azar.reduce((de, n) => de?.[n % de.length], hay),
        entre(9999), entre(9999))).asElement();
      hecho.push(await e?.evaluate(e => `pulsa ${e.className} ${e.hash ?? e.textContent}`));
      await e?.click().catch(() => {}); // lo tapa otra cosa
    },
    tecla: () => p.teclas(hecho[hecho.push(elige(TECLAS)) - 1]),
    va: () => p.va(hecho[hecho.push(elige(sitios)) - 1]),
    async atras() {
      if (historia.length < 2) return;
      historia.pop();
      hecho.push('atrás');
      await p.da(() => history.back());
      await p.acaba(`«Atrás» va a «${historia.at(-1)}», tras ${hecho.join('; ')}`, debe => location.hash === debe,
        historia.at(-1));
    },
    async talla() {
      await p.talla(...talla = elige(TALLAS));
      await p.da(() => document.fullscreenElement && document.exitFullscreen());
    },
  };
  await p.talla(...talla);
  await p.carga();
  while (hecho.length < pasos) {
    const que = elige(['pulsa', 'pulsa', 'pulsa', 'tecla', 'va', 'va', 'atras', 'talla']);
    const engrande = await p.da(() => una('dialog')?.open); // lo que se pasa no es otro sitio al que volver
    await HACE[que]();
    const ahora = await p.da(() => cuadro().then(() => location.hash)), es = ahora === antes;
    antes = ahora;
    if (es) continue;
    const pasa = que !== 'va' && (engrande || que === 'tecla' && !/^(Enter| )$/.test(hecho.at(-1)));
    if (pasa) historia[historia.length - 1] = ahora;
    else if (que !== 'atras') historia.push(ahora);
    if (await p.da(() => una('dialog')?.open)) continue;
    const completa = await p.da(() => document.fullscreenElement?.className.split(' ')[0]);
    visto.push({ ahora, talla, completa, ve: await asentada(), tras: hecho.slice(-9).join('; ') });
  }
  for (const { ahora, talla, completa, ve, tras } of visto) {
    const clave = [ahora, talla, completa].join();
    if (!abiertas.has(clave)) {
      await p.talla(...talla);
      await p.carga(ahora);
      await asentada();
      if (completa) await p.da(completa => una(`.${completa}`).requestFullscreen(), completa);
      abiertas.set(clave, await asentada());
    }
    const abierta = abiertas.get(clave), i = ve.findIndex((trozo, i) => trozo !== abierta[i]);
    assert.ok(i < 0 && ve.length === abierta.length, `semilla ${semilla}: «${ahora}» (${talla}) no es como al abrirla, \
tras ${tras}: ${ve.slice(i, i + 3)} y no ${abierta.slice(i, i + 3)}`);
  }
}
