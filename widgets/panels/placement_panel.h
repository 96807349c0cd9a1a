#pragma once

#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>
#include <optional>

#include "engine/geometry/pose.h"

namespace glissade {

/// Where one thing is, as numbers that can be changed: millimetres along the world's axes, and degrees
/// about them (URDF's roll, pitch and yaw). A coordinate that nobody touches stays as exact as it is.
class PlacementPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  /// What is placed, and where it is; without a pose there is nothing to change. Announces nothing.
  void show(const QString& name, const std::optional<Pose>& X_WB);

 signals:
  void placed(const glissade::Pose& X_WB);

 private:
  QDoubleSpinBox* addBox(int row, int axis, const QString& label, const QString& tip);
  void takePosition(int axis);
  void takeTurn(int axis);

  QLabel* name_;
  QDoubleSpinBox* position_[3] = {};
  QDoubleSpinBox* turn_[3] = {};
  Pose X_WB_;
  Vector3 rollPitchYaw_ = Vector3::Zero();  ///< radians
};

}  // namespace glissade
