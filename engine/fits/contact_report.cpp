#include "engine/fits/contact_report.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "engine/base/made_once.h"
#include "engine/base/part_count.h"
#include "engine/fits/contact_finder.h"

namespace glissade {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

/// Prepares each body for its first comparison, and the surfaces of each mesh once. Thread-safe.
class Preparation {
 public:
  explicit Preparation(const std::vector<ContactBody>& bodies) : bodies_(bodies), prepared_(bodies.size()) {}

  const PreparedBody& of(std::size_t index) {
    Prepared& own = prepared_[index];
    std::call_once(own.isMade, [&] {
      const ContactBody& body = bodies_[index];
      const auto shape = shapes_.get(body.mesh.get(), {}, [&] { return shapeOf(*body.mesh); });
      own.body = std::make_unique<const PreparedBody>(transformed(shape->mesh, body.X_WB),
                                                      transformed(shape->regions, body.X_WB), body.deflection);
    });
    return *own.body;
  }

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

  struct Prepared {
    std::once_flag isMade;
    std::unique_ptr<const PreparedBody> body;
  };

  const std::vector<ContactBody>& bodies_;
  std::vector<Prepared> prepared_;
  MadeOnce<const TriangleMesh*, ShapePtr> shapes_;
};

/// Pairs whose boxes are near each other.
std::vector<Pair> nearPairs(const std::vector<ContactBody>& bodies, const ContactLimits& limits) {
  std::vector<Box3> boxes;
  for (const ContactBody& body : bodies) {
    boxes.push_back(boundingBox(*body.mesh, body.X_WB));
    const Vector3 margin = Vector3::Constant(0.5 * limits.clearanceUpTo + body.deflection + 1e-5);
    boxes.back().min() -= margin;
    boxes.back().max() += margin;
  }
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (limits.only && a != *limits.only && b != *limits.only) continue;
      if (boxes[a].intersects(boxes[b])) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

/// Sorts pairs by their finer mesh, the coarsest first: most pairs are compared in a limited time then.
void sortBySize(const std::vector<ContactBody>& bodies, std::vector<Pair>& pairs) {
  const auto sizeOf = [&](const Pair& pair) {
    return std::max(bodies[pair.first].mesh->triangles.size(), bodies[pair.second].mesh->triangles.size());
  };
  std::stable_sort(pairs.begin(), pairs.end(),
                   [&](const Pair& one, const Pair& other) { return sizeOf(one) < sizeOf(other); });
}

}  // namespace

ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits, const WorkWatch& watch,
                           ThreadTeam& team, const std::optional<StopToken>& enough) {
  auto pairs = nearPairs(bodies, limits);
  if (enough) sortBySize(bodies, pairs);
  Preparation prepared(bodies);
  std::vector<std::optional<Contact>> found(pairs.size());
  std::vector<char> isLeft(pairs.size(), 0);
  PartCount done(watch, pairs.size());
  team.run(pairs.size(), [&](std::size_t i) {
    if (watch.stop.stopRequested()) return;
    isLeft[i] = enough && enough->stopRequested();
    if (isLeft[i] == 0) found[i] = contactOf(prepared.of(pairs[i].first), prepared.of(pairs[i].second), limits);
    done.add();
  });
  ContactReport report;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (isLeft[i] != 0) report.notCompared.push_back(pairs[i]);
    if (!found[i]) continue;
    report.contacts.push_back(*found[i]);
    report.contacts.back().a = pairs[i].first;
    report.contacts.back().b = pairs[i].second;
  }
  std::sort(report.contacts.begin(), report.contacts.end(), [](const Contact& one, const Contact& other) {
    return std::tie(one.a, one.b) < std::tie(other.a, other.b);
  });
  return report;
}

ContactReport findContacts(const std::vector<ContactBody>& bodies, const ContactLimits& limits,
                           const WorkWatch& watch) {
  ThreadTeam alone(0);
  return findContacts(bodies, limits, watch, alone);
}

}  // namespace glissade
