"""La hoja de calificaciones que da Moodle (mod/assign/feedback/offline), con la nota y los comentarios puestos: lo
demás, columnas, filas, separador y finales de línea, se queda como estaba, que Moodle reconoce las columnas por su
nombre y compara la fecha de la última modificación."""
import codecs
import csv
import html
import io
import re
import unicodedata
from collections import Counter, defaultdict

from base.procesos import Fallo, escribe
from ejercicios.corrige.aula import de_moodle
from ejercicios.corrige.entrega import limpio
from ejercicios.corrige.informes import lineas

# Cómo se llaman en castellano, catalán, gallego e inglés.
COLUMNAS = {
    "id": "Identifier|Identificador",
    "nombre": "Full name|Nombre completo|Nom complet|Nome completo|Nombre / Apellido(s)",
    "nota": "Grade|Calificación|Qualificació|Cualificación",
    "máxima": "Maximum grade|Calificación máxima|Qualificació màxima|Cualificación máxima",
    "escala": "Scale|Escala",
    "comentario": "Feedback comments|Comentarios de retroalimentación|Comentarios de realimentación|"
    "Comentarios de retroacción|Comentaris de retroacció|Comentaris de retroalimentació|Comentarios|Comentaris",
    "grupo": "Group|Grupo|Grup",
}
SEPARADORES = ",;\t"
YA_HABIA = "notas que ya había, y eran otras"


def llano(nombre):
    """Como se comparan las columnas, que cada Moodle escribe a su manera: sin acentos, puntuación ni mayúsculas."""
    return "".join(c for c in unicodedata.normalize("NFKD", nombre).casefold() if c.isalnum())


def descifra(datos):
    """El texto y su codificación, que dice si lleva una marca delante."""
    en_16 = datos.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    como = "utf-16" if en_16 else "utf-8-sig" if datos.startswith(codecs.BOM_UTF8) else "utf-8"
    try:
        return datos.decode(como), como
    except UnicodeDecodeError:
        return datos.decode("cp1252"), "cp1252"


def numero(texto):
    """El de «100,00» o «1.000,00», y si lleva coma; None si no lo es."""
    limpio_ = re.sub(r"\s", "", texto)
    con_coma = bool(re.fullmatch(r"[\d.]*\d,\d+", limpio_))
    limpio_ = limpio_.replace(".", "").replace(",", ".") if con_coma else limpio_
    return (float(limpio_), con_coma) if re.fullmatch(r"\d+(\.\d+)?", limpio_) else None


def entero(texto):
    return unicodedata.normalize("NFC", texto).replace("_", " ").strip().casefold()


class Hoja:
    """La que se ha leído, y lo que se va a escribir en ella."""

    def __init__(self, fichero):
        self.fichero = fichero
        try:
            self.texto, self.como = descifra(fichero.read_bytes())
        except (OSError, UnicodeDecodeError):
            raise Fallo(f"no puedo leer «{fichero}»") from None
        self.texto = re.sub(r"\Asep=.\r?\n", "", self.texto)  # es para Excel, y Moodle no la quiere
        cabecera = self.texto.partition("\n")[0]
        self.como_esta = {"delimiter": max(SEPARADORES, key=cabecera.count)}
        try:
            leidas = csv.reader(io.StringIO(self.texto, newline=""), **self.como_esta)
            self.columnas, *self.filas = [fila for fila in leidas if fila] or [[]]
        except csv.Error:
            raise Fallo(f"no puedo leer «{fichero}»") from None
        self.como_esta["lineterminator"] = "\r\n" if cabecera.endswith("\r") else "\n"
        self.como_esta["quoting"] = csv.QUOTE_ALL if cabecera.startswith('"') else csv.QUOTE_MINIMAL
        nombres = [*map(llano, self.columnas)]
        conocidos = {que: [llano(n) for n in hay.split("|")] for que, hay in COLUMNAS.items()}
        self.donde = {q: nombres.index(n) for q, hay in conocidos.items() for n in hay[::-1] if n in nombres}
        if "id" not in self.donde or "nota" not in self.donde:
            raise Fallo(
                f"«{fichero.name}» no es una hoja de calificaciones de Moodle que conozca: le falta la columna "
                f"«Identificador» o la «Calificación». Tiene {limpio(', '.join(self.columnas))}"
            )
        if "escala" in self.donde and "máxima" not in self.donde:
            raise Fallo(f"«{fichero.name}» es de una tarea que se califica con una escala de palabras, no con puntos")
        self.avisos, self.puestos = [], Counter()
        self.de_cada_uno, self.de_grupo = defaultdict(list), defaultdict(list)
        vistos = [numero(self.valor(fila, que)) for fila in self.filas for que in ("máxima", "nota")]
        self.con_coma = any(n and n[1] for n in vistos)
        for fila in self.filas:
            self.de_cada_uno[self.participante(fila)].append(fila)
            if grupo := self.valor(fila, "grupo"):
                self.de_grupo[entero(grupo)].append(fila)

    def valor(self, fila, que):
        return fila[self.donde[que]] if self.donde.get(que, len(fila)) < len(fila) else ""

    @property
    def de_grupos(self):
        return "grupo" in self.donde

    def carpetas(self, nombre):
        """Cómo se llamaría la carpeta de cada uno de sus filas."""
        quienes = [(re.sub("[_/]", " ", self.valor(f, "nombre")), self.participante(f)) for f in self.de(nombre)]
        return [f"{quien or 'Participante'}_{numero_}_assignsubmission_file_" for quien, numero_ in quienes if numero_]

    def participante(self, fila):
        """El número de «Participante 1234»."""
        m = re.search(r"(\d+)\s*$", self.valor(fila, "id"))
        return int(m[1]) if m else None

    def de(self, nombre):
        """Sus filas: la de su número o, si la tarea es de grupos, que lo llevan de otra cosa, las de su grupo. Puede
        haber una columna de grupos y no ser de ellos la tarea: vale su número si la fila tiene su nombre."""
        m = de_moodle(nombre)
        suyas = self.de_cada_uno.get(int(m["numero"]), []) if m and m["numero"] else []
        if m and self.de_grupos:
            quien = entero(m["quien"])
            return self.de_grupo.get(quien) or [f for f in suyas if entero(self.valor(f, "nombre")) == quien]
        return suyas

    def pon(self, nombre, correccion):
        """Su nota, en los puntos de la tarea, y lo que se le dice."""
        suyas = self.de(nombre)
        if not suyas:
            self.avisos.append(f"«{correccion['entrega']}» no está en {self.fichero.name}")
        for fila in suyas:
            maxima = (numero(self.valor(fila, "máxima")) or (100, False))[0]
            nota = en_puntos(correccion["nota"], maxima, self.con_coma)
            antes = numero(self.valor(fila, "nota"))
            self.puestos[YA_HABIA] += bool(antes and antes != numero(nota))
            self.cambia(fila, "nota", nota)
            if "comentario" in self.donde:
                self.cambia(fila, "comentario", comentario(correccion))

    def cambia(self, fila, que, valor):
        if self.donde[que] < len(fila):
            fila[self.donde[que]] = valor
            self.puestos[que] += 1

    @property
    def cuenta(self):
        """Cuánto se ha puesto, y lo que no."""
        dice = [f"{self.puestos['nota']} notas y {self.puestos['comentario']} comentarios puestos"]
        if "comentario" not in self.donde:
            dice.append(f"no hay columna de comentarios que conozca: {limpio(', '.join(self.columnas))}")
        dice += [f"{self.puestos[YA_HABIA]} {YA_HABIA}"] if self.puestos[YA_HABIA] else []
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


def en_puntos(nota, maxima, con_coma):
    """Con dos decimales, o tres si hacen falta para que lo que no está bien del todo no sea la máxima."""
    puntos = re.sub(r"0$", "", f"{nota * maxima / 100:.3f}")
    return puntos.replace(".", ",") if con_coma else puntos


def comentario(c):
    """Lo que se dice de una corrección, en el HTML que Moodle guarda."""
    frases = "".join(f"<li>{html.escape(linea)}</li>" for linea in lineas(c))
    cuantos = f"{c['bien']} de {c['guiones']} guiones dan lo mismo que la solución. " if c["casos"] else ""
    return f"<p>{c['nota']:g} de 100. {cuantos}</p><ul>{frases}</ul><p>Reglas: {html.escape(c['reglas'])}.</p>"
