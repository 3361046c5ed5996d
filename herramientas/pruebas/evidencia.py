"""evidencia.py RAÍZ BUILD: ejecuta las pruebas y apunta lo que miden en docs/evidencia.json (unos minutos); en
BUILD/exactitud/ deja cada imagen al lado de su referencia y de su diferencia."""
import json
import os
import subprocess
import sys
from pathlib import Path

from base import catalogo, evidencia, procesos
from base.libro import filas
from pruebas import googletest
from pruebas.googletest import busca


def casos_dificiles(raiz):
    """De cada uno, «tema: caso», las pruebas que dice tests/casos_dificiles/casos.tsv."""
    return {f"{tema}: {caso}": citas for tema, caso, *citas in filas(raiz / "tests/casos_dificiles/casos.tsv")}


def ejecuta(build, citas, pruebas):
    """Las propiedades que apunta cada prueba citada."""
    informes = build / "exactitud"
    informes.mkdir(exist_ok=True)
    entorno = {**procesos.entorno(build), **os.environ, "LAB_COMPARACIONES": str(informes)}
    quiere = {}
    for prueba in (prueba for cita in citas for prueba in busca(cita, pruebas)):
        ejecutable, nombre = prueba.split(".", 1)
        quiere.setdefault(ejecutable, []).append(nombre)
    propiedades = {}
    for ejecutable, nombres in sorted(quiere.items()):
        print(f"{ejecutable}: {len(nombres)} pruebas", file=sys.stderr)
        orden, informe = build / "tests" / f"{ejecutable}_test", informes / f"{ejecutable}.json"
        palabras = [orden, f"--gtest_filter={':'.join(nombres)}", f"--gtest_output=json:{informe}"]
        if subprocess.run(palabras, env=entorno, stdout=subprocess.DEVNULL).returncode:
            sys.exit(f"{ejecutable}: no pasan sus pruebas")
        propiedades.update({f"{ejecutable}.{nombre}": p for nombre, p in lee_informe(informe).items()})
    return propiedades


def lee_informe(informe):
    """Lo que apuntó cada prueba de un --gtest_output=json."""
    grupos = json.loads(informe.read_text())["testsuites"]
    return {f"{grupo['name']}.{prueba['name']}": prueba for grupo in grupos for prueba in grupo["testsuite"]}


def unidad(texto):
    """GoogleTest escribe en el JSON cada byte de UTF-8 como si fuera un carácter."""
    try:
        return texto.encode("latin-1").decode()
    except UnicodeError:
        return texto  # esta versión no lo hace


def mide_programa(p, pruebas, propiedades):
    """Lo peor que han medido sus pruebas."""
    for cita in p.pruebas:
        if not any(f"ejecuta_{p.nombre}" in propiedades[prueba] for prueba in busca(cita, pruebas)):
            sys.exit(f"{p.nombre}: «{cita}» no lo ejecuta")
    todas = [propiedades[prueba].get(f"pixeles_{p.nombre}") for cita in p.pruebas for prueba in busca(cita, pruebas)]
    medido = [[float(x) for x in m.split()] for m in todas if m]
    peor = {"pruebas": p.pruebas}
    if medido:
        *mayores, lejos, banda = zip(*medido)
        peor |= {que: float(f"{max(m):.3g}") for que, m in zip(("maximo", "rmse", "borde"), mayores) if max(m) >= 0}
        if sum(lejos):
            peor |= {"lejos": int(sum(lejos)), "banda": int(sum(banda))}
    return peor


def mide_caso(citas, pruebas, propiedades):
    """Cuántas pruebas tiene y la que más se acerca a su cota."""

    def cerca(medido):
        cota = float(medido["cota"])
        return float(medido["medida"]) / cota if cota else float(medido["medida"])

    suyas = [prueba for cita in citas for prueba in busca(cita, pruebas)]
    miden = [p for p in (propiedades.get(prueba, {}) for prueba in suyas) if "medida" in p]
    peor = {"pruebas": len(suyas), "citas": citas}
    if miden:
        p = max(miden, key=cerca)
        peor |= {"medida": float(p["medida"]), "cota": float(p["cota"]), "unidad": unidad(p["unidad"])}
    return peor


def mide(raiz, build):
    programas, casos, pruebas = catalogo.lee_programas(build), casos_dificiles(raiz), googletest.todas(build)
    # de los casos difíciles, las que miden: las otras solo se cuentan
    citas = {cita for p in programas for cita in p.pruebas}
    citas |= {cita for suyas in casos.values() for cita in suyas if cita.startswith("dificil_")}
    propiedades = ejecuta(build, sorted(citas), pruebas)
    return {
        "programas": {p.nombre: mide_programa(p, pruebas, propiedades) for p in programas},
        "casos": {caso: mide_caso(suyas, pruebas, propiedades) for caso, suyas in casos.items()},
    }


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:])
    evidencia.apunta(raiz, **mide(raiz, build))


if __name__ == "__main__":
    procesos.principal(main)
