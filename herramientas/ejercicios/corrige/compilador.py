"""El árbol que ve una entrega, y el programa compilado con ella dentro."""
import functools
import re
import shutil
from pathlib import Path

from base import compilacion
from base.fuentes import SHADERS
from ejercicios import nuevo
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.jaula import NO_ACABA, desempaqueta
from ejercicios.corrige.partidas import Jugador

COMPILA = {"segundos": 120, "procesador": 60, "memoria": 3 << 30, "procesos": 16}
SIN = {
    "-MD": 1,
    "-MT": 2,
    "-MF": 2,
    "-o": 2,
    "-c": 2,
    "-Werror": 1,
}  # de la orden de compilar, cuántas palabras no valen aquí


def arbol_visible(raiz, programa, ref):
    """Lo que ve una entrega del laboratorio, además de common/: cabeceras, shaders y modelos, sin los ficheros de la
    solución."""
    patrones = (
        *(f"{donde}/*{tipo}" for donde in ("common", "ch*") for tipo in (".h", *SHADERS)),
        "assets/*.vf",
        "assets/*.txt",
    )
    privados = set(nuevo.privados(raiz, programa, ref))
    rutas = [f.relative_to(raiz) for patron in patrones for f in sorted(raiz.glob(patron))]
    return [ruta for ruta in rutas if ruta not in privados]


class Compilador:
    def __init__(self, raiz, build, programa, ref, recinto):
        self.raiz, self.build, self.programa, self.recinto = raiz, build, programa, recinto
        self.visible = arbol_visible(raiz, programa, ref)
        self.solucion = Jugador("la solución", programa.ejecutable(build), [])

    def en_arbol(self, ficheros, carpeta):
        """El árbol que ve una entrega, con ella dentro. Devuelve dónde están sus fuentes."""
        for ruta in self.visible:
            (carpeta / ruta).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.raiz / ruta, carpeta / ruta)
        suya = carpeta / "mios"
        suya.mkdir()
        for nombre, contenido in ficheros.items():
            (suya / nombre).write_bytes(contenido if isinstance(contenido, bytes) else contenido.encode())
        return suya

    @functools.cached_property
    def opciones(self):
        """Con qué palabras se compila el programa del ejercicio, sin sus ficheros."""
        palabras = iter(compilacion.compila(self.build, self.raiz / self.programa.fuente))
        quedan = []
        for palabra in palabras:
            if palabra not in SIN:
                quedan.append(palabra)
            for _ in range(SIN.get(palabra, 1) - 1):
                next(palabras)
        return quedan

    @functools.cached_property
    def bibliotecas(self):
        """Con cuáles se enlaza; las de BUILD, con su ruta."""
        palabras = compilacion.enlaza(self.build, self.solucion.programa)
        tras_el_nombre = palabras[palabras.index("-o") + 2 :]
        return [
            str(self.build / p) if (self.build / p).is_file() and not p.startswith("/") else p
            for p in tras_el_nombre
            if not p.endswith(".o")
        ]

    @functools.cached_property
    def ve(self):
        """Lo que de BUILD hace falta para compilarlo y para jugarlo."""
        rutas = [p for p in self.bibliotecas if p.startswith(str(self.build))] + [self.build / "assets"]
        if "-include" in self.opciones:
            rutas.append(Path(self.opciones[self.opciones.index("-include") + 1]).parent)
        return list(dict.fromkeys(map(str, rutas)))

    def compila(self, ficheros, carpeta, ajena=True):
        """El programa de esos ficheros, compilado en esa carpeta. Si no compila, Rechazo con el primer error."""
        carpeta.mkdir(exist_ok=True)
        arbol = carpeta / "fuentes"
        suya = self.en_arbol(ficheros, arbol)
        raiz = re.compile(re.escape(str(self.raiz)) + r"(?=$|/(?!build))")  # la de los fuentes, no la de BUILD
        orden = [
            raiz.sub(str(arbol), p) if p.startswith("-I") and not p[2:].startswith(str(self.build)) else p
            for p in self.opciones
        ]
        orden += ["-w", "-fdiagnostics-color=never", "-I", suya, "-I", arbol / self.programa.capitulo.nombre]
        orden += [suya / nombre for nombre in ficheros if nombre.endswith(".cpp")]
        orden += ["-o", "programa", *self.bibliotecas]
        hecho = desempaqueta(
            self.recinto.ajeno(orden, COMPILA, [carpeta, *self.ve]) if ajena else self.recinto.propio(orden, COMPILA)
        )
        if hecho.get("estado", b"").strip() != b"0":
            raise Rechazo(primer_error(hecho, suya), hecho.get("errores", b"").decode(errors="replace"))
        ejecutable = carpeta / self.programa.nombre
        ejecutable.write_bytes(hecho["programa"])
        ejecutable.chmod(0o755)
        return Jugador("la entrega", ejecutable, [suya, arbol], ajeno=ajena)


def primer_error(hecho, suya):
    """Lo primero de lo que se queja el compilador, sin la ruta de la carpeta en que compila."""
    if int(hecho.get("estado", b"").strip() or -1) in NO_ACABA:
        return f"no compila: el compilador no acaba en {COMPILA['procesador']} s"
    errores = (
        hecho.get("errores", b"")[: 1 << 20]
        .decode(errors="replace")
        .replace(f"{suya}/", "")
        .replace(f"{suya.parent}/", "")
    )
    if error := re.search(r"^([^:\n]+):(\d+):(?:\d+:)? (?:fatal )?error: (.*)$", errores, re.M):
        return f"no compila: {error[1]}:{error[2]}: {error[3]}"
    if falta := re.search(r"undefined reference to [`'](.*)'", errores):
        return f"no compila: falta «{falta[1]}»"
    return "no compila: " + (next(iter(errores.strip().splitlines()[-1:]), "") or "el compilador no ha acabado bien")
