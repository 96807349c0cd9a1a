#pragma once

#include <QCheckBox>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "engine/geometry/section_plane.h"
#include "widgets/panels/quantity_box.h"

namespace glissade {

/// One section as a person sees and moves it: on or off, its place as a slider and as a length, the side that is cut
/// away.
class SectionRow final : public QWidget {
  Q_OBJECT

 public:
  /// `name` begins the row; `id` is its object name.
  SectionRow(const QString& name, const QString& id, const SectionPlane& section, const PlaceRange& range,
             QWidget* parent);

  const SectionPlane& section() const { return section_; }
  /// Announces nothing.
  void setSection(const SectionPlane& section);
  void setRange(const PlaceRange& range);
  void focusPlace() { length_->setFocus(); }

 signals:
  /// Somebody has changed it.
  void changed();
  void removed();
  /// What was typed is no length within the range.
  void refused(const QString& text);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectWidgets();
  void showUnit();
  void showSection();

  SectionPlane section_;
  PlaceRange range_;
  double perMetre_ = 1e3;
  QCheckBox* on_;
  QSlider* place_;
  QuantityBox* length_;
  QToolButton* otherSide_;
  QToolButton* remove_;
};

}  // namespace glissade
