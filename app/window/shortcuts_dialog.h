#pragma once

#include <QDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "widgets/commands/action_catalogue.h"

namespace glissade {

/// Changes the shortcuts of all commands. A shortcut that is taken by another command is taken from it; keys without
/// Ctrl, Alt or Meta that steer the object or write text are refused. Nothing changes before the dialog is accepted.
class ShortcutsDialog final : public QDialog {
  Q_OBJECT

 public:
  ShortcutsDialog(const ActionCatalogue& actions, QWidget* parent);

  /// By id of the action; all of them.
  const QHash<QString, QKeySequence>& shortcuts() const { return shortcuts_; }

 private:
  QLayout* makeEditor();
  void addRow(const ActionSpec& spec);
  void showKeys();
  void filter(const QString& text);
  /// Of the row that is chosen; empty where none is.
  QString chosenId() const;
  void showChosen();
  void assign(const QKeySequence& keys);
  /// What assigning these keys to the chosen command does, or why it cannot be done.
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
