"""Los paquetes de Debian que hacen falta para cada cosa, y ponerlos: antes se dice cuáles, cuánto se descarga y cuánto
ocupan. LAB_SIN_INSTALAR=1 no instala nada, y entonces se dice cuáles faltan."""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from base.procesos import Fallo, por_donde

TABLA = [fila.split("\t") for fila in Path(__file__).with_name("paquetes.tsv").read_text().splitlines()]
PARA = {para: [fila[0] for fila in TABLA if fila[1] == para] for _, para, *_ in TABLA}
PARA_USAR, CORRIGE, MEDIDAS = PARA["usar"], PARA["corrige"], PARA["medidas"]  # la jaula, salvo con --sin-jaula
PRUEBAS = PARA["pruebas"] + CORRIGE
PARES = ["libglu1-mesa-dev", "libnoise-dev", "imagemagick"]  # con LAB_PARES=1
NAVEGADOR = ["chromium", "firefox-esr"]  # con LAB_NAVEGADOR=1
WEB = "emscripten libjs-codemirror esbuild libdeflate-tools".split()
WEB += [] if shutil.which("npm") else ["npm"]  # o el de otro Node.js
WINDOWS = ["g++-mingw-w64-x86-64-posix", "dpkg-dev"]
WINE = ["wine64", "openbox"]  # con LAB_WINDOWS=1
OPENGL = {"llvmpipe": [], "softpipe": [], "zink": ["mesa-vulkan-drivers"], "swiftshader": ["chromium"]}
OPENGL["virgl"] = ["virgl-server"]  # con LAB_OPENGL
[OPCIONAL] = PARA["opcional"]  # no existe con Mesa 25.1 o posterior: entonces se usa EGL
AVANCE = re.compile(r"(Get:\d+|Des:\d+|Unpacking|Desempaquetando|Setting up|Configurando) ?(\S+)")


def escrito(*orden):
    return subprocess.run(orden, capture_output=True, text=True, errors="replace").stdout


def existe(paquete):
    return bool(escrito("apt-cache", "show", paquete))


def para_pruebas():
    """Los de las pruebas, y los de lo que se pide por el entorno."""
    todos = list(PRUEBAS)
    if os.environ.get("LAB_WINDOWS") == "1":
        todos += WINE
    if os.environ.get("LAB_NAVEGADOR") == "1":
        todos += NAVEGADOR + WEB
    otro = os.environ.get("LAB_OPENGL", "")
    if otro and otro not in OPENGL:
        raise Fallo(f"LAB_OPENGL: no conozco «{otro}»; {' '.join(OPENGL)}")
    return todos + OPENGL.get(otro, [])


def faltan(paquetes):
    """Los que no están instalados. El opcional, solo si existe."""
    dice = escrito("dpkg-query", "-W", "-f=${Package} ${db:Status-Status}\n", *paquetes, OPCIONAL)
    puestos = {linea.split()[0] for linea in dice.splitlines() if linea.endswith(" installed")}
    lista = sorted({*paquetes} - puestos)
    return lista + ([OPCIONAL] if OPCIONAL not in puestos and existe(OPCIONAL) else [])


def en_otros(paquetes):
    """Cómo se llaman en otros sistemas."""
    suyas = [fila for fila in TABLA if fila is TABLA[0] or fila[0] in {*paquetes, OPCIONAL}]
    dice = "Los paquetes que hacen falta, como se llaman en cada sistema; los de Fedora y Arch, sin probar:"
    return "\n".join([dice, *("  {0:<19} {2:<29} {3}".format(*fila) for fila in suyas)])


def cuesta(lista):
    """Lo que dice apt que se descarga y que ocuparán."""
    dice = escrito("apt-get", "install", "-s", "-o", "Debug::NoLocking=1", "--no-install-recommends", *lista)
    nuevos = len(re.findall("^Inst ", dice, re.M))
    uris = escrito("apt-get", "install", "--print-uris", "-qq", "--no-install-recommends", *lista)
    bytes_ = sum(int(linea.split()[2]) for linea in uris.splitlines() if len(linea.split()) > 2)
    return f"{nuevos} paquetes con los que piden, y se descargan {bytes_ / 1e6:.0f} MB" if nuevos else ""


def apt(como, registro, *palabras):
    """Estado con que acaba. En una terminal enseña por dónde va. En el grupo de quien lo llama: sudo pregunta."""
    orden = [*como, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", *palabras]
    with open(registro, "a", errors="replace") as escribe:
        proceso = subprocess.Popen(orden, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        for linea in proceso.stdout:
            escribe.write(linea)
            if AVANCE.match(linea):
                por_donde(linea)
    por_donde()
    return proceso.wait()


def instala(paquetes, build):
    """Los que falten. Un Fallo, si no se puede."""
    if not shutil.which("apt-get") or not shutil.which("dpkg-query"):
        if all(shutil.which(quien) for quien in ("cmake", "c++", "ninja")):
            return
        print(en_otros(paquetes), file=sys.stderr)
        raise Fallo("solo sé instalar en Debian y derivados")
    lista = faltan(paquetes)
    if not lista:
        return
    if os.environ.get("LAB_SIN_INSTALAR") == "1":
        imprescindibles = [p for p in lista if p in PARA_USAR]
        if imprescindibles:
            raise Fallo(f"con LAB_SIN_INSTALAR no instalo nada, y faltan {' '.join(imprescindibles)}")
        return
    como = []
    if os.getuid():
        if not shutil.which("sudo"):
            pide = f"pide a quien administra la máquina: apt-get install --no-install-recommends {' '.join(lista)}"
            raise Fallo(f"faltan paquetes y no hay sudo; {pide}")
        como = ["sudo"]
    registro = build / "instala.log"
    registro.unlink(missing_ok=True)
    print(f"Instalo {'con sudo ' if como else ''}los paquetes que faltan: {' '.join(lista)}", file=sys.stderr)
    if apt(como, registro, "update", "-qq"):
        print("lab: apt-get update ha fallado; pruebo con las listas que hay", file=sys.stderr)
    lista = faltan(paquetes)  # ahora se sabe si el opcional existe
    if dice := cuesta(lista):
        print(f"Son {dice}", file=sys.stderr, flush=True)
    if apt(como, registro, "install", "-y", "-q", "--no-install-recommends", *lista):
        print(*registro.read_text().splitlines()[-5:], sep="\n", file=sys.stderr)
        raise Fallo(f"no se han podido instalar (¿hay red?): {' '.join(lista)}")
    if "Operation was interrupted" in registro.read_text():  # sudo se queda con el Ctrl+C y no nos llega
        print("Interrumpido, con los paquetes ya puestos", file=sys.stderr)
        raise SystemExit(130)
