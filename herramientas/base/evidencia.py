"""docs/evidencia.json: lo que midieron las pruebas la última vez que se midió todo, y de donde salen las tablas de
docs/exactitud.md.

programas: de cada uno, las pruebas que lo ejecutaron y lo peor que midieron frente a su referencia: máximo y RMSE, en
niveles de 255, y borde, en píxeles, salvo `lejos` de los `banda` que hay en él (herramientas/pruebas/evidencia.py
mide).
casos: de cada caso difícil, sus pruebas (citas), cuántas son y, de la que más se acerca a su cota, lo que mide
(también).
"""
import json

from base.procesos import escribe


def lee(raiz):
    return json.loads((raiz / "docs/evidencia.json").read_text())


def apunta(raiz, **nuevas):
    """Cambia esas secciones. Una medida por línea, para que se vea qué ha cambiado."""

    def texto(dato):
        return json.dumps(dato, ensure_ascii=False)

    secciones = []
    for seccion, medidas in {**lee(raiz), **nuevas}.items():
        lineas = ",\n".join(f"  {texto(nombre)}: {texto(medida)}" for nombre, medida in medidas.items())
        secciones.append(f"{texto(seccion)}: {{\n{lineas}\n}}")
    escribe(raiz / "docs/evidencia.json", "{\n" + ",\n".join(secciones) + "\n}\n")


def numero(x):
    """Con pocas cifras: 0.51, 1.2e-07."""
    return "0" if x == 0 else f"{x:.2g}" if abs(x) >= 1e-3 else f"{x:.1e}"


def errores(medida):
    """Máximo, RMSE y borde de un programa, como se leen; vacío, lo que no se mide."""
    maximo, rmse, borde = (numero(medida[m]) if m in medida else "" for m in ("maximo", "rmse", "borde"))
    if medida.get("lejos"):
        borde += f", salvo {medida['lejos']} de {medida['banda']}"
    return [maximo, rmse, borde]
