// La escena de espejo.cpp en POV-Ray: W y H, su tamaño.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
#declare ALTO = tan(0.25); // la mitad de lo que se ve en vertical, a distancia 1
background { color rgb <0.95, 0.96, 0.98> }
camera {
    perspective
    location <1.5, 1.2, 5.2>
    up y
    right -x * image_width / image_height // con X a la derecha y Z hacia quien mira
    angle 2 * degrees(atan(ALTO * image_width / image_height))
    look_at <0, 0, 0>
}
light_source { <-3, 4, 6>, rgb 1 }
sphere {
    <0, 0.45, 0>, 0.55
    pigment { color rgb <0.62, 0.26, 0.17> }
    finish { ambient rgb <0.20 / 0.62, 0.08 / 0.26, 0.05 / 0.17> diffuse 1 phong 0.7 phong_size 16 }
}
plane {
    y, -0.15
    pigment { color rgb 0 }
    finish { ambient 0 diffuse 0 reflection 1 }
}
