// Lo que se guarda en el disco de quien mira.
import { crea } from '../base/documento.mjs';

export function guarda(blob, nombre) {
  const enlace = crea('a', { href: URL.createObjectURL(blob), download: nombre });
  enlace.click();
  setTimeout(() => URL.revokeObjectURL(enlace.href), 1000);
}
