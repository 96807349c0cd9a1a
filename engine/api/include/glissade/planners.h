#pragma once

#include <glissade/export.h>
#include <glissade/problem.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glissade::api {

/// The problem and the run for a planner from outside. It exists during one call, on the planner's thread.
class GLISSADE_EXPORT PlannerContext {
 public:
  virtual ~PlannerContext();
  /// The task.
  virtual const Problem& problem() const = 0;
  /// Queries for the planner's thread.
  virtual Query& query() = 0;
  /// Seed of the run. Everything random has to come from it.
  virtual std::uint64_t seed() const = 0;
  /// Value of a parameter by its key; NaN for an unknown key.
  virtual double parameter(const std::string& key) const = 0;
  /// The planner calls it once for each configuration that it draws. False: the planner has to return, because the run
  /// was stopped or has reached a limit.
  virtual bool step() = 0;
};

/// Searches a way and returns its configurations, from the start to the goal; empty: none was found. It is called once
/// for a run. The library certifies what it returns.
using PlannerFunction = std::function<std::vector<Pose>(PlannerContext&)>;

/// Planners from outside, beside those of the library.
class GLISSADE_EXPORT Planners {
 public:
  /// Adds a planner. Errors (Usage): an id that is empty, already there, or one of the library; an empty function.
  Outcome add(const std::string& id, PlannerFunction search);
  /// The ids of all planners, those of the library first.
  std::vector<std::string> ids() const;

  /// A planner from outside.
  struct Entry {
    std::string id;          ///< see add()
    PlannerFunction search;  ///< see add()
  };
  /// The planners from outside.
  const std::vector<Entry>& added() const { return added_; }

 private:
  std::vector<Entry> added_;
};

}  // namespace glissade::api
