#pragma once

#include <QStringList>

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

  const Workbench& bench_;
  SequenceController& sequence_;
  QDialog* dialog_ = nullptr;  ///< owned by the window
  QStringList lines_{};        ///< the last result
};

/// The dialog with the result of a comparison. `file`: the other revision.
QDialog* makeRevisionDialog(const QString& file, const QStringList& lines, QWidget* parent);

}  // namespace glissade
