// Un sólido iluminado, dibujado con los shaders de los programas y trazado con el oráculo: la cámara y la luz, una sola
// vez.
#pragma once
#include "ch05_iluminacion/iluminacion.h"
#include "gpu.h"
#include "herramientas/oraculo/oraculo.h"
#include <glm/gtc/matrix_transform.hpp>

namespace mide {

const float ANGULO = 0.5f;
const glm::vec3 OJO(1.5f, 1.2f, 5.2f), FONDO(0.95f, 0.96f, 0.98f);
const ::Luz LUZ{{-3, 4, 6, 1}};
const ::Material CORAL = {{0.20f, 0.08f, 0.05f}, {0.62f, 0.26f, 0.17f}, {0.70f, 0.70f, 0.70f}, 16};

inline glm::mat4 camaraEscena() {
    return glm::lookAt(OJO, glm::vec3(0), glm::vec3(0, 1, 0));
}
inline glm::mat4 proyeccionEscena(const Framebuffer &framebuffer) {
    return glm::perspective(ANGULO, float(framebuffer.ancho) / float(framebuffer.alto), 0.5f, 50.0f);
}

inline oraculo::Vec3 exacto(const glm::vec3 &v) {
    return {v.x, v.y, v.z};
}
inline oraculo::Camara camaraExacta() {
    return oraculo::perspectiva(oraculo::miraDesde(exacto(OJO), {}), ANGULO, 0.5, 50);
}

/// Una malla de coral, iluminada con ese programa.
inline void mideIluminada(const Dibujadas &variante, const Framebuffer &framebuffer,
                          const std::string &nombre, const std::string &nota, GLuint programa,
                          const Malla &malla, const glm::mat4 &M) {
    const Buferes b = creaBuferes(malla);
    usaIluminado(programa, camaraEscena(), proyeccionEscena(framebuffer), LUZ);
    variante(nombre, nota, [&] {
        framebuffer.borra(FONDO);
        dibujaIluminado(programa, b, M, camaraEscena(), CORAL);
    });
    borraBuferes(b);
}

inline oraculo::Vec3 phongExacto(const oraculo::Vec3 &P, const oraculo::Vec3 &N) {
    const oraculo::Material material = {exacto(CORAL.Ka), exacto(CORAL.Kd), exacto(CORAL.Ks), CORAL.alfa};
    const oraculo::Luz luz{exacto(glm::vec3(LUZ.Lp))};
    return oraculo::phong(material, {1, 1, 1}, {luz}, P, N, oraculo::unitario(exacto(OJO) - P));
}

/// La imagen exacta de una esfera de coral.
inline oraculo::ImagenRef trazaEsfera(const Framebuffer &framebuffer, double radio = 1) {
    return oraculo::render(
        {oraculo::esfera(oraculo::escala(radio))}, camaraExacta(), framebuffer.ancho, framebuffer.alto,
        [](const oraculo::Impacto &i) { return i ? phongExacto(i.punto, i.normal) : exacto(FONDO); });
}

/// Raíz del error cuadrático medio, en niveles, de los píxeles que cuentan.
inline double errorDonde(const Imagen &gpu, const oraculo::ImagenRef &ref,
                         const std::function<bool(int x, int y)> &cuenta) {
    double suma = 0;
    int n = 0;
    for (int y = 0; y < ref.alto; ++y)
        for (int x = 0; x < ref.ancho; ++x)
            if (cuenta(x, y)) {
                suma += std::pow(oraculo::diferencia(gpu, x, y, ref.en(x, y).color), 2);
                ++n;
            }
    return std::sqrt(suma / n);
}

/// El de donde la referencia ve algo casi de frente: el contorno se juzga aparte.
inline double errorDeFrente(const Imagen &gpu, const oraculo::ImagenRef &ref) {
    return errorDonde(gpu, ref, [&](int x, int y) {
        const oraculo::PixelRef &p = ref.en(x, y);
        return p.objeto >= 0 && oraculo::escalar(p.normal, oraculo::unitario(exacto(OJO) - p.punto)) >= 0.5;
    });
}

} // namespace mide
