#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/result.h"
#include "engine/fits/joint.h"
#include "engine/places/body_class.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {

/// Density of steel, kg/m^3.
inline constexpr double kUsualDensity = 7850.0;

/// The joints that a plan keeps to. A joint that a person has dissolved never counts.
enum class JointUse {
  Off,         ///< none: threads that nobody marked may be pulled apart
  Recognised,  ///< joints that shapes or a person state
  Suggested    ///< joints that shape, name or class suggest as well
};

inline constexpr EnumNames<JointUse, 3> kJointUseNames{{"off", "recognised", "suggested"}};

/// Demands of a person on an assembly plan, and facts about its bodies. Bodies by id, or by the end of ids behind a
/// "/".
struct SequenceDemands {
  std::vector<std::vector<std::string>> together;           ///< bodies that leave as one
  std::vector<std::pair<std::string, std::string>> before;  ///< the first leaves before the second
  std::optional<Vector3> gravity{};  ///< direction of gravity, world frame; any length; nothing: as the base lies well
  std::vector<std::pair<std::string, double>> densities;         ///< kg/m^3; kUsualDensity for other bodies
  std::vector<std::string> stay{};                               ///< bodies that do not leave
  std::vector<std::pair<std::string, double>> masses{};          ///< kg; by volume and density for other bodies
  std::vector<std::string> fragile{};                            ///< bodies that leave as early as they can
  std::vector<std::pair<std::string, std::string>> tools{};      ///< tool of each body, see kToolNames
  std::vector<std::pair<std::string, std::string>> fasteners{};  ///< kind of each body, whatever its shape
  std::string cost{};  ///< cost of a step: an expression or a preset, see step_cost.h; empty: the usual one
  std::map<std::string, Attributes> attributes{};  ///< attributes of bodies by id; costs name them as body.<attribute>
  std::vector<BodyClass> classes{};                ///< classes in addition to the usual ones
  std::vector<DemandedPlace> places{};             ///< steps with a demanded place
  std::vector<DemandedMotion> motions{};           ///< the only motions of these bodies
  std::vector<ForbiddenDirection> forbidden{};
  JointUse jointUse = JointUse::Recognised;
  std::vector<JointEdit> joints{};  ///< statements of a person about joints

  bool operator==(const SequenceDemands&) const = default;
};

/// One body leaves before another one.
struct OrderRule {
  std::size_t first = 0;
  std::size_t then = 0;
  bool demanded = true;  ///< a person demands it; else it is dropped where no other body can leave
};

/// Demands and knowledge about a product's bodies, by index.
struct OrderRules {
  std::vector<BodyGroup> together;  ///< no body is in two
  std::vector<OrderRule> before;
  /// Steps by ascending place, no place twice. A group of several bodies is in `together`, too.
  struct PlacedStep {
    BodyGroup group;
    std::size_t place = 1;  ///< from 1
  };
  std::vector<PlacedStep> placed{};
  struct GivenMotion {
    BodyGroup group;
    std::vector<PathPoint> path;
    std::string method;
  };
  std::vector<GivenMotion> motions{};             ///< no group twice
  std::vector<std::vector<Vector3>> forbidden{};  ///< forbidden directions of each body, unit; empty: none

  /// Null if these bodies may leave by any motion.
  const GivenMotion* motionOf(const BodyGroup& group) const;
  /// The forbidden directions of all bodies of the group.
  std::vector<Vector3> forbiddenTo(const BodyGroup& group) const;
  /// The place that a person wants for the step of these bodies; 0: any place.
  std::size_t placeOf(const BodyGroup& group) const;
};

/// The bodies with this id, or whose ids end in "/" and this name; empty if there is none.
BodyGroup bodiesNamed(const AssembledProduct& product, const std::string& name);

/// The bodies with these names, which do not leave; none if there are no names. Error, Usage with
/// `location` "stay": a name that no body has.
Result<BodySet> stayingBodies(const AssembledProduct& product, const std::vector<std::string>& names);

/// The demands by index. A name that several bodies have stands for all of them. Errors, Usage with `location`: a name
/// that no body has; a body in two groups; demands in a circle; two steps at one place, two motions of the same bodies,
/// a forbidden direction without length.
Result<OrderRules> resolved(const SequenceDemands& demands, const AssembledProduct& product);

}  // namespace glissade
