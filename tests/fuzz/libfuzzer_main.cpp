// Runs libFuzzer on the target that GLISSADE_FUZZ_TARGET names. Started by packaging/fuzz.sh.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const glissade::fuzz::Target* const target = [] {
    const char* name = std::getenv("GLISSADE_FUZZ_TARGET");
    const glissade::fuzz::Target* found = name == nullptr ? nullptr : glissade::fuzz::findTarget(name);
    if (found == nullptr) {
      std::fprintf(stderr, "Set GLISSADE_FUZZ_TARGET to the name of a target.\n");
      std::exit(2);
    }
    return found;
  }();
  target->run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
