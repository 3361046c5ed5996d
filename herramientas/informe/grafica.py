"""La gráfica de una técnica: error frente a tiempo, con gnuplot."""
import math

from base.procesos import ejecuta, escribe

ROJO, AZUL, GRIS = "#a3260f", "#1f5f9e", "#5f6b78"
CABECERA = """set terminal svg size 860,480 font 'sans-serif,12' background rgb 'white'
set logscale xy
set format x '%g'
set format y '10^{%T}'
set grid lc rgb '#e2dfd9'
unset key"""


def color(v):
    return ROJO if v.elegida else GRIS if v.optima is False else AZUL


def dibuja(tecnica, svg):
    """Error frente a tiempo, los dos en logaritmo, con el frente de cada grupo unido y el número de cada variante en la
    tabla."""
    con_error = [(n, v) for n, v in enumerate(tecnica.variantes, 1) if not math.isnan(v.error)]
    errores = [v.error for _, v in con_error]
    finitos = [e for e in errores if 0 < e < math.inf]
    if not finitos:
        return False
    # décadas enteras, y una más para el 0 y el infinito
    abajo = 10 ** math.floor(math.log10(min(finitos) * 0.8)) / (10 if 0 in errores else 1)
    arriba = 10 ** math.ceil(math.log10(max(finitos) * 1.25)) * (10 if math.inf in errores else 1)

    def datos(nombre, variantes):
        y = {0: abajo * 1.5, math.inf: arriba / 1.5}
        filas = [f"{v.mediana:g} {y.get(v.error, v.error):g} {v.minimo:g} {v.maximo:g} {n}" for n, v in variantes]
        return [f"${nombre} << FIN", *(filas or ["NaN NaN NaN NaN NaN"]), "FIN"]

    guion = [CABECERA, f"set yrange [{abajo}:{arriba}]", f'set xlabel "{tecnica.tiempo}"']
    guion.append(f'set ylabel "{tecnica.error}"')
    trozos = []
    for k, grupo in enumerate(dict.fromkeys(v.grupo for _, v in con_error)):
        frente = [(n, v) for n, v in con_error if v.grupo == grupo and v.optima is not False]
        guion += datos(f"frente{k}", sorted(frente, key=lambda uno: uno[1].mediana))
        trozos.append(f"$frente{k} using 1:2 with lines lw 2 lc rgb '#84b8ee'")
    for clase, tipo in (GRIS, 6), (AZUL, 7), (ROJO, 7):
        nombre = f"c{clase[1:]}"
        guion += datos(nombre, [(n, v) for n, v in con_error if color(v) == clase])
        trozos.append(f"${nombre} using 1:2:3:4 with xerrorbars pt {tipo} ps 0.8 lc rgb '{clase}'")
        trozos.append(f"${nombre} using 1:2:5 with labels offset 0,0.8 textcolor rgb '{clase}'")
    guion.append("plot " + ", ".join(trozos))
    escribe(svg, ejecuta(["gnuplot"], input="\n".join(guion), text=True))
    return True
