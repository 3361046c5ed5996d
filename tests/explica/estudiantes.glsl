// Fragment shaders como los que se escriben en un laboratorio: legales, y cada uno a su manera. Los separa una línea de iguales.
#version 140
in vec3 N,P; uniform vec3 luz,kd;
out vec4 c;
void main()
{
   vec3 n=normalize(N); vec3 l=normalize(luz-P);
   float d=dot(n,l);
   if(d<0.)d=0.;
   c=vec4(d*kd,1);
}
====
#version 140
#define PI 3.14159265358979
#define rad(g) ((g)*PI/180.0)
#define COLOR(r,g,b) vec4(r/255.,g/255.,b/255.,1.)
in vec2 uv; uniform float t; out vec4 FragColor;
void main ( void )
{
	float a = atan(uv.y, uv.x + 4.0) + rad(t * 30.);
	if (mod(floor(a * 6. / PI), 2.) == 0.) FragColor = COLOR(255., 128., 0.);
	else FragColor = COLOR(0., 64., 255.);
}
====
#version 140
in vec2 uv; out vec4 o; uniform sampler2D foto;
vec4 gris(vec4 c){float g=(c.r+c.g+c.b)/3.;return vec4(vec3(g),c.a);}
vec4 negativo(vec4 c){c.rgb=1.-c.rgb;return c;}
vec4 sepia(vec4 c){return vec4(min(vec3(dot(c.rgb,vec3(.393,.769,.189)),dot(c.rgb,vec3(.349,.686,.168)),dot(c.rgb,vec3(.272,.534,.131))),1.),c.a);}
uniform int modo;
void main(){vec4 c=texture(foto,uv);
switch(modo){case 0:o=c;break;case 1:o=gris(c);break;case 2:o=negativo(c);break;default:o=sepia(negativo(c));}}
====
#version 140
// Mandelbrot
in vec2 uv; out vec4 o; uniform int N;
void main() {
  vec2 z = vec2(0.0), c = uv * 1.5 - vec2(0.5, 0.0);
  int i = 0;
  while (i < 20 + N && dot(z, z) < 4.0) { z = vec2(z.x*z.x - z.y*z.y, 2.0*z.x*z.y) + c; i++; }
  if (i == 20 + N) { o = vec4(0.0, 0.0, 0.0, 1.0); return; }
  float k = float(i) / float(20 + N);
  o = vec4(k, 1.0 - k, abs(0.5 - k), 1.0);
}
====
#version 140
in float altura; out vec4 o;
void main() {
    if (altura < -1.0) { o = vec4(0.0, 0.0, 0.5, 1.0); }
    else if (altura < 0.0) { o = vec4(0.0, 0.3, 0.8, 1.0); }
    else if (altura < 1.0) { o = vec4(0.1, 0.6, 0.1, 1.0); }
    else { o = vec4(1.0); }
}
====
#version 140
flat in int id; flat in uvec2 par; out vec4 o;
void main() { uint h = par.x * 2654435761u ^ (par.y << 7); h ^= h >> 13u; h *= 0x5bd1e995u; ivec3 v = ivec3(id, ~id, -id) * 7919; v.xy <<= 2; o = vec4(float(h & 255u) / 255.0, vec3(v & 0xFF) / 255.0); }
====
#version 140
uniform Bloque { vec4 base; mat2 giro; float pesos[3]; }; layout(std140) uniform Mas { vec3 k[2]; int n; };
in vec2 uv; out vec4 o;
void main() { float s = n == 0 ? 0.0 : 1.0; for (int i = 0; i < 3; i++) s += pesos[i]; o = base * s + vec4(giro * uv, k[1].xy); }
====
#version 140
#ifdef NADA
esto no es nada { {
#elif defined(OTRA) || __VERSION__ < 100
esto tampoco
#else
#define SI(c) if (c)
#define NO else
#endif
in vec2 uv;
out vec4 o;
void main() { SI(uv.x > 0.0) o = vec4(1.0, 0.0, 0.0, 1.0); NO o = vec4(0.0, 1.0, 0.0, 1.0); }
====
#version 140
in vec2 uv; out vec4 o;
struct Rayo { vec3 o, d; }; struct Choque { bool hay; float t; vec3 n; };
Choque plano(Rayo r) { Choque c; c.hay = r.d.y < 0.0; c.t = c.hay ? -r.o.y / r.d.y : 0.0; c.n = vec3(0.0, 1.0, 0.0); return c; }
void main() { Rayo r = Rayo(vec3(0.0, 1.0, 0.0), normalize(vec3(uv, -1.0))); Choque c = plano(r); Choque d = c; if (d.hay) r.o += d.t * r.d; o = vec4(r.o, d.hay ? 1.0 : 0.0); }
====
#version 140
in vec2 uv; out vec4 o; uniform sampler2D s;
void main() { o = textureOffset(s, uv, ivec2(1, -1)) + textureLodOffset(s, uv, 0.0, ivec2(0, 1)) + textureProj(s, vec3(uv, 2.0)) + textureGrad(s, uv, dFdx(uv), dFdy(uv)); }
====
#version 140
in vec2 uv; out vec4 o;
void main() { float m[3] = float[3](uv.x, uv.y, 1.0); for (int i = 0; i < 3; i++) for (int j = i + 1; j < 3; j++) if (m[j] < m[i]) { float t = m[i]; m[i] = m[j]; m[j] = t; } o = vec4(m[0], m[1], m[2], m.length()); }
