// El compilador pide sus ficheros por la red, y aquí ya están: se le dan los que la página ha traído. Va antes que él,
// que se queda con fetch al cargarse.
const traidos = {};

/// Desde ahora, esos, comprimidos: { nombre: blob }.
export function pon(blobs) { Object.assign(traidos, blobs); }

self.fetch = async direccion => {
  const nombre = String(direccion).split('/').pop();
  const type = nombre.endsWith('.wasm') ? 'application/wasm' : 'text/plain';
  const flujo = traidos[nombre].stream().pipeThrough(new DecompressionStream('deflate'));
  delete traidos[nombre]; // se pide una vez
  return new Response(flujo, { headers: { 'content-type': type } });
};
