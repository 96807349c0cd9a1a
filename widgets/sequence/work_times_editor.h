#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <vector>

#include "engine/base/message.h"
#include "engine/sequence/work_times.h"

namespace glissade {

/// The rows of a table of work times: name, value, unit, default. Values that differ from their defaults are bold. A
/// person's input is announced and not kept; setTimes() changes the rows.
class WorkTimeTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit WorkTimeTable(QWidget* parent);

  void setTimes(const WorkTimes& times);
  /// Selected indices of workTimeRows(), ascending.
  std::vector<std::size_t> selectedTimes() const;
  /// Writes the text into the value of this row, as a person does.
  void write(std::size_t row, const QString& text);

 signals:
  void written(std::size_t row, const QString& text);

 private:
  void addRow(int row, const WorkTimeRow& time);
};

/// A table of work times that a person edits, reads from a file and saves. The owner keeps the table and its earlier
/// states; the editor shows the table that it is given.
class WorkTimesEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit WorkTimesEditor(QWidget* parent);

  void setTimes(const WorkTimes& times);
  const WorkTimes& times() const { return times_; }
  void setCanUndo(bool can) { undo_->setEnabled(can); }
  void setCanRedo(bool can) { redo_->setEnabled(can); }
  /// Writes the text into the value of this row, as a person does.
  void write(std::size_t row, const QString& text) { table_->write(row, text); }
  /// The reason why the last value was refused; empty: it was accepted.
  QString trouble() const { return trouble_->text(); }

 signals:
  /// A person asks for this table.
  void edited(const glissade::WorkTimes& times);
  void undoRequested();
  void redoRequested();
  void openRequested();
  void saveRequested();

 private:
  QPushButton* addButton(const char* id, const QString& text, const QString& tip);
  void makeButtons();
  void take(std::size_t row, const QString& text);
  void refuse(const WorkTimeRow& row, const QString& text, const Message& reason);
  void reset();
  void enableButtons();

  WorkTimes times_;
  WorkTimeTable* table_;
  QLabel* count_;
  QLabel* trouble_;
  QPushButton* reset_ = nullptr;
  QPushButton* resetAll_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* redo_ = nullptr;
};

}  // namespace glissade
