#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <TopoDS_Face.hxx>
#include <string>
#include <unordered_map>

namespace glissade {

/// The entities of a STEP file from which its faces were made. Runs in the importing process only.
class FaceEntities {
 public:
  FaceEntities() = default;
  /// Precondition: the transfer is done.
  explicit FaceEntities(const STEPCAFControl_Reader& reader);

  /// "#45"; "#?" if it is not known.
  std::string nameOf(const TopoDS_Face& face) const;

 private:
  std::unordered_map<const TopoDS_TShape*, int> numbers_;
};

}  // namespace glissade
