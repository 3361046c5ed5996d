#version 140
in vec3 posicion;
in vec3 color;
in vec3 gemelo;
out vec3 vColor;
void main() {
    bool igual = gemelo == color;
    vColor = color;
    gl_Position = vec4(posicion + 0.2 * float(gl_InstanceID), 1.0);
    gl_PointSize = 9.0;
}
