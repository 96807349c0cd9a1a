#include "engine/check/plain_overlaps.h"

#include <algorithm>
#include <utility>

namespace glissade::check {

Message plainOverlapsInWords(std::size_t pairs) {
  return {GLISSADE_TEXT("%1 {1|pair overlaps|pairs overlap} without being a fit, a thread or a press"), {pairs}};
}

void addPlainOverlaps(const std::vector<AppliedAllowance>& allowances, std::vector<PlainOverlap>& overlaps) {
  for (const AppliedAllowance& each : allowances) {
    if (each.plainOverlap <= 0.0) continue;
    const std::pair<std::string, std::string> pair = std::minmax(each.thinner, each.against);
    const auto known = std::find_if(overlaps.begin(), overlaps.end(), [&](const PlainOverlap& overlap) {
      return overlap.one == pair.first && overlap.other == pair.second;
    });
    if (known == overlaps.end()) {
      overlaps.push_back({pair.first, pair.second, each.plainOverlap});
    } else {
      known->depth = std::max(known->depth, each.plainOverlap);
    }
  }
}

Message inWords(const std::vector<PlainOverlap>& overlaps) {
  if (overlaps.empty()) return {};
  std::vector<Message> pairs;
  for (const PlainOverlap& each : overlaps) {
    pairs.push_back({GLISSADE_TEXT("'%1' and '%2' by %3"), {each.one, each.other, Depth{each.depth}}});
  }
  return {GLISSADE_TEXT("%1 {1|pair|pairs} with allowances {1|overlaps|overlap} without being a fit, a thread or a "
                        "press: %2"),
          {overlaps.size(), joined(pairs, ", ")}};
}

}  // namespace glissade::check
