#pragma once

#include <benchmark/benchmark.h>
#include <glissade/version.h>

#include "tests/benchmarks/machine.h"

namespace glissade {

/// Adds the origin of the numbers for the page of results. Call it before the benchmarks are run.
inline void addMachineContext() {
  benchmark::AddCustomContext("glissade", kVersion);
  benchmark::AddCustomContext("machine", describeMachine());
  benchmark::AddCustomContext("libraries", describeLibraries());
}

}  // namespace glissade

/// Like BENCHMARK_MAIN, with the machine in the context.
#define GLISSADE_BENCHMARK_MAIN()        \
  int main(int argc, char** argv) {      \
    benchmark::Initialize(&argc, argv);  \
    glissade::addMachineContext();       \
    benchmark::RunSpecifiedBenchmarks(); \
    return 0;                            \
  }
