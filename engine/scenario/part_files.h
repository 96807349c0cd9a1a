#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/scenario/scenario.h"

namespace glissade {

enum class PartRole { Moves, Static, Mobile };

/// A file that holds a part of a product, and how it is taken. Parts lie where their files have them:
/// CAD exports them in the coordinates of the assembly.
struct PartFile {
  std::string path;
  PartRole role = PartRole::Static;
  double unit = 0.001;             ///< metres per unit of the file; 1 where saysItsUnit()
  UpAxis up = UpAxis::Z;           ///< Z where saysItsUnit()
  std::string part{};              ///< of a STEP file, or an assembly in it, as "pump/rotor"; empty: all of the file
  double deflection = 0.0;         ///< as of Asset
  bool closeHoles = false;         ///< as of Asset
  bool groups = false;             ///< of an OBJ file: its groups are parts, and `part` is the name of one
  std::vector<NodeNames> names{};  ///< of the steps of `part`, as of Occurrence; filled in where the file is read
  bool asOne = false;              ///< as of StepGeometry
};

/// A static part, taken as files of its kind usually are: Collada and glTF in metres and y up, URDF and STEP
/// as they say, others in millimetres and z up. `text` names a file, or a part of a STEP file:
/// "product.step:pin", or a group of an OBJ file: "product.obj:pin".
PartFile usualPart(const std::string& text);

bool isUrdfFile(const std::string& path);

/// URDF and STEP: the file says what its numbers mean, whatever a person says, and is z up.
bool saysItsUnit(const std::string& path);

/// Whether groups of the file may be taken as parts: of an OBJ file.
bool mayHaveGroups(const std::string& path);

/// Whether nothing says what a unit of the file is: STL, OBJ, PLY. Its size may tell (unit_guess.h).
bool saysNoUnit(const std::string& path);

/// Whether the ending is one that parts have: of a mesh, a STEP or a URDF file.
bool isPartFile(const std::string& path);

/// What a part is made of. What is in `read` is not read again, and what is read comes into it. Errors: it
/// cannot be read, or was stopped. What was lost in reading the file is added to `warnings`, where there is one.
Result<LoadedGeometryPtr> readPart(const PartFile& part, GeometryCache& read, const StopToken& stop = {},
                                   Warnings* warnings = nullptr);

/// Reads small mesh files among these many at a time, for readPart() and the functions below. Errors are left to them.
void readSmallFiles(const std::vector<std::string>& paths, GeometryCache& read, const StopToken& stop = {});

/// One of the parts of a file, with its bounding box in the units and axes of the file (metres where
/// saysItsUnit()).
struct MeasuredPart {
  std::string part;  ///< as of PartFile; empty where the file holds one
  Box3 inFile;
};
/// The parts of a CAD file; or the one that another file is. `apart`: each solid of a part of several, and each group
/// of an OBJ file, is a part. `read` and errors as of readPart().
Result<std::vector<MeasuredPart>> partsInFile(const std::string& path, GeometryCache& read, const StopToken& stop = {},
                                              bool apart = false);

/// Where the reference point of an object of this radius may be so that it can get clear of the box, and
/// move there.
Box3 roomAbout(const Box3& box, double radius);

/// Where a part lies: metres, z up. `inFile` is of partsInFile().
Box3 boxOfPart(const PartFile& part, const Box3& inFile);

/// A scenario of these parts, one or several of which move, as one: they are to come "out", from where they lie. A STEP
/// file that moves does so as one; of others each part is a body of its own, unless another entry names it. The
/// reference point is in the middle of what moves (the origin of a URDF file); the workspace leaves room for "out" on
/// every side; fits are on. It is named as the file where there is one only. Reads all files, which takes its time;
/// what is in `read` (may be null) is not read again, and what is read comes into it.
///
/// Errors are Usage where no part moves, and those of the importers.
Result<Scenario> scenarioOfParts(const std::vector<PartFile>& files, GeometryCache* read = nullptr,
                                 const StopToken& stop = {});

/// The scenario with more bodies: of a STEP file the parts that it does not have yet. Files that are assets already,
/// taken the same way, are not listed again; where the goal is "out", the workspace grows so that it stays within
/// reach. `scenarioFile` is where the scenario is saved, empty: nowhere yet.
///
/// `read` as above. Errors are Usage where there is no part or one moves, and those of the importers.
Result<Scenario> withParts(Scenario scenario, const std::string& scenarioFile, const std::vector<PartFile>& files,
                           GeometryCache* read = nullptr, const StopToken& stop = {});

}  // namespace glissade
