// El worker que compila: así la página no espera. Recibe { trae }, lo que hace falta, y después lo que hay que
// compilar: { n, programa, fuentes, cambiados, capitulo }; responde { n, dicho, wasm, tarda } o
// { n, error }. Con { n, sitios }, qué línea es la de donde ha fallado; con { n, adelanta }, hace lo que es de todos.
import { pon } from './sin_red.mjs';
import { adelanta, busca, hazlo, prepara } from './compila.mjs';

onmessage = async ({ data: { trae, n, ...pedido } }) => {
  if (trae) {
    pon(trae.blobs);
    return prepara(trae.da, trae.objetos);
  }
  try {
    postMessage({ n, ...await (pedido.sitios ? busca : pedido.adelanta ? adelanta : hazlo)(pedido) });
  } catch (error) {
    postMessage({ n, error: String(error?.stack ?? error) });
  }
};
