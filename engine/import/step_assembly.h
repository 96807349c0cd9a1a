#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <cstdint>
#include <gp_Trsf.hxx>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "engine/assembly/node_names.h"
#include "engine/import/step_face_entities.h"
#include "engine/import/step_mirrors.h"
#include "engine/import/step_stand_in_shapes.h"
#include "engine/import/step_validation.h"

namespace glissade {

/// A solid of a STEP file, or the surfaces of a product that are none, where the assembly has it.
struct StepSolid {
  /// Names on the way to it below the root, each once among its sisters: "pump/rotor", "pin#2". UTF-8. Empty: the root.
  std::string path;
  std::vector<NodeNames> names;                 ///< of its steps, as the file has them
  TopoDS_Shape shape;                           ///< at its own origin; instances of one solid share it
  StepPlacement placement;                      ///< millimetres
  std::optional<std::array<double, 3>> colour;  ///< sRGB
  std::uint32_t losses = 0;                     ///< faces and boundaries that the file has and `shape` has not
  bool isOneOfSeveral = false;                  ///< of the solids of one product; the last step is that of the solid
  std::string formerPath{};                     ///< as of Occurrence
};

/// A product that the file places and another file has.
struct StepExternalPart {
  std::string path;              ///< as of StepSolid
  std::vector<NodeNames> names;  ///< as of StepSolid
  gp_Trsf placement;
  std::string file;  ///< as the STEP file names it; UTF-8
};

struct StepAssembly {
  std::string rootName;  ///< of the one product of the file, where it is no assembly; else empty
  double unit = 0.001;   ///< metres: that in which the file states most lengths
  bool isSewn = false;   ///< faces were joined: their common vertices may differ by rounding
  std::vector<StepSolid> solids;
  std::vector<StepExternalPart> externalParts;
  std::vector<std::string> notes;   ///< lines as import_protocol has them
  std::vector<std::string> losses;  ///< "entity, tab, what is missing", as "#45<tab>its face #12 could not be made"
  FaceEntities faceEntities;
  std::vector<StatedMeasures> measures;  ///< that the file states of its products
  StandInShapes standIns;                ///< solids that stand for triangles of the file
};

/// A STEP text and its content as counted before OpenCASCADE reads it.
struct StepText {
  const StepEntities& entities;
  const StatedShapes& stated;
  StepStandIns standIns;
};

/// Reads a STEP file. Without `solidNames` the solids of a product that has several are numbered only. Throws
/// std::runtime_error with the reason where there is nothing to be had, or where something is lost and nobody knows of
/// which part, and OpenCASCADE's Standard_Failure. Runs in
/// the importing process only. The content is UTF-8.
///
/// `text`: of the file; `content` is that of its stand-ins where they have one.
StepAssembly readStepAssembly(std::istream& content, bool solidNames, StepText text);

}  // namespace glissade
