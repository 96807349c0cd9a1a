#include "widgets/studies/times_view.h"

#include <QFormLayout>
#include <QScrollArea>
#include <QVBoxLayout>

#include "engine/study/line_chart.h"
#include "widgets/commands/window_language.h"
#include "widgets/studies/plan_graph_view.h"

namespace glissade {
namespace {

constexpr int kMostStations = 50;

QString seconds(double value) { return TimesView::tr("%1 s").arg(value, 0, 'f', 1); }

QString summaryOf(const PlanTiming& timing) {
  QStringList lines;
  lines << TimesView::tr("One person needs %1. The longest chain of steps takes %2: no number of people is faster.")
               .arg(seconds(timing.sum()), seconds(timing.chainSeconds()));
  if (timing.line) {
    lines << TimesView::tr(
                 "A product leaves the line every %1. No division is faster than %2. People work %3 % of "
                 "the time.")
                 .arg(seconds(timing.line->cycle), seconds(timing.line->least))
                 .arg(100.0 * timing.line->efficiency(), 0, 'f', 0);
  }
  lines << TimesView::tr("The times are estimates and were not measured.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

TimesView::TimesView(QWidget* parent)
    : QDialog(parent), stations_(new QSpinBox(this)), summary_(new QLabel(this)), chart_(new QLabel(this)) {
  setWindowTitle(tr("Times of the assembly"));
  setObjectName(QStringLiteral("sequence-times"));
  stations_->setObjectName(QStringLiteral("times-stations"));
  stations_->setRange(1, kMostStations);
  stations_->setKeyboardTracking(false);
  stations_->setToolTip(tr("Stations of the line, one person each; the product passes them in order"));
  summary_->setObjectName(QStringLiteral("times-summary"));
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  chart_->setAccessibleName(tr("A bar for each station with the numbers of its steps"));
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(chart_);
  scroll->setAccessibleName(windowTitle());
  scroll->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
  form->addRow(tr("&Stations"), stations_);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(summary_);
  layout->addWidget(scroll, 1);
  resize(900, 420);
  connect(stations_, qOverload<int>(&QSpinBox::valueChanged), this, &TimesView::stationsChanged);
}

void TimesView::setTiming(const std::optional<PlanTiming>& timing, const GraphColours& colours) {
  bars_ = !timing ? 0 : timing->line ? timing->line->load.size() : 1;
  summary_->setText(timing ? summaryOf(*timing) : tr("There is no assembly plan."));
  QImage image =
      timing ? imageOfSvg(lineChartSvg(*timing, StudyWords(windowLanguage()), colours), devicePixelRatioF()) : QImage();
  image.setDevicePixelRatio(devicePixelRatioF());
  chart_->setPixmap(QPixmap::fromImage(image));
  chart_->adjustSize();
}

}  // namespace glissade
