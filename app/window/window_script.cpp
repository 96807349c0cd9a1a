#include "app/window/window_script.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMouseEvent>

#include <ctime>
#include <filesystem>
#include <sstream>

#include "app/window/window_picture.h"
#include "engine/base/file.h"
#include "engine/base/file_save.h"
#include "engine/base/memory_use.h"
#include "engine/base/number_text.h"
#include "widgets/controls/picture_file.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/workbench/scene_target.h"

namespace glissade {
namespace {

using Words = ScriptCommands::Words;

constexpr std::size_t kMostMeasured = 1U << 20;  ///< maximum bytes of a file to which measurements are appended

Outcome trigger(const ActionCatalogue& actions, const std::string& id) {
  QAction* action = actions.find(QString::fromStdString(id));
  if (action == nullptr) return wrongCommand("there is no action '" + id + "'");
  if (!action->isEnabled()) return wrongCommand("the action '" + id + "' is not possible now");
  action->trigger();
  return Done{};
}

Outcome pressKey(const Workbench& bench, const std::string& how, const std::string& key) {
  const QKeySequence sequence(QString::fromStdString(key));
  if (sequence.count() != 1) return wrongCommand("there is no key '" + key + "'");
  if (how != "press" && how != "release" && how != "tap") return wrongCommand("say press, release or tap");
  const auto send = [&](QEvent::Type type) {
    const int modifiers = sequence[0] & static_cast<int>(Qt::KeyboardModifierMask);
    QKeyEvent event(type, sequence[0] & ~modifiers, Qt::KeyboardModifiers(modifiers));
    QApplication::sendEvent(bench.scene.widget(), &event);
  };
  if (how != "release") send(QEvent::KeyPress);
  if (how == "tap") bench.session.advance(1);
  if (how != "press") send(QEvent::KeyRelease);
  return Done{};
}

/// Clicks if `pixels` are one point; drags if they are two.
Outcome pressMouse(QWidget* scene, const Words& pixels) {
  std::vector<double> numbers;
  for (const std::string& word : pixels) {
    const auto number = toNumber(word);
    if (!number) return wrongCommand("'" + word + "' is not a pixel", "Give numbers.");
    numbers.push_back(*number);
  }
  const auto send = [&](QEvent::Type type, const QPointF& at) {
    QMouseEvent event(type, at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(scene, &event);
  };
  const QPointF from(numbers[0], numbers[1]);
  const QPointF to(numbers[numbers.size() - 2], numbers.back());
  send(QEvent::MouseButtonPress, from);
  constexpr int kMoves = 8;
  for (int i = 1; i <= kMoves && to != from; ++i) send(QEvent::MouseMove, from + (to - from) * i / kMoves);
  send(QEvent::MouseButtonRelease, to);
  return Done{};
}

/// Clicks with the left button on a pixel that shows the body, the first one on a grid over the view.
Outcome clickBody(const Workbench& bench, const std::string& id) {
  constexpr int kGrid = 40;
  if (!bench.document.scenario()) return wrongCommand("no scenario is open");
  QWidget& widget = *bench.scene.widget();
  for (int i = 1; i < kGrid * kGrid; ++i) {
    const QPoint pixel(widget.width() * (i % kGrid) / kGrid, widget.height() * (i / kGrid) / kGrid);
    const SceneTarget target = targetAt(bench, pixel);
    const bool isIt = id == "object" ? target.isObject : target.body == QString::fromStdString(id);
    if (isIt) return pressMouse(&widget, {std::to_string(pixel.x()), std::to_string(pixel.y())});
  }
  return wrongCommand("the body '" + id + "' is not seen");
}

Outcome append(const std::string& line, const std::string& name) {
  const auto before =
      std::filesystem::exists(name) ? readFile(name, kMostMeasured) : Result<std::string>(std::string());
  if (!before) return before.error();
  Warnings warnings;
  return saveFile(name, *before + line, warnings);
}

/// Appends a line with seconds since the start, megabytes in main memory, megabytes after free memory was given back,
/// and allocated megabytes.
Outcome appendMemory(const QElapsedTimer& since, const std::string& name) {
  const double seconds = static_cast<double>(since.elapsed()) / 1000.0;
  const double resident = residentMegabytes();
  std::ostringstream line;
  line << seconds << " " << resident << " " << residentMegabytesAfterTrim() << " " << allocatedMegabytes() << "\n";
  return append(line.str(), name);
}

/// Turns the camera around once in this number of pictures. Appends a line with seconds of the first picture, pictures
/// a second during the turn, seconds of one more picture, and seconds of processor time for each picture of the turn.
Outcome measureTurning(SceneWidget& scene, const std::string& pictures, const std::string& name) {
  const auto count = toNumber(pictures);
  if (!count || *count < 1.0) return wrongCommand("'" + pictures + "' is not a number of pictures", "Give 1 or more.");
  const auto secondsOfPicture = [&scene] {
    QElapsedTimer timer;
    timer.start();
    scene.refresh();
    QCoreApplication::processEvents();  // paints
    return static_cast<double>(timer.nsecsElapsed()) / 1e9;
  };
  const double first = secondsOfPicture();
  double turning = 0.0;
  const std::clock_t before = std::clock();
  for (int i = 0; i < static_cast<int>(*count); ++i) {
    scene.view().camera().orbit(2.0 / *count, 0.0);  // a drag over the view's height turns by half a turn
    turning += secondsOfPicture();
  }
  const double work = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  std::ostringstream line;
  line << first << " " << *count / turning << " " << secondsOfPicture() << " " << work / *count << "\n";
  return append(line.str(), name);
}

}  // namespace

void addWindowCommands(const Workbench& bench) {
  ScriptCommands& scripts = bench.scripts;
  scripts.add("action", 1, [&bench](const Words& words) { return trigger(bench.actions, words[0]); });
  scripts.add("key", 2, [&bench](const Words& words) { return pressKey(bench, words[0], words[1]); });
  for (const auto& [name, count] : {std::pair("click", 2), std::pair("drag", 4)}) {
    scripts.add(name, static_cast<std::size_t>(count),
                [&bench](const Words& words) { return pressMouse(bench.scene.widget(), words); });
  }
  scripts.add("click-body", 1, [&bench](const Words& words) { return clickBody(bench, words[0]); });
  scripts.add("screenshot", 1, [&bench](const Words& words) -> Outcome {
    return outcomeOf(savePicture(pictureOf(bench.window), QString::fromStdString(words[0])));
  });
  scripts.add("measure-turning", 2,
              [&bench](const Words& words) { return measureTurning(bench.scene, words[0], words[1]); });
  QElapsedTimer since;
  since.start();
  scripts.add("memory", 1, [since](const Words& words) { return appendMemory(since, words[0]); });
}

}  // namespace glissade
