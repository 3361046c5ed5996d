"""huecos.py RAÍZ BUILD [--semillas N] [EJERCICIO…] [--programas]: si ./lab corrige ve toda la solución, y nada más.

Cada línea que escribe quien hace un ejercicio se perturba de varias maneras (perturba.py), todas en un binario, y con
cada semilla algún guion debe quitarle puntos, salvo lo que está en EXCEPCIONES; también a los errores conocidos
(errores/). La solución escrita de otras maneras (bien/) vale 100. De cada ejercicio escribe la nota de las buenas y
la menor y la mayor de unos errores, con todas las semillas. Los de la página (L5.1) no tienen semillas: son los casos
y los gestos de ella. Con --programas, solo dice cuáles usa.
"""
import os
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, defectos
from base.procesos import Fallo, principal
from ejercicios import ensayo, nuevo
from ejercicios.corrige import shaders
from ejercicios.corrige.motivos import ruta
from pruebas.muta import no_compila_glsl

BIEN = "herramientas/ejercicios/bien"
MINIMO = 5  # soluciones y errores de cada ejercicio
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
OPACO = "la ventana no tiene opacidad"
SATURA = "más de 1 se dibuja como 1"
UNITARIA = "la normal se hace unitaria después"
APLASTADA = "lo de una cara aplastada no se pide, y aquí no las hay"
REPITE = "la textura se repite"
DIRECCION = "del mapa solo se usa la dirección"
BORDE = "ningún píxel cae justo ahí"
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
    "E9.1": {"(colorA.a * 1.25));": OPACO, "(colorA.a + 1));": OPACO},
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
    "L1.2": {
        "(vec4(1.0, 0.0, 0.0, 1.0) * 1.25)": SATURA,
        "vec4((1.0 * 1.25), 0.0": SATURA,
        "vec4((1.0 + 1), 0.0": SATURA,
        "vec4(1.0, (0.0 * 1.25)": CERO,
        "0.0, (0.0 * 1.25), 1.0)": CERO,
        "0.0, (1.0 * 1.25))": OPACO,
        "0.0, (1.0 + 1))": OPACO,
    },
    "L3.1": {
        "(N * 1.25) * vNormal": UNITARIA,
        "N * (vNormal * 1.25)": UNITARIA,
        "normalize((n * 1.25))": UNITARIA,
        "dot((n * 1.25), n)": APLASTADA,
        "dot(n, (n * 1.25))": APLASTADA,
        "(dot(n, n) * 1.25)": APLASTADA,
        "(dot(n, n) + 1) > 0.0": APLASTADA,
        "dot(n, n) >= 0.0": APLASTADA,
        "> (0.0 * 1.25) ?": APLASTADA,
        "(vec3(0.0) * 1.25)": APLASTADA,
        "(vec3(0.0) + 1)": APLASTADA,
        ": vec3((0.0 * 1.25))": APLASTADA,
        ": vec3((0.0 + 1))": APLASTADA,
        "(proyeccion * 1.25) *": OTRA_W,
        "(camara * 1.25) * M": OTRA_W,
        "(M * 1.25) * vec4": OTRA_W,
        "(vec4(posicion, 1.0) * 1.25)": OTRA_W,
    },
    "L5.1": {"NdotL >= 0.0": CERO, "(NdotL * 1.25) > 0.0": CERO, "NdotL > (0.0 * 1.25)": CERO},
    "L5.2": {"(N * 1.25) * vNormal": UNITARIA, "N * (vNormal * 1.25)": UNITARIA},
    "L5.3": {
        "ecPosicion, (normal * 1.25)": UNITARIA,
        "unitario((N * 1.25) * vNormal)": UNITARIA,
        "unitario(N * (vNormal * 1.25))": UNITARIA,
        "(unitario(N * vNormal) * 1.25)": UNITARIA,
        "normal), (1.0 * 1.25)": OPACO,
        "normal), (1.0 + 1)": OPACO,
    },
    "L6.3": {"(nuevaCoordTextura + 1)": REPITE},
    "L8.1": {
        "(reflexion * 1.25)": DIRECCION,
        "(reflect(haciaPunto, normalize(normal)) * 1.25)": DIRECCION,
        "reflect((haciaPunto * 1.25)": DIRECCION,
        "normalize((normal * 1.25))": UNITARIA,
        "(reflect(haciaPunto, normal) * 1.25)": DIRECCION,
    },
    "L8.3": {
        "(nuevaCoordTextura.s + 1)": REPITE,
        "(nuevaCoordTextura.t + 1)": REPITE,
        "s >= talla.s &&": BORDE,
        "talla.s && t >= talla.t": BORDE,
    },
    "L8.4": {"texture(ruido, (p + 1))": REPITE},
    "L9.3": {
        "i <= tallaFiltro": "más allá del filtro se lee 0",
        "i < (tallaFiltro + 1)": "más allá del filtro se lee 0",
        "coordenadaTextura - desplazamiento[i]": "los filtros son simétricos",
        "(0.0 * 1.25), 1.0)": CERO,
    },
    "L12.1": {
        "(coordTextura + 1) * S1": REPITE,
        "(tiempo + 1)).rgb": REPITE,
        "coordTextura / S1": "S1 es 1",
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


class Ejercicio(ensayo.Ensayo):
    @property
    def de_shaders(self):
        return nuevo.es_de_shaders(self.ref)

    def con_shader(self, sitio, fichero, texto):
        """De uno de la página, con los demás y en su sitio: el programa puede no usar common/."""
        if not self.de_shaders:
            return super().con_shader(sitio, fichero, texto)
        return self.banco.compilador.compila(
            self.banco.motivos.limpio({**self.textos, fichero: texto}), sitio, ajena=False
        )

    def vale_glsl(self, fichero, p):
        if len(p.cambios) > 1:
            return False
        return not no_compila_glsl(self.raiz, ruta(self.programa, fichero), self.estropeado(fichero, p))

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
        if len(algunos) < MINIMO and not self.de_shaders or len(buenas) < MINIMO:
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
    programas = catalogo.lee_programas(build)
    hay = nuevo.ejercicios(raiz, programas) | shaders.ejercicios(raiz, programas)
    if resto[-1:] == ["--programas"]:
        return print(*dict.fromkeys(hay[ref].nombre for ref in resto[:-1] or hay))
    fallos = []
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
        for ref in resto or hay:
            reglas = shaders.REGLAS if nuevo.es_de_shaders(ref) else None
            ejercicio = Ejercicio(raiz, build, ref, hay[ref], Path(temporal), range(1, semillas + 1), reglas)
            suyos = [f"{ref} {fallo}" for fallo in ejercicio.fallos(hilos)]
            print(*suyos, sep="\n", end="\n" if suyos else "", flush=True)
            fallos += suyos
            shutil.rmtree(ejercicio.temporal)
    if fallos:
        raise Fallo(f"huecos: {len(fallos)} que no deben")


if __name__ == "__main__":
    principal(main)
