// Juzgar a quien juzga.
#pragma once
#include <gtest/gtest-spi.h>

/// Si lo que se juzga en f no pasa.
template<class F>
bool falla(const F &f) {
    testing::TestPartResultArray quejas;
    {
        const testing::ScopedFakeTestPartResultReporter apunta(
            testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &quejas);
        f();
    }
    return quejas.size() > 0;
}
