// A person's statements about pairs of bodies. Evidence for allowances is judged with them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/message.h"
#include "engine/geometry/pose.h"
#include "engine/model/body_id.h"
#include "engine/model/fit_options.h"

namespace glissade::evidence {

/// A person's statement about a pair of bodies, named by id.
struct PairWord {
  BodyId a;
  BodyId b;
  std::string kind{};                 ///< kind as in the file; empty: not stated
  std::optional<double> allowance{};  ///< metres, >= 0; 0: clearance is required
  bool accepted = false;              ///< the clash of the pair is accepted
  std::optional<double> pitch{};      ///< pitch of a thread, metres; below 0: left-handed
  BodyId turned{};                    ///< id of the body that is turned in a thread; empty: not stated

  bool isThread() const { return kind == "thread"; }
};

/// A person's statement about a snap: its hook bends while the body leaves.
struct SnapWord {
  BodyId hook;                           ///< id of the body with the hook
  BodyId edge;                           ///< id of the body that it is hooked into
  double bend = 0.0;                     ///< metres, > 0
  Vector3 direction = Vector3::UnitZ();  ///< unit, world frame: exit direction of the body with the hook
  bool byPlan = false;                   ///< only a plan states it

  bool operator==(const SnapWord&) const = default;
};

/// A person's statements about threads and inserts that come apart without a turn.
struct PartingWords {
  bool anyPair = false;                            ///< joints are not used
  std::vector<std::pair<BodyId, BodyId>> pairs{};  ///< ids, the lesser first
};

struct FitWords {
  bool on = false;             ///< false: each pair has to keep the clearance
  double acceptedClash = 0.0;  ///< metres: clashes up to this overlap are accepted
  std::vector<PairWord> pairs{};
  std::vector<SnapWord> snaps{};
  PartingWords partings{};
  std::vector<std::string> cut{};  ///< bodies that are cut in accepted clashes: ids, or the ends of ids behind a "/"

  bool isCut(const BodyId& id) const;
  /// The statement about the pair in either order; null: there is none.
  const PairWord* about(const BodyId& a, const BodyId& b) const;
  /// The snap of the pair in either order; null: the pair is no snap.
  const SnapWord* snapOf(const BodyId& a, const BodyId& b) const;
  /// The statement by which the pair may come apart without a turn, for people; empty: none.
  Message partingOf(const BodyId& a, const BodyId& b) const;
  /// True if a person accepts a clash of this depth, metres, to a nanometre. `word`: the statement about the pair, or
  /// null. `advised`: the depth that is advised for the pair; nothing: `depth`.
  bool accepts(const PairWord* word, double depth, std::optional<double> advised = {}) const {
    const double most = acceptedClash == kAdvisedClashes ? advised.value_or(depth) : acceptedClash;
    return (most > 0.0 && depth <= most + 1e-9) || (word != nullptr && word->accepted);
  }
};

}  // namespace glissade::evidence
