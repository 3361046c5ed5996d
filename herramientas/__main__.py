"""python3 herramientas CUARTO.MODULO …: ejecuta ese módulo. Esta carpeta es la raíz de los import de todos, y cada
cuarto, un paquete."""
import runpy
import sys

del sys.argv[0]
runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
