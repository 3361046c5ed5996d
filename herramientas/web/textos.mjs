// Textos: cortarlos y buscar en ellos.

export const corta = (texto, letras) => texto.length > letras ? texto.slice(0, letras) + '…' : texto;

/// Sin acentos ni mayúsculas.
export const llano = texto => texto.normalize('NFD').replace(/[\u0300-\u036f]/g, '').toLowerCase();

/// Si ese contenido, que ya es llano, tiene todas las palabras.
export const casa = (contenido, buscado) => llano(buscado).split(/\s+/).every(palabra => contenido.includes(palabra));

/// El de un fichero, sin nada que estorbe en una ruta.
export const nombreLlano = nombre => nombre.replace(/[^\w.-]/g, '_');
