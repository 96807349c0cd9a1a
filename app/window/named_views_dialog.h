#pragma once

#include <QDialog>
#include <QListWidget>
#include <QPushButton>

#include <vector>

#include "app/window/named_views.h"

namespace glissade {

/// The named views of a scenario: go to one, rename it (F2), remove it (Del).
class NamedViewsDialog final : public QDialog {
  Q_OBJECT

 public:
  NamedViewsDialog(NamedViews views, QWidget* parent);

 signals:
  void chosen(const glissade::NamedView& view);
  /// After a view was renamed or removed.
  void edited(const glissade::NamedViews& views);

 private:
  void showViews();
  void goToCurrent();
  void takeName(const QListWidgetItem& item);
  void removeCurrent();

  NamedViews views_;
  QListWidget* list_;
  std::vector<QPushButton*> ofOneView_;  ///< they need one
};

}  // namespace glissade
