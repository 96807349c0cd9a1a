#include "widgets/scene3d/label_placement.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr double kGap = 2.0;  ///< between two labels, in pixels

/// Steps from a label's preferred place, in its own sizes, the nearest first.
constexpr double kSteps[][2] = {{0, 0}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

class Placement {
 public:
  explicit Placement(const QRectF& covered) : taken_{covered} {}

  std::optional<QRectF> place(const WantedLabel& label) {
    for (const auto& [across, down] : kSteps) {
      if (label.bound && (across != 0 || down != 0)) break;
      const QRectF box = label.box.translated(across * (label.box.width() + kGap), down * (label.box.height() + kGap));
      if (isFree(box)) return taken(box);
    }
    if (label.strong) return taken(label.box);
    return std::nullopt;
  }

 private:
  bool isFree(const QRectF& box) const {
    return std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return other.intersects(box); });
  }
  QRectF taken(const QRectF& box) {
    taken_.push_back(box);
    return box;
  }

  std::vector<QRectF> taken_;
};

}  // namespace

std::vector<std::optional<QRectF>> placeLabels(const std::vector<WantedLabel>& labels, const QRectF& covered) {
  Placement placement(covered);
  std::vector<std::optional<QRectF>> places(labels.size());
  const auto rank = [](const WantedLabel& label) { return label.strong ? 0 : label.bound ? 2 : 1; };
  for (const int turn : {0, 1, 2}) {
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (rank(labels[i]) == turn) places[i] = placement.place(labels[i]);
    }
  }
  return places;
}

}  // namespace glissade
