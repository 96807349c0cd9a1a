#include "engine/api/threads.h"
#include "engine/api/values.h"
#include "engine/fits/joint_edits.h"
#include "engine/planning/clearance_profile.h"
#include "engine/sequence/product_finder.h"

namespace glissade::api {
namespace {

constexpr std::size_t kMostSamples = 1'000'000;

Diagnostic interrupted() { return {ErrorKind::Interrupted, "", "", "the search was stopped", ""}; }

Fit publicFit(const PairFit& pair) {
  const Contact& contact = pair.contact;
  return {pair.a.text(),       pair.b.text(),          kContactKindNames.of(contact.kind), contact.gap, contact.overlap,
          contact.uncertainty, pair.way().allowance(), kFitStatusNames.of(pair.status())};
}

std::vector<std::string> idsOf(const std::vector<std::size_t>& bodies, const AssembledProduct& product) {
  std::vector<std::string> ids;
  for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id.text());
  return ids;
}

Joint publicJoint(const glissade::Joint& joint, const AssembledProduct& product) {
  Joint made;
  made.kind = kJointKindNames.of(joint.kind);
  made.state = kJointStateNames.of(joint.state);
  made.body = product.bodies[joint.body].id.text();
  made.others = idsOf(joint.others, product);
  made.clamped = idsOf(joint.clamped, product);
  made.point = joint.point;
  made.direction = joint.direction;
  made.diameter = joint.thread ? joint.thread->diameter : 0.0;
  made.pitch = joint.thread ? joint.thread->pitch : 0.0;
  made.designation = joint.designation;
  for (const Message& fact : joint.evidence) made.evidence.push_back(toString(fact));
  return made;
}

}  // namespace

Result<std::vector<Fit>> fits(const Product& product, const FindOptions& options) {
  // The negations refuse NaN, too.
  if (!(options.clearanceUpTo >= 0.0)) return wrongArgument("clearanceUpTo", "is below 0");
  if (!(options.clashAbove >= 0.0)) return wrongArgument("clashAbove", "is below 0");
  return attempt<std::vector<Fit>>("finding fits", [&]() -> Result<std::vector<Fit>> {
    ThreadTeam team(helpersOf(options.threads));
    ContactLimits limits;
    limits.clearanceUpTo = options.clearanceUpTo;
    limits.clashOverlap = options.clashAbove;
    const AssembledProduct& bodies = product.impl().loaded.product;
    const auto table = ProductFinder().fits(bodies, team, {options.stop, options.progress}, limits);
    if (!table) return publicDiagnostic(table.error());
    std::vector<Fit> found;
    for (const PairFit& pair : (*table)->pairs()) found.push_back(publicFit(pair));
    return found;
  });
}

Result<std::vector<Joint>> joints(const Product& product, const FindOptions& options) {
  return attempt<std::vector<Joint>>("finding joints", [&]() -> Result<std::vector<Joint>> {
    const auto joints = jointsOf(product.impl().loaded, options.confirmsSuggested, options.stop);
    if (!joints) return publicDiagnostic(joints.error());
    std::vector<Joint> found;
    for (const glissade::Joint& joint : *joints) found.push_back(publicJoint(joint, product.impl().loaded.product));
    return found;
  });
}

Result<std::vector<ClearanceSample>> clearance(const World& world, const Path& path, const FindOptions& options) {
  if (options.samples > kMostSamples) return wrongArgument("samples", "are more than a million");
  return attempt<std::vector<ClearanceSample>>("measuring clearances", [&]() -> Result<std::vector<ClearanceSample>> {
    const CollisionWorld& shared = *world.impl().world;
    const auto query = shared.makeQuery();
    const ClearanceProfile profile =
        clearanceProfile(*query, path.impl().path.configurations(), Se3Metric(shared.objectRadius()), options.samples,
                         {options.stop, options.progress});
    if (!profile.complete) return interrupted();
    std::vector<ClearanceSample> samples;
    for (const glissade::ClearanceSample& sample : profile.samples) {
      samples.push_back({sample.share, publicPose(sample.q), publicNearest(sample.nearest, shared)});
    }
    return samples;
  });
}

}  // namespace glissade::api
