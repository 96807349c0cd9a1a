#include "widgets/measure/measure_controller.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <numbers>

#include "engine/fits/contact_report.h"
#include "widgets/controls/length_text.h"
#include "widgets/scene3d/camera_controller.h"
#include "widgets/workbench/scene_ray.h"

namespace glissade {
namespace {

using Kind = MeasureController::Kind;

constexpr std::array<std::pair<const char*, Kind>, 6> kKinds{{{"measure.distance", Kind::Distance},
                                                              {"measure.angle", Kind::Angle},
                                                              {"measure.radius", Kind::Radius},
                                                              {"measure.clearance", Kind::Clearance},
                                                              {"assembly.pick-frame", Kind::Frame},
                                                              {"section.pick-face", Kind::Section}}};

QString degreesText(double radians) {
  return QLocale().toString(radians * 180.0 / std::numbers::pi, 'f', 2) + QStringLiteral("°");
}

/// The text about a round face.
QString radiusText(const MeasureFeature& feature) {
  const QString radius = lengthText(feature.radius);
  if (feature.kind == MeasureFeature::Kind::Torus) {
    return MeasureController::tr("Torus: radius of the circle %1, of the tube %2")
        .arg(radius, lengthText(feature.tubeRadius));
  }
  const QString text = MeasureController::tr("Radius %1, diameter %2").arg(radius, lengthText(2.0 * feature.radius));
  if (feature.kind != MeasureFeature::Kind::Cone) return text;
  return text + MeasureController::tr(" there; half angle of the cone %1").arg(degreesText(feature.halfAngle));
}

/// Adds the marks of a clicked vertex, edge or face.
void addTo(MeasurePicture& picture, const MeasureFeature& feature) {
  picture.points.push_back(feature.picked);
  if (feature.kind == MeasureFeature::Kind::Edge) {
    picture.segments.insert(picture.segments.end(), {feature.from, feature.to});
  }
  if (feature.isTurned() || feature.kind == MeasureFeature::Kind::Sphere) {
    picture.segments.insert(picture.segments.end(), {feature.picked, feature.axisPoint});
  }
}

struct Clearance {
  MeasuredDistance distance;
  std::optional<double> overlap;
};

Clearance clearanceOf(const RigidBody& a, const RigidBody& b, const StopToken& stop) {
  const auto world = CollisionWorld::build({b}, a.mesh);
  const NearestObstacle nearest = world->makeQuery()->nearestObstacle(a.X_WB);
  Clearance clearance{{nearest.distance, nearest.p_WPn, nearest.p_WPo}, std::nullopt};
  if (nearest.distance > 0.0) return clearance;
  const std::vector<ContactBody> bodies{{a.id, a.mesh, a.X_WB}, {b.id, b.mesh, b.X_WB}};
  for (const Contact& contact : findContacts(bodies, {}, stop).contacts) {
    if (contact.overlap > 0.0) clearance.overlap = contact.overlap;
  }
  return clearance;
}

}  // namespace

MeasureController::MeasureController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), store_(bench), hint_(new SceneHint(bench.scene.widget())) {
  bench.scene.widget()->installEventFilter(this);
  connect(&measuring_, &BackgroundTask::failed, &bench.work, &WorkController::reportFailure);
  connect(&bench.document, &WorkbenchDocument::changed, this, [this](Changes what) {
    if (what & Change::Scenario) setKind(Kind::None);
    if (what & (Change::Scenario | Change::Arrangement)) clear();
    for (const auto& [id, kind] : kKinds) {
      if (kind != Kind::Section) bench_.enable(id, true);  // the number of sections is limited
    }
  });
  connectActions();
  addCommands();
}

void MeasureController::connectActions() {
  for (const auto& [id, kind] : kKinds) {
    bench_.enable(id, false);
    bench_.onAction(id, this, [this, kind = kind](bool on) { setKind(on ? kind : Kind::None); });
  }
  for (const char* other : {"assembly.arrange", "assembly.align"}) {
    connect(bench_.actions[QLatin1String(other)], &QAction::toggled, this, [this](bool on) {
      if (!on) return;
      setKind(Kind::None);
      clear();
    });
  }
  bench_.enable("measure.clear", false);
  bench_.onAction("measure.clear", this, [this] { clear(); });
  bench_.enable("measure.copy", false);
  bench_.onAction("measure.copy", this, [this] { QGuiApplication::clipboard()->setText(result_); });
}

void MeasureController::setKind(Kind kind) {
  if (kind == kind_) return;
  kind_ = kind;
  for (const auto& [id, other] : kKinds) bench_.actions[QLatin1String(id)]->setChecked(other == kind);
  clear();
  if (kind == Kind::None) {
    bench_.scene.widget()->unsetCursor();
  } else {
    bench_.actions["assembly.arrange"]->setChecked(false);
    bench_.actions["assembly.align"]->setChecked(false);
    bench_.scene.widget()->setCursor(Qt::CrossCursor);
    bench_.scene.widget()->setFocus();
  }
}

void MeasureController::clear() {
  store_.cancel();
  measuring_.cancel();
  features_.clear();
  bodies_.clear();
  result_.clear();
  bench_.scene.view().setMeasure({});
  bench_.scene.refresh();
  for (const char* id : {"measure.clear", "measure.copy"}) bench_.enable(id, false);
  showHint();
}

bool MeasureController::eventFilter(QObject* watched, QEvent* event) {
  if (kind_ == Kind::None) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    setKind(Kind::None);
    return true;
  }
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease) {
    return QObject::eventFilter(watched, event);
  }
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  if (mouse.button() != Qt::LeftButton) return QObject::eventFilter(watched, event);
  if (const auto clicked = clicks_.follow(mouse)) click(*clicked);
  // A click selects nothing while measuring is on.
  return event->type() == QEvent::MouseButtonRelease || QObject::eventFilter(watched, event);
}

std::optional<MeasureController::Picked> MeasureController::pick(const Ray& ray) const {
  const SceneView& view = bench_.scene.view();
  std::vector<RigidBody> bodies = view.drawnObstacles();
  std::optional<BodyHit> hit = pickBody(bodies, ray, {}, view.sections());
  if (view.layerVisible(SceneLayer::Object) && !view.showsSequence()) {
    RigidBody object = bench_.document.scenario()->object;
    object.X_WB = view.objectPose();
    const auto onObject = pickBody({object}, ray);
    if (onObject && (!hit || onObject->distance < hit->distance)) {
      bodies.push_back(object);
      hit = BodyHit{bodies.size() - 1, onObject->distance, onObject->triangle};
    }
  }
  if (!hit) return std::nullopt;
  const Vector3 p_W = ray.origin + hit->distance * ray.direction;
  const double pixel = view.camera().viewHeightAt(p_W) / std::max(1, bench_.scene.widget()->height());
  return Picked{bodies[hit->body], *hit, p_W, kFeaturePixels * pixel};
}

void MeasureController::click(const QPointF& position) {
  const auto picked = pick(rayThrough(bench_.scene, position));
  if (!picked) return;
  if (!result_.isEmpty()) clear();
  if (kind_ == Kind::Clearance) {
    addBody(picked->body);
  } else {
    takeFeature(*picked);
  }
}

void MeasureController::measureAlong(const Ray& ray) {
  setKind(Kind::None);
  if (!result_.isEmpty()) clear();
  const auto picked = pick(ray);
  if (!picked) return;
  MeasureFeature point;
  point.kind = MeasureFeature::Kind::Vertex;
  point.picked = picked->p_W;
  addFeature(point);
}

void MeasureController::takeFeature(const Picked& picked) {
  const MeshFeaturesPtr known = store_.find(picked.body.mesh);
  if (!known) {
    hint_->write(tr("Finding edges and faces of the body…"));
    store_.prepare(picked.body.mesh, [this, picked] { takeFeature(picked); });
  } else if (kind_ == Kind::Frame) {
    takeFrame(picked, known->measurable);
  } else {
    const Vector3 p_B = inverse(picked.body.X_WB) * picked.p_W;
    const double snap = kind_ == Kind::Radius || kind_ == Kind::Section ? 0.0 : picked.snap;
    const MeasureFeature feature =
        placed(known->measurable.featureAt(picked.hit.triangle, p_B, snap), picked.body.X_WB);
    if (kind_ == Kind::Section) {
      setKind(Kind::None);
      emit facePicked(feature);
    } else {
      addFeature(feature);
    }
  }
}

void MeasureController::takeFrame(const Picked& picked, const MeasurableMesh& mesh) {
  const auto frame = mesh.frameAt(picked.hit.triangle);
  if (!frame) {
    show(tr("This is neither a plane nor a round face with an axis or a centre."), {});
    return;
  }
  setKind(Kind::None);
  emit framePicked(picked.body, *frame);
}

void MeasureController::addFeature(const MeasureFeature& feature) {
  features_.push_back(feature);
  MeasurePicture picture;
  for (const MeasureFeature& clicked : features_) addTo(picture, clicked);
  bench_.scene.view().setMeasure(picture);
  bench_.scene.refresh();
  if (features_.size() == (kind_ == Kind::Radius ? 1U : 2U)) {
    measureFeatures();
  } else {
    showHint();
  }
}

void MeasureController::measureFeatures() {
  const MeasureFeature& a = features_.front();
  const MeasureFeature& b = features_.back();
  MeasurePicture picture;
  for (const MeasureFeature& clicked : features_) addTo(picture, clicked);
  if (kind_ == Kind::Radius) {
    if (!a.isTurned() && a.kind != MeasureFeature::Kind::Sphere) {
      show(tr("This is no face of a cylinder, a cone, a sphere or a torus."), picture);
      return;
    }
    picture.labels.push_back(lengthLabel(0.5 * (a.picked + a.axisPoint), a.radius, true));
    show(radiusText(a), picture);
  } else if (kind_ == Kind::Angle) {
    const auto angle = angleBetweenFeatures(a, b);
    if (!angle) {
      show(tr("A vertex, a sphere or a free surface has no direction: click edges, planes or faces with an axis."),
           picture);
      return;
    }
    const QString text = degreesText(*angle);
    picture.labels.push_back({0.5 * (a.picked + b.picked), text.toStdString(), true});
    show(tr("Angle %1").arg(text), picture);
  } else {
    const MeasuredDistance distance = distanceBetween(a, b);
    showDistance(tr("Distance %1").arg(lengthText(distance.metres)), distance);
  }
}

void MeasureController::showDistance(const QString& text, const MeasuredDistance& distance) {
  MeasurePicture picture;
  for (const MeasureFeature& clicked : features_) addTo(picture, clicked);
  picture.points.insert(picture.points.end(), {distance.from, distance.to});
  picture.segments.insert(picture.segments.end(), {distance.from, distance.to});
  picture.labels.push_back(lengthLabel(0.5 * (distance.from + distance.to), distance.metres, true));
  const Vector3 along = distance.to - distance.from;
  show(text + tr(" (x %1, y %2, z %3)").arg(lengthText(along.x()), lengthText(along.y()), lengthText(along.z())),
       picture);
}

void MeasureController::addBody(const RigidBody& body) {
  if (!bodies_.empty() && bodies_.front().id == body.id) return;
  bodies_.push_back(body);
  if (bodies_.size() == 2) {
    measureClearance();
  } else {
    showHint();
  }
}

void MeasureController::measureClearance() {
  const auto measure = [this, a = bodies_.front(),
                        b = bodies_.back()](const WorkWatch& watch) -> BackgroundTask::Delivery {
    const Clearance clearance = clearanceOf(a, b, watch.stop);
    return [this, clearance, a, b] {
      const QString names =
          QStringLiteral("%1 – %2: ").arg(QString::fromStdString(a.shown()), QString::fromStdString(b.shown()));
      if (clearance.distance.metres > 0.0) {
        showDistance(names + tr("clearance %1").arg(lengthText(clearance.distance.metres)), clearance.distance);
      } else if (clearance.overlap) {
        show(names + tr("overlap %1").arg(lengthText(*clearance.overlap)), {});
      } else {
        show(names + tr("they touch"), {});
      }
    };
  };
  hint_->write(tr("Measuring the clearance…"));
  measuring_.start(GLISSADE_TEXT("measuring a clearance"), measure, bench_.work.isAtOnce());
}

void MeasureController::show(const QString& text, MeasurePicture picture) {
  result_ = text;
  bench_.scene.view().setMeasure(std::move(picture));
  bench_.scene.refresh();
  for (const char* id : {"measure.clear", "measure.copy"}) bench_.enable(id, true);
  bench_.messages.log().add(LogLevel::Information, text);
  showHint();
}

/// Shows the result, or the next item to click.
void MeasureController::showHint() {
  QString text = result_;
  if (!text.isEmpty()) {
    const QString keys = bench_.actions["measure.copy"]->shortcut().toString(QKeySequence::NativeText);
    text += QLatin1Char('\n') + tr("%1 copies this. Esc removes it.").arg(keys);
  }
  const bool first = features_.empty() && bodies_.empty();
  if (text.isEmpty()) {
    switch (kind_) {
      case Kind::None: break;
      case Kind::Radius: text = tr("Click a cylindrical face. Esc ends measuring."); break;
      case Kind::Frame: text = tr("Click a plane or a cylinder of what is placed. Esc ends this."); break;
      case Kind::Section: text = tr("Click the face that the section lies along. Esc ends this."); break;
      case Kind::Clearance:
        text = first ? tr("Click the first body. Esc ends measuring.") : tr("Click the second body.");
        break;
      case Kind::Distance:
        text = first ? tr("Click the first vertex, edge or face. Esc ends measuring.")
                     : tr("Click the second vertex, edge or face.");
        break;
      case Kind::Angle:
        text = first ? tr("Click the first edge or face. Esc ends measuring.") : tr("Click the second edge or face.");
        break;
    }
  }
  hint_->write(text);
}

void MeasureController::addCommands() {
  bench_.scripts.add("expect-measure", 1, [this](const ScriptCommands::Words& words) -> Outcome {
    if (result_.contains(QString::fromStdString(words[0]))) return Done{};
    return unmetExpectation("what is measured is '" + result_.toStdString() + "', not '" + words[0] + "'");
  });
}

}  // namespace glissade
