#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <gp_Trsf.hxx>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace glissade {

/// A solid of a STEP file, or the surfaces of a product that are none, where the assembly has it.
struct StepSolid {
  /// Names on the way to it, each once among its sisters: "pump/rotor", "pin#2". UTF-8.
  std::string path;
  TopoDS_Shape shape;                           ///< at its own origin; instances of one solid share it
  gp_Trsf placement;                            ///< millimetres
  std::optional<std::array<double, 3>> colour;  ///< sRGB
};

struct StepAssembly {
  std::vector<StepSolid> solids;
  std::vector<std::string> losses;  ///< as step_losses.h has them
};

/// Reads a STEP file. Without `solidNames` the solids of a product that has several are numbered only. Throws
/// std::runtime_error with the reason where there is nothing to be had, and OpenCASCADE's Standard_Failure. Runs in
/// the importing process only.
StepAssembly readStepAssembly(std::istream& content, bool solidNames);

}  // namespace glissade
