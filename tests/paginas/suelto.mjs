import { ABRE, enNavegadores, lee } from './navegador.mjs';
import { pasea } from './paseo.mjs';
const web = ABRE.includes('web');
export const SITIOS = ['', '#grua', '#grua-girada', '#grua;tecla d', '#ejercicio/L5.1', '#ejercicio/L5.2', '#sombras', '#menu', '#convolucion', '#luces_animadas', '#info_opengl', '#no_esta', '#5', '#cap5', '#l5.1', '#ejercicio/nada'];
enNavegadores(['chromium'], { paseo: p => pasea(p, { pasos: +(process.env.PASOS ?? 60), sitios: SITIOS, lista: web ? () =>
  !visto.programa || (sesion || !telon.hidden) && editor.ruta && editor.ruta === editor.abierto &&
  !/^(Mirando|Repitiendo)/.test(aviso) && !(visto.ejercicio && una('.marcador').textContent.includes('…')) : () => true }) });
