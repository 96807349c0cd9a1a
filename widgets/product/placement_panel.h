#pragma once

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "engine/files/placement_points.h"
#include "engine/geometry/pose.h"
#include "widgets/controls/quantity_box.h"

namespace glissade {

/// The pose of one item, as numbers that can be changed: millimetres along the world's axes, and degrees about them
/// (URDF's roll, pitch and yaw), or in any unit that is typed with them. They describe a point that the person selects:
/// the origin of the file's coordinates, the middle, or the reference point, to which poses of path files refer. This
/// point stays in place when the angles change. If a face or an axis was picked, the numbers can describe its frame. A
/// coordinate that nobody changes keeps its exact value.
class PlacementPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementPanel(QWidget* parent = nullptr);

  /// Adds the action beside the choice of the point.
  void addPickAction(QAction* action);

  /// The frame of a face or an axis that the numbers describe, X_BF; nothing if they describe a point.
  std::optional<Pose> chosenFrame() const;
  /// The displayed name of the point that the numbers describe.
  QString chosenPoint() const { return about_->currentText(); }

  /// Shows the item and its pose; without a pose nothing can be changed. A new picked frame becomes selected. Emits no
  /// signal.
  void show(const QString& name, const std::optional<Pose>& X_WB, const PlacementPoints& points = {});

 signals:
  void placed(const glissade::Pose& X_WB);
  /// The person has selected another point.
  void pointChosen();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QuantityBox* addBox(QuantityBox::Quantity quantity, int axis, const QString& tip);
  /// Shows a short refusal in place of the title; its tool tip has the whole reason.
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
  QuantityBox* position_[3] = {};
  QuantityBox* turn_[3] = {};
  QLabel* refused_;
  double perMetre_ = 1.0;  ///< the number that fields show for a metre
  QString placedName_;
  bool isPlaced_ = false;
  Pose X_WB_;
  PlacementPoints points_;                  ///< in the frame B
  Vector3 rollPitchYaw_ = Vector3::Zero();  ///< radians
};

}  // namespace glissade
