"""La hoja de calificaciones que da Moodle (mod/assign/feedback/offline), con la nota y los comentarios puestos: lo
demás, columnas, filas, separador y finales de línea, se queda como estaba, que Moodle reconoce las columnas por su
nombre y compara la fecha de la última modificación."""
import codecs
import csv
import io
import re
import unicodedata
from collections import Counter, defaultdict

from base.procesos import Fallo, escribe
from ejercicios.corrige.aula import de_moodle
from ejercicios.corrige.informes import en_html, lineas
from ejercicios.corrige.lector import limpio
from ejercicios.reglas import Reglas

# Cómo se llaman, por lo que significan, en castellano, catalán, gallego, portugués, francés, italiano, alemán e inglés.
# En otro idioma se conocen por lo que tienen.
COLUMNAS = {
    "id": "id|identif.*",
    "nombre": "(full|comp|voll).*name|(nombre|nom|nome)(ape.*|com.*)?",
    "nota": "grade|(cal|[cq]ual)ificaci..?|nota|note|bewertung|voto|valutazione",
    "máxima": ".*(maxi|massi|best).*",
    "escala": "scale|escala|echelle|bareme|scala|skala",
    "comentario": ".*(com+ent|kommentar|feedback|retro|realim).*",
    "grupo": "grupo?|groupe?|grupp[eo]",
}
SEPARADORES = ",;\t"


def llano(nombre):
    """Como se comparan las columnas, que cada Moodle escribe a su manera: sin acentos, puntuación ni mayúsculas."""
    return "".join(c for c in unicodedata.normalize("NFKD", nombre).casefold() if c.isalnum())


def conocidas(columnas, filas):
    """{qué es: en qué columna está}, por el nombre o, de lo que haga falta, por lo que tiene; y de cuáles, por esto."""
    nombres = [*map(llano, columnas)]
    donde = {}
    for que, patron in COLUMNAS.items():
        donde |= {que: i for i, n in reversed([*enumerate(nombres)]) if re.fullmatch(patron, n)}

    def celdas(i):
        return {fila[i].strip() for fila in filas if i < len(fila)}

    sabidas, otras = {*donde}, [i for i in range(len(columnas)) if i not in donde.values() and filas]
    if "id" not in donde and (suyas := [i for i in otras if all(re.fullmatch(r"\D+\d+", c) for c in celdas(i))]):
        donde["id"] = suyas[0]
    if not {"máxima", "escala"} & {*donde} and (iguales := [i for i in otras if es_de_todos(celdas(i))]):
        donde["máxima"] = iguales[-1]
    if "nota" not in donde and (de := donde.get("máxima") or donde.get("escala")):
        donde["nota"] = de - 1
    ultima = len(columnas) - 1
    if "comentario" not in donde and ultima in otras and ultima > donde.get("máxima", ultima):
        donde |= {"comentario": ultima} if all(c[:1] in ("", "<") for c in celdas(ultima)) else {}
    return donde, [que for que in donde if que not in sabidas]


def es_de_todos(celdas):
    """Un número mayor que cero, en todas el mismo."""
    return len(celdas) == 1 and (numero(*celdas) or (0,))[0] > 0


def descifra(datos):
    """El texto y su codificación, que dice si lleva una marca delante."""
    en_16 = datos.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    como = "utf-16" if en_16 else "utf-8-sig" if datos.startswith(codecs.BOM_UTF8) else "utf-8"
    try:
        return datos.decode(como), como
    except UnicodeDecodeError:
        return datos.decode("cp1252"), "cp1252"


def numero(texto):
    """El de «100,00», «1.000,00» o «10», y con qué separa los decimales; None si no lo es."""
    junto = re.sub(r"\s", "", texto)
    con_coma = re.fullmatch(r"[\d.]*\d,\d+", junto)
    junto = junto.replace(".", "").replace(",", ".") if con_coma else junto
    hay = re.fullmatch(r"\d+(\.\d+)?", junto)
    return (float(junto), "," if con_coma else "." if hay[1] else "") if hay else None


def de_una_escala(celda):
    return [palabra.strip() for palabra in re.split("[\n,]", celda) if palabra.strip()]


class Hoja:
    """La que se ha leído, y lo que se va a escribir en ella."""

    def __init__(self, fichero, quienes=(), reglas=Reglas(), cambia=False):
        """QUIENES: cómo se llaman las carpetas. CAMBIA: también las notas que ya hay."""
        self.fichero, self.reglas, self.las_que_hay = fichero, reglas, cambia
        try:
            self.texto, self.como = descifra(fichero.read_bytes())
        except (OSError, UnicodeDecodeError):
            raise Fallo(f"no puedo leer «{fichero}»") from None
        # otra marca, o lo que es para Excel: Moodle no los quiere
        self.texto = re.sub("\\A\ufeff*(sep=.\r?\n\ufeff*)?", "", self.texto)
        cabecera = self.texto.partition("\n")[0]
        self.como_esta = {"delimiter": max(SEPARADORES, key=cabecera.count)}
        try:
            leidas = csv.reader(io.StringIO(self.texto, newline=""), **self.como_esta)
            self.columnas, *self.filas = [fila for fila in leidas if fila] or [[]]
        except csv.Error:
            raise Fallo(f"no puedo leer «{fichero}»") from None
        self.como_esta["lineterminator"] = "\r\n" if cabecera.endswith("\r") else "\n"
        self.como_esta["quoting"] = csv.QUOTE_ALL if cabecera.startswith('"') else csv.QUOTE_MINIMAL
        self.donde, self.por_lo_que_tienen = conocidas(self.columnas, self.filas)
        if "id" not in self.donde or "nota" not in self.donde:
            raise Fallo(
                f"«{fichero.name}» no es una hoja de calificaciones de Moodle que conozca: le falta la columna "
                f"«Identificador» o la «Calificación». Tiene {limpio(', '.join(self.columnas))}"
            )
        self.comprueba_escala()
        self.avisos, self.puestos, self.respetadas = [], Counter(), 0
        leidos = [numero(self.valor(fila, que)) for fila in self.filas for que in ("máxima", "nota")]
        con_decimales = [n for n in leidos if n and n[1] != ""]
        self.coma = con_decimales[0][1] if con_decimales else "." if "grade" in map(llano, self.columnas) else ","
        self.de_cada_uno, self.de_grupo = defaultdict(list), defaultdict(list)
        for fila in self.filas:
            self.de_cada_uno[self.participante(fila)].append(fila)
            if grupo := self.valor(fila, "grupo"):
                self.de_grupo[llano(grupo)].append(fila)
        # puede haber una columna de grupos y no ser de ellos la tarea
        self.de_grupos = any(llano(m["quien"]) in self.de_grupo for m in map(de_moodle, quienes) if m)

    @property
    def con_escala(self):
        return "escala" in self.donde and "máxima" not in self.donde

    def comprueba_escala(self):
        """Que se sepa desde cuántos puntos es cada palabra, y que todas sean de las suyas."""
        if not self.con_escala:
            return
        hay = {llano(p) for fila in self.filas for p in de_una_escala(self.valor(fila, "escala"))}
        if not self.reglas.tramos:
            raise Fallo(
                f"«{self.fichero.name}» es de una tarea que se califica con una escala de palabras, no con puntos. Di "
                "desde cuántos es cada una, en un fichero que se dé con --reglas: «escala = 0 No apto; 50 Apto»"
            )
        if faltan := [palabra for _, palabra in self.reglas.tramos if llano(palabra) not in hay]:
            son = ", ".join(de_una_escala(self.valor(self.filas[0], "escala"))) if self.filas else "ninguna"
            raise Fallo(f"«{faltan[0]}» no es de la escala de «{self.fichero.name}», que son {limpio(son)}")

    def valor(self, fila, que):
        return fila[self.donde[que]] if self.donde.get(que, len(fila)) < len(fila) else ""

    def carpetas(self, nombre):
        """Cómo se llamaría la carpeta de cada uno de sus filas."""
        quienes = [(re.sub("[_/]", " ", self.valor(f, "nombre")), self.participante(f)) for f in self.de(nombre)]
        return [f"{quien or 'Participante'}_{numero_}_assignsubmission_file_" for quien, numero_ in quienes if numero_]

    def participante(self, fila):
        """El número de «Participante 1234»."""
        m = re.search(r"(\d+)\s*$", self.valor(fila, "id"))
        return int(m[1]) if m else None

    def de(self, nombre):
        """Sus filas: la de su número o, si la tarea es de grupos, que lo llevan de otra cosa, las de su grupo."""
        m = de_moodle(nombre)
        if m and self.de_grupos:
            return self.de_grupo.get(llano(m["quien"]), [])
        return self.de_cada_uno.get(int(m["numero"]), []) if m and m["numero"] else []

    def pon(self, nombre, correccion):
        """Su nota, en los puntos de la tarea, y lo que se le dice. Lo que alguien ha puesto a mano se respeta."""
        suyas = self.de(nombre)
        if not suyas:
            self.avisos.append(f"«{correccion['entrega']}» no está en {self.fichero.name}")
        for fila in suyas:
            nota, antes = self.nota(fila, correccion["nota"]), self.valor(fila, "nota").strip()
            if antes.strip("-") and (numero(antes) or antes) != (numero(nota) or nota) and not self.las_que_hay:
                self.respetadas += 1
                continue
            self.cambia(fila, "nota", nota)
            if "comentario" in self.donde:
                self.cambia(fila, "comentario", comentario(correccion))

    def nota(self, fila, nota):
        """Como la escribe ella: una palabra de su escala, o puntos."""
        if self.con_escala:
            palabra = [llano(p) for desde, p in self.reglas.tramos if nota >= desde][-1]
            return next(p for p in de_una_escala(self.valor(fila, "escala")) if llano(p) == palabra)
        maxima = self.valor(fila, "máxima")
        return en_puntos(nota, numero(maxima) or (100, ","), self.coma)

    def cambia(self, fila, que, valor):
        if self.donde[que] < len(fila):
            fila[self.donde[que]] = valor
            self.puestos[que] += 1

    @property
    def cuenta(self):
        """Cuánto se ha puesto, y lo que no."""
        dice = [f"{self.puestos['nota']} notas y {self.puestos['comentario']} comentarios puestos"]
        por_eso = [f"{que} «{limpio(self.columnas[self.donde[que]])}»" for que in self.por_lo_que_tienen]
        dice += [f"por lo que tienen, son {', '.join(por_eso)}"] if por_eso else []
        if "comentario" not in self.donde:
            dice.append(f"sin columna de comentarios: {limpio(', '.join(self.columnas))}")
        if self.respetadas:
            dice.append(f"se quedan {self.respetadas} que ya había, y eran otras; --cambia-notas las cambia")
        dice += [f"no están en la hoja {len(self.avisos)}"] if self.avisos else []
        return "; ".join(dice)

    def escribe(self):
        """Al lado, y nunca encima. Devuelve dónde."""
        texto = io.StringIO(newline="")
        csv.writer(texto, **self.como_esta).writerows([self.columnas, *self.filas])
        escrito = texto.getvalue() if self.texto.endswith("\n") else texto.getvalue().rstrip("\r\n")
        destino = self.fichero.with_name(f"{self.fichero.stem}-con-notas{self.fichero.suffix}")
        # lo que no quepa en la codificación que trae está en un comentario, que es HTML
        escribe(destino, escrito.encode(self.como, "xmlcharrefreplace"))
        return destino


def en_puntos(nota, maxima, coma):
    """Con dos decimales, o tres si hacen falta para que lo que no está bien del todo no sea la máxima; si la máxima no
    los lleva, sin los que sobran."""
    puntos = re.sub(r"0$" if maxima[1] else r"\.?0+$", "", f"{nota * maxima[0] / 100:.3f}")
    return puntos.replace(".", coma)


def comentario(c):
    """Lo que se dice de una corrección, en el HTML que Moodle guarda."""
    frases = "".join(f"<li>{en_html(linea)}</li>" for linea in lineas(c))
    cuantos = f"{c['bien']} de {c['guiones']} pruebas salen como se espera. " if c["casos"] else ""
    return f"<p>{c['nota']:g} de 100. {cuantos}</p><ul>{frases}</ul><p>Reglas: {en_html(c['reglas'])}.</p>"
