#include "widgets/view/named_views_dialog.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace glissade {

NamedViewsDialog::NamedViewsDialog(NamedViews views, QWidget* parent)
    : QDialog(parent), views_(std::move(views)), list_(new QListWidget(this)) {
  setWindowTitle(tr("Named views"));
  setObjectName(QStringLiteral("named-views"));
  list_->setAccessibleName(tr("Named views"));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* go = buttons->addButton(tr("&Go to"), QDialogButtonBox::ActionRole);
  QPushButton* rename = buttons->addButton(tr("&Rename"), QDialogButtonBox::ActionRole);
  QPushButton* remove = buttons->addButton(tr("R&emove"), QDialogButtonBox::ActionRole);
  ofOneView_ = {go, rename, remove};
  remove->setShortcut(QKeySequence::Delete);
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_, 1);
  column->addWidget(buttons);
  resize(420, 300);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &NamedViewsDialog::goToCurrent);
  connect(rename, &QPushButton::clicked, this, [this] {
    if (list_->currentItem() != nullptr) list_->editItem(list_->currentItem());
  });
  connect(remove, &QPushButton::clicked, this, &NamedViewsDialog::removeCurrent);
  connect(list_, &QListWidget::itemDoubleClicked, this, &NamedViewsDialog::goToCurrent);
  connect(list_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) { takeName(*item); });
  showViews();
}

void NamedViewsDialog::showViews() {
  const int row = std::max(0, list_->currentRow());
  {
    const QSignalBlocker block(list_);
    list_->clear();
    for (const NamedView& view : views_) {
      auto* item = new QListWidgetItem(view.name, list_);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
  }
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  for (QPushButton* button : ofOneView_) button->setEnabled(!views_.empty());
}

void NamedViewsDialog::goToCurrent() {
  if (list_->currentRow() >= 0) emit chosen(views_[static_cast<std::size_t>(list_->currentRow())]);
}

/// Takes a new name, unless it is empty or another view has it.
void NamedViewsDialog::takeName(const QListWidgetItem& item) {
  const QString name = item.text().trimmed();
  const bool taken =
      std::any_of(views_.begin(), views_.end(), [&](const NamedView& view) { return view.name == name; });
  if (!name.isEmpty() && !taken) {
    views_[static_cast<std::size_t>(list_->row(&item))].name = name;
    emit edited(views_);
  }
  showViews();
}

void NamedViewsDialog::removeCurrent() {
  if (list_->currentRow() < 0) return;
  views_.erase(views_.begin() + list_->currentRow());
  emit edited(views_);
  showViews();
}

}  // namespace glissade
