#include "widgets/scene3d/scene_view_impl.h"

namespace glissade {

SceneLabel lengthLabel(const Vector3& p_W, double metres, bool strong) {
  SceneLabel label{p_W, {}, strong};
  label.length = metres;
  return label;
}

std::vector<SceneLabel> SceneView::labels() const {
  std::vector<SceneLabel> labels;
  if (impl_->difficulty && layerVisible(SceneLayer::Difficulty)) labels = difficultyLabels(*impl_->difficulty);
  if (impl_->help.places && layerVisible(SceneLayer::Help)) {
    const std::vector<SceneLabel> lacking = helpLabels(impl_->help, impl_->markScale().objectRadius);
    labels.insert(labels.end(), lacking.begin(), lacking.end());
  }
  if (impl_->refusal) labels = refusalLabels(*impl_->refusal);
  for (const KeptPathPicture& path : impl_->keptPaths) {
    if (!path.way.empty()) labels.push_back({path.way[path.way.size() / 2], path.name});
  }
  labels.insert(labels.end(), impl_->measure.labels.begin(), impl_->measure.labels.end());
  const EnvironmentPicture& environment = impl_->environment;
  if (!environment.knowledge) return labels;
  const auto& places = environment.knowledge->environment->map.places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool selected = environment.selectedPlaces.count(static_cast<int>(i)) != 0;
    if (selected || layerVisible(SceneLayer::Places)) {
      labels.push_back(
          {places[i].passage ? places[i].box.center() : places[i].anchor, environment.placeNames[i], selected});
    }
  }
  if (!layerVisible(SceneLayer::Graph) || !impl_->drawnPlan || !impl_->drawnPlan->graph) return labels;
  const TopologicalGraph& graph = *impl_->drawnPlan->graph;
  for (std::size_t i = 2; i < graph.nodes.size(); ++i) {
    if (graph.nodes[i].cost > 0.0) labels.push_back({graph.nodes[i].p_W, {}, false, true, graph.nodes[i].cost});
  }
  const auto p_W = [&](int node) { return graph.nodes[static_cast<std::size_t>(node)].p_W; };
  for (const auto& edge : graph.edges) {
    if (edge.from > edge.to || !std::isfinite(edge.cost)) continue;
    labels.push_back({0.5 * (p_W(edge.from) + p_W(edge.to)), {}, false, false, edge.cost, true});
  }
  return labels;
}

}  // namespace glissade
