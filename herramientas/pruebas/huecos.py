"""huecos.py RAÍZ BUILD [--semillas N] [EJERCICIO…]: si ./lab corrige ve toda la solución de cada ejercicio.

Cada línea que escribe quien lo hace se perturba de varias maneras (perturba.py), todas en un binario, y con cada
semilla debe quitarle puntos algún guion, salvo lo que está en EXCEPCIONES. También los errores conocidos
(ejercicios/errores/) y, al revés, las soluciones escritas de otra manera (tests/herramientas/bien.tsv) valen 100.
"""
import os
import re
import shutil
import sys
import tempfile
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, defectos, marcas
from base.fuentes import SHADERS
from base.procesos import Fallo, principal
from ejercicios import nuevo
from ejercicios.corrige import partidas
from ejercicios.corrige.arbitro import aparte
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.orden import GUIONES
from ejercicios.corrige.partidas import Jugador
from pruebas import perturba
from pruebas.muta import no_compila_glsl

BIEN = "tests/herramientas/bien.tsv"
VUELTAS = 6  # de quitar lo que no compila
# (ejercicio, cómo queda el trozo): por qué no se puede ver
EXCEPCIONES = {}


def con_lineas(texto, desde, hasta, alternativas):
    """Ese trozo de C++, con todas dentro: el compilador dice de cada error en cuál está, que es su línea."""
    original = texto[desde:hasta]
    es_instruccion = original.endswith((";", "}"))
    marca = '\n#line {} "perturbado"\n'
    for numero, otro in alternativas:
        aqui = marca.format(numero)
        if es_instruccion:
            original = f"{aqui}if (mutante({numero})) {{ {otro} }} else {{ {original} }}{marca.format(1 << 20)}"
        else:
            original = f"{aqui}(mutante({numero}) ? ({otro}) : ({original})){marca.format(1 << 20)}"
    return original


class Ejercicio:
    def __init__(self, raiz, build, ref, programa, temporal, semillas):
        self.raiz, self.ref, self.programa, self.temporal = raiz, ref, programa, temporal / ref
        self.temporal.mkdir()
        self.banco = Banco(raiz, build, ref, programa, self.temporal, None, semillas[0], GUIONES)
        self.casos = [g for g in self.banco.todos if g.caso]
        entorno = self.banco.compilador.recinto.entorno
        self.de_semilla = {
            s: list(partidas.al_azar(raiz, build, programa, f"{ref} {s}", GUIONES, entorno)) for s in semillas
        }
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
        solucion = self.banco.compilador.solucion
        for n, (fichero, p) in self.perturbadas.items():
            if fichero.endswith(SHADERS) and self.vale_glsl(fichero, p):
                ruta = self.temporal / f"glsl{n}" / self.programa.capitulo.nombre / fichero
                ruta.parent.mkdir(parents=True)
                ruta.write_text(self.estropeado(fichero, p))
                hechos[n] = Jugador(str(n), solucion.programa, [self.temporal / f"glsl{n}"])
        return hechos

    def estropeado(self, fichero, p):
        ((desde, hasta, otro),) = p.cambios
        return self.textos[fichero][:desde] + otro + self.textos[fichero][hasta:]

    def vale_glsl(self, fichero, p):
        if len(p.cambios) > 1:
            return False
        return not no_compila_glsl(self.raiz, f"{self.programa.capitulo.nombre}/{fichero}", self.estropeado(fichero, p))

    def compila(self, vivas):
        """El binario con todas, menos las que no compilan, que se quitan de VIVAS."""
        for vuelta in range(VUELTAS):
            textos = dict(self.textos)
            for fichero in textos:
                trozos = defaultdict(list)
                for n, (suyo, p) in vivas.items():
                    for desde, hasta, otro in p.cambios if suyo == fichero else ():
                        trozos[desde, hasta].append((n, otro))
                for (desde, hasta), alternativas in sorted(trozos.items(), reverse=True):
                    nuevo_texto = con_lineas(textos[fichero], desde, hasta, alternativas)
                    textos[fichero] = textos[fichero][:desde] + nuevo_texto + textos[fichero][hasta:]
                if trozos:
                    incluye = (defectos.MUTANTE_H, "herramientas/pruebas/otro_factor.h")
                    textos[fichero] = "".join(f'#include "{self.raiz / f}"\n' for f in incluye) + textos[fichero]
            carpeta = self.temporal / f"vuelta{vuelta}"
            malas = self.no_compilan(self.banco.motivos.limpio(textos), carpeta)
            if not malas:
                return carpeta / self.programa.nombre, [carpeta / "fuentes/mios", carpeta / "fuentes"]
            for n in malas:
                vivas.pop(n, None)
        raise Fallo(f"huecos: {self.ref} no compila: {malas}")

    def no_compilan(self, textos, carpeta):
        """Las que no."""
        try:
            self.banco.compilador.compila(textos, carpeta, ajena=False)
            return set()
        except Rechazo as rechazo:
            malas = {int(n) for n in re.findall(r"perturbado:(\d+):(?:\d+:)? (?:fatal )?error", rechazo.todo)}
            if not malas - {1 << 20}:
                raise Fallo(f"huecos: {self.ref} no compila: {rechazo.todo[:2000]}") from None
            return malas

    # --- jugar ---

    def quita(self, jugador, guion):
        """Si con ese guion pierde puntos."""
        esperada = self.banco.arbitro.juega(self.banco.compilador.solucion, guion)
        datos = self.banco.arbitro.juega_de_nuevo(jugador, guion, 10 + 4 * esperada.segundos)
        obtenida = partidas.Partida.lee(datos, guion)
        return self.banco.arbitro.difiere(esperada, obtenida) is not None or bool(aparte(esperada, obtenida))

    def no_se_nota(self, jugador):
        """Las semillas con que no pierde nada."""
        if any(self.quita(jugador, g) for g in self.casos):
            return []
        return [s for s, guiones in self.de_semilla.items() if not any(self.quita(jugador, g) for g in guiones)]


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    resto = sys.argv[3:]
    semillas = 1
    if resto[:1] == ["--semillas"]:
        semillas, resto = int(resto[1]), resto[2:]
    hay = nuevo.ejercicios(raiz, catalogo.lee_programas(build))
    mal = 0
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
        for ref in resto or hay:
            e = Ejercicio(raiz, build, ref, hay[ref], Path(temporal), range(1, semillas + 1))
            quienes = e.jugadores()
            quedan = dict(zip(quienes, hilos.map(e.no_se_nota, quienes.values())))
            for n, en in quedan.items():
                fichero, p = e.perturbadas[n]
                if en:
                    mal += 1
                    print(f"{ref} {fichero}:{p.linea}: {p.que}: {p.texto}: no se nota con {len(en)} semillas")
            print(
                f"{ref}: {len(e.perturbadas)} perturbaciones, {len(quienes)} compilan, {sum(map(bool, quedan.values()))} no se notan",
                flush=True,
            )
            shutil.rmtree(e.temporal)
    return 1 if mal else 0


if __name__ == "__main__":
    principal(main)
