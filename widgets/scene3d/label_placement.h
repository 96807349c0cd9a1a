#pragma once

#include <QRectF>

#include <optional>
#include <vector>

namespace glissade {

/// A label that wants to be drawn.
struct WantedLabel {
  QRectF box;           ///< where it would like to be
  bool strong = false;  ///< drawn in any case
  bool bound = false;   ///< only where it would like to be, or not at all
};

/// Where labels go so that none lies on another: each where it wants to be, or beside that by its own size. One
/// for which there is no room is left out, unless it is strong. Strong ones choose first, then in their order;
/// bound ones last. `covered` is kept free; it may be empty.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<WantedLabel>& labels, const QRectF& covered = {});

}  // namespace glissade
