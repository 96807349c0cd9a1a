#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>
#include <optional>

#include "engine/geometry/pose.h"
#include "engine/scenario/placement_points.h"

namespace glissade {

/// Where one thing is, as numbers that can be changed: millimetres along the world's axes, and degrees
/// about them (URDF's roll, pitch and yaw). They are about a point that people choose: the origin of the file's
/// coordinates, the middle, or the reference point, which poses of path files are about. It stays where it is when the
/// angles change. A coordinate that nobody touches stays as exact as it is.
class PlacementPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  /// What is placed, and where it is; without a pose there is nothing to change. Announces nothing.
  void show(const QString& name, const std::optional<Pose>& X_WB, const PlacementPoints& points = {});

 signals:
  void placed(const glissade::Pose& X_WB);

 private:
  QDoubleSpinBox* addBox(int row, int axis, const QString& label, const QString& tip);
  QComboBox* makePoints();
  Vector3 point() const;
  void showNumbers();
  void takePosition(int axis);
  void takeTurn(int axis);

  QLabel* name_;
  QComboBox* about_ = nullptr;
  QDoubleSpinBox* position_[3] = {};
  QDoubleSpinBox* turn_[3] = {};
  Pose X_WB_;
  PlacementPoints points_;                  ///< in B
  Vector3 rollPitchYaw_ = Vector3::Zero();  ///< radians
};

}  // namespace glissade
