"""Las propiedades, juzgadas: un programa de mentira que las cumple todas y que, con cada defecto suyo, deja de cumplir
la que se dice. Cada queja que hay en los fuentes la tiene que haber dado alguno."""
import ast
import inspect
import re
import shlex
import sys
import zlib
from pathlib import Path
from types import SimpleNamespace

import pytest

RAIZ = Path(__file__).parents[2]
sys.path[:0] = [str(RAIZ / "herramientas"), str(RAIZ / "tests/propiedades")]
from base import controles
import dados
import programa
import propiedades

LINEA = "a d giran · 1 a 3 eligen el color · v compara · espacio anda o para · n elige un punto · ← → ↑ ↓ lo mueven"
LINEA += " · ratón orbita · botón derecho menú · Esc termina"
RASGOS = {"raton", "arrastre", "rueda", "temporizador"}
PASO = {"IZQUIERDA": (-1, 0), "DERECHA": (1, 0), "ARRIBA": (0, 1), "ABAJO": (0, -1)}
ESCENA = "giro", "color", "doble", "anda", "hora", "punto", "sitio", "orbita", "zoom", "opcion", "ayuda", "ajena"


class Partida:
    """Una ejecución del programa de mentira: lo que recuerda, y lo que escribe y deja."""

    def __init__(self, p, carpeta, opciones, talla, entorno):
        self.p, self.carpeta, self.opciones, self.entorno = p, carpeta, opciones, entorno
        self.d = p.defecto
        self.talla = tuple(map(int, talla.split("x")))
        self.giro = self.hora = self.punto = self.zoom = self.ajena = self.veces = 0
        self.color, self.opcion, self.anda, self.doble, self.ayuda = "1", "", True, False, False
        self.puntero, self.bajo = False, (0, 0)
        self.sitio, self.orbita, self.baja, self.clic = (0, 0), (0, 0), None, None
        self.salida, self.encima, self.dicho, self.f5, self.hechas = [], [], "", 0, 0
        self.diario, self.lento = "-diario" in opciones, "-lento" in opciones
        self.escena = self.se_ve()

    def se_ve(self):
        solo_titulo = self.d.endswith("en el título")
        suyo = [getattr(self, que) for que in ESCENA if not (solo_titulo and que == "ajena")]
        if self.d == "color según la forma":
            suyo.append(self.talla[0] > 2 * self.talla[1])
        return repr(suyo)

    def titulo(self):
        if self.d in ("título −0", "título sin estado") and (self.d[-1] == "0" or not self.hechas):
            return "Mentira" + (": −0.0" if self.d[-1] == "0" else "")
        if self.d == "número del título" and self.giro:
            return "Mentira: 77"
        pausa = "" if self.anda or self.d == "pausa sin decirlo" else ", en pausa"
        return f"Mentira: {self.hora} ms{pausa}" + (f", {self.ajena} de más" if self.d.endswith("en el título") else "")

    def pulsa(self, que, tecla):
        d = self.d
        if que == "especial":
            return self.especial(tecla)
        if tecla in ("a", "d") and d != f"«{tecla}», nada":
            tope = 100
            self.giro += 1 if tecla == "a" else -2 if d == "no se deshace" else -1
            if d == "al límite, sin vuelta" and abs(self.giro) >= tope:
                self.giro = 9999 if self.giro > 0 else -9999
            if d == "al límite, por otro lado" and self.giro == tope - 1 and tecla == "d":
                self.veces += 1
                self.giro -= 0.25 * self.veces
            if not abs(self.giro) > 9000:
                self.giro = max(min(self.giro, tope), -tope)
            self.veces += d == "de un límite a otro" and self.giro == -tope
            if d == "de un límite a otro" and self.veces:
                self.giro = min(self.giro, tope - 2)
        elif tecla in ("1", "2", "3") and not (d == "comparando, nada" and self.doble):
            self.color = tecla
            if d == "no conmutan" and self.giro:
                self.giro = -7
        elif tecla == "v":
            self.doble = not self.doble
        elif tecla == "Espacio":
            self.anda = not self.anda
            self.veces += 1
            if d == "parar cuenta" and self.veces > 9:
                self.hora += 1
        elif tecla == "n" and not (d == "n, una vez" and self.punto):
            self.punto = 1 if d == "n, una vez" else (self.punto + 1) % 3
            if d == "n, si anda" and not self.anda:
                self.punto = 0
            if d == "n, un modo que no se ve":
                self.veces += 1
                self.punto = (0, 1, 0, 2)[self.veces % 4]
        elif tecla == "Esc" and d != "Esc no termina":
            return True
        elif d.startswith("ajena") and tecla == "x" or d == "código raro" and tecla == "200":
            self.ajena += 1
            self.salida += ["equis"] if d == "ajena que escribe" else []
        return False

    def especial(self, tecla):
        d = self.d
        if tecla == "F1" and not (d == "F1 no quita" and self.ayuda) and d != "F1 nada":
            self.ayuda = not self.ayuda
        elif tecla == "F2":
            self.puntero = True
        elif tecla == "F12" and d != "F12 callado":
            self.salida.append("guardado mentira-1.ppm")
        elif tecla == "F5":
            self.f5 += 1
            self.ajena += d == "F5 cambia"
            self.salida += ["leído"] if d == "F5 escribe" else []
        elif tecla in PASO and d != "flechas, nada":
            self.sitio = tuple(a + b for a, b in zip(self.sitio, PASO[tecla]))

    def raton(self, que, boton, *donde):
        x, y = map(int, donde)
        if que == "arrastra" and self.baja:
            veces = 2 if self.d == "arrastrar por pasos" and self.orbita == (0, 0) else 1
            self.orbita = tuple(o + veces * (b - a) for o, a, b in zip(self.orbita, self.baja, (x, y)))
            self.baja = x, y
        elif boton == "IZQUIERDO":
            lejos = {"clic lejos en x": (3, 0), "clic lejos en y": (0, 3)}.get(self.d, (0, 0))
            self.clic = x + 0.5 + lejos[0], self.talla[1] - y - 0.5 + lejos[1]
            self.baja = (x, y) if que == "abajo" else None
        self.ajena += self.d == "botón 7" and boton == "7"

    def haz(self, orden):
        """Si con ella termina."""
        una, _, veces = orden.partition(" ×")
        que, *resto = una.split()
        self.hechas += 1
        for _ in range(int(veces or 1)):
            if que in ("tecla", "especial") and self.pulsa(que, resto[0]):
                return True
            if que == "boton":
                self.raton(resto[1], resto[0], *resto[2:])
            elif que == "arrastra":
                self.raton(que, "", *resto)
            elif que == "mueve":
                self.bajo = tuple(map(int, resto))
            elif que == "rueda":
                self.zoom += int(resto[0])
            elif que == "menu":
                self.opcion = resto[0]
            elif que == "tamano":
                self.talla = tuple(map(int, resto))
                self.giro += self.d == "la talla cuenta"
            elif que == "espera":
                self.pasa(int(resto[0]))
            elif que == "captura":
                self.guarda(una.partition(" ")[2])
        return False

    def pasa(self, ms):
        d = self.d
        if self.anda or d == "la pausa cuenta" or d == "en pausa, algo":
            self.hora += ms if self.anda or d == "la pausa cuenta" else 0
            self.ajena += d == "en pausa, algo" and not self.anda
        if self.lento and d == "lento, otra hora":
            self.hora -= 1
        if self.lento and d == "lento, se para":
            self.hora = 0

    def fila(self, orden):
        d, bytes_, objetos, temporizadores, cambiado = self.d, 1000, "1 0 1 2 0 0 1", 1, ""
        if d == "demasiados bytes" and self.giro:
            bytes_ = propiedades.BYTES + 1
        if d == "bytes cada vez":
            bytes_ += self.f5
        if d == "objetos por ronda":
            objetos = f"{self.hechas} 0"
        if d == "objetos por F5":
            objetos = f"1 {self.f5}"
        if d == "dos temporizadores" and self.giro:
            temporizadores = 2
        if d == "sin temporizador" and self.hora:
            temporizadores = 0
        if d == "deja el estado" and self.giro:
            cambiado = "BLEND 0→1 "
        repetida = "otra" if d == "otro cuadro" and self.giro else ""
        imagen = zlib.crc32(repr((self.se_ve(), self.talla)).encode())
        if d == "título −0 en el rótulo":
            imagen = 0
        campos = (orden, imagen, repetida, self.titulo(), cambiado, objetos, bytes_, temporizadores)
        self.salida.append("diario\t" + "\t".join(map(str, campos)))

    def colores(self):
        """Un recuadro, en el centro de lo que cabe a 4:3, del color de lo que se ve; o la foto."""
        ancho, alto = self.talla
        lado = max(min(ancho // 4, alto // 3), 1)
        w, h = 2 * lado, lado
        if self.p.admite == "imagen":
            w, h = int(41 * alto / 30 + 0.5) + (self.d == "foto ancha"), alto
        x, y = (ancho - w) // 2 + (self.d == "foto corrida"), (alto - h) // 2
        lejos = abs(self.giro) >= 60
        if lejos and self.d == "al extremo, cortado":
            x, w = 0, ancho
        if self.d == "modelo corrido" and self.p.admite == "modelo":
            x += len(Path(self.carpeta, "cubo.vf").read_text()) % 7
        tinta = zlib.crc32(self.escena.encode()).to_bytes(4, "big")[:3]
        if lejos and self.d == "al extremo, nada":
            tinta = b"\0\0\0"
        tintas = tinta * w
        if self.d == "al extremo, liso" and not lejos:  # de dos colores
            tintas = tinta * (w // 2) + b"\xff\0\0" * (w - w // 2)
        dentro = (b"\0\0\0" * x + tintas + b"\0\0\0" * ancho)[: 3 * ancho]
        filas = [dentro if y <= fila < y + h else b"\0\0\0" * ancho for fila in range(alto)]
        if self.d == "plano de cerca" and "-sin_planos" not in self.opciones:
            filas[0] = b"\xff" * 3 * ancho
        return b"".join(filas)

    def guarda(self, fichero):
        if not (self.d == "no pide dibujar" and not self.diario and not self.f5):
            self.escena = self.se_ve()
        Path(self.carpeta, fichero).write_bytes(b"P6\n%d %d\n255\n" % self.talla + self.colores())
        ancho, alto = self.talla
        self.encima.append(f"imagen\t{fichero}\t{ancho}\t{alto}")
        x, y = ancho / 2, alto / 2
        lado = {"izquierda": (-ancho, 0), "derecha": (ancho, 0), "abajo": (0, -alto), "arriba": (0, alto)}
        dx, dy = lado.get(self.d.removeprefix("rótulo a la ").removeprefix("rótulo "), (0, 0))
        panel, texto = f"0 0 {ancho} {alto}", "−0.0 m" if self.d == "rótulo −0" else "m"
        if self.puntero:
            color = self.colores()[3 * (self.bajo[1] * ancho + self.bajo[0]) :][:3]
            color = [c + (self.d == f"F2, otro {nombre}") for c, nombre in zip(color, ("rojo", "verde", "azul"))]
            donde = (self.bajo[1], self.bajo[0]) if self.d == "F2, al revés" else self.bajo
            texto = r"{}, {}\n({}, {}, {})".format(*donde, *color)
        if self.d == "rótulo que tapa" and 3 * ancho == 4 * alto:  # en el catálogo, en la esquina
            dx, dy = 20 - x, 20 - y
        puntos = f"{x - 9 + dx} {y - 4 + dy} 0 {x + 9 + dx} {y + 4 + dy} 0 {x} {y} 0"
        self.encima += [f"rotulo\t1 1 1\t{panel}\t8\t0\t{puntos}\t{texto}"] * (2 if self.d == "rótulo doble" else 1)
        if self.clic:
            self.encima.append(f"puntos\t1 1 1\t{panel}\t8\t0\t{self.clic[0]} {self.clic[1]} 0\t")
        if self.ayuda:
            self.pon_ayuda(panel)

    def pon_ayuda(self, panel):
        partes = [c.partes for c in self.p.controles][self.d == "F1, sin uno" :] + [("F1", "la quita")]
        for columna in zip(*partes):
            letra = 7 if self.talla != (960, 720) or self.d == "F1, menuda" and "F1" not in columna else 23
            self.encima.append(f"rotulo\t1 1 1\t{panel}\t{letra}\t0\t9 9 0 9 9 0 9 9 0\t" + r"\n".join(columna))

    def juega(self):
        if "-ayuda" in self.opciones:
            return "\n".join([*self.p.dice.split(" · ")[self.d == "-ayuda, sin uno" :], *"123456"])
        guion = self.opciones[self.opciones.index("-guion") + 1] if "-guion" in self.opciones else ""
        dibuja = self.fila if self.diario else lambda _: None
        dibuja("")
        for orden in guion.split("; ") if guion else ():
            if self.d == "se cae" and orden == "tecla d":
                raise programa.Termina("estado 139")
            if self.haz(orden):
                break
            if self.d == "número del título" and orden == "tecla a":
                self.salida.append("giro 1")
            dibuja(orden)
            if "-titulos" in self.opciones and self.titulo() != self.dicho:
                self.dicho = self.titulo()
                self.salida.append("título: " + self.dicho)
        self.guarda("imagen.ppm" if "-ppm" not in self.opciones else self.opciones[self.opciones.index("-ppm") + 1])
        if "LAB_ENCIMA" in self.entorno:
            Path(self.carpeta, self.entorno["LAB_ENCIMA"]).write_text("\n".join(self.encima) + "\n")
        return "\n".join([*self.salida, ""])


def lo_que_no_lee(admite, defecto):
    """Por cada cosa que no puede leer, un renglón de shell que la rechaza; con defecto, mal."""
    linea_de_mas = "; echo otra >&2" if defecto == "se queja dos veces" else ""
    dibuja = "; : >imagen.ppm" if defecto == "dibuja lo que no lee" else ""
    for palabras, estado, dice in dados.pedidos(admite):
        estado = 5 if defecto == "acaba de otra manera" else estado
        queja = shlex.quote("mentira: " + ("mal" if defecto == "se queja de otra cosa" else dice))
        da = shlex.quote(" ".join(palabras) + " -geometry")
        yield f'case "$*" in {da}*) echo {queja} >&2{linea_de_mas}{dibuja}; exit {estado};; esac\n'


class Mentira(programa.Programa):
    def __init__(self, carpeta, defecto="", linea=LINEA, admite="", rasgos=RASGOS):
        self.defecto = defecto
        sobra = "" if defecto == "no sobra nada" else 'for u; do :; done; [ "$1" = -ppm ] || echo "sobra «$1»" >&2'
        de_mentira = carpeta / "mentira"
        de_mentira.write_text(f"#!/bin/sh\n{''.join(lo_que_no_lee(admite, defecto))}{sobra}\nexit 2\n")
        de_mentira.chmod(0o755)
        con = SimpleNamespace(raiz=RAIZ, build=carpeta, ordenes=50, semilla=1, todo=bool(defecto))
        opciones = ["Vista/Perfil", "Vista/Planta"] if defecto != "sin menú" and ("menú" in linea or defecto) else []
        leidos = [] if defecto == "sin línea" else [controles.analiza(c) for c in linea.split(" · ")]
        with pytest.MonkeyPatch.context() as cambia:
            cambia.setattr(controles, "lee", lambda *_: leidos)
            cambia.setattr(controles, "atiende", lambda *_: (set(rasgos), opciones))
            suyo = SimpleNamespace(
                nombre="mentira", ejecutable=lambda _: de_mentira, admite=admite, casos=[SimpleNamespace(guion="")]
            )
            super().__init__(suyo, con)

    def ejecuta_en(self, carpeta, opciones, talla=programa.TALLA, **entorno):
        return Partida(self, carpeta, opciones, talla, entorno).juega()


CLIC = LINEA.replace("ratón orbita", "clic elige el punto, rueda acerca")
SIN_RUEDA, SIN_MENU = CLIC.replace(", rueda acerca", ""), LINEA.replace(" · botón derecho menú", "")
SIN_RATON = LINEA.replace(" · ratón orbita", "")
# propiedad, en qué, los defectos con que no se cumple y, si no es el de siempre, cómo es el programa
DEFECTOS = [
    ("paseo", "termina", "se cae"),
    ("paseo", "repetir", "otro cuadro"),
    ("paseo", "estado", "deja el estado"),
    ("paseo", "F5", "F5 cambia; F5 escribe"),
    ("paseo", "objetos", "objetos por F5"),
    ("paseo", "ajena", "ajena; ajena que escribe; ajena en el título"),
    ("paseo", "bytes", "demasiados bytes"),
    ("paseo", "temporizadores", "dos temporizadores"),
    ("nombres", "línea", "sin línea"),
    ("nombres", "ajena", "ajena; ajena en el título"),
    ("nombres", "ratón", "", {"rasgos": RASGOS - {"raton", "arrastre"}}),
    ("nombres", "rueda", "", {"rasgos": RASGOS - {"rueda"}}),
    ("nombres", "menú", "sin menú"),
    ("nombres", "ratón", "", {"linea": SIN_RATON}),
    ("nombres", "rueda", "", {"linea": SIN_RUEDA}),
    ("nombres", "menú", "menú sin nombrar", {"linea": SIN_MENU}),
    ("limites", "tecla a", "no se deshace; al límite, sin vuelta; al límite, por otro lado; de un límite a otro"),
    ("limites", "tecla d", "al límite, sin vuelta"),
    ("comparacion", "tecla 1", "comparando, nada"),
    ("vuelta", "tecla n", "n, una vez; n, un modo que no se ve"),
    ("comunes", "tiempo", "", {"rasgos": RASGOS - {"temporizador"}}),
    ("comunes", "F1", "F1 nada; F1 no quita; F1, sin uno; F1, menuda"),
    ("comunes", "F2", "F2, otro rojo; F2, otro verde; F2, otro azul; F2, al revés"),
    ("comunes", "-ayuda", "-ayuda, sin uno"),
    ("comunes", "F12", "F12 callado"),
    ("comunes", "Esc", "Esc no termina"),
    ("comunes", "argumentos", "no sobra nada"),
    ("vivos", "vivos", "n, una vez; flechas, nada"),
    ("mandos", "especial ARRIBA", "flechas, nada"),
    ("mandos", "tecla a", "«a», nada"),
    ("raras", "raras", "código raro; botón 7"),
    ("tallas", "talla", "la talla cuenta"),
    ("tallas", "tecla [ad], tecla [123]", "no conmutan"),
    ("arrastres", "pasos", "arrastrar por pasos"),
    ("franja", "", "color según la forma"),
    ("rotulos", "rótulo", "rótulo a la izquierda; rótulo a la derecha; rótulo abajo; rótulo arriba"),
    ("tapan", "tapa m", "rótulo que tapa"),
    ("tapan", "toca", "rótulo doble"),
    ("tapan", "cabe", "rótulo a la izquierda"),
    ("extremos", "nada", "al extremo, nada"),
    ("extremos", "liso", "al extremo, liso"),
    ("extremos", "corta", "al extremo, cortado"),
    ("cerca", "plano", "plano de cerca"),
    ("tocado", "120x90 .*", "clic lejos en x; clic lejos en y", {"linea": CLIC}),
    ("modelo", "modelo", "modelo corrido", {"admite": "modelo"}),
    ("dados", "dados", "se queja dos veces; dibuja lo que no lee", {"admite": "imagenes"}),
    ("dados", "dados", "acaba de otra manera; se queja de otra cosa", {"admite": "modelo"}),
    ("foto", "foto", "foto ancha; foto corrida", {"admite": "imagen"}),
    ("pausa", "temporizador", "sin temporizador; no pide dibujar"),
    ("pausa", "título", "pausa sin decirlo"),
    ("pausa", "pausa", "la pausa cuenta; en pausa, algo; parar cuenta"),
    ("lento", "hora", "lento, otra hora; lento, se para"),
    ("lento", "sigue", "lento, se para"),
    ("conmuta", "tecla n", "n, si anda"),
    ("rondas", "objetos", "objetos por ronda"),
    ("rondas", "bytes", "bytes cada vez"),
    ("dicho", "título", "título −0"),
    ("dicho", "rótulo", "rótulo −0"),
    ("dicho", "números", "número del título"),
    ("dicho", "primero", "título sin estado"),
]
ANTES = {"mandos": ["paseo"], "dicho": ["franja", "paseo", "limites"]}  # lo que ya se ha hecho con él
dadas = set()  # dónde está cada queja que se ha dado


def apunta(marco, suceso, que):
    """De cada generador de las propiedades, en qué línea da algo."""
    if suceso == "return" and que is not None and marco.f_code.co_filename.startswith(propiedades.__file__[:-14]):
        dadas.add((Path(marco.f_code.co_filename).name, marco.f_lineno))


def quejas(p, nombre):
    """En qué no cumple esa propiedad."""
    for antes in ANTES.get(nombre, ()):
        list(getattr(propiedades, antes)(p))
    sys.setprofile(apunta)
    try:
        return {en_que for en_que, que in getattr(propiedades, nombre)(p) if (que() if callable(que) else que)}
    finally:
        sys.setprofile(None)


@pytest.mark.parametrize("como", [{}, {"linea": CLIC}, {"admite": "modelo"}, {"admite": "imagen"}])
def test_lo_bueno_se_da_por_bueno(tmp_path, como):
    for propiedad in propiedades.PROPIEDADES:
        assert not quejas(Mentira(tmp_path, **como), propiedad.__name__), propiedad


def test_lo_que_acaba_mal_no_vale(tmp_path):
    p = Mentira(tmp_path)
    for hace, mal in (("", False), ("exit 3", True), ("kill -9 $$", True), ("echo aviso >&2", True)):
        p.ejecutable.write_text(f"#!/bin/sh\n{hace}\n")
        try:
            programa.Programa.ejecuta_en(p, tmp_path, ["-rasgos"])
            assert not mal, hace
        except programa.Termina:
            assert mal, hace


def hay_quejas():
    """Dónde está cada una en los fuentes de las propiedades: fichero y líneas."""
    for modulo in {inspect.getmodule(p) for p in propiedades.PROPIEDADES} | {propiedades}:
        for nodo in ast.walk(ast.parse(inspect.getsource(modulo))):
            if isinstance(nodo, ast.Yield):
                yield Path(modulo.__file__).name, nodo.lineno, nodo.end_lineno


def test_cada_defecto_se_ve(tmp_path):
    """Y ninguna queja se queda sin dar."""
    mal = []
    for nombre, en_que, defectos, *como in DEFECTOS:
        for defecto in defectos.split("; "):
            hay = quejas(Mentira(tmp_path, defecto, **dict(*como)), nombre)
            mal += [] if any(re.fullmatch(en_que, h) for h in hay) else [f"{nombre}, {en_que}: «{defecto}» da {hay}"]
    mudas = [(f, desde) for f, desde, hasta in hay_quejas() if not dadas & {(f, n) for n in range(desde, hasta + 1)}]
    assert (mal, mudas) == ([], [])
