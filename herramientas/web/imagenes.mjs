// Imágenes: sus tallas, cuánto se parecen dos y las propias, en el formato que leen los programas.
import { crea } from '../base/documento.mjs';

const LADO_MAXIMO = 4096;
/// Lo mismo, escrito de otra manera, se redondea de otra: dos píxeles coinciden si difieren en estos niveles, de 255, o
/// menos; y como en un contorno ese redondeo decide píxeles enteros, basta con que coincida esta parte de la imagen.
export const TOLERA = 3, BASTA = 0.999;

/// La parte de dos imágenes RGBA de igual talla que coincide. En `diferencia`, si se da, gris lo que coincide y rojo lo
/// demás.
export function compara(lograda, objetivo, diferencia) {
  let iguales = 0;
  for (let i = 0; i < objetivo.length; i += 4) {
    const [r, g, b] = [objetivo[i], objetivo[i + 1], objetivo[i + 2]];
    const error = Math.max(Math.abs(lograda[i] - r), Math.abs(lograda[i + 1] - g), Math.abs(lograda[i + 2] - b));
    if (error <= TOLERA) ++iguales;
    if (!diferencia) continue;
    const gris = 150 + 0.35 * (0.3 * r + 0.6 * g + 0.1 * b), rojo = error > TOLERA ? Math.min(0.5 + error / 128, 1) : 0;
    diferencia[i] = gris + rojo * (214 - gris);
    diferencia[i + 1] = gris + rojo * (40 - gris);
    diferencia[i + 2] = gris + rojo * (20 - gris);
    diferencia[i + 3] = 255;
  }
  return 4 * iguales / objetivo.length;
}

/// Hacia abajo: el 100 % es que coinciden todos.
export const porciento = parte => `${Math.floor(parte * 1000) / 10}\u00a0%`;

export function pixeles(lienzo) {
  const { width, height } = lienzo;
  const pincel = crea('canvas', { width, height }).getContext('2d', { willReadFrequently: true });
  pincel.drawImage(lienzo, 0, 0);
  return pincel.getImageData(0, 0, width, height).data;
}

/// Los píxeles de un lienzo que ocupa ese sitio en una pantalla de esa densidad.
export function tallaDe({ width, height }, densidad) {
  const e = Math.min(densidad || 1, 2, LADO_MAXIMO / Math.max(width, height, 1));
  return { ancho: Math.max(Math.round(width * e), 1), alto: Math.max(Math.round(height * e), 1) };
}

/// Una imagen más grande se reduce.
export function quepa({ width, height }, lado = 2048) {
  const e = Math.min(1, lado / Math.max(width, height));
  return { width: Math.max(Math.round(width * e), 1), height: Math.max(Math.round(height * e), 1) };
}

export const esPpm = datos => datos[0] === 0x50 && datos[1] === 0x36; // un P6

export function ppmDe(rgba, width, height) {
  const cabecera = new TextEncoder().encode(`P6\n${width} ${height}\n255\n`);
  const ppm = new Uint8Array(cabecera.length + 3 * width * height);
  ppm.set(cabecera);
  for (let i = 0; i < width * height; ++i) ppm.set(rgba.subarray(4 * i, 4 * i + 3), cabecera.length + 3 * i);
  return ppm;
}

/// La imagen de un fichero como PPM, que es lo que leen los programas.
export async function aPpm(fichero) {
  const datos = new Uint8Array(await fichero.arrayBuffer());
  if (esPpm(datos)) return datos;
  const imagen = await createImageBitmap(fichero, { colorSpaceConversion: 'none' });
  const { width, height } = quepa(imagen), pincel = crea('canvas', { width, height }).getContext('2d');
  pincel.drawImage(imagen, 0, 0, width, height);
  return ppmDe(pincel.getImageData(0, 0, width, height).data, width, height);
}
