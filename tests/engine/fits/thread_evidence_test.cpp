// Plates, axles, dowels, rods, tubes, washers, nuts, wrong pairs and modelled threads: which of them are threads is
// known by construction.
#include <gtest/gtest.h>

#include <set>

#include "engine/fits/joint_finder.h"
#include "engine/geometry/thread_standards.h"
#include "tests/engine/fits/grooved_shafts.h"
#include "tests/engine/fits/threaded_screw.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

using namespace glissade::test;

/// The expected result for a product.
struct Answer {
  enum class Kind {
    NoThread,    ///< nothing is screwed
    Thread,      ///< one joint is screwed and counts
    Contradicts  ///< one joint is screwed, doubtful, and does not count
  };
  Kind kind = Kind::NoThread;
  JointKind joint = JointKind::Screw;  ///< kind of the joint of a thread
};

struct Case {
  std::string what;
  AssembledProduct product;
  Answer answer;
};

constexpr Answer kNoThread{};
constexpr Answer kScrew{Answer::Kind::Thread, JointKind::Screw};
constexpr Answer kNut{Answer::Kind::Thread, JointKind::Nut};
constexpr Answer kParts{Answer::Kind::Thread, JointKind::Thread};
constexpr Answer kContradicts{Answer::Kind::Contradicts};

Contour rectangle(double length, double width) { return slot(length, width); }

/// A rod along an axis that is tilted against z.
Pose tilted(double angle) {
  Pose pose;
  pose.orientation = Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitX()));
  return pose;
}

/// One product of each kind for a size; `isNamed`: names say what the parts are, else "part 1" and so on.
class CaseMaker {
 public:
  CaseMaker(double diameter, bool isNamed, const Pose& at, RandomStream& random)
      : d_(diameter), r_(0.5 * diameter), isNamed_(isNamed), at_(at), random_(random) {
    const ThreadSize& size = nearestThreadSize(ThreadFamily::Metric, diameter);
    core_ = r_ - 0.54 * size.pitch;
    width_ = size.acrossFlats;
    size_ = size.name;
  }

  std::vector<Case> all() {
    std::vector<Case> cases;
    cases.push_back(plateUnderScrew("a square plate under a screw", square(), kScrew));
    cases.push_back(plateUnderScrew("a rectangular plate under a screw", oblong(), kScrew));
    cases.push_back(plateUnderScrew("a hexagonal plate under a screw", hexagon(), kScrew));
    cases.push_back(axleIn("an axle in a square plate", square(), 1.0));
    cases.push_back(axleIn("an axle in a rectangular plate", oblong(), 1.0));
    cases.push_back(axleIn("an axle in a hexagonal plate", hexagon(), 1.01));
    cases.push_back(dowel());
    cases.push_back(headedRod(1.0));
    cases.push_back(headedRod(1.03));
    cases.push_back(tiltedRod());
    cases.push_back(tube());
    cases.push_back(washer());
    cases.push_back(nutOnBolt("a nut on a bolt, both drawn by the diameter", 1.0));
    cases.push_back(nutOnBolt("a nut on a bolt, drawn by the core", core_ / r_));
    cases.push_back(nutOnRod());
    cases.push_back(wrongNut());
    cases.push_back(threadedRod());
    cases.push_back(pinNamedScrew());
    return cases;
  }

  /// Shafts with a relief that is modelled.
  std::vector<Case> reliefs() {
    std::vector<Case> cases;
    addThreads(cases);
    addOtherReliefs(cases);
    return cases;
  }

 private:
  std::string name(const std::string& said) { return isNamed_ ? said : "part " + std::to_string(++number_); }
  double within(double low, double high) { return random_.uniform(low, high); }
  Contour square() { return prism(within(2.2, 5.0) * d_, 4); }
  Contour oblong() { return rectangle(within(3.0, 5.0) * d_, within(2.2, 2.8) * d_); }
  Contour hexagon() { return prism(within(2.6, 4.5) * d_, 6); }
  TriangleMesh plate(double hole, const Contour& outside, double low, double high) {
    return tubeMesh(circle(hole), outside, low, high);
  }
  TriangleMesh headed(double length) { return screwMesh(d_, length, circle(0.9 * d_), 0.6 * d_, {}); }
  ProductOfParts parts() { return ProductOfParts(at_); }

  Case plateUnderScrew(const std::string& what, const Contour& outside, const Answer& answer) {
    const double thick = within(0.5, 1.5) * d_;
    auto made = parts();
    made.add(name("base"), plate(core_, prism(9.0 * d_, 4), -4.0 * d_, -thick))
        .add(name("plate"), plate(1.1 * r_, outside, -thick, 0.0))
        .add(name("ISO 4762 " + size_ + "x30"), capScrew(d_, 3.2 * d_));
    return {what, made.product(), answer};
  }

  Case axleIn(const std::string& what, const Contour& outside, double share) {
    auto made = parts();
    made.add(name("plate"), plate(share * r_, outside, 0.0, within(0.8, 1.6) * d_))
        .add(name("axle"), rodMesh(r_, -within(2.0, 9.0) * d_, within(4.0, 9.0) * d_));
    return {what, made.product(), kNoThread};
  }

  Case dowel() {
    auto made = parts();
    made.add(name("plate"), plate(within(0.995, 1.0) * r_, square(), 0.0, 1.2 * d_))
        .add(name("dowel pin ISO 2338"), rodMesh(r_, -0.5 * d_, 1.6 * d_));
    return {"a dowel in a plate", made.product(), kNoThread};
  }

  Case headedRod(double share) {
    auto made = parts();
    made.add(name("bracket"), plate(share * r_, oblong(), -2.0 * d_, -d_))
        .add(name("guide rod"), headed(within(3.0, 9.0) * d_));
    return {"a rod with a head in a bracket", made.product(), kNoThread};
  }

  Case tiltedRod() {
    auto made = parts();
    made.add(name("wall"), plate(1.03 * r_, prism(8.0 * d_, 4), -d_, 0.0), tilted(within(0.08, 0.15)))
        .add(name("rod"), screwMesh(d_, 5.0 * d_, circle(0.9 * d_), 0.6 * d_, {}),
             Pose::translation({0.0, 0.0, 2.0 * d_}));
    return {"a rod that is tilted against its hole", made.product(), kNoThread};
  }

  Case tube() {
    auto made = parts();
    made.add(name("clamp"), plate(r_, square(), 0.0, d_))
        .add(name("tube"), tubeMesh(circle(0.7 * r_), circle(r_), -3.0 * d_, 4.0 * d_));
    return {"a tube in a clamp", made.product(), kNoThread};
  }

  Case washer() {
    auto made = parts();
    made.add(name("shaft"), rodMesh(r_, -4.0 * d_, 4.0 * d_))
        .add(name("washer " + size_), tubeMesh(circle(1.05 * r_), circle(d_), 0.0, 0.2 * d_));
    return {"a washer on a shaft", made.product(), kNoThread};
  }

  Case nutOnBolt(const std::string& what, double share) {
    auto made = parts();
    made.add(name("plate"), plate(1.1 * r_, square(), -d_, 0.0))
        .add(name("ISO 4762 " + size_ + "x30"), capScrew(d_, 3.0 * d_))
        .add(name("ISO 4032 " + size_), tubeMesh(circle(share * r_), prism(width_, 6), -1.8 * d_, -d_));
    return {what, made.product(), kNut};
  }

  Case nutOnRod() {
    auto made = parts();
    made.add(name("rod"), rodMesh(r_, -5.0 * d_, 5.0 * d_))
        .add(name("ISO 4032 " + size_), tubeMesh(circle(r_), prism(width_, 6), 0.0, 0.8 * d_));
    return {"a nut on a rod", made.product(), kNut};
  }

  /// The nut is for a larger thread than the bolt.
  Case wrongNut() {
    const double thinner = muchSmaller();
    auto made = parts();
    made.add(name("plate"), plate(0.55 * thinner, square(), -d_, 0.0))
        .add(name("ISO 4762 " + nearestThreadSize(ThreadFamily::Metric, thinner).name + "x30"),
             capScrew(thinner, 3.0 * d_))
        .add(name("ISO 4032 " + size_), tubeMesh(circle(core_), prism(width_, 6), -1.8 * d_, -d_));
    return {"a bolt in a nut of another size", made.product(), kContradicts};
  }

  double muchSmaller() const {
    std::vector<double> smaller;
    for (const ThreadSize& size : threadSizes(ThreadFamily::Metric)) {
      if (size.acrossFlats > 0.0 && size.diameter < d_ - 1e-6) smaller.push_back(size.diameter);
    }
    return smaller[smaller.size() - 2];
  }

  Case threadedRod() {
    auto made = parts();
    made.add(name("block"), plate(core_, prism(7.0 * d_, 4), -2.0 * d_, 0.0))
        .add(name("stud"), rodMesh(r_, -d_, 4.0 * d_));
    return {"a threaded rod in a tapped hole", made.product(), kParts};
  }

  /// The recess makes it a screw, and its name a pin: its hole is as wide as the shaft.
  Case pinNamedScrew() {
    auto made = parts();
    made.add(name("plate"), plate(1.1 * r_, square(), -d_, 0.0))
        .add(name("block"), blockMesh(r_, 2.0 * d_, 8.0 * d_, -5.0 * d_, -d_))
        .add(name("guide pin"), capScrew(d_, 3.0 * d_));
    return {"a shaft with a drive", made.product(), isNamed_ ? kContradicts : kScrew};
  }

  /// Threads that are modelled as a helix, or as rings on what is a screw by its name.
  void addThreads(std::vector<Case>& cases) {
    const double plastic = 0.39 * d_;
    const double fine = 0.2 * d_;
    const std::string screw = "self tapping screw " + size_ + "x10";
    cases.push_back(
        inBoss("a coarse helix in plastic", screw, helix(r_, 0.58 * r_, plastic), ShaftHead::Round, kScrew));
    cases.push_back(inBoss("a fine helix", screw, helix(r_, 0.84 * r_, fine), ShaftHead::Hexagon, kScrew));
    cases.push_back(inBoss("a left-handed helix", screw, helix(r_, 0.6 * r_, -plastic), ShaftHead::Round, kScrew));
    cases.push_back(
        inBoss("a helix without a head", "insert stud", helix(r_, 0.6 * r_, plastic), ShaftHead::None, kParts));
    cases.push_back(inBoss("rings under a hexagon", screw, rings(r_, 0.7 * r_, 0.3 * d_), ShaftHead::Hexagon, kScrew));
    cases.push_back(cap());
    cases.push_back(clampedByHelix());
    cases.push_back(nutOnHelix());
  }

  void addOtherReliefs(std::vector<Case>& cases) {
    const double deep = 0.8 * r_;
    const auto none = ShaftHead::None;
    const auto round = ShaftHead::Round;
    cases.push_back(inBoss("barbs", "barbed pin", barbs(r_, deep, 0.3 * d_), none, kNoThread));
    cases.push_back(inBoss("rings", "ribbed pin", rings(r_, deep, 0.3 * d_), none, kNoThread));
    cases.push_back(inBoss("a knurl along the pin", "knurled pin", straightKnurl(r_, deep, 18), none, kNoThread));
    cases.push_back(inBoss("a knurl under a head", "press stud", straightKnurl(r_, deep, 18), round, kNoThread));
    cases.push_back(inBoss("a diamond knurl", "knurled pin", diamondKnurl(r_, deep, d_, 14), none, kNoThread));
    cases.push_back(inBoss("a pin that is hammered in", "rivet", helix(r_, deep, 2.5 * d_, 6), round, kNoThread));
    cases.push_back(dowelWithGroove());
    cases.push_back(knurledInsert());
  }

  /// A boss of plastic with a pilot hole that is narrower than the crests by half of a thread.
  Case inBoss(const std::string& what, const std::string& said, const Relief& relief, ShaftHead head,
              const Answer& answer) {
    auto made = parts();
    made.add(name("boss"), blockMesh(0.86 * r_, 2.6 * d_, 4.0 * d_, -4.0 * d_, -0.3 * d_))
        .add(name(said), groovedShaft(relief, 2.2 * d_, r_, head));
    return {what, made.product(), answer};
  }

  /// The thread is on the neck, and the cap is plain.
  Case cap() {
    auto made = parts();
    TriangleMesh neck = groovedShaft(helix(r_, 0.88 * r_, 0.2 * d_), d_, r_);
    made.add(name("neck"), neck).add(name("cap"), tubeMesh(circle(0.93 * r_), circle(1.3 * r_), -0.8 * d_, -0.1 * d_));
    return {"a cap on a neck with a helix", made.product(), kParts};
  }

  Case clampedByHelix() {
    auto made = parts();
    made.add(name("plate"), plate(1.1 * r_, square(), -0.5 * d_, 0.0))
        .add(name("boss"), blockMesh(0.86 * r_, 2.6 * d_, 4.0 * d_, -4.0 * d_, -0.5 * d_))
        .add(name("screw"), groovedShaft(helix(r_, 0.6 * r_, 0.36 * d_), 2.2 * d_, r_, ShaftHead::Round));
    return {"a plate under a screw with a helix", made.product(), kScrew};
  }

  Case nutOnHelix() {
    auto made = parts();
    made.add(name("plate"), plate(1.1 * r_, square(), -d_, 0.0))
        .add(name(size_ + "x20 screw"),
             ThreadedScrew{r_, core_ - 0.02 * r_, nearestThreadSize(ThreadFamily::Metric, d_).pitch, 3.0 * d_}.mesh())
        .add(name("ISO 4032 " + size_), tubeMesh(circle(core_), prism(width_, 6), -1.8 * d_, -d_));
    return {"a nut on a helix", made.product(), kNut};
  }

  Case dowelWithGroove() {
    auto made = parts();
    made.add(name("plate"), plate(0.997 * r_, square(), -1.6 * d_, -0.4 * d_))
        .add(name("dowel"), groovedShaft(ringGroove(r_, 0.9 * r_, -d_, 0.2 * d_), 2.0 * d_, r_));
    return {"a dowel with a groove for a ring", made.product(), kNoThread};
  }

  /// The screw is in the insert; the insert is pressed in, whatever its knurl.
  Case knurledInsert() {
    auto made = parts();
    const auto knurl = [this](double z) {
      return [this, z](double angle) { return diamondKnurl(1.7 * r_, 1.55 * r_, d_, 14)(z, angle); };
    };
    std::vector<Station> stations{{-1.5 * d_, circle(core_)}};
    for (int i = 0; i <= 24; ++i) stations.push_back({d_ * (-1.5 + i / 24.0), knurl(d_ * (-1.5 + i / 24.0))});
    stations.push_back({-0.5 * d_, circle(core_)});
    made.add(name("boss"), blockMesh(1.5 * r_, 2.6 * d_, 5.0 * d_, -4.0 * d_, -0.5 * d_))
        .add(name("threaded insert " + size_), turnedMesh(stations, true))
        .add(name("plate"), plate(1.1 * r_, square(), -0.5 * d_, 0.0))
        .add(name("ISO 4762 " + size_ + "x30"), capScrew(d_, 1.4 * d_));
    return {"a screw in a knurled insert", made.product(), kScrew};
  }

  double d_;
  double r_;
  bool isNamed_;
  Pose at_;
  RandomStream& random_;
  double core_ = 0.0;
  double width_ = 0.0;
  std::string size_;
  int number_ = 0;
};

bool isRight(const Joints& joints, const Answer& answer) {
  Joints screwed;
  for (const Joint& joint : joints) {
    if (isScrewed(joint.kind)) screwed.push_back(joint);
  }
  if (answer.kind == Answer::Kind::NoThread) return screwed.empty();
  if (screwed.size() != 1) return false;
  const bool counts = screwed[0].state == JointState::Recognised;
  if (answer.kind == Answer::Kind::Contradicts) return !counts && screwed[0].isDoubtful;
  return counts && screwed[0].kind == answer.joint && !screwed[0].isDoubtful;
}

std::string inWords(const Joints& joints) {
  std::string words;
  for (const Joint& joint : joints) {
    words += std::string(kJointStateNames.of(joint.state)) + " " + kJointKindNames.of(joint.kind) + " of " +
             std::to_string(joint.body) + (joint.isDoubtful ? " (?): " : ": ");
    words += toString(joined(joint.evidence, "; ")) + "; ";
  }
  return words.empty() ? "nothing" : words;
}

/// A screwed pair that is not found could be pulled.
TEST(ThreadEvidence, IsFoundWhereThereIsAThreadAndNowhereElse) {
  RandomStream random(7, "threads");
  std::size_t all = 0;
  for (const double size : {0.003, 0.005, 0.008, 0.012}) {
    for (const bool isNamed : {true, false}) {
      CaseMaker maker(size, isNamed, randomPose(random, 0.2), random);
      std::vector<Case> cases = maker.all();
      // The larger meshes are tested only for named screws of 3 mm and for unnamed screws of 8 mm.
      if (isNamed == (size == 0.003) && (isNamed || size == 0.008)) {
        for (Case& each : maker.reliefs()) cases.push_back(std::move(each));
      }
      for (const Case& one : cases) {
        const Joints joints = findJoints(one.product);
        ++all;
        EXPECT_TRUE(isRight(joints, one.answer))
            << one.what << ", " << 1e3 * size << " mm" << (isNamed ? ", named" : "") << ": " << inWords(joints);
      }
    }
  }
  EXPECT_GE(all, 160U);
}

/// Four squares that are nuts by their width, and one by its name only.
TEST(ThreadEvidence, ASquareIsANutWithItsNameOrOnAScrew) {
  const auto joints = [](const std::string& name, const Contour& outside, bool isScrew) {
    ProductOfParts parts;
    parts.add("1", isScrew ? capScrew(0.01, 0.04) : rodMesh(0.005, -0.04, 0.01))
        .add(name, tubeMesh(circle(0.005), outside, -0.03, -0.022));
    return findJoints(parts.product());
  };
  const auto isNut = [](const Joints& found) {
    return found.size() == 1 && isScrewed(found[0].kind) && found[0].state == JointState::Recognised;
  };
  EXPECT_TRUE(isNut(joints("2", prism(0.017, 4), true))) << "DIN 557 M10";
  EXPECT_FALSE(isNut(joints("2", prism(0.017, 4), false))) << "it may be a plate on an axle";
  EXPECT_TRUE(isNut(joints("square nut M10", prism(0.017, 4), false)));
  EXPECT_TRUE(isNut(joints("nut", slot(0.02, 0.014), false))) << "as those of as1";
  EXPECT_FALSE(isNut(joints("link", slot(0.02, 0.014), false)));
}

TEST(ThreadEvidence, PitchAndHandAreThoseOfTheDesignation) {
  struct Said {
    const char* name;
    double diameter;
    double pitch;
  };
  const double inch = 0.0254;
  for (const Said& said :
       {Said{"ISO 7049 ST4.2x35 tapping screw", 0.0042, 0.0014}, Said{"DIN 7981 4.8x16", 0.0048, 0.0016},
        Said{"wood screw 5x40", 0.005, 0.0022}, Said{"M10x1.5 LH left hand screw", 0.01, -0.0015},
        Said{"ISO 4017 M10x1", 0.01, 0.001}, Said{"M8 x 1 x 30 LH", 0.008, -0.001},
        Said{"SHCS 1_4-20 x 1-1_4", 0.25 * inch, inch / 20}, Said{"SHCS 1_4-28 x 1", 0.25 * inch, inch / 28},
        Said{"10-32 x 1_2 BHCS", 0.19 * inch, inch / 32}, Said{"#8 UNF screw", 0.164 * inch, inch / 36},
        Said{"bolt 3_8 UNC", 0.375 * inch, inch / 16}}) {
    ProductOfParts parts;
    const double d = said.diameter;
    parts.add("block", blockMesh(0.4 * d, 2.5 * d, 6.0 * d, -6.0 * d, 0.0)).add(said.name, capScrew(d, 2.0 * d));
    const Joints joints = findJoints(parts.product());
    ASSERT_EQ(joints.size(), 1U) << said.name;
    EXPECT_EQ(joints[0].kind, JointKind::Screw);
    EXPECT_NEAR(joints[0].thread->pitch, said.pitch, 1e-8) << said.name;
  }
}

/// The name of the bolt states the hand where the nut is turned.
TEST(ThreadEvidence, ALeftHandedBoltHasALeftHandedNut) {
  ProductOfParts parts;
  parts.add("M8 LH bolt", capScrew(0.008, 0.04))
      .add("plate", plateMesh(0.0045, 0.05, -0.02, 0.0))
      .add("nut", tubeMesh(circle(0.004), prism(0.013, 6), -0.0265, -0.02));
  const Joints joints = findJoints(parts.product());
  ASSERT_EQ(joints.size(), 1U);
  EXPECT_EQ(joints[0].kind, JointKind::Nut);
  EXPECT_NEAR(joints[0].thread->pitch, -0.00125, 1e-9);
}

TEST(ThreadEvidence, OnlyAScrewMakesItsHole) {
  const auto found = [](const std::string& name, bool hasDrive) {
    ProductOfParts parts;
    parts.add("motor", rodMesh(0.02, -0.05, -0.004))
        .add("cap", plateMesh(0.0023, 0.03, -0.004, 0.0))
        .add(name, hasDrive ? capScrew(0.004, 0.01) : screwMesh(0.004, 0.01, circle(0.0035), 0.003, {}));
    return findJoints(parts.product());
  };
  for (const bool hasDrive : {true, false}) {
    const Joints named = found("DIN 912 M4x10", hasDrive);
    ASSERT_EQ(named.size(), 1U);
    EXPECT_EQ(named[0].kind, JointKind::Screw);
    EXPECT_TRUE(named[0].makesHole);
  }
  for (const Joint& joint : found("post", false)) EXPECT_FALSE(isScrewed(joint.kind)) << "neither drive nor name";
}

}  // namespace
}  // namespace glissade
