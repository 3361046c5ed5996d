"""La gráfica de una técnica: error frente a tiempo, con gnuplot."""
import math

from base.procesos import ejecuta, escribe

ANCHO, ALTO, MARGEN = 860, 480, (80, 20, 20, 60)  # del SVG: izquierda, derecha, arriba, abajo
ROJO, AZUL, GRIS = "#a3260f", "#1f5f9e", "#5f6b78"


def color(v):
    return ROJO if v.elegida else GRIS if v.optima is False else AZUL


def decadas(valores):
    return 10 ** math.floor(math.log10(min(valores) * 0.8)), 10 ** math.ceil(math.log10(max(valores) * 1.25))


def coloca(puntos, textos):
    """Dónde va el rótulo de cada punto (x, y en píxeles desde abajo) para que ninguno tape a otro ni a un punto."""
    ocupado = [(x - 5, y - 5, x + 5, y + 5) for x, y in puntos]
    lugares = []
    for (x, y), texto in zip(puntos, textos):
        largo = 6.9 * len(texto)
        altos = (lado * dy for dy in (13, 26, 39, 52, 65) for lado in (1, -1))
        opciones = [(x + dx, y + dy) for dy in altos for dx in (3, -largo / 2, -largo - 3)]

        def caja(lugar):
            return lugar[0] - 3, lugar[1] - 6, lugar[0] + largo + 3, lugar[1] + 6

        def estorbo(lugar):
            a, b, c, d = caja(lugar)
            fuera = a < MARGEN[0] or c > ANCHO - MARGEN[1] or b < MARGEN[3] or d > ALTO - MARGEN[2]
            return 100 * fuera + sum(a < o[2] and o[0] < c and b < o[3] and o[1] < d for o in ocupado)

        mejor = min(opciones, key=estorbo)
        ocupado.append(caja(mejor))
        lugares.append(mejor)
    return lugares


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
    # en el eje del tiempo, sitio para los nombres; en el del error, una década más para el 0 y el infinito
    izquierda, derecha = min(v.minimo for v in con_error) / 1.3, max(v.maximo for v in con_error) * 1.6
    abajo, arriba = decadas(finitos)
    abajo /= 10 if 0 in [v.error for v in con_error] else 1
    arriba *= 10 if math.inf in [v.error for v in con_error] else 1

    def y(v):
        return abajo * 1.5 if v.error == 0 else arriba / 1.5 if v.error == math.inf else v.error

    def en_pixeles(v):
        x = math.log(v.mediana / izquierda) / math.log(derecha / izquierda)
        alto = math.log(y(v) / abajo) / math.log(arriba / abajo)
        return MARGEN[0] + x * (ANCHO - MARGEN[0] - MARGEN[1]), MARGEN[3] + alto * (ALTO - MARGEN[2] - MARGEN[3])

    def texto(v):
        return v.nombre + (" (0)" if v.error == 0 else " (no vale)" if v.error == math.inf else "")

    def datos(nombre, variantes):
        filas = [f"{v.mediana:g} {y(v):g} {v.minimo:g} {v.maximo:g}" for v in variantes]
        return [f"${nombre} << FIN", *(filas or ["NaN NaN NaN NaN"]), "FIN"]

    guion, trozos = cabecera(tecnica, izquierda, derecha, abajo, arriba), []
    for n, grupo in enumerate(dict.fromkeys(v.grupo for v in con_error)):
        frente = [v for v in con_error if v.grupo == grupo and v.optima is not False]
        guion += datos(f"frente{n}", sorted(frente, key=lambda v: v.mediana))
        trozos.append(f"$frente{n} using 1:2 with lines lw 2 lc rgb '#84b8ee'")
    for clase, tipo in (GRIS, 6), (AZUL, 7), (ROJO, 7):
        nombre = f"c{clase[1:]}"
        guion += datos(nombre, [v for v in con_error if color(v) == clase])
        trozos.append(f"${nombre} using 1:2:3:4 with xerrorbars pt {tipo} ps 0.8 lc rgb '{clase}'")
    for v, (px, py) in zip(con_error, coloca(list(map(en_pixeles, con_error)), list(map(texto, con_error)))):
        donde = f"screen {px / ANCHO},{py / ALTO}"
        guion.append(f'set label "{texto(v)}" at {donde} noenhanced textcolor rgb "{color(v)}"')
    guion.append("plot " + ", ".join(trozos))
    escribe(svg, ejecuta(["gnuplot"], input="\n".join(guion), text=True))
    return True
