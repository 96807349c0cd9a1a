#include "engine/api/values.h"
#include "engine/files/path_reader.h"
#include "engine/files/plan_file.h"
#include "engine/files/scenario_io.h"
#include "engine/import/mesh_import.h"

namespace glissade::api {
namespace {

constexpr const char* kReading = "reading a file";

FitOptions fitOptionsOf(const LoadOptions& options) { return {options.fits, options.acceptedClash}; }

/// The fault of the options; nothing where they are sound.
std::optional<Diagnostic> faultOf(const LoadOptions& options) {
  // The negations refuse NaN, too.
  if (!(options.deflection >= 0.0)) return wrongArgument("deflection", "is below 0");
  if (options.acceptedClash && !(*options.acceptedClash >= 0.0)) return wrongArgument("acceptedClash", "is below 0");
  return std::nullopt;
}

}  // namespace

template <>
Result<Scenario> load(const std::string& file, const LoadOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Scenario>(kReading, [&]() -> Result<Scenario> {
    auto loaded = loadScenario(file, options.stop, fitOptionsOf(options));
    if (!loaded) return publicDiagnostic(loaded.error());
    return valueOf<Scenario>({std::make_shared<const LoadedScenario>(std::move(*loaded))});
  });
}

template <>
Result<Product> load(const std::string& file, const LoadOptions& options) {
  if (const auto fault = faultOf(options)) return *fault;
  return attempt<Product>(kReading, [&]() -> Result<Product> {
    auto loaded = loadProduct(file, options.stop, options.deflection, {options.open, {}});
    if (!loaded) return publicDiagnostic(loaded.error());
    if (const auto left = leaveOut(options.without, *loaded); !left) return publicDiagnostic(left.error());
    if (loaded->product.bodies.size() < 2) return wrongArgument("without", "leaves less than two bodies");
    fitOptionsOf(options).applyTo(loaded->product.fits);
    return valueOf<Product>({std::move(*loaded), file, options.deflection});
  });
}

template <>
Result<Mesh> load(const std::string& file, const LoadOptions& options) {
  return attempt<Mesh>(kReading, [&]() -> Result<Mesh> {
    auto imported = importMesh(file, options.stop);
    if (!imported) return publicDiagnostic(imported.error());
    if (imported->mesh.triangles.empty()) {
      return Diagnostic{ErrorKind::MalformedInput, file, "", "holds no triangle", ""};
    }
    return valueOf<Mesh>({std::make_shared<const TriangleMesh>(std::move(imported->mesh))});
  });
}

template <>
Result<Path> load(const std::string& file, const LoadOptions& /*options*/) {
  return attempt<Path>(kReading, [&]() -> Result<Path> {
    auto points = readPath(file);
    if (!points) return publicDiagnostic(points.error());
    return publicPath({std::move(*points), {}}, {}, nullptr);
  });
}

template <>
Result<AssemblyPlan> load(const std::string& file, const LoadOptions& /*options*/) {
  return attempt<AssemblyPlan>(kReading, [&]() -> Result<AssemblyPlan> {
    auto plan = readPlan(file);
    if (!plan) return publicDiagnostic(plan.error());
    return valueOf<AssemblyPlan>({std::move(*plan)});
  });
}

}  // namespace glissade::api
