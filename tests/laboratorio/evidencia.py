#!/usr/bin/env python3
"""evidencia.py comprueba RAIZ BUILD   que docs/ dice la verdad de las pruebas: lo que no, se escribe y acaba con 1
evidencia.py escribe RAIZ BUILD     ejecuta las pruebas y rehace las tablas de docs/exactitud.md (unos minutos); en
                                    BUILD/exactitud/ deja cada imagen al lado de su referencia y de su diferencia

Se comprueba que exista cada prueba nombrada en docs/*.md; que cada errata tenga la suya o diga por qué no; que no falte ninguna
ecuación del libro en docs/ecuaciones.md y que esté donde dice; que cada programa tenga una comprobación independiente de su
golden (docs/exactitud.tsv) cuyo fuente lo ejecute; y que las tablas de docs/exactitud.md sean las de esos programas y casos."""
import json
import os
import pathlib
import re
import subprocess
import sys

# Las ecuaciones numeradas del libro: de la 1 a la n de cada capítulo.
ECUACIONES = {3: 10, 4: 4, 5: 7, 7: 4, 8: 1, 9: 1, 11: 42}
CITA = re.compile(r"`([a-z0-9_]+(?:\.[\w/]+)+\*?)`")
SIN_PRUEBA = "Sin prueba:"


def lista_pruebas(build):
    """«ch03_giro.GiroEje.AnguloPequeno» de cada programa de GoogleTest, y lo que hay de cada uno."""
    nombres = []
    for ejecutable in sorted((build / "tests").glob("*_test")):
        salida = subprocess.run([ejecutable, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
        for linea in salida.splitlines():
            if not linea.startswith(" "):
                grupo = linea.split("#")[0].strip()
            else:
                nombres.append(f"{ejecutable.name[:-5]}.{grupo}{linea.split('#')[0].strip()}")
    return nombres


def busca(cita, pruebas):
    """Las pruebas a que se refiere: la de ese nombre, las de ese grupo o ese fichero, o las que empiezan así si acaba en *."""
    if cita.endswith("*"):
        return [p for p in pruebas if p.startswith(cita[:-1])]
    return [p for p in pruebas if p == cita or p.startswith(cita + ".")]


def filas(fichero):
    """Las de un TSV, sin la cabecera ni los comentarios."""
    return [linea.split("\t") for linea in fichero.read_text().splitlines() if linea and not linea.startswith("#")]


def fuente(raiz, prueba):
    """El fichero en que está esa prueba."""
    return next((raiz / "tests").glob(f"*/{prueba.split('.')[0]}_test.cpp"))


class Documentos:
    def __init__(self, raiz, build):
        self.raiz, self.build, self.fallos = raiz, build, 0
        self.pruebas = lista_pruebas(build)
        self.ejecutables = {p.split(".")[0] for p in self.pruebas}
        self.catalogo = [linea.split("\t") for linea in (build / "catalogo.tsv").read_text().splitlines()]

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
        capitulos = {int(fila[0][2:4]) for fila in self.catalogo}
        todas = {f"{c}.{i}" for c, n in ECUACIONES.items() if c in capitulos for i in range(1, n + 1)}
        for numero in sorted(todas - vistas, key=lambda n: [int(x) for x in n.split(".")]):
            self.mal(f"ecuaciones.md: falta la ecuación {numero}")
        for numero in vistas - todas:
            self.mal(f"ecuaciones.md: el libro no tiene ecuación {numero}")

    def comprueba_programas(self):
        """Cada programa, con una prueba que lo ejecute y que no sea su golden."""
        evidencia = {fila[0]: fila[1:] for fila in filas(self.raiz / "docs/exactitud.tsv")}
        for capitulo, programa, *_ in self.catalogo:
            if programa not in evidencia:
                self.mal(f"{capitulo}/{programa}: no tiene comprobación independiente en docs/exactitud.tsv")
                continue
            _, *citas = evidencia.pop(programa)
            for cita in citas:
                if not busca(cita, self.pruebas):
                    self.mal(f"exactitud.tsv, {programa}: no hay ninguna prueba «{cita}»")
                elif not re.search(rf'[/"]{programa}"', fuente(self.raiz, cita).read_text()):
                    self.mal(f"exactitud.tsv, {programa}: «{cita}» no lo ejecuta")
        for programa in evidencia:
            self.mal(f"exactitud.tsv: no hay ningún programa «{programa}»")

    def comprueba_casos(self):
        """Los casos dificiles: cada uno, con pruebas; y ninguna de un fichero dificil_* sin estar en la lista."""
        nombradas = set()
        for tema, caso, *citas in filas(self.raiz / "tests/casos_dificiles/casos.tsv"):
            for cita in citas:
                encontradas = busca(cita, self.pruebas)
                nombradas.update(encontradas)
                if not encontradas:
                    self.mal(f"casos.tsv, {tema}, {caso}: no hay ninguna prueba «{cita}»")
        for prueba in self.pruebas:
            if prueba.startswith("dificil_") and prueba not in nombradas:
                self.mal(f"casos.tsv: falta «{prueba}»")

    def comprueba_tablas(self):
        """docs/exactitud.md tiene una fila por programa y por caso difícil, y nada más."""
        texto = (self.raiz / "docs/exactitud.md").read_text().partition("\n## Defectos plantados")[0]
        programas = [fila[0] for fila in filas(self.raiz / "docs/exactitud.tsv")]
        casos = [f"{fila[0]}: {fila[1]}" for fila in filas(self.raiz / "tests/casos_dificiles/casos.tsv")]
        escritas = re.findall(r"^\| ([^|]+?) \|", texto, re.M)
        cabeceras = {"programa", "caso", "---"}
        for sobra in set(escritas) - set(programas) - set(casos) - cabeceras:
            self.mal(f"exactitud.md: sobra la fila «{sobra}»")
        explicados = set(re.findall(r"`(\w+)`", re.search(r"^Pasan de 2 niveles.*?(?=^##)", texto, re.M | re.S)[0]))
        pasan = {m[1] for m in re.finditer(r"^\| (\w+) \| [^|]+ \| ([\d.]+) \|", texto, re.M) if float(m[2]) > 2}
        for programa in pasan ^ explicados:
            self.mal(f"exactitud.md: de «{programa}» " + ("falta por qué pasa de 2 niveles" if programa in pasan else "ya no pasa de 2 niveles"))
        for falta in [f for f in programas + casos if f not in escritas]:
            self.mal(f"exactitud.md: falta la fila «{falta}»: tests/laboratorio/evidencia.py escribe")


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
        medidas = lee_informe(informe) if informe.exists() and informe.stat().st_mtime > orden.stat().st_mtime else {}
        if not set(nombres) <= set(medidas): # si no, vale lo que midió la otra vez
            print(f"{ejecutable}: {len(nombres)} pruebas", file=sys.stderr)
            if subprocess.run([orden, f"--gtest_filter={':'.join(nombres)}", f"--gtest_output=json:{informe}"], env=entorno,
                              stdout=subprocess.DEVNULL).returncode:
                informe.unlink(missing_ok=True)
                sys.exit(f"{ejecutable}: no pasan sus pruebas")
            medidas = lee_informe(informe)
        propiedades.update({f"{ejecutable}.{nombre}": p for nombre, p in medidas.items()})
    return propiedades


def lee_informe(informe):
    """Lo que apuntó cada prueba de un --gtest_output=json."""
    return {f"{grupo['name']}.{prueba['name']}": prueba for grupo in json.loads(informe.read_text())["testsuites"]
            for prueba in grupo["testsuite"]}


def unidad(texto):
    """La unidad de una medida, para una tabla. GoogleTest escribe en el JSON cada byte de UTF-8 como si fuera un carácter."""
    try:
        texto = texto.encode("latin-1").decode()
    except UnicodeError:
        pass  # esta versión no lo hace
    return texto.replace("|", "\\|")


def numero(texto, cifras=2):
    """Con pocas cifras: 0.51, 1.2e-07."""
    x = float(texto)
    return "0" if x == 0 else f"{x:.{cifras}g}" if abs(x) >= 1e-3 else f"{x:.1e}"


def escribe(d):
    programas = filas(d.raiz / "docs/exactitud.tsv")
    casos = filas(d.raiz / "tests/casos_dificiles/casos.tsv")
    # de los casos dificiles, las que miden: las otras solo se cuentan
    citas = {cita for fila in programas for cita in fila[2:]} | {c for fila in casos for c in fila[2:] if c.startswith("dificil_")}
    propiedades = ejecuta(d.build, sorted(citas), d.pruebas)

    tabla = ["| programa | contra qué | máximo | RMSE | borde | prueba |", "|---|---|---|---|---|---|"]
    de_pixeles = 0
    for programa, oraculo, *citas in programas:
        for cita in citas:
            if not any(f"ejecuta_{programa}" in propiedades[prueba] for prueba in busca(cita, d.pruebas)):
                sys.exit(f"exactitud.tsv, {programa}: «{cita}» no lo ejecuta")
        medidas = [valor.split() for cita in citas for prueba in busca(cita, d.pruebas)
                   for clave, valor in propiedades[prueba].items() if clave == f"pixeles_{programa}"]
        peor = [numero(mayor) if medidas and (mayor := max(float(m[i]) for m in medidas)) >= 0 else "" for i in range(3)]
        lejos, banda = (sum(int(float(m[i])) for m in medidas) for i in (3, 4))
        if lejos:
            peor[2] += f", salvo {lejos} de {banda}"
        de_pixeles += bool(medidas)
        tabla.append(f"| {programa} | {oraculo} | {' | '.join(peor)} | {', '.join(f'`{c}`' for c in citas)} |")
    dificiles = ["| caso | pruebas | la peor: medida / cota | cuáles |", "|---|---|---|---|"]
    cuantas = set()
    for tema, caso, *citas in casos:
        suyas = [prueba for cita in citas for prueba in busca(cita, d.pruebas)]
        cuantas.update(suyas)
        medidas = [(p["medida"], p["cota"], unidad(p["unidad"])) for p in (propiedades.get(x, {}) for x in suyas) if "medida" in p]
        peor = ""
        if medidas:
            m, c, u = max(medidas, key=lambda m: float(m[0]) / float(m[1]) if float(m[1]) else float(m[0]))
            peor = f"{numero(m)} / {numero(c)} {u}"
        dificiles.append(f"| {tema}: {caso} | {len(suyas)} | {peor} | {', '.join(f'`{c}`' for c in citas)} |")
    destino = d.raiz / "docs/exactitud.md"
    texto = destino.read_text()
    for marca, contenido in [("programas", tabla), ("casos", dificiles)]:
        texto = re.sub(rf"(<!-- {marca} -->\n).*?(<!-- fin -->)", lambda m: m[1] + "\n".join(contenido) + "\n" + m[2], texto, flags=re.S)
    texto = re.sub(r"Son \d+ programas, \d+ de ellos píxel a píxel", f"Son {len(programas)} programas, {de_pixeles} de ellos píxel a píxel", texto)
    texto = re.sub(r"Son \d+ pruebas con nombre", f"Son {len(cuantas)} pruebas con nombre", texto)
    destino.write_text(texto)


def main():
    orden, raiz, build = sys.argv[1], *map(lambda r: pathlib.Path(r).resolve(), sys.argv[2:4])
    d = Documentos(raiz, build)
    if orden == "escribe":
        escribe(d)
        return 0
    for comprueba in (d.comprueba_citas, d.comprueba_erratas, d.comprueba_ecuaciones, d.comprueba_programas, d.comprueba_casos,
                      d.comprueba_tablas):
        comprueba()
    return 1 if d.fallos else 0


sys.exit(main())
