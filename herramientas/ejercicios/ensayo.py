"""Si lo que pide un ejercicio se ve: se estropea de muchas maneras, a máquina (perturba.py) y como ya se sabe que se
equivoca la gente (errores.tsv), y se juega como lo que entrega un estudiante (comprueba.py)."""
import re

from base import defectos, marcas
from base.fuentes import SHADERS
from base.procesos import Fallo
from ejercicios import perturba
from ejercicios.corrige import partidas, veredicto
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.motivos import ruta
from ejercicios.corrige.partidas import Guion

SEMILLA = "1"  # la de ./lab corrige, si no se dice otra
VUELTAS = 9  # de quitar lo que no compila
MARCA = '\n#line {} "perturbado"\n'  # el compilador dice de cada error en cuál está, que es su línea
ANTES = '#pragma GCC diagnostic ignored "-Wnarrowing"\n'  # lo que era constante ya no lo es
OTRO_FACTOR = "herramientas/ejercicios/otro_factor.h"
ERROR = re.compile(r"perturbado:(\d+):(?:\d+:)? (?:fatal )?error: (.*)")


def culpables(dice, textos, vivas):
    """Los números de las que no compilan. Si en una declaración hay un error, lo que se declara detrás no está, y de
    quien lo usa se queja también el compilador: no tiene la culpa. Y si lo que ya no es constante debe serlo, la tiene
    quien lo declara."""
    errores = [(int(n), que) for n, que in ERROR.findall(dice)]
    de_rebote = {n for n, que in errores if "was not declared" in que}
    suyas = {n for n, _ in errores if n < defectos.DE_NADIE}
    if suyas:
        return suyas - de_rebote or suyas
    nombres = {nombre for _, que in errores for nombre in re.findall(r"‘(\w+)’", que)}
    declara = re.compile(rf"\b(?:{'|'.join(nombres) or '(?!)'})\s*[=({{]\s*\Z")
    sitios = {m.numero: (textos[m.fichero], m.sitio("")[0]) for m in vivas}
    return {n for n, (texto, desde) in sitios.items() if declara.search(texto, max(0, desde - 80), desde)}


def se_puede(m, texto):
    """Si en C++ cabe entre paréntesis, o es una instrucción entera."""
    try:
        return m.en_shader or bool(defectos.cambia(texto, [m]))
    except ValueError:
        return False


class Ensayo:
    """Un ejercicio que se prueba a sí mismo. De cada perturbación de lo que pide y de cada error conocido, quien los
    juega."""

    def __init__(self, raiz, build, ref, programa, temporal, reglas):
        self.raiz, self.ref, self.programa, self.temporal = raiz, ref, programa, temporal / ref
        self.temporal.mkdir()
        self.reglas = reglas
        self.banco = Banco(raiz, build, ref, programa, self.temporal, None, SEMILLA, reglas)
        self.guiones = self.banco.todos  # antes, los casos
        self.solucion = self.banco.compilador.solucion
        self.textos = {ruta(programa, f): texto for f, texto in self.banco.motivos.textos().items()}

    def perturbadas(self):
        """Todas las de lo que pide."""
        n = 0
        for fichero, texto in self.textos.items():
            for t in marcas.TROZO.finditer(texto):
                if t["codigo"] == self.ref:
                    for p in perturba.perturbaciones(texto, *t.span("hecho"), fichero.endswith(SHADERS)):
                        n += 1
                        yield perturba.perturbado(p, n, fichero, texto)

    # --- compilar ---

    def jugadores(self):
        """De cada perturbación que compila, quien la juega."""
        vivas = [m for m in self.perturbadas() if se_puede(m, self.textos[m.fichero])]
        antes = f'{ANTES}#include "{self.raiz / OTRO_FACTOR}"\n'
        for vuelta in range(VUELTAS):
            try:
                hechos = self.de_lista(vivas, f"vuelta{vuelta}", marca=MARCA, antes=antes)
                return {m: j for m, j in hechos.items() if not m.en_shader or self.dibuja(j)}  # si no, no compila
            except Rechazo as rechazo:
                dice = rechazo.todo
            if not (malas := culpables(dice, self.textos, vivas)):
                break
            vivas = [m for m in vivas if m.numero not in malas]
        raise Fallo(f"{self.ref} perturbado no compila: {dice[:2000]}")

    def dibuja(self, jugador):
        nada = Guion("", ())
        return bool(partidas.Partida.lee(self.banco.arbitro.juega_de_nuevo(jugador, nada), nada).imagenes)

    def de_lista(self, mutantes, como, **mas):
        """Quien juega cada uno de esos cambios."""
        sitio, motivos = self.temporal / como, self.banco.motivos
        sitio.mkdir()
        motivos.planta(mutantes, sitio, **mas)
        return {m: motivos.con_defecto(m, sitio) for m in mutantes}

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

    def se_nota(self, jugador):
        """Si con algún guion pierde puntos; se deja en el primero."""
        return any(self.nota(self.juega(jugador, [g])) < 100 for g in self.guiones)
