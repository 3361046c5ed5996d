"""Lo que usan las pruebas de ./lab corrige: entregas de toda clase, y un banco que ni compila ni juega."""
import os
import stat
import sys
import tarfile
import zipfile
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace

import pytest

from ejercicios.corrige.banco import Banco
from ejercicios.corrige.partidas import Guion
from ejercicios.reglas import Reglas
from mentira import BUILD, RAIZ, se_encierra

REF = "E3.5"
MOODLE = "_assignsubmission_file_"
UNO = {"p.cpp": "int main() {}", "p.h": ""}
configurado = (BUILD / "catalogo.json").exists()
con_catalogo = pytest.mark.skipif(not configurado, reason="no está configurado")
hay_comparador = (BUILD / "herramientas/comparador/compara").exists()
con_comparador = pytest.mark.skipif(not hay_comparador, reason="no está compilado")
con_jaula = pytest.mark.skipif(not (configurado and se_encierra()), reason="no se puede encerrar, o no está compilado")


def orden(*palabras):
    return [sys.executable, "-B", RAIZ / "herramientas", "ejercicios.corrige.orden", RAIZ, BUILD, *palabras]


def carpeta_de(sitio, ficheros):
    """Una entrega: de cada fichero, lo que tiene; un número, tantos bytes; una ruta, un enlace."""
    sitio.mkdir(parents=True, exist_ok=True)
    for fichero, contenido in ficheros.items():
        ruta = os.fsencode(sitio) + b"/" + os.fsencode(fichero)
        os.makedirs(os.path.dirname(ruta), exist_ok=True)
        if contenido is os.mkfifo:
            os.mkfifo(ruta)
        elif isinstance(contenido, Path):
            os.symlink(contenido, ruta)
        else:
            with open(ruta, "wb") as f:
                f.write(crudo(contenido))


def crudo(contenido):
    return bytes(contenido) if isinstance(contenido, (bytes, int)) else contenido.encode()


class Cruda(zipfile.ZipInfo):
    """Con un nombre que se escribe tal cual, como los de antes, que no dicen en qué están."""

    def _encodeFilenameFlags(self):
        return bytes(map(ord, self.filename)), 0


def en_zip(*miembros, como=zipfile.ZIP_DEFLATED):
    """De cada uno, su nombre, que puede ser de bytes, y lo que tiene, como en carpeta_de."""
    datos = BytesIO()
    with zipfile.ZipFile(datos, "w", como) as z:
        for nombre, contenido in miembros:
            info = zipfile.ZipInfo(nombre) if isinstance(nombre, str) else Cruda("".join(map(chr, nombre)))
            modo = stat.S_IFIFO if contenido is os.mkfifo else stat.S_IFREG
            modo = stat.S_IFLNK if isinstance(contenido, Path) else modo
            info.external_attr = (modo | 0o644) << 16
            z.writestr(info, crudo(contenido) if modo == stat.S_IFREG else b"/etc/passwd", como)
    return datos.getvalue()


def en_tar(comprimido, *miembros):
    """De cada uno, su nombre, lo que tiene y, si no es un fichero, lo que es."""
    datos = BytesIO()
    with tarfile.open(fileobj=datos, mode=f"w:{comprimido}") as t:
        for nombre, contenido, *tipo in miembros:
            info = tarfile.TarInfo(nombre)
            info.type, info.size, info.linkname = getattr(tarfile, *tipo or ["REGTYPE"]), len(contenido), "/etc/passwd"
            t.addfile(info, BytesIO(contenido))
    return datos.getvalue()


def banco_falso(temporal, **mas):
    """Un banco del que basta lo que no compila ni juega."""
    de_partida = {"p.cpp": "// lo de partida\nint main() {}\n", "p.h": ""}, "p.cpp"
    hay = {"ref": REF, "clave": "v", "semilla": "1", "temporal": temporal, "reglas": Reglas(), "raiz": RAIZ}
    hay |= {"todos": [Guion("caso", (), True), Guion("al azar", ("tecla a",))], "de_partida": de_partida}
    hay |= {"dados": (de_partida[0], {"p.cpp": "int main() {}\n", "p.h": "// algo"})}
    hay |= {"programa": SimpleNamespace(nombre="a", titulo="A", casos=[]), "arbitro": SimpleNamespace()}
    hay |= {"privados": {"ch03_transformaciones/grua.h"}, "de_otro": lambda ruta: Banco.de_otro(banco, ruta)}
    banco = SimpleNamespace(**hay | {"huella": lambda *que: Banco.huella(banco, *que)} | mas)
    return banco
