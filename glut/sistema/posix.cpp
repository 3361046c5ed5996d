#include "sistema.h"
#include <cerrno> // program_invocation_short_name, de glibc
#include <csignal>
#include <unistd.h>

const char SEPARADOR_DE_CARPETAS = ':';
const int FREEGLUT_CON_UTF8 = 30800; // los anteriores los dan a X11 como Latin-1

std::filesystem::path ejecutable() {
    std::error_code noSeSabe;
    return std::filesystem::read_symlink("/proc/self/exe", noSeSabe);
}

std::string nombreDelEjecutable() {
    return program_invocation_short_name;
}

int numeroDeProceso() {
    return getpid();
}

struct SinSenales::Antes {
    sigset_t bloqueadas;
};

SinSenales::SinSenales() : antes(new Antes) {
    sigset_t acaban;
    sigemptyset(&acaban);
    for (int senal : {SIGHUP, SIGINT, SIGTERM})
        sigaddset(&acaban, senal);
    sigprocmask(SIG_BLOCK, &acaban, &antes->bloqueadas);
    std::signal(SIGXFSZ, SIG_IGN);
}

SinSenales::~SinSenales() {
    sigprocmask(SIG_SETMASK, &antes->bloqueadas, nullptr);
}
