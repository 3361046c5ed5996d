"""Si lo que pide un ejercicio se ve: se estropea de muchas maneras, a máquina (perturba.py) y como ya se sabe que se
equivoca la gente (errores.tsv), y se juega como lo que entrega un estudiante. Lo usan ./lab ejercicio comprueba y
./lab muta huecos."""
import re
import tempfile
from collections import defaultdict
from pathlib import Path

from base import defectos, marcas
from base.fuentes import SHADERS
from base.procesos import Fallo, escribe
from ejercicios import perturba
from ejercicios.corrige import partidas, veredicto
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.compilador import SUYA
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.motivos import ruta
from ejercicios.corrige.partidas import Guion, Jugador
from ejercicios.reglas import Reglas

POCOS = 3  # guiones al azar, al menos, con que se da la nota de una semilla o de todas
VUELTAS = 9  # de quitar lo que no compila
LEJOS = 1 << 20  # la línea que no es de ninguna alternativa
ANTES = '#pragma GCC diagnostic ignored "-Wnarrowing"\n'  # lo que era constante ya no lo es


def con_lineas(texto, desde, hasta, alternativas):
    """Ese trozo de C++, con todas dentro: el compilador dice de cada error en cuál está, que es su línea."""
    original = texto[desde:hasta]
    es_instruccion = original.endswith(";")
    marca = '\n#line {} "perturbado"\n'
    for numero, otro in alternativas:
        aqui = marca.format(numero)
        if es_instruccion:
            original = f"{aqui}if (mutante({numero})) {{ {otro} }} else {{ {original} }}{marca.format(LEJOS)}"
        else:
            original = f"{aqui}(mutante({numero}) ? ({otro}) : ({original})){marca.format(LEJOS)}"
    return original


def con_todas(raiz, texto, perturbaciones):
    """Un fuente con todas esas dentro, que elige $LAB_MUTANTE."""
    trozos = defaultdict(list)
    for n, p in perturbaciones.items():
        for desde, hasta, otro in p.cambios:
            trozos[desde, hasta].append((n, otro))
    for (desde, hasta), alternativas in sorted(trozos.items(), reverse=True):
        texto = texto[:desde] + con_lineas(texto, desde, hasta, alternativas) + texto[hasta:]
    incluye = (defectos.MUTANTE_H, "herramientas/ejercicios/otro_factor.h") if trozos else ()
    return (ANTES if trozos else "") + "".join(f'#include "{raiz / f}"\n' for f in incluye) + texto


ERROR = re.compile(r"perturbado:(\d+):(?:\d+:)? (?:fatal )?error: (.*)")


def culpables(dice, textos, vivas):
    """Qué alternativas no compilan. Si en una declaración hay un error, lo que se declara detrás no está, y de quien lo
    usa se queja también el compilador: no tiene la culpa. Y si lo que ya no es constante debe serlo, la tiene quien lo
    declara."""
    errores = [(int(n), que) for n, que in ERROR.findall(dice)]
    de_rebote = {n for n, que in errores if "was not declared" in que}
    suyas = {n for n, _ in errores if n < LEJOS}
    if suyas:
        return suyas - de_rebote or suyas
    nombres = {nombre for _, que in errores for nombre in re.findall(r"‘(\w+)’", que)}
    declara = re.compile(rf"\b(?:{'|'.join(nombres) or '(?!)'})\s*[=({{]\s*\Z")
    return {
        n for n, (f, p) in vivas.items() if declara.search(textos[f], max(0, p.cambios[0][0] - 80), p.cambios[0][0])
    }


class Ensayo:
    """Un ejercicio que se prueba a sí mismo. De cada perturbación de lo que pide y de cada error conocido, quien los
    juega."""

    def __init__(self, raiz, build, ref, programa, temporal, semillas, reglas=None):
        self.raiz, self.ref, self.programa, self.temporal = raiz, ref, programa, temporal / ref
        self.temporal.mkdir()
        self.reglas = reglas or Reglas()
        self.banco = Banco(raiz, build, ref, programa, self.temporal, None, semillas[0], self.reglas)
        self.casos = [g for g in self.banco.todos if g.caso]
        entorno = self.banco.compilador.recinto.entorno
        self.de_semilla = {
            s: list(partidas.al_azar(raiz, build, programa, f"{ref} {s}", self.reglas.guiones, entorno))
            for s in semillas
        }
        self.solucion = self.banco.compilador.solucion
        self.textos = self.banco.motivos.textos()
        self.perturbadas = dict(enumerate(self.perturba(), 1))

    def perturba(self):
        for fichero, texto in self.textos.items():
            for t in marcas.TROZO.finditer(texto):
                if t["codigo"] == self.ref:
                    glsl = fichero.endswith(SHADERS)
                    for p in perturba.perturbaciones(texto, *t.span("hecho"), glsl):
                        yield fichero, p

    # --- compilar ---

    def jugadores(self):
        """De cada perturbación que compila, quien la juega."""
        en_cpp = {n: p for n, p in self.perturbadas.items() if not p[0].endswith(SHADERS)}
        hechos = {}
        if en_cpp:
            programa, raices = self.compila(en_cpp)
            hechos = {n: Jugador(str(n), programa, raices, {"LAB_MUTANTE": str(n)}) for n in en_cpp}
        for n, (fichero, p) in self.perturbadas.items():
            if fichero.endswith(SHADERS) and self.vale_glsl(fichero, p):
                hechos[n] = self.con_shader(self.temporal / f"glsl{n}", fichero, self.estropeado(fichero, p))
        return hechos

    def con_shader(self, sitio, fichero, texto):
        """Quien juega la solución con ese shader así."""
        escribe(sitio / ruta(self.programa, fichero), texto)
        return Jugador(sitio.name, self.solucion.programa, [sitio, *self.programa.raices])

    def de_lista(self, mutantes, como):
        """Quien juega cada uno de esos cambios."""
        textos, hechos = self.textos, {}
        nombra = {ruta(self.programa, f): f for f in textos}
        con = dict(textos)
        for suya, suyos in defectos.por_fichero([m for m in mutantes if m.fichero in nombra]).items():
            texto = textos[nombra[suya]]
            if suyos[0].en_shader:
                for m in suyos:
                    sitio = self.temporal / f"{como}{m.numero}"
                    hechos[m] = self.con_shader(sitio, nombra[suya], defectos.estropea(texto, m))
                continue
            con[nombra[suya]] = f'#include "{self.raiz / defectos.MUTANTE_H}"\n{defectos.cambia(texto, suyos)}'
            for m in suyos:
                hechos[m] = Jugador(m.nombre, None, None, {"LAB_MUTANTE": str(m.numero)})
        if con != textos:
            sitio = self.temporal / como
            self.banco.compilador.compila(self.banco.motivos.limpio(con), sitio, ajena=False)
            for jugador in hechos.values():
                if not jugador.programa:
                    jugador.programa = sitio / self.programa.nombre
                    jugador.raices = [sitio / "fuentes" / SUYA, sitio / "fuentes"]
        return hechos

    def estropeado(self, fichero, p):
        ((desde, hasta, otro),) = p.cambios
        return self.textos[fichero][:desde] + otro + self.textos[fichero][hasta:]

    def vale_glsl(self, fichero, p):
        """Si compila: si no, el programa acaba sin dibujar nada."""
        if len(p.cambios) > 1:
            return False
        with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
            escribe(Path(aqui, ruta(self.programa, fichero)), self.estropeado(fichero, p))
            jugador = Jugador("", self.solucion.programa, [aqui, *self.programa.raices])
            nada = Guion("", ())
            return bool(partidas.Partida.lee(self.banco.arbitro.juega_de_nuevo(jugador, nada), nada).imagenes)

    def compila(self, vivas):
        """El binario con todas, menos las que no compilan, que se quitan de VIVAS."""
        for vuelta in range(VUELTAS):
            textos = dict(self.textos)
            for fichero in textos:
                suyas = {n: p for n, (suyo, p) in vivas.items() if suyo == fichero}
                textos[fichero] = con_todas(self.raiz, textos[fichero], suyas)
            carpeta = self.temporal / f"vuelta{vuelta}"
            malas = self.no_compilan(self.banco.motivos.limpio(textos), carpeta, vivas)
            if not malas:
                return carpeta / self.programa.nombre, [carpeta / "fuentes" / SUYA, carpeta / "fuentes"]
            for n in malas:
                vivas.pop(n, None)
        raise Fallo(f"{self.ref} perturbado no compila: {malas}")

    def no_compilan(self, textos, carpeta, vivas):
        """Las que no."""
        try:
            self.banco.compilador.compila(textos, carpeta, ajena=False)
            return set()
        except Rechazo as rechazo:
            malas = culpables(rechazo.todo, self.textos, vivas)
            if not malas:
                raise Fallo(f"{self.ref} perturbado no compila: {rechazo.todo[:2000]}") from None
            return malas

    # --- jugar ---

    def juega(self, jugador, guiones):
        """De cada guion, lo que se espera y lo que deja."""
        jugado = {}
        for g in guiones:
            esperada = self.banco.arbitro.juega(self.solucion, g)
            datos = self.banco.arbitro.juega_de_nuevo(jugador, g, 10 + 4 * esperada.segundos)
            jugado[g] = esperada, partidas.Partida.lee(datos, g)
        return jugado

    def nota(self, jugado):
        """La que se le daría."""
        esperadas, suyas = ({g: par[i] for g, par in jugado.items()} for i in (0, 1))
        fallan, casi, otros = veredicto.juzga(self.banco.arbitro, esperadas, suyas)
        return veredicto.nota(jugado, [g for g in jugado if g not in fallan], casi, otros, self.reglas)

    def quita(self, jugador, guiones):
        """Si con alguno pierde puntos; se deja en el primero."""
        return any(self.nota(self.juega(jugador, [g])) < 100 for g in guiones)

    def no_se_nota(self, jugador):
        """Las semillas con que no pierde nada."""
        if self.quita(jugador, self.casos):
            return []
        return [s for s, guiones in self.de_semilla.items() if not self.quita(jugador, guiones)]

    def notas(self, jugador, mal=False):
        """La menor y la mayor, con todas las semillas. De cada una bastan los casos y unos pocos guiones, que de una a
        otra no son los mismos; si está mal, hasta que se note."""
        de_casos, notas = self.juega(jugador, self.casos), []
        for n, guiones in enumerate(self.de_semilla.values()):
            i = n % max(len(guiones), 1)
            jugado, faltan = dict(de_casos), max(1, POCOS // len(self.de_semilla))
            for guion in (*guiones[i:], *guiones[:i]):
                if faltan <= 0 and (not mal or self.nota(jugado) < 100):
                    break
                jugado |= self.juega(jugador, [guion])
                faltan -= 1
            notas.append(self.nota(jugado))
        return min(notas), max(notas)
