#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// The actions whose name, synonyms, description or id contain every word of the text, in order of rank: the name
/// begins with the text, the name contains it, name and synonyms contain the words, others.
std::vector<QAction*> matchingActions(const ActionCatalogue& actions, const QString& text);

/// Finds an action by a part of its name or a synonym and triggers it, or says that it finds none. Up and Down choose a
/// row during typing, Enter triggers it, Esc closes the dialog. A row shows the menu and the shortcut of the action.
/// Disabled actions are grey.
class CommandPalette final : public QDialog {
  Q_OBJECT

 public:
  CommandPalette(const ActionCatalogue& actions, QWidget* parent);

  QLineEdit& field() const { return *field_; }
  const QTreeWidget& list() const { return *list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showMatches();
  void addRow(const QAction& action);
  void triggerCurrent();

  const ActionCatalogue& actions_;
  QLineEdit* field_;
  QTreeWidget* list_;
  std::vector<QAction*> shown_;  ///< action of each row
};

}  // namespace glissade
