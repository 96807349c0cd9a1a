#include "engine/import/urdf_import.h"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

#include "engine/base/limits.h"
#include "engine/base/printable_text.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "engine/import/safe_path.h"
#include "engine/import/xml_precheck.h"

namespace glissade {
namespace {

constexpr std::size_t kMostUrdfBytes = 16U << 20;
/// urdfdom releases a chain of links recursively.
constexpr std::size_t kMostLinks = 4000;
/// Largest number of triangles of all shapes together.
constexpr std::size_t kMostTriangles = 8U << 20;

Diagnostic malformedUrdf(const std::string& file, const Location& location, const Message& reason) {
  return {ErrorKind::MalformedInput, file, location, reason, GLISSADE_TEXT("Correct the URDF file.")};
}

/// Collects the messages of urdfdom about a file during the lifetime of this object.
class ParserMessages final : public console_bridge::OutputHandler {
 public:
  ParserMessages() : previous_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~ParserMessages() override { console_bridge::useOutputHandler(previous_); }
  ParserMessages(const ParserMessages&) = delete;
  ParserMessages& operator=(const ParserMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN && first_.empty()) first_ = text;
  }
  /// The first warning or error; `otherwise` if there is none.
  Message firstOr(CatalogueText otherwise) const { return first_.empty() ? Message(otherwise) : Message(first_); }

 private:
  console_bridge::OutputHandler* previous_;
  std::string first_;
};

Pose toPose(const urdf::Pose& pose) {
  Pose result;
  result.position = {pose.position.x, pose.position.y, pose.position.z};
  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  result.orientation = Quaternion(w, x, y, z).normalized();
  return result;
}

bool isSound(const Pose& pose) {
  return isValid(pose) && pose.position.cwiseAbs().maxCoeff() <= limits::kLargestLength;
}

/// Converts one parsed file to links; stops at the first error.
class LinkBuilder {
 public:
  LinkBuilder(std::string file, std::string packageFolder, StopToken stop)
      : file_(std::move(file)), packageFolder_(std::move(packageFolder)), stop_(std::move(stop)) {}

  Result<std::vector<Occurrence>> build(const urdf::ModelInterface& model) {
    std::vector<Occurrence> links;
    std::vector<std::pair<urdf::LinkConstSharedPtr, Pose>> open{{model.getRoot(), Pose::identity()}};
    for (std::size_t i = 0; i < open.size(); ++i) {
      // Two joints with one child would be followed twice, and a chain of such pairs without end.
      if (open.size() > model.links_.size())
        return malformedUrdf(file_, "", GLISSADE_TEXT("has a link that is the child of two joints"));
      const auto [link, X_RL] = open[i];
      coordinateSpacing_ = 0.0;
      auto mesh = meshOf(*link);
      if (!mesh) return mesh.error();
      triangles_ += mesh->triangles.size();
      if (triangles_ > kMostTriangles) {
        return malformedUrdf(file_, "", {GLISSADE_TEXT("has more than %1 triangles"), {kMostTriangles}});
      }
      if (!mesh->empty()) {
        Occurrence part{printableLine(link->name), std::make_shared<const TriangleMesh>(std::move(*mesh)), X_RL,
                        colourOf(*link)};
        part.coordinateSpacing = coordinateSpacing_;
        links.push_back(std::move(part));
      }
      for (const auto& joint : link->child_joints) {
        const Location place{GLISSADE_TEXT("joint '%1'"), {joint->name}};
        if (joint->type != urdf::Joint::FIXED) {
          return malformedUrdf(file_, place, GLISSADE_TEXT("is not fixed: only rigid bodies are read"));
        }
        const Pose X_LC = toPose(joint->parent_to_joint_origin_transform);
        const Pose X_RC = X_RL * X_LC;
        if (!isSound(X_LC) || !isSound(X_RC)) return malformedUrdf(file_, place, kFarOrigin);
        open.emplace_back(model.getLink(joint->child_link_name), X_RC);
      }
    }
    if (open.size() < model.links_.size())
      return malformedUrdf(file_, "", GLISSADE_TEXT("has links that no joint connects to its root"));
    if (links.empty()) return malformedUrdf(file_, "", GLISSADE_TEXT("holds no shape"));
    return links;
  }

 private:
  Result<TriangleMesh> meshOf(const urdf::Link& link) {
    TriangleMesh mesh;
    const auto add = [&](const auto& shapes) -> Outcome {
      for (const auto& shape : shapes) {
        const Location location{GLISSADE_TEXT("link '%1'"), {link.name}};
        auto part = meshOf(*shape->geometry, location);
        if (!part) return part.error();
        const Pose X_LS = toPose(shape->origin);
        if (!isSound(X_LS)) return malformedUrdf(file_, location, kFarOrigin);
        append(mesh, transformed(*part, X_LS));
      }
      return Done{};
    };
    const Outcome outcome = link.collision_array.empty() ? add(link.visual_array) : add(link.collision_array);
    if (!outcome) return outcome.error();
    return mesh;
  }

  Result<TriangleMesh> meshOf(const urdf::Geometry& geometry, const Location& location) {
    const auto sized = [](std::initializer_list<double> sizes) {
      return std::all_of(sizes.begin(), sizes.end(), limits::isSize);
    };
    const Diagnostic badSize = malformedUrdf(
        file_, location, GLISSADE_TEXT("has a shape whose size is not a positive number from 1e-12 m to 1e9 m"));
    switch (geometry.type) {
      case urdf::Geometry::BOX: {
        const auto& box = static_cast<const urdf::Box&>(geometry);
        if (!sized({box.dim.x, box.dim.y, box.dim.z})) return badSize;
        return makeBox({box.dim.x, box.dim.y, box.dim.z});
      }
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
        if (!sized({cylinder.radius, cylinder.length})) return badSize;
        return makeCylinder(cylinder.radius, cylinder.length);
      }
      case urdf::Geometry::SPHERE: {
        const auto& sphere = static_cast<const urdf::Sphere&>(geometry);
        if (!sized({sphere.radius})) return badSize;
        return makeSphere(sphere.radius);
      }
      case urdf::Geometry::MESH: return meshOf(static_cast<const urdf::Mesh&>(geometry), location);
    }
    return malformedUrdf(file_, location, GLISSADE_TEXT("has an unknown shape"));
  }

  Result<TriangleMesh> meshOf(const urdf::Mesh& mesh, const Location& location) {
    constexpr const char* kPackage = "package://";
    const Vector3 scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
    if (!limits::isSize(scale.cwiseAbs().minCoeff()) || !limits::isSize(scale.cwiseAbs().maxCoeff())) {
      return malformedUrdf(file_, location, GLISSADE_TEXT("has a mesh whose scale is not a number from 1e-12 to 1e9"));
    }
    std::string name = mesh.filename;
    if (name.rfind(kPackage, 0) == 0) name.erase(0, std::string(kPackage).size());
    const auto path = resolveBelow(packageFolder_, name, file_, location);
    if (!path) return path.error();
    auto known = meshes_.find(*path);
    if (known == meshes_.end()) {
      auto imported = importMesh(*path, stop_);
      if (!imported) return imported.error();
      known = meshes_.emplace(*path, KnownMesh{welded(imported->mesh), imported->coordinateSpacing}).first;
    }
    coordinateSpacing_ = std::max(coordinateSpacing_, known->second.coordinateSpacing * scale.cwiseAbs().maxCoeff());
    return scaled(known->second.mesh, scale);
  }

  static std::optional<std::array<double, 3>> colourOf(const urdf::Link& link) {
    if (!link.visual || !link.visual->material) return std::nullopt;
    const auto& colour = link.visual->material->color;
    return std::array<double, 3>{colour.r, colour.g, colour.b};
  }

  static constexpr CatalogueText kFarOrigin = GLISSADE_TEXT("has an origin that is not finite, or beyond 1e9 m");

  std::string file_;
  std::string packageFolder_;
  StopToken stop_;
  struct KnownMesh {
    TriangleMesh mesh;
    double coordinateSpacing;
  };
  std::map<std::string, KnownMesh> meshes_;  ///< each file is read once
  double coordinateSpacing_ = 0.0;           ///< spacing of the meshes of the link that is being built
  std::size_t triangles_ = 0;
};

/// Nothing if urdfdom refuses the text, by its result or by an exception.
urdf::ModelInterfaceSharedPtr parse(const std::string& text) {
  try {
    return urdf::parseURDF(text);
  } catch (const std::exception&) {
    return nullptr;
  }
}

/// Counts the shapes that should exist: urdfdom drops a shape with a bad number and still returns a model.
std::size_t shapesIn(const urdf::ModelInterface& model) {
  std::size_t shapes = 0;
  for (const auto& [name, link] : model.links_) shapes += link->visual_array.size() + link->collision_array.size();
  return shapes;
}

}  // namespace

Result<std::vector<Occurrence>> importUrdf(const FileContent& content, const std::string& packageFolder,
                                           const StopToken& stop) {
  const auto& [file, text] = content;
  const auto facts = precheckXml(text, file);
  if (!facts) return facts.error();
  if (facts->links > kMostLinks) {
    return malformedUrdf(file, "", {GLISSADE_TEXT("has more than %1 links"), {kMostLinks}});
  }
  ParserMessages messages;
  const urdf::ModelInterfaceSharedPtr model = parse(text);
  if (!model || !model->getRoot()) {
    return malformedUrdf(file, "", messages.firstOr(GLISSADE_TEXT("is not a URDF file")));
  }
  if (shapesIn(*model) != facts->geometries) {
    return malformedUrdf(file, "", messages.firstOr(GLISSADE_TEXT("has a shape that cannot be read")));
  }
  return LinkBuilder(file, packageFolder, stop).build(*model);
}

Result<std::vector<Occurrence>> importUrdf(const std::string& file, const std::string& packageFolder) {
  const auto content = readContent(file, kMostUrdfBytes);
  if (!content) return content.error();
  return importUrdf(*content, packageFolder);
}

}  // namespace glissade
