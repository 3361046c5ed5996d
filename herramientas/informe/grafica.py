"""La gráfica de una técnica: error frente a tiempo, con gnuplot."""
import math

from base.procesos import ejecuta, escribe

ANCHO, ALTO, MARGEN = 860, 480, (80, 20, 20, 60)  # del SVG: izquierda, derecha, arriba, abajo


def decadas(valores):
    return 10 ** math.floor(math.log10(min(valores) * 0.8)), 10 ** math.ceil(math.log10(max(valores) * 1.25))


def coloca(puntos, textos):
    """Dónde va el rótulo de cada punto (x, y en píxeles desde abajo) para que ninguno tape a otro ni a un punto."""
    ocupado = [(x - 5, y - 5, x + 5, y + 5) for x, y in puntos]
    lugares = []
    for (x, y), texto in zip(puntos, textos):
        largo = 6.9 * len(texto)
        opciones = [
            (x + dx, y + dy)
            for dy in (13, -13, 26, -26, 39, -39, 52, -52, 65, -65)
            for dx in (3, -largo / 2, -largo - 3)
        ]

        def cajas(lugar):
            return lugar[0] - 3, lugar[1] - 6, lugar[0] + largo + 3, lugar[1] + 6

        def estorbo(lugar):
            a, b, c, d = cajas(lugar)
            fuera = a < MARGEN[0] or c > ANCHO - MARGEN[1] or b < MARGEN[3] or d > ALTO - MARGEN[2]
            return 100 * fuera + sum(a < o[2] and o[0] < c and b < o[3] and o[1] < d for o in ocupado)

        mejor = min(opciones, key=estorbo)
        ocupado.append(cajas(mejor))
        lugares.append(mejor)
    return lugares


def limites(con_error, finitos):
    """De los ejes: el tiempo, con sitio para los nombres, y el error, con una década más para el 0 y el infinito."""
    abajo, arriba = decadas(finitos)
    if any(v.error == 0 for v in con_error):
        abajo /= 10
    if any(v.error == math.inf for v in con_error):
        arriba *= 10
    return min(v.minimo for v in con_error) / 1.3, max(v.maximo for v in con_error) * 1.6, abajo, arriba


def cabecera(tecnica, izquierda, derecha, abajo, arriba):
    """Lo que se le dice a gnuplot antes de los datos."""
    return [
        f"set terminal svg size {ANCHO},{ALTO} font 'sans-serif,12' background rgb 'white'",
        f"set lmargin at screen {MARGEN[0] / ANCHO}",
        f"set rmargin at screen {1 - MARGEN[1] / ANCHO}",
        f"set bmargin at screen {MARGEN[3] / ALTO}",
        f"set tmargin at screen {1 - MARGEN[2] / ALTO}",
        "set logscale xy",
        "set format x '%g'",
        "set format y '10^{%T}'",
        f"set xrange [{izquierda}:{derecha}]",
        f"set yrange [{abajo}:{arriba}]",
        f'set xlabel "{tecnica.tiempo}"',
        f'set ylabel "{tecnica.error}"',
        "set grid lc rgb '#e2dfd9'",
        "unset key",
    ]


def dibuja(tecnica, svg):
    """Error frente a tiempo, los dos en logaritmo, con el frente de cada grupo unido y el nombre de cada variante."""
    con_error = [v for v in tecnica.variantes if not math.isnan(v.error)]
    finitos = [v.error for v in con_error if 0 < v.error < math.inf]
    if not finitos:
        return False
    izquierda, derecha, abajo, arriba = limites(con_error, finitos)

    def y(v):
        return abajo * 1.5 if v.error == 0 else arriba / 1.5 if v.error == math.inf else v.error

    def en_pixeles(v):
        def parte(x, a, b):
            return math.log(x / a) / math.log(b / a)

        return (
            MARGEN[0] + parte(v.mediana, izquierda, derecha) * (ANCHO - MARGEN[0] - MARGEN[1]),
            MARGEN[3] + parte(y(v), abajo, arriba) * (ALTO - MARGEN[2] - MARGEN[3]),
        )

    def texto(v):
        return v.nombre + (" (0)" if v.error == 0 else " (no vale)" if v.error == math.inf else "")

    def datos(nombre, variantes):
        filas = [f"{v.mediana:g} {y(v):g} {v.minimo:g} {v.maximo:g}" for v in variantes]
        return [f"${nombre} << FIN", *(filas or ["NaN NaN NaN NaN"]), "FIN"]

    lugares = coloca([en_pixeles(v) for v in con_error], [texto(v) for v in con_error])
    grupos = [
        [v for v in sorted(con_error, key=lambda v: v.mediana) if v.grupo == g and v.optima is not False]
        for g in dict.fromkeys(v.grupo for v in con_error)
    ]
    guion = cabecera(tecnica, izquierda, derecha, abajo, arriba)
    for v, (px, py) in zip(con_error, lugares):
        color = "#a3260f" if v.elegida else "#1f5f9e" if v.optima is not False else "#5f6b78"
        guion.append(f'set label "{texto(v)}" at screen {px / ANCHO},{py / ALTO} noenhanced textcolor rgb "{color}"')
    for clase, elige in (
        ("otras", lambda v: v.optima is False and not v.elegida),
        ("optimas", lambda v: v.optima is not False and not v.elegida),
        ("elegidas", lambda v: v.elegida),
    ):
        guion += datos(clase, [v for v in con_error if elige(v)])
    trozos = []
    for n, grupo in enumerate(grupos):
        guion += datos(f"frente{n}", grupo)
        trozos.append(f"$frente{n} using 1:2 with lines lw 2 lc rgb '#84b8ee'")
    for clase, color, tipo in (("otras", "#98a3af", 6), ("optimas", "#1f5f9e", 7), ("elegidas", "#a3260f", 7)):
        trozos.append(f"${clase} using 1:2:3:4 with xerrorbars pt {tipo} ps 0.8 lc rgb '{color}'")
    guion.append("plot " + ", ".join(trozos))
    escribe(svg, ejecuta(["gnuplot"], input="\n".join(guion), text=True))
    return True
