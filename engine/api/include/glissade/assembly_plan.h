#pragma once

#include <glissade/export.h>
#include <glissade/path.h>

#include <memory>
#include <string>
#include <vector>

namespace glissade::api {

/// The removal of one body, or of several that move as one.
struct Motion {
  std::vector<std::string> bodies{};  ///< ids of the bodies that leave
  std::string method{};               ///< how the motion was found, such as "straight"
  /// Poses of the first body's frame, or of the group's. Each body of the motion has X_WB = X(t) X(0)^-1
  /// X_WB(assembled).
  std::vector<Pose> path{};
  bool certified = true;      ///< false for a flexible body, whose motion is not proved
  double minClearance = 0.0;  ///< smallest clearance that was met, metres; infinite where no body was there
  std::string nearest{};      ///< id of the body at the smallest clearance; empty: none
};

/// Motions that are carried out one after the other, such as those of nut, washer and bolt.
struct Step {
  std::vector<std::string> bodies{};  ///< ids of the bodies that leave
  std::vector<Motion> motions{};      ///< one or more, in the order of removal
  std::vector<std::size_t> after{};   ///< numbers, from 1, of the steps that have to come before
};

/// A body that no removal was found for.
struct StuckBody {
  std::string body{};                    ///< id
  std::vector<std::string> blockedBy{};  ///< ids of blocking bodies
  std::string reason{};                  ///< for people; may be empty
};

/// The reason why a plan has ended.
enum class PlanEnd {
  Complete,    ///< every body that is to leave has left
  Stuck,       ///< no removal was found for the others
  TimeLimit,   ///< the time limit was reached
  Interrupted  ///< stopped
};

/// An order in which the bodies of a product leave, each with a certified motion. Assembly is the reverse. Immutable;
/// copies share everything; any thread may read it.
class GLISSADE_EXPORT AssemblyPlan {
 public:
  /// The steps in the order of removal.
  std::vector<Step> steps() const;
  /// The reason why it has ended.
  PlanEnd end() const;
  /// Number of bodies that are to leave.
  std::size_t parts() const;
  /// Number of bodies that leave.
  std::size_t removed() const;
  /// Ids of the bodies that stay as base.
  std::vector<std::string> staying() const;
  /// Bodies that should leave and do not.
  std::vector<StuckBody> stuck() const;
  /// The document of a plan file (resources/schema/plan-2.schema.json), without checksum. `product`: the file of the
  /// product.
  std::string json(const std::string& product) const;
  /// Saves the plan for `product`, the file of the product. Error: a file that cannot be written (Unwritable).
  Outcome save(const std::string& file, const std::string& product) const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit AssemblyPlan(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  AssemblyPlan(const AssemblyPlan&) = default;             ///< shares everything
  AssemblyPlan& operator=(const AssemblyPlan&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
