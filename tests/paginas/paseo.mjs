// Un paseo al azar: se haga lo que se haga en una página, al ir a otra dirección todo está en ella como al abrirla,
// «Atrás» lleva a donde se estaba, y lo que se pone pulsando algo se quita pulsándolo otra vez. Con LAB_SEMILLA, otro.
import assert from 'node:assert/strict';
import { espera } from './navegador.mjs';

const NO = '.enlace, .guarda, .descarga, .corrige, .compila, .copia, .a-galeria, .suelto, .incrusta, [href*="/E"]';
const TECLAS = ['PageDown', 'PageUp', 'Home', 'End', 'ArrowRight', 'ArrowLeft', ...'b.?pxdvr1', 'Enter', ' ', 'Escape'];
const ACCIONES = ['pulsa', 'pulsa', 'pulsa', 'tecla', 'va', 'va', 'atras', 'dos', 'talla'];
const TALLAS = [[1280, 800], [390, 844]];

/// En la página: lo que se ve en ella, a trozos, salvo lo que se recuerda: lo que se busca y lo que se ha desplegado.
function seVe(menos = '') {
  const copia = document.body.cloneNode(true), suyos = todos('*', copia), programa = globalThis.pagina?.visto.programa;
  for (const [i, e] of todos('*', document.body).entries()) if (!e.checkVisibility()) suyos[i].remove();
  menos += programa?.anima ? ', .estado, .consola' : '';
  for (const e of todos('script, style, .resultados, .CodeMirror, .compilar, details:not(.tarea *)' + menos, copia))
    e.remove();
  for (const e of todos('canvas', copia)) for (const talla of ['width', 'height']) e.removeAttribute(talla);
  return [document.title, programa && `${cm.getOption('readOnly')} ${cm.getValue()}`, una(':popover-open')?.className,
    ...copia.outerHTML.replace(/ class="(.*?)"/g, (_, clases) => ` ${clases.split(' ').sort().join('.')}`).split(/\s*(?=<)/)];
}

/// En la página: lo que se puede pulsar, junto lo que está junto; o, `dos` veces, lo que se pone y se quita.
const pulsables = (no, dos) => Object.values(Object.groupBy(todos(dos ? '.derecho, .tarea button, .explica'
  : 'a[href^="#"], figure a, button, summary, canvas', una('dialog[open]') ?? document.fullscreenElement ?? document)
  .filter(e => e.checkVisibility({ visibilityProperty: true }) && !e.closest(no)),
  e => todos('*').indexOf(e.parentElement.closest('div, ul, ol, section, article, nav'))));

/// `lista()`, en la página, es si ha acabado de llegar adonde iba; `sitios`, adónde se va de golpe.
export async function pasea(p, { pasos, sitios, lista }) {
  const semilla = +(process.env.LAB_SEMILLA ?? 1), hecho = [], historia = [''], visto = [];
  let azar = semilla * 7919 + 1, talla = TALLAS[0];
  const entre = n => (azar = azar * 48271 % 2147483647) % n, elige = lista => lista[entre(lista.length)];
  const donde = () => p.da(() => cuadro().then(() => location.hash));
  const asentada = async menos => {
    await p.acaba(`llega, tras ${hecho.join('; ')}`, lista);
    for (let antes, ahora; ; antes = ahora, await espera(100))
      if (JSON.stringify(ahora = await p.da(seVe, menos)) === JSON.stringify(antes)) return ahora;
  };
  const pulsa = async dos => {
    const hay = await p.pagina.evaluateHandle(`(${pulsables})('${NO}', ${dos})`);
    const e = (await hay.evaluateHandle((hay, ...azar) => azar.reduce((de, n) => de?.[n % de.length], hay),
      entre(9999), entre(9999))).asElement();
    hecho.push(await e?.evaluate(e => `pulsa ${e.className} ${e.hash ?? e.textContent}`));
    return () => e?.click().catch(() => {}); // lo tapa otra cosa
  };
  const iguales = (una, otra, que) => {
    const i = una.findIndex((trozo, i) => trozo !== otra[i]);
    assert.ok(i < 0 && una.length === otra.length,
      `con la semilla ${semilla}, ${que}: ${una.slice(i, i + 3)} y no ${otra.slice(i, i + 3)}`);
  };
  const HACE = {
    pulsa: () => pulsa().then(hazlo => hazlo()),
    tecla: () => p.teclas(hecho[hecho.push(elige(TECLAS)) - 1]),
    va: () => p.va(hecho[hecho.push(elige(sitios)) - 1]),
    atras: () => historia.length > 1 && hecho.push('atrás') && p.da(() => history.back()),
    async talla() {
      await p.talla(...talla = elige(TALLAS));
      await p.da(() => document.fullscreenElement && document.exitFullscreen());
    },
    async dos() {
      const menos = ', .aviso, .explicacion, .aqui', antes = await asentada(menos), hazlo = await pulsa(true);
      await hazlo();
      await hazlo();
      iguales(await asentada(menos), antes, `dos veces, ${hecho.slice(-9).join('; ')}`);
    },
  };
  await p.talla(...talla);
  await p.carga();
  for (let antes = await donde(), ahora; hecho.length < pasos; antes = ahora) {
    const que = elige(ACCIONES), pasa = await p.da(() => una('dialog')?.open); // lo que se pasa no es otro sitio
    await HACE[que]();
    ahora = await donde();
    if (que === 'atras' && historia.length > 1) {
      historia.pop();
      await p.acaba(`«Atrás» va a «${historia.at(-1)}», tras ${hecho.join('; ')}`, debe => location.hash === debe,
        ahora = historia.at(-1));
    }
    if (ahora === antes) continue;
    if (pasa || que === 'tecla' && !/^(Enter| )$/.test(hecho.at(-1))) historia[historia.length - 1] = ahora;
    else if (que !== 'atras') historia.push(ahora);
    if (await p.da(() => una('dialog')?.open)) continue;
    const completa = await p.da(() => document.fullscreenElement?.className.split(' ')[0]);
    visto.push({ ahora, talla, completa, ve: await asentada(), hecho: hecho.slice(-9).join('; ') });
  }
  const abiertas = new Map();
  for (const { ahora, talla, completa, ve, hecho } of visto) {
    const clave = [ahora, talla, completa].join();
    if (!abiertas.has(clave)) {
      await p.talla(...talla);
      await p.carga(ahora);
      await asentada();
      if (completa) await p.da(completa => una(`.${completa}`).requestFullscreen(), completa);
      abiertas.set(clave, await asentada());
    }
    iguales(ve, abiertas.get(clave), `«${ahora}» (${talla}) no se ve como al abrirla, tras ${hecho}`);
  }
}
