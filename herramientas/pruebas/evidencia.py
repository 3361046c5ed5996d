#!/usr/bin/env python3
"""evidencia.py comprueba RAIZ BUILD   que docs/ dice la verdad de las pruebas: lo que no, se escribe y acaba con 1
evidencia.py mide RAIZ BUILD        ejecuta las pruebas, apunta lo que miden en docs/medidas.json y rehace docs/exactitud.md (unos minutos);
                                    en BUILD/exactitud/ deja cada imagen al lado de su referencia y de su diferencia

Se comprueba que exista cada prueba nombrada en docs/*.md; que cada errata tenga la suya o diga por qué no y cada ejercicio, su respuesta;
que no falte ninguna ecuación del libro en docs/ecuaciones.md y que esté donde dice; que cada programa tenga una comprobación independiente
de su golden (CONTRA y PRUEBAS, en el CMakeLists.txt de su capítulo) y docs/medidas.json sea de esas pruebas, que lo ejecutaron; que esté
dicho por qué pasan de 2 niveles los que pasan; y lo mismo de los casos difíciles."""
import json
import os
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "herramientas"))
import catalogo
import medidas
from libro import filas
from procesos import pruebas_de

# Las ecuaciones numeradas del libro: de la 1 a la n de cada capítulo.
ECUACIONES = {3: 10, 4: 4, 5: 7, 7: 4, 8: 1, 9: 1, 11: 42}
CITA = re.compile(r"`([a-z0-9_]+(?:\.[\w/]+)+\*?)`")
SIN_PRUEBA = "Sin prueba:"


def lista_pruebas(build):
    """«ch03_giro.GiroEje.AnguloPequeno» de cada TEST de cada programa de GoogleTest."""
    return [f"{ejecutable.name[:-5]}.{nombre}" for ejecutable in sorted((build / "tests").glob("*_test")) for nombre in pruebas_de(ejecutable)]


def busca(cita, pruebas):
    """Las pruebas a que se refiere: la de ese nombre, las de ese grupo o ese fichero, o las que empiezan así si acaba en *."""
    if cita.endswith("*"):
        return [p for p in pruebas if p.startswith(cita[:-1])]
    return [p for p in pruebas if p == cita or p.startswith(cita + ".")]


class Documentos:
    def __init__(self, raiz, build):
        self.raiz, self.build, self.fallos = raiz, build, 0
        self.pruebas = lista_pruebas(build)
        self.ejecutables = {p.split(".")[0] for p in self.pruebas}
        self.capitulos = catalogo.lee(build)
        self.programas = [p for capitulo in self.capitulos for p in capitulo.programas]
        self.casos = [(f"{tema}: {caso}", citas) for tema, caso, *citas in filas(raiz / "tests/casos_dificiles/casos.tsv")]
        self.medido = medidas.lee(raiz)

    def mal(self, que):
        print(que)
        self.fallos += 1

    def citas(self, texto):
        return [c for c in CITA.findall(texto) if c.split(".")[0] in self.ejecutables]

    def comprueba_citas(self):
        for fichero in sorted((self.raiz / "docs").glob("*.md")):
            for cita in CITA.findall(fichero.read_text()):
                if cita.split(".")[0] in self.ejecutables and not busca(cita, self.pruebas):
                    self.mal(f"{fichero.name}: no hay ninguna prueba «{cita}»")

    def comprueba_erratas(self):
        entradas = re.split(r"\n(?=- \*\*|## )", (self.raiz / "docs/erratas.md").read_text())
        for entrada in entradas:
            if entrada.startswith("- **") and not self.citas(entrada) and SIN_PRUEBA not in entrada:
                self.mal(f"erratas.md: sin prueba ni «{SIN_PRUEBA} …»: {entrada.splitlines()[0]}")

    def comprueba_ecuaciones(self):
        vistas = set()
        for linea in (self.raiz / "docs/ecuaciones.md").read_text().splitlines():
            fila = re.fullmatch(r"\| (\d+\.\d+) \| ([^|]+) \| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \|", linea)
            if not fila:
                if re.match(r"\| \d", linea):
                    self.mal(f"ecuaciones.md: no entiendo «{linea}»")
                continue
            numero, _, donde, funcion, prueba = fila.groups()
            vistas.add(numero)
            sitio = self.raiz / donde
            if not sitio.is_file():
                self.mal(f"ecuaciones.md, {numero}: no existe {donde}")
            elif not re.search(rf"\b{re.escape(funcion)}\b", sitio.read_text()):
                self.mal(f"ecuaciones.md, {numero}: {donde} no tiene «{funcion}»")
            if not busca(prueba, self.pruebas):
                self.mal(f"ecuaciones.md, {numero}: no hay ninguna prueba «{prueba}»")
        capitulos = {capitulo.numero for capitulo in self.capitulos}
        todas = {f"{c}.{i}" for c, n in ECUACIONES.items() if c in capitulos for i in range(1, n + 1)}
        for numero in sorted(todas - vistas, key=lambda n: [int(x) for x in n.split(".")]):
            self.mal(f"ecuaciones.md: falta la ecuación {numero}")
        for numero in vistas - todas:
            self.mal(f"ecuaciones.md: el libro no tiene ecuación {numero}")

    def comprueba_soluciones(self):
        soluciones = (self.raiz / "docs/soluciones.md").read_text()
        for codigo, *_ in filas(self.raiz / "docs/libro.tsv"):
            if codigo.startswith("E") and f"- **{codigo[1:]}**" not in soluciones:
                self.mal(f"soluciones.md: falta el ejercicio {codigo[1:]}")

    def comprueba_programas(self):
        """Cada programa, con una prueba que lo ejecute y que no sea su golden."""
        medido = dict(self.medido["programas"])
        for p in self.programas:
            medida = medido.pop(p.nombre, {})
            if not p.contra or not p.pruebas:
                self.mal(f"{p.fuente}: no tiene comprobación independiente: CONTRA y PRUEBAS")
            elif medida.get("pruebas") != p.pruebas:
                self.mal(f"medidas.json no es de las pruebas de «{p.nombre}»: tests/laboratorio/evidencia.py mide")
            for cita in p.pruebas:
                if not busca(cita, self.pruebas):
                    self.mal(f"{p.nombre}: no hay ninguna prueba «{cita}»")
            if bool(p.pasa) != (medida.get("maximo", 0) > 2):
                self.mal(f"{p.nombre}: " + ("ya no pasa de 2 niveles: sobra PASA" if p.pasa else "falta por qué pasa de 2 niveles: PASA"))
        for programa in medido:
            self.mal(f"medidas.json: no hay ningún programa «{programa}»")

    def comprueba_casos(self):
        """Los casos difíciles: cada uno, con pruebas; y ninguna de un fichero dificil_* sin estar en la lista."""
        medido = dict(self.medido["casos"])
        nombradas = set()
        for caso, citas in self.casos:
            for cita in citas:
                if not busca(cita, self.pruebas):
                    self.mal(f"casos.tsv, {caso}: no hay ninguna prueba «{cita}»")
            suyas = [p for cita in citas for p in busca(cita, self.pruebas)]
            nombradas.update(suyas)
            if medido.pop(caso, {}).get("pruebas") != len(suyas):
                self.mal(f"medidas.json no es de las pruebas de «{caso}»: tests/laboratorio/evidencia.py mide")
        for caso in medido:
            self.mal(f"medidas.json: no hay ningún caso «{caso}»")
        for prueba in self.pruebas:
            if prueba.startswith("dificil_") and prueba not in nombradas:
                self.mal(f"casos.tsv: falta «{prueba}»")


def ejecuta(build, citas, pruebas):
    """Las propiedades que apunta cada prueba citada."""
    entorno = dict(os.environ)
    for linea in (build / "entorno.txt").read_text().splitlines():
        nombre, _, valor = linea.partition("=")
        entorno.setdefault(nombre, valor)
    entorno["LAB_COMPARACIONES"] = str(build / "exactitud")
    quiere = {}
    for cita in citas:
        for prueba in busca(cita, pruebas):
            ejecutable, nombre = prueba.split(".", 1)
            quiere.setdefault(ejecutable, []).append(nombre)
    propiedades = {}
    informes = build / "exactitud"
    informes.mkdir(exist_ok=True)
    for ejecutable, nombres in sorted(quiere.items()):
        orden, informe = build / "tests" / f"{ejecutable}_test", informes / f"{ejecutable}.json"
        apuntado = lee_informe(informe) if informe.exists() and informe.stat().st_mtime > orden.stat().st_mtime else {}
        if not set(nombres) <= set(apuntado):  # si no, vale lo que midió la otra vez
            print(f"{ejecutable}: {len(nombres)} pruebas", file=sys.stderr)
            if subprocess.run([orden, f"--gtest_filter={':'.join(nombres)}", f"--gtest_output=json:{informe}"], env=entorno,
                              stdout=subprocess.DEVNULL).returncode:
                informe.unlink(missing_ok=True)
                sys.exit(f"{ejecutable}: no pasan sus pruebas")
            apuntado = lee_informe(informe)
        propiedades.update({f"{ejecutable}.{nombre}": p for nombre, p in apuntado.items()})
    return propiedades


def lee_informe(informe):
    """Lo que apuntó cada prueba de un --gtest_output=json."""
    return {f"{grupo['name']}.{prueba['name']}": prueba for grupo in json.loads(informe.read_text())["testsuites"]
            for prueba in grupo["testsuite"]}


def unidad(texto):
    """GoogleTest escribe en el JSON cada byte de UTF-8 como si fuera un carácter."""
    try:
        return texto.encode("latin-1").decode()
    except UnicodeError:
        return texto  # esta versión no lo hace


def mide_programa(p, pruebas, propiedades):
    """Lo peor que han medido sus pruebas."""
    for cita in p.pruebas:
        if not any(f"ejecuta_{p.nombre}" in propiedades[prueba] for prueba in busca(cita, pruebas)):
            sys.exit(f"{p.nombre}: «{cita}» no lo ejecuta")
    todas = [propiedades[prueba].get(f"pixeles_{p.nombre}") for cita in p.pruebas for prueba in busca(cita, pruebas)]
    medido = [[float(x) for x in m.split()] for m in todas if m]
    peor = {"pruebas": p.pruebas}
    if medido:
        *mayores, lejos, banda = zip(*medido)
        peor.update({que: float(f"{max(m):.3g}") for que, m in zip(("maximo", "rmse", "borde"), mayores) if max(m) >= 0})
        if sum(lejos):
            peor.update(lejos=int(sum(lejos)), banda=int(sum(banda)))
    return peor


def mide_caso(citas, pruebas, propiedades):
    """Cuántas pruebas tiene y la que más se acerca a su cota."""
    suyas = [prueba for cita in citas for prueba in busca(cita, pruebas)]
    miden = [p for p in (propiedades.get(prueba, {}) for prueba in suyas) if "medida" in p]
    peor = {"pruebas": len(suyas)}
    if miden:
        p = max(miden, key=lambda p: float(p["medida"]) / float(p["cota"]) if float(p["cota"]) else float(p["medida"]))
        peor.update(medida=float(p["medida"]), cota=float(p["cota"]), unidad=unidad(p["unidad"]))
    return peor


def mide(d):
    # de los casos difíciles, las que miden: las otras solo se cuentan
    citas = {cita for p in d.programas for cita in p.pruebas} | {c for _, suyas in d.casos for c in suyas if c.startswith("dificil_")}
    propiedades = ejecuta(d.build, sorted(citas), d.pruebas)
    medidas.apunta(d.raiz, programas={p.nombre: mide_programa(p, d.pruebas, propiedades) for p in d.programas},
                   casos={caso: mide_caso(suyas, d.pruebas, propiedades) for caso, suyas in d.casos})
    return subprocess.run([sys.executable, "-B", d.raiz / "herramientas/documentos.py", d.raiz, d.build, "escribe"]).returncode


def main():
    orden, raiz, build = sys.argv[1], *map(lambda r: pathlib.Path(r).resolve(), sys.argv[2:4])
    d = Documentos(raiz, build)
    if orden == "mide":
        return mide(d)
    for comprueba in (d.comprueba_citas, d.comprueba_erratas, d.comprueba_ecuaciones, d.comprueba_soluciones, d.comprueba_programas,
                      d.comprueba_casos):
        comprueba()
    return 1 if d.fallos else 0


sys.exit(main())
