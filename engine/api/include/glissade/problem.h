#pragma once

#include <glissade/export.h>
#include <glissade/world.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace glissade::api {

/// Values of parameters by their keys in scenario files, such as "alpha" or "required_clearance". SI units.
using Parameters = std::map<std::string, double>;

/// A task: the object has to get from the start to the goal. Immutable; copies share everything; any thread may read
/// it.
class GLISSADE_EXPORT Problem {
 public:
  /// The problem of bringing the object from `start` to `goal`. Without a goal, every configuration clear of the
  /// bounding box of all obstacles is one ("out"). Without bounds, the object's origin may be in a box with room to get
  /// out on each side. Errors (Usage): an invalid pose or box, an unknown parameter, a value out of its range.
  static Result<Problem> make(const World& world, const Pose& start, const std::optional<Pose>& goal,
                              const std::optional<Box>& bounds = {}, const Parameters& parameters = {});

  /// Obstacles and object.
  World world() const;
  /// Configuration at which every path begins.
  Pose start() const;
  /// Configuration at which every path ends; nothing: "out".
  std::optional<Pose> goal() const;
  /// Box of the object's origin.
  Box bounds() const;
  /// All parameters with their values.
  Parameters parameters() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Problem(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Problem(const Problem&) = default;             ///< shares everything
  Problem& operator=(const Problem&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
