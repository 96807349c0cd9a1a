#include "engine/files/fits_cache.h"

#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/memory.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/variant.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>
#include <utility>

#include "engine/base/file.h"

namespace cereal {

template <class Archive>
void serialize(Archive& archive, glissade::Vector3& vector) {
  archive(vector.x(), vector.y(), vector.z());
}

}  // namespace cereal

namespace glissade {

// The library finds these functions by their names, in the namespaces of their types.

template <class Archive>
void save(Archive& archive, const BodyId& id) {
  archive(id.text());
}
template <class Archive>
void load(Archive& archive, BodyId& id) {
  std::string text;
  archive(text);
  id = BodyId(std::move(text));
}

template <class Archive>
void serialize(Archive& archive, Length& length) {
  archive(length.metres);
}
template <class Archive>
void serialize(Archive& archive, Depth& depth) {
  archive(depth.metres);
}
template <class Archive>
void save(Archive& archive, const Message& message) {
  archive(message.text, static_cast<std::uint64_t>(message.arguments.size()));
  for (const MessageArgument& argument : message.arguments) archive(argument.value);
}
template <class Archive>
void load(Archive& archive, Message& message) {
  std::uint64_t count = 0;
  archive(message.text, count);
  for (std::uint64_t i = 0; i < count; ++i) archive(message.arguments.emplace_back(std::string()).value);
}
template <class Archive>
void serialize(Archive& archive, Diagnostic& diagnostic) {
  archive(diagnostic.kind, diagnostic.file, static_cast<Message&>(diagnostic.location), diagnostic.reason,
          diagnostic.advice);
}

template <class Archive>
void serialize(Archive& archive, Pose& pose) {
  Quaternion& turn = pose.orientation;
  archive(pose.position, turn.w(), turn.x(), turn.y(), turn.z());
}
template <class Archive>
void serialize(Archive& archive, SurfaceFace& face) {
  archive(face.kind, face.point, face.axis, face.radius, face.second, face.deflection);
}
template <class Archive>
void serialize(Archive& archive, TriangleMesh& mesh) {
  archive(mesh.vertices, mesh.triangles, mesh.faces, mesh.faceOf);
}

template <class Archive>
void serialize(Archive& archive, ContactAxis& axis) {
  archive(axis.point, axis.direction, axis.radiusA, axis.radiusB, axis.shaftIsA, axis.conical);
}
template <class Archive>
void serialize(Archive& archive, Contact& contact) {
  archive(contact.a, contact.b, contact.kind, contact.gap, contact.overlap, contact.uncertainty, contact.deviation,
          contact.thickness, contact.axis, contact.isPlainOverlap);
}
template <class Archive>
void serialize(Archive& archive, ThreadRule& rule) {
  archive(rule.obstacle, rule.point_W, rule.axis_W, rule.pitch, rule.radiusOfObject, rule.radiusOfObstacle,
          rule.objectIsShaft, rule.mayTurn, rule.assembled);
}
template <class Archive>
void serialize(Archive& archive, FitThread& thread) {
  archive(thread.rule, thread.size);
}
template <class Archive>
void serialize(Archive& archive, Fit& fit) {
  archive(fit.body, fit.kind, fit.overlap, fit.allowance, fit.text, fit.moving, fit.yields, fit.hollow, fit.core,
          fit.pitch, fit.turns, fit.evidence);
  archive(fit.object, fit.obstacle, fit.role, fit.thread, fit.thinned, fit.cut, fit.refused);
}
template <class Archive>
void serialize(Archive& archive, ObjectFits& fits) {
  archive(fits.allowed, fits.clashes, fits.contacts, fits.warnings);
}

template <class Archive>
void serialize(Archive& archive, ContactLimits& limits) {
  archive(limits.clearanceUpTo, limits.clashOverlap, limits.clashThickness, limits.only);
}
template <class Archive>
void serialize(Archive& archive, FitEdit& edit) {
  archive(edit.a, edit.b, edit.kind, edit.allowance, edit.accepted, edit.pitch, edit.turned);
}
template <class Archive>
void serialize(Archive& archive, FitSettings& settings) {
  archive(settings.on, settings.acceptedClash, settings.pairs, settings.cut);
}

namespace evidence {

template <class Archive>
void serialize(Archive& archive, StatedThread& thread) {
  archive(thread.point, thread.direction, thread.pitch, thread.radiusMoving, thread.radiusOther);
}
template <class Archive>
void serialize(Archive& archive, Evidence& evidence) {
  archive(evidence.overlap, evidence.deflection, evidence.spacing, evidence.margin, evidence.byPerson);
}
template <class Archive>
void serialize(Archive& archive, SnapWord& snap) {
  archive(snap.hook, snap.edge, snap.bend, snap.direction, snap.byPlan);
}

}  // namespace evidence

namespace {

namespace fs = std::filesystem;

/// Digits of a SHA-256 at the head of a file: the hash of all that follows.
constexpr std::size_t kHashDigits = 64;
constexpr const char* kEnding = ".fits";

/// Removes the files that were used least recently until the others have `mostBytes` at most.
void tidy(const std::string& folder, std::size_t mostBytes) {
  struct Kept {
    fs::file_time_type used;
    std::size_t bytes;
    fs::path file;
  };
  std::error_code ignored;
  std::vector<Kept> kept;
  std::size_t bytes = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != kEnding) continue;
    kept.push_back({entry.last_write_time(ignored), entry.file_size(ignored), entry.path()});
    bytes += kept.back().bytes;
  }
  std::sort(kept.begin(), kept.end(), [](const Kept& one, const Kept& other) { return one.used < other.used; });
  for (const Kept& each : kept) {
    if (bytes <= mostBytes) return;
    fs::remove(each.file, ignored);
    bytes -= each.bytes;
  }
}

}  // namespace

FitsCache::FitsCache(std::string folder, std::string version, std::size_t mostBytes)
    : folder_(std::move(folder)), version_(std::move(version)), mostBytes_(mostBytes) {}

std::optional<std::vector<ObjectFits>> FitsCache::find(const std::string& key) const {
  const std::string file = fileOf(key);
  const auto content = readFile(file, mostBytes_);
  if (!content || content->size() < kHashDigits) return std::nullopt;
  std::string fits = content->substr(kHashDigits);
  if (sha256(fits) != content->substr(0, kHashDigits)) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  std::istringstream stream(std::move(fits));
  std::vector<ObjectFits> objects;
  try {
    cereal::BinaryInputArchive archive(stream);
    archive(objects);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return objects;
}

void FitsCache::keep(const std::string& key, const std::vector<ObjectFits>& objects) {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) return;
  std::ostringstream stream;
  cereal::BinaryOutputArchive archive(stream);
  archive(objects);
  const std::string fits = std::move(stream).str();
  if (writeFileAtomically(fileOf(key), sha256(fits) + fits)) tidy(folder_, mostBytes_);
}

std::string FitsCache::fileOf(const std::string& key) const { return folder_ + "/" + key + kEnding; }

std::string FitsCache::keyOf(const AssembledProduct& product, const ContactLimits& limits) const {
  std::ostringstream stream;
  cereal::BinaryOutputArchive archive(stream);
  archive(version_, std::string(__VERSION__), limits, product.deflections, product.fits, product.spacings,
          product.snaps);
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    const RigidBody& body = product.bodies[i];
    archive(body.id, body.name, body.label, product.nameInFile(i), body.X_WB, body.mesh);
  }
  return sha256(std::move(stream).str());
}

std::unique_ptr<FitsStore> usersFitsCache(const std::string& version) {
  if (version.find("-dirty") != std::string::npos) return nullptr;
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  std::string folder;
  if (cache != nullptr && fs::path(cache).is_absolute()) {
    folder = cache;
  } else if (home != nullptr && fs::path(home).is_absolute()) {
    folder = home + std::string("/.cache");
  } else {
    return nullptr;
  }
  return std::make_unique<FitsCache>(folder + "/glissade/fits", version);
}

}  // namespace glissade
