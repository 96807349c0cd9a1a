#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <vector>

#include "engine/geometry/section_plane.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/quantity_box.h"

namespace glissade {

/// The controls of one section: on or off, its place as a slider and as a length, the side that is cut away.
class SectionRow final : public QWidget {
  Q_OBJECT

 public:
  /// `name` is the title of the row; `id` is its object name.
  SectionRow(const QString& name, const QString& id, const SectionPlane& section, const PlaceRange& range,
             QWidget* parent);

  const SectionPlane& section() const { return section_; }
  /// Emits no signal.
  void setSection(const SectionPlane& section);
  void setRange(const PlaceRange& range);
  void focusPlace() { length_->setFocus(); }

 signals:
  /// The user has changed the section.
  void changed();
  void removed();
  /// The text is no length within the range.
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

/// The sections of the view, one row for each, and buttons that add some.
class SectionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// Sets the range of the sliders.
  void setExtent(const Box3& extent);
  const Box3& extent() const { return extent_; }
  std::vector<SectionPlane> sections() const;
  /// Neither this function nor the next three emit a signal.
  void add(const SectionPlane& section);
  void set(std::size_t index, const SectionPlane& section);
  void remove(std::size_t index);
  void clear();
  void focusFirstButton() { firstButton_->setFocus(); }

 signals:
  /// The user has changed, switched or removed a section.
  void changed();

 private:
  QString freeName(const Vector3& direction) const;
  void removeByHand(SectionRow* row);
  void showNote();

  Box3 extent_;
  std::vector<SectionRow*> rows_;
  QVBoxLayout* rowsLayout_;
  QLabel* note_;
  QWidget* firstButton_ = nullptr;
};

}  // namespace glissade
