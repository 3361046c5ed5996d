// Una función con un error a propósito, para incluirla (tests/costura/costura_test.cpp).
float doble(float x) {
    return 2.0 * y;
}
