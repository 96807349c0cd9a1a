#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/work_watch.h"
#include "engine/check/motion_setup.h"
#include "engine/check/product.h"

namespace glissade::check {

/// The edge at which a path meets a forbidden place.
struct ForbiddenEdge {
  std::size_t edge = 0;
  std::string place;
};

struct PathVerdict {
  std::size_t configurations = 0;
  JudgedMotion motion;  ///< names bodies by their number in the product; empty if the motion was not judged
  bool beginsAtStart = false;
  bool endsAtGoal = false;
  std::optional<std::size_t> outside{};      ///< the first configuration outside the workspace
  std::optional<ForbiddenEdge> forbidden{};  ///< the first edge that does not keep the margin from a forbidden place
  double forbiddenMargin = 0.0;              ///< metres; 0: no place is forbidden
  std::vector<AppliedAllowance> allowances{};
  std::vector<Message> refusals{};  ///< refused allowances and threads, for people
  std::vector<Message> pulls{};     ///< threads that the path pulls the object off without a turn, for people
  double deviation = 0.0;           ///< metres by which surfaces may be nearer than their triangles
  double spacing = 0.0;             ///< deviation of the coordinates of two bodies from their files together, metres

  bool valid() const {
    return motion.verdict.status == Status::Certified && beginsAtStart && endsAtGoal && !outside && !forbidden &&
           refusals.empty();
  }
  /// True if the path is shown to be wrong. A path that is neither valid nor refused is undecided.
  bool refused() const {
    const bool undecided = motion.verdict.status == Status::Undecided && !outside;
    return !valid() && (!undecided || !refusals.empty() || forbidden || !beginsAtStart);
  }
};

PathVerdict judgePath(const Question& question, const Path& path, const WorkWatch& watch = {});

/// The first edge with a point in a box, on its boundary, or within the margin along each axis.
std::optional<ForbiddenEdge> firstForbidden(const std::vector<Pose>& path, const std::vector<ForbiddenRegion>& regions,
                                            double margin);

/// Largest deviation of the body's triangles from its surface, metres.
double deflectionOf(const Body& body);

}  // namespace glissade::check
