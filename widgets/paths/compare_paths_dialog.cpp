#include "widgets/paths/compare_paths_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <numbers>

#include "widgets/controls/body_id_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/paths/clearance_curve.h"

namespace glissade {
namespace {

constexpr int kCurveHeight = 150;
constexpr int kColumnWidth = 230;

struct Figure {
  QString title;
  std::function<QString(const KeptPathRow&)> text;
  std::function<double(const KeptPathRow&)> less;  ///< the path with the least value is marked; empty: none
};

std::vector<Figure> figures() {
  const auto way = [](const KeptPathRow& row) { return Path{row.path->points, {}}; };
  return {
      {ComparePathsDialog::tr("Certificate"), [](const KeptPathRow& row) { return proofText(row.proof); }, {}},
      {ComparePathsDialog::tr("Strategy"),
       [](const KeptPathRow& row) { return strategyName(row.path->provenance.planner); },
       {}},
      {ComparePathsDialog::tr("Seed"),
       [](const KeptPathRow& row) {
         return row.path->provenance.planner.empty() ? QStringLiteral("–") : QString::number(row.path->provenance.seed);
       },
       {}},
      {ComparePathsDialog::tr("Smallest clearance"),
       [](const KeptPathRow& row) {
         return row.path->clearance < 0.0 ? QStringLiteral("–") : lengthText(row.path->clearance);
       },
       [](const KeptPathRow& row) { return -row.path->clearance; }},
      {ComparePathsDialog::tr("Certified clearance"),
       [](const KeptPathRow& row) { return lengthText(row.path->provedClearance); },
       {}},
      {ComparePathsDialog::tr("Required clearance"),
       [](const KeptPathRow& row) { return lengthText(row.path->requiredClearance); },
       {}},
      {ComparePathsDialog::tr("Length"), [way](const KeptPathRow& row) { return lengthText(way(row).length()); },
       [way](const KeptPathRow& row) { return way(row).length(); }},
      {ComparePathsDialog::tr("Turns"),
       [way](const KeptPathRow& row) {
         return QLocale().toString(way(row).rotation() * 180.0 / std::numbers::pi, 'f', 0) + QStringLiteral("°");
       },
       [way](const KeptPathRow& row) { return way(row).rotation(); }},
      {ComparePathsDialog::tr("Configurations"),
       [](const KeptPathRow& row) { return QString::number(row.path->points.size()); },
       [](const KeptPathRow& row) { return static_cast<double>(row.path->points.size()); }},
      {ComparePathsDialog::tr("Smoothed"),
       [](const KeptPathRow& row) {
         return row.path->smoothed ? ComparePathsDialog::tr("yes") : ComparePathsDialog::tr("no");
       },
       {}},
      {ComparePathsDialog::tr("Allowances"),
       [](const KeptPathRow& row) {
         QStringList lines;
         for (const auto& allowance : row.path->allowances) {
           const QString length = lengthText(allowance.allowance);
           lines << (allowance.hollow ? ComparePathsDialog::tr("accepted clash, %1").arg(length) : length) +
                        QStringLiteral(" · ") + toQString(allowance.body);
         }
         return lines.isEmpty() ? QStringLiteral("–") : lines.join(QLatin1Char('\n'));
       },
       {}},
  };
}

/// Makes the best figure of a row bold, unless all are equal.
void markBest(QTableWidget& table, int row, const Figure& figure, const std::vector<ComparedPath>& paths) {
  if (!figure.less) return;
  double best = figure.less(paths.front().row);
  double worst = best;
  for (const ComparedPath& path : paths) {
    best = std::min(best, figure.less(path.row));
    worst = std::max(worst, figure.less(path.row));
  }
  if (best == worst) return;
  for (std::size_t column = 0; column < paths.size(); ++column) {
    if (figure.less(paths[column].row) != best) continue;
    QTableWidgetItem* item = table.item(row, static_cast<int>(column));
    QFont font = item->font();
    font.setBold(true);
    item->setFont(font);
  }
}

void addCurves(QTableWidget& table, const std::vector<ComparedPath>& paths, const LoadedScenario& scenario) {
  QStringList bodies;
  for (const RigidBody& body : scenario.obstacles) bodies << QString::fromStdString(body.shown());
  const int row = table.rowCount();
  table.insertRow(row);
  table.setVerticalHeaderItem(row, new QTableWidgetItem(ComparePathsDialog::tr("Clearance along the path")));
  for (std::size_t column = 0; column < paths.size(); ++column) {
    if (!paths[column].profile) continue;
    auto* curve = new ClearanceCurve(&table);
    curve->setProfile(paths[column].profile, bodies, paths[column].row.path->requiredClearance);
    table.setCellWidget(row, static_cast<int>(column), curve);
  }
  table.setRowHeight(row, kCurveHeight);
  table.verticalHeader()->setStretchLastSection(true);
}

}  // namespace

ComparePathsDialog::ComparePathsDialog(const std::vector<ComparedPath>& paths, const LoadedScenario& scenario,
                                       QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Compare paths"));
  setObjectName(QStringLiteral("compare-paths"));
  auto* table = new QTableWidget(0, static_cast<int>(paths.size()), this);
  table->setAccessibleName(tr("Figures of the paths, side by side"));
  table->setTabKeyNavigation(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  QStringList names;
  for (const ComparedPath& path : paths) names << QString::fromStdString(path.row.path->name);
  table->setHorizontalHeaderLabels(names);
  table->horizontalHeader()->setMinimumSectionSize(kColumnWidth);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const Figure& figure : figures()) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setVerticalHeaderItem(row, new QTableWidgetItem(figure.title));
    for (std::size_t column = 0; column < paths.size(); ++column) {
      table->setItem(row, static_cast<int>(column), new QTableWidgetItem(figure.text(paths[column].row)));
    }
    markBest(*table, row, figure, paths);
  }
  table->resizeRowsToContents();
  addCurves(*table, paths, scenario);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(table, 1);
  column->addWidget(buttons);
  resize(std::min(1100, 240 + kColumnWidth * static_cast<int>(paths.size())), 560);
}

}  // namespace glissade
