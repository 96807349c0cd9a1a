#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scenario/scenario.h"

namespace glissade {

enum class PartRole { Moves, Static, Mobile };

/// A file that holds a part of a product, and how it is taken. Parts lie where their files have them:
/// CAD exports them in the coordinates of the assembly.
struct PartFile {
  std::string path;
  PartRole role = PartRole::Static;
  double unit = 0.001;    ///< metres per unit of the file; 1 for URDF
  UpAxis up = UpAxis::Z;  ///< Z for URDF
};

/// A static part, taken as files of its kind usually are: Collada and glTF in metres and y up, URDF in
/// metres and z up, others in millimetres and z up.
PartFile usualPart(const std::string& path);

/// Always in metres and z up, whatever a person says.
bool isUrdfFile(const std::string& path);

/// Whether the ending is one that parts have: of a mesh or a URDF file.
bool isPartFile(const std::string& path);

/// Bounding box of what a file holds, in its own units and axes. Errors: it cannot be read.
Result<Box3> boxInFile(const std::string& path);

/// Where the reference point of an object of this radius may be so that it can get clear of the box, and
/// move there.
Box3 roomAbout(const Box3& box, double radius);

/// Where a part lies: metres, z up. `inFile` is boxInFile() of its path.
Box3 boxOfPart(const PartFile& part, const Box3& inFile);

/// A scenario of these parts, one of which moves: it is to come "out", from where it lies. Its reference
/// point is the mean of its vertices (the origin of a URDF file); the workspace leaves room for "out" on
/// every side. Reads all files, which takes its time; what is in `read` (may be null) is not read again, and what is
/// read comes into it.
///
/// Errors are Usage where not exactly one part moves, and those of the importers.
Result<Scenario> scenarioOfParts(const std::vector<PartFile>& parts, GeometryCache* read = nullptr);

/// The scenario with more bodies. Files that are assets already, taken the same way, are not listed
/// again; where the goal is "out", the workspace grows so that it stays within reach. `scenarioFile` is
/// where the scenario is saved, empty: nowhere yet.
///
/// `read` as above. Errors are Usage where there is no part or one moves, and those of the importers.
Result<Scenario> withParts(Scenario scenario, const std::string& scenarioFile, const std::vector<PartFile>& parts,
                           GeometryCache* read = nullptr);

}  // namespace glissade
