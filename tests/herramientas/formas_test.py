"""La forma del código, que un compilador no ve: cuánto pesa y cómo está escrito."""
import re
import shutil
import subprocess
from pathlib import Path

import pytest

RAIZ = Path(__file__).parents[2]
HERRAMIENTAS, PRUEBAS = RAIZ / "herramientas", RAIZ / "tests"
PYTHON = sorted(f for carpeta in ("herramientas", "tests") for f in (RAIZ / carpeta).rglob("*.py"))
CPP = sorted(f for carpeta in ("common", "herramientas", "tests", "assets") for f in (RAIZ / carpeta).rglob("*.*"))
CPP = [f for f in [*CPP, *sorted(RAIZ.glob("ch*/*.*"))] if f.suffix in (".cpp", ".h")]
SHADERS = [f for en in ("ch*/*", "common/**/*") for f in RAIZ.glob(en) if f.suffix in (".vert", ".frag", ".glsl")]
BASH = [RAIZ / "lab", *sorted(PRUEBAS.rglob("*.sh"))]
ANCHO = 120
# Líneas que puede tener cada carpeta, sin lo que es dato: lo que se añade se paga con lo que se quita.
PESO = {"tests": 22273, "herramientas": 29509, "common": 2895}
SON_DATOS = re.compile(r"tests/(golden|mutantes|fuzz/semillas)|.*(\.(ppm|encima|pasos|png|webp)|/package-lock\.json)$")


def falla(hallados):
    assert not hallados, "\n".join(hallados)


def corto(fichero):
    return str(fichero.relative_to(RAIZ))


def test_ningun_shader_es_igual_que_otro():
    """Por su texto se sabe de qué fichero es el que OpenGL ha recibido, al explicar un cuadro."""
    de = {}
    for f in sorted(SHADERS):
        de.setdefault((f.suffix, f.read_text()), []).append(corto(f))
    falla([" = ".join(iguales) for iguales in de.values() if len(iguales) > 1])


@pytest.mark.parametrize("carpeta", PESO)
def test_no_pesa_mas(carpeta):
    r = subprocess.run(["git", "ls-files", carpeta], cwd=RAIZ, text=True, capture_output=True)
    ficheros = [RAIZ / f for f in r.stdout.split() if not SON_DATOS.match(f)]
    assert sum(f.read_bytes().count(b"\n") for f in ficheros if f.is_file()) <= PESO[carpeta]


def test_ninguna_linea_es_ancha():
    """Tampoco un comentario de C++, que clang-format no toca, ni el JavaScript, que no tiene quien le dé formato."""
    js = [f for en in (HERRAMIENTAS, PRUEBAS) for f in en.rglob("*.*") if f.suffix in (".js", ".mjs")]
    for f in [*BASH, *PYTHON, *CPP, *js]:
        lineas = enumerate(f.read_text().splitlines(), 1)
        falla([f"{corto(f)}:{n}: {len(linea)} columnas" for n, linea in lineas if len(linea) > ANCHO])


ESCRITO = [
    (f"black -l {ANCHO} --check", "23", PYTHON),
    ("pyflakes3", "", PYTHON),
    ("clang-format --dry-run -Werror", "14", CPP),
    ("shellcheck -s bash -e SC1091,SC2015,SC2094,SC2154,SC2329", "", BASH),
]


@pytest.mark.parametrize("orden,version,ficheros", ESCRITO)
def test_esta_escrito_como(orden, version, ficheros):
    """Sin nada que decir. Otra versión de los que dan formato lo da de otra manera."""
    orden = orden.split()
    if not shutil.which(orden[0]):
        pytest.skip(f"no hay {orden[0]}")
    es = subprocess.run([orden[0], "--version"], text=True, capture_output=True).stdout
    if version and not re.search(rf"\b{version}\.\d", es):
        pytest.skip(f"{es.strip()}: se compara con la {version}")
    r = subprocess.run([*orden, *ficheros], cwd=RAIZ, text=True, capture_output=True)
    assert r.returncode == 0, (r.stdout + r.stderr)[-3000:]
