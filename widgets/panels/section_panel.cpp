#include "widgets/panels/section_panel.h"

#include <algorithm>
#include <array>

#include "widgets/commands/flow_layout.h"

namespace glissade {
namespace {

/// A direction that differs less from an axis is named after it.
constexpr double kIsAxis = 0.999999;

}  // namespace

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
  auto* column = new QVBoxLayout(this);
  column->addLayout(flow);
  column->addLayout(rowsLayout_);
  column->addWidget(note_);
  column->addStretch();
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

/// X, X 2, Face, Face 2
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

/// The next row has the focus then, so that the keyboard goes on there.
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
                                    "object that moves stays whole.")
                               : tr("Drag the arrows in the scene, or type a place such as 25.4 mm."));
}

}  // namespace glissade
