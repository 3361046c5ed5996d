"""La nota de ./lab corrige de lo que hacen unos estudiantes: el punto de partida, la solución, la misma escrita de otra
manera, una pieza sola y algunos de los errores que se conocen. La página tiene que dar la misma (notas.mjs)."""
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, defectos
from base.marcas import TROZO
from ejercicios import comprueba, en_pagina, nuevo
from ejercicios.corrige import clase, piezas

AL_AZAR = 4  # guiones, además de los casos
ERRORES = 2


def programas(raiz, build):
    return en_pagina.los_que_hay(raiz, catalogo.lee_programas(build))


def entregas(c):
    """Sus ficheros, por lo que son."""
    bien = [m for m in defectos.lee(c.raiz / comprueba.BIEN)[0] if m.lista == c.ref][-1:]
    mal = c.banco.motivos.defectos
    hechas = dict(zip(("el punto de partida", "la solución"), c.banco.dados)) | {"a medias": a_medias(c)}
    otro_fondo = {f: t.replace("ponFondo(", "ponFondo(glm::vec3(0.3f) - ") for f, t in c.banco.dados[1].items()}
    hechas |= {"con otro fondo": otro_fondo} if otro_fondo != c.banco.dados[1] else {}
    for m in (*bien, *mal[:: max(1, -(-len(mal) // ERRORES))]):
        hechas[f"{m.nombre}, {m.imita}"] = con_sus_marcas(c, c.banco.motivos.estropeados(m))
    return hechas


def con_sus_marcas(c, textos):
    """Como quien lo hizo entre ellas: lo que no es de este ejercicio, sin las suyas."""
    suyas = {f: TROZO.sub(lambda t: t[0] if t["codigo"] == c.ref else nuevo.deja(t[0]), t) for f, t in textos.items()}
    return suyas if nuevo.es_de_shaders(c.ref) else nuevo.aqui(suyas, c.programa)


def a_medias(c):
    """El punto de partida con lo primero que se pide, hecho."""
    (_, hecho), *_ = c.banco.motivos.trozos()
    por_hacer = [t[0] for texto in c.banco.dados[0].values() for t in TROZO.finditer(texto)]
    return {f: texto.replace(por_hacer[0], hecho[0], 1) for f, texto in c.banco.dados[0].items()}


def de(raiz, build, ref):
    """Lo que se juega y, de cada entrega, sus ficheros y su nota; y lo que se juega si no se dice otra cosa."""
    programa = programas(raiz, build)[ref]
    cuantos = None if nuevo.es_de_shaders(ref) else AL_AZAR
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(2) as hilos:
        c = comprueba.Comprobacion(raiz, build, ref, programa, Path(temporal), hilos, cuantos)
        hechas = {}
        for i, (nombre, ficheros) in enumerate(entregas(c).items()):
            carpeta = Path(temporal, f"e{i}")
            carpeta.mkdir()
            for f, texto in ficheros.items():
                (carpeta / Path(f).name).write_text(texto)
            hecha = clase.corrige(c.banco, carpeta)
            hechas[nombre] = {"ficheros": ficheros, "nota": hecha["nota"], "piezas": hecha.get("piezas", [])}
            hechas[nombre]["dice"] = [d for d in hecha["dice"] if d.startswith(piezas.PARECE)]
    return {"datos": en_pagina.corrige(raiz, build, programa, ref, cuantos), "entregas": hechas}
