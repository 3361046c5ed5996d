"""documentos.py RAÍZ BUILD: que docs/ dice la verdad de las pruebas; lo que no, se escribe y acaba con 1.

Se comprueba que exista cada prueba y cada programa que nombra; que cada errata tenga su prueba o diga por qué no y cada
ejercicio, su respuesta; que cada función de un listado del libro la llame el programa que lo lleva o diga su cabecera
por qué no; que no falte ninguna ecuación del libro en docs/ecuaciones.md y que esté donde dice; que cada programa tenga
una comprobación independiente de su golden (CONTRA y PRUEBAS, en el catálogo de su capítulo) y docs/evidencia.json sea
de esas pruebas, que lo ejecutaron; que esté dicho por qué pasan de 2 niveles los que pasan; y lo mismo de los casos
difíciles."""
import re
import sys
from pathlib import Path

from base import catalogo, evidencia, fuentes
from base.libro import cosas, filas
from pruebas import googletest
from pruebas.evidencia import casos_dificiles
from pruebas.googletest import busca

# Las ecuaciones numeradas del libro: de la 1 a la n de cada capítulo.
ECUACIONES = {3: 10, 4: 4, 5: 7, 7: 4, 8: 1, 9: 1, 11: 42}
CITA = re.compile(r"`([a-z0-9_]+(?:\.[\w/]+)+\*?)`")
SIN_PRUEBA = "Sin prueba:"
# Cómo se nombra una cosa. Las pruebas, tras «Prueba:» hasta que acaba la entrada o su paréntesis.
PRUEBAS = re.compile(r"\bPruebas?\b[^:`]*: ([^()]*(?:\([^()]*\)[^()]*)*)|[(;] ?pruebas?:\s([^()]*)\)")
PRUEBA = re.compile(r"(?:\b[a-z]\w*\.)?\b[A-Z][a-z]\w*\.[A-Z]\w+")
PROGRAMA = re.compile(
    r"[Pp]rogramas? `(\w+)`|`(\w+)`, (?:con |y )?(?:las? )?teclas? |^- \*\*.*?\*\* \(`(\w+)`\)", re.MULTILINE
)
FICHERO = re.compile(r"(?<![\w.*<>/$-])((?:[\w-]+/)*[\w-]+\.(?:cpp|h|vert|frag|glsl))\b")
CPP = ".cpp", ".h"
APUNTA = "./lab prueba --apunta"


class Documentos:
    def __init__(self, raiz, build):
        self.raiz, self.fallos = raiz, 0
        preguntas = (f.read_text() for f in sorted(raiz.glob("tests/propiedades/*.py")))
        propiedades = [
            f"propiedades.{nombre}" for texto in preguntas for nombre in re.findall(r"^def (\w+)\(p\)", texto, re.M)
        ]
        self.pruebas = googletest.todas(build) + propiedades
        self.ejecutables = {p.split(".")[0] for p in self.pruebas}
        self.capitulos = catalogo.lee(build)
        self.programas = [p for capitulo in self.capitulos for p in capitulo.programas]
        self.medido = evidencia.lee(raiz)

    def mal(self, que):
        print(que)
        self.fallos += 1

    def citas(self, texto):
        return [c for c in CITA.findall(texto) if c.split(".")[0] in self.ejecutables]

    def comprueba_citas(self):
        for fichero in sorted((self.raiz / "docs").glob("*.md")):
            for cita in self.citas(fichero.read_text()):
                if not busca(cita, self.pruebas):
                    self.mal(f"{fichero.name}: no hay ninguna prueba «{cita}»")

    def comprueba_nombrado(self):
        """Los programas que nombran los documentos y las pruebas que nombran ellos y los comentarios de los
        capítulos."""
        documentos = [self.raiz / f for f in ("README.md", "CONTRIBUTING.md")] + sorted(self.raiz.glob("docs/*.md"))
        fuentes_suyos = [
            f for f in sorted(self.raiz.glob("ch??_*/*")) if f.suffix in fuentes.SHADERS or f.suffix in CPP
        ]
        nombres = {p.nombre for p in self.programas}
        for fichero in documentos + fuentes_suyos:
            texto = fichero.read_text()
            hallados = PROGRAMA.findall(texto) if fichero in documentos else []
            for nombre in {"".join(hallado) for hallado in hallados} - nombres:
                self.mal(f"{fichero.name}: no hay ningún programa «{nombre}»")
            dicho = texto if fichero in documentos else "\n".join(re.findall("//(.*)", texto))
            for prueba in PRUEBA.findall(dicho):
                if not any(p.startswith(prueba) or p.partition(".")[2].startswith(prueba) for p in self.pruebas):
                    self.mal(f"{fichero.name}: no hay ninguna prueba «{prueba}»")

    def comprueba_pruebas_sueltas(self):
        """Todo lo que sigue a «Prueba:» lo es; también por su último nombre, si es del grupo de la de antes."""
        for fichero in ("erratas.md", "soluciones.md"):
            for entrada in self.entradas(fichero):
                grupo = ""
                for cita in re.findall("`([^`]+)`", " ".join("".join(h) for h in PRUEBAS.findall(entrada))):
                    if not busca(cita, self.pruebas) and f"{grupo}.{cita}" not in self.pruebas:
                        self.mal(f"{fichero}: «{cita}» no es ninguna prueba")
                    grupo = cita.rpartition(".")[0] or grupo

    def entradas(self, fichero):
        return re.split(r"\n(?=- \*\*|## )", (self.raiz / "docs" / fichero).read_text())

    def comprueba_listados(self):
        """Cada función de un listado: la llama el programa que lo lleva (él, lo que incluye de los capítulos y lo que
        nombra su cabecera) o dice su cabecera por qué no."""
        listados = [cosa for cosa in cosas(self.raiz) if cosa.funciones]
        for p in self.programas:
            suyos = [cosa for cosa in listados if cosa.codigo in p.referencias]
            if not suyos:
                continue
            cabecera = re.match(r"(?://.*\n)*", (self.raiz / p.fuente).read_text())[0]
            nombrados = [c / n for n in FICHERO.findall(cabecera) for c in (Path(), p.fuente.parent)]
            ficheros = [*fuentes.alcanza(self.raiz, p.fuente), *(n for n in nombrados if (self.raiz / n).is_file())]
            codigo = re.sub("//.*", "", "\n".join((self.raiz / fichero).read_text() for fichero in ficheros))
            for cosa in suyos:
                for f in cosa.funciones.split():
                    if not re.search(rf"\b{f}\b", cabecera) and not re.search(rf"\b{f}\(", codigo):
                        self.mal(f"{p.nombre}: ni llama a {f}, del listado {cosa.codigo[1:]}, ni dice por qué no")

    def comprueba_erratas(self):
        for entrada in self.entradas("erratas.md"):
            if entrada.startswith("- **") and not self.citas(entrada) and SIN_PRUEBA not in entrada:
                self.mal(f"erratas.md: sin prueba ni «{SIN_PRUEBA} …»: {entrada.splitlines()[0]}")

    def comprueba_ecuaciones(self):
        vistas = set()
        for linea in (self.raiz / "docs/ecuaciones.md").read_text().splitlines():
            fila = re.fullmatch(r"\| (\d+\.\d+) \| ([^|]+) \| `([^`]+)` \| `([^`]+)` \| `([^`]+)` \|", linea)
            if fila:
                vistas.add(fila[1])
                self.comprueba_ecuacion(fila[1], *fila.groups()[2:])
            elif re.match(r"\| \d", linea):
                self.mal(f"ecuaciones.md: no entiendo «{linea}»")
        capitulos = {capitulo.numero for capitulo in self.capitulos}
        todas = {f"{c}.{i}" for c, n in ECUACIONES.items() if c in capitulos for i in range(1, n + 1)}
        for numero in sorted(todas - vistas, key=lambda n: [int(x) for x in n.split(".")]):
            self.mal(f"ecuaciones.md: falta la ecuación {numero}")
        for numero in vistas - todas:
            self.mal(f"ecuaciones.md: el libro no tiene ecuación {numero}")

    def comprueba_ecuacion(self, numero, donde, funcion, prueba):
        sitio = self.raiz / donde
        if not sitio.is_file():
            self.mal(f"ecuaciones.md, {numero}: no existe {donde}")
        elif not re.search(rf"\b{re.escape(funcion)}\b", sitio.read_text()):
            self.mal(f"ecuaciones.md, {numero}: {donde} no tiene «{funcion}»")
        if not busca(prueba, self.pruebas):
            self.mal(f"ecuaciones.md, {numero}: no hay ninguna prueba «{prueba}»")

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
                self.mal(f"evidencia.json no es de las pruebas de «{p.nombre}»: {APUNTA}")
            for cita in p.pruebas:
                if not busca(cita, self.pruebas):
                    self.mal(f"{p.nombre}: no hay ninguna prueba «{cita}»")
            if bool(p.pasa) != (medida.get("maximo", 0) > 2):
                que = "ya no pasa de 2 niveles: sobra PASA" if p.pasa else "falta por qué pasa de 2 niveles: PASA"
                self.mal(f"{p.nombre}: {que}")
        for programa in medido:
            self.mal(f"evidencia.json: no hay ningún programa «{programa}»")

    def comprueba_casos(self):
        """Los casos difíciles: cada uno, con pruebas; y ninguna de un fichero dificil_* sin estar en la lista."""
        medido = dict(self.medido["casos"])
        nombradas = set()
        for caso, citas in casos_dificiles(self.raiz).items():
            for cita in citas:
                if not busca(cita, self.pruebas):
                    self.mal(f"casos.tsv, {caso}: no hay ninguna prueba «{cita}»")
            suyas = [p for cita in citas for p in busca(cita, self.pruebas)]
            nombradas.update(suyas)
            medida = medido.pop(caso, {})
            if (medida.get("pruebas"), medida.get("citas")) != (len(suyas), citas):
                self.mal(f"evidencia.json no es de las pruebas de «{caso}»: {APUNTA}")
        for caso in medido:
            self.mal(f"evidencia.json: no hay ningún caso «{caso}»")
        for prueba in self.pruebas:
            if prueba.startswith("dificil_") and prueba not in nombradas:
                self.mal(f"casos.tsv: falta «{prueba}»")


def main():
    d = Documentos(*(Path(ruta).resolve() for ruta in sys.argv[1:]))
    d.comprueba_citas()
    d.comprueba_nombrado()
    d.comprueba_pruebas_sueltas()
    d.comprueba_listados()
    d.comprueba_erratas()
    d.comprueba_ecuaciones()
    d.comprueba_soluciones()
    d.comprueba_programas()
    d.comprueba_casos()
    return 1 if d.fallos else 0


if __name__ == "__main__":
    sys.exit(main())
