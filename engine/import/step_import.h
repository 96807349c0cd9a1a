#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"

namespace glissade {

/// A solid of a STEP file where the assembly has it, or the surfaces of a product that are none.
struct StepPart {
  /// Names of the products that it is in and its own, each once among its sisters: "pump/rotor", "pin#2".
  std::string path;
  MeshPtr mesh;                                 ///< at its own origin P, metres; instances of one solid share it
  Pose X_FP;                                    ///< in the file's frame F, metres and z up
  std::optional<std::array<double, 3>> colour;  ///< sRGB
  double deflection = 0.0;                      ///< metres that the mesh may be off the surface, about
  std::size_t facesWithoutMesh = 0;             ///< faces and boundaries that could not be made: they are missing
};

/// The content of a STEP file.
struct StepProduct {
  std::vector<StepPart> parts;  ///< at least one
  Warnings warnings;            ///< what the file says and OpenCASCADE has not made, with the entity
};

/// Imports a STEP file (AP203, AP214, AP242) with OpenCASCADE, in a process of its own that can open no
/// file and has limited memory and time. The file's unit is honoured. `deflection`: metres that the
/// triangles may be off curved surfaces; 0: usualDeflection() of each part.
///
/// Takes its time: seconds for thousands of faces. Errors are MalformedInput with the file's name, or
/// Interrupted where it was stopped.
Result<StepProduct> importStep(const FileContent& content, double deflection, const StopToken& stop = {});
Result<StepProduct> importStep(const std::string& file, double deflection, const StopToken& stop = {});

/// Whether the ending is one of STEP files.
bool isStepFile(const std::string& file);

}  // namespace glissade
