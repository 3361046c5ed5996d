#!/usr/bin/env python3
"""mide.py RAÍZ BUILD DESTINO [--ensayo] [TÉCNICA…]: cronometra las técnicas de herramientas/mide y el coste de los programas, y
escribe DESTINO/index.html, con un TSV y un SVG por técnica.

Sin técnicas se miden todas y la tabla de costes. --ensayo: tallas diminutas; comprueba que cada TSV está bien formado y que
los errores son los de herramientas/mide/ensayo.tsv, y no escribe nada; con --apunta, escribe ese fichero. LAB_PARES=1 añade los
programas con los que se compara.
"""
import math
import os
import platform
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

import pagina

CABECERA = "variante\tgrupo\tmediana\tmínimo\tmáximo\terror\tnota"
ANCHO, ALTO, MARGEN = 860, 480, (80, 20, 20, 60)  # del SVG: izquierda, derecha, arriba, abajo
TALLAS = ("960x720", "1920x1080")
ESPERADOS = "herramientas/mide/ensayo.tsv"
# Lo que deben ganar los programas: tiempo de la primera variante entre el de la segunda
METAS = (("la superficie a 0.5 px, frente a GLU con no menos error", "superficies", "par: GLU, pidiendo 0.04 px", "cota de la tira, 0.5 px", 10),
         ("separable de 15×15, frente a la directa", "convolucion", "directa, 15×15", "separable, float, 15×15", 5),
         ("separable de 15×15, frente a ImageMagick", "convolucion", "par: ImageMagick, 15×15", "separable, float, 15×15", 1),
         ("el volumen de ruido, frente a libnoise", "ruido_volumen", "par: libnoise, normal", "texelsRuido", 1),
         ("un millón de partículas, frente a los puntos pelados", "particulas", "suelo: un millón de puntos quietos", "un millón, fórmula en la GPU", 0.8))


class Fallo(Exception):
    pass


@dataclass
class Variante:
    nombre: str
    grupo: str
    mediana: float
    minimo: float
    maximo: float
    error: float
    nota: str
    elegida: bool = False
    optima: bool = False  # en el frente de Pareto de su grupo: ninguna tan exacta tarda menos que su mejor vuelta
    imagen: str = ""

    @property
    def par(self):
        return self.nombre.startswith("par: ")


@dataclass
class Tecnica:
    nombre: str
    titulo: str
    tiempo: str
    error: str
    elegida: str
    por_que: str
    variantes: list = field(default_factory=list)
    imagenes: list = field(default_factory=list)

    @property
    def frente_a_pares(self):
        """(par, elegida, cuántas veces tarda el par lo que la elegida, cuántas veces se equivoca)."""
        return [(par, v, par.mediana / v.mediana, par.error / v.error if v.error else math.nan)
                for par in self.variantes if par.par for v in self.variantes if v.elegida and v.grupo == par.grupo]

    @property
    def elegida_fuera(self):
        return [v for v in self.variantes if v.elegida and not v.optima]


def ejecuta(orden, **opciones):
    proceso = subprocess.run([str(o) for o in orden], stdin=subprocess.DEVNULL, capture_output=True, text=True, **opciones)
    if proceso.returncode:
        raise Fallo(proceso.stderr.strip() or f"{orden[0]} ha acabado con estado {proceso.returncode}")
    return proceso.stdout


def lee_variantes(fichero):
    """Una fila por variante, con siete columnas: si no, el TSV está mal formado."""
    variantes = []
    for fila in fichero.read_text().splitlines():
        campos = fila.split("\t")
        if len(campos) != 7 or "" in campos:
            raise Fallo(f"{fichero.name}: una fila no tiene siete columnas: «{fila}»")
        v = Variante(campos[0], "" if campos[1] == "-" else campos[1], *map(float, campos[2:6]), "" if campos[6] == "-" else campos[6])
        if not 0 < v.minimo <= v.mediana <= v.maximo < math.inf or v.error < 0:
            raise Fallo(f"{fichero.name}: los números de «{v.nombre}» no tienen sentido")
        variantes.append(v)
    if len({v.nombre for v in variantes}) != len(variantes) or not variantes:
        raise Fallo(f"{fichero.name}: hay variantes repetidas o ninguna")
    return variantes


def marca(tecnica):
    """Las del frente de Pareto, grupo a grupo, y las que usan los programas."""
    for v in tecnica.variantes:
        v.elegida = bool(tecnica.elegida) and (v.nombre + ",").startswith(tecnica.elegida + ",")
        rivales = [r for r in tecnica.variantes if r.grupo == v.grupo and not r.par]
        v.optima = not math.isnan(v.error) and not any(r.mediana < v.minimo and r.error <= v.error for r in rivales)


# --- La gráfica ---------------------------------------------------------------------------------------------------


def decadas(valores):
    return 10 ** math.floor(math.log10(min(valores) * 0.8)), 10 ** math.ceil(math.log10(max(valores) * 1.25))


def coloca(puntos, textos):
    """Dónde va el rótulo de cada punto (x, y en píxeles desde abajo) para que ninguno tape a otro ni a un punto."""
    ocupado = [(x - 5, y - 5, x + 5, y + 5) for x, y in puntos]
    lugares = []
    for (x, y), texto in zip(puntos, textos):
        largo = 6.9 * len(texto)
        opciones = [(x + dx, y + dy) for dy in (13, -13, 26, -26, 39, -39, 52, -52, 65, -65) for dx in (-4, -largo / 2, 4 - largo)]

        def cajas(lugar):
            return lugar[0], lugar[1] - 6, lugar[0] + largo, lugar[1] + 6

        def estorbo(lugar):
            a, b, c, d = cajas(lugar)
            fuera = a < MARGEN[0] or c > ANCHO or b < MARGEN[3] or d > ALTO
            return 100 * fuera + sum(a < o[2] and o[0] < c and b < o[3] and o[1] < d for o in ocupado)

        mejor = min(opciones, key=estorbo)
        ocupado.append(cajas(mejor))
        lugares.append(mejor)
    return lugares


def dibuja(tecnica, svg):
    """Error frente a tiempo, los dos en logaritmo, con el frente de cada grupo unido y el nombre de cada variante."""
    con_error = [v for v in tecnica.variantes if not math.isnan(v.error)]
    finitos = [v.error for v in con_error if 0 < v.error < math.inf]
    if not finitos:
        return False
    abajo, arriba = decadas(finitos)
    if any(v.error == 0 for v in con_error):
        abajo /= 10
    if any(v.error == math.inf for v in con_error):
        arriba *= 10
    izquierda, derecha = min(v.minimo for v in con_error) / 1.3, max(v.maximo for v in con_error) * 1.6

    def y(v):
        return abajo * 1.5 if v.error == 0 else arriba / 1.5 if v.error == math.inf else v.error

    def en_pixeles(v):
        def parte(x, a, b):
            return math.log(x / a) / math.log(b / a)
        return (MARGEN[0] + parte(v.mediana, izquierda, derecha) * (ANCHO - MARGEN[0] - MARGEN[1]),
                MARGEN[3] + parte(y(v), abajo, arriba) * (ALTO - MARGEN[2] - MARGEN[3]))

    def texto(v):
        return v.nombre + (" (0)" if v.error == 0 else " (no vale)" if v.error == math.inf else "")

    def datos(nombre, variantes):
        filas = [f"{v.mediana:g} {y(v):g} {v.minimo:g} {v.maximo:g}" for v in variantes]
        return [f"${nombre} << FIN", *(filas or ["NaN NaN NaN NaN"]), "FIN"]

    lugares = coloca([en_pixeles(v) for v in con_error], [texto(v) for v in con_error])
    grupos = [[v for v in sorted(con_error, key=lambda v: v.mediana) if v.grupo == g and v.optima] for g in dict.fromkeys(v.grupo for v in con_error)]
    guion = [
        f"set terminal svg size {ANCHO},{ALTO} font 'sans-serif,12' background rgb 'white'", f"set output '{svg}'",
        f"set lmargin at screen {MARGEN[0] / ANCHO}", f"set rmargin at screen {1 - MARGEN[1] / ANCHO}",
        f"set bmargin at screen {MARGEN[3] / ALTO}", f"set tmargin at screen {1 - MARGEN[2] / ALTO}",
        "set logscale xy", "set format x '%g'", "set format y '10^{%T}'", f"set xrange [{izquierda}:{derecha}]", f"set yrange [{abajo}:{arriba}]",
        f'set xlabel "{tecnica.tiempo}"', f'set ylabel "{tecnica.error}"', "set grid lc rgb '#e2dfd9'", "unset key"]
    for v, (px, py) in zip(con_error, lugares):
        color = "#a3260f" if v.elegida else "#1f5f9e" if v.optima else "#5f6b78"
        guion.append(f'set label "{texto(v)}" at screen {px / ANCHO},{py / ALTO} noenhanced textcolor rgb "{color}"')
    for clase, elige in (("otras", lambda v: not v.optima and not v.elegida), ("optimas", lambda v: v.optima and not v.elegida),
                         ("elegidas", lambda v: v.elegida)):
        guion += datos(clase, [v for v in con_error if elige(v)])
    trozos = []
    for n, grupo in enumerate(grupos):
        guion += datos(f"frente{n}", grupo)
        trozos.append(f"$frente{n} using 1:2 with lines lw 2 lc rgb '#84b8ee'")
    for clase, color, tipo in (("otras", "#98a3af", 6), ("optimas", "#1f5f9e", 7), ("elegidas", "#a3260f", 7)):
        trozos.append(f"${clase} using 1:2:3:4 with xerrorbars pt {tipo} ps 0.8 lc rgb '{color}'")
    guion.append("plot " + ", ".join(trozos))
    subprocess.run(["gnuplot"], input="\n".join(guion), text=True, check=True, capture_output=True)
    return True


# --- Técnicas -----------------------------------------------------------------------------------------------------


def imagenes(tecnica, carpeta, destino):
    """La mejor, la elegida y la peor, cada una con su diferencia con lo exacto por ocho."""
    con_imagen = []
    for n, v in enumerate(tecnica.variantes, 1):
        if (carpeta / f"{tecnica.nombre}-{n}.ppm").exists():
            con_imagen.append((v, n))
    if not con_imagen:
        return
    por_error = sorted(con_imagen, key=lambda vn: vn[0].error)
    ensena = {"la mejor": por_error[0], "la elegida": next((vn for vn in con_imagen if vn[0].elegida), por_error[0]), "la peor": por_error[-1]}
    for papel, (v, n) in ensena.items():
        ficheros = []
        for sufijo in ("", "-diferencia"):
            ppm = carpeta / f"{tecnica.nombre}-{n}{sufijo}.ppm"
            if ppm.exists():
                png = destino / f"{ppm.stem}.png"
                with png.open("wb") as f:
                    subprocess.run(["pnmtopng", "-quiet", str(ppm)], stdout=f, check=True)
                ficheros.append(png.name)
        tecnica.imagenes.append((papel, v, ficheros))


def mide(ejecutable, tecnica, destino, ensayo):
    with tempfile.TemporaryDirectory() as temporal:
        carpeta = Path(temporal)
        ejecuta([ejecutable, *(["--ensayo"] if ensayo else []), carpeta, tecnica.nombre])
        tecnica.variantes = lee_variantes(carpeta / f"{tecnica.nombre}.tsv")
        marca(tecnica)
        if tecnica.elegida and not any(v.elegida for v in tecnica.variantes):
            raise Fallo(f"ninguna variante se llama «{tecnica.elegida}»")
        if ensayo:
            return
        (destino / f"{tecnica.nombre}.tsv").write_text(CABECERA + "\n" + (carpeta / f"{tecnica.nombre}.tsv").read_text())
        imagenes(tecnica, carpeta, destino)
        dibuja(tecnica, destino / f"{tecnica.nombre}.svg")


# --- Ensayo -------------------------------------------------------------------------------------------------------


def comprueba_marca():
    def v(nombre, tiempo, error, grupo=""):
        return Variante(nombre, grupo, tiempo, 0.9 * tiempo, 1.1 * tiempo, error, "")
    t = Tecnica("", "", "", "", "b", "", [v("a", 1, 3), v("b", 2, 1), v("b, x", 3, 1), v("bc", 2.1, 1), v("par: d", 0.1, 0), v("e", 9, 9, "otro")])
    marca(t)
    if [x.nombre for x in t.variantes if x.elegida] != ["b", "b, x"] or [x.nombre for x in t.variantes if not x.optima] != ["b, x"]:
        raise Fallo("el frente de Pareto o la variante elegida se marcan mal")


def comprueba(tecnica, esperados):
    """Los errores del ensayo son siempre los mismos, salvo el redondeo: si no, se ha roto una variante o la cuenta de su error."""
    hay = {v.nombre: v.error for v in tecnica.variantes if v.nombre in esperados or not v.par}
    if hay.keys() != esperados.keys():
        raise Fallo(f"sobran o faltan variantes: {', '.join(hay.keys() ^ esperados.keys())}")
    for nombre, error in hay.items():
        e = esperados[nombre]
        if error != e and not abs(error - e) <= 0.15 * e + 0.001 and not (math.isnan(error) and math.isnan(e)):
            raise Fallo(f"«{nombre}» se equivoca {error:g} y se esperaba {e:g}")


# --- Coste de los programas ---------------------------------------------------------------------------------------


@dataclass
class Coste:
    programa: str
    arranque: float  # ms de arrancar a tener el PPM de 240×180
    primera: float  # los de la primera imagen, con lo que se compila al dibujarla
    veces_suelo: float
    ms: list  # por imagen, en cada una de TALLAS
    veces_llenar: float  # la mayor, entre llenarla de un color
    primitivas: int
    buferes: int
    texturas: int
    errores: list  # máximo, RMSE y borde frente a su oráculo, como están en docs/exactitud.md


def metas(tecnicas, tabla, suelo, golden):
    """(qué, cifra, la que se pide, si debe ser mayor) de cada meta que se ha podido medir."""
    tiempo = {(t.nombre, v.nombre): v.mediana for t in tecnicas for v in t.variantes}
    filas = [(f"{que}, veces más rápido", tiempo[t, lenta] / tiempo[t, rapida], pide, True)
             for que, t, lenta, rapida, pide in METAS if (t, lenta) in tiempo and (t, rapida) in tiempo]
    veces = [c.veces_suelo for c in tabla]
    if veces and not math.isnan(veces[0]):
        filas += [("arranque de un programa entre el suelo: mediana", statistics.median(veces), 1.25, False),
                  ("arranque de un programa entre el suelo: el peor", max(veces), 2.5, False)]
    if golden:
        filas.append(("los golden, entre casos × suelo / núcleos", golden / suelo, 1.5, False))
    return filas


def cronometra(orden, carpeta):
    antes = time.perf_counter()
    ejecuta(orden, cwd=carpeta)
    return 1000 * (time.perf_counter() - antes)


def avisa(texto, fin="\n"):
    """Por dónde va: en una terminal, en la misma línea."""
    print(f"\r\033[K{texto}" if sys.stderr.isatty() else texto, end=fin if sys.stderr.isatty() else "\n", file=sys.stderr, flush=True)


def errores(raiz):
    """De cada programa, el máximo, el RMSE y el borde que dice docs/exactitud.md; vacío, lo que no se mide."""
    filas = (linea.split(" | ") for linea in (raiz / "docs/exactitud.md").read_text().splitlines() if linea.startswith("| "))
    return {fila[0][2:]: [c.strip() for c in fila[2:5]] for fila in filas if len(fila) == 6}


def costes(raiz, build, destino, llenar, vueltas=5):
    """Cada programa: lo que tarda en arrancar frente al suelo, alternados; y por imagen, con -mide."""
    sin_ventana = (build / "sin_ventana").read_text().strip()
    suelo = build / "herramientas/mide/suelo_osmesa"
    programas = [p for capitulo in pagina.lee_catalogo(build) for p in capitulo.programas if not p.consola]
    comprobado = errores(raiz)
    tabla, suelos = [], []
    with tempfile.TemporaryDirectory() as carpeta:
        for n, p in enumerate(programas, 1):
            avisa(f"costes {n}/{len(programas)}: {p.nombre}", "")
            ejecutable = build / sin_ventana / p.capitulo / p.nombre
            arranques, ms = [], []
            for _ in range(vueltas):
                if suelo.exists():
                    suelos.append(cronometra([suelo, "x.ppm"], carpeta))
                arranques.append(cronometra([ejecutable, "-geometry", "240x180", "-ppm", "x.ppm"], carpeta))
            for talla in TALLAS:
                campos = ejecuta([ejecutable, "-geometry", talla, "-mide", "5", "-ppm", "x.ppm"], cwd=carpeta).splitlines()[-1].split("\t")
                ms.append(float(campos[3]))
            tabla.append(Coste(p.nombre, statistics.median(arranques), float(campos[2]), math.nan, ms, ms[-1] / llenar, int(campos[6]), int(campos[8]),
                               int(campos[9]), comprobado[p.nombre]))
    avisa(f"costes: {len(tabla)} programas")
    suelo = statistics.median(suelos) if suelos else math.nan
    with (destino / "costes.tsv").open("w") as f:
        print("programa", "arranque ms", "primera ms", "veces el suelo", *(f"ms {t}" for t in TALLAS), "veces llenar", "primitivas", "bytes de buffers",
              "bytes de texturas", "error máximo", "error RMSE", "borde px", sep="\t", file=f)
        for c in tabla:
            c.veces_suelo = c.arranque / suelo
            print(c.programa, f"{c.arranque:.1f}", f"{c.primera:.1f}", f"{c.veces_suelo:.2f}", *(f"{x:.1f}" for x in c.ms), f"{c.veces_llenar:.1f}",
                  c.primitivas, c.buferes, c.texturas, *(e or "-" for e in c.errores), sep="\t", file=f)
    return tabla, suelo


# --- Compilar y probar --------------------------------------------------------------------------------------------


def segundos_de_cpu(orden, carpeta):
    antes = resource.getrusage(resource.RUSAGE_CHILDREN)
    ejecuta(orden, cwd=carpeta)
    despues = resource.getrusage(resource.RUSAGE_CHILDREN)
    return despues.ru_utime + despues.ru_stime - antes.ru_utime - antes.ru_stime


def compilacion(build):
    """(qué, cifra con su unidad): compilar un programa, con la cabecera precompilada y sin ella; y pasar los golden. Además, los ms
    de un núcleo por golden."""
    ordenes = {}
    for linea in ejecuta(["ninja", "-C", build, "-t", "commands", "programas"]).splitlines():
        if re.search(r"-c \S+/ch\d\d_\w+/\w+\.cpp$", linea):
            ordenes[linea.split("/")[-1]] = [x for x in linea.split() if x != "ccache"]
    con, sin = [], []
    for orden in list(ordenes.values())[::9]:
        con.append(segundos_de_cpu(orden, build))
        i = orden.index("-include")
        sin.append(segundos_de_cpu(orden[:i] + orden[i + 2:], build))
    filas = [("compilar un programa", f"{statistics.median(con):.2f} s de procesador"),
             ("sin la cabecera precompilada", f"{statistics.median(sin):.2f} s de procesador"),
             ("fuentes de programas", f"{len(ordenes)}")]
    ms = None
    if (build / "tests" / "compara").exists():
        sin_ventana = (build / "sin_ventana").read_text().strip()
        antes = time.perf_counter()
        salida = ejecuta(["ctest", "--test-dir", build, "-j", str(os.cpu_count()), "-R", rf"^imagen\.{sin_ventana}\."])
        segundos, casos = time.perf_counter() - antes, int(re.search(r"out of (\d+)", salida)[1])
        ms = 1000 * segundos * os.cpu_count() / casos
        filas.append((f"pasar los {casos} golden", f"{segundos:.1f} s, con {os.cpu_count()} núcleos: {ms:.0f} ms de núcleo cada uno"))
    return filas, ms


def entorno(build):
    cpu = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text()) if Path("/proc/cpuinfo").exists() else None
    sin_ventana = (build / "sin_ventana").read_text().strip()
    info = ejecuta([build / sin_ventana / "ch01_intro" / "info_opengl"]).splitlines()
    return {"procesador": f"{cpu[1] if cpu else platform.machine()}, {os.cpu_count()} núcleos", "carga al empezar": f"{os.getloadavg()[0]:.2f}",
            "OpenGL": " · ".join(linea.strip() for linea in info[:3]), "sin ventana": sin_ventana,
            "compilador": ejecuta([os.environ.get("CXX", "c++"), "--version"]).splitlines()[0],
            "caché de shaders": "sin ella" if os.environ.get("MESA_SHADER_CACHE_DISABLE") == "true" else "la de Mesa",
            "pares": "sí" if os.environ.get("LAB_PARES") else "no", "fecha": time.strftime("%Y-%m-%d %H:%M")}


def main():
    raiz, build, destino = (Path(a).resolve() for a in sys.argv[1:4])
    apunta, ensayo = "--apunta" in sys.argv[4:], "--ensayo" in sys.argv[4:]
    pedidas = [a for a in sys.argv[4:] if a not in ("--ensayo", "--apunta")]
    esperados = {}
    if ensayo:
        comprueba_marca()
        for fila in (raiz / ESPERADOS).read_text().splitlines():
            nombre, variante, error = fila.split("\t")
            esperados.setdefault(nombre, {})[variante] = float(error)
    ejecutable = build / "herramientas" / "mide" / "mide"
    todas = [Tecnica(*fila.split("\t")) for fila in ejecuta([ejecutable, "--lista"]).splitlines()]
    for nombre in pedidas:
        if nombre not in [t.nombre for t in todas]:
            sys.exit(f"lab: no hay ninguna técnica «{nombre}»; hay {', '.join(t.nombre for t in todas)}")
    tecnicas = [t for t in todas if not pedidas or t.nombre in pedidas]
    if not ensayo:
        destino.mkdir(parents=True, exist_ok=True)
    datos = {} if ensayo else entorno(build)
    fallos = []
    for n, t in enumerate(tecnicas, 1):
        antes = time.monotonic()
        try:
            mide(ejecutable, t, destino, ensayo)
            if ensayo and not apunta:
                comprueba(t, esperados.get(t.nombre, {}))
            print(f"[{n:2}/{len(tecnicas)}] {t.nombre}: {len(t.variantes)} variantes, {time.monotonic() - antes:.1f} s", file=sys.stderr)
        except Fallo as fallo:
            fallos.append(t.nombre)
            print(f"[{n:2}/{len(tecnicas)}] {t.nombre} ha fallado: {fallo}", file=sys.stderr)
    if not ensayo:
        medidas = [t for t in tecnicas if t.variantes]
        tabla, suelo, compilar, golden = [], math.nan, [], None
        if not pedidas:
            llenar = next((v.mediana for t in medidas for v in t.variantes if v.nombre == f"llenar {TALLAS[-1].replace('x', '×')}"), math.nan)
            tabla, suelo = costes(raiz, build, destino, llenar)
            avisa("compilar y pasar los golden", "")
            compilar, golden = compilacion(build)
        pagina.escribe_informe(destino, tecnicas=medidas, metas=metas(medidas, tabla, suelo, golden), costes=tabla, suelo=suelo, compilar=compilar, entorno=datos)
        avisa(f"Hecho: {destino}/index.html")
    if apunta:
        esperados.update({t.nombre: {v.nombre: v.error for v in t.variantes if not v.par or "glm::" in v.nombre} for t in tecnicas})
        (raiz / ESPERADOS).write_text("".join(f"{t}\t{v}\t{e:g}\n" for t in esperados for v, e in esperados[t].items()))
    if fallos:
        sys.exit(f"lab: no se ha podido medir todo: {', '.join(fallos)}")


try:
    main()
except Fallo as fallo:
    sys.exit(f"lab: {fallo}")
except KeyboardInterrupt:
    sys.exit(130)
