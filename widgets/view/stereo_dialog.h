#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>

#include <set>

#include "widgets/controls/action_catalogue.h"
#include "widgets/workbench/stereo_settings.h"

namespace glissade {

/// Settings of stereo and of the screen's size. A change has effect at once.
class StereoDialog final : public QDialog {
  Q_OBJECT

 public:
  /// A mode whose action is disabled cannot be chosen.
  StereoDialog(const ActionCatalogue& actions, const StereoSettings& present, QWidget* parent);

  void setSettings(const StereoSettings& present);
  /// Shows the size of the scene on the screen, metres, by which a person can check the screen's width.
  void showPictureSize(const QSizeF& metres);

 signals:
  void changed(const glissade::StereoSettings& settings);

 private:
  QDoubleSpinBox* makeLength(double least, double most, double step, const QString& tip);
  void fill(const ActionCatalogue& actions);
  StereoSettings settings() const;
  void announce();

  QComboBox* mode_;
  QCheckBox* swapped_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* distance_;
  QDoubleSpinBox* separation_;
  QComboBox* convergence_;
  QComboBox* display_;
  QLabel* size_;
};

}  // namespace glissade
