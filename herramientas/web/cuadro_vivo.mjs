// El cuadro que se ve, explicado: lo que cuenta herramientas/explica/web.cpp, que va en el laboratorio, como lo enseña
// herramientas/base/cuadro.mjs.
import { crea } from '../base/documento.mjs';

/// Una miniatura: { ancho, alto, canales y sus bytes en base 64, fila a fila desde arriba }.
function enPng({ ancho, alto, canales, datos }) {
  const lienzo = crea('canvas', { width: ancho, height: alto }), imagen = new ImageData(ancho, alto);
  const bytes = Uint8Array.from(atob(datos), c => c.charCodeAt(0));
  imagen.data.forEach((_, i) => {
    imagen.data[i] = i % 4 === 3 ? 255 : bytes[canales * (i >> 2) + Math.min(i % 4, canales - 1)];
  });
  lienzo.getContext('2d').putImageData(imagen, 0, 0);
  return lienzo.toDataURL();
}

/// El cuadro y, si se da, el píxel [x, y] desde arriba a la izquierda del lienzo, con el texto de los shaders tal cual.
export async function explicaCuadro({ lienzo, explica }, pixel) {
  if (!lienzo.getContext('webgl2').getExtension('EXT_color_buffer_float'))
    throw new Error('a este navegador le falta EXT_color_buffer_float, con que se mira lo que calcula un shader');
  const { pixeles: [suyo], ordenes, ...datos } = await explica(pixel);
  for (const orden of ordenes)
    for (const que of ['miniatura', 'profundidad', 'plantilla']) if (orden[que]) orden[que] = enPng(orden[que]);
  const { fragmento, vertices = [] } = suyo?.sombreado ?? {};
  for (const traza of fragmento ? [fragmento, ...vertices] : [])
    for (const linea of [...traza.lineas, ...traza.sinSeguir]) linea.en = linea.linea;
  return { pixel: null, color: null, historia: [], ...suyo, ordenes, ...datos };
}
