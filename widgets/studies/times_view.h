#pragma once

#include <QDialog>
#include <QLabel>
#include <QSpinBox>

#include "engine/study/plan_graph.h"
#include "engine/study/plan_timing.h"

namespace glissade {

/// How long an assembly plan takes people: the sum, the longest chain, and a division over as many stations as are
/// chosen, with a bar chart.
class TimesView final : public QDialog {
  Q_OBJECT

 public:
  explicit TimesView(QWidget* parent);

  /// Nothing: there is no plan.
  void setTiming(const std::optional<PlanTiming>& timing, const GraphColours& colours);
  /// Of the chart; 0: there is none.
  std::size_t shownBars() const { return bars_; }
  /// 1: one person does all.
  int stations() const { return stations_->value(); }
  /// At least 1; what the box cannot hold becomes the nearest that it can.
  void setStations(int count) { stations_->setValue(count); }

 signals:
  void stationsChanged();

 private:
  QSpinBox* stations_;
  QLabel* summary_;
  QLabel* chart_;
  std::size_t bars_ = 0;
};

}  // namespace glissade
