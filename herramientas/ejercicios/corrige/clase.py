"""Corregir una carpeta, o muchas. Cada entrega es un JSON, entero o nada: lo que ya está corregido no se corrige otra
vez."""
import json
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor

from base.procesos import Fallo, escribe, motivo
from ejercicios.corrige.arbitro import suma
from ejercicios.corrige.entrega import Rechazo, lee_entrega
from ejercicios.corrige.informes import en_una_linea, lineas
from ejercicios.corrige.veredicto import Correccion


def lee_resultado(fichero):
    try:
        return json.loads(fichero.read_text())
    except (OSError, ValueError):
        return None


def corrige(banco, carpeta, resultado=None):
    """La corrección de una carpeta; si RESULTADO ya es la de lo mismo, esa."""
    datos = {
        "entrega": os.fsencode(carpeta.name).decode(errors="replace"),
        "ejercicio": banco.ref,
        "semilla": banco.semilla,
    }
    try:
        ficheros, rechazo = lee_entrega(carpeta), ""
        datos["huella"] = suma(banco.version, str(banco.semilla), str(len(banco.todos)), repr(sorted(ficheros.items())))
    except Rechazo as por:
        ficheros, rechazo = None, str(por)
        datos["huella"] = suma(banco.version, rechazo)
    if resultado and (anterior := lee_resultado(resultado)) and anterior["huella"] == datos["huella"]:
        return anterior
    datos |= {"bien": 0, "guiones": len(banco.todos)}
    datos |= {"nota": 0, "dice": [rechazo], "fallos": []} if rechazo else Correccion(banco, ficheros).hazla()
    if resultado:
        escribe(resultado, json.dumps(datos, ensure_ascii=False, indent=1))
    return datos


def fichero_de(carpeta):
    nombre = carpeta.name if re.fullmatch(r"\w[\w .@+-]{0,99}", carpeta.name) else suma(os.fsencode(carpeta.name))
    return f"{nombre}.json"


def clase(banco, carpetas, destino, a_la_vez):
    """Cada carpeta, una entrega. Lo que no se pueda corregir por algo que no es suyo se dice y queda para la próxima
    vez."""
    correcciones, fallos = {}, []

    def una(carpeta):
        try:
            c = correcciones[carpeta] = corrige(banco, carpeta, destino / fichero_de(carpeta))
            dice = f"{c['entrega']}: {c['nota']:g}; {en_una_linea(lineas(c)[0])}"
        except (Fallo, OSError) as fallo:
            dice = f"{carpeta.name}: {motivo(fallo) if isinstance(fallo, OSError) else fallo}"
            fallos.append(dice)
        print(f"[{len(correcciones) + len(fallos):3}/{len(carpetas)}] {dice}", file=sys.stderr)

    with ThreadPoolExecutor(a_la_vez) as hilos:
        list(hilos.map(una, carpetas))
    return [correcciones[carpeta] for carpeta in carpetas if carpeta in correcciones], fallos
