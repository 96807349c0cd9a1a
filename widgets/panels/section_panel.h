#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

#include <vector>

#include "widgets/commands/action_catalogue.h"
#include "widgets/panels/section_row.h"

namespace glissade {

/// The sections of the view, one row for each, and buttons that add some.
class SectionPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit SectionPanel(const ActionCatalogue& actions, QWidget* parent = nullptr);

  /// What the sliders go through.
  void setExtent(const Box3& extent);
  const Box3& extent() const { return extent_; }
  std::vector<SectionPlane> sections() const;
  /// Announces nothing, as the next three.
  void add(const SectionPlane& section);
  void set(std::size_t index, const SectionPlane& section);
  void remove(std::size_t index);
  void clear();

 signals:
  /// Somebody has changed, switched or removed a section.
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
