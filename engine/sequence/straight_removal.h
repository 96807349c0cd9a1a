#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/collision/prepared_bodies.h"
#include "engine/sequence/product_fits.h"
#include "engine/sequence/removal_trial.h"

namespace glissade {

/// Removal along straight lines. Whether a body blocks a line of another one is a fact about the two, found at most
/// once: the blocking graph of the product for these lines, filled where it is asked. So an answer holds whoever else
/// leaves.
class StraightRemoval {
 public:
  StraightRemoval(const AssembledProduct& product, const ProductFits& fits, PreparedBodies& prepared);

  /// As RemovalTrial::tryRemoval().
  RemovalAnswer tryRemoval(std::size_t body, const BodySet& present, const StopToken& stop);
  /// Bodies of the same geometry try the line of this one first.
  void learn(std::size_t body, const std::vector<PathPoint>& path);

 private:
  /// A line of a body, and who blocks it; nothing where it was not asked.
  struct Line {
    Vector3 direction;
    Pose end;
    Box3 swept;  ///< holds the body on all of the line
    std::vector<std::optional<bool>> blockedBy;
  };
  struct Lines {
    bool known = false;
    std::vector<Line> lines;
    std::vector<std::size_t> order;  ///< others, those that it fits first
  };

  Lines& linesOf(std::size_t body);
  Line lineAlong(std::size_t body, const Vector3& direction) const;
  std::vector<Line*> inOrder(std::size_t body, Lines& lines) const;
  std::optional<std::size_t> blockerOf(std::size_t body, Line& line, const Lines& lines, const BodySet& present,
                                       const StopToken& stop);
  bool blocks(std::size_t other, std::size_t body, const Line& line, const StopToken& stop);
  Path certified(std::size_t body, const Line& line, const BodySet& present, const StopToken& stop);

  const AssembledProduct& product_;
  const ProductFits& fits_;
  PreparedBodies& prepared_;
  std::vector<Lines> lines_;            ///< of each body
  std::map<MeshPtr, Vector3> learned_;  ///< in the body's frame, the last one
};

}  // namespace glissade
