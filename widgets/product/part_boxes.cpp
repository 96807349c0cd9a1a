#include "widgets/product/part_boxes.h"

#include <QHBoxLayout>
#include <QWheelEvent>

#include "engine/base/length_units.h"
#include "engine/files/part_files.h"
#include "engine/import/step_import.h"
#include "widgets/product/parts_dialog.h"

namespace glissade {
namespace {

constexpr int kGap = 4;

/// Lets the wheel scroll the table instead of changing the box under the pointer.
class CellCombo final : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QComboBox* makeBox(const char* id, const QString& name, const QString& tip) {
  auto* combo = new CellCombo;
  combo->setObjectName(QLatin1String(id));
  combo->setAccessibleName(name);
  combo->setToolTip(tip);
  return combo;
}

}  // namespace

void showUnitOfFile(const std::string& file, QComboBox& unit, QComboBox& up) {
  if (isCadFile(file)) unit.setItemText(0, PartsDialog::tr("file's"));
  for (QComboBox* box : {&unit, &up}) {
    box->setEnabled(false);
    box->setToolTip(PartsDialog::tr("The file says its unit itself; Z is up"));
  }
}

QWidget* cellOf(QComboBox* box) {
  auto* cell = new QWidget;
  auto* layout = new QHBoxLayout(cell);
  layout->setContentsMargins(kGap, kGap / 2, kGap, kGap / 2);
  layout->addWidget(box);
  return cell;
}

QComboBox* makeRoleBox(const QString& part, bool mayMove) {
  QComboBox* role =
      makeBox("role", PartsDialog::tr("Role of %1").arg(part),
              PartsDialog::tr("What the part does while the path of one part is planned; an assembly plan moves every "
                              "part. It is set for all selected rows together"));
  const auto add = [role](const QString& label, PartRole value, const QString& tip) {
    role->addItem(label, static_cast<int>(value));
    role->setItemData(role->count() - 1, tip, Qt::ToolTipRole);
  };
  if (mayMove) {
    add(PartsDialog::tr("Moves: its path is planned"), PartRole::Moves,
        PartsDialog::tr("The part whose path is planned; several move as one"));
  }
  add(PartsDialog::tr("Stays"), PartRole::Static, PartsDialog::tr("Does not move while another part moves"));
  add(PartsDialog::tr("Stays, could be moved aside"), PartRole::Mobile,
      PartsDialog::tr("In the way, but a person could move it"));
  return role;
}

QComboBox* makeUnitBox(const QString& part) {
  QComboBox* unit = makeBox("unit", PartsDialog::tr("Unit of %1").arg(part),
                            PartsDialog::tr("Unit of the file; of all selected rows together"));
  unit->addItem(PartsDialog::tr("m"), 1.0);
  unit->addItem(PartsDialog::tr("cm"), 0.01);
  unit->addItem(PartsDialog::tr("mm"), 0.001);
  unit->addItem(PartsDialog::tr("inch"), kInch);
  return unit;
}

QComboBox* makeUpBox(const QString& part) {
  QComboBox* up = makeBox("up", PartsDialog::tr("Axis of %1 that points up").arg(part),
                          PartsDialog::tr("The file's axis that points up; of all selected rows together"));
  up->addItem(QStringLiteral("Z"), static_cast<int>(UpAxis::Z));
  up->addItem(QStringLiteral("Y"), static_cast<int>(UpAxis::Y));
  return up;
}

}  // namespace glissade
