"""comprueba.py RAÍZ BUILD EJERCICIO… [--programa]: si cada ejercicio está bien hecho, en una línea por pregunta, con su
cifra: las marcas, el esqueleto, la solución, si cada control y cada línea que se pide los ve algún guion, y si los
errores conocidos se distinguen. Los del laboratorio son «todos»; de ellos, además, que la solución escrita de otra
manera (bien/) también vale. Con --programa solo dice qué hay que compilar antes."""
import itertools
import os
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import controles, defectos
from base.fuentes import SHADERS
from base.marcas import TROZO, fin_de_nadie
from base.procesos import Fallo, principal
from ejercicios import nuevo, perturba, propios, reglas
from ejercicios.corrige import partidas, shaders, veredicto
from ejercicios.corrige.arbitro import suma
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.lector import Rechazo, limpio
from ejercicios.corrige.motivos import como_acaba, que_cambian, ruta
from ejercicios.corrige.orden import ejercicio
from ejercicios.corrige.partidas import Guion

BIEN = "herramientas/ejercicios/bien"
SEMILLA = "1"  # la de ./lab corrige, si no se dice otra
VUELTAS = 9  # de quitar lo que no compila
SE_CALLA = "unused parameter|defined but not used"  # de lo de mios/ (cmake/ejercicios.cmake): lo usará quien lo haga
SUSPENSO = 60  # el esqueleto no llega
MANDOS = {controles.clic: "el ratón", controles.rueda: "la rueda", controles.tiempo: "el tiempo"}
SON = {controles.clic: ("boton", "arrastra", "mueve"), controles.rueda: ("rueda",), controles.tiempo: ("espera",)}


def enumera(cosas, cuantas=5):
    return "; ".join(cosas[:cuantas]) + (f"; y {len(cosas) - cuantas} más" if len(cosas) > cuantas else "")


# --- lo que se mira sin ejecutar nada: (qué, la cifra, lo que está mal) ------------------------------------------


def marcas(raiz, programa, ref):
    """Cuántos trozos se piden; los que no se cierran o se cierran sin abrir."""
    mal, cuantos, otras = [], 0, set()
    for f, texto in nuevo.textos(raiz, programa, ref).items():
        abierta = 0
        for n, renglon in enumerate(texto.splitlines(), 1):
            cierra = re.fullmatch(r" *// fin de (\S+)\s*", renglon)
            abre = re.fullmatch(rf" *// {re.escape(ref)}:(.*)", renglon)
            if cierra and cierra[1] != ref:
                otras.add(cierra[1])
            elif cierra and not abierta:
                mal.append(f"{f}:{n}: se cierra sin haberse abierto")
            elif cierra:
                abierta, cuantos = 0, cuantos + 1
            elif abre and abierta:
                mal.append(f"{f}:{abierta}: no se cierra antes de la siguiente")
            elif abre and not abre[1].strip():
                mal.append(f"{f}:{n}: no dice qué se pide")
            if abre:
                abierta = n
        mal += [f"{f}:{abierta}: no se cierra"] if abierta else []
        if (de_nadie := fin_de_nadie(texto, ref)) and any(m.startswith(f"{f}:") for m in mal):
            mal.append(f"{f}:{de_nadie[0]}: «{de_nadie[1]}» no es de nadie: ¿es «// fin de {ref}»?")
    if not cuantos and not mal:
        mal.append(f"no se pide nada: falta «// {ref}: …» y «// fin de {ref}»")
        mal += [f"las marcas son de {', '.join(sorted(otras))}, y deben ser de {ref}"] if otras else []
    return "marcas", f"se piden {cuantos} trozos", mal


def enunciado(programa):
    fichero = programa.carpeta / propios.ENUNCIADO
    texto = propios.lee_texto(fichero) if fichero.is_file() else ""
    titulo = re.search(r"^# +\S", texto, re.M)
    cuenta = [r for r in texto.splitlines() if r.strip() and not r.startswith("#")]
    mal = [] if fichero.is_file() else [f"falta {propios.ENUNCIADO}"]
    mal += ["no tiene título, «# …»"] if texto and not titulo else []
    mal += ["no dice qué hay que hacer"] if fichero.is_file() and not cuenta else []
    return "enunciado", f"{len(texto.split())} palabras", mal


# --- y lo que se juega ----------------------------------------------------------------------------------------------


class Comprobacion:
    """Un ejercicio que se prueba a sí mismo: se estropea como ya se sabe que se equivoca la gente (errores.tsv) y de
    muchas maneras, a máquina (perturba.py), y se juega como lo que entrega un estudiante."""

    def __init__(self, raiz, build, ref, programa, temporal, hilos, guiones=None):
        self.raiz, self.build, self.ref, self.programa, self.hilos = raiz, build, ref, programa, hilos
        self.temporal = temporal / ref
        self.temporal.mkdir()
        self.reglas = reglas.del_programa(programa, None, guiones, shaders.reglas(ref))
        self.banco = Banco(raiz, build, ref, programa, self.temporal, None, SEMILLA, self.reglas)
        self.arbitro, self.solucion = self.banco.arbitro, self.banco.compilador.solucion
        self.guiones = self.banco.todos
        self.casos = [g for g in self.guiones if g.caso]
        self.textos = {ruta(programa, f): texto for f, texto in self.banco.motivos.textos().items()}

    def perturbadas(self):
        """Todas las de lo que pide."""
        n = 0
        for fichero, texto in self.textos.items():
            for t in TROZO.finditer(texto):
                if t["codigo"] == self.ref:
                    for p in perturba.perturbaciones(texto, *t.span("hecho"), fichero.endswith(SHADERS)):
                        n += 1
                        yield perturba.perturbado(p, n, fichero, texto)

    def jugadores(self):
        """De cada perturbación que compila, quien la juega."""
        vivas = [m for m in self.perturbadas() if perturba.se_puede(m, self.textos[m.fichero])]
        mas = {"marca": perturba.MARCA, "antes": perturba.antes(self.raiz)}
        for vuelta in range(VUELTAS):
            try:
                hechos = self.de_lista(vivas, f"vuelta{vuelta}", **mas)
                return {m: j for m, j in hechos.items() if not m.en_shader or self.dibuja(j)}  # si no, no compila
            except Rechazo as rechazo:
                dice = rechazo.todo
            if not (malas := perturba.culpables(dice, self.textos, vivas)):
                break
            vivas = [m for m in vivas if m.numero not in malas]
        raise Fallo(f"{self.ref} perturbado no compila: {dice[:2000]}")

    def dibuja(self, jugador):
        nada = Guion("", ())
        return bool(partidas.Partida.lee(self.arbitro.juega_de_nuevo(jugador, nada), nada).imagenes)

    def de_lista(self, mutantes, como, **mas):
        """Quien juega cada uno de esos cambios."""
        sitio, motivos = self.temporal / como, self.banco.motivos
        sitio.mkdir()
        motivos.planta(mutantes, sitio, **mas)
        return {m: motivos.con_defecto(m, sitio) for m in mutantes}

    def juega(self, jugador, guiones):
        """De cada guion, lo que se espera y lo que deja."""
        jugado = {}
        for g in guiones:
            esperada = self.arbitro.juega(self.solucion, g)
            datos = self.arbitro.juega_de_nuevo(jugador, g, 10 + 4 * esperada.segundos)
            jugado[g] = esperada, partidas.Partida.lee(datos, g)
        return jugado

    def nota(self, jugado, piezas=lambda *_: ()):
        """La que se le daría; si no sale todo, con lo que valgan sus piezas."""
        esperadas, suyas = ({g: par[i] for g, par in jugado.items()} for i in (0, 1))
        fallan, valen, otros = veredicto.juzga(self.banco, esperadas, suyas, self.banco.sin_hacer)
        return veredicto.nota(jugado, valen, otros, self.reglas, piezas(esperadas, suyas) if fallan else ())

    def piezas_con(self, m):
        """Lo que valen las de la solución con ese error, que está en una o en ninguna."""
        trozos = [(ruta(self.programa, f), t.span("hecho")) for f, t in self.banco.motivos.trozos()]
        desde = m.sitio(self.textos[m.fichero])[0]
        es_de = [f == m.fichero and d <= desde < h for f, (d, h) in trozos]

        def valen(esperadas, suyas):
            return [
                veredicto.parte_de_pieza(self.banco, esperadas, suyas, self.banco.motivos.sin_hacer(i)) if suya else 1
                for i, suya in enumerate(es_de)
            ]

        return valen if len(trozos) > 1 and self.reglas.huecos else lambda *_: ()

    def se_nota(self, jugador):
        """Si con algún guion pierde puntos; se deja en el primero."""
        return any(self.nota(self.juega(jugador, [g])) < 100 for g in self.guiones)

    # --- las preguntas ---

    def solucion_acaba(self):
        """Cada guion llega al final: si no, no hay con qué comparar."""
        juega = lambda g: self.arbitro.juega(self.solucion, g)
        self.esperadas = dict(zip(self.guiones, self.hilos.map(juega, self.guiones)))
        acaban = {g: como_acaba(p, g) for g, p in self.esperadas.items()}
        # de lo que dice el programa, lo primero
        mal = [f"{g.nombre}: {limpio(dice)}" for g, dice in acaban.items() if dice]
        return "guiones", f"los {len(self.guiones)} llegan al final", mal

    def entregado(self, textos, nombre, piezas=lambda *_: ()):
        """La nota de esos ficheros, compilados como una entrega, por qué no compilan y de qué avisa el compilador."""
        try:
            jugador = self.banco.compilador.compila(textos, self.temporal / nombre, ajena=False)
        except Rechazo as rechazo:
            return 0, [limpio(str(rechazo))], []
        avisos = self.banco.compilador.avisos(textos, jugador)
        jugado = self.hilos.map(lambda g: self.juega(jugador, [g])[g], self.guiones)
        return self.nota(dict(zip(self.guiones, jugado)), piezas), [], avisos

    def esqueleto(self):
        cuantas = len(self.banco.motivos.trozos())
        nadas = lambda *_: [0] * cuantas if cuantas > 1 else []
        nota, mal, avisos = self.entregado(self.banco.dados[0], "de_partida", nadas)
        avisos = [a for a in avisos if not re.search(SE_CALLA, a)]
        if not mal and nota >= SUSPENSO:
            mal.append(f"sin hacer nada ya se saca {nota:g}: debe ser menos de {SUSPENSO}")
        ojo = f"\nojo   esqueleto: al compilarlo salen {len(avisos)} avisos: {enumera(avisos)}" if avisos else ""
        return "esqueleto", f"{nota:g} de 100{ojo}", mal

    def la_solucion(self):
        nota, mal, _ = self.entregado(self.banco.dados[1], "resuelto")
        if not mal and nota < 100:
            mal.append(f"la solución saca {nota:g}: ¿lee la hora, o algo que no está en su carpeta?")
        return "solución", f"{nota:g} de 100", mal

    def controles(self):
        """Cada tecla que dicen sus «// Controles:», cada opción de sus menús y cada mando que atiende, en algún guion
        cambia la imagen."""
        suyos = controles.lee(self.raiz, self.programa)
        mal = [] if suyos else ["falta la línea «// Controles: … · Esc termina.»"]
        rasgos, opciones = controles.atiende(self.build, self.programa)
        ordenes = [o for c in suyos if not c.termina for o in c.ordenes if o not in controles.COMUNES]
        ordenes += [f"menu {o}" for o in opciones]
        vistas = que_cambian(self.esperadas)
        mal += [f"«{o}» no cambia la imagen en ningún guion" for o in ordenes if not vistas.get(o)]
        mandos = [m for m, cuales in controles.MANDOS.items() if cuales & rasgos]
        for mando in mandos:
            if not any(vistas.get(orden) for orden in SON[mando]):
                mal.append(f"{MANDOS[mando]} no cambia la imagen en ningún guion")
        return "controles", f"se ven {len(ordenes) + len(mandos)}", mal

    def imagenes(self):
        """Que a lo largo de los guiones no se vea siempre lo mismo, y que dos casos no sean el mismo."""
        distintas = {imagen for p in self.esperadas.values() for imagen in p.imagenes}
        finales = {}
        for g in self.casos:
            finales.setdefault(self.esperadas[g].imagenes[len(g.ordenes) - len(partidas.FINAL)], []).append(g.nombre)
        mal = [f"se ve lo mismo en los casos {' y '.join(n)}" for n in finales.values() if len(n) > 1]
        lisas = [g.nombre for g in self.casos if len(set(veredicto.pixeles(self.esperadas[g].imagenes[0]))) < 2]
        mal += [f"al abrirlo no se dibuja nada en {lisas[0]}"] if lisas else []
        return "imágenes", f"{len(distintas)} distintas en {len(self.esperadas)} guiones", mal

    def errores(self):
        """Los conocidos: cada uno quita puntos y no se confunde con otro ni con el esqueleto."""
        suyos = [m for m in self.banco.motivos.defectos if m.dice]
        mal = [f"{m.nombre}: no dice nada a quien lo comete: falta la sexta columna" for m in self.mudos()]
        try:
            quienes = self.de_lista(suyos, "mal")
        except Rechazo:
            return "errores conocidos", f"{len(suyos)}", [*mal, *self.los_que_no_compilan(suyos)]
        hecho = dict(zip(suyos, self.hilos.map(lambda m: self.resume(quienes[m], self.piezas_con(m)), suyos)))
        mal += [f"{m.nombre}, {m.imita}: no quita puntos" for m, (nota, _) in hecho.items() if nota == 100]
        for (una, (_, deja)), (otra, (_, dejo)) in itertools.combinations(hecho.items(), 2):
            if una.dice != otra.dice and deja == dejo:
                mal.append(f"{una.nombre} y {otra.nombre} no se distinguen: {una.dice}; {otra.dice}")
        quitan = {m: round(100 - nota, 1) for m, (nota, _) in hecho.items()}
        cada_uno = [f"\n      quita {quitan[m]:g}: {m.imita}" for m in sorted(quitan, key=lambda m: -quitan[m])]
        return "errores conocidos", f"{len(suyos)}, que se distinguen{''.join([*cada_uno, *self.ojo(quitan)])}", mal

    def ojo(self, quitan):
        """De los que quitan, cada uno solo, más de lo que dicen las reglas."""
        mucho = [m.imita for m, puntos in quitan.items() if puntos > self.reglas.cuesta_mas]
        if mucho:
            yield (
                f"\nojo   errores conocidos: cada uno de estos, él solo, quita más de {self.reglas.cuesta_mas:g} "
                f"(cuesta_mas): {enumera(mucho)}. Para que quiten menos: casos en que no se noten, más piezas o, en "
                f"{reglas.FICHERO}, más peso de ellas (huecos = {self.reglas.huecos:g})"
            )

    def resume(self, jugador, piezas=lambda *_: ()):
        """Su nota, y lo que deja en cada guion, que entero no cabría."""
        jugado = self.juega(jugador, self.guiones)
        dejan = [suma(repr(p.titulos), p.texto, *(i[2] for i in p.imagenes)) for _, p in jugado.values()]
        return self.nota(jugado, piezas), dejan

    def los_que_no_compilan(self, suyos):
        for m in suyos:
            try:
                self.de_lista([m], f"solo{m.numero}_")
            except Rechazo as rechazo:
                yield f"{m.nombre}, {m.imita}: {limpio(str(rechazo))}"

    def mudos(self):
        return [m for m in self.banco.motivos.defectos if not m.dice] if self.programa.raices else []

    def otras_maneras(self):
        """La solución, escrita de otra manera: a quien la entregara así no se le quita nada."""
        otras = [m for m in defectos.lee(self.raiz / BIEN)[0] if m.lista == self.ref]
        quienes = self.de_lista(otras, "bien")
        notas = dict(zip(quienes, self.hilos.map(lambda m: self.resume(quienes[m])[0], quienes)))
        mal = [f"{m.nombre}, {m.imita}: está bien, y saca {nota:g}" for m, nota in notas.items() if nota < 100]
        return "otras maneras", f"{len(notas)} valen lo mismo", mal

    def lineas(self):
        """Cada línea de lo que se pide, estropeada de alguna manera, se nota."""
        try:
            quienes = self.jugadores()
        except Fallo as fallo:
            return "líneas", "0", [limpio(str(fallo))]
        print(f"{len(quienes)} cambios en lo que se pide, uno a uno: es lo que más tarda…", file=sys.stderr, flush=True)
        notadas = dict(zip(quienes, self.hilos.map(lambda m: self.se_nota(quienes[m]), quienes)))
        de_linea = {}
        for m, notada in notadas.items():
            de_linea.setdefault((Path(m.fichero).name, m.perturbacion.linea), []).append(notada)
        mal = [
            f"{f}:{n}: se cambie como se cambie, da lo mismo" for (f, n), vistas in de_linea.items() if not any(vistas)
        ]
        if not de_linea:
            mal.append("en lo que se pide no hay nada que se pueda estropear")
        cambios = f"{sum(notadas.values())} cambios de {len(notadas)}"
        return "líneas", f"se notan {len(de_linea) - len(mal)} de {len(de_linea)}, con {cambios}", mal


def preguntas(raiz, build, ref, programa, temporal, hilos):
    """Cada una: (qué, la cifra, lo que está mal). Con lo que no deja seguir mal, las demás no se hacen."""
    yield (hay := marcas(raiz, programa, ref))
    if programa.raices:
        yield enunciado(programa)
    if hay[2]:
        return
    suya = Comprobacion(raiz, build, ref, programa, temporal, hilos)
    yield (llegan := suya.solucion_acaba())
    if llegan[2]:
        return
    yield suya.esqueleto()
    yield suya.la_solucion()
    if programa.raices:  # lo demás se pregunta a cada programa del laboratorio, y los de la página juegan sus gestos
        yield suya.controles()
        yield suya.imagenes()
    yield suya.errores()
    if not programa.raices:
        yield suya.otras_maneras()
    yield suya.lineas()


def elige(raiz, build, pedido):
    """Cada uno de los que se piden, y su programa."""
    programas, ref = propios.resuelve(raiz, build, pedido)
    if pedido == "todos":
        return nuevo.ejercicios(raiz, [p for p in programas if not p.raices]) | shaders.ejercicios(raiz, programas)
    suyo = next((p for p in programas if p.raices and p.nombre == ref), None)
    return {ref: suyo} if suyo else dict([ejercicio(raiz, programas, ref)])


def comprueba(raiz, build, ref, programa):
    """Lo que le falta para darlo, tras decir cada cosa."""
    mal = 0
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
        for pregunta, cifra, fallos in preguntas(raiz, build, ref, programa, Path(temporal), hilos):
            print(f"mal   {pregunta}: {enumera(fallos)}" if fallos else f"bien  {pregunta}: {cifra}", flush=True)
            mal += bool(fallos)
    print(f"{ref} {'todavía no ' * bool(mal)}está para darlo", flush=True)
    return [f"{ref} todavía no está para darlo: {mal} de las preguntas, mal"] if mal else []


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    que, solo_dice = [p for p in sys.argv[3:] if p != "--programa"], "--programa" in sys.argv
    if not que:
        raise Fallo("ejercicio comprueba: di qué ejercicio: ./lab ejercicio comprueba ejercicios/NOMBRE")
    hay = {ref: programa for pedido in que for ref, programa in elige(raiz, build, pedido).items()}
    if solo_dice:
        return print(*dict.fromkeys(p.objetivo for p in hay.values()))
    mal = []
    for ref, programa in hay.items():
        mal += comprueba(raiz, build, ref, programa)
    if mal:
        raise Fallo("; ".join(mal))


if __name__ == "__main__":
    principal(main)
