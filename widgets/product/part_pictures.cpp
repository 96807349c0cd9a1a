#include "widgets/product/part_pictures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/places/rigid_body.h"

namespace glissade {
namespace {

/// Samples of a pixel in each direction.
constexpr int kSamples = 3;

/// Border on each side, as a share of the picture.
constexpr double kBorder = 0.04;

constexpr double kAmbient = 0.35;

/// The rotation to the view; its rows point to the right, up and towards the eye.
Eigen::Matrix3d viewFromACorner() {
  const Vector3 toEye = Vector3(-1.0, -1.4, 1.1).normalized();
  const Vector3 right = Vector3::UnitZ().cross(toEye).normalized();
  Eigen::Matrix3d view;
  view << right.transpose(), toEye.cross(right).transpose(), toEye.transpose();
  return view;
}

/// Depth and shade of each sample.
class Raster {
 public:
  explicit Raster(int size)
      : size_(size),
        depth_(static_cast<std::size_t>(size * size), -std::numeric_limits<double>::infinity()),
        shade_(static_cast<std::size_t>(size * size), -1.0) {}

  /// Draws a triangle. x to the right, y down, in samples; z towards the eye.
  void draw(const std::array<Vector3, 3>& p, double shade) {
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[2].x() - p[0].x()) * (p[1].y() - p[0].y());
    if (area == 0.0) return;
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [top, bottom] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = first(top); y <= last(bottom); ++y) {
      for (int x = first(left); x <= last(right); ++x) {
        const double a = ((p[1].x() - x) * (p[2].y() - y) - (p[2].x() - x) * (p[1].y() - y)) / area;
        const double b = ((p[2].x() - x) * (p[0].y() - y) - (p[0].x() - x) * (p[2].y() - y)) / area;
        const double c = 1.0 - a - b;
        if (a < 0.0 || b < 0.0 || c < 0.0) continue;
        const double z = a * p[0].z() + b * p[1].z() + c * p[2].z();
        const std::size_t sample = sampleAt(x, y);
        if (z <= depth_[sample]) continue;
        depth_[sample] = z;
        shade_[sample] = shade;
      }
    }
  }

  std::size_t sampleAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(x);
  }

  QRgb pixel(int x, int y, const Colour& colour) const {
    int covered = 0;
    double shade = 0.0;
    for (int row = y * kSamples; row < (y + 1) * kSamples; ++row) {
      for (int column = x * kSamples; column < (x + 1) * kSamples; ++column) {
        const double own = shade_[sampleAt(column, row)];
        if (own < 0.0) continue;
        ++covered;
        shade += own;
      }
    }
    if (covered == 0) return 0;
    const auto channel = [&](double value) {
      return static_cast<int>(std::lround(255.0 * std::clamp(value * shade / covered, 0.0, 1.0)));
    };
    const int alpha = 255 * covered / (kSamples * kSamples);
    return qRgba(channel(colour[0]), channel(colour[1]), channel(colour[2]), alpha);
  }

 private:
  int first(double least) const { return std::clamp(static_cast<int>(std::ceil(least)), 0, size_ - 1); }
  int last(double most) const { return std::clamp(static_cast<int>(std::floor(most)), 0, size_ - 1); }

  int size_;
  std::vector<double> depth_;
  std::vector<double> shade_;  ///< below 0: background
};

}  // namespace

QImage partPicture(const RigidBody& body, int pixels) {
  QImage picture(pixels, pixels, QImage::Format_ARGB32);
  picture.fill(Qt::transparent);
  const Eigen::Matrix3d view = viewFromACorner() * body.X_WB.orientation.toRotationMatrix();
  std::vector<Vector3> seen;
  Box3 box;
  for (const Vector3& vertex : body.mesh->vertices) {
    seen.push_back(view * vertex);
    box.extend(seen.back());
  }
  if (box.isEmpty()) return picture;
  const int size = pixels * kSamples;
  const double extent = std::max({box.sizes().x(), box.sizes().y(), 1e-12});
  const double scale = size * (1.0 - 2.0 * kBorder) / extent;
  const Vector3 middle = box.center();
  for (Vector3& p : seen) {
    p = {size / 2.0 + scale * (p.x() - middle.x()), size / 2.0 - scale * (p.y() - middle.y()), p.z()};
  }
  Raster raster(size);
  const Vector3 light = Vector3(-0.35, 0.55, 0.75).normalized();
  for (const auto& triangle : body.mesh->triangles) {
    const auto corner = [&](int i) {
      return view * body.mesh->vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])];
    };
    const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (!(normal.norm() > 0.0)) continue;
    const double shade = kAmbient + (1.0 - kAmbient) * std::abs(normal.normalized().dot(light));
    raster.draw({seen[static_cast<std::size_t>(triangle[0])], seen[static_cast<std::size_t>(triangle[1])],
                 seen[static_cast<std::size_t>(triangle[2])]},
                shade);
  }
  for (int y = 0; y < pixels; ++y) {
    for (int x = 0; x < pixels; ++x) picture.setPixel(x, y, raster.pixel(x, y, body.colour));
  }
  return picture;
}

QIcon iconOf(const QImage& picture) {
  const QPixmap pixmap = QPixmap::fromImage(picture);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

PartPictures::Key PartPictures::keyOf(const RigidBody& body) {
  const auto& q = body.X_WB.orientation;
  return {body.mesh, {q.x(), q.y(), q.z(), q.w()}, body.colour};
}

QIcon PartPictures::of(const RigidBody& body) const {
  const auto known = icons_.find(keyOf(body));
  return known == icons_.end() ? QIcon() : known->second;
}

/// Pictures of bodies that are not in the product are forgotten.
void PartPictures::draw(const ProductPtr& product, int pixels, bool atOnce) {
  std::map<Key, QIcon> known;
  std::map<Key, RigidBody> open;
  for (const RigidBody& body : product->bodies) {
    const Key key = keyOf(body);
    const auto icon = icons_.find(key);
    if (icon != icons_.end()) {
      known.insert(*icon);
    } else {
      open.emplace(key, body);
    }
  }
  icons_ = std::move(known);
  if (open.empty()) return;
  task_.start(
      GLISSADE_TEXT("drawing the parts"),
      [this, open, pixels](const WorkWatch& watch) -> BackgroundTask::Delivery {
        const auto pictures = std::make_shared<std::map<Key, QImage>>();
        for (const auto& [key, body] : open) {
          if (watch.stop.stopRequested()) break;
          pictures->emplace(key, partPicture(body, pixels));
        }
        return [this, pictures] {
          for (const auto& [key, picture] : *pictures) icons_[key] = iconOf(picture);
          emit drawn();
        };
      },
      atOnce);
}

}  // namespace glissade
