// Un modelo de GLUT, escrito otra vez y más corto, y partidas al azar: lo que se le hace a tests/costura/registro.cpp y
// lo que tiene que escribir, línea por línea (glut_test.cpp).
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace partida {

using Numeros = std::vector<int>;

const int ANCHO = 300, ALTO = 200;                                 // la ventana, al empezar
const std::pair<int, int> PANTALLA = {1920, 1080};                 // la que no hay
const char *const BOTONES[] = {"IZQUIERDO", "CENTRAL", "DERECHO"}; // los que pueden tener menú

inline std::string une(std::string texto, const Numeros &numeros) {
    for (const int n : numeros)
        texto += " " + std::to_string(n);
    return texto;
}

class Partida {
public:
    std::string tandas; // el argumento de registro
    std::string guion, diario, rasgos;

    explicit Partida(unsigned semilla) : azar(semilla) {
        for (const char *una : FUNCIONES)
            pon(una, 1);
        for (int i = 0; i < 12; ++i) // con menús desde el principio
            if (const std::string que = i % 4 == 0 ? "crea" : "opcion"; !prueba(que))
                prueba("crea");
        prueba("enlaza");
        if (n(2))
            prueba("talla");
        if (funcion["tamano"])
            apunta(une("tamano", {funcion["tamano"], talla.first, talla.second}));
        repinta = true;
        trabaja();
        da("mueve", {20, 30});
        llevaRaton({20, 30});
        trabaja();
        for (int i = 0; i < 40 && !termina; ++i)
            orden();
        for (const char *rasgo : {"teclado", "especial", "raton", "arrastre", "movimiento", "rueda"})
            if (funcion[rasgo])
                rasgos += std::string(rasgo) + "\n";
        if (!relojes.empty())
            rasgos += "temporizador\n";
        for (const int menu : deBoton)
            if (menu)
                enumera(menu, "");
    }

private:
    static constexpr const char *FUNCIONES[] = {"dibuja", "tamano",   "teclado",    "especial",
                                                "raton",  "arrastre", "movimiento", "rueda"};
    struct Entrada {
        int texto, valor, submenu; // 0 si es una opción
    };
    struct Menu {
        int funcion;
        std::vector<Entrada> entradas;
    };
    struct Opcion {
        std::string ruta;
        int menu, funcion, valor;
    };

    std::mt19937 azar;
    bool repinta = false, termina = false, completa = false, conmutaCompleta = false;
    std::map<std::string, int> funcion; // su versión; 0: ninguna
    std::map<int, Menu> menus;
    int actual = 0, creados = 0, deBoton[3] = {}, rotulos = 10000000, titulo = 0;
    bool abierto = false;
    std::pair<int, int> talla = {ANCHO, ALTO}, pedida, previa, puntero = {-1, -1};
    std::set<int> pulsados;
    long long reloj = 0;
    std::multimap<long long, int> relojes;
    std::set<std::string> yaEnLaTanda;

    int n(int cuantos) {
        return int(azar() % unsigned(cuantos));
    }

    // --- lo que se apunta y lo que se manda ---

    void apunta(const std::string &que) {
        diario += une(que + " |", {talla.first}) + "x" + std::to_string(talla.second) + ", a " +
                  std::to_string(reloj) + " ms\n";
    }
    void da(const std::string &que) {
        guion += que + ";";
    }
    void da(const std::string &que, std::pair<int, int> p) {
        const int f = 1 + n(2); // como si la ventana fuera el doble
        guion += une("escala", {f * talla.first, f * talla.second}) + ";";
        da(une(que, {f * p.first, f * p.second}));
    }

    // --- GLUT ---

    void llama(const std::string &nombre, const Numeros &a = {}) {
        tandas += une(nombre, a) + ";";
        yaEnLaTanda.insert(nombre);
        if (std::count(std::begin(FUNCIONES), std::end(FUNCIONES), nombre))
            funcion[nombre] = a[0];
        else if (nombre == "crea")
            menus[actual = ++creados] = {a[0], {}};
        else if (nombre == "actual")
            actual = a[0];
        else if (nombre == "opcion")
            menus[actual].entradas.push_back({a[0], a[1], 0});
        else if (nombre == "submenu")
            menus[actual].entradas.push_back({a[0], -1, a[1]});
        else if (nombre == "enlaza")
            deBoton[a[0]] = actual;
        else if (nombre == "temporizador")
            relojes.emplace(reloj + std::max(a[0], 1), a[1]);
        else if (nombre == "repinta")
            repinta = true;
        else if (nombre == "talla")
            pedida = {a[0], a[1]};
        else if (nombre == "completa")
            conmutaCompleta = true;
        else if (nombre == "titulo")
            ponTitulo(a[0]);
        else
            termina = true;
        apunta(une("- " + nombre, a));
    }

    void dibuja() {
        if (!repinta || termina)
            return;
        repinta = funcion["dibuja"] == 2;
        apunta(une("dibuja", {funcion["dibuja"]}));
    }

    void cambiaTalla(std::pair<int, int> nueva) {
        if (nueva == talla)
            return;
        talla = nueva;
        if (funcion["tamano"])
            apunta(une("tamano", {funcion["tamano"], talla.first, talla.second}));
        repinta = true;
    }

    // La talla que pide el programa es la de la ventana cuando acaba la función en que la pide.
    void tallaPendiente() {
        if (std::exchange(conmutaCompleta, false) && !termina) {
            completa = !completa;
            previa = completa ? talla : previa;
            cambiaTalla(completa ? PANTALLA : previa);
        }
        if (const auto nueva = std::exchange(pedida, {}); nueva.first && !termina) {
            completa = false;
            cambiaTalla(nueva);
        }
    }

    void trabaja() {
        tallaPendiente();
        dibuja();
    }

    // El diario dice los que cambian.
    void ponTitulo(int cual) {
        if (std::exchange(titulo, cual) != cual)
            diario += "título: " + std::to_string(cual) + "\n";
    }

    void llega(const std::string &que, int quien, int valor) {
        apunta(une(que, {quien, valor}));
        if (valor % 10 == 7)
            tanda();
    }

    void pasa(int ms) {
        const long long fin = reloj + ms;
        while (!termina && !relojes.empty() && relojes.begin()->first <= fin) {
            const auto [vence, valor] = *relojes.begin();
            relojes.erase(relojes.begin());
            reloj = vence;
            llega("temporizador", 0, valor);
            trabaja();
        }
        reloj = fin;
    }

    void llevaRaton(std::pair<int, int> adonde) {
        if (std::exchange(puntero, adonde) == adonde || abierto)
            return;
        // X solo dice cuáles de los cinco primeros botones están pulsados
        const char *quien = !pulsados.empty() && *pulsados.begin() < 5 ? "arrastre" : "movimiento";
        if (funcion[quien])
            apunta(une(quien, {funcion[quien], adonde.first, adonde.second}));
    }

    // Un clic fuera del menú abierto lo cierra, y puede abrir otro; el programa no se entera.
    void boton(int cual, int estado, bool esRueda = false) {
        const bool suyo = cual < 3 && deBoton[cual];
        if (abierto || (suyo && estado == 0)) {
            abierto = estado == 0 ? suyo : abierto;
            return;
        }
        if (esRueda && funcion["rueda"]) {
            if (estado == 0)
                apunta(
                    une("rueda", {funcion["rueda"], 0, cual == 3 ? 1 : -1, puntero.first, puntero.second}));
        } else if (funcion["raton"]) {
            apunta(une("raton", {funcion["raton"], cual, estado, puntero.first, puntero.second}));
        }
    }

    void enumera(int menu, const std::string &ruta) {
        for (const Opcion &o : opciones(menu, ruta))
            rasgos += "opcion " + o.ruta + "\n";
    }
    std::vector<Opcion> opciones(int menu, const std::string &ruta) {
        std::vector<Opcion> todas;
        for (const Entrada &e : menus[menu].entradas) {
            const std::string suya = ruta + std::to_string(e.texto);
            if (!e.submenu) {
                todas.push_back({suya, menu, menus[menu].funcion, e.valor});
                continue;
            }
            for (const Opcion &o : opciones(e.submenu, suya + "/"))
                todas.push_back(o);
        }
        return todas;
    }

    // --- al azar: lo que el programa pide ---

    void tanda() {
        tandas += "/";
        yaEnLaTanda.clear();
        for (int veces = n(5); veces > 0 && !termina; --veces) {
            static const char *const QUE[] = {"crea",    "crea",    "opcion", "opcion", "opcion",
                                              "submenu", "actual",  "enlaza", "talla",  "temporizador",
                                              "repinta", "repinta", "titulo", "",       "",
                                              "",        "completa"};
            prueba(QUE[n(int(std::size(QUE)))]);
        }
        if (n(30) == 0)
            llama("acaba");
    }

    // Si tiene sentido ahora, la llama. Sin nombre, una de las funciones.
    bool prueba(const std::string &que) {
        const std::string una = FUNCIONES[n(int(std::size(FUNCIONES)))];
        const int vivo = menus.empty() ? 0 : std::next(menus.begin(), n(int(menus.size())))->first;
        if (que.empty())
            return pon(una, 0), true;
        if (que == "crea")
            return llama(que, {n(2) + 1}), true;
        if (que == "titulo")
            return llama(que, {!titulo || n(2) ? ++rotulos : titulo}), true;
        if (que == "repinta")
            return llama(que), true;
        if (que == "temporizador")
            return llama(que, {n(n(2) ? 2 : 50), n(100)}), true;
        if (que == "talla" && !yaEnLaTanda.count("completa"))
            return llama(que, {260 + n(100), 200 + n(100)}), true;
        if (que == "completa" && !yaEnLaTanda.count("completa") && !yaEnLaTanda.count("talla"))
            return llama(que), true;
        if (vivo && que == "actual")
            return llama(que, {vivo}), true;
        if (!actual)
            return false;
        if (que == "opcion" && menus[actual].entradas.size() < 6)
            return llama(que, {++rotulos, n(3) ? 10 * n(9) : 7}), true;
        if (que == "submenu" && vivo && vivo < actual) // sin lazos
            return llama(que, {++rotulos, vivo}), true;
        if (que == "enlaza")
            return llama(que, {n(3)}), true;
        return false;
    }

    // Una versión de esa función, desde `minima`. Sin dibujar o sin órdenes no se sigue.
    void pon(const std::string &una, int minima) {
        minima = una == "dibuja" || una == "especial" ? 1 : minima;
        llama(una, {minima + n(3 - minima)});
    }

    // --- al azar: lo que se le hace ---

    std::pair<int, int> sitio() {
        return {5 + n(240), 5 + n(180)};
    }

    void tecla() {
        const bool esc = n(60) == 0;
        const char cual = esc ? 27 : "azq5-,."[n(7)];
        da(esc ? "tecla Esc" : std::string("tecla ") + cual);
        if (const int version = funcion["teclado"]) {
            apunta(une("teclado", {version, cual, puntero.first, puntero.second}));
            termina = esc;
        }
        trabaja();
    }

    void especial() {
        static const std::pair<const char *, int> TECLAS[] = {
            {"F2", 2},      {"F9", 9},    {"IZQUIERDA", 100}, {"ABAJO", 103},
            {"REPAG", 104}, {"FIN", 107}, {"INSERTAR", 108}};
        const auto &[nombre, codigo] = TECLAS[n(int(std::size(TECLAS)))];
        da(std::string("especial ") + nombre);
        apunta(une("especial", {funcion["especial"], codigo, puntero.first, puntero.second}));
        tanda();
        trabaja();
    }

    void espera(int ms) {
        da("espera " + std::to_string(ms));
        pasa(ms);
        trabaja();
    }

    void mueve(std::pair<int, int> adonde) {
        da(pulsados.empty() ? "mueve" : "arrastra", adonde);
        llevaRaton(adonde);
        trabaja();
    }

    void pulsa(int cual, bool abajo, std::pair<int, int> donde) {
        da("boton " + (cual < 3 ? BOTONES[cual] : std::to_string(cual)) + (abajo ? " abajo" : " arriba"),
           donde);
        llevaRaton(donde);
        abajo ? void(pulsados.insert(cual)) : void(pulsados.erase(cual));
        boton(cual, abajo ? 0 : 1);
        trabaja();
    }

    void arrastra() {
        const int uno = std::array{0, 1, 2, 5, 8}[std::size_t(n(5))];
        if (uno < 3 && deBoton[uno])
            return abreYCierra(uno);
        pulsa(uno, true, sitio());
        mueve(sitio());
        if (n(2))
            tecla();
        // hasta que se da un menú al botón que está pulsado
        for (int veces = uno > 2 ? 0 : n(9); veces > 0 && !termina && !deBoton[uno]; --veces)
            especial();
        if (!termina)
            pulsa(uno, false, sitio());
    }

    void rueda() {
        const std::pair<int, int> donde = sitio();
        const int cual = 3 + n(2);
        da(std::string("rueda ") + (cual == 3 ? "+1" : "-1"), donde);
        giraRueda(cual, donde);
    }
    void giraRueda(int cual, std::pair<int, int> donde) {
        llevaRaton(donde);
        boton(cual, 0, true);
        boton(cual, 1, true);
        trabaja();
    }

    // Sale hacia abajo y a la derecha: los clics que lo cierran, o lo abren otra vez, cada vez más a la izquierda.
    void abreYCierra(int cual) {
        int x = 200;
        const auto clic = [&](int con) {
            x -= 5 + n(20);
            pulsa(con, true, {x, 20 + n(100)});
            pulsa(con, false, puntero);
        };
        clic(cual);
        for (int veces = n(3); veces > 0 && abierto && !termina; --veces)
            n(2) ? tecla() : clic(n(3));
        if (abierto && !termina && n(2))
            return eligeOpcion();
        if (abierto && !termina) {
            da("rueda +1", {x - 20, 9});
            giraRueda(3, {x - 20, 9});
        }
    }

    void eligeOpcion() {
        const int cual = n(3);
        const auto todas = deBoton[cual] ? opciones(deBoton[cual], "") : std::vector<Opcion>();
        if (todas.empty())
            return tecla();
        const Opcion o = todas[std::size_t(n(int(todas.size())))];
        mueve({talla.first - 5, 10 + n(20)});
        da("menu " + o.ruta);
        const int antes = std::exchange(actual, o.menu);
        abierto = false;
        llega("menu", o.funcion, o.valor);
        actual = antes;
        trabaja();
        if (!termina)
            mueve(sitio());
    }

    void orden() {
        switch (n(10)) {
        case 0: return tecla();
        case 1: return mueve(sitio());
        case 2: return rueda();
        case 3: return arrastra();
        case 4: return eligeOpcion();
        case 5: return espera(n(60));
        case 6: {
            const std::pair<int, int> nueva = {260 + n(100), 200 + n(100)};
            da(une("tamano", {nueva.first, nueva.second}));
            cambiaTalla(nueva);
            return trabaja();
        }
        default: return especial();
        }
    }
};

} // namespace partida
