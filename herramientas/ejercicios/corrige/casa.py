"""Corregir en casa: lo que juega la solución de un ejercicio de quien enseña, grabado, va con lo que se reparte, y
donde no está ella se compara con eso. No lleva nada de su texto."""
import functools
import json
import lzma
import os
import re
import tempfile
from dataclasses import asdict, replace
from pathlib import Path
from types import SimpleNamespace

from base import catalogo, procesos
from base.procesos import Fallo, ejecuta, en_png, escribe
from ejercicios import nuevo, propios, reglas
from ejercicios.corrige.arbitro import Arbitro, suma
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.compilador import Compilador
from ejercicios.corrige.partidas import Guion, Jugador, Partida

ESPERADO, GRABADAS = "esperado", "partidas.datos"
SIN_SOLUCION = "aquí no está la solución: las piezas y los errores conocidos los mira quien enseña"


# --- quien lo reparte -----------------------------------------------------------------------------------------------


def graba(raiz, build, ref, programa, carpeta):
    """Deja ahí, en esperado/, la imagen de cada caso y lo que juega la solución en los casos y con cada semilla."""
    hay, imagenes, suyas = {}, {}, reglas.del_programa(programa)
    entorno = {**os.environ, **procesos.entorno(), "LAB_RAIZ": f"{programa.carpeta}:{build}"}
    with tempfile.TemporaryDirectory() as temporal:
        de_esta = replace(suyas, guiones=0) if suyas.semillas == "ninguna" else suyas
        for semilla in re.findall(r"\d+", suyas.semillas) or ["1"]:
            (sitio := Path(temporal, semilla)).mkdir()
            banco = Banco(raiz, build, ref, programa, sitio, None, semilla, de_esta)
            hay[semilla] = [
                de_guion(g, banco.arbitro.juega(banco.compilador.solucion, g), imagenes) for g in banco.todos
            ]
        for caso in programa.casos:
            ve = ["-geometry", "{}x{}".format(*propios.VENTANA), "-ppm", f"{temporal}/caso.ppm"]
            ejecuta([programa.ejecutable(build), *ve, "-guion", caso.guion], env=entorno)
            escribe(carpeta / ESPERADO / nuevo.imagen_de(caso), en_png(f"{temporal}/caso.ppm", 9))
    if (fichero := programa.carpeta / reglas.FICHERO).exists():
        escribe(carpeta / ESPERADO / reglas.FICHERO, propios.lee_texto(fichero))
    datos = {"titulo": programa.titulo, "principal": programa.fuente.name, "partida": banco.de_partida[0]}
    datos |= {"casos": [(c.nombre, c.titulo, c.guion) for c in programa.casos], "semillas": hay}
    datos["tallas"] = [imagen[:2] for imagen in imagenes]
    junto = json.dumps(datos, ensure_ascii=False).encode() + b"\n" + b"".join(pixeles for *_, pixeles in imagenes)
    escribe(carpeta / ESPERADO / GRABADAS, lzma.compress(junto, preset=9))


def de_guion(guion, partida, imagenes):
    """Los dos, con el número de cada imagen, que muchas son la misma."""
    cuales = [imagenes.setdefault(imagen, len(imagenes)) for imagen in partida.imagenes]
    return {**asdict(guion), "partida": {**vars(partida), "imagenes": cuales}}


# --- y quien lo hace ------------------------------------------------------------------------------------------------


def lo_repartido(carpeta, programas):
    """El ejercicio de esa carpeta, su programa y lo grabado, si es de quien enseña y aquí no está la solución."""
    dicho = (carpeta / nuevo.EJERCICIO).read_text(errors="replace") if (carpeta / nuevo.EJERCICIO).is_file() else ""
    es_de = re.match(r"([a-z0-9_]+) ejercicios/\1/\1\n", dicho)
    if not es_de or any(p.nombre == es_de[1] for p in programas):
        return None
    nombre, esperado = es_de[1], carpeta / ESPERADO
    if not (esperado / GRABADAS).is_file():
        falta = f"ni la carpeta {ESPERADO}/ con la que se compara, que da quien enseña con el ejercicio"
        raise Fallo(f"aquí no está la solución de {nombre}, {falta}: pídesela y ponla en {carpeta}")
    try:
        cabeza, _, pixeles = lzma.decompress((esperado / GRABADAS).read_bytes()).partition(b"\n")
        datos = json.loads(cabeza)
        datos["imagenes"] = list(corta(pixeles, datos["tallas"]))
    except (lzma.LZMAError, ValueError, KeyError, TypeError):
        raise Fallo(f"{esperado / GRABADAS} está estropeado: pídeselo otra vez a quien enseña") from None
    programa = propios.Propio(catalogo.Capitulo(f"ejercicios/{nombre}", ""), nombre, nombre, datos["titulo"])
    programa.carpeta = esperado
    programa.casos = [catalogo.Caso(programa, n, nombre, titulo, guion) for n, titulo, guion in datos["casos"]]
    return nombre, programa, datos


def corta(pixeles, tallas):
    desde = 0
    for ancho, alto in tallas:
        yield ancho, alto, pixeles[desde : (desde := desde + 3 * ancho * alto)]


class DeOtro(Compilador):
    """Como el de un programa del laboratorio: el de la solución no está."""

    def __init__(self, raiz, build, programa, ref, recinto, otro):
        super().__init__(raiz, build, otro, ref, recinto)
        _ = self.opciones, self.bibliotecas  # se quedan las suyas
        self.programa, self.solucion = programa, Jugador("la solución", None, [])


class ArbitroDeCasa(Arbitro):
    def juega(self, jugador, guion, esperada=None):
        return super().juega(jugador, guion, esperada) if jugador.ajeno else self.grabadas[guion]


class BancoDeCasa(Banco):
    """El de un ejercicio del que solo está lo grabado: sin piezas, ni errores conocidos, ni dónde se aparta."""

    sin_solucion = SIN_SOLUCION

    def __init__(self, raiz, build, que, temporal, jaula, semilla, puntua, otro):
        self.ref, self.programa, datos = que
        grabado = datos["semillas"]
        self.semilla = semilla if semilla in grabado else next(iter(grabado))
        if semilla not in grabado and semilla != "1":
            raise Fallo(f"aquí no están los guiones de la semilla {semilla}: solo {', '.join(grabado)}")
        self.raiz, self.temporal, self.privados, self.piezas = raiz, temporal, set(), {}
        recinto = self.recinto(jaula)
        self.compilador = DeOtro(raiz, build, self.programa, self.ref, recinto, otro)
        self.arbitro = ArbitroDeCasa(build, self.compilador, recinto, temporal, puntua.tolerancia)
        self.arbitro.grabadas, al_azar = {}, 0
        for g in grabado[self.semilla]:
            guion = Guion(g["nombre"], tuple(g["ordenes"]), g["caso"], g.get("suyas", len(g["ordenes"])))
            al_azar += not guion.caso
            if puntua.peso(guion) and (guion.caso or al_azar <= puntua.guiones):
                imagenes = [datos["imagenes"][i] for i in g["partida"]["imagenes"]]
                self.arbitro.grabadas[guion] = Partida(**{**g["partida"], "imagenes": imagenes})
        self.todos = [*self.arbitro.grabadas]
        de_aqui = replace(puntua, guiones=sum(not g.caso for g in self.todos), huecos=0)
        self.reglas = reglas.comprueba(de_aqui, "lo repartido")
        self.de_partida, self.dados = (datos["partida"], datos["principal"]), (datos["partida"], {})
        self.clave = suma(repr(datos["semillas"]), *(i[2] for i in datos["imagenes"]))
        self.motivos = SimpleNamespace(por_que=lambda *_: [], trozos=lambda: [])
        self.__dict__["donde"] = SimpleNamespace(busca=lambda *_: None)

    @functools.cache
    def sin_hacer(self):
        return self.compilador.compila(self.de_partida[0], self.temporal / "de_partida")
