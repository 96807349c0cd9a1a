#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QTreeWidget>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// The actions whose name, description or id has every word of the text, the best first: those whose name begins with
/// it, then those whose name has it, then the others.
std::vector<QAction*> matchingActions(const ActionCatalogue& actions, const QString& text);

/// Finds an action by a part of its name and triggers it. Up and Down choose while one types, Enter triggers, Esc
/// leaves. A row says in which menu the action is and what its shortcut is. What cannot be done now is grey.
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
  std::vector<QAction*> shown_;  ///< by row
};

}  // namespace glissade
