#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/fits/assembled_product.h"
#include "engine/fits/contact_report.h"
#include "engine/fits/object_fits.h"

namespace glissade {

/// Keeps the fits of products from one run of the program to the next. Thread-safe.
class FitsStore {
 public:
  virtual ~FitsStore() = default;
  FitsStore() = default;
  FitsStore(const FitsStore&) = delete;
  FitsStore& operator=(const FitsStore&) = delete;

  /// The key of all that the fits depend on. It takes a second for millions of triangles.
  virtual std::string keyOf(const AssembledProduct& product, const ContactLimits& limits) const = 0;
  /// The fits of each body of the product, as FitTable::objects(); nothing: they are not kept.
  virtual std::optional<std::vector<ObjectFits>> find(const std::string& key) const = 0;
  /// A failure has no effect but that the fits are found again.
  virtual void keep(const std::string& key, const std::vector<ObjectFits>& objects) = 0;
};

}  // namespace glissade
