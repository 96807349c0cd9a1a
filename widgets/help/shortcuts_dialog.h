#pragma once

#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "widgets/controls/action_catalogue.h"

namespace glissade {

/// Changes the shortcuts of all commands. A command loses a shortcut that is assigned to another one. Keys without
/// Ctrl, Alt or Meta that steer the object or write text are refused. Nothing changes before the dialog is accepted.
class ShortcutsDialog final : public QDialog {
  Q_OBJECT

 public:
  ShortcutsDialog(const ActionCatalogue& actions, QWidget* parent);

  /// The shortcuts of all actions, by the action's id.
  const QHash<QString, QKeySequence>& shortcuts() const { return shortcuts_; }

 private:
  QLayout* makeEditor();
  void addRow(const ActionSpec& spec);
  void showKeys();
  void filter(const QString& text);
  /// Id of the chosen row; empty if no row is chosen.
  QString chosenId() const;
  void showChosen();
  void assign(const QKeySequence& keys);
  /// Shows the effect of assigning these keys to the chosen command, or why they are refused.
  void explain();

  const ActionCatalogue& actions_;
  QHash<QString, QKeySequence> shortcuts_;
  QLineEdit* filter_;
  QTableWidget* table_;
  QKeySequenceEdit* keys_;
  QPushButton* assign_;
  QPushButton* remove_;
  QPushButton* usual_;
  QLabel* note_;
};

}  // namespace glissade
