"""Las pruebas de GoogleTest: cómo se llaman y cuáles nombra una cita de docs/ o de un CMakeLists.txt."""
from base.procesos import ejecuta


def pruebas_de(ejecutable):
    """«Grua.ContraTrazadoDeRayos» de cada TEST."""
    grupo, pruebas = "", []
    for linea in ejecuta([ejecutable, "--gtest_list_tests"], text=True).splitlines():
        nombre = linea.split("#")[0].strip()
        if linea.startswith(" "):
            pruebas.append(grupo + nombre)
        else:
            grupo = nombre
    return pruebas


def todas(build):
    """«ch03_grua.Grua.ContraTrazadoDeRayos» de cada TEST de cada programa de GoogleTest."""
    ejecutables = sorted((build / "tests").glob("*_test"))
    return [f"{ejecutable.name[:-5]}.{nombre}" for ejecutable in ejecutables for nombre in pruebas_de(ejecutable)]


def busca(cita, pruebas):
    """Las pruebas a que se refiere: la de ese nombre, las de ese grupo o ese fichero, o las que empiezan así si acaba
    en *."""
    if cita.endswith("*"):
        return [p for p in pruebas if p.startswith(cita[:-1])]
    return [p for p in pruebas if p == cita or p.startswith(cita + ".")]
