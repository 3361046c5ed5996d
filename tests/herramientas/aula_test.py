"""Lo que entrega una clase: lo que hay en una carpeta o en un .zip, que no es de fiar; lo que descarga Moodle y la hoja
de calificaciones; en qué se equivoca una clase; y quién se parece a quién. Una entera, en corrige_test.py."""
import csv
import gzip
import io
import itertools
import os
import random
import re
import unicodedata
import zipfile
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest

from banco import BUILD, MOODLE, RAIZ, REF, banco_falso, carpeta_de, con_catalogo, en_tar, en_zip
from base import catalogo, defectos, procesos
from ejercicios import nuevo
from ejercicios.corrige import aula, clase as de_clase, conjunto, entrega, hoja, informes, orden, parecidos
from ejercicios.reglas import Reglas
from copias import copia
from mentira import faltan, siembra

P = b"int main() {}"

# --- lo que hay en una carpeta o en un .zip -------------------------------------------------------------------------


def cambiado(datos, antes, por):
    assert antes in datos
    return datos.replace(antes, por)


def con_clave(datos):
    """Dice que lo está, en las dos cabeceras de cada fichero."""
    datos = bytearray(datos)
    for marca, donde in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        i = -1
        while (i := datos.find(marca, i + 1)) >= 0:
            datos[i + donde] |= 1
    return bytes(datos)


BUENO = en_zip(("p.cpp", P), ("p.h", b""))
NFD = unicodedata.normalize("NFD", "grúa.cpp")
NOMBRADOS = {  # de cómo se llama un fichero, cómo lo escribe cada uno
    "niño.cpp": ["niño.cpp".encode("cp437")],
    "GRÚA.cpp": ["GRÚA.cpp".encode("cp850")],
    "Garcíá.cpp": [unicodedata.normalize("NFD", "Garcíá.cpp").encode().decode("cp437")],
    "grúa niño.cpp": ["grúa niño.cpp".encode("latin1")],
    "grúa.cpp": [NFD, NFD.encode(), "grúa.cpp".encode()],
    **{f"a{v}.cpp": [unicodedata.normalize("NFD", f"a{v}.cpp").encode()] for v in "áéíóüñçàèòïÁÉÍÓÚÜÑÇ"},  # de un Mac
}
SALEN = ["../../p.cpp", "a/../../p.cpp", b"..\\..\\p.cpp", "/etc/p.cpp", "C:/p.cpp"]
ESTROPEADOS = {
    "cortado por delante": BUENO[40:],
    "CRC": cambiado(en_zip(("p.cpp", P), como=zipfile.ZIP_STORED), P, P[::-1]),
    "otro método": cambiado(BUENO, b"\x08\0\0\0!\0", b"\x63\0\0\0!\0"),
}
ZIPS = {  # lo que solo puede haber en un .zip → lo mismo que en REVUELTA
    "de Windows": (en_zip((b"grua\\p.cpp", P), (b"grua\\p.h", b"")), "p.cpp p.h"),
    "un zip dentro": (en_zip(("dentro.zip", BUENO)), "p.cpp p.h"),
    "tres dentro": (en_zip(("3.zip", en_zip(("2.zip", en_zip(("1.zip", BUENO)))))), "…sin descomprimir"),
    "con clave": (con_clave(BUENO), "«p.cpp» está en un .zip con contraseña…"),
    "bomba en un zip": (en_zip(("a.zip", en_zip(("p.cpp", bytes(99 << 20))))), "«p.cpp» pasa de 1 MiB"),
    "zip enorme dentro": (en_zip(("a.zip", bytes(65 << 20))), "«a.zip» pasa de 64 MiB"),
    "nombre larguísimo": (en_zip(("a" * 300 + ".cpp", P)), "«x/aaaaaaaa…"),
    "fichero y carpeta": (en_zip(("a.cpp", P), ("a.cpp/b.cpp", P)), "…no se puede poner en una carpeta…"),
    "dos veces": (en_zip(("p.cpp", b"\x7fELF\0"), ("p.cpp", P), ("p.h", b"")), "p.cpp p.h"),  # vale el segundo
    "se llama como lo nuestro": (en_zip(("correccion.zip", BUENO), ("p.h", b"")), "p.cpp p.h; no viene p.cpp…"),
    **{f"{n} {e!r}": (en_zip((e, P), ("p.h", b"")), f"{n} p.h") for n, escritos in NOMBRADOS.items() for e in escritos},
    **{f"sale {i}": (en_zip((n, P)), "…una ruta que sale de su carpeta…") for i, n in enumerate(SALEN)},
    **{como: (datos, "…no se puede abrir: está estropeado…") for como, datos in ESTROPEADOS.items()},
}
CONTENIDOS = {"enlace": Path("/etc"), "tubería": os.mkfifo, "2 MiB": 2 << 20, "utf16": "int main() {}".encode("utf-16")}
CONTENIDOS |= {"binario": b"\x7fELF\0", "latin1": b"int main() {} // gr\xfaa", "bom": b"\xef\xbb\xbfint x;", "": ""}
CONTENIDOS |= {"E4.4": "E4.4 ch04/x", REF: f"{REF} ch03/grua", "viejo": "viejo", "m": "int main() {}"}
CONTENIDOS |= {
    "en tar": en_tar("gz", ("grua/p.cpp", P), ("grua/p.h", b"")),
    "tar que sale": en_tar("gz", ("../../p.cpp", P)),
    "tar de enlaces": en_tar("gz", ("p.cpp", b"", "SYMTYPE")),
    "tar bomba": en_tar("gz", ("a", bytes(70 << 20)), ("p.cpp", P)),
}
CONTENIDOS |= {"otro main": "int main() { return 0; }", "suyo": '#include "p.h"\nint main() {}', "el mismo": BUENO}
CONTENIDOS |= {"+gordo.h": '#include "gordo.h"\nint main() {}', "comentado": "// int main() {}\n/* main() */"}
CONTENIDOS["+p.h"] = '#include "p.h"'
REVUELTA = r"""
ana                           p.cpp=m, p.h → p.cpp p.h
solo el programa              mi.cc=m → mi.cc p.h; no viene p.h: se ha puesto el de partida
navegador                     mi_p (1).cpp=m, p (2).h, p(1).h=viejo → mi_p.cpp p(1).h p.h
sin repetir                   p.h, p (1).h, p.cpp=m → p (1).h p.cpp p.h
nombre raro                   a\x1b[2J.cpp=m, p.h → a [2J.cpp p.h
que no se puede escribir      p.cpp=m, p.h, é\udcff.hh → p.cpp p.h é .hh
guion                         -o.cpp=m, p.h → -o.cpp p.h
dentro                        entrega/entrega/p.cpp=m, entrega/entrega/p.h, __MACOSX/a.cpp → p.cpp p.h
subcarpeta, y de un Mac       p.cpp=m, p.h, util/u\u0301.hpp, util/mas/a.inl → p.cpp p.h util/mas/a.inl util/ú.hpp
muy hondo                     p.cpp=m, p.h, a/a/a/a/a/a/a/x.cpp → p.cpp p.h
de todo                       p.cpp=m, p.h, .git/x.cpp, .DS_Store, Thumbs.db=binario, p.cpp~, p.o=binario → p.cpp p.h
corregida                     P.CPP=m, p.h, correccion/x.cpp, ._p.cpp=binario → P.CPP p.h
a_b                           src/p.cpp=m, include/p.h, ejercicio.txt=E3.5 → include/p.h src/p.cpp
lo mismo dos veces            p.cpp=m, p.zip=el mismo → p.cpp p.h; no viene p.h…
bom                           p.cpp=m, p.h=bom → p.cpp p.h
otro tipo                     p.cpp=m, p.h, a.vert, b.FRAG, c.geom, m.vf, n.txt → a.vert b.FRAG c.geom m.vf p.cpp p.h
un enlace que no es fuente    p.cpp=m, p.h, notas.txt=enlace, x=enlace, util=enlace → p.cpp p.h
de otro ejercicio             p.cpp=m, p.h, ejercicio.txt=E4.4 → su carpeta es de otro ejercicio, el E4.4; p.cpp p.h
nada                          .p.cpp=m → no hay nada en su carpeta
rar                           entrega.rar, leeme.txt → no hay ningún fuente: hay un «entrega.rar» sin descomprimir
tar.gz                        e.tar.gz=en tar → p.cpp p.h; se ha abierto «e.tar.gz»: entrégalo sin comprimir…
tar que sale                  e.tgz=tar que sale → en lo comprimido hay una ruta que sale de su carpeta: «../../p.cpp»
tar de enlaces                e.tgz=tar de enlaces → no hay nada en su carpeta
tar bomba                     e.tgz=tar bomba → «e.tgz» pasa de 64 MiB
de Windows                    p.cpp.txt=m, p.h → p.cpp p.h; se llama p.cpp.txt, y se ha leído como p.cpp
y también sin él              p.cpp=m, p.cpp.txt=binario, p.h, leeme.txt → p.cpp p.h
word                          mi grúa.docx → no hay ningún fuente: hay mi grúa.docx
latin1                        p.cpp=latin1, p.h → p.cpp p.h; no está en UTF-8, y se ha traducido: p.cpp
utf16                         p.cpp=utf16, p.h → p.cpp p.h; no está en UTF-8, y se ha traducido: p.cpp
binario                       p.cpp=m, p.h=binario → «p.h» no es un texto en UTF-8: guárdalo así en el editor
enlace                        p.cpp=enlace → no se puede leer «p.cpp»: es un enlace o no hay permiso
tubería                       p.cpp=tubería → «p.cpp» no es un fichero corriente
ejercicio tubería             p.cpp=m, p.h, ejercicio.txt=tubería → p.cpp p.h; …
incluye uno enorme            p.cpp=+gordo.h, p.h, gordo.h=2 MiB → «gordo.h» pasa de 1 MiB
uno enorme al lado            p.cpp=m, p.h, gordo.h=2 MiB → p.cpp p.h; no se ha mirado todo: «gordo.h» pasa de 1 MiB
varios que no se leen         p.cpp=m, p.h, a.vf=2 MiB, b.h=enlace → p.cpp p.h; no se ha mirado todo: …, y 1 más
copia de Windows              p.h, mi ñ - copia.cpp=otro main, mi ñ.cpp=m → mi ñ - copia.cpp mi ñ.cpp p.h (mi ñ.cpp)
una prueba                    p.h, grua.cpp=suyo, a.cpp=m → a.cpp grua.cpp p.h (grua.cpp)
de CMake                      p.cpp=m, cmake-build-debug/CMakeFiles/3.25.1/C.cpp=m, p.h, build/x.cpp=m → p.cpp p.h
con lo suyo              p.cpp=suyo, p.h, p_util.cpp=+p.h, q.cpp, r.cpp=comentado → p.cpp p.h p_util.cpp q.cpp r.cpp
dos ejercicios                a/ejercicio.txt=E4.4, a/x.cpp=m, b/ejercicio.txt=E3.5, b/p.cpp=m, b/p.h → p.cpp p.h
con glm                       p.cpp=m, p.h, glm/glm.hpp, externo/glm/vec3.hpp, glm/mio.hpp → glm/mio.hpp p.cpp p.h
el laboratorio entero         p.cpp=m, p.h, lab/common/malla.h, lab/ch03_transformaciones/objeto.h, lab/lab → p.cpp p.h
"""  # lo que hay en la carpeta de cada uno → qué se lee (con varios main, cuál se corrige) o qué se le dice


def revuelta():
    """De cada carpeta, sus ficheros, como los da carpeta_de, y lo que se le dice."""

    def vale(nombre):
        return re.sub(r"\\(x..|u....|n)", lambda e: e[0].encode().decode("unicode_escape"), nombre)

    for fila in REVUELTA.strip().splitlines():
        hay, dice = fila.split("→ ")
        nombre, ficheros = re.match(r"(.+?)(?:\s\s+|$)(.*)", hay.rstrip()).groups()
        partes = [f.partition("=") for f in ficheros.split(", ") if f]
        yield vale(nombre), {vale(f): CONTENIDOS[que] for f, _, que in partes}, dice
    yield from ((f"z {nombre}", {"x.zip": datos}, dice) for nombre, (datos, dice) in ZIPS.items())
    yield from ((nombre, {"p.cpp": P, "p.h": ""}, "p.cpp p.h") for nombre in ("x" * 150, "n\udcff"))
    yield "muchos", {"p.cpp": P, "p.h": "", **{f"z{i}.h": "" for i in range(500)}}, "… son más de 400 ficheros…"
    de_npm = {f"node_modules/{i}.h": "" for i in range(500)}
    yield "muchísimos", {"p.cpp": P, "p.h": "", **de_npm, **{f"z/{i}": "" for i in range(4600)}}, "p.cpp p.h"


def sembrada(sitio, como):
    """Esa clase, y cómo se llama cada uno: una carpeta con las de todos; o el .zip de todos, de Moodle, con lo de cada
    uno o con su .zip."""
    llamados, miembros = {}, []
    for i, (nombre, ficheros, dice) in enumerate(revuelta()):
        if como == "carpeta":
            carpeta_de(sitio / nombre, ficheros)
            llamados[nombre] = dice
            continue
        if "\udcff" in "".join(ficheros) or (como, nombre) == ("zip", "nada"):  # no se puede escribir, o no sale nada
            continue
        suyo = f"Alguien_{i}{MOODLE}"
        llamados[suyo] = dice
        if como == "zip":
            miembros += ((f"{suyo}/{f}", contenido) for f, contenido in ficheros.items())
        else:
            miembros.append((f"{suyo}x.zip", ficheros.get("x.zip") or en_zip(*ficheros.items())))
    if not miembros:
        no_son = "plantilla.cpp", ".git/x.cpp", "__MACOSX/ana/p.cpp", "correccion/p.cpp", "Thumbs.db", "notas.csv"
        siembra(sitio, dict.fromkeys(no_son, "int main() {}"))
        return sitio, llamados
    sitio.with_suffix(".zip").write_bytes(en_zip(*miembros))
    return sitio.with_suffix(".zip"), llamados


@pytest.mark.parametrize("como", ["carpeta", "zip", "zip de zips"])
def test_una_clase_revuelta(tmp_path, juzga, como):
    """Venga como venga, de cada uno se lee lo mismo y se le dice lo mismo."""

    def dice(_, entregado):
        varios = f" ({entregado.intentos[0][0]})" if len(entregado.alcance.con_main) > 1 else ""
        return {"nota": 50, "dice": [" ".join(sorted(entregado.ficheros)) + varios]}

    juzga(dice)
    pedida, debe = sembrada(tmp_path / "clase", como)
    destino, temporal = tmp_path / "notas", tmp_path / "t"
    for carpeta in (destino, temporal):
        carpeta.mkdir()
    _, dentro, sueltos = aula.busca(tmp_path, pedida, destino)
    assert {c.name for c in dentro} == debe.keys() and sueltos in ([], ["plantilla.cpp"])
    hechas, fallos = de_clase.clase(banco_falso(temporal), dentro, destino, 2)
    dicho = {c.name: "; ".join(informes.lineas(hecha)) for c, hecha in hechas.items()}
    vale = lambda n: re.fullmatch(".*".join(map(re.escape, debe[n].split("…"))), dicho.get(n, ""), re.S)
    mal = {n: (dicho.get(n), debe[n]) for n in debe if not vale(n)}
    assert not mal and not fallos
    assert len(list(destino.glob("*.json"))) == len(debe) > 60 and not list(temporal.iterdir())
    assert {f.name for f in tmp_path.iterdir()} == {pedida.name, "notas", "t"}
    visibles = {n for n in debe if n.isprintable() and len(n.encode()) <= 200}
    assert {f"{n}.json" for n in visibles} <= {f.name for f in destino.iterdir()}


def test_con_que_se_compila():
    """Un main y lo que tiene que ver con él; si así no se puede, con todo lo que no tiene main; y si tampoco, solo."""
    ficheros = {"p.cpp": '#include "p.h"\nint main() {}', "p.h": "", "a.cpp": '#include "p.h"', "b.cpp": ""}
    ficheros |= {"c.cpp": "int main() {}", "suelta.cpp": '#include "b.hpp"', "b.hpp": ""}
    leida = entrega.Entrega({f: c.encode() for f, c in ficheros.items()}, ("p",))
    leida.completa({"p.cpp": "", "p.h": ""}, "p.cpp")
    assert leida.intentos[:3] == [["p.cpp", "a.cpp"], ["p.cpp", "a.cpp", "b.cpp", "suelta.cpp"], ["p.cpp"]]
    assert leida.suyos.keys() == {"p.cpp", "a.cpp", "p.h"}
    leida.corregida(leida.intentos[0])
    assert leida.avisos == ["se ha corregido p.cpp, y no c.cpp"]


def lee(que):
    """Los ficheros de una entrega, o lo que se le dice."""
    try:
        leida = entrega.lee_entrega(que, REF)
    except entrega.Rechazo as rechazo:
        return str(rechazo)
    return next(iter(leida.mal.values()), " ".join(sorted(leida.ficheros)))


HAY = {"p.cpp": P * 9, "p.h": b"int x;\n"}
COMPRIMIDOS = {f".tar{c}": en_tar(c[1:], *HAY.items()) for c in ("", ".gz", ".xz", ".bz2")}
COMPRIMIDOS |= {".zip": en_zip(*HAY.items()), "dos veces": gzip.compress(COMPRIMIDOS[".tar.gz"])}


def estropeados(datos, azar):
    """Cortados por cualquier sitio; y si en él se sabe, con algunos bytes cambiados."""
    yield from (datos[:hasta] for hasta in range(1, len(datos), len(datos) // 9 + 1))
    for _ in range(60 * datos.startswith(b"PK")):
        malos = {azar.randrange(len(datos)) for _ in range(azar.randint(1, 12))}
        yield bytes(azar.randrange(256) if i in malos else b for i, b in enumerate(datos))


@pytest.mark.parametrize("tipo", [".zip", ".tar", ".TAR", ".tar.gz", ".tgz"])
@pytest.mark.parametrize("como", COMPRIMIDOS)
def test_de_lo_comprimido_sale_lo_que_hay_o_se_dice(tmp_path, como, tipo):
    """Sea lo que sea, se llame como se llame y se estropee como se estropee: nunca otra cosa."""
    entero = COMPRIMIDOS[como]
    for datos in (entero, *estropeados(entero, random.Random(1))):
        (tmp_path / f"e{tipo}").write_bytes(datos)
        try:
            leida = entrega.lee_entrega(tmp_path, REF)
            assert {*leida.ficheros.values()} <= {*HAY.values()} and (datos != entero or leida.ficheros == HAY)
        except entrega.Rechazo as por:
            assert "\n" not in str(por) and (datos != entero or tipo.lower() != como and f"e{tipo}" in str(por))


def test_lo_que_hay_en_el_zip_de_todos_es_de_cada_uno(tmp_path):
    """Lo de uno que sale de su carpeta, o que se estropea, es suyo."""
    bien, mal = f"Ana_1{MOODLE}", f"Eva_2{MOODLE}"
    suyos = (f"{bien}/p.cpp", P), (f"{mal}/../../x.cpp", P), (f"Luis_3{MOODLE}/p.cpp", b"Z" * 99)
    datos = en_zip(*suyos, como=zipfile.ZIP_STORED)
    (tmp_path / "c.zip").write_bytes(cambiado(datos, b"Z" * 99, b"z" * 99))
    _, dentro, _ = aula.busca(tmp_path, tmp_path / "c.zip")
    dicho = {q.name: lee(q) for q in dentro}
    assert dicho[bien] == "p.cpp" and "sale de su carpeta" in dicho[mal] and "estropeado" in dicho[f"Luis_3{MOODLE}"]
    with pytest.raises(procesos.Fallo, match="no se puede abrir"):
        (tmp_path / "c.zip").write_bytes(b"no")
        aula.busca(tmp_path, tmp_path / "c.zip")


# Lo que hay en lo que se da → quiénes son, y los ficheros de cada uno o lo que se le dice. ~ es un blanco, y tras el
# número va lo que pone Moodle en el nombre de cada carpeta.
NOMBRES = """
Ana~Gil_1_/p.cpp Luis_2_/p.cpp → Ana~Gil_1_=p.cpp Luis_2_=p.cpp
Ana_1/p.cpp Luis_2/a/p.cpp → Ana_1=p.cpp Luis_2=p.cpp
Ana_1_grua.cpp Ana_1_grua.h Luis_2_p.cpp → Ana_1_=grua.cpp~grua.h Luis_2_=p.cpp
Ana_1_mi_grua.cpp → Ana_1_=mi_grua.cpp
Ana_1_/p.cpp Ana_1_texto_/t.html → Ana_1_=p.cpp
Ana_1_texto_/t.html → Ana_1_texto_=no~hay~ningún~fuente:~hay~t.html
Tarea/Ana_1_/p.cpp Tarea/Luis_2_/p.cpp → Ana_1_=p.cpp Luis_2_=p.cpp
Tarea/Ana_1_p.cpp → Ana_1_=p.cpp
Ana_1_/p.cpp Ana_2_/q.cpp → Ana_1_=p.cpp Ana_2_=q.cpp
Ana_1_/Luis_2_/p.cpp Luis_2_/q.cpp → Ana_1_=p.cpp Luis_2_=q.cpp
Grupo~A_7_/p.cpp Default~group_/q.cpp → Default~group_=q.cpp Grupo~A_7_=p.cpp
ana/p.cpp luis/src/p.cpp → ana=p.cpp luis=p.cpp
ana/p.cpp luis/Eva_2_p.cpp → ana=p.cpp luis=Eva_2_p.cpp
""".strip().splitlines()


def de_moodle(texto):
    pone = lambda m: MOODLE[:-5] + "onlinetext" if m[2] else MOODLE[:-1]
    return re.sub(r"((?<=[^/a-z]\d)|(?<=group))(_texto)?(?=[_/=]|$)", pone, texto)


# Y de Canvas y de Blackboard, sin nada de Moodle.
DE_OTRAS = """
gilana_11111_222222_p.cpp gilana_11111_222223_p-1.h luis_LATE_3_4_grua-12.cpp → gilana_11111=p.cpp~p.h luis_3=grua.cpp
gilana_11111_222222_p.cpp leeme.txt → gilana_11111=p.cpp
Clase/gil_11_22_mi_p.cpp Clase/luis_3_4_q.h → gil_11=mi_p.cpp luis_3=q.h
T_1_al7_attempt_2026-11-20-09-30-00_p.cpp T_1_al7_attempt_2026-11-20-09-30-00.txt → al7=p.cpp
T_a_attempt_2026-11-20-09-30-00_p.cpp T_a_attempt_2026-11-21-09-30-00_q_2.cpp → a=q_2.cpp
T_1_ana_m_attempt_2026-11-20-09-30-00_p.cpp T_1_eva_m_attempt_2026-11-20-09-30-00_p.cpp → ana_m=p.cpp eva_m=p.cpp
""".strip().splitlines()


@pytest.mark.parametrize("fila", [*(" ".join(map(de_moodle, fila.split())) for fila in NOMBRES), *DE_OTRAS])
@pytest.mark.parametrize("en", ("zip", "carpeta"))
def test_de_quien_es_lo_que_da_una_plataforma(tmp_path, fila, en):
    hay, son = ([p.replace("~", " ") for p in lado.split()] for lado in fila.split("→"))
    if en == "zip":
        (tmp_path / "clase.zip").write_bytes(en_zip(*((ruta, P) for ruta in hay)))
    for ruta in hay if en == "carpeta" else ():
        siembra(tmp_path / "clase", {ruta: P.decode()})
    _, dentro, _ = aula.busca(tmp_path, tmp_path / ("clase.zip" if en == "zip" else "clase"))
    assert [f"{q.name}={lee(q)}" for q in sorted(dentro, key=lambda q: q.name)] == son


def test_uno_solo_en_un_zip(tmp_path):
    for nombres in (("src/p.cpp", "src/p.h"), ("ana_1_2_p.cpp", "p.h")):
        (tmp_path / "ana.zip").write_bytes(en_zip(*((nombre, P) for nombre in nombres)))
        suya, dentro, _ = aula.busca(tmp_path, tmp_path / "ana.zip")
        assert dentro is None and suya.name == "ana" and lee(suya) == " ".join(n.removeprefix("src/") for n in nombres)


# --- la hoja de calificaciones --------------------------------------------------------------------------------------

# las que da Moodle, en ese orden (mod/assign/gradingtable.php)
COLUMNAS = """Identificador|Nombre completo|Dirección de correo|Estado|Calificación|Calificación máxima
La calificación puede ser cambiada|Última modificación (entrega)|Última modificación (calificación)
Comentarios de retroalimentación"""
INGLES = """Identifier|Full name|Email address|Status|Grade|Maximum Grade
Grade can be changed|Last modified (submission)|Last modified (grade)|Feedback comments"""
COLUMNAS, INGLES = (re.split("[|\n]", suyas) for suyas in (COLUMNAS, INGLES))
COLUMNAS_DE = {  # como las nombra Moodle en otros idiomas
    "catalán": "Identificador|Nom complet|Adreça electrònica|Estat|Qualificació|Qualificació màxima|La qualificació es"
    " pot canviar|Darrera modificació (tramesa)|Darrera modificació (qualificació)|Comentaris de retroacció.",
    "portugués": "Identificador|Nome completo|Endereço de email|Status|Nota|Nota máxima|Nota pode ser alterada|"
    "Última modificação (envio)|Última modificação (nota)|Comentários de feedback",
    "francés": "Identifiant|Nom complet|Adresse de courriel|Statut|Note|Note maximale|La note peut être modifiée|"
    "Dernière modification (travail remis)|Dernière modification (note)|Feedback par commentaires",
    "alemán": "ID|Vollständiger Name|E-Mail-Adresse|Status|Bewertung|Bestwertung|Bewertung kann geändert werden|"
    "Zuletzt geändert (Abgabe)|Zuletzt geändert (Bewertung)|Feedback als Kommentar",
    "sueco": "Identifierare|Namn|E-postadress|Status|Betyg|Högsta betyg|Betyget kan ändras|"
    "Senast ändrad (inlämning)|Senast ändrad (betyg)|Återkoppling",
}
SIN_ACENTOS = ["".join(q for q in unicodedata.normalize("NFD", c) if q.isascii()) for c in COLUMNAS]
GRUPOS = [*INGLES[:4], "Group", *INGLES[4:]]
RARO = 'Pérez, "la O"\nGil'
EN_CIEN = {"maxima": "100.00"}
TRES = (1001, RARO), (1002, "Ana Gil"), (1003, "Luis")  # el tercero no ha entregado


def una_hoja(columnas, separador=",", fin="\r\n", maxima="10,00", acaba=True, comento="ya", son=TRES, **como):
    datos = io.StringIO()
    escribe = csv.writer(datos, delimiter=separador, lineterminator=fin, **como)
    escribe.writerow(columnas)
    for n, quien in son:
        grupo, sin_nota = ["Grupo_A"] if "Group" in columnas else [], "" if n == 1002 else "-"
        fila = [f"Participante {n}", quien, "", "Enviado", *grupo, sin_nota, maxima, "Sí", "lunes, 5", "-", comento]
        escribe.writerow(fila[: len(columnas)])
    return datos.getvalue() if acaba else datos.getvalue().rstrip()


HECHA = {"entrega": "x", "nota": 87.5, "bien": 3, "guiones": 5, "casos": {"a": True}, "fallos": [], "reglas": "r"}
HECHA["dice"] = ['parece que <b>gira</b>, "al revés"', "«tecla d» no hace nada → ✗"]
HOJAS = {  # las columnas, cómo se escriben, en qué están y qué llevan delante
    "en castellano": (COLUMNAS, {}, "utf-8", b""),
    "sin acentos ni el último fin": (SIN_ACENTOS, {"acaba": False}, "utf-8", b""),
    "con puntuación": ([f" {c.upper()}: " for c in COLUMNAS], {}, "utf-8", b""),
    **{f"en {idioma}": (suyas.split("|"), {"comento": ""}, "utf-8", b"") for idioma, suyas in COLUMNAS_DE.items()},
    "con BOM": (COLUMNAS, {}, "utf-8", b"\xef\xbb\xbf"),
    "en inglés": (INGLES, EN_CIEN, "utf-8", b""),
    "con todo entre comillas": (INGLES, {**EN_CIEN, "quoting": csv.QUOTE_ALL}, "utf-8", b""),
    "con punto y coma": (COLUMNAS, {"separador": ";", "fin": "\n"}, "utf-8", b""),
    "con tabuladores": (COLUMNAS, {"separador": "\t", "fin": "\n"}, "utf-16-le", b"\xff\xfe"),
    "de Windows": (COLUMNAS, {}, "cp1252", b""),
    "sin comentarios": (INGLES[:-1], EN_CIEN, "utf-8", b""),
    "de grupos": (GRUPOS, EN_CIEN, "utf-8", b""),
}


def celdas(datos, como="utf-8", marca=b"", separador=","):
    assert datos.startswith(marca)
    return list(csv.reader(io.StringIO(datos[len(marca) :].decode(como), newline=""), delimiter=separador))


@pytest.mark.parametrize("cual", HOJAS)
def test_la_hoja_de_moodle_se_queda_como_estaba(tmp_path, cual):
    """Leída otra vez, columna a columna; y lo que no se pone, byte a byte."""
    columnas, escrita, como, marca = HOJAS[cual]
    fichero, de_grupos = tmp_path / "hoja.csv", "Group" in columnas
    fichero.write_bytes(antes := marca + una_hoja(columnas, **escrita).encode(como))
    son = ("Otro nombre_1001", "x"), ("Grupo A_7", "x"), ("Eva_9", "Eva")
    quienes = {f"{nombre}{MOODLE}": quien for nombre, quien in son[de_grupos:]}
    suya = hoja.Hoja(fichero, quienes)
    assert suya.escribe().read_bytes() == antes  # sin notas es la misma
    for nombre, quien in quienes.items():
        suya.pon(nombre, {**HECHA, "entrega": quien})
    destino = suya.escribe()
    assert (destino.name, fichero.read_bytes()) == ("hoja-con-notas.csv", antes)
    una, otra = (celdas(datos, como, marca, suya.como_esta["delimiter"]) for datos in (antes, destino.read_bytes()))
    cambia = [c + de_grupos for c in (4, 9) if c < len(columnas)]
    con_nota = [1, 2, 3] if de_grupos else [1]
    distintas = [[k for k, suyo in enumerate(a) if suyo != b[k]] for a, b in zip(una, otra, strict=True)]
    assert distintas == [cambia if i in con_nota else [] for i in range(4)]
    assert otra[1][cambia[0]] == ("87.50" if escrita.get("maxima") else "8,75")
    for dicho in [otra[1][c] for c in cambia[1:]]:
        flecha = "&#8594;" if como == "cp1252" else "→"
        debe = ("parece que &lt;b&gt;gira&lt;/b&gt;, &quot;al revés&quot;", "3 de 5", f"{flecha} ")
        assert not faltan(dicho, *debe)
    if "quoting" in escrita:
        assert b'"87.50","100.00"' in destino.read_bytes()
    # las demás líneas, con sus comillas y sus finales
    viejas, nuevas = (re.split(r"(\r?\n)", datos.decode(como, "replace")) for datos in (antes, destino.read_bytes()))
    assert sum(linea in nuevas for linea in viejas) >= len(viejas) - 2 * len(con_nota)
    fuera = ["Eva"] if de_grupos else ["x", "Eva"]
    assert suya.avisos == [f"«{quien}» no está en hoja.csv" for quien in fuera]
    comentarios = len(con_nota) * (len(cambia) - 1)
    assert suya.cuenta.startswith(f"{len(con_nota)} notas y {comentarios} comentarios puestos; ")
    assert suya.cuenta.endswith(f"; no están en la hoja {len(fuera)}")
    assert ("sin columna de comentarios" in suya.cuenta) == (len(columnas) < 10)
    assert ("por lo que tienen" in suya.cuenta) == (cual == "en sueco")


def test_una_fila_cortada_no_estropea_la_hoja(tmp_path):
    """Por donde sea: a esa se le pone lo que le cabe, y a las demás, lo suyo."""
    for cuantas in range(len(COLUMNAS) + 1):
        filas = list(csv.reader(io.StringIO(una_hoja(COLUMNAS), newline="")))
        filas[2] = filas[2][:cuantas]
        with open(tmp_path / "h.csv", "w", newline="") as f:
            csv.writer(f).writerows(filas)
        suya = hoja.Hoja(tmp_path / "h.csv")
        for n in (1001, 1002, 1003):
            suya.pon(f"X_{n}{MOODLE}", HECHA)
        debe = [{4, 9}, {c for c in (4, 9) if c < cuantas}, {4, 9}] if cuantas else [{4, 9}, {4, 9}]
        pares = zip(filter(None, filas[1:]), celdas(suya.escribe().read_bytes())[1:], strict=True)
        assert [{i for i, (a, b) in enumerate(zip(*par, strict=True)) if a != b} for par in pares] == debe


@pytest.mark.parametrize("antes", ["sep=;\r\n", "\ufeff\ufeffsep=;\r\n", "\ufeffsep=;\n\ufeff", "\ufeff\ufeff"])
def test_lo_que_la_hoja_dice_a_excel_no_va_a_moodle(tmp_path, antes):
    fichero, suya = tmp_path / "h.csv", una_hoja(COLUMNAS, separador=";")
    fichero.write_bytes(f"{antes}{suya}".encode())
    escrita = hoja.Hoja(fichero).escribe().read_text("utf-8-sig" if antes[0] == "\ufeff" else "utf-8")
    assert escrita == suya.replace("\r\n", "\n")


@pytest.mark.parametrize("maxima", "1,00 7.00 10 10,00 12.50 20 100 1000 1.000,00".split())
def test_una_nota_vale_lo_que_vale_en_cada_sitio(tmp_path, monkeypatch, maxima):
    """En los puntos de la tarea, con la coma y los decimales que use, en VPL, en la tabla y en el comentario; y solo la
    que es 100 es la máxima."""
    coma = "," if "," in maxima else "."
    debe = float(re.sub(r"\.(?=.*,)", "", maxima).replace(",", "."))
    monkeypatch.setenv("VPL_GRADEMAX", f"{debe:g}")
    monkeypatch.setenv("VPL_GRADEMIN", str(menor := len(maxima) % 2))
    for nota in (0, 0.1, 8.3, 33.3, 50, 87.5, 99.4, 99.9, 100):
        c = {**HECHA, "nota": nota, "ejercicio": REF, "semilla": "1"}
        (tmp_path / "h.csv").write_text(una_hoja(COLUMNAS, maxima=maxima))
        suya = hoja.Hoja(tmp_path / "h.csv")
        suya.pon(f"A_1002{MOODLE}", c)
        puesta = celdas(suya.escribe().read_bytes())[2][4]
        como = rf"\d+{coma}\d\d[1-9]?" if coma in maxima else r"\d+(,\d*[1-9])?"
        assert re.fullmatch(como, puesta), puesta
        vpl, en_tabla = informes.en_vpl(c).rpartition(" ")[2], celdas(informes.en_csv([c]).encode(), separador=";")[1]
        dicho = re.match(r"<p>(\S+) de 100", hoja.comentario(c))[1]
        for escrita, desde, de in (puesta, 0, debe), (vpl, menor, debe), (en_tabla[2], 0, 100), (dicho, 0, 100):
            vale = float(escrita.replace(",", "."))
            assert abs(vale - desde - nota * (de - desde) / 100) <= 0.005 and (vale == de) == (nota == 100), escrita


def test_la_hoja_que_no_se_entiende_se_dice_antes_de_corregir(tmp_path, monkeypatch):
    monkeypatch.setattr(orden.clase, "clase", lambda *_: pytest.fail("se corrige"))
    for fichero, texto, dice in (
        ("a", "Nombre,Nota\nAna,5\n", "no es una hoja de calificaciones de Moodle que conozca"),
        ("b", "", "no es una hoja"),
        ("c", "Identifier,Grade,Scale\nParticipant 1,,Mal\n", "escala de palabras"),
        ("x/no.csv", "", "no puedo leer"),
    ):
        siembra(tmp_path, {Path(fichero).name: texto})
        with pytest.raises(procesos.Fallo, match=dice):
            pedido = SimpleNamespace(moodle=tmp_path / fichero, cambia_notas=False, deja=tmp_path, j=1)
            orden.de_una_clase(pedido, banco_falso(tmp_path), tmp_path, [])


def test_lo_puesto_a_mano_se_respeta(tmp_path):
    (tmp_path / "h.csv").write_text(una_hoja(COLUMNAS).replace("Gil,,Enviado,,", 'Gil,,Enviado,"7,5",'))
    for cambia, nota, dice in ((False, "7,5", "1 notas y 1 comentarios puestos; se quedan 1"), (True, "8,75", "2 n")):
        suya = hoja.Hoja(tmp_path / "h.csv", cambia=cambia)
        for n in (1002, 1003):
            suya.pon(f"X_{n}{MOODLE}", HECHA)
        filas = celdas(suya.escribe().read_bytes())
        assert [fila[4] for fila in filas[2:]] == [nota, "8,75"] and suya.cuenta.startswith(dice)
        assert (filas[2][9] == "ya") != cambia


def test_con_una_escala_van_palabras(tmp_path):
    columnas = ["Escala" if c == "Calificación máxima" else c for c in COLUMNAS]
    (tmp_path / "h.csv").write_text(una_hoja(columnas, maxima="No apto\n Apto"))
    reglas = Reglas(escala="0 No apto; 50 apto")
    for nota, palabra in ((100, "Apto"), (50, "Apto"), (49.9, "No apto"), (0, "No apto")):
        suya = hoja.Hoja(tmp_path / "h.csv", reglas=reglas)
        suya.pon(f"A_1002{MOODLE}", {**HECHA, "nota": nota})
        assert celdas(suya.escribe().read_bytes())[2][4] == palabra
    with pytest.raises(procesos.Fallo, match="«Bien» no es de la escala de «h.csv», que son No apto, Apto"):
        hoja.Hoja(tmp_path / "h.csv", reglas=Reglas(escala="0 No apto; 90 Bien"))


def test_lo_de_un_grupo_vuelve_a_cada_uno(tmp_path):
    """El número de la carpeta es el del grupo, que puede ser el de una persona que no tiene nada que ver; y aunque haya
    una columna de grupo puede no ser de la tarea."""
    (tmp_path / "h.csv").write_text(una_hoja(GRUPOS))
    suya = hoja.Hoja(tmp_path / "h.csv", [f"Grupo A_1003{MOODLE}"])
    son = conjunto.de_vuelta(f"Grupo A_1003{MOODLE}", suya)
    assert [re.split("_", s)[1] for s in son] == ["1001", "1002", "1003"] and "/" not in "".join(son)
    assert conjunto.de_vuelta(f"Otro_1003{MOODLE}", suya) == [] and conjunto.de_vuelta("ana", suya) == []
    sola = hoja.Hoja(tmp_path / "h.csv", [f"Participante 1002_1002{MOODLE}"])
    sola.pon(f"Participante 1002_1002{MOODLE}", HECHA)
    assert sola.puestos["nota"] == 1 and not sola.avisos
    for quien, de in (f"Ana_1002{MOODLE}", sola), (f"Ana_5{MOODLE}", None):
        assert conjunto.de_vuelta(quien, de) == [quien]


# --- en qué se equivoca una clase -----------------------------------------------------------------------------------


def corregida(quien, nota, *dice, imagen=""):
    falla = {"que": "falla tras «tecla d»: abajo", "tras": ["tecla d"], "donde": None, "imagenes": [imagen] * 3}
    c = {"entrega": quien, "nota": nota, "dice": list(dice), "fallos": [falla] * bool(imagen)}
    c |= {"casos": {}, "bien": 1, "guiones": 2}
    return conjunto.Hecha(quien, quien, f"{quien}.html", {**c, "semilla": "1"})


def test_en_que_se_equivoca_una_clase():
    gira, nada = "parece que gira al revés", "«tecla d» no hace nada"
    hechas = [
        corregida("a", 60, gira, nada, imagen="A"),
        corregida("b", 50, gira, imagen="B"),
        corregida("k", 40, f"parece que falta el pie; y que {gira.removeprefix('parece que ')}"),
        corregida("c", 0, "no compila: p.cpp:3: x"),
        corregida("d", 0, "no compila: q.cpp:9: y"),
        corregida("e", 0, "no compila: falta «main»"),
        corregida("f", 100),
        corregida("g", 80, imagen="G"),
        corregida("i", 0, "acaba con un error: ondas.frag:3: falta «;»"),
        corregida("j", 60, "el título es «x» y debía ser «y»", imagen="J"),
        corregida("h", 0, "se cae tras «tecla d»: abort", "el compilador avisa: p.cpp:1: z"),
    ]
    hay = [(e.dice, [h.quien for h in e.de], e.imagenes[:1]) for e in conjunto.errores(hechas)]
    assert hay == [
        ("no compila", ["c", "d", "e"], []),
        (gira, ["a", "b", "k"], ["B"]),  # de quien no hace nada más mal
        ("el título no es el que debía", ["j"], []),
        ("no se ve como debe: abajo", ["g"], ["G"]),
        ("se cae", ["h"], []),
        ("un shader no compila", ["i"], []),
    ]


def test_en_que_se_equivoca_cada_uno():
    """Si solo se sabe lo que se ve, en lo que más se repite; y de lo que se dibuja, lo que le falta."""
    callan = [[f"«tecla {t}» no hace nada" for t in teclas] for teclas in ("ma", "ad", "d", "od")]
    hechas = [corregida(str(i), 50, *dice) for i, dice in enumerate(callan)]
    otra = corregida("otra", 50, imagen="O")
    otra.c["fallos"][0]["donde"] = {"que": "falta", "dice": "x"}
    debe = {"«tecla d» no hace nada": 3, "«tecla a» no hace nada": 1, "falta algo por dibujar": 1}
    assert {dice: len(de) for dice, de in conjunto.por_causa([*hechas, otra]).items()} == debe


def al_azar(azar, n, casos):
    """Una corrección como cualquiera, con una palabra distinta en cada cosa que dice."""
    cuenta = itertools.count()

    def algunas(que, cuantas=(0, 1, 2, 3)):
        return [f"{que}{n}x{next(cuenta)}z" for _ in range(azar.choice(cuantas))]

    def un_fallo(que):
        sitio = azar.choice([None, [azar.randrange(960), azar.randrange(720)]])
        donde = {"que": "falta", "pixel": sitio, "ventana": [961, 721], "explica": f"{n} {next(cuenta)}"}
        donde["dice"] = azar.choice([que.replace("falla", "donde"), f"donde{n}x99z"])
        tras, imagenes = ["tecla d"] * azar.randrange(2), algunas("png", [0, 2, 3])
        return {"que": que, "tras": tras, "imagenes": imagenes, "donde": azar.choice([donde, None])}

    c = {"entrega": f"quien{n}", "ejercicio": REF, "semilla": "1", "reglas": f"r{n}", "entero": ""}
    c |= {"nota": azar.choice([0, 49.9, 50, 87.5, 99.9, 100]), "dice": algunas("dice", [1, 2]), "bien": 3, "guiones": 5}
    c |= {"avisos": algunas("aviso"), "casos": {caso.nombre: azar.random() < 0.5 for caso in casos}}
    c |= {"fallos": [*map(un_fallo, algunas("falla"))]}
    return c | {"piezas": [{"pide": p, "nota": azar.choice([0, 33.3, 100])} for p in algunas("pieza")]}


def test_lo_que_se_sabe_de_cada_uno_esta_en_cada_sitio(tmp_path):
    """De una clase cualquiera, todo lo de cada uno, en su orden y sin repetirlo: en su página, en la tabla, en JUnit,
    en VPL, en la terminal y en lo que vuelve a Moodle; y en la página de todos, lo que lleva a la suya y qué le pasa.
    """
    azar, casos = random.Random(1), [SimpleNamespace(nombre=n, titulo=f"T{n}", mira="") for n in ("", "b", "c")]
    banco = banco_falso(tmp_path, programa=SimpleNamespace(nombre="a", titulo="A", casos=casos, raices=[]))
    todos = {Path(f"Ana {i}_{i}{MOODLE}"): al_azar(azar, i, casos) for i in range(40)}
    conjunto.escribe(tmp_path, todos, banco, {})
    pagina, de_moodle = (tmp_path / "index.html").read_text(), zipfile.ZipFile(tmp_path / "comentarios.zip")
    junit, tabla = ElementTree.fromstring(informes.en_junit(todos.values())), informes.en_csv(todos.values()).encode()
    assert all(info.external_attr >> 16 & 0o444 == 0o444 for info in de_moodle.infolist()), "se puede abrir"
    fila = r'<tr><td><a href="(.*?)">(.*?)</a></td>\s*<td class="nota( mal)?">(.*?)</td><td>(.*?)</td>'
    filas, (_, *celdas_) = re.findall(fila, pagina), celdas(tabla, "utf-8-sig", separador=";")
    palabras = lambda texto: re.findall(r"\b(?!png)[a-z]+\d+x\d+z", re.sub("<[^>]*>|mios/.*", " ", texto).lower())
    for (carpeta, c), caso, celda, fila in zip(todos.items(), junit, celdas_, filas, strict=True):
        donde = [f["donde"] for f in c["fallos"] if f["donde"]]
        fallos = [palabra for f in c["fallos"] for palabra in (f["que"], *([f["donde"]["dice"]] if f["donde"] else []))]
        pide, dicho = [p["pide"] for p in c["piezas"]], informes.en_texto(c, "yo")
        debe = [*dict.fromkeys([*c["dice"], *fallos, *pide, *c["avisos"]])]
        assert [palabras(f.get("message")) for f in caso] == [debe] * (c["nota"] < 100)
        assert palabras(celda[6]) == palabras(dicho) == palabras(informes.en_vpl(c)) == debe
        en_tabla = [c["entrega"], REF, f"{c['nota']:g}".replace(".", ","), "3", "5", "1"]
        assert celda[:6] == en_tabla and caso.get("name") == c["entrega"]
        assert re.findall("mios/yo (.+)", dicho) == [d["explica"] for d in donde][:1]
        suya = (tmp_path / unquote(fila[0])).read_text()
        assert palabras(suya) == [*c["dice"], *pide, *fallos, *c["avisos"]]  # nada de otro, ni de fuera
        vuelve = de_moodle.read(f"{carpeta}/correccion.html").decode()
        assert vuelve == suya and not re.search(r'(src|href)="(?!data:)|url\(', suya)
        assert all(re.search(rf"\b{c['reglas']}\b", texto) for texto in (suya, dicho, celda[7], informes.en_vpl(c)))
        bien = ["✗✓"[b] for b in (*c["casos"].values(), *(p["nota"] == 100 for p in c["piezas"]))]
        assert re.findall("[✓✗]", suya) == bien
        assert re.findall('base64,(.*?)"', suya) == [imagen for f in c["fallos"] for imagen in f["imagenes"]]
        assert suya.count("Para verlo: pulsa d.") == sum(len(f["tras"]) for f in c["fallos"])
        sitios = [f"({d['pixel'][0]}, {d['pixel'][1]}) de la ventana de 961×721" for d in donde if d["pixel"]]
        assert re.findall(r"\(\d+, \d+\) de la ventana de \d+×\d+", suya) == sitios
        dice = [f"Ana {c['entrega'][5:]}", " mal" * (c["nota"] < 50), f"{c['nota']:g}"]
        assert [*fila[1:4]] == dice and palabras(fila[4]) == debe[:1]
    banco.programa.raices = ["suya"]  # de un ejercicio de quien enseña, la solución no la tiene
    paginas = [informes.pagina(c, banco.programa, REF, "yo") for c in todos.values()]
    assert "./lab ver mios/yo<" in "".join(paginas) and "./lab ver a<" not in "".join(paginas)


@pytest.mark.parametrize("copian", range(6))
def test_las_parejas_que_no_se_ensenan_se_cuentan(monkeypatch, copian):
    monkeypatch.setattr(conjunto, "PAREJAS", 3)
    leidas = {(i, j): {"p.cpp": UNA.replace("3", str(10 + i))} for i in range(copian) for j in "ab"}
    vistas, mas = conjunto.las_que_se_parecen({q: q for q in leidas}, leidas, [{"p.cpp": UNA.replace("3", "x")}])
    assert (len(vistas), mas) == (min(copian, 3), max(copian - 3, 0)) and all(p.una[0] == p.otra[0] for p in vistas)


def test_lo_que_se_dice_a_quien_no_sabe_de_guiones():
    dice = informes.en_html("«tecla d ×7» y «boton x»: `vuelta` < <b>")
    assert dice == "«pulsa d 7 veces» y «boton x»: <code>vuelta</code> &lt; &lt;b&gt;"
    de_partida = {"p.cpp": "1", "p.h": "2"}
    hay = [de_clase.sobra(f"no viene {f}: se ha puesto", de_partida, {"p.cpp": "1", "p.h": "3"}) for f in de_partida]
    assert hay == [True, False]  # en p.cpp no hay nada que hacer


def test_como_se_llama_cada_uno():
    nombres = [f"Ana Gil_1{MOODLE}", f"Ana Gil_2{MOODLE}", f"Luis_3{MOODLE}", "eva_4"]
    correcciones = {aula.Subida(n, []): {"entrega": n} for n in nombres}
    assert [h.quien for h in conjunto.quienes(correcciones).values()] == ["Ana Gil (1)", "Ana Gil (2)", "Luis", "eva_4"]


# --- quién se parece a quién ----------------------------------------------------------------------------------------


def variantes(ref, programa, *listas):
    """De cada línea de bien/ y errores/, que es la solución con otro estilo o con un error, sus ficheros."""
    textos = {f"{programa.capitulo.nombre}/{f}": t for f, t in nuevo.de_la_carpeta(RAIZ, programa, ref).items()}
    for lista in listas:
        for i, linea in enumerate((RAIZ / f"herramientas/ejercicios/{lista}/{ref}.tsv").read_text().splitlines(), 1):
            m = defectos.Mutante(lista, i, i, *linea.replace("\\n", "\n").split("\t")[:4])
            if m.fichero in textos:
                otros = {**textos, m.fichero: defectos.estropea(textos[m.fichero], m)}
                yield m.nombre, nuevo.aqui({Path(f).name: nuevo.deja(t) for f, t in otros.items()}, programa)


def parecidas(ref, programa):
    """Las parejas de una clase en que cada uno hace la suya y otro se la copia, y cuántas copias hay."""
    clase, dados = {}, (nuevo.esqueleto(RAIZ, programa, ref), nuevo.solucion(RAIZ, programa, ref))
    for nombre, ficheros in variantes(ref, programa, "bien", "errores"):
        clase[nombre] = parecidos.codigo(ficheros)
        clase[nombre, "copia"] = parecidos.codigo(copia(ficheros, random.Random(nombre)))
    return parecidos.parejas(clase, dados), len(clase) // 2


@con_catalogo
def test_las_copias_se_ven_y_las_independientes_no():
    """Independientes: las que no son la misma línea de bien/ o de errores/, cada una con una solución de otro estilo o
    con otro error."""
    vistas = hay = 0
    for ref, programa in list(nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD)).items())[::2]:
        parejas, cuantas = parecidas(ref, programa)
        son = [{p.una, p.otra} for p in parejas]
        ajenas = [s for s in son if len({q if isinstance(q, str) else q[0] for q in s}) > 1]
        assert not ajenas, f"{ref}: {ajenas}"
        vistas, hay = vistas + len(son), hay + cuantas
    assert vistas >= 0.92 * hay > 150, f"{vistas} de {hay}"


# Un trozo, y a qué se le cambia el nombre: lo declare como lo declare, es el mismo.
RENOMBRADOS = {
    "float radio = 3;\nfloat a = radio * 2 + giro();\nusa(a, radio, 7);": "radio a",
    "const float dx = u * cos(t), dy = v * sin(t);\nmueve(dx + dy * 3, dy - 2);": "dx dy",
    "float x, y, z;\nx = 3 * giro(); y = x + 2; z = y * x;\npon(x, y, z);": "x y z",
    "auto [a, b] = corta(3);\npon(a * 2 + b, b - 7, a);": "a b",
    "for (int i = 0, n = 12; i < n; i++)\n    pon(i * 30.0f, n - i);": "i n",
    "float *p = dame(4);\np[0] = 3; p[1] = p[0] * 2 + 1;\nusa(p, 5);": "p",
    "#define LADO 5\nvoid f() { pinta(LADO * 2, LADO + 7, 3 - LADO); }": "LADO f",
    "enum { IZQ, DER, MAS };\nvoid f() { m[IZQ] = 3; m[DER] = m[MAS] + 7; }": "IZQ DER MAS m",
    "struct Cosa { float largo; };\nvoid f(Cosa *c) { c->largo = 3; usa(c->largo * 2); }": "Cosa largo f c",
}


@pytest.mark.parametrize("trozo", RENOMBRADOS)
def test_con_otro_nombre_es_lo_mismo(trozo):
    otro = trozo
    for i, nombre in enumerate(RENOMBRADOS[trozo].split()):
        otro = re.sub(rf"\b{nombre}\b", f"otro{i}", otro)
    (p,) = pareja(trozo, otro)
    assert p.cuanto == 1


UNA = """#include "x.h"
float doble(float x) { return 2 * x * giroY(x); }
int main() { const float a = 3; if (a > 2) { pinta(a, "hola a todos"); } return doble(a) > 3; }
"""
OTRA = """// mía
int main() { const float num = 3;
  if (num > 2)
    pinta(num, "adiós a nadie"); /* aquí */
  return duplica(num) > 3; }
float duplica(float v) { return 2 * v * giroY(v); }
"""


def pareja(una, otra, *dadas):
    dadas = '#include "transformaciones.h"', *dadas
    return parecidos.parejas({"a": {"p.cpp": una}, "b": {"q.cpp": otra}}, [{"p.cpp": d} for d in dadas])


def test_lo_que_no_cuenta_al_comparar():
    assert [p.linea for p in parecidos.palabras("a\n/* x\ny */ b\n// z\nc")] == [1, 3, 5]
    (p,) = pareja(UNA, OTRA)
    assert p.cuanto == 1 and p.lineas[0]["p.cpp"] == {2, 3} and p.lineas[1]["q.cpp"] == {2, 3, 4, 5, 6}
    ((mas,), todo) = (pareja(UNA, OTRA, UNA.replace(viejo, otro)) for viejo, otro in (("= 3", "= 4"), ("x", "y")))
    assert mas.lineas[0] == {"p.cpp": {3}} and not todo  # solo dónde, y el nombre no cuenta
    assert not pareja(UNA, OTRA, UNA) and not pareja(UNA, OTRA, OTRA)  # de partida lo tienen
    for viejo, otro in (("2 * x", "x + x"), ("giroY", "giroZ"), ("= 3", "= 4")):
        (q,) = pareja(UNA.replace(viejo, otro), OTRA)
        assert q.cuanto < 1
    de_todos = {str(i): {"p.cpp": UNA} for i in range(6)}  # lo que hacen seis no es de nadie
    assert not parecidos.parejas(de_todos) and len(parecidos.parejas(dict(list(de_todos.items())[:3]))) == 3


def test_al_lado_se_ensena_lo_marcado_y_lo_de_alrededor():
    texto = {"p.cpp": "\n".join(map(str, range(1, 31)))}
    ((ruta, filas),) = parecidos.al_lado(texto, {"p.cpp": {3, 20}, "no.h": {1}})
    debe = [(n, n in (3, 20)) if n else None for n in (*range(1, 6), 0, *range(18, 23))]
    assert ruta == "p.cpp" and [f and (f[0], f[2]) for f in filas] == debe


@pytest.mark.parametrize("trozo", ["{", "}", "(", "-> {", "/*", '"', "a b;", "#", "0e"])
def test_comparar_lo_de_otro_no_dura(trozo):
    """Se lee hasta un límite y de una vez, sea lo que sea."""
    texto = trozo * (parecidos.TOPE // len(trozo))
    leidos = parecidos.codigo({"a.cpp": texto * 3})
    assert len(leidos["a.cpp"]) <= parecidos.TOPE
    antes = os.times().user
    parecidos.parejas({"a": leidos, "b": leidos})
    assert os.times().user - antes < 20
