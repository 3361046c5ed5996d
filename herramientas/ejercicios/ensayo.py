"""Si lo que pide un ejercicio se ve: se estropea de muchas maneras, a máquina (perturba.py) y como ya se sabe que se
equivoca la gente (errores.tsv), y se juega como lo que entrega un estudiante (comprueba.py)."""
import re
from collections import defaultdict
from dataclasses import replace

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
        trozos[p.desde, p.hasta].append((n, p.otro))
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
    return {n for n, (f, p) in vivas.items() if declara.search(textos[f], max(0, p.desde - 80), p.desde)}


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
        hechos = self.compila(en_cpp) if en_cpp else {}
        en_glsl = [(n, *p) for n, p in self.perturbadas.items() if p[0].endswith(SHADERS)]
        suyos = [perturba.perturbado(p, n, ruta(self.programa, f), self.textos[f]) for n, f, p in en_glsl]
        for m, jugador in self.de_lista(suyos, "glsl").items() if suyos else ():
            if self.dibuja(jugador):  # si no, es que no compila
                hechos[m.numero] = jugador
        return hechos

    def dibuja(self, jugador):
        nada = Guion("", ())
        return bool(partidas.Partida.lee(self.banco.arbitro.juega_de_nuevo(jugador, nada), nada).imagenes)

    def de_lista(self, mutantes, como):
        """Quien juega cada uno de esos cambios."""
        sitio, motivos = self.temporal / como, self.banco.motivos
        sitio.mkdir()
        motivos.planta(mutantes, sitio)
        return {m: motivos.con_defecto(m, sitio) for m in mutantes}

    def compila(self, vivas):
        """De cada una, quien la juega, todas en un binario; las que no compilan se quitan de VIVAS."""
        for vuelta in range(VUELTAS):
            textos = dict(self.textos)
            for fichero in textos:
                suyas = {n: p for n, (suyo, p) in vivas.items() if suyo == fichero}
                textos[fichero] = con_todas(self.raiz, textos[fichero], suyas)
            try:
                limpios = self.banco.motivos.limpio(textos)
                hecho = self.banco.compilador.compila(limpios, self.temporal / f"vuelta{vuelta}", ajena=False)
                return {n: replace(hecho, entorno={"LAB_MUTANTE": str(n)}) for n in vivas}
            except Rechazo as rechazo:
                dice = rechazo.todo
            if not (malas := culpables(dice, self.textos, vivas)):
                break
            for n in malas:
                vivas.pop(n, None)
        raise Fallo(f"{self.ref} perturbado no compila: {dice[:2000]}")

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
