#pragma once

#include <QPainter>
#include <QWidget>

#include <functional>

#include "widgets/panels/run_history.h"

namespace glissade {

/// Nodes, authority and clearance over the time of planning, one curve below the other. Hidden until a run has begun.
class RunCurves final : public QWidget {
  Q_OBJECT

 public:
  explicit RunCurves(QWidget* parent = nullptr);

  /// `run` is 0 before the first run.
  void add(std::uint64_t run, const RunSample& sample);
  const RunHistory& history() const { return history_; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Curve;
  Curve nodesCurve() const;
  Curve authorityCurve() const;
  Curve clearanceCurve() const;
  void paintCurve(QPainter& painter, const Curve& curve, double top) const;
  void paintTimes(QPainter& painter) const;
  QRectF plotBelow(double top) const;

  RunHistory history_;
};

}  // namespace glissade
