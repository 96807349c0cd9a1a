#include "widgets/devices/calibration_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

constexpr int kPoints = 200;
constexpr double kMargin = 6.0;

constexpr int kRefreshInterval = 33;  ///< ms
constexpr int kWidth = 960;

bool isController(const HandInput& input) {
  return input.kind == InputKind::LeftController || input.kind == InputKind::RightController;
}

QString text(const std::string& value) { return QString::fromStdString(value); }

}  // namespace

ResponseCurve::ResponseCurve(QWidget* parent) : QWidget(parent) {
  setToolTip(tr("How the device's deflection (across) is answered (up); the dot is where it is now"));
}

void ResponseCurve::setAxis(const QString& title, const AxisShaping& axis) {
  title_ = title;
  axis_ = axis;
  update();
}

void ResponseCurve::setRaw(double raw) {
  if (raw == raw_) return;
  raw_ = raw;
  update();
}

void ResponseCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height();
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRect(0, 0, width(), line), Qt::AlignCenter, title_);
  const double side = std::min<double>(width(), height() - line) - 2.0 * kMargin;
  const QRectF area(0.5 * (width() - side), line + kMargin, side, side);
  const auto at = [&](double raw, double shaped) {
    return QPointF(area.center().x() + 0.5 * side * raw, area.center().y() - 0.5 * side * shaped);
  };
  painter.setBrush(palette().base());
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(area);
  painter.drawLine(at(-1, 0), at(1, 0));
  painter.drawLine(at(0, -1), at(0, 1));
  QPainterPath curve(at(-1, shapeAxis(axis_, -1)));
  for (int i = 1; i <= kPoints; ++i) {
    const double raw = -1.0 + 2.0 * i / kPoints;
    curve.lineTo(at(raw, shapeAxis(axis_, raw)));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
  painter.drawPath(curve);
  painter.setBrush(palette().color(QPalette::WindowText));
  painter.setPen(Qt::NoPen);
  painter.drawEllipse(at(std::clamp(raw_, -1.0, 1.0), shapeAxis(axis_, raw_)), 4.0, 4.0);
}

CalibrationDialog::CalibrationDialog(HandInputsPtr hand, DeviceSettings& settings, const ActionCatalogue& actions,
                                     QWidget* parent)
    : QDialog(parent),
      hand_(std::move(hand)),
      settings_(settings),
      actions_(actions),
      device_(new QComboBox(this)),
      state_(new QLabel(this)),
      preset_(new QComboBox(this)),
      curve_(new ResponseCurve(this)),
      dominantAxis_(new QCheckBox(tr("&One axis at a time (the dominant one)"), this)),
      translationLocked_(new QCheckBox(tr("Lock &shifts"), this)),
      rotationLocked_(new QCheckBox(tr("Lock &turns"), this)),
      frame_(new QComboBox(this)),
      linearSpeed_(new ValueSlider(kSpeedRange, tr("Speed of shifts"), this)),
      angularSpeed_(new ValueSlider(kSpeedRange, tr("Speed of turns"), this)),
      button_(new QComboBox(this)),
      action_(new QComboBox(this)),
      trouble_(new QLabel(this)) {
  setObjectName(QStringLiteral("calibration"));
  setWindowTitle(tr("Devices"));
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(makeHeader());
  axes_ = makeAxes();
  motion_ = makeMotion();
  layout->addWidget(axes_);
  auto* below = new QHBoxLayout;
  below->addWidget(motion_, 3);
  below->addWidget(makeButtons(), 2);
  layout->addLayout(below);
  trouble_->setText(tr("The settings cannot be written: %1").arg(settings_.file()));
  trouble_->setVisible(false);
  layout->addWidget(trouble_);
  auto* close = new QDialogButtonBox(QDialogButtonBox::Close, this);
  close->button(QDialogButtonBox::Close)->setText(tr("&Close"));
  connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(close);
  timer_.setInterval(kRefreshInterval);
  connect(&timer_, &QTimer::timeout, this, &CalibrationDialog::refresh);
  resize(kWidth, sizeHint().height());
  device_->setCurrentIndex(1);
  chooseDevice(1);
}

QLayout* CalibrationDialog::makeHeader() {
  for (const CatalogueText name : {GLISSADE_TEXT("Keyboard"), GLISSADE_TEXT("6D mouse"), GLISSADE_TEXT("Gamepad"),
                                   GLISSADE_TEXT("Left controller"), GLISSADE_TEXT("Right controller")}) {
    device_->addItem(engineText(name));
  }
  device_->setObjectName(QStringLiteral("device"));
  preset_->setObjectName(QStringLiteral("preset"));
  state_->setObjectName(QStringLiteral("device-state"));
  auto* reset = new QPushButton(tr("&Reset the device"), this);
  reset->setToolTip(tr("Restores the original curves and buttons of this device"));
  auto* deviceLabel = new QLabel(tr("&Device"), this);
  deviceLabel->setBuddy(device_);
  auto* presetLabel = new QLabel(tr("&Preset"), this);
  presetLabel->setBuddy(preset_);
  auto* row = new QHBoxLayout;
  row->addWidget(deviceLabel);
  row->addWidget(device_);
  row->addWidget(state_, 1);
  row->addWidget(presetLabel);
  row->addWidget(preset_);
  row->addWidget(reset);
  connect(device_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CalibrationDialog::chooseDevice);
  connect(preset_, QOverload<int>::of(&QComboBox::activated), this, &CalibrationDialog::choosePreset);
  connect(reset, &QPushButton::clicked, this, &CalibrationDialog::resetDevice);
  return row;
}

QWidget* CalibrationDialog::makeAxes() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(1, 3);
  for (const int slider : {2, 3, 4}) grid->setColumnStretch(slider, 2);
  AxisRow::addHeader(*grid, this);
  for (const QString& name :
       {tr("Right"), tr("Up"), tr("Towards you"), tr("Tip forward"), tr("Turn right"), tr("Roll left")}) {
    const int axis = static_cast<int>(rows_.size());
    auto* row = new AxisRow(name, *grid, axis + 1, this);
    connect(row, &AxisRow::changed, this, &CalibrationDialog::apply);
    connect(row, &AxisRow::entered, this, [this, axis] {
      current_ = axis;
      showShaping(shown_);
    });
    rows_.push_back(row);
  }
  auto* axes = new QWidget(this);
  auto* both = new QHBoxLayout(axes);
  both->setContentsMargins(0, 0, 0, 0);
  both->setSpacing(14);
  both->addLayout(grid, 1);
  both->addWidget(curve_);
  return axes;
}

QWidget* CalibrationDialog::makeMotion() {
  frame_->addItems({tr("of the view"), tr("of the world"), tr("of the object")});
  auto* box = new QGroupBox(tr("Motion"), this);
  auto* checks = new QVBoxLayout;
  for (QCheckBox* check : {dominantAxis_, translationLocked_, rotationLocked_}) {
    checks->addWidget(check);
    connect(check, &QCheckBox::toggled, this, &CalibrationDialog::apply);
  }
  auto* form = new QFormLayout;
  form->addRow(tr("&Axes"), frame_);
  form->addRow(tr("S&hifts, speed"), linearSpeed_);
  form->addRow(tr("T&urns, speed"), angularSpeed_);
  auto* layout = new QHBoxLayout(box);
  layout->addLayout(checks);
  layout->addLayout(form, 1);
  connect(frame_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CalibrationDialog::apply);
  connect(linearSpeed_, &ValueSlider::valueChosen, this, &CalibrationDialog::apply);
  connect(angularSpeed_, &ValueSlider::valueChosen, this, &CalibrationDialog::apply);
  return box;
}

QWidget* CalibrationDialog::makeButtons() {
  for (std::size_t button = 0; button < kInputButtons; ++button) button_->addItem(QString::number(button));
  action_->addItem(tr("nothing"), QString());
  for (const ActionSpec& spec : actions_.specs()) {
    const QString id = QLatin1String(spec.id);
    action_->addItem(withoutMnemonic(actions_[id]->text()), id);
  }
  action_->setObjectName(QStringLiteral("button-action"));
  action_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  action_->setMinimumContentsLength(16);
  auto* box = new QGroupBox(tr("Buttons"), this);
  auto* form = new QFormLayout(box);
  form->addRow(tr("&Button"), button_);
  form->addRow(tr("d&oes"), action_);
  auto* hint = new QLabel(tr("Press a button of the device to find its number."), box);
  hint->setWordWrap(true);
  form->addRow(hint);
  connect(button_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { showAction(); });
  connect(action_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    settings_.setAction(input(), static_cast<std::size_t>(button_->currentIndex()), action_->currentData().toString());
  });
  return box;
}

/// Names the buttons of controllers, which all controllers have in the same places.
void CalibrationDialog::nameButtons() {
  const QStringList names{tr("Trigger"), tr("Menu"), tr("Lower button"), tr("Upper button"), tr("Stick")};
  const int named = isController(input()) ? names.size() : 0;
  for (int button = 0; button < button_->count(); ++button) {
    button_->setItemText(button, button < named ? names[button] : QString::number(button));
  }
}

/// Settings of axes are disabled for a controller: it has buttons only, and the object follows its pose.
void CalibrationDialog::chooseDevice(int /*index*/) {
  for (QWidget* ofAxes : {axes_, motion_, static_cast<QWidget*>(preset_)}) ofAxes->setEnabled(!isController(input()));
  nameButtons();
  preset_->clear();
  for (const ShapingPreset& preset : shapingPresets(input().kind)) {
    preset_->addItem(engineText(preset.label));
  }
  preset_->addItem(tr("own"));
  dominant_.reset();
  showShaping(input().shaping.get());
  showAction();
  refresh();
}

void CalibrationDialog::choosePreset(int index) {
  const auto presets = shapingPresets(input().kind);
  if (index < static_cast<int>(presets.size())) showShaping(presets[static_cast<std::size_t>(index)].shaping);
  apply();
}

void CalibrationDialog::resetDevice() {
  settings_.reset(input());
  input().shaping.set(settings_.shaping(input()));
  showShaping(input().shaping.get());
  showAction();
}

void CalibrationDialog::apply() {
  DeviceShaping shaping;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!(rows_[i]->shaping() == shown_.axes[i])) current_ = static_cast<int>(i);
    shaping.axes[i] = rows_[i]->shaping();
  }
  shaping.dominantAxis = dominantAxis_->isChecked();
  shaping.translationLocked = translationLocked_->isChecked();
  shaping.rotationLocked = rotationLocked_->isChecked();
  shaping.frame = static_cast<MotionFrame>(frame_->currentIndex());
  shaping.linearSpeed = linearSpeed_->value();
  shaping.angularSpeed = angularSpeed_->value();
  input().shaping.set(shaping);
  settings_.setShaping(input(), shaping);
  trouble_->setVisible(!settings_.writable());
  showShaping(input().shaping.get());
  refresh();
}

void CalibrationDialog::showShaping(const DeviceShaping& shaping) {
  shown_ = shaping;
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->setShaping(shaping.axes[i]);
  const QSignalBlocker blocks[]{QSignalBlocker(dominantAxis_), QSignalBlocker(translationLocked_),
                                QSignalBlocker(rotationLocked_), QSignalBlocker(frame_)};
  dominantAxis_->setChecked(shaping.dominantAxis);
  translationLocked_->setChecked(shaping.translationLocked);
  rotationLocked_->setChecked(shaping.rotationLocked);
  frame_->setCurrentIndex(static_cast<int>(shaping.frame));
  linearSpeed_->setValue(shaping.linearSpeed);
  angularSpeed_->setValue(shaping.angularSpeed);
  const auto presets = shapingPresets(input().kind);
  std::size_t preset = 0;
  while (preset < presets.size() && !(presets[preset].shaping == shaping)) ++preset;
  preset_->setCurrentIndex(static_cast<int>(preset));
  curve_->setAxis(rows_[static_cast<std::size_t>(current_)]->name(), shaping.axes[static_cast<std::size_t>(current_)]);
}

void CalibrationDialog::showAction() {
  const QString id = settings_.action(input(), static_cast<std::size_t>(button_->currentIndex()));
  action_->setCurrentIndex(std::max(0, action_->findData(id)));
}

void CalibrationDialog::showButton(const HandInput& pressed, std::size_t button) {
  if (&pressed == &input()) button_->setCurrentIndex(static_cast<int>(button));
}

void CalibrationDialog::refresh() {
  const InputReading now = input().mailbox.reading();
  state_->setText(now.connected ? tr("connected: %1").arg(text(now.name)) : tr("not connected"));
  const DeviceShaping shaping = input().shaping.get();
  if (!(shaping == shown_)) {
    showShaping(shaping);
    showAction();
  }
  const Deflection shaped = shape(shaping, now.axes, dominant_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Vector3& part = i < 3 ? shaped.translation : shaped.rotation;
    rows_[i]->bar().setValues(now.axes[shaping.axes[i].source], part[static_cast<int>(i % 3)]);
  }
  curve_->setRaw(now.axes[shaping.axes[static_cast<std::size_t>(current_)].source]);
}

void CalibrationDialog::showEvent(QShowEvent* event) {
  refresh();
  timer_.start();
  QDialog::showEvent(event);
}

void CalibrationDialog::hideEvent(QHideEvent* event) {
  timer_.stop();
  QDialog::hideEvent(event);
}

}  // namespace glissade
