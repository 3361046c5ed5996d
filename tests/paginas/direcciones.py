"""Lo que se pregunta a las dos páginas, en Chromium y en Firefox, de cada dirección, de cada cosa que se busca y de
cada botón de copiar. Basta que `n` tenga js(código, …)."""
from navegador import CASOS, PROGRAMAS, RAIZ, espera, exige

NOMBRES = """const todos = s => [...document.querySelectorAll(s)], una = s => document.querySelector(s);
const cuadro = () => new Promise(hecho => requestAnimationFrame(() => setTimeout(hecho, 30)));
"""
CAPITULOS = list(dict.fromkeys(p.capitulo.nombre for p in PROGRAMAS.values()))
REFERENCIAS = list(dict.fromkeys(r for p in PROGRAMAS.values() for r in p.referencias))
TODAS = [*CAPITULOS, *PROGRAMAS, *REFERENCIAS, *(c.fichero for c in CASOS)]
BUSQUEDAS = [
    linea.split("\t")
    for linea in (RAIZ / "tests/paginas/busquedas.tsv").read_text().splitlines()
    if not linea.startswith("#")
]


def promesa(n, codigo, *argumentos):
    """Lo que acaba dando un código asíncrono; Firefox no sabe esperarlo."""
    n.js("window.dado = undefined; window.pedido = arguments", *argumentos)
    n.js(f"(async () => {{ {NOMBRES} {codigo} }})().then(v => {{ dado = [v] }}, e => {{ dado = [String(e)] }})")
    exige(espera(n, "return window.dado !== undefined", 400), f"acaba: {codigo[:60]}")
    return n.js("return dado[0]")


def de_la_galeria(n, cada=1):
    """Cada dirección, o una de CADA, lleva a lo suyo, que queda arriba, y el índice lo señala; alguna, escrita en
    minúsculas."""
    mal = promesa(
        n,
        """const mal = [];
        const escritas = (pedida, i) => i % 9 ? [[pedida, pedida]] : [[pedida, pedida], [pedida, pedida.toLowerCase()]];
        for (const [pedida, escrita] of pedido[0].flatMap(escritas)) {
          location.hash = '#' + escrita;
          const e = document.getElementById(pedida);
          const primero = e?.matches('.capitulo') && e.querySelector('article').id; // su título puede quedar por encima
          const suyo = e?.closest('article, .capitulo').id;
          let bien = false, r, senalado;
          for (let cuadros = 0; !bien && cuadros < 20; ++cuadros) { // con la máquina ocupada, lo señala más tarde
            await cuadro();
            r = e?.getBoundingClientRect();
            const final = scrollY + innerHeight > document.body.scrollHeight - 2;
            const arriba = e && (final || (r.top > -2 && r.top < innerHeight * 0.15));
            senalado = todos('.programas [aria-current]').map(a => a.hash.slice(1)).join();
            const senala = [suyo, primero].includes(senalado), esta = una('#no-esta').hidden;
            bien = arriba && senala && esta && decodeURIComponent(location.hash) === '#' + pedida;
          }
          if (!bien)
            mal.push([escrita, r?.top, senalado]);
        }
        return mal""",
        TODAS[::cada],
    )
    exige(mal == [], f"cada dirección lleva a lo suyo: {len(mal)}, {mal[:5]}")
    vuelve = promesa(
        n,
        """for (const h of ['#grua', '#L5.1', '#particulas-fuego']) { location.hash = h; await cuadro(); }
        const vistos = [];
        for (let i = 0; i < 2; ++i) {
          history.back();
          await cuadro();
          await cuadro();
          vistos.push(location.hash, scrollY);
        }
        const debe = ['L5.1', 'grua'].map(id => document.getElementById(id).getBoundingClientRect().top + scrollY);
        return vistos[0] === '#L5.1' && vistos[2] === '#grua' && Math.abs(vistos[1] - debe[0]) < 120 &&
          Math.abs(vistos[3] - debe[1]) < 120 || vistos""",
    )
    exige(vuelve is True, f"con «Atrás» se vuelve a donde se estaba: {vuelve}")
    for nada in ("no_esta", "L99.1", "%", "a" * 1000):
        n.js("location.hash = '#' + arguments[0]", nada)
        dice = "return !document.querySelector('#no-esta').hidden"
        exige(espera(n, dice), f"de #{nada[:9]} se dice que no está")
    n.js("location.hash = ''")


def busquedas(n, que, cuantas=None):
    """Lo que se escribe en el buscador da lo de la tabla, dice dónde, e Intro lleva a lo primero; con ↓ se pasa por
    todo, y Esc lo deja."""
    escribe = """const campo = document.querySelector('input[type=search]');
        campo.focus();
        campo.value = arguments[0];
        campo.dispatchEvent(new Event('input'))"""
    enlaces = "[...document.querySelectorAll('.hallazgos a')].map(a => decodeURIComponent(a.hash.slice(1)))"
    for buscado, *salen in BUSQUEDAS[:cuantas]:
        for escrito in (buscado, buscado.upper()):
            n.js("location.hash = '#ch01_intro'")
            n.js(escribe, escrito)
            primero = f"{enlaces}[0] === '{salen[0]}' && {salen}.every(e => {enlaces}.slice(0, 6).includes(e))"
            visible = f"!document.querySelector('.hallazgos').hidden && {primero}"
            exige(espera(n, f"return {visible}"), f"{que}, «{escrito}»: {n.js('return ' + enlaces)[:3]} y no {salen}")
        dicen = n.js("return [...document.querySelectorAll('.donde')].every(d => d.textContent.trim().length > 2)")
        exige(dicen, f"{que}, «{buscado}»: cada uno dice dónde se ha encontrado")
        n.js("""document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }));""")
        va = (
            f"return decodeURIComponent(location.hash) === '#{salen[0]}' && document.querySelector('.hallazgos').hidden"
        )
        exige(espera(n, va), f"{que}, «{buscado}»: Intro lleva al primero y no a {n.js('return location.hash')}")
    n.js(escribe, "textura")
    exige(espera(n, f"return {enlaces}.length === 12"), f"{que}: de muchos se enseñan doce")
    pasa = n.js(
        """const vistos = new Set(), da = key => document.activeElement
          .dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
        for (let i = 0; i < 13; ++i) { da('ArrowDown'); vistos.add(document.activeElement); }
        const vuelta = document.activeElement.tagName;
        da('ArrowUp');
        const ultimo = document.activeElement.textContent;
        da('Escape');
        return [vistos.size, vuelta, Boolean(ultimo), document.querySelector('.hallazgos').hidden,
          document.querySelector('input[type=search]').value].join()"""
    )
    exige(pasa == "13,INPUT,true,true,", f"{que}: con las flechas se pasa por todos, y Esc lo deja: {pasa}")
    n.js(escribe, "xyzzy")
    nada = "return /Nada/.test(document.querySelector('.cuantos').textContent)"
    exige(espera(n, nada), f"{que}: de lo que no hay se dice")
    n.js(escribe, "")
    exige(espera(n, "return !document.querySelector('.cuantos').textContent"), f"{que}: y sin nada, nada")


def copias(n, que):
    """Cada botón de copiar copia lo que tiene al lado o, donde no se puede, lo selecciona."""
    mal = promesa(
        n,
        """const mal = [], botones = todos('.copia').filter(b => b.offsetParent);
        let copiado;
        for (const deja of [true, false]) {
          Object.defineProperty(navigator, 'clipboard', { configurable: true, value: { writeText: async texto => {
            if (!deja) throw new Error('no');
            copiado = texto;
          } } });
          for (const b of botones) {
            copiado = '';
            getSelection().removeAllRanges();
            b.click();
            await new Promise(hecho => setTimeout(hecho));
            const texto = deja ? copiado : String(getSelection());
            const debe = b.ariaLabel.replace('Copiar ', '');
            if (texto !== debe || !texto.startsWith('./lab ')) mal.push([texto, debe]);
          }
        }
        delete navigator.clipboard;
        return [botones.length, mal]""",
    )
    exige(mal[0] and not mal[1], f"{que}: se copia lo que se dice: {mal}")
