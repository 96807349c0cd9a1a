#include "widgets/headset/headset_page.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/flow_layout.h"
#include "widgets/run/strategy_use.h"

namespace glissade {
namespace {

constexpr int kIconPixels = 28;
constexpr int kMostViews = 6;      ///< named views on the sheet, those that were saved last
constexpr int kLongestView = 260;  ///< pixels of the name of a view

/// Sizes of the controls allow for the tremor of a pointing hand: half a degree, which is 13 pixels.
const char* const kPointedAt =
    "#headset-page QWidget { font-size: %1px; }"
    "#headset-page { border: 3px solid palette(highlight); }"
    "#headset-page QToolButton { padding: 9px 14px; border: 2px solid palette(mid); border-radius: 8px; "
    "background: palette(button); }"
    "#headset-page QToolButton:hover { border: 2px solid palette(highlight); }"
    "#headset-page QToolButton:pressed { background: palette(midlight); }"
    "#headset-page QToolButton:checked { background: palette(highlight); color: white; }"
    "#headset-page QToolButton#tuning { padding: 2px 10px; }"
    "#headset-page QSlider { min-height: 40px; }"
    "#headset-page QSlider::groove:horizontal { height: 10px; border-radius: 5px; background: palette(mid); }"
    "#headset-page QSlider::sub-page:horizontal { height: 10px; border-radius: 5px; background: palette(highlight); }"
    "#headset-page QSlider::handle:horizontal { width: 32px; margin: -11px 0px; border-radius: 16px; "
    "background: palette(button); border: 3px solid palette(highlight); }"
    "#headset-page QLabel#headset-refused, #headset-page QLabel#headset-asked { font-weight: 600; }"
    "#headset-page QWidget#headset-question { background: palette(window); border: 3px solid palette(highlight); }"
    "#headset-page QDoubleSpinBox { border: none; background: transparent; }";

QLabel* makeLabel(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

/// Makes buttons that are large enough for hands, in as many rows as their texts need.
QLayout* makeButtons(const ActionCatalogue& actions, const std::vector<const char*>& ids, QWidget* parent) {
  QLayout* row = makeActionFlow(actions, ids, parent);
  row->setSpacing(12);
  for (int i = 0; i < row->count(); ++i) {
    auto* button = qobject_cast<QToolButton*>(row->itemAt(i)->widget());
    if (button == nullptr) continue;
    button->setIconSize(QSize(kIconPixels, kIconPixels));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(false);
  }
  return row;
}

/// Removes all widgets of the layout. They are deleted later, because one may have been pressed.
void clearLayout(QLayout& layout) {
  while (QLayoutItem* item = layout.takeAt(0)) {
    item->widget()->deleteLater();
    item->widget()->hide();
    delete item;
  }
}

void addLine(QVBoxLayout& layout) {
  auto* line = new QFrame;
  line->setFrameShape(QFrame::HLine);
  line->setForegroundRole(QPalette::Mid);
  layout.addWidget(line);
}

}  // namespace

HeadsetPage::HeadsetPage(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent),
      sheets_(new QStackedWidget(this)),
      strategy_(makeLabel("headset-strategy", this)),
      strategies_(new QButtonGroup(this)),
      status_(makeLabel("headset-status", this)),
      sliders_(
          new ParameterSliders({ParameterId::Alpha, ParameterId::ContactSamples, ParameterId::ContactDistance}, this)),
      views_(new FlowLayout),
      step_(makeLabel("headset-step", this)),
      what_(makeLabel("headset-refused", this)),
      why_(makeLabel("headset-reason", this)),
      question_(new QWidget(this)),
      asked_(makeLabel("headset-asked", question_)),
      details_(makeLabel("headset-details", question_)),
      answers_(new FlowLayout) {
  setObjectName(QStringLiteral("headset-page"));
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Panel in the headset"));
  setStyleSheet(QString::fromLatin1(kPointedAt).arg(kTextPixels));
  setFixedSize(kWidth, kHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(28, 22, 28, 22);
  layout->setSpacing(18);
  layout->addLayout(makeHead());
  addLine(*layout);
  sheets_->addWidget(makeRunSheet(actions));
  sheets_->addWidget(makeSequenceSheet(actions));
  sheets_->addWidget(makeSceneSheet(actions));
  layout->addWidget(sheets_, 1);
  layout->addLayout(makeRefusal());
  makeQuestion();
  setStep({});
  setRefusal({}, {});
  ask({}, {}, {});
}

/// Makes the buttons of the sheets, and the state of the run beside them.
QLayout* HeadsetPage::makeHead() {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  auto* buttons = new QButtonGroup(this);
  const std::vector<std::pair<const char*, QString>> sheets{
      {"headset-run", tr("Run")}, {"headset-sequence", tr("Sequence")}, {"headset-scene", tr("Scene")}};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(sheets[i].first));
    button->setText(sheets[i].second);
    button->setCheckable(true);
    button->setChecked(i == 0);
    buttons->addButton(button);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, i] { sheets_->setCurrentIndex(static_cast<int>(i)); });
  }
  row->addWidget(status_, 1);
  return row;
}

QWidget* HeadsetPage::makeRunSheet(const ActionCatalogue& actions) {
  auto* sheet = new QWidget;
  auto* column = new QVBoxLayout(sheet);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(18);
  column->addLayout(makeStrategies());
  column->addLayout(
      makeButtons(actions, {"run.start", "run.stop", "path.play", "paths.keep", "edit.undo", "edit.redo"}, sheet));
  for (ParameterSlider* slider : sliders_->all()) slider->setNumberReadOnly();
  connect(sliders_, &ParameterSliders::commanded, this, &HeadsetPage::commanded);
  column->addWidget(sliders_);
  column->addStretch();
  return sheet;
}

QWidget* HeadsetPage::makeSceneSheet(const ActionCatalogue& actions) {
  auto* sheet = new QWidget;
  auto* column = new QVBoxLayout(sheet);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(18);
  const std::vector<std::vector<const char*>> groups{
      {"headset.on-table", "headset.to-place", "headset.leave"},
      {"display.shaded-edges", "display.shaded", "display.see-through", "display.wireframe"},
      {"headset.select", "body.hide", "body.isolate", "body.show-all"},
      {"headset.section", "section.remove-all", "headset.measure", "measure.clear"}};
  for (const auto& group : groups) {
    column->addLayout(makeButtons(actions, group, sheet));
    if (&group == &groups.front()) column->addLayout(views_);
    if (&group != &groups.back()) addLine(*column);
  }
  column->addStretch();
  return sheet;
}

/// The question lies over the whole page, and keeps hands from its controls.
void HeadsetPage::makeQuestion() {
  question_->setObjectName(QStringLiteral("headset-question"));
  question_->setAttribute(Qt::WA_StyledBackground);
  question_->setGeometry(rect());
  auto* column = new QVBoxLayout(question_);
  column->setContentsMargins(56, 44, 56, 44);
  column->setSpacing(24);
  column->addStretch();
  column->addWidget(asked_);
  column->addWidget(details_);
  answers_->setSpacing(18);
  column->addLayout(answers_);
  column->addStretch();
}

/// Makes a button for each main strategy. The name of another strategy is shown above them.
QLayout* HeadsetPage::makeStrategies() {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(strategy_, 1);
  const PlannerRegistry planners = makePlannerRegistry();
  for (const PlannerEntry& entry : planners.entries()) {
    if (!isMainStrategy(entry.id)) continue;
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromStdString(entry.id));
    button->setText(engineText(entry.label));
    button->setToolTip(engineText(entry.description));
    button->setCheckable(true);
    strategies_->addButton(button);
    row->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, id = entry.id] { emit commanded(command::SetPlanner{id}); });
  }
  return row;
}

QWidget* HeadsetPage::makeSequenceSheet(const ActionCatalogue& actions) {
  auto* sheet = new QWidget;
  auto* column = new QVBoxLayout(sheet);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(18);
  column->addLayout(makeButtons(actions, {"sequence.plan", "sequence.play", "headset.instruction"}, sheet));
  column->addWidget(step_);
  column->addLayout(makeButtons(actions, {"sequence.previous-step", "sequence.next-step"}, sheet));
  column->addStretch();
  return sheet;
}

QLayout* HeadsetPage::makeRefusal() {
  auto* column = new QVBoxLayout;
  what_->setForegroundRole(QPalette::BrightText);
  column->addWidget(what_);
  column->addWidget(why_);
  return column;
}

void HeadsetPage::setScenario(const LoadedScenario& scenario) { sliders_->setScenario(scenario); }

void HeadsetPage::setSnapshot(const SessionSnapshot& snapshot, const std::string& deviceId, const QString& status) {
  const auto chosen = QString::fromStdString(snapshot.plannerId);
  strategies_->setExclusive(false);
  bool isMain = false;
  for (QAbstractButton* button : strategies_->buttons()) {
    button->setChecked(button->objectName() == chosen);
    isMain = isMain || button->isChecked();
  }
  strategies_->setExclusive(true);
  const PlannerRegistry planners = makePlannerRegistry();
  const PlannerEntry* entry = planners.find(snapshot.plannerId);
  strategy_->setText(isMain || entry == nullptr ? tr("Strategy") : tr("Strategy: %1").arg(engineText(entry->label)));
  status_->setText(status);
  sliders_->setSnapshot(snapshot);
  if (entry != nullptr) sliders_->showOnly(parametersInUse(*entry, deviceId));
}

void HeadsetPage::setReplayed(bool replayed) {
  sliders_->setEnabled(!replayed);
  for (QAbstractButton* button : strategies_->buttons()) button->setEnabled(!replayed);
}

void HeadsetPage::setStep(const QString& place) { step_->setText(place.isEmpty() ? tr("No sequence yet") : place); }

void HeadsetPage::setRefusal(const QString& what, const QString& why) {
  what_->setText(what);
  why_->setText(why);
  what_->setVisible(!what.isEmpty());
  why_->setVisible(!why.isEmpty());
}

void HeadsetPage::setViews(const QStringList& names) {
  clearLayout(*views_);
  const int first = std::max(0, names.size() - kMostViews);
  for (int i = first; i < names.size(); ++i) {
    auto* button = new QToolButton(sheets_);
    button->ensurePolished();
    button->setText(button->fontMetrics().elidedText(names[i], Qt::ElideRight, kLongestView));
    button->setToolTip(tr("Stand where the camera of %1 is").arg(names[i]));
    button->setAccessibleName(button->toolTip());
    views_->addWidget(button);
    connect(button, &QToolButton::clicked, this, [this, i] { emit viewChosen(i); });
  }
}

void HeadsetPage::ask(const QString& what, const QString& why, const QStringList& answers) {
  asked_->setText(what);
  details_->setText(why);
  details_->setVisible(!why.isEmpty());
  clearLayout(*answers_);
  for (int i = 0; i < answers.size(); ++i) {
    auto* button = new QToolButton(question_);
    button->setText(answers[i]);
    answers_->addWidget(button);
    button->show();
    connect(button, &QToolButton::clicked, this, [this, i] { emit answered(i); });
  }
  question_->setVisible(!answers.isEmpty());
  question_->raise();
}

}  // namespace glissade
