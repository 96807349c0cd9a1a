#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/planning/path.h"
#include "engine/product/object_fits.h"
#include "engine/sequence/assembled_product.h"

namespace glissade {

/// A certified motion that takes a body out of the product.
struct Removed {
  Path path;              ///< the certificate names bodies by their index in the product
  std::string method;     ///< as of AssemblyStep
  std::vector<Fit> fits;  ///< with bodies that were there; `obstacle` is the index in the product
};

/// No motion was found.
struct Refused {
  /// Indices of bodies that were in the way, ascending: asked again with the same effort while all of them are there,
  /// the answer is the same, or as likely to be (of searches).
  std::vector<std::size_t> blockedBy;
  bool stopped = false;  ///< the answer is not final
};

using RemovalAnswer = std::variant<Removed, Refused>;

/// Answers whether a body can leave.
class RemovalTrial {
 public:
  virtual ~RemovalTrial() = default;

  /// How many levels of effort there are, at least 1.
  virtual int efforts() const = 0;
  /// The body leaves while those of `present` are there, which has the body itself. The answer depends on body, set,
  /// effort and what was learned, never on other calls. May be called from several threads at a time, for different
  /// bodies.
  virtual RemovalAnswer tryRemoval(std::size_t body, const BodySet& present, int effort, const StopToken& stop) = 0;
  /// A body has left so. Not while others ask.
  virtual void learn(std::size_t body, const std::vector<PathPoint>& path) = 0;
};

}  // namespace glissade
