#include "widgets/product/variants_dialog.h"

#include <QDialogButtonBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "widgets/controls/flow_layout.h"

namespace glissade {
namespace {

/// Id of the button that leaves all variants of a place in the scenario.
constexpr int kAll = -2;

}  // namespace

VariantsDialog::VariantsDialog(std::vector<std::vector<Variant>> places, QWidget* parent)
    : QDialog(parent), places_(std::move(places)) {
  setObjectName(QStringLiteral("variants"));
  setWindowTitle(tr("Variants"));
  resize(720, 560);
  auto* about = new QLabel(tr("These bodies fill the same place, as variants of one part do. Choose the one that is "
                              "built. The scenario keeps the others under \"Excluded\"."),
                           this);
  about->setWordWrap(true);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  for (std::size_t i = 0; i < places_.size(); ++i) column->addWidget(makePlace(places_[i], static_cast<int>(i) + 1));
  column->addStretch(1);
  auto* area = new QScrollArea(this);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(page);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("&Exclude the others"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(about);
  layout->addWidget(area, 1);
  layout->addWidget(buttons);
}

QWidget* VariantsDialog::makePlace(const std::vector<Variant>& variants, int number) {
  auto* box = new QGroupBox(tr("Place %1").arg(number), this);
  auto* choice = new QButtonGroup(box);
  choices_.push_back(choice);
  auto* pictures = new QWidget(box);
  auto* flow = new FlowLayout;
  pictures->setLayout(flow);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    flow->addWidget(makeVariant(variants[i], static_cast<int>(i), *choice));
  }
  auto* all = new QRadioButton(tr("All of them are built"), box);
  all->setChecked(true);
  choice->addButton(all, kAll);
  auto* column = new QVBoxLayout(box);
  column->addWidget(pictures);
  column->addWidget(all);
  return box;
}

QWidget* VariantsDialog::makeVariant(const Variant& variant, int index, QButtonGroup& choice) {
  auto* tile = new QWidget(this);
  auto* picture = new QLabel(tile);
  picture->setPixmap(QPixmap::fromImage(variant.picture));
  picture->setFrameShape(QFrame::StyledPanel);
  auto* button = new QRadioButton(tile);
  const QFontMetrics metrics(button->font());
  // Width of the button's mark.
  constexpr int kMark = 28;
  button->setText(metrics.elidedText(variant.name, Qt::ElideMiddle, variant.picture.width() - kMark));
  button->setToolTip(variant.name);
  button->setAccessibleName(variant.name);
  picture->setBuddy(button);
  choice.addButton(button, index);
  auto* column = new QVBoxLayout(tile);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(picture);
  column->addWidget(button);
  return tile;
}

std::set<BodyId> VariantsDialog::leftOut() const {
  std::set<BodyId> ids;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    const int chosen = choices_[place]->checkedId();
    if (chosen == kAll) continue;
    for (std::size_t i = 0; i < places_[place].size(); ++i) {
      if (static_cast<int>(i) != chosen) ids.insert(places_[place][i].id);
    }
  }
  return ids;
}

}  // namespace glissade
