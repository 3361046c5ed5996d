"""La forma del código que CONTRIBUTING pide y un compilador no ve."""
import re
from pathlib import Path

RAIZ = Path(__file__).parents[2]


def usos():
    """Cada fichero de un capítulo que se incluye o se carga desde otro (o desde common/), y desde dónde."""
    hay = {}
    for fuente in (*RAIZ.glob("common/*.*"), *RAIZ.glob("ch*/*.*")):
        if fuente.suffix in (".cpp", ".h", ".vert", ".frag", ".glsl"):
            for capitulo, fichero in re.findall(r'"(ch\d\d)_\w+/([\w.]+)"', fuente.read_text()):
                if not fuente.parent.name.startswith(capitulo):
                    hay.setdefault(f"{capitulo}/{fichero}", []).append(str(fuente.relative_to(RAIZ)))
    return hay


def test_lo_publico_de_cada_capitulo():
    """Lo que un capítulo usa de otro es justo lo que CONTRIBUTING llama público; `objeto.*` vale por objeto.h, .vert…"""
    dice = (RAIZ / "CONTRIBUTING.md").read_text()
    lista = re.search(r"De otro capítulo solo se usa lo público:(.*?)\.\s+La prueba `formas`", dice, re.S)[1]
    publico = {
        f"{capitulo}/{fichero}"
        for capitulo, ficheros in re.findall(r"(ch\d\d)((?:\s*`[^`]+`,?)+)", lista)
        for fichero in re.findall(r"`([^`]+)`", ficheros)
    }
    usado = usos()
    comodin = {nombre: re.sub(r"\.\w+$", ".*", nombre) for nombre in usado}
    colados = {n: usado[n] for n in usado if n not in publico and comodin[n] not in publico}
    assert not colados
    assert not {p for p in publico if p not in usado and p not in comodin.values()}, "nadie los usa"
