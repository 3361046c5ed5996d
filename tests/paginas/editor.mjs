// Tocar los shaders en la página: cambiarlos bien y mal, y hacer los ejercicios, bien y mal.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { lee, RAIZ } from './navegador.mjs';

const CODIGOS = readdirSync(`${RAIZ}/herramientas/ejercicios/errores`).filter(f => f[0] === 'L')
  .map(f => f.replace('.tsv', ''));
const PHONG = 'ch05_iluminacion/phong.glsl';

async function editaPhong(p) {
  await p.abre('#componentes_phong');
  await p.acaba('el editor', () => editor.ruta && cm.lineCount() > 5);
  await p.da(ruta => editor.abre(ruta), PHONG);
  return p.da(() => cm.getValue().split('\n').findLastIndex(l => /^\s*return /.test(l)) + 1);
}

const cambios = {
  'un cambio bueno se aplica solo, y se puede volver al original': async p => {
    const linea = await editaPhong(p), original = await p.imagen();
    const mira = await p.da(() => todos('.casos-botones [aria-pressed=true], .panel .mira').map(e => e.textContent));
    assert.match(mira.join(': '), /^Ambiente, difusa y especular: La reflexión especular/,
      'lo que hay que mirar es lo que se ve');
    await p.escribe(linea, '    return vec3(1.0, 0.0, 0.0);\n');
    await p.acaba('se aplica', () => /Cambiado/.test(estado.textContent));
    assert.notDeepEqual(await p.imagen(), original);
    await p.da(() => una('button', estado).click());
    await p.acaba('vuelve', () => !visto.taller.cambios.size && sessionStorage.getItem('cambios') === '[]');
    assert.deepEqual(await p.imagen(), original);
  },

  'un error se dice en su línea, la imagen sigue, y al volver a abrir la página aún está': async p => {
    const linea = await editaPhong(p), original = await p.imagen(), malo = () => una('.linea-mala');
    await p.escribe(linea, 'esto no compila;\n');
    await p.acaba('se marca', malo);
    await p.exige('su línea', linea => cm.lineInfo(linea - 1).bgClass === 'linea-mala' &&
      estado.textContent.includes(`phong.glsl, línea ${linea}: `), linea);
    assert.deepEqual(await p.imagen(), original);
    await p.da(() => cm.undo());
    await p.acaba('corregido', () => !una('.linea-mala, .mensaje-malo') && !estado.classList.contains('mal'));
    await p.da(() => cm.redo());
    await p.acaba('y estropeado otra vez', malo);
    await p.pagina.reload();
    await p.acaba('sigue', () => !telon.hidden && una('.linea-mala'));
    await p.acaba('el fichero se abre por esa línea', () => editor.ruta.endsWith('phong.glsl') &&
      cm.coordsChar({ left: 0, top: cm.getScrollInfo().top }, 'local').line > 10);
    await p.da(() => todos('button', estado).at(-1).click());
    await p.acaba('vuelto al original, arranca', () => sesion?.vivo && telon.hidden);
  },

  'lo escrito justo antes de irse queda en su programa, y de las pestañas pulsadas seguidas, la última': async p => {
    await editaPhong(p);
    await p.da(() => {
      cm.replaceRange('// mío\n', { line: 1, ch: 0 }, undefined, '+input');
      todos('.pestanas button').find(b => b.ruta && b.ruta !== editor.ruta).click();
      location.hash = 'grua';
    });
    await p.acaba('se va', () => visto.programa.nombre === 'grua' && sesion?.vivo && editor.ruta);
    await p.exige('y queda', ruta => /mío/.test(visto.taller.cambios.get(ruta)) && visto.taller.cambios.size === 1,
      PHONG);
    await p.exige('queda la última', async () => {
      const rutas = todos('.pestanas button').flatMap(b => b.ruta ?? []);
      await Promise.all(rutas.map(ruta => editor.abre(ruta)));
      const texto = cm.getValue(), ultima = rutas.at(-1);
      await editor.abre(rutas[0]);
      await editor.abre(ultima);
      cm.undo(); // de lo escrito en otro fichero, nada
      return rutas.length > 2 && editor.abierto === ultima && texto === cm.getValue();
    });
  },
};

/// La solución del programa o, mal hecha, con un error que se conoce.
async function resuelve(p, mal) {
  const { textos, defectos: [{ en, cambia: [desde, hasta, por] }] } =
    (await p.da(() => pagina.deEjercicio(visto.ejercicio.codigo))).errores;
  for (const ruta of await p.da(() => Object.keys(visto.ejercicio.pide)))
    await p.reescribe(ruta, () => !mal ? lee(ruta) : ruta !== en ? textos[ruta]
      : textos[ruta].slice(0, desde) + por + textos[ruta].slice(hasta));
}

/// La parte que coincide de lo que se ve, cuando ya se ha mirado si también lo demás; y lo que se dice.
async function parecido(p) {
  await p.da(() => visto.ejercicio.comparaYa());
  await p.acaba('compara', () => sesion?.vivo && !una('.veredicto').textContent.startsWith('Comparando'));
  return p.da(() => {
    visto.ejercicio.comparaYa();
    return [parseFloat(una('.parecido output').textContent), una('.veredicto').textContent];
  });
}

const resuelto = (p, codigo) =>
  p.da(codigo => (localStorage.getItem('resueltos') ?? '').split(' ').includes(codigo), codigo);

async function empieza(p, codigo) {
  await p.abre('#ejercicio/' + codigo);
  await p.acaba('empieza', () => /%/.test(una('.parecido output').textContent) && editor.ruta);
}

const cadaUno = CODIGOS.map(codigo => [`el ejercicio ${codigo}, mal y bien`, async p => {
  await empieza(p, codigo);
  await p.da(() => { if (visto.programa.anima) escena.manda('tecla Espacio'); });
  const [antes] = await parecido(p), imagen = await p.imagen();
  assert.ok(antes < 90, `sin hacer, coincide el ${antes} %`);

  const linea = await p.da(() => cm.getValue().split('\n').findIndex(l => editor.esMarca(l)) + 2);
  await p.escribe(linea, 'esto no compila;\n');
  await p.acaba('un error', linea => una('.linea-mala') && estado.textContent.includes(`línea ${linea}: `), linea);
  assert.deepEqual(await parecido(p), [antes, 'El shader tiene un error: la imagen es la de antes.']);
  assert.deepEqual(await p.imagen(), imagen);

  await resuelve(p, true);
  let [coincide, dicho] = await parecido(p);
  assert.deepEqual(await p.da(() => escena.errores), [], 'lo mal hecho compila');
  assert.ok(coincide < 99.9 || dicho.startsWith('Falta'), `lo mal hecho coincide el ${coincide} %: ${dicho}`);
  assert.equal(await resuelto(p, codigo), false);

  await resuelve(p);
  [coincide, dicho] = await parecido(p);
  assert.ok(coincide === 100 && dicho.startsWith('Resuelto'), `hecho, coincide el ${coincide} %: ${dicho}`);
  assert.ok(await resuelto(p, codigo));
  for (const i of await p.da(() => Object.keys(visto.programa.casos))) {
    await p.da(i => pagina.empiezaCaso(visto.programa.casos[i]), i);
    assert.equal((await parecido(p))[0], 100, `hecho, el caso ${i} es igual`);
  }
  await p.da(() => { for (const tecla of 'dv2+') escena.manda('tecla ' + tecla); });
  assert.equal((await parecido(p))[0], 100, 'y con las mismas teclas');
}]);

const ejercicios = {
  'los ejercicios resueltos se recuerdan, y en la lista se ve': async p => {
    await p.carga();
    const suyos = await p.da(() =>
      JSON.parse(una('#programas').textContent).flatMap(q => q.ejercicios.filter(e => !e.carpeta).map(e => e.codigo)));
    assert.deepEqual(suyos.sort(), CODIGOS.sort());
    await p.da(() => localStorage.setItem('resueltos', 'de_otra_clase')); // que no está en la página
    await empieza(p, 'L5.1');
    await resuelve(p);
    assert.match((await parecido(p))[1], /^Resuelto/);
    const cerrada = p.pagina;
    await p.estrena(await cerrada.browserContext().newPage());
    await p.pagina.goto(cerrada.url());
    await cerrada.close();
    await p.acaba('vuelve otro día', () => sesion?.vivo);
    assert.equal((await parecido(p))[0], 100, 'lo escrito sigue');
    await p.escribe(2, '// otra cosa\n');
    await p.acaba('lo escrito después no se ha mirado', () => !una('[data-coincide]'));
    await p.va('');
    await p.acaba('se ve', () => todos('.tarjetas .a-ejercicio').filter(a => a.textContent.endsWith('✓') &&
      /resuelto/.test(a.ariaLabel)).length === 1 && una('.cuenta').textContent.endsWith('resuelto 1'));
    await p.va('#sombreado');
    await p.acaba('y en su programa', () => todos('#programa .a-ejercicio').map(a => a.textContent).join() ===
      'Ejercicio L5.1 ✓,Ejercicio L5.2,Ejercicio L5.3');
    await p.va('#ejercicio/L99.1');
    await p.acaba('no está', () => una('#no-esta').textContent === 'No hay ningún ejercicio «L99.1».');
  },

  'la solución se ve y no se cambia; lo escrito se descarga y se borra': async p => {
    await empieza(p, 'L9.2');
    await p.escribe(1, '// lo mío\n');
    await p.pulsa('.tarea button', 'Ver la solución');
    await p.acaba('se ve', () => cm.getOption('readOnly') && /mix\(/.test(cm.getValue()) &&
      !/lo mío/.test(cm.getValue()));
    await p.pulsa('.tarea button', 'Volver a lo mío');
    await p.acaba('y lo de uno sigue', () => !cm.getOption('readOnly') && /lo mío/.test(cm.getValue()));
    await p.pulsa('.tarea button', 'Ver la solución');
    for (const otro of ['L9.1', 'L9.2']) {
      await p.va('#ejercicio/' + otro);
      await p.acaba(`viéndola se pasa a ${otro}`, otro => visto.ejercicio?.codigo === otro && editor.ruta &&
        !cm.getOption('readOnly') && conTexto('.tarea button', 'Ver la solución'), otro);
    }
    assert.deepEqual(await p.descarga('.descarga'), ['mezcla.frag', await p.da(() => cm.getValue())]);
    await p.da(() => todos('button', estado)[0].click());
    await p.acaba('se borra', () => !visto.taller.cambios.size && !/mix\(/.test(cm.getValue()));
    assert.ok((await parecido(p))[0] < 90);
  },

  'donde no se puede guardar nada, también se resuelve': async p => {
    await p.pagina.evaluateOnNewDocument(() => {
      for (const almacen of ['localStorage', 'sessionStorage'])
        Object.defineProperty(window, almacen, { get() { throw new DOMException('no', 'SecurityError'); } });
    });
    await empieza(p, 'L9.2');
    await resuelve(p);
    assert.match((await parecido(p))[1], /^Resuelto/);
    await p.exige('y se dice', () => una('a.a-ejercicio[href$="L9.2"]').textContent.endsWith('✓'));
  },
};

export const edicion = { ...cambios, ...Object.fromEntries(cadaUno), ...ejercicios };
