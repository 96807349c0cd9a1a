#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A picture that stands in the scene: rows from the top, 4 bytes a pixel, colours multiplied by the opacity.
struct FlatPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};
using FlatPicturePtr = std::shared_ptr<const FlatPicture>;

/// A text at a point of the scene. A null picture shows nothing.
struct FlatLabel {
  Vector3 p_W = Vector3::Zero();
  FlatPicturePtr picture;
};
using FlatLabelsPtr = std::shared_ptr<const std::vector<FlatLabel>>;

}  // namespace glissade
