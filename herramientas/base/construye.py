"""Dónde se trabaja, de uno en uno, y compilar con CMake y ninja diciendo por dónde se va."""
import fcntl
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from base import paquetes, procesos
from base.procesos import Fallo

SALEN = "build", "explica", "galeria", "informe", "web", "mios", "windows"
DE_CMAKE = "CMakeCache.txt", "catalogo.json", "sin_ventana"  # lo que deja CMake
FUTURO = 5  # segundos de más que se perdonan al reloj
MUCHOS, SEGUNDOS_POR_PASO = 20, 0.6  # lo que cuesta de media cada fuente y cada enlace, de procesador


def aviso(texto):
    print(texto, file=sys.stderr, flush=True)


def corre(orden, **opciones):
    """Con qué estado acaba. Lo que se ejecuta acaba con nosotros si llega una señal."""
    with procesos.arranca(orden, **opciones) as proceso:
        return proceso.wait()


class Taller:
    """Las carpetas de lo que sale del laboratorio: aquí o, si en alguna no se puede escribir, en la caché de quien lo
    usa."""

    def __init__(self, raiz):
        self.raiz, sitio = raiz, raiz
        self.vale(sitio)
        existentes = [raiz, *(raiz / c for c in SALEN if c != "mios" and (raiz / c).exists())]
        ajeno = next((c for c in existentes if not os.access(c, os.W_OK)), None)
        if ajeno:
            casa = os.environ.get("XDG_CACHE_HOME") or f"{os.environ.get('HOME', '')}/.cache"
            sitio = Path(f"{casa}/laboratorio{raiz}")
            self.vale(sitio)
            try:
                sitio.mkdir(parents=True, exist_ok=True)
            except OSError:
                pass
            if not os.access(sitio, os.W_OK):
                raise Fallo(f"no puedo escribir en {ajeno} ni en {sitio}")
            aviso(f"No puedo escribir en {ajeno}: trabajo en {sitio}")
        for carpeta in SALEN:
            setattr(self, carpeta, sitio / carpeta)
        self.build.mkdir(parents=True, exist_ok=True)
        self.cerrojo = None

    @staticmethod
    def vale(carpeta):
        if re.search('[\n;:"\\\\#]', str(carpeta)):
            que = str(carpeta).replace("\n", "?")
            raise Fallo(f'CMake no sabe trabajar en una carpeta con ; : " \\ # o un salto de línea en su ruta: {que}')

    # --- de uno en uno: dos a la vez en la misma carpeta se estorbarían -----------------------------------------------

    def cierra(self, carpeta=None):
        """Si ya lo tiene otro, espera. LAB_CERROJO dice que lo tiene quien nos llama."""
        carpeta = carpeta or self.build
        carpeta.mkdir(parents=True, exist_ok=True)
        if os.environ.get("LAB_CERROJO") == str(carpeta):
            return
        self.cerrojo = open(carpeta / ".cerrojo", "w")
        try:
            fcntl.flock(self.cerrojo, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            aviso(f"Hay otro ./lab trabajando en {carpeta}: espero a que acabe")
            while True:  # a trozos: así se atiende una señal
                procesos.si_hay_senal()
                try:
                    fcntl.flock(self.cerrojo, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    break
                except BlockingIOError:
                    time.sleep(0.1)
        os.environ["LAB_CERROJO"] = str(carpeta)

    def suelta(self):
        """Para lo que puede durar sin estorbar a otro."""
        if self.cerrojo:
            self.cerrojo.close()
            self.cerrojo = None
            del os.environ["LAB_CERROJO"]

    # --- configurar y compilar ----------------------------------------------------------------------------------------

    def atrasa_lo_futuro(self):
        """Con un CMakeLists.txt de mañana (un reloj atrasado, un zip de otro huso) ninja no acabaría de configurar."""
        patrones = "CMakeLists.txt", "CMakePresets.json", "*/CMakeLists.txt", "**/*.cmake", "ch*/catalogo.toml"
        ahora = time.time()
        suyos = {f for patron in patrones for f in self.raiz.glob(patron) if self.build not in f.parents}
        futuros = [f for f in suyos if f.stat().st_mtime > ahora + FUTURO]
        if not futuros:
            return
        aviso(f"{futuros[0].relative_to(self.raiz)} tiene fecha futura (¿va atrasado el reloj?): le pongo la de ahora")
        try:
            for f in futuros:
                os.utime(f)
        except OSError as error:
            raise Fallo(f"no puedo ponerle la de ahora: {procesos.motivo(error)}") from None

    def al_dia(self, carpeta):
        """Si CMake no tiene nada que hacer."""
        if not all((carpeta / f).exists() for f in DE_CMAKE):
            return False
        nada = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        return corre(["cmake", "--build", carpeta, "--target", "build.ninja"], **nada) == 0

    def configura(self, preset, carpeta, *opciones):
        """Con opciones, siempre."""
        cache = carpeta / "CMakeCache.txt"
        if cache.exists():
            texto = cache.read_text(errors="replace")
            de_aqui = f"CMAKE_HOME_DIRECTORY:INTERNAL={self.raiz}\n" in texto
            if not de_aqui or "CMAKE_GENERATOR:INTERNAL=Ninja\n" not in texto:
                aviso(f"{carpeta} se hizo en otra carpeta, o a mano con otra cosa: la vacío y la hago otra vez")
                for que in carpeta.iterdir():
                    if que.name != ".cerrojo":
                        shutil.rmtree(que) if que.is_dir() and not que.is_symlink() else que.unlink()
        self.atrasa_lo_futuro()
        if not opciones and self.al_dia(carpeta):
            return
        carpeta.mkdir(parents=True, exist_ok=True)
        registro = carpeta / "configura.log"
        with open(registro, "w") as escribe:
            orden = ["cmake", "--preset", preset, "-B", carpeta, *opciones]
            estado = corre(orden, cwd=self.raiz, stdout=escribe, stderr=subprocess.STDOUT)
        dicho = registro.read_text(errors="replace")
        if estado:
            aviso(dicho.rstrip())
            if not shutil.which("apt-get"):
                aviso(paquetes.en_otros(paquetes.PARA_USAR))
            self.no_sale("CMake no ha podido configurar")
        if falta := re.search("^-- (No hay OSMesa.*)", dicho, re.M):
            aviso(falta[1])

    @classmethod
    def compilando(cls, carpeta, *objetivos):
        """Cada línea de ninja, según la escribe, y al acabar un Fallo si no compila. En una terminal enseña por dónde
        va; fuera de ella, solo avisos y errores. Todo queda en compila.log."""
        orden = ["cmake", "--build", carpeta, "--target", *objetivos]
        como = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, "errors": "replace"}
        with open(carpeta / "compila.log", "w") as registro, procesos.arranca(orden, **como) as proceso:
            for linea in proceso.stdout:
                registro.write(linea)
                cls.ensena(linea)
                yield linea
            proceso.wait()
        cls.ensena("")
        if proceso.returncode:
            raise Fallo("no compila")

    def compila(self, carpeta, *objetivos, si_no="no compila"):
        try:
            for _ in self.compilando(carpeta, *objetivos):
                pass
        except Fallo:
            self.no_sale(si_no)

    @staticmethod
    def ensena(linea):
        """Una línea de ninja: por dónde va, que se borra, con lo que queda si es mucho; o por qué no compila."""
        paso = re.match(r"\[(\d+)/(\d+)\]", linea)
        if paso and int(paso[1]) == 1 and int(paso[2]) > MUCHOS:
            procesadores = len(os.sched_getaffinity(0))
            minutos = max(1, round(int(paso[2]) * SEGUNDOS_POR_PASO / procesadores / 60))
            aviso(f"Compilo: {paso[2]} pasos, unos {minutos} min con {procesadores} procesadores")
        if not linea or paso:
            procesos.por_donde(linea)
        elif not re.match(r"-- |FAILED: |(: && )?/\S+ .* -o |ninja: (?!error: |build stopped: .* space)", linea):
            aviso(linea.rstrip())

    def compila_para_usar(self, *objetivos):
        """Los avisos solo impiden seguir en ./lab prueba: si ha sido por ellos, otra vez sin que sean errores."""
        try:
            self.compila(self.build, *objetivos)
        except Fallo:
            self.perdona_avisos()
            self.compila(self.build, *objetivos)

    def perdona_avisos(self):
        """Un Fallo, si no ha sido por ellos."""
        if "[-Werror" not in (self.build / "compila.log").read_text(errors="replace"):  # sin corchete, en cada orden
            self.no_sale("no compila")
        self.configura("release", self.build, "-DLAB_AVISOS_SON_ERRORES=OFF")

    def no_sale(self, que):
        if shutil.disk_usage(self.build).free < 1 << 20:
            raise Fallo(f"no puedo escribir en {self.build}: ¿queda sitio en el disco?")
        raise Fallo(que)
