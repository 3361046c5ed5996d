"""reparte.py RAÍZ BUILD MIOS QUÉ [NOMBRE] [--programa]: lo de nuevo.py y, si es un ejercicio de quien enseña, adónde
hay que llegar y con qué se corrige en casa (corrige/casa.py). Con --programa solo dice qué hay que compilar antes."""
import sys
from pathlib import Path

from base.procesos import Fallo, principal
from ejercicios import nuevo, propios
from ejercicios.corrige import casa


def main():
    raiz, build, mios, *resto = (p for p in sys.argv[1:] if p != "--programa")
    if not 1 <= len(resto) <= 2:
        raise Fallo(
            "nuevo: hace falta un ejercicio o un programa y, si acaso, el nombre de la carpeta: "
            "./lab nuevo E3.5 mi_grua"
        )
    raiz, build = Path(raiz).resolve(), Path(build)
    programas, resto[0] = propios.resuelve(raiz, build, resto[0])
    referencia, programa = nuevo.elige(raiz, programas, resto[0])
    se_graba = bool(referencia and programa.raices)
    if "--programa" in sys.argv:
        return print(*[programa.objetivo] * se_graba)
    con = (lambda carpeta: casa.graba(raiz, build, referencia, programa, carpeta)) if se_graba else lambda _: None
    referencia, carpeta = nuevo.crea(raiz, programas, Path(mios), *resto, con=con)
    dice = "lo que se pide está en ENUNCIADO.md" if referencia else "una copia, para jugar con ella"
    tambien = f"; para corregirlo, ./lab corrige {carpeta.name}" if referencia else ""
    print(f"{carpeta}: {dice}. Para verlo, ./lab ver mios/{carpeta.name}{tambien}")


if __name__ == "__main__":
    principal(main)
