// Por qué falla lo entregado: lo de herramientas/ejercicios/corrige/motivos.py, en la página. Qué error conocido, o qué
// dos, plantados en la solución, dejan en todos los guiones lo mismo.
import { aparte, BIEN } from './nota.mjs';

const PAREJAS = 16, TOCAN = 0.6, GEMELOS = 0.5; // los de allí

/// Los puntos, uno de cada cinco, en que las imágenes de una partida no son las que se esperan.
function queToca(partida, esperada) {
  const toca = new Uint8Array(esperada.imagenes.reduce((n, ppm) => n + Math.ceil(pixeles(ppm).length / 5), 0));
  let n = 0;
  for (const [i, debe] of esperada.imagenes.entries()) {
    const es = partida.imagenes[i], de = pixeles(debe), suyos = es && pixeles(es);
    for (let j = 0; j < de.length; j += 5) toca[n++] = suyos?.length !== de.length || suyos[j] !== de[j];
  }
  return toca;
}

/// Los de un PPM.
function pixeles(ppm) {
  let sitio = 0;
  for (let linea = ''; linea !== '255'; sitio += linea.length + 1)
    linea = new TextDecoder().decode(ppm.subarray(sitio, ppm.indexOf(10, sitio)));
  return ppm.subarray(sitio);
}

/// De los pares [i, j, si son gemelos], los que entre los dos tocan casi lo que ha TOCADO lo entregado, los que más,
/// antes.
function losQueTocan(pares, tocado, tocan) {
  const cuanto = ([a, b, gemelos]) => {
    let todos = 0, comunes = 0;
    for (let i = 0; i < tocado.length; ++i) {
      const entre = tocan[a][i] || tocan[b][i];
      todos += entre || tocado[i];
      comunes += entre && tocado[i];
    }
    return GEMELOS * gemelos + comunes / Math.max(todos, 1);
  };
  return pares.map(par => ({ par, cuanto: cuanto(par) })).filter(p => p.cuanto >= TOCAN)
    .sort((una, otra) => otra.cuanto - una.cuanto).slice(0, PAREJAS).map(p => p.par);
}

/// Lo que se le dice a quien ha dejado esas partidas en los guiones; nada, si no se conoce; [''], si es el punto de
/// partida. `variantes` son [{ dice, arranca() }], y `esqueleto`, otra; `defectos`, de las variantes, las que son uno,
/// que van al final; `dos(i, j)`, la de dos de ellos; `pares`, los que se pueden.
export async function porQue(corrector, guiones, { variantes, esqueleto, defectos, pares, dos }) {
  const jugados = guiones.filter(g => g.partida), fallan = jugados.filter(g => g.parecido < BIEN);
  const primero = [...jugados].sort((a, b) => (a.en ?? 99) - (b.en ?? 99)); // donde antes se aparta, antes se sabe

  async function lasQueDanLoMismo(vivas) {
    vivas = vivas.map(v => ({ ...v, exacta: true }));
    for (const { ordenes, partida } of primero) {
      const siguen = [];
      for (const v of vivas) {
        v.como ??= await v.arranca();
        const { suya, igual, exacta } = v.como ? await corrector.deja(v.como, ordenes, partida) : {};
        v.exacta &&= exacta;
        if (igual && !Object.keys(aparte(suya, partida)).length) siguen.push(v);
      }
      vivas = siguen;
    }
    return vivas;
  }

  let vivas = await lasQueDanLoMismo(variantes);
  if (!vivas.length) vivas = await lasQueDanLoMismo([esqueleto]);
  if (!vivas.length && fallan.length && pares.length) {
    const [{ ordenes, partida }] = fallan, debe = await corrector.esperada(ordenes), tocan = [];
    for (const [i, { arranca }] of defectos.entries())
      if (pares.some(par => par.slice(0, 2).includes(i)))
        tocan[i] = queToca(await corrector.juega(await arranca(), ordenes), debe);
    vivas = await lasQueDanLoMismo(losQueTocan(pares, queToca(partida, debe), tocan).map(([i, j]) => dos(i, j)));
  }
  const exactas = vivas.filter(v => v.exacta);
  return [...new Set((exactas.length ? exactas : vivas).map(v => v.dice))];
}
