#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/environment/body_class.h"
#include "engine/product/joint.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/demanded_steps.h"

namespace glissade {

/// Of steel, kg/m^3.
inline constexpr double kUsualDensity = 7850.0;

/// Which joints a plan keeps to. What a person has dissolved never counts.
enum class JointUse {
  Off,         ///< none: threads that nobody marked may be pulled apart
  Recognised,  ///< those that the shapes say, or a person
  Suggested    ///< those that shape, name or class hint at as well
};

/// "off", "recognised", "suggested".
const char* jointUseName(JointUse use);
std::optional<JointUse> jointUseByName(const std::string& name);

/// What a person demands of an assembly plan, and knows of its bodies; bodies by id, or by the end of ids behind a "/".
struct SequenceDemands {
  std::vector<std::vector<std::string>> together;                ///< these leave as one
  std::vector<std::pair<std::string, std::string>> before;       ///< the first leaves before the second
  Vector3 gravity = -Vector3::UnitZ();                           ///< its direction, world frame; any length
  std::vector<std::pair<std::string, double>> densities;         ///< kg/m^3; of others kUsualDensity
  std::vector<std::string> stay{};                               ///< these do not leave
  std::vector<std::pair<std::string, double>> masses{};          ///< kg; of others by volume and density
  std::vector<std::string> fragile{};                            ///< these leave as early as they can
  std::vector<std::pair<std::string, std::string>> tools{};      ///< as of toolName(), or "none"
  std::vector<std::pair<std::string, std::string>> fasteners{};  ///< kinds that bodies are, whatever their shapes
  std::string cost{};  ///< what a step costs: an expression or a preset, see step_cost.h; empty: the usual one
  std::map<std::string, Attributes> attributes{};  ///< by id: what costs may name as body.<attribute>
  std::vector<BodyClass> classes{};                ///< beside the usual ones
  std::vector<DemandedPlace> places{};             ///< steps at places
  std::vector<DemandedMotion> motions{};           ///< of these bodies the only ones
  std::vector<ForbiddenDirection> forbidden{};
  JointUse jointUse = JointUse::Recognised;
  std::vector<JointEdit> joints{};  ///< what a person says of joints

  bool operator==(const SequenceDemands&) const = default;
};

/// One body leaves before another one.
struct OrderRule {
  std::size_t first = 0;
  std::size_t then = 0;
  bool demanded = true;  ///< by a person; else it is given up where nothing else can leave
};

/// Demands and knowledge about a product's bodies, by index.
struct OrderRules {
  std::vector<BodyGroup> together;  ///< no body is in two
  std::vector<OrderRule> before;
  /// Ascending by place, no place twice; groups of several bodies are in `together`, too.
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
  std::vector<std::vector<Vector3>> forbidden{};  ///< of each body, unit; empty: none is

  /// Null where these bodies leave by any motion.
  const GivenMotion* motionOf(const BodyGroup& group) const;
  /// Of all bodies of the group.
  std::vector<Vector3> forbiddenTo(const BodyGroup& group) const;
  /// Where a person wants the step of these bodies; 0: anywhere.
  std::size_t placeOf(const BodyGroup& group) const;
};

/// The bodies of these ids, or whose ids end in "/" and this; empty where there is none.
BodyGroup bodiesNamed(const AssembledProduct& product, const std::string& name);

/// The bodies of these names, which do not leave; the largest where none is named. Error, Usage with `location` "stay":
/// a name that no body has.
Result<BodySet> stayingBodies(const AssembledProduct& product, const std::vector<std::string>& names);

/// The demands by index. A name that several bodies have stands for all of them. Errors, Usage with `location`: a name
/// that no body has; a body in two groups; demands in a circle; two steps at one place, two motions of the same bodies,
/// a forbidden direction without length.
Result<OrderRules> resolved(const SequenceDemands& demands, const AssembledProduct& product);

}  // namespace glissade
