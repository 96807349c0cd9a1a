#include "widgets/sequence/times_view.h"

#include <QFormLayout>
#include <QLocale>
#include <QScrollArea>
#include <QVBoxLayout>

#include "engine/documents/line_chart.h"
#include "widgets/controls/window_language.h"
#include "widgets/sequence/plan_graph_view.h"

namespace glissade {
namespace {

constexpr int kMostStations = 50;

QString seconds(double value) { return TimesView::tr("%1 s").arg(QLocale().toString(value, 'f', 1)); }

QString sourceOf(const PlanTiming& timing) {
  if (timing.edited == 0) return TimesView::tr("The times are estimates and were not measured.");
  return TimesView::tr(
             "%1 of the %2 values of the table of times were edited. The others are estimates and were not measured.")
      .arg(timing.edited)
      .arg(workTimeRows().size());
}

QString summaryOf(const PlanTiming& timing) {
  QStringList lines;
  lines << TimesView::tr("One person: %1. Critical path: %2, the minimum, however many people.")
               .arg(seconds(timing.sum()), seconds(timing.chainSeconds()));
  if (timing.line) {
    lines << TimesView::tr("Cycle time %1, minimum %2. Utilization %3 %.")
                 .arg(seconds(timing.line->cycle), seconds(timing.line->least))
                 .arg(100.0 * timing.line->efficiency(), 0, 'f', 0);
  }
  lines << sourceOf(timing);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

TimesView::TimesView(QWidget* parent)
    : QDialog(parent),
      stations_(new QSpinBox(this)),
      summary_(new QLabel(this)),
      chart_(new QLabel(this)),
      pages_(new QTabWidget(this)),
      table_(new WorkTimesEditor(this)) {
  setWindowTitle(tr("Assembly times"));
  setObjectName(QStringLiteral("sequence-times"));
  stations_->setObjectName(QStringLiteral("times-stations"));
  stations_->setRange(1, kMostStations);
  stations_->setKeyboardTracking(false);
  stations_->setToolTip(tr("Stations of the line, one person each; the product passes them in order"));
  summary_->setObjectName(QStringLiteral("times-summary"));
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  pages_->setAccessibleName(windowTitle());
  pages_->addTab(makeChartPage(), tr("&Chart"));
  table_->setAutoFillBackground(true);
  pages_->addTab(table_, tr("&Table of times"));
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Stations"), stations_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(summary_);
  layout->addWidget(pages_, 1);
  resize(900, 600);
  connect(stations_, qOverload<int>(&QSpinBox::valueChanged), this, &TimesView::stationsChanged);
}

QWidget* TimesView::makeChartPage() {
  chart_->setAccessibleName(tr("A bar for each station with the numbers of its steps"));
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(chart_);
  scroll->setAccessibleName(windowTitle());
  scroll->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  scroll->setFrameShape(QFrame::NoFrame);
  return scroll;
}

void TimesView::setTiming(const std::optional<PlanTiming>& timing, const GraphColours& colours) {
  seconds_ = timing ? timing->sum() : 0.0;
  bars_ = !timing ? 0 : timing->line ? timing->line->load.size() : 1;
  summary_->setText(timing ? summaryOf(*timing) : tr("There is no assembly plan."));
  QImage image = timing
                     ? imageOfSvg(lineChartSvg(*timing, DocumentWords(windowLanguage()), colours), devicePixelRatioF())
                     : QImage();
  image.setDevicePixelRatio(devicePixelRatioF());
  chart_->setPixmap(QPixmap::fromImage(image));
  chart_->adjustSize();
}

}  // namespace glissade
