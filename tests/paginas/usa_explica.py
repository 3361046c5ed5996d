"""Explicar un píxel en la página: se pregunta de cada programa, en dos píxeles suyos."""
import zlib

from navegador import PROGRAMAS, exige

# La historia acaba en el color de la imagen; el shader da el color que se le apunta, y nada cambia.
MIRA = """const { lienzo } = sesion, { width, height } = lienzo, gl = lienzo.getContext('webgl2');
const todo = new Uint8Array(4 * width * height), [x, y] = arguments, i = 4 * ((height - 1 - y) * width + x);
const lee = () => { gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, todo); return todo.join(); };
escena.quieta = true;
const antes = lee(), color = [...todo.slice(i, i + 3)];
const datos = await pagina.explica(x, y), mal = [];
if (!datos) return ['no lo explica: ' + una('.aviso').textContent];
if (datos.color.join() !== color.join()) mal.push(`es (${color}) y la historia acaba en (${datos.color})`);
if (lee() !== antes) mal.push('la imagen ha cambiado');
if (gl.getError()) mal.push('queda un error de OpenGL');
if (!sesion.vivo) mal.push('el programa ha terminado');
const gana = datos.historia.findLast(s => s.veredicto === 'escrito'), { shader } = datos;
if (!shader !== (gana.primitiva === undefined)) mal.push('no es el shader de quien gana');
if (shader) {
  const ultimo = shader.lineas.findLast(l => l.clase === 13 && l.tipo === 'vec4')?.valor ?? [NaN];
  const da = ultimo.slice(0, 3).map(v => Math.round(255 * Math.min(Math.max(v, 0), 1)));
  if (da.some((v, k) => !(Math.abs(v - gana.color[k]) <= 1))) mal.push(`el shader apunta (${da}) y da (${gana.color})`);
  if (shader.sinSeguir.length) mal.push(JSON.stringify(shader.sinSeguir));
  if (!todos('.explicacion .hecha').length) mal.push('no se ve ninguna línea');
}
return mal;
"""


def explica(p):
    for programa in PROGRAMAS.values():
        if programa.consola:
            continue
        p.abre(f"#{programa.nombre}")
        azar = zlib.crc32(programa.nombre.encode())
        for x, y in ((40 + azar % 160, 40 + azar // 160 % 110), (120, 90)):
            mal = p.espera_js(MIRA, x, y)
            exige(mal == [], f"{programa.nombre}: el píxel ({x}, {y}) se explica: {mal}")
