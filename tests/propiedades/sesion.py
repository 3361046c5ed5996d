"""Un programa arrancado una vez (-sesion): cada guion sigue en un proceso desdoblado de él, y arrancar es casi todo lo que cuestan los cortos."""
import os
import socket
import subprocess
import tempfile
from pathlib import Path


class Sesion:
    def __init__(self, orden, **entorno):
        self.carpeta = tempfile.TemporaryDirectory()  # con lo que escribe al arrancar
        mio, suyo = socket.socketpair()
        with open(f"{self.carpeta.name}/salida", "w") as salida, open(f"{self.carpeta.name}/errores", "w") as errores, suyo:
            self.programa = subprocess.Popen([*orden, "-sesion"], stdin=suyo, stdout=salida, stderr=errores, env=os.environ | entorno)
        self.hilo = mio.makefile("rw")
        mio.close()
        self.respuesta()

    def respuesta(self):
        """El estado de salida del último; si el programa no puede seguir, el suyo."""
        return int(self.hilo.readline() or self.programa.wait())

    def sigue(self, carpeta, opciones):
        """Con esas opciones, en esa carpeta: el estado en que acaba, y lo que escriben, en stdout y en stderr, al arrancar y él."""
        estado = self.programa.poll()
        if estado is None:
            self.hilo.write("\t".join(map(str, [carpeta, *opciones])) + "\n")
            self.hilo.flush()
            estado = self.respuesta()

        def escrito(fichero):
            return "".join(f.read_text() for f in (Path(self.carpeta.name, fichero), Path(carpeta, fichero)) if f.exists())
        return estado, escrito("salida"), escrito("errores")

    def cierra(self):
        self.hilo.close()
        self.programa.wait()
        self.carpeta.cleanup()
