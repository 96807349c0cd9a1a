// Compares the volumes of the triangles of an import with the volumes that OpenCASCADE computes exactly from the same
// file. usage: step_volumes FILE... Exit code 0: for every solid of every file, the difference is at most deflection
// times area.
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "engine/geometry/mesh_audit.h"
#include "engine/import/step_import.h"

namespace {

using glissade::Occurrence;
using glissade::TriangleMesh;
using glissade::Vector3;

constexpr double kMillimetre = 1e-3;
/// Relative error requested from OpenCASCADE.
constexpr double kAccuracy = 1e-5;

struct Solid {
  double volume = 0.0;                 ///< cubic metres
  Vector3 centroid = Vector3::Zero();  ///< metres, in the file's frame
};

std::vector<Solid> exactSolids(const std::string& file) {
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::string("OpenCASCADE cannot read it");
  reader.TransferRoots();
  std::vector<GProp_GProps> known;
  TopTools_DataMapOfShapeInteger numbers;
  std::vector<Solid> solids;
  for (TopExp_Explorer at(reader.OneShape(), TopAbs_SOLID); at.More(); at.Next()) {
    const TopoDS_Shape shape = at.Current().Located(TopLoc_Location());
    if (!numbers.IsBound(shape)) {
      numbers.Bind(shape, static_cast<int>(known.size()));
      known.emplace_back();
      BRepGProp::VolumeProperties(shape, known.back(), kAccuracy);
    }
    const GProp_GProps& exact = known[static_cast<std::size_t>(numbers.Find(shape))];
    const gp_Pnt p = exact.CentreOfMass().Transformed(at.Current().Location().Transformation());
    solids.push_back({std::pow(kMillimetre, 3) * std::abs(exact.Mass()), kMillimetre * Vector3(p.X(), p.Y(), p.Z())});
  }
  return solids;
}

struct Part {
  std::string name;
  double volume = 0.0;
  double area = 0.0;
  double deflection = 0.0;
  Vector3 centroid = Vector3::Zero();
  bool taken = false;

  double uncertainty() const { return deflection * area + 2.0 * kAccuracy * volume; }
};

Part measured(const Occurrence& occurrence) {
  const TriangleMesh& mesh = *occurrence.mesh;
  const Vector3 origin = mesh.vertices.front();
  Part part{occurrence.path};
  Vector3 moment = Vector3::Zero();
  for (const auto& [i, k, l] : mesh.triangles) {
    const Vector3 a = mesh.vertices[i] - origin;
    const Vector3 b = mesh.vertices[k] - origin;
    const Vector3 c = mesh.vertices[l] - origin;
    const double volume = a.dot(b.cross(c)) / 6.0;
    part.volume += volume;
    part.area += 0.5 * (b - a).cross(c - a).norm();
    moment += 0.25 * volume * (a + b + c);
  }
  part.centroid = occurrence.X_FP * Vector3(origin + moment / part.volume);
  part.volume = std::abs(part.volume);
  part.deflection = occurrence.deflection;
  return part;
}

/// The part at the place of the solid whose volume is nearest.
Part* partAt(const Solid& solid, std::vector<Part>& parts) {
  Part* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (Part& part : parts) {
    const double size = std::cbrt(solid.volume);
    const double apart = (part.centroid - solid.centroid).norm() / size;
    const double differs = std::abs(part.volume - solid.volume) / solid.volume;
    if (part.taken || apart + differs >= least) continue;
    least = apart + differs;
    best = &part;
  }
  return best;
}

/// Compares every solid of the file; returns whether all differences are within their limits.
bool compare(const std::string& file) {
  const auto product = glissade::importStep(file, 0.0);
  if (!product) throw glissade::toString(product.error());
  std::vector<Part> parts;
  std::size_t open = 0;
  for (const Occurrence& occurrence : product->parts) {
    if (glissade::isClosedSurface(*occurrence.mesh)) {
      parts.push_back(measured(occurrence));
    } else {
      ++open;
    }
  }
  const std::vector<Solid> solids = exactSolids(file);
  std::size_t wrong = 0;
  double worst = 0.0;
  for (const Solid& solid : solids) {
    Part* part = partAt(solid, parts);
    if (part != nullptr) part->taken = true;
    const double differs = part == nullptr ? 1.0 : std::abs(part->volume - solid.volume);
    const double share = part == nullptr ? 1e9 : differs / part->uncertainty();
    worst = std::max(worst, share);
    if (share <= 1.0) continue;
    ++wrong;
    std::cout << file << ": '" << (part == nullptr ? "" : part->name) << "' has " << (part ? part->volume : 0.0) * 1e9
              << " mm3, exactly " << solid.volume * 1e9 << " mm3, deflection times area "
              << (part ? part->uncertainty() : 0.0) * 1e9 << " mm3\n";
  }
  std::cout << file << ": " << solids.size() << " solids, " << parts.size() << " closed parts, " << open
            << " open parts, " << wrong << " wrong, largest share of deflection times area " << worst << "\n";
  return wrong == 0;
}

}  // namespace

int main(int argc, char** argv) {
  bool right = argc > 1;
  for (int i = 1; i < argc; ++i) {
    try {
      right = compare(argv[i]) && right;
    } catch (const Standard_Failure& failure) {
      std::cout << argv[i] << ": OpenCASCADE fails (" << failure.DynamicType()->Name() << ")\n";
      right = false;
    } catch (const std::string& why) {
      std::cout << argv[i] << ": " << why << "\n";
      right = false;
    }
  }
  return right ? 0 : 1;
}
