#pragma once

#include <QDialog>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>

#include "engine/study/plan_graph.h"
#include "engine/study/plan_timing.h"
#include "widgets/studies/work_times_editor.h"

namespace glissade {

/// How long an assembly plan takes people: the sum, the longest chain, and a division over as many stations as are
/// chosen, with a bar chart. A second page is the table of times that these follow from.
class TimesView final : public QDialog {
  Q_OBJECT

 public:
  explicit TimesView(QWidget* parent);

  /// Nothing: there is no plan.
  void setTiming(const std::optional<PlanTiming>& timing, const GraphColours& colours);
  /// Of the chart; 0: there is none.
  std::size_t shownBars() const { return bars_; }
  /// Of one person; 0: there is no plan.
  double shownSeconds() const { return seconds_; }
  WorkTimesEditor& table() { return *table_; }
  void showTable() { pages_->setCurrentWidget(table_); }
  /// 1: one person does all.
  int stations() const { return stations_->value(); }
  /// At least 1; what the box cannot hold becomes the nearest that it can.
  void setStations(int count) { stations_->setValue(count); }

 signals:
  void stationsChanged();

 private:
  QWidget* makeChartPage();

  QSpinBox* stations_;
  QLabel* summary_;
  QLabel* chart_;
  QTabWidget* pages_;
  WorkTimesEditor* table_;
  std::size_t bars_ = 0;
  double seconds_ = 0.0;
};

}  // namespace glissade
