#include "engine/evidence/units.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "engine/evidence/pulled_thread.h"
#include "engine/evidence/rolling_bearing.h"
#include "engine/evidence/turn.h"
#include "engine/model/designation.h"

namespace glissade::evidence {
namespace {

bool isInsertName(const std::string& name) {
  const auto said = designationIn(name);
  return said && (said->part == StandardPart::Insert || said->part == StandardPart::Bearing);
}

/// The body as a ring about an axis: its least and its largest distance, and its range along the axis.
BearingRing ringAbout(const PlacedBody& body, const RoundFace& hole) {
  BearingRing ring{hole.point, hole.axis, std::numeric_limits<double>::infinity(), 0.0, 0.0, 0.0};
  ring.low = ring.hole;
  ring.high = -ring.hole;
  for (const Triangle& each : body.tree.triangles()) {
    const TurnedTriangle passed = turned(each[0], each[1], each[2], hole.point, hole.axis);
    ring.hole = std::min(ring.hole, passed.nearest);
    ring.outer = std::max(ring.outer, passed.farthest);
    ring.low = std::min(ring.low, passed.low);
    ring.high = std::max(ring.high, passed.high);
  }
  return ring;
}

/// Bodies that are connected step by step.
class ConnectedBodies {
 public:
  explicit ConnectedBodies(std::size_t count) : first_(count) {
    std::iota(first_.begin(), first_.end(), std::size_t{0});
  }

  void connect(std::size_t one, std::size_t other) {
    const auto [to, from] = std::minmax(first_[one], first_[other]);
    std::replace(first_.begin(), first_.end(), std::size_t{from}, std::size_t{to});
  }
  bool are(std::size_t one, std::size_t other) const { return first_[one] == first_[other]; }
  bool areAll() const {
    return std::all_of(first_.begin(), first_.end(), [](std::size_t each) { return each == 0; });
  }

 private:
  std::vector<std::size_t> first_;  ///< for each body the lowest one that it is connected to
};

class Unit {
 public:
  Unit(const std::vector<const Body*>& bodies, PlacedBodies& placed) : bodies_(bodies), connected_(bodies.size()) {
    for (const Body* body : bodies) placed_.push_back(&placed.at({*body, body->X_WB}));
  }

  void addSaid(const std::vector<BodyId>& unit) {
    const auto isIn = [&](std::size_t body) {
      return std::find(unit.begin(), unit.end(), bodies_[body]->id) != unit.end();
    };
    connectAll(isIn);
  }

  void addPressed() {
    for (std::size_t one = 0; one < bodies_.size(); ++one) {
      for (std::size_t other = 0; other < bodies_.size(); ++other) {
        if (one == other || connected_.are(one, other)) continue;
        const bool isIn = isPressedIn(*placed_[one], *placed_[other]) ||
                          isInsertIn(*placed_[one], *placed_[other], isInsertName(bodies_[one]->name));
        if (isIn) connected_.connect(one, other);
      }
    }
  }

  void addBearings() {
    for (const PlacedBody* inner : placed_) {
      for (const RoundFace& bore : inner->rounds) {
        if (!bore.isShaft) addBearing(*inner, bore);
      }
    }
  }

  bool isWhole() const { return connected_.areAll(); }

 private:
  template <class IsIn>
  void connectAll(const IsIn& isIn) {
    std::optional<std::size_t> first;
    for (std::size_t body = 0; body < bodies_.size(); ++body) {
      if (!isIn(body)) continue;
      if (first) connected_.connect(*first, body);
      if (!first) first = body;
    }
  }

  void addBearing(const PlacedBody& inner, const RoundFace& bore) {
    std::vector<BearingRing> rings;
    for (const PlacedBody* body : placed_) rings.push_back(ringAbout(*body, bore));
    const BearingRing in = ringAbout(inner, bore);
    for (std::size_t outer = 0; outer < placed_.size(); ++outer) {
      if (placed_[outer] == &inner || !areRaces(in, rings[outer])) continue;
      std::vector<bool> isPart(placed_.size(), false);
      std::size_t balls = 0;
      std::size_t rollers = 0;
      for (std::size_t body = 0; body < placed_.size(); ++body) {
        const auto element = rollingElement(*placed_[body]);
        const bool isRolling = element && isBetween(*element, in, rings[outer]);
        if (isRolling) ++(element->isBall ? balls : rollers);
        isPart[body] = isRolling || body == outer || placed_[body] == &inner || isCageOf(rings[body], in, rings[outer]);
      }
      if (areOfBearing(balls, rollers)) connectAll([&](std::size_t body) { return isPart[body]; });
    }
  }

  static std::optional<RollingElement> rollingElement(const PlacedBody& body) {
    if (const auto middle = ballMiddle(body.mesh)) return RollingElement{*middle, true};
    const auto isHole = [](const RoundFace& round) { return !round.isShaft; };
    if (body.rounds.empty() || std::any_of(body.rounds.begin(), body.rounds.end(), isHole)) return std::nullopt;
    return RollingElement{boundingBox(body.mesh).center(), false};
  }

  const std::vector<const Body*>& bodies_;
  std::vector<const PlacedBody*> placed_;
  ConnectedBodies connected_;
};

}  // namespace

bool areOneUnit(const std::vector<const Body*>& bodies, const std::vector<std::vector<BodyId>>& said,
                PlacedBodies& placed) {
  Unit unit(bodies, placed);
  for (const auto& each : said) unit.addSaid(each);
  unit.addPressed();
  if (!unit.isWhole()) unit.addBearings();
  return unit.isWhole();
}

}  // namespace glissade::evidence
