#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace glissade {

/// Puts its items beside each other, and into further rows if the width does not suffice. Rows of buttons then do not
/// widen a panel.
class FlowLayout final : public QLayout {
 public:
  FlowLayout();
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  /// The minimum is as wide as the widest item, and as high as all rows at the present width: panels keep room for the
  /// rows.
  QSize minimumSize() const override;
  /// The hint is as wide as all items in one row.
  QSize sizeHint() const override;
  void setGeometry(const QRect& area) override;

 private:
  /// Calls `place` with each item and its rectangle within the area; returns the height.
  template <class Place>
  int arrange(const QRect& area, Place place) const;

  std::vector<std::unique_ptr<QLayoutItem>> items_;
  int height_ = 0;  ///< height of all rows at the present width; 0: not arranged yet
};

}  // namespace glissade
