#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <StepRepr_MappedItem.hxx>
#include <TopLoc_Datum3D.hxx>
#include <TopLoc_Location.hxx>
#include <gp_Mat.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace glissade {

/// The placement of a shape in an assembly: the shape is mirrored in x if `mirrored`, scaled by `scale`, and placed.
struct StepPlacement {
  gp_Trsf rigid;
  double scale = 1.0;
  bool mirrored = false;
};

/// Instances that a CARTESIAN_TRANSFORMATION_OPERATOR_3D mirrors or scales, or whose mapping has an origin. OpenCASCADE
/// 7.6 ignores all three, so the instance would differ from the file's. Each such operator is therefore replaced by a
/// plain translation before the transfer; the resulting location identifies the instance and its true transformation.
///
/// Errors: ImportRefusal with the entity, if an operator is used other than by a mapped item, or its instance is
/// not found. Runs in the importing process only.
class MirroredInstances {
 public:
  /// p -> linear * p + shift.
  struct Similarity {
    gp_Mat linear;
    gp_XYZ shift;
  };

  /// Constructs an object without mirrored instances.
  MirroredInstances() = default;
  /// Construct it before the transfer, because it changes the operators.
  explicit MirroredInstances(const STEPCAFControl_Reader& reader);

  /// Call once, after the transfer.
  void locate(const STEPCAFControl_Reader& reader);

  /// The placement, in millimetres. Throws with `path` of the part if it is not composed of turn, mirror and scale.
  StepPlacement placementOf(const TopLoc_Location& location, const std::string& path);

  /// Throws unless placementOf() was called for every instance.
  void demandAllUsed() const;

 private:
  struct Instance {
    Handle(StepRepr_MappedItem) item;
    std::string operatorName;
    Similarity placed;  ///< `shift` in the unit of the file
  };

  std::vector<Instance> instances_;
  std::map<const TopLoc_Datum3D*, Similarity> trueOf_;
  std::set<const TopLoc_Datum3D*> used_;
};

}  // namespace glissade
