"""Los comparadores aceptan lo que deben y rechazan lo demás: el de imágenes, con unos píxeles cambiados a uno y otro
lado de cada límite; y el de lo que se pinta encima."""
import itertools
import math
import os
import re
import subprocess
import sys
from pathlib import Path

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))
sys.path[:0] = [str(RAIZ / "herramientas"), str(RAIZ / "tests/casos")]
import compara_encima

BUENA = (RAIZ / "tests/golden/ch06_texturas/textura_objeto.ppm").read_bytes()
# Un componente de unos cuantos píxeles cambia unos niveles: qué estado da cada opción. 43 píxeles son el 0.1 % de
# 240×180. Allí el fondo es liso, y los 3×3 de alrededor no disculpan nada.
PIXELES = (
    (0, 0, 0, {"": 0, "--amplia": 0, "--otro": 0}),
    (0, 1, 1, {"": 1, "--amplia": 0}),
    *((c, 43200, 3, {"--amplia": 0, "--otro": 0}) for c in range(3)),
    *((c, 43200, 4, {"--amplia": 1}) for c in range(3)),
    (1, 43, 10, {"": 1, "--amplia": 0}),
    (2, 44, 4, {"--amplia": 1}),
    (2, 1, 32, {"--amplia": 0}),
    (2, 1, 33, {"--amplia": 1}),
    (0, 43200, 1, {"--redondeo": 0}),
    (0, 1, 2, {"--redondeo": 1}),
    (1, 432, 4, {"--otro": 0}),
    (1, 433, 4, {"--otro": 1}),
    (2, 43, 33, {"--otro": 0}),
    (2, 44, 33, {"--otro": 1}),
    # con permiso; con el mismo OpenGL no lo hay: idénticas
    (1, 86, 10, {"--amplia --tolerancia=0.2 3 32": 0, "--tolerancia=0.2 3 32": 1, "--amplia --tolerancia=0.2 3 9": 1}),
    (2, 86, 60, {"--otro --tolerancia=2 3 32": 0, "--otro --tolerancia=1 3 60": 0, "--otro --tolerancia=1 3 59": 1}),
)


def compara(carpeta, buena, mala, opciones=""):
    """Con qué estado acaba, y lo que dice."""
    (carpeta / "buena.ppm").write_bytes(buena)
    (carpeta / "mala.ppm").write_bytes(mala)
    palabras = re.split("(?: |^)(?=--)|=", opciones)[1:]
    orden = [BUILD / "herramientas/comparador/compara", "buena.ppm", "mala.ppm", *palabras]
    hecho = subprocess.run(orden, cwd=carpeta, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return hecho.returncode, hecho.stdout


def cambiada(componente, cuantos, niveles):
    """Con esos píxeles, los de abajo, niveles más allá."""
    rgb = bytearray(BUENA[-3 * 43200 :])
    for y, x in (divmod(i, 240) for i in range(cuantos)):
        k = 3 * (240 * (179 - y) + x) + componente
        rgb[k] += niveles if rgb[k] + niveles <= 255 else -niveles
    return BUENA[: -3 * 43200] + rgb


def test_lo_que_se_ve_distinto(tmp_path):
    """Nada lo disculpa; se dice cuánto es, y la imagen de la diferencia es esa, ocho veces."""
    rgb = BUENA[-3 * 43200 :]
    corrida, oscura = rgb[3:] + rgb[:3], bytes(round(0.95 * c) for c in rgb)
    azul = b"".join(rgb[i : i + 3][::-1] for i in range(0, len(rgb), 3))
    for (que, otra), modo in itertools.product(enumerate((corrida, oscura, azul)), ("", "--amplia", "--otro")):
        estado, dice = compara(tmp_path, BUENA, BUENA[: -len(rgb)] + otra, modo + " --deja=de")
        distan = [abs(a - b) for a, b in zip(rgb, otra)]
        media, rmse = sum(distan) / len(distan), math.sqrt(sum(d * d for d in distan) / len(distan))
        assert estado == 1 and f"máximo {max(distan)} " in dice, (que, modo)
        assert f"media {media:.4f}, RMSE {rmse:.4f}, PSNR {20 * math.log10(255 / rmse):.1f} dB" in dice
        dejan = {"esperada": rgb, "obtenida": otra, "diferencia": bytes(min(8 * d, 255) for d in distan)}
        assert all((tmp_path / f"de-{de}.ppm").read_bytes()[-len(rgb) :] == dejan[de] for de in dejan)


def test_a_uno_y_otro_lado_de_cada_limite(tmp_path):
    for componente, cuantos, niveles, estados in PIXELES:
        for opciones, estado in estados.items():
            dicho = compara(tmp_path, BUENA, cambiada(componente, cuantos, niveles), opciones)
            assert dicho[0] == estado, (componente, cuantos, niveles, opciones, dicho)


def test_una_mancha_se_nota_este_donde_este(tmp_path):
    """También en las esquinas; y menor de 3×3, en ninguna parte."""
    lisa = BUENA[: -3 * 43200] + bytes(3 * 43200)
    for x, y, ancho in itertools.product((0, 119, 237), (0, 89, 177), (2, 3)):
        manchada = bytearray(lisa)
        for fila in range(y, y + 3):
            k = len(manchada) - 3 * 43200 + 3 * (240 * fila + x)
            manchada[k : k + 3 * ancho] = b"\x40" * (3 * ancho)
        assert compara(tmp_path, lisa, manchada, "--otro")[0] == (ancho == 3), (x, y, ancho)
    raya = b"\x40" * 300  # fina, y sobre o falte
    for dos in itertools.permutations((lisa, lisa[:-60000] + raya + lisa[300 - 60000 :])):
        assert compara(tmp_path, *dos, "--otro")[0] == 1


def test_lo_que_no_se_puede_comparar(tmp_path):
    for ancho, alto in ((239, 180), (240, 181), (180, 240)):  # la última, con los mismos píxeles
        otra = BUENA[: -3 * 43200].replace(b"240 180", b"%d %d" % (ancho, alto)) + bytes(3 * ancho * alto)
        assert compara(tmp_path, BUENA, otra, "--amplia")[0] == compara(tmp_path, otra, BUENA)[0] == 2
    for mal in ("0.2 3", "0.2 3 32 1", "0,2 3 32", "-1 3 32", "nan 3 32", ""):
        assert compara(tmp_path, BUENA, BUENA, f"--amplia --tolerancia={mal}")[0] == 2, mal
    # sin sello no se sabe qué exigir; una captura de una ventana de verdad no lo lleva, y se compara con --amplia
    sin_sello = re.sub(rb"\n#.*", b"", BUENA, count=1)
    assert [compara(tmp_path, BUENA, sin_sello, modo)[0] for modo in ("", "--amplia")] == [2, 0]


TRAZOS = [
    "rotulo|0.1 0.2 0.3|0 0 240 180|8|0|1 2 0 30 10 0.5 15 6 0|la grúa",
    "segmentos|0.4 0.5 0.6|0 0 120 180|2|1|1 2 0.1 3 4 0.2 5 6 0.3|",
    "puntos|0.7 0.8 0.9|120 0 120 180|5|1|7 8 0.4|",
]


def test_lo_que_se_pinta_encima():
    """Cada número, a uno y otro lado de su cota; cada texto, y los trazos que faltan, sobran o van en otro orden."""
    trazos = [t.split("|") for t in TRAZOS]

    def distinto(otros):
        return list(compara_encima.compara([(["a.ppm"], trazos)], [(["a.ppm"], otros)]))

    def con(i, k, texto):
        return [*trazos[:i], [*trazos[i][:k], texto, *trazos[i][k + 1 :]], *trazos[i + 1 :]]

    assert not distinto(trazos)
    for i, trazo in enumerate(trazos):
        for k, (campo, texto) in enumerate(zip(compara_encima.CAMPOS, trazo)):
            cotas, numeros = compara_encima.DISTA.get(campo), texto.split()
            if not cotas:
                assert distinto(con(i, k, texto + "x")), (i, campo)
                continue
            for (j, numero), signo in itertools.product(enumerate(numeros), (1, -1)):
                cota = signo * cotas[j % len(cotas)]
                cambia = lambda c: " ".join([*numeros[:j], str(float(numero) + c * cota), *numeros[j + 1 :]])
                casi, otro = map(cambia, (0.8, 1.2))
                assert not distinto(con(i, k, casi)) and distinto(con(i, k, otro)), (i, campo, j)
        assert any("falta" in h for h in distinto(trazos[:i] + trazos[i + 1 :]))
        assert any("sobra" in h for h in distinto([*trazos[: i + 1], trazo, *trazos[i + 1 :]]))
    for orden in itertools.permutations(trazos):
        assert bool(distinto(list(orden))) == (list(orden) != trazos)
