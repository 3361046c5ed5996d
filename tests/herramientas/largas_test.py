"""Ninguna función de C++ pasa de 60 líneas: una más larga se desempaqueta poniendo nombres."""

import re
from pathlib import Path

import pytest

RAIZ = Path(__file__).parents[2]
MAXIMO = 60
NO_ES_FUNCION = re.compile(r"\s*(template.*> )?(namespace|struct|class|enum|union|extern)\b|.*= \{$")


def funciones(lineas):
    """(por dónde empieza, cuántas líneas) de cada función, como las deja clang-format: desde la última línea con el sangrado de la llave que
    la cierra, que es 0 o 4 (los métodos). De paso salen los bloques de dentro, que son más cortos."""
    empieza = {}
    for n, linea in enumerate(lineas, 1):
        texto = linea.lstrip(" ")
        sangrado = len(linea) - len(texto)
        if sangrado > 4 or not texto or re.match(r"#|//|(public|private|protected):|template<.*>$|[\])]", texto):
            continue
        if texto[0] == "}":
            principio = empieza.pop(sangrado, None)
            if principio and not NO_ES_FUNCION.match(lineas[principio - 1]):
                yield principio, n - principio + 1
        else:
            empieza[sangrado] = n


def largas(fichero):
    sin_literales = re.sub(r'R"\(.*?\)"', lambda m: '""' + m[0].count("\n") * "\n", fichero.read_text(), flags=re.S)
    lineas = sin_literales.splitlines()
    return [
        f"{fichero.relative_to(RAIZ)}:{n}: {cuantas} líneas: {lineas[n - 1].strip()}"
        for n, cuantas in funciones(lineas)
        if cuantas > MAXIMO
    ]


@pytest.mark.parametrize("carpeta", ["common", "herramientas", "tests"])
def test_ninguna_funcion_pasa_de_60_lineas(carpeta):
    ficheros = sorted(f for f in (RAIZ / carpeta).rglob("*.*") if f.suffix in (".cpp", ".h"))
    assert len(ficheros) > 20
    assert "\n".join(x for f in ficheros for x in largas(f)) == ""


def test_se_cuentan_las_funciones_y_los_metodos():
    cuerpo = ["    a();", "    if (b) {", "        c();", "    }", "", "    // d"]
    funcion = ["static void f(int a,", "              int b) {", *cuerpo, "}"]
    metodo = ["class K {", "public:", "    void g() {", *("    " + linea for linea in cuerpo), "    }", "};"]
    espacio = ["namespace {", "const int D[] = {", "    1,", "};", *funcion, "} // namespace"]
    assert (1, 9) in funciones(funcion)
    assert max(n for _, n in funciones(metodo)) == 8
    assert list(funciones(espacio)) == [(8, 3), (5, 9)]
