"""Los módulos de herramientas/, por lo que hacen: cada cuenta frente a un caso resuelto a mano, sin compilar nada."""
import base64
import html
import itertools
import json
import math
import os
import random
import re
import subprocess
import sys
import time
import zlib
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from base import catalogo, controles, defectos, fuentes, guiones, libro, marcas, paginas, procesos
from ejercicios import nuevo, propios
from ejercicios.corrige import entrega
from explica import fuentes as de_shaders, orden as de_explica, palabras
from galeria import dibuja
from galeria.pagina import AQUI as GALERIA, MODULOS, PaginaGaleria
from informe import cocientes, costes, grafica, informe, tecnicas
from web import pagina as de_la_pagina, taller
from windows import fuentes as de_windows, paquete
from mentira import BUILD, RAIZ, ejecutable, espera_a, siembra

FUENTES = [f for f in RAIZ.glob("c*/**/*.*") if f.suffix in (".cpp", ".h", ".vert", ".frag", ".glsl")]
LEEN = r'"((?:assets|common|ch\d\d_\w+)/[\w.]+\.(?:vert|frag|glsl|vf|txt|rgb|r8))"'


def test_una_descarga_a_medias_no_estorba(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["x", str(tmp_path)])
    monkeypatch.setattr(de_windows, "lista_de_fuentes", lambda _: "lista")
    monkeypatch.setenv("PATH", str(tmp_path))  # no hay apt-get, que es como si no hubiera red
    monkeypatch.delenv("LAB_SIN_INSTALAR", raising=False)
    for _ in range(2):
        with pytest.raises(procesos.Fallo, match="no se han podido descargar"):
            de_windows.main()


def test_el_zip_de_windows_tiene_lo_que_leen_los_programas(tmp_path, monkeypatch):
    """Lo que nombran sus fuentes, lo que enlaza su página, y de cada biblioteca que lleva dentro, su licencia."""
    nombrados = {f for fuente in FUENTES for f in re.findall(LEEN, fuente.read_text())}
    metidos, mini = {}, lambda _, caso: f"{caso.programa.nombre}.webp" if not caso.programa.consola else None
    monkeypatch.setattr(paquete.Paquete, "mete", lambda _, donde, fichero: metidos.update({str(donde): fichero}))
    monkeypatch.setattr(paquete, "ejecuta", lambda *_, **__: "")
    monkeypatch.setattr(paquete.Pagina, "miniatura", mini)
    hecho = paquete.Paquete(RAIZ, BUILD, BUILD)
    hecho.web.destino = tmp_path
    hecho.escribe(tmp_path / "w.zip")
    de_aqui = {f for f in nombrados if (RAIZ / f).exists() or (BUILD / f).exists()}
    assert len(de_aqui) > 90 and de_aqui <= metidos.keys()
    enlaza = set(re.findall(r'(?:href|src)="([^"#:]+)"', (tmp_path / "index.html").read_text()))
    assert len(enlaza) > 80 and enlaza - {"LEEME.txt"} <= metidos.keys()
    licencias = {Path(f).stem for f in metidos if f.startswith("licencias/")}
    assert licencias == {"laboratorio", "freeglut", "glew", "gcc", "mingw-w64", "glm", "dejavu"}


# --- procesos ---------------------------------------------------------------------------------------------------


def test_ejecuta_dice_por_que_falla():
    assert procesos.ejecuta(["printf", "uno"]) == b"uno" and procesos.ejecuta(["cat"], input="ñ", text=True) == "ñ"
    ambas = procesos.ejecuta(["sh", "-c", "echo dos; echo tres >&2"], text=True, stderr=subprocess.STDOUT)
    assert ambas == "dos\ntres\n"
    for orden, opciones, dice in (
        ("echo mal >&2; exit 3", {}, "mal"),
        ("exit 3", {"text": True}, "sh ha acabado con estado 3"),
        ("kill -9 $$", {}, "sh ha acabado con estado -9"),
        ("sleep 9", {"timeout": 0.1}, "no ha acabado en 0.1 segundos"),
    ):
        with pytest.raises(procesos.Fallo, match=f"^{dice}$"):
            procesos.ejecuta(["sh", "-c", orden], **opciones)
    with pytest.raises(procesos.Fallo, match="^no encuentro noesta$"):
        procesos.ejecuta(["noesta"])


@pytest.mark.parametrize("no_quiere", ["", "trap '' TERM;"])
def test_lo_que_no_acaba_a_tiempo_no_deja_nietos(tmp_path, no_quiere):
    antes = time.monotonic()
    with pytest.raises(procesos.Fallo, match="no ha acabado en 0.5 segundos"):
        orden = ["sh", "-c", f"{no_quiere} sleep 20 & echo $! >{tmp_path}/nieto; wait; sleep 20"]
        procesos.ejecuta(orden, timeout=0.5)
    assert time.monotonic() < antes + 15  # ni lo espera
    # de lo que ha acabado está vacío, aunque en un contenedor no lo recoja nadie
    orden = f"cat /proc/$(cat {tmp_path}/nieto)/cmdline 2>/dev/null"
    assert espera_a(lambda: not subprocess.getoutput(orden), 2), "el nieto sigue en marcha"


def test_escribe_entero_o_nada(tmp_path):
    fichero = tmp_path / "a" / "b.txt"
    procesos.escribe(fichero, "ñ")
    assert fichero.read_bytes() == "ñ".encode()
    antes = fichero.stat().st_ino
    procesos.escribe(fichero, b"dos")
    assert fichero.read_bytes() == b"dos" and fichero.stat().st_ino != antes  # otro, puesto en su sitio
    Path(f"{fichero}.parcial").symlink_to("/dev/full")
    with pytest.raises(procesos.Fallo, match="no puedo escribir «.*b.txt»: no queda sitio en el disco"):
        procesos.escribe(fichero, "x" * 99)
    assert fichero.read_bytes() == b"dos" and len(list(fichero.parent.iterdir())) == 1


def variante(nombre, tiempo, error, grupo=""):
    return tecnicas.Variante(nombre, grupo, error, "", [tiempo * paso for paso in (1, 0.9, 1.1, 1, 2, 0.95, 1)])


def tecnica(*variantes, elegida="b", nombre="t"):
    return tecnicas.Tecnica(nombre, "T", "ms", "e", elegida, "", list(variantes))


def test_a_otro_paso_desde_la_mitad_el_cociente_es_el_mismo():
    """Un procesador que a media medida va la mitad de rápido: cada mediana es de un paso, y el cociente no."""
    azar = random.Random(3)
    paso = [1] * 12 + [2] * 13
    lenta, rapida = ([t * p * azar.uniform(0.97, 1.03) for p in paso] for t in (3, 2))
    c = cocientes.cociente(lenta, rapida)
    assert abs(c.mediana - 1.5) < 0.03 and c.menor < c.mediana < c.mayor and c.mayor / c.menor < 1.05
    assert cocientes.mas_lento(lenta, rapida) is True and cocientes.mas_lento(rapida, lenta) is False
    assert cocientes.mas_lento(lenta, [1.05 * t for t in lenta]) is None
    a_destiempo = [2 * t for t in rapida[:9]] + rapida[9:]  # cuando el intervalo no lo dice, tampoco
    assert cocientes.mas_lento(lenta, a_destiempo) is None and cocientes.cociente(lenta, a_destiempo).menor < 1
    with pytest.raises(ValueError):
        cocientes.cociente([1, 2], [1])


def test_el_frente_de_pareto_y_la_elegida():
    """Los pares no están en el frente."""
    t = tecnica(variante("a", 1, 3), variante("b", 2, 1), variante("b, x", 3, 1), variante("bc", 2.1, 1))
    t.variantes += [variante("par: d", 0.1, 0), variante("e", 9, 9, "otro"), variante("f", 3.1, 1)]  # f, como «b, x»
    tecnicas.marca(t)
    optima = {x.nombre: x.optima for x in t.variantes if not x.par}
    assert optima == {"a": True, "b": None, "b, x": False, "bc": None, "e": True, "f": False}
    assert [x.nombre for x in t.variantes if x.elegida] == ["b", "b, x"]
    assert [x.nombre for x in t.elegida_fuera] == ["b, x"]


def test_las_columnas_de_un_tsv(tmp_path):
    (tmp_path / "t.tsv").write_text("a\t-\t0.5\t-\t3 1 2\nb\tg\tnan\tnota\t30 10 20\n")
    a, b = tecnicas.lee_variantes(tmp_path / "t.tsv")
    son = a.grupo, a.mediana, a.minimo, a.maximo, a.error, a.nota, b.grupo, b.nota
    assert son == ("", 2, 1, 3, 0.5, "", "g", "nota")


def test_el_error_de_un_ensayo():
    def mal(esperados, *variantes):
        try:
            informe.comprueba(tecnica(*variantes), esperados)
        except procesos.Fallo as fallo:
            return str(fallo)

    for error, esperado in ((0.5, 0.5), (0.57, 0.5), (math.nan, math.nan), (math.inf, math.inf)):
        assert mal([esperado], variante("a", 1, error)) is None
    for error, esperado in ((0.6, 0.5), (0, 0.1), (math.nan, 1)):
        assert f"se equivoca {error:g} y se esperaba {esperado:g}" in mal([esperado], variante("a", 1, error))
    a, b, par = variante("a", 1, 0.5), variante("b", 1, 0), variante("par: c", 1, 9)
    assert "son 2 variantes y se esperaban 1" in mal([0.5], a, b) and "son 1" in mal([0.5, 0], a, par)


def test_lo_que_cuesta_un_programa(tmp_path, monkeypatch):
    """Con un suelo de 2 ms y un programa que arranca en 6. De los campos de -mide que se leen por su lugar, el primero
    es el 104, y los demás siguen."""
    medido = '{"programas": {"a": {"maximo": 0.5, "rmse": 0.25, "borde": 0.125}}}'
    siembra(tmp_path, {"docs/evidencia.json": medido, "herramientas/mide/suelo_osmesa": ""})
    a = SimpleNamespace(nombre="a", consola="", ejecutable=lambda b: b / "osmesa/ch01/a")

    def escribe(orden, **_):
        return "\t".join(["otra\na", "960x720", "7", "10" if "960x720" in orden else "30", *map(str, range(104, 120))])

    monkeypatch.setattr(catalogo, "lee_programas", lambda _: [a])
    monkeypatch.setattr(costes, "milisegundos", lambda orden, _: 2 if "suelo" in str(orden[0]) else 6)
    monkeypatch.setattr(costes, "ejecuta", escribe)
    assert costes.costes(tmp_path, tmp_path, tmp_path, 15)[1] == [2] * 9
    columnas, fila = (linea.split("\t") for linea in (tmp_path / "costes.tsv").read_text().splitlines())
    assert columnas == costes.COLUMNAS.split(",")
    assert fila == "a 6.0 7.0 3.00 10.0 30.0 2.0 106 108 109 0.5 0.25 0.12".split()


def test_el_tiempo_de_un_proceso(tmp_path):
    assert costes.milisegundos(["sleep", "0.2"], tmp_path) < 150
    gasta = "import os, time\nwhile time.process_time() < 0.1: os.stat('.')"
    assert 100 <= costes.milisegundos([sys.executable, "-S", "-c", gasta], tmp_path) < 2000


def test_en_rojo_va_lo_que_pasa(tmp_path):
    """En el informe, lo que tarda más de lo que dice; y las columnas en kB."""
    tardan = list(itertools.product((50, 100, 101), repeat=len(costes.TALLAS)))
    filas = [costes.Coste("p", 1, 1, [1], ms, 1, 1, 4000, 7000, [""] * 3) for ms in tardan]
    informe.escribe_pagina(tmp_path, [], metas=[], costes=filas, suelo=1, entorno={})
    pagina = (tmp_path / "index.html").read_text()
    assert "En rojo, más de 100 ms a 1920×1080." in pagina and costes.TALLAS[-1] == "1920x1080"
    suyo = dict(zip(*(re.findall(f"<{e}.*?>(.*?)</{e}>", pagina, re.S) for e in ("th", "td"))))
    assert (suyo["kB de buffers"], suyo["kB de texturas"]) == ("4", "7")
    rojas = [re.findall('class="mal">(.*?)<', fila) for fila in re.findall("<tr><td>p<.*?</tr>", pagina, re.S)]
    assert rojas == [[f"{ms[-1]}"] if ms[-1] > 100 else [] for ms in tardan]


def en_el_informe(pagina, t):
    """De cada variante que tiene error, el color que le toca por cómo va en su tabla."""
    suya = pagina.split(f'<section id="{t.nombre}">')[1].split("</section>")[0]
    for clase, n, nombre in re.findall(r'<tr class="(.*)"><td><small>(\d+)</small> (.*?)</td>', suya):
        if not math.isnan(t.variantes[int(n) - 1].error):
            azul = "optima" in clase or nombre[-1] == "?"
            yield n, grafica.ROJO if "elegida" in clase else grafica.AZUL if azul else grafica.GRIS


def en_la_grafica(t, guion):
    """De cada una, el color con que va; cuanto más error, más arriba, y todas dentro."""
    alturas = {}
    for color, suyas in re.findall(r"\$c(\w+) << FIN\n(.*?)\nFIN", guion, re.S):
        for y, n in re.findall(r"^\S+ ([\d.e-]+) \S+ \S+ (\d+)$", suyas, re.M):
            alturas[t.variantes[int(n) - 1].error] = float(y)
            yield n, f"#{color}"
    for suyas in re.findall(r"\$frente\d << FIN\n(.*?)\nFIN", guion, re.S):
        tiempos = [float(fila.split()[0]) for fila in suyas.split("\n")]
        assert tiempos == sorted(tiempos), "se une de la más rápida a la más lenta"
    abajo, arriba = map(float, re.search(r"yrange \[(.*):(.*)\]", guion).groups())
    assert [abajo, *(alturas[e] for e in sorted(alturas)), arriba] == sorted({abajo, *alturas.values(), arriba})


def test_el_informe_dice_lo_que_se_ha_medido(tmp_path, monkeypatch):
    """De lo que sea: cada variante, igual en la gráfica y en la tabla; y la mejor imagen, la peor y el peor lo son."""
    azar, guion, metas = random.Random(1), [], [meta.split("|") for meta in informe.METAS.split("\n")[1:-1]]
    monkeypatch.setattr(grafica, "ejecuta", lambda _, input, **__: guion.append(input) or "")
    monkeypatch.setattr(tecnicas, "en_png", lambda _: b"")
    mediana = lambda tiempos: sorted(tiempos)[len(tiempos) // 2]
    for vuelta in range(20):
        tardan = lambda: [azar.uniform(0.9, 1.1) * paso for paso in [azar.uniform(0.5, 2)] * 9]
        filas = [costes.Coste(f"p{i}", 1, 1, tardan(), [1, 1], 1, 1, 1, 1, [""] * 3) for i in range(5)]
        monkeypatch.setattr(costes, "costes", lambda *_: (filas, [1]))
        de = {(t, v): tardan() for _, t, *dos, _ in metas for v in ("más", *dos)}
        hechas = [tecnica(elegida="más", nombre=nombre) for nombre in dict.fromkeys(t for t, _ in de)]
        for t in hechas:
            for _, nombre in (que for que in de if que[0] == t.nombre):
                error = azar.choice([0, 1e-3, 7, math.inf, math.nan]) if t.variantes else 0.5
                t.variantes.append(replace(variante(nombre, 1, error), tiempos=de[t.nombre, nombre]))
            tecnicas.marca(t)
            con = {n: v.error for n, v in enumerate(t.variantes, 1) if v.error == v.error and azar.random() < 0.7}
            siembra(en := tmp_path / f"{vuelta}", {f"{t.nombre}-{n}.ppm": "" for n in con})
            tecnicas.imagenes(t, en, en)
            assert [v.error for _, v, _ in t.imagenes[::2]] == [min(con.values()), max(con.values())] if con else True
        informe.informa(RAIZ, BUILD, tmp_path, hechas, {}, True)
        pagina = html.unescape((tmp_path / "index.html").read_text())
        for t in hechas:
            grafica.dibuja(t, tmp_path / "x.svg")
            assert dict(en_la_grafica(t, guion[-1])) == dict(en_el_informe(pagina, t))
        fila = r"<tr><td>(.*)</td><td>(\S+) <small>\((\S+)–(\S+)\)</small></td><td>(.) (\S+)</td>\s*<td (.*?)>(.*)</td>"
        dichas, veces = re.findall(fila, pagina), {c.programa: c.veces_suelo for c in filas}
        peor = max(veces, key=lambda p: mediana(veces[p]))
        debe = [mediana([a / b for a, b in zip(de[t, lenta], de[t, rapida])]) for _, t, lenta, rapida, _ in metas]
        debe += mediana([mediana(ronda) for ronda in zip(*veces.values())]), mediana(veces[peor])
        assert [float(m) for _, m, *_ in dichas] == pytest.approx(debe, rel=0.01) and dichas[-1][0].endswith(peor)
        for _, medido, menor, mayor, signo, pide, mal, llega in dichas:
            menor, mayor, pide = map(float, (menor, mayor, pide))
            si, no = (menor >= pide, mayor < pide) if signo == "≥" else (mayor <= pide, menor > pide)
            assert menor <= float(medido) <= mayor and bool(mal) == (llega == "no")
            assert pide in (menor, mayor) or llega == ("sí" if si else "no" if no else "no se distingue")


@pytest.mark.parametrize("en_marcha", [True, False])
def test_cada_enlace_de_la_galeria_lleva_a_algo(tmp_path, en_marcha):
    capitulos = catalogo.lee(BUILD)
    siembra(tmp_path, {"galeria/x": "", "web/index.html" if en_marcha else "x": ""})
    pagina = PaginaGaleria(RAIZ, tmp_path / "galeria", capitulos)
    casos = [c for capitulo in capitulos for p in capitulo.programas for c in p.casos]
    for caso in casos[::2]:  # se enseña lo dibujado, y de lo demás se dice que no lo está
        caso.hecho, caso.fallo = True, "" if caso in casos[::4] else f"mal {caso.fichero}"
    pagina.escribe(3, en_marcha)
    escrita = (tmp_path / "galeria/index.html").read_text()
    se_ven = [c for c in (*casos[::4], *(c.caso_de_portada for c in capitulos)) if c.hecho and not c.fallo]
    debe = sorted(c.miniatura for c in se_ven if not c.programa.consola)
    assert sorted(re.findall(r'\bsrc="([^"]+webp)"', escrita)) == debe
    assert re.findall("No se ha podido dibujar: (mal .*)<", escrita) == [c.fallo for c in casos[2::4]]
    assert escrita.count("Aún no está dibujada") == len(casos[1::2])
    assert ("faltan 3 programas" in escrita, "http-equiv" in escrita) == (True, en_marcha)
    assert ("<code>./lab explica" not in escrita, "../web/index.html#" in escrita) == (en_marcha, en_marcha)


def test_lo_que_se_sirve(tmp_path, monkeypatch):
    """La galería y la página, sin comprimir y con todo oculto: ninguna línea de una solución, salvo, en su shader, la
    que se dibuja; cada enlace lleva a algo, el de un ejercicio, a él; y están los fuentes y lo que leen."""
    raiz, build = tmp_path / "lab", tmp_path / "build"
    for copia, de in (raiz, RAIZ), (build, BUILD):
        copia.mkdir()
        [(copia / f.name).symlink_to(f) for f in de.iterdir() if f != BUILD / "web"]
    de_clase = {f"clase.{tipo}" for tipo in ("vert", "frag", "glsl", "vf")}
    siembra(build / "web", {"lab.js": "", "lab.wasm": ""})
    siembra(raiz / propios.CARPETA / "x", dict.fromkeys(de_clase, ""))
    codigos = marcas.que_piden({f: f.read_text() for f in FUENTES})
    (raiz / "ocultos.txt").write_text("\n".join(codigos) + "  # los de este curso")
    assert marcas.ocultos(raiz) == [*codigos], "y nada más"
    monkeypatch.setattr(controles, "atiende", lambda *_, **__: (set(), []))
    monkeypatch.setattr(taller, "paquete", lambda _: build)
    monkeypatch.setattr(de_la_pagina.Pagina, "empaqueta_taller", lambda _: {"ficheros": []})
    de_capitulos = [(c.caso_de_portada, *(p.casos[0] for p in c.programas)) for c in catalogo.lee(BUILD)]
    minis = {c.miniatura: "" for suyos in de_capitulos for c in suyos if c and not c.programa.consola}
    siembra(tmp_path, minis)
    de_la_pagina.Pagina(raiz, build / "web", tmp_path, tmp_path / "web").escribe(catalogo.lee(BUILD))
    PaginaGaleria(raiz, tmp_path / "galeria", catalogo.lee(BUILD)).escribe()
    hay = {str(f.relative_to(tmp_path)): f.read_text() for c in ("web", "galeria") for f in (tmp_path / c).rglob("*.*")}
    datos = {nombre: re.fullmatch(r'llega\("(.*)","(.*)"\)\n', hay[nombre]) for nombre in hay if "/datos/" in nombre}
    hay |= {f"web/datos/{m[1]}.js": zlib.decompress(base64.b64decode(m[2])).decode("latin1") for m in datos.values()}
    trozos = [(f.suffix, t["hecho"]) for f in FUENTES for t in marcas.TROZO.finditer(f.read_text())]
    hechas = {linea.strip(): tipo for tipo, hecho in trozos for linea in hecho.split("\n") if len(linea.strip()) > 30}
    de_otros = "".join(marcas.esqueleto(f.read_text()) for f in FUENTES)
    for nombre, escrito in hay.items():
        se_lee = html.unescape(re.sub("<[^>]+>", "", escrito.replace('\\"', '"')))
        de_mas = {linea for linea in hechas if linea.encode().decode("latin1" if nombre in datos else "utf8") in se_lee}
        vale = nombre == "web/datos/shaders.js" and {linea for linea in hechas if hechas[linea] not in (".cpp", ".h")}
        assert not {linea for linea in de_mas - (vale or set()) if linea not in de_otros}, nombre
    indice = {n for suyos in json.loads(hay["web/datos/indice.js"])["ficheros"].values() for n in suyos.split()}
    assert not indice & set(re.findall(r"\w+", " ".join(hechas))) - set(re.findall(r"\w+", de_otros))
    leen = {Path(f).name for fuente in FUENTES for f in re.findall(LEEN, fuente.read_text())}
    estan = {Path(f).name for f in json.loads(hay["web/datos/shaders.js"])} | {f[10:-3] for f in datos}
    de_aqui = {f.name for f in [*RAIZ.glob("*/*"), *BUILD.glob("assets/*")]}
    assert len(hechas) > 100 and de_clase | leen & de_aqui <= estan
    se_ven = set(re.findall('src="([^"]+webp)"', hay["web/index.html"]))
    assert se_ven == {*minis} and {f"web/{f}" for f in minis} <= hay.keys()
    pagina, fuentes_ = hay["web/index.html"], re.findall('data-fuente="([^"]+)"', hay["galeria/index.html"])
    assert {f"galeria/fuentes/{f}.js" for f in fuentes_} == {f for f in hay if "/fuentes/" in f}
    programas = json.loads(re.search('id="programas">(.*)</script>', pagina)[1])
    textos = json.loads(hay["web/datos/codigo.js"]) | json.loads(hay["web/datos/shaders.js"])
    assert all(textos[f].strip() for p in programas for f in p["fuentes"] if not f.startswith("common/"))
    ejercicios = {f"ejercicio/{e['codigo']}" for p in programas for e in p["ejercicios"]}
    pagina = re.sub("<script.*?</script>", "", pagina, flags=re.S)
    enlaza = {e.split("/explica/")[0] for e in re.findall(r'\bhref="#([^"]+)"', pagina)}
    suyos = {p["nombre"] for p in programas} | set(re.findall('id="([^"]+)"', pagina))
    assert ejercicios <= enlaza <= ejercicios | suyos
    hacerlo = re.findall(r'Para hacerlo: (<a href="#(\S+)">.*?</a> o )?<.*?<code>./lab nuevo (\S+)</code>', pagina)
    assert hacerlo and all(a == f"ejercicio/{r}" or not a and f"ejercicio/{r}" not in ejercicios for _, a, r in hacerlo)
    assert not set(codigos) & set(libro.Libro(raiz).respuestas) and libro.Libro(raiz).respuestas


def test_lo_que_dice_la_galeria_mientras_dibuja(tmp_path, monkeypatch, capsys):
    """De programas con tres casos que no se pueden dibujar, ya lo estaban o se hacen, de cada manera: cuántas imágenes
    ha hecho, o cuáles no y por qué; en la página a medias, cuántos faltan; y acaba mal si alguna no se ha podido."""

    def hace(_, programa, caso, __):
        if caso.titulo == "mal":
            raise procesos.Fallo("mal\ny más")
        return caso.titulo == "hecha"

    pagina, escritas = SimpleNamespace(escribe=lambda faltan=0, sigue=True: escritas.append((faltan, sigue))), []
    monkeypatch.setattr(dibuja, "CADA", -1)
    monkeypatch.setattr(dibuja, "PaginaGaleria", lambda *_: pagina)
    monkeypatch.setattr(dibuja.Galeria, "dibuja", hace)
    monkeypatch.setattr(dibuja.Taller, "compilando", lambda *_: [])
    monkeypatch.setattr(sys, "argv", ["x", RAIZ, BUILD, tmp_path])
    for pueden in ("mal", "igual", "hecha"), ("igual", "hecha"):
        capitulo, dicen, mal, fin = catalogo.Capitulo("ch01", ""), {}, [], ""
        for como in itertools.product(pueden, repeat=3):
            p = catalogo.Programa(capitulo, f"p{len(dicen)}", "")
            p.casos, n = [catalogo.Caso(p, f, f, que) for f, que in zip("abc", como)], como.count("hecha")
            fallan = "; ".join(f"{c.fichero} ha fallado: mal" for c in p.casos if c.titulo == "mal")
            dicen[p.nombre] = fallan or (f"{n} {'imagen' if n == 1 else 'imágenes'}" if n else "sin cambios")
            mal += [p.nombre] * bool(fallan)
            capitulo.programas.append(p)
        monkeypatch.setattr(catalogo, "lee", lambda _: [capitulo])
        escritas.clear()
        try:
            dibuja.main()
        except SystemExit as salida:
            fin = salida.code
        dicho = re.findall(r"^\[ *(\d+)/(\d+)\] ch01/(\w+): (.*)$", capsys.readouterr().err, re.M)
        assert [(int(i), int(n)) for i, n, *_ in dicho] == [(i + 1, len(dicen)) for i in range(len(dicen))]
        assert escritas == [*((i, True) for i in range(1, len(dicen)))][::-1] + [(0, False), (0, True)]
        assert {nombre: dice for *_, nombre, dice in dicho} == dicen
        assert fin == (f"lab: no se ha podido dibujar todo: {', '.join(mal)}" if mal else "")


def test_lo_que_ocupa_la_pagina_y_si_es_otra(tmp_path, monkeypatch, capsys):
    """Lo que hay en su carpeta y en las de dentro; y con cualquier cambio en lo de compilar, es otra versión."""
    todos = [taller.resumen([(f"f{i}", b"ab" if i == cual else b"a") for i in range(9)]) for cual in range(10)]
    assert len({r["version"] for r in todos}) == 10 and [r["bytes"] for r in todos] == [10] * 9 + [9]
    llena = lambda *_: siembra(tmp_path, {"index.html": "x" * 60_000, "datos/a/b.js": "x" * 1_040_000})
    monkeypatch.setattr(de_la_pagina.Pagina, "escribe", llena)
    monkeypatch.setattr(sys, "argv", ["x", *map(str, (RAIZ, BUILD, BUILD, tmp_path))])
    de_la_pagina.main()
    assert "(1.1 MB en total)" in capsys.readouterr().err


def test_una_imagen_se_rehace_si_cambia_algo_de_lo_que_lee(tmp_path, monkeypatch):
    p = next(p for p in catalogo.lee_programas(BUILD) if p.nombre == "textura_objeto")
    galeria, caso = dibuja.Galeria(RAIZ, BUILD, tmp_path, []), p.casos[0]
    assert [galeria.dibuja(p, caso, tmp_path) for _ in range(2)] == [True, False]
    hecho = galeria.hecho[caso.imagen]
    assert {".rgb", ".vert", ".frag", ".glsl", ".cpp"} <= {Path(f).suffix for f in hecho["leidos"]}
    for ruta, suma in list(hecho["leidos"].items()):
        hecho["leidos"][ruta] = "otra"
        assert not galeria.al_dia(caso, hecho["clave"], [])
        hecho["leidos"][ruta] = suma
    otro = replace(caso, guion="espera 0")
    assert [galeria.dibuja(p, c, tmp_path) for c in (caso, otro)] == [False, True]
    ejecutable(tmp_path / "otro", f'exec "{p.ejecutable(BUILD, "egl")}" "$@"')
    monkeypatch.setattr(type(p), "ejecutable", lambda *_: tmp_path / "otro")  # vuelto a compilar
    assert [galeria.dibuja(p, otro, tmp_path) for _ in range(2)] == [True, False]


def test_con_muestras_se_suaviza_lo_que_separa_dos_colores_y_nada_mas(tmp_path):
    opengl = subprocess.run([BUILD / "egl/ch01_intro/info_opengl"], text=True, capture_output=True).stdout
    if int(re.search(r"Mesa (\d+)", opengl)[1]) >= 25:
        pytest.skip("el EGL de Mesa 25 no da muestras que se puedan leer")
    ancho, imagenes = 120, []
    for suaviza in {}, {"LAB_SUAVIZA": "1"}:
        ppm = tmp_path / f"{len(suaviza)}.ppm"
        orden = BUILD / "egl/ch02_modelado/primitivas", "-guion", "tecla 5", "-geometry", f"{ancho}x90", "-ppm", ppm
        subprocess.run(orden, env={**os.environ, **suaviza, "LAB_SIN_ENCIMA": "1"}, check=True)
        rgb = ppm.read_bytes()[-3 * ancho * 90 :]
        imagenes.append([rgb[i : i + 3] for i in range(0, len(rgb), 3)])
    una, suave = imagenes
    for i in range(ancho + 1, len(una) - ancho - 1):
        if len({una[i + dy + dx] for dy in (-ancho, 0, ancho) for dx in (-1, 0, 1)}) == 1:
            assert suave[i] == una[i], divmod(i, ancho)
    assert len({*suave}) > len({*una}) + 3  # de cada cuatro muestras, una, dos o tres


def test_de_un_pixel_se_dice_todo_hasta_un_limite():
    """De cada lista, ninguna, una, las que caben y más: las primeras, en su orden, y de qué es lo demás."""
    ordenes = {n: {"n": n, "titulo": f"T{n}", "pruebas": ["mezcla"], "nada": f"N{n}"} for n in range(9)}

    def numeros(filas, de):
        return [int(n) for fila in filas for n in re.findall(de, fila)]

    for n in range(33):
        sucesos = [{"orden": i % 9, "soloEsa": "x", "profundidad": -i, "veredicto": "z", "dice": i} for i in range(n)]
        assert numeros(palabras.lo_que_falta(sucesos, ordenes), r": (\d+)$") == list(range(n))[:-4:-1]
        sin_nada = palabras.lo_que_falta([], dict([*ordenes.items()][:n]))
        assert numeros(sin_nada, r": N(\d)$") == list(range(min(n, 3)))
        linea = {"fichero": "a.frag", "clase": "asigna", "funcion": "main"}
        lineas = [{**linea, "linea": i, "nombre": "v", "valor": [i, "nan" if i > 4 else 0]} for i in range(n)]
        otra = {**linea, "funcion": "luz", "linea": 99, "nombre": "z", "valor": ["inf"]}
        *dichas, raro = palabras.de_sombreado([*lineas, otra])
        assert numeros(dichas, r"^ {6}a.frag:(\d+): v = ") == list(range(min(n, 30)))
        primero = "5: v = .5, NaN." if n > 5 else "99: z = ∞"
        assert re.fullmatch(f" +lo primero que no es un número: a.frag:{primero}", raro)
        leida = {"fichero": "a.frag", "escrito": "t", "motivo": "m", "coordenadas": [2, 0.5]}
        leidas = [{**leida, "linea": i, "valor": [i, 0, 1, 1]} for i in range(n)]
        suyo = {"historia": [], "lineas": [], "sombreado": {"lecturas": leidas}}
        filas = palabras.de_pixel(suyo, ordenes)
        assert numeros(filas, r"a.frag:(\d+): t en \(2, 0.5\) = \(\1, 0, 1, 1\): m$") == list(range(min(n, 6)))
        assert numeros(filas, r"^ +y (\d+) lecturas más") == [n - 6] * (n > 6)


def test_una_cifra():
    dicen = "nan —, 0 0, inf no vale, 0.0123 0.0123, 12.345 12.3, -1.5 -1.5, 999.4 999, 999.6 1\u202f000, 0.001 0.001"
    dicen += ", 1234567 1\u202f234\u202f567, 1.23e-9 1.2·10⁻⁹, 2e7 2.0·10⁷"
    for x, texto in (cifra.split(" ", 1) for cifra in dicen.split(", ")):
        assert paginas.cifra(float(x)) == texto


def test_las_marcas_de_una_respuesta():
    hecha = libro.en_html("`a*b` y `c<d`, **uno** y **dos**, *tres* y *cuatro*, [x](y) y [z](t)")
    debe = "<code>a*b</code> y <code>c&lt;d</code>, <b>uno</b> y <b>dos</b>, <i>tres</i> y <i>cuatro</i>, x y z"
    assert hecha == debe


def test_los_fuentes_de_un_programa(tmp_path):
    hay = {"ch01/a.cpp": '#include "b.h"\n"a.frag" "ch02/c.h" "nada.h"', "ch01/b.h": '"ch02/c.h"', "ch01/a.frag": ""}
    siembra(tmp_path, {**hay, "ch02/c.h": '"ch01/b.h"', "common/d.h": "", "ch01/nada.txt": ""})
    alcanzados = fuentes.alcanza(tmp_path, Path("ch01/a.cpp"))
    assert list(map(str, alcanzados)) == ["ch01/a.cpp", "ch01/b.h", "ch02/c.h", "ch01/a.frag"]


def test_cada_linea_de_un_shader_en_su_fichero():
    textos = {"a": '\ufeffuno\r\n/* //\n#include "b"\n*/ // /*\n#include "b"\nfin\n', "b": '/*/dos\r#include "a"'}
    lineas = fuentes.con_sitios(lambda nombre: (nombre, textos[nombre]), "a")
    assert [f"{f}{n}" for f, n, _ in lineas] == ["a1", "a2", "a3", "a4", "b1", "b2", "a6"]


def test_un_shader_es_de_la_carpeta_en_que_se_busca_antes(tmp_path, monkeypatch):
    raices = [tmp_path / quien for quien in "abc"]
    for ultima in raices:
        siembra(ultima, {f"{ultima.name}.frag": "void main() {}\n"})
        (ultima / "de_otro_editor.frag").write_bytes(b"// Latin-1: \xe1\n")
        monkeypatch.setenv("LAB_RAIZ", ":".join(map(str, raices[:-1])))
        assert de_shaders.reconoce(raices[-1], [{"programa": 1, "frag": "void main() {}\n"}]) == {1: "a.frag"}


def test_un_programa_explicado_que_acaba_mal(tmp_path):
    """Lo último que escribe es por qué."""
    deja = "echo '{\"sospechas\": []}' >$LAB_EXPLICA\n"
    ejecutable(tmp_path / "p", f"{deja}echo aviso >&2\necho de qué >&2\nexit 3")
    [dicho] = de_explica.ejecuta(tmp_path, tmp_path / "p", "", [])["sospechas"]
    assert dicho["dice"] == "el programa acaba mal: de qué"


EN_BREVE = {
    "": "",
    "espera 0": "",
    "tecla d ×7": "pulsa d 7 veces",
    "tecla 2; especial ARRIBA ×4; espera 1500; tecla m": "pulsa 2 y ↑ 4 veces; espera 1.5 s; pulsa m",
    "escala 4 3; boton IZQUIERDO abajo 1 2; arrastra 3 4; boton IZQUIERDO arriba 3 4": "arrastra para orbitar",
    "rueda -1 3 4": "gira la rueda hacia atrás",
    "boton DERECHO abajo 1 2; arrastra 3 4; boton IZQUIERDO abajo 1 2": "arrastra con el botón derecho; haz clic",
    "menu Vista/Perfil; mueve 1 2; mueve 3 4": "elige en el menú Vista → Perfil; mueve el ratón",
}
ORDENES = {
    "tecla d ×7": "pulsa d 7 veces",
    "boton DERECHO abajo 3 4": "pulsa el botón derecho en 3, 4",
    "boton IZQUIERDO arriba 3 4": "suelta el botón izquierdo en 3, 4",
    "menu Vista/Perfil ñ": "elige en el menú Vista → Perfil ñ",
}


def test_lo_que_hace_una_persona():
    """De cada caso, todo y sin números de píxeles; y cada orden."""
    assert {orden: guiones.en_palabras(orden) for orden in ORDENES} == ORDENES
    for guion, dice in EN_BREVE.items():
        assert guiones.en_breve(guion, True) == dice
    assert guiones.en_breve("boton IZQUIERDO abajo 1 2; arrastra 3 4") == "arrastra"
    for c in (c for p in catalogo.lee_programas(BUILD) for c in p.casos):
        dice = guiones.en_breve(c.guion)
        assert not re.search(r"IZQUIERDO|DERECHO|abajo|boton|\d+ \d+\b|  |;;", dice), c.fichero
        teclas = re.findall(r"(?:tecla|especial) (\S+)", c.guion.replace(";", " ;"))
        assert {guiones.TECLAS.get(t, t) for t in teclas} <= set(re.split(r"[,;]? ", dice + " ")), dice


def test_la_portada_es_de_su_capitulo():
    """Cada capítulo dice la suya, y está."""
    for c in catalogo.lee(BUILD):
        assert c.portada and c.caso_de_portada.fichero == c.portada, c.nombre
        c.portada = "no_esta"
        assert c.caso_de_portada in [caso for p in c.programas for caso in p.casos], c.nombre


def test_los_modulos_juntos(tmp_path):
    """Sin import ni export; lo que otro declara, una vez."""
    modulo = "import { todos,\n  una } from './x.mjs';\nexport const a = 1;\nexport function f() {}\n"
    siembra(tmp_path, {"a.mjs": modulo})
    assert paginas.junta(tmp_path, ["a.mjs"]) == "const a = 1;\nfunction f() {}\n"
    declara = r"^(?:const|let|class|(?:async )?function) (\w+)"
    declarados = re.findall(declara, paginas.junta(GALERIA, MODULOS), re.MULTILINE)
    assert len(declarados) > 20 and len(set(declarados)) == len(declarados)


def test_cada_errata_esta_en_un_sitio_de_su_capitulo():
    """La que nombra un programa entre paréntesis, en ese y en ningún otro; y en el que diga o en el que la enseña."""
    suyo, capitulos = libro.Libro(RAIZ), catalogo.lee(BUILD)
    programas = {p.nombre for c in capitulos for p in c.programas}
    enteras = re.findall(r"^- \*\*.*(?:\n  .*)*", (RAIZ / "docs/erratas.md").read_text(), re.MULTILINE)
    for errata, entera in zip(suyo.erratas, enteras, strict=True):
        (capitulo,) = (c for c in capitulos if c.numero == errata[0])
        de = [p.nombre for c in capitulos for p in c.programas if errata[2] in suyo.erratas_de(p)]
        assert bool(de) != (errata[2] in suyo.otras_erratas(capitulo)), errata[2]
        assert not errata[3] or de == [errata[3]], errata[2]
        dichos = programas & set(re.findall(r"`(\w+)`", entera))
        assert not dichos or dichos & set(de), errata[2]
        assert de or not re.search(r"`ch\d+\w*\.", entera), errata[2]


def test_cada_ejercicio_con_lo_que_pide_y_su_respuesta():
    suyo = libro.Libro(RAIZ)
    for codigo, cosa in suyo.cosas.items():
        assert (codigo[0] not in "E§") or (len(cosa.enunciado) > 20 and suyo.respuestas.get(codigo)), codigo


# --- controles ----------------------------------------------------------------------------------------------------


CONTROLES = """
a d giran | tecla a, tecla d | giran
1 a 3 resaltan una tira | tecla 1, tecla 2, tecla 3 | resaltan una tira
t o espacio anda o para | tecla t, tecla Espacio | anda o para
F5 relee | especial F5 | relee
F12 x | especial F12 | x
F13 x | | F13 x
Esc termina | tecla Esc | termina
; sigue | tecla PuntoYComa | sigue
1 A | tecla 1 | A
0 (1,1,1) | tecla 0 | (1,1,1)
ñ x | | ñ x
← → ↑ ↓ mueven | especial IZQUIERDA, especial DERECHA, especial ARRIBA, especial ABAJO | mueven
a | | a
ratón orbita | | ratón orbita
arrastra (o n y flechas) | tecla n, especial IZQUIERDA, especial DERECHA, especial ARRIBA, especial ABAJO | arrastra
"""


def test_las_teclas_de_cada_control():
    for fila in CONTROLES.strip().splitlines():
        texto, ordenes, hace = map(str.strip, fila.split("|"))
        c = controles.analiza(texto)
        assert (", ".join(c.ordenes), c.hace) == (ordenes, hace), texto
    assert controles.analiza(", . mueven").ordenes == ["tecla ,", "tecla ."]
    assert controles.analiza("botón derecho menú").menu and not controles.analiza("a menú").menu
    todos = catalogo.lee_programas(BUILD)
    for c in (c for p in todos for c in controles.lee(RAIZ, p) if c.texto != "ninguno"):  # lo que enseña F1
        assert " ".join(c.partes).strip() == c.texto


def test_la_linea_de_controles(tmp_path):
    programa = SimpleNamespace(fuente="a.cpp")
    for fuente, textos in (
        ("// x\n// Controles: a gira el\n// plano · Esc termina.\n// Otra.\n", ["a gira el plano", "Esc termina"]),
        ("// nada\n", []),
        ("// Controles: ninguno.\nint x;\n// y.\n", ["ninguno"]),
    ):
        (tmp_path / "a.cpp").write_text(fuente)
        assert [c.texto for c in controles.lee(tmp_path, programa)] == textos


def test_lo_que_se_pide_es_eso_y_nada_mas():
    """Cada programa y cada caso por su nombre, aunque sea el principio del de otro."""
    programas = catalogo.lee_programas(BUILD)
    for p in programas:
        assert catalogo.resuelve(programas, p.nombre) == [p]
        suyos = [c for c in p.casos if not p.consola]
        assert not suyos or catalogo.casos(programas, p.nombre) == suyos
        assert all(catalogo.casos(programas, c.fichero) == [c] for c in suyos if c.fichero != p.nombre)


# a qué lleva, o qué se contesta | lo que se pide
REFERENCIAS = """
sombreado | L5.1, l5.1, listado 5.1, Listado 5.1, list. 5.1
grua | ejercicio 3.5, Figura 3.3, fig. 3.3, Grua, Grúa, ch03_transformaciones/grua, ch03_transformaciones/grua.cpp
giro_eje | ecuación 3.9, apartado 3.4, §3.4
materiales | tabla 5.1
varias_luces | 5.7
repeticion filtrado | 6.2.2
eventos menu seleccion | ch10_interaccion, ch10, capítulo 10, Capitulo 10, cap. 10
L5.1 (sombreado) | 5.1
textura3d_animada luces_animadas), L12.1 (ruido_vertices), F12.1 (mosaico): di cuál | 12.1
lo más parecido: grua | grula, ch04_vista3d/grua
lo más parecido: L5. | listado 5.9
"""


def test_como_la_gente_escribe_una_referencia():
    programas = catalogo.lee_programas(BUILD)
    for fila in REFERENCIAS.strip().splitlines():
        lleva, pedidos = fila.split(" | ")
        for pedido in pedidos.split(", "):
            assert [pedido] == catalogo.juntas(pedido.split())  # en la terminal son dos
            try:
                assert " ".join(p.nombre for p in catalogo.resuelve(programas, pedido)) == lleva
            except catalogo.Fallo as fallo:
                assert lleva in str(fallo)
    assert "ch05" == catalogo.abrevia("ch5") == catalogo.abrevia("capítulo 5") == catalogo.abrevia("cap 05")
    for llanas in "grua 1 2 captura 5.1 -geometry 9", "listado grua 5.1":
        assert catalogo.juntas(llanas.split()) == llanas.split()
    hay = nuevo.ejercicios(RAIZ, programas)
    assert {nuevo.ejercicio_pedido(p, hay) for p in ("E3.5", "e3.5", "3.5", "Ejercicio 3.5")} == {"E3.5"}


# --- ejercicios -----------------------------------------------------------------------------------------------------


def test_un_ejercicio_entre_sus_marcas():
    texto = "uno;\n  // L1.2: esto y aquello\n  dos;\n  tres;\n  // fin de L1.2\n"
    texto += "// E3.5: lo otro\ncuatro;\n// de partida: 4;\n//   y 5;\n// fin de E3.5\ncinco;\n"
    hecho_uno = "uno;\n  // L1.2: esto y aquello\n\n  // fin de L1.2\n"
    assert marcas.esqueleto(texto, "L1.2") == hecho_uno + texto[texto.index("// E3.5") :]
    assert marcas.esqueleto(texto) == hecho_uno + "// E3.5: lo otro\n4;\n// fin de E3.5\ncinco;\n"
    assert marcas.esqueleto(texto, "L1.20") == texto
    piden = marcas.que_piden({"a": texto, "b": "// L1.2: más\n// fin de L1.2\n"})
    assert piden == {"L1.2": {"a": "esto y aquello", "b": "más"}, "E3.5": {"a": "lo otro"}}


def test_las_marcas_que_hay():
    """Cada una se cierra y no se anidan, que de un fichero saldría un esqueleto con la solución; y en lo que queda de
    un ejercicio no está lo que pide."""
    marca = re.compile(r"^ *// (?:fin de )?[EL]\d+\.\d+(?::.*)?$|^ *// de partida: ", re.MULTILINE)
    for fichero in FUENTES:
        texto = fichero.read_text()
        sueltas = re.findall(r"// fin de [EL]\d|// de partida:|// [EL]\d+\.\d+: ", marcas.TROZO.sub("", texto))
        assert not sueltas and not marca.search(nuevo.deja(texto)), f"{fichero}: {sueltas}"
        for trozo in marcas.TROZO.finditer(texto):
            quedan = marcas.esqueleto(trozo[0], trozo["codigo"]).splitlines()
            hecho = [linea for linea in trozo["hecho"].splitlines() if linea.strip()]
            hecho = [linea for linea in hecho if not linea.lstrip().startswith("// de partida: ")]
            assert hecho and not set(hecho) & set(quedan), fichero


def test_lo_que_escribe_un_programa_es_de_su_imagen():
    """Bajo ella va lo de la última orden que ha escrito algo: ni lo que se dice al empezar ni lo que se dijo antes."""
    diario = "hola\ntítulo: A\ndiario\t\t0\nuno\ndiario\tx\t1\n{}título: B \ndiario\ty\t2\n"
    assert dibuja.lo_suyo(diario.format("dos\ntres\n"), True) == ("B", "dos\ntres\n")
    assert dibuja.lo_suyo(diario.format(""), True) == ("B", "uno\n")
    assert dibuja.lo_suyo(diario.format("").replace("uno\n", ""), True) == ("B", "")
    assert dibuja.lo_suyo("hola\ntítulo: A\nqué tal\n") == ("A", "hola\nqué tal\n")


# --- muta ---------------------------------------------------------------------------------------------------------


def mutante(texto, estropeado, numero=1, fichero="x.cpp"):
    return defectos.Mutante("ch01", numero, numero, fichero, texto, estropeado, "imita")


def test_un_defecto_plantado():
    assert defectos.estropea("a = b + c;", mutante("b «+» c", "-")) == "a = b - c;"
    for texto, mal in (("a", "está 2 veces"), ("x", "está 0 veces"), ("«b»", "no cambia nada")):
        with pytest.raises(ValueError, match=mal):
            mutante(texto, "b").sitio("a a b")
    expresiones = mutante("«b» + c", "1"), mutante("«b» + c", "2", 2), mutante("+ «c»", "d", 3)
    todos = *expresiones, mutante("a = b + c;", "x();", 4)
    juntos = "a = (mutante(2) ? (2) : (mutante(1) ? (1) : (b))) + (mutante(3) ? (d) : (c));"
    assert defectos.cambia("a = b + c;", todos[:3]) == juntos
    assert defectos.cambia("a = b + c;", todos[3:]) == "if (mutante(4)) { x(); } else { a = b + c; }"
    assert defectos.cambia("a = b + c;", todos) == f"if (mutante(4)) {{ x(); }} else {{ {juntos} }}"
    with pytest.raises(ValueError, match="se pisa con otro"):
        defectos.cambia("a = b + c;", [mutante("b + c", "1"), mutante("a = b", "2", 2)])
    for antes in ("", "if (d)\n    ", "else ", "// por qué\n", "case 1: "):
        assert "mutante(1)" in defectos.cambia(f"{antes}a();", [mutante("a();", ";")])
    for antes in ("return ", "d = ", "f(", "b ? c : "):
        with pytest.raises(ValueError, match="no es una instrucción entera"):
            defectos.cambia(f"{antes}a();", [mutante("a();", ";")])


def test_lo_que_se_le_dice_a_un_alumno(tmp_path):
    siembra(tmp_path, {"ch01.tsv": "f\ta\tb\ti\nf\ta\tb\ti\tm\nf\ta\tb\ti\t\td\n"})
    mutantes, fallos = defectos.lee(tmp_path)
    assert [(m.motivo, m.dice) for m in mutantes] == [("", ""), ("m", ""), ("", "d")] and not fallos
    siembra(tmp_path, {"ch01.tsv": "f\ta\tb\nf\ta\tb\ti\t\nf\t\tb\ti\nf\ta\tb\ti\tm\td\t7\n"})
    assert len(defectos.lee(tmp_path)[1]) == 4


# --- nuevo ------------------------------------------------------------------------------------------------------


def test_una_carpeta_se_hace_entera_y_no_se_toca(tmp_path, monkeypatch):
    programas, mios = catalogo.lee_programas(BUILD), tmp_path / "mios"
    assert nuevo.crea(RAIZ, programas, mios, "e3.5", "mi_a") == ("E3.5", mios / "mi_a")
    con = nuevo.ejercicios(RAIZ, programas)["E3.5"]
    assert entrega.ejercicio_de(mios / "mi_a", programas) == ("E3.5", con)
    (mios / "mi_a/mi_a.cpp").write_text("mío")
    with pytest.raises(nuevo.Fallo, match="ya existe .*mi_a, y no se toca: .*./lab nuevo E5.1 NOMBRE"):
        nuevo.crea(RAIZ, programas, mios, "E5.1", "mi_a")
    assert (mios / "mi_a/mi_a.cpp").read_text() == "mío"
    siembra(mios / ".grua.parcial", {"de otra vez": ""})
    assert nuevo.crea(RAIZ, programas, mios, "grua") == ("", mios / "grua")
    hechos = {f.name for f in (mios / "grua").iterdir()}
    assert {"grua.cpp", "ejercicio.txt"} <= hechos and not hechos & {"de otra vez", "ENUNCIADO.md"}
    for nombre in ("Mi_a", "../a", "a b", "ñ", "a.b", "-a"):
        with pytest.raises(nuevo.Fallo, match="no vale de nombre"):
            nuevo.crea(RAIZ, programas, mios, "E3.5", nombre)
    with monkeypatch.context() as roto:
        roto.setattr(nuevo, "enunciado", None)
        with pytest.raises(TypeError):
            nuevo.crea(RAIZ, programas, mios, "E3.5", "z")
    (mios / "grua/ejercicio.txt").write_text("E3.5 no/esta")
    with pytest.raises(entrega.Fallo, match="ejercicio.txt no dice de qué ejercicio es"):
        entrega.ejercicio_de(mios / "grua", programas)
    assert sorted(f.name for f in mios.iterdir()) == ["grua", "mi_a"]


def test_cada_carpeta_con_otro_nombre(tmp_path):
    """De cada ejercicio y de cada programa: los ficheros que nombra el enunciado y sus controles están, y de las marcas
    solo quedan las suyas."""
    programas = catalogo.lee_programas(BUILD)
    pedidos = *nuevo.ejercicios(RAIZ, programas), *(p.nombre for p in programas)
    for pedido in pedidos:
        referencia, carpeta = nuevo.crea(RAIZ, programas, tmp_path, pedido, f"m_{pedido.lower().replace('.', '_')}")
        enunciado = carpeta / "ENUNCIADO.md"
        nombrados = re.findall("^- `(.+)`: ", enunciado.read_text(), re.M) if referencia else []
        assert bool(referencia) == bool(nombrados) and all((carpeta / f).is_file() for f in nombrados), pedido
        if referencia:  # si no, se le diría que lo empezó con otra versión
            programa = nuevo.ejercicios(RAIZ, programas)[referencia]
            hoy = nuevo.version(esqueleto := nuevo.esqueleto(RAIZ, programa, referencia))
            mandos = re.search("// Controles: .*", (RAIZ / programa.fuente).read_text())[0]
            assert mandos in esqueleto.get(programa.fuente.name, mandos), "con F1 no se dirían sus teclas"
            assert entrega.lee_entrega(carpeta, referencia).version == hoy, pedido
        for fichero in carpeta.iterdir():
            marcas_ = re.findall(r"// (?:fin de )?([EL]\d+\.\d+)|// (de partida)", fichero.read_text())
            quedan = {m[0] or m[1] for m in marcas_ if fichero.suffix != ".md"}
            assert quedan <= {referencia}, f"{pedido}: {fichero.name} {quedan}"


def test_de_lo_que_no_se_corrige_dice_que_hacer(tmp_path):
    programas = catalogo.lee_programas(BUILD)
    se_corrigen = nuevo.ejercicios(RAIZ, programas)
    p, sin = next((p, r) for p in programas for r in p.referencias if nuevo.es_del_libro(r) and r not in se_corrigen)
    for pedido, dice in (
        (sin, f"el ejercicio {sin[1:]} no tiene programa que corregir; .* ./lab nuevo {p.nombre}. Se corrigen E"),
        ("ch01", "elige uno: "),
        ("L3.1", "se hace en la página, que lo da empezado: .*#ejercicio/L3.1; ./lab nuevo objetos da una copia"),
    ):
        with pytest.raises(nuevo.Fallo, match=dice):
            nuevo.crea(RAIZ, programas, tmp_path, pedido)
    assert nuevo.crea(RAIZ, programas, tmp_path, "L1.1")[0] == ""
