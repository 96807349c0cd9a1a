// glissade-import-step: reads one STEP file from standard input and writes its parts to standard output.
// Runs with limited memory and time and cannot open a file, so that a malformed file can do no harm.
// usage: glissade-import-step DEFLECTION [unnamed] < FILE
// DEFLECTION in millimetres; 0: by the size of each part. unnamed: without the names of solids, on which OpenCASCADE
// crashes in some files.
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <iostream>
#include <string_view>

#include "engine/import/confined_step_import.h"

int main(int argc, char** argv) {
  double deflection = -1.0;
  const bool unnamed = argc == 3 && std::string_view(argv[2]) == "unnamed";
  if (argc == 2 || unnamed) std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), deflection);
  if (!(deflection >= 0.0)) {
    std::cerr << "usage: glissade-import-step DEFLECTION [unnamed] < FILE\n";
    return 2;
  }
  // Not by return: taking the model apart again would take a tenth of the time.
  ::_exit(glissade::confinedStepImport(deflection, !unnamed));
}
