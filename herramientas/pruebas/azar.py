"""Defectos que no ha pensado nadie: líneas de los programas, sus shaders, common/ y glut/ elegidas al azar y
perturbadas a máquina (ejercicios/perturba.py). De cada una, los que compilan; si alguno da lo mismo, no se sabe."""
import random
import re
import subprocess

from base import compilacion
from base.defectos import MUTANTE_H, cambia, estropea
from base.fuentes import SHADERS
from ejercicios.perturba import perturbaciones, perturbado

DE_DONDE = "ch*/*.cpp", "ch*/*.h", "ch*/*.vert", "ch*/*.frag", "ch*/*.glsl", "common/**/*.*", "glut/sin_ventana/*.*"
NO_SE_COMPILAN = re.compile(r"_(web|egl)\.cpp$|/(essl|contexto)\.h$|\.cmake$")
OTRO_FACTOR = "herramientas/ejercicios/otro_factor.h"
CUERPO = re.compile(r"^(?!.*\b(?:if|for|while|switch|catch)\b ?\()[^#\n;=]*\)\s*(?:const\s*)?\{", re.M)
INTENTOS = 20  # por cada uno de los que se piden


def cuerpos(texto):
    """Dónde empieza y acaba lo de dentro de cada función."""
    fin = 0
    for hallado in CUERPO.finditer(texto):
        if hallado.end() < fin:
            continue
        fin, abiertas = hallado.end(), 1
        while abiertas and fin < len(texto):
            abiertas += {"{": 1, "}": -1}.get(texto[fin], 0)
            fin += 1
        yield hallado.end(), fin - 1


def de_fichero(texto, glsl):
    """Las perturbaciones, por líneas."""
    lineas = {}
    for desde, hasta in cuerpos(texto):
        for p in perturbaciones(texto, desde, hasta, glsl):
            lineas.setdefault(p.linea, []).append(p)
    return lineas


def compila(raiz, build, fichero, texto):
    """Si ese fuente, cambiado así, compila; una cabecera, con las palabras de un programa cualquiera."""
    ordenes = compilacion.ordenes(build)
    suya = ordenes.get(raiz / fichero) or ordenes[raiz / "ch03_transformaciones/grua.cpp"]
    palabras = suya[: suya.index("-o")]
    incluye = "".join(f'#include "{raiz / f}"\n' for f in (MUTANTE_H, OTRO_FACTOR))
    orden = [*palabras, "-w", "-fsyntax-only", "-x", "c++", "-"]
    donde = (raiz / fichero).parent
    return subprocess.run(orden, input=incluye + texto, text=True, cwd=donde, capture_output=True).returncode == 0


def elige(raiz, build, cuantos, semilla, no_compila_glsl):
    """Los que se piden, de otras tantas líneas."""
    azar = random.Random(semilla)
    ficheros = sorted({f for patron in DE_DONDE for f in raiz.glob(patron) if not NO_SE_COMPILAN.search(str(f))})
    ficheros = [f for f in ficheros if f.suffix in (".cpp", ".h", *SHADERS)]
    largos = [len(f.read_text().splitlines()) for f in ficheros]
    lineas, elegidos, usadas = {}, [], set()
    for _ in range(cuantos * INTENTOS):
        if len(elegidos) == cuantos:
            break
        fichero = azar.choices(ficheros, largos)[0]
        relativo, texto = str(fichero.relative_to(raiz)), fichero.read_text()
        if fichero not in lineas:
            lineas[fichero] = de_fichero(texto, fichero.suffix in SHADERS)
        if not lineas[fichero]:
            continue
        linea = azar.choice(sorted(lineas[fichero]))
        p = azar.choice(lineas[fichero][linea])
        m = perturbado(p, len(elegidos) + 1, relativo, texto)
        if (relativo, linea) not in usadas and vale(raiz, build, m, texto, no_compila_glsl):
            usadas.add((relativo, linea))
            elegidos.append(m)
    return elegidos


def vale(raiz, build, m, texto, no_compila_glsl):
    if m.en_shader:
        return not no_compila_glsl(raiz, m.fichero, estropea(texto, m))
    try:
        return compila(raiz, build, m.fichero, cambia(texto, [m]))
    except ValueError:  # entre paréntesis sería otra expresión
        return False
