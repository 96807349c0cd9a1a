#pragma once

#include <QDialog>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>

#include "engine/documents/plan_graph.h"
#include "engine/documents/plan_timing.h"
#include "widgets/sequence/work_times_editor.h"

namespace glissade {

/// The work times of an assembly plan: the sum, the longest chain, and a division over a number of stations, with a bar
/// chart. A second page is the table of times from which they follow.
class TimesView final : public QDialog {
  Q_OBJECT

 public:
  explicit TimesView(QWidget* parent);

  /// Sets the times; nothing: there is no plan.
  void setTiming(const std::optional<PlanTiming>& timing, const GraphColours& colours);
  /// Number of bars of the chart; 0: there is no chart.
  std::size_t shownBars() const { return bars_; }
  /// Seconds for one person; 0: there is no plan.
  double shownSeconds() const { return seconds_; }
  WorkTimesEditor& table() { return *table_; }
  void showTable() { pages_->setCurrentWidget(table_); }
  /// Number of stations; 1: one person does all.
  int stations() const { return stations_->value(); }
  /// Sets the number of stations, limited to the range of the box (at least 1).
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
