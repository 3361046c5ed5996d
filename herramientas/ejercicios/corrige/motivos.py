"""Por qué falla una entrega: qué defecto conocido, plantado en la solución, deja en todos los guiones lo mismo; qué
no responde; cómo acaba."""
import shutil
import tempfile
import threading
from pathlib import Path

from base import defectos, marcas
from base.guiones import sin_veces
from base.procesos import Fallo, escribe
from ejercicios import nuevo, propios
from ejercicios.corrige.compilador import SUYA
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.partidas import Jugador

ERRORES = "herramientas/ejercicios/errores"
SENALES = {
    132: "instrucción ilegal",
    134: "abort",
    135: "memoria mal alineada",
    136: "división por cero",
    139: "acceso a memoria que no es suya",
}


def conocidos(raiz, programa, ref):
    """Los defectos que se conocen de los ficheros que tiene quien hace el ejercicio, salvo en lo que pide otro. Los de
    uno propio están en su carpeta, y no los ha mirado nadie."""
    donde = programa.carpeta / propios.ERRORES if programa.raices else raiz / ERRORES
    textos = {ruta(programa, f): texto for f, texto in nuevo.textos(raiz, programa, ref).items()}
    ajenos = {
        f: [t.span() for t in marcas.TROZO.finditer(texto) if t["codigo"] != ref and nuevo.es_del_libro(t["codigo"])]
        for f, texto in textos.items()
    }

    def es_de_otro(m):
        sitio = m.sitio(textos[m.fichero])[0]
        return any(desde <= sitio < hasta for desde, hasta in ajenos[m.fichero])

    suyos, fallos = defectos.lee_lista(donde) if programa.raices else (defectos.lee(donde)[0], [])
    if programa.raices:
        fallos += [f"{m.nombre}: no hay ningún «{m.fichero}»" for m in suyos if m.fichero not in textos]
    try:
        if fallos:
            raise ValueError(fallos[0])
        suyos = [m for m in suyos if m.fichero in textos and not es_de_otro(m)]
        for fichero, de_el in defectos.por_fichero(suyos).items():
            if not de_el[0].en_shader:
                defectos.cambia(textos[fichero], de_el)
        return suyos
    except ValueError as error:
        raise Fallo(f"{donde}: {error}") from None


def ruta(programa, fichero):
    """Cómo lo llama la lista de sus errores."""
    return fichero if programa.raices or "/" in fichero else f"{programa.carpeta}/{fichero}"


class Motivos:
    """El esqueleto y la solución con cada defecto, que juegan como una entrega. Se compilan cuando hacen falta."""

    def __init__(self, raiz, programa, ref, compilador, arbitro):
        self.raiz, self.programa, self.ref, self.compilador, self.arbitro = raiz, programa, ref, compilador, arbitro
        self.defectos = conocidos(raiz, programa, ref)
        self.turno, self.hechas = threading.Lock(), None

    def textos(self):
        return nuevo.textos(self.raiz, self.programa, self.ref)

    def limpio(self, textos):
        """Los ficheros de quien hace el ejercicio, sin las marcas, con esos textos."""
        return nuevo.sin_marcas(textos, self.programa, self.ref)

    def huecos(self):
        """De cada cosa que pide el ejercicio, si son varias: qué es, y los ficheros con todo menos eso."""
        textos = self.textos()
        trozos = [(f, t) for f in textos for t in marcas.TROZO.finditer(textos[f]) if t["codigo"] == self.ref]

        def sin(f, t):
            return {**textos, f: textos[f][: t.start()] + marcas.esqueleto(t[0]) + textos[f][t.end() :]}

        return [(t["pide"], sin(f, t)) for f, t in trozos if len(trozos) > 1]

    def variantes(self):
        """(qué se le diría a quien la entregara, Jugador): el esqueleto y la solución con cada defecto, todos en un
        binario."""
        with self.turno:
            if self.hechas is None:
                try:
                    self.hechas = self.enumera(self.compiladas())
                except (ValueError, Rechazo) as error:
                    raise Fallo(f"los defectos plantados de {self.ref} no valen: {error}") from None
        return self.hechas

    def compiladas(self):
        """Dónde están."""
        sitio = self.arbitro.cache / "variantes"
        if not sitio.is_dir():
            parcial = Path(tempfile.mkdtemp(dir=self.arbitro.cache))
            self.compila(parcial)
            try:
                parcial.replace(sitio)
            except OSError:  # otro lo ha hecho mientras
                shutil.rmtree(parcial)
        return sitio

    def compila(self, sitio):
        esqueleto = nuevo.esqueleto(self.raiz, self.programa, self.ref)
        self.compilador.compila(esqueleto, sitio / "esqueleto", ajena=False)
        for i, (_, con_hueco) in enumerate(self.huecos()):
            try:
                self.compilador.compila(self.limpio(con_hueco), sitio / f"hueco{i}", ajena=False)
            except Rechazo:  # lo demás lo necesita
                shutil.rmtree(sitio / f"hueco{i}")
        self.planta(self.defectos, sitio)

    def planta(self, suyos, sitio, marca="", antes=""):
        """Deja ahí la solución con esos defectos: los de C++, en un binario, con esa MARCA; de cada shader, el
        estropeado."""
        textos = self.textos()
        for fichero, de_el in defectos.por_fichero(suyos).items():
            nombre = Path(fichero).name
            fuente = textos[nombre]
            if not de_el[0].en_shader:
                cambiado = defectos.cambia(fuente, de_el, marca)
                textos[nombre] = f'{antes}#include "{self.raiz / defectos.MUTANTE_H}"\n{cambiado}'
                continue
            for m in de_el:
                estropeado = {**textos, nombre: defectos.estropea(fuente, m)}
                escribe(sitio / str(m.numero) / nombre, self.limpio(estropeado)[nombre])
        self.compilador.compila(self.limpio(textos), sitio / "mutantes", ajena=False)

    def enumera(self, sitio):
        variantes = [("", self.jugador("esqueleto", sitio, "esqueleto"))]
        for i, (pide, _) in enumerate(self.huecos()):
            if (sitio / f"hueco{i}").is_dir():
                variantes.append((f"parece que falta: {pide}", self.jugador(f"hueco{i}", sitio, f"hueco{i}")))
        for m in self.defectos:
            dice = f"parece que {m.dice}" if m.dice else f"parece este error: {m.imita}"
            variantes.append((dice, self.con_defecto(m, sitio)))
        return variantes

    def jugador(self, nombre, sitio, carpeta, *antes, **entorno):
        raices = [*antes, sitio / carpeta / "fuentes" / SUYA, sitio / carpeta / "fuentes"]
        return Jugador(nombre, self.en(sitio, carpeta) / self.programa.nombre, raices, entorno)

    def en(self, sitio, carpeta):
        """Dónde está compilada cada una."""
        return sitio / carpeta

    def con_defecto(self, m, sitio):
        """Si es de un shader, en su carpeta está el estropeado; si no, no hay nada."""
        return self.jugador(m.nombre, sitio, "mutantes", sitio / str(m.numero), LAB_MUTANTE=str(m.numero))

    def por_que(self, partidas, esperadas, fallan):
        """Lo que deja en todos los guiones lo mismo que la entrega, en palabras; del esqueleto, ninguna."""
        arbitro = self.arbitro

        def las_que_dan_lo_mismo(vivas):
            for guion in sorted(partidas, key=lambda g: g not in fallan):
                vivas = [
                    v for v in vivas if arbitro.misma(arbitro.juega(v[1], guion, esperadas[guion]), partidas[guion])
                ]
                if not vivas:
                    break
            return vivas

        esqueleto, *otras = self.variantes()
        vivas = las_que_dan_lo_mismo([esqueleto]) or las_que_dan_lo_mismo(otras)
        exactas = [
            v
            for v in vivas
            if all(arbitro.juega(v[1], g, esperadas[g]).imagenes == p.imagenes for g, p in partidas.items())
        ]
        return list(dict.fromkeys(dice for dice, _ in exactas or vivas))  # vacío, si no hay ninguna


def que_cambian(partidas):
    """De cada orden de esos guiones, si alguna vez cambia la imagen."""
    vistas = {}
    for guion, p in partidas.items():
        for orden, antes, despues in zip(guion.ordenes, p.imagenes, p.imagenes[1:]):
            vistas[sin_veces(orden)] = vistas.get(sin_veces(orden), False) or antes != despues
    return vistas


def no_responden(partidas, esperadas):
    """Las órdenes que en la solución cambian la imagen y en lo entregado, nunca; y si alguna la cambia."""
    hace = que_cambian(partidas)
    deben = [orden for orden, cambia in que_cambian(esperadas).items() if cambia]
    return [o for o in deben if not hace.get(o)], any(hace.get(o) for o in deben)


def tras(p, guion):
    """Hasta dónde ha llegado una partida que no llega al final."""
    if not p.imagenes:
        return " sin dibujar nada"
    return f" tras «{guion.ordenes[len(p.imagenes) - 2]}»" if 1 < len(p.imagenes) <= len(guion.ordenes) else ""


def como_acaba(p, guion):
    """Lo que hay que decir de una partida que no ha acabado como debe."""
    donde = tras(p, guion)
    dice = next((linea for linea in p.errores.splitlines() if linea.strip()), "")
    dice = dice.partition("; lo he buscado en")[0]  # rutas que solo hay aquí
    if p.cuelga:
        return f"tarda más de {p.limite:.0f} s de procesador{donde}"
    if p.estado == 3:
        return dice.partition(": ")[2] or "error de OpenGL"
    if p.estado == -1:
        return "no ha dejado nada: ha llenado su disco o ha acabado con quien lo ejecutaba"
    if p.estado > 128:
        que = next((linea.strip() for linea in p.errores.splitlines() if "what():" in linea), "")
        return f"se cae{donde}: {SENALES.get(p.estado, f'señal {p.estado - 128}')}{'; ' if que else ''}{que}"
    if p.estado:
        return f"acaba con un error{donde}: {dice or f'estado {p.estado}'}"
    return f"acaba por su cuenta{donde}" if len(p.imagenes) <= len(guion.ordenes) else ""
