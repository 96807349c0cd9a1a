#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/assembly/missing_shape.h"
#include "engine/assembly/occurrence.h"
#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"

namespace glissade {

/// A file that another one names for a part of its product.
struct StepPartFile {
  std::string name;    ///< below the folder of the product's file, '/' separated; as it is named where it is not there
  std::string sha256;  ///< of the bytes that were read; empty: it is not there
};

/// The content of a STEP file, and of those that it names for its parts.
struct StepProduct {
  std::vector<Occurrence> parts;  ///< solids, or the surfaces of a product that are none; at least one
  /// What the files say and OpenCASCADE has not made, with the entity; files that are not there, with their parts.
  Warnings warnings;
  std::vector<StepPartFile> partFiles;  ///< each once, in the order in which they are named
  MissingShapes missing;                ///< of all files; there is a warning of each
};

/// Imports a STEP file (AP203, AP214, AP242), an IGES file (5.3 and before) or a BREP file with OpenCASCADE, in a
/// process of its own that can open no file and has limited memory and time. The ending tells the kind. The file's unit
/// is honoured; BREP files state none and are millimetres. `deflection`: metres that the triangles may be off curved
/// surfaces; 0: usualDeflection() of each part.
///
/// Parts that are in files of their own are read from the folder of the file and those below it, each file once and in
/// a process of its own (step_composition.h has the rules).
///
/// Takes its time: seconds for thousands of faces. Errors are MalformedInput with the file's name, or
/// Interrupted where it was stopped.
Result<StepProduct> importStep(const FileContent& content, double deflection, const StopToken& stop = {});
Result<StepProduct> importStep(const std::string& file, double deflection, const StopToken& stop = {});

/// The exact volume that two parts of a CAD file have in common, of each pair of paths, cubic metres: OpenCASCADE's
/// Boolean operation on the solids of the file, in the confined process. Nothing for a pair that has no volume there,
/// because a part has no solid, is in another file, or cannot be intersected. Takes seconds. Errors: as of
/// importStep().
Result<std::vector<std::optional<double>>> commonVolumes(const std::string& file,
                                                         const std::vector<std::pair<std::string, std::string>>& parts,
                                                         const StopToken& stop = {});

/// Whether the ending is one of the files that importStep() reads: STEP, IGES, BREP.
bool isCadFile(const std::string& file);

}  // namespace glissade
