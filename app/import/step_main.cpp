// glissade-import-step: reads one STEP, IGES or BREP file from standard input and writes its parts to standard output.
// It runs with limited memory and time and cannot open a file, so a malformed file can do no harm.
// usage: glissade-import-step STEP|IGES|BREP DEFLECTION [unnamed] < FILE
//        glissade-import-step STEP|IGES|BREP volumes PART PART [PART PART]... < FILE
// DEFLECTION is in millimetres; 0: from the size of each part. unnamed: reads no names of solids, because OpenCASCADE
// crashes on them in some files. volumes: writes the common volume of each pair of parts, which are given by their
// paths.
#include <unistd.h>

#include <charconv>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/import/confined_step_import.h"
#include "engine/import/import_protocol.h"

namespace {

/// Nothing if the arguments do not follow the usage.
std::optional<glissade::StepImportOrder> orderOf(const std::vector<std::string>& arguments) {
  using glissade::CadKind;
  if (arguments.size() < 2) return std::nullopt;
  for (const CadKind kind : {CadKind::Step, CadKind::Iges, CadKind::Brep}) {
    if (arguments[0] != nameOf(kind)) continue;
    glissade::StepImportOrder order{kind, 0.0};
    if (arguments[1] == glissade::import_protocol::kVolumesOf) {
      for (std::size_t i = 2; i + 1 < arguments.size(); i += 2) {
        order.volumesOf.emplace_back(arguments[i], arguments[i + 1]);
      }
      if (order.volumesOf.empty() || arguments.size() % 2 != 0) return std::nullopt;
      return order;
    }
    const std::string& number = arguments[1];
    const auto read = std::from_chars(number.data(), number.data() + number.size(), order.deflection);
    order.solidNames = arguments.size() == 2;
    const bool isUsage = order.solidNames || (arguments.size() == 3 && arguments[2] == "unnamed");
    if (read.ec != std::errc() || !(order.deflection >= 0.0) || !isUsage) return std::nullopt;
    return order;
  }
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  const auto order = orderOf(std::vector<std::string>(argv + 1, argv + argc));
  if (!order) {
    std::cerr << "usage: glissade-import-step STEP|IGES|BREP DEFLECTION [unnamed] < FILE\n"
                 "       glissade-import-step STEP|IGES|BREP volumes PART PART [PART PART]... < FILE\n";
    return 2;
  }
  // No return from main(): destroying the model would take a tenth of the time.
  ::_exit(glissade::confinedStepImport(*order));
}
