#include "engine/documents/plan_timing.h"

#include <numeric>

namespace glissade {
double PlanTiming::sum() const { return std::accumulate(tasks.seconds.begin(), tasks.seconds.end(), 0.0); }

double PlanTiming::chainSeconds() const {
  double seconds = 0.0;
  for (const std::size_t task : chain) seconds += tasks.seconds[task];
  return seconds;
}

std::vector<std::size_t> PlanTiming::stepsAt(std::size_t station) const {
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < line->stationOf.size(); ++i) {
    if (line->stationOf[i] == station) steps.push_back(i);
  }
  return steps;
}

Result<PlanTiming> planTiming(const AssemblyPlan& plan, const AssembledProduct& product, const WorkTimes& table,
                              std::optional<std::size_t> stations) {
  const std::vector<StepTime> times = stepTimes(plan, product, table);
  std::vector<double> seconds;
  for (const StepTime& time : times) seconds.push_back(time.total());
  PlanTiming timing{{times.rbegin(), times.rend()}, lineTasks(plan, seconds), {}};
  timing.chain = longestChain(timing.tasks);
  timing.edited = editedCount(table);
  if (!stations) return timing;
  auto line = balanceLine(timing.tasks, *stations);
  if (!line) return line.error();
  timing.line = *std::move(line);
  return timing;
}

std::string numbersText(const std::vector<std::size_t>& steps) {
  std::string text;
  for (const std::size_t step : steps) text += (text.empty() ? "" : ", ") + std::to_string(step + 1);
  return text;
}

}  // namespace glissade
