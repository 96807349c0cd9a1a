#include "widgets/instruction/step_drawer.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"
#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// The place on their way where the coming parts of a motion are drawn, not far from their final place.
struct StepMotionPicture {
  std::vector<BodyId> bodies;
  Pose moved;                ///< a body stands at moved * X_WB
  std::vector<Vector3> way;  ///< of the middle of the coming parts, world frame, from the drawn to the final place
  double along = 0.0;        ///< size of the coming parts in the direction of their motion, metres
  double apart = 0.0;        ///< distance of the drawn from the final place along the way, metres
};

/// Least distance of the drawn from the final place, in lengths of the coming parts.
constexpr double kClear = 1.1;
/// Cosine of the largest angle between two motions that come the same way.
constexpr double kSameWay = 0.9;

/// `before`: the motions of the step that come before; what comes the same way is drawn behind them. `apart`: least
/// distance of the drawn from the final place, metres, if the way is that long or others come before. Precondition: the
/// product has the bodies of the motion.
StepMotionPicture stepMotionPicture(const StepMotion& motion, const AssembledProduct& product,
                                    const std::vector<StepMotionPicture>& before, double apart) {
  StepMotionPicture picture;
  picture.bodies = motion.bodies();
  const Vector3 direction = exitDirection(motion.path);
  Box3 box;
  double least = 0.0;
  double most = 0.0;
  bool isFirst = true;
  for (const std::size_t index : product.indicesOf(picture.bodies)) {
    const RigidBody& body = product.bodies[index];
    for (const Vector3& vertex : body.mesh->vertices) {
      const Vector3 p_W = body.X_WB * vertex;
      const double along = direction.dot(p_W);
      box.extend(p_W);
      least = isFirst ? along : std::min(least, along);
      most = isFirst ? along : std::max(most, along);
      isFirst = false;
    }
  }
  picture.along = most - least;
  const Vector3 middle = box.center();
  picture.apart = std::max(apart, kClear * picture.along);
  bool isBehind = false;
  for (const StepMotionPicture& each : before) {
    const Vector3 way = each.way.front() - each.way.back();
    const bool isSameWay = way.dot(direction) > kSameWay * way.norm();
    if (!isSameWay) continue;
    isBehind = true;
    picture.apart = std::max(picture.apart, each.apart + kClear * picture.along);
  }
  const double wanted = picture.apart;
  const Pose X_PW = inverse(motion.path.front().q);  // the path's frame at the final place
  picture.way = {middle};
  double length = 0.0;
  for (std::size_t i = 1; i < motion.path.size() && length < wanted; ++i) {
    const Pose& from = motion.path[i - 1].q;
    const Pose& to = motion.path[i].q;
    const double leg = ((to * X_PW) * middle - (from * X_PW) * middle).norm();
    const double share = leg > 0.0 ? std::min(1.0, (wanted - length) / leg) : 1.0;
    picture.moved = interpolate(from, to, share) * X_PW;
    picture.way.push_back(picture.moved * middle);
    length += leg;
  }
  if (isBehind && length < wanted) {  // what comes before it is drawn where its own way ends
    picture.moved.position += (wanted - length) * direction;
    picture.way.push_back(picture.moved * middle);
  }
  std::reverse(picture.way.begin(), picture.way.end());
  return picture;
}

const QColor kPaleFill(0xf3, 0xf4, 0xf6);
const QColor kPaleLine(0x9a, 0xa2, 0xac);
const QColor kComingFill(0xff, 0xb0, 0x2e);
const QColor kComingLine(0x1d, 0x23, 0x29);
const QColor kPartFill(0xdb, 0xe4, 0xee);
const QColor kArrow(0xc8, 0x3c, 0x00);
constexpr double kBorder = 0.03;  // share of the picture
/// Distances of the coming parts from their place, as shares of the sizes of the whole and of these parts.
constexpr double kApartOfWhole = 0.06;
constexpr double kApartOfPart = 0.25;
constexpr double kApartOfPartNear = 0.6;  // the share in a close-up
/// A close-up is drawn if it magnifies the picture by this factor.
constexpr double kLeastMagnification = 1.6;
constexpr double kInsetShare = 0.46;   // share of the picture's shorter side
constexpr double kMostCovered = 0.02;  // share of a corner that a close-up may hide
constexpr double kMostlySeen = 0.5;    // share of the parts of a motion
constexpr double kCloseMargin = 1.5;   // size of the close-up, in sizes of the first step's parts

QRectF shrunk(const QRectF& rect, double by) { return rect.adjusted(by, by, -by, -by); }

/// All bodies of a picture, with the coming ones at some distance from their place.
struct Scene {
  std::vector<DrawnBody> bodies;
  std::vector<StepMotionPicture> motions;
  Box3 box_V;    ///< box of all bodies
  Box3 first_V;  ///< box of the first step's parts, on their way and at their place
};

/// Draws an arrow along the way. It begins at the edge of the drawn parts; an arrow that would be too short is left
/// out.
void drawArrow(QPainter& painter, const std::vector<QPointF>& way, double alongPixels, double size) {
  if (way.size() < 2) return;
  QPainterPath line(way.front());
  for (std::size_t i = 1; i < way.size(); ++i) line.lineTo(way[i]);
  const double length = line.length();
  if (length < 2.0 * size) return;
  const double from = std::min(0.5 * alongPixels, std::max(0.0, length - 4.0 * size)) / length;
  const double to = (length - 1.6 * size) / length;
  QPainterPath shaft(line.pointAtPercent(from));
  for (int i = 1; i <= 24; ++i) shaft.lineTo(line.pointAtPercent(from + (to - from) * i / 24.0));
  const QPointF tip = line.pointAtPercent(1.0);
  const QPointF back = line.pointAtPercent(to) - tip;
  const double norm = std::max(1e-9, std::hypot(back.x(), back.y()));
  const QPointF unit = back / norm;
  const QPointF across(-unit.y() * 0.75 * size, unit.x() * 0.75 * size);
  QPolygonF head({tip, tip + 1.8 * size * unit + across, tip + 1.8 * size * unit - across});
  for (const bool halo : {true, false}) {
    const QColor colour = halo ? QColor(Qt::white) : kArrow;
    painter.setPen(QPen(colour, (halo ? 0.75 : 0.45) * size, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shaft);
    painter.setPen(QPen(colour, halo ? 0.3 * size : 1.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(colour);
    painter.drawPolygon(head);
  }
}

void drawArrows(QPainter& painter, const Scene& scene, const Projection& projection, double size) {
  for (const StepMotionPicture& motion : scene.motions) {
    std::vector<QPointF> way;
    for (const Vector3& p_W : motion.way) way.push_back(projection.pixel(p_W));
    const Vector3 last = motion.way.front() - motion.way.back();
    const double metres = last.norm();
    const QPointF across = way.front() - way.back();
    const double foreshortened = metres > 0.0 ? std::hypot(across.x(), across.y()) / metres : 0.0;
    drawArrow(painter, way, motion.along * foreshortened, size);
  }
}

/// Share of the pixels of a rectangle that are not white.
double covered(const QImage& picture, const QRect& rect) {
  constexpr int kStride = 3;
  int count = 0;
  int all = 0;
  for (int y = rect.top(); y <= rect.bottom(); y += kStride) {
    for (int x = rect.left(); x <= rect.right(); x += kStride) {
      ++all;
      if (picture.pixel(x, y) != qRgb(255, 255, 255)) ++count;
    }
  }
  return all > 0 ? static_cast<double>(count) / all : 1.0;
}

/// The rectangles of the picture and its close-up.
struct Places {
  QRectF whole;
  QRectF inset;
};

QRectF cornerOf(const QRectF& frame, double side, int corner) {
  const double x = corner % 2 == 0 ? frame.right() - side : frame.left();
  const double y = corner / 2 == 0 ? frame.top() : frame.bottom() - side;
  return {x, y, side, side};
}

class PanelPicture {
 public:
  PanelPicture(const InstructionPanel& panel, const AssembledProduct& product, const QSize& pixels)
      : panel_(panel),
        product_(product),
        pixels_(pixels),
        size_(std::max(6.0, 0.022 * std::min(pixels.width(), pixels.height()))),
        frame_(shrunk(QRectF(QPointF(0.0, 0.0), QSizeF(pixels)), kBorder * std::min(pixels.width(), pixels.height()))) {
  }

  QImage draw() {
    const Scene scene = sceneOf(false);
    Projection whole = projection();
    whole.fit(scene.box_V, frame_);
    QImage picture = drawing(scene, whole, pixels_);
    if (!panel_.closeUp || panel_.steps.empty()) return picture;
    const Scene near = sceneOf(true);
    const Box3 close_V = closeBox(near);
    const auto magnified = [&](const Places& places) {
      Projection close = projection();
      close.fit(close_V, places.inset);
      return close.pixelsPerMetre();
    };
    Places places = placesFor(picture, scene);
    if (magnified(places) < kLeastMagnification * whole.pixelsPerMetre()) return picture;
    if (places.whole != frame_) {
      whole.fit(scene.box_V, places.whole);
      picture = drawing(scene, whole, pixels_);
    }
    addCloseUp(picture, near, close_V, places.inset, whole);
    return picture;
  }

 private:
  Projection projection() const { return {panel_.view.toEye(), panel_.view.up()}; }

  const RigidBody& body(const BodyId& id) const { return product_.body(id); }

  Scene sceneOf(bool isNear) const {
    Scene scene;
    Box3 box_W;
    for (const BodyId& id : panel_.present) {
      const RigidBody& there = body(id);
      const bool isStart = panel_.steps.empty();
      scene.bodies.push_back(
          {there.mesh, there.X_WB, isStart ? kComingFill : kPaleFill, isStart ? kComingLine : kPaleLine, isStart});
      box_W.extend(boundingBox(*there.mesh, there.X_WB));
    }
    for (const AssemblyStep& step : panel_.steps) box_W.extend(boxOf(step.bodies()));
    const double whole = box_W.diagonal().norm();
    const Projection view = projection();
    for (std::size_t i = 0; i < panel_.steps.size(); ++i) {
      std::vector<StepMotionPicture> motions;
      for (const StepMotion* coming : motionsOf(panel_.steps[i], PlanOrder::Assembly)) {
        const double part = boxOf(coming->bodies()).diagonal().norm();
        const double apart = isNear ? kApartOfPartNear * part : kApartOfWhole * whole + kApartOfPart * part;
        motions.push_back(stepMotionPicture(*coming, product_, motions, apart));
      }
      for (const StepMotionPicture& motion : motions) addComing(motion, i == 0, view, scene);
    }
    for (const DrawnBody& each : scene.bodies) scene.box_V.extend(view.boxOf(*each.mesh, each.X_WB));
    return scene;
  }

  Box3 boxOf(const std::vector<BodyId>& ids) const {
    Box3 box;
    for (const BodyId& id : ids) box.extend(boundingBox(*body(id).mesh, body(id).X_WB));
    return box;
  }

  void addComing(const StepMotionPicture& motion, bool isOfFirstStep, const Projection& view, Scene& scene) const {
    for (const BodyId& id : motion.bodies) {
      const RigidBody& comes = body(id);
      scene.bodies.push_back({comes.mesh, motion.moved * comes.X_WB, kComingFill, kComingLine, true});
      scene.box_V.extend(view.boxOf(*comes.mesh, comes.X_WB));
      if (!isOfFirstStep) continue;
      scene.first_V.extend(view.boxOf(*comes.mesh, comes.X_WB));
      scene.first_V.extend(view.boxOf(*comes.mesh, motion.moved * comes.X_WB));
    }
    scene.motions.push_back(motion);
  }

  QImage drawing(const Scene& scene, const Projection& view, const QSize& pixels) const {
    QImage picture = lineDrawing(scene.bodies, view, pixels);
    showHidden(scene, view, picture);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    drawArrows(painter, scene, view, size_);
    return picture;
  }

  /// The parts of a motion that are hidden for the greater part show through what is before them: a nut behind a plate
  /// that comes with it, too.
  void showHidden(const Scene& scene, const Projection& view, QImage& picture) const {
    const QImage opaque = picture;
    for (const StepMotionPicture& motion : scene.motions) {
      std::vector<DrawnBody> coming;
      for (const BodyId& id : motion.bodies) {
        coming.push_back({body(id).mesh, motion.moved * body(id).X_WB, kComingFill, kComingLine, true});
      }
      const QImage alone = lineDrawing(coming, view, picture.size());
      std::size_t drawn = 0;
      std::size_t seen = 0;
      const auto visit = [&](const auto& take) {
        for (int y = 0; y < picture.height(); ++y) {
          for (int x = 0; x < picture.width(); ++x) {
            if (const QRgb pixel = alone.pixel(x, y); pixel != qRgb(255, 255, 255)) take(x, y, pixel);
          }
        }
      };
      visit([&](int x, int y, QRgb pixel) {
        ++drawn;
        if (opaque.pixel(x, y) == pixel) ++seen;
      });
      if (static_cast<double>(seen) >= kMostlySeen * static_cast<double>(drawn)) continue;
      visit([&](int x, int y, QRgb pixel) {
        const QRgb there = picture.pixel(x, y);
        picture.setPixel(x, y,
                         qRgb((qRed(there) + qRed(pixel)) / 2, (qGreen(there) + qGreen(pixel)) / 2,
                              (qBlue(there) + qBlue(pixel)) / 2));
      });
    }
  }

  /// A square about the parts of the first step.
  static Box3 closeBox(const Scene& scene) {
    const Vector3 middle = scene.first_V.center();
    const double half = 0.5 * kCloseMargin * std::max(scene.first_V.sizes().x(), scene.first_V.sizes().y());
    return {middle - Vector3::Constant(half), middle + Vector3::Constant(half)};
  }

  /// The rectangles of the picture and its close-up, in the corner where it hides least. If it hides something in each
  /// corner, the picture makes room at its side or below.
  Places placesFor(const QImage& picture, const Scene& scene) const {
    const double side = kInsetShare * std::min(frame_.width(), frame_.height());
    double least = 1.0;
    QRectF best;
    for (int corner = 0; corner < 4; ++corner) {
      const QRectF rect = cornerOf(frame_, side, corner);
      const double share = covered(picture, rect.toAlignedRect().intersected(picture.rect()));
      if (share >= least) continue;
      least = share;
      best = rect;
    }
    if (least <= kMostCovered) return {frame_, best};
    const double room = side + size_;
    const Places beside{frame_.adjusted(0.0, 0.0, -room, 0.0), cornerOf(frame_, side, 0)};
    const Places below{frame_.adjusted(0.0, 0.0, 0.0, -room), cornerOf(frame_, side, 2)};
    const auto scaleIn = [&](const Places& places) {
      Projection view = projection();
      view.fit(scene.box_V, places.whole);
      return view.pixelsPerMetre();
    };
    return scaleIn(beside) >= scaleIn(below) ? beside : below;
  }

  /// Adds the close-up in its frame, and a ring about its place in the picture.
  void addCloseUp(QImage& picture, const Scene& near, const Box3& close_V, const QRectF& inset,
                  const Projection& whole) const {
    const QRect rect = inset.toAlignedRect();
    Projection close = projection();
    close.fit(close_V, QRectF(0.0, 0.0, rect.width(), rect.height()));
    const QImage detail = drawing(near, close, rect.size());
    const QRectF ring = whole.rectOf(close_V);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(kArrow, 0.15 * size_));
    painter.setBrush(Qt::NoBrush);
    const double grown = std::max(0.0, 1.5 * size_ - 0.5 * ring.width());
    const QRectF circle = ring.adjusted(-grown, -grown, grown, grown);
    const QLineF link(circle.center(), QRectF(rect).center());
    const double length = link.length();
    if (length > 0.5 * circle.width()) painter.drawLine(link.pointAt(0.5 * circle.width() / length), link.p2());
    painter.drawEllipse(circle);
    painter.drawImage(rect.topLeft(), detail);
    painter.drawRect(QRectF(rect));
  }

  const InstructionPanel& panel_;
  const AssembledProduct& product_;
  QSize pixels_;
  double size_;  ///< size of arrows, pixels
  QRectF frame_;
};

QColor softened(const Colour& colour) {
  constexpr double kOwn = 0.75;  // the rest is white
  const auto channel = [](double value) { return 1.0 - kOwn + kOwn * std::clamp(value, 0.0, 1.0); };
  return QColor::fromRgbF(channel(colour[0]), channel(colour[1]), channel(colour[2]));
}

}  // namespace

QImage StepDrawer::panel(const InstructionPanel& panel, const QSize& pixels) const {
  return PanelPicture(panel, product_, pixels).draw();
}

QImage StepDrawer::drawn(const std::vector<DrawnBody>& bodies, const QSize& pixels, const Vector3& up) const {
  const Viewpoint from{0, false, up};
  Projection projection(from.toEye(), from.up());
  Box3 box_V;
  for (const DrawnBody& each : bodies) box_V.extend(projection.boxOf(*each.mesh, each.X_WB));
  const double border = kBorder * std::min(pixels.width(), pixels.height());
  projection.fit(box_V, shrunk(QRectF(QPointF(0.0, 0.0), QSizeF(pixels)), border));
  return lineDrawing(bodies, projection, pixels);
}

QImage StepDrawer::finished(const std::vector<BodyId>& bodies, const QSize& pixels, const Vector3& up) const {
  std::vector<DrawnBody> all;
  for (const BodyId& id : bodies) {
    all.push_back({body(id).mesh, body(id).X_WB, softened(body(id).colour), kComingLine});
  }
  return drawn(all, pixels, up);
}

QImage StepDrawer::parts(const std::vector<BodyId>& bodies, const QSize& pixels) const {
  std::vector<DrawnBody> all;
  for (const BodyId& id : bodies) all.push_back({body(id).mesh, body(id).X_WB, kPartFill, kComingLine});
  return drawn(all, pixels);
}

QImage StepDrawer::exploded(const std::vector<Pose>& moved, const QSize& pixels) const {
  std::vector<DrawnBody> all;
  for (std::size_t i = 0; i < product_.bodies.size(); ++i) {
    const RigidBody& each = product_.bodies[i];
    all.push_back({each.mesh, moved[i] * each.X_WB, softened(each.colour), kComingLine});
  }
  return drawn(all, pixels);
}

}  // namespace glissade
