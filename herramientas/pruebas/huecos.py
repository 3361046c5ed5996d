"""huecos.py RAÍZ BUILD [--semillas N] [EJERCICIO…] [--programas]: si ./lab corrige ve toda la solución, y nada más.

Cada línea que escribe quien hace un ejercicio se perturba de varias maneras (perturba.py), todas en un binario, y con
cada semilla algún guion debe quitarle puntos, salvo lo que está en EXCEPCIONES; también a los errores conocidos
(errores/). La solución escrita de otras maneras (bien/) vale 100. De cada ejercicio escribe la nota de las buenas y
la menor y la mayor de unos errores, con todas las semillas. Con --programas, solo dice cuáles usa.
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
from ejercicios.corrige import partidas, veredicto
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.compilador import SUYA
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.orden import GUIONES
from ejercicios.corrige.partidas import Jugador
from pruebas import perturba
from pruebas.muta import no_compila_glsl

BIEN = "herramientas/ejercicios/bien"
MINIMO = 5  # soluciones y errores de cada ejercicio
POCOS = 3  # guiones al azar, al menos, con que se da la nota de una semilla o de todas
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
TRIANGULOS = "en una malla de triángulos es la misma arista, al revés en todos"
ACABA_ANTES = "el vértice que falta está en el triángulo, y ahí se deja de buscar"
UNITARIO = "la carga es de lado uno"
VERTICAL = "lo que se traslada en la vertical da lo mismo girarlo antes o después"
DENTRO = "lo que el cable tiene de más queda dentro de la carga"
SIN_INTERPOLAR = "sin interpolar, y a 15 texeles como mucho, no llega a caer en otro"
FUERA_DEL_FILTRO = "fuera de la textura del filtro se lee 0"
CERO = "cero por un número es cero"
MAS_DE_CUATRO = "siempre hay más de cuatro"
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
        "cara[(otroFactor(i) + 1) % cara.size()]": TRIANGULOS,
        "cara[(i + otroFactor(1)) % cara.size()]": TRIANGULOS,
    },
    "E2.2": {
        "r.usados.push_back(t); libre[t] = false;": ORDEN,
        "std::swap(b, a);": ORDEN,
        "triangulos[otroFactor(t)].end()": ACABA_ANTES,
        "[b, a](std::uint32_t v)": ORDEN,
        "otroFactor(v) != a": "solo se equivoca en una tira que se prueba y no es la más larga",
    },
    "E3.1": {"otroFactor(matrizNormal(M))": NORMAL, "matrizNormal(otroFactor(M))": NORMAL},
    "E3.2": {"glm::mat4(otroFactor(1))": OTRA_W, "alReves(A, A)": "los dos factores son el mismo"},
    "E3.5": {
        "LARGO_PIE - p.altura + LADO_CARGA / 2": DENTRO,
        "LARGO_PIE - p.altura - LADO_CARGA / otroFactor(2)": DENTRO,
        "LARGO_PIE - p.altura - otroFactor(LADO_CARGA) / 2": "queda un hueco de un píxel en un cable de un píxel",
        "LARGO_PIE - otroFactor(largoCable) / 2": "según dónde quede, el hueco es de un píxel o lo tapa el brazo",
        "alReves(carro, traslacion({0, LARGO_PIE - largoCable / 2, 0}))": VERTICAL,
        "alReves(carro, traslacion({0, p.altura, 0}))": VERTICAL,
        "/ escalado(LADO_CARGA)": UNITARIO,
        "alReves(traslacion({0, p.altura, 0}), escalado(LADO_CARGA))": UNITARIO,
    },
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
        "orden": ORDEN,
        'envia(programa, "N", otroFactor(matrizNormal(camara * M)));': NORMAL,
        'envia(programa, "N", matrizNormal(camara * otroFactor(M)));': NORMAL,
    },
    "E9.1": {"(colorA.a * 1.25));": "la ventana no tiene opacidad", "(colorA.a + 1));": "la ventana no tiene opacidad"},
    "E9.2": {
        " / (vec2(textureSize(imagen, 0)) + 1)": SIN_INTERPOLAR,
        " / vec2((textureSize(imagen, 0) + 1))": SIN_INTERPOLAR,
        **{f"j {mas}": FUERA_DEL_FILTRO for mas in ("<= talla.y", "< (talla.y * 1.25)", "< (talla.y + 1)")},
        **{f"i {mas}": FUERA_DEL_FILTRO for mas in ("<= talla.x", "< (talla.x * 1.25)", "< (talla.x + 1)")},
        "(vec3(0.0) * 1.25)": CERO,
        "vec3((0.0 * 1.25))": CERO,
    },
    "E9.4": {
        "(vec4(sentido * (2.0 * coordenadaTextura - 1.0), 0.0, 1.0) * 1.25)": OTRA_W,
        "sentido / (2.0 * coordenadaTextura - 1.0)": "en los vértices vale 1 o −1",
        "(0.0 * 1.25), 1.0)": "no hay test de profundidad",
        "(0.0 + 1), 1.0)": "no hay test de profundidad",
    },
    "E11.8": {"orden": ORDEN},
    "E11.7": {
        "n <= 4 ? 0 : cerrada": MAS_DE_CUATRO,
        "n < otroFactor(4)": MAS_DE_CUATRO,
        "n < 4 ? otroFactor(0)": MAS_DE_CUATRO,
    },
}
EXCEPCIONES["E4.2"] |= {
    f"centro.y + y, {z})": HONDO
    for z in (
        "centro.z - z, -centro.z + z",
        "-centro.z - otroFactor(z), -centro.z + z",
        "-centro.z - z, -otroFactor(centro.z) + z",
    )
}


def excepcion(ref, p):
    """La que dice por qué no se puede ver esa, si hay alguna: por lo que se hace o, la más larga, por cómo queda."""
    valen = (q for q in EXCEPCIONES.get(ref, {}) if q in (p.que, p.texto) or len(q) > 12 and q in p.texto)
    return max(valen, key=len, default="")


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
        return veredicto.nota(jugado, [g for g in jugado if g not in fallan], casi, otros)

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
        for i, guiones in enumerate(self.de_semilla.values()):
            jugado, faltan = dict(de_casos), max(1, POCOS // len(self.de_semilla))
            for guion in (*guiones[i % GUIONES :], *guiones[: i % GUIONES]):
                if faltan <= 0 and (not mal or self.nota(jugado) < 100):
                    break
                jugado |= self.juega(jugador, [guion])
                faltan -= 1
            notas.append(self.nota(jugado))
        return min(notas), max(notas)

    def sin_ver(self, hilos):
        """Las perturbaciones a las que no se quita nada y las excepciones que sobran: de estas se miran los casos."""
        quienes, sobran = self.jugadores(), set(EXCEPCIONES.get(self.ref, {}))

        def no_se_ve(n):
            if excepcion(self.ref, self.perturbadas[n][1]):
                return not self.quita(quienes[n], self.casos)
            return self.no_se_nota(quienes[n])

        for n, donde in zip(quienes, hilos.map(no_se_ve, quienes)):
            fichero, p = self.perturbadas[n]
            queda = excepcion(self.ref, p)
            if donde and queda:
                sobran.discard(queda)
            elif donde:
                yield f"{fichero}:{p.linea}: {p.que}: {p.texto}: no quita puntos con las semillas {donde}"
        yield from (f"sobra la excepción «{queda}»" for queda in sorted(sobran))

    def fallos(self, hilos):
        """Lo que hay que decir de él."""
        yield from self.sin_ver(hilos)
        errores = self.de_lista([m for m in self.banco.motivos.defectos if m.dice], "mal")
        for m, en in zip(errores, hilos.map(self.no_se_nota, errores.values())):
            if en:
                yield f"{m.nombre}, {m.imita}: no quita puntos con las semillas {en}"
        buenas = self.de_lista([m for m in defectos.lee(self.raiz / BIEN)[0] if m.lista == self.ref], "bien")
        for m, (nota, _) in (de_buenas := dict(zip(buenas, hilos.map(self.notas, buenas.values())))).items():
            if nota < 100:
                yield f"{m.nombre}, {m.imita}: está bien, y vale {nota}"
        algunos = list(errores.values())[:: max(1, len(errores) // MINIMO)][:MINIMO]
        de_errores = list(hilos.map(lambda j: self.notas(j, mal=True), algunos))
        if len(algunos) < MINIMO or len(buenas) < MINIMO:
            yield f"hay {len(errores)} errores y {len(buenas)} soluciones: deben ser {MINIMO}"
        print(
            f"{self.ref}: {len(self.perturbadas)} perturbaciones, {len(errores)} errores; buenas:",
            *(f"{nota:g}" for nota, _ in de_buenas.values()),
            "; errores:",
            *(f"{una:g}–{otra:g}" for una, otra in de_errores),
            flush=True,
        )


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
