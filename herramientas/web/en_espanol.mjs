// Lo que más dicen clang y los compiladores de shaders de los navegadores, en español.

const TIPO = "'([^']+)'(?: \\(aka '[^']+'\\))?";

/// De cada cosa que dicen, cómo la dicen y qué es; la primera que valga.
export const CLANG = [
  [/undeclared identifier '(.+?)'/, '«$1» no está declarado'],
  [/(?:unknown type name|no template named) '(.+?)'/, 'no hay ningún tipo «$1»: ¿falta glm::, std:: o una cabecera?'],
  [/^expected '(.+?)'/, 'falta «$1»'],
  [/^expected unqualified-id|extraneous closing brace/, '¿sobra antes una llave?'],
  [/^expected/, 'aquí falta algo, o sobra lo de antes'],
  [/function definition is not allowed here/, '¿falta cerrar antes una llave?'],
  [/(?:no matching \w+ for \w+ (?:to|of)) '(.+?)'/, 'ninguna «$1» admite esos argumentos'],
  [/too (few|many) arguments/, 'la función no lleva esos argumentos'],
  [/no member named '(.+?)' in (?:namespace )?'(.+?)'/, '«$2» no tiene «$1»'],
  [RegExp(`no viable conversion from (?:returned value of type )?${TIPO} to (?:function return type )?${TIPO}`),
    'un «$1» no vale como «$2»'],
  [RegExp(`cannot initialize .*?${TIPO} with .*?${TIPO}`), 'un «$2» no vale como «$1»'],
  [RegExp(`(?:assigning to|incompatible \\w+ types?) ${TIPO} from .*?${TIPO}`), 'un «$2» no vale como «$1»'],
  [/no viable overloaded '='/, 'eso no se le puede asignar'],
  [RegExp(`invalid operands to binary expression \\(${TIPO} and ${TIPO}\\)`), 'un «$1» y un «$2» no se operan así'],
  [/'(.+?)' with const-qualified/, '«$1» es constante'],
  [/redefinition of '(.+?)'/, '«$1» ya está antes'],
  [/is not a function/, 'eso no es una función: ¿falta un operador antes del paréntesis?'],
  [/'(.+?)' file not found/, 'no está la cabecera «$1»'],
  [/type specifier/, 'falta el tipo'],
  [/does not return a value/, 'falta un return'],
  [/did you mean to use '(.+?)'/, 'es con «$1»'],
  [/missing terminating/, 'falta cerrar las comillas'],
  [/unused \w+ '(.+?)'/, '«$1» no se usa'],
  [/assignment as a condition|comparison result unused/, '¿era la otra, = o ==?'],
];
export const NAVEGADOR = [
  [/'(.+?)' : undeclared identifier/, '«$1» no está declarado'],
  [/syntax error/, 'no se entiende: ¿falta «;», un paréntesis o una llave, aquí o en la línea de antes?'],
  [/'(.+?)' : no matching overloaded function/, 'no hay ninguna función «$1» que admita esos argumentos'],
  [/(?=.*\bfloat\b).*(\d)-component vector of int/, 'uno es de enteros: vec$1(…) lo hace de reales'],
  [/(?=.*\bint\b).*\bfloat\b/, 'un int no vale como float: un real lleva punto, 1.0 y no 1'],
  [/dimension mismatch/, 'no tienen tantos componentes: vec3(0.0) son tres'],
  [/cannot convert|wrong operand/, 'no son del mismo tipo'],
  [/not enough data/, 'faltan componentes'],
  [/'constructor' : too many/, 'sobran componentes'],
  [/l-value required/, 'no se cambia: ni lo que es in, ni un uniform, ni una constante'],
  [/'(.+?)' : .*field/, 'ahí no hay «$1»'],
  [/boolean expression expected/, 'hace falta una condición: verdad o mentira'],
  [/'(.+?)' : invalid number/, '«$1» no es un número'],
  [/'(.+?)' : redefinition/, '«$1» ya está antes'],
  [/'(.+?)' : .*reserved word/, '«$1» es una palabra reservada'],
  [/index out of range/, 'ese índice se sale'],
  [/void function cannot return/, 'es void: no devuelve nada'],
  [/does not return a value/, 'falta un return'],
];

/// Eso, y lo que dijo; solo lo que dijo, si no se sabe qué es.
export function enEspanol(dicen, mensaje) {
  for (const [como, es] of dicen) {
    const m = mensaje.match(como);
    if (m) return `${es.replace(/\$(\d)/g, (_, n) => m[n])} (${mensaje})`;
  }
  return mensaje;
}
