"""La forma del código, que un compilador no ve: quién usa qué, cómo de largo es y cómo está escrito."""
import ast
import functools
import graphlib
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
BASH = [RAIZ / "lab", *sorted(PRUEBAS.rglob("*.sh"))]
MAXIMO = 60  # líneas de una función: una más larga se desempaqueta poniendo nombres
ANCHO = 120
PISOS = {
    "base": 0,
    "documentos": 1,
    "ejercicios": 1,
    "explica": 1,
    "galeria": 1,
    "informe": 1,
    "web": 1,
    "windows": 2,
    "pruebas": 3,
}


def falla(hallados):
    assert not hallados, "\n".join(hallados)


def corto(fichero):
    return str(fichero.relative_to(RAIZ))


# --- quién usa qué --------------------------------------------------------------------------------------------------


def modulos():
    """De cada módulo de herramientas/, los que importa."""
    hay = {".".join(f.relative_to(HERRAMIENTAS).with_suffix("").parts): f for f in HERRAMIENTAS.rglob("*.py")}
    grafo = {modulo: set() for modulo in hay}
    for modulo, fichero in hay.items():
        for nodo in ast.walk(ast.parse(fichero.read_text())):
            if isinstance(nodo, ast.Import):
                grafo[modulo] |= {nombre.name for nombre in nodo.names}
            elif isinstance(nodo, ast.ImportFrom):
                grafo[modulo] |= {nodo.module, *(f"{nodo.module}.{nombre.name}" for nombre in nodo.names)}
        grafo[modulo] &= hay.keys()
    return grafo


def test_los_import_van_hacia_abajo():
    """De un cuarto de herramientas/ a los de los pisos de debajo, y dentro de uno, sin círculos."""
    grafo = modulos()
    list(graphlib.TopologicalSorter(grafo).static_order())
    cuartos = [(m.split(".")[0], u.split(".")[0], f"{m} importa {u}") for m, usa in grafo.items() for u in usa]
    assert len(cuartos) > 50
    falla([que for suyo, otro, que in cuartos if suyo != otro and PISOS[suyo] <= PISOS[otro]])


def sin_comentarios(fichero):
    """Lo que de un fuente se ejecuta: en Python, sus textos que no son documentación."""
    texto = fichero.read_text()
    if fichero.suffix == ".py":
        arbol = ast.parse(texto)
        sueltos = {id(n.value) for n in ast.walk(arbol) if isinstance(n, ast.Expr)}
        textos = [n for n in ast.walk(arbol) if isinstance(n, ast.Constant) and id(n) not in sueltos]
        return "\n".join(n.value for n in textos if isinstance(n.value, str))
    return re.sub(r"(//|(?<![\w$])#(?!include)).*", "", texto)


def test_solo_las_pruebas_usan_tests():
    ficheros = [*HERRAMIENTAS.rglob("*.*"), *RAIZ.glob("common/**/*.*"), *RAIZ.glob("ch*/*.*")]
    fuentes = [f for f in ficheros if f.suffix in (".py", ".cpp", ".h", ".txt", ".cmake", ".glsl", ".vert", ".frag")]
    assert len(fuentes) > 400
    suyos = [f for f in fuentes if HERRAMIENTAS / "pruebas" not in f.parents and "tests/" in sin_comentarios(f)]
    falla([corto(f) for f in suyos])
    partes = re.findall(r"^(\w+)\(\) \{ *\n(.*?)^\}|^([^\n]+)$", sin_comentarios(RAIZ / "lab"), re.M | re.S)
    usan = [(funcion, linea) for funcion, cuerpo, linea in partes if re.search(r"(?<!-)\btests\b", cuerpo or linea)]
    de_lab = {funcion or linea.split(")")[0] for funcion, linea in usan}
    assert de_lab == {
        "documentos",
        "dora",
        "dora_aparte",
        "para_dorar",
        "dibuja_golden",
        "prueba | dora | muta",
    }, de_lab


def usos():
    """Cada fichero de un capítulo que se incluye o se carga desde otro (o desde common/), y desde dónde."""
    hay = {}
    for fuente in (*RAIZ.glob("common/**/*.*"), *RAIZ.glob("ch*/*.*")):
        if fuente.suffix in (".cpp", ".h", ".vert", ".frag", ".glsl"):
            for capitulo, fichero in re.findall(r'"(ch\d\d)_\w+/([\w.]+)"', fuente.read_text()):
                if not fuente.parent.name.startswith(capitulo):
                    hay.setdefault(f"{capitulo}/{fichero}", []).append(corto(fuente))
    return hay


def test_lo_publico_de_cada_capitulo():
    """Lo que un capítulo usa de otro es justo lo que CONTRIBUTING llama público; `objeto.*` es objeto.h, .vert…"""
    dice = (RAIZ / "CONTRIBUTING.md").read_text()
    lista = re.search(r"De otro capítulo solo se usa lo público:(.*?)\.\s+La prueba `formas`", dice, re.S)[1]
    publico = {
        f"{capitulo}/{fichero}"
        for capitulo, ficheros in re.findall(r"(ch\d\d)((?:\s*`[^`]+`,?)+)", lista)
        for fichero in re.findall(r"`([^`]+)`", ficheros)
    }
    usado = usos()
    comodin = {nombre: re.sub(r"\.\w+$", ".*", nombre) for nombre in usado}
    assert not {n: usado[n] for n in usado if n not in publico and comodin[n] not in publico}
    assert not {p for p in publico if p not in usado and p not in comodin.values()}, "nadie los usa"


def test_ningun_shader_es_igual_que_otro():
    """Por su texto se sabe de qué fichero es el que OpenGL ha recibido, al explicar un cuadro."""
    de = {}
    for f in sorted([*RAIZ.glob("ch*/*.vert"), *RAIZ.glob("ch*/*.frag"), *RAIZ.glob("common/**/*.vert")]):
        de.setdefault((f.suffix, f.read_text()), []).append(corto(f))
    assert len(de) > 80
    falla([" = ".join(iguales) for iguales in de.values() if len(iguales) > 1])


# De cada cabecera, lo de std que la necesita: la que una versión del compilador trae sin pedirla, otra no. De lo que
# traen casi todas (size_t, pair, begin…) no se pregunta.
CABECERAS = {
    "algorithm": "sort|(min|max)_element|(find|count|copy|remove)_if|find|count|(any|all|none)_of|fill|reverse|unique|"
    "clamp|shuffle|transform|(lower|upper)_bound|min|max",
    "cctype": "is(alpha|digit|alnum|space|xdigit)|to(lower|upper)",
    "cmath": "sqrt|sin|cos|tan|atan2?|acos|asin|pow|exp|log(2|10)?|floor|ceil|l?l?round|fmod|hypot|is(nan|finite|inf)",
    "cstdint": "u?int(8|16|32|64|ptr)_t",
    "cstdio": "f?printf|snprintf|fputs|puts|fopen|fclose|fflush|fread|fwrite|FILE",
    "cstdlib": "exit|getenv|strto[fdl]|atoi|atof|abort|system|_Exit|atexit",
    "cstring": "mem(cpy|cmp|set|move)|str(len|n?cmp|error|chr|str)",
    "fstream": "[io]?fstream",
    "functional": "function|greater|less|plus|minus",
    "iostream": "cout|cerr|cin",
    "limits": "numeric_limits",
    "memory": "(unique|shared)_ptr|make_(unique|shared)",
    "numeric": "accumulate|iota|inner_product|partial_sum",
    "random": "mt19937|uniform_\\w+_distribution",
    "sstream": "[io]?stringstream",
    "stdexcept": "(runtime|logic)_error|invalid_argument|out_of_range",
    "string": "string|to_string|sto[idf]",
    "type_traits": "is_\\w+_v|conditional_t|decay_t",
    **{c: c for c in "array atomic bitset chrono complex deque filesystem list map mutex optional regex set".split()},
    **{c: c for c in "string_view thread tuple unordered_map variant vector".split()},
}


@functools.cache
def incluye(fichero):
    """Las cabeceras del sistema que trae, también por las suyas."""
    hay = set(re.findall("#include <(.*)>", fichero.read_text()))
    for nombre in re.findall('#include "(.*)"', fichero.read_text()):
        al_lado = (fichero.parent / nombre).resolve()
        otras = [al_lado] if al_lado in CPP else [f for f in CPP if str(f).endswith(f"/{nombre}")]
        hay |= {cabecera for otra in otras[:1] if otra != fichero for cabecera in incluye(otra)}
    return hay


def test_cada_fuente_incluye_lo_que_usa():
    """Él o las cabeceras suyas que incluye: la precompilada, que no siempre hay, no cuenta."""
    usa = {
        f: {
            c
            for c, nombres in CABECERAS.items()
            if re.search(rf"\bstd::({nombres})\b", re.sub("//.*", "", f.read_text()))
        }
        for f in CPP
    }
    assert len(set().union(*usa.values())) > 20
    falla([f"{corto(f)}: falta <{c}>" for f in CPP for c in sorted(usa[f] - incluye(f))])


# --- cómo de largo es -----------------------------------------------------------------------------------------------

NO_ES_FUNCION = re.compile(r"\s*(template.*> )?(namespace|struct|class|enum|union|extern)\b|.*= \{$")


def de_cpp(texto):
    """(por dónde empieza, cuántas líneas) de cada función, como las deja clang-format: desde la última línea con el
    sangrado de la llave que la cierra, que es 0 o 4 (los métodos). De paso salen los bloques de dentro, más cortos."""
    sin_literales = re.sub(r'R"\(.*?\)"', lambda m: '""' + m[0].count("\n") * "\n", texto, flags=re.S)
    lineas = sin_literales.splitlines()
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


def de_python(texto):
    for nodo in ast.walk(ast.parse(texto)):
        if isinstance(nodo, (ast.FunctionDef, ast.Lambda)):
            yield nodo.lineno, nodo.end_lineno - nodo.lineno + 1


@pytest.mark.parametrize("ficheros,funciones", [(CPP, de_cpp), (PYTHON, de_python)], ids=["C++", "Python"])
def test_ninguna_funcion_es_larga(ficheros, funciones):
    todas = [(f, *funcion) for f in ficheros for funcion in funciones(f.read_text())]
    assert len(todas) > 300
    falla([f"{corto(f)}:{n}: {cuantas} líneas" for f, n, cuantas in todas if cuantas > MAXIMO])


def test_se_cuentan_las_funciones_y_los_metodos():
    cuerpo = ["    a();", "    if (b) {", "        c();", "    }", "", "    // d"]
    funcion = ["static void f(int a,", "              int b) {", *cuerpo, "}"]
    metodo = ["class K {", "public:", "    void g() {", *("    " + linea for linea in cuerpo), "    }", "};"]
    espacio = ["namespace {", "const int D[] = {", "    1,", "};", *funcion, "} // namespace"]
    assert (1, 9) in de_cpp("\n".join(funcion)) and list(de_cpp("\n".join(espacio))) == [(8, 3), (5, 9)]
    assert max(n for _, n in de_cpp("\n".join(metodo))) == 8
    assert list(de_python("a\ndef f():\n    def g():\n        b\n    c\n")) == [(2, 4), (3, 2)]


def test_ninguna_linea_es_ancha():
    """Tampoco un comentario de C++, que clang-format no toca, ni el JavaScript, que no tiene quien le dé formato."""
    ficheros = [
        *BASH,
        *PYTHON,
        *CPP,
        *(f for tipo in ("mjs", "js") for en in (HERRAMIENTAS, PRUEBAS) for f in en.rglob(f"*.{tipo}")),
    ]
    lineas = [(f, n, linea) for f in ficheros for n, linea in enumerate(f.read_text().splitlines(), 1)]
    falla([f"{corto(f)}:{n}: {len(linea)} columnas" for f, n, linea in lineas if len(linea) > ANCHO])


# --- cómo está escrito ----------------------------------------------------------------------------------------------

SHELLCHECK = "shellcheck -s bash -e SC1091,SC2015,SC2094,SC2154,SC2329".split()


@pytest.mark.parametrize(
    "orden,version,ficheros",
    [
        (["black", "-l", str(ANCHO), "--check"], "23", PYTHON),
        (["pyflakes3"], "", PYTHON),
        (["clang-format", "--dry-run", "-Werror"], "14", CPP),
        (SHELLCHECK, "", BASH),
    ],
    ids=["black", "pyflakes3", "clang-format", "shellcheck"],
)
def test_esta_escrito_como(orden, version, ficheros):
    """Sin nada que decir. Otra versión de los que dan formato lo da de otra manera."""
    if not shutil.which(orden[0]):
        pytest.skip(f"no hay {orden[0]}")
    es = subprocess.run([orden[0], "--version"], text=True, capture_output=True).stdout
    if version and not re.search(rf"\b{version}\.\d", es):
        pytest.skip(f"{es.strip()}: se compara con la {version}")
    r = subprocess.run([*orden, *ficheros], cwd=RAIZ, text=True, capture_output=True)
    assert r.returncode == 0, (r.stdout + r.stderr)[-3000:]


# --- lo que acaba antes que quien le escribe ------------------------------------------------------------------------

SE_VA = re.compile(
    r"(?<!\|)\|&?\s*(head\b|grep\s+(-\S+\s+)*-\w*[qm]|sed\b[^|]*?[\s;'0-9$]q\b|awk\b[^|]*\bexit\b|read\b)"
)


def se_van(guion):
    """Sus tuberías hacia quien puede acabar antes de leerlo todo: con pipefail, a quien escribe lo mata SIGPIPE si aún
    no había acabado, y el guion falla una vez de tantas."""
    sin_comentarios = re.sub(r"(^|\s)#.*", "", guion, flags=re.M)
    return [m[0] for m in SE_VA.finditer(re.sub(r"\\\n|(?<=\|)\s*\n", " ", sin_comentarios))]


def test_nadie_escribe_a_quien_se_va():
    con_pipefail = [RAIZ / "lab", RAIZ / ".ci/run", *sorted(RAIZ.glob("tests/**/*.sh"))]  # los demás los incluyen ellos
    assert len(con_pipefail) > 15
    falla([f"{corto(f)}: {tuberia}" for f in con_pipefail for tuberia in se_van(f.read_text())])
    for mala in "head|grep -q x|grep -v -Fq x|sed 2q|sed -n '/x/{p;q}'|awk '{ print; exit }'|read x".split("|"):
        assert se_van(f"a | {mala}\n") and se_van(f"a |\n  {mala}"), mala
    assert not se_van("a || head b\ngrep -q x <a\na | sed 's/q/x/' | grep -v q | awk '{ print }' # | head")
