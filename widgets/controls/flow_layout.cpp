#include "widgets/controls/flow_layout.h"

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

constexpr int kFlowGap = 4;

}  // namespace

FlowLayout::FlowLayout() {
  setSpacing(kFlowGap);
  setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) { items_.emplace_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  if (itemAt(index) == nullptr) return nullptr;
  const auto at = items_.begin() + index;
  QLayoutItem* item = at->release();
  items_.erase(at);
  return item;
}

template <class Place>
int FlowLayout::arrange(const QRect& area, Place place) const {
  QPoint at = area.topLeft();
  int rowHeight = 0;
  for (const auto& item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint();
    if (at.x() > area.left() && at.x() + size.width() > area.left() + area.width()) {
      at = {area.left(), at.y() + rowHeight + spacing()};
      rowHeight = 0;
    }
    place(*item, QRect(at, size));
    at.rx() += size.width() + spacing();
    rowHeight = std::max(rowHeight, size.height());
  }
  return at.y() + rowHeight - area.top();
}

QSize FlowLayout::minimumSize() const {
  QSize least;
  for (const auto& item : items_) {
    if (!item->isEmpty()) least = least.expandedTo(item->sizeHint());
  }
  return least.expandedTo(QSize(0, height_));
}

QSize FlowLayout::sizeHint() const {
  QSize whole;
  for (const auto& item : items_) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint();
    whole = {whole.width() + size.width() + spacing(), std::max(whole.height(), size.height())};
  }
  return whole.expandedTo(QSize(0, height_));
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  const int height = arrange(area, [](QLayoutItem& item, const QRect& place) { item.setGeometry(place); });
  if (std::exchange(height_, height) != height) invalidate();
}

}  // namespace glissade
