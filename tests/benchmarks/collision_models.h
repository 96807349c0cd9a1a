#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/kernel_query.h"

namespace glissade {

/// A query of the kernel and FCL (OBBRSS) for the same poses. Both query surfaces only, so that neither includes our
/// test of containment.
struct CollisionQuestion {
  std::string what;   ///< query: collide, distance, edge or edge-first
  std::string model;  ///< model: L, pump, Twistycool or alpha-1.5
  std::string poses;  ///< poses: far, colliding or near
  std::size_t count;
  std::function<void(std::size_t)> fcl;
  std::function<void(std::size_t)> kernel;

  std::string place() const { return what + "/" + model + "/" + poses; }
};

/// For each model `count` random poses in the problem's bounds that are free, as many that collide, and as many between
/// these, free and within a thousandth of the object's size of contact. Edges begin at these poses and go 5 % of the
/// bounds' diagonal in any direction, and 15 degrees. FCL checks 20 poses of an edge, up to the first that collides;
/// the kernel proves it, or finds a violation ("edge"), or the first one ("edge-first"). Missing models are left out
/// with a message on stderr.
std::vector<CollisionQuestion> collisionQuestions(const std::string& sourceFolder, std::size_t count);

/// FCL's CPU time divided by the kernel's. Both run all queries in turn in each round; the median of the rounds counts.
double timeRatio(const CollisionQuestion& question, int rounds);

}  // namespace glissade
