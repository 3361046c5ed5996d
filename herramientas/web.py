#!/usr/bin/env python3
"""web.py RAÍZ BUILD GALERÍA DESTINO: la página con todos los programas, en ficheros estáticos que valen sin servidor.

BUILD es el del enlace web (herramientas/web.cmake). Lo que no es texto de la página va en DESTINO/datos/NOMBRE.js, que
llama a llega("NOMBRE", "…") con los bytes comprimidos y en base64: así un navegador lo lee también de file://, y ocupa
poco aunque el servidor no comprima.
"""
import base64
import json
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import jinja2
import pagina

CODEMIRROR = Path("/usr/share/javascript/codemirror")
SHADERS = (".vert", ".frag", ".glsl")
ESPECIALES = {"←": "IZQUIERDA", "→": "DERECHA", "↑": "ARRIBA", "↓": "ABAJO"}


def orden_de(tecla):
    """La orden del guion que da una tecla nombrada en «// Controles:», o nada si no es una tecla."""
    if tecla in ESPECIALES:
        return "especial " + ESPECIALES[tecla]
    if re.fullmatch(r"F([1-9]|1[0-2])", tecla):
        return "especial " + tecla
    if tecla == "espacio":
        return "tecla Espacio"
    return "tecla " + ("PuntoYComa" if tecla == ";" else tecla) if len(tecla) == 1 and tecla.isascii() else ""


def clase(tecla):
    return "cifra" if tecla.isdigit() else "letra" if tecla.isalpha() else "otra"


def mando(control):
    """Un control en botones y lo que hacen: «a d giran» son dos teclas; «1 a 9 resaltan», nueve; «arrastra (o n y flechas)», cinco."""
    palabras = control.replace(" o espacio ", " espacio ").split()
    hace, teclas = control, []
    if rango := re.match(r"(\d) a (\d) (.*)", control):
        teclas, hace = [str(n) for n in range(int(rango[1]), int(rango[2]) + 1)], rango[3]
    elif flechas := re.search(r" \(o (\w) y flechas\)$", control):
        teclas, hace = [flechas[1], *ESPECIALES], control[:flechas.start()]
    else:
        while len(palabras) > 1 and orden_de(palabras[0]) and (not teclas or clase(teclas[0]) == clase(palabras[0])):
            teclas.append(palabras.pop(0))
        hace = " ".join(palabras)
    return {"teclas": [(t, orden_de(t)) for t in teclas], "hace": hace, "menu": not teclas and "menú" in control}


def describe(raiz, programa, texturas):
    """Lo que la página tiene que saber de un programa."""
    fuente = Path(programa.capitulo, f"{programa.nombre}.cpp")
    texto = (raiz / fuente).read_text()
    fuentes = pagina.fuentes(raiz, fuente)
    todo = "".join((raiz / f).read_text() for f in fuentes)
    nombrados = set(re.findall(r'"(assets/\w*)', todo))
    ficheros = re.search(r'\[FICHERO\]', texto) and ".vf"
    imagenes = len(set(re.findall(r'"assets/\w+\.rgb"', texto))) if re.search("imagenDeArg|ConImagenes", texto) else 0
    return {
        "nombre": programa.nombre, "capitulo": programa.capitulo, "referencia": programa.referencia,
        "titulo": programa.titulo, "consola": bool(programa.consola),
        "mandos": [mando(c) for c in map(str.strip, pagina.controles(texto)) if not c.startswith(("Esc ", "ninguno"))],
        "derecho": "derecho" in texto and "glutAttachMenu" not in todo,
        "anima": bool(re.search("glutTimerFunc|glutIdleFunc|GLUT_ELAPSED_TIME", todo)),
        "raton": bool(re.search("ratón|rueda|clic|arrastra|botón", " ".join(pagina.controles(texto)))),
        "sigue": "glutPassiveMotionFunc" in todo,
        "casos": [{"titulo": c.titulo or "al empezar", "guion": c.guion, "argumentos": c.argumentos, "mira": c.mira}
                  for c in programa.casos],
        "fuentes": [str(f) for f in fuentes],
        "texturas": [t for t in texturas if any(f"assets/{t}.rgb".startswith(n) for n in nombrados)],
        "admite": ficheros or ("imagen" if imagenes else ""), "cuantas": imagenes or 1,
    }


class Pagina:
    def __init__(self, raiz, build, galeria, destino):
        self.raiz, self.build, self.galeria, self.destino = raiz, build, galeria, destino

    def empaqueta(self, nombre, datos):
        datos = datos if isinstance(datos, bytes) else json.dumps(datos, ensure_ascii=False).encode()
        comprimido = base64.b64encode(zlib.compress(datos, 9)).decode()
        (self.destino / "datos" / f"{nombre}.js").write_text(f'llega("{nombre}","{comprimido}")\n')

    def textos(self, *patrones):
        ficheros = sorted(f for patron in patrones for f in self.raiz.glob(patron))
        return {str(f.relative_to(self.raiz)): f.read_text() for f in ficheros}

    def miniatura(self, programa):
        """La primera imagen de la galería, a la mitad: basta para el catálogo."""
        origen = self.galeria / programa.casos[0].imagen
        destino = self.destino / programa.capitulo / f"{programa.nombre}.jpg"
        if programa.consola or not origen.is_file():
            return ""
        if not destino.is_file() or destino.stat().st_mtime < origen.stat().st_mtime:
            destino.parent.mkdir(exist_ok=True)
            reducida = subprocess.run(f"pngtopnm '{origen}' | pamscale -linear 0.5 | pnmtojpeg -quality=85 -optimize", shell=True,
                                      check=True, capture_output=True).stdout
            destino.write_bytes(reducida)
        return str(destino.relative_to(self.destino))

    def escribe(self, capitulos):
        shutil.rmtree(self.destino / "datos", ignore_errors=True)
        (self.destino / "datos").mkdir(parents=True)
        for parte in ("js", "wasm"):
            self.empaqueta(parte, (self.build / f"lab.{parte}").read_bytes())
        self.empaqueta("shaders", self.textos(*(f"c*/*{e}" for e in SHADERS), "assets/*.txt", "assets/*.vf"))
        self.empaqueta("codigo", self.textos("ch*/*.cpp", "ch*/*.h"))
        guiones = ("lib/codemirror.js", "mode/clike/clike.js", "addon/edit/matchbrackets.js")
        self.empaqueta("editor", {"css": (CODEMIRROR / "lib/codemirror.css").read_text(),
                                  "js": "\n".join((CODEMIRROR / g).read_text() for g in guiones)})
        texturas = [f.stem for f in sorted((self.build.parent / "assets").glob("*.rgb"))]
        for textura in texturas:
            self.empaqueta(textura, (self.build.parent / "assets" / f"{textura}.rgb").read_bytes())
        programas = [p for capitulo in capitulos for p in capitulo.programas]
        entorno = jinja2.Environment(loader=jinja2.FileSystemLoader(pagina.PLANTILLAS), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
        entorno.policies["json.dumps_kwargs"] = {"ensure_ascii": False, "separators": (",", ":")}
        html = entorno.get_template("web.html").render(
            capitulos=capitulos, miniaturas={p.nombre: self.miniatura(p) for p in programas},
            programas=[describe(self.raiz, p, texturas) for p in programas])
        parcial = self.destino / "index.html.parcial"
        parcial.write_text(html)
        parcial.replace(self.destino / "index.html")


def main():
    raiz, build, galeria, destino = map(Path, sys.argv[1:])
    Pagina(raiz, build, galeria, destino).escribe(pagina.lee_catalogo(build))
    ocupa = sum(f.stat().st_size for f in destino.rglob("*") if f.is_file())
    print(f"Hecha: {destino}/index.html ({ocupa / 1e6:.1f} MB en total)", file=sys.stderr)


main()
