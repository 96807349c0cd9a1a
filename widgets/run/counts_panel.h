#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QPainter>
#include <QWidget>

#include <functional>
#include <optional>

#include "engine/files/scenario.h"
#include "engine/session/session.h"
#include "widgets/controls/author_bar.h"
#include "widgets/document/session_bridge.h"
#include "widgets/run/run_history.h"

namespace glissade {

/// Curves of nodes, authority and clearance over the time of planning, one below the other. Hidden until a run has
/// begun.
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

/// Live figures of the run, and the nearest obstacle.
class CountsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit CountsPanel(QWidget* parent = nullptr);

  /// Shows the numbers of a paper beside those of the run, as HTML; empty: none.
  void setComparison(const QString& html);
  /// In lockstep no processor time is shown, because it differs from run to run.
  void setSnapshot(const SessionSnapshot& snapshot, const LoadedScenario& scenario, SessionClock clock);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  static QString handText(const HandReport& hand, bool found);
  void showDistance();
  QLabel* addRow(const QString& label, const QString& tip);

  QFormLayout* layout_;
  RunCurves* curves_;
  QLabel* iterations_;
  QLabel* nodes_;
  AuthorBar* authors_;
  QLabel* edges_;
  QLabel* random_;
  QLabel* operator_;
  QLabel* contact_;
  QLabel* time_;
  QLabel* duration_;
  QLabel* pace_;
  QLabel* mode_;
  QLabel* nearest_;
  QLabel* distance_;
  QLabel* comparison_;
  QLabel* hand_;                         ///< result of the motions that the hand has shown
  std::optional<double> shownDistance_;  ///< metres; none: not known
};

}  // namespace glissade
