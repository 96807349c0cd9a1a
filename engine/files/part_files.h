#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/files/scenario.h"

namespace glissade {

enum class PartRole { Moves, Static, Mobile };

/// A file that holds a part of a product, and its import options. Parts lie where their files place them, because CAD
/// systems export them in the coordinates of the assembly.
struct PartFile {
  std::string path;
  PartRole role = PartRole::Static;
  double unit = 0.001;             ///< metres per unit of the file; 1 where saysItsUnit()
  UpAxis up = UpAxis::Z;           ///< axis that points up; Z where saysItsUnit()
  std::string part{};              ///< part or assembly in a STEP file, such as "pump/rotor"; empty: the whole file
  double deflection = 0.0;         ///< as in Asset
  bool closeHoles = false;         ///< as in Asset
  bool groups = false;             ///< for an OBJ file: its groups are parts, and `part` is the name of a group
  std::vector<NodeNames> names{};  ///< names of the steps of `part`, as in Occurrence; filled in when the file is read
  bool asOne = false;              ///< as in StepGeometry
};

/// A static part with the default options for its file type: Collada and glTF in metres and y up, URDF and STEP as they
/// state, others in millimetres and z up. `text` names a file, a part of a STEP file ("product.step:pin"), or a group
/// of an OBJ file ("product.obj:pin").
PartFile usualPart(const std::string& text);

bool isUrdfFile(const std::string& path);

/// True for URDF and STEP: the file states its unit, which overrides a person's choice, and is z up.
bool saysItsUnit(const std::string& path);

/// True for OBJ files, whose groups may be imported as parts.
bool mayHaveGroups(const std::string& path);

/// True for STL, OBJ and PLY, which do not state their unit. It is guessed from the size (unit_guess.h).
bool saysNoUnit(const std::string& path);

/// True if the ending is that of a mesh, STEP or URDF file.
bool isPartFile(const std::string& path);

/// The geometry of a part. Geometry that `read` contains is not read again, and new geometry is added to it. Errors: it
/// cannot be read, or was stopped. Losses while reading the file are added to `warnings`, if not null.
Result<LoadedGeometryPtr> readPart(const PartFile& part, GeometryCache& read, const StopToken& stop = {},
                                   Warnings* warnings = nullptr);

/// Reads the small mesh files among these in parallel, for readPart() and the functions below. Errors are left to those
/// functions.
void readSmallFiles(const std::vector<std::string>& paths, GeometryCache& read, const StopToken& stop = {});

/// One of the parts of a file, with its bounding box in the units and axes of the file (metres where
/// saysItsUnit()), and its mesh.
struct MeasuredPart {
  std::string part;  ///< as in PartFile; empty where the file holds one part
  Box3 inFile;
  Occurrence solid{};  ///< in the units and axes of the file; that of the first body where the part has several
};
/// The parts of a CAD file, or the solids of its only part; the single part of another file. `apart`: each solid of a
/// part with several solids, and each group of an OBJ file, is a part. `read` and errors are those of readPart().
Result<std::vector<MeasuredPart>> partsInFile(const std::string& path, GeometryCache& read, const StopToken& stop = {},
                                              bool apart = false);

/// Box of the reference point of an object of this radius, with room to get clear of the given box and to move there.
Box3 roomAbout(const Box3& box, double radius);

/// Bounding box of a part in metres, z up. `inFile` is a result of partsInFile().
Box3 boxOfPart(const PartFile& part, const Box3& inFile);

/// A scenario of these parts. One or several parts move as one object, from where they lie to "out". A STEP file that
/// moves does so as one; of other files each part is a body, unless another entry names it. The reference point is the
/// middle of the object (the origin of a URDF file). The workspace leaves room for "out" on every side, and fits are
/// on. The scenario has the name of the file where there is only one. Reads all files, which may take long. Geometry
/// that `read` (may be null) contains is not read again, and new geometry is added to it.
///
/// Errors are Usage where no part moves, and those of the importers.
Result<Scenario> scenarioOfParts(const std::vector<PartFile>& files, GeometryCache* read = nullptr,
                                 const StopToken& stop = {});

/// The scenario with more bodies; of a STEP file, only the parts that it does not have yet. Files that are assets with
/// the same options already are not added again. Where the goal is "out", the workspace grows so that "out" stays
/// within reach. `scenarioFile` is the file of the scenario, empty: not saved yet.
///
/// `read` as above. Errors are Usage where there is no part or one moves, and those of the importers.
Result<Scenario> withParts(Scenario scenario, const std::string& scenarioFile, const std::vector<PartFile>& files,
                           GeometryCache* read = nullptr, const StopToken& stop = {});

}  // namespace glissade
