#include "pila.h"
#include <cstdint>
#include <link.h>
#include <map>
#include <unwind.h>

namespace explica {
namespace {

const std::size_t HONDO = 16; // las llamadas que se guardan, como mucho

using Pila = std::vector<std::uintptr_t>;
std::map<Pila, int> pilas;

// Dónde ha puesto el sistema el ejecutable, y su código.
struct Ejecutable {
    std::uintptr_t base = 0, desde = 0, hasta = 0;

    Ejecutable() {
        const auto primero = [](dl_phdr_info *info, std::size_t, void *suyo) {
            Ejecutable &e = *static_cast<Ejecutable *>(suyo);
            e.base = info->dlpi_addr;
            for (int i = 0; i < info->dlpi_phnum; ++i)
                if (const auto &parte = info->dlpi_phdr[i]; parte.p_type == PT_LOAD && (parte.p_flags & PF_X))
                    e.desde = e.base + parte.p_vaddr, e.hasta = e.desde + parte.p_memsz;
            return 1; // el primero es el ejecutable
        };
        dl_iterate_phdr(primero, this);
    }
};

_Unwind_Reason_Code apunta(_Unwind_Context *contexto, void *suya) {
    static const Ejecutable ejecutable;
    Pila &pila = *static_cast<Pila *>(suya);
    const std::uintptr_t llama = _Unwind_GetIP(contexto) - 1; // se vuelve a la de después
    if (llama >= ejecutable.desde && llama < ejecutable.hasta)
        pila.push_back(llama - ejecutable.base);
    return pila.size() < HONDO ? _URC_NO_REASON : _URC_END_OF_STACK;
}

} // namespace

int pilaActual() {
    Pila pila;
    pila.reserve(HONDO);
    _Unwind_Backtrace(apunta, &pila);
    return pilas.insert({pila, int(pilas.size())}).first->second;
}

std::vector<Json> pilasEnJson() {
    std::vector<Json> todas(pilas.size());
    for (const auto &[pila, numero] : pilas)
        todas[std::size_t(numero)].pon("llamadas", pila);
    return todas;
}

} // namespace explica
