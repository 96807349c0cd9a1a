#include "widgets/section/section_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/controls/flow_layout.h"
#include "widgets/controls/length_text.h"

namespace glissade {
namespace {

constexpr int kPlaces = 1000;
/// Finest difference that the field shows, metres.
constexpr double kFinestSection = 1e-5;
/// Largest distance of sections from the drawn scene, in sizes of the scene.
constexpr double kBeside = 10.0;

QToolButton* smallButton(const QString& text, const QString& name, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(name);
  button->setAccessibleName(name);
  return button;
}

/// A direction with a larger component along an axis is named after the axis.
constexpr double kIsAxis = 0.999999;

}  // namespace

SectionRow::SectionRow(const QString& name, const QString& id, const SectionPlane& section, const PlaceRange& range,
                       QWidget* parent)
    : QWidget(parent),
      section_(section),
      range_(range),
      on_(new QCheckBox(name, this)),
      place_(new QSlider(Qt::Horizontal, this)),
      length_(new QuantityBox(QuantityBox::Quantity::Length, this)),
      otherSide_(smallButton(QStringLiteral("⇄"), tr("Show the other side of section %1").arg(name), this)),
      remove_(smallButton(QStringLiteral("✕"), tr("Remove section %1").arg(name), this)) {
  setObjectName(id);
  on_->setObjectName(id + QStringLiteral("-on"));
  on_->setToolTip(tr("Cut the bodies open by section %1").arg(name));
  place_->setRange(0, kPlaces);
  place_->setAccessibleName(tr("Place of section %1").arg(name));
  place_->setToolTip(place_->accessibleName());
  length_->setObjectName(id + QStringLiteral("-place"));
  length_->setAccessibleName(tr("Place of section %1 as a length").arg(name));
  length_->setToolTip(tr("Place of section %1, in any unit: 25.4 mm, 1 in").arg(name));
  length_->setFixedWidth(length_->fontMetrics().horizontalAdvance(QStringLiteral("-0000.00 mm ")) + 12);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(on_);
  row->addWidget(place_, 1);
  row->addWidget(length_);
  row->addWidget(otherSide_);
  row->addWidget(remove_);
  on_->setMinimumWidth(on_->fontMetrics().horizontalAdvance(QStringLiteral("Y 2")) + 28);
  connectWidgets();
  showUnit();
}

void SectionRow::connectWidgets() {
  connect(on_, &QCheckBox::toggled, this, [this](bool on) {
    section_.on = on;
    showSection();
    emit changed();
  });
  connect(place_, &QSlider::valueChanged, this, [this](int value) {
    const double share = static_cast<double>(value) / kPlaces;
    section_.place = (1.0 - share) * range_.least + share * range_.greatest;
    showSection();
    emit changed();
  });
  connect(length_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    section_.place = value / perMetre_;
    showSection();
    emit changed();
  });
  connect(length_, &QuantityBox::refused, this, &SectionRow::refused);
  connect(otherSide_, &QToolButton::clicked, this, [this] {
    section_.otherSide = !section_.otherSide;
    emit changed();
  });
  connect(remove_, &QToolButton::clicked, this, &SectionRow::removed);
}

void SectionRow::setSection(const SectionPlane& section) {
  section_ = section;
  showSection();
}

void SectionRow::setRange(const PlaceRange& range) {
  range_ = range;
  showUnit();
}

void SectionRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) showUnit();
}

void SectionRow::showUnit() {
  const LengthField field = lengthField(kFinestSection);
  perMetre_ = field.perMetre;
  const QSignalBlocker block(length_);
  length_->setUnit(1.0 / perMetre_, field.decimals);
  length_->setSuffix(QLatin1Char(' ') + field.unit);
  const double size = std::max(1.0, range_.greatest - range_.least);
  length_->setRange(perMetre_ * (range_.least - kBeside * size), perMetre_ * (range_.greatest + kBeside * size));
  length_->setSingleStep(perMetre_ * (range_.greatest - range_.least) / 100.0);
  showSection();
}

void SectionRow::showSection() {
  const QSignalBlocker blockOn(on_);
  const QSignalBlocker blockPlace(place_);
  const QSignalBlocker blockLength(length_);
  on_->setChecked(section_.on);
  const double size = range_.greatest - range_.least;
  const double share = size > 0.0 ? (section_.place - range_.least) / size : 0.5;
  place_->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kPlaces)));
  length_->setValue(perMetre_ * section_.place);
  for (QWidget* part :
       {static_cast<QWidget*>(place_), static_cast<QWidget*>(length_), static_cast<QWidget*>(otherSide_)}) {
    part->setEnabled(section_.on);
  }
}

SectionPanel::SectionPanel(const ActionCatalogue& actions, QWidget* parent)
    : QWidget(parent), rowsLayout_(new QVBoxLayout), note_(new QLabel(this)) {
  const std::array<std::pair<const char*, QString>, 5> buttons{{{"section.add-x", QStringLiteral("X")},
                                                                {"section.add-y", QStringLiteral("Y")},
                                                                {"section.add-z", QStringLiteral("Z")},
                                                                {"section.pick-face", tr("Face")},
                                                                {"section.remove-all", tr("Remove all")}}};
  auto* flow = new FlowLayout;
  flow->addWidget(new QLabel(tr("Add:"), this));
  for (const auto& [id, text] : buttons) {
    QAction* action = actions[QLatin1String(id)];
    action->setIconText(text);
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(commandName(action->text()));
    flow->addWidget(button);
    if (firstButton_ == nullptr) firstButton_ = button;
  }
  rowsLayout_->setSpacing(2);
  note_->setWordWrap(true);
  auto* left = new QVBoxLayout;
  left->addLayout(flow);
  left->addWidget(note_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addLayout(left, 1);
  row->addLayout(rowsLayout_, 1);
  showNote();
  setEnabled(false);
}

void SectionPanel::setExtent(const Box3& extent) {
  extent_ = extent;
  setEnabled(!extent.isEmpty());
  if (extent.isEmpty()) return;
  for (SectionRow* row : rows_) row->setRange(rangeAlong(row->section().direction, extent));
}

std::vector<SectionPlane> SectionPanel::sections() const {
  std::vector<SectionPlane> sections;
  for (const SectionRow* row : rows_) sections.push_back(row->section());
  return sections;
}

/// A free name such as "X", "X 2", "Face" or "Face 2".
QString SectionPanel::freeName(const Vector3& direction) const {
  QString kind = tr("Face");
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) > kIsAxis) kind = QLatin1Char("XYZ"[axis]);
  }
  QString name = kind;
  const auto isTaken = [&] {
    return std::any_of(rows_.begin(), rows_.end(),
                       [&](const SectionRow* row) { return row->property("section-name").toString() == name; });
  };
  for (int i = 2; isTaken(); ++i) name = QStringLiteral("%1 %2").arg(kind).arg(i);
  return name;
}

void SectionPanel::add(const SectionPlane& section) {
  const QString name = freeName(section.direction);
  const QString id = QStringLiteral("section-") + QString(name).remove(QLatin1Char(' ')).toLower();
  auto* row = new SectionRow(name, id, section, rangeAlong(section.direction, extent_), this);
  row->setProperty("section-name", name);
  connect(row, &SectionRow::changed, this, [this] {
    showNote();
    emit changed();
  });
  connect(row, &SectionRow::removed, this, [this, row] { removeByHand(row); });
  connect(row, &SectionRow::refused, this, [this](const QString& text) {
    note_->setText(QStringLiteral("⚠ ") + tr("“%1” is no place. Write 10, 25.4 mm or 1 in.").arg(text));
  });
  rows_.push_back(row);
  rowsLayout_->addWidget(row);
  showNote();
}

void SectionPanel::set(std::size_t index, const SectionPlane& section) { rows_[index]->setSection(section); }

void SectionPanel::remove(std::size_t index) {
  SectionRow* row = rows_[index];
  rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(index));
  rowsLayout_->removeWidget(row);
  row->hide();
  row->deleteLater();
  showNote();
}

/// Removes a section and gives the next row the focus, for use by the keyboard.
void SectionPanel::removeByHand(SectionRow* row) {
  const auto index = static_cast<std::size_t>(std::find(rows_.begin(), rows_.end(), row) - rows_.begin());
  remove(index);
  if (rows_.empty()) {
    firstButton_->setFocus();
  } else {
    rows_[std::min(index, rows_.size() - 1)]->focusPlace();
  }
  emit changed();
}

void SectionPanel::clear() {
  while (!rows_.empty()) remove(rows_.size() - 1);
}

void SectionPanel::showNote() {
  note_->setText(rows_.empty() ? tr("Sections cut bodies open: across an axis, or along a face that is clicked. The "
                                    "moving part stays whole.")
                               : tr("Drag the arrows in the scene, or type a place such as 25.4 mm."));
}

}  // namespace glissade
