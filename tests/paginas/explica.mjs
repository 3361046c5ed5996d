// Explicar en la página: de cada programa, dos píxeles suyos, cuya historia es la que da con OSMesa; de cada manera de
// pedirlo, con el ratón, el teclado, un enlace; con un shader cambiado, y lo que se pregunta en docs/porques.tsv.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { BUILD, dePython, lee, PROGRAMAS } from './navegador.mjs';

const CADA = 3; // de los programas, uno
const SIN_SOSPECHAS = { // con razón, y a propósito
  tiras: '«diametroPunto»', primer_programa: 'no se dibuja nada',
  zbuffer: 'GL_DEPTH_TEST', grua_zbuffer: 'GL_DEPTH_TEST',
};

/// En la página: lo que no cuadra de lo que se dice de ese píxel, y lo que se dice. La historia acaba en el color de la
/// imagen; el shader da el color que se le apunta, y nada cambia.
async function mira([x, y], sabido) {
  const { lienzo } = sesion, { width, height } = lienzo, gl = lienzo.getContext('webgl2'), mal = [];
  const todo = new Uint8Array(4 * width * height), i = 4 * ((height - 1 - y) * width + x);
  const lee = () => { gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, todo); return todo.join(); };
  const di = (cuando, que) => { if (cuando) mal.push(que); };
  escena.quieta = true;
  const antes = lee(), color = [...todo.slice(i, i + 3)], datos = await pagina.explica([x, y]);
  if (!datos) return { mal: [aviso] };
  const { historia, sombreado, ordenes } = datos, escritos = historia.filter(s => s.veredicto === 'escrito');
  const cambia = escritos.findLast(s => !s.mezcla?.si || String(s.antes) !== String(s.despues));
  const gana = cambia?.primitiva === undefined ? escritos.at(-1) : cambia;
  const de = s => s.slice(0, 3).join();
  di(de(datos.color) !== de(color) || de(gana.despues) !== de(color),
    `es (${color}), se dice (${datos.color}) y la historia acaba en (${gana.despues})`);
  di(lee() !== antes, 'la imagen ha cambiado');
  sesion.redibuja();
  di(lee() !== antes, 'la imagen, dibujada otra vez, ha cambiado');
  di(gl.getError(), 'queda un error de OpenGL');
  di(gl.getContextAttributes().alpha, 'donde alfa no es 1 se ve la página');
  di(!sesion.vivo, 'el programa ha terminado');
  for (const [k, s] of historia.entries()) {
    di(k && de(s.antes) !== de(historia[k - 1].despues), `la orden ${s.orden} encuentra otro color`);
    di(s.veredicto !== 'escrito' && de(s.antes) !== de(s.despues), `la orden ${s.orden} no escribe y cambia el color`);
    di(s.mezcla && !s.mezcla.cuadra, `la orden ${s.orden} deja (${s.despues}) y no (${s.mezcla?.suma})`);
  }
  di(sombreado?.primitiva !== gana.primitiva, 'no es el shader de quien gana');
  if (sombreado) {
    const { fragmento, vertices, pesos } = sombreado;
    const ultimo = fragmento.lineas.findLast(l => l.clase === 'salida')?.valor ?? [NaN];
    di(fragmento.pasos < 4000 && ultimo.some((v, k) => !(Math.abs(v - gana.color[k]) <= 1 / 255)),
      `el shader apunta (${ultimo}) y da (${gana.color})`);
    for (const t of [fragmento, ...vertices]) di(t.motivo || t.sinSeguir.length, t.motivo + t.sinSeguir);
    di(vertices.length !== gana.vertices.length || (vertices.length === 3) !== Boolean(pesos), 'faltan vértices');
    di(!todos('.explicacion .apunte').length, 'no se ve ninguna línea');
    const pinta = escritos.filter(s => s.dice !== 'borrado').length;
    const dichas = todos('.explicacion h2').map(t => t.textContent.match(/escrito (\d+) veces/)).find(Boolean)?.[1];
    di(+(dichas ?? 0) !== (pinta > 2 ? pinta : 0), `lo pintan ${pinta} y se dice ${dichas}`);
    const { atributos, uniformes, texturas } = ordenes.find(o => o.n === gana.orden).cableado;
    const cosas = new Set([...atributos, ...uniformes].map(c => c.nombre).concat(texturas.map(t => t.sampler)));
    await cuadro(); // el cableado se traza en el siguiente
    const lineas = todos('.explicacion .cableado path').length;
    di(lineas < cosas.size, `de ${cosas.size} cosas salen ${lineas} líneas`);
  }
  const dichas = datos.sospechas.map(s => s.dice).filter(dice => !sabido || !dice.includes(sabido));
  di(dichas.length, `se sospecha: ${dichas}`);
  return { mal, guion: hecho.ordenes.join(';'),
    dice: [historia.map(s => [s.orden, s.primitiva ?? -1, s.veredicto]), datos.sospechas.map(s => s.dice).sort()] };
}

/// Con ./lab explica, lo que le pasa a ese píxel de la ventana, [orden, primitiva, veredicto], y lo que se sospecha.
function loQueDice({ capitulo, nombre }, guion, punto) {
  const cwd = mkdtempSync(`${tmpdir()}/explica`);
  const env = { ...process.env, LD_PRELOAD: `${BUILD}/herramientas/explica/libexplica.so`, LAB_EXPLICA: 'e.json',
    LAB_EXPLICA_PIXELES: punto.join() };
  execFileSync(`${BUILD}/osmesa/${capitulo}/${nombre}`, ['-geometry', '240x180', ...guion ? ['-guion', guion] : [],
    '-ppm', 'i.ppm'], { cwd, env, stdio: 'ignore' });
  const { pixeles: [pixel], sospechas } = JSON.parse(readFileSync(`${cwd}/e.json`));
  return [pixel.historia.filter(s => s.framebuffer === 0).map(s => [s.orden, s.primitiva ?? -1, s.veredicto]),
    sospechas.map(s => s.dice).sort()];
}

const borraSusShaders = q => q.nombre === 'shader_basico'; // y hay que leerlos
const mirados = PROGRAMAS.filter(q => !q.consola).filter((q, i) => i % CADA === 0 || borraSusShaders(q));
const historias = mirados.map((programa, i) =>
  [`la historia de dos píxeles de ${programa.nombre}`, async p => {
    await p.abre(`#${programa.nombre}`);
    for (const punto of [[40 + i * 37 % 160, 40 + i * 23 % 110], [i % 2 ? 0 : 120, 90]]) { // y en el borde
      const { mal, guion, dice } = await p.da(mira, punto, SIN_SOSPECHAS[programa.nombre]);
      assert.deepEqual(mal, [], `${punto}`);
      assert.deepEqual(dice, loQueDice(programa, guion, punto), `${punto}, tras «${guion}»`);
    }
  }]);

const seVe = (p, pixel) => p.acaba(`se explica ${pixel ?? ''}`,
  pixel => una('.explicacion > h2')?.textContent.startsWith(`El píxel (${pixel ?? ''}`), pixel);
const cerrado = () => una('.explicacion').hidden && !una('.lienzo .aqui') && !visto.explicado;
const apuntando = () => una('.explica').getAttribute('aria-pressed') === 'true' && marco.classList.contains('apunta');

const maneras = {
  'explicar con el ratón: el clic no llega al programa, y el foco va y vuelve': async p => {
    await p.abre('#espejo_plantilla');
    await p.pulsa('.explica');
    await p.acaba('se apunta', apuntando);
    await p.pagina.mouse.click(...await p.punto(65, 82));
    await seVe(p);
    await p.exige('no le llega', () => !hecho.ordenes.length);
    await p.exige('y la marca no se queda con los que vengan', () => {
      una('.lienzo .aqui').scrollIntoView({ block: 'center' });
      const { x, y, width, height } = una('.lienzo .aqui').getBoundingClientRect();
      return document.elementFromPoint(x + width / 2, y + height / 2) === una('canvas');
    });
    await p.exige('dice por qué', () =>
      /no pasa la plantilla: hay 0 y se pide GL_EQUAL 1/.test(una('.explicacion').textContent));
    await p.exige('sin sospechar de lo que no llega a nada', () => !una('.explicacion .sospechas'));
    await p.exige('el foco va allí', () => document.activeElement === una('.explicacion > h2'));
    await p.teclas('Escape');
    await p.acaba('Esc lo cierra', cerrado);
    await p.exige('y se vuelve al botón', () => document.activeElement === una('.explica'));
  },

  'explicar con el teclado, y con el enlace que se copia': async p => {
    await p.abre('#espejo_plantilla');
    await p.teclas('x');
    await p.acaba('con x se apunta', apuntando);
    await p.teclas('ArrowLeft', 'ArrowLeft', 'ArrowUp', 'Enter');
    await seVe(p, '118, 89');
    await p.da(() => una('.enlace').click());
    for (const enlace of [await p.da(() => location.hash), '#espejo_plantilla/explica/474,358']) {
      assert.match(enlace, /^#espejo_plantilla\/explica\//);
      await p.abre(enlace);
      await seVe(p, '118, 89');
    }
    await p.abre('#grua/explica/9999,1');
    await p.acaba('el que no hay se dice', () => /no está en la ventana/.test(aviso));
  },

  'explicar el cuadro entero, y lo que se anima': async p => {
    await p.abre('#espejo_plantilla');
    await p.pulsa('.explica-cuadro');
    await p.acaba('el cuadro', () => una('.explicacion > h2')?.textContent === 'El cuadro entero' &&
      todos('.explicacion .tira li').length > 9 && todos('.explicacion .tira img').length > 5);
    const [una, otra] = await p.da(async () =>
      [await pagina.explica(), await pagina.explica()].map(d => JSON.stringify(d)));
    assert.equal(una, otra, 'explicado otra vez, es lo mismo');
    await p.da(() => todos('.explicacion .tira button').at(-1).click());
    const laminas = await p.da(() => todos('.explicacion .laminas figcaption').map(f => f.textContent.split(':')[0]));
    for (const que of ['color', 'profundidad', 'plantilla']) assert.ok(laminas.includes(que), que);
    await p.abre('#luces_animadas/explica/480,360');
    await seVe(p);
    const antes = await p.da(() => hecho.ordenes.join());
    await p.acaba('y después sigue', antes => hecho.ordenes.join() !== antes, antes);
    await p.da(() => { una('.explica-cuadro').click(); location.hash = 'banderas'; });
    await p.acaba('y si mientras se va a otro, también él', () => visto.programa?.nombre === 'banderas' &&
      /^espera \d{3}/.test(hecho.ordenes.join()));
  },

  'explicar un canto, con muestras: lo que no llega al centro del píxel no se calla ni se da por otro': async p => {
    await p.carga('#tres_cubos');
    await p.acaba('arranca', () => sesion?.vivo);
    const { mal, cantos } = await p.da(async () => {
      const { lienzo } = sesion, { width, height } = lienzo, gl = lienzo.getContext('webgl2'), mal = [];
      sesion.redibuja();
      const fila = new Uint8Array(4 * width), y = Math.floor(height * 0.38);
      gl.readPixels(0, height - 1 - y, width, 1, gl.RGBA, gl.UNSIGNED_BYTE, fila);
      const de = x => [...fila.slice(4 * x, 4 * x + 3)].join(', ');
      const cantos = [...Array(width).keys()].filter(x => x && de(x) !== de(x - 1) && de(x) !== de(x + 1)).slice(0, 6);
      for (const x of cantos) {
        await pagina.explica([x, y]);
        const quedan = todos('.sucesos td:last-child').map(t => t.textContent).filter(Boolean);
        const filas = todos('.sucesos tbody tr').map(t => t.textContent);
        if (quedan.at(-1) !== `(${de(x)})`) mal.push(`${x}: es (${de(x)}) y queda ${quedan.at(-1)}`);
        const ajeno = filas.some(f => f.includes('algo que no sigo') && f.endsWith(`(${de(x)})`));
        if (ajeno === /se lo ha dado/.test(una('.explicacion .dice').textContent)) mal.push(`${x}: quién`);
      }
      return { mal, cantos: cantos.length };
    });
    assert.deepEqual(mal, []);
    assert.ok(cantos > 1, `${cantos} cantos`);
  },

  'explicar un shader según se escribe, y lo que suele dejar la ventana negra': async p => {
    const de = '#sombreado/explica/250,210;tecla 3';
    const NDOTL = () => todos('.explicacion .apunte').map(a => a.textContent).find(a => a.startsWith('NdotL = '));
    for (const [antes, final, debe] of [
      ['uniform float k;', '    colorFragmento *= k;', '«k» lo usa el shader y nadie le ha dado valor: es 0'],
      ['', '    discard;', 'el shader descarta todos sus fragmentos'],
      ['', '    float nada = 0.0;\n    colorFragmento.r = nada / nada;', 'NaN']]) {
      await p.abre(de);
      await p.acaba('se explica', () => visto.explicado && editor.ruta);
      await p.reescribe('ch05_iluminacion/sombreado_phong.frag', texto =>
        texto.replace(/^void main[^]*(?=^})/m, cuerpo => `${antes}\n${cuerpo}${final}\n`));
      await p.acaba(debe, debe => una('.explicacion').textContent.includes(debe), debe);
      assert.equal(await p.da(() => todos('.explicacion .cableado path.malo').length), antes ? 1 : 0);
      await p.da(() => sessionStorage.clear());
    }
    await p.abre(de);
    await seVe(p);
    const debe = await p.da(NDOTL), phong = 'ch05_iluminacion/phong.glsl';
    assert.ok(debe);
    await p.da(async (ruta, texto) => {
      escena.cambia(ruta, texto);
      await pagina.explica(visto.explicado.pixel);
    }, phong, lee(phong).replace(/ {4}if \(NdotL > 0.0\) \{[^]*?\n {4}\}\n/, ''));
    assert.equal(await p.da(NDOTL), debe, 'a medio hacer, con la luz que aún nada usa');
    await p.abre('#ejercicio/L5.1/explica/250,210');
    await p.acaba('en un ejercicio', () => todos('.explicacion .apunte').length);
  },

  'lo que se dice que se verá en docs/porques.tsv se ve': async p => {
    const porques = dePython(`import json, sys
from pathlib import Path
from base import libro
print(json.dumps([[p.enlace, p.mira] for p in libro.porques(Path(sys.argv[1]))]))`);
    for (const [enlace, mira] of porques) {
      await p.abre('#' + enlace);
      await seVe(p);
      const texto = await p.da(() => una('.explicacion').textContent + todos('.explicacion .tira button').map(b => {
        b.click();
        return una('.una-orden').textContent;
      }).join());
      assert.deepEqual([...mira.matchAll(/`(.+?)`/g)].map(m => m[1]).filter(t => !texto.includes(t)), [], enlace);
    }
    await p.carga();
    assert.equal(await p.da(() => todos('.porques a').length), porques.length, 'cada una está en su capítulo');
  },

  'lo que explica un píxel, para todos, y nada se sale': async p => {
    for (const [ancho, alto] of [[1440, 900], [1024, 768], [390, 844]]) {
      await p.talla(ancho, alto);
      await p.carga('#transparencia/explica/480,400');
      await seVe(p);
      await p.nadaSeSale(`a ${ancho}`);
      for (const value of p.cual === 'chromium' ? ['light', 'dark'] : ['']) { // Firefox no deja pedirlo desde fuera
        if (value) await p.pagina.emulateMediaFeatures([{ name: 'prefers-color-scheme', value }]);
        await p.esParaTodos();
      }
    }
  },
};

export const explica = { ...Object.fromEntries(historias), ...maneras };
