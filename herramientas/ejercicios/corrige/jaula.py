"""Ejecutar lo que no es de fiar: en una jaula (bwrap), con límites, y de ella solo sale un tar que se lee hasta un
límite."""
import io
import os
import random
import re
import subprocess
import tarfile
import tempfile
from contextlib import suppress
from pathlib import Path

from base.procesos import Fallo, lanza

APPARMOR = Path("/proc/sys/kernel/apparmor_restrict_unprivileged_userns")
SALE = 96 << 20  # bytes que se leen de una jaula
DISCO = 64 << 20  # de la carpeta temporal, que está en memoria
NADIE = range(61184, 65520)  # de root no valen los límites: se ejecuta como uno de estos, que no son nadie
SALEN = re.compile(r"estado|salida|errores|titulos|tiempos|programa|cuadro\.json|\d{3}\.ppm")
NO_ACABA = 124, 137, 152  # timeout; timeout -k, si ha pasado ese tiempo; y el límite de procesador

# Lo que se ejecuta en la jaula: SEGUNDOS ORDEN…; lo que deja sale en un tar. Los shaders ya compilados, de
# LAB_SHADERS, se copian: así lo ajeno no los estropea, y cada vez se ahorra tres cuartos de lo que tarda.
ENCIERRA = """segundos=$1; shift
[ ! -d "$LAB_SHADERS" ] || cp -r "$LAB_SHADERS" shaders
antes=$(date +%s)
timeout -k 1 "$segundos" "$@" >salida 2>errores
estado=$?
times >tiempos
[ $estado != 137 ] || [ $(($(date +%s) - antes)) -ge "$segundos" ] || estado=mata # a timeout, que lo vigilaba
echo $estado >estado
exec tar -cf - --exclude=./shaders ."""


def por_apparmor():
    """Lo que hay que hacer en Ubuntu, desde la 23.10, para que bwrap pueda encerrar."""
    with suppress(OSError):
        if APPARMOR.read_text().strip() == "1":
            return (
                "Es que Ubuntu no deja crear espacios de nombres a quien no es root: "
                "«sudo sysctl kernel.apparmor_restrict_unprivileged_userns=0» lo permite hasta que se apague, o "
                "dale permiso solo a bwrap (docs/corrige.md). "
            )
    return ""


class Jaula:
    """Donde se ejecuta lo que no es de fiar: sin red, sin más ficheros que los que se le dan y con límites."""

    def __init__(self, raiz):
        self.root = os.geteuid() == 0
        aparte = [f"--unshare-{que}" for que in ("ipc", "pid", "net", "uts", "cgroup-try")]
        self.prefijo = ["bwrap", *(aparte if self.root else ["--unshare-all"])]
        self.prefijo += "--die-with-parent --new-session --proc /proc --dev /dev --dir /etc".split()
        for carpeta in ("bin", "lib", "lib64"):  # en todos los sistemas de ahora son enlaces
            self.prefijo += ["--symlink", f"usr/{carpeta}", f"/{carpeta}"]
        for que in ("/usr", "/etc/alternatives", "/etc/ld.so.cache"):
            self.prefijo += ["--ro-bind-try", que, que]
        if raiz.is_relative_to("/usr"):  # el laboratorio no es del sistema
            self.prefijo += ["--tmpfs", raiz]
        for carpeta in ("/trabajo", "/tmp"):
            self.prefijo += ["--perms", "1777", "--size", DISCO, "--tmpfs", carpeta]
        self.prefijo += ["--chdir", "/trabajo"]

    def comprueba(self):
        try:
            prueba = lanza([*self.orden([]), "true"], text=True)
            dice = prueba.stderr.strip() if prueba.returncode else ""
        except Fallo as fallo:
            dice = str(fallo)
        if dice:
            raise Fallo(
                f"no se puede encerrar lo que no es de fiar: {dice.splitlines()[0]}. {por_apparmor()}Con --sin-jaula "
                "se corrige sin encerrarlo, si la máquina es para eso o lo entregado es tuyo"
            )

    def orden(self, ve):
        """Con qué palabras empieza una orden encerrada, que ve además esas rutas."""
        padres = dict.fromkeys(
            str(p) for que in ve for p in list(Path(que).parents)[-2::-1]
        )  # las que hace bwrap solo las ve su dueño
        monta = [*(p for que in padres for p in ("--dir", que)), *(p for que in ve for p in ("--ro-bind", que, que))]
        # sin ser root, lo que bwrap hace para montar es de quien lo ejecuta, y podría llenar la memoria
        cierra = "--remount-ro /dev --remount-ro / --".split()
        return [*self.prefijo, *monta, *cierra, *(self.otro() if self.root else [])]

    def otro(self):
        quien = random.SystemRandom().choice(NADIE)
        sin_nada = ["--clear-groups", "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs"]
        return ["setpriv", f"--reuid={quien}", f"--regid={quien}", *sin_nada, "--"]


class Recinto:
    """Ejecuta lo propio en una carpeta temporal, y lo ajeno, en la jaula, que puede no haber."""

    def __init__(self, temporal, jaula, entorno):
        self.temporal, self.jaula, self.entorno = temporal, jaula, entorno

    def propio(self, orden, limites, antes=(), **entorno):
        """Lo que deja una orden, en un tar."""
        with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
            return self.ejecuta(antes, limites, orden, aqui, HOME=aqui, TMPDIR=aqui, **entorno)

    def ajeno(self, orden, limites, ve, **entorno):
        """Lo mismo, de una que no es de fiar y que solo ve, además del sistema, esas rutas."""
        segundos = limites["procesador"]
        topes = {"cpu": f"{segundos}:{segundos + 1}", "as": limites["memoria"], "fsize": DISCO, "core": 0}
        if self.jaula:  # fuera de ella contaría también todos los que ya tiene quien corrige
            topes["nproc"] = limites["procesos"]
        prlimit = ["prlimit", *(f"--{que}={tope}" for que, tope in topes.items()), "--"]  # cpu: el segundo mata
        if not self.jaula:
            return self.propio(orden, limites, prlimit, **entorno)
        antes = [*self.jaula.orden(ve), *prlimit]
        return self.ejecuta(antes, limites, orden, "/", HOME="/trabajo", TMPDIR="/trabajo", **entorno)

    def ejecuta(self, antes, limites, orden, carpeta, **entorno):
        encerrada = [*antes, "sh", "-c", ENCIERRA, "sh", limites["segundos"], *orden]
        try:  # de lo ajeno se lee hasta un límite, aunque escriba donde no debe
            return lanza(
                ["sh", "-c", f'"$@" | head -c {SALE}', "sh", *encerrada],
                timeout=limites["segundos"] + 10,
                stderr=subprocess.DEVNULL,
                cwd=carpeta,
                env={**self.entorno, **entorno},
            ).stdout
        except subprocess.TimeoutExpired:
            return b""


def desempaqueta(datos):
    """Los ficheros corrientes de un tar que ha podido escribir cualquiera, hasta donde se pueda leer."""
    ficheros = {}
    try:
        with tarfile.open(fileobj=io.BytesIO(datos), mode="r|") as tar:
            for miembro in tar:
                nombre = miembro.name.removeprefix("./")
                if miembro.isreg() and not miembro.issparse() and SALEN.fullmatch(nombre):
                    ficheros.setdefault(nombre, tar.extractfile(miembro).read())
    except Exception:  # pylint: disable=broad-except  # está cortado o estropeado, y puede ser de cualquier manera
        pass
    return ficheros
