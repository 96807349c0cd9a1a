#include "widgets/devices/head_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include <numbers>

namespace glissade {
namespace {

constexpr int kHeadRefresh = 33;  ///< ms
constexpr int kValueWidth = 88;
constexpr double kCentimetre = 0.01;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMillisecond = 1e-3;

/// The value in centimetres or degrees, as trackers show them.
QString valueText(double value, std::size_t axis) {
  const bool isLength = axis < 3;
  const QString number = QLocale().toString(value / (isLength ? kCentimetre : kDegree), 'f', 1);
  return isLength ? HeadDialog::tr("%1 cm").arg(number) : QStringLiteral("%1°").arg(number);
}

std::array<double, 6> numbersOf(const HeadMotion& motion) {
  const Eigen::Vector3d turns = motion.turn.toRotationMatrix().eulerAngles(1, 0, 2);
  return {motion.shift.x(), motion.shift.y(), motion.shift.z(), turns[0], turns[1], turns[2]};
}

}  // namespace

HeadDialog::HeadDialog(const HeadPreferences& present, std::function<HeadState()> state, QWidget* parent)
    : QDialog(parent),
      state_(std::move(state)),
      port_(new QSpinBox(this)),
      fromAnywhere_(new QCheckBox(tr("Receive from &other machines, too"), this)),
      delay_(new QSpinBox(this)),
      delayNow_(new QLabel(this)),
      stateText_(new QLabel(this)),
      trouble_(new QLabel(this)) {
  setObjectName(QStringLiteral("head-dialog"));
  setWindowTitle(tr("Head tracker"));
  stateText_->setObjectName(QStringLiteral("head-state"));
  auto* rest = new QPushButton(tr("&I sit straight before the screen"), this);
  rest->setToolTip(tr("What the tracker sends now is the head at rest: press it while you look at the middle"));
  rest->setAutoDefault(false);
  auto* reset = new QPushButton(tr("&Reset"), this);
  reset->setToolTip(tr("Use the original axes, signs, delay and port again"));
  reset->setAutoDefault(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  buttons->addButton(reset, QDialogButtonBox::ResetRole);
  trouble_->hide();
  auto* column = new QVBoxLayout(this);
  column->addLayout(makeSocket());
  column->addWidget(stateText_);
  column->addLayout(makeAxes());
  column->addWidget(rest, 0, Qt::AlignLeft);
  column->addLayout(makeDelay());
  column->addWidget(trouble_);
  column->addStretch();
  column->addWidget(buttons);
  setPreferences(present);
  connect(rest, &QPushButton::clicked, this, &HeadDialog::restRequested);
  connect(reset, &QPushButton::clicked, this, [this] {
    setPreferences({});
    announce();
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  timer_.setInterval(kHeadRefresh);
  connect(&timer_, &QTimer::timeout, this, &HeadDialog::refresh);
}

QLayout* HeadDialog::makeSocket() {
  port_->setRange(1, 65535);
  fromAnywhere_->setToolTip(tr("Otherwise only programs of this machine can move the view"));
  auto* label = new QLabel(tr("&Port"), this);
  label->setBuddy(port_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(port_);
  row->addWidget(fromAnywhere_);
  row->addStretch();
  connect(port_, QOverload<int>::of(&QSpinBox::valueChanged), this, &HeadDialog::announce);
  connect(fromAnywhere_, &QCheckBox::toggled, this, &HeadDialog::announce);
  return row;
}

QGridLayout* HeadDialog::makeAxes() {
  auto* grid = new QGridLayout;
  const QStringList titles{tr("Head"), tr("From"), QString(), tr("Tracker sends"), tr("Head has moved")};
  for (int i = 0; i < titles.size(); ++i) {
    auto* title = new QLabel(titles[i], this);
    title->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(title, 0, i);
  }
  const QStringList names{tr("Right"), tr("Up"), tr("Towards you"), tr("Turn left"), tr("Look up"), tr("Tilt left")};
  const QStringList sources{tr("x"), tr("y"), tr("z"), tr("yaw"), tr("pitch"), tr("roll")};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const QString& name = names[static_cast<int>(i)];
    Row& row = rows_[i];
    row = {new QComboBox(this), new QCheckBox(tr("inverted"), this), new QLabel(this), new QLabel(this)};
    row.source->addItems(sources);
    row.source->setAccessibleName(name);
    row.source->setToolTip(tr("The number of the tracker that this comes from"));
    row.inverted->setAccessibleName(tr("%1, inverted").arg(name));
    row.inverted->setToolTip(tr("The tracker counts in the other direction"));
    const int line = static_cast<int>(i) + 1;
    grid->addWidget(new QLabel(name, this), line, 0);
    grid->addWidget(row.source, line, 1);
    grid->addWidget(row.inverted, line, 2);
    grid->addWidget(row.sent, line, 3);
    grid->addWidget(row.head, line, 4);
    for (QLabel* value : {row.sent, row.head}) {
      value->setMinimumWidth(kValueWidth);
      value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    connect(row.source, QOverload<int>::of(&QComboBox::activated), this, &HeadDialog::announce);
    connect(row.inverted, &QCheckBox::toggled, this, &HeadDialog::announce);
  }
  return grid;
}

QLayout* HeadDialog::makeDelay() {
  delay_->setRange(0, static_cast<int>(kMostRestDelay / kMillisecond));
  delay_->setSingleStep(10);
  delay_->setSuffix(tr(" ms"));
  delay_->setToolTip(tr("More of it lets a head at rest tremble less; a head that moves is followed faster"));
  auto* label = new QLabel(tr("&Delay of a head at rest"), this);
  label->setBuddy(delay_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(delay_);
  row->addWidget(delayNow_, 1);
  connect(delay_, QOverload<int>::of(&QSpinBox::valueChanged), this, &HeadDialog::announce);
  return row;
}

void HeadDialog::setPreferences(const HeadPreferences& present) {
  rest_ = present.shaping.rest;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const QSignalBlocker block(rows_[i].inverted);
    rows_[i].source->setCurrentIndex(present.shaping.axes[i].source);
    rows_[i].inverted->setChecked(present.shaping.axes[i].inverted);
  }
  const QSignalBlocker blocks[]{QSignalBlocker(port_), QSignalBlocker(fromAnywhere_), QSignalBlocker(delay_)};
  port_->setValue(present.port);
  fromAnywhere_->setChecked(present.fromAnywhere);
  delay_->setValue(qRound(present.shaping.restDelay / kMillisecond));
  refresh();
}

HeadPreferences HeadDialog::preferences() const {
  HeadPreferences preferences;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    preferences.shaping.axes[i] = {rows_[i].source->currentIndex(), rows_[i].inverted->isChecked()};
  }
  preferences.shaping.rest = rest_;
  preferences.shaping.restDelay = delay_->value() * kMillisecond;
  preferences.port = port_->value();
  preferences.fromAnywhere = fromAnywhere_->isChecked();
  return preferences;
}

void HeadDialog::announce() { emit changed(preferences()); }

void HeadDialog::refresh() {
  const HeadState now = state_();
  QString text = tr("off");
  if (now.on) text = now.tracked ? tr("the head is tracked") : tr("nothing comes");
  if (now.dropped > 0) text += tr("; dropped: %L1").arg(now.dropped);
  stateText_->setText(text);
  const std::array<double, 6> head = numbersOf(now.motion);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto source = static_cast<std::size_t>(rows_[i].source->currentIndex());
    rows_[i].sent->setText(valueText(now.reading[source], source));
    rows_[i].head->setText(valueText(head[i], i));
  }
  delayNow_->setText(now.tracked ? tr("now %L1 ms").arg(now.delay / kMillisecond, 0, 'f', 0) : QString());
}

void HeadDialog::showTrouble(const QString& file) {
  trouble_->setText(tr("The settings cannot be written: %1").arg(file));
  trouble_->show();
}

void HeadDialog::showEvent(QShowEvent* event) {
  refresh();
  timer_.start();
  QDialog::showEvent(event);
}

void HeadDialog::hideEvent(QHideEvent* event) {
  timer_.stop();
  QDialog::hideEvent(event);
}

}  // namespace glissade
