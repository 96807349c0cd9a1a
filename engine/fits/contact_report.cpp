#include "engine/fits/contact_report.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/fits/contact_finder.h"

namespace glissade {
namespace {

/// Share of all pairs of `bodies` bodies that comes before the pairs of this body.
double shareOfPairs(std::size_t body, std::size_t bodies) {
  const auto count = static_cast<double>(bodies);
  const auto rest = static_cast<double>(bodies - body);
  return 1.0 - rest * (rest - 1.0) / std::max(1.0, count * (count - 1.0));
}

/// Prepares each body once, and the surfaces of each mesh once.
class Preparation {
 public:
  explicit Preparation(const std::vector<ContactBody>& bodies) : bodies_(bodies), prepared_(bodies.size()) {}

  const PreparedBody& operator[](std::size_t index) {
    std::unique_ptr<const PreparedBody>& prepared = prepared_[index];
    if (!prepared) {
      const ContactBody& body = bodies_[index];
      const Shape& shape = shapeOf(body.mesh);
      prepared = std::make_unique<const PreparedBody>(transformed(shape.mesh, body.X_WB),
                                                      transformed(shape.regions, body.X_WB), body.deflection);
    }
    return *prepared;
  }

 private:
  struct Shape {
    TriangleMesh mesh;
    SurfaceRegions regions;
  };

  const Shape& shapeOf(const MeshPtr& mesh) {
    const auto known = shapes_.find(mesh);
    if (known != shapes_.end()) return known->second;
    Shape shape{welded(*mesh), {}};
    shape.regions = findSurfaceRegions(shape.mesh);
    return shapes_.emplace(mesh, std::move(shape)).first->second;
  }

  const std::vector<ContactBody>& bodies_;
  std::vector<std::unique_ptr<const PreparedBody>> prepared_;
  std::map<MeshPtr, Shape> shapes_;
};

}  // namespace

ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits,
                           const WorkWatch& watch) {
  ContactReport report;
  std::vector<Box3> boxes;
  for (const ContactBody& body : bodies) {
    boxes.push_back(boundingBox(*body.mesh, body.X_WB));
    const Vector3 margin = Vector3::Constant(0.5 * limits.clearanceUpTo + body.deflection + 1e-5);
    boxes.back().min() -= margin;
    boxes.back().max() += margin;
  }
  Preparation prepared(bodies);
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    watch.report(shareOfPairs(a, bodies.size()));
    for (std::size_t b = a + 1; b < bodies.size() && !watch.stop.stopRequested(); ++b) {
      if (limits.only && a != *limits.only && b != *limits.only) continue;
      if (!boxes[a].intersects(boxes[b])) continue;
      auto contact = contactOf(prepared[a], prepared[b], limits);
      if (!contact) continue;
      contact->a = a;
      contact->b = b;
      report.contacts.push_back(*contact);
    }
  }
  return report;
}

}  // namespace glissade
