#pragma once

#include <optional>
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

  /// The fits of each body of this product, as FitTable::objects(); nothing: they are not kept.
  virtual std::optional<std::vector<ObjectFits>> find(const AssembledProduct& product, const ContactLimits& limits) = 0;
  /// A failure has no effect but that the fits are found again.
  virtual void keep(const AssembledProduct& product, const ContactLimits& limits,
                    const std::vector<ObjectFits>& objects) = 0;
};

}  // namespace glissade
