// Enseña un cuadro explicado, lo que da entrada.cpp con los ficheros y las miniaturas, en un elemento de la página.
const ANCHO = 480; // de la imagen grande, como mucho

function h(etiqueta, atributos = {}, ...dentro) {
  const elemento = document.createElement(etiqueta);
  for (const [clave, valor] of Object.entries(atributos))
    if (clave.startsWith('on')) elemento.addEventListener(clave.slice(2), valor);
    else if (valor !== false && valor !== undefined) elemento.setAttribute(clave, valor === true ? '' : valor);
  elemento.append(...dentro.flat().filter(d => d !== '' && d !== undefined && d !== null));
  return elemento;
}

/** Un número como se lee: sin más de `cifras` significativas. NaN e infinitos pueden venir como texto. */
export function cifra(numero, cifras = 4) {
  const raro = { nan: 'NaN', inf: '∞', infinity: '∞', '-inf': '−∞', '-infinity': '−∞' };
  if (!Number.isFinite(numero)) return raro[String(numero).toLowerCase().replace('-nan', 'nan')] ?? numero;
  return String(Number(numero.toPrecision(cifras))).replace('-', '−');
}

export function vector(numeros, cifras) {
  return numeros.length === 1 ? cifra(numeros[0], cifras) : `(${numeros.map(n => cifra(n, cifras)).join(', ')})`;
}

const enteros = color => vector(color.slice(0, 3).map(c => Math.round(c * 10) / 10), 6);

function muestra(color) { // de 0 a 255
  const [r, g, b] = color.map(c => (typeof c === 'number' ? Math.min(Math.max(c, 0), 255) : 0));
  return h('span', { class: 'muestra', style: `background: rgb(${r} ${g} ${b})` });
}

const conMuestra = color => (color ? h('span', { class: 'color' }, muestra(color), enteros(color)) : '');

/** «12 triángulos · liso.frag · mezcla». */
export function tituloDe(orden) {
  return [orden.titulo, orden.frag, ...orden.pruebas].filter(Boolean).join(' · ');
}

/** La línea del programa en que se llama a OpenGL, con su texto si se pide: «grua.cpp:64, dibuja → dibujaSuelo». */
function sitioDe({ sitio }, conTexto) {
  if (!sitio) return '';
  const texto = conTexto ? [': ', h('code', {}, sitio.texto)] : '';
  return h('span', { class: 'sitio', title: sitio.texto }, sitio.dice, texto);
}

function mezclaDe(mezcla) {
  if (!mezcla) return '';
  const veces = (factores, color) => {
    const f = factores.slice(0, 3);
    const factor = f.every(x => x === f[0]) ? cifra(f[0], 3) : vector(f, 3);
    return `${factor} · ${enteros(color.map(c => c * 255))}`;
  };
  const suma = mezcla.si
    ? `${veces(mezcla.factorOrigen, mezcla.origen)} + ${veces(mezcla.factorDestino, mezcla.destino)} =
      ${enteros(mezcla.suma)}`
    : '';
  return h('span', { class: 'mezcla' }, suma, mezcla.cuadra ? '' : h('b', { class: 'malo' }, ' no es lo que queda'));
}

const cambia = s => String(s.antes) !== String(s.despues);

/** Lo que pasa; con muestras en la ventana, lo que cubre una parte del píxel lo cambia sin llegar a su centro. */
function loQuePasa(s) {
  const enParte = s.color && s.despues && !s.mezcla;
  if (s.veredicto === 'escrito') return s.dice + (enParte ? ', en parte de sus muestras' : '');
  return s.tipo && cambia(s) ? `${s.dice}; y otra, que no llega a su centro, cambia parte de sus muestras` : s.dice;
}

const tabla = (clase, titulos, ...filas) => h('div', { class: 'tabla', tabindex: 0 }, h('table', { class: clase },
  h('thead', {}, h('tr', {}, titulos.map(texto => h('th', {}, texto)))), h('tbody', {}, ...filas)));

/** «triángulo 11.º»: el primero es el 1.º; de un punto, también su gl_VertexID, que se cuenta desde 0. */
function primitivaDe({ tipo, primitiva, vertices }) {
  const numero = vertices?.length === 1 ? ` (gl_VertexID ${vertices[0]})` : '';
  return tipo ? `${tipo} ${primitiva + 1}.º${numero}` : '';
}

function historia(datos, elige) {
  const ordenes = new Map(datos.ordenes.map(o => [o.n, o]));
  const fila = suceso => {
    const orden = ordenes.get(suceso.orden);
    const color = suceso.color?.map(c => (typeof c === 'number' ? c * 255 : c));
    return h('tr', { class: suceso.veredicto },
      h('td', {}, h('button', { title: 'La orden, más abajo', onclick: () => elige(suceso.orden, true) },
        suceso.orden)), h('td', {}, tituloDe(orden), sitioDe(orden)), h('td', {}, primitivaDe(suceso)),
      h('td', {}, color ? h('span', { class: 'color' }, muestra(color), vector(suceso.color.slice(0, 4), 3)) : ''),
      h('td', {}, suceso.profundidad === undefined ? '' : cifra(suceso.profundidad, 6)),
      h('td', {}, loQuePasa(suceso), mezclaDe(suceso.mezcla)),
      h('td', {}, suceso.veredicto === 'escrito' || cambia(suceso) ? conMuestra(suceso.despues) : ''));
  };
  const cabecera = ['orden', '', '', 'da el shader', 'profundidad', 'qué pasa', 'queda'];
  return tabla('historia sucesos', cabecera, datos.historia.map(fila));
}

/** Lo que habría estado ahí si no fuera por una prueba, de más cerca a más lejos; si nada, qué órdenes no dibujan. */
function loQueFalta(datos) {
  const ordenes = new Map(datos.ordenes.map(o => [o.n, o]));
  const habria = datos.historia.filter(s => s.soloEsa).sort((a, b) => (a.profundidad ?? 1) - (b.profundidad ?? 1));
  const quien = s => `${primitivaDe(s)} de la orden ${s.orden}, ${tituloDe(ordenes.get(s.orden))}: ${s.dice}`;
  const nada = datos.ordenes.filter(o => o.nada).map(o => `${o.n} · ${tituloDe(o)}: ${o.nada}`);
  const [titulo, filas] = habria.length
    ? ['Lo que no se ve por una sola prueba, de más cerca a más lejos', habria.map(quien)]
    : ['Las órdenes que no dibujan nada', nada];
  return filas.length ? [h('h2', {}, titulo), h('ul', {}, filas.slice(0, 12).map(f => h('li', {}, f)))] : [];
}

const noNumero = valores => !valores.every(Number.isFinite);

function valorDe({ tipo, valor }) {
  const matriz = /^mat(\d)(?:x(\d))?$/.exec(tipo);
  if (!valor.length) return 'no se sabe';
  const escrito = tipo === 'bool' ? (valor[0] ? 'sí' : 'no') : vector(valor);
  if (!matriz) return h('span', { class: noNumero(valor) ? 'malo' : '' }, escrito);
  const columnas = Number(matriz[1]), filas = valor.length / columnas;
  return h('table', { class: 'matriz' }, Array.from({ length: filas }, (_, f) =>
    h('tr', {}, Array.from({ length: columnas }, (_, c) => h('td', {}, cifra(valor[c * filas + f]))))));
}

const ESCRITO = { entra: 'se entra', vuelve: 'se vuelve', descarta: 'discard', caso: 'este caso' };

/** Lo que se lee de una textura: con qué filtro, de qué niveles y de qué texels, con lo que pesa cada uno. */
function lecturaDe({ escrito, coordenadas, motivo, filtro, lambda, niveles, texels, suma, valor, cara, seguido }) {
  if (motivo) return h('p', {}, h('i', {}, `${escrito}: ${motivo}`));
  const deNivel = n => `nivel ${n.nivel}${n.peso < 1 ? ` · ${cifra(n.peso, 3)}` : ''}`;
  const color = (v, cifras) => [muestra(v.map(c => 255 * c)), vector(v, cifras)];
  const fila = t => h('tr', {}, h('td', {}, t.nivel), h('td', {}, vector(t.texel)), h('td', {}, cifra(t.peso, 3)),
    h('td', {}, color(t.color, 3)));
  const como = `${cara && `cara ${cara}, `}${filtro}, λ = ${cifra(lambda, 3)}: `;
  return h('details', { class: 'lectura' }, h('summary', {}, como,
    niveles.map(deNivel).join(' + ')),
  h('p', {}, `${escrito}, en ${vector(coordenadas)}. Un píxel abarca 2^λ texels: si λ no es positiva, se amplía.`),
  h('table', {}, h('tr', {}, ['nivel', 'texel', 'pesa', ''].map(t => h('th', {}, t))), texels.map(fila)),
  h('p', {}, 'suman ', color(suma, 4), '; se ha leído ', color(valor, 4)),
  seguido ? h('p', {}, `Se pinta en el framebuffer ${seguido.framebuffer}: `,
    h('a', { href: `#${idDe(seguido)}` }, `por qué el texel ${vector(seguido.pixel)} tiene ese color`)) : '');
}

const idDe = ({ lee, textura }) => `texel-${lee}-${textura}`;

/** Los texels de las texturas que se pintan en el mismo cuadro, cada uno explicado como el píxel. */
function texelsDe(datos, elige) {
  return (datos.texels ?? []).flatMap(texel => [
    h('h2', { id: idDe(texel) }, `El texel ${vector(texel.pixel)} que lee la orden ${texel.lee}, en el framebuffer ` +
      texel.framebuffer), h('p', {}, 'Queda de color ', conMuestra(texel.color), '.'),
    historia({ ...datos, ...texel }, elige), ...sombreadoDe({ ...datos, ...texel })]);
}

/** Cada línea de un shader y, a su lado, lo que vale lo que se calcula en ella; en gris, las que no se ejecutan. */
function fuenteDe(fuente, traza, lecturas = []) {
  const pasa = new Map(fuente.map((_, i) => [i + 1, []]));
  const veces = {}; // de cada función, las que se ha entrado
  for (const l of traza.lineas) {
    if (l.clase === 'entra') veces[l.funcion] = (veces[l.funcion] ?? 0) + 1;
    pasa.get(l.en)?.push({ ...l, vez: veces[l.funcion] });
  }
  const podia = new Set(traza.apuntables), perdidas = new Map(traza.sinSeguir.map(a => [a.en, a.motivo]));
  const primera = traza.lineas.find(l => noNumero(l.valor));
  const principal = fuente.at(-1)?.fichero;
  let fichero, plegadas;
  const filas = fuente.flatMap((linea, i) => {
    const suyas = pasa.get(i + 1), dichas = suyas.filter(l => l.valor.length || ESCRITO[l.clase]).slice(0, 12);
    const clase = primera && primera.en === i + 1 ? 'rara' : podia.has(i + 1) && !suyas.length ? 'no-se-ejecuta' : '';
    const valores = dichas.map(l => h('span', { class: 'apunte' }, veces[l.funcion] > 1 ? `${l.vez}.ª vez: ` : '',
      ESCRITO[l.clase] ?? [`${l.nombre} = `, valorDe(l)]));
    const mas = suyas.length > 12 ? ` … ${suyas.length} en total` : '';
    const perdida = perdidas.has(i + 1) ? h('i', {}, `no sé seguir esta línea: ${perdidas.get(i + 1)}`) : '';
    const texto = h('td', {}, h('code', {}, linea.texto));
    const numero = h('td', { class: 'numero' }, linea.linea);
    const leido = lecturas.filter(l => l.en === i + 1).slice(0, 4).map(lecturaDe);
    const fila = h('tr', { class: clase }, numero, texto, h('td', {}, valores, mas, perdida, leido));
    const empieza = linea.fichero !== fichero;
    fichero = linea.fichero;
    if (empieza) plegadas = fichero === principal ? undefined : [];
    fila.hidden = Boolean(plegadas) && /^\s*(\/\/.*)?$/.test(linea.texto); // la cabecera de una biblioteca
    if (fila.hidden) plegadas.push(fila);
    else plegadas = undefined;
    if (!empieza) return [fila];
    const suCabecera = plegadas, abre = () => { for (const f of suCabecera) f.hidden = !f.hidden; };
    return [h('tr', {}, h('th', { colspan: 3 }, fichero,
      suCabecera ? h('button', { title: 'Lo que dice su cabecera', onclick: abre }, '…') : '')), fila];
  });
  return h('div', { class: 'tabla', tabindex: 0 }, h('table', { class: 'fuente' }, h('tbody', {}, filas)));
}

function interpolacion(sombreado) {
  const salidas = vertice => new Map(vertice.lineas.filter(l => l.clase === 'salida').map(l => [l.nombre, l]));
  const suyas = sombreado.vertices.map(salidas);
  const nombres = [...(suyas[0]?.keys() ?? [])];
  const titulos = ['', ...sombreado.vertices.map(v => `gl_VertexID ${v.indice}`), 'en el píxel'];
  const peso = (titulo, pesos) => pesos && h('tr', {}, h('th', {}, titulo), pesos.map(p => h('td', {}, cifra(p))),
    h('td'));
  const fila = nombre => {
    const entrada = sombreado.entradas?.find(e => e.nombre === nombre);
    return h('tr', {}, h('th', {}, h('code', {}, nombre)),
      suyas.map(s => h('td', {}, s.has(nombre) ? valorDe(s.get(nombre)) : '')),
      h('td', {}, entrada ? vector(entrada.valor) : ''));
  };
  const pesos = [peso('lo que pesa', sombreado.pesos), peso('sin perspectiva', sombreado.pesosSinPerspectiva)];
  return tabla('historia', titulos, nombres.map(fila), pesos);
}

function sombreadoDe(datos) {
  const { sombreado } = datos;
  if (!sombreado?.fragmento) return [];
  const { programa } = datos.ordenes.find(o => o.n === sombreado.orden);
  const suyo = datos.programas.find(p => p.programa === programa);
  const lecturas = (sombreado.lecturas ?? []).map(l =>
    ({ ...l, seguido: datos.texels?.find(t => t.textura === l.textura && t.lee === sombreado.orden) }));
  const partes = [];
  if (sombreado.vertices.length) {
    const [primero] = sombreado.vertices;
    const titulo = h('summary', {}, `El vertex shader en el vértice con gl_VertexID ${primero.indice}`);
    partes.push(h('h2', {}, 'Sus vértices, y lo que llega al píxel'), interpolacion(sombreado),
      h('details', {}, titulo, fuenteDe(suyo.vert, primero)));
  }
  const { motivo } = sombreado.fragmento;
  partes.push(h('h2', {}, 'El shader que le da el color, línea a línea'),
    motivo ? h('p', { class: 'malo' }, motivo) : '', fuenteDe(suyo.frag, sombreado.fragmento, lecturas));
  return partes;
}

const LADO = 260; // de cada lienzo de una malla
const CUBO = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6]].map(cara =>
  cara.map(i => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]));

/** Puntos en una caja de −1 a 1 alrededor de su centro. */
function centrados(puntos) {
  const ejes = [0, 1, 2].map(k => puntos.map(p => p[k]));
  const [a, b] = [Math.min, Math.max].map(f => ejes.map(e => f(...e)));
  const radio = Math.max(...a.map((_, k) => (b[k] - a[k]) / 2)) || 1;
  return puntos.map(p => p.map((v, k) => (v - (a[k] + b[k]) / 2) / radio));
}

/** Lo que de un polígono queda delante de la cámara, donde w pasa de un mínimo, y dividido por ella; z, hacia aquí. */
function delante(poligono, minimo) {
  const salen = poligono.flatMap((p, i) => {
    const q = poligono[(i + 1) % poligono.length], t = (minimo - p[3]) / (q[3] - p[3]);
    const corte = (p[3] > minimo) === (q[3] > minimo) ? [] : [p.map((v, k) => v + t * (q[k] - v))];
    return p[3] > minimo ? [p, ...corte] : corte;
  });
  return salen.map(([x, y, z, w]) => [x / w, y / w, -z / w]);
}

/** La malla de la orden antes y después del vertex shader, con el triángulo del píxel; se gira arrastrando. */
function mallaDe({ malla, primitiva }) {
  if (!malla?.antes) return [];
  const deTres = puntos => Array.from({ length: malla.triangulos.length / 3 }, (_, t) =>
    malla.triangulos.slice(3 * t, 3 * t + 3).map(i => puntos[i]));
  const minimo = 1e-3 * Math.max(...malla.despues.map(p => Math.abs(p[3])).filter(Number.isFinite));
  const vistas = [['como está en el array', deTres(centrados(malla.antes)), [], [0.5, -0.6]],
    ['después del vertex shader, dividida por w: se ve lo que cae en el cubo; recortada, la de detrás de la cámara',
      deTres(malla.despues).map(p => delante(p, minimo)), CUBO, [0, 0]]];
  return [h('h2', {}, 'La malla de esa orden'), h('div', { class: 'mallas' },
    vistas.map(vista => unaMalla(primitiva, vista)))];
}

function unaMalla(primitiva, [texto, poligonos, cubo, giro]) {
  const lienzo = h('canvas', { width: 2 * LADO, height: 2 * LADO, title: 'Se gira arrastrando' });
  const aqui = ([x, y, z]) => {
    const [[ca, sa], [cb, sb]] = giro.map(g => [Math.cos(g), Math.sin(g)]);
    const [u, v] = [ca * x + sa * z, cb * y + sb * (sa * x - ca * z)];
    return [LADO + 0.6 * LADO * u, LADO - 0.6 * LADO * v];
  };
  const pinta = () => {
    const c = lienzo.getContext('2d'), color = getComputedStyle(lienzo).color;
    c.clearRect(0, 0, 2 * LADO, 2 * LADO);
    const traza = puntos => {
      c.beginPath();
      for (const p of puntos) c.lineTo(...aqui(p));
      c.closePath();
      c.stroke();
    };
    c.strokeStyle = color;
    c.globalAlpha = 0.7;
    for (const cara of cubo) traza(cara);
    for (const [t, poligono] of poligonos.entries()) {
      if (!poligono.length || !poligono.flat().every(Number.isFinite)) continue;
      c.globalAlpha = 0.25;
      traza(poligono);
      c.globalAlpha = 1;
      c.fillStyle = '#f08c00';
      if (t === primitiva) c.fill();
    }
  };
  lienzo.addEventListener('pointermove', e => {
    if (!e.buttons) return;
    giro[0] += 0.01 * e.movementX;
    giro[1] -= 0.01 * e.movementY;
    pinta();
  });
  lienzo.addEventListener('pointerdown', e => lienzo.setPointerCapture(e.pointerId));
  requestAnimationFrame(pinta);
  return h('figure', {}, lienzo, h('figcaption', {}, texto));
}

/** La última imagen de ese framebuffer hasta esa orden, por si ella no lo cambia. */
function ultima(ordenes, hasta, que) {
  const suyas = ordenes.slice(0, hasta + 1).filter(o => o.framebuffer === ordenes[hasta].framebuffer && o[que]);
  return suyas.at(-1)?.[que];
}

function lamina(src, texto, marcas) {
  const imagen = h('div', { class: 'lamina' }, h('img', { src, alt: texto }), marcas);
  return h('figure', {}, imagen, h('figcaption', {}, texto));
}

/** Un rectángulo o un punto, en tantos por ciento de la imagen. */
function marca(clase, [x, y, ancho, alto], [total, filas]) {
  const p = (parte, todo) => `${100 * parte / todo}%`;
  return h('i', { class: clase,
    style: `left: ${p(x, total)}; top: ${p(y, filas)}; width: ${p(ancho, total)}; height: ${p(alto, filas)}` });
}

function estadoDe(orden, anterior) {
  const antes = new Map((anterior?.estado ?? []).map(e => [e.nombre, e.valor]));
  return h('dl', { class: 'puesto' }, orden.estado.map(({ nombre, valor }) => {
    const cambia = anterior && antes.get(nombre) !== valor;
    const clase = cambia ? 'cambia' : valor === 'no' ? 'apagado' : '';
    return [h('dt', {}, h('code', {}, nombre)), h('dd', { class: clase }, valor)];
  }).flat());
}

/** Las líneas que van de cada elemento a otro, [de, a, clase], en la caja en que están; se trazan otra vez si cambia de
 *  forma. */
function conLineas(caja, pares) {
  const svg = (nombre, atributos) => {
    const elemento = document.createElementNS('http://www.w3.org/2000/svg', nombre);
    for (const [clave, valor] of Object.entries(atributos)) elemento.setAttribute(clave, valor);
    return elemento;
  };
  const dibujo = svg('svg', { 'aria-hidden': true });
  caja.append(dibujo);
  new ResizeObserver(() => {
    const { left, top } = caja.getBoundingClientRect();
    dibujo.replaceChildren(...pares.map(([de, a, clase]) => {
      const [x0, x1] = [[de, 'right'], [a, 'left']].map(([fila, lado]) => fila.closest('section')
        .getBoundingClientRect()[lado] - left), medio = (x0 + x1) / 2;
      const [y0, y1] = [de, a].map(fila => fila.getBoundingClientRect()).map(r => (r.top + r.bottom) / 2 - top);
      return svg('path', { class: clase, d: `M ${x0} ${y0} C ${medio} ${y0} ${medio} ${y1} ${x1} ${y1}` });
    }));
  }).observe(caja);
  return caja;
}

const deAtributo = a => (a.activo
  ? `${a.componentes} ${a.de} cada ${a.paso} bytes desde el ${a.desplazamiento}; ` +
    a.primeros.map(v => vector(v.slice(0, a.componentes), 3)).join(' ')
  : 'ningún array');
const deTextura = (t, pinta) => [`${t.objetivo} ${t.talla.join('×')} ${t.formato}`,
  [t.reduce, t.amplia].filter(Boolean).join(', '), t.repite, t.incompleta,
  pinta && `la pinta la orden ${pinta.n}, en el ${pinta.framebuffer}`].filter(Boolean).join('; ');

/** Lo que le llega a una orden: de cada caja, su título y sus filas, con el nombre que tiene en los shaders. */
function fuentesDe({ n, cableado: { atributos, uniformes, texturas, vao } }, ordenes) {
  const quienPinta = t => ordenes.findLast(o => o.n < n && o.pinta && o.pinta === t.textura);
  const filas = (lista, nombre, dice, falta) => lista.map(cosa =>
    ({ nombre: cosa[nombre], dice: dice(cosa), falta: falta(cosa), sitio: cosa.sitio }));
  const caja = (titulo, lista) => ({ titulo, filas: lista });
  const deBufer = bufer => caja(bufer ? `VAO ${vao} · buffer ${bufer}` : `VAO ${vao} · sin buffer`, filas(
    atributos.filter(a => (a.activo ? a.bufer : 0) === bufer), 'nombre', deAtributo, a => !a.activo));
  return [
    ...[...new Set(atributos.map(a => (a.activo ? a.bufer : 0)))].map(deBufer),
    caja('Uniforms', filas(uniformes.filter(u => !texturas.some(t => t.sampler === u.nombre)), 'nombre',
      u => `${u.tipo} ${u.dado ? vector(u.valor, 3) : 'sin valor'}`, u => !u.dado)),
    ...texturas.map(t => caja(`Unidad ${t.unidad} · textura ${t.textura}`,
      filas([t], 'sampler', () => deTextura(t, quienPinta(t)), () => Boolean(t.incompleta)))),
  ].filter(({ filas: suyas }) => suyas.length);
}

/** De dónde le llega a una orden lo que dibuja y a qué shader, con una línea de cada cosa al que la usa; en negrita, lo
 *  que no era así en la orden anterior. */
function cableadoDe(orden, anterior, { programas, ordenes }) {
  const programa = programas.find(p => p.programa === orden.programa);
  const antes = new Map(anterior?.cableado
    ? fuentesDe(anterior, ordenes).flatMap(({ titulo, filas }) => filas.map(f => [f.nombre, titulo + f.dice])) : []);
  const usa = (etapa, nombre) => (programa?.[etapa] ?? []).some(({ texto }) =>
    new RegExp(`\\b${nombre.match(/^\w+/)[0]}\\b`).test(texto.replace(/\/\/.*/, '')));
  const pares = [], shaders = [['vert', 'Vertex shader'], ['frag', 'Fragment shader']].map(([etapa, titulo]) =>
    ({ etapa, titulo, filas: [] }));
  const izquierda = fuentesDe(orden, ordenes).map(({ titulo, filas }) => h('section', {}, h('h4', {}, titulo),
    h('ul', {}, filas.map(({ nombre, dice, falta, sitio }) => {
      const clase = falta ? 'malo' : antes.size && antes.get(nombre) !== titulo + dice ? 'cambia' : '';
      const fila = h('li', {}, h('code', {}, nombre), ' ', h('span', { class: clase }, dice), sitioDe({ sitio }));
      for (const shader of shaders.filter(({ etapa }) => usa(etapa, nombre))) {
        const suya = h('li', {}, h('code', {}, nombre));
        shader.filas.push(suya);
        pares.push([fila, suya, clase]);
      }
      return fila;
    }))));
  const derecha = shaders.map(({ etapa, titulo, filas }) => h('section', {}, h('h4', {}, titulo),
    h('p', {}, h('code', {}, programa?.[etapa].at(-1)?.fichero.split('/').pop() ?? '')), h('ul', {}, filas)));
  const sale = h('section', {}, h('h4', {}, 'Sale'), h('p', {}, [orden.framebuffer, ...orden.pruebas].join(' · ')));
  return conLineas(h('div', { class: 'cableado' }, h('div', {}, izquierda), h('div', {}, derecha, sale)), pares);
}

function detalle(datos, indice) {
  const orden = datos.ordenes[indice];
  const anterior = datos.ordenes.slice(0, indice).reverse().find(o => o.estado.length);
  const laminas = [];
  const color = ultima(datos.ordenes, indice, 'miniatura');
  if (color) {
    const marcas = [];
    if (orden.donde) marcas.push(marca('rectangulo', orden.donde, orden.talla));
    const aqui = datos.pixel && orden.framebuffer === 'la ventana';
    if (aqui) marcas.push(marca('pixel', [...datos.pixel, 1, 1], orden.talla));
    laminas.push(lamina(color, orden.cambian ? `color: cambian ${orden.cambian} píxeles` : 'color: no cambia', marcas));
  }
  for (const que of ['profundidad', 'plantilla']) {
    const imagen = ultima(datos.ordenes, indice, que);
    if (imagen) laminas.push(lamina(imagen, orden[que] ? que : `${que}: no cambia`));
  }
  const cuantos = orden.fragmentos >= 0 ? `, ${orden.fragmentos} fragmentos escritos` : '';
  return [h('h3', {}, `${orden.n} · ${tituloDe(orden)}`),
    h('p', {}, h('code', {}, orden.llamada), `, en ${orden.framebuffer}${cuantos}. `, sitioDe(orden, true)),
    h('div', { class: 'laminas' }, laminas), orden.estado.length ? estadoDe(orden, anterior) : '',
    orden.cableado ? cableadoDe(orden, anterior, datos) : ''];
}

function ordenesDe(datos) {
  const sitio = h('section', { class: 'una-orden' }), tira = h('ol', { class: 'tira' });
  const mando = h('input', { type: 'range', min: 0, max: datos.ordenes.length - 1, 'aria-label': 'Orden',
    oninput: () => elige(datos.ordenes[mando.value].n) });
  const elige = (n, llevaAlli) => {
    const indice = datos.ordenes.findIndex(o => o.n === n);
    mando.value = indice;
    sitio.replaceChildren(...detalle(datos, indice));
    for (const [i, li] of [...tira.children].entries()) li.classList.toggle('elegida', i === indice);
    const li = tira.children[indice]; // sin mover la página
    if (llevaAlli) sitio.scrollIntoView({ block: 'start' });
    tira.scrollTop += li.getBoundingClientRect().top - tira.getBoundingClientRect().top - tira.clientHeight / 3;
  };
  const enHistoria = new Set(datos.historia.map(s => s.orden));
  tira.append(...datos.ordenes.map((o, i) => h('li', { class: enHistoria.has(o.n) ? 'toca' : '' },
    h('button', { onclick: () => elige(o.n) },
      o.miniatura ? h('img', { src: ultima(datos.ordenes, i, 'miniatura'), alt: '' }) : '',
      h('span', {}, `${o.n} · ${tituloDe(o)}`, sitioDe(o))))));
  return { elige, elemento: h('div', { class: 'ordenes' }, h('div', {}, mando, tira), sitio) };
}

/** De la historia, lo que le da el color: lo último que se escribe en la ventana, si no lo deja como estaba. */
function quienGana({ historia, sombreado }) {
  const { orden, primitiva } = sombreado ?? {};
  return historia.findLast(s => s.orden === orden && s.primitiva === primitiva && !s.framebuffer) ??
    historia.findLast(s => s.veredicto === 'escrito' && !s.framebuffer);
}

function resumen(datos, conImagen) {
  const final = datos.ordenes.filter(o => o.framebuffer === 'la ventana' && o.miniatura).at(-1);
  const partes = [];
  if (datos.sospechas.length)
    partes.push(h('ul', { class: 'sospechas' }, datos.sospechas.map(s => h('li', {}, `${s.dice}. ${s.prueba} `,
      sitioDe(s.sitio ? s : datos.ordenes.find(o => o.n === s.orden) ?? {}, true)))));
  if (!datos.pixel) return partes;
  const ultimo = quienGana(datos), orden = ultimo && datos.ordenes.find(o => o.n === ultimo.orden);
  const suya = ultimo?.tipo ? `el ${primitivaDe(ultimo)} de ` : '';
  const quien = orden && `${suya}la orden ${orden.n}, ${tituloDe(orden)}`;
  const desde = orden?.sitio ? [', en ', sitioDe(orden, true)] : [];
  const marcas = marca('pixel', [...datos.pixel, 1, 1], datos.talla);
  const cuadro = final && lamina(final.miniatura, 'El cuadro, y el píxel', marcas);
  if (cuadro && conImagen) partes.push(h('div', { style: `max-width: ${ANCHO}px` }, cuadro));
  const ajeno = datos.historia.findLast(s => !s.framebuffer)?.veredicto === 'ajeno';
  const despues = `. Después lo ha cambiado algo que no sigo: en un borde, y con muestras en la ventana
    (GLUT_MULTISAMPLE), lo que cubre una parte del píxel sin llegar a su centro, y su color es una mezcla.`;
  const dado = !quien ? ['.'] : ajeno ? [`. Lo último que sigo en él es ${quien}`, ...desde, despues]
    : [` y se lo ha dado ${quien}`, ...desde, '.'];
  partes.push(h('p', { class: 'dice' }, 'El píxel es ', conMuestra(datos.color), ...dado));
  return partes;
}

/** En `contenedor`, el cuadro entero; con `datos.pixel`, además, su historia. Con `conImagen`, dónde está el píxel. */
export function muestraCuadro(datos, contenedor, { conImagen = true } = {}) {
  if (!datos.ordenes.length) return contenedor.replaceChildren(h('p', {}, 'Este cuadro no dibuja ni borra nada.'));
  const { elige, elemento } = ordenesDe(datos);
  const partes = resumen(datos, conImagen);
  const titulo = 'La historia del píxel', borra = s => s.dice === 'borrado';
  const veces = datos.historia?.filter(s => s.veredicto === 'escrito' && !borra(s)).length;
  if (datos.pixel) partes.push(h('h2', {}, veces > 2 ? `${titulo}: escrito ${veces} veces` : titulo),
    historia(datos, elige), ...loQueFalta(datos),
    ...sombreadoDe(datos), ...mallaDe(datos.sombreado ?? {}), ...texelsDe(datos, elige));
  partes.push(h('h2', {}, 'El cuadro, orden a orden'), elemento);
  if (typeof datos.veces?.imagen === 'string') partes.push(h('div', { style: `max-width: ${ANCHO}px` },
    lamina(datos.veces.imagen, `Cuántas órdenes cambian cada píxel: en blanco, ${datos.veces.maximo}`)));
  contenedor.classList.add('cuadro-explicado');
  contenedor.replaceChildren(...partes);
  elige(quienGana(datos)?.orden ?? datos.ordenes.at(-1).n);
}
