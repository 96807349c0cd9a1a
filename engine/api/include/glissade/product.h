#pragma once

#include <glissade/export.h>
#include <glissade/world.h>

#include <memory>
#include <string>
#include <vector>

namespace glissade::api {

/// The assembled bodies of a product. Immutable; copies share everything; any thread may read it. load<Product>() reads
/// one.
class GLISSADE_EXPORT Product {
 public:
  /// A product of these bodies, with fits on. Errors (Usage): less than two bodies, an empty or repeated id, an invalid
  /// pose.
  static Result<Product> make(const std::vector<Body>& bodies);

  /// The bodies where they are assembled. The frame of each is in the middle of its bounding box.
  std::vector<Body> bodies() const;
  /// The file that it was read from; empty for Product::make().
  std::string file() const;
  /// Losses and doubts from reading it.
  Warnings warnings() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Product(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Product(const Product&) = default;             ///< shares everything
  Product& operator=(const Product&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
