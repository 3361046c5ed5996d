// De qué fichero es cada línea de un shader que se ha compilado con sus #include en su sitio.

/// Las líneas de un shader con sus #include en su sitio, como las da common/shader.cpp: { fichero, linea, texto }.
export function conInclusiones(ruta, textos, pila = []) {
  const todo = textos[ruta].replace(/^\ufeff/, '').replace(/\n$/, '');
  const codigo = todo.replace(/\/\/.*|\/\*[^]*?(\*\/|$)/g, c => c.replace(/./g, ' ')).split('\n');
  return todo.split('\n').flatMap((texto, i) => {
    const [, incluido] = texto.match(/^\s*#include\s*"(.+)"\s*$/) ?? [];
    return incluido && codigo[i].trim() && textos[incluido] !== undefined && !pila.includes(incluido)
      ? conInclusiones(incluido, textos, [...pila, ruta]) : { fichero: ruta, linea: i + 1, texto };
  });
}

/// De qué fichero es cada línea de ese texto; si no se encuentra, de ninguno. `tipo`: vert o frag.
export function lineasDe(texto, textos, tipo) {
  const cuerpo = texto.replace(/^[\s\S]*?\n#line 2\n/, '').replace(/\n$/, ''); // sin la cabecera de ES
  for (const ruta of Object.keys(textos).filter(r => r.endsWith(`.${tipo}`))) {
    const lineas = conInclusiones(ruta, textos);
    if (lineas.slice(1).map(l => l.texto).join('\n') === cuerpo) return lineas;
  }
  return ['#version 140', ...cuerpo.split('\n')].map((t, i) => ({ fichero: '', linea: i + 1, texto: t }));
}
