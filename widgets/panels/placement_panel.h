#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "engine/geometry/pose.h"
#include "engine/scenario/placement_points.h"

namespace glissade {

/// Where one thing is, as numbers that can be changed: millimetres along the world's axes, and degrees
/// about them (URDF's roll, pitch and yaw). They are about a point that people choose: the origin of the file's
/// coordinates, the middle, or the reference point, which poses of path files are about. It stays where it is when the
/// angles change. Where a face or an axis was picked, the numbers may be those of its frame. A coordinate that nobody
/// touches stays as exact as it is.
class PlacementPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  /// Beside the choice of the point.
  void addPickAction(QAction* action);

  /// What the numbers are about, as people read it.
  QString chosenPoint() const { return about_->currentText(); }

  /// What is placed, and where it is; without a pose there is nothing to change. A frame
  /// that was not there before is chosen. Announces nothing.
  void show(const QString& name, const std::optional<Pose>& X_WB, const PlacementPoints& points = {});

 signals:
  void placed(const glissade::Pose& X_WB);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QDoubleSpinBox* addBox(int row, int axis, const QString& label, const QString& tip);
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
  QDoubleSpinBox* position_[3] = {};
  QDoubleSpinBox* turn_[3] = {};
  double perMetre_ = 1.0;  ///< what is shown of a metre
  QString placedName_;
  bool isPlaced_ = false;
  Pose X_WB_;
  PlacementPoints points_;                  ///< in B
  Vector3 rollPitchYaw_ = Vector3::Zero();  ///< radians
};

}  // namespace glissade
