#pragma once

#include <QStringList>

#include <cstddef>

#include "widgets/workbench/workbench.h"

class QDialog;

namespace glissade {

class SequenceController;

/// Compares the open product with a file of another revision, and shows the differences and the steps of the sequence
/// that no longer hold.
class RevisionController final : public QObject {
  Q_OBJECT

 public:
  RevisionController(const Workbench& bench, SequenceController& sequence);

 private:
  void chooseFile();
  void compareWith(const QString& file);
  void show(const QString& file, const QStringList& lines);
  Outcome expect(const ScriptCommands::Words& words) const;

  const Workbench& bench_;
  SequenceController& sequence_;
  QDialog* dialog_ = nullptr;  ///< owned by the window
  bool isSame_ = false;        ///< the last comparison has found no difference
  std::size_t holding_ = 0;    ///< steps that hold in the revision of the last comparison
};

/// The dialog with the result of a comparison. `file`: the other revision.
QDialog* makeRevisionDialog(const QString& file, const QStringList& lines, QWidget* parent);

}  // namespace glissade
