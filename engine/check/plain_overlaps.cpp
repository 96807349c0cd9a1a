#include "engine/check/plain_overlaps.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/base/depth_text.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {

std::string plainOverlapsInWords(std::size_t pairs) {
  const std::string subject = pairs == 1 ? "1 pair overlaps" : std::to_string(pairs) + " pairs overlap";
  return subject + " without being a fit, a thread or a press";
}

void addPlainOverlaps(const std::vector<AppliedAllowance>& allowances, std::vector<PlainOverlap>& overlaps) {
  for (const AppliedAllowance& each : allowances) {
    if (each.plainOverlap <= 0.0) continue;
    const std::pair<std::string, std::string> pair = std::minmax(each.thinner, each.against);
    const bool known = std::any_of(overlaps.begin(), overlaps.end(), [&](const PlainOverlap& overlap) {
      return std::tie(overlap.one, overlap.other, overlap.depth) ==
             std::tie(pair.first, pair.second, each.plainOverlap);
    });
    if (!known) overlaps.push_back({pair.first, pair.second, each.plainOverlap});
  }
}

std::string inWords(const std::vector<PlainOverlap>& overlaps) {
  if (overlaps.empty()) return {};
  std::string words = plainOverlapsInWords(overlaps.size()) + ": ";
  for (std::size_t i = 0; i < overlaps.size(); ++i) {
    words += (i == 0 ? "" : ", ") + pairInWords(overlaps[i].one, overlaps[i].other) + " by " +
             depthInMillimetres(overlaps[i].depth);
  }
  return words;
}

}  // namespace glissade::check
