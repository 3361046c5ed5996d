#!/usr/bin/env python3
"""herramientas_test.py: las cuentas de herramientas/ que se pueden comprobar sin compilar nada."""
import json
import random
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
import catalogo
import controles
import medidas
import tecnicas


class Mide(unittest.TestCase):
    def test_el_frente_de_pareto_y_la_elegida(self):
        def v(nombre, tiempo, error, grupo=""):
            return tecnicas.Variante(nombre, grupo, tiempo, 0.9 * tiempo, 1.1 * tiempo, error, "")
        t = tecnicas.Tecnica("", "", "", "", "b", "", [v("a", 1, 3), v("b", 2, 1), v("b, x", 3, 1), v("bc", 2.1, 1), v("par: d", 0.1, 0),
                                                      v("e", 9, 9, "otro")])
        tecnicas.marca(t)
        self.assertEqual([x.nombre for x in t.variantes if x.elegida], ["b", "b, x"])
        self.assertEqual([x.nombre for x in t.variantes if not x.optima], ["b, x"])

    def test_los_errores_de_un_programa(self):
        self.assertEqual(medidas.errores({"maximo": 0.512, "borde": 1, "lejos": 2, "banda": 90}), ["0.51", "", "1, salvo 2 de 90"])
        self.assertEqual(medidas.errores({"rmse": 1.23e-7}), ["", "1.2e-07", ""])


class Controles(unittest.TestCase):
    def test_las_teclas_de_cada_control(self):
        for texto, ordenes, hace in (("a d giran", ["tecla a", "tecla d"], "giran"),
                                     ("1 a 3 resaltan una tira", ["tecla 1", "tecla 2", "tecla 3"], "resaltan una tira"),
                                     (", . mueven el plano", ["tecla ,", "tecla ."], "mueven el plano"),
                                     ("t o espacio anda o para", ["tecla t", "tecla Espacio"], "anda o para"),
                                     ("F5 relee", ["especial F5"], "relee"), ("; sigue", ["tecla PuntoYComa"], "sigue"),
                                     ("1 A", ["tecla 1"], "A"), ("0 (1,1,1)", ["tecla 0"], "(1,1,1)"),
                                     ("arrastra los puntos (o n y flechas)", ["tecla n", *(f"especial {f}" for f in controles.ESPECIALES.values())],
                                      "arrastra los puntos"), ("ratón orbita", [], "ratón orbita")):
            c = controles.analiza(texto)
            self.assertEqual((c.ordenes, c.hace), (ordenes, hace))
        self.assertTrue(controles.analiza("botón derecho menú").menu and not controles.analiza("a menú").menu)

    def test_al_azar_solo_lo_suyo(self):
        azar = random.Random(1)
        suyos = {orden for _ in range(200) for orden in controles.sucesos_al_azar(
            azar, [controles.analiza("a d giran"), controles.analiza("Esc termina")], {"temporizador"}, ["Vista/Perfil"], 120, 90)}
        self.assertEqual(suyos, {"tecla a", "tecla d", "especial F5", "menu Vista/Perfil", *(f"espera {n}" for n in (1, 20, 333, 1700))})


class Catalogo(unittest.TestCase):
    def setUp(self):
        texto = {"consola": "", "contra": "", "pruebas": "", "pasa": "", "admite": ""}
        with tempfile.TemporaryDirectory() as build:
            Path(build, "catalogo.json").write_text(json.dumps({
                "capitulos": [{"nombre": "ch01_uno", "titulo": "Uno"}, {"nombre": "ch10_diez", "titulo": "Diez"}],
                "programas": [{**texto, "capitulo": "ch01_uno", "nombre": "a", "ref": "L1.2 E1.1", "titulo": "A", "pruebas": "x.Y.z x.W"},
                              {**texto, "capitulo": "ch10_diez", "nombre": "b", "ref": "§10.1", "titulo": "B", "consola": "TRUE"}],
                "casos": [{"programa": "a", "nombre": "base", "fichero": "a", "guion": "", "tolerancia": "", "mira": "M", "borde": "", "anima": ""},
                          {"programa": "a", "nombre": "dos", "fichero": "a-dos", "guion": "tecla d; tecla a", "tolerancia": "1 2 3", "mira": "M",
                           "borde": "", "anima": ""}]}))
            self.programas = catalogo.lee_programas(build)

    def nombres(self, pedido):
        return [p.nombre for p in catalogo.resuelve(self.programas, pedido)]

    def test_a_que_se_refiere(self):
        for pedido in ("a", "ch01", "ch01_uno", "l1.2", "E1.1"):
            self.assertEqual(self.nombres(pedido), ["a"], pedido)
        self.assertEqual(self.nombres("§10.1"), ["b"])
        for pedido in ("ch1", "E1", "1.1", ""):  # ch1 no es ch10
            with self.assertRaisesRegex(SystemExit, "no hay ningún programa"):
                self.nombres(pedido)

    def test_los_hechos_de_un_caso(self):
        self.assertEqual([c.hechos for c in catalogo.casos(self.programas, "a")],
                         [["ch01_uno", "a", "a", "-", "-"], ["ch01_uno", "a", "a-dos", "1 2 3", "tecla d; tecla a"]])
        self.assertEqual([c.nombre for c in catalogo.casos(self.programas, "a-dos")], ["dos"])
        for pedido in ("a-tres", "b"):  # b es de consola
            with self.assertRaisesRegex(SystemExit, "no es un caso"):
                catalogo.casos(self.programas, pedido)
        self.assertEqual(self.programas[0].pruebas, ["x.Y.z", "x.W"])
        self.assertEqual(self.programas[1].capitulo.numero, 10)


unittest.main()
