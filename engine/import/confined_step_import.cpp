#include "engine/import/confined_step_import.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <exception>
#include <gp_Quaternion.hxx>
#include <istream>
#include <stdexcept>
#include <streambuf>

#include "engine/import/confinement.h"
#include "engine/import/step_assembly.h"
#include "engine/import/step_tessellation.h"
#include "engine/import/step_text_check.h"

namespace glissade {
namespace {

namespace protocol = import_protocol;

/// Reads what is in memory without another copy of it.
class MemoryBuffer final : public std::streambuf {
 public:
  explicit MemoryBuffer(std::vector<char>& content) {
    setg(content.data(), content.data(), content.data() + content.size());
  }
};

/// The triangles of each shape once, however many parts have it.
class Message {
 public:
  Message(double deflection, const std::vector<std::string>& losses) : deflection_(deflection) {
    for (const std::string& loss : losses) losses_ += loss + "\n";
  }

  void add(const StepSolid& solid) {
    if (!indexOf_.IsBound(solid.shape)) addShape(solid);
    protocol::Part part;
    part.shape = static_cast<std::uint32_t>(indexOf_.Find(solid.shape));
    const gp_XYZ position = solid.placement.TranslationPart();
    const gp_Quaternion turn = solid.placement.GetRotation();
    for (int i = 0; i < 3; ++i) part.position[i] = position.Coord(i + 1);
    part.orientation[0] = turn.X();
    part.orientation[1] = turn.Y();
    part.orientation[2] = turn.Z();
    part.orientation[3] = turn.W();
    part.hasColour = solid.colour ? 1 : 0;
    if (solid.colour) std::copy(solid.colour->begin(), solid.colour->end(), part.colour);
    part.pathBytes = static_cast<std::uint32_t>(solid.path.size());
    parts_.push_back(part);
    paths_.push_back(solid.path);
  }

  void write(const ImportOutput& output) const {
    output.write(&total_, sizeof total_);
    const protocol::AssemblyCounts counts{static_cast<std::uint32_t>(shapes_.size()),
                                          static_cast<std::uint32_t>(parts_.size()),
                                          static_cast<std::uint32_t>(losses_.size()), 0};
    output.write(&counts, sizeof counts);
    for (const StepTriangles& shape : shapes_) {
      output.write(&shape.record, sizeof shape.record);
      output.write(shape.vertices);
      output.write(shape.indices);
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      output.write(&parts_[i], sizeof parts_[i]);
      output.write(paths_[i].data(), paths_[i].size());
    }
    output.write(losses_.data(), losses_.size());
  }

 private:
  void addShape(const StepSolid& solid) {
    indexOf_.Bind(solid.shape, static_cast<int>(shapes_.size()));
    shapes_.push_back(tessellate(solid.shape, deflection_));
    shapes_.back().record.facesWithoutMesh += solid.losses;
    total_.kind = protocol::kAssembly;
    total_.vertices += shapes_.back().record.vertices;
    total_.triangles += shapes_.back().record.triangles;
    if (total_.vertices > protocol::kMostElements || total_.triangles > protocol::kMostElements) {
      throw std::runtime_error("it needs more than " + std::to_string(protocol::kMostElements) + " triangles");
    }
  }

  double deflection_;
  protocol::Header total_;
  std::vector<StepTriangles> shapes_;
  TopTools_DataMapOfShapeInteger indexOf_;
  std::vector<protocol::Part> parts_;
  std::vector<std::string> paths_;
  std::string losses_;
};

int failToRead(const ImportOutput& output, const std::string& reason) {
  return output.fail("cannot be read: " + reason);
}

int import(double deflection, bool solidNames, const ImportOutput& output) {
  std::vector<char> content = readStandardInput(protocol::kStepLimits.bytes);
  if (content.empty()) return failToRead(output, "it is empty or too large");
  if (const auto fault = faultOfStepText({content.data(), content.size()})) return failToRead(output, *fault);
  MemoryBuffer buffer(content);
  std::istream stream(&buffer);
  const StepAssembly assembly = readStepAssembly(stream, solidNames);
  Message message(deflection, assembly.losses);
  for (const StepSolid& solid : assembly.solids) message.add(solid);
  message.write(output);
  return 0;
}

}  // namespace

int confinedStepImport(double deflection, bool solidNames) {
  const ImportOutput output;
  if (const Outcome confined = confine(protocol::kStepLimits); !confined) return output.refuse(confined.error());
  ::Message::DefaultMessenger()->ChangePrinters().Clear();
  try {
    return import(deflection, solidNames, output);
  } catch (const Standard_Failure& failure) {
    return failToRead(output, std::string("its shapes cannot be computed (") + failure.DynamicType()->Name() + ")");
  } catch (const std::bad_alloc&) {
    return failToRead(output, "it needs more memory than an import may take");
  } catch (const std::exception& error) {
    return failToRead(output, error.what());
  }
}

}  // namespace glissade
