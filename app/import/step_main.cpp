// glissade-import-step: reads one STEP, IGES or BREP file from standard input and writes its parts to standard output.
// Runs with limited memory and time and cannot open a file, so that a malformed file can do no harm.
// usage: glissade-import-step STEP|IGES|BREP DEFLECTION [unnamed] < FILE
// DEFLECTION in millimetres; 0: by the size of each part. unnamed: without the names of solids, on which OpenCASCADE
// crashes in some files.
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <iostream>
#include <string_view>

#include "engine/import/confined_step_import.h"

int main(int argc, char** argv) {
  using glissade::CadKind;
  double deflection = -1.0;
  const bool unnamed = argc == 4 && std::string_view(argv[3]) == "unnamed";
  std::optional<CadKind> kind;
  for (const CadKind each : {CadKind::Step, CadKind::Iges, CadKind::Brep}) {
    if (argc > 1 && std::string_view(argv[1]) == nameOf(each)) kind = each;
  }
  if (argc == 3 || unnamed) std::from_chars(argv[2], argv[2] + std::strlen(argv[2]), deflection);
  if (!kind || !(deflection >= 0.0)) {
    std::cerr << "usage: glissade-import-step STEP|IGES|BREP DEFLECTION [unnamed] < FILE\n";
    return 2;
  }
  // Not by return: taking the model apart again would take a tenth of the time.
  ::_exit(glissade::confinedStepImport(*kind, deflection, !unnamed));
}
