#include "engine/files/sequence_json.h"

#include "engine/files/body_classes_json.h"
#include "engine/files/joints_json.h"
#include "engine/files/semantics_json.h"
#include "engine/geometry/pose_json.h"
#include "engine/sequence/fastener_kind.h"

namespace glissade {
namespace {

constexpr std::size_t kMostMotionPoints = 1'000'000;

/// A configuration of a motion. The author of its segment is not written.
struct MotionPoint : PathPoint {};

using MotionPointFormat = ViewFormat<PathPoint, MotionPoint>;

/// Names of at least so many bodies.
constexpr ListFormat<GetterFormat<std::string>> names(std::size_t least) { return listOf(kNonEmptyText, least); }

/// A direction of any length above zero.
struct AnyLengthFormat : VectorFormat {
  Vector3 read(const JsonCursor& at) const {
    const Vector3 direction = readVector(at);
    if (!(direction.norm() > 0.0)) at.fail(GLISSADE_TEXT("has no direction"));
    return direction;
  }
};

void checkFasteners(const SequenceDemands& demands, const JsonCursor& at) {
  for (std::size_t i = 0; i < demands.fasteners.size(); ++i) {
    if (kFastenerNames.find(demands.fasteners[i].second)) continue;
    at.at("fasteners")
        .element(i)
        .fail({GLISSADE_TEXT("names a fastener that is not one of: %1"), {kFastenerNames.listed()}});
  }
}

}  // namespace

template <class Archive>
void describe(Archive& point, Type<MotionPoint> /*type*/) {
  point.type("motion_configuration");
  point.embed(&PathPoint::q);
  point.required("author", &PathPoint::author, named(kAuthorNames));
}

std::vector<PathPoint> MotionFormat::read(const JsonCursor& at) const {
  return listOf(MotionPointFormat(), least, kMostMotionPoints).read(at);
}

JsonCursor::Json MotionFormat::write(const std::vector<PathPoint>& path) const {
  return listOf(MotionPointFormat()).write(path);
}

JsonCursor::Json MotionFormat::schema(SchemaDefinitions& definitions) const {
  return listOf(MotionPointFormat(), least).schema(definitions);
}

template <class Archive>
void describe(Archive& place, Type<DemandedPlace> /*type*/) {
  place.type("demanded_place");
  place.required("bodies", &DemandedPlace::bodies, names(1), "Several bodies leave as one.");
  place.required("place", &DemandedPlace::place, kCountFrom1);
  place.optional("locked", &DemandedPlace::locked, kBoolean, "The step keeps its place where other steps are moved.");
}

template <class Archive>
void describe(Archive& motion, Type<DemandedMotion> /*type*/) {
  motion.type("demanded_motion");
  motion.required("bodies", &DemandedMotion::bodies, names(1), "Several bodies leave as one.");
  motion.required("method", &DemandedMotion::method, kNonEmptyText,
                  "'by hand', or the method of the step that it was.");
  motion.required("path", &DemandedMotion::path, MotionFormat{2},
                  "Configurations, as of a step of a plan: at the first one the product is assembled.");
}

template <class Archive>
void describe(Archive& direction, Type<ForbiddenDirection> /*type*/) {
  direction.type("forbidden_direction");
  direction.required("body", &ForbiddenDirection::body, kNonEmptyText);
  direction.required("direction", &ForbiddenDirection::direction, AnyLengthFormat());
}

template <class Archive>
void describe(Archive& demands, Type<SequenceDemands> /*type*/) {
  using Demands = SequenceDemands;
  demands.type("sequence",
               "A person's demands on assembly plans. Bodies are named by id, or by the end of ids behind a '/'.");
  demands.optional("together", &Demands::together, listOf(names(2)), "Bodies that leave as one.");
  demands.optional("before", &Demands::before, listOf(kTextPair), "The first body leaves before the second.");
  demands.optional("gravity", &Demands::gravity, AnyLengthFormat(),
                   "Direction of gravity; absent: the base lies well, see up of plans.");
  demands.optional("densities", &Demands::densities, listOf(PairFormat{"body", "density", kPositive}),
                   "Densities in kg/m^3; 7850 for other bodies.");
  demands.optional("joint_use", &Demands::jointUse, named(kJointUseNames),
                   "Joints that a plan keeps to: none, those that shapes or a person state, or suggested ones as well. "
                   "Absent: recognised.");
  demands.optional("joints", &Demands::joints, JointEditsFormat());
  demands.optional("stay", &Demands::stay, names(0), "Bodies that do not leave.");
  demands.optional("masses", &Demands::masses, listOf(PairFormat{"body", "mass", kPositive}),
                   "Masses in kg; by volume and density for other bodies.");
  demands.optional("fragile", &Demands::fragile, names(0), "Bodies that leave as early as they can.");
  demands.optional("tools", &Demands::tools, listOf(kTextPair),
                   "A body and its tool: hex_key, socket, screwdriver, open_wrench, circlip_pliers, none. By shape for "
                   "other bodies.");
  demands.optional("fasteners", &Demands::fasteners, listOf(kTextPair),
                   "A body and its kind of fastener: screw, nut, washer, pin, none. By shape for other bodies.");
  demands.optional("cost", &Demands::cost, kNonEmptyText,
                   "Cost of a step, for best-first: balanced, steady, few-tools, short, fragile-first, or an "
                   "expression.");
  demands.optional("attributes", &Demands::attributes, mapOf(AttributesFormat()),
                   "By id: attributes of parts of a body, as stand/bar, which costs name as body.<attribute>, beside "
                   "the attributes of the bodies of the scenario.");
  demands.optional("classes", &Demands::classes, kBodyClasses,
                   "Classes of bodies, beside those of body_classes.json. A class replaces another one of its name.");
  demands.optional("places", &Demands::places, kObjects<DemandedPlace>,
                   "Steps that a person wants at places of the plan, from 1 in the order of removal.");
  demands.optional("motions", &Demands::motions, kObjects<DemandedMotion>,
                   "The only motions by which these bodies leave: found by hand, or kept.");
  demands.optional("forbidden", &Demands::forbidden, kObjects<ForbiddenDirection>,
                   "Directions in which bodies do not move, nor within 30 degrees of them, until their convex hulls "
                   "are clear of those of the bodies that they touch.");
  demands.check(checkFasteners);
}

template struct ObjectFormat<SequenceDemands>;

}  // namespace glissade
