#pragma once

#include <QFormLayout>
#include <QLabel>
#include <QWidget>

#include <optional>

#include "engine/scenario/scenario.h"
#include "engine/session/session.h"
#include "widgets/panels/author_bar.h"
#include "widgets/panels/run_curves.h"

namespace glissade {

/// Live figures of the run, and the nearest obstacle.
class CountsPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit CountsPanel(QWidget* parent = nullptr);

  void setSnapshot(const SessionSnapshot& snapshot, const LoadedScenario& scenario);

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
  QLabel* pace_;
  QLabel* mode_;
  QLabel* nearest_;
  QLabel* distance_;
  QLabel* hand_;                         ///< what came of what the hand has shown
  std::optional<double> shownDistance_;  ///< metres; none: not known
};

}  // namespace glissade
