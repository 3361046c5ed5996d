#!/usr/bin/env python3
"""comprueba_web.py RAÍZ BUILD WEB [caso… | persona | gestos | ejercicios | explica | pedido |
    incrustado]: la página de los programas
(./lab web), con file:// en Chromium sobre llvmpipe. Con LAB_OPENGL=swiftshader, sobre el SwiftShader que lleva dentro,
y solo los casos, con el comparador en --otro.

Cada caso del catálogo se dibuja con su guion y se compara con su golden, con el comparador y la tolerancia de siempre.
Después, lo que hace una persona (usa_programas.py, usa_editor.py), y lo que se pregunta de todo lo que hay (gestos.py).
"""
import base64
import os
import sys
from pathlib import Path

import gestos
import navegador  # que sabe dónde está procesos
import usa_editor
import usa_explica
import usa_incrustado
import usa_programas
from navegador import BUILD, CASOS, exige, procesos
from persona import Persona

# De lo demás, SwiftShader no vale de juez: con polygon offset sus mallas cambian de una vez a otra.
SWIFTSHADER = os.environ.get("LAB_OPENGL") == "swiftshader"
ANGLE = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader") if SWIFTSHADER else ("--use-angle=gl",)
VENTANA = ("--disable-gpu-watchdog", "--window-size=1280,900", "--no-first-run")
OPCIONES = ("--use-gl=angle", *ANGLE, "--ignore-gpu-blocklist", *VENTANA)

DIBUJA = """
const [nombre, guion] = arguments, escrito = [], lienzo = document.createElement('canvas');
const programa = JSON.parse(document.querySelector('#programas').textContent).find(p => p.nombre === nombre);
try {
  const di = linea => escrito.push(linea);
  const s = await pagina.arranca(programa, { lienzo, ancho: 240, alto: 180, suavizado: false, di });
  s.orden(guion);
  s.orden('captura /imagen.ppm');
  let ppm = '';
  if (s.vivo) for (const b of s.lee('/imagen.ppm')) ppm += String.fromCharCode(b);
  s.cierra();
  return { ppm: btoa(ppm), escrito: escrito.join('\\n') };
} catch (error) {
  return { ppm: '', escrito: String(error) };
}
"""

OPENGL = """
const gl = document.createElement('canvas').getContext('webgl2');
return gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL)
"""


def compara_casos(n, pedidos):
    casos = [c for c in CASOS if not pedidos or c.fichero in pedidos or c.programa.nombre in pedidos]
    bien = 0
    for caso in casos:
        r = n.espera_js(DIBUJA, caso.programa.nombre, caso.guion)
        if not r["ppm"]:
            exige(False, f"{caso.fichero} se dibuja: {r['escrito']}")
            continue
        tolerancia = caso.otro if SWIFTSHADER else caso.tolerancia
        es, dicho = navegador.como_golden(caso, base64.b64decode(r["ppm"]), SWIFTSHADER, tolerancia, "web")
        print(f"{caso.fichero}: {dicho}", flush=True)
        bien += es
        exige(es, f"{caso.fichero} es como su golden")
    print(f"{bien} de {len(casos)} casos como su golden; {n.js(OPENGL)}")


DE_EJERCICIOS = [usa_editor.ejercicios, usa_programas.pagina]
DE_PERSONA = [usa_programas.entradas, usa_programas.pantalla_completa, usa_programas.fin, usa_programas.adversidades]
DE_PERSONA += [
    usa_explica.explica,
    usa_incrustado.incrustado,
    gestos.de_la_pagina,
    usa_editor.editor,
    usa_programas.ficheros_y_tallas,
    *DE_EJERCICIOS,
]
PRUEBAS = {"": DE_PERSONA, "persona": DE_PERSONA, "ejercicios": DE_EJERCICIOS, "gestos": [gestos.de_la_pagina]}
PRUEBAS |= {
    "explica": [usa_explica.explica_todos],
    "pedido": [usa_explica.pedido],
    "incrustado": [usa_incrustado.incrustado],
}


def main():
    web, pedidos = Path(sys.argv[3], "index.html").resolve(), sys.argv[4:]
    que = " ".join(pedidos)
    fijo = procesos.entorno(BUILD)
    with navegador.pantalla({**os.environ, **fijo}) as entorno, navegador.chromium(*OPCIONES, entorno=entorno) as n:
        n.pide("/timeouts", script=240000)  # con la máquina ocupada
        n.abre(web)
        if not que or que not in PRUEBAS:
            compara_casos(n, pedidos)
        persona = Persona(n, web)
        for prueba in () if SWIFTSHADER else PRUEBAS.get(que, ()):
            n.talla(1280, 800)  # cada una empieza en un portátil, sin shaders cambiados, y no como lo dejó la de antes
            n.js("try { sessionStorage.clear() } catch { /* la de antes los tenía prohibidos */ }")
            prueba(persona)
        registro = [linea for linea in n.registro() if "CONTEXT_LOST_WEBGL" not in linea]
        exige(not registro, f"la consola está vacía: {registro[:3]}")
    navegador.acaba()


if __name__ == "__main__":
    main()
