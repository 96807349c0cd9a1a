#include "widgets/studies/study_browser.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTextBrowser>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "engine/study/cell_value.h"
#include "engine/study/finding_check.h"
#include "engine/study/study_plots.h"
#include "engine/study/study_words.h"
#include "widgets/controls/window_language.h"
#include "widgets/plots/plot_view.h"

namespace glissade {
namespace {

constexpr int kSeedRole = Qt::UserRole;

QString shownText(const std::string& words) { return QString::fromStdString(words); }

QTreeWidget* makeList(const QString& name, const QStringList& columns, QWidget* parent) {
  auto* list = new QTreeWidget(parent);
  list->setObjectName(name);
  list->setRootIsDecorated(false);
  list->setAlternatingRowColors(true);
  list->setUniformRowHeights(true);
  list->setHeaderLabels(columns);
  list->header()->setStretchLastSection(false);
  return list;
}

void addRow(QTreeWidget* list, const QStringList& cells, int firstNumber) {
  auto* item = new QTreeWidgetItem(list, cells);
  for (int i = firstNumber; i < cells.size(); ++i) item->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
}

void fitColumns(QTreeWidget* list) {
  for (int i = 0; i < list->columnCount(); ++i) {
    list->resizeColumnToContents(i);
    list->setColumnWidth(i, list->columnWidth(i) + 8);
  }
}

QString spread(const std::optional<CellValue>& value) {
  if (!value) return QStringLiteral("–");
  return QStringLiteral("%1  (%2 – %3)")
      .arg(shownText(shortNumber(value->value)), shownText(shortNumber(value->low)),
           shownText(shortNumber(value->high)));
}

QString verdictText(Verdict verdict) {
  if (verdict == Verdict::Holds) return StudyBrowser::tr("Holds");
  return verdict == Verdict::Refuted ? StudyBrowser::tr("Does not hold") : StudyBrowser::tr("Open");
}

QString numberText(const RunResult& result, const char* column) {
  for (std::size_t i = 0; i < kResultColumnCount; ++i) {
    if (resultColumns()[i].name == column && result.numbers[i]) return shownText(shortNumber(*result.numbers[i]));
  }
  return QStringLiteral("–");
}

}  // namespace

StudyBrowser::StudyBrowser(QWidget* parent)
    : QWidget(parent, Qt::Window),
      heading_(new QLabel(this)),
      message_(new QLabel(this)),
      cells_(makeList(QStringLiteral("cells"), {}, this)),
      runs_(makeList(QStringLiteral("runs"),
                     {tr("Seed"), tr("Ending"), tr("Virtual s"), tr("Nodes"), tr("Edges"), tr("Random")}, this)),
      findings_(new QTextBrowser(this)),
      plots_(new QTabWidget(this)) {
  setWindowTitle(tr("Study"));
  cells_->setAccessibleName(tr("Cells of the study"));
  runs_->setAccessibleName(tr("Runs of the cell"));
  findings_->setAccessibleName(tr("Findings"));
  plots_->setAccessibleName(tr("Plots"));
  heading_->setWordWrap(true);
  message_->setWordWrap(true);
  findings_->setFrameShape(QFrame::NoFrame);
  plots_->setDocumentMode(true);
  plots_->setUsesScrollButtons(true);
  auto* open = new QPushButton(tr("&Show this run"), this);
  open->setToolTip(
      tr("Open the scenario with the strategy, operator, parameters and seed of the chosen run, and run it"));

  auto* runsPart = new QWidget(this);
  auto* runsLayout = new QVBoxLayout(runsPart);
  runsLayout->setContentsMargins(0, 0, 0, 0);
  runsLayout->addWidget(runs_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(message_, 1);
  row->addWidget(open);
  runsLayout->addLayout(row);
  auto* left = new QSplitter(Qt::Vertical, this);
  left->addWidget(cells_);
  left->addWidget(runsPart);
  left->setStretchFactor(0, 3);
  left->setStretchFactor(1, 2);
  auto* all = new QSplitter(Qt::Horizontal, this);
  all->addWidget(left);
  auto* right = new QWidget(this);
  plotsLayout_ = new QVBoxLayout(right);
  plotsLayout_->setContentsMargins(0, 0, 0, 0);
  plotsLayout_->addWidget(plots_, 1);
  all->addWidget(right);
  all->setStretchFactor(0, 1);
  all->setStretchFactor(1, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(heading_);
  layout->addWidget(all, 1);

  connect(cells_, &QTreeWidget::currentItemChanged, this,
          [this](QTreeWidgetItem* item) { fillRuns(cells_->indexOfTopLevelItem(item)); });
  connect(plots_, &QTabWidget::currentChanged, this, &StudyBrowser::plotChanged);
  connect(runs_, &QTreeWidget::itemActivated, this, [this] { want(); });
  connect(open, &QPushButton::clicked, this, [this] { want(); });
}

StudyBrowser::~StudyBrowser() { plots_->disconnect(this); }

void StudyBrowser::show(const StudyFolder& folder, const StudyResults& results) {
  folder_ = std::make_unique<StudyFolder>(folder);
  results_ = results;
  const Study& study = folder_->plan().study;
  summaries_ = summarise(study, results_);
  setWindowTitle(tr("%1 — study").arg(shownText(study.heading.name)));
  heading_->setText(QStringLiteral("<b>%1</b><br>%2")
                        .arg(shownText(StudyWords(windowLanguage())(study.heading.title)).toHtmlEscaped(),
                             shownText(study.heading.citation).toHtmlEscaped()));
  fillCells();
  fillPlots();
  fillFindings();
  selectCell(0);
  setMessage(tr("Double-click a run to see it again, from its seed."));
  QWidget::show();
  raise();
}

void StudyBrowser::fillCells() {
  const StudyWords words(windowLanguage());
  const Study& study = folder_->plan().study;
  QStringList titles{tr("Row"), tr("Solved"), tr("Success, 95 %")};
  for (const PaperColumn& column : study.heading.paper) {
    titles << tr("%1, paper").arg(shownText(words(column.title)));
    if (column.quantity.measure != "success_rate") titles << tr("%1, ours").arg(shownText(words(column.title)));
  }
  cells_->clear();
  cells_->setColumnCount(titles.size());
  cells_->setHeaderLabels(titles);
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    const CellSummary& summary = summaries_[i];
    QStringList row{shownText(study.cells[i].label), tr("%1 of %2").arg(summary.solved()).arg(summary.runs),
                    shownText(percent(summary.success.low) + " – " + percent(summary.success.high))};
    for (const PaperColumn& column : study.heading.paper) {
      row << shownText(paperText(study.cells[i], column));
      if (column.quantity.measure != "success_rate") row << spread(valueOf(summary, column.quantity));
    }
    addRow(cells_, row, 1);
  }
  fitColumns(cells_);
}

void StudyBrowser::fillPlots() {
  while (plots_->count() > 0) {
    QWidget* page = plots_->widget(0);
    plots_->removeTab(0);
    if (page != findings_) delete page;
  }
  for (const Plot& plot : plotsOf(folder_->plan().study, summaries_, StudyWords(windowLanguage()))) {
    auto* view = new PlotView(plot, plots_);
    connect(view, &PlotView::cellPicked, this, [this](int cell) { selectCell(cell); });
    connect(view, &PlotView::zoomChanged, this, &StudyBrowser::plotChanged);
    const int tab = plots_->addTab(view, QString::fromStdString(StudyWords(windowLanguage())(plot.y.title())));
    plots_->setTabToolTip(tab, shownText(plot.title + ". " + plot.caption));
  }
}

void StudyBrowser::fillFindings() {
  const Study& study = folder_->plan().study;
  const StudyWords words(windowLanguage());
  QString html;
  for (const Finding& finding : study.heading.findings) {
    const CheckedFinding checked = checkFinding(finding, study, summaries_, words);
    html += QStringLiteral("<p>%1<br><b>%2</b>, %3. %4</p>")
                .arg(shownText(words(finding.text)).toHtmlEscaped(), verdictText(checked.verdict),
                     tr("%1 of %2 pairs").arg(checked.agreeing).arg(checked.compared),
                     shownText(checked.numbers).toHtmlEscaped());
  }
  findings_->setHtml(html.isEmpty() ? tr("The study declares no findings.") : html);
  plots_->addTab(findings_, tr("Findings"));
}

void StudyBrowser::fillRuns(int cell) {
  runs_->clear();
  for (const auto& [run, outcome] : results_) {
    if (static_cast<int>(run.cell) != cell) continue;
    const RunResult& result = outcome.result;
    addRow(runs_,
           {QString::number(run.seed),
            shownText(StudyWords(windowLanguage())(std::string(kRunStatusNames.of(result.status)))),
            numberText(result, "virtual_s"), numberText(result, "nodes"), numberText(result, "edges"),
            numberText(result, "random_configurations")},
           2);
    runs_->topLevelItem(runs_->topLevelItemCount() - 1)->setData(0, kSeedRole, QVariant::fromValue(quint64(run.seed)));
  }
  fitColumns(runs_);
  if (runs_->topLevelItemCount() > 0) runs_->setCurrentItem(runs_->topLevelItem(0));
}

bool StudyBrowser::selectCell(int cell) {
  QTreeWidgetItem* item = cells_->topLevelItem(cell);
  if (item == nullptr) return false;
  cells_->setCurrentItem(item);
  cells_->scrollToItem(item);
  return true;
}

PlotView* StudyBrowser::plot() const { return qobject_cast<PlotView*>(plots_->currentWidget()); }

void StudyBrowser::addPlotActions(const ActionCatalogue& actions) {
  const std::vector<const char*> ids{"study.zoom-out", "study.copy-plot", "study.save-plot"};
  plotsLayout_->addLayout(makeActionFlow(actions, ids, this));
  for (const char* id : ids) addAction(actions[QLatin1String(id)]);
}

void StudyBrowser::setMessage(const QString& text) { message_->setText(text); }

void StudyBrowser::want() {
  const QTreeWidgetItem* item = runs_->currentItem();
  const int cell = cells_->indexOfTopLevelItem(cells_->currentItem());
  if (item == nullptr || cell < 0) return;
  emit runRequested({static_cast<std::size_t>(cell), item->data(0, kSeedRole).toULongLong()});
}

}  // namespace glissade
