#include "app/cli/commands.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/interrupt.h"
#include "engine/base/csv_table.h"
#include "engine/files/product_file.h"
#include "engine/fits/liaison_graph.h"
#include "engine/sequence/product_finder.h"

namespace glissade::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string jointNames(const Liaison& liaison) {
  std::string names;
  for (const JointKind kind : liaison.joints)
    names += (names.empty() ? "" : " ") + std::string(kJointKindNames.of(kind));
  return names;
}

/// One row for each direction in which a liaison lets go; one row without a direction if it has none.
std::string csvOf(const LiaisonGraph& graph, const AssembledProduct& product) {
  CsvTable table;
  table.header({"a", "b", "contact", "joints", "x", "y", "z"});
  for (const Liaison& liaison : graph.liaisons()) {
    const std::size_t rows = std::max<std::size_t>(1, liaison.lettingGo.size());
    for (std::size_t i = 0; i < rows; ++i) {
      table.row();
      table.text(product.bodies[liaison.a].id.text());
      table.text(product.bodies[liaison.b].id.text());
      table.text(liaison.contact ? kContactKindNames.of(*liaison.contact) : "");
      table.text(jointNames(liaison));
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        table.number(liaison.lettingGo.empty() ? std::nullopt : std::optional(liaison.lettingGo[i][axis]));
      }
    }
  }
  return table.content();
}

Json jsonOf(const LiaisonGraph& graph, const AssembledProduct& product) {
  const auto idsOf = [&](const std::vector<std::size_t>& bodies) {
    Json ids = Json::array();
    for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id);
    return ids;
  };
  Json json{{"format", "glissade-liaisons"}, {"version", 1}, {"liaisons", Json::array()}, {"clusters", Json::array()}};
  for (const Liaison& liaison : graph.liaisons()) {
    Json each{{"a", product.bodies[liaison.a].id}, {"b", product.bodies[liaison.b].id}};
    if (liaison.contact) each["contact"] = kContactKindNames.of(*liaison.contact);
    each["joints"] = Json::array();
    for (const JointKind kind : liaison.joints) each["joints"].push_back(kJointKindNames.of(kind));
    each["lets_go"] = Json::array();
    for (const Vector3& way : liaison.lettingGo) each["lets_go"].push_back(Json::array({way.x(), way.y(), way.z()}));
    json["liaisons"].push_back(std::move(each));
  }
  for (const auto& cluster : graph.clusters()) json["clusters"].push_back(idsOf(cluster));
  return json;
}

}  // namespace

int runLiaisons(const JointsOptions& options) {
  const Interrupt interrupt;
  auto loaded = readProduct(options.file, interrupt.token(), options.deflection, {options.open, {}});
  if (!loaded) return reportError(loaded.error(), options.console);
  if (const Outcome left = leaveOut(options.without, *loaded); !left) return reportError(left.error(), options.console);
  reportWarnings(loaded->warnings, options.console);
  AssembledProduct& product = loaded->product;
  product.fits.on = true;
  const auto joints = jointsOf(*loaded, options.confirmsSuggested, interrupt.token());
  if (!joints) return reportError(joints.error(), options.console);
  ThreadTeam team(usableCores() - 1);
  const auto fits = ProductFits::find(product, team, {interrupt.token()});
  if (!fits) return reportError(fits.error(), options.console);
  const LiaisonGraph graph(product.bodies.size(), fits->contacts(), *joints);
  if (options.console.json) {
    printJson(jsonOf(graph, product));
  } else {
    std::cout << csvOf(graph, product);
  }
  return 0;
}

}  // namespace glissade::cli
