#pragma once

#include <QRectF>

#include <optional>
#include <vector>

namespace glissade {

/// A label that is to be drawn.
struct WantedLabel {
  QRectF box;           ///< preferred place
  bool strong = false;  ///< drawn in any case
  bool bound = false;   ///< drawn at the preferred place only
};

/// Places labels without overlaps: each at its preferred place, or beside that by its own size. A label without room is
/// left out, unless it is strong. Strong labels are placed first, then the others in their order; bound ones last.
/// `covered` is kept free; it may be empty.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<WantedLabel>& labels, const QRectF& covered = {});

}  // namespace glissade
