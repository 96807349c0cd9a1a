#pragma once

#include <glissade/export.h>
#include <glissade/problem.h>
#include <glissade/product.h>

#include <cstdint>
#include <memory>
#include <string>

namespace glissade::api {

/// A loaded scenario file. Immutable; copies share everything; any thread may read it. load<Scenario>() reads one.
class GLISSADE_EXPORT Scenario {
 public:
  /// Name of the scenario.
  std::string name() const;
  /// The file that it was read from.
  std::string file() const;
  /// Id of the planner that the scenario chooses.
  std::string strategy() const;
  /// Seed that the scenario states.
  std::uint64_t seed() const;
  /// Losses and doubts from reading it.
  Warnings warnings() const;
  /// The task, with the allowances of the scenario's fits.
  Problem problem() const;
  /// All bodies: the obstacles, then the object at its start. Error (MalformedInput): contradicting attributes.
  Result<Product> product() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Scenario(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Scenario(const Scenario&) = default;             ///< shares everything
  Scenario& operator=(const Scenario&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
