// Un paseo al azar: se haga lo que se haga en una página, al ir a otra dirección todo está en ella como al abrirla, y
// «Atrás» lleva a donde se estaba. LAB_SEMILLA es la del paseo.
import assert from 'node:assert/strict';
import { espera } from './navegador.mjs';

const NO_SE_PULSA = '.enlace, .guarda, .descarga, .corrige, .compila, .copia, .a-galeria, .suelto, .incrusta, [href*="/E"]';
const TECLAS = ['PageDown', 'PageUp', 'Home', 'End', 'ArrowRight', 'ArrowLeft', ...'b.?pxdvr1', 'Enter', ' ', 'Escape'];
const ACCIONES = ['pulsa', 'pulsa', 'pulsa', 'tecla', 'tecla', 'va', 'va', 'atras', 'talla'];
const TALLAS = [[1280, 800], [390, 844]];

/// En la página: lo que se ve en ella, a trozos. Se recuerda, adonde se vaya, lo que se busca y lo que se ha desplegado.
function seVe() {
  const copia = document.body.cloneNode(true), suyos = todos('*', copia), programa = globalThis.pagina?.visto.programa;
  for (const [i, e] of todos('*', document.body).entries()) if (!e.checkVisibility()) suyos[i].remove();
  const anda = programa?.anima ? ', .estado, .consola' : '';
  for (const e of todos('script, style, template, .resultados, .CodeMirror, .compilar, details:not(.tarea *)' + anda, copia))
    e.remove();
  for (const e of todos('canvas', copia)) for (const talla of ['width', 'height']) e.removeAttribute(talla);
  return [document.title, programa && `${cm.getOption('readOnly')} ${cm.getValue()}`, una(':popover-open')?.className,
    ...copia.outerHTML.replaceAll(' class=""', '').split(/\s*(?=<)/)];
}

const pulsables = no => todos('a[href^="#"], figure a, button, summary, canvas', document.fullscreenElement ?? document)
  .filter(e => e.checkVisibility({ visibilityProperty: true }) && !e.closest(no) &&
    (!una('dialog[open]') || e.closest('dialog')));

/// `lista()`, en la página, es si ha acabado de llegar adonde iba; `sitios`, adónde se va de golpe.
export async function pasea(p, { pasos, sitios, lista }) {
  const semilla = +(process.env.LAB_SEMILLA ?? 1), hecho = [], historia = [''], visto = [];
  let azar = semilla * 7919 + 1, talla = TALLAS[0];
  const elige = entre => entre[(azar = azar * 48271 % 2147483647) % entre.length];
  const donde = () => p.da(() => cuadro().then(() => location.hash));
  const asentada = async () => {
    await p.acaba(`llega, tras ${hecho.join('; ')}`, lista);
    for (let antes, ahora; ; antes = ahora, await espera(100))
      if (JSON.stringify(ahora = await p.da(seVe)) === JSON.stringify(antes)) return ahora;
  };
  const HACE = {
    async pulsa() {
      const hay = await p.pagina.evaluateHandle(`(${pulsables})('${NO_SE_PULSA}')`);
      const i = elige([...Array(await hay.evaluate(hay => hay.length)).keys()]);
      const e = (await hay.evaluateHandle((hay, i) => hay[i], i)).asElement();
      hecho.push(await e?.evaluate(e => `pulsa ${e.className} ${e.hash ?? e.textContent}`));
      await e?.click().catch(() => {}); // lo tapa otra cosa
    },
    async tecla() {
      hecho.push(elige(TECLAS));
      await p.teclas(hecho.at(-1));
    },
    va: () => p.va(hecho[hecho.push(elige(sitios)) - 1]),
    atras: () => historia.length > 1 && hecho.push('atrás') && p.da(() => history.back()),
    talla: () => p.talla(...talla = elige(TALLAS)),
  };
  await p.talla(...talla);
  await p.carga();
  for (let antes = await donde(), ahora; hecho.length < pasos; antes = ahora) {
    const que = elige(ACCIONES);
    const pasa = await p.da(() => una('dialog')?.open); // lo que se pasa en grande o con teclas no es otro sitio
    await HACE[que]();
    ahora = await donde();
    if (que === 'atras' && historia.length > 1) {
      historia.pop();
      await p.acaba(`«Atrás» va a «${historia.at(-1)}», tras ${hecho.join('; ')}`, debe => location.hash === debe,
        ahora = historia.at(-1));
    }
    if (ahora === antes) continue;
    if (que === 'tecla' && !/^(Enter| )$/.test(hecho.at(-1)) || pasa) historia[historia.length - 1] = ahora;
    else if (que !== 'atras') historia.push(ahora);
    const completa = await p.da(() => document.fullscreenElement?.className.split(' ')[0]);
    if (!await p.da(() => una('dialog')?.open))
      visto.push({ ahora, talla, completa, ve: await asentada(), hecho: hecho.slice(-12).join('; ') });
  }
  for (const { ahora, talla, completa, ve, hecho } of visto) {
    await p.talla(...talla);
    await p.carga(ahora);
    await asentada();
    if (completa) await p.da(completa => una(`.${completa}`).requestFullscreen(), completa);
    const abierta = await asentada(), i = abierta.findIndex((trozo, i) => trozo !== ve[i]);
    console.log(ahora, talla, completa, i);
    assert.ok(i < 0 && ve.length === abierta.length, `con la semilla ${semilla}, «${ahora}» (${talla}) no se ve como al \
abrirla: ${ve.slice(i, i + 3)} y no ${abierta.slice(i, i + 3)}; tras ${hecho}`);
  }
}
