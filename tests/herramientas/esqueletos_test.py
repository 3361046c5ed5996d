"""El esqueleto de cada ejercicio, como lo da ./lab nuevo: compila sin avisos, dibuja algo y no es todavía lo que se
pide. Con lo que ya está compilado en $LAB_BUILD."""
import os

import pytest

from base import catalogo, compilacion
from base.procesos import ejecuta, entorno
from ejercicios import nuevo
from mentira import BUILD, RAIZ, siembra

EJERCICIOS = nuevo.ejercicios(RAIZ, catalogo.lee_programas(BUILD))
ENTORNO = entorno(BUILD)


def compila(programa, textos, carpeta):
    """Lo de esa carpeta, con las mismas órdenes que el programa."""
    siembra(carpeta, textos)
    compilar = compilacion.compila(BUILD, RAIZ / programa.fuente)
    ejecutable = programa.ejecutable(BUILD)
    cambios = {
        compilar[compilar.index("-o") + 1]: carpeta / "programa.o",
        str(RAIZ / programa.fuente): carpeta / programa.fuente.name,
        str(ejecutable.relative_to(BUILD)): carpeta / "programa",
    }
    compilar += ["-Werror", f"-I{RAIZ / programa.capitulo.nombre}"]
    ejecuta([cambios.get(p, p) for p in compilar], cwd=BUILD, text=True)
    ejecuta([cambios.get(p, p) for p in compilacion.enlaza(BUILD, ejecutable)], cwd=BUILD, text=True)


def dibuja(ejecutable, carpeta, caso):
    """La imagen, y lo que escribe."""
    guion = ["-guion", caso.guion] if caso.guion else []
    orden = [ejecutable, "-geometry", "240x180", "-ppm", carpeta / "p.ppm", *guion]
    escrito = ejecuta(orden, env={**os.environ, **ENTORNO, "LAB_RAIZ": str(carpeta)})
    return (carpeta / "p.ppm").read_bytes(), escrito


@pytest.mark.parametrize("referencia", EJERCICIOS)
def test_se_empieza_por_algo_que_compila_y_dibuja(referencia, tmp_path):
    programa = EJERCICIOS[referencia]
    compila(programa, nuevo.esqueleto(RAIZ, programa, referencia), tmp_path / "esqueleto")
    (tmp_path / "nada").mkdir()
    distintos = 0
    for caso in programa.casos:
        imagen, escrito = dibuja(tmp_path / "esqueleto/programa", tmp_path / "esqueleto", caso)
        assert len({imagen[i : i + 3] for i in range(15, len(imagen), 3)}) > 2, f"{caso.nombre}: no dibuja nada"
        distintos += (imagen, escrito) != dibuja(programa.ejecutable(BUILD), tmp_path / "nada", caso)
    assert distintos > len(programa.casos) / 2, "el esqueleto ya hace lo que se pide"
