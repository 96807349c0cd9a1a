#include "widgets/instruction/line_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Samples of a pixel in each direction.
constexpr int kSamples = 2;
/// Cosine of the angle from which an edge of a surface is a line.
constexpr float kSharp = 0.88F;
constexpr std::uint32_t kNothing = 0;

struct Facet {
  std::uint32_t body;
  Eigen::Vector3f n_V;  ///< towards the eye
  float slope;          ///< metres of depth for each metre across, at most
  float shade;
};

/// Depth and facet of each sample.
class Drawing {
 public:
  Drawing(const std::vector<DrawnBody>& bodies, const Projection& projection, const QSize& pixels)
      : bodies_(bodies),
        projection_(projection),
        width_(pixels.width() * kSamples),
        height_(pixels.height() * kSamples),
        depth_(count(), -std::numeric_limits<float>::infinity()),
        facet_(count(), kNothing),
        line_(count(), 0) {
    facets_.push_back({});  // kNothing
    for (std::size_t i = 0; i < bodies.size(); ++i) draw(i);
    findLines();
  }

  QImage image() const {
    QImage picture(width_ / kSamples, height_ / kSamples, QImage::Format_RGB32);
    for (int y = 0; y < picture.height(); ++y) {
      auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
      for (int x = 0; x < picture.width(); ++x) row[x] = pixel(x, y);
    }
    return picture;
  }

 private:
  std::size_t count() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  void draw(std::size_t index) {
    static const Vector3 kLight = Vector3(-0.45, 0.7, 0.55).normalized();
    const DrawnBody& body = bodies_[index];
    std::vector<Vector3> points;
    points.reserve(body.mesh->vertices.size());
    for (const Vector3& vertex : body.mesh->vertices) {
      Vector3 p = projection_.project(body.X_WB * vertex);
      p.x() *= kSamples;
      p.y() *= kSamples;
      points.push_back(p);
    }
    const Eigen::Matrix3d R_VB = projection_.R_VW() * body.X_WB.orientation.toRotationMatrix();
    for (const TriangleIndices& triangle : body.mesh->triangles) {
      const std::array<Vector3, 3> p{points[triangle[0]], points[triangle[1]], points[triangle[2]]};
      if (isOutside(p)) continue;
      Vector3 n = R_VB * faceNormal(*body.mesh, triangle);
      if (n.z() < 0.0) n = -n;
      const double slope = std::hypot(n.x(), n.y()) / std::max(0.02, n.z());
      const double shade = 0.8 + 0.2 * std::max(0.0, n.dot(kLight));
      facets_.push_back(
          {static_cast<std::uint32_t>(index), n.cast<float>(), static_cast<float>(slope), static_cast<float>(shade)});
      fill(p, static_cast<std::uint32_t>(facets_.size() - 1));
    }
  }

  bool isOutside(const std::array<Vector3, 3>& p) const {
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    return right < 0.0 || bottom < 0.0 || left >= width_ || top >= height_;
  }

  void fill(const std::array<Vector3, 3>& p, std::uint32_t facet) {
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
    if (area == 0.0) return;
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    const int last = std::min(height_ - 1, static_cast<int>(std::floor(bottom)));
    const double perX =
        ((p[1].z() - p[0].z()) * (p[2].y() - p[0].y()) - (p[2].z() - p[0].z()) * (p[1].y() - p[0].y())) / area;
    const double perY =
        ((p[2].z() - p[0].z()) * (p[1].x() - p[0].x()) - (p[1].z() - p[0].z()) * (p[2].x() - p[0].x())) / area;
    for (int y = std::max(0, static_cast<int>(std::ceil(top))); y <= last; ++y) {
      double left = std::numeric_limits<double>::infinity();
      double right = -left;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& a = p[i];
        const Vector3& b = p[(i + 1) % 3];
        if ((a.y() <= y) == (b.y() <= y) && a.y() != y && b.y() != y) continue;
        const double x = a.y() == b.y() ? a.x() : a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
        left = std::min(left, x);
        right = std::max(right, x);
        if (a.y() == b.y()) left = std::min(left, b.x()), right = std::max(right, b.x());
      }
      const int end = std::min<int>(width_ - 1, static_cast<int>(std::floor(std::min(right, 1e9))));
      for (int x = std::max(0, static_cast<int>(std::ceil(std::max(left, -1e9)))); x <= end; ++x) {
        const auto z = static_cast<float>(p[0].z() + perX * (x - p[0].x()) + perY * (y - p[0].y()));
        const std::size_t sample = at(x, y);
        if (z <= depth_[sample]) continue;
        depth_[sample] = z;
        facet_[sample] = facet;
      }
    }
  }

  /// Whether a line lies between two samples.
  bool isEdge(std::size_t a, std::size_t b) const {
    if (facet_[a] == facet_[b]) return false;
    if (facet_[a] == kNothing || facet_[b] == kNothing) return true;
    const Facet& f = facets_[facet_[a]];
    const Facet& g = facets_[facet_[b]];
    if (f.body != g.body || f.n_V.dot(g.n_V) < kSharp) return true;
    const auto step = static_cast<float>(1.0 / (kSamples * projection_.pixelsPerMetre()));
    return std::abs(depth_[a] - depth_[b]) > 3.0F * step * (f.slope + g.slope + 0.5F);
  }

  /// Finds the lines. A line belongs to the body in front, on both sides.
  void findLines() {
    std::vector<std::uint32_t> thin(count(), 0);
    const auto mark = [&](std::size_t a, std::size_t b) {
      if (!isEdge(a, b)) return;
      const std::uint32_t front = facets_[depth_[a] > depth_[b] ? facet_[a] : facet_[b]].body + 1;
      for (const std::size_t sample : {a, b}) {
        if (thin[sample] == 0 || bodies_[front - 1].strong) thin[sample] = front;
      }
    };
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (x + 1 < width_) mark(at(x, y), at(x + 1, y));
        if (y + 1 < height_) mark(at(x, y), at(x, y + 1));
      }
    }
    line_ = thin;
    for (int y = 1; y + 1 < height_; ++y) {
      for (int x = 1; x + 1 < width_; ++x) {
        const std::uint32_t body = thin[at(x, y)];
        if (body == 0 || !bodies_[body - 1].strong) continue;
        for (const std::size_t beside : {at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)}) line_[beside] = body;
      }
    }
  }

  QRgb pixel(int x, int y) const {
    std::array<double, 3> sum{0.0, 0.0, 0.0};
    for (int row = y * kSamples; row < (y + 1) * kSamples; ++row) {
      for (int column = x * kSamples; column < (x + 1) * kSamples; ++column) {
        const std::size_t sample = at(column, row);
        QColor colour = Qt::white;
        double shade = 1.0;
        if (line_[sample] != 0) {
          colour = bodies_[line_[sample] - 1].line;
        } else if (facet_[sample] != kNothing) {
          const Facet& facet = facets_[facet_[sample]];
          colour = bodies_[facet.body].fill;
          shade = static_cast<double>(facet.shade);
        }
        sum[0] += shade * colour.red();
        sum[1] += shade * colour.green();
        sum[2] += shade * colour.blue();
      }
    }
    constexpr double kAll = kSamples * kSamples;
    const auto channel = [](double value) { return static_cast<int>(std::lround(value / kAll)); };
    return qRgb(channel(sum[0]), channel(sum[1]), channel(sum[2]));
  }

  const std::vector<DrawnBody>& bodies_;
  const Projection& projection_;
  int width_;
  int height_;
  std::vector<float> depth_;
  std::vector<std::uint32_t> facet_;  ///< index; kNothing: the background
  std::vector<std::uint32_t> line_;   ///< number of the body whose line is here, from 1; 0: none
  std::vector<Facet> facets_;
};

}  // namespace

Projection::Projection(const Vector3& toEye, const Vector3& up) {
  const Vector3 right = up.cross(toEye).normalized();
  R_VW_ << right.transpose(), toEye.cross(right).transpose(), toEye.transpose();
}

Box3 Projection::boxOf(const TriangleMesh& mesh, const Pose& X_WB) const {
  const Eigen::Matrix3d R_VB = R_VW_ * X_WB.orientation.toRotationMatrix();
  const Vector3 p_V = R_VW_ * X_WB.position;
  Box3 box;
  for (const Vector3& vertex : mesh.vertices) box.extend(Vector3(R_VB * vertex + p_V));
  return box;
}

void Projection::fit(const Box3& box_V, const QRectF& target) {
  constexpr double kLeast = 1e-9;  // metres
  if (box_V.isEmpty()) return;
  const Vector3 sizes = box_V.sizes();
  scale_ = std::min(target.width() / std::max(kLeast, sizes.x()), target.height() / std::max(kLeast, sizes.y()));
  const Vector3 middle = box_V.center();
  origin_ = {target.center().x() - scale_ * middle.x(), target.center().y() + scale_ * middle.y()};
}

Vector3 Projection::project(const Vector3& p_W) const {
  const Vector3 p_V = R_VW_ * p_W;
  return {origin_.x() + scale_ * p_V.x(), origin_.y() - scale_ * p_V.y(), p_V.z()};
}

QPointF Projection::pixel(const Vector3& p_W) const {
  const Vector3 p = project(p_W);
  return {p.x(), p.y()};
}

QRectF Projection::rectOf(const Box3& box_V) const {
  return {QPointF(origin_.x() + scale_ * box_V.min().x(), origin_.y() - scale_ * box_V.max().y()),
          QPointF(origin_.x() + scale_ * box_V.max().x(), origin_.y() - scale_ * box_V.min().y())};
}

QImage lineDrawing(const std::vector<DrawnBody>& bodies, const Projection& projection, const QSize& pixels) {
  return Drawing(bodies, projection, pixels).image();
}

}  // namespace glissade
