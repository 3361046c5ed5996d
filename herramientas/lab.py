"""lab.py RAÍZ ORDEN …: cada orden de ./lab. Prepara lo que hace falta (paquetes, CMake, compilar) y la pasa al módulo
que la hace."""
import argparse
import difflib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from base import catalogo, paquetes, procesos
from base.construye import Taller, aviso, corre
from base.procesos import Fallo
from ejercicios import propios

# Lo que dicen FreeGLUT, Xlib o los programas donde no se puede abrir una ventana con OpenGL 3.1.
SIN_VENTANA = "failed to open display|GLX extension not supported|Unable to create .*context|GLXBad|FBConfig"
SIN_VENTANA += "|hace falta OpenGL"
MINUTOS = {False: 5, True: 15}  # de las pruebas de cualquiera y de todas, sin compilar
CODEMIRROR = Path("/usr/share/javascript/codemirror")
OTROS_SON = """
LAB_SIN_INSTALAR=1 no instala paquetes; LAB_NAVEGADOR=1 prueba también la galería y la página en navegadores;
LAB_WINDOWS=1, los programas de Windows con Wine;
LAB_OPENGL=softpipe, zink, swiftshader, virgl o llvmpipe dibuja con él, en ./lab prueba -R otro, cada caso;
LAB_PARES=1 compara también con GLU, libnoise e ImageMagick.
./lab ORDEN --help dice más de cada una; source <(./lab completa) las completa con el tabulador."""
EN_ESPANOL = {
    "usage: ": "uso: ",
    "options": "opciones",
    "positional arguments": "lo que se dice",
    "show this help message and exit": "esto",
    "unrecognized arguments: %s": "no entiendo «%s»",
    "the following arguments are required: %s": "falta %s",
    "expected one argument": "falta lo que sigue",
    "argument %(argument_name)s: %(message)s": "%(argument_name)s: %(message)s",
    "invalid %(type)s value: %(value)r": "«%(value)s» no vale",
}
argparse._ = lambda texto: EN_ESPANOL.get(texto, texto)


class Analizador(argparse.ArgumentParser):
    def __init__(self, *args, **opciones):
        super().__init__(*args, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False, **opciones)

    def error(self, mensaje):
        sys.exit(f"lab: {self.prog.removeprefix('./lab ')}: {mensaje}; ./lab {self.prog.split()[-1]} --help")


class Mio(propios.Propio):
    """Lo de quien aprende, en mios/: se llama como el programa del que sale."""

    objetivo = property(lambda self: f"mio_{self.carpeta.name}")


def suyo(programa):
    """Cómo se llama lo que se saca de él: lo de mios/, como su carpeta."""
    return programa.carpeta.name if programa.raices else programa.nombre


def modulo(nombre, *palabras):
    """Con qué se ejecuta uno de los de herramientas/."""
    return [sys.executable, "-B", "-X", "utf8", Path(__file__).parent, nombre, *palabras]


class Laboratorio:
    def __init__(self, raiz, donde):
        self.raiz, self.donde = raiz, donde
        os.chdir(raiz)

    # --- lo que comparten ---------------------------------------------------------------------------------------------

    def abre(self):
        self.t = Taller(self.raiz)
        self.build = self.t.build
        self.t.cierra()

    def prepara(self, *mas):
        paquetes.instala([*paquetes.PARA_USAR, *mas], self.build)
        self.t.configura("release", self.build)

    def pasa_a(self, nombre, *palabras):
        """Y ya no vuelve: el cerrojo, si se tiene, es suyo."""
        if self.t.cerrojo:
            os.set_inheritable(self.t.cerrojo.fileno(), True)
        sys.stdout.flush()
        orden = [str(palabra) for palabra in modulo(nombre, *palabras)]
        os.execv(orden[0], orden)

    def hace(self, nombre, *palabras):
        """Lo hace ese módulo, y con qué estado acaba."""
        return corre(modulo(nombre, *palabras))

    @property
    def sin_ventana(self):
        return (self.build / "sin_ventana").read_text().strip()

    def mio(self, orden, pedido, programas):
        """Lo que está en mios/; nada si es del laboratorio, que va antes."""
        partes = Path(pedido.removeprefix(f"{self.t.mios.parent}/")).parts  # mios/NOMBRE, y quizá su fuente
        nombre = partes[1] if partes[:1] == ("mios",) and len(partes) > 1 else pedido.rstrip("/")
        if nombre in ("", "mios"):
            hay = ", ".join(sorted(f"mios/{c.name}" for c in self.t.mios.glob("*") if c.is_dir())) or "nada aún"
            raise Fallo(f"{orden}: di cuál de lo que hay en mios: {hay}")
        if nombre == pedido and (not (self.t.mios / nombre).exists() or any(p.es(nombre) for p in programas)):
            return None
        carpeta = self.t.mios / nombre
        if not (carpeta / f"{nombre}.cpp").exists():
            raise Fallo(f"{orden}: no encuentro {carpeta}/{nombre}.cpp")
        if not (carpeta / "ejercicio.txt").exists():
            raise Fallo(f"{orden}: falta {carpeta}/ejercicio.txt, que hace ./lab nuevo")
        origen = (carpeta / "ejercicio.txt").read_text().split("\n", 1)[0]
        hecho = Mio(catalogo.Capitulo(f"mios/{nombre}", ""), origen.rpartition("/")[2], "", nombre, carpeta=carpeta)
        if "ejercicios/" not in origen:  # la solución de uno de esos puede no estar aquí
            [p] = catalogo.resuelve(programas, hecho.nombre)
            hecho.consola, hecho.titulo = p.consola, p.titulo
        return hecho

    def elige(self, orden, pedido):
        """Los programas de que se habla."""
        self.prepara()
        os.chdir(self.donde)
        if mio := self.mio(orden, pedido, catalogo.lee_programas(self.build)):
            elegidos = [mio]
        else:
            elegidos = catalogo.resuelve(*propios.resuelve(self.raiz, self.build, pedido))
        antes = os.environ.get("LAB_RAIZ")
        for carpeta in elegidos[0].raices:
            os.environ["LAB_RAIZ"] = f"{carpeta}:{antes}" if antes else str(carpeta)
        return elegidos

    def compila_elegidos(self, elegidos, *enlaces):
        objetivos = [f"{p.objetivo}_{enlace}" for p in elegidos for enlace in (self.sin_ventana, *enlaces)]
        if not elegidos[0].raices:
            self.t.compila_para_usar(*objetivos)
        else:
            self.t.compila(self.build, *objetivos, si_no=f"{elegidos[0].capitulo.nombre} no compila")

    # --- ver ----------------------------------------------------------------------------------------------------------

    def ver(self, que):
        """Abre un programa en una ventana; sin pantalla lo dibuja en PROGRAMA.png.

        PROGRAMA puede ser su nombre, su listado, ejercicio o figura (L1.2, ejercicio 3.5), lo que hay en mios/NOMBRE
        o un capítulo (ch05): Esc pasa de cada programa al siguiente. Lo que siga va al programa: ./lab ver grua -ayuda.
        Con --vigila (o F3, con la ventana abierta) cada shader se relee en cuanto se guarda."""
        if "--vigila" in que.resto or que.vigila:
            os.environ["LAB_VIGILA"] = "1"
        resto = [palabra for palabra in que.resto if palabra != "--vigila"]
        elegidos = self.elige("ver", que.programa)
        con_pantalla = bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
        self.compila_elegidos(elegidos, *(["ventana"] if con_pantalla else []))
        self.t.suelta()  # con la ventana abierta se puede seguir trabajando
        estado = 0
        for programa in elegidos:
            if len(elegidos) > 1:
                aviso(f"{programa.nombre}: {programa.titulo}")
            estado = self.ensena(programa, resto, con_pantalla) or estado
        return estado

    def ensena(self, programa, resto, con_pantalla):
        if con_pantalla:
            orden, errores = [self.build / "ventana" / programa.capitulo.nombre / programa.nombre, *resto], []
            como = {"stderr": subprocess.PIPE, "text": True, "errors": "replace"}
            with procesos.arranca(orden, **como) as proceso:
                for linea in proceso.stderr:
                    errores.append(linea)
                    print(linea, end="", file=sys.stderr, flush=True)
                estado = proceso.wait()
            if not estado or not re.search(SIN_VENTANA, "".join(errores)):
                return estado
        with tempfile.TemporaryDirectory() as temporal:
            imagen = Path(temporal, "imagen.ppm")
            ppm = [] if programa.consola else ["-ppm", imagen]
            estado = corre([programa.ejecutable(self.build), *ppm, *resto])
            if estado or not imagen.exists():  # no la hay con -ayuda, con -ppm o en los de consola
                return estado
            procesos.escribe(self.donde / f"{suyo(programa)}.png", procesos.en_png(imagen))
        aviso(f"No puedo abrir una ventana con OpenGL 3.1: lo he dibujado en {suyo(programa)}.png")
        return 0

    def explica(self, que):
        """Deja en explica/PROGRAMA.html, orden a orden, cómo se ha dibujado su imagen y, del píxel X Y que se diga,
        como los da el ratón, por qué tiene ese color. Tras eso, -guion y -geometry, como en ./lab ver, y --json
        FICHERO, que lo deja también en datos."""
        elegidos = self.elige("explica", que.programa)
        if len(elegidos) > 1:
            son = " ".join(p.nombre for p in elegidos)
            raise Fallo(f"explica: «{que.programa}» son varios programas; elige uno: {son}")
        [p] = elegidos
        if p.consola:
            raise Fallo(f"explica: {p.nombre} escribe texto y no dibuja nada")
        self.compila_elegidos(elegidos)
        self.t.compila_para_usar("explica")
        self.t.suelta()
        cual = p.capitulo.nombre, p.nombre, suyo(p), p.titulo
        self.pasa_a("explica.orden", self.raiz, self.build, self.t.explica, *cual, *que.resto)

    # --- ejercicios ---------------------------------------------------------------------------------------------------

    def nuevo(self, que):
        """Empieza en mios/NOMBRE un ejercicio (E3.5, o la carpeta de uno de quien enseña), con su enunciado y lo que ya
        está hecho, o una copia de un programa para jugar con ella; ./lab ver mios/NOMBRE la abre."""
        self.prepara()
        self.con_su_programa("ejercicios.reparte", [self.t.mios, *que.resto])

    def ejercicio(self, que):
        """comprueba CARPETA: si un ejercicio de quien enseña (ejercicios/NOMBRE, o la carpeta que se diga) está bien
        hecho: las marcas, el esqueleto, la solución, cada control, cada error conocido y cada línea que se pide
        (docs/ejercicios.md). Vale también con los del laboratorio (E3.5, L5.1), que son «todos»."""
        if que.resto[:1] != ["comprueba"]:
            dicho = f"no entiendo «{que.resto[0]}»; " if que.resto else ""
            raise Fallo(f"ejercicio: {dicho}es ./lab ejercicio comprueba ejercicios/NOMBRE")
        self.prepara()
        self.con_su_programa("ejercicios.comprueba", que.resto[1:], "compara")

    def corrige(self, que):
        """Corrige mios/ENTREGA, o una carpeta con lo mismo, y deja una página con lo que falla y lo que se esperaba.

        Si dentro hay carpetas, es una clase, y cada una, una entrega; también vale lo que descarga Moodle, en su .zip,
        Canvas o Blackboard, y --moodle HOJA.csv pone las notas en la suya; las que ya hay, con --cambia-notas.
        EJERCICIO es E3.5, L5.1 (en su shader) o la carpeta de uno de quien enseña. Con --semilla N y --guiones N, otros
        guiones; con --reglas FICHERO se puntúa de otra manera; --deja CARPETA, --json, --junit y --vpl dicen cómo se
        deja; -j N, cuántas a la vez; --sin-jaula no encierra lo entregado (docs/corrige.md)."""
        self.prepara(*(p for p in paquetes.CORRIGE if p != "bubblewrap" or "--sin-jaula" not in que.resto))
        self.con_su_programa("ejercicios.corrige.orden", que.resto, "compara", "explica")

    def con_su_programa(self, quien, palabras, *objetivos):
        """Lo que haya que compilar depende del ejercicio, que lo sabe quien lo hace."""
        pregunta = modulo(quien, self.raiz, self.build, "--programa", *palabras)
        dice = procesos.lanza(pregunta, cwd=self.donde, text=True, stderr=None)  # lo que avise, a stderr
        if dice.returncode:
            raise SystemExit(dice.returncode)
        objetivos += tuple(f"{p}_{self.sin_ventana}" for p in dice.stdout.split())
        if objetivos:
            self.t.compila_para_usar(*objetivos)
        self.t.suelta()  # cada corrección es independiente
        os.chdir(self.donde)
        self.pasa_a(quien, self.raiz, self.build, *palabras)

    # --- galería, página, zip de Windows ------------------------------------------------------------------------------

    def dibuja_galeria(self):
        """Compila los programas y los dibuja. Con qué estado acaba."""
        dibuja = "galeria.dibuja", self.raiz, self.build, self.t.galeria
        estado = self.hace(*dibuja)
        if estado == 3:  # no compila
            self.t.perdona_avisos()
            estado = self.hace(*dibuja)
        return estado if estado != 3 else self.t.no_sale("no compila")

    def galeria(self, _):
        """Dibuja todos los programas sin ventana y deja galeria/index.html."""
        self.prepara()
        aviso(f"Dibujo los programas según se compilan; desde la primera imagen se ven en {self.t.galeria}/index.html")
        return self.dibuja_galeria()

    def web(self, _):
        """Deja en web/ una página con todos los programas en marcha, que se abre con el navegador y se puede poner en
        cualquier servidor."""
        self.prepara(*paquetes.WEB)
        if not shutil.which("em++") or not shutil.which("esbuild") or not CODEMIRROR.is_dir():
            raise Fallo(f"web: hacen falta Emscripten, CodeMirror 5 y esbuild ({' '.join(paquetes.WEB)})")
        if self.dibuja_galeria():
            aviso("lab: la página irá sin las imágenes que faltan")
        for p in propios.los_de_aqui(self.raiz, self.build):  # sus ejercicios, que van en la página
            objetivo = f"{p.objetivo}_{self.sin_ventana}"
            self.t.compila(self.build, objetivo, si_no=f"{p.capitulo.nombre} no compila, y va en la página")
        os.environ["NODE_PATH"] = "/usr/share/nodejs"  # em++ busca ahí acorn
        en = self.build / "web"
        self.t.configura("web", en)
        taller = [] if self.hace("web.taller", self.build) else ["taller"]
        if not taller:
            aviso("lab: en la página no se podrán compilar programas")
        self.t.compila(en, "laboratorio", *taller)
        es_nueva = not (self.t.web / "index.html").exists()
        if estado := self.hace("web.pagina", self.raiz, en, self.t.galeria, self.t.web):
            return estado
        return self.dibuja_galeria() if es_nueva else 0  # que enlace con ella

    def windows(self, _):
        """Deja en windows/laboratorio-windows.zip los programas para Windows, con todo lo que necesitan."""
        self.prepara()
        self.compila_windows()
        if self.dibuja_galeria():
            aviso("lab: la página irá sin las imágenes que faltan")
        self.pasa_a("windows.paquete", self.raiz, self.build, self.t.galeria, self.t.windows)

    def compila_windows(self):
        if not shutil.which("apt-get"):
            raise Fallo("windows: solo en Debian y derivados, de los que salen FreeGLUT y GLEW")
        paquetes.instala(paquetes.WINDOWS, self.build)
        if not shutil.which("x86_64-w64-mingw32-g++-posix"):
            raise Fallo(f"windows: hace falta MinGW-w64 ({paquetes.WINDOWS[0]})")
        if estado := self.hace("windows.fuentes", self.build):
            raise SystemExit(estado)
        en = self.build / "windows/programas"
        self.t.configura("windows", en)
        self.t.compila(en, "programas")

    # --- medidas y listas ---------------------------------------------------------------------------------------------

    def lista(self, que):
        """Capítulo, programa, referencia y título de cada uno; con --docs, pone al día las páginas de docs/ que salen
        del catálogo."""
        self.prepara()
        if que.docs:
            return self.hace("documentos.escribe", self.raiz, self.build)
        formato = "{}\t{}\t{}\t{}" if que.tsv else "{:<22} {:<22} {:<14} {}"
        for p in catalogo.lee_programas(self.build):
            print(formato.format(p.capitulo.nombre, p.nombre, p.ref, p.titulo))

    def mide(self, que):
        """Cronometra las técnicas y los programas y deja informe/index.html: velocidad frente a error. Con --ensayo
        solo comprueba que cada técnica da lo que debe."""
        con_pares = os.environ.get("LAB_PARES") == "1"
        paquetes.instala([*paquetes.PARA_USAR, *paquetes.MEDIDAS, *(paquetes.PARES if con_pares else [])], self.build)
        # con los pares que se acaben de instalar hay que configurar otra vez
        self.t.configura("release", self.build, *(["-DLAB_PARES=1"] if con_pares else []))
        self.t.compila_para_usar("mide", "programas")
        self.pasa_a("informe.informe", self.raiz, self.build, self.t.informe, *que.resto)

    # --- pruebas ------------------------------------------------------------------------------------------------------

    def prueba(self, que):
        """Ejecuta las pruebas de cualquiera: imágenes, ventanas, cálculos. Con --todo, todas.

        Lo que falla queda, con sus imágenes, en build/fallos/index.html. --junit FICHERO deja ahí los resultados, en
        XML de JUnit, y -I 2,,3 hace la segunda tercera parte. Con --apunta no se juzga nada: lo que miden queda en
        docs/.
        """
        preset, en = ("asan", self.build / "asan") if que.asan else ("release", self.build)
        paquetes.instala([*paquetes.PARA_USAR, *paquetes.para_pruebas()], self.build)
        if os.environ.get("LAB_WINDOWS") == "1":
            self.compila_windows()
        # se configura siempre: lo que se acaba de instalar puede añadir pruebas
        self.t.configura(preset, en, "-DLAB_AVISOS_SON_ERRORES=ON")
        self.t.compila(en, "all")
        if que.apunta:
            estado = self.hace("pruebas.evidencia", self.raiz, en)
            return estado or self.hace("documentos.escribe", self.raiz, en)
        que_son = "todas las pruebas" if que.todo else "las pruebas de cualquiera; ./lab prueba --todo hace todas"
        if not {"-R", "-L", "-N"} & {opcion for opcion, *_ in que.ctest}:
            dura = f"unos {MINUTOS[que.todo]} minutos con dos procesadores"
            aviso(f"Ejecuto {que_son}: {dura}. Lo que falle, en {en}/fallos")
        shutil.rmtree(en / "fallos", ignore_errors=True)
        informe = en / "pruebas.xml"
        informe.unlink(missing_ok=True)
        # una más que procesadores: las que abren ventanas esperan más que calculan
        orden = ["ctest", "--test-dir", en, "--parallel", len(os.sched_getaffinity(0)) + 1, "--output-on-failure"]
        orden += ["--no-tests=error", "--output-junit", informe, *self.para_ctest(que)]
        estado = corre(orden)
        if informe.exists():
            if que.junit:
                procesos.escribe(self.donde / que.junit, informe.read_bytes())
            sin_decir = self.hace("pruebas.fallos", self.raiz, en)
            estado = estado or sin_decir
        return estado

    @staticmethod
    def para_ctest(que):
        """Lo que se le pasa. Lo que no es de cualquiera lleva la etiqueta «todo»: se hace con --todo o si se nombra; y
        la parte que de eso hace cualquiera, «muestra»."""
        nombradas = {"-R", "-L"} & {opcion for opcion, *_ in que.ctest}
        de_otros = "" if nombradas else "^muestra$" if que.todo or que.asan else "^todo$"
        no = "|".join(filter(None, [que.LE, de_otros]))
        return [palabra for opcion in que.ctest for palabra in opcion] + (["-LE", no] if no else [])

    def dora(self, que):
        """Rehace los golden que se nombren (grua, grua-girada), o «todo», y enseña en una página los que cambian: el de
        antes y el de ahora."""
        if not que.resto:
            raise Fallo("dora: di qué casos (grua, grua-girada), o «todo»")
        self.prepara()
        pedidos = [] if que.resto == ["todo"] else que.resto
        suyos = {c.programa.nombre for c in catalogo.elegidos(catalogo.lee_programas(self.build), pedidos)}
        self.t.compila_para_usar("compara", *(f"{nombre}_{self.sin_ventana}" for nombre in sorted(suyos)))
        self.pasa_a("pruebas.dorado", self.raiz, self.build, self.sin_ventana, *pedidos)

    def muta(self, que):
        """Planta defectos en los programas y en lo que llevan dentro y dice qué prueba nota cada uno.

        QUÉ: un capítulo (ch05), un programa, un fichero o uno (ch05:12), y si no, todos (más de media hora). --azar N
        --semilla S planta N que no ha pensado nadie, en líneas elegidas al azar. --comprueba solo mira las listas."""
        paquetes.instala([*paquetes.PARA_USAR, *paquetes.PRUEBAS], self.build)
        self.t.configura("release", self.build)
        self.t.suelta()  # mientras se puede seguir trabajando: los mutantes tienen su carpeta, con su cerrojo
        mutantes = self.build / "mutantes"
        self.t.cierra(mutantes)
        self.pasa_a("pruebas.muta", self.raiz, mutantes, que.azar, que.semilla, int(que.comprueba), *que.resto)

    # --- lo que no compila --------------------------------------------------------------------------------------------

    def paquetes(self, _):
        """Los paquetes de Debian que hacen falta para todo eso, salvo web y mide."""
        opcional = [paquetes.OPCIONAL] if paquetes.existe(paquetes.OPCIONAL) else []
        print(*paquetes.PARA_USAR, *paquetes.para_pruebas(), *opcional, sep="\n")

    def completa(self, _):
        """Para Bash: source <(./lab completa), y el tabulador completa las órdenes y los programas."""
        programas = sorted(f.stem for f in self.raiz.glob("ch??_*/*.cpp"))
        print(
            "_lab() { local palabra=${COMP_WORDS[COMP_CWORD]}\n"
            f"  if [ $COMP_CWORD = 1 ]; then COMPREPLY=($(compgen -W '{' '.join(ORDENES)}' -- \"$palabra\"))\n"
            f"  else COMPREPLY=($(compgen -f -W '{' '.join(programas)}' -- \"$palabra\")); fi; }}\n"
            "complete -o filenames -F _lab lab ./lab"
        )


# De cada orden, lo que sigue a su nombre y lo primero que se dice de ella: en este orden las enumera la ayuda.
ORDENES = {
    "galeria": "",
    "prueba": "[--todo] [--asan] [-R EXPRESIÓN] …",
    "ver": "PROGRAMA …",
    "explica": "PROGRAMA [X Y] …",
    "nuevo": "EJERCICIO|PROGRAMA [NOMBRE]",
    "corrige": "ENTREGA [EJERCICIO] …",
    "ejercicio": "comprueba CARPETA",
    "web": "",
    "windows": "",
    "lista": "[--tsv|--docs]",
    "mide": "[--ensayo] [TÉCNICA…]",
    "dora": "CASO…|todo",
    "muta": "[QUÉ…|--azar N [--semilla S]|--comprueba]",
    "paquetes": "",
    "completa": "",
}
LIBRES = "nuevo", "corrige", "ejercicio", "mide"
NECESITAN_PRUEBAS = "prueba", "dora", "muta"
OTRAS = {"ayuda": "--help", "help": "--help", "-h": "--help", "galería": "galeria", "test": "prueba", "tests": "prueba"}


def analizador(orden):
    descripcion = re.sub("\n +", "\n", getattr(Laboratorio, orden).__doc__)
    a = Analizador(prog=f"./lab {orden}", usage=f"./lab {orden} {ORDENES[orden]}".strip(), description=descripcion)
    if orden in ("ver", "explica"):
        if orden == "ver":
            a.add_argument("--vigila", action="store_true", help="relee los shaders en cuanto se guardan")
        a.add_argument("programa", metavar="PROGRAMA")
        a.add_argument("resto", nargs=argparse.REMAINDER, metavar="…", help="va al programa")
    elif orden == "dora":
        a.add_argument("resto", nargs="*", metavar="CASO")
    elif orden == "muta":
        a.add_argument("--azar", type=int, default=0, metavar="N", help="tantos, en líneas al azar")
        a.add_argument("--semilla", type=int, default=1, metavar="S", help="con que se eligen")
        a.add_argument("--comprueba", action="store_true", help="solo si se pueden plantar los de las listas")
        a.add_argument("resto", nargs="*", metavar="QUÉ")
    elif orden == "lista":
        cual = a.add_mutually_exclusive_group()
        cual.add_argument("--tsv", action="store_true", help="entre tabuladores")
        cual.add_argument("--docs", action="store_true", help="pone al día las páginas de docs/")
    elif orden == "prueba":
        para_prueba(a)
    return a


def entiende(orden, palabras):
    """Lo que se pide a esa orden, con «listado 5.1» en una palabra. Lo de LIBRES lo entiende el módulo que la hace."""
    a = analizador(orden)
    if orden in ("ver", "explica", "nuevo"):
        palabras = catalogo.juntas(palabras)
    if {"--help", "-h"} & {*palabras}:  # también detrás de lo demás
        palabras = ["--help"]
    elif orden in LIBRES:
        return argparse.Namespace(resto=palabras)
    return a.parse_args(palabras)


def para_prueba(a):
    a.add_argument("--todo", action="store_true", help="todas, y no solo las de cualquiera")
    a.add_argument("--asan", action="store_true", help="bajo AddressSanitizer y UndefinedBehaviorSanitizer")
    a.add_argument("--apunta", action="store_true", help="lo que miden queda en docs/")
    a.add_argument("--junit", metavar="FICHERO", help="deja ahí los resultados, en XML de JUnit")
    como_ctest = {"dest": "ctest", "default": [], "help": "como en ctest"}
    for opcion in ("-R", "-E", "-L", "-I", "-j", "--repeat", "--timeout"):
        con_valor = {"metavar": "…", "type": lambda valor, opcion=opcion: (opcion, valor)}
        a.add_argument(opcion, action="append", **con_valor, **como_ctest)
    for opcion in ("-V", "-VV", "-N", "--rerun-failed", "--stop-on-failure", "--progress"):
        a.add_argument(opcion, action="append_const", const=(opcion,), **como_ctest)
    a.add_argument("-LE", metavar="…", help="como en ctest")


def ayuda():
    lineas = []
    for orden, sigue in ORDENES.items():
        dice = getattr(Laboratorio, orden).__doc__.split(".\n\n")[0].split(". ")[0]
        dice = re.sub(r"\s+", " ", dice).rstrip(".")
        lineas += [f"./lab {orden} {sigue}".rstrip(), f"    {dice[0].lower() + dice[1:]}"]
    return "\n".join(lineas) + "\n" + OTROS_SON


def elige_orden(pedida):
    """La que se pide, aunque se llame de otra manera; si no es ninguna, dice cuál se le parece."""
    pedida = OTRAS.get(pedida, pedida)
    if pedida == "--help":
        print(ayuda())
        raise SystemExit(0)
    if pedida == "--version":
        de_git = "git", "-C", sys.argv[1], "log", "-1", "--format=laboratorio del %cs (%h)", "--date=short"
        raise SystemExit(subprocess.run(de_git).returncode)
    if pedida not in ORDENES:
        parecidas = difflib.get_close_matches(pedida, ORDENES, 1, 0.5)
        pregunta = f": ¿querías decir {parecidas[0]}?" if parecidas else "; ./lab ayuda las enumera"
        print(f"lab: no conozco la orden «{pedida}»{pregunta}", file=sys.stderr)
        raise SystemExit(2)
    return pedida


def main():
    raiz, donde, *pedido = Path(sys.argv[1]), Path.cwd(), *sys.argv[2:]
    orden = elige_orden(pedido[0] if pedido else "--help")
    que = entiende(orden, pedido[1:])
    if orden in NECESITAN_PRUEBAS and not (raiz / "tests").is_dir():
        raise Fallo(f"{orden}: hace falta la carpeta tests/")
    lab = Laboratorio(raiz, donde)
    if orden not in ("paquetes", "completa"):
        lab.abre()
    return getattr(lab, orden)(que)


if __name__ == "__main__":
    if sys.stdout is None:  # cerrada: que falle quien escriba en ella, y nadie la abra con otra cosa
        os.dup2(os.open("/dev/full", os.O_WRONLY), 1)
        sys.stdout = open(1, "w")
    for senal in procesos.SENALES:
        signal.signal(senal, procesos.acaba)
    procesos.acaba_bien(main)
