#include "app/window/context_menus.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QContextMenuEvent>
#include <QMouseEvent>

#include <vector>

#include "engine/base/number_text.h"

namespace glissade {
namespace {

/// A press and a release within this distance are a click.
constexpr double kMenuClickPixels = 4.0;

using ActionIds = std::vector<const char*>;  ///< an empty id is a separator

const ActionIds kObjectMenu{"run.start",         "object.to-start", "", "assembly.start-here", "assembly.goal-here",
                            "assembly.goal-out", "assembly.swap",   "", "assembly.free-ends",  "assembly.arrange",
                            "operator.camera"};
const ActionIds kBodyMenu{"body.rename",        "body.properties", "", "view.zoom-selection", "body.hide",
                          "body.isolate",       "body.show-all",   "", "assembly.moves",      "sequence.stays",
                          "assembly.leave-out", "assembly.remove", "", "fits.find",           "assembly.arrange"};
const ActionIds kDisplayMenu{"display-selected.shaded-edges", "display-selected.shaded", "display-selected.see-through",
                             "display-selected.wireframe", "display-selected.as-view"};
const ActionIds kPlaceMenu{"place.forbid", "place.prefer", "milestone.set", "milestone.reset", "", "layer.places"};
const ActionIds kSceneMenu{"view.fit", "view.isometric",    "view.front",   "view.left",   "view.top",
                           "",         "view.orthographic", "layer.places", "layer.graph", "body.show-all",
                           "",         "assembly.add"};

struct TableMenu {
  const char* table;  ///< object name
  ActionIds actions;
};

const std::vector<TableMenu>& tableMenus() {
  static const std::vector<TableMenu> menus{
      {"steps", {"place.forbid", "place.prefer", "milestone.set", "milestone.reset"}},
      {"semantics-tree", {"place.forbid", "place.prefer", "attribute.add", "view.zoom-selection"}},
      {"attributes", {"attribute.add", "attribute.rename", "attribute.remove", "attribute.remove-strays"}},
      {"difficulty-rows", {"difficulty.find", "difficulty.play", "assist.go", "layer.difficulty", "layer.help"}},
      {"log-messages", {"log.copy"}},
  };
  return menus;
}

void fill(QMenu& menu, const ActionCatalogue& actions, const ActionIds& ids) {
  for (const char* id : ids) {
    if (id[0] == '\0') {
      menu.addSeparator();
    } else {
      menu.addAction(actions[QLatin1String(id)]);
    }
  }
}

}  // namespace

ContextMenus::ContextMenus(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  bench.scene.widget()->installEventFilter(this);
  addTableMenus();
  bench.onAction("edit.context-menu", this, [this] { openByKeyboard(); });
  addCommands();
}

void ContextMenus::openByKeyboard() {
  QWidget* widget = bench_.window.focusWidget();
  if (widget == nullptr) widget = bench_.scene.widget();
  const auto* table = qobject_cast<QAbstractItemView*>(widget);
  const QRect row = table != nullptr ? table->visualRect(table->currentIndex()) : QRect();
  const QPoint position = (row.isValid() ? row : widget->rect()).center();
  QContextMenuEvent event(QContextMenuEvent::Keyboard, position, widget->mapToGlobal(position));
  QCoreApplication::sendEvent(widget, &event);
}

void ContextMenus::addTableMenus() {
  for (const TableMenu& menu : tableMenus()) {
    auto* table = bench_.window.findChild<QWidget*>(QLatin1String(menu.table));
    for (const char* id : menu.actions) table->addAction(bench_.actions[QLatin1String(id)]);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
  }
}

bool ContextMenus::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: return handleMouse(*static_cast<QMouseEvent*>(event));
    case QEvent::ContextMenu: {
      const auto& menu = *static_cast<QContextMenuEvent*>(event);
      // The press of the mouse button opened the menu already.
      if (menu.reason() != QContextMenuEvent::Mouse) open(false, bench_.scene.widget()->rect().center());
      return true;
    }
    default: return QObject::eventFilter(watched, event);
  }
}

/// Never consumes an event, because the camera needs all of them.
bool ContextMenus::handleMouse(const QMouseEvent& event) {
  if (event.type() == QEvent::MouseButtonPress) {
    pressed_ = event.button() == Qt::RightButton && event.buttons() == Qt::RightButton
                   ? std::make_optional(event.localPos())
                   : std::nullopt;
  } else if (pressed_ && (event.localPos() - *pressed_).manhattanLength() >= kMenuClickPixels) {
    pressed_.reset();
  } else if (pressed_ && event.type() == QEvent::MouseButtonRelease) {
    pressed_.reset();
    if (!bench_.document.scenario()) return false;
    const SceneTarget target = targetAt(bench_, event.localPos());
    if (!target.isObject) select(target);
    open(target.isObject, event.pos());
  }
  return false;
}

void ContextMenus::select(const SceneTarget& target) {
  SemanticDocument& semantics = bench_.document.semantics();
  SemanticSelection selection;
  if (target.body) selection.bodies.insert(*target.body);
  if (target.place != kNoPlace) selection.places.insert(target.place);
  const SemanticSelection& present = semantics.selection();
  if (!semantics.selectedBodies().contains(selection.bodies) || !present.places.contains(selection.places) ||
      selection == SemanticSelection{}) {
    semantics.select(selection);
  }
}

void ContextMenus::open(bool isObject, const QPoint& position) {
  if (!bench_.document.scenario()) return;
  delete menu_;
  menu_ = new QMenu(bench_.scene.widget());
  menu_->setObjectName(QStringLiteral("context-menu"));
  menu_->setAttribute(Qt::WA_DeleteOnClose);
  const SemanticSelection& selection = bench_.document.semantics().selection();
  if (isObject) {
    fill(*menu_, bench_.actions, kObjectMenu);
  } else if (!selection.places.isEmpty()) {
    fill(*menu_, bench_.actions, kPlaceMenu);
  } else if (!selection.bodies.isEmpty()) {
    fill(*menu_, bench_.actions, kBodyMenu);
    fill(*menu_->addMenu(tr("&Display")), bench_.actions, kDisplayMenu);
  } else {
    fill(*menu_, bench_.actions, kSceneMenu);
  }
  menu_->popup(bench_.scene.widget()->mapToGlobal(position));
}

void ContextMenus::addCommands() {
  using Words = ScriptCommands::Words;
  bench_.scripts.add("right-click", 2, [this](const Words& words) -> Outcome {
    const auto x = toNumber(words[0]);
    const auto y = toNumber(words[1]);
    if (!x || !y) return wrongCommand("these are no pixels", "Give numbers.");
    for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
      const Qt::MouseButtons held = type == QEvent::MouseButtonPress ? Qt::RightButton : Qt::NoButton;
      QMouseEvent event(type, QPointF(*x, *y), Qt::RightButton, held, Qt::NoModifier);
      QCoreApplication::sendEvent(bench_.scene.widget(), &event);
    }
    return Done{};
  });
  bench_.scripts.add("expect-menu", 1, [this](const Words& words) -> Outcome {
    QAction* action = bench_.actions.find(QString::fromStdString(words[0]));
    if (menu_ != nullptr && action != nullptr && menu_->actions().contains(action)) {
      return Done{};
    }
    return unmetExpectation("no context menu with '" + words[0] + "' is open");
  });
}

}  // namespace glissade
