#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <vector>

#include "engine/sequence/work_times.h"

namespace glissade {

/// The rows of a table of work times: name, value, unit, default. Values that differ from their defaults are bold. What
/// a person writes is told; the rows show only what they are given.
class WorkTimeTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit WorkTimeTable(QWidget* parent);

  void setTimes(const WorkTimes& times);
  /// Of workTimeRows(), ascending.
  std::vector<std::size_t> selectedTimes() const;
  /// As a person writes it into the value of this row.
  void write(std::size_t row, const QString& text);

 signals:
  void written(std::size_t row, const QString& text);

 private:
  void addRow(int row, const WorkTimeRow& time);
};

/// A table of work times that a person edits, reads from a file and saves. The owner keeps the table and its earlier
/// states; this shows what it is given.
class WorkTimesEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit WorkTimesEditor(QWidget* parent);

  void setTimes(const WorkTimes& times);
  const WorkTimes& times() const { return times_; }
  void setCanUndo(bool can) { undo_->setEnabled(can); }
  void setCanRedo(bool can) { redo_->setEnabled(can); }
  /// As a person writes it into the value of this row.
  void write(std::size_t row, const QString& text) { table_->write(row, text); }
  /// Why the last value was not taken; empty: it was.
  QString trouble() const { return trouble_->text(); }

 signals:
  /// A person wants this table.
  void edited(const glissade::WorkTimes& times);
  void undoAsked();
  void redoAsked();
  void openAsked();
  void saveAsked();

 private:
  QPushButton* addButton(const char* id, const QString& text, const QString& tip);
  void makeButtons();
  void take(std::size_t row, const QString& text);
  void refuse(const WorkTimeRow& row, const QString& text, const std::string& reason);
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
