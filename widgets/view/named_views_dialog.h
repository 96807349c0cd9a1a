#pragma once

#include <QDialog>
#include <QListWidget>
#include <QPushButton>

#include <vector>

#include "widgets/workbench/named_views.h"

namespace glissade {

/// Lists the named views of a scenario: opens, renames (F2) and removes (Del) them.
class NamedViewsDialog final : public QDialog {
  Q_OBJECT

 public:
  NamedViewsDialog(NamedViews views, QWidget* parent);

 signals:
  void chosen(const glissade::NamedView& view);
  /// A view was renamed or removed.
  void edited(const glissade::NamedViews& views);

 private:
  void showViews();
  void goToCurrent();
  void takeName(const QListWidgetItem& item);
  void removeCurrent();

  NamedViews views_;
  QListWidget* list_;
  std::vector<QPushButton*> ofOneView_;  ///< buttons that need a selected view
};

}  // namespace glissade
