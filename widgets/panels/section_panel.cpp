#include "widgets/panels/section_panel.h"

#include <QEvent>
#include <QGridLayout>
#include <QSignalBlocker>

#include <cmath>

#include "widgets/commands/length_text.h"

namespace glissade {
namespace {

constexpr int kPositions = 1000;

}  // namespace

SectionPanel::SectionPanel(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  for (int axis = 0; axis < 3; ++axis) rows_[static_cast<std::size_t>(axis)] = addRow(axis);
  auto* note = new QLabel(tr("Sections cut obstacles open. The object that moves stays whole."), this);
  note->setWordWrap(true);
  grid->addWidget(note, 3, 0, 1, 4);
  grid->setRowStretch(4, 1);
  setExtent(Box3());
}

SectionPanel::Row SectionPanel::addRow(int axis) {
  const QString letter(QLatin1Char("XYZ"[axis]));
  const Row row{new QCheckBox(letter, this), new QSlider(Qt::Horizontal, this), new QLabel(this),
                new QToolButton(this)};
  row.on->setObjectName(QStringLiteral("section-") + letter.toLower());
  row.on->setToolTip(tr("Cut obstacles open across %1").arg(letter));
  row.place->setRange(0, kPositions);
  row.place->setAccessibleName(tr("Place of the section across %1").arg(letter));
  row.place->setToolTip(row.place->accessibleName());
  row.otherSide->setText(QStringLiteral("⇄"));
  row.otherSide->setCheckable(true);
  row.otherSide->setAutoRaise(true);
  row.otherSide->setFocusPolicy(Qt::TabFocus);
  row.otherSide->setToolTip(tr("Show the other side of the section across %1").arg(letter));
  row.otherSide->setAccessibleName(row.otherSide->toolTip());
  row.length->setMinimumWidth(fontMetrics().horizontalAdvance(lengthText(-0.888)));
  row.length->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->addWidget(row.on, axis, 0);
  grid->addWidget(row.place, axis, 1);
  grid->addWidget(row.length, axis, 2);
  grid->addWidget(row.otherSide, axis, 3);
  const auto announce = [this] {
    showLengths();
    emit changed();
  };
  connect(row.on, &QCheckBox::toggled, this, [this, axis](bool on) {
    if (on) emit switchedOn(axis);
  });
  connect(row.on, &QCheckBox::toggled, this, announce);
  connect(row.place, &QSlider::valueChanged, this, announce);
  connect(row.otherSide, &QToolButton::toggled, this, announce);
  return row;
}

void SectionPanel::setExtent(const Box3& extent) {
  extent_ = extent;
  for (const Row& row : rows_) {
    const QSignalBlocker blockOn(row.on);
    const QSignalBlocker blockPlace(row.place);
    row.on->setChecked(false);
    row.place->setValue(kPositions / 2);
  }
  setEnabled(!extent.isEmpty());
  showLengths();
}

void SectionPanel::setSection(int axis, bool on, double share) {
  const Row& row = rows_[static_cast<std::size_t>(axis)];
  row.place->setValue(static_cast<int>(std::lround(share * kPositions)));
  row.on->setChecked(on);
}

void SectionPanel::setOtherSide(int axis, bool otherSide) {
  QToolButton* button = rows_[static_cast<std::size_t>(axis)].otherSide;
  const QSignalBlocker block(button);
  button->setChecked(otherSide);
}

double SectionPanel::placeOf(int axis) const {
  const double share = static_cast<double>(rows_[static_cast<std::size_t>(axis)].place->value()) / kPositions;
  return (1.0 - share) * extent_.min()[axis] + share * extent_.max()[axis];
}

std::vector<Plane> SectionPanel::sections() const {
  std::vector<Plane> sections;
  for (int axis = 0; axis < 3 && !extent_.isEmpty(); ++axis) {
    const Row& row = rows_[static_cast<std::size_t>(axis)];
    if (!row.on->isChecked()) continue;
    const double side = row.otherSide->isChecked() ? -1.0 : 1.0;
    sections.push_back({side * Vector3(Vector3::Unit(axis)), side * placeOf(axis)});
  }
  return sections;
}

void SectionPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) showLengths();
}

void SectionPanel::showLengths() {
  for (int axis = 0; axis < 3; ++axis) {
    const Row& row = rows_[static_cast<std::size_t>(axis)];
    row.length->setText(extent_.isEmpty() ? QString() : lengthText(placeOf(axis)));
    row.place->setEnabled(row.on->isChecked());
    row.otherSide->setEnabled(row.on->isChecked());
  }
}

}  // namespace glissade
