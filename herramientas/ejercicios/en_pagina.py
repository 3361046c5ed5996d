"""Lo que la página de ./lab web sabe de cada ejercicio: lo que se da, lo que se pide y cómo se corrige. Todo es de
./lab nuevo y de ./lab corrige, escrito una vez al hacer la página: allí solo se juega."""
import os
import re
from dataclasses import asdict
from pathlib import Path

from base import defectos, libro, marcas
from base.guiones import en_palabras
from ejercicios import nuevo, propios, reglas
from ejercicios.corrige import piezas as corrige_piezas, shaders
from ejercicios.corrige.banco import guiones
from ejercicios.corrige.motivos import Motivos, que_dice

SEMILLA = "1"  # la de ./lab corrige, si no se dice otra


def los_que_hay(raiz, programas):
    """El programa de cada uno, menos los que en su carpeta llevan hecho lo de otro que está oculto."""
    ocultos = {*marcas.ocultos(raiz)}
    hechos = lambda p, ref: marcas.que_piden(nuevo.de_la_carpeta(raiz, p, ref)).keys() - {ref}
    suyos = {ref: p for ref, p in nuevo.ejercicios(raiz, programas).items() if not ocultos & hechos(p, ref)}
    return {**suyos, **shaders.ejercicios(raiz, programas)}


def suya(programa):
    """Dónde está en la página la carpeta de quien lo hace."""
    return f"mios/{programa.nombre}"


def piden(raiz, programa, ref):
    """Lo que se pide en cada fichero, por su ruta en la página: lo de cada pieza."""
    if nuevo.es_de_shaders(ref):
        return {f: nuevo.pide(texto, ref) for f, texto in nuevo.pedidos(raiz, programa, ref).items()}
    textos = nuevo.de_la_carpeta(raiz, programa, ref)
    return {f"{suya(programa)}/{f}": que for f, texto in textos.items() if (que := nuevo.pide(texto, ref))}


def resumen(raiz, programa, ref, del_libro):
    """Lo que hace falta para enseñarlo en la lista."""
    datos = {"codigo": ref, "pide": {f: "; ".join(que) for f, que in piden(raiz, programa, ref).items()}}
    datos["que"] = del_libro.cosas[ref].que if ref in del_libro.cosas else programa.titulo
    if not nuevo.es_de_shaders(ref):
        oculto = bool(programa.raices) or ref in marcas.ocultos(raiz)
        datos |= {"carpeta": suya(programa), "oculto": oculto, "propio": bool(programa.raices)}
    return datos


def en_html(texto):
    """Un enunciado: párrafos y listas, que pueden ir seguidos. Su título ya está en la página."""
    hecho = ""
    for trozo in re.split(r"\n\s*\n|\n(?=- |#)", re.sub("^# .*", "", texto, flags=re.M)):
        if dice := libro.en_html(trozo.strip().removeprefix("- ").lstrip("# ")):
            hecho += f"<li>{dice}</li>" if trozo.lstrip("\n").startswith("- ") else f"<p>{dice}</p>"
    return re.sub("(<li>.*?</li>)(?!<li>)", r"<ul>\1</ul>", hecho)


def corrige(raiz, build, programa, ref, cuantos=None):
    """Lo que se juega para corregirlo, y lo que vale."""
    suyas = reglas.del_programa(programa, None, cuantos, shaders.reglas(ref))
    todos = guiones(raiz, build, programa, ref, SEMILLA, suyas, {})
    ordenes = {o.partition(" ×")[0] for g in todos for o in g.ordenes}
    return {
        "guiones": [de_guion(g, suyas) for g in todos],
        "palabras": {o: en_palabras(o) for o in sorted(ordenes)},
        "reglas": asdict(suyas) | {"dichas": suyas.en_palabras},
        **piezas(raiz, programa, ref, suyas),
        "errores": errores(raiz, programa, ref),
    }


def de_guion(guion, reglas_):
    dicho = {"nombre": guion.nombre, "ordenes": guion.ordenes, "pesa": reglas_.peso(guion)}
    return dicho | ({"suyas": guion.suyas} if guion.caso else {})


def errores(raiz, programa, ref):
    """Los que se conocen, para plantarlos en la solución, si no está oculta: ella con los de C++ puestos, que los elige
    $LAB_MUTANTE; de los de un shader, qué se cambia; y los que pueden ir de dos en dos. Los juega web/motivos.mjs."""
    if programa.raices or ref in marcas.ocultos(raiz):
        return None
    motivos = Motivos(raiz, programa, ref, None, None)
    limpios, donde = motivos.limpio(motivos.textos()), "" if nuevo.es_de_shaders(ref) else f"{suya(programa)}/"

    def suyo(m):
        if not m.en_shader:
            return {"dice": que_dice(m), "numero": m.numero}
        f = m.fichero if m.fichero in limpios else Path(m.fichero).name
        cambiado = motivos.limpio(motivos.estropeados(m))[f]
        return {"dice": que_dice(m), "en": f"{donde}{f}", "cambia": lo_que_cambia(limpios[f], cambiado)}

    cual = {m: i for i, m in enumerate(motivos.defectos)}
    puestos = motivos.con_los_de_cpp(motivos.defectos, f'#include "{defectos.MUTANTE_H}"\n')
    return {
        "textos": {f"{donde}{f}": texto for f, texto in puestos.items()},
        "defectos": [suyo(m) for m in motivos.defectos],
        "pares": [[cual[a], cual[b], int(a.imita == b.imita)] for a, b in motivos.pares([m for m in cual if m.dice])],
    }


def lo_que_cambia(uno, otro):
    """[desde, hasta, lo que va en su lugar]: en el primero, para que sea el segundo."""
    antes = len(os.path.commonprefix([uno, otro]))
    despues = min(len(os.path.commonprefix([uno[::-1], otro[::-1]])), len(uno) - antes, len(otro) - antes)
    return [antes, len(uno) - despues, otro[antes : len(otro) - despues]]


def piezas(raiz, programa, ref, reglas_):
    """Si se piden varias, de cada una lo que va en su sitio y lo que hay de partida, y la solución sin ellas; si está
    oculta, nada de eso. Las junta web/piezas.mjs."""
    textos, trozos = nuevo.textos(raiz, programa, ref), []

    def sin_ella(trozo):
        if trozo["codigo"] != ref:
            return trozo[0]
        trozos.append(trozo)
        return f"\0{len(trozos) - 1}\0\n"

    sin_ellas = {f: marcas.TROZO.sub(sin_ella, texto) for f, texto in textos.items()}
    if len(trozos) < 2 or not reglas_.huecos:
        return {}
    if programa.raices or ref in marcas.ocultos(raiz):
        return {"huecos": []}
    hechas = nuevo.sin_marcas({str(i): t[0] for i, t in enumerate(trozos)}, programa, ref)
    solucion = nuevo.sin_marcas(sin_ellas, programa, ref)
    donde = "" if nuevo.es_de_shaders(ref) else f"{suya(programa)}/"
    return {
        "huecos": [
            {"pide": t["pide"], "pesa": pesa, "hecha": hechas[str(i)], "partida": corrige_piezas.por_hacer(t)}
            for i, (t, pesa) in enumerate(zip(trozos, reglas_.de_cada(len(trozos))))
        ],
        "solucion": {f"{donde}{f}": texto for f, texto in solucion.items()},
    }


def datos(raiz, build, programa, ref):
    """Lo demás, que se pide al entrar en él."""
    hechos = corrige(raiz, build, programa, ref)
    if nuevo.es_de_shaders(ref):
        pedidos = nuevo.pedidos(raiz, programa, ref)
        return hechos | {"esqueleto": {f: marcas.esqueleto(texto, ref) for f, texto in pedidos.items()}}
    carpeta = nuevo.carpeta_de(raiz, programa, ref, programa.nombre)
    sueltos = {f: carpeta.pop(f) for f in (nuevo.EJERCICIO, propios.ENUNCIADO)}
    hechos["esqueleto"] = {f"{suya(programa)}/{f}": texto for f, texto in carpeta.items()}
    return hechos | {"sueltos": sueltos, "enunciado": en_html(nuevo.encabezado(raiz, programa, ref))}
