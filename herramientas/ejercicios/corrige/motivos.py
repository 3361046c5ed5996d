"""Por qué falla una entrega: qué defecto conocido, o qué dos, plantados en la solución, dejan en todos los guiones lo
mismo; qué no responde; cómo acaba."""
import itertools
import math
import re
import shutil
import tempfile
import threading
from pathlib import Path

from base import defectos, marcas
from base.guiones import sin_veces
from base.procesos import Fallo, escribe
from ejercicios import nuevo, propios
from ejercicios.corrige.compilador import SUYA
from ejercicios.corrige.entrega import COMENTARIO, Rechazo
from ejercicios.corrige.partidas import Jugador

ERRORES = "herramientas/ejercicios/errores"
PAREJAS = 16  # de defectos, que se juegan: los que entre los dos más tocan lo mismo que la entrega, y no menos que esto
TOCAN, GEMELOS = 0.6, 0.5
SENALES = {
    132: "instrucción ilegal",
    134: "abort",
    135: "memoria mal alineada",
    136: "división por cero",
    139: "acceso a memoria que no es suya, o una función que se llama a sí misma sin fin",
}

SE_EXIGE = {  # lo que comprueba _GLIBCXX_ASSERTIONS
    "< this->size()": "un índice se sale de un vector o de un array",
    "!this->empty()": "se pide un elemento de un vector que está vacío",
    "get() != ": "se usa un puntero que no apunta a nada",
}
CONSTANTES = [math.pi * k for k in (1 / 180, 1 / 6, 1 / 4, 1 / 3, 1 / 2, 2 / 3, 1, 2)] + [180 / math.pi]
CONSTANTES += [1 / 3, 2 / 3, 1 / 6, 1 / 9, *(math.sqrt(n) / k for n in (2, 3) for k in (1, 2, 3))]
DECIMAL = re.compile(r"(?<![\w.])\d*\.(\d{2,})")
MUCHO = 16 << 20  # bytes que escribe quien no ha dejado un printf en un bucle


def conocidos(raiz, programa, ref):
    """Los defectos que se conocen de los ficheros que tiene quien hace el ejercicio, salvo en lo que pide otro. Los de
    uno propio están en su carpeta, y no los ha mirado nadie."""
    donde = programa.carpeta / propios.ERRORES if programa.raices else raiz / ERRORES
    textos = {ruta(programa, f): texto for f, texto in nuevo.textos(raiz, programa, ref).items()}
    ajenos = {
        f: [t.span() for t in marcas.TROZO.finditer(texto) if t["codigo"] != ref and nuevo.es_del_libro(t["codigo"])]
        for f, texto in textos.items()
    }

    def es_de_otro(m):
        sitio = m.sitio(textos[m.fichero])[0]
        return any(desde <= sitio < hasta for desde, hasta in ajenos[m.fichero])

    suyos, fallos = defectos.lee_lista(donde) if programa.raices else (defectos.lee(donde)[0], [])
    if programa.raices:
        fallos += [f"{m.nombre}: no hay ningún «{m.fichero}»" for m in suyos if m.fichero not in textos]
    try:
        if fallos:
            raise ValueError(fallos[0])
        suyos = [m for m in suyos if m.fichero in textos and not es_de_otro(m)]
        for fichero, de_el in defectos.por_fichero(suyos).items():
            if not de_el[0].en_shader:
                defectos.cambia(textos[fichero], de_el)
        return suyos
    except ValueError as error:
        raise Fallo(f"{donde}: {error}") from None


def ruta(programa, fichero):
    """Cómo lo llama la lista de sus errores."""
    return fichero if programa.raices or "/" in fichero else f"{programa.carpeta}/{fichero}"


class Motivos:
    """El esqueleto y la solución con cada defecto, que juegan como una entrega. Se compilan cuando hacen falta."""

    def __init__(self, raiz, programa, ref, compilador, arbitro):
        self.raiz, self.programa, self.ref, self.compilador, self.arbitro = raiz, programa, ref, compilador, arbitro
        self.defectos = conocidos(raiz, programa, ref)
        self.turno, self.hechas = threading.Lock(), None

    def textos(self):
        return nuevo.textos(self.raiz, self.programa, self.ref)

    def limpio(self, textos):
        """Los ficheros de quien hace el ejercicio, sin las marcas, con esos textos."""
        return nuevo.sin_marcas(textos, self.programa, self.ref)

    def trozos(self):
        """Lo que pide el ejercicio, sitio a sitio: en qué fichero, y su marca."""
        textos = self.textos()
        return [(f, t) for f in textos for t in marcas.TROZO.finditer(textos[f]) if t["codigo"] == self.ref]

    def huecos(self):
        """Si se piden varias cosas, de cada una: qué es, y los ficheros con todo menos ella."""
        trozos, textos = self.trozos(), self.textos()
        for f, t in trozos if trozos[1:] else ():
            yield t["pide"], textos | {f: textos[f][: t.start()] + marcas.esqueleto(t[0]) + textos[f][t.end() :]}

    def variantes(self):
        """(qué se le diría a quien la entregara, Jugador): el esqueleto y la solución con cada defecto, todos en un
        binario."""
        with self.turno:
            if self.hechas is None:
                try:
                    self.hechas = self.enumera(self.compiladas())
                except (ValueError, Rechazo) as error:
                    raise Fallo(f"los defectos plantados de {self.ref} no valen: {error}") from None
        return self.hechas

    def compiladas(self):
        """Dónde están."""
        sitio = self.arbitro.cache / "variantes"
        if not sitio.is_dir():
            parcial = Path(tempfile.mkdtemp(dir=self.arbitro.cache))
            self.compila(parcial)
            try:
                parcial.replace(sitio)
            except OSError:  # otro lo ha hecho mientras
                shutil.rmtree(parcial)
        return sitio

    def compila(self, sitio):
        esqueleto = nuevo.esqueleto(self.raiz, self.programa, self.ref)
        self.compilador.compila(esqueleto, sitio / "esqueleto", ajena=False)
        for i, (_, con_hueco) in enumerate(self.huecos()):
            try:
                self.compilador.compila(self.limpio(con_hueco), sitio / f"hueco{i}", ajena=False)
            except Rechazo:  # lo demás lo necesita
                shutil.rmtree(sitio / f"hueco{i}")
        self.planta(self.defectos, sitio)

    def planta(self, suyos, sitio, marca="", antes=""):
        """Deja ahí la solución con esos defectos: los de C++, en un binario, con esa MARCA; de cada shader, el
        estropeado."""
        for m in suyos:
            if m.en_shader:
                self.planta_en_shaders(sitio, m)
        incluye = f'{antes}#include "{self.raiz / defectos.MUTANTE_H}"\n'
        self.compilador.compila(self.con_los_de_cpp(suyos, incluye, marca), sitio / "mutantes", ajena=False)

    def con_los_de_cpp(self, suyos, incluye, marca=""):
        """Los ficheros de la solución con esos defectos, los de C++, puestos todos, e INCLUYE delante."""
        textos = self.textos()
        for fichero, de_el in defectos.por_fichero(suyos).items():
            if not de_el[0].en_shader:
                nombre = Path(fichero).name
                textos[nombre] = incluye + defectos.cambia(textos[nombre], de_el, marca)
        return self.limpio(textos)

    def estropeados(self, *defectos_):
        """Los ficheros de la solución con esos defectos de sus shaders."""
        textos = self.textos()
        for m in defectos_:
            nombre = m.fichero if m.fichero in textos else Path(m.fichero).name
            textos[nombre] = defectos.estropea(textos[nombre], m)
        return textos

    def planta_en_shaders(self, sitio, *suyos):
        """Deja en la carpeta de esos defectos sus shaders, estropeados."""
        limpios = self.limpio(self.estropeados(*suyos))
        for nombre in {Path(m.fichero).name for m in suyos}:
            escribe(sitio / nombre_de(suyos) / nombre, limpios[nombre])

    def enumera(self, sitio):
        variantes = [("", self.jugador("esqueleto", sitio, "esqueleto"))]
        for i, (pide, _) in enumerate(self.huecos()):
            if (sitio / f"hueco{i}").is_dir():
                variantes.append((f"parece que falta: {pide}", self.jugador(f"hueco{i}", sitio, f"hueco{i}")))
        return variantes + [(que_dice(m), self.con_defecto(m, sitio)) for m in self.defectos]

    def sin_hacer(self, i):
        """Quien juega la solución sin ese trozo, o None si así no compila."""
        self.variantes()
        sitio = self.compiladas()
        return self.jugador(f"hueco{i}", sitio, f"hueco{i}") if (sitio / f"hueco{i}").is_dir() else None

    def jugador(self, nombre, sitio, carpeta, *antes, **entorno):
        raices = [*antes, sitio / carpeta / "fuentes" / SUYA, sitio / carpeta / "fuentes"]
        return Jugador(nombre, self.en(sitio, carpeta) / self.programa.nombre, raices, entorno)

    def en(self, sitio, carpeta):
        """Dónde está compilada cada una."""
        return sitio / carpeta

    def con_defecto(self, m, sitio, *mas):
        """Con ese y los demás. Si son de shaders, en su carpeta están los estropeados; si no, no hay nada."""
        suyos = m, *mas
        cuales = ",".join(str(m.numero) for m in suyos)
        return self.jugador(nombres(suyos), sitio, "mutantes", sitio / nombre_de(suyos), LAB_MUTANTE=cuales)

    def pares(self, defectos_):
        """De esos, los que se pueden plantar de dos en dos y tiene sentido: del mismo hueco o que imitan lo mismo."""
        textos = {ruta(self.programa, f): t for f, t in self.textos().items()}
        huecos = [(ruta(self.programa, f), t.span()) for f, t in self.trozos()]

        def hueco(m):
            return next((h for h in huecos if h[0] == m.fichero and h[1][0] <= sitios[m][0] < h[1][1]), m)

        def se_pueden(una, otra):
            (a, b), (c, d) = sitios[una], sitios[otra]
            aparte = una.fichero != otra.fichero or b <= c or d <= a
            return aparte and (hueco(una) == hueco(otra) or una.imita == otra.imita)

        sitios = {m: m.sitio(textos[m.fichero]) for m in defectos_}
        return [par for par in itertools.combinations(defectos_, 2) if se_pueden(*par)]

    def parejas(self, sitio, tocado, tocan):
        """(qué se diría, Jugador) de los pares que pueden ser los de una entrega que ha TOCADO esos píxeles: entre los
        dos tocan casi los mismos. TOCAN: los de cada uno."""

        def casi_lo_mismo(una, otra):
            """Dos que mueven una línea fina tocan, juntos, otros píxeles: a los gemelos se les pide menos."""
            entre = tocan[una] | tocan[otra]
            gemelos = GEMELOS if una.imita == otra.imita else 0
            return gemelos + (entre & tocado).bit_count() / max((entre | tocado).bit_count(), 1)

        pares = self.pares([m for m in self.defectos if m.dice and m in tocan])
        mejores = sorted(((casi_lo_mismo(*par), i) for i, par in enumerate(pares)), key=lambda p: (-p[0], p[1]))
        for cuanto, i in mejores[:PAREJAS]:
            if cuanto >= TOCAN and (jugador := self.de_dos(sitio, *pares[i])):
                yield f"{que_dice(pares[i][0])}; y que {pares[i][1].dice}", jugador

    def de_dos(self, sitio, *suyos):
        """Quien juega con esos dos, o None: en un shader uno puede ser parte de lo que cambia el otro, y donde corrige
        VPL no se puede escribir."""
        try:
            with self.turno:
                if any(m.en_shader for m in suyos) and not (sitio / nombre_de(suyos)).is_dir():
                    self.planta_en_shaders(sitio, *(m for m in suyos if m.en_shader))
            return self.con_defecto(suyos[0], sitio, suyos[1])
        except (ValueError, OSError, Fallo, Rechazo):
            return None

    def por_que(self, partidas, esperadas, fallan):
        """Lo que deja en todos los guiones lo mismo que la entrega, en palabras; si es el esqueleto, lo primero,
        ninguna."""
        arbitro = self.arbitro

        def las_que_dan_lo_mismo(vivas):
            for guion in sorted(partidas, key=lambda g: g not in fallan):
                vivas = [
                    v for v in vivas if arbitro.misma(arbitro.juega(v[1], guion, esperadas[guion]), partidas[guion])
                ]
                if not vivas:
                    break
            return vivas

        esqueleto, *otras = self.variantes()
        vivas = las_que_dan_lo_mismo([esqueleto]) + las_que_dan_lo_mismo(otras)
        if not vivas and fallan:
            guion = min(partidas, key=lambda g: g not in fallan)
            debe = esperadas[guion]
            de_cada = dict(zip(self.defectos, otras[len(otras) - len(self.defectos) :]))
            tocan = {m: que_toca(arbitro.juega(v[1], guion, debe), debe) for m, v in de_cada.items() if m.dice}
            vivas = las_que_dan_lo_mismo(self.parejas(self.compiladas(), que_toca(partidas[guion], debe), tocan))
        exactas = [
            v
            for v in vivas
            if all(arbitro.juega(v[1], g, esperadas[g]).imagenes == p.imagenes for g, p in partidas.items())
        ]
        return list(dict.fromkeys(dice for dice, _ in exactas or vivas))  # vacío, si no hay ninguna


def que_dice(m):
    """Qué se le dice a quien lo ha cometido."""
    return f"parece que {m.dice}" if m.dice else f"parece este error: {m.imita}"


def nombres(suyos):
    return " y ".join(m.nombre for m in suyos)


def nombre_de(suyos):
    """El de la carpeta de esos defectos, si lo son de shaders."""
    return "-".join(str(m.numero) for m in suyos)


NO_CERO = bytes([0, *[1] * 255])


def que_toca(partida, esperada):
    """Los puntos, uno de cada cinco, en que sus imágenes no son las que se esperan, en los bits de un número."""

    def entero(una, otra):
        distinto = int.from_bytes(una, "little") ^ int.from_bytes(otra, "little")
        return distinto.to_bytes(len(otra), "little")[::5].translate(NO_CERO)

    pares = itertools.zip_longest(partida.imagenes, esperada.imagenes, fillvalue=(0, 0, b""))
    dichos = [entero(a[2], b[2]) if len(a[2]) == len(b[2]) else bytes([1]) * (len(b[2]) // 5) for a, b in pares]
    return int.from_bytes(b"".join(dichos), "little")


def que_cambian(partidas):
    """De cada orden de esos guiones, si alguna vez cambia la imagen."""
    vistas = {}
    for guion, p in partidas.items():
        for orden, antes, despues in zip(guion.ordenes, p.imagenes, p.imagenes[1:]):
            vistas[sin_veces(orden)] = vistas.get(sin_veces(orden), False) or antes != despues
    return vistas


def no_responden(partidas, esperadas):
    """Las órdenes que en la solución cambian la imagen y en lo entregado, nunca; y si alguna la cambia."""
    hace = que_cambian(partidas)
    deben = [orden for orden, cambia in que_cambian(esperadas).items() if cambia]
    return [o for o in deben if not hace.get(o)], any(hace.get(o) for o in deben)


def pocas_cifras(ficheros, de_partida):
    """Lo que se dice del primer número escrito que es una constante con pocas cifras, 3.14 o 0.33, y no se daba."""
    dados = {n for texto in de_partida.values() for n in DECIMAL.findall(texto)}
    for f, crudo in ficheros.items():
        texto = COMENTARIO.sub(lambda m: b"\n" * m[0].count(b"\n"), crudo).decode(errors="replace")
        for m in DECIMAL.finditer(texto):
            cifras, vale = len(m[1]), float(m[0])
            redondas = {c: {round(c, cifras), math.floor(c * 10**cifras) / 10**cifras} for c in CONSTANTES}
            if m[0] not in dados and any(vale in r and abs(vale / c - 1) > 1e-6 for c, r in redondas.items()):
                return f": ¿pocas cifras en {f}:{texto.count(chr(10), 0, m.start()) + 1}, {m[0]}?"
    return ""


def tras(p, guion):
    """La orden con que se queda una partida que no llega al final."""
    if not p.imagenes:
        return " sin dibujar nada"
    return f" al hacer «{guion.ordenes[len(p.imagenes) - 1]}»" if len(p.imagenes) <= len(guion.ordenes) else ""


def como_acaba(p, guion):
    """Lo que hay que decir de una partida que no ha acabado como debe."""
    donde = tras(p, guion)
    dice = next((linea for linea in p.errores.splitlines() if linea.strip()), "")
    dice = dice.partition("; lo he buscado en")[0]  # rutas que solo hay aquí
    if p.escrito > MUCHO:
        return f"escribe demasiado{donde}, más de {MUCHO >> 20} MB: ¿un printf o un cout en un bucle que no acaba?"
    if p.cuelga and p.segundos < p.limite / 2:
        return f"se queda esperando{donde}: ¿duerme, espera a que alguien escriba o pulse algo, o llama a fork?"
    if p.cuelga:
        return f"tarda más de lo que se le deja{donde}: ¿un bucle que no acaba, o demasiado trabajo?"
    if p.estado == 3:
        return dice.partition(": ")[2] or "error de OpenGL"
    if p.estado == -1:
        return "no ha dejado nada: ha llenado su disco o ha acabado con quien lo ejecutaba"
    if p.estado > 128:
        que = next((linea.strip() for linea in p.errores.splitlines() if "what():" in linea), "")
        if "std::bad_alloc" in que:
            return f"se cae{donde}: pide más memoria de la que se le da: ¿un vector que crece sin fin?"
        if falla := re.search(r"Assertion '(.*)' failed", p.errores):
            que = next((dicho for trozo, dicho in SE_EXIGE.items() if trozo in falla[1]), falla[1])
            return f"se cae{donde}: {que}"
        return f"se cae{donde}: {SENALES.get(p.estado, f'señal {p.estado - 128}')}{'; ' if que else ''}{que}"
    if p.estado:
        return f"acaba con un error{donde}: {dice or f'estado {p.estado}'}"
    return f"acaba por su cuenta{donde}" if len(p.imagenes) <= len(guion.ordenes) else ""
