#include "engine/scenario/product_file.h"

#include <algorithm>
#include <functional>

#include "engine/scenario/part_files.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

Result<ProductFile> productOfParts(const std::string& file, const StopToken& stop, double deflection) {
  GeometryCache read;
  PartFile part = usualPart(file);
  part.deflection = deflection;
  const auto geometry = readPart(part, read, stop);
  if (!geometry) return geometry.error();
  ProductFile loaded;
  for (const GeometryPart& solid : (*geometry)->parts) {
    const std::string name = solid.name.empty() ? file : solid.name;
    loaded.product.bodies.push_back({name, name, Mobility::Mobile, solid.mesh, solid.X_BP});
    if (solid.colour) loaded.product.bodies.back().colour = *solid.colour;
    loaded.product.deflections.push_back(solid.deflection);
  }
  loaded.product.fits.on = true;
  return loaded;
}

Result<ProductFile> productOfScenario(const std::string& file, const StopToken& stop) {
  auto scenario = loadScenario(file, stop);
  if (!scenario) return scenario.error();
  ProductFile loaded;
  loaded.product.bodies = std::move(scenario->obstacles);
  loaded.product.bodies.push_back(std::move(scenario->object));
  for (const RigidBody& body : loaded.product.bodies) {
    const auto known = scenario->deflections.find(body.id);
    loaded.product.deflections.push_back(known == scenario->deflections.end() ? 0.0 : known->second);
  }
  loaded.product.fits = scenario->scenario.fits;
  loaded.demands = scenario->scenario.sequence;
  loaded.warnings = std::move(scenario->warnings);
  return loaded;
}

/// The two largest, together.
double largestTwo(std::vector<double> values) {
  values.resize(std::max<std::size_t>(values.size(), 2), 0.0);
  std::partial_sort(values.begin(), values.begin() + 2, values.end(), std::greater<>());
  return values[0] + values[1];
}

}  // namespace

Result<ProductFile> readProduct(const std::string& file, const StopToken& stop, double deflection) {
  auto loaded =
      isPartFile(usualPart(file).path) ? productOfParts(file, stop, deflection) : productOfScenario(file, stop);
  if (loaded) loaded->deviation = largestTwo(loaded->product.deflections);
  return loaded;
}

Result<ProductFile> loadProduct(const std::string& file, const StopToken& stop, double deflection) {
  auto loaded = readProduct(file, stop, deflection);
  if (!loaded) return loaded;
  if (loaded->product.bodies.size() < 2) {
    return Diagnostic{ErrorKind::MalformedInput, file, "", "holds one body: there is nothing to take apart",
                      "Give a product of several parts."};
  }
  loaded->product.bodies = aboutTheirMiddles(std::move(loaded->product.bodies));
  return loaded;
}

}  // namespace glissade
