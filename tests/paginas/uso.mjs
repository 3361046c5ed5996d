// Usar los programas en la página: teclas, ratón, dedos, botones, menú y enlaces, contra los golden; lo que se hace
// mientras se carga, enlaces hostiles y descargas que fallan; ficheros buenos y malos; el contexto perdido y devuelto;
// un shader que no deja acabar de dibujar.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { renameSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { seBusca, seCopia, sonDelNavegador } from './comun.mjs';
import { ABRE, CASOS, espera } from './navegador.mjs';

const ROJO_VERDE_AZUL_BLANCO = Buffer.concat([Buffer.from('P6\n2 2\n255\n'),
  Buffer.from([255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255])]);
const PNG = execFileSync('pnmtopng', { input: ROJO_VERDE_AZUL_BLANCO, stdio: ['pipe', 'pipe', 'ignore'] });
const guionDe = fichero => CASOS.find(c => c.fichero === fichero).guion;

const entradas = {
  'la grúa, girada con la tecla d, su botón, dos enlaces y el botón del caso': async p => {
    await p.abre('#grua');
    await p.da(() => una('canvas').focus());
    await p.teclas(...'ddddddd');
    await p.es('grua-girada');
    await p.da(() => una('.enlace').click());
    assert.match(await p.da(() => location.hash), /grua;tecla%20d%20%C3%977/, 'el enlace lleva lo que se ha hecho');
    await p.teclas('Tab');
    await p.exige('con Tab se sale del lienzo a los botones', () => document.activeElement.tagName === 'BUTTON');
    for (const enlace of ['#E3.5' + ';tecla d;tecla%20d'.repeat(3), '#grua;tecla d ×6']) {
      await p.abre(enlace);
      await p.da(() => conTexto('.mando button', 'd').click());
      await p.es('grua-girada');
    }
    await p.da(() => conTexto('.casos-botones button', 'Desde otro lado').click());
    await p.acaba('otro caso', () => hecho.ordenes.length > 2 && sesion?.vivo);
    await p.es('grua-orbitada');
    await p.da(() => conTexto('.casos-botones button', 'Girada').click());
    await p.acaba('tiene dirección', () => location.hash === '#grua-girada' && hecho.ordenes.length === 7);
    await p.da(() => { escena.manda('tecla d'); conTexto('.casos-botones button', 'Girada').click(); });
    await p.acaba('pulsado otra vez, empieza otra vez', () => hecho.ordenes.length === 7 && sesion?.vivo);
    await p.da(() => history.back());
    await p.acaba('«Atrás» vuelve al de antes', () => visto.caso.fichero === 'grua-orbitada' && sesion?.vivo);
  },

  'un dedo y una pinza': async p => {
    await p.abre('#grua');
    await p.dedos([[[60, 90], [100, 80], [160, 60]]]);
    await p.dedos([-1, 1].map(lado => [[120 + lado * 40, 90], [120 + lado * 47, 90]]));
    await p.acaba('la pinza llega', () => hecho.ordenes.some(o => o.startsWith('rueda')));
    await p.es('grua-orbitada');
    await p.pagina.mouse.move(...await p.punto(100, 90));
    await p.pagina.mouse.down();
    await p.pagina.mouse.move(...await p.punto(-30, 90), { steps: 4 });
    await p.pagina.mouse.up();
    await p.acaba('soltado fuera, se suelta', () => hecho.ordenes.at(-1) === 'boton IZQUIERDO arriba -30 90');
    await p.talla(1280, 900, 2); // de una pantalla densa, sus píxeles
    await p.abre('#grua');
    await p.pagina.mouse.click(...await p.punto(100, 90));
    await p.acaba('donde se pulsa', () => /arriba (199|200|201) (179|18[01])$/.test(hecho.ordenes.at(-1)));
  },

  'un enlace con ratón, en una ventana de otra forma': async p => {
    await p.abre('#eventos;' + guionDe('eventos'));
    await p.es('eventos'); // la imagen dice dónde ha sido cada suceso
    const enlace = '#eventos;escala 240 180;boton IZQUIERDO abajo 145 115;arrastra 175 108;tecla a;rueda -1 20 30';
    await p.abre(enlace, 'width: 480px; height: 270px');
    await p.da(() => una('.enlace').click());
    assert.equal(await p.da(() => decodeURIComponent(location.hash)), enlace);
    assert.match(await p.da(() => una('.estado').textContent), /-1 90 45$/);
  },

  'el menú: con sus teclas, y siempre entero': async p => {
    await p.abre('#menu');
    await p.pulsa('.mando button', 'Menú');
    await p.da(() => conTexto('.opciones button', 'Paralela › Perfil').click());
    await p.es('menu-perfil');
    await p.talla(390, 700);
    for (const punto of [[390, 0], [0, 700], [390, 700]]) {
      await p.exige(`abierto en ${punto}, cabe`, (x, y) => {
        escena.ensenaMenu(x, y);
        const r = una('.opciones').getBoundingClientRect();
        return r.left >= 0 && r.top >= 0 && r.right <= innerWidth && r.bottom <= innerHeight;
      }, ...punto);
    }
    const vistas = [], cuantas = await p.da(() => todos('.opciones button').length);
    for (let i = 0; i < cuantas; ++i) {
      await p.teclas('ArrowDown');
      vistas.push(await p.da(() => todos('.opciones button').indexOf(document.activeElement)));
    }
    assert.ok(vistas.at(-1) === 0 && new Set(vistas).size === cuantas && !vistas.includes(-1), `con ↓: ${vistas}`);
    await p.termina('#menu');
    await p.pulsa('.mando button', 'Menú');
    await p.exige('terminado, ya no se abre', () => !una('.opciones').matches(':popover-open'));
  },

  'lo que se anima se mueve solo': async p => {
    await p.abre('#luces_animadas');
    const antes = await p.imagen();
    await p.acaba('el enlace lleva cuánto', () => /^espera \d{3,}$/.test(hecho.ordenes.join()));
    assert.notDeepEqual(await p.imagen(), antes);
  },

  'la imagen se guarda': async p => {
    await p.abre('#grua;tecla d');
    assert.match(await p.da(() => una('.estado').textContent), /^Grúa de obra: giro/);
    const [nombre, texto] = await p.descarga('.guarda');
    assert.deepEqual([nombre, texto.slice(1, 4)], ['grua.png', 'PNG']);
  },

  'el enlace que se copia lleva a lo que se ve, esté como esté la página': async p => {
    const ve = () => p.da(() => [visto.programa.nombre, visto.ejercicio?.codigo, una('.estado').textContent]);
    for (const enlace of ['#grua', '#ejercicio/L5.1', '#ejercicio/L5.2;tecla v', `#eventos;${guionDe('eventos')}`]) {
      await p.abre(enlace);
      const antes = await ve();
      await p.da(() => una('.enlace').click());
      await p.abre(await p.da(() => location.hash));
      assert.deepEqual(await ve(), antes, enlace);
    }
    await p.abre('#grua');
    const [, , alEmpezar] = await ve();
    await p.da(() => escena.manda('tecla d'));
    await p.da(() => una('.enlace').click());
    await p.va('#grua');
    await p.acaba('y el del índice empieza de nuevo', alEmpezar => una('.estado').textContent === alEmpezar, alEmpezar);
  },
};

const adversidades = {
  'mientras un programa carga se va a otro y vuelve; lo que se hace entonces no le llega': async p => {
    /// El próximo no acaba de cargar hasta que se llama a carga().
    const tarda = hace => p.da(() => {
      globalThis.carga = undefined;
      const rapido = WebAssembly.instantiate;
      WebAssembly.instantiate = async (...todo) => {
        WebAssembly.instantiate = rapido;
        await new Promise(sigue => { globalThis.carga = sigue; });
        return rapido(...todo);
      };
    }).then(hace).then(() => p.acaba('uno que tarda', () => globalThis.carga));
    await p.abre('#grua');
    await tarda(() => p.da(() => una('.otra-vez').click()));
    await p.va('#camara');
    await p.acaba('se va a otro', () => sesion?.vivo);
    const titulo = await p.da(() => { carga(); return una('.estado').textContent; });
    await espera(1000);
    assert.equal(await p.da(() => una('.estado').textContent), titulo, 'el primero no escribe en él');
    assert.doesNotMatch(titulo, /^(Grúa|$)/);
    await tarda(() => p.va('#grua'));
    await p.pagina.mouse.move(...await p.punto(60, 90));
    await p.pagina.mouse.down();
    await p.da(() => { marco.style.setProperty('width', '260px', 'important'); carga(); });
    await p.acaba('carga, de la talla que la página ha tomado', () => sesion?.vivo && sesion.lienzo.width === 260);
    await p.pagina.mouse.move(...await p.punto(160, 60));
    await p.pagina.mouse.up();
    await p.da(() => escena.gestos.suelta());
    await p.exige('no le llega', () => sesion.vivo && !hecho.ordenes.length);
  },

  'empezar nueve veces seguidas es empezar una, y el lienzo que ya no está no da nada': async p => {
    await p.abre('#grua');
    await p.da(() => {
      globalThis.viejo = escena.gestos;
      for (let i = 0; i < 9; ++i) una('.otra-vez').click();
    });
    await p.acaba('una', () => sesion?.lienzo.isConnected && sesion.vivo && todos('canvas').length === 1);
    await p.da(() => viejo.gira({ id: 1, x: 1, y: 1 }, 99, 0));
    await p.exige('el viejo no da nada', () => !hecho.ordenes.length);
  },

  'una imagen que tarda en leerse no es para el programa al que se ha ido': async p => {
    await p.abre('#convolucion');
    await p.da(() => {
      const lee = createImageBitmap;
      globalThis.createImageBitmap = async (...todo) => {
        await new Promise(sigue => { globalThis.sigue = sigue; });
        return lee(...todo);
      };
    });
    await p.suelta('foto.png', PNG);
    await p.acaba('tarda', () => globalThis.sigue);
    await p.va('#grua');
    await p.acaba('se va', () => visto.programa.nombre === 'grua' && sesion?.vivo);
    await p.da(() => { globalThis.antes = sesion; sigue(); });
    await espera(500);
    await p.exige('no es para él', () => sesion?.vivo && sesion === antes &&
      ![...sesion.leidos].some(r => r.startsWith('/propias/')));
  },

  'enlaces hostiles': async p => {
    await p.abre('#grua');
    for (const orden of ['tecla nada', 'a'.repeat(100000), '%25', '%']) {
      await p.va('#grua;' + orden);
      await p.acaba(`«${orden.slice(0, 9)}» se dice que no vale`, () => !telon.hidden &&
        telon.textContent.length < 2000 && /guion «(tecla nada|[a%])/.test(telon.textContent));
    }
    await p.va('#grua;espera 20000');
    await p.acaba('de lo que no se repite entero se dice', () => /demasiado largo/.test(aviso));
    const shader = 'lab/ch03_transformaciones/objeto';
    await p.abre(`#grua;captura /${shader}.frag;captura ${shader}.vert;tecla d ×7`);
    for (const tipo of ['frag', 'vert']) assert.match(String(await p.lee(`/${shader}.${tipo}`)), /^#/, tipo);
    await p.es('grua-girada');
    for (const nombre of ['no_existe', '%', '%E0%A4%A', 'a'.repeat(100000)]) {
      await p.va('#' + nombre);
      const dice = nombre.length > 60 ? nombre.slice(0, 60) + '…' : nombre;
      await p.acaba(`#${nombre.slice(0, 9)} no está`, dice => una('#no-esta').textContent.includes(`«${dice}»`), dice);
    }
  },

  'lo que no se puede descargar se dice, y que ha terminado, y se puede volver a empezar': async p => {
    const shaders = `${ABRE}/datos/shaders.js`;
    renameSync(shaders, shaders + '.fuera');
    try {
      await p.carga('#grua');
      await p.acaba('se dice', () => /no se puede leer datos.shaders.js/.test(telon.textContent));
    } finally {
      renameSync(shaders + '.fuera', shaders);
    }
    await p.da(() => una('.telon button').click());
    await p.acaba('se puede volver', () => sesion?.vivo && telon.hidden);
    p.errores.length = 0; // ese error sí tiene que estar
    await p.termina('#grua');
    await p.da(() => una('.telon button').click());
    await p.acaba('terminado, se puede empezar de nuevo', () => sesion?.vivo && telon.hidden);
  },

  'ficheros propios, buenos y malos': async p => {
    await p.abre('#convolucion');
    const antes = await p.imagen();
    const propia = () => [...sesion?.leidos ?? []].find(r => r.startsWith('/propias/'));
    await p.suelta('apuntes.txt', Buffer.from('hola'));
    await p.acaba('no es una imagen', () => /apuntes.txt.*no es una imagen/.test(aviso));
    assert.deepEqual(await p.imagen(), antes);
    await p.suelta('mal.ppm', Buffer.from('P6 999 999 255\n\0\0'));
    await p.acaba('un PPM cortado', () => !telon.hidden && /mal.ppm/.test(telon.textContent));
    await p.da(() => una('.telon button').click());
    await p.acaba('se puede seguir', () => sesion?.vivo);
    await p.suelta('foto.png', PNG);
    await p.acaba('se abre', propia);
    assert.deepEqual(await p.lee(await p.da(propia)), ROJO_VERDE_AZUL_BLANCO);
    assert.notDeepEqual(await p.imagen(), antes);
    await p.abre('#mezcla');
    const fotos = ['foto', 'otra'].map(foto => `${tmpdir()}/${foto}.ppm`), campo = await p.pagina.$('.fichero input');
    for (const foto of fotos) writeFileSync(foto, 'P6 2 1 255\nabcdef');
    for (const [vez, ...veces] of [[1, fotos], [3, [fotos[0]], [fotos[1]]]]) { // las mismas, juntas y de una en una
      for (const suyas of veces) {
        await campo.uploadFile(...suyas);
        await p.acaba('queda vacío, o el navegador no avisa', () => una('.fichero input').value === '');
      }
      await p.acaba(`la vez ${vez}`, vez => sesion?.leidos.has(`/propias/${vez}-foto.ppm`) &&
        sesion.leidos.has(`/propias/${vez + 1}-otra.ppm`), vez);
    }
    await p.abre('#malla_vf');
    await p.suelta('nada.vf', Buffer.from('no'));
    await p.acaba('un modelo que no lo es', () => !telon.hidden && /nada.vf/.test(telon.textContent));
    await p.abre('#grua');
    await p.suelta('foto.png', PNG);
    await p.acaba('un programa que no lee ninguno', () => /no lee ficheros/.test(aviso));
  },

  'el contexto perdido, y devuelto': async p => {
    await p.abre('#grua;tecla d ×7');
    await p.da(() => {
      globalThis.quita = una('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
      quita.loseContext();
    });
    await p.acaba('se dice', () => !telon.hidden && /perdido/.test(telon.textContent));
    await p.da(() => quita.restoreContext());
    await p.acaba('sigue', () => sesion?.vivo && telon.hidden);
    await p.es('grua-girada');
  },

  'con un shader que no deja acabar de dibujar, volver a abrir la página basta': async p => {
    const objeto = 'ch03_transformaciones/objeto.frag';
    await p.abre('#grua');
    const antes = await p.imagen();
    await p.da(() => {
      globalThis.apuntado = [];
      const pon = Storage.prototype.setItem;
      Storage.prototype.setItem = function (clave, texto) {
        if (/dibujando/.test(clave)) apuntado.push(texto);
        pon.call(this, clave, texto);
      };
    });
    await p.reescribe(objeto, texto => texto.replace(/(colorFragmento = )[^;]*;/, '$1vec4(1.0, 0.0, 0.0, 1.0);'));
    await p.acaba('mientras se dibuja está apuntado, y después ya no', () => apuntado.join() === 'sí,');
    assert.notDeepEqual(await p.imagen(), antes);
    for (const [queda, dejo] of [['sí', true], ['', false]]) {
      await p.da(queda => sessionStorage.setItem('cambios, dibujando', queda), queda);
      await p.pagina.reload();
      await p.acaba('se abre otra vez', () => sesion?.vivo && editor.ruta);
      await p.acaba('lo dice', dejo => /dejó de responder/.test(aviso) === dejo, dejo);
      await p.exige('lo escrito no se pierde', () => visto.taller.cambios.size === 1);
      const usado = String(await p.lee(`/lab/${objeto}`));
      assert.equal(usado.includes('vec4(1.0, 0.0, 0.0'), !dejo, 'lo que no se llegó a ver no se usa');
    }
  },
};

const pagina = {
  'se busca y se copia, en la lista y en un programa': async p => {
    await p.carga();
    await seBusca(p);
    await sonDelNavegador(p);
    await p.va('#grua');
    await p.acaba('grua', () => sesion?.vivo);
    await seBusca(p);
    await p.va('#grua');
    await seCopia(p);
    const capitulo = ['#ch05_iluminacion', '#5', '#cap05', '#Ch5'].map(enlace => [enlace, '#ch05_iluminacion']);
    for (const [enlace, marcado] of [...capitulo, ['#l5.1', '#sombreado']]) {
      await p.va(enlace);
      await p.acaba(`el índice señala adónde lleva ${enlace}`, marcado => una('#no-esta').hidden &&
        una('.programas [aria-current]')?.hash === marcado, marcado);
    }
  },

  'nada se sale, y se ve lo que hay que ver': async p => {
    for (const [ancho, alto] of [[360, 740], [390, 844], [1280, 800], [1920, 1080]]) {
      await p.talla(ancho, alto);
      await p.carga();
      for (const enlace of ['', '#grua', '#convolucion_variable', '#ejercicio/L5.3', '#info_opengl']) {
        await p.va(enlace);
        await p.acaba(enlace, () => !visto.programa || cm && (sesion?.vivo || visto.programa.consola));
        await p.nadaSeSale(`«${enlace}» a ${ancho}`);
        await p.exige(`«${enlace}» a ${ancho}, el fuente se puede leer`, () =>
          !visto.programa || una('.CodeMirror').clientWidth > 0.75 * Math.min(innerWidth, 400));
        if (enlace !== '#ejercicio/L5.3') continue;
        await p.exige(`a ${ancho}×${alto} se ven las tres imágenes y cuánto coinciden`, () => scrollY === 0 &&
          todos('.lienzo, .cuadro, .parecido').every(e => e.getBoundingClientRect().bottom < innerHeight));
        await p.talla(ancho, 600);
        await p.nadaSeSale(`«${enlace}» a ${ancho}×600`);
        await p.talla(ancho, alto);
      }
    }
    await p.acaba('info_opengl escribe lo que hay', () => consola.textContent.includes('OpenGL: 3.1 (imitado'));
  },

  'de un programa o un ejercicio a su vecino se pasa por todos': async p => {
    await p.carga();
    assert.deepEqual(await p.da(async () => {
      const programas = JSON.parse(una('#programas').textContent), mal = [];
      const ejercicios = programas.flatMap(q => q.ejercicios.map(e => `ejercicio/${e.codigo}`));
      for (const lista of [programas.map(q => q.nombre).slice(-9), ejercicios]) {
        for (const [i, enlace] of lista.entries()) {
          location.hash = enlace;
          await cuadro();
          const hay = [['.anterior', i - 1], ['.siguiente', i + 1]].map(([boton, vecino]) => lista[vecino]
            ? una(boton).hash === '#' + lista[vecino] : una(boton).hidden || lista !== ejercicios);
          if (hay.includes(false)) mal.push(enlace);
        }
      }
      return mal;
    }), []);
  },

  'para todos: la lista, un programa y un ejercicio': async p => {
    for (const [enlace, lleva] of [['', 'h1'], ['#grua', '#programa .enunciado'], ['#ejercicio/L5.2', '.editor']]) {
      await p.carga(enlace);
      await p.acaba(enlace, () => !visto.programa || sesion?.vivo && editor.ruta);
      await p.exige(lleva, lleva => una(lleva).checkVisibility(), lleva);
      await p.esParaTodos();
    }
  },
};

export const uso = { ...entradas, ...adversidades, ...pagina };
