#pragma once

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

}  // namespace glissade
