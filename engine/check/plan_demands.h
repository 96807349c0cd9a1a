#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/condition.h"
#include "engine/check/plan.h"

namespace glissade::check {

/// Bodies of a product that are there: one entry for each body.
using Present = std::vector<bool>;
/// Numbers of bodies, ascending.
using Group = std::vector<std::size_t>;

/// Numbers of the bodies with this name, ascending: see bodiesMeant().
Group bodiesNamed(const Product& product, const std::string& name);

/// The demands that a step breaks, for people.
struct BrokenDemands {
  Message refused{};                 ///< the first broken demand that the step does not admit; empty: none
  std::vector<Condition> givenUp{};  ///< broken demands that the step admits
};

/// Judges the step with this number (from 1). `there`: the bodies that are there when it begins, its own included.
BrokenDemands brokenDemands(const Step& step, const Group& group, const Present& there, std::size_t number,
                            const Product& product, const Demands& demands);

}  // namespace glissade::check
