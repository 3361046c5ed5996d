"""huecos.py RAÍZ BUILD [--semillas N] [EJERCICIO…] [--programas]: si ./lab corrige ve toda la solución, y nada más.

Cada línea que escribe quien hace un ejercicio se perturba de varias maneras (perturba.py), todas en un binario, y con
cada semilla algún guion debe quitarle puntos, salvo lo que está en EXCEPCIONES; también a los errores conocidos
(errores/). La solución escrita de otras maneras (bien/) vale 100. Con --programas, solo dice cuáles usa.
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
from ejercicios.corrige.compilador import SUYA
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.orden import GUIONES
from ejercicios.corrige.partidas import Jugador
from pruebas import perturba
from pruebas.muta import no_compila_glsl

BIEN = "herramientas/ejercicios/bien"
MINIMO = 5  # soluciones y errores de cada ejercicio
BUENAS = 3  # guiones al azar de cada semilla que juegan las buenas
VUELTAS = 6  # de quitar lo que no compila
# Por qué no se ve lo que queda así.
OTRA_W = "toda la posición homogénea por un número es el mismo punto"
NORMAL = "la normal se normaliza después, y las caras son paralelas a los ejes"
ORDEN = "da lo mismo en qué orden"
HONDO = "lo hondo que es el volumen de la vista no se ve, si cabe la grúa"
HACIA = "de la posición de la cámara solo cuenta hacia dónde está"
ARRIBA = "de lo que queda arriba solo cuenta el plano en que está con la cámara"
ROTULO = "es del rótulo, que no se pide"
DISTINTOS = "los dos vértices de una arista no son el mismo"
SIGNO = "del volumen solo se usa el signo"
EXCEPCIONES = {
    "E2.1": {
        "push_back({c, p <= q})": DISTINTOS,
        "push_back({c, p < otroFactor(q)})": DISTINTOS,
        "volumen += otroFactor(": SIGNO,
        "componente.giros[k] / glm::dot": SIGNO,
        "componente.giros[otroFactor(k)]": SIGNO,
        "* otroFactor(glm::dot": SIGNO,
        "glm::dot(otroFactor(a)": SIGNO,
        "glm::dot(a, otroFactor(": SIGNO,
        "glm::cross(otroFactor(b), d)": SIGNO,
        "glm::cross(b, otroFactor(d))": SIGNO,
    },
    "E3.1": {"otroFactor(matrizNormal(M))": NORMAL, "matrizNormal(otroFactor(M))": NORMAL},
    "E3.2": {"glm::mat4(otroFactor(1))": OTRA_W, "alReves(A, A)": "los dos factores son el mismo"},
    "E4.2": {
        "otroFactor(DISTANCIA_CAMARA)": HACIA,
        "otroFactor(glm::dvec3(DISTANCIA_CAMARA / glm::root_three<double>()))": HACIA,
        "glm::dvec3(otroFactor(DISTANCIA_CAMARA) / glm::root_three<double>())": HACIA,
        "glm::dvec3(DISTANCIA_CAMARA * glm::root_three<double>())": HACIA,
        "otroFactor(0)": ARRIBA,
        "otroFactor(1)": ARRIBA,
        "-otroFactor(1)": ARRIBA,
        "otroFactor(COLOR_EJE[1])": ROTULO,
        "COLOR_EJE[otroFactor(1)]": ROTULO,
        "otroFactor(COLOR_EJE[0])": ROTULO,
        "COLOR_EJE[otroFactor(0)]": ROTULO,
        "otroFactor(OSCURO)": ROTULO,
        "otroFactor(0.5) * HOLGURA * (caja.maximo.z - caja.minimo.z)": HONDO,
        "0.5 * otroFactor(HOLGURA) * (caja.maximo.z - caja.minimo.z)": HONDO,
        "0.5 * HOLGURA * (caja.maximo.z - otroFactor(caja.minimo.z))": HONDO,
    },
    "E5.1": {
        'envia(programa, "N", otroFactor(matrizNormal(camara * M)));': NORMAL,
        'envia(programa, "N", matrizNormal(camara * otroFactor(M)));': NORMAL,
    },
    "E9.1": {"(colorA.a * 1.25));": "la ventana no tiene opacidad", "(colorA.a + 1));": "la ventana no tiene opacidad"},
    "E9.4": {
        "(vec4(sentido * (2.0 * coordenadaTextura - 1.0), 0.0, 1.0) * 1.25)": OTRA_W,
        "sentido / (2.0 * coordenadaTextura - 1.0)": "en los vértices vale 1 o −1",
        "(0.0 * 1.25), 1.0)": "no hay test de profundidad",
        "(0.0 + 1), 1.0)": "no hay test de profundidad",
    },
    "E11.7": {"n <= 4": "siempre hay más de cuatro", "n < otroFactor(4)": "siempre hay más de cuatro"},
}
EXCEPCIONES["E4.2"] |= {
    f"centro.y + y, {z})": HONDO
    for z in (
        "centro.z - z, -centro.z + z",
        "-centro.z - otroFactor(z), -centro.z + z",
        "-centro.z - z, -otroFactor(centro.z) + z",
    )
}
EXCEPCIONES["E11.7"] |= {"n < 4 ? otroFactor(0)": "siempre hay más de cuatro"}


def excepcion(ref, p):
    """Por qué no se puede ver, si se dice."""
    if p.que == "orden" and ref in ("E5.1", "E11.8"):
        return ORDEN
    return next(
        (
            porque
            for queda, porque in EXCEPCIONES.get(ref, {}).items()
            if p.texto == queda or len(queda) > 12 and queda in p.texto
        ),
        "",
    )


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
                ruta = self.temporal / f"glsl{n}" / self.programa.capitulo.nombre / fichero
                ruta.parent.mkdir(parents=True)
                ruta.write_text(self.estropeado(fichero, p))
                hechos[n] = Jugador(str(n), self.solucion.programa, [self.temporal / f"glsl{n}"])
        return hechos

    def de_lista(self, mutantes, como):
        """Quien juega cada uno de esos cambios."""
        textos, hechos = self.textos, {}
        nombra = {f"{self.programa.capitulo.nombre}/{f}": f for f in textos}
        con = dict(textos)
        for ruta, suyos in defectos.por_fichero([m for m in mutantes if m.fichero in nombra]).items():
            texto = textos[nombra[ruta]]
            if suyos[0].en_shader:
                for m in suyos:
                    fichero = self.temporal / f"{como}{m.numero}" / ruta
                    fichero.parent.mkdir(parents=True)
                    fichero.write_text(defectos.estropea(texto, m))
                    hechos[m] = Jugador(m.nombre, self.solucion.programa, [self.temporal / f"{como}{m.numero}"])
                continue
            con[nombra[ruta]] = f'#include "{self.raiz / defectos.MUTANTE_H}"\n{defectos.cambia(texto, suyos)}'
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
                return carpeta / self.programa.nombre, [carpeta / "fuentes" / SUYA, carpeta / "fuentes"]
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
        esperada = self.banco.arbitro.juega(self.solucion, guion)
        datos = self.banco.arbitro.juega_de_nuevo(jugador, guion, 10 + 4 * esperada.segundos)
        obtenida = partidas.Partida.lee(datos, guion)
        return self.banco.arbitro.difiere(esperada, obtenida) is not None or bool(aparte(esperada, obtenida))

    def no_se_nota(self, jugador):
        """Las semillas con que no pierde nada."""
        if any(self.quita(jugador, g) for g in self.casos):
            return []
        return [s for s, guiones in self.de_semilla.items() if not any(self.quita(jugador, g) for g in guiones)]

    def no_vale(self, jugador):
        """Los guiones en que pierde algo."""
        todos = [*self.casos, *(g for guiones in self.de_semilla.values() for g in guiones[:BUENAS])]
        return [g.nombre for g in todos if self.quita(jugador, g)]

    def fallos(self, hilos):
        """Lo que hay que decir de él."""
        quienes = self.jugadores()
        for n, en in zip(quienes, hilos.map(self.no_se_nota, quienes.values())):
            fichero, p = self.perturbadas[n]
            porque = excepcion(self.ref, p)
            if en and not porque:
                yield f"{fichero}:{p.linea}: {p.que}: {p.texto}: no quita puntos con las semillas {en}"
        conocidos = self.de_lista([m for m in self.banco.motivos.defectos if m.dice], "mal")
        for m, en in zip(conocidos, hilos.map(self.no_se_nota, conocidos.values())):
            if en:
                yield f"{m.nombre}, {m.imita}: no quita puntos con las semillas {en}"
        buenas = self.de_lista([m for m in defectos.lee(self.raiz / BIEN)[0] if m.lista == self.ref], "bien")
        for m, en in zip(buenas, hilos.map(self.no_vale, buenas.values())):
            if en:
                yield f"{m.nombre}, {m.imita}: está bien, y pierde puntos en {', '.join(en)}"
        if len(conocidos) < MINIMO or len(buenas) < MINIMO:
            yield f"hay {len(conocidos)} errores y {len(buenas)} soluciones: deben ser {MINIMO}"
        print(f"{self.ref}: {len(quienes)} perturbaciones, {len(conocidos)} errores, {len(buenas)} buenas", flush=True)


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    resto = sys.argv[3:]
    semillas = 1
    if resto[:1] == ["--semillas"]:
        semillas, resto = int(resto[1]), resto[2:]
    hay = nuevo.ejercicios(raiz, catalogo.lee_programas(build))
    if resto[-1:] == ["--programas"]:
        return print(*dict.fromkeys(hay[ref].nombre for ref in resto[:-1] or hay))
    fallos = []
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
        for ref in resto or hay:
            ejercicio = Ejercicio(raiz, build, ref, hay[ref], Path(temporal), range(1, semillas + 1))
            suyos = [f"{ref} {fallo}" for fallo in ejercicio.fallos(hilos)]
            print(*suyos, sep="\n", end="\n" if suyos else "", flush=True)
            fallos += suyos
            shutil.rmtree(ejercicio.temporal)
    if fallos:
        raise Fallo(f"huecos: {len(fallos)} que no deben")


if __name__ == "__main__":
    principal(main)
