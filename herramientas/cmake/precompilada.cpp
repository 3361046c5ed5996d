// Solo da nombre al objetivo cuya cabecera precompilada comparten los programas (CMakeLists.txt): las bibliotecas de
// todos, que de otro modo se analizan cada vez. Cada fuente incluye igualmente lo que usa: el preset asan compila sin
// ella.
