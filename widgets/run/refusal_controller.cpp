#include "widgets/run/refusal_controller.h"

#include <QEvent>

#include <algorithm>

#include "widgets/controls/diagnostic_text.h"
#include "widgets/controls/length_text.h"
#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Maximum number of bodies that are named one by one.
constexpr std::size_t kMostNamed = 4;
/// Ratio of the viewed region to the region where the surfaces meet.
constexpr double kSurroundings = 3.0;

bool touches(const EndConflict& conflict) { return conflict.overlap || conflict.distance == 0.0; }

QString factOf(const EndConflict& conflict, const LoadedScenario& scenario, double required) {
  const QString name = QString::fromStdString(scenario.obstacles[conflict.obstacle].shown());
  if (conflict.overlap) return RefusalController::tr("'%1': overlap %2").arg(name, lengthText(*conflict.overlap));
  if (conflict.distance == 0.0) return RefusalController::tr("'%1': touches or overlaps").arg(name);
  return RefusalController::tr("'%1': %2 away, required %3")
      .arg(name, lengthText(conflict.distance), lengthText(required));
}

/// The sentence about the first conflict, which has the largest overlap.
QString titleOf(const EndConflicts& found, const LoadedScenario& scenario, double required) {
  const EndConflict& first = found.conflicts.front();
  const QString object = QString::fromStdString(scenario.object.shown());
  const QString body = QString::fromStdString(scenario.obstacles[first.obstacle].shown());
  if (first.overlap) {
    return (found.atStart ? RefusalController::tr("Start pose collides: '%1' overlaps %2 by %3.")
                          : RefusalController::tr("Goal pose collides: '%1' overlaps %2 by %3."))
        .arg(object, body, lengthText(*first.overlap));
  }
  if (first.distance == 0.0) {
    return (found.atStart ? RefusalController::tr("Start pose collides: '%1' touches or overlaps %2.")
                          : RefusalController::tr("Goal pose collides: '%1' touches or overlaps %2."))
        .arg(object, body);
  }
  return (found.atStart ? RefusalController::tr("Start pose too close: '%1' is %2 away from %3, required %4.")
                        : RefusalController::tr("Goal pose too close: '%1' is %2 away from %3, required %4."))
      .arg(object, lengthText(first.distance), body, lengthText(required));
}

/// Marks the pair as an accepted fit. An overlap within a fit's allowance is no refusal.
void accept(FitSettings& fits, const BodyId& object, const BodyId& body) {
  const auto isPair = [&](const FitEdit& edit) {
    return (edit.a == object && edit.b == body) || (edit.a == body && edit.b == object);
  };
  auto found = std::find_if(fits.pairs.begin(), fits.pairs.end(), isPair);
  if (found == fits.pairs.end()) found = fits.pairs.insert(found, {object, body, {}, {}, false});
  found->accepted = true;
  found->allowance.reset();
}

}  // namespace

RefusalController::RefusalController(const Workbench& bench)
    : QObject(&bench.window),
      bench_(bench),
      bar_(new NoticeBar(bench.actions, bench.scene.widget(), kRoomForViewCube)) {
  connect(bar_, &NoticeBar::closed, this, &RefusalController::close);
  bar_->installEventFilter(this);
  bench.enable("refusal.close", false);
  connect(&examination_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&bench.run, &ShownRun::changed, this, &RefusalController::followRun);
  connect(&bench.document, &WorkbenchDocument::changed, this, &RefusalController::followDocument);
  connectActions();
  enableActions();
  addCommands();
}

void RefusalController::connectActions() {
  bench_.onAction("refusal.show", this, [this] { zoomToConflicts(); });
  bench_.onAction("refusal.allow", this, [this] { allowAsFits(); });
  bench_.onAction("refusal.close", this, [this] {
    bar_->hide();
    close();
  });
}

/// Enables the action that closes the message while the message is shown, and writes its lengths in another unit.
bool RefusalController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::LocaleChange && !bar_->isHidden()) showAgain();
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) {
    bench_.enable("refusal.close", !bar_->isHidden());
  }
  return QObject::eventFilter(watched, event);
}

void RefusalController::followDocument(Changes what) {
  if (what & Change::Scenario) {
    examination_.cancel();
    noticed_.clear();
    bar_->hide();
    mark(nullptr);
  } else if (what & Change::Arrangement) {
    examination_.cancel();
    if (conflicts_) {
      examineEnds();
    } else if (!bar_->isHidden()) {
      showAgain();  // bodies may have other names
    }
  }
}

void RefusalController::showAgain() {
  if (conflicts_) {
    showConflicts();
  } else if (bench_.run.snapshot()) {
    noticed_.clear();
    followRun(bench_.run.snapshot());
  }
}

void RefusalController::followRun(const SnapshotPtr& snapshot) {
  const bool refusedPath = snapshot->refused != nullptr && bench_.run.isLive();
  QString said;
  if (snapshot->problem) {
    said = QString::number(snapshot->run) + QString::fromStdString(toString(*snapshot->problem));
  } else if (refusedPath) {
    said = QString::number(reinterpret_cast<quintptr>(snapshot->refused.get()));
  }
  if (said == noticed_) return;
  noticed_ = said;
  if (snapshot->problem) {
    showProblem(*snapshot);
  } else if (refusedPath) {
    showRefusedPath(*snapshot->refused);
  } else if (snapshot->state != SessionState::Idle || !conflicts_) {
    examination_.cancel();
    bar_->hide();
    mark(nullptr);
  }
}

void RefusalController::showProblem(const SessionSnapshot& snapshot) {
  const Diagnostic& why = *snapshot.problem;
  Notice notice{tr("The run ended without a path."), diagnosticText(why), {}};
  const std::string place = toString(why.location);
  const bool atEnds = place == "start" || place == "goal";
  if (atEnds) {
    notice.title = place == "start" ? tr("The start pose cannot be used.") : tr("The goal pose cannot be used.");
  }
  switch (why.kind) {
    case ErrorKind::InCollision: notice.actions = {"refusal.show", "refusal.allow", "assembly.free-ends"}; break;
    case ErrorKind::MalformedInput: notice.actions = {"assembly.fit-workspace"}; break;
    case ErrorKind::NoPath:
      if (atEnds) break;  // the end is in a forbidden place
      [[fallthrough]];
    case ErrorKind::LimitReached: notice.actions = {"assist.go", "difficulty.find", "run.restart-new-seed"}; break;
    default: break;
  }
  bar_->showNotice(notice);
  if (why.kind == ErrorKind::InCollision) examineEnds();
}

void RefusalController::showRefusedPath(const PathExamination& refused) {
  Notice notice{tr("The path is no longer valid."), {}, {"path.first-blocked", "run.start"}};
  if (!refused.blocked.empty()) {
    const int body = refused.blocked.front().nearest.body;
    notice.details = tr("%n of %1 edges are blocked.", "", static_cast<int>(refused.blocked.size()))
                         .arg(std::max<std::size_t>(1, refused.path.points.size() - 1));
    if (body == kForbiddenPlace) {
      notice.details += QLatin1Char(' ') + tr("The first leads through a forbidden place.");
    } else if (body >= 0) {
      const auto& obstacles = bench_.document.scenario()->obstacles;
      notice.details +=
          QLatin1Char(' ') + tr("The first is blocked by '%1'.")
                                 .arg(QString::fromStdString(obstacles[static_cast<std::size_t>(body)].shown()));
    }
  } else {
    notice.details = tr("It no longer leads from the start pose to the goal pose.");
  }
  mark(nullptr);
  bar_->showNotice(notice);
}

void RefusalController::examineEnds() {
  const double required = bench_.document.settings().parameters[ParameterId::RequiredClearance];
  const auto examine = [this, required,
                        scenario = bench_.document.scenario()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    auto found = findEndConflicts(*scenario, required, watch.stop);
    return [this, found = std::move(found)] { takeConflicts(found); };
  };
  examination_.start(GLISSADE_TEXT("examining start and goal"), examine, bench_.work.isAtOnce());
}

void RefusalController::takeConflicts(const std::optional<EndConflicts>& found) {
  if (found) {
    mark(std::make_shared<const EndConflicts>(*found));
    showConflicts();
    return;
  }
  if (conflicts_) bench_.messages.showStatus(tr("Start and goal have no collisions now. Press Find path (F5)."));
  mark(nullptr);
  bar_->hide();
}

void RefusalController::showConflicts() {
  const ScenarioPtr& scenario = bench_.document.scenario();
  const double required = bench_.document.settings().parameters[ParameterId::RequiredClearance];
  const std::vector<EndConflict>& all = conflicts_->conflicts;
  QStringList facts;
  if (all.size() > 1) {
    for (std::size_t i = 0; i < std::min(all.size(), kMostNamed); ++i) facts << factOf(all[i], *scenario, required);
  }
  if (all.size() > kMostNamed) facts << tr("and %n more", "", static_cast<int>(all.size() - kMostNamed));
  bar_->showNotice({titleOf(*conflicts_, *scenario, required),
                    facts.join(QStringLiteral("\n")),
                    {"refusal.show", "refusal.allow", "assembly.free-ends"}});
}

void RefusalController::mark(std::shared_ptr<const EndConflicts> conflicts) {
  conflicts_ = std::move(conflicts);
  bench_.scene.view().setRefusal(conflicts_);
  bench_.scene.refresh();
  enableActions();
}

/// Shows the region where the surfaces meet, with its surroundings, or the object if there is no such region.
void RefusalController::zoomToConflicts() {
  const LoadedScenario& scenario = *bench_.document.scenario();
  const Box3 object = boundingBox(*scenario.object.mesh, conflicts_->q);
  Box3 box;
  for (const EndConflict& conflict : conflicts_->conflicts) {
    for (const Vector3& p : conflict.cut) box.extend(p);
  }
  if (box.isEmpty()) box = object;
  const Vector3 middle = box.center();
  Vector3 half = 0.5 * kSurroundings * box.sizes();
  half = half.cwiseMax(Vector3::Constant(0.1 * object.diagonal().norm()));
  bench_.scene.view().camera().zoomTo(Box3(middle - half, middle + half));
  bench_.scene.refresh();
}

void RefusalController::allowAsFits() {
  std::vector<BodyId> bodies;
  for (const EndConflict& conflict : conflicts_->conflicts) {
    if (touches(conflict)) bodies.push_back(bench_.document.scenario()->obstacles[conflict.obstacle].id);
  }
  const auto change = [bodies, object = bench_.document.scenario()->objectBodies](Scenario& scenario) {
    scenario.fits.on = true;
    for (const BodyId& body : bodies) {
      for (const RigidBody& moving : object) accept(scenario.fits, moving.id, body);
    }
    return Outcome(Done{});
  };
  const Outcome edited = bench_.document.edit(tr("Allow as fits"), change);
  if (!edited) bench_.messages.showError(tr("This cannot be allowed as a fit"), edited.error());
}

void RefusalController::close() {
  examination_.cancel();
  mark(nullptr);
  bench_.scene.widget()->setFocus();
}

void RefusalController::enableActions() {
  bench_.enable("refusal.show", conflicts_ != nullptr);
  bench_.enable("refusal.allow",
                conflicts_ && std::any_of(conflicts_->conflicts.begin(), conflicts_->conflicts.end(), touches));
}

void RefusalController::addCommands() {
  bench_.scripts.add("expect-refusal", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    std::string found = "none";
    if (bar_->isVisible()) found = "other";
    if (conflicts_) found = bench_.document.scenario()->obstacles[conflicts_->conflicts.front().obstacle].id.text();
    if (found == words[0]) return Done{};
    return unmetExpectation("what is refused is '" + found + "', not '" + words[0] + "'");
  });
}

}  // namespace glissade
