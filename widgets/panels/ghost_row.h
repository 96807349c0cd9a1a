#pragma once

#include <QComboBox>
#include <QSpinBox>
#include <QWidget>

#include "engine/planning/path_spacing.h"
#include "widgets/panels/quantity_box.h"

namespace glissade {

/// Where the object is drawn along the path: nowhere, at a number of places, or every so many millimetres.
class GhostRow final : public QWidget {
  Q_OBJECT

 public:
  explicit GhostRow(QWidget* parent);

  const PathSpacing& spacing() const { return spacing_; }
  /// Announces it, too.
  void setSpacing(const PathSpacing& spacing);

 signals:
  void changed(const glissade::PathSpacing& spacing);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectWidgets();
  void showUnit();
  void showSpacing();

  PathSpacing spacing_;
  double perMetre_ = 1e3;
  QComboBox* by_;
  QSpinBox* number_;
  QuantityBox* distance_;
};

}  // namespace glissade
