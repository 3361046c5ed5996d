// Comparar la escena de un programa con su referencia (oraculo/): qué se admite y por qué.
#pragma once
#include "ejecuta.h"
#include "malla.h"
#include "oraculo/oraculo.h"

/// Lo que se admite. Con la misma forma que dibuja el programa, en los bordes solo pueden fallar los píxeles cuyo
/// centro está a menos de 1/512 de uno, que la GPU redondea a una rejilla de 1/256: como la banda mide de 2 a 3
/// píxeles, uno de cada 500.
struct Cotas {
    double maximo = 0.501; // niveles, en el interior: solo el redondeo a 8 bits
    int lejosDeCada =
        500; // de cada tantos píxeles de los bordes, uno que no se parece a nada de su alrededor; 0: los que sean
    double desvio = oraculo::INFINITO; // píxeles, en los bordes
};

inline void comprueba(const std::string &que, const oraculo::Comparacion &c, const Cotas &cotas = {}) {
    std::cout << que << ": " << c << "\n";
    EXPECT_LE(c.maximo, cotas.maximo) << que << ": " << c;
    EXPECT_LE(c.desvio, cotas.desvio) << que << ": " << c;
    EXPECT_TRUE(cotas.lejosDeCada == 0 || c.bandaLejos <= c.banda / cotas.lejosDeCada) << que << ": " << c;
    EXPECT_GT(c.interior, c.banda) << que << ": " << c;
}

/// Contra una imagen de referencia ya hecha.
inline void comprueba(const std::string &que, const Imagen &escena, const oraculo::ImagenRef &ref,
                      const Cotas &cotas = {}) {
    comprueba(que, oraculo::compara(escena, ref, std::max(cotas.maximo, 2.0)), cotas);
}

inline oraculo::Vec3 exacto(const glm::dvec3 &v) {
    return {v.x, v.y, v.z};
}

inline oraculo::Luz posicional(const oraculo::Vec3 &p) {
    oraculo::Luz luz;
    luz.posicion = p;
    return luz;
}
inline oraculo::Luz direccional(const oraculo::Vec3 &haciaLuz) {
    oraculo::Luz luz = posicional(haciaLuz);
    luz.w = 0;
    return luz;
}
inline oraculo::Luz foco(const oraculo::Vec3 &p, const oraculo::Vec3 &apunta, double delta,
                         double exponente) {
    oraculo::Luz luz = posicional(p);
    luz.foco = true;
    luz.S = oraculo::unitario(apunta - p);
    luz.delta = delta;
    luz.exponente = exponente;
    return luz;
}

/// Una malla de common/malla.h con su transformación ya hecha: vértices y normales unitarias.
inline oraculo::Objeto enElMundo(const oraculo::Mat4 &M, const Malla &m) {
    const oraculo::Mat4 inv = oraculo::inversa(M);
    std::vector<oraculo::VerticeRef> vertices;
    for (const Vertice &v : m.vertices)
        vertices.push_back(
            {oraculo::punto(M, exacto(v.posicion)), oraculo::transformaNormal(inv, exacto(v.normal))});
    std::vector<oraculo::Triangulos::Indices> indices;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        indices.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
    return oraculo::malla(oraculo::Mat4(), vertices, indices);
}

/// La luz fija de los capítulos 3 y 4 (luz_fija.glsl), con la normal que llega al fragment shader.
inline double luzFija(const oraculo::Vec3 &normal) {
    return 0.58 + 0.42 * oraculo::escalar(normal, {0.20, 0.78, 0.593});
}
/// Lo que vale en un punto de una malla lo que se interpola entre los vértices de su triángulo.
template<class EnVertice>
oraculo::Vec3 interpola(const oraculo::Objeto &objeto, const oraculo::Impacto &i, EnVertice enVertice) {
    const oraculo::Triangulos &malla = *objeto.triangulos;
    const auto &[a, b, c] = malla.indices[i.corte.triangulo];
    return (1 - i.corte.b1 - i.corte.b2) * enVertice(malla.vertices[a]) +
           i.corte.b1 * enVertice(malla.vertices[b]) + i.corte.b2 * enVertice(malla.vertices[c]);
}
/// En una malla, la interpolada entre las de los vértices, que son unitarias, sin volver a normalizarla.
inline oraculo::Vec3 normalInterpolada(const oraculo::Objeto &objeto, const oraculo::Impacto &i) {
    if (objeto.forma != oraculo::Objeto::MALLA)
        return i.normal;
    return interpola(objeto, i,
                     [&](const oraculo::VerticeRef &v) { return transformaNormal(objeto.inv, v.normal); });
}

/// Una escena con un color por objeto y la luz fija, contra lo que dibuja el programa.
struct Cuerpo {
    oraculo::Objeto objeto;
    oraculo::Vec3 color;
};
/// Sin sus colores.
inline oraculo::Escena objetos(const std::vector<Cuerpo> &cuerpos) {
    oraculo::Escena escena;
    for (const Cuerpo &c : cuerpos)
        escena.push_back(c.objeto);
    return escena;
}
inline oraculo::Comparacion comparaConLuzFija(const Imagen &escena, const std::vector<Cuerpo> &cuerpos,
                                              const oraculo::Camara &camara, const oraculo::Vec3 &fondo,
                                              double umbral = 1) {
    return oraculo::compara(
        escena, objetos(cuerpos), camara,
        [&](const oraculo::Impacto &i) {
            if (!i)
                return fondo;
            const Cuerpo &c = cuerpos[std::size_t(i.objeto)];
            return luzFija(normalInterpolada(c.objeto, i)) * c.color;
        },
        umbral);
}

/// Esquina y tamaño de un panel, en píxeles desde abajo a la izquierda.
struct Hueco {
    int x, y, ancho, alto;
};
/// El de esa columna y esa fila (contada desde arriba) de una rejilla con rayas de un 180º del alto útil de la ventana.
inline Hueco hueco(int columna, int columnas, int fila, int filas, int ancho, int alto) {
    const int raya = std::max(int(oraculo::altoUtil(ancho, alto) / 180), 1);
    const auto corte = [raya](int i, int n, int largo) { return i * (largo + raya) / n; };
    const int x = corte(columna, columnas, ancho), y = corte(filas - 1 - fila, filas, alto);
    return {x, y, corte(columna + 1, columnas, ancho) - raya - x,
            corte(filas - fila, filas, alto) - raya - y};
}
inline Imagen recorta(const Imagen &imagen, const Hueco &h) {
    return oraculo::recorta(imagen, h.x, h.y, h.ancho, h.alto);
}

/// Todo lo que corta un rayo, lo más cercano primero.
inline std::vector<oraculo::Impacto> impactos(const oraculo::Escena &escena, oraculo::Rayo r) {
    std::vector<oraculo::Impacto> todos;
    for (;;) {
        const oraculo::Impacto i = oraculo::primerImpacto(escena, r);
        if (!i)
            return todos;
        todos.push_back(i);
        r.minimo = i.distancia + 1e-9;
    }
}
