#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"
#include "engine/model/missing_shape.h"
#include "engine/model/occurrence.h"

namespace glissade {

/// A file that another file names for a part of its product.
struct StepPartFile {
  std::string name;    ///< below the folder of the product's file; as stated if the file does not exist
  std::string sha256;  ///< hash of the bytes that were read; empty: the file does not exist
};

/// The content of a STEP file, and of the files that it names for its parts.
struct StepProduct {
  std::vector<Occurrence> parts;  ///< solids, or the surfaces of a product without solids; at least one
  /// Entities that OpenCASCADE has not made; files that do not exist, with their parts.
  Warnings warnings;
  std::vector<StepPartFile> partFiles;  ///< each once, in the order in which they are named
  MissingShapes missing;                ///< missing shapes of all files; each has a warning
};

/// Imports a STEP file (AP203, AP214, AP242), an IGES file (5.3 and before) or a BREP file with OpenCASCADE, in a
/// separate process that can open no file and has limited memory and time. The ending gives the kind. The file's unit
/// is applied; BREP files state none and are in millimetres. `deflection`: largest deflection of triangles from curved
/// surfaces, metres; 0: usualDeflection() of each part.
///
/// Parts in other files are read from the folder of the file and the folders below it, each file once and in a separate
/// process (see step_composition.h for the rules).
///
/// Takes seconds for thousands of faces. Errors are MalformedInput with the file's name, or Interrupted after a stop.
Result<StepProduct> importStep(const FileContent& content, double deflection, const StopToken& stop = {});
Result<StepProduct> importStep(const std::string& file, double deflection, const StopToken& stop = {});

/// The exact common volume of each pair of parts, by paths of a CAD file, cubic metres: OpenCASCADE's Boolean operation
/// on the solids of the file, in the confined process. Nothing for a pair without a volume, because a part has no
/// solid, is in another file, or cannot be intersected. Takes seconds. Errors: see importStep().
Result<std::vector<std::optional<double>>> commonVolumes(const std::string& file,
                                                         const std::vector<std::pair<std::string, std::string>>& parts,
                                                         const StopToken& stop = {});

/// True if importStep() reads files with this ending: STEP, IGES, BREP.
bool isCadFile(const std::string& file);

}  // namespace glissade
