"""De cada ejercicio de la página, algo mal hecho que compila: por la página (editor.mjs) y por ./lab corrige
(propios_test.py). En ella, los de L8.4, L9.1, L9.3 y L12.1 solo se notan en uno de los casos, y el de L5.1, en ninguno:
solo con la luz detrás."""

MAL_HECHO = {
    "L1.2": ("1.0, 0.0, 0.0", "0.0, 0.0, 1.0"),
    "L3.1": ("N * vNormal", "vNormal"),
    "L5.1": ("if (NdotL > 0.0) {", "{ NdotL = max(NdotL, 0.0);"),
    "L5.2": ("N * vNormal", "vNormal"),
    "L5.3": ("ecPosicion, normal)", "ecPosicion, -normal)"),
    "L6.3": ("nuevaCoordTextura)", "nuevaCoordTextura.ts)"),
    "L8.1": ("reflect(haciaPunto, normalize", "reflect(-haciaPunto, normalize"),
    "L8.3": ("&&", "||"),
    "L8.4": ("p).r * S2", "p * S2).r"),
    "L9.1": ("/ 3.0", "/ 2.0"),
    "L9.2": ("colorA, colorB", "colorB, colorA"),
    "L9.3": ("dentro || !ceroFuera", "true"),
    "L12.1": ("- centro", "- 0.5"),
}
