#pragma once

#include <string>
#include <vector>

#include "engine/check/plan.h"

namespace glissade::check {

/// Which bodies of a product are there: one entry each.
using Present = std::vector<bool>;
/// Numbers of bodies, ascending.
using Group = std::vector<std::size_t>;

/// The bodies that a person means by the name, ascending: bodiesMeant().
Group bodiesNamed(const Product& product, const std::string& name);

/// What of the demands the step of this number (from 1) does not keep, and does not say that it does not; empty:
/// nothing. `there`: the bodies when it begins, its own included.
std::string againstDemands(const Step& step, const Group& group, const Present& there, std::size_t number,
                           const Product& product, const Demands& demands);

}  // namespace glissade::check
