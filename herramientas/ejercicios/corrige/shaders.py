"""Los ejercicios de la página (L5.1): se entrega un shader suelto y no un programa, y se juzga como en ella, con los
mismos casos y, en cada uno, los mismos gestos (web/ejercicio.mjs). Lo entregado tampoco es de fiar: lo compila
OpenGL, y se juega en la jaula."""
import shutil

from base import controles
from ejercicios import nuevo
from ejercicios.corrige import partidas
from ejercicios.corrige.compilador import Compilador
from ejercicios.corrige.motivos import Motivos, nombre_de, nombres
from ejercicios.corrige.partidas import Jugador
from ejercicios.reglas import Reglas

GIRA = "boton IZQUIERDO abajo 10 90", "arrastra 330 90", "boton IZQUIERDO arriba 330 90"
REGLAS = Reglas(guiones=0)  # los de la página bastan
CON_RATON = {"raton", "rueda", "arrastre"}


def ejercicios(raiz, programas):
    """El primer programa que tiene marcado cada uno."""
    hay = {}
    for p in programas:
        for r in p.referencias:
            if nuevo.es_de_shaders(r) and r not in hay and not p.consola and nuevo.privados(raiz, p, r):
                hay[r] = p
    return hay


def reglas(referencia):
    """Cómo se puntúa, si no se dice."""
    return REGLAS if nuevo.es_de_shaders(referencia) else Reglas()


def guiones(raiz, build, programa, entorno):
    """En cada caso, lo que se hace en la página: la cámara al otro lado y cada tecla."""
    suyos = [c for c in controles.lee(raiz, programa) if c.teclas != ["Esc"]]
    teclas = [o for c in suyos for o in c.ordenes]
    rasgos = {r for hecho in ("", "; ".join(teclas)) for r in controles.atiende(build, programa, hecho, **entorno)[0]}
    return partidas.de_los_casos(programa, (*(GIRA if rasgos & CON_RATON else ()), *teclas))


class DeShaders(Compilador):
    """El programa es el de la solución, que los busca en un árbol con los de la entrega."""

    def compila(self, ficheros, carpeta, ajena=True, intentos=()):
        carpeta.mkdir(exist_ok=True, parents=True)
        arbol = carpeta / "fuentes"
        self.en_arbol({}, arbol)
        for ruta in self.privados:
            contenido = ficheros[str(ruta)]
            (arbol / ruta).write_bytes(contenido if isinstance(contenido, bytes) else contenido.encode())
        # shader_basico, que no usa common/, los busca junto a la carpeta en que está
        ejecutable = arbol / "programa" / self.programa.nombre
        ejecutable.parent.mkdir()
        shutil.copy(self.solucion.programa, ejecutable)
        return Jugador("la entrega", ejecutable, [arbol], ajeno=ajena)

    def avisos(self, ficheros, jugador):
        return []

    def linea_en_que_cae(self, *_):
        return ""


class MotivosDeShaders(Motivos):
    def planta(self, suyos, sitio, **_):
        for m in suyos:
            self.planta_en_shaders(sitio, m)

    def planta_en_shaders(self, sitio, *suyos):
        self.compilador.compila(self.limpio(self.estropeados(*suyos)), sitio / nombre_de(suyos), ajena=False)

    def en(self, sitio, carpeta):
        return sitio / carpeta / "fuentes/programa"

    def con_defecto(self, m, sitio, *mas):
        return self.jugador(nombres((m, *mas)), sitio, nombre_de((m, *mas)))
