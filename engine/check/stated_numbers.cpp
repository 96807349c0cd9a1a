#include "engine/check/stated_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "engine/base/number_text.h"
#include "engine/check/motion_setup.h"
#include "engine/check/pair_work.h"
#include "engine/check/verdict_words.h"

namespace glissade::check {
namespace {

/// Relative differences within which two computations of a number agree.
constexpr double kClearanceShare = 0.01;
constexpr double kTurnShare = 0.01;
constexpr double kDiameterShare = 0.04;
constexpr double kFlatsShare = 0.03;
constexpr double kOverlapShare = 0.05;
/// Absolute differences that are ignored: metres, and turns.
constexpr double kLeastLength = 1e-8;
constexpr double kLeastTurn = 1e-3;

bool isNear(double stated, double found, double share, double least) {
  return std::abs(stated - found) <= share * std::max(std::abs(stated), std::abs(found)) + least;
}

/// The rotation of a path, about any axis.
struct Turning {
  double turns = 0.0;
  double pitch = 0.0;  ///< pitch of its first turn, metres; 0: it does not turn
};

Turning turningOf(const std::vector<Point>& path) {
  constexpr double kEnoughTurn = 0.01;  // radians
  Turning turning;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::AngleAxisd turn(
        (path[i].q.orientation * path[i - 1].q.orientation.conjugate()).normalized().toRotationMatrix());
    turning.turns += std::abs(turn.angle()) / (2.0 * std::numbers::pi);
    if (turning.pitch != 0.0 || std::abs(turn.angle()) < kEnoughTurn) continue;
    const Vector3 way = path[i].q.position - path[i - 1].q.position;
    turning.pitch = way.dot(turn.axis()) / turn.angle() * 2.0 * std::numbers::pi;
  }
  return turning;
}

class Numbers {
 public:
  explicit Numbers(const NumbersQuestion& question)
      : question_(question), step_(*question.numbered.step), turning_(turningOf(step_.path)) {}

  std::vector<Message> wrong() {
    compareCounts();
    if (step_.proof && step_.certified) compareProof(*step_.proof);
    for (const StatedJoint& joint : step_.joints) compareJoint(joint);
    for (const StatedAllowance& allowance : step_.allowances) compareAllowance(allowance);
    return std::move(wrong_);
  }

 private:
  void refuse(const char* key, const MessageArgument& stated, const MessageArgument& found) {
    wrong_.push_back({GLISSADE_TEXT("it states \"%1\": %2, and the independent check finds %3"), {key, stated, found}});
  }

  /// `of`: the joint or the allowance that the number belongs to.
  void refuse(const char* key, double stated, const MessageArgument& found, const Message& of) {
    wrong_.push_back({GLISSADE_TEXT("it states \"%1\": %2 of %3, and the independent check finds %4"),
                      {key, shortText(stated), of, found}});
  }

  static Message atMost(double value) { return {GLISSADE_TEXT("at most %1"), {shortText(value)}}; }

  void compareCounts() {
    const std::size_t bodies = question_.product.bodies.size();
    for (const auto& [key, number] : {std::pair("wave", step_.wave), std::pair("task", step_.task)}) {
      if (number && *number > bodies) refuse(key, *number, Message{GLISSADE_TEXT("at most %1"), {bodies}});
    }
  }

  void compareProof(const StatedProof& proof) {
    const std::size_t before = question_.numbered.earlier;
    if (proof.afterSteps > before) {
      refuse("after_steps", proof.afterSteps, Message{GLISSADE_TEXT("%1 {1|step|steps} before it"), {before}});
    }
    if (!proof.nearest.empty() && question_.product.find(proof.nearest) == nullptr) {
      refuse("nearest", Message{GLISSADE_TEXT("'%1'"), {proof.nearest.text()}}, GLISSADE_TEXT("no such body"));
    }
    if (proof.required && question_.required && !isNear(*proof.required, *question_.required, kClearanceShare, 0.0)) {
      refuse("required_m", shortText(*proof.required), shortText(*question_.required));
    }
    const double met = question_.farthest;
    if (proof.provedClearance && *proof.provedClearance > (1.0 + kClearanceShare) * met + kLeastLength) {
      refuse("proved_clearance_m", shortText(*proof.provedClearance), atMost(met));
    }
    const double proved = question_.verdict.motion.verdict.provedClearance;
    const bool isOfSameBodies = proof.afterSteps == before;
    if (proof.minClearance && isOfSameBodies && question_.verdict.certified() &&
        *proof.minClearance < (1.0 - kClearanceShare) * proved - kLeastLength) {
      refuse("min_clearance_m", shortText(*proof.minClearance),
             Message{GLISSADE_TEXT("at least %1"), {shortText(proved)}});
    }
    if (proof.minClearance && proof.provedClearance &&
        *proof.minClearance < (1.0 - kClearanceShare) * *proof.provedClearance) {
      refuse("min_clearance_m", shortText(*proof.minClearance),
             Message{GLISSADE_TEXT("at least the certified %1"), {shortText(*proof.provedClearance)}});
    }
    if (proof.minClearance && std::isfinite(met) && !std::isfinite(*proof.minClearance)) {
      refuse("min_clearance_m", "null", atMost(met));
    }
  }

  void compareJoint(const StatedJoint& joint) {
    const Message of{GLISSADE_TEXT("the joint of '%1'"), {question_.product.nameOf(joint.body)}};
    if (joint.turns && !isNear(*joint.turns, turning_.turns, kTurnShare, kLeastTurn)) {
      refuse("turns", *joint.turns, shortText(turning_.turns), of);
    }
    const bool turns = joint.turns && *joint.turns > 0.0 && turning_.pitch != 0.0;
    if (joint.pitch && *joint.pitch != 0.0 && turns) {
      // The hand is that of the motion, whichever of the two bodies moves.
      if (!isNear(*joint.pitch, turning_.pitch, kEstimate, kLeastLength)) {
        refuse("pitch_m", *joint.pitch, shortText(turning_.pitch), of);
      }
    }
    if (joint.diameter && *joint.diameter > 0.0) compareDiameter(joint, of);
    if (joint.bend && *joint.bend > 0.0) compareBend(joint, of);
    if (joint.driveSize && *joint.driveSize > 0.0) compareDrive(joint, of);
  }

  /// A thread may be drawn anywhere from its core to its crests, on either body.
  void compareDiameter(const StatedJoint& joint, const Message& of) {
    std::vector<BodyId> ids = joint.others;
    ids.push_back(joint.body);
    double nearest = 0.0;
    double largest = 0.0;
    for (const BodyId& id : ids) {
      const Body* body = question_.product.find(id);
      if (body == nullptr) continue;
      const PlacedBody& placed = question_.placed.at({*body, body->X_WB});
      largest = std::max(largest, 2.0 * placed.halfDiagonal);
      for (const RoundFace& round : placed.rounds) {
        if (std::abs(2.0 * round.radius - *joint.diameter) < std::abs(nearest - *joint.diameter)) {
          nearest = 2.0 * round.radius;
        }
      }
    }
    constexpr double kCoreShare = 0.3;
    const bool isDrawn = nearest > (1.0 - kCoreShare) * *joint.diameter - kLeastLength &&
                         nearest < (1.0 + kDiameterShare) * *joint.diameter;
    if (nearest > 0.0 && !isDrawn) {
      refuse("diameter_m", *joint.diameter, Message{GLISSADE_TEXT("a cylinder of %1"), {shortText(nearest)}}, of);
    } else if (nearest == 0.0 && *joint.diameter > largest) {
      refuse("diameter_m", *joint.diameter, Message{GLISSADE_TEXT("bodies of %1"), {shortText(largest)}}, of);
    }
  }

  void compareBend(const StatedJoint& joint, const Message& of) {
    for (const BodyId& other : joint.others) {
      const SnapWord* snap = question_.product.fits.snapOf(joint.body, other);
      const double bend = snap == nullptr ? 0.0 : snap->bend;
      if (isNear(*joint.bend, bend, kEstimate, kLeastLength)) continue;
      const MessageArgument noWord = GLISSADE_TEXT("no statement about a bend");
      refuse("bend_m", *joint.bend, snap == nullptr ? noWord : shortText(bend), of);
    }
  }

  /// The width across flats of a hexagon is the distance between two faces; other drives are no larger than their
  /// bodies.
  void compareDrive(const StatedJoint& joint, const Message& of) {
    const Body* body = question_.product.find(joint.body);
    if (body == nullptr) return;
    const double size = boundingBox(*body->mesh).diagonal().norm();
    if (*joint.driveSize > size) {
      refuse("drive_size_m", *joint.driveSize, Message{GLISSADE_TEXT("a body of %1"), {shortText(size)}}, of);
      return;
    }
    const bool isHexagon = joint.drive == "hex" || joint.drive == "hex_socket";
    if (!isHexagon || joint.isNamed || hasFlats(*body->mesh, *joint.driveSize)) return;
    if (joint.drive == "hex_socket" && isOfPlainCapHead(*body, joint)) return;
    refuse("drive_size_m", *joint.driveSize, GLISSADE_TEXT("no two parallel faces so far apart"), of);
  }

  /// True if the key is that of ISO 4762 for the thread, and the screw is drawn with a head and without its socket: its
  /// two cylinders on one axis are the thread and a head of 1.4 to 2.2 diameters.
  bool isOfPlainCapHead(const Body& body, const StatedJoint& joint) {
    struct Key {
      double diameter;  // millimetres
      double across;
    };
    constexpr std::array kKeys{Key{1.6, 1.5},   Key{2.0, 1.5},   Key{2.5, 2.0},   Key{3.0, 2.5},  Key{4.0, 3.0},
                               Key{5.0, 4.0},   Key{6.0, 5.0},   Key{8.0, 6.0},   Key{10.0, 8.0}, Key{12.0, 10.0},
                               Key{14.0, 12.0}, Key{16.0, 14.0}, Key{20.0, 17.0}, Key{24.0, 19.0}};
    const double diameter = joint.diameter.value_or(0.0);
    const bool isStandard = std::any_of(kKeys.begin(), kKeys.end(), [&](const Key& key) {
      return isNear(diameter, 1e-3 * key.diameter, kDiameterShare, 0.0) &&
             isNear(*joint.driveSize, 1e-3 * key.across, kDiameterShare, 0.0);
    });
    if (!isStandard) return false;
    const std::vector<RoundFace>& rounds = question_.placed.at({body, body.X_WB}).rounds;
    return std::any_of(rounds.begin(), rounds.end(), [&](const RoundFace& thread) {
      return thread.isShaft && isNear(2.0 * thread.radius, diameter, kDiameterShare, 0.0) &&
             std::any_of(rounds.begin(), rounds.end(), [&](const RoundFace& head) {
               const double ratio = 2.0 * head.radius / diameter;
               const bool isOneAxis = head.axis.cross(thread.axis).norm() < 1e-3 &&
                                      (head.point - thread.point).cross(thread.axis).norm() < 0.02 * diameter;
               return head.isShaft && ratio > 1.4 && ratio < 2.2 && isOneAxis;
             });
    });
  }

  static bool hasFlats(const TriangleMesh& mesh, double across) {
    using Direction = std::tuple<long, long, long>;
    constexpr double kDirections = 1e3;
    const auto rounded = [](const Vector3& n) {
      return Direction{std::lround(kDirections * n.x()), std::lround(kDirections * n.y()),
                       std::lround(kDirections * n.z())};
    };
    std::map<Direction, std::vector<double>> planes;
    for (const auto& triangle : mesh.triangles) {
      const Vector3 a = mesh.vertices[triangle[0]];
      const Vector3 normal = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
      if (!(normal.norm() > 0.0)) continue;
      planes[rounded(normal.normalized())].push_back(normal.normalized().dot(a));
    }
    for (auto& [direction, offsets] : planes) {
      std::sort(offsets.begin(), offsets.end());
      offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    }
    for (const auto& [direction, offsets] : planes) {
      const auto& [x, y, z] = direction;
      const auto opposite = planes.find({-x, -y, -z});
      if (opposite == planes.end()) continue;
      for (const double offset : offsets) {
        // The two faces of a socket face each other.
        const auto isAcross = [&](double other) {
          return isNear(std::abs(offset + other), across, kFlatsShare, kLeastLength);
        };
        if (std::any_of(opposite->second.begin(), opposite->second.end(), isAcross)) return true;
      }
    }
    return false;
  }

  void compareAllowance(const StatedAllowance& stated) {
    const BodyId moving = stated.moving.empty() ? step_.bodies.front() : stated.moving;
    const Message of{GLISSADE_TEXT("the allowance for '%1' and '%2'"),
                     {question_.product.nameOf(moving), question_.product.nameOf(stated.body)}};
    if (stated.turns && *stated.turns > turning_.turns * (1.0 + kTurnShare) + kLeastTurn) {
      refuse("turns", *stated.turns, shortText(turning_.turns), of);
    }
    bool isKnown = false;
    bool isOverlap = !stated.overlap;
    bool isEvidence = !stated.evidence;
    std::string overlap;
    std::string evidence;
    for (const AppliedAllowance& applied : question_.verdict.allowances) {
      if (applied.moving != moving || applied.other != stated.body) continue;
      isKnown = true;
      if (stated.overlap) isOverlap = isOverlap || isOverlapOf(*stated.overlap, applied);
      if (stated.evidence) isEvidence = isEvidence || isEvidenceOf(*stated.evidence, applied.evidence);
      overlap = shortText(applied.evidence.overlap);
      evidence = shortText(applied.evidence.sum());
      if (applied.hollow && stated.hollow && !isNear(stated.allowance, applied.most, kEstimate, kLeastLength)) {
        refuse("allowance_m", stated.allowance, shortText(applied.most), of);
      }
    }
    if (!isKnown) return;
    if (!isOverlap) refuse("overlap_m", *stated.overlap, overlap, of);
    if (!isEvidence) refuse("evidence", stated.evidence->sum(), evidence, of);
  }

  static bool isOverlapOf(double stated, const AppliedAllowance& applied) {
    // Triangles of a fit overlap by their deviations from their surfaces.
    constexpr double kLeastOverlap = 2e-6;  // metres
    // A plan may claim less than the true overlap.
    return stated < applied.evidence.overlap ||
           isNear(stated, applied.evidence.overlap, kOverlapShare, kLeastOverlap + applied.evidence.deflection);
  }

  static bool isEvidenceOf(const Evidence& stated, const Evidence& found) {
    const auto isSame = [](double a, double b) { return isNear(a, b, kEstimate, kLeastLength); };
    return isSame(stated.overlap, found.overlap) && isSame(stated.deflection, found.deflection) &&
           isSame(stated.spacing, found.spacing) && isSame(stated.margin, found.margin) &&
           isSame(stated.byPerson, found.byPerson);
  }

  const NumbersQuestion& question_;
  const Step& step_;
  Turning turning_;
  std::vector<Message> wrong_;
};

}  // namespace

std::vector<Message> wrongNumbers(const NumbersQuestion& question) { return Numbers(question).wrong(); }

}  // namespace glissade::check
