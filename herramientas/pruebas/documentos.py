"""documentos.py RAÍZ BUILD: que docs/ dice la verdad de las pruebas; lo que no, se escribe y acaba con 1.

Se comprueba que exista cada prueba y cada programa que se nombra, en docs/, en el catálogo y en los comentarios de los
capítulos; que cada errata tenga su prueba o diga por qué no y cada ejercicio, su respuesta; que cada función de un
listado del libro la llame el programa que lo lleva o diga su cabecera por qué no; que no falte ninguna ecuación del
libro en docs/ecuaciones.md y que esté donde dice; que cada programa tenga una comprobación independiente de su golden
(CONTRA y PRUEBAS) y, si pasa de 2 niveles, esté dicho por qué (PASA); que docs/evidencia.json sea de los programas
que hay, y cada prueba de un fichero dificil_*, de un caso difícil."""
import re
import sys
from pathlib import Path

from base import catalogo, evidencia, fuentes
from base.libro import cosas
from pruebas import googletest
from pruebas.evidencia import casos_dificiles
from pruebas.googletest import busca

# Las ecuaciones numeradas del libro: de la 1 a la n de cada capítulo.
ECUACIONES = {3: 10, 4: 4, 5: 7, 7: 4, 8: 1, 9: 1, 11: 42}
CITA = re.compile(r"\b([a-z]\w*\.(?!md|cpp|py)\w+(?:[./]\w+)*\*?)")  # ch03_grua.Grua.ContraTrazadoDeRayos
SIN_PRUEBA = "Sin prueba:"
PROGRAMA = re.compile(
    r"[Pp]rogramas? `(\w+)`|`(\w+)`, (?:con |y )?(?:las? )?teclas? |^- \*\*.*?\*\* \(`(\w+)`\)", re.MULTILINE
)
FICHERO = re.compile(r"(?<![\w.*<>/$-])((?:[\w-]+/)*[\w-]+\.(?:cpp|h|vert|frag|glsl))\b")


class Documentos:
    def __init__(self, raiz, build):
        self.raiz = raiz
        preguntas = "\n".join(f.read_text() for f in raiz.glob("tests/propiedades/*.py"))
        propiedades = [f"propiedades.{nombre}" for nombre in re.findall(r"^def (\w+)\(p\)", preguntas, re.M)]
        self.pruebas = googletest.todas(build) + propiedades
        self.ejecutables = {p.split(".")[0] for p in self.pruebas}
        self.capitulos = catalogo.lee(build)
        self.programas = [p for capitulo in self.capitulos for p in capitulo.programas]

    def citas(self, texto):
        return [c for c in CITA.findall(texto) if c.split(".")[0] in self.ejecutables]

    def comprueba_citas(self, donde, citas):
        for cita in citas:
            if not busca(cita, self.pruebas):
                yield f"{donde}: no hay ninguna prueba «{cita}»"

    def comprueba_nombrado(self):
        nombres = {p.nombre for p in self.programas}
        for fichero in (*self.raiz.glob("*.md"), *self.raiz.glob("docs/*.md"), self.raiz / "docs/evidencia.json"):
            texto = fichero.read_text()
            yield from self.comprueba_citas(fichero.name, self.citas(re.sub("`./lab .*?`", "", texto)))
            for nombre in {"".join(hallado) for hallado in PROGRAMA.findall(texto)} - nombres:
                yield f"{fichero.name}: no hay ningún programa «{nombre}»"
        for fichero in self.raiz.glob("ch??_*/*"):
            if fichero.suffix in (".cpp", ".h", *fuentes.SHADERS):
                yield from self.comprueba_citas(
                    fichero.name, self.citas("\n".join(re.findall("//(.*)", fichero.read_text())))
                )

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
                        yield f"{p.nombre}: ni llama a {f}, del listado {cosa.codigo[1:]}, ni dice por qué no"

    def comprueba_erratas(self):
        for entrada in re.split(r"\n(?=- \*\*|## )", (self.raiz / "docs/erratas.md").read_text()):
            if entrada.startswith("- **") and not self.citas(entrada) and SIN_PRUEBA not in entrada:
                yield f"erratas.md: sin prueba ni «{SIN_PRUEBA} …»: {entrada.splitlines()[0]}"

    def comprueba_ecuaciones(self):
        capitulos = {capitulo.numero for capitulo in self.capitulos}
        faltan = {f"{c}.{i}" for c, n in ECUACIONES.items() if c in capitulos for i in range(1, n + 1)}
        fila = re.compile(r"^\| (\d+\.\d+) \| [^|]+ \| `([^`]+)` \| `([^`]+)` \| `[^`]+` \|$", re.MULTILINE)
        for numero, donde, funcion in fila.findall((self.raiz / "docs/ecuaciones.md").read_text()):
            if numero not in faltan:
                yield f"ecuaciones.md: el libro no tiene ecuación {numero}, o está dos veces"
            faltan.discard(numero)
            sitio = self.raiz / donde
            if not sitio.is_file() or not re.search(rf"\b{re.escape(funcion)}\b", sitio.read_text()):
                yield f"ecuaciones.md, {numero}: no hay «{funcion}» en {donde}"
        for numero in sorted(faltan):
            yield f"ecuaciones.md: falta la ecuación {numero}"

    def comprueba_soluciones(self):
        soluciones = (self.raiz / "docs/soluciones.md").read_text()
        for cosa in cosas(self.raiz):
            if cosa.codigo.startswith("E") and f"- **{cosa.codigo[1:]}**" not in soluciones:
                yield f"soluciones.md: falta el ejercicio {cosa.codigo[1:]}"

    def comprueba_programas(self, medido):
        """Cada programa, con una prueba que lo ejecute y que no sea su golden."""
        for p in self.programas:
            if not p.contra or not p.pruebas:
                yield f"{p.fuente}: no tiene comprobación independiente: CONTRA y PRUEBAS"
            if bool(p.pasa) != (medido.get(p.nombre, {}).get("maximo", 0) > 2):
                que = "ya no pasa de 2 niveles: sobra PASA" if p.pasa else "falta por qué pasa de 2 niveles: PASA"
                yield f"{p.nombre}: {que}"

    def comprueba_medido(self):
        """docs/evidencia.json es de los programas que hay; y ninguna de un fichero dificil_* deja de ser de un caso."""
        medido, casos = evidencia.lee(self.raiz)["programas"], casos_dificiles(self.raiz)
        yield from self.comprueba_programas(medido)
        for nombre in {p.nombre for p in self.programas} ^ medido.keys():
            yield f"evidencia.json: falta o sobra «{nombre}»: ./lab prueba --apunta"
        suyas = {prueba for citas in casos.values() for cita in citas for prueba in busca(cita, self.pruebas)}
        for prueba in {p for p in self.pruebas if p.startswith("dificil_")} - suyas:
            yield f"casos.tsv: falta «{prueba}»"


def main():
    d = Documentos(*(Path(ruta).resolve() for ruta in sys.argv[1:]))
    preguntas = d.comprueba_nombrado, d.comprueba_listados, d.comprueba_erratas, d.comprueba_ecuaciones
    preguntas += d.comprueba_soluciones, d.comprueba_medido
    fallos = [fallo for pregunta in preguntas for fallo in pregunta()]
    print(*fallos, sep="\n")
    return bool(fallos)


if __name__ == "__main__":
    sys.exit(main())
