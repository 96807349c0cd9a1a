#pragma once

#include <string>
#include <vector>

#include "engine/check/condition.h"
#include "engine/check/plan.h"

namespace glissade::check {

/// Which bodies of a product are there: one entry each.
using Present = std::vector<bool>;
/// Numbers of bodies, ascending.
using Group = std::vector<std::size_t>;

/// The bodies that a person means by the name, ascending: bodiesMeant().
Group bodiesNamed(const Product& product, const std::string& name);

/// The demands that a step does not keep, for people.
struct BrokenDemands {
  std::string refused{};             ///< the first that the step does not say it does not keep; empty: there is none
  std::vector<Condition> givenUp{};  ///< that the step says it does not keep
};

/// Of the step of this number (from 1). `there`: the bodies when it begins, its own included.
BrokenDemands brokenDemands(const Step& step, const Group& group, const Present& there, std::size_t number,
                            const Product& product, const Demands& demands);

}  // namespace glissade::check
