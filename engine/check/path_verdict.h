#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/check/motion_setup.h"

namespace glissade::check {

/// Where a path meets what a person forbids.
struct ForbiddenEdge {
  std::size_t edge = 0;
  std::string place;
};

/// What is said of a path: it is valid only where nothing is wrong.
struct PathVerdict {
  std::size_t configurations = 0;
  JudgedMotion motion;  ///< names bodies by their number in the product; empty where it was not judged
  bool beginsAtStart = false;
  bool endsAtGoal = false;
  std::optional<std::size_t> outside{};      ///< the first configuration outside the workspace
  std::optional<ForbiddenEdge> forbidden{};  ///< the first edge that does not keep the margin from a forbidden place
  double forbiddenMargin = 0.0;              ///< metres; 0: no place is forbidden
  std::vector<AppliedAllowance> allowances{};
  std::vector<std::string> refusals{};  ///< of allowances and threads, for people
  double deviation = 0.0;               ///< metres that surfaces may be nearer than their triangles
  double spacing = 0.0;                 ///< metres that coordinates may be off their files, of two bodies together

  bool valid() const {
    return motion.verdict.status == Status::Certified && beginsAtStart && endsAtGoal && !outside && !forbidden &&
           refusals.empty();
  }
  /// Shown to be wrong; neither valid nor refused: undecided.
  bool refused() const {
    const bool undecided = motion.verdict.status == Status::Undecided && !outside;
    return !valid() && (!undecided || !refusals.empty() || forbidden || !beginsAtStart);
  }
};

PathVerdict judgePath(const Question& question, const Path& path, const WorkWatch& watch = {});

/// The first edge with a point in a box, on its boundary, or nearer to it than the margin along each axis.
std::optional<ForbiddenEdge> firstForbidden(const std::vector<Pose>& path, const std::vector<ForbiddenRegion>& regions,
                                            double margin);

/// Metres that the triangles of a body may be off its surface at most.
double deflectionOf(const Body& body);

}  // namespace glissade::check
