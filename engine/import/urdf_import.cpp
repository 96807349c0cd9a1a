#include "engine/import/urdf_import.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <mutex>

#include "engine/geometry/primitives.h"
#include "engine/import/input_file.h"
#include "engine/import/mesh_exchange.h"
#include "engine/import/mesh_import.h"
#include "engine/import/sha256.h"
#include "engine/import/urdf_survey.h"

namespace glissade {
namespace {

/// Thrown inside this file only, with the file left out; importUrdf turns it into a Result.
struct Refusal {
  Diagnostic diagnostic;
};

[[noreturn]] void refuse(const std::string& place, const std::string& reason, const std::string& advice) {
  throw Refusal{{ErrorKind::MalformedInput, "", place, reason, advice}};
}

/// Gathers what urdfdom says while it is in scope. Lines after the first are consequences.
class CapturedMessages : public console_bridge::OutputHandler {
 public:
  CapturedMessages() { console_bridge::useOutputHandler(this); }
  ~CapturedMessages() override { console_bridge::restorePreviousOutputHandler(); }
  CapturedMessages(const CapturedMessages&) = delete;
  CapturedMessages& operator=(const CapturedMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
  }
  std::string asReason() const { return first_.empty() ? "" : " (" + first_ + ")"; }

 private:
  std::string first_;
};

std::string ofLink(const std::string& name) { return "link '" + name + "'"; }

void checkPositive(const std::string& place, std::initializer_list<double> sizes) {
  for (const double size : sizes) {
    const bool sound = std::isfinite(size) && size > 0.0 && size <= kLargestCoordinate;
    if (!sound) refuse(place, "a shape has a size that is not a positive number", "Give every size in metres.");
  }
}

Pose toPose(const urdf::Pose& pose, const std::string& place) {
  const urdf::Rotation& r = pose.rotation;
  Pose result{{pose.position.x, pose.position.y, pose.position.z}, Quaternion(r.w, r.x, r.y, r.z)};
  const bool sound = isValid(result) && result.position.cwiseAbs().maxCoeff() <= kLargestCoordinate;
  if (!sound) refuse(place, "an origin is not a pose", "Give finite numbers in 'xyz' and 'rpy'.");
  result.orientation.normalize();
  return result;
}

/// Reads the geometry of one file; knows where its mesh files may be.
class GeometryReader {
 public:
  GeometryReader(std::string urdfFile, std::string folder)
      : urdfFile_(std::move(urdfFile)), folder_(std::move(folder)) {}

  TriangleMesh read(const urdf::Geometry& geometry, const std::string& place) const {
    switch (geometry.type) {
      case urdf::Geometry::BOX: {
        const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
        checkPositive(place, {size.x, size.y, size.z});
        return makeBox({size.x, size.y, size.z});
      }
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
        checkPositive(place, {cylinder.radius, cylinder.length});
        return makeCylinder(cylinder.radius, cylinder.length);
      }
      case urdf::Geometry::SPHERE: {
        const auto& sphere = static_cast<const urdf::Sphere&>(geometry);
        checkPositive(place, {sphere.radius});
        return makeSphere(sphere.radius);
      }
      case urdf::Geometry::MESH: return readMesh(static_cast<const urdf::Mesh&>(geometry), place);
    }
    refuse(place, "a shape is of an unknown kind", "Use box, cylinder, sphere or mesh.");
  }

 private:
  TriangleMesh readMesh(const urdf::Mesh& mesh, const std::string& place) const {
    const Vector3 scale(mesh.scale.x, mesh.scale.y, mesh.scale.z);
    checkPositive(place, {std::abs(scale.x()), std::abs(scale.y()), std::abs(scale.z())});
    const Result<ImportedMesh> imported = importMesh(locate(mesh.filename, place), {});
    if (!imported) throw Refusal{imported.error()};
    return scaled(imported->mesh, scale);
  }

  std::string locate(const std::string& name, const std::string& place) const {
    namespace fs = std::filesystem;
    constexpr std::string_view kPackage = "package://";
    std::vector<std::string> candidates;
    if (name.compare(0, kPackage.size(), kPackage) == 0) {
      const std::string inPackage = name.substr(kPackage.size());
      candidates = {inPackage, inPackage.substr(inPackage.find('/') + 1)};
    } else if (name.find("://") != std::string::npos || fs::path(name).is_absolute()) {
      refuse(place, "the mesh file '" + name + "' is outside the scenario's folder", "Name it relative to this file.");
    } else {
      const fs::path here = fs::path(folderOf(urdfFile_)).lexically_relative(folder_);
      candidates = {(here / name).lexically_normal().string()};
    }
    Result<std::string> found = resolveInside(folder_, candidates.front());
    std::error_code error;
    if (candidates.size() > 1 && found && !fs::exists(*found, error)) found = resolveInside(folder_, candidates.back());
    if (!found) refuse(place, found.error().reason, found.error().advice);
    return *found;
  }

  std::string urdfFile_;
  std::string folder_;
};

/// urdfdom drops shapes that it cannot read and goes on; nothing may be lost without a word.
void compareWithSurvey(const urdf::ModelInterface& model, const UrdfSurvey& survey, const CapturedMessages& messages) {
  const std::string advice = "Mend its numbers and names.";
  for (const UrdfSurvey::Link& counted : survey.links) {
    const urdf::LinkConstSharedPtr link = model.getLink(counted.name);
    if (!link) refuse(ofLink(counted.name), "the link cannot be read" + messages.asReason(), advice);
    const bool complete =
        link->collision_array.size() == counted.collisions && link->visual_array.size() == counted.visuals;
    if (!complete) refuse(ofLink(counted.name), "a shape cannot be read" + messages.asReason(), advice);
  }
  if (model.links_.size() != survey.links.size()) refuse("", "two links have the same name", advice);
  if (model.joints_.size() != survey.joints) refuse("", "a joint cannot be read" + messages.asReason(), advice);
}

template <class Shapes>
TriangleMesh readShapes(const Shapes& shapes, const GeometryReader& reader, const std::string& place) {
  TriangleMesh mesh;
  for (const auto& shape : shapes) {
    if (!shape->geometry) refuse(place, "a shape has no geometry", "Give it a box, cylinder, sphere or mesh.");
    append(mesh, transformed(reader.read(*shape->geometry, place), toPose(shape->origin, place)));
  }
  return mesh;
}

std::optional<Colour> colourOf(const urdf::Link& link) {
  for (const urdf::VisualSharedPtr& visual : link.visual_array) {
    if (!visual->material || !visual->material->texture_filename.empty()) continue;
    const urdf::Color& colour = visual->material->color;
    const Colour rgb{colour.r, colour.g, colour.b};
    for (const double part : rgb) {
      if (!(part >= 0.0 && part <= 1.0)) refuse(ofLink(link.name), "a colour is not between 0 and 1", "Mend it.");
    }
    return rgb;
  }
  return std::nullopt;
}

/// Pose of the link in the root's frame, along fixed joints.
Pose poseInRoot(const urdf::ModelInterface& model, const urdf::Link& link) {
  Pose X_RootLink;
  for (urdf::JointConstSharedPtr joint = link.parent_joint; joint;) {
    const std::string place = "joint '" + joint->name + "'";
    if (joint->type != urdf::Joint::FIXED) {
      refuse(place, "the joint can move", "Only fixed joints are read: fix it in the position you want.");
    }
    X_RootLink = toPose(joint->parent_to_joint_origin_transform, place) * X_RootLink;
    joint = model.getLink(joint->parent_link_name)->parent_joint;
  }
  return X_RootLink;
}

UrdfModel read(const std::string& content, const GeometryReader& reader) {
  const Result<UrdfSurvey> survey = surveyUrdf(content);
  if (!survey) throw Refusal{survey.error()};
  static std::mutex consoleBridge;
  const std::lock_guard<std::mutex> lock(consoleBridge);
  const CapturedMessages messages;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(content);
  if (!model) refuse("", "this is not a robot description" + messages.asReason(), "Mend its links and joints.");
  compareWithSurvey(*model, *survey, messages);

  UrdfModel result;
  result.name = model->getName();
  for (const UrdfSurvey::Link& counted : survey->links) {
    const urdf::Link& link = *model->getLink(counted.name);
    UrdfLink read;
    read.name = link.name;
    read.X_RootLink = poseInRoot(*model, link);
    read.mesh = link.collision_array.empty() ? readShapes(link.visual_array, reader, ofLink(link.name))
                                             : readShapes(link.collision_array, reader, ofLink(link.name));
    read.colour = colourOf(link);
    if (!read.mesh.empty()) result.links.push_back(std::move(read));
  }
  if (result.links.empty()) refuse("", "no link has geometry", "Give a link a box, cylinder, sphere or mesh.");
  return result;
}

}  // namespace

Result<UrdfModel> importUrdf(const std::string& file, const std::string& folder) {
  const Result<std::string> content = readInputFile(file, kLargestTextFile);
  if (!content) return content.error();
  Diagnostic problem{ErrorKind::MalformedInput, "", "", "", "Mend the file."};
  try {
    UrdfModel model = read(*content, GeometryReader(file, folder));
    model.sha256 = sha256(*content);
    return model;
  } catch (const Refusal& refusal) {
    problem = refusal.diagnostic;
  } catch (const std::exception& error) {
    problem.reason = std::string("urdfdom cannot read it (") + error.what() + ")";
  }
  if (problem.file.empty()) problem.file = file;
  return problem;
}

}  // namespace glissade
