#version 150

void main() {
    gl_Position = vec4(0.0);
}
