// Fragment shaders como los que se escriben en un laboratorio: legales, y cada uno a su manera. Los separa una línea de iguales.
#version 140
in vec3 normal; out vec4 color;
void main(){color=vec4(normalize(normal)*.5+.5,1.);}
====
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
in vec3 P; out vec4 o;
float ruido(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float suave(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f*f*(3.0-2.0*f);
    return mix(mix(ruido(i), ruido(i + vec2(1.0, 0.0)), f.x), mix(ruido(i + vec2(0.0, 1.0)), ruido(i + vec2(1.0)), f.x), f.y);
}
float fbm(vec2 p) { float v = 0.0, a = 0.5; for (int i = 0; i < 5; ++i, p *= 2.0, a *= 0.5) v += a * suave(p); return v; }
void main() { float v = fbm(P.xy * 3.0); o = vec4(v, v * v, sqrt(v), 1.0); }
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
in vec2 uv; out vec4 o; uniform vec3 colores[4]; uniform int cual;
void main() { vec3 c[4]; for (int i = 3; i >= 0; i--) c[i] = colores[3 - i] * uv.x; c[cual & 3].g += uv.y; o = vec4(c[cual & 3], 1.0); }
====
#version 140
struct Luz { vec3 pos; vec3 color; float intensidad; };
uniform Luz luces[3]; in vec3 P; in vec3 N; out vec4 fragColor;
vec3 difusa(in Luz l, const in vec3 n) { vec3 d = l.pos - P; float r2 = dot(d, d); return l.color * l.intensidad * max(0.0, dot(n, d * inversesqrt(r2))) / (1.0 + r2); }
void main() {
    vec3 suma = vec3(0.0), n = normalize(N);
    for (int i = 0; i < luces.length(); i++) { Luz l = luces[i]; l.intensidad *= 2.0; suma += difusa(l, n); }
    fragColor = vec4(suma / (1.0 + suma), 1.0);
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
in vec2 uv; out vec4 o;
bool dentro(vec2 p, vec2 centro, float r) { return distance(p, centro) < r; }
void main() { if (!dentro(uv, vec2(0.0), 1.5)) discard; if (dentro(uv, vec2(0.3), 0.4) || dentro(uv, vec2(-0.3, 0.3), 0.4)) o = vec4(0.0); else o = vec4(1.0, 1.0, 0.0, 1.0); }
====
#version 140
in vec2 uv; out vec4 o; uniform float t;
void gira(inout vec2 p, float a) { float c = cos(a), s = sin(a); p = vec2(c * p.x - s * p.y, s * p.x + c * p.y); }
void polares(vec2 p, out float r, out float a) { r = length(p); a = atan(p.y, p.x); }
void main() { vec2 p = uv; gira(p, t); float r, a; polares(p, r, a); o = vec4(fract(r * 3.0), fract(a * 2.0), 0.0, 1.0); }
====
#version 140
in vec2 uv; out vec4 o;
float f(float x) { return x * x; } vec2 f(vec2 x) { return x * x * x; } float f(float x, float y) { return f(x) + f(y); }
void main() { o = vec4(f(uv), f(uv.x, f(uv.y)), f(f(f(uv.x)))); }
====
#version 140
in vec2 uv; out vec4 o;
const int N = 3; const float PESOS[N] = float[N](0.25, 0.5, 0.25); uniform sampler2D img;
void main() { vec4 s = vec4(0.0); for (int j = -1; j <= 1; ++j) for (int i = -1; i <= 1; ++i) s += PESOS[i + 1] * PESOS[j + 1] * textureLod(img, uv + vec2(i, j) / vec2(textureSize(img, 0)), 0.0); o = s; }
====
#version 140
in vec2 uv; out vec4 o;
float uv2(float uv) { float x = uv; { float x = x + 1.0; uv *= x; } return uv + x; }
void main() { float o2 = uv2(uv.x); { vec2 uv = vec2(o2); o2 += uv.y; } o = vec4(o2, uv2(o2), uv); }
====
#version 140
in vec2 uv; out vec4 o; uniform int n;
void main() { int i = 0, j = 10; do { if ((i & 1) == 0) { i += 3; continue; } j -= i; if (j < -n) break; ++i; } while (i < 12); o = vec4(float(i), float(j), uv); }
====
#version 140
flat in int id; flat in uvec2 par; out vec4 o;
void main() { uint h = par.x * 2654435761u ^ (par.y << 7); h ^= h >> 13u; h *= 0x5bd1e995u; ivec3 v = ivec3(id, ~id, -id) * 7919; v.xy <<= 2; o = vec4(float(h & 255u) / 255.0, vec3(v & 0xFF) / 255.0); }
====
#version 140
in vec3 P; out vec4 o; uniform mat4 M; uniform mat3 R;
void main() { mat4 A = M * transpose(M); mat3 B = mat3(A) * R; B[1] += P; B[2][0] = -B[0].z; vec4 q = A * vec4(P, 1.0); q /= q.w == 0.0 ? 1.0 : q.w; o = vec4(B * q.xyz, dot(B[0], cross(B[1], B[2]))); }
====
#version 140
in vec2 uv; out vec4 o;
void main() { float s = 0.0; for (float x = 0.0, y = 1.0; x < 1.0; x += 0.25, y *= 0.5) s += x * y; o.r = s; o.g = (s += 1.0, s * uv.x); o.ba = uv.yx; }
====
#version 140
in vec2 uv; out vec4 o;
void main() { vec2 a, b, c; a = b = c = uv; a.x = b.y = c.x += 1.0; o = vec4(a, b) + c.xyxy; }
====
#version 140
in vec2 uv; out vec4 o; uniform samplerCube cielo; uniform sampler3D vol; uniform sampler2DShadow sombra; uniform usampler2D ids;
void main() { o = texture(cielo, vec3(uv, 1.0)) + textureLod(vol, vec3(uv, .5), 0.) * texture(sombra, vec3(uv, .5)) + vec4(texelFetch(ids, ivec2(abs(uv)), 0)) / 4294967295.; }
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
in vec2 uv;out vec4 o;float g=1.;void suma(float x){g+=x;}float dos(){suma(1.);suma(2.);return g;}
void main(){float a=dos()+dos()*uv.x;suma(a);o=vec4(g,a,uv);}
====
#version 140
in vec2 uv; out vec4 o;
int menor(int a, int b) { return a < b ? a : b; } int mayor(int a, int b) { if (a > b) return a; return b; }
void main() { int x = int(uv.x * 10.0), y = int(uv.y * 10.0); o = vec4(float(menor(mayor(x, y), menor(x++, ++y))), float(x), float(y--), float(y)); }
====
#version 140
in vec2 uv; out vec4 o;
bool par(int n) { bool r = true; for (int i = 0; i < n; ++i) r = !r; return r; }
void main() { ivec2 q = ivec2(floor(abs(uv) * 8.0)); o = par(q.x) ^^ par(q.y) ? vec4(vec3(0.1), 1.0) : vec4(vec3(0.9), 1.0); }
====
#version 140
in vec4 p; out vec4 o;
void main()
{
    /* un comentario { que abre y no cierra */ vec4 c = p; // y otro } aquí
    bvec4 b = greaterThan(c, vec4(0.0)); if (any(b)) c = mix(c, vec4(0.5), b);
    if (all(b)) { discard; }
    o = c
        * 2.0
        ;
}
====
#version 140
in vec2 uv; out vec4 o;
vec3 hsv(float h, float s, float v) {
    h = fract(h) * 6.0; int i = int(h); float f = h - float(i), p = v * (1.0 - s), q = v * (1.0 - s * f), t = v * (1.0 - s * (1.0 - f));
    return i == 0 ? vec3(v, t, p) : i == 1 ? vec3(q, v, p) : i == 2 ? vec3(p, v, t) : i == 3 ? vec3(p, q, v) : i == 4 ? vec3(t, p, v) : vec3(v, p, q);
}
void main() { o = vec4(hsv(uv.x, abs(uv.y), 1.0), 1.0); }
====
#version 140
in vec2 uv; out vec4 o;
float esfera(vec3 p, float r) { return length(p) - r; }
float escena(vec3 p) { return min(esfera(p, 1.0), p.y + 1.0); }
void main() {
    vec3 ojo = vec3(0.0, 0.0, 3.0), d = normalize(vec3(uv, -1.5)); float t = 0.0; bool toca = false;
    for (int i = 0; i < 40 && !toca && t < 20.0; ++i) { float e = escena(ojo + t * d); toca = e < 0.001; t += e; }
    if (!toca) { o = vec4(0.5, 0.7, 1.0, 1.0); return; }
    vec3 p = ojo + t * d, n; for (int k = 0; k < 3; ++k) { vec3 h = vec3(0.0); h[k] = 0.01; n[k] = escena(p + h) - escena(p - h); }
    o = vec4(normalize(n) * 0.5 + 0.5, 1.0);
}
====
#version 140
in vec2 uv; out vec4 o;
struct Rayo { vec3 o, d; }; struct Choque { bool hay; float t; vec3 n; };
Choque plano(Rayo r) { Choque c; c.hay = r.d.y < 0.0; c.t = c.hay ? -r.o.y / r.d.y : 0.0; c.n = vec3(0.0, 1.0, 0.0); return c; }
void main() { Rayo r = Rayo(vec3(0.0, 1.0, 0.0), normalize(vec3(uv, -1.0))); Choque c = plano(r); Choque d = c; if (d.hay) r.o += d.t * r.d; o = vec4(r.o, d.hay ? 1.0 : 0.0); }
====
#version 140
out vec4 o; in vec2 uv;
float a(float x) { if (x > 1.0) return 1.0; else if (x < -1.0) return -1.0; return x; }
float b(float x) { for (int i = 0; i < 8; ++i) { x = x * x - 1.0; if (x > 0.5) return x; } return -x; }
void main() { float x = a(uv.x); if (x == 1.0) { o = vec4(1.0); return; } float y = b(uv.y); if (y < 0.0) return; o = vec4(x, y, 0.0, 1.0); }
====
#version 140
in vec3 n; in vec3 p; out vec4 o;
void main() { vec3 nn = gl_FrontFacing ? n : -n; vec3 f = normalize(cross(dFdx(p), dFdy(p))); o = vec4(mix(nn, f, 0.5), fwidth(p.x)); gl_FragDepth = gl_FragCoord.z * 0.5; }
====
#version 140
in vec2 uv; out vec4 o; uniform sampler2D s;
void main() { o = textureOffset(s, uv, ivec2(1, -1)) + textureLodOffset(s, uv, 0.0, ivec2(0, 1)) + textureProj(s, vec3(uv, 2.0)) + textureGrad(s, uv, dFdx(uv), dFdy(uv)); }
====
#version 140
in vec2 uv; out vec4 o;
void main() { float m[3] = float[3](uv.x, uv.y, 1.0); for (int i = 0; i < 3; i++) for (int j = i + 1; j < 3; j++) if (m[j] < m[i]) { float t = m[i]; m[i] = m[j]; m[j] = t; } o = vec4(m[0], m[1], m[2], m.length()); }
====
#version 140
in vec2 uv; out vec4 o;
#define REPITE(n) for (int i = 0; i < n; ++i)
#define VARIAS(a, b) \
    a += 0.1; \
    b *= a
void main() { float x = uv.x, y = uv.y; REPITE(3) { VARIAS(x, y); } REPITE(2) x -= y; o = vec4(x, y, 0.0, 1.0); }
====
#version 140
precision highp float;
in vec2 uv; out vec4 o; invariant o;
lowp vec3 f(mediump float x) { highp vec3 r = vec3(x); r.yz *= vec2(2.0, 3.0); return r; }
void main() { o = vec4(f(uv.x), 1.0); }
====
#version 140
in vec2 uv; out vec4 o; uniform bool a, b; uniform bvec2 c; uniform ivec3 k;
void main() { bool r = a && !b || c.x ^^ c.y; if ((a || (r = false)) && uv.x > 0.0) o = vec4(1.0); else o = vec4(vec3(k) / 4.0, r); }
====
#version 140
smooth in vec2 uv; centroid in vec3 color; noperspective in float w; out vec4 o;
void main() { float g = pow(abs(w), 2.2); o = vec4(color * g, 1.0) ; o.xyz = o.zyx ; o += vec4(uv, 0, 0) ; }
====
#version 140
in vec2 uv; out vec4 o;
void nada() {} int cuenta = 0; bool cuentaUno() { cuenta++; return true; }
void main() { nada(); bool x = false && cuentaUno(); x = true || cuentaUno(); x = x && cuentaUno(); int k = x ? cuenta : (cuenta = 9); if (cuentaUno()); o = vec4(cuenta, k, uv); }
====
#version 140
in vec2 uv; out vec4 o; uniform int modo;
float elige(int m) { switch (m) { case 0: { float x = uv.x; return x; } case 1: case 2: return uv.y; default: break; } return -1.0; }
void main() { int k = 0; for (int i = 0; i < 4; ++i) { switch (i) { case 1: continue; case 2: k += 10; default: k++; } k += 100; } o = vec4(elige(modo), elige(2), float(k), 1.0); }
====
#version 140
in vec2 uv; out vec4 o;
void main() { { { { ; } } } ; ; if (uv.x > 9.0) ; else ; for (;false;) ; while (false) ; vec4 gl; gl = vec4(uv, 1., 1.); ((o)) = (((gl))); ((o).rgb).g = 3.; }
====
#version 140
in vec2 uv; out vec4 o;
float potencia(float b, int n) { float r = 1.0; for (; n > 0; n >>= 1, b *= b) if ((n & 1) != 0) r *= b; return r; }
void main() { float x = potencia(uv.x, 5), y = potencia(potencia(uv.y, 2), 3); x = y > x ? (x += 1.0, x) : (y -= 1.0, -y); o = vec4(x, y, uv); }
====
#version 140
in vec2 uv; out vec4 o; uniform sampler2D img;
const int LADO = 1;
void main() { vec4 s = vec4(0.0); if (uv.x > LADO * 0.5) s = textureOffset(img, uv, ivec2(LADO > 0 && LADO < 3 ? 1 : -1, 0)); o = s + textureLodOffset(img, uv, 0.0, ivec2(LADO == 1 ? 2 : 0)); }
