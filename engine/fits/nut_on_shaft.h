#pragma once

#include "engine/base/message.h"
#include "engine/fits/named_joints.h"
#include "engine/fits/product_shapes.h"

namespace glissade {

/// Evidence for a thread between a shaft and a prism with a hole that is on it.
struct NutOnShaft {
  bool isThread = false;    ///< false: it is no nut, or one that only passes the shaft
  Message evidence{};       ///< evidence for the thread
  Message doubt{};          ///< evidence against it; empty: none
  bool isDeepened = false;  ///< the hole is narrower by a thread: the joint counts despite doubts
};

/// True for a prism with a hole that is called a nut, or has the width, the height and the hole of one
/// (evidence/nut_size.h).
bool isNut(const ProductShapes& shapes, const Designations& said, std::size_t body);

/// A body that may be a nut, and a shaft in its hole.
struct NutAndShaft {
  std::size_t nut = 0;
  std::size_t shaft = 0;
  double radius = 0.0;   ///< radius of the shaft, metres
  bool isScrew = false;  ///< the shaft has a drive, or its name says that it is a screw
};

NutOnShaft nutOnShaft(const ProductShapes& shapes, const Designations& said, const NutAndShaft& pair);

}  // namespace glissade
