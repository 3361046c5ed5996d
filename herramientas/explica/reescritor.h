// Lee un shader palabra a palabra y va dando, de cada expresión y de cada sentencia, su texto reescrito: en un solo
// paso, sin árbol. Lo que no sabe leer lanza NoSe; la sentencia en que pasa se copia como estaba.
#pragma once
#include "glsl.h"
#include "lexico.h"
#include "preludio.h"
#include "tipos.h"
#include <map>
#include <set>

namespace explica {

/// Una expresión ya reescrita.
struct Expresion {
    std::string texto;
    Tipo tipo;          // solo de lo que puede estar a la izquierda de un =, o de un array recién construido
    bool lugar = false; // si es una variable o una parte suya
    bool efectos = false; // si calcularla dos veces no da lo mismo
    std::size_t desde = 0, hasta = 0;

    void yaNoEsLugar() {
        tipo = {};
        lugar = false;
    }
    void sigue(const std::string &signo, const Expresion &otra) {
        texto += signo + otra.texto;
        efectos |= otra.efectos;
        hasta = otra.hasta;
        yaNoEsLugar();
    }
};

/// Lo que nombra un nombre: una variable o una estructura.
struct Nombrado {
    Tipo tipo;
    bool esTipo = false;
    std::size_t donde = 0; // la palabra que lo declara: para saber si otra lo tapa
    bool conocido = false; // si es una constante entera y se sabe cuánto vale
    long long valor = 0;
};

/// Un parámetro, con la palabra que lo declara (0, si no tiene nombre).
struct Parametro {
    std::size_t donde = 0;
    Tipo tipo;
    bool entra = true, sale = false;
};

/// Calificadores y tipo de una declaración.
struct Cabeza {
    std::string calificadores, texto; // texto: el tipo
    Tipo tipo;
    bool constante = false, entra = false, sale = false, uniforme = false, sinTipo = false;
};

class Reescritor {
public:
    Reescritor(Preprocesado entrada, int cuantasSalidas, bool esFragmento, bool conLecturas);
    Reescrito hace();

private:
    // Lo que se lee
    Palabras p;
    std::string cabeceraDelShader;
    std::size_t i = 0;
    int salidas, hondo = 0;
    bool fragmento, apuntaLecturas;
    std::map<std::string, int> apariciones; // de cada palabra

    // Lo que se sabe
    std::vector<std::map<std::string, Nombrado>> ambitos;
    std::set<std::string> funciones;
    Palabra nombreFuncion; // en la que se está
    Cabeza devuelve;
    std::vector<Parametro> parametrosFuncion;
    bool congelado = false; // en una expresión constante, donde no se puede llamar a nada
    bool arriba = false;    // en una expresión que es toda una sentencia
    bool admite = false;    // si al acabar la sentencia se puede apuntar algo más: `pendientes`
    std::string pendientes;
    bool lleno = false;

    // Lo que sale
    Reescrito r;
    std::set<std::string> tipos, varian;
    std::set<Leida> lecturas;
    std::map<std::string, std::set<std::string>> llegan; // a cada parámetro, «funcion/0», qué texturas
    std::string alEmpezar, alAcabar;
    std::set<std::string> daba; // las salidas de un fragment shader, que pasan a ser variables como las demás

    const Palabra &ahora() const {
        return p[i];
    }
    bool es(const char *que, std::size_t mas = 0) const;
    bool toma(const char *que); // si es esa, la pasa
    void exige(const char *que);
    std::size_t nombreNuevo(); // pasa un nombre y dice dónde está
    std::string emite(const Palabra &palabra) const;
    std::string copia(std::size_t desde, std::size_t hasta) const;
    std::string copiaSentencia();
    std::size_t cierre(std::size_t desde) const; // de lo que abre esa palabra: ( [ {
    template<class Lee>
    std::string intenta(const Lee &lee); // lo que lee o, si no sabe, la sentencia como estaba

    // apuntes.cpp
    int apunta(Clase clase, const Palabra &donde, const std::string &nombre, const std::string &tipo);
    std::string sinValor(Clase clase, const Palabra &donde, const std::string &nombre);
    std::string envuelve(Clase clase, const Palabra &donde, const std::string &nombre, const Tipo &tipo,
                         const std::string &valor);
    std::string partes(Clase clase, const Palabra &donde, const std::string &nombre, const Tipo &tipo,
                       const std::string &valor);
    void avisa(const Palabra &donde, const std::string &motivo);
    std::string comoEsta(const Expresion &e) const;
    const Nombrado *busca(const std::string &nombre) const;
    void abre();
    void cierra();
    void declara(std::size_t donde, const Tipo &tipo, bool esTipo = false);

    // expresiones.cpp
    Expresion expresion(); // con comas
    Expresion asignacion();
    Expresion constante(); // donde no se puede llamar a nada
    Expresion ternaria();
    Expresion binaria(int minima);
    Expresion unaria();
    Expresion posfija();
    Expresion primaria();
    Expresion llamada(bool construye);
    std::vector<Expresion> argumentos(const std::string &funcion);
    void apuntaLectura(const std::string &funcion, Expresion &e, const std::vector<Expresion> &dados);
    std::string texturaDe(const Expresion &e) const;
    std::set<std::string> deDonde(const std::string &textura, int quedan) const;
    void trasPosfijo(Expresion &e);
    void apuntaAsignacion(Expresion &a, const std::string &lugar, bool repetible, bool toda);

    // declaraciones.cpp
    bool esTipo(std::size_t donde) const;
    bool empiezaDeclaracion() const;
    Cabeza cabeza();
    void calificador(Cabeza &c);
    std::string defineEstructura(Tipo &tipo);
    bool conoce(std::size_t desde, std::size_t hasta, long long &valor) const; // de una constante entera
    std::string corchetes(Tipo &tipo);                                         // los de un array, si los hay
    std::string declaracion(const Cabeza &c, std::string &despues);
    std::string inicial(const Cabeza &c, std::size_t nombre, Tipo &tipo, std::string &despues);
    std::string global();
    std::string globales(const Cabeza &c);
    std::string bloqueUniforme(const Cabeza &c);
    std::string definicion(const Cabeza &c);
    std::string parametros();
    void entradasDelSistema();

    // sentencias.cpp
    std::string sentencia();
    std::string conocida();
    std::string simple();
    std::string bloque();
    std::string cuerpo();
    std::string condicion(Clase clase);
    std::string si();
    std::string para();
    std::string mientras();
    std::string haz();
    std::string elige();
    std::string caso();
    std::string regresa();
    std::string descarta();
    std::string alSalir(const Palabra &donde);
};

/// Las llamadas unas dentro de otras no agotan la pila: pasadas 200, lanza NoSe.
class Hondo {
public:
    Hondo(int &n, const Palabra &donde) : hondo(n) {
        if (hondo >= 200)
            throw NoSe(donde, "hay demasiadas cosas unas dentro de otras");
        ++hondo;
    }
    ~Hondo() {
        --hondo;
    }
    Hondo(const Hondo &) = delete;
    Hondo &operator=(const Hondo &) = delete;

private:
    int &hondo;
};

template<class Lee>
std::string Reescritor::intenta(const Lee &lee) {
    const std::size_t inicio = i, cuantos = ambitos.size(), notas = r.notas.size(),
                      empezar = alEmpezar.size(), acabar = alAcabar.size();
    arriba = admite = congelado = false;
    pendientes.clear();
    try {
        return lee();
    } catch (const NoSe &e) {
        r.sinSeguir.push_back({e.linea, e.fichero, e.what()});
        r.notas.resize(notas);
        ambitos.resize(cuantos);
        alEmpezar.resize(empezar);
        alAcabar.resize(acabar);
        i = inicio;
        return copiaSentencia();
    }
}

} // namespace explica
