"""Corregir una carpeta, o muchas. Cada entrega es un JSON, entero o nada: lo que ya está corregido no se corrige otra
vez."""
import json
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor

from base.procesos import Fallo, escribe, motivo
from ejercicios.nuevo import version
from ejercicios.corrige import parecidos
from ejercicios.corrige.arbitro import suma
from ejercicios.corrige.entrega import lee_entrega
from ejercicios.corrige.informes import lineas
from ejercicios.corrige.injerto import SE_CORRIGE, SE_EMPEZO, injertada
from ejercicios.corrige.lector import Rechazo, limpio
from ejercicios.corrige.veredicto import Correccion


def lee_resultado(fichero):
    try:
        resultado = json.loads(fichero.read_text())
        return resultado if isinstance(resultado, dict) else None
    except (OSError, ValueError):
        return None


def limpia(que, oculta):
    """Lo mismo, con cada texto limpio y sin la carpeta en que se corrige. Las imágenes y las reglas no son suyas."""
    if isinstance(que, str):
        return limpio(re.sub(re.escape(oculta) + r"[^\s:,»]*/", "", que))
    if isinstance(que, list):
        return [limpia(uno, oculta) for uno in que]
    if isinstance(que, dict):
        return {clave: v if clave in ("imagenes", "reglas") else limpia(v, oculta) for clave, v in que.items()}
    return que


def corrige(banco, carpeta, resultado=None, leidas=None):
    """La corrección de una carpeta, o de lo que da una plataforma; si RESULTADO ya es la de lo mismo, esa. En LEIDAS se
    deja su código."""
    datos = {"entrega": limpio(carpeta.name), "ejercicio": banco.ref, "semilla": banco.semilla}
    datos["reglas"] = banco.reglas.en_palabras
    try:
        entrega, rechazo = lee_entrega(carpeta, banco.ref, banco.de_otro), ""
        entrega.completa(*banco.de_partida)
        que = entrega.ficheros, entrega.llamadas, entrega.avisos, entrega.ejercicio, entrega.version
    except Rechazo as por:
        entrega, rechazo = None, str(por)
        que = (rechazo,)
    if entrega and leidas is not None:
        leidas[carpeta] = parecidos.codigo(entrega.suyos)
    datos["huella"] = banco.huella(*que)
    if resultado and (anterior := lee_resultado(resultado)) and anterior.get("huella") == datos["huella"]:
        return anterior
    datos |= {"bien": 0, "guiones": len(banco.todos), "casos": {}}
    datos |= {"nota": 0, "dice": [rechazo], "fallos": []} if rechazo else corregida(banco, entrega)
    datos["avisos"] = []
    if entrega and datos["nota"] < 100:
        de_otro = entrega.ejercicio not in ("", banco.ref)
        antes = [f"su carpeta es de otro ejercicio, el {entrega.ejercicio}"] if de_otro else []
        datos["dice"] = antes + datos["dice"]
        datos["avisos"] = [aviso for aviso in entrega.avisos if not sobra(aviso, *banco.dados)]
    datos = limpia(datos, str(banco.temporal))
    if resultado:
        escribe(resultado, json.dumps(datos, ensure_ascii=False, indent=1))
    return datos


def sobra(aviso, esqueleto, solucion):
    """Lo de que no viene un fichero en que no hay nada que hacer."""
    return any(aviso.startswith(f"no viene {f}:") for f, texto in esqueleto.items() if solucion.get(f) == texto)


def corregida(banco, entrega):
    """Tal cual o, si se empezó con otra versión y así sale mejor, injertada en el punto de partida de hoy."""
    suya = Correccion(banco, entrega)
    datos = suya.hazla()
    dice_cual, de_partida = bool(entrega.ejercicio), banco.de_partida[0]
    es_de_otra = entrega.version != version(de_partida) if dice_cual else not suya.dibuja
    if datos["nota"] == 100 or not es_de_otra or entrega.ejercicio not in ("", banco.ref):
        return datos
    otra = injertada(entrega, de_partida, banco.ref)
    if otra:
        otra.completa(*banco.de_partida)
        hoy = Correccion(banco, otra).hazla()
        if hoy["nota"] > datos["nota"]:
            return {**hoy, "dice": [*hoy["dice"], SE_CORRIGE]}
    return {**datos, "dice": [*datos["dice"], *[SE_EMPEZO] * bool(otra and dice_cual)]}


def fichero_de(carpeta):
    """Se llama como ella, si se puede: de dos nunca es el mismo."""
    nombre = os.fsencode(carpeta.name)
    legible = carpeta.name.isprintable() and carpeta.name[0] != "." and len(nombre) <= 200
    return f"{carpeta.name if legible else suma(nombre)}.json"


def clase(banco, carpetas, destino, a_la_vez, leidas=None):
    """{carpeta: su corrección}: cada una es una entrega. Lo que no se pueda corregir por algo que no es suyo se dice y
    queda para la próxima vez."""
    correcciones, fallos = {}, []

    def una(carpeta):
        try:
            c = correcciones[carpeta] = corrige(banco, carpeta, destino / fichero_de(carpeta), leidas)
            dice = f"{c['entrega']}: {c['nota']:g}; {lineas(c)[0]}"
        except (Fallo, OSError) as fallo:
            dice = limpio(f"{carpeta.name}: {motivo(fallo) if isinstance(fallo, OSError) else fallo}")
            fallos.append(dice)
        sys.stderr.write(f"[{len(correcciones) + len(fallos):3}/{len(carpetas)}] {dice}\n")  # entera, que son varios

    with ThreadPoolExecutor(a_la_vez) as hilos:
        list(hilos.map(una, carpetas))
    return {carpeta: correcciones[carpeta] for carpeta in carpetas if carpeta in correcciones}, fallos
