#pragma once

#include <QWidget>
#include <memory>

#include "engine/study/study_folder.h"
#include "engine/study/study_summary.h"
#include "engine/study/study_words.h"
#include "widgets/controls/action_catalogue.h"

class QLabel;
class QVBoxLayout;
class QTabWidget;
class QTextBrowser;
class QTreeWidget;

namespace glissade {

class PlotView;

/// Shows a study's results in a separate window: its cells with the paper's numbers, the plots of the report, the
/// findings, and the runs of the selected cell. A double click on a run asks to show it.
class StudyBrowser final : public QWidget {
  Q_OBJECT

 public:
  explicit StudyBrowser(QWidget* parent);
  ~StudyBrowser() override;

  void show(const StudyFolder& folder, const StudyResults& results);
  /// Null until a study is shown.
  const StudyFolder* folder() const { return folder_.get(); }
  const StudyResults& results() const { return results_; }

  /// False if there is no such cell (from 0).
  bool selectCell(int cell);
  /// The plot in front; null: the findings are in front.
  PlotView* plot() const;
  /// Puts buttons for a plot's actions under it.
  void addPlotActions(const ActionCatalogue& actions);
  /// Shows a message about the run that was shown.
  void setMessage(const QString& text);

 signals:
  /// Another plot, or another part of it, is shown.
  void plotChanged();
  void runRequested(const glissade::StudyRun& run);

 private:
  void fillCells();
  void fillPlots();
  void fillFindings();
  void fillRuns(int cell);
  void want();

  std::unique_ptr<StudyFolder> folder_;
  StudyResults results_;
  std::vector<CellSummary> summaries_;
  QLabel* heading_;
  QLabel* message_;
  QTreeWidget* cells_;
  QTreeWidget* runs_;
  QTextBrowser* findings_;
  QTabWidget* plots_;
  QVBoxLayout* plotsLayout_;
};

}  // namespace glissade
