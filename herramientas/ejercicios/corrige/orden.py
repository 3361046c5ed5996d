"""orden.py RAÍZ BUILD ENTREGA [EJERCICIO] [opciones]: corrige lo que ha hecho un estudiante, o una clase entera.

ENTREGA es mios/NOMBRE, o una carpeta con lo mismo dentro; si dentro hay carpetas con programas, es una clase, y cada
una, una entrega; también vale lo que descarga Moodle, en una carpeta o en su .zip. Lo entregado y la solución juegan
los mismos guiones, los casos del ejercicio y otros al azar con los controles de su programa, y tras cada orden se
comparan las imágenes y los títulos. El guion que falla se acorta y, si algún defecto conocido
plantado en la solución (errores/) deja en todos los guiones lo que deja la entrega, se dice cuál.
"""
import argparse
import os
import re
import sys
import tempfile
from pathlib import Path

from base.procesos import Fallo, escribe, por_donde, principal
from ejercicios import nuevo, propios, reglas
from ejercicios.corrige import aula, casa, clase, conjunto, entrega, informes, lector, shaders
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.hoja import Hoja
from ejercicios.corrige.jaula import Jaula


class Analizador(argparse.ArgumentParser):
    def error(self, message):
        """Lo que dice argparse, en una línea y en español."""
        opcion = re.match(r"argument ([^ :]+): (?:.*: '(.*)')?", message)
        if not opcion:
            raise Fallo("corrige: di qué entrega: ./lab corrige mi_grua, o ./lab corrige CLASE E3.5")
        if opcion[2] is None:
            raise Fallo(f"corrige: falta lo que sigue a {opcion[1]}")
        raise Fallo(f"corrige: no entiendo «{opcion[1]} {opcion[2]}»")


def opciones(palabras):
    """Las de docs/corrige.md."""
    analizador = Analizador(add_help=False, allow_abbrev=False)
    analizador.add_argument("entrega")
    analizador.add_argument("ejercicio", nargs="?")
    analizador.add_argument("--semilla", default="1")
    analizador.add_argument("--guiones", type=natural)
    for opcion in ("--deja", "--json", "--junit", "--moodle", "--reglas"):
        analizador.add_argument(opcion, type=Path)
    analizador.add_argument("-j", type=positivo, default=os.cpu_count())
    for opcion in ("--vpl", "--sin-jaula", "--cambia-notas", "--programa"):  # --programa: solo escribe cuál es
        analizador.add_argument(opcion, action="store_true")
    que, sobran = analizador.parse_known_args(palabras)
    if sobran:
        raise Fallo(f"corrige: no entiendo «{sobran[0]}»; ./lab ayuda dice sus opciones")
    if que.vpl and que.sin_jaula:
        raise Fallo("corrige: --vpl, con --sin-jaula, no: lo entregado leería la solución")
    return que


def natural(texto):
    if not re.fullmatch("[0-9]{1,6}", texto):
        raise ValueError
    return int(texto)


def positivo(texto):
    return natural(texto) or natural("")


def ejercicio(raiz, programas, pedido):
    hay = {**nuevo.ejercicios(raiz, programas), **shaders.ejercicios(raiz, programas)}
    ref = nuevo.ejercicio_pedido(pedido or "", hay)
    if ref not in hay:
        que = f"«{pedido}» no es un ejercicio que se pueda corregir" if pedido else "di qué ejercicio es"
        raise Fallo(f"{que}: {', '.join(hay)}")
    return ref, hay[ref]


def de_una(que, banco, carpeta):
    """Su corrección, escrita; y dónde va su página, si va. Mientras, por dónde va: de una clase se dice quién acaba."""
    van = {g: f"[{n}/{len(banco.todos)}] juega " for n, g in enumerate(banco.todos, 1)}
    buscan = lambda quien, g: g not in van or quien.nombre not in ("la solución", "la entrega")
    dice = lambda quien, g: "busco en qué se aparta" if buscan(quien, g) else van[g] + quien.nombre
    banco.arbitro.avanza = lambda *que: por_donde(dice(*que))
    correccion = clase.corrige(banco, carpeta, que.json and que.json.absolute())
    por_donde()
    print(informes.en_vpl(correccion) if que.vpl else informes.en_texto(correccion, en_mios(que, carpeta)))
    return [correccion], [], que.deja or (None if que.json or que.vpl else donde(que, carpeta))


def en_mios(que, carpeta):
    """Cómo se llama su carpeta de mios/, si lo es: la corrige quien la ha hecho."""
    return carpeta.name if isinstance(carpeta, Path) and carpeta.parent == que.mios else ""


def donde(que, carpeta):
    """La página de una entrega: en ella o, si es un fichero, a su lado."""
    if isinstance(carpeta, Path) and carpeta.is_dir():
        return carpeta / "correccion"
    suelto = Path(que.entrega)
    return suelto.with_name(f"{suelto.stem}-correccion")


def de_una_clase(que, banco, carpeta, dentro):
    """Las de todos, en una página y en lo que Moodle recoge."""
    quienes = [suya.name for suya in dentro]  # la hoja, antes de nada, si no se entiende
    hoja = que.moodle and Hoja(que.moodle.absolute(), quienes, banco.reglas, que.cambia_notas)
    destino, leidas = que.deja or carpeta.with_name(f"{carpeta.name}-corregida"), {}
    correcciones, fallos = clase.clase(banco, dentro, destino, que.j, leidas)
    escribe(destino / "notas.csv", informes.en_csv(correcciones.values()))
    conjunto.escribe(destino, correcciones, banco, leidas, hoja)
    if hoja:
        for suya, correccion in correcciones.items():
            hoja.pon(suya.name, correccion)
        print(f"Hecha: {hoja.escribe()}: {hoja.cuenta}", *hoja.avisos, sep="\n", file=sys.stderr)
    return list(correcciones.values()), fallos, destino


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    que = opciones(sys.argv[3:])
    que.mios = (build.parent / "mios").absolute()
    carpeta, dentro, sueltos = aula.busca(que.mios, que.entrega, que.deja and que.deja.absolute())
    repartido, otro = None, None
    programas, que.ejercicio = propios.resuelve(raiz, build, que.ejercicio)
    if que.ejercicio or dentro:
        ref, programa = ejercicio(raiz, programas, que.ejercicio)
    elif isinstance(carpeta, aula.Subida):
        raise Fallo(f"di qué ejercicio es: ./lab corrige {que.entrega} E3.5")
    elif repartido := casa.lo_repartido(carpeta, programas):
        ref, programa, _ = repartido
    else:
        ref, programa = entrega.ejercicio_de(carpeta, programas)
    if not ref:
        raise Fallo(f"{que.entrega} es una copia de {programa.nombre}: no hay ejercicio que corregir")
    if que.moodle and not dentro:
        raise Fallo(f"--moodle es de una clase, y {que.entrega} es una entrega")
    if dentro and (opcion := "--json" if que.json else "--vpl" if que.vpl else ""):
        raise Fallo(f"{opcion} es de una entrega, y {que.entrega} es una clase: de cada una ya queda su JSON")
    if que.cambia_notas and not que.moodle:
        raise Fallo("--cambia-notas es de --moodle HOJA.csv, que falta")
    if repartido:
        otro = next(p for p in programas if not p.consola)  # como él se compila
    if que.programa:
        return print((otro or programa).objetivo)
    puntua = reglas.del_programa(programa, que.reglas, que.guiones, shaders.reglas(ref))
    if dentro and sueltos:
        print(lector.limpio(f"En {que.entrega} hay sueltos, y se dejan: {', '.join(sueltos)}"), file=sys.stderr)
    jaula = None if que.sin_jaula else Jaula(raiz)
    if jaula:
        jaula.comprueba()
    with tempfile.TemporaryDirectory() as temporal:
        os.chmod(temporal, 0o755)
        como = Path(temporal), jaula, que.semilla, puntua
        if repartido:
            banco = casa.BancoDeCasa(raiz, build, repartido, *como, otro)
        else:
            banco = Banco(raiz, build, ref, programa, *como)
        hecho = de_una_clase(que, banco, carpeta, dentro) if dentro else de_una(que, banco, carpeta)
        correcciones, fallos, destino = hecho
    if que.junit:
        escribe(que.junit, informes.en_junit(correcciones))
    if destino:
        if not dentro:
            pagina = informes.pagina(correcciones[0], programa, ref, en_mios(que, carpeta))
            escribe(destino / "index.html", pagina)
        print(f"Hecha: {destino}/index.html", file=sys.stderr)
    if fallos:
        raise Fallo(f"no se han podido corregir {len(fallos)}: {'; '.join(fallos)}")
    return 0 if all(c["nota"] == 100 for c in correcciones) else 1


if __name__ == "__main__":
    principal(main)
