#include "engine/files/kept_path_json.h"

#include <set>

#include "engine/geometry/pose_json.h"
#include "engine/model/body_id_json.h"

namespace glissade {
namespace {

using Json = JsonCursor::Json;

constexpr std::size_t kMostKeptPaths = 1000;
constexpr std::size_t kMostKeptPoints = 10'000'000;

struct KeptPoint : PathPoint {};

using KeptPointFormat = ViewFormat<PathPoint, KeptPoint>;

struct KeptAllowance : Allowance {};

using KeptAllowanceFormat = ViewFormat<Allowance, KeptAllowance>;

bool hasPlanner(const KeptPath& path) { return !path.provenance.planner.empty(); }
bool hasClearance(const KeptPath& path) { return path.clearance >= 0.0; }

constexpr Accessor kPlanner{[](const KeptPath& path) { return path.provenance.planner; },
                            [](KeptPath& path, std::string id) { path.provenance.planner = std::move(id); }};
constexpr Accessor kSeed{[](const KeptPath& path) { return path.provenance.seed; },
                         [](KeptPath& path, std::uint64_t seed) { path.provenance.seed = seed; }};

}  // namespace

template <class Archive>
void describe(Archive& point, Type<KeptPoint> /*type*/) {
  point.type("kept_configuration");
  point.embed(&PathPoint::q);
  point.optional("author", &PathPoint::author, named(kAuthorNames), "Author of the configuration.", Always());
  point.check([](KeptPoint& read, const JsonCursor& /*at*/) { read.segmentAuthor = read.author; });
  point.optional("segment_author", &PathPoint::segmentAuthor, named(kAuthorNames),
                 "Author of the motion that ends here; absent: the author of the configuration.",
                 [](const PathPoint& written) { return written.segmentAuthor != written.author; });
}

template <class Archive>
void describe(Archive& allowance, Type<KeptAllowance> /*type*/) {
  allowance.type("kept_allowance");
  allowance.required("body", &Allowance::body, kBodyId, "Id of the obstacle.");
  allowance.required("allowance", &Allowance::allowance, kLength, "Metres.");
  allowance.optional("yields", &Allowance::yields, kBoolean, "The obstacle was taken thinner, not the object.");
  allowance.optional("hollow", &Allowance::hollow, kBoolean,
                     "The overlap was taken away to this depth: a clash that a person accepts.");
}

template <class Archive>
void describe(Archive& path, Type<KeptPath> /*type*/) {
  path.type("kept_path");
  path.required("name", &KeptPath::name, kNonEmptyText, "Unique among the paths.");
  path.optional("pinned", &KeptPath::pinned, kBoolean);
  path.required("object", &KeptPath::object, kNonEmptyText, "Id of the object that moves.");
  path.optional("planner", kPlanner, kText, "Strategy of the run that found the path; absent: unknown.", hasPlanner);
  path.optional("seed", kSeed, kCount, "", hasPlanner);
  path.optional("smoothed", &KeptPath::smoothed, kBoolean, "The path was shortened after it was planned.");
  path.required("required_clearance", &KeptPath::requiredClearance, kLength, "Metres.");
  path.optional("clearance", &KeptPath::clearance, kLengthOrZero,
                "Smallest distance to any body, metres, when the path was kept; absent: no body was near.",
                hasClearance);
  path.optional("proved_clearance", &KeptPath::provedClearance, kLengthOrZero, "Metres, when the path was kept.",
                Always());
  path.optional("allowances", &KeptPath::allowances, listOf(KeptAllowanceFormat()),
                "By how much the object and bodies that it fits were taken thinner against each other.");
  path.optional("problem_sha256", &KeptPath::problemSha256, kText,
                "Hash of the problem for which the path was proved.");
  path.required("configurations", &KeptPath::points, listOf(KeptPointFormat(), 1, kMostKeptPoints),
                "Straight motions lead from each to the next.");
}

KeptPaths KeptPathsFormat::read(const JsonCursor& at) const {
  KeptPaths paths;
  std::set<std::string> names;
  for (std::size_t i = 0; i < at.sizeUpTo(kMostKeptPaths); ++i) {
    const JsonCursor element = at.element(i);
    auto path = std::make_shared<const KeptPath>(readDescribed<KeptPath>(element));
    if (!names.insert(path->name).second) {
      element.at("name").fail(GLISSADE_TEXT("is the name of a path before it"),
                              GLISSADE_TEXT("Give every path a name of its own."));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

Json KeptPathsFormat::write(const KeptPaths& paths) const {
  Json list = Json::array();
  for (const KeptPathPtr& path : paths) list.push_back(writeDescribed(*path));
  return list;
}

Json KeptPathsFormat::schema(SchemaDefinitions& definitions) const {
  return {{"type", "array"}, {"maxItems", kMostKeptPaths}, {"items", definitions.reference<KeptPath>()}};
}

}  // namespace glissade
