#!/usr/bin/env python3
"""web.py RAÍZ BUILD WEB [caso…]: la página de los programas (./lab web), en Chromium sobre llvmpipe y abierta con file://.

Cada caso de casos.tsv se dibuja con su guion y se compara con su golden, con el comparador y la tolerancia de siempre.
"""
import base64
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import navegador
from navegador import Navegador, espera, exige

# SwiftShader no vale de juez: con polygon offset sus mallas cambian de una vez a otra.
LLVMPIPE = ("--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist", "--window-size=1280,900", "--no-first-run")

DIBUJA = """
const [nombre, guion, argumentos, acaba] = arguments;
(async () => {
  const programa = PROGRAMAS.find(p => p.nombre === nombre), escrito = [];
  const s = await arranca(programa, { lienzo: document.createElement('canvas'), ancho: 240, alto: 180, argumentos, suavizado: false,
    di: linea => escrito.push(linea) });
  s.orden(guion);
  s.orden('captura /imagen.ppm');
  const bien = s.vivo;
  let texto = '';
  if (bien) for (const b of s.lee('/imagen.ppm')) texto += String.fromCharCode(b);
  s.cierra();
  return { bien, escrito: escrito.join('\\n'), ppm: btoa(texto) };
})().then(acaba, error => acaba({ bien: false, escrito: String(error), ppm: '' }));
"""


def lee_casos(build):
    for fila in (build / "casos.tsv").read_text().splitlines():
        yield ["" if campo == "-" else campo for campo in fila.split("\t")]


def compara_casos(n, raiz, build, carpeta, pedidos):
    bien = total = 0
    for capitulo, programa, _, guion, argumentos, tolerancia, fichero, *_ in lee_casos(build):
        if pedidos and fichero not in pedidos and programa not in pedidos:
            continue
        total += 1
        r = n.pide("/execute/async", script=DIBUJA, args=[programa, guion, argumentos.split()])
        if not r["bien"]:
            exige(False, f"{fichero} se dibuja: {r['escrito']}")
            continue
        obtenida = carpeta / f"{fichero}.ppm"
        obtenida.write_bytes(base64.b64decode(r["ppm"]))
        fallos = build / "fallos/web"
        fallos.mkdir(parents=True, exist_ok=True)
        opciones = ["--tolerancia", tolerancia] if tolerancia else []
        c = subprocess.run([build / "tests/compara", raiz / "tests/golden" / capitulo / f"{fichero}.ppm", obtenida, "--amplia",
                            "--deja", fallos / fichero, *opciones], capture_output=True, text=True)
        print(f"{fichero}: {(c.stdout + c.stderr).strip()}", flush=True)
        bien += c.returncode == 0
        exige(c.returncode == 0, f"{fichero} es como su golden")
    print(f"{bien} de {total} casos como su golden")


def main():
    raiz, build, web, *pedidos = sys.argv[1:]
    raiz, build, web = Path(raiz).resolve(), Path(build).resolve(), Path(web).resolve()
    fijo = dict(linea.split("=", 1) for linea in (raiz / "tests/entorno.txt").read_text().split())
    pantalla = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "1920x1200x24", "-nolisten", "tcp"], stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True)
    try:
        entorno = {**os.environ, **fijo, "DISPLAY": ":" + pantalla.stdout.readline().strip()}
        with tempfile.TemporaryDirectory() as carpeta:
            n = Navegador(Path(carpeta, "perfil"), LLVMPIPE, entorno)
            try:
                n.pide("/timeouts", script=60000)
                n.pide("/url", url=(web / "index.html").as_uri())
                compara_casos(n, raiz, build, Path(carpeta), pedidos)
            finally:
                n.cierra()
    finally:
        pantalla.terminate()
        pantalla.wait()
    sys.exit(1 if navegador.fallos else 0)


if __name__ == "__main__":
    main()
