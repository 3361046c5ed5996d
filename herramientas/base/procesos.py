"""Lo que comparten las órdenes: ejecutar un programa y quedarse con lo que escribe, dejar un fichero entero o nada, y
acabar en una línea cuando algo falla y enseguida, con todo lo que se haya puesto en marcha, cuando llega una señal."""
import errno
import os
import shutil
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager
from pathlib import Path

MOTIVOS = {
    errno.ENOSPC: "no queda sitio en el disco",
    errno.EDQUOT: "no queda sitio en el disco",
    errno.EACCES: "no hay permiso",
    errno.EROFS: "no se puede escribir ahí",
    errno.ENOENT: "no existe",
    errno.EISDIR: "es una carpeta",
    errno.ENOTDIR: "parte de la ruta no es una carpeta",
    errno.ENAMETOOLONG: "el nombre es demasiado largo",
}
SENALES = signal.SIGINT, signal.SIGTERM, signal.SIGHUP


class Fallo(Exception):
    pass


class Procesos:
    """Los que hay en marcha, cada uno en su grupo, y la señal que los acaba."""

    vivos, senal = set(), 0


def motivo(error):
    return MOTIVOS.get(error.errno, error.strerror)


def mata(proceso, senal=signal.SIGTERM):
    try:
        os.killpg(proceso.pid, senal)  # y a los que haya puesto en marcha
    except ProcessLookupError:
        pass


def acaba(senal, _):
    Procesos.senal = Procesos.senal or senal
    for proceso in list(Procesos.vivos):
        mata(proceso)


def si_hay_senal():
    if Procesos.senal:
        raise SystemExit(128 + Procesos.senal)


@contextmanager
def arranca(orden, **opciones):
    """Un proceso en un grupo suyo, que acaba con nosotros."""
    si_hay_senal()
    try:
        proceso = subprocess.Popen([str(palabra) for palabra in orden], start_new_session=True, **opciones)
    except FileNotFoundError as error:
        raise Fallo(f"no encuentro {error.filename}") from None
    Procesos.vivos.add(proceso)
    try:
        if Procesos.senal:  # ha llegado mientras
            mata(proceso)
        yield proceso
    except BaseException:
        mata(proceso, signal.SIGKILL)
        proceso.wait()
        raise
    finally:
        Procesos.vivos.discard(proceso)
    si_hay_senal()


def lanza(orden, input=None, timeout=None, **opciones):
    """subprocess.run con arranca; en un texto, lo que no es UTF-8 no rompe nada."""
    if opciones.get("text"):
        opciones.setdefault("errors", "replace")
    entra = subprocess.DEVNULL if input is None else subprocess.PIPE
    tuberias = {"stdin": entra, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with arranca(orden, **{**tuberias, **opciones}) as proceso:
        salida, errores = proceso.communicate(input, timeout)
    return subprocess.CompletedProcess(orden, proceso.returncode, salida, errores)


def ejecuta(orden, **opciones):
    """Lo que escribe; si no acaba bien o, con timeout, a tiempo, un Fallo que lo dice."""
    try:
        proceso = lanza(orden, **opciones)
    except subprocess.TimeoutExpired as lento:
        raise Fallo(f"no ha acabado en {lento.timeout} segundos") from None
    if proceso.returncode:
        errores = proceso.stderr if opciones.get("text") else proceso.stderr.decode(errors="replace")
        raise Fallo(errores.strip() or f"{orden[0]} ha acabado con estado {proceso.returncode}")
    return proceso.stdout


def por_donde(va=""):
    """En una terminal, en una línea que se pisa; sin nada, se borra."""
    if sys.stderr.isatty():
        print(f"\r\033[K{va.strip()[: shutil.get_terminal_size().columns - 1]}", end="", file=sys.stderr, flush=True)


def entorno(carpeta=Path(__file__).parent):
    """Las variables de su entorno.txt: el de aquí fija la imagen; el de build/ tiene además la caché de shaders de
    las pruebas."""
    return dict(linea.split("=", 1) for linea in (carpeta / "entorno.txt").read_text().splitlines())


def en_png(ppm, compresion=6):
    """El de un PPM. La compresión, de 1 a 9: con la de siempre cuesta tanto como dibujar."""
    return ejecuta(["pnmtopng", "-quiet", "-compression", compresion, ppm])


def escribe(fichero, datos):
    """Entero o nada: al lado, y en su sitio cuando ya está."""
    parcial = fichero.with_name(fichero.name + ".parcial")
    try:
        fichero.parent.mkdir(parents=True, exist_ok=True)
        parcial.write_bytes(datos if isinstance(datos, bytes) else datos.encode())
        parcial.replace(fichero)
    except OSError as error:
        raise Fallo(f"no puedo escribir «{fichero}»: {motivo(error)}") from None
    finally:
        parcial.unlink(missing_ok=True)


def acaba_bien(hace):
    """Con lo que dice hace(). Una señal, un Fallo o un disco lleno acaban con su estado y, como mucho, una línea."""
    if sys.stdout:
        sys.stdout.reconfigure(errors="replace")  # donde no cabe una letra, «?»
    try:
        resultado = hace()
        si_hay_senal()
        if sys.stdout:
            sys.stdout.flush()
        sys.exit(resultado)
    except Fallo as fallo:
        por_donde()
        sys.exit(f"lab: {fallo}")
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # si era la salida, que al acabar no se intente otra vez
        if error.errno == errno.EPIPE:  # quien la lee ya tiene bastante: ./lab lista | head
            sys.exit(128 + signal.SIGPIPE)
        sys.exit(f"lab: {error.filename or 'no puedo escribir'}: {motivo(error)}")


def principal(main):
    """main(), de un módulo de herramientas/."""
    for senal in SENALES:
        signal.signal(senal, acaba)

    def en_otro_hilo():
        # y aquí se espera a trozos: Python no atiende la señal que llega justo cuando se pone a esperar a un cerrojo
        with ThreadPoolExecutor(1) as hilo:
            trabajo = hilo.submit(main)
            while not trabajo.done():
                wait([trabajo], 0.1)
        return trabajo.result()

    acaba_bien(en_otro_hilo)
