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

/// Where an assembly has a shape: the shape is mirrored in x where that is so, taken `scale` times as large, and
/// placed.
struct StepPlacement {
  gp_Trsf rigid;
  double scale = 1.0;
  bool mirrored = false;
};

/// Instances that a CARTESIAN_TRANSFORMATION_OPERATOR_3D mirrors or scales, or whose mapping has an origin of its own.
/// OpenCASCADE 7.6 leaves out all three: the instance would be another body than the file's. So each such operator is
/// made a plain translation before the transfer; the location that comes of it tells the instance, and stands for the
/// true transformation.
///
/// Errors: std::runtime_error with the entity, where an operator is used otherwise than by a mapped item, or its
/// instance is not found. Runs in the importing process only.
class MirroredInstances {
 public:
  /// p -> linear * p + shift.
  struct Similarity {
    gp_Mat linear;
    gp_XYZ shift;
  };

  /// No instance is mirrored.
  MirroredInstances() = default;
  /// To be made before the transfer: changes the operators.
  explicit MirroredInstances(const STEPCAFControl_Reader& reader);

  /// To be called once, after the transfer.
  void locate(const STEPCAFControl_Reader& reader);

  /// Millimetres. Error: `path` is the part's, where its place is no turn, mirror and scale.
  StepPlacement placementOf(const TopLoc_Location& location, const std::string& path);

  /// Every instance has been asked for.
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
