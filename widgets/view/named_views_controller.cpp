#include "widgets/view/named_views_controller.h"

#include <QInputDialog>

#include <algorithm>

#include "widgets/controls/menu_mnemonics.h"
#include "widgets/view/named_views_dialog.h"
#include "widgets/workbench/window_memory.h"

namespace glissade {

NamedViewsController::NamedViewsController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), menu_(new QMenu(tr("Named &views"), &bench.window)) {
  menu_->setObjectName(QStringLiteral("menu.named-views"));
  bench.onAction("views.save", this, [this] { askForName(); });
  bench.onAction("views.manage", this, [this] { manage(); });
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & Change::Scenario) {
      load();
    } else if ((what & Change::File) && bench_.document.scenario()->file != file_) {
      setViews(views_);  // the scenario has another file now
    }
  });
  fillMenu();
  addCommands();
}

void NamedViewsController::setMemory(WindowMemory* memory) {
  memory_ = memory;
  load();
}

void NamedViewsController::load() {
  const ScenarioPtr& scenario = bench_.document.scenario();
  file_ = scenario ? scenario->file : std::string();
  views_ = memory_ != nullptr && scenario ? memory_->views(QString::fromStdString(file_)) : NamedViews();
  fillMenu();
}

void NamedViewsController::setViews(NamedViews views) {
  views_ = std::move(views);
  const ScenarioPtr& scenario = bench_.document.scenario();
  file_ = scenario ? scenario->file : std::string();
  if (memory_ != nullptr && scenario) memory_->saveViews(QString::fromStdString(file_), views_);
  fillMenu();
}

void NamedViewsController::fillMenu() {
  bench_.actions.setPassing({});
  qDeleteAll(entries_);
  entries_.clear();
  menu_->clear();
  for (const NamedView& view : views_) {
    auto* entry = new QAction(QString(view.name).replace(QLatin1Char('&'), QStringLiteral("&&")), this);
    entry->setStatusTip(tr("Look from there again"));
    connect(entry, &QAction::triggered, this, [this, view] { goTo(view); });
    entries_.push_back(entry);
  }
  menu_->addActions(entries_);
  if (!entries_.isEmpty()) menu_->addSeparator();
  menu_->addAction(bench_.actions["views.save"]);
  menu_->addAction(bench_.actions["views.manage"]);
  addMnemonics(*menu_);
  bench_.actions.setPassing(entries_);
  bench_.enable("views.save", bench_.document.scenario() != nullptr);
  bench_.enable("views.manage", !views_.empty());
  emit viewsChanged(views_);
}

void NamedViewsController::save(const QString& name) {
  NamedViews views = views_;
  putView(views, {name, bench_.scene.view().camera().pose()});
  setViews(views);
}

void NamedViewsController::goTo(const NamedView& view) {
  bench_.scene.view().camera().setPose(view.pose);
  {
    const QSignalBlocker block(bench_.actions["view.orthographic"]);
    bench_.actions["view.orthographic"]->setChecked(view.pose.orthographic);
  }
  bench_.scene.refresh();
  emit cameraMoved();
}

QString NamedViewsController::freeName() const {
  for (std::size_t number = views_.size() + 1;; ++number) {
    const QString name = tr("View %1").arg(number);
    if (std::none_of(views_.begin(), views_.end(), [&](const NamedView& view) { return view.name == name; })) {
      return name;
    }
  }
}

void NamedViewsController::askForName() {
  auto* dialog = new QInputDialog(&bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Save this view"));
  dialog->setLabelText(tr("Name of the view"));
  dialog->setTextValue(freeName());
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
    if (!name.trimmed().isEmpty()) save(name.trimmed());
  });
  dialog->open();
}

void NamedViewsController::manage() {
  auto* dialog = new NamedViewsDialog(views_, &bench_.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &NamedViewsDialog::chosen, this, &NamedViewsController::goTo);
  connect(dialog, &NamedViewsDialog::edited, this, &NamedViewsController::setViews);
  dialog->open();
}

void NamedViewsController::addCommands() {
  bench_.scripts.add("save-view", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    save(QString::fromStdString(words[0]));
    return Done{};
  });
  bench_.scripts.add("go-to-view", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    const QString name = QString::fromStdString(words[0]);
    const auto view =
        std::find_if(views_.begin(), views_.end(), [&](const NamedView& known) { return known.name == name; });
    if (view == views_.end()) return wrongCommand("there is no view '" + words[0] + "'");
    goTo(*view);
    return Done{};
  });
}

}  // namespace glissade
