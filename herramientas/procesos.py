"""Ejecutar un programa y quedarse con lo que escribe; qué pruebas hay en uno de GoogleTest."""
import subprocess


class Fallo(Exception):
    pass


def ejecuta(orden, **opciones):
    """Lo que escribe; si no acaba bien o, con timeout, a tiempo, un Fallo que lo dice."""
    try:
        proceso = subprocess.run([str(palabra) for palabra in orden], stdin=subprocess.DEVNULL, capture_output=True, **opciones)
    except subprocess.TimeoutExpired as lento:
        raise Fallo(f"no ha acabado en {lento.timeout} segundos") from None
    if proceso.returncode:
        errores = proceso.stderr if opciones.get("text") else proceso.stderr.decode(errors="replace")
        raise Fallo(errores.strip() or f"{orden[0]} ha acabado con estado {proceso.returncode}")
    return proceso.stdout


def pruebas_de(ejecutable):
    """«GiroEje.AnguloPequeno» de cada TEST."""
    grupo, pruebas = "", []
    for linea in ejecuta([ejecutable, "--gtest_list_tests"], text=True).splitlines():
        nombre = linea.split("#")[0].strip()
        if linea.startswith(" "):
            pruebas.append(grupo + nombre)
        else:
            grupo = nombre
    return pruebas
