#version 140

#include "tests/costura/inclusion.glsl"

void main() {
    gl_Position = vec4(doble(1.0));
}
