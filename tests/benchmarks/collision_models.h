#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/kernel_query.h"

namespace glissade {

/// The kernel and FCL (OBBRSS) asked the same, about the same poses. Surfaces alone in both, so that
/// neither pays for our test of containment.
struct CollisionQuestion {
  std::string what;   ///< collide, distance, edge or edge-first
  std::string model;  ///< L, pump, Twistycool or alpha-1.5
  std::string poses;  ///< far, colliding or near
  std::size_t count;
  std::function<void(std::size_t)> fcl;
  std::function<void(std::size_t)> kernel;

  std::string place() const { return what + "/" + model + "/" + poses; }
};

/// About each model `count` random poses in the problem's bounds that are free, as many that collide, and
/// as many between these, free and within a thousandth of the object's size of contact; edges begin at
/// them and go 5 % of the bounds' diagonal in any direction, and 15 degrees. FCL checks 20 poses of an
/// edge, up to the first that collides; the kernel proves it, or finds a violation ("edge"), or the
/// first one ("edge-first"). Models that are not there are left out, with a word on stderr.
std::vector<CollisionQuestion> collisionQuestions(const std::string& sourceFolder, std::size_t count);

/// FCL's CPU time over the kernel's: both are asked everything in turn, in as many rounds, and the
/// median counts.
double timeRatio(const CollisionQuestion& question, int rounds);

}  // namespace glissade
