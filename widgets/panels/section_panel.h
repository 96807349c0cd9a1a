#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include <array>
#include <vector>

#include "engine/geometry/plane_section.h"

namespace glissade {

/// Section planes along the world's axes: one row for each axis, with its place and the side that is cut away.
class SectionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPanel(QWidget* parent = nullptr);

  /// What the sliders go through; all sections are off. Announces nothing.
  void setExtent(const Box3& extent);
  /// Switches a section on at a share of the extent along its axis (0: x), or off.
  void setSection(int axis, bool on, double share);
  /// Which side of a section is cut away: that of the axis, or the other one.
  void setOtherSide(int axis, bool otherSide);
  /// The sections that are on.
  std::vector<Plane> sections() const;

 signals:
  void changed();
  /// Before changed().
  void switchedOn(int axis);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    QCheckBox* on;
    QSlider* place;
    QLabel* length;
    QToolButton* otherSide;
  };

  Row addRow(int axis);
  double placeOf(int axis) const;
  void showLengths();

  Box3 extent_;
  std::array<Row, 3> rows_;
};

}  // namespace glissade
