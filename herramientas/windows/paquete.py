"""paquete.py RAÍZ BUILD GALERÍA DESTINO: DESTINO/laboratorio-windows.zip, que se descomprime y se usa: los programas
con sus DLL en una carpeta y, a su lado, los shaders, los modelos y las texturas, un LEEME.txt, una página con la
imagen de cada programa y las licencias.

Los programas son los de BUILD/windows/programas (herramientas/cmake/windows.cmake); lo demás, el de la compilación
corriente.
"""
import io
import sys
import tempfile
import zipfile
from pathlib import Path

from base import catalogo, controles, paginas
from base.procesos import ejecuta, escribe, principal
from web.pagina import TEXTURAS, Pagina

AQUI = Path(__file__).parent
MINGW = "x86_64-w64-mingw32-"
DLL = "libstdc++-6.dll", "libgcc_s_seh-1.dll", "libwinpthread-1.dll"
# de qué paquete es cada una de las demás
LICENCIAS = {"gcc": "g++-mingw-w64-x86-64-posix", "mingw-w64": "mingw-w64-common", "glm": "libglm-dev"}
LICENCIAS |= {"dejavu": "fonts-dejavu-core"}


class Paquete:
    def __init__(self, raiz, build, galeria):
        self.raiz, self.build = raiz, build
        self.programas = catalogo.lee_programas(build)
        self.web = Pagina(raiz, build, galeria, build / "windows/pagina")  # donde se quedan las miniaturas
        self.contenido = io.BytesIO()
        self.zip = zipfile.ZipFile(self.contenido, "w", zipfile.ZIP_DEFLATED, compresslevel=9)

    def mete(self, donde, fichero):
        self.zip.write(fichero, f"laboratorio/{donde}")

    def mete_programas(self):
        compilado = self.build / "windows/programas"
        for p in self.programas:
            self.mete(f"programas/{p.nombre}.exe", compilado / f"ventana/{p.capitulo.nombre}/{p.nombre}.exe")
        for dll in sorted(compilado.glob("dll/*.dll")):
            self.mete(f"programas/{dll.name}", dll)
        with tempfile.TemporaryDirectory() as carpeta:
            for nombre in DLL:
                entera = ejecuta([MINGW + "g++-posix", f"-print-file-name={nombre}"], text=True).strip()
                aligerada = Path(carpeta, nombre)  # las de GCC llevan veinte megas para depurar
                ejecuta([MINGW + "strip", "-o", aligerada, entera])
                self.mete(f"programas/{nombre}", aligerada)

    def mete_datos(self):
        for patron in ("c*/**/*.vert", "c*/**/*.frag", "c*/**/*.glsl", "assets/*.txt", "assets/*.vf"):
            for fichero in sorted(self.raiz.glob(patron)):
                if fichero.name != "CMakeLists.txt":
                    self.mete(fichero.relative_to(self.raiz), fichero)
        for fichero in sorted((self.build / "assets").iterdir()):
            if fichero.suffix in TEXTURAS:
                self.mete(f"assets/{fichero.name}", fichero)

    def mete_licencias(self):
        fuentes = self.build / "windows/fuentes"
        for nombre, fichero in {
            "laboratorio": self.raiz / "LICENSE",
            "freeglut": fuentes / "freeglut/COPYING",
            "glew": fuentes / "glew/LICENSE.txt",
            **{nombre: Path("/usr/share/doc", paquete, "copyright") for nombre, paquete in LICENCIAS.items()},
        }.items():
            self.mete(f"licencias/{nombre}.txt", fichero)

    def mete_pagina(self):
        miniaturas = {p.nombre: self.web.miniatura(p.casos[0]) for p in self.programas}
        for miniatura in filter(None, miniaturas.values()):
            self.mete(f"imagenes/{miniatura}", self.web.destino / miniatura)
        mandos = {p.nombre: [c.texto for c in controles.lee(self.raiz, p)] for p in self.programas}
        datos = {"capitulos": catalogo.lee(self.build), "miniaturas": miniaturas, "controles": mandos}
        paginas.escribe_pagina(self.web.destino, AQUI / "windows.html", **datos)
        self.mete("index.html", self.web.destino / "index.html")
        leeme = (AQUI / "windows_leeme.txt").read_text().replace("\n", "\r\n")  # para el Bloc de notas
        self.zip.writestr("laboratorio/LEEME.txt", leeme)

    def escribe(self, fichero):
        with self.zip:
            self.mete_pagina()
            self.mete_programas()
            self.mete_datos()
            self.mete_licencias()
        escribe(fichero, self.contenido.getvalue())


def main():
    raiz, build, galeria, destino = (Path(ruta).resolve() for ruta in sys.argv[1:])
    fichero = destino / "laboratorio-windows.zip"
    Paquete(raiz, build, galeria).escribe(fichero)
    print(f"Hecho: {fichero} ({fichero.stat().st_size / 1e6:.1f} MB)", file=sys.stderr)


if __name__ == "__main__":
    principal(main)
