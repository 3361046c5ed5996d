// A qué lleva un enlace: #grua;tecla d;tecla d

/// Por su nombre o por lo que es en el libro: grua, E3.5.
export function programaDe(nombre, programas) {
  const n = nombre.toLowerCase();
  return programas.find(p => p.nombre === n)
    ?? programas.find(p => n && p.referencia.toLowerCase().split(' ').includes(n));
}

/// Los %XX; los que no son nada se quedan como están, y ya dirá quien los lea que no los entiende.
const descifra = texto => texto.replace(/(?:%[\da-f]{2})+/gi, cifrado => {
  try {
    return decodeURIComponent(cifrado);
  } catch {
    return cifrado;
  }
});

/// #grua;tecla d;tecla d. Sin punto y coma no lleva guion. Y #ejercicio/L5.1, que puede llevarlo.
export function leeEnlace(hash) {
  const [, ejercicio, nombre, guion] = descifra(hash.slice(1)).match(/^(ejercicio\/)?([^;]*)(?:;(.*))?$/s);
  return { ejercicio: Boolean(ejercicio), nombre, guion };
}

export function hazEnlace(nombre, ordenes) {
  const grupos = []; // las seguidas e iguales, con ×N
  for (const orden of ordenes) {
    if (grupos.at(-1)?.orden === orden && !orden.includes('×')) ++grupos.at(-1).veces;
    else grupos.push({ orden, veces: 1 });
  }
  const textos = grupos.map(({ orden, veces }) => veces > 1 ? `${orden} ×${veces}` : orden);
  return '#' + encodeURI([nombre, ...textos].join(';')).replaceAll('#', '%23');
}
