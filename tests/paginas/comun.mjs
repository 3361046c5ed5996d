// Lo que se pregunta a las dos páginas: el buscador, los botones de copiar y de quién son las teclas.
import assert from 'node:assert/strict';

/// Lo que se escribe en el buscador sale, e Intro lleva a lo primero; con ↓ se pasa por todo, y Esc lo deja. Qué debe
/// salir de cada cosa lo pregunta partes.mjs.
export async function seBusca(p) {
  const enfoca = () => p.da(() => una('input[type=search]').focus()); // ir a un enlace lo quita, cuando le parece
  const escribe = texto => p.da(texto => {
    const campo = una('input[type=search]');
    campo.focus();
    campo.value = texto;
    campo.dispatchEvent(new Event('input'));
  }, texto);
  for (const [buscado, enlace] of [['STENCIL', 'espejo_plantilla'], ['listado 5.1', 'L5.1']]) {
    await escribe(buscado);
    await p.acaba(`«${buscado}» sale, y dónde`, enlace => una('.hallazgos a')?.hash === `#${enlace}` &&
      todos('.donde').every(d => d.textContent.trim().length > 2), enlace);
    await enfoca();
    await p.teclas('Enter');
    await p.acaba('Intro lleva al primero', enlace => location.hash === `#${enlace}` && una('.hallazgos').hidden,
      enlace);
  }
  await escribe('textura');
  await p.acaba('de muchos se enseñan doce', () => todos('.hallazgos a').length === 12);
  const pasa = [];
  await enfoca();
  for (let i = 0; i < 13; ++i) {
    await p.teclas('ArrowDown');
    pasa.push(await p.da(() => todos('.hallazgos a').indexOf(document.activeElement)));
  }
  assert.deepEqual(pasa, [...Array(12).keys(), -1], 'con las flechas se pasa por todos y se vuelve');
  await p.teclas('ArrowUp', 'Escape');
  await p.exige('Esc lo deja', () => una('.hallazgos').hidden && !una('input[type=search]').value);
  await escribe('xyzzy');
  await p.acaba('de lo que no hay se dice', () => /Nada/.test(una('.cuantos').textContent));
  await escribe('');
  await p.acaba('y sin nada, nada', () => !una('.cuantos').textContent);
}

/// Cada botón de copiar copia lo que tiene al lado o, donde no se puede, lo selecciona.
export async function seCopia(p) {
  const [cuantos, mal] = await p.da(async () => {
    const mal = [], botones = todos('.copia').filter(b => b.offsetParent);
    let copiado;
    for (const deja of [true, false]) {
      Object.defineProperty(navigator, 'clipboard', { configurable: true, value: { writeText: async texto => {
        if (!deja) throw new Error('no');
        copiado = texto;
      } } });
      for (const b of botones) {
        copiado = '';
        getSelection().removeAllRanges();
        b.click();
        await new Promise(hecho => setTimeout(hecho));
        const texto = deja ? copiado : String(getSelection()), debe = b.ariaLabel.replace('Copiar ', '');
        if (texto !== debe || !texto.startsWith('./lab ')) mal.push([texto, debe]);
      }
    }
    return [botones.length, mal];
  });
  assert.ok(cuantos);
  assert.deepEqual(mal, []);
  await p.acaba('y vuelven a decirlo', () => todos('.copia').every(b => b.textContent === 'Copiar'));
}

/// Las que llevan Ctrl, Alt o Meta son del navegador, esté donde esté el foco.
export async function sonDelNavegador(p, selector = 'body', con = ['ctrlKey', 'altKey', 'metaKey']) {
  assert.deepEqual(await p.da((selector, con) => {
    const teclas = [...'abcdefghijklmnopqrstuvwxyz0123456789+-/. ', 'Enter', 'PageDown', 'Home', 'Escape', 'ArrowLeft',
      'F1', 'F5', 'F11'];
    return con.flatMap(con => teclas.filter(key => !una(selector)
      .dispatchEvent(new KeyboardEvent('keydown', { key, [con]: true, bubbles: true, cancelable: true }))));
  }, selector, con), []);
  await p.exige('ninguna ha abierto nada', () => !document.fullscreenElement && !una('dialog[open]'));
}
