"""Los ejercicios de quien enseña: uno hecho de la nada como dice docs/ejercicios.md, en un laboratorio de verdad; los
defectos que se le plantan, que ./lab ejercicio comprueba nombra; y las reglas, que cada una cambia lo suyo."""
import dataclasses
import itertools
import json
import lzma
import os
import random
import re
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest

from banco import BUILD, RAIZ, con_catalogo
from base import catalogo, controles, defectos
from base.marcas import TROZO
from base.procesos import Fallo
from ejercicios import comprueba, en_pagina, nuevo, perturba, propios, reglas
from ejercicios.corrige import clase as de_clase, motivos, shaders, veredicto
from ejercicios.corrige.arbitro import Arbitro
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.partidas import Guion, Partida
from ejercicios.reglas import Reglas
from mentira import siembra
from sin_pruebas_test import sin_pruebas

IMAGENES = "al_abrirlo.png", "con_siete_aspas.png", "girado.png"
DOCUMENTO = (RAIZ / "docs/ejercicios.md").read_text()
FICHEROS = dict(re.findall(r"^`ejercicios/molinete/([\w.]+)`:\n\n```\w+\n(.*?)^```$", DOCUMENTO, re.M | re.S))
ORDENES = re.findall(r"^\./lab (.*)$", DOCUMENTO, re.M)
PREGUNTAS = re.findall(r"^\| (\w[\w ]*) \| .*$", DOCUMENTO.split("## Lo que se comprueba")[1].split("##")[0], re.M)[1:]


def escribe(carpeta, **cambios):
    """El del documento, con algunos ficheros de otra manera o, si son None, sin ellos."""
    shutil.rmtree(carpeta, ignore_errors=True)
    hay = {**FICHEROS, **{f.replace("_", "."): texto for f, texto in cambios.items()}}
    siembra(carpeta, {f: texto for f, texto in hay.items() if texto is not None})
    return carpeta


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    lab = sin_pruebas(tmp_path_factory.mktemp("lab"))
    escribe(lab.sitio / "ejercicios/molinete", reglas_txt="guiones = 4\n")
    return lab


# --- hecho de la nada -------------------------------------------------------------------------------------------


def test_uno_hecho_como_dice_el_documento(lab):
    """Sus órdenes, en su orden. La clase: quien no ha hecho nada, quien lo ha hecho y quien comete un error."""
    hay = "ejercicio comprueba ejercicios", "nuevo ejercicios", "ver mios", "corrige clase ejercicios"
    assert ORDENES == [f"{orden}/molinete" for orden in hay]
    uso = re.findall(r"^\./lab (.*?) +#", (RAIZ / "docs/uso.md").read_text(), re.M)
    assert {o for o in ORDENES if "ver" not in o} <= set(uso)
    dicho = lab(ORDENES[0])
    assert re.findall(r"^bien  (.+?):", dicho, re.M) == PREGUNTAS and "mal" not in dicho
    lab(ORDENES[1], dice="/mios/molinete: lo que se pide está en ENUNCIADO.md")
    assert "warning" not in lab(ORDENES[2], dice="lo he dibujado en molinete.png")
    assert lab.deja("molinete.png", b"\x89PNG")
    clase = lab.sitio / "aqui/clase"
    solucion = FICHEROS["molinete.cpp"]
    shutil.copytree(lab.sitio / "mios/molinete", clase / "nada")
    _, texto, estropeado, _, _, dice = FICHEROS["errores.tsv"].splitlines()[2].split("\t")
    bien, mal = re.sub("[«»]", "", texto), re.sub("«.*»", lambda _: estropeado, texto)
    siembra(clase, {"todo/molinete.cpp": solucion, "error/molinete.cpp": solucion.replace(bien, mal)})
    dicen = {"nada": "se ve lo mismo que en el punto de partida", "todo": "todo bien", "error": f"parece que {dice}"}
    dicho = lab(ORDENES[3], 1)
    for quien, dice in dicen.items():
        assert re.search(rf"\] {quien}: {'100' if quien == 'todo' else '[0-9.]+'}; .*{re.escape(dice)}", dicho), quien
    shutil.rmtree(clase)
    shutil.rmtree(lab.sitio / "aqui/clase-corregida")


def test_se_usa_como_cualquier_otro(lab):
    """La solución se abre y se explica, y una carpeta de fuera se da por su ruta y se apunta. La de quien aprende se
    abre aunque no esté la solución."""
    lab("ver ejercicios/molinete", dice="lo he dibujado en molinete.png")
    assert lab.deja("molinete.png", b"\x89PNG")
    lab("explica molinete 120 90 -geometry 240x180", dice="molinete en (120, 90)")
    escribe(lab.sitio / "aqui/molino")
    for f in (lab.sitio / "aqui/molino").iterdir():
        f.write_text(f.read_text().replace("molinete:", "molino:").replace("de molinete", "de molino"))
        f.rename(f.with_name(f.name.replace("molinete", "molino")))
    errores = lab.sitio / "aqui/molino/errores.tsv"
    errores.write_text(errores.read_text().replace("molinete.cpp", "molino.cpp"))
    (lab.sitio / "aqui/molino/reglas.txt").write_text("guiones = 4\nhuecos = 0\nsemillas = 7 3\n")
    lab("nuevo ./molino el_mio", dice="/mios/el_mio")
    mio, solucion = lab.sitio / "mios/el_mio", (lab.sitio / "aqui/molino/molino.cpp").read_text()
    origen = (mio / "ejercicio.txt").read_text()
    assert re.fullmatch("molino ejercicios/molino/molino\npartida [0-9a-f]{12}\n", origen)
    esperado = {f.name: f.stat().st_size for f in (mio / "esperado").iterdir()}
    assert esperado.keys() == {*IMAGENES, "reglas.txt", "partidas.datos"} and sum(esperado.values()) < 100_000
    assert all(f"](esperado/{imagen})" in (mio / "ENUNCIADO.md").read_text() for imagen in IMAGENES)
    assert "two_pi" not in str(lzma.decompress((mio / "esperado/partidas.datos").read_bytes()).partition(b"\n")[0])
    hechos = {"nada": (mio / "el_mio.cpp").read_text(), "todo": solucion}
    hechos |= {"mal": solucion.replace("radians(10", "radians(20"), "no": "int main("}
    en_clase = {como: corrige_el_mio(lab, hecho, como != "todo") for como, hecho in hechos.items()}
    shutil.rmtree(lab.sitio / "aqui/molino")
    en_casa = {como: corrige_el_mio(lab, hecho, como != "todo") for como, hecho in hechos.items()}
    assert en_casa == en_clase and en_casa["todo"][0] == "100" != en_casa["mal"][0]
    (mio / "el_mio.cpp").write_text(hechos["nada"])
    lab("ver mios/el_mio/", dice="lo he dibujado en el_mio.png")
    assert lab.deja("el_mio.png", b"\x89PNG")
    lab("corrige el_mio", 1, "las piezas y los errores conocidos los mira quien enseña")
    lab("corrige el_mio --semilla 8", 1, "aquí no están los guiones de la semilla 8: solo 7, 3")
    (mio / "esperado/partidas.datos").write_bytes(b"otra cosa")
    lab("corrige el_mio", 1, "está estropeado: pídeselo otra vez")
    shutil.rmtree(mio / "esperado")
    lab("corrige el_mio", 1, "aquí no está la solución de molino, ni la carpeta esperado/")


def corrige_el_mio(lab, hecho, mal):
    """La nota y los guiones que salen bien, con lo que se ha hecho."""
    (lab.sitio / "mios/el_mio/el_mio.cpp").write_text(hecho)
    dicho = lab("corrige el_mio --semilla 3", mal)
    return re.search(r"el_mio, molino: ([\d.]+) de 100 (\(\d+ de 7 guiones)", dicho).groups()


def test_en_la_pagina_va_lo_que_se_reparte_y_no_la_solucion(tmp_path, monkeypatch):
    monkeypatch.setattr(controles, "atiende", lambda *_, **__: (set(), ["Más aspas"]))
    programa = propios.propio(escribe(tmp_path / "molinete", reglas_txt="caso = 3\nguiones = 2\n"))
    datos = en_pagina.datos(RAIZ, BUILD, programa, "molinete")
    resumen = en_pagina.resumen(RAIZ, programa, "molinete", SimpleNamespace(cosas={}))
    va = json.dumps([resumen, datos], ensure_ascii=False)
    pedido = [linea.strip() for t in TROZO.finditer(CPP) for linea in t["hecho"].splitlines()]
    assert len(pedido) == 6 and not [linea for linea in pedido if linea in va]
    reparte = {f"mios/molinete/{f}": t for f, t in nuevo.carpeta_de(RAIZ, programa, "molinete", "molinete").items()}
    assert reparte == datos["esqueleto"] | {f"mios/molinete/{f}": t for f, t in datos["sueltos"].items()}
    assert resumen["oculto"] and resumen["que"] == "Un molinete"
    assert [*resumen["pide"]] == ["mios/molinete/molinete.cpp"]
    assert [g["pesa"] for g in datos["guiones"]] == [3, 3, 3, 1, 1] and datos["palabras"]["tecla g"] == "pulsa g"


@con_catalogo
def test_los_errores_que_planta_la_pagina():
    """De cada ejercicio, lo que cambia cada uno en su shader es lo que cambia en la solución, y ni una letra más."""
    cambian = 0
    for ref, programa in en_pagina.los_que_hay(RAIZ, catalogo.lee_programas(BUILD)).items():
        suyos, dados = motivos.Motivos(RAIZ, programa, ref, None, None), en_pagina.errores(RAIZ, programa, ref)
        limpios = {Path(f).name: texto for f, texto in suyos.limpio(suyos.textos()).items()}
        assert {Path(f).name for f in dados["textos"]} == limpios.keys()
        for m, dado in zip(suyos.defectos, dados["defectos"], strict=True):
            assert dado["dice"] == motivos.que_dice(m) and dado.get("numero", m.numero) == m.numero, m
            if m.en_shader:
                (desde, hasta, pone), fichero = dado["cambia"], Path(dado["en"]).name
                uno, cambian = limpios[fichero], cambian + 1
                otro = {Path(f).name: t for f, t in suyos.limpio(suyos.estropeados(m)).items()}[fichero]
                assert uno[:desde] + pone + uno[hasta:] == otro and dado["en"] in dados["textos"], m
                sobra = [uno[desde:hasta][i : i + 1 or None] == pone[i : i + 1 or None] for i in (0, -1)]
                assert not any(sobra), m
    assert cambian > 50


CPP, ERRORES = FICHEROS["molinete.cpp"], FICHEROS["errores.tsv"]
PRIMERA, SEGUNDA = re.findall("// molinete: .*", CPP)
FIN = "// fin de molinete\n"


def linea(de, texto=CPP):
    """Dónde está, en «molinete.cpp:12: »."""
    return f"molinete.cpp:{texto[: texto.index(de)].count(chr(10)) + 1}: "


SIN_MIRAR = (  # qué pregunta lo nota, en qué fichero se cambia qué por qué, y lo que dice
    ("marcas", "molinete_cpp", FIN + "    return", "return", f"{linea(PRIMERA)}no se cierra antes de la siguiente"),
    ("marcas", "molinete_cpp", FIN + "    glut", "glut", f"{linea(SEGUNDA)}no se cierra"),
    ("marcas", "molinete_cpp", FIN, "// fin de molinte\n", f"{linea(FIN)}«// fin de molinte» no es de nadie"),
    ("marcas", "molinete_cpp", SEGUNDA, "// la tecla", "se cierra sin haberse abierto"),
    ("marcas", "molinete_cpp", SEGUNDA, "// molinete:", f"{linea(SEGUNDA)}no dice qué se pide"),
    ("marcas", "molinete_cpp", "molinete", "E3.9", "falta «// molinete: …»"),
    ("enunciado", "ENUNCIADO_md", "# Un molinete", "Un molinete", "no tiene título"),
    ("enunciado", "ENUNCIADO_md", None, None, "falta ENUNCIADO.md"),
)


@pytest.mark.parametrize("pregunta, fichero, texto, otro, dice", SIN_MIRAR)
def test_lo_que_esta_mal_sin_ejecutar_nada(tmp_path, pregunta, fichero, texto, otro, dice):
    entero = FICHEROS[fichero.replace("_", ".")]
    programa = propios.propio(escribe(tmp_path / "molinete", **{fichero: texto and entero.replace(texto, otro)}))
    hechas = [comprueba.marcas(RAIZ, programa, "molinete"), comprueba.enunciado(programa)]
    mal = {que: "; ".join(fallos) for que, _, fallos in hechas if fallos}
    assert mal.keys() == {pregunta} and dice in mal[pregunta]


def test_los_primeros_y_cuantos_mas():
    for n in range(1, 9):
        cosas = [f"c{i}" for i in range(n)]
        dichas, _, mas = comprueba.enumera(cosas).partition("; y ")
        assert dichas.split("; ") == cosas[:5] and mas == (f"{n - 5} más" if n > 5 else "")


CON_SOBRA = CPP.replace("    esquinas[1] = polar", "    const float sobra = 3;\n    esquinas[1] = polar")
CON_SOBRA = CON_SOBRA.replace("n la quita", "n la quita · z gira al revés")
SIN_EFECTO = 'glutCreateMenu([](int) {}), glutAddMenuEntry("Nada", 1), glutAttachMenu(GLUT_RIGHT_BUTTON);\n'
CON_SOBRA = CON_SOBRA.replace("    glutMainLoop", f"    {SIN_EFECTO}    glutMainLoop")
CON_ERROR = CPP.replace("estado.giro += ", "glEnable(7), estado.giro += ")
SIN_ASPAS = CPP.replace("i < estado.aspas; ++i", "i < estado.aspas - 20; ++i")
REPETIDO = ERRORES.splitlines()[1].replace("gira hacia", "se tuerce hacia")
SIN_SEXTA = ERRORES.splitlines()[0].rpartition("\t\t")[0]
JUGADOS = (  # los ficheros que cambian, y de cada pregunta que lo nota, y solo de ellas, lo que dice
    (
        {
            "molinete_cpp": CON_SOBRA,
            "casos_txt": f"{FICHEROS['casos.txt']}Otra vez: tecla g ×3\n",
            "errores_tsv": f"{ERRORES}{REPETIDO}\nmolinete.cpp\tsobra = «3»\t4\tnada\t\tno se ve\n",
        },
        {
            "controles": ["«tecla z» no cambia la imagen en ningún guion", "«menu Nada» no cambia la imagen"],
            "imágenes": ["se ve lo mismo en los casos Girado y Otra vez"],
            "errores conocidos": ["errores:6, nada: no quita puntos", "errores:2 y errores:5 no se distinguen: gira"],
            "líneas": [f"{linea('const float sobra', CON_SOBRA)}se cambie como se cambie, da lo mismo"],
        },
    ),
    (
        {
            "molinete_cpp": SIN_ASPAS,
            "errores_tsv": f"{SIN_SEXTA}\nmolinete.cpp\tpolar(«0.6f», angulo + paso\tnoesta\ta medias\t\tx\n",
        },
        {
            "esqueleto": ["ya se saca 100: debe ser menos de 60"],
            "controles": ["«tecla m» no cambia la imagen"],
            "imágenes": ["se ve lo mismo en los casos Al abrirlo y Con siete aspas y Girado"],
            "errores conocidos": ["falta la sexta columna", "errores:2, a medias: no compila: molinete.cpp:"],
            "líneas": ["se cambie como se cambie, da lo mismo; "],
        },
    ),
    ({"casos_txt": "Uno: tecla g; pulsa g\n"}, {"guiones": ["Uno: acaba con un error"]}),
    ({"molinete_cpp": CON_ERROR, "errores_tsv": ""}, {"guiones": ["GL_INVALID_ENUM"]}),
)
NO_EMPIEZAN = (  # y los que no dejan ni empezar
    ({"molinete_cpp": "esto no es C++\n"}, "no compila"),
    ({"errores_tsv": "molinete.cpp\tno está\tx\ty\t\tz\n"}, "«no está» está 0 veces en molinete.cpp"),
    ({"errores_tsv": "molinete.cpp\t«angulo + paso» / 2\t1\ta\t\tx\n"}, "la expresión sería otra: «angulo + paso»"),
    ({"errores_tsv": "molinete.cpp\tpolar(«0.6f, angulo + paso / 2»)\t1\ta\t\tx\n"}, "la expresión sería otra: «0.6f"),
    ({"errores_tsv": "otro.cpp\ta\tx\ty\t\tz\n"}, "no hay ningún «otro.cpp»"),
    ({"errores_tsv": "molinete.cpp a b\n"}, "errores:1: son fichero, texto"),
    ({"casos_txt": "tecla g\n"}, "casos.txt:1: es «nombre: guion»"),
    ({"casos_txt": "Uno: rueda +1 959 719\nDos: mueve 3 4; arrastra 960 3\n"}, "casos.txt:2: (960, 3) cae fuera"),
    ({"casos_txt": "Uno: mueve 3 720\n"}, "casos.txt:1: (3, 720) cae fuera"),
    ({"reglas_txt": "caso = mucho\n"}, "reglas.txt:1: «mucho» no vale de caso"),
)


@pytest.mark.parametrize("cambios, debe", JUGADOS)
def test_lo_que_esta_mal_al_jugar(lab, cambios, debe):
    escribe(lab.sitio / "ejercicios/molinete", reglas_txt="guiones = 1\n", **cambios)
    dicho = lab("ejercicio comprueba ejercicios/molinete", 1)
    mal = dict(re.findall(r"^mal   (.+?): (.*)$", dicho, re.M))
    assert mal.keys() == debe.keys(), dicho
    assert not [texto for que, textos in debe.items() for texto in textos if texto not in mal[que]], dicho


@pytest.mark.parametrize("cambios, debe", NO_EMPIEZAN)
def test_lo_que_no_deja_ni_empezar(lab, cambios, debe):
    escribe(lab.sitio / "ejercicios/molinete", **cambios)
    *_, ultima = lab("ejercicio comprueba ejercicios/molinete", 1).splitlines()
    assert ultima.startswith("lab: ") and debe in ultima


# --- lo que se perturba ----------------------------------------------------------------------------------------------

CUALQUIERA = r"""#include <glm/glm.hpp>
#include <string>
#include <vector>
struct Punto { float x, y; } p;
const unsigned char ESC = 27;
static glm::vec3 luna() { return glm::vec3(p.x, 2 * p.y, 0); } // «/*» no es nada
void teclado(unsigned char tecla, int x, int y) {
    const std::string cuerda = R"x(no ; se " acaba)x", red = "http://x"; /* ni aquí */
    switch (tecla) {
    case 'a': p.x += 0.1f; break;
    case ESC: p = {0, float(x - y)}; break;
    default: p.y -= luna().y;
    }
    do { p.x *= 2; } while (p.x < 1e-3f);
    try {
        for (const char letra : cuerda + red) p.y += letra;
    } catch (const std::exception &error) { p.y = -1; }
    const auto corre = [&](float cuanto) { p.x += cuanto; return cuanto * 2; };
    glm::mat4 A(1), B(2), C = A * B;
    const glm::vec2 uno(p.x, 1), otro{1, p.y}, *donde = &uno;
    std::vector<std::pair<int, float>> lista = {{1, 2.5f}, {x, corre(3)}};
    if (const float d = glm::dot(uno, otro); d > 0 && !lista.empty())
        p.x = d > 1 ? donde->x / d : C[0][0] - d;
    else goto fin;
fin: enum { MIL = 1000 };
    lista.resize(MIL % 7);
}"""


def test_lo_perturbado_casi_siempre_compila(tmp_path):
    """Nueve de cada diez: lo que no, se quita, sin culpar a quien no la tiene, y lo demás se queda."""
    hay = perturba.perturbaciones(CUALQUIERA, CUALQUIERA.index("static"), len(CUALQUIERA), False)
    todas = [perturba.perturbado(p, n, "p.cpp", CUALQUIERA) for n, p in enumerate(hay, 1)]
    vivas = [m for m in todas if perturba.se_puede(m, CUALQUIERA)]
    incluye = f'{perturba.antes(RAIZ)}#include "{RAIZ / defectos.MUTANTE_H}"\n'
    for _ in range(comprueba.VUELTAS):
        (tmp_path / "p.cpp").write_text(incluye + defectos.cambia(CUALQUIERA, vivas, perturba.MARCA))
        compila = ["g++", "-std=c++17", "-fsyntax-only", "-w", "-fdiagnostics-color=never", tmp_path / "p.cpp"]
        entorno = {**os.environ, "LC_ALL": "C.UTF-8"}  # en el idioma de quien prueba no se entendería
        dice = subprocess.run(compila, text=True, capture_output=True, env=entorno).stderr
        malas = perturba.culpables(dice, {"p.cpp": CUALQUIERA}, vivas)
        assert malas or not dice, dice
        vivas = [m for m in vivas if m.numero not in malas]
        if not dice:
            break
    assert not dice and len(vivas) >= 0.9 * len(todas) > 63
    assert {m.perturbacion.linea for m in todas} == {m.perturbacion.linea for m in vivas}


SALTOS = """void f(int tecla) {
    for (int i = 0; i < 9; ++i) {
        switch (tecla) {
        case 'a':
            break; // salta
        case 'b':
            if (i > 2) {
                x += 1; break; // sobra: acaba el if, y tras él está el break de default
            }
        case 'z':
        default: break; // sobra
        }
        if (tecla > 3) {
            y += 1; continue; // salta
        }
        if (tecla > 4) break; // salta
        while (y > 2) {
            y -= 1; break; // salta
        }
        if (tecla > 5) continue; // sobra
    }
    switch (tecla) {
    case 1: x += 2; break; // salta
    case 2: {
        for (;;)
            if (x > 3) break; // salta
        break; // sobra
    }
    default:;
    }
}
"""


def test_por_lo_que_no_hace_nada_no_se_pregunta():
    """Un salto que lleva adonde se llega sin él; el que lleva a otro sitio se quita."""
    marcadas = [n for n, renglon in enumerate(SALTOS.splitlines(), 1) if "// salta" in renglon]
    hay = perturba.perturbaciones(SALTOS, SALTOS.index("switch"), SALTOS.index("    default:;"), False)
    assert [p.linea for p in hay if SALTOS[p.desde :].startswith(("break", "continue"))] == marcadas


# --- lo que no es un ejercicio ----------------------------------------------------------------------------------


def test_lo_que_no_es_un_ejercicio(tmp_path):
    raiz, build = (tmp_path / "lab").resolve(), tmp_path / "build"
    programas = [catalogo.Programa(catalogo.Capitulo("ch01_x", "X"), "grua", "E1.1", "Grúa")]
    son = {"lab/ejercicios": "uno", "fuera": "uno dos tres grua Mal a;b mio", "otra": "dos tres cuatro"}
    for carpeta in (f"{en}/{n}" for en, de in son.items() for n in de.split()):
        nombre = Path(carpeta).name
        siembra(tmp_path / carpeta, {f"{nombre}.cpp": "", **({"ejercicio.txt": ""} if nombre == "mio" else {})})
    (tmp_path / "fuera/vacia").mkdir()
    build.mkdir()

    def busca(que):
        return propios.busca(raiz, build, que, programas)

    assert [busca(q) for q in ("uno", "ejercicios/uno", "grua", "E1.1", "nada")] == ["uno", "uno", "", "", ""]
    assert busca(f"{tmp_path}/fuera/dos/") == "dos"
    for cual, dice in {
        **{"./no": "no hay ninguna carpeta", "fuera/vacia": "falta vacia.cpp", "fuera/grua": "ya hay un programa"},
        **{"fuera/Mal": "no vale de nombre", "fuera/a;b": "no vale de nombre", "fuera/mio": "es de quien aprende"},
        "fuera/uno": "ya hay un ejercicio",
    }.items():
        with pytest.raises(Fallo, match=dice) as fallo:
            busca(f"{tmp_path}/{cual}")
        assert "\n" not in str(fallo.value)
    assert propios.apuntadas(build) == [tmp_path / "fuera/dos"]
    siembra(tmp_path, {"fuera/dos/casos.txt": "Clic: mueve 480 360\n"})  # en la ventana que se ve
    assert propios.propio(tmp_path / "fuera/dos").casos[0].guion == "escala 960 720; mueve 480 360"
    siembra(tmp_path, {"lab/ejercicios/roto/roto.cpp": "", "lab/ejercicios/roto/casos.txt": "sin dos puntos"})
    (tmp_path / "lab/ejercicios/uno/otro.h").write_bytes(b"\xff\xfe")
    assert [p.nombre for p in propios.lee(raiz, build)] == ["dos"]
    for roto, dice in (("roto", "casos.txt:1: es «nombre: guion»"), ("uno", "otro.h no está en UTF-8")):
        with pytest.raises(Fallo, match=dice):
            propios.lee(raiz, build, roto)
    azar, ultima = random.Random(1), {"dos": "fuera"}
    for _ in range(30):  # de cada nombre vale la última ruta, y no se olvida ninguno
        en, nombre = azar.choice(["fuera dos", "fuera tres", "otra dos", "otra tres", "otra cuatro"]).split()
        ultima[nombre] = en
        assert busca(f"{tmp_path}/{en}/{nombre}") == busca(nombre) == nombre
        assert sorted(propios.apuntadas(build)) == sorted(tmp_path / e / n for n, e in ultima.items())
    shutil.rmtree(tmp_path / ultima["dos"] / "dos")
    assert busca("dos") == ""


def test_cada_caso_tiene_su_imagen(tmp_path):
    raros = "tecla +", "tecla -", "tecla Á", "tecla a", "←", "→", "a/b", "a b", "a b otro", "¿?"
    casos = "".join(f"{titulo}: tecla g\n" for titulo in raros)
    imagenes = [*map(nuevo.imagen_de, propios.propio(escribe(tmp_path / "molinete", casos_txt=casos)).casos)]
    assert len({*imagenes}) == len(raros) and all(re.fullmatch(r"[a-z0-9]\w*\.png", i) for i in imagenes)


def test_un_enunciado_en_la_pagina():
    """En cualquier orden, seguidos o no: cada palabra, y cada cosa de una lista, una vez."""
    trozos = "Un `texto`\nque sigue", "- una", "- otra\n  que sigue\n- y otra", "## Otro"
    for orden, entre in itertools.product(itertools.permutations(trozos, 3), ("\n\n", "\n")):
        hecho, texto = en_pagina.en_html("# Título\n\n" + entre.join(orden)), entre.join(orden)
        assert re.sub("<.*?>", " ", hecho).split() == re.sub("^(- |## )|`", "", texto, flags=re.M).split(), texto
        listas, cosas = "".join(re.findall("<ul>.*?</ul>", hecho)), len(re.findall("^- ", texto, re.M))
        assert listas.count("<li>") == cosas and "</ul><ul>" not in hecho and "<p>" not in listas, texto


def test_un_ejercicio_esta_para_darlo_si_todo_esta_bien(monkeypatch):
    """Y varios, si lo está cada uno."""
    for como in itertools.product(([], ["x"], ["x", "y"]), repeat=3):
        monkeypatch.setattr(comprueba, "preguntas", lambda *_: [("p", "1", mal) for mal in como])
        dado = comprueba.comprueba(RAIZ, BUILD, "E1.1", None)
        assert [re.search(r": (\d) de", d)[1] for d in dado] == [str(sum(map(bool, como)))] * any(como)
    monkeypatch.setattr(comprueba.sys, "argv", ["", str(RAIZ), str(BUILD), "uno", "dos"])
    monkeypatch.setattr(comprueba, "elige", lambda *que: {que[2]: None})
    monkeypatch.setattr(comprueba, "comprueba", lambda *que: [que[2]] * (que[2] == "uno"))
    with pytest.raises(Fallo, match="uno"):
        comprueba.main()


def test_lo_que_se_da_y_lo_que_no(tmp_path):
    """A quien lo hace le llega lo de la carpeta, menos lo que es de quien enseña, y los huecos, vacíos."""
    carpeta = escribe(tmp_path / "molinete", agua_frag="void", aspa_vf="", notas_md="x", reglas_txt="texto = 7")
    programa, mios = propios.propio(carpeta), tmp_path / "mios"
    assert nuevo.crea(RAIZ, [programa], mios, "molinete", "x")[0] == "molinete"
    dado = "x.cpp agua.frag aspa.vf ENUNCIADO.md ejercicio.txt".split()
    assert {f.name for f in (mios / "x").iterdir()} == {*dado}
    texto, enunciado = ((mios / "x" / f).read_text() for f in ("x.cpp", "ENUNCIADO.md"))
    assert "two_pi" not in texto and texto.count("// molinete: ") == texto.count("// fin de molinete") == 2
    assert enunciado.startswith(FICHEROS["ENUNCIADO.md"]) and "estén esas líneas (7)" in enunciado
    assert "- Girado (`tecla g ×3`). ![Girado](esperado/girado.png)\n" in enunciado
    assert "./lab ver molinete" not in enunciado
    with pytest.raises(Fallo, match="falta .*ENUNCIADO.md"):
        (carpeta / "ENUNCIADO.md").unlink()
        nuevo.crea(RAIZ, [programa], mios, "molinete", "y")
    with pytest.raises(Fallo, match="no hay nada entre «// molinete: …»"):
        (carpeta / "molinete.cpp").write_text("int main() {}\n")
        nuevo.crea(RAIZ, [programa], mios, "molinete", "y")
    assert [f.name for f in mios.iterdir()] == ["x"]


# --- las reglas -------------------------------------------------------------------------------------------------

CASO, AZAR = Guion("caso", ("tecla a",), True), Guion("al azar", ("tecla a",))
OTRAS = {"caso": 5.5, "azar": 4.5, "guiones": 3, "tolerancia": "otro", "casi": 80.5}
OTRAS |= {"titulo": 11.5, "texto": 12.5, "estado": 13.5, "huecos": 70.5, "pesos": "2 3"}
OTRAS |= {"medias": 60.5, "cuesta_mas": 45.5, "semillas": "3 5", "escala": "0 Mal; 50 Bien"}
SE_VE = {"bien": "bb", "casi": "cc", "a medias": "bm", "mal": "mm", "de partida": "pp"}  # al empezar y tras la tecla
SITUACIONES = {  # cómo sale cada guion, y lo demás que falla
    "falla un caso": ("mal", "bien", {}),
    "falla uno al azar": ("bien", "mal", {}),
    "casi": ("bien", "casi", {}),
    "a medias": ("a medias", "bien", {}),
    **{f"el {que}": ("bien", "bien", {que: "mal"}) for que in ("título", "texto", "estado")},
    "una pieza": ("bien", "mal", {}, [1, 0.5]),
}
CAMBIA = {**dict.fromkeys(OTRAS, set()), "casi": {"casi"}, "medias": {"a medias"}}  # lo que cambia cada una
CAMBIA |= {"titulo": {"el título"}, "texto": {"el texto"}, "estado": {"el estado"}}
CAMBIA |= dict.fromkeys(("caso", "azar"), SITUACIONES.keys() - {"el título", "el texto", "el estado"})
CAMBIA |= {"huecos": {"una pieza"}, "pesos": {"una pieza"}}


def test_lo_que_pesa_una_pieza():
    """Como si estuviera tantas veces."""
    for *pesos, otra in itertools.product((1, 2, 5), (1, 3), (0, 0.5, 1)):
        una = Reglas(pesos=" ".join(map(str, pesos))).junta(0.3, [otra, 0.2])
        assert una == pytest.approx(Reglas().junta(0.3, [otra] * pesos[0] + [0.2] * pesos[1]))


def test_cada_regla_cambia_lo_suyo(tmp_path):
    documento = re.findall(r"^\| `(\w+)` \| ([\w.]+) \|", DOCUMENTO, re.M)
    assert documento == [(f.name, str(f.default)) for f in dataclasses.fields(Reglas)]
    assert OTRAS.keys() == dict(documento).keys()

    parecidas = {("b", "b"): 1, ("b", "c"): 0.5}
    arbitro = SimpleNamespace(parecido=lambda una, otra: parecidas.get((una, otra), 0))
    arbitro.difiere = lambda *p: Arbitro.difiere(arbitro, *p)
    jugada = lambda como: Partida([*SE_VE[como]], [], "", 0, "")
    arbitro.juega = lambda de_nada, *_: jugada(de_nada)
    bien = {g: jugada("bien") for g in (CASO, AZAR)}

    def nota(r, caso, azar, otros, *piezas, de_nada="de partida"):
        banco = SimpleNamespace(arbitro=arbitro, reglas=r)
        _, valen, _ = veredicto.juzga(banco, bien, {CASO: jugada(caso), AZAR: jugada(azar)}, lambda: de_nada)
        return veredicto.nota([CASO, AZAR], valen, otros, r, *piezas)

    def notas(r):
        return {s: nota(r, *que) for s, que in SITUACIONES.items()}

    # un caso que se ve bien sin hacer nada no vale; ni es de un caso lo de uno al azar
    for como, de_nada in (("a medias", "bien"), ("a medias", "a medias"), ("a medias", None)):
        assert nota(Reglas(), como, "a medias", {}, de_nada=de_nada) == 0
    base = notas(Reglas())
    for clave, valor in OTRAS.items():
        for escrito in (str(valor), str(valor).replace(".", ",")):
            (tmp_path / "r").write_text(f"# mías\n{clave.replace('titulo', 'título')} = {escrito}  \n")
            otra = reglas.lee(tmp_path / "r")
            assert otra == dataclasses.replace(Reglas(), **{clave: valor})
        assert {s for s, nota in notas(otra).items() if nota != base[s]} == CAMBIA[clave], clave
        es_de_la_nota = clave not in ("cuesta_mas", "semillas")
        assert (otra.en_palabras != Reglas().en_palabras and str(valor) in otra.en_palabras) == es_de_la_nota
    assert nota(Reglas(titulo=0), "bien", "bien", {"título": "mal"}) == 100
    assert reglas.del_programa(SimpleNamespace(raices=[]), guiones=3) == Reglas(guiones=3)
    (tmp_path / "r").write_text("casi = 0")  # lo demás, como en ese ejercicio
    suyas = reglas.del_programa(SimpleNamespace(raices=[]), tmp_path / "r", como_siempre=Reglas(guiones=5))
    assert suyas == Reglas(guiones=5, casi=0)


MALAS = {
    "# una\n\ncaso": "reglas.txt:3: es «clave = valor»",
    "peso = 3": "reglas.txt:1: no hay ninguna regla «peso»: caso, azar",
    "caso = -1": "reglas.txt:1: «-1» no vale de caso",
    "caso = 1e3": "no vale de caso",
    "casi = 101": "«101» no vale de casi: puntos, de 0 a 100",
    "titulo = nan": "no vale de titulo",
    "guiones = 2.5": "no vale de guiones: un número natural",
    "tolerancia = ancha": "«ancha» no vale de tolerancia: redondeo, amplia, otro",
    "texto =": "«» no vale de texto",
    "escala = Apto": "«Apto» no vale de escala: desde cuántos puntos es cada palabra",
    "escala = 0 No; 90 Bien; 50 Apto": "no vale de escala",
    "pesos = 0 0": "no vale de pesos: lo que pesa cada pieza",
    "caso = 0\nazar = 0": "no queda nada",
    "caso = 0\nguiones = 0": "no queda nada",
    "texto = 90\ntitulo = 10": "más de 100",
    "caso = 1\ncaso = 1": "reglas.txt:2: «caso» está dos veces",
}


@pytest.mark.parametrize("texto", MALAS)
def test_unas_reglas_que_no_valen(tmp_path, texto):
    (tmp_path / "reglas.txt").write_text(texto)
    with pytest.raises(Fallo, match=re.escape(MALAS[texto])):
        reglas.lee(tmp_path / "reglas.txt")


# --- los de la página -------------------------------------------------------------------------------------------


@con_catalogo
@pytest.mark.parametrize("ref", ["L3.1", "L5.3", "L9.3"])  # uno de cada clase; de todos, ./lab ejercicio comprueba
def test_un_shader_suelto(tmp_path, ref):
    """El del programa saca 100, aunque se llame de otra manera y no esté en UTF-8; el de partida, uno mal hecho o uno
    que no compila, no; y uno de otro tipo no es el que se pide."""
    programa = shaders.ejercicios(RAIZ, catalogo.lee_programas(BUILD))[ref]
    if not programa.ejecutable(BUILD).exists():
        pytest.skip("no está compilado")
    banco = Banco(RAIZ, BUILD, ref, programa, tmp_path, None, "1", shaders.REGLAS)
    banco.__dict__["donde"] = SimpleNamespace(busca=lambda *_: None)  # lo mira donde_test, y tarda
    pedidos = nuevo.pedidos(RAIZ, programa, ref)

    def nota(textos, nombre="{}", en="utf8"):
        suya = tmp_path / "e"
        shutil.rmtree(suya, ignore_errors=True)
        siembra(suya, {nombre.format(Path(f).name): texto for f, texto in textos.items()})
        for fichero in suya.iterdir():
            fichero.write_text(fichero.read_text(), en, "replace")
        return de_clase.corrige(banco, suya if len(textos) > 1 else next(suya.iterdir()))

    assert nota({f: f"{texto}// año\n" for f, texto in pedidos.items()}, "mío {}", "latin1")["nota"] == 100
    de_partida = nota(banco.de_partida[0])  # con los nombres que se piden
    assert de_partida["nota"] < 60 and "se ve lo mismo que en el punto de partida" in de_partida["dice"]
    mal = banco.motivos.estropeados(banco.motivos.defectos[-1])
    sin_mirar = None
    if ref == "L5.3":
        mal = {f: texto.replace("ecPosicion, normal)", "ecPosicion, -normal)") for f, texto in pedidos.items()}
        sin_mirar = banco.__dict__.pop("donde")
    hecho = nota(mal)
    assert mal != pedidos and hecho["nota"] < 100
    if sin_mirar:  # línea a línea, la que se ha cambiado
        banco.__dict__["donde"] = sin_mirar
        assert any(f["donde"] and ".frag" in f["donde"]["dice"] for f in hecho["fallos"]), hecho["fallos"]
    roto = nota({f: "esto no compila\n" for f in pedidos})
    assert roto["nota"] == 0 and any("error" in dice for dice in roto["dice"])
    otro = nota({f"{f}.geom": texto for f, texto in pedidos.items()})
    assert otro["nota"] == 0 and otro["dice"][0].startswith("no viene")
