// Textos: cortarlos y quitarles lo que estorba.

export const corta = (texto, letras) => texto.length > letras ? texto.slice(0, letras) + '…' : texto;

/// El de un fichero, sin nada que estorbe en una ruta.
export const nombreLlano = nombre => nombre.replace(/[^\w.-]/g, '_');
