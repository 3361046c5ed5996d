"""Quien juzga, juzgado: a cada uno se le enseña lo bueno, que da por bueno, y lo mismo con una sola cosa mal, de cada
componente, lado y clase, que tiene que decir. Lo que dan los programas es de mentira: ficheros que se copian."""
import ast
import copy
import inspect
import itertools
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))
sys.path[:0] = [str(RAIZ / carpeta) for carpeta in ("herramientas", "tests/casos", "tests/paginas", "tests/ordenes")]
from pruebas import documentos, evidencia
import compara_encima
from mentira import ejecutable, siembra


def dice(*orden, **entorno):
    """Con qué estado acaba, y lo que escribe."""
    como = {"text": True, "stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    r = subprocess.run(list(map(str, orden)), **como, env={**os.environ, **entorno}, timeout=200)
    return r.returncode, r.stdout


def ppm(ancho, alto, *puntos, fondo=(242, 245, 250)):
    """De ese fondo, con esos puntos (x, y desde abajo, color)."""
    filas = [[fondo] * ancho for _ in range(alto)]
    for x, y, color in puntos:
        filas[alto - 1 - y][x] = color
    return b"P6\n# sello\n%d %d\n255\n" % (ancho, alto) + bytes(c for fila in filas for p in fila for c in p)


def con(color, componente, cuanto):
    return tuple(c + cuanto * (i == componente) for i, c in enumerate(color))


# --- lo que se pinta encima ------------------------------------------------------------------------------------------

IMAGEN = ["a.ppm", "240", "180"]
TRAZOS = [
    "rotulo|0.1 0.2 0.3|0 0 240 180|8|0|1 2 0 30 10 0.5 15 6 0|la grúa",
    "segmentos|0.4 0.5 0.6|0 0 120 180|2|1|1 2 0.1 3 4 0.2 5 6 0.3|",
    "puntos|0.7 0.8 0.9|120 0 120 180|5|1|7 8 0.4|",
]


def test_lo_que_se_pinta_encima():
    trazos = [t.split("|") for t in TRAZOS]

    def distinto(trazos_de_ahora, imagen=tuple(IMAGEN), mas=()):
        hay = compara_encima.compara([(IMAGEN, trazos)], [(list(imagen), trazos_de_ahora), *mas])
        return list(hay)

    assert not distinto(trazos)
    for i, trazo in enumerate(trazos):
        for k, (campo, texto) in enumerate(zip(compara_encima.CAMPOS, trazo)):
            cambia = [texto + "x"]
            if cotas := compara_encima.DISTA.get(campo):
                numeros = texto.split()
                uno = lambda j, v: " ".join([*numeros[:j], str(v), *numeros[j + 1 :]])
                cambia = [" ".join(numeros[:-3]), f"{texto} 1 2 3"] if len(numeros) > 1 else []
                for j, cota in ((j, cotas[j % len(cotas)]) for j in range(len(numeros))):
                    cambia += [uno(j, float(numeros[j]) + s * 1.2 * cota) for s in (1, -1)] + [uno(j, "nan")]
                    for casi in (uno(j, float(numeros[j]) + s * 0.8 * cota) for s in (1, -1)):
                        assert not distinto([*trazos[:i], [*trazo[:k], casi, *trazo[k + 1 :]], *trazos[i + 1 :]]), casi
            for otro in cambia:
                hay = distinto([*trazos[:i], [*trazo[:k], otro, *trazo[k + 1 :]], *trazos[i + 1 :]])
                assert hay and f"trazo {i + 1}, " in hay[0] and campo.split()[-1] in " ".join([*hay, campo]), (
                    campo,
                    otro,
                )
        assert any("falta" in h for h in distinto(trazos[:i] + trazos[i + 1 :]))
        assert any("sobra" in h for h in distinto([*trazos[: i + 1], trazo, *trazos[i + 1 :]]))
    for orden in itertools.permutations(trazos):
        assert bool(distinto(list(orden))) == (list(orden) != trazos)
    for k in range(3):
        assert distinto(trazos, con_otro(IMAGEN, k))
    assert distinto(trazos, mas=[(IMAGEN, [])]) and list(compara_encima.compara([(IMAGEN, trazos)], []))
    assert list(compara_encima.compara([], [(IMAGEN, trazos)]))


def con_otro(lista, k):
    return [*lista[:k], lista[k] + "1", *lista[k + 1 :]]


# --- lo que toca el borde, y lo que queda ----------------------------------------------------------------------------

LADOS = "izquierdo", "derecho", "de abajo", "de arriba"


def fondos():
    """Los colores que tienen por fondo, de colores.h."""
    nombrados = re.search(r": \{(FONDO_[^}]*)\}", (RAIZ / "tests/casos/borde.cpp").read_text())[1].split(", ")
    paleta = (RAIZ / "common/encima/colores.h").read_text()
    for nombre in nombrados:
        rgb = re.search(rf"\b{nombre}\(([^)]*)\)", paleta)[1]
        yield tuple(int(255 * float(c.strip(" f")) + 0.5) for c in rgb.split(","))


def test_el_borde(tmp_path):
    """Cada píxel de los cuatro lados, y cada componente, en más y en menos de lo que se perdona."""
    ancho, alto, ficheros = 6, 5, {}
    for n, fondo in enumerate(fondos()):
        for x, y in itertools.product(range(ancho), range(alto)):
            toca = [lado for lado, es in zip(LADOS, (x == 0, x == ancho - 1, y == 0, y == alto - 1)) if es]
            for k, s in itertools.product(range(3), (-2, -1, 1, 2)):
                fichero = f"{n}_{x}_{y}_{k}_{s}.ppm"
                ficheros[fichero] = toca if abs(s) == 2 else []
                (tmp_path / fichero).write_bytes(ppm(ancho, alto, (x, y, con(fondo, k, s)), fondo=fondo))
    estado, dicho = dice(BUILD / "tests/borde", *(tmp_path / f for f in ficheros))
    hay = {f: re.findall(rf"{f}: 1 píxeles del borde (.*) no son fondo", dicho) for f in ficheros} if n < 1 else {}
    for fila in dicho.splitlines():
        fichero, lado = re.fullmatch(r".*/(\S+): 1 píxeles del borde (.*) no son fondo", fila).groups()
        hay.setdefault(fichero, []).append(lado)
    assert estado == 1 and n == 3 and {f: l for f, l in hay.items() if l} == {f: l for f, l in ficheros.items() if l}
    bien, mal = ([tmp_path / f for f, l in ficheros.items() if bool(l) == toca][0] for toca in (False, True))
    for orden, esperado in (((bien,), 0), ((bien, mal), 1), ((mal, bien), 1), ((bien, bien), 0)):
        assert dice(BUILD / "tests/borde", *orden)[0] == esperado


@pytest.mark.parametrize("lado", range(4))
def test_lo_que_puede_estar_cortado(tmp_path, lado):
    """Por el lado que se dice, en una imagen al menos; por los demás, en ninguna."""
    nombres, x, y = ("izquierda", "derecha", "abajo", "arriba"), (0, 5, 2, 2)[lado], (2, 2, 0, 4)[lado]
    for fichero, puntos in (("no.ppm", []), ("si.ppm", [(x, y, (9, 9, 9))])):
        (tmp_path / fichero).write_bytes(ppm(6, 5, *puntos))
    for cuantos in range(5):
        for corta in itertools.combinations(nombres, cuantos):
            bien = corta == (nombres[lado],)
            for ficheros in ("no.ppm", "si.ppm"), ("si.ppm", "no.ppm"):
                orden = "--corta", " ".join(corta), *(tmp_path / f for f in ficheros)
                assert dice(BUILD / "tests/borde", *orden)[0] == (not bien), corta
    assert dice(BUILD / "tests/borde", "--corta", nombres[lado], tmp_path / "no.ppm")[0] == 1


def test_lo_que_queda(tmp_path):
    """El 0.5 % de los píxeles, y uno menos."""
    for cuantos, esperado in ((0, 1), (1, 1), (2, 0), (3, 0)):
        puntos = [(x, 3, (9, 9, 9)) for x in range(cuantos)]
        (tmp_path / "i.ppm").write_bytes(ppm(20, 20, *puntos))
        estado, dicho = dice(BUILD / "tests/borde", "--queda", tmp_path / "i.ppm")
        assert estado == esperado and bool(dicho) == bool(esperado)


# --- lo que no es un número ------------------------------------------------------------------------------------------

PHONG = "ch05_iluminacion/sombreado_phong.frag"
NO_SON = {"sqrt(-1.0 - La.x)": "-?nan", "1.0 / (La.x - La.x)": "inf", "-1.0 / (La.x - La.x)": "-inf"}
osmesa = pytest.mark.skipif(not (BUILD / "tests/libfinitos.so").exists(), reason="solo con OSMesa")


def estropea(raiz, que):
    siembra(raiz, {PHONG: re.sub("colorFragmento = .*", rf"\g<0> {que}", (RAIZ / PHONG).read_text(), count=1)})
    return {"LAB_RAIZ": str(raiz)}


@osmesa
def test_lo_que_no_es_un_numero(tmp_path):
    """NaN y los dos infinitos, en cada componente; en lo que se lee de la ventana y en encuadre."""
    programa = BUILD / "osmesa/ch05_iluminacion/materiales"
    chica = "-geometry", "40x30", "-ppm", "/dev/null"
    finitos = {"LD_PRELOAD": str(BUILD / "tests/libfinitos.so")}
    assert dice(programa, *chica, **finitos, **estropea(tmp_path, ""))[0] == 0
    for donde, que in itertools.product("rgba", NO_SON):
        estado, dicho = dice(programa, *chica, **finitos, **estropea(tmp_path, f"colorFragmento.{donde} = {que};"))
        assert estado == 4 and re.search(f"finitos: un color {NO_SON[que]} en", dicho), (donde, que, dicho)
    encuadre = RAIZ / "tests/casos/casos.sh", BUILD, "encuadre", "materiales"
    assert dice(*encuadre)[0] == 0 and "finitos: " in dice(*encuadre, LAB_RAIZ=str(tmp_path))[1]


# --- casos.sh --------------------------------------------------------------------------------------------------------

FALSO = """da=$(dirname "$0")/da
cat "$da/salida"
cat "$da/errores" >&2
while [ $# -gt 0 ]; do
  case $1 in -ppm) ppm=$2 ;; -guion) guion=$2 ;; esac
  shift
done
case $guion in @*) guion=$(cat "${guion#@}") ;; esac
for f in $ppm $(echo "$guion" | tr ';' '\\n' | sed -n 's/^ *captura //p'); do
  cp "$da/$f" "$f" 2>/dev/null || cp "$da/imagen" "$f" 2>/dev/null
done
[ -z "$LAB_ENCIMA" ] || cp "$da/encima" "$LAB_ENCIMA"
exit "$(cat "$da/estado")"
"""
PUNTOS = [(x, y, (217, 51, 46)) for x in range(4, 8) for y in range(4, 8)]
BUENA, CIEGA = ppm(12, 12, *PUNTOS), ppm(12, 12)
TOCA = ppm(12, 12, *PUNTOS, (0, 6, (0, 0, 0)))
CASI = ppm(12, 12, *PUNTOS[1:], (4, 4, (218, 51, 46)))
OTRA = ppm(12, 12, *PUNTOS[1:], (4, 4, (219, 51, 46)))
ENCIMA = "".join(f"imagen\t{n}\t12\t12\n" + "\t".join(TRAZOS[2].split("|")) + "\n" for n in ("1", "2", "última"))
DE_PASOS = ENCIMA.partition("imagen\túltima")[0].replace("\t1\t12", "\ttecla a\t12").replace("\t2\t12", "\ttecla b\t12")
TALLAS = "640x360", "480x360", "480x540", "200x450"
# lo que sale bien: lo que da el programa, y sus golden
BIEN = {"da/salida": "título: a\nuno\n", "da/errores": "", "da/estado": "0", "da/imagen": BUENA, "da/encima": ENCIMA}
BIEN |= {"golden/a.ppm": BUENA, "golden/a.txt": "título: a\nuno\n", "golden/a.encima": ENCIMA}
BIEN |= {"golden/a.pasos": "# talla 12x12\n\ntecla a\ntecla b\n", "golden/a-pasos.encima": DE_PASOS}
CASOS = [  # enlace, con qué acaba, lo que dice, lo que se cambia (None: no está) y lo demás del caso
    *((enlace, 0, "", {}) for enlace in ("osmesa", "egl", "encuadre", "pasos", "pies")),
    *(
        (enlace, 1, "estado 3", {"da/estado": "3"}, "cumple='ROJO entero'")
        for enlace in ("osmesa", "egl", "encuadre", "pasos", "pies")
    ),
    *(
        (enlace, 1, "aviso", {"da/errores": "aviso"}, "cumple='ROJO entero'")
        for enlace in ("osmesa", "egl", "encuadre", "pasos", "pies")
    ),
    *((enlace, 1, "ningún caso", {}, "", "otro") for enlace in ("osmesa", "egl", "encuadre", "pies")),
    ("osmesa", None, "a.ppm", {"da/imagen": None}),
    ("osmesa", 1, "1 píxeles|máximo 1 ", {"golden/a.ppm": CASI}),
    ("egl", 0, "máximo 1 ", {"golden/a.ppm": CASI}),
    ("egl", 1, "máximo 2 ", {"golden/a.ppm": OTRA}),
    ("osmesa", 1, "máximo 2 ", {"golden/a.ppm": OTRA}, "tolerancia='5 3 32'"),
    ("egl", 0, "máximo 2 ", {"golden/a.ppm": OTRA}, "tolerancia='5 3 32'"),
    ("osmesa", 1, r"\n\+uno", {"golden/a.txt": "título: a\n"}),
    ("osmesa", 1, r"\n-dos", {"golden/a.txt": "título: a\nuno\ndos\n"}),
    ("osmesa", 1, r"\n-título: b", {"golden/a.txt": "título: b\nuno\n"}),
    ("osmesa", 4, "el punto", {"golden/a.encima": ENCIMA.replace("7 8 0.4", "7 8.1 0.4", 1)}),
    ("osmesa", 4, "no debía pintar", {"golden/a.encima": None}),
    ("osmesa", 4, "no pinta nada", {"da/encima": ""}),
    ("osmesa", 4, r"\+uno", {"da/encima": "", "golden/a.txt": ""}),
    ("osmesa", 1, "falta el golden .*a.ppm", {"golden/a.ppm": None}),
    ("osmesa", 1, "falta el golden .*a.txt", {"golden/a.txt": None}),
    *(("encuadre", 1, f"a-{t}.ppm: 1 píxeles del borde izq", {f"da/a-{t}.ppm": TOCA}) for t in TALLAS),
    *(("encuadre", 1, f"{v}: no se ve", {f"da/{v}": CIEGA}) for v in ("alejada", "desde_arriba", "desde_abajo")),
    *(("encuadre", 0, "", {f"da/a-{t}.ppm": TOCA}, "borde='izquierda: llega'") for t in TALLAS),
    ("encuadre", 1, "sobra «arriba»", {f"da/a-{TALLAS[0]}.ppm": TOCA}, "borde='izquierda arriba: llega'"),
    ("encuadre", 1, "1 píxeles del borde izq", {f"da/a-{TALLAS[0]}.ppm": TOCA}, "borde='derecha: llega'"),
    ("encuadre", 1, "sobra «derecha»", {f"da/a-{TALLAS[0]}.ppm": TOCA}, "borde='todos: llega'"),
    (
        "encuadre",
        1,
        "alejada: no se ve",
        {f"da/a-{TALLAS[0]}.ppm": TOCA, "da/alejada": CIEGA},
        "borde='izquierda: llega'",
    ),
    *(
        ("pasos", 4, f"tecla {p}, trazo 1", {"golden/a-pasos.encima": m})
        for p, m in (
            ("a", DE_PASOS.replace("7 8 0.4", "7 8 0.5", 1)),
            ("b", DE_PASOS[::-1].replace("4.0 8 7", "4.0 8 6", 1)[::-1]),
        )
    ),
    ("pasos", 4, "las imágenes debían ser", {"golden/a-pasos.encima": DE_PASOS.partition("imagen\ttecla b")[0]}),
    ("pasos", 4, "las imágenes debían ser", {"golden/a.pasos": "tecla a\ntecla c\n"}),
    ("pasos", 1, "falta el golden .*-pasos", {"golden/a-pasos.encima": None}),
    ("pies", 0, "", {}, "cumple='ROJO entero'"),
    ("pies", 1, "ROJO", {}, "cumple='ROJO ausente'"),
    ("pies", 1, "ROJO", {"da/base-960x1080.ppm": CIEGA}, "cumple='ROJO entero'"),
]


@pytest.fixture
def taller(tmp_path):
    """Un build de mentira con un programa, y sus golden."""
    for destino in ("osmesa", "egl"):
        (tmp_path / destino / "cap").mkdir(parents=True)
        (tmp_path / destino / "cap/da").symlink_to(tmp_path / "da")
        ejecutable(tmp_path / destino / "cap/a", FALSO)
    (tmp_path / "tests").mkdir()
    for suyo in ("herramientas", "tests/borde", "tests/pies"):
        (tmp_path / suyo).symlink_to(BUILD / suyo)
    siembra(tmp_path, {"sin_ventana": "egl\n", "da/x": "", "golden/cap/x": "", "casos/x": ""})
    return tmp_path


def test_casos(taller):
    mal = []
    for enlace, estado, texto, cambia, *mas in CASOS:
        for fichero, datos in {**BIEN, **cambia}.items():
            f = taller / fichero.replace("golden/", "golden/cap/")
            f.unlink(missing_ok=True)
            if datos is not None:
                f.write_bytes(datos if isinstance(datos, bytes) else datos.encode())
        otros, pedido = (*mas, "", "")[:2]
        (taller / "casos/a.sh").write_text(
            f"capitulo=cap\ncaso nombre=base fichero=a guion= tolerancia= otro= borde= cumple= {otros}\n"
        )
        es, dicho = dice(
            RAIZ / "tests/casos/casos.sh", taller, enlace, "a", *[pedido][: bool(pedido)], GOLDEN=str(taller / "golden")
        )
        if (es != estado and (estado is not None or es == 0)) or not re.search(texto, dicho):
            mal.append(f"{enlace} {list(cambia)} {mas}: {es} y no {estado}, «{texto}»: {dicho}")
        for fichero in cambia.keys() - BIEN.keys():
            (taller / fichero).unlink()
    assert not mal, "\n".join(mal)


# --- docs/ -----------------------------------------------------------------------------------------------------------


def cambia(fichero, viejo, nuevo):
    """En un fichero que está copiado, que tiene que tener eso."""

    def haz(d):
        texto = (d.raiz / fichero).read_text()
        otro = re.sub(viejo, nuevo, texto, count=1)
        assert otro != texto, fichero
        (d.raiz / fichero).write_text(otro)

    return haz


def uno(**campos):
    """El primer programa, con otros hechos."""
    return lambda d: vars(d.programas[0]).update(campos)


def medido(seccion, quien=None, **campos):
    def haz(d):
        de = d.medido[seccion]
        if quien:
            de[quien] = {}
        else:
            next(iter(de.values())).update(campos)

    return haz


FILA = "| 99.1 | x | `lab` | `falla` | `costura.Guion.LeDiceAlPrograma` |\n"
ECUACIONES, ERRATAS, FUENTE = "docs/ecuaciones.md", "docs/erratas.md", "ch10_interaccion/menu.cpp"
MENTIRAS = [  # lo que dice, y lo que se cambia
    *(
        (f"{f.name}: no hay ninguna prueba", cambia(f"docs/{f.name}", r"\Z", "\n`costura.NoEsta.Nada`\n"))
        for f in sorted((RAIZ / "docs").glob("*.md"))
    ),
    *(
        (f"{Path(d).name}: no existe {f}", cambia(d, r"\Z", f"\n{f}\n"))
        for d, f in (("README.md", "noesta.cpp"), ("CONTRIBUTING.md", "common/noesta.h"), ("docs/ci.md", "tests/no.sh"))
    ),
    ("menu.cpp: no existe noesta.h", cambia(FUENTE, r"\A", "// noesta.h\n")),
    ("menu.cpp: no hay ninguna prueba «Nadie.Nada»", cambia(FUENTE, r"\A", "// Nadie.Nada\n")),
    (
        "CONTRIBUTING.md: no hay ninguna prueba «costura.Nadie.Nada»",
        cambia("CONTRIBUTING.md", r"\Z", "costura.Nadie.Nada"),
    ),
    *(
        (f"{Path(d).name}: no hay ningún programa «nadie»", cambia(d, r"\Z", f"\n{dicho}\n"))
        for d, dicho in (("README.md", "Programas `nadie`"), ("docs/soluciones.md", "en `nadie`, tecla `a`"))
    ),
    ("no hay ningún programa «nadie»", cambia(ERRATAS, r"\Z", "\n- **Eso** (`nadie`): x. Sin prueba: no.\n")),
    *(
        (f"{f}: «{cita}» no es ninguna prueba", cambia(f"docs/{f}", r"\Z", f"\n- **x**: y. {dicho}\n"))
        for f, cita, dicho in (
            ("soluciones.md", "Nada", "Pruebas: `costura.Guion.LeDiceAlPrograma`, `Nada`."),
            ("erratas.md", "LeDiceAlPrograma", "Prueba: `costura.GuionDeOtro`, `LeDiceAlPrograma`."),
            ("erratas.md", "nada", "Es así (prueba: `nada`)."),
        )
    ),
    ("menu: ni llama a glNoEsta, del listado 10.1, ni", cambia("docs/libro.tsv", r"(\nL10\.1\t.*)", r"\1 glNoEsta")),
    ("menu: ni llama a glutAttachMenu, del listado 10.1, ni", cambia(FUENTE, "glutAttachMenu", "// glutAttachMenu")),
    ("erratas.md: sin prueba ni", cambia(ERRATAS, r"\Z", "\n- **Nada**: x.\n")),
    ("sin prueba ni «Sin prueba: …»: - **§1.3.1", cambia(ERRATAS, "Sin prueba: es un nombre", "")),
    ("no entiendo «| 3.1 ", cambia(ECUACIONES, r"(\| 3\.1 \|.*) \|\n", r"\1\n")),
    *(
        (f"falta la ecuación {c}.{n}", cambia(ECUACIONES, rf"\| {c}\.{n} \|.*\n", ""))
        for c, n in ((3, 1), (3, 10), (9, 1), (11, 42))
    ),
    ("el libro no tiene ecuación 99.1", cambia(ECUACIONES, r"\Z", FILA)),
    ("99.1: no existe noesta", cambia(ECUACIONES, r"\Z", FILA.replace("`lab`", "`noesta`"))),
    ("99.1: lab no tiene «fall»", cambia(ECUACIONES, r"\Z", FILA.replace("`falla`", "`fall`"))),
    (
        "99.1: no hay ninguna prueba «costura.Nada.Nada»",
        cambia(ECUACIONES, r"\Z", FILA.replace("Guion.LeDiceAlPrograma", "Nada.Nada")),
    ),
    ("falta el ejercicio 3.5", cambia("docs/soluciones.md", r"- \*\*3\.5\*\*", "- **3.55**")),
    ("no tiene comprobación independiente", uno(contra="")),
    ("no tiene comprobación independiente", uno(pruebas=[])),
    ("evidencia.json no es de las pruebas de", uno(pruebas=["costura.Guion.LeDiceAlPrograma"])),
    ("no hay ninguna prueba «a.B.c»", uno(pruebas=["a.B.c"])),
    ("sobra PASA", lambda d: (uno(pasa="sí")(d), medido("programas", maximo=2)(d))),
    ("falta por qué pasa de 2", lambda d: (uno(pasa="")(d), medido("programas", maximo=2.01)(d))),
    ("no hay ningún programa «nadie»", medido("programas", "nadie")),
    (
        "no hay ninguna prueba «a.B.c»",
        cambia("tests/casos_dificiles/casos.tsv", r"\n([^#\t\n]*\t[^\t\n]*)\t.*", r"\n\1\ta.B.c"),
    ),
    ("casos.tsv: falta «dificil_", cambia("tests/casos_dificiles/casos.tsv", r"(\tdificil_\S*)", "")),
    ("evidencia.json no es de las pruebas de", medido("casos", pruebas=0)),
    ("evidencia.json no es de las pruebas de", medido("casos", citas=[])),
    ("no hay ningún caso «nadie»", medido("casos", "nadie")),
    ("evidencia.json no es de los defectos", medido("defectos", "ch99")),
    ("evidencia.json no es de los defectos", medido("sobreviven", "nadie")),
]


def test_lo_que_dicen_los_documentos(tmp_path, monkeypatch):
    """Lo que hay es verdad, y de cada manera de mentir se queja; ninguna queja se queda sin dar."""
    copiados = "docs", "ch10_interaccion", "README.md", "CONTRIBUTING.md", "tests/casos_dificiles"
    for carpeta, aparte in ((RAIZ, ("build", "tests", *copiados)), (RAIZ / "tests", ("casos_dificiles",))):
        (tmp_path / carpeta.relative_to(RAIZ)).mkdir(exist_ok=True)
        for f in carpeta.iterdir():
            if f.name not in aparte:
                (tmp_path / f.relative_to(RAIZ)).symlink_to(f)
    limpio, quejas, mal, lineas = documentos.Documentos(RAIZ, BUILD), [], [], set()
    limpio.medido |= documentos.listas(RAIZ)  # mientras se planta, docs/ es de los defectos de antes

    def apunta(d, que):
        d.fallos += 1
        lineas.add(inspect.currentframe().f_back.f_lineno)
        quejas.append(que)

    monkeypatch.setattr(documentos.Documentos, "mal", apunta)
    monkeypatch.setattr(sys, "argv", ["x"])
    for texto, estropea_algo in [("", lambda _: None), *MENTIRAS]:
        for copiado in copiados:
            shutil.rmtree(tmp_path / copiado, ignore_errors=True)
            (shutil.copytree if (RAIZ / copiado).is_dir() else shutil.copy)(RAIZ / copiado, tmp_path / copiado)
        d = copy.copy(limpio)
        d.raiz, d.programas, d.medido = tmp_path, [copy.copy(p) for p in limpio.programas], copy.deepcopy(limpio.medido)
        estropea_algo(d)
        quejas.clear()
        monkeypatch.setattr(documentos, "Documentos", lambda d=d: d)
        assert documentos.main() == bool(texto), texto
        mal += [] if any(texto in q for q in quejas) == bool(texto) else [f"«{texto}»: {quejas}"]
    fuente = ast.walk(ast.parse(inspect.getsource(documentos)))
    hay = [(n.lineno, n.end_lineno) for n in fuente if isinstance(n, ast.Call) and getattr(n.func, "attr", "") == "mal"]
    assert (mal, [n for n in hay if not lineas & set(range(n[0], n[1] + 1))]) == ([], [])


def test_la_peor_medida():
    """De un programa, la mayor de cada columna, de cualquiera de sus pruebas; de un caso, la más cerca de su cota."""
    p = SimpleNamespace(nombre="a", pruebas=["t.*"])
    nombres = ["t.A.a", "t.A.b", "t.A.c"]
    for orden in itertools.permutations(["1 0.5 0.1 0 9", "2 0.1 0.1 1 9", "0 0 0.25 0 9"]):
        propiedades = {n: {"ejecuta_a": 1, "pixeles_a": m} for n, m in zip(nombres, orden)}
        monta = {"maximo": 2, "rmse": 0.5, "borde": 0.25, "lejos": 1, "banda": 27, "pruebas": ["t.*"]}
        assert evidencia.mide_programa(p, nombres, propiedades) == monta
    with pytest.raises(SystemExit, match="no lo ejecuta"):
        evidencia.mide_programa(p, nombres, {n: {} for n in nombres})
    for orden in itertools.permutations([("1", "10"), ("2", "4"), ("3", "30")]):
        propiedades = {n: {"medida": m, "cota": c, "unidad": "u"} for n, (m, c) in zip(nombres, orden)}
        peor = evidencia.mide_caso(["t.*"], nombres, propiedades)
        assert (peor["medida"], peor["cota"], peor["pruebas"]) == (2, 4, 3)


# --- la integración continua y las páginas ---------------------------------------------------------------------------


def test_la_integracion_continua_falla_si_falla_algo(tmp_path):
    guion = (RAIZ / ".ci/run").read_text()
    siembra(tmp_path, {".ci/run": guion})
    (tmp_path / ".ci/run").chmod(0o755)
    ordenes = len(re.findall(r"(?m)^(?:\w+=\S* )*\./lab", guion))
    assert ordenes >= 2
    for falla in range(ordenes + 1):
        (tmp_path / "veces").write_text("")
        ejecutable(tmp_path / "lab", f'echo >>veces\n[ "$(wc -l <veces)" != {falla} ]')
        assert bool(dice(tmp_path / ".ci/run")[0]) == bool(falla), falla


@pytest.fixture
def navegador(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["x", str(RAIZ), str(BUILD)])
    import navegador

    monkeypatch.setattr(navegador, "fallos", [])
    monkeypatch.setattr(navegador, "axe", lambda: "")
    return navegador


def test_lo_que_se_exige_en_una_pagina(navegador):
    """Lo que no se cumple cuenta, y al acabar se dice todo."""

    def pagina(**da):
        """Lo que contesta a cada cosa que se le pregunta; lo demás, bien."""
        bien = {"200%": "32px", "100%": "16px", "cabe": [True, True], "chicos": [], "axe": []} | da
        cabe = iter(bien["cabe"])
        js = (
            lambda que, *a: bien[a[0]]
            if a
            else bien["chicos"]
            if "chicos" in que or "offsetParent" in que
            else next(cabe, True)
        )
        return SimpleNamespace(js=js, espera_js=lambda _: bien["axe"])

    def falla(**da):
        navegador.fallos.clear()
        for mira in (navegador.proyectable, navegador.accesible):
            mira(pagina(**da), "p")
        navegador.nada_se_sale(pagina(**da), "p", 360)
        return len(navegador.fallos)

    assert falla() == 0
    for mal in (
        {"200%": "16px"},
        {"100%": "32px"},
        {"cabe": [False, True]},
        {"cabe": [True, False]},
        {"chicos": ["p 12px"]},
        {"axe": ["x"]},
    ):
        assert falla(**mal) == 1, mal
    with pytest.raises(SystemExit, match="p es para todos: .*x"):
        navegador.acaba()
    navegador.fallos.clear()
    with pytest.raises(SystemExit) as bien:
        navegador.acaba()
    assert not bien.value.code


def test_una_imagen_de_la_pagina_es_su_golden(navegador):
    caso = navegador.CASOS[0]
    golden = RAIZ / "tests/golden" / caso.programa.capitulo.nombre / f"{caso.fichero}.ppm"
    buena = bytearray(golden.read_bytes())
    for otro in (False, True):
        assert navegador.como_golden(caso, bytes(buena), otro, "", "jueces")[0]
        for y0, x0 in itertools.product((0, 177), (0, 237)):  # una mancha en cada esquina
            mala = bytearray(buena)
            for i in (
                len(buena) - 3 * 240 * 180 + 3 * (240 * y + x) for y in range(y0, y0 + 3) for x in range(x0, x0 + 3)
            ):
                mala[i : i + 3] = bytes(255 - c for c in mala[i : i + 3])
            assert not navegador.como_golden(caso, bytes(mala), otro, "", "jueces")[0]
            assert navegador.como_golden(caso, bytes(mala), otro, "9 3 255", "jueces")[0]
