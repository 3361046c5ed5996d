#!/usr/bin/env python3
"""compara_encima.py [--escribe] GOLDEN LISTA: si lo que un programa pinta encima (common/encima/encima.h) es lo del
golden.

Son los mismos trazos en el mismo orden, con el mismo tipo, panel y texto; los sitios y las tallas, a 0.05 píxeles,
que es más de lo que cambia un redondeo de un compilador a otro; los colores y las profundidades, a 0.001. Lo que no
pinta nada no tiene golden. Acaba con 4 si no, y dice qué trazo. Con --escribe, lo que es distinto pasa a ser el
golden, y está bien.
"""
import os
import sys

CAMPOS = "el tipo", "el color", "el panel", "la talla", "la profundidad", "el punto", "el texto"
DISTA = {"el color": (0.001,) * 3, "la talla": (0.05,), "el punto": (0.05, 0.05, 0.001)}  # de tres en tres


def lee(fichero):
    """De cada imagen, su línea y los campos de sus trazos; vacío si en ninguna hay nada."""
    with open(fichero) as lista:
        lineas = lista.read().split("\n")
    imagenes = []
    for campos in (linea.split("\t") for linea in lineas if linea):
        if campos[0] == "imagen":
            imagenes.append((campos[1:], []))
        else:
            imagenes[-1][1].append(campos)
    return imagenes if any(trazos for _, trazos in imagenes) else []


def redondea(campo, texto):
    """Con los decimales que se comparan."""
    if campo not in DISTA:
        return texto
    decimales = [2 if dista == 0.05 else 3 for dista in DISTA[campo]]
    return " ".join(f"{round(float(x), decimales[i % 3]) + 0.0:.12g}" for i, x in enumerate(texto.split()))  # sin -0


def nombre(trazo):
    return trazo[0] + (f" «{trazo[-1]}»" if trazo[-1] else "")


def distinto(debe, es):
    """En qué se distinguen dos trazos."""
    for campo, a, b in zip(CAMPOS, debe, es):
        u, v = a.split(), b.split()
        if campo not in DISTA:
            if a != b:
                yield f"{campo} debía ser {a} y es {b}"
                if campo == CAMPOS[0]:  # lo demás no se parece en nada
                    return
            continue
        if len(u) != len(v):
            yield f"debía tener {len(u) // 3} puntos y tiene {len(v) // 3}"
            continue
        lejos = (i for i in range(len(u)) if not abs(float(u[i]) - float(v[i])) <= DISTA[campo][i % 3])
        for i in lejos:
            i -= i % 3
            cual = f" {i // 3 + 1}" if len(u) > 3 else ""
            yield f"{campo}{cual} debía ser {' '.join(u[i:i + 3])} y es {redondea(campo, ' '.join(v[i:i + 3]))}"
            break  # basta con el primero


def compara(deben, son):
    """En qué se distinguen las imágenes, una línea por trazo."""
    if not deben or not son:
        yield "no debía pintar nada encima" if son else "no pinta nada encima"
        return
    if [imagen for imagen, _ in deben] != [imagen for imagen, _ in son]:
        yield f"las imágenes debían ser {[i for i, _ in deben]} y son {[i for i, _ in son]}"
        return
    for ((imagen, *_), a), (_, b) in zip(deben, son):
        if len(a) == len(b):
            for i, (debe, es) in enumerate(zip(a, b), 1):
                if en := "; ".join(distinto(debe, es)):
                    yield f"{imagen}, trazo {i}, {nombre(debe)}: {en}"
            continue
        from difflib import SequenceMatcher  # solo aquí: son cientos de procesos, y tarda más que todo lo demás

        una, otra = ([nombre(t) for t in trazos] for trazos in (a, b))
        for que, i, j, k, n in SequenceMatcher(None, una, otra, False).get_opcodes():
            yield from (f"{imagen}, trazo {i + 1}, falta {nombre(t)}" for t in a[i:j] if que != "equal")
            yield from (f"{imagen}, trazo {k + 1}, sobra {nombre(t)}" for t in b[k:n] if que != "equal")


def main():
    golden, lista = sys.argv[-2:]
    deben, son = lee(golden) if os.path.exists(golden) else [], lee(lista)
    diferencias = list(compara(deben, son)) if deben or son else []
    print(*diferencias, sep="\n", end="\n" if diferencias else "")
    if diferencias and "--escribe" not in sys.argv:
        sys.exit(4)
    if diferencias and os.path.exists(golden):
        os.unlink(golden)
    if diferencias and son:
        lineas = []
        for imagen, trazos in son:
            lineas += [["imagen", *imagen], *([redondea(*campo) for campo in zip(CAMPOS, t)] for t in trazos)]
        with open(golden, "w") as nuevo:
            nuevo.write("".join("\t".join(linea) + "\n" for linea in lineas))


if __name__ == "__main__":
    main()
