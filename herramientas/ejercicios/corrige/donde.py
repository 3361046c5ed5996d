"""Dónde se aparta una entrega de lo que se espera. Con un guion que falla, el cuadro de las dos se explica en el píxel
en que más se apartan (herramientas/explica), y se dice lo primero que no es lo mismo: de las órdenes que pintan ese
píxel, la primera en que se apartan, y de ella lo que le llega (shaders, uniforms, arrays, texturas), su estado, lo que
se pide dibujar o la primera línea de sus shaders que da otra cosa; si no, qué primitiva lo cubre o qué prueba no pasa.

De lo suyo se dice también en qué línea se dibuja, o se envía.

De la solución se dicen valores, y nombres que la entrega también tiene; nunca su texto."""
import difflib
import re
from collections import Counter
from pathlib import PurePath

from base.fuentes import SHADERS, con_sitios, en_lineas
from ejercicios.corrige import cuadro as de_cuadro
from ejercicios.corrige.jaula import desempaqueta

PROCESADOR = 20  # segundos de cada explicación
PIXELES = 3
LEJOS = 12  # píxeles que hay de uno a otro, al menos
ORDENES = 300  # las que se emparejan por lo que hacen
IGUAL = 1e-4
NIVEL = 2 / 255
HACEN = "escrito", "mascara"  # los veredictos de lo que deja algo
VENTANA = "la ventana"
ENCIMA = "common/encima/"  # los shaders con que se pintan los trazos, que no son de nadie
TRAZO = "trazo"  # lo que se dice de uno
SUELTOS = 3  # pasos sin pareja de los que sale el que se aparta, que se dicen
FINAL = 1 << 30  # más que las líneas que tiene un shader: la última
COLOR = re.compile(r"tinta|color\w*")  # de un uniform, el de lo que se dibuja
CON_NOMBRE = "entrada", "global", "declara", "asigna", "argumento", "sale", "salida"
PRUEBAS = {
    "cara": "la de la cara",
    "recorte": "la del recorte",
    "descartado": "el discard del shader",
    "plantilla": "la prueba de plantilla",
    "profundidad": "la prueba de profundidad",
    "mascara": "glColorMask",
}
# De lo que le llega a una orden: cómo se llama cada cosa, y de cada hecho suyo que no es el que se espera, qué se dice.
# Si un hecho es None, no hay nada que decir de él.
ARRAY = {
    lambda a: None if a["activo"] and a["bufer"] else "ninguno": "al atributo «{nombre}» no le llega ningún array",
    "componentes": "al atributo «{nombre}» le llegan {es} números por vértice y se esperan {debe}",
    "suma": "lo que hay en el array de «{nombre}» no es lo que se espera",
}
TEXTURA = {
    lambda t: t["incompleta"] or None: "la textura de «{nombre}» está incompleta: {es}",
    "unidad": "la textura de «{nombre}» está en la unidad {es} y se espera {debe}",
    lambda t: "×".join(map(str, t["talla"])): "la textura de «{nombre}» es de {es} y se espera {debe}",
    "formato": "la textura de «{nombre}» es {es} y se espera {debe}",
    "reduce": "la textura de «{nombre}» se reduce con {es} y se espera {debe}",
    "amplia": "la textura de «{nombre}» se amplía con {es} y se espera {debe}",
    "repite": "la textura de «{nombre}» se repite con {es} y se espera {debe}",
    "suma": "lo que hay en la textura de «{nombre}» no es lo que se espera",
}
LLEGA = (
    ("array", lambda o: {a["nombre"]: a for a in o["cableado"]["atributos"]}, ARRAY),
    ("array", lambda o: {"": o["cableado"]}, {"sumaIndices": "los índices no son los que se esperan"}),
    ("textura", lambda o: {t["sampler"]: t for t in o["cableado"]["texturas"]}, TEXTURA),
    ("estado", lambda o: {e["nombre"]: e for e in o["estado"]}, {"valor": "{nombre} es «{es}» y se espera «{debe}»"}),
)


# --- lo que se dice ---


def cifra(n, cifras=4):
    return {"nan": "NaN", "inf": "∞", "-inf": "−∞"}.get(f"{n:g}") or f"{n:.{cifras}g}".replace("-", "−")


def valor(numeros, tipo="", cifras=4):
    if tipo == "bool" and numeros:
        return "sí" if numeros[0] else "no"
    dichos = [cifra(0.0 if abs(n) < 1e-6 else n, cifras) for n in numeros]  # lo que deja un giro de 90°
    return dichos[0] if len(dichos) == 1 else f"({', '.join(dichos)})"


def los_dos(tuyo, esperado, tipo=""):
    """Con las cifras que hagan falta para que se vea que no son lo mismo."""
    una, otra = valor(tuyo, tipo), valor(esperado, tipo)
    if una == otra:
        una, otra = valor(tuyo, tipo, 9), valor(esperado, tipo, 9)
    return f"{una} y se espera {otra}"


def vale(que, tuyo, esperado, tipo=""):
    """De una matriz, la primera columna que no es la misma."""
    columnas = re.fullmatch(r"mat([2-4])(?:x[2-4])?", tipo)
    if columnas and len(tuyo) == len(esperado):
        filas = len(tuyo) // int(columnas[1])
        for c in range(int(columnas[1])):
            una, otra = (m[c * filas : (c + 1) * filas] for m in (tuyo, esperado))
            if distintos(una, otra):
                return f"{que}, en su columna {c + 1}, vale {los_dos(una, otra)}"
    return f"{que} vale {los_dos(tuyo, esperado, tipo)}"


def rgb(suceso):
    return valor(suceso["despues"][:3]) if suceso and suceso["despues"] else "otra cosa"


def de_poco(hallada):
    """Lo que vale menos, mayor."""
    return {"suceso": 2, TRAZO: 1, "array": 1, "textura": 1}.get(hallada["que"], 0)


# --- comparar ---


def distintos(una, otra, igual=IGUAL):
    """Dos listas de números, si lo son de verdad."""
    if una is None or otra is None:
        return una is not otra
    if len(una) != len(otra):
        return True
    return any(
        a != b and (a == a or b == b) and not abs(a - b) <= igual * max(1, abs(a), abs(b)) for a, b in zip(una, otra)
    )


def contenido(orden):
    """Lo que pinta y con qué, para encontrarla en otro cuadro."""
    cableado = orden["cableado"] or {"uniformes": [], "atributos": [], "texturas": []}
    numeros = [f"{n:.4g}" for u in cableado["uniformes"] for n in u["valor"]]
    sumas = [cosa["suma"] for que in ("atributos", "texturas") for cosa in cableado[que]]
    return orden["titulo"], orden["framebuffer"], *numeros, *sumas


def hace(orden):
    """Qué clase de orden es, sin cuánto dibuja."""
    titulo = orden["titulo"].rstrip("s").partition(" ")[2] if orden["cableado"] else orden["titulo"]
    return titulo, orden["framebuffer"]


def empareja(suyas, esperadas):
    """Cada orden con la que debía ser: por su sitio, si son las mismas; si no, por su contenido. A la que le falta
    pareja le queda None."""
    if [*map(hace, suyas)] == [*map(hace, esperadas)] or max(len(suyas), len(esperadas)) > ORDENES:
        return list(zip(suyas, esperadas))
    una, otra = [*map(contenido, suyas)], [*map(contenido, esperadas)]
    pares = []
    for que, a, b, c, d in difflib.SequenceMatcher(None, una, otra, autojunk=False).get_opcodes():
        comunes = min(b - a, d - c) if que in ("equal", "replace") else 0
        pares += zip(suyas[a : a + comunes], esperadas[c : c + comunes])
        pares += [(o, None) for o in suyas[a + comunes : b]] + [(None, o) for o in esperadas[c + comunes : d]]
    return pares


def pasos(traza, comunes):
    """Cada paso de un shader por lo que es y las veces que van. El de una condición se llama como está escrita: si en
    el otro shader no hay ninguna igual, se empareja sin nombre."""
    van = Counter()
    for p in traza["lineas"]:
        nombre = p["nombre"] if p["clase"] in CON_NOMBRE or p["nombre"] in comunes else ""
        que = p["clase"], nombre, p["tipo"], p["funcion"]
        van[que] += 1
        yield (*que, van[que]), p


CONTADOR = re.compile(r"\bfor\s*\(\s*\w+\s+(\w+)\s*=")


def primer_paso(suya, esperada, fuentes):
    """Cuál es el primero que no da lo mismo en las dos, lo que se espera de él, y los de antes que no tienen pareja.
    Lo que cuenta un `for` no se mira: se puede recorrer en otro orden, y entonces, de lo que se repite, basta que los
    valores, o el último, sean los mismos."""
    comunes = set.intersection(*({p["nombre"] for p in traza["lineas"]} for traza in (suya, esperada)))
    cuentan = [set(CONTADOR.findall(fuente)) for fuente in fuentes]
    vueltas = [[p["valor"] for p in t["lineas"] if p["nombre"] in c] for t, c in zip((suya, esperada), cuentan)]
    esperados, grupos = dict(pasos(esperada, comunes)), ({}, {})
    for grupo, traza in zip(grupos, (suya, esperada)):
        for que, paso in pasos(traza, comunes):
            grupo.setdefault(que[:-1], []).append(paso["valor"] or [])
    sueltos = []
    for i, (que, mio) in enumerate(pasos(suya, comunes)):
        mios, otros = (grupo.get(que[:-1], []) for grupo in grupos)
        if mio["nombre"] in cuentan[0]:
            continue
        if que not in esperados:
            sueltos.append(i)
            esperado = otros[-1] if otros and len(mios) == que[-1] else None  # lo que queda, si se cambia más veces
        elif vueltas[0] != vueltas[1] and len(mios) == len(otros) > 1:
            esperado = otros[-1] if len(mios) == que[-1] and not son_los_mismos(mios, otros) else None
        elif len(mios) > len(otros) and que[-1] == len(otros):
            esperado = None  # falta lo que le hacen los que no tienen pareja
        else:
            esperado = esperados[que]["valor"]
        if mio["valor"] and esperado and distintos(mio["valor"], esperado):  # sin valor, el que no se sabe
            return i, esperado, [j for j in sueltos if j != i]
    return None


def son_los_mismos(unos, otros):
    return not any(distintos(a, b) for a, b in zip(sorted(unos), sorted(otros)))


def instruccion(fuente, linea):
    """Desde esa línea hasta donde acaba."""
    return "\n".join(fuente.splitlines()[linea - 1 :]).partition(";")[0]


def de_que_sale(lineas, sueltos, i, fuente):
    """Los pasos sin pareja de los que sale el i: lo que lee en su línea, y lo que leen ellos. Antes, el primero."""
    hallados, leen = [], [(i, donde_se_llama(lineas, i) if lineas[i]["clase"] == "argumento" else lineas[i]["linea"])]
    while leen:
        cual, linea = leen.pop()
        nombres = set(re.findall(r"\w+", instruccion(fuente, linea)))
        for nombre in nombres - {lineas[cual]["nombre"]} if cual != i else nombres:
            de_el = [j for j in sueltos if j < cual and lineas[j]["nombre"] == nombre and lineas[j]["valor"]]
            if de_el and de_el[-1] not in hallados:
                hallados.append(de_el[-1])
                leen.append((de_el[-1], lineas[de_el[-1]]["linea"]))
    return sorted(hallados)[:SUELTOS]


def donde_se_llama(lineas, i):
    """La línea en que se da valor a ese parámetro: la de lo siguiente que se apunta en quien llama a su función."""
    suya = lineas[i]["funcion"]
    quien = next((p["funcion"] for p in reversed(lineas[:i]) if p["funcion"] not in (suya, "")), "main")
    return next((p["linea"] for p in lineas[i:] if p["funcion"] == quien), lineas[i]["linea"])


class Comparacion:
    """De un píxel, en los dos cuadros, con los Shaders de la entrega y los del laboratorio."""

    def __init__(self, suyo, esperado, i, suyos, lab, primitiva=0):
        self.cuadros, self.i, self.suyos, self.lab = (suyo, esperado), i, suyos, lab
        self.primitiva = primitiva  # de lo que se pinta en otro framebuffer
        self.pixel = suyo["pixeles"][i]["pixel"]
        self.pares = empareja(suyo["ordenes"], esperado["ordenes"])
        self.se_sombrea = None  # (orden, primitiva) de cada uno: las que habría que ver por dentro

    def sucesos(self, cual, orden):
        """Lo que hace esa orden en el píxel: {primitiva: suceso}."""
        historia = self.cuadros[cual]["pixeles"][self.i]["historia"]
        return {-1 if s["primitiva"] is None else s["primitiva"]: s for s in historia if s["orden"] == orden["n"]}

    def fuente(self, cual, orden, etapa):
        suyo = next((p for p in self.cuadros[cual]["programas"] if p["programa"] == orden["programa"]), {})
        return suyo.get(etapa) or ""

    def primera(self):
        """Lo primero en que se apartan, o None: `que`, `dice` y, si se sabe, la `pila` de lo suyo. Antes lo que dice de
        dónde sale que lo que solo dice que no es lo mismo."""
        return self.con_pila(min(self.halladas(), key=de_poco, default=None))

    def con_pila(self, hallada):
        pilas = self.cuadros[0]["pilas"]
        suya = hallada.pop("pila", -1) if hallada else -1
        return {**hallada, "pila": pilas[suya]} if 0 <= suya < len(pilas) and hallada["que"] != "linea" else hallada

    def halladas(self):
        for mia, suya in self.pares:
            if not mia or not suya:
                orden = mia or suya
                de = self.sucesos(0 if mia else 1, orden)
                if any(s["veredicto"] in HACEN for s in de.values()):
                    yield self.suelta(mia, suya)
                continue
            de_mia, de_suya = self.sucesos(0, mia), self.sucesos(1, suya)
            cual = self.suceso_distinto(de_mia, de_suya)
            if cual is not None:
                yield {"pila": mia["pila"], **self.de_orden(mia, suya, cual, de_mia.get(cual), de_suya.get(cual))}
            if self.se_sombrea:
                return

    def del_cuadro(self):
        """La primera orden del cuadro a la que le llega otra cosa que dice de dónde sale, pinte ese píxel o no."""
        for mia, suya in self.pares:
            if mia and suya and mia["fragmentos"]:
                hallado = self.de_lo_que_llega(mia, suya)
                if hallado and not de_poco(hallado):
                    return self.con_pila({"pila": mia["pila"], **hallado})
        return None

    def suelta(self, mia, suya):
        if mia:
            return {"que": "sobra", "pila": mia["pila"], "dice": f"sobra {self.llama(mia)}: en lo esperado no está"}
        if self.es_de_encima(suya, 1):
            return {"que": "falta", "dice": f"falta {self.llama(suya, 1)}"}
        antes = None
        for una, otra in self.pares:
            if otra is suya:
                break
            antes = una or antes
        donde = f"después de {self.llama(antes)}" if antes else "antes de todo"
        return {"que": "falta", "dice": f"falta algo, {donde}: se espera que se dibujen {suya['titulo']}"}

    @staticmethod
    def suceso_distinto(de_mia, de_suya):
        """La primera primitiva (-1 es la orden entera) que no hace lo mismo."""
        for cual in sorted({*de_mia, *de_suya}):
            uno, otro = de_mia.get(cual), de_suya.get(cual)
            hacen = [s is not None and s["veredicto"] in HACEN for s in (uno, otro)]
            if not any(hacen):
                continue
            if not all(hacen) or uno["veredicto"] != otro["veredicto"]:
                return cual
            if uno["veredicto"] == "escrito" and distintos(uno["color"], otro["color"], NIVEL):
                return cual
            if any(distintos([uno[q] or 0], [otro[q] or 0]) for q in ("profundidadDespues", "plantillaDespues")):
                return cual
            if distintos([c / 255 for c in uno["despues"] or []], [c / 255 for c in otro["despues"] or []], NIVEL):
                return cual
        return None

    # --- lo que le llega a una orden ---

    def llama(self, orden, cual=0):
        """Como lo diría quien la ha escrito: por su color, y por lo que se ha dibujado antes."""
        if not orden["cableado"]:
            return f"«{orden['titulo']}»"
        pinta = [o["n"] for o in self.cuadros[cual]["ordenes"] if o["cableado"]].index(orden["n"]) + 1
        colores = [u["valor"] for u in orden["cableado"]["uniformes"] if COLOR.fullmatch(u["nombre"])]
        color = f" de color {self.color(colores[0])}" if colores else ""
        if self.es_de_encima(orden, cual):
            return f"el trazo{color} (lo {pinta}.º que se dibuja)"
        return f"lo {pinta}.º que se dibuja ({orden['titulo']}{color})"

    def color(self, componentes):
        """Por su nombre, si es de los de colores.h."""
        tiene = [nombre for nombre, c in self.lab.colores.items() if not distintos(componentes, c)]
        return tiene[0] if tiene else valor(componentes)

    def es_de_encima(self, orden, cual=0):
        return self.lab.sitio(self.fuente(cual, orden, "frag"), FINAL)[0].startswith(ENCIMA)

    def de_orden(self, mia, suya, cual, uno, otro):
        quien = self.llama(mia)
        if not mia["cableado"] or not suya["cableado"]:
            if hallado := self.de_llamada(mia, suya):
                return {"que": "llamada", "dice": f"{quien} {hallado['dice']}"}
            return {"que": "suceso", "dice": self.de_suceso(quien, cual, uno, otro)}
        if hallado := self.de_lo_que_llega(mia, suya):
            if hallado["que"] == "textura":
                return self.de_quien_la_pinta(mia) or hallado
            return hallado
        if hallado := self.de_lineas(mia, suya, cual):
            return hallado
        return {"que": "suceso", "dice": self.de_suceso(quien, cual, uno, otro)}

    def de_lo_que_llega(self, mia, suya):
        if not mia["cableado"] or not suya["cableado"]:
            return None
        for parte in (self.de_shaders, self.de_uniforms, self.de_tabla, self.de_llamada):
            if hallado := parte(mia, suya):
                if self.es_de_encima(mia) and self.es_de_encima(suya, 1):
                    return self.de_trazo(mia, suya, hallado)
                return {**hallado, "dice": f"en {self.llama(mia)} {hallado['dice']}"}
        return None

    def de_trazo(self, mia, suya, hallado):
        """De lo que se traza, ni shaders ni vértices: por dónde va y de qué color es."""
        (de, debe) = (self.llama(o, i).partition(" (")[0] for i, o in enumerate((mia, suya)))
        if hallado["que"] == "uniform" and de != debe:
            return {**hallado, "dice": f"{self.llama(mia)} debía ser{debe.removeprefix('el trazo')}"}
        return {"que": TRAZO, "dice": f"{self.llama(mia)} no va por donde debe"}

    def de_quien_la_pinta(self, orden):
        """Lo primero en que se aparta una orden de antes que dibuja en otro framebuffer."""
        for mia, suya in self.pares:
            if mia is orden:
                return None
            if mia and suya and mia["framebuffer"] != VENTANA:
                if hallado := self.de_lo_que_llega(mia, suya):
                    return hallado if hallado["que"] != "textura" else None
                if any(self.fuente(0, mia, e) != self.fuente(1, suya, e) for e in ("vert", "frag")):
                    if hallado := self.de_lineas(mia, suya, self.primitiva):
                        return hallado
        return None

    def de_shaders(self, mia, suya):
        """Otro shader del laboratorio por el suyo."""
        for etapa in ("vert", "frag"):
            fuentes = [self.fuente(cual, orden, etapa) for cual, orden in enumerate((mia, suya))]
            uno, otro = (PurePath(self.lab.sitio(fuente, FINAL)[0]).name for fuente in fuentes)
            if uno and otro and uno != otro:
                return {"que": "shader", "dice": f"el shader es {uno} y se espera {otro}"}
        return None

    def de_uniforms(self, mia, suya):
        esperados = {u["nombre"]: u for u in suya["cableado"]["uniformes"]}
        pares = [(u, esperados.get(u["nombre"])) for u in mia["cableado"]["uniformes"]]
        salen = [(u, o) for u, o in pares if o and o["tipo"] == u["tipo"] and distintos(u["valor"], o["valor"])]
        if not salen:
            return None
        lineas = [ll for e in ("vert", "frag") for ll in self.fuente(0, mia, e).partition("main")[2].splitlines()]

        def se_usa(par):
            """Antes las matrices grandes, de las que salen otras, y el que está en una línea de antes; en la misma, el
            de más a la derecha, que es lo primero que se aplica."""
            nombre = re.compile(rf"\b{re.escape(re.split('[.[]', par[0]['nombre'])[0])}\b")
            hay = ((i, -s.start()) for i, ll in enumerate(lineas) for s in [*nombre.finditer(ll)][-1:])
            return -len(par[0]["valor"]) if par[0]["tipo"].startswith("mat") else 0, next(hay, (len(lineas), 0))

        u, otro = min(salen, key=se_usa)
        dice = vale(f"el uniform «{u['nombre']}»", u["valor"], otro["valor"], u["tipo"])
        return {"que": "uniform", "dice": dice, "pila": u["pila"]}

    def de_tabla(self, mia, suya):
        for que, cosas, hechos in LLEGA:
            esperadas = cosas(suya)
            for nombre, una in cosas(mia).items():
                for hecho, dice in hechos.items():
                    es, debe = (hecho(c) if callable(hecho) else c[hecho] for c in (una, esperadas.get(nombre, una)))
                    if es is not None and es != debe:
                        return {"que": que, "dice": dice.format(nombre=nombre, es=es, debe=debe)}
        return None

    def de_llamada(self, mia, suya):
        if mia["titulo"] != suya["titulo"]:
            return {"que": "llamada", "dice": f"se pide dibujar {mia['titulo']} y se espera {suya['titulo']}"}
        (una, *mios), (otra, *suyos) = (re.split(r"[(), ]+", o["llamada"].rstrip(")")) for o in (mia, suya))
        if una == otra and mios != suyos:
            mio, suyo = next(((a, b) for a, b in zip(mios, suyos) if a != b), ("", ""))
            return {"que": "llamada", "dice": f"{una} recibe {mio} y se espera {suyo}"}
        return None

    # --- sus shaders, por dentro ---

    def por_dentro(self, mia, suya, cual):
        """Lo apuntado de los shaders de esa primitiva; si hay que pedirlo, nada."""
        if cual < 0:
            return None
        pedida = (mia["n"], cual), (suya["n"], cual)
        sombreados = [c["pixeles"][self.i]["sombreado"] or {} for c in self.cuadros]
        if any((s.get("orden"), s.get("primitiva")) != p for s, p in zip(sombreados, pedida)):
            self.se_sombrea = pedida
            return None
        return sombreados

    def de_lineas(self, mia, suya, cual):
        if not (sombreados := self.por_dentro(mia, suya, cual)):
            return None
        uno, otro = sombreados
        for mio, suyo in zip(uno["vertices"] or [], otro["vertices"] or []):
            if paso := primer_paso(mio, suyo, self.fuentes(mia, suya, "vert")):
                return self.de_paso(mia, "vert", mio["lineas"], *paso)
        mio, suyo = uno["fragmento"], otro["fragmento"]
        if mio and suyo and (paso := primer_paso(mio, suyo, self.fuentes(mia, suya, "frag"))):
            return self.de_paso(mia, "frag", mio["lineas"], *paso)
        return None

    def fuentes(self, mia, suya, etapa):
        return [self.fuente(cual, orden, etapa) for cual, orden in enumerate((mia, suya))]

    def de_paso(self, orden, etapa, lineas, i, esperado, sueltos):
        mio, fuente = lineas[i], self.fuente(0, orden, etapa)
        antes = de_que_sale(lineas, sueltos, i, fuente)
        es_parametro, nombre = mio["clase"] == "argumento", mio["nombre"]
        en = donde_se_llama(lineas, i) if es_parametro else mio["linea"]
        fichero, linea = self.suyos.sitio(fuente, en)
        fichero = PurePath(fichero).name
        shader = f"el {'vertex' if etapa == 'vert' else 'fragment'} shader"
        quien = nombre if mio["clase"] in CON_NOMBRE else f"«{nombre}»"
        if es_parametro:
            quien = f"el parámetro {nombre} de {mio['funcion']}"
        elif mio["clase"] == "devuelve":
            quien = f"lo que devuelve {mio['funcion']}"
        que = vale(quien, mio["valor"], esperado, mio["tipo"])
        de = f" de {fichero or shader.replace('el ', 'su ')}"
        donde = f"en la línea {linea}{de if not antes else ''}, {que}"
        if mio["clase"] == "entrada":
            return {"que": "linea", "dice": f"a {shader} {fichero} le llega otra cosa: {que}".replace("a el ", "al ")}
        for paso in reversed([lineas[j] for j in antes]):
            suya, primero = self.suyos.sitio(fuente, paso["linea"])[1], paso is lineas[antes[0]]
            como = f"{de if primero else ''}, {paso['nombre']} vale {valor(paso['valor'], paso['tipo'])}"
            donde = f"en la línea {suya}{como}; {'y ' if paso is lineas[antes[-1]] else ''}{donde}"
        return {"que": "linea", "dice": donde}

    @staticmethod
    def de_suceso(quien, cual, uno, otro):
        tipo = (uno or otro)["tipo"]
        que = f"el {tipo} {cual} de {quien}" if tipo else quien
        if not uno or not otro:
            return f"{quien} {'no ' if otro else ''}cubre este píxel y en lo esperado {'sí' if otro else 'no'}"
        if uno["veredicto"] == otro["veredicto"]:
            if rgb(uno) != rgb(otro):
                return f"{que} deja {rgb(uno)} y se espera {rgb(otro)}"
            for clave, como in (("profundidadDespues", "la profundidad"), ("plantillaDespues", "la plantilla")):
                if uno[clave] != otro[clave]:
                    return f"{que} deja {como} en {los_dos([uno[clave] or 0], [otro[clave] or 0])}"
            return f"{que} no deja lo mismo que en lo esperado"
        pasa = uno["veredicto"] in HACEN
        prueba = PRUEBAS.get((otro if pasa else uno)["veredicto"], "")
        return f"{que} {'' if pasa else 'no '}pasa aquí {prueba} y en lo esperado {'no' if pasa else 'sí'}"


# --- los shaders de la entrega ---


class Shaders:
    """De qué fichero y línea sale cada línea de un shader con lo que incluye ya dentro. `textos`: {fichero: texto} de
    lo que ve quien lo compila."""

    def __init__(self, textos):
        self.textos, self.hechos, self.colores = {}, {}, {}
        for fichero, contenido in textos.items():
            suyo = contenido.decode(errors="replace") if isinstance(contenido, bytes) else contenido
            for nombre in (fichero, PurePath(fichero).name):
                self.textos.setdefault(nombre, (fichero, suyo.removeprefix("\ufeff")))
        for fichero in self.textos:
            if fichero.endswith((".vert", ".frag")):
                lineas = con_sitios(lambda nombre: self.textos.get(nombre, ("", "")), fichero)
                self.hechos.setdefault(self.clave(t for *_, t in lineas), lineas)

    @staticmethod
    def clave(lineas):
        return "\n".join(lineas).strip()

    def sitio(self, fuente, linea):
        """El fichero, vacío si no se sabe, y la línea."""
        lineas = self.hechos.get(self.clave(en_lineas(fuente)), [])
        fichero, numero_, _ = lineas[min(linea, len(lineas)) - 1] if lineas and linea > 0 else ("", linea, "")
        return fichero, numero_


# --- el peor píxel ---


def peores(una, otra):
    """Los píxeles en que más se apartan dos imágenes, con lo que tienen alrededor, lejos unos de otros."""
    ancho, alto, a = una
    b = otra[2]
    aparta = [max(abs(a[i + c] - b[i + c]) for c in range(3)) for i in range(0, 3 * ancho * alto, 3)]

    def alrededor(i):
        x, y = i % ancho, i // ancho
        filas = (ancho * v for v in range(max(y - 1, 0), min(y + 2, alto)))
        return sum(sum(aparta[f + max(x - 1, 0) : f + min(x + 2, ancho)]) for f in filas)

    orden = sorted((i for i, cuanto in enumerate(aparta) if cuanto > 0), key=lambda i: -aparta[i])[:4000]
    elegidos = []
    for i in sorted(orden, key=alrededor, reverse=True):
        x, y = i % ancho, i // ancho
        if all(abs(x - u) + abs(y - v) >= LEJOS for u, v in elegidos):
            elegidos.append((x, y))
            if len(elegidos) == PIXELES:
                break
    return elegidos


def es_de(cuadro, imagen):
    """Si los píxeles del cuadro son los de esa imagen."""
    ancho, _, rgb_ = imagen
    de_imagen = [list(rgb_[3 * (y * ancho + x) :][:3]) for x, y in (p["pixel"] for p in cuadro["pixeles"])]
    return de_imagen == [p["color"][:3] for p in cuadro["pixeles"]]


# --- explicarlas ---


class Donde:
    def __init__(self, banco):
        self.arbitro, self.compilador = banco.arbitro, banco.compilador
        self.delante = banco.compilador.build / de_cuadro.DELANTE
        raiz, capitulo = banco.compilador.raiz, banco.programa.capitulo.nombre
        todos = [f for tipo in SHADERS for f in raiz.glob(f"c*/**/*{tipo}")]
        todos.sort(key=lambda f: f.parent.name != capitulo)  # antes los de su capítulo, que hay iguales en otros
        textos = {str(f.relative_to(raiz)): f.read_text() for f in todos}
        propios = [f for c in banco.programa.raices for f in sorted(c.iterdir()) if f.suffix in SHADERS]
        self.lab = Shaders({**{f.name: f.read_text() for f in propios}, **textos})
        paleta = re.findall(r"([A-Z]+)\(([\d., f]+)\)", (raiz / ENCIMA / "colores.h").read_text())
        self.lab.colores = {n: [*map(float, c.replace("f", "").split(","))] for n, c in paleta if c.count(",") == 2}
        self.visibles = {f: textos[f] for f in map(str, banco.compilador.visible) if f in textos}

    def explica(self, jugador, guion, pixeles, **mas):
        """El cuadro en que acaba ese guion, o None."""
        entorno = {
            "LAB_EXPLICA": de_cuadro.FICHERO,
            "LAB_EXPLICA_SUMAS": "1",
            "LAB_EXPLICA_PIXELES": " ".join(f"{x},{y}" for x, y in pixeles),
            **mas,
        }
        datos = self.arbitro.juega_de_nuevo(jugador, guion, PROCESADOR, self.delante, **entorno)
        return de_cuadro.lee(desempaqueta(datos).get(de_cuadro.FICHERO, b""))

    def de_los_dos(self, jugador, guion, imagenes, pixeles, pedida=((), ())):
        """Sus cuadros, si se explican los dos y el de la solución es el de su imagen."""
        cuadros = []
        for quien, imagen, sombrea in zip((self.compilador.solucion, jugador), imagenes, reversed(pedida)):
            mas = {"LAB_EXPLICA_SOMBREA": "{},{}".format(*sombrea)} if sombrea else {}
            cuadro = self.explica(quien, guion, pixeles, **mas)
            if not cuadro or [tuple(p["pixel"]) for p in cuadro["pixeles"]] != pixeles:
                return None
            cuadros.insert(0, cuadro)
        return cuadros if es_de(cuadros[1], imagenes[0]) else None

    def busca(self, jugador, ficheros, guion, esperada, obtenida):
        """Lo primero que se aparta en el cuadro en que acaba ese guion, que en las dos da esas imágenes, o None."""
        hallada = self.halla(jugador, ficheros, guion, esperada, obtenida)
        pila = hallada and hallada.pop("pila", None)
        linea = pila and self.compilador.linea_de_una_llamada(ficheros, jugador, pila)
        como = "se envía" if linea and hallada["que"] == "uniform" else "se pide"
        return {**hallada, "dice": f"{hallada['dice']} ({como} en {linea})"} if linea else hallada

    def halla(self, jugador, ficheros, guion, esperada, obtenida):
        if not self.delante.exists() or esperada[:2] != obtenida[:2]:
            return None
        pixeles = peores(esperada, obtenida)
        cuadros = pixeles and self.de_los_dos(jugador, guion, (esperada, obtenida), pixeles)
        if not cuadros:
            return None
        if not es_de(cuadros[0], obtenida):  # lo que se ve no es lo que se dibuja ahora
            if not es_de(cuadros[0], esperada):
                return None
            dice = "si se vuelve a dibujar sale lo que se espera: falta glutPostRedisplay"
            return {"que": "sin redibujar", "dice": dice, "pixel": list(pixeles[0])}
        shaders = Shaders({**{f: t for f, t in ficheros.items() if f.endswith(SHADERS)}, **self.visibles})
        halladas = []
        for i, pixel in enumerate(pixeles):
            comparacion = Comparacion(*cuadros, i, shaders, self.lab)
            hallada = comparacion.primera()
            for primitiva in (0, 1) if comparacion.se_sombrea else ():
                otros = self.de_los_dos(jugador, guion, (esperada, obtenida), [pixel], comparacion.se_sombrea)
                comparacion = otros and Comparacion(*otros, 0, shaders, self.lab, primitiva)
                hallada = comparacion and comparacion.primera() or hallada
                if not comparacion or not comparacion.se_sombrea:
                    break
            if hallada:
                halladas.append({**hallada, "pixel": list(pixel)})
                if not de_poco(hallada):
                    break
        mejor = min(halladas, key=de_poco, default=None)
        if mejor and de_poco(mejor) == 1 and (otra := Comparacion(*cuadros, 0, shaders, self.lab).del_cuadro()):
            return {**otra, "pixel": None}
        return mejor
