#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/pair_fit.h"

namespace glissade::check {

/// A pair that overlaps and is no fit, no thread and no press fit: a part is drawn too large.
struct PlainOverlap {
  std::string one;  ///< names, for people
  std::string other;
  double depth = 0.0;  ///< metres
};

/// "1 pair overlaps without being a fit, a thread or a press"
Message plainOverlapsInWords(std::size_t pairs);

/// Adds the plain overlaps that allowances state, each pair once.
void addPlainOverlaps(const std::vector<AppliedAllowance>& allowances, std::vector<PlainOverlap>& overlaps);

/// "1 pair with allowances overlaps without being a fit, a thread or a press: 'bar' and 'post' by 0.75 mm"; empty if
/// there is none. Pairs that no step moves past each other are not among them.
Message inWords(const std::vector<PlainOverlap>& overlaps);

}  // namespace glissade::check
