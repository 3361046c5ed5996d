// El buscador de las dos páginas: lo que se escribe en él y la lista de lo hallado, que dice dónde.
import { crea, enCampo, esDelNavegador, todos, una } from './documento.mjs';
import { Indice, trozo } from './busca.mjs';

const MUCHOS = 12; // los que se enseñan
const caja = una('.buscador'), campo = una('input', caja);
const lista = una('.hallazgos', caja), cuenta = una('.cuantos', caja);

function fichaDe({ titulo, enlace, clase, texto, palabra }, buscado) {
  const [antes, hallado, despues] = trozo(texto, buscado);
  const donde = palabra ? [crea('mark', { textContent: palabra }), ` en ${texto}`]
    : clase === 'título' ? ['en el título'] : [`${clase}: `, antes, crea('mark', { textContent: hallado }), despues];
  return crea('li', {}, crea('a', { href: `#${enlace}` },
    crea('b', { textContent: titulo }), crea('span', { className: 'donde' }, ...donde)));
}

function ponHallados(hallados, buscado) {
  lista.replaceChildren(...hallados.slice(0, MUCHOS).map(h => fichaDe(h, buscado)));
  lista.hidden = !hallados.length;
  cuenta.textContent = !buscado.trim() ? '' : !hallados.length ? 'Nada coincide con lo que buscas.'
    : hallados[0].leFalta ? 'Nada tiene todas las palabras; esto, casi'
    : hallados.length > MUCHOS ? `Los ${MUCHOS} mejores de ${hallados.length}` : '';
}

function esconde() {
  lista.hidden = true;
  cuenta.textContent = '';
}

/// `trae()` promete los datos del índice, y se llama la primera vez que se busca.
export function atiendeBuscador(trae) {
  let indice;
  const busca = async () => {
    const buscado = campo.value;
    indice ??= trae().then(datos => new Indice(datos));
    const hallados = (await indice).busca(buscado);
    const yaPasa = lista.contains(document.activeElement); // por lo hallado: se le iría el foco
    if (campo.value === buscado && !yaPasa) ponHallados(hallados, buscado);
  };
  campo.addEventListener('input', busca);
  campo.addEventListener('focus', () => { if (campo.value.trim()) busca(); });
  document.addEventListener('click', ({ target }) => {
    if (target.closest('.hallazgos a') || !caja.contains(target)) esconde();
  });
  caja.addEventListener('keydown', async suceso => {
    if (suceso.key !== 'Enter' || document.activeElement !== campo) return anda(suceso);
    await busca(); // lo hallado aún puede estar por llegar
    una('a', lista)?.click();
  });
  document.addEventListener('keydown', suceso => {
    const deOtro = enCampo(suceso) || suceso.target.closest('dialog') || document.fullscreenElement;
    if (suceso.key !== '/' || esDelNavegador(suceso) || deOtro) return;
    suceso.preventDefault();
    campo.focus();
  });
}

/// ↑ y ↓ pasan por lo hallado, y Esc lo deja.
function anda(suceso) {
  const paradas = [campo, ...lista.hidden ? [] : todos('a', lista)], donde = paradas.indexOf(document.activeElement);
  const paso = { ArrowDown: 1, ArrowUp: -1 }[suceso.key];
  if (paso && donde >= 0) {
    suceso.preventDefault();
    paradas[(donde + paso + paradas.length) % paradas.length].focus();
  } else if (suceso.key === 'Escape') {
    campo.value = '';
    esconde();
    campo.blur();
  }
}
