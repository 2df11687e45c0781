/// A function of the name that an inline function of Supple has, as one of the same header has that was
/// compiled with other flags: the library must not call it.
#include <cstdio>
#include <cstdlib>

extern "C" void IMPOSTOR() {
  std::fputs("the library calls a function of the program\n", stderr);
  std::_Exit(1);
}
