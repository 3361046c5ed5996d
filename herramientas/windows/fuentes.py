"""fuentes.py BUILD: deja en BUILD/windows/fuentes los de FreeGLUT y GLEW, que para Windows no están en Debian pero
valen tal cual. Salen del mismo archivo que los demás paquetes de la máquina, con una lista aparte: la suya no tiene
por qué nombrar los fuentes."""
import os
import re
import shutil
import sys
from pathlib import Path

from base import procesos
from base.procesos import Fallo, principal


def lista_de_fuentes(carpeta):
    """La de apt de que sale libglew-dev, pero de fuentes."""
    dice = procesos.ejecuta(["apt-cache", "madison", "libglew-dev"], text=True).split()
    formato = ["apt-get", "indextargets", "--format", "$(SOURCESENTRY)", f"Site: {dice[4]}", "Created-By: Packages"]
    lista = Path(re.sub(r":\d+$", "", procesos.ejecuta(formato, text=True).split("\n")[0]))
    cambios = {".sources": ("^Types:.*", "Types: deb-src"), ".list": (r"^deb\b", "deb-src")}
    if lista.suffix not in cambios:
        raise Fallo("windows: no sé de qué archivo de Debian viene libglew-dev")
    de, a = cambios[lista.suffix]
    lineas = [linea for linea in lista.read_text().splitlines() if lista.suffix == ".sources" or re.match("deb", linea)]
    suya = carpeta / f"lista{lista.suffix}"
    suya.write_text(re.sub(de, a, "\n".join(lineas) + "\n", flags=re.M))
    return suya


def main():
    build = Path(sys.argv[1])
    destino, apt = build / "windows/fuentes", build / "windows/apt"
    if destino.exists():
        return
    if os.environ.get("LAB_SIN_INSTALAR") == "1":
        raise Fallo("faltan los fuentes de FreeGLUT y GLEW, que ./lab windows descarga sin LAB_SIN_INSTALAR")
    print("Descargo los fuentes de FreeGLUT y GLEW", file=sys.stderr, flush=True)
    shutil.rmtree(apt, ignore_errors=True)
    (apt / "listas/partial").mkdir(parents=True)
    (apt / "fuentes").mkdir()
    donde = f"Dir::Etc::SourceList={lista_de_fuentes(apt)}", "Dir::Etc::SourceParts=/dev/null"
    opciones = *donde, f"Dir::State::Lists={apt}/listas", "APT::Sandbox::User=root"
    con = [palabra for opcion in opciones for palabra in ("-o", opcion)]
    for que in (["update"], ["source", "freeglut", "glew"]):
        try:
            procesos.ejecuta(["apt-get", "-qq", *con, *que], cwd=apt / "fuentes")
        except Fallo as fallo:
            print(*str(fallo).splitlines()[-5:], sep="\n", file=sys.stderr)
            raise Fallo("no se han podido descargar los fuentes de FreeGLUT y GLEW (¿hay red?)") from None
    for nombre in ("freeglut", "glew"):
        [carpeta] = (apt / "fuentes").glob(f"{nombre}-*/")
        carpeta.rename(apt / "fuentes" / nombre)
    (apt / "fuentes").rename(destino)  # cuando ya están todos
    shutil.rmtree(apt)


if __name__ == "__main__":
    principal(main)
