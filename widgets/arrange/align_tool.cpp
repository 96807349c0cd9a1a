#include "widgets/arrange/align_tool.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

#include "widgets/workbench/scene_ray.h"

namespace glissade {
namespace {

using FeatureKind = MeasureFeature::Kind;

constexpr int kHoverMilliseconds = 15;

QString kindText(const MeasureFeature& feature) {
  switch (feature.kind) {
    case FeatureKind::Vertex: return AlignTool::tr("vertex");
    case FeatureKind::Edge: return AlignTool::tr("edge");
    case FeatureKind::Cylinder: return AlignTool::tr("cylinder");
    case FeatureKind::Cone: return AlignTool::tr("cone");
    case FeatureKind::Sphere: return AlignTool::tr("sphere");
    case FeatureKind::Torus: return AlignTool::tr("torus");
    case FeatureKind::Face: return AlignTool::tr("plane");
    case FeatureKind::FreeFace: break;
  }
  return AlignTool::tr("free surface");
}

/// How the two features lie to each other after the alignment; alignment() has the table.
QString relationText(const MeasureFeature& a, const MeasureFeature& b) {
  const auto either = [&](FeatureKind kind) { return a.kind == kind || b.kind == kind; };
  const auto isPoint = [](const MeasureFeature& feature) {
    return feature.kind == FeatureKind::Vertex || feature.kind == FeatureKind::Sphere;
  };
  const bool planes = a.kind == FeatureKind::Face && b.kind == FeatureKind::Face;
  if (planes) return AlignTool::tr("in one plane");
  if (isPoint(a) && isPoint(b)) return AlignTool::tr("in one point");
  if (either(FeatureKind::Face)) {
    const bool tangent = either(FeatureKind::Cylinder) || either(FeatureKind::Sphere);
    return tangent ? AlignTool::tr("tangent") : AlignTool::tr("in the plane");
  }
  if (isPoint(a) || isPoint(b)) {
    return a.isTurned() || b.isTurned() ? AlignTool::tr("on the axis") : AlignTool::tr("on the edge");
  }
  return AlignTool::tr("on one line");
}

void addTo(MeasurePicture& picture, const MeasureFeature& feature, const std::vector<Vector3>& outline) {
  if (feature.kind == FeatureKind::Vertex) picture.points.push_back(feature.picked);
  if (feature.kind == FeatureKind::Edge) {
    picture.segments.insert(picture.segments.end(), {feature.from, feature.to});
  }
  if (feature.kind == FeatureKind::Sphere) picture.points.push_back(feature.axisPoint);
  if (feature.isTurned()) {
    const Vector3 half = feature.radius * feature.direction;
    picture.segments.insert(picture.segments.end(), {feature.axisPoint - half, feature.axisPoint + half});
  }
  picture.segments.insert(picture.segments.end(), outline.begin(), outline.end());
}

}  // namespace

AlignTool::AlignTool(const Workbench& bench, FeatureStore& features)
    : QObject(&bench.window), bench_(bench), features_(features), hint_(new SceneHint(bench.scene.widget())) {
  hovering_.setSingleShot(true);
  hovering_.setInterval(kHoverMilliseconds);
  connect(&hovering_, &QTimer::timeout, this, &AlignTool::hover);
  bench.scene.widget()->installEventFilter(this);
}

void AlignTool::setOn(bool on) {
  if (on == on_) return;
  hovering_.stop();
  features_.cancel();
  preview(std::nullopt);
  first_.reset();
  on_ = on;
  QWidget* scene = bench_.scene.widget();
  scene->setMouseTracking(on);
  if (on) {
    features_.prepareAll();
    scene->setCursor(Qt::CrossCursor);
    scene->setFocus();
    mark(std::nullopt);
  } else {
    scene->unsetCursor();
    hint_->write({});
    bench_.scene.view().setMeasure({});
    bench_.scene.refresh();
  }
}

bool AlignTool::eventFilter(QObject* watched, QEvent* event) {
  if (!on_ || !bench_.document.scenario()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::KeyPress:
      if (static_cast<const QKeyEvent&>(*event).key() != Qt::Key_Escape) break;
      emit left();
      return true;
    case QEvent::Leave:
      hovering_.stop();
      mark(std::nullopt);
      break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
      if (followMouse(static_cast<const QMouseEvent&>(*event))) return true;
      break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

/// Returns true if the event needs no other treatment.
bool AlignTool::followMouse(const QMouseEvent& event) {
  if (event.type() == QEvent::MouseMove) {
    pointer_ = event.localPos();
    if (event.buttons() != Qt::NoButton) return false;
    if (bench_.work.isAtOnce()) {
      hover();
    } else if (!hovering_.isActive()) {
      hovering_.start();
    }
    return false;
  }
  if (event.button() != Qt::LeftButton) return false;
  if (const auto clicked = clicks_.follow(event)) click(*clicked);
  return event.type() == QEvent::MouseButtonRelease;  // a click selects nothing while the tool is on
}

/// The first item that can be arranged at a point of the view; the object is hit at its start and its goal.
std::optional<AlignTool::Target> AlignTool::targetAt(const QPointF& position) const {
  const LoadedScenario& scenario = *bench_.document.scenario();
  const SceneView& view = bench_.scene.view();
  const Ray ray = rayThrough(bench_.scene, position);
  std::optional<ItemHit> hit;
  if (selected_ && !first_) hit = itemAt(scenario, view, ray, selected_);
  if (!hit) hit = itemAt(scenario, view, ray);
  if (!hit) return std::nullopt;
  const double pixel = view.camera().viewHeightAt(hit->p_W) / std::max(1, bench_.scene.widget()->height());
  return Target{hit->item, hit->body, hit->hit.triangle, hit->p_W, kFeaturePixels * pixel};
}

AlignTool::Pointed AlignTool::pointedAt(const Target& target, const MeasurableMesh& mesh) const {
  const Vector3 p_B = inverse(target.body.X_WB) * target.p_W;
  const MeasureFeature feature = mesh.alignableAt(target.triangle, p_B, target.snap);
  Pointed pointed{target.item, placed(feature, target.body.X_WB)};
  if (feature.kind != FeatureKind::Vertex && feature.kind != FeatureKind::Edge) {
    pointed.outline = mesh.outlineAt(target.triangle);
    for (Vector3& p : pointed.outline) p = target.body.X_WB * p;
  }
  return pointed;
}

void AlignTool::hover() {
  const auto target = targetAt(pointer_);
  const MeshFeaturesPtr features = target ? features_.find(target->body.mesh) : nullptr;
  mark(features ? std::optional(pointedAt(*target, features->measurable)) : std::nullopt);
}

void AlignTool::click(const QPointF& position) {
  if (const auto target = targetAt(position)) take(*target);
}

void AlignTool::take(const Target& target) {
  if (const MeshFeaturesPtr features = features_.find(target.body.mesh)) {
    takePointed(pointedAt(target, features->measurable));
    return;
  }
  hint_->write(tr("Finding edges and faces of the body…"));
  features_.prepare(target.body.mesh, [this, target] { take(target); });
}

bool AlignTool::fits(const Pointed& onto) const {
  return first_ && onto.item != first_->item && canAlign(first_->feature, onto.feature);
}

/// A click that does not fit keeps the first clicked feature.
void AlignTool::takePointed(const Pointed& pointed) {
  if (fits(pointed)) {
    const Pointed moving = *first_;
    preview(std::nullopt);
    emit picked(moving.item, moving.feature, pointed.feature);
  } else if (!first_ && canAlign(pointed.feature, pointed.feature)) {
    first_ = pointed;
    mark(std::nullopt);
    emit movingPicked(first_->item);
  } else {
    hint_->write(hintFor(pointed));
  }
}

void AlignTool::mark(const std::optional<Pointed>& hovered) {
  MeasurePicture picture;
  if (first_) addTo(picture, first_->feature, first_->outline);
  if (hovered) addTo(picture, hovered->feature, hovered->outline);
  bench_.scene.view().setMeasure(picture);
  preview(hovered && fits(*hovered) ? hovered : std::nullopt);
  hint_->write(hintFor(hovered));
  bench_.scene.refresh();
}

/// Draws the moving item where the alignment puts it, or puts it back.
void AlignTool::preview(const std::optional<Pointed>& onto) {
  if (!onto && !previewed_) return;
  const LoadedScenario& scenario = *bench_.document.scenario();
  const auto X_WB = poseOf(scenario.scenario, first_->item);
  previewed_ = onto.has_value();
  if (!X_WB) return;
  SceneView& view = bench_.scene.view();
  const Pose motion = onto ? alignment(first_->feature, onto->feature, false) : Pose::identity();
  drawItemAt(first_->item, motion * *X_WB, scenario, view);
  if (!onto) view.restoreObstacles();
}

QString AlignTool::hintFor(const std::optional<Pointed>& hovered) const {
  if (hovered && !canAlign(hovered->feature, hovered->feature)) {
    return tr("This is a free surface: it has no plane and no axis.");
  }
  if (hovered && first_ && hovered->item == first_->item) {
    return tr("This is the moving part. Click another body. Esc ends this.");
  }
  const QString body = hovered ? nameOf(hovered->item, *bench_.document.scenario()) : QString();
  if (hovered && first_) {
    return tr("Click to align: %1 with %2 of %3, %4. Esc ends this.")
        .arg(kindText(first_->feature), kindText(hovered->feature), body,
             relationText(first_->feature, hovered->feature));
  }
  if (hovered) {
    return tr("Click the moving part: %1 of %2. Esc ends this.").arg(kindText(hovered->feature), body);
  }
  return first_ ? tr("Click the vertex, edge or face of another body that it goes onto. Esc ends this.")
                : tr("Click a vertex, an edge or a face of the moving part. Esc ends this.");
}

}  // namespace glissade
