"""La corrección de una entrega: en qué guiones se aparta de la solución, la nota, y de los que antes fallan, en
palabras y en imágenes."""
import base64
import os
import tempfile
import time
from collections import Counter
from pathlib import Path

from base.guiones import acorta, sin_veces
from base.procesos import en_png
from ejercicios.corrige.arbitro import BIEN, CASI, aparte
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.motivos import SENALES, como_acaba, no_responden, pocas_cifras
from ejercicios.corrige.donde import TRAZO
from ejercicios.corrige.partidas import FINAL, TALLA, Guion, Partida, lee_ppm
from ejercicios.corrige.piezas import NO_COMPILA, PARECE, Piezas, SoloLoEntero, pelado
from ejercicios.reglas import Reglas

VENTANA = 960, 720  # la que se abre
DE_SU_VENTANA = "boton", "arrastra", "mueve", "rueda", "tamano"  # órdenes con un sitio de la ventana
MUESTRA = 3  # guiones que fallan, con sus imágenes
INTENTOS = 24  # para acortar un guion
CUELGUES = 2  # tras los que no se juega más
AVISOS = 3  # del propio programa
COMO_AL_EMPEZAR = "se ve lo mismo que en el punto de partida"
POR_POCO = "se ve casi igual, con un desvío de menos de un cuarto de píxel"
TOPE = 300  # segundos de una entrega, entre todos sus guiones


def png(imagen, deja):
    ancho, alto, pixeles = imagen
    (deja / "i.ppm").write_bytes(b"P6\n%d %d\n255\n" % (ancho, alto) + pixeles)
    return base64.b64encode(en_png(deja / "i.ppm", 9)).decode()


def pixeles(imagen):
    return [imagen[2][i : i + 3] for i in range(0, len(imagen[2]), 3)]


def bordes(colores, ancho):
    """Qué píxeles no son del color del de su izquierda, o del de encima."""
    juntos = lambda i: {colores[i], colores[i - bool(i % ancho)], colores[max(i - ancho, i % ancho)]}
    return {i for i in range(len(colores)) if len(juntos(i)) > 1}


def del_fondo(debidos, suyos):
    """En cuántos píxeles hay algo donde no debía o falta donde debía, sea del color que sea."""
    fondo = Counter(debidos).most_common(1)[0][0]
    suyo = Counter(b for a, b in zip(debidos, suyos) if a == fondo).most_common(1)[0][0]
    return sum((a == fondo) != (b == suyo) for a, b in zip(debidos, suyos))


def en_que(una, otra):
    """Dónde se apartan dos imágenes, o si es solo en los colores."""
    if una[:2] != otra[:2]:
        return "la imagen es de {}×{} y debía ser de {}×{}".format(*otra[:2], *una[:2])
    ancho, alto, _ = una
    debida, suya = pixeles(una), pixeles(otra)
    mal = [i for i, (a, b) in enumerate(zip(debida, suya)) if a != b]
    debidos, suyos = bordes(debida, ancho), bordes(suya, ancho)
    mismos = debidos and len(suyos ^ debidos) < 0.002 * ancho * alto and len(suyos & debidos) > 0.9 * len(debidos)
    if mismos and del_fondo(debida, suya) < 0.1 * len(mal):
        return "las formas están bien; los colores, no"
    x, y = sum(i % ancho for i in mal) / len(mal) / ancho, sum(i // ancho for i in mal) / len(mal) / alto
    if len(mal) > 0.5 * ancho * alto:
        return "casi toda la imagen"
    vertical = ["arriba"] * (y < 0.4) + ["abajo"] * (y > 0.6)
    return " ".join([*vertical, *["a la izquierda"] * (x < 0.4), *["a la derecha"] * (x > 0.6)]) or "en el centro"


def distintos(esperada, obtenida):
    """Cuánto se apartan las imágenes en que más se apartan."""
    pares = zip(esperada.imagenes, obtenida.imagenes)
    return max((sum(a != b for a, b in zip(una[2], otra[2])) for una, otra in pares), default=0)


def juzga(banco, esperadas, partidas, de_nada):
    """En qué imagen falla cada guion, lo que vale cada uno, de 0 a 1, y lo que cuenta una vez, no en cada guion. De un
    caso que falla al seguirlo cuenta lo suyo, si se ve bien y lo que juega DE_NADA() no."""
    arbitro, reglas = banco.arbitro, banco.reglas
    donde = {g: arbitro.difiere(esperadas[g], p) for g, p in partidas.items()}
    fallan = {g: i for g, i in donde.items() if i is not None}

    def empieza_bien(g, p):
        imagen = esperadas[g].imagenes[g.suyas]
        return len(p.imagenes) > g.suyas and arbitro.parecido(imagen, p.imagenes[g.suyas]) == BIEN

    def vale(g, p):
        if g not in fallan:
            return 1
        if arbitro.difiere(esperadas[g], p, CASI) is None:
            return reglas.casi / 100
        if reglas.medias and g.caso and empieza_bien(g, p) and (nada := de_nada()):
            return 0 if empieza_bien(g, arbitro.juega(nada, g, esperadas[g])) else reglas.medias / 100
        return 0

    valen = {g: vale(g, p) for g, p in partidas.items()}
    otros = {}
    for g, p in partidas.items():
        if len(p.imagenes) == len(esperadas[g].imagenes):
            otros = {**aparte(esperadas[g], p), **otros}
    return fallan, valen, otros


def parte(todos, valen, reglas):
    """La de los guiones jugados, con lo que VALEN y lo que pesa cada uno, de 0 a 1."""
    return sum(reglas.peso(g) * valen.get(g, 0) for g in todos) / sum(map(reglas.peso, todos))


def redondea(puntos):
    """A una cifra; lo que está justo en medio, salvo lo que mueve sumar en otro orden, a la que es par."""
    return round(round(puntos, 9), 1)


def nota(todos, valen, otros, reglas=Reglas(), piezas=()):
    """Esa parte, junto con la de cada pieza, si se sabe, y sin lo que quita lo demás. Con un fallo que cueste algo no
    es 100."""
    puntos = reglas.junta(parte(todos, valen, reglas), piezas)
    cuestan = sum(reglas.cuesta(que) for que in otros)
    todo = all(valen.get(g) == 1 for g in todos)
    return min(redondea(puntos * (100 - cuestan)), 100 if todo and not cuestan else 99.9)


def parte_de_pieza(banco, esperadas, partidas, sin_hacer):
    """La de la solución con esa pieza; 0, si deja lo mismo que SIN_HACER, que juega la solución sin ella."""
    fallan, valen, _ = juzga(banco, esperadas, partidas, lambda: sin_hacer)
    es_de_nada = lambda g: banco.arbitro.difiere(banco.arbitro.juega(sin_hacer, g, esperadas[g]), partidas[g]) is None
    if fallan and sin_hacer and all(map(es_de_nada, partidas)):
        return 0
    return parte(banco.todos, valen, banco.reglas)


def en_su_ventana(ordenes, pixel, talla):
    """Ese píxel en la ventana que se abre o, si el guion usa el ratón o cambia el tamaño, en la suya; y cómo se ve con
    ./lab explica."""
    mide = [*map(int, talla)]
    es_otra = any(orden.partition(" ")[0] in DE_SU_VENTANA for orden in ordenes)
    como = ["-geometry {}x{}".format(*TALLA)] * es_otra + [f'-guion "{"; ".join(ordenes)}"'] * bool(ordenes)
    if pixel and not es_otra:
        veces = VENTANA[0] // mide[0]
        pixel, mide = [veces * p + veces // 2 for p in pixel], [*VENTANA]
    return {"pixel": pixel, "ventana": mide, "explica": " ".join([*map(str, pixel or ()), *como])}


class Correccion:
    """En un diccionario que va tal cual a su JSON."""

    def __init__(self, banco, entrega):
        self.banco, self.arbitro, self.entrega = banco, banco.arbitro, entrega
        self.gastado, self.caidas, self.partidas = 0, {}, {}

    def juega(self, guion, esperada):
        antes = time.monotonic()
        partida = self.arbitro.juega(self.jugador, guion, esperada)
        self.gastado += time.monotonic() - antes
        return partida

    @property
    def dibuja(self):
        return any(p.imagenes for p in self.partidas.values())

    def hazla(self):
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as carpeta:
            os.chmod(carpeta, 0o755)  # lo lee quien está en la jaula
            try:
                suyos, intentos = self.entrega.ficheros, self.entrega.intentos
                self.jugador = self.banco.compilador.compila(suyos, Path(carpeta), intentos=intentos)
                if self.jugador.fuentes:
                    self.entrega.corregida(self.jugador.fuentes)
            except Rechazo as rechazo:
                return {"nota": 0, "dice": [str(rechazo)], "fallos": [], "entero": NO_COMPILA}
            self.carpeta = carpeta
            return self.compara()

    @property
    def hay_tiempo(self):
        return self.gastado <= TOPE

    def juega_todos(self, jugador):
        """Lo que deja en cada guion; si se cuelga o tarda, solo en los primeros."""
        jugador_suyo, self.jugador, partidas = self.jugador, jugador, {}
        for guion in self.banco.todos:
            partidas[guion] = self.juega(guion, self.esperadas[guion])
            if sum(p.cuelga for p in partidas.values()) >= CUELGUES or not self.hay_tiempo:
                break
        self.jugador = jugador_suyo
        return partidas

    def parte_de(self, jugador, sin_hacer):
        """La de una pieza, que juega ese, y qué errores conocidos son los suyos."""
        partidas = self.juega_todos(jugador)
        if not self.hay_tiempo:
            raise SoloLoEntero("es muy lento")
        suya = parte_de_pieza(self.banco, self.esperadas, partidas, sin_hacer)
        fallan = [] if suya == 1 else juzga(self.banco, self.esperadas, partidas, lambda: sin_hacer)[0]
        porque = self.banco.motivos.por_que(partidas, self.esperadas, fallan) if fallan else []
        return suya, ["; o ".join(filter(None, porque[:3]))] * any(porque)

    def por_piezas(self):
        """Lo que vale cada una y sus errores; y si no se puede saber, por qué: entonces cuenta solo lo entero."""
        if not self.banco.reglas.huecos or self.banco.sin_solucion:
            return [], self.banco.sin_solucion
        try:
            return Piezas(self).juega(), ""
        except SoloLoEntero as por:
            return [], str(por)

    def compara(self):
        todos, solucion = self.banco.todos, self.banco.compilador.solucion
        self.esperadas = {g: self.arbitro.juega(solucion, g) for g in todos}
        self.partidas = self.juega_todos(self.jugador)
        fallan, valen, otros = juzga(self.banco, self.esperadas, self.partidas, self.banco.sin_hacer)
        bien = [g for g in todos if g in self.partidas and g not in fallan]
        muestra = self.muestra(fallan)
        acaban = list(dict.fromkeys(filter(None, (self.como_acaba(g) for g in self.partidas))))
        dice = acaban[:3]
        if any(p.estado in SENALES for p in self.partidas.values()):  # casi siempre lo sabía el compilador
            avisos = self.banco.compilador.avisos(self.entrega.ficheros, self.jugador)
            dice += [f"el compilador avisa: {a}" for a in avisos[:2]]
        if self.gastado > TOPE and len(self.partidas) < len(todos):
            jugados = f"{len(self.partidas)} de los {len(todos)} guiones"
            dice.append(f"es muy lento: a los {TOPE // 60} minutos se ha dejado, con {jugados} jugados")
        if (fallan or otros) and not acaban:
            dice += self.explica(fallan, muestra)
        dice += [como for que, como in otros.items() if que != "estado"]
        if fallan:
            dice += [f"el programa avisa: {a}" for a in self.avisos()[:AVISOS]]
        if medias := [g.nombre for g in fallan if valen[g] and not self.es_casi(g)]:
            dice.append(f"se ven bien, hasta que se toca algo más, los casos {', '.join(medias)}")
        casos = {g.nombre: g in bien for g in todos if g.caso}
        cuenta = {"bien": len(bien), "guiones": len(todos), "casos": casos, "dice": dice, "fallos": muestra}
        todo = parte(todos, valen, self.banco.reglas) == 1
        piezas, entero = ([], "") if todo else self.por_piezas()
        if not any(d.startswith(PARECE) for d in dice) and COMO_AL_EMPEZAR not in dice:
            dice[:0] = [d for _, dicen in piezas for d in dicen]  # de varios errores a la vez, cada uno en su pieza
        partes = [suya for suya, _ in piezas]
        suya = nota(todos, valen, otros, self.banco.reglas, partes)
        piden = self.banco.motivos.trozos() if piezas else []
        de_cada = [{"pide": t["pide"], "nota": redondea(100 * p)} for (_, t), p in zip(piden, partes)]
        return {"nota": suya, **cuenta, "piezas": de_cada, "entero": entero}

    def como_acaba(self, guion):
        partida = self.partidas[guion]
        dice = como_acaba(partida, guion)
        if partida.estado not in SENALES or partida.errores in self.caidas:
            return f"{dice}{self.caidas.get(partida.errores, '')}"
        linea = self.banco.compilador.linea_en_que_cae(self.entrega.ficheros, self.jugador, partida.errores)
        self.caidas[partida.errores] = f", en {linea}" if linea else ""
        return self.como_acaba(guion)

    def avisos(self):
        """De lo que avisa el programa, lo que no avisa también la solución."""
        marca = f"{self.banco.programa.nombre}: aviso: "
        dichos = [
            {
                linea.partition(marca)[2]: 1
                for p in partidas.values()
                for linea in p.errores.splitlines()
                if marca in linea
            }
            for partidas in (self.partidas, self.esperadas)
        ]
        return [a for a in dichos[0] if a not in dichos[1]]

    def es_casi(self, guion):
        return self.arbitro.difiere(self.esperadas[guion], self.partidas[guion], CASI) is None

    def es_lo_de_partida(self):
        """Sin mirar los comentarios ni los blancos."""
        suyos = {*map(pelado, self.entrega.ficheros.values())}
        return all(pelado(texto) in suyos for texto in self.banco.de_partida[0].values())

    def explica(self, fallan, muestra):
        if self.es_lo_de_partida():
            return [COMO_AL_EMPEZAR]
        porque = self.banco.motivos.por_que(self.partidas, self.esperadas, fallan)
        if porque == [""] and not any(fallo["donde"] for fallo in muestra):
            return [COMO_AL_EMPEZAR]
        porque = [dice for dice in porque if dice]
        dice = ["; o ".join(porque[:3])] if porque else []
        if not porque and fallan and all(map(self.es_casi, fallan)):
            return [f"{POR_POCO}{pocas_cifras(self.entrega.ficheros, self.banco.de_partida[0])}"]
        callan, alguna = no_responden(self.partidas, self.esperadas)
        if callan and not alguna:
            dice.append("no responde a nada de lo que debería")
        elif 0 not in fallan.values():  # si no, antes es lo que falta al empezar
            dice += [f"«{orden}» no hace nada" for orden in callan[:5]]
        if any(fallo["tras"] and fallo["tras"][-1].startswith("tamano") for fallo in muestra):
            dice.append("está mal al cambiar el tamaño de la ventana")
        return dice

    def muestra(self, fallan):
        """De los guiones que antes fallan, sin repetir: qué órdenes bastan, en palabras y en imágenes."""
        vistos, fallos = [], []
        for guion in sorted(fallan, key=lambda g: (fallan[g], not g.caso))[: 4 * MUESTRA]:
            if len(fallos) == MUESTRA or [] in vistos:
                break
            if [sin_veces(o) for o in guion.ordenes[: fallan[guion]][-1:]] in vistos:  # ya se sabe que con eso basta
                continue
            tras, esperada, obtenida = self.acortado(guion, fallan[guion])
            bastan = [sin_veces(o) for o in tras]
            if bastan not in vistos:
                vistos.append(bastan)
                falla = "falla tras " + ", ".join(f"«{o}»" for o in tras) if tras else "falla ya al empezar"
                fallo = {"guion": guion.nombre, "tras": list(tras), "que": falla, "donde": None, "imagenes": []}
                i = self.arbitro.difiere(esperada, obtenida)
                if i is not None and i < len(obtenida.imagenes):
                    par = esperada.imagenes[i], obtenida.imagenes[i]
                    como = self.como(*par)
                    fallo |= {"que": f"{falla}: {como}" if como else falla, "imagenes": self.imagenes(*par)}
                    fallo["donde"] = None if obtenida.cuelga else self.donde(Guion("", tras[:i]), *par)
                fallos.append(fallo)
        hallados = [f for f in fallos if f["donde"]]
        if hallados and all(f["donde"]["que"] == TRAZO for f in hallados):
            hallados[0]["donde"] = self.donde_no_es_un_trazo(fallan) or hallados[0]["donde"]
        return fallos

    def donde_no_es_un_trazo(self, fallan):
        """En los casos, con todas sus órdenes, lo primero que se aparta y dice más que por dónde va un trazo."""
        for guion in [g for g in fallan if g.caso and g.ordenes[: -len(FINAL)]][:MUESTRA]:
            tras = guion.ordenes[: -len(FINAL)]
            imagenes = [p[guion].imagenes[len(tras) :][:1] for p in (self.esperadas, self.partidas)]
            if all(imagenes) and (hallado := self.donde(Guion("", tras), imagenes[0][0], imagenes[1][0])):
                if hallado["que"] in ("uniform", "linea"):
                    return {**hallado, "dice": f"tras {', '.join(f'«{o}»' for o in tras)}, {hallado['dice']}"}
        return None

    def acortado(self, guion, hasta):
        """Las órdenes de ese guion que bastan para que falle, y las dos partidas."""
        ordenes = guion.ordenes[:hasta]
        jugadas = {guion.ordenes: (self.esperadas[guion], self.partidas[guion])}

        def falla(candidatas):
            g = Guion("", tuple(candidatas))
            esperada = Partida.lee(self.arbitro.juega_de_nuevo(self.banco.compilador.solucion, g), g)
            jugadas[g.ordenes] = esperada, self.juega(g, esperada)
            return self.arbitro.difiere(*jugadas[g.ordenes]) is not None

        # acortarlo es jugarlo otra vez, y otra
        if self.partidas[guion].cuelga or self.gastado > TOPE / 2 or self.banco.sin_solucion:
            return ordenes, *jugadas[guion.ordenes]
        if ordenes:
            ordenes = acorta(ordenes, falla, INTENTOS)
        if ordenes not in jugadas:
            falla(ordenes)
        if ordenes and ordenes[-1].startswith(("tecla", "especial")) and "×" not in ordenes[-1]:
            siete = (*ordenes[:-1], f"{ordenes[-1]} ×7")  # que con más veces se vea más
            if falla(siete) and distintos(*jugadas[siete]) > distintos(*jugadas[ordenes]):
                return siete, *jugadas[siete]
        return ordenes, *jugadas[ordenes]

    def como(self, una, otra):
        cuanto = self.arbitro.parecido(una, otra)
        return POR_POCO if cuanto == CASI else en_que(una, otra) if cuanto == 0 else ""

    def donde(self, guion, una, otra):
        """Lo primero en que se apartan al dibujarlas, o None."""
        if self.gastado > TOPE / 2:
            return None
        antes = time.monotonic()
        hallado = self.banco.donde.busca(self.jugador, self.entrega.ficheros, guion, una, otra)
        self.gastado += time.monotonic() - antes
        return hallado and {**hallado, **en_su_ventana(guion.ordenes, hallado["pixel"], una[:2])}

    def imagenes(self, una, otra):
        """La entregada, la esperada y su diferencia, en PNG."""
        if self.arbitro.parecido(una, otra) == BIEN:
            return []
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as aqui:
            aqui = Path(aqui)
            imagenes = [otra, una]
            self.arbitro.compara(una, otra, "--amplia", "--deja", aqui / "d")
            if (aqui / "d-diferencia.ppm").exists():
                imagenes.append(lee_ppm((aqui / "d-diferencia.ppm").read_bytes()))
            return [png(imagen, aqui) for imagen in imagenes]
