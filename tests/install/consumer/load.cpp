/// Loads a shared module that holds Supple and calls its function:  load MODULE SHELLS SEED
#include "plain.hpp"
//
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

#include "supple/core/version.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  void* module = dlopen(argv[1], RTLD_NOW);
  if (!module) return std::fprintf(stderr, "%s\n", dlerror()), 1;
  const auto jammed = reinterpret_cast<double (*)(int, int)>(dlsym(module, "jammed_fraction"));
  if (!jammed) return 1;
  std::printf("%s %.17g\n", supple::version(), jammed(std::atoi(argv[2]), std::atoi(argv[3])));
  return dlclose(module);
}
