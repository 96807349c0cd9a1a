#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <gp_Trsf.hxx>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "engine/import/step_face_entities.h"
#include "engine/import/step_mirrors.h"
#include "engine/import/step_note.h"
#include "engine/import/step_stand_in_shapes.h"
#include "engine/import/step_validation.h"
#include "engine/model/node_names.h"

namespace glissade {

/// A solid of a STEP file, or the surfaces of a product without solids, at its place in the assembly.
struct StepSolid {
  /// Names on the path below the root, each unique among its siblings: "pump/rotor", "pin#2". UTF-8. Empty: the root.
  std::string path;
  std::vector<NodeNames> names;                 ///< names of the path's steps, as the file states them
  TopoDS_Shape shape;                           ///< at its origin; instances of one solid share it
  StepPlacement placement;                      ///< millimetres
  std::optional<std::array<double, 3>> colour;  ///< sRGB
  std::uint32_t losses = 0;                     ///< number of faces and boundaries of the file that `shape` lacks
  bool isOneOfSeveral = false;  ///< the product has several solids; the last step of the path is this solid
  std::string formerPath{};     ///< see Occurrence::formerPath
};

/// A product that the file places and that is in another file.
struct StepExternalPart {
  std::string path;              ///< see StepSolid::path
  std::vector<NodeNames> names;  ///< see StepSolid::names
  gp_Trsf placement;
  std::string file;  ///< name in the STEP file; UTF-8
};

struct StepAssembly {
  std::string rootName;  ///< name of the only product of the file if that is no assembly; else empty
  double unit = 0.001;   ///< metres: unit in which the file states most lengths
  bool isSewn = false;   ///< faces were sewn: their common vertices may differ by rounding
  std::vector<StepSolid> solids;
  std::vector<StepExternalPart> externalParts;
  StepNotes notes;
  StepNotes losses;
  FaceEntities faceEntities;
  std::vector<StatedMeasures> measures;  ///< measures that the file states for its products
  StandInShapes standIns;                ///< solids that stand in for triangles of the file
};

/// A STEP text with its content as counted before OpenCASCADE reads it.
struct StepText {
  const StepEntities& entities;
  const StatedShapes& stated;
  StepStandIns standIns;
};

/// Reads a STEP file. Without `solidNames`, the solids of a product with several solids are only numbered. Throws
/// ImportRefusal with the reason if there is no result, or if a loss cannot be assigned to a part, and
/// OpenCASCADE's Standard_Failure. Runs in the importing process only. The content is UTF-8.
///
/// `text`: the text of the file; `content` is the text with stand-ins if there are any.
StepAssembly readStepAssembly(std::istream& content, bool solidNames, StepText text);

}  // namespace glissade
