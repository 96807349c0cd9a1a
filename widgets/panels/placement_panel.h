#pragma once

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "engine/geometry/pose.h"
#include "engine/scenario/placement_points.h"
#include "widgets/panels/quantity_box.h"

namespace glissade {

/// Where one thing is, as numbers that can be changed: millimetres along the world's axes, and degrees
/// about them (URDF's roll, pitch and yaw), or in any unit that is written with them. They are about a point that
/// people choose: the origin of the file's coordinates, the middle, or the reference point, which poses of path files
/// are about. It stays where it is when the angles change. Where a face or an axis was picked, the numbers may be those
/// of its frame. A coordinate that nobody touches stays as exact as it is.
class PlacementPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  /// Beside the choice of the point.
  void addPickAction(QAction* action);

  /// The frame of a face or an axis that the numbers are of, X_BF; nothing where they are of a point.
  std::optional<Pose> chosenFrame() const;
  /// What the numbers are about, as people read it.
  QString chosenPoint() const { return about_->currentText(); }

  /// What is placed, and where it is; without a pose there is nothing to change. A frame
  /// that was not there before is chosen. Announces nothing.
  void show(const QString& name, const std::optional<Pose>& X_WB, const PlacementPoints& points = {});

 signals:
  void placed(const glissade::Pose& X_WB);
  /// Somebody has chosen what the numbers are about.
  void pointChosen();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QuantityBox* addBox(QuantityBox::Quantity quantity, int axis, const QString& tip);
  /// In the place of the title, shortly; the whole reason is its tool tip.
  void showRefused(QuantityBox::Quantity quantity, const QString& text);
  void hideRefused();
  QComboBox* makePoints();
  void offerPicked();
  Pose frame() const;
  void showTitle();
  void showUnit();
  void showNumbers();
  void takePosition(int axis);
  void takeTurn(int axis);

  QLabel* name_;
  QComboBox* about_ = nullptr;
  QToolButton* pick_ = nullptr;
  QuantityBox* position_[3] = {};
  QuantityBox* turn_[3] = {};
  QLabel* refused_;
  double perMetre_ = 1.0;  ///< what is shown of a metre
  QString placedName_;
  bool isPlaced_ = false;
  Pose X_WB_;
  PlacementPoints points_;                  ///< in B
  Vector3 rollPitchYaw_ = Vector3::Zero();  ///< radians
};

}  // namespace glissade
