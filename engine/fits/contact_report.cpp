#include "engine/fits/contact_report.h"

#include <set>
#include <utility>

#include "engine/base/made_once.h"
#include "engine/base/part_count.h"
#include "engine/fits/contact_finder.h"

namespace glissade {
namespace {

/// Prepares bodies for comparisons, and the surfaces of each mesh once. Thread-safe for different bodies.
class Preparation {
 public:
  explicit Preparation(const std::vector<ContactBody>& bodies) : bodies_(bodies), prepared_(bodies.size()) {}

  void prepare(std::size_t index) {
    const ContactBody& body = bodies_[index];
    const auto shape = shapes_.get(body.mesh.get(), {}, [&] { return shapeOf(*body.mesh); });
    prepared_[index] = std::make_unique<const PreparedBody>(transformed(shape->mesh, body.X_WB),
                                                            transformed(shape->regions, body.X_WB), body.deflection);
  }
  /// Precondition: it is prepared.
  const PreparedBody& operator[](std::size_t index) const { return *prepared_[index]; }

 private:
  struct Shape {
    TriangleMesh mesh;
    SurfaceRegions regions;
  };
  using ShapePtr = std::shared_ptr<const Shape>;

  static ShapePtr shapeOf(const TriangleMesh& mesh) {
    Shape shape{welded(mesh), {}};
    shape.regions = findSurfaceRegions(shape.mesh);
    return std::make_shared<const Shape>(std::move(shape));
  }

  const std::vector<ContactBody>& bodies_;
  std::vector<std::unique_ptr<const PreparedBody>> prepared_;
  MadeOnce<const TriangleMesh*, ShapePtr> shapes_;
};

/// Pairs whose boxes are near each other, ordered by the first body, then by the second one.
std::vector<std::pair<std::size_t, std::size_t>> nearPairs(const std::vector<ContactBody>& bodies,
                                                           const ContactLimits& limits) {
  std::vector<Box3> boxes;
  for (const ContactBody& body : bodies) {
    boxes.push_back(boundingBox(*body.mesh, body.X_WB));
    const Vector3 margin = Vector3::Constant(0.5 * limits.clearanceUpTo + body.deflection + 1e-5);
    boxes.back().min() -= margin;
    boxes.back().max() += margin;
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (limits.only && a != *limits.only && b != *limits.only) continue;
      if (boxes[a].intersects(boxes[b])) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

}  // namespace

ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits, const WorkWatch& watch,
                           ThreadTeam& team) {
  const auto pairs = nearPairs(bodies, limits);
  std::set<std::size_t> compared;
  for (const auto& [a, b] : pairs) compared.insert({a, b});
  const std::vector<std::size_t> all(compared.begin(), compared.end());
  Preparation prepared(bodies);
  team.run(all.size(), [&](std::size_t i) {
    if (!watch.stop.stopRequested()) prepared.prepare(all[i]);
  });
  std::vector<std::optional<Contact>> found(pairs.size());
  PartCount done(watch, pairs.size());
  team.run(pairs.size(), [&](std::size_t i) {
    if (watch.stop.stopRequested()) return;
    found[i] = contactOf(prepared[pairs[i].first], prepared[pairs[i].second], limits);
    done.add();
  });
  ContactReport report;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!found[i]) continue;
    report.contacts.push_back(*found[i]);
    report.contacts.back().a = pairs[i].first;
    report.contacts.back().b = pairs[i].second;
  }
  return report;
}

ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits,
                           const WorkWatch& watch) {
  ThreadTeam alone(0);
  return findContacts(bodies, limits, watch, alone);
}

}  // namespace glissade
