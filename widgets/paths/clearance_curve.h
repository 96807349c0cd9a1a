#pragma once

#include <QStringList>
#include <QWidget>

#include <memory>

#include "engine/planning/clearance_profile.h"
#include "widgets/controls/length_text.h"

namespace glissade {

/// The distance to the nearest body along a path, on a logarithmic axis, in the colour of the nearest body. A click or
/// a drag selects a place of the path; the pointer over the curve shows distance and body; Left and Right move along
/// the path.
class ClearanceCurve final : public QWidget {
  Q_OBJECT

 public:
  explicit ClearanceCurve(QWidget* parent = nullptr);

  /// `bodies`: the names of the obstacles by index. `required`: the required clearance, metres. A null profile is not
  /// known.
  void setProfile(std::shared_ptr<const ClearanceProfile> profile, const QStringList& bodies, double required);
  const std::shared_ptr<const ClearanceProfile>& profile() const { return profile_; }
  /// Shows this place of the path, as a share of its length.
  void setPlace(double share);

  QSize sizeHint() const override;

 signals:
  void placeChosen(double share);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  PlotLengths lengths() const;
  std::vector<double> marks() const;
  QRectF plotArea() const;
  double shareAt(double x) const;
  double yOf(double distance) const;
  const ClearanceSample& sampleAt(double share) const;
  QString textOf(const ClearanceSample& sample) const;
  QColor colourOf(int body) const;
  void paintGrid(QPainter& painter) const;
  void paintCurve(QPainter& painter) const;

  std::shared_ptr<const ClearanceProfile> profile_;
  QStringList bodies_;
  std::vector<int> bodyOrder_;  ///< nearest bodies in the order in which they appear, which determines their colours
  double required_ = 0.0;
  double least_ = 1e-3;  ///< least distance of the axis, metres
  double most_ = 1.0;
  double place_ = 0.0;
};

}  // namespace glissade
