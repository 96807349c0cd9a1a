#pragma once

#include <glissade/export.h>
#include <glissade/world.h>

#include <memory>
#include <string>
#include <vector>

namespace glissade::api {

class Scenario;

/// Straight motions between consecutive configurations, with what is proved about them. Immutable; copies share
/// everything; any thread may read it.
class GLISSADE_EXPORT Path {
 public:
  /// A path that nothing is proved of: check() judges it. Errors (Usage): no pose, an invalid pose.
  static Result<Path> make(const std::vector<Pose>& configurations);

  /// The configurations X_WB of the object, at least one.
  const std::vector<Pose>& configurations() const;
  /// The certificate of the planner. It is undecided for a path of a file and for one of Path::make().
  const Certificate& certificate() const;
  /// Sum of the translations, metres.
  double length() const;
  /// Sum of the rotation angles, radians.
  double rotation() const;
  /// Saves the path of a scenario's object in the format of the file's ending: .csv, .json, .path or .glb. Errors: an
  /// unknown ending (Usage), a file that cannot be written (Unwritable).
  Outcome save(const std::string& file, const Scenario& scenario) const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Path(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Path(const Path&) = default;             ///< shares everything
  Path& operator=(const Path&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
