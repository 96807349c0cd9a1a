#include "engine/import/confined_step_import.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <gp_Quaternion.hxx>
#include <istream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <streambuf>
#include <string_view>
#include <tuple>

#include "engine/base/message_json.h"
#include "engine/base/printable_text.h"
#include "engine/import/brep_parts.h"
#include "engine/import/confinement.h"
#include "engine/import/foreign_text.h"
#include "engine/import/iges_parts.h"
#include "engine/import/import_refusal.h"
#include "engine/import/shape_overlaps.h"
#include "engine/import/step_assembly.h"
#include "engine/import/step_edited_text.h"
#include "engine/import/step_entities.h"
#include "engine/import/step_fineness.h"
#include "engine/import/step_healing_notes.h"
#include "engine/import/step_shape_notes.h"
#include "engine/import/step_tessellation.h"
#include "engine/import/step_text_check.h"
#include "engine/import/step_validation_notes.h"
#include "engine/model/body_path.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// Reads memory without a copy.
class MemoryBuffer final : public std::streambuf {
 public:
  MemoryBuffer(char* content, std::size_t bytes) { setg(content, content, content + bytes); }
};

/// Gives the coordinates of the first vertex to vertices that differ by rounding only.
void joinRounded(std::vector<double>& vertices) {
  constexpr double kRounding = 1e-9;  // millimetres
  std::vector<std::size_t> byX(vertices.size() / 3);
  std::iota(byX.begin(), byX.end(), std::size_t{0});
  std::sort(byX.begin(), byX.end(), [&](std::size_t a, std::size_t b) { return vertices[3 * a] < vertices[3 * b]; });
  for (std::size_t i = 1; i < byX.size(); ++i) {
    double* own = &vertices[3 * byX[i]];
    for (std::size_t j = i; j > 0; --j) {
      const double* other = &vertices[3 * byX[j - 1]];
      if (own[0] - other[0] > kRounding) break;
      if (std::abs(own[1] - other[1]) > kRounding || std::abs(own[2] - other[2]) > kRounding) continue;
      std::copy(other, other + 3, own);
      break;
    }
  }
}

/// The note as a line of the protocol.
std::string lineOf(const StepNote& note) {
  nlohmann::json json{{"kind", std::string(1, note.kind)}, {"text", toJson(note.text)}};
  if (note.kind == protocol::kMissingLine) {
    json["product"] = note.product;
    json["entity"] = note.entity;
    json["shape"] = note.shapeKind;
  } else {
    json["place"] = toJson(note.place);
  }
  return glissade::lineOf(json);
}

/// Writes the triangles of each shape once, whatever the number of its parts.
class AssemblyMessage {
 public:
  AssemblyMessage(double deflection, const StepAssembly& assembly)
      : fineness_(deflection, assembly.solids),
        rootName_(assembly.rootName),
        unit_(assembly.unit),
        isSewn_(assembly.isSewn),
        externalParts_(assembly.externalParts) {
    addNotes(assembly.notes);
    addNotes(assembly.losses);
    total_.kind = protocol::kAssembly;
    for (const StepSolid& solid : assembly.solids) add(solid, assembly);
    addNotes(validationNotes(assembly.measures, [this](const TopoDS_Shape& shape) { return validated(shape); }));
    if (healings_ > kMostHealings) {
      notes_ += lineOf(
          {protocol::kHealedLine,
           "",
           {GLISSADE_TEXT(
                "%1 more {1|face was triangulated from its boundary|faces were triangulated from their boundaries}"),
            {healings_ - kMostHealings}}});
    }
  }

  void write(const ImportOutput& output) const {
    output.write(&total_, sizeof total_);
    const protocol::AssemblyCounts counts{static_cast<std::uint32_t>(shapes_.size()),
                                          static_cast<std::uint32_t>(parts_.size()),
                                          static_cast<std::uint32_t>(notes_.size()),
                                          static_cast<std::uint32_t>(externalParts_.size()),
                                          static_cast<std::uint32_t>(rootName_.size()),
                                          0,
                                          unit_};
    output.write(&counts, sizeof counts);
    output.write(rootName_.data(), rootName_.size());
    for (const StepTriangles& shape : shapes_) {
      output.write(&shape.record, sizeof shape.record);
      output.write(shape.vertices);
      output.write(shape.indices);
      output.write(shape.faces);
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      output.write(&parts_[i], sizeof parts_[i]);
      output.write(paths_[i].data(), paths_[i].size());
      output.write(names_[i].data(), names_[i].size());
      output.write(formerPaths_[i].data(), formerPaths_[i].size());
    }
    for (const StepExternalPart& part : externalParts_) write(part, output);
    output.write(notes_.data(), notes_.size());
  }

 private:
  void add(const StepSolid& solid, const StepAssembly& assembly) {
    protocol::Part part;
    part.shape = shapeOf(solid, assembly);
    place(solid.placement.rigid, part);
    part.hasColour = solid.colour ? 1 : 0;
    if (solid.colour) std::copy(solid.colour->begin(), solid.colour->end(), part.colour);
    part.pathBytes = static_cast<std::uint32_t>(solid.path.size());
    names_.push_back(namesText(solid.path, solid.names));
    part.namesBytes = static_cast<std::uint32_t>(names_.back().size());
    part.formerPathBytes = static_cast<std::uint32_t>(solid.formerPath.size());
    part.isSolidOfPart = solid.isOneOfSeveral ? 1 : 0;
    parts_.push_back(part);
    paths_.push_back(solid.path);
    formerPaths_.push_back(solid.formerPath);
  }

  /// One line for each step; empty if the names are those of the path.
  static std::string namesText(const std::string& path, const std::vector<NodeNames>& names) {
    std::string text;
    if (names == productNames(stepsOf(path))) return text;
    for (const NodeNames& each : names) text += each.product + "\t" + each.occurrence + "\t" + each.designator + "\n";
    return text;
  }

  template <class Placed>
  static void place(const gp_Trsf& placement, Placed& placed) {
    const gp_XYZ position = placement.TranslationPart();
    const gp_Quaternion turn = placement.GetRotation();
    for (int i = 0; i < 3; ++i) placed.position[i] = position.Coord(i + 1);
    placed.orientation[0] = turn.X();
    placed.orientation[1] = turn.Y();
    placed.orientation[2] = turn.Z();
    placed.orientation[3] = turn.W();
  }

  static void write(const StepExternalPart& part, const ImportOutput& output) {
    protocol::ExternalPart record;
    place(part.placement, record);
    record.pathBytes = static_cast<std::uint32_t>(part.path.size());
    const std::string names = namesText(part.path, part.names);
    record.namesBytes = static_cast<std::uint32_t>(names.size());
    record.fileBytes = static_cast<std::uint32_t>(part.file.size());
    output.write(&record, sizeof record);
    output.write(part.path.data(), part.path.size());
    output.write(names.data(), names.size());
    output.write(part.file.data(), part.file.size());
  }

  std::uint32_t shapeOf(const StepSolid& solid, const StepAssembly& assembly) {
    if (!numberOf_.IsBound(solid.shape)) numberOf_.Bind(solid.shape, numberOf_.Extent());
    const Key key{numberOf_.Find(solid.shape), solid.placement.scale, solid.placement.mirrored};
    const auto [known, isNew] = indexOf_.try_emplace(key, static_cast<std::uint32_t>(shapes_.size()));
    if (isNew) addShape(solid, assembly);
    return known->second;
  }

  /// A solid as the file states it, at its origin; null if it was not met, or only mirrored or scaled.
  const ValidatedSolid* validated(const TopoDS_Shape& shape) const {
    if (!numberOf_.IsBound(shape)) return nullptr;
    const auto known = indexOf_.find(Key{numberOf_.Find(shape), 1.0, false});
    return known == indexOf_.end() ? nullptr : &solids_[known->second];
  }

  void addShape(const StepSolid& solid, const StepAssembly& assembly) {
    const auto& [rigid, scale, mirrored] = solid.placement;
    const StepTessellation* held = assembly.standIns.of(solid.shape);
    shapes_.push_back(held != nullptr
                          ? trianglesOf(*held, scale, mirrored)
                          : tessellate(solid.shape, fineness_.of(solid), assembly.faceEntities, scale, mirrored));
    if (isSewn_) joinRounded(shapes_.back().vertices);
    const std::string& part = solid.path.empty() ? rootName_ : solid.path;
    solids_.push_back({part, measuresOf(shapes_.back())});
    addNotes(healingNotes(shapes_.back(), assembly.faceEntities, part));
    // If faces are lost, the lines about the losses say why the part is open.
    if (solid.losses == 0 && held == nullptr) addNotes(shapeNotes(solid.shape, shapes_.back(), part));
    shapes_.back().record.facesWithoutMesh += solid.losses;
    total_.vertices += shapes_.back().record.vertices;
    total_.triangles += shapes_.back().record.triangles;
    faces_ += shapes_.back().record.faces;
    if (total_.vertices > protocol::kMostElements || total_.triangles > protocol::kMostElements) {
      throw ImportRefusal{{GLISSADE_TEXT("it needs more than %1 triangles"), {protocol::kMostElements}}};
    }
    if (faces_ > protocol::kMostFaces) {
      throw ImportRefusal{{GLISSADE_TEXT("it has more than %1 faces"), {protocol::kMostFaces}}};
    }
  }

  /// Each loss is a line; only a few healed faces are lines.
  void addNotes(const StepNotes& notes) {
    for (const StepNote& note : notes) {
      if (note.kind == protocol::kHealedLine && ++healings_ > kMostHealings) continue;
      notes_ += lineOf(note);
    }
  }

  static constexpr std::size_t kMostHealings = 20;

  StepFineness fineness_;
  std::string rootName_;
  double unit_;
  bool isSewn_;
  protocol::Header total_;
  std::uint32_t faces_ = 0;
  std::vector<StepTriangles> shapes_;
  std::vector<ValidatedSolid> solids_;  ///< one entry for each shape
  TopTools_DataMapOfShapeInteger numberOf_;
  /// number of the shape, scale, mirrored
  using Key = std::tuple<int, double, bool>;
  std::map<Key, std::uint32_t> indexOf_;
  std::vector<protocol::Part> parts_;
  std::vector<std::string> paths_;
  std::vector<std::string> names_;  ///< result of namesText() for each part
  std::vector<std::string> formerPaths_;
  std::vector<StepExternalPart> externalParts_;
  std::string notes_;
  std::size_t healings_ = 0;
};

int failToRead(CadKind kind, const ImportOutput& output, const Message& reason) {
  if (kind == CadKind::Step) return output.fail({GLISSADE_TEXT("cannot be read: %1"), {reason}});
  return output.fail({GLISSADE_TEXT("cannot be read as %1: %2"), {nameOf(kind), reason}});
}

StepNote noteOf(const ForeignNames& names) {
  const std::string example = printableLine(names.example);
  if (names.isSure) {
    return {protocol::kForeignNamesLine,
            GLISSADE_TEXT("names"),
            {GLISSADE_TEXT("are read as %1: '%2'"), {names.encoding, example}}};
  }
  return {
      protocol::kDoubtfulNamesLine,
      GLISSADE_TEXT("names"),
      {GLISSADE_TEXT("are in an encoding that cannot be told, and are read as %1: '%2'"), {names.encoding, example}}};
}

/// OpenCASCADE crashes on an oriented shell that names no shell.
void refuseNamelessShells(const StepEntities& entities) {
  for (const StepEntities::Entity& entity : entities.all()) {
    const std::string_view type = entities.typeOf(entity);
    if (type != "ORIENTED_CLOSED_SHELL" && type != "ORIENTED_OPEN_SHELL") continue;
    const std::vector<StepRecord> records = entities.recordsOf(entity);
    const auto values = stepValues(records.front().arguments);
    if (values.size() == 4 && stepReference(values[2]) != 0) continue;
    throw ImportRefusal{
        {GLISSADE_TEXT("%1: %2"), {stepName(entity.id), Message(GLISSADE_TEXT("it is oriented and names no shell"))}}};
  }
}

StepAssembly readStepParts(std::vector<char>& content, bool solidNames, const ForeignText& foreign) {
  const auto names = foreign.makeUtf8(content);
  const std::string_view text(content.data(), content.size());
  if (const auto fault = faultOfStepText(text)) throw ImportRefusal{*fault};
  const StepEntities entities(text);
  refuseNamelessShells(entities);
  const StatedShapes stated = statedShapesOf(entities);
  StepStandIns standIns = standInsFor(entities, stated);
  std::string edited = std::move(standIns.text);
  MemoryBuffer buffer(edited.empty() ? content.data() : edited.data(), edited.empty() ? content.size() : edited.size());
  std::istream stream(&buffer);
  StepAssembly assembly = readStepAssembly(stream, solidNames, {entities, stated, std::move(standIns)});
  if (names) assembly.notes.push_back(noteOf(*names));
  return assembly;
}

StepAssembly readBrepText(std::vector<char>& content) {
  MemoryBuffer buffer(content.data(), content.size());
  std::istream stream(&buffer);
  return readBrepParts(stream);
}

void writeVolumes(const std::vector<std::pair<std::string, std::string>>& pairs, const StepAssembly& assembly,
                  const ImportOutput& output) {
  protocol::Header header;
  header.kind = protocol::kVolumes;
  header.vertices = static_cast<std::uint32_t>(pairs.size());
  std::vector<double> volumes;
  for (const auto& [a, b] : pairs) volumes.push_back(commonVolume(assembly, a, b));
  output.write(&header, sizeof header);
  output.write(volumes);
}

int import(const StepImportOrder& order, const ForeignText& foreign, const ImportOutput& output) {
  std::vector<char> content = readStandardInput(protocol::kStepLimits.bytes);
  if (content.empty()) return failToRead(order.kind, output, GLISSADE_TEXT("it is empty or too large"));
  const StepAssembly assembly = order.kind == CadKind::Iges   ? readIgesParts(content)
                                : order.kind == CadKind::Brep ? readBrepText(content)
                                                              : readStepParts(content, order.solidNames, foreign);
  if (order.volumesOf.empty()) {
    AssemblyMessage(order.deflection, assembly).write(output);
  } else {
    writeVolumes(order.volumesOf, assembly, output);
  }
  return 0;
}

}  // namespace

int confinedStepImport(const StepImportOrder& order) {
  const ImportOutput output;
  const ForeignText foreign;
  if (const Outcome confined = confine(protocol::kStepLimits); !confined) return output.refuse(confined.error());
  ::Message::DefaultMessenger()->ChangePrinters().Clear();
  try {
    return import(order, foreign, output);
  } catch (const Standard_Failure& failure) {
    return failToRead(order.kind, output,
                      {GLISSADE_TEXT("its shapes cannot be computed (%1)"), {failure.DynamicType()->Name()}});
  } catch (const std::bad_alloc&) {
    return failToRead(order.kind, output, GLISSADE_TEXT("it needs more memory than an import may take"));
  } catch (const ImportRefusal& refusal) {
    return failToRead(order.kind, output, refusal.reason);
  } catch (const std::exception& error) {
    return failToRead(order.kind, output, Message(error.what()));
  }
}

}  // namespace glissade
