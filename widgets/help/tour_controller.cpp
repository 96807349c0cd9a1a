#include "widgets/help/tour_controller.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMenuBar>
#include <QToolBar>

#include <sstream>

#include "widgets/files/sample_scenarios.h"

namespace glissade {
namespace {

QString tourText(const char* text) { return QCoreApplication::translate("Tour", text); }

bool holds(const QMenu& menu, const QAction* action) {
  for (const QAction* entry : menu.actions()) {
    if (entry == action || (entry->menu() != nullptr && holds(*entry->menu(), action))) return true;
  }
  return false;
}

QRect inWindow(const QMainWindow& window, const QWidget& widget, const QRect& part) {
  return widget.isVisible() ? QRect(widget.mapTo(&window, part.topLeft()), part.size()) : QRect();
}

QRect partOfAction(const QMainWindow& window, QAction* action) {
  for (const QToolBar* bar : window.findChildren<QToolBar*>()) {
    const QWidget* button = bar->widgetForAction(action);
    if (button != nullptr && button->isVisible()) return inWindow(window, *button, button->rect());
  }
  const QMenuBar* menus = window.menuBar();
  for (QAction* entry : menus->actions()) {
    if (entry->menu() != nullptr && holds(*entry->menu(), action)) {
      return inWindow(window, *menus, menus->actionGeometry(entry));
    }
  }
  return {};
}

/// The words of a command, with `report` in place of "{report}".
ScriptCommands::Words wordsOf(const char* line, const QString& report) {
  std::istringstream stream(line);
  ScriptCommands::Words words;
  for (std::string word; stream >> word;) {
    if (word == "{report}") word = report.toStdString();
    words.push_back(word);
  }
  return words;
}

}  // namespace

QRect partOf(const QMainWindow& window, const ActionCatalogue& actions, const QString& target) {
  if (QAction* action = actions.find(target)) return partOfAction(window, action);
  const auto* widget = window.findChild<QWidget*>(target);
  return widget != nullptr ? inWindow(window, *widget, widget->rect()) : QRect();
}

TourController::TourController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      panel_(new TourPanel(bench.scene.widget())),
      frame_(new TourFrame(&bench.window)),
      escape_(new QShortcut(Qt::Key_Escape, &bench.window)),
      samples_(samplesFolder(QCoreApplication::applicationDirPath())) {
  bench.onAction("help.tour", this, [this] { start(); });
  connect(panel_, &TourPanel::next, this, &TourController::next);
  connect(panel_, &TourPanel::back, this, [this] { go(*current_ - 1); });
  connect(panel_, &TourPanel::end, this, [this] { go(std::nullopt); });
  connect(panel_, &TourPanel::stepRequested, this, [this] {
    if (const Outcome done = doStep(); !done) bench_.messages.showError(tr("This cannot be done"), done.error());
  });
  connect(escape_, &QShortcut::activated, this, [this] { go(std::nullopt); });
  // Esc cancels background work first.
  connect(bench.actions["work.cancel"], &QAction::changed, this,
          [this] { escape_->setEnabled(current_ && !bench_.actions["work.cancel"]->isEnabled()); });
  escape_->setEnabled(false);
  for (const ActionSpec& spec : bench.actions.specs()) {
    const QString id = QLatin1String(spec.id);
    connect(bench.actions[id], &QAction::triggered, this, [this, id] { noteAction(id); });
  }
  connect(&bench.document, &WorkbenchDocument::changed, this, &TourController::check);
  connect(&bench.document.semantics(), &SemanticDocument::selectionChanged, this, &TourController::check);
  connect(&bench.run, &ShownRun::changed, this, &TourController::check);
  for (const char* possible : {"sequence.export", "section.remove-all"}) {
    connect(bench.actions[QLatin1String(possible)], &QAction::changed, this, &TourController::check);
  }
  bench.window.installEventFilter(this);
  addCommands();
}

void TourController::start() { go(0); }

void TourController::go(std::optional<std::size_t> to) {
  current_ = to;
  escape_->setEnabled(current_ && !bench_.actions["work.cancel"]->isEnabled());
  if (!current_) {
    panel_->hide();
    frame_->mark({});
    bench_.scene.widget()->setFocus();
    return;
  }
  isDone_ = step().isDone != nullptr && step().isDone(bench_);
  panel_->showStep(static_cast<int>(*current_) + 1, static_cast<int>(tourSteps().size()), tourText(step().title),
                   tourText(step().text));
  panel_->setDone(isDone_);
  markTarget();
}

void TourController::next() {
  const bool last = *current_ + 1 == tourSteps().size();
  go(last ? std::nullopt : std::make_optional(*current_ + 1));
}

void TourController::noteAction(const QString& id) {
  if (!current_) return;
  if (step().isDone != nullptr) {
    check();
  } else if (id == QLatin1String(step().target)) {
    next();
  }
}

void TourController::check() {
  if (!current_) return;
  markTarget();
  if (isDone_ || step().isDone == nullptr || !step().isDone(bench_)) return;
  next();
}

Outcome TourController::doStep() {
  const std::size_t before = *current_;
  for (const char* line : step().commands) {
    ScriptCommands::Words words = wordsOf(line, folder_.filePath(QStringLiteral("report.html")));
    std::string name = words.front();
    words.erase(words.begin());
    if (name == "open-sample" && isOfTour(bench_)) {
      name = "open";  // "open" asks no question
      words[0] = samples_.filePath(QString::fromStdString(words[0])).toStdString();
    }
    if (const Outcome done = bench_.scripts.carryOut(name, words); !done) return done;
  }
  if (current_ == before && step().isDone == nullptr) next();
  return Done{};
}

void TourController::markTarget() {
  frame_->mark(current_ ? partOf(bench_.window, bench_.actions, QLatin1String(step().target)) : QRect());
}

bool TourController::eventFilter(QObject* watched, QEvent* event) {
  if (current_ && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)) markTarget();
  return QObject::eventFilter(watched, event);
}

void TourController::addCommands() {
  using Words = ScriptCommands::Words;
  bench_.scripts.add("tour", 1, [this](const Words& words) -> Outcome {
    if (!current_) return wrongCommand("there is no tour", "Begin with 'action help.tour'.");
    if (words[0] == "do") return doStep();
    if (words[0] == "next") {
      next();
    } else if (words[0] == "back" && *current_ > 0) {
      go(*current_ - 1);
    } else if (words[0] == "end") {
      go(std::nullopt);
    } else {
      return wrongCommand("'" + words[0] + "' is not possible", "Say do, next, back or end.");
    }
    return Done{};
  });
  bench_.scripts.add("expect-tour-mark", 0, [this](const Words&) -> Outcome {
    if (current_ && frame_->isVisible()) return Done{};
    return unmetExpectation("nothing is marked");
  });
  bench_.scripts.add("expect-tour", 1, [this](const Words& words) -> Outcome {
    const std::string at = current_ ? std::to_string(*current_ + 1) : "none";
    if (at == words[0]) return Done{};
    return unmetExpectation("the tour is at step " + at + ", not " + words[0]);
  });
}

}  // namespace glissade
