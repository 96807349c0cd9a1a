#include "engine/operator/run_log.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

template <class Entry>
void appendAll(const std::vector<Entry>& from, std::vector<Entry>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

/// A point at which the log has both step and time.
struct TimeMark {
  double step;
  double seconds;
};

TimeMark markOf(const RunCheckpoint& checkpoint) { return {static_cast<double>(checkpoint.step), checkpoint.seconds}; }

/// Interpolates between the two marks around `x`, which grow with `from`; extrapolates after the last.
double between(const RunLog& log, double x, double TimeMark::*from, double TimeMark::*to) {
  TimeMark before{0.0, 0.0};
  TimeMark after = before;
  const auto later = std::upper_bound(
      log.checkpoints.begin(), log.checkpoints.end(), x,
      [from](double value, const RunCheckpoint& checkpoint) { return value < markOf(checkpoint).*from; });
  if (later != log.checkpoints.begin()) before = markOf(*std::prev(later));
  if (later != log.checkpoints.end()) {
    after = markOf(*later);
  } else if (log.end) {
    after = markOf(*log.end);
  }
  if (!(after.*from > before.*from) || !(after.*to > before.*to)) {
    const double rate = log.start.parameters[ParameterId::StepsPerSecond];
    after = {before.step + rate, before.seconds + 1.0};
  }
  return before.*to + (x - before.*from) * (after.*to - before.*to) / (after.*from - before.*from);
}

}  // namespace

double secondsAt(const RunLog& log, std::uint64_t step) {
  return between(log, static_cast<double>(step), &TimeMark::step, &TimeMark::seconds);
}

std::uint64_t stepAt(const RunLog& log, double seconds) {
  return static_cast<std::uint64_t>(
      std::llround(between(log, std::max(seconds, 0.0), &TimeMark::seconds, &TimeMark::step)));
}

void append(const RunLog& part, RunLog& log) {
  appendAll(part.parameterChanges, log.parameterChanges);
  appendAll(part.semanticChanges, log.semanticChanges);
  appendAll(part.operatorStream, log.operatorStream);
  appendAll(part.checkpoints, log.checkpoints);
  if (part.end) log.end = part.end;
  log.cutShort = part.cutShort;
}

RunLog joined(const RunLogParts& parts) {
  RunLog log;
  log.start = parts.front()->start;
  for (const auto& part : parts) append(*part, log);
  return log;
}

}  // namespace glissade
