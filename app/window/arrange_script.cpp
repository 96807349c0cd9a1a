#include "app/window/arrange_script.h"

#include <QApplication>
#include <QMouseEvent>

#include <array>

#include "app/window/arrange_controller.h"
#include "engine/base/number_text.h"
#include "engine/base/quantity_text.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

/// As kGizmoHandles.
constexpr std::array<const char*, 9> kHandleNames{"x", "y", "z", "yz", "zx", "xy", "rx", "ry", "rz"};

std::optional<GizmoHandle> handleNamed(const std::string& name) {
  for (std::size_t i = 0; i < kHandleNames.size(); ++i) {
    if (name == kHandleNames[i]) return kGizmoHandles[i];
  }
  return std::nullopt;
}

/// `words`: handle, pixels to the right, pixels down.
Outcome dragHandle(const GizmoOverlay& gizmo, QWidget* scene, const Words& words, bool release) {
  const auto handle = handleNamed(words[0]);
  const auto right = toNumber(words[1]);
  const auto down = toNumber(words[2]);
  if (!handle || !right || !down)
    return wrongCommand("there is no such handle or pixel", "Say x, yz or rz, and pixels.");
  const auto from = gizmo.pointOn(*handle);
  if (!from) return wrongCommand("the handle '" + words[0] + "' cannot be taken now");
  const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButtons buttons) {
    QMouseEvent event(type, at, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, buttons, Qt::NoModifier);
    QApplication::sendEvent(scene, &event);
  };
  const QPointF by(*right, *down);
  constexpr int kMoves = 8;
  send(QEvent::MouseMove, *from, Qt::NoButton);
  send(QEvent::MouseButtonPress, *from, Qt::LeftButton);
  for (int i = 1; i <= kMoves; ++i) send(QEvent::MouseMove, *from + by * i / kMoves, Qt::LeftButton);
  if (release) send(QEvent::MouseButtonRelease, *from + by, Qt::NoButton);
  return Done{};
}

Outcome setSteps(ArrangeController& arrange, const Words& words) {
  const auto distance = toMetres(words[0], 1e-3);
  const auto angle = toRadians(words[1], 3.14159265358979323846 / 180.0);
  if (!distance || !angle) return wrongCommand("these are no steps", "Say 10mm and 15deg.");
  arrange.bar().setSteps(*distance, *angle);
  arrange.takeSteps();
  return Done{};
}

Outcome hover(QWidget* scene, const Words& words) {
  const auto x = toNumber(words[0]);
  const auto y = toNumber(words[1]);
  if (!x || !y) return wrongCommand("these are no pixels");
  QMouseEvent event(QEvent::MouseMove, QPointF(*x, *y), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(scene, &event);
  return Done{};
}

Outcome expectText(const QString& is, const std::string& part) {
  const bool found = part == "none" ? is.isEmpty() : is.contains(QString::fromStdString(part));
  return found ? Outcome(Done{}) : unmetExpectation("the text is '" + is.toStdString() + "', without '" + part + "'");
}

}  // namespace

void addArrangeCommands(const Workbench& bench, ArrangeController& arrange) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("drag-handle", 3, [&bench, &arrange](const Words& words) {
    return dragHandle(arrange.tool().gizmo(), bench.scene.widget(), words, true);
  });
  scripts.add("hold-handle", 3, [&bench, &arrange](const Words& words) {
    return dragHandle(arrange.tool().gizmo(), bench.scene.widget(), words, false);
  });
  scripts.add("hover", 2, [&bench](const Words& words) { return hover(bench.scene.widget(), words); });
  scripts.add("expect-hint", 1,
              [&arrange](const Words& words) { return expectText(arrange.align().hint(), words[0]); });
  scripts.add("expect-snap", 1, [&arrange](const Words& words) { return expectText(arrange.bar().snap(), words[0]); });
  scripts.add("set-steps", 2, [&arrange](const Words& words) { return setSteps(arrange, words); });
  scripts.add("expect-arranging", 1, [&arrange](const Words& words) -> Outcome {
    const std::string is = arrange.bar().isVisible() ? "yes" : "no";
    return is == words[0] ? Outcome(Done{}) : unmetExpectation("arranging: '" + is + "', not '" + words[0] + "'");
  });
}

}  // namespace glissade
