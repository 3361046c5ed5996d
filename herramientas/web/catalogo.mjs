// La lista de todos los programas.
import { todos, una } from '../base/documento.mjs';
import { PROGRAMAS } from './programas.mjs';
import { ponResueltos } from './resueltos.mjs';
import { corta } from './textos.mjs';

const noEsta = una('#no-esta');
// la galería está al lado, si la página no se ha llevado sola a otro sitio
una('.a-galeria').hidden = !/\/web\/[^/]*$/.test(location.pathname);

/// Todos, por el capítulo de ese nombre (ch03, 3), o por donde se dejó; si no lo hay, dice que no está.
export function ensenaCatalogo(nombre, esEjercicio, sitio) {
  ponResueltos();
  document.title = 'Síntesis de imagen y animación';
  const capitulo = PROGRAMAS.map(p => p.capitulo).find(c =>
    c.split('_')[0] === `ch${/^(?:ch|cap)?0*(\d+)$/i.exec(nombre)?.[1].padStart(2, '0')}`) ?? nombre;
  const lugar = todos('#catalogo [id]').find(e => e.id.toLowerCase() === capitulo.toLowerCase());
  noEsta.hidden = !nombre || Boolean(lugar);
  noEsta.textContent = `No hay ningún ${esEjercicio ? 'ejercicio' : 'programa'} «${corta(nombre, 60)}».`;
  if (lugar) lugar.scrollIntoView();
  else scrollTo(0, nombre ? 0 : sitio);
}
