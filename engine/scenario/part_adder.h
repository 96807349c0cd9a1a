#pragma once

#include <string>

#include "engine/scenario/part_files.h"

namespace glissade {

/// Adds files and bodies to a scenario that is saved as `file`, or nowhere yet.
class PartAdder {
 public:
  PartAdder(Scenario& scenario, const std::string& file);

  void addBody(const PartFile& part);
  /// To what moves. The reference point is still to be chosen.
  void addToObject(const PartFile& part);

 private:
  BodyDescription bodyOf(const PartFile& part);
  Geometry geometryOf(const PartFile& part);
  std::string assetOf(const PartFile& part);

  Scenario& scenario_;
  std::string folder_;
  bool saved_;
  bool hasObject_ = false;
};

}  // namespace glissade
