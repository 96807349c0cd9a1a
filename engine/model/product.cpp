#include "engine/model/product.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <system_error>

#include "engine/model/body_path.h"
#include "engine/model/unique_names.h"

namespace glissade {

/// Makes the nodes of a product.
class ProductMaker {
 public:
  ProductMaker(const std::vector<ProductBody>& bodies, const std::vector<NodeDescription>& said, Product& product)
      : bodies_(bodies), product_(product) {
    for (const NodeDescription& node : said) said_.emplace(node.id, &node);
    for (const ProductBody& body : bodies) {
      taken_.insert(body.id.text());
      for (const TreePlace& part : body.parts) taken_.insert(joinedPath(body.id.text(), part.path));
    }
  }

  void make() {
    for (const ProductBody& body : bodies_) add(body);
  }

 private:
  using Node = Product::Node;
  using Parent = std::optional<std::size_t>;
  using Steps = std::vector<std::string>;

  const NodeDescription* saidOf(const std::string& id) const {
    const auto found = said_.find(id);
    return found == said_.end() ? nullptr : found->second;
  }

  void add(const ProductBody& body) {
    const NodeDescription* said = saidOf(body.id.text());
    const Parent parent = said != nullptr && said->in ? assemblyWithId(*said->in) : assemblyAbove({}, body.place);
    const std::size_t node = append({body.id.text(), body.place.path, namesAt(body.place), parent}, said);
    product_.nodes_[node].unit = body.parts.empty() ? body.place.unit : body.parts.front().unit;
    for (const TreePlace& part : body.parts) {
      if (part.path.empty()) continue;
      const std::size_t below = append({joinedPath(body.id.text(), part.path), joinedPath(body.place.path, part.path),
                                        namesAt(part), assemblyAbove(node, part)},
                                       nullptr);
      product_.nodes_[below].unit = part.unit;
    }
  }

  std::size_t append(Node node, const NodeDescription* said) {
    if (said != nullptr && said->name) node.names.product = *said->name;
    if (said != nullptr && !said->occurrence.empty()) node.names.occurrence = said->occurrence;
    if (said != nullptr && !said->designator.empty()) node.names.designator = said->designator;
    if (said != nullptr && node.isAssembly) node.attributes = said->attributes;
    const std::size_t index = product_.nodes_.size();
    if (node.parent) product_.nodes_[*node.parent].children.push_back(index);
    product_.byId_.emplace(node.id, index);
    product_.nodes_.push_back(std::move(node));
    return index;
  }

  static NodeNames namesAt(const TreePlace& place) {
    return place.names.empty() ? NodeNames{lastStepOf(place.path)} : place.names.back();
  }

  /// The assembly below `top` that contains the last step of the place.
  Parent assemblyAbove(Parent top, const TreePlace& place) {
    const Steps steps = stepsOf(place.path);
    Parent parent = top;
    for (std::size_t level = 0; level + 1 < steps.size(); ++level) {
      const bool named = place.names.size() == steps.size();
      parent = assemblyAt(parent, steps[level], named ? place.names[level] : NodeNames{steps[level]});
    }
    return parent;
  }

  std::string idBelow(Parent parent, const std::string& step) const {
    const std::string id = parent ? joinedPath(product_.nodes_[*parent].id, step) : step;
    std::string free = id;
    for (int number = 2; taken_.count(free) > 0; ++number) free = id + "#" + std::to_string(number);
    return free;
  }

  std::size_t assemblyAt(Parent parent, const std::string& step, const NodeNames& names) {
    const auto known = assemblies_.find({parent, step});
    if (known != assemblies_.end()) return known->second;
    const std::string id = idBelow(parent, step);
    const auto same = product_.byId_.find(id);
    const std::size_t node = same != product_.byId_.end() ? same->second : addAssembly(id, parent, step, names);
    assemblies_.emplace(std::pair(parent, step), node);
    return node;
  }

  std::size_t addAssembly(const std::string& id, Parent parent, const std::string& step, const NodeNames& names) {
    const NodeDescription* said = saidOf(id);
    if (said != nullptr && said->in && making_.insert(id).second) parent = assemblyWithId(*said->in);
    if (const auto made = product_.byId_.find(id); made != product_.byId_.end()) return made->second;
    Node node{id, parent ? joinedPath(product_.nodes_[*parent].path, step) : step, names, parent};
    node.isAssembly = true;
    return append(std::move(node), said);
  }

  /// The assembly that a description names.
  Parent assemblyWithId(const std::string& id) {
    if (id.empty()) return std::nullopt;
    const auto known = product_.byId_.find(id);
    if (known != product_.byId_.end()) return known->second;
    const NodeDescription* said = saidOf(id);
    if (said != nullptr && said->in) return addAssembly(id, std::nullopt, lastStepOf(id), {lastStepOf(id)});
    const TreePlace below{joinedPath(id, "body")};
    return assemblyAbove({}, below);
  }

  const std::vector<ProductBody>& bodies_;
  Product& product_;
  std::map<std::string, const NodeDescription*> said_;
  std::set<std::string> taken_;                                       ///< ids of bodies
  std::map<std::pair<Parent, std::string>, std::size_t> assemblies_;  ///< by the assembly above and the step
  std::set<std::string> making_;  ///< assemblies whose place has been searched, to search each once
};

Product::Product(const std::vector<ProductBody>& bodies, const std::vector<NodeDescription>& said) {
  ProductMaker(bodies, said, *this).make();
}

std::optional<std::size_t> Product::find(const std::string& id) const {
  const auto found = byId_.find(id);
  return found == byId_.end() ? std::nullopt : std::optional(found->second);
}

double Product::lengthUnit() const {
  std::vector<std::pair<double, std::size_t>> counts;
  for (const Node& node : nodes_) {
    if (node.unit == 0.0) continue;
    const auto known = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == node.unit; });
    if (known == counts.end()) {
      counts.emplace_back(node.unit, 1);
    } else {
      ++known->second;
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? 0.0 : most->first;
}

std::vector<BodyId> Product::bodiesBelow(std::size_t node) const {
  std::vector<std::size_t> bodies;
  std::vector<std::size_t> open{node};
  while (!open.empty()) {
    const std::size_t next = open.back();
    open.pop_back();
    const std::vector<std::size_t>& children = nodes_[next].children;
    if (children.empty() && !nodes_[next].isAssembly) bodies.push_back(next);
    open.insert(open.end(), children.begin(), children.end());
  }
  std::sort(bodies.begin(), bodies.end());
  std::vector<BodyId> ids;
  for (const std::size_t body : bodies) ids.emplace_back(nodes_[body].id);
  return ids;
}

std::vector<std::size_t> Product::assembliesAbove(std::size_t node) const {
  std::vector<std::size_t> above;
  for (auto parent = nodes_[node].parent; parent; parent = nodes_[*parent].parent) {
    if (nodes_[*parent].isAssembly) above.push_back(*parent);
  }
  std::reverse(above.begin(), above.end());
  return above;
}

namespace {

/// Nodes that have a text, and whose texts on the path from the root end in the name. Texts may contain a "/".
std::vector<std::size_t> endingIn(const std::string& name, const std::vector<Product::Node>& nodes,
                                  const std::vector<std::string>& texts) {
  std::vector<std::size_t> found;
  std::vector<std::string> ways;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ways.push_back(nodes[i].parent ? joinedPath(ways[*nodes[i].parent], texts[i]) : texts[i]);
    if (!texts[i].empty() && endsInPath(ways.back(), name)) found.push_back(i);
  }
  return found;
}

/// The body with the number in "#2", counted from 1.
std::vector<std::size_t> numbered(const std::string& name, const std::vector<Product::Node>& nodes) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  if (name.front() != '#' || error != std::errc() || end != name.data() + name.size()) return {};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].isAssembly && nodes[i].children.empty() && --number == 0) return {i};
  }
  return {};
}

}  // namespace

std::vector<std::size_t> Product::named(const std::string& name) const {
  if (name.empty()) return {};
  if (const auto known = find(name)) return {*known};
  std::vector<std::size_t> found = endingIn(name, nodes_, shownNames());
  if (!found.empty()) return found;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].path == name) return {i};
    if (endsInPath(nodes_[i].path, name)) found.push_back(i);
  }
  for (const auto kind : {&NodeNames::product, &NodeNames::occurrence, &NodeNames::designator}) {
    if (!found.empty()) break;
    std::vector<std::string> texts;
    for (const Node& node : nodes_) texts.push_back(node.names.*kind);
    found = endingIn(name, nodes_, texts);
  }
  return found.empty() ? numbered(name, nodes_) : found;
}

std::vector<std::string> Product::shownNames() const {
  std::map<std::optional<std::size_t>, UniqueNames> siblings;
  std::vector<std::string> shown;
  for (const Node& node : nodes_) {
    const std::string& name = shownName(node.names);
    shown.push_back(siblings[node.parent].take(name.empty() ? lastStepOf(node.path) : name));
  }
  return shown;
}

std::vector<std::string> Product::shownPaths() const {
  std::vector<std::string> paths = shownNames();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent) paths[i] = joinedPath(paths[*nodes_[i].parent], paths[i]);
  }
  return paths;
}

std::vector<std::string> Product::labels(const std::vector<std::string>& ids) const {
  const std::vector<std::string> shown = shownNames();
  std::vector<std::vector<std::string>> endsOf;  // ends of each node's path, the shortest first
  std::map<std::string, int> count;
  for (const std::string& id : ids) {
    std::vector<std::string>& ends = endsOf.emplace_back();
    for (auto node = find(id); node; node = nodes_[*node].parent) {
      ends.push_back(joinedPath(shown[*node], ends.empty() ? "" : ends.back()));
    }
    for (const std::string& end : ends) ++count[end];
  }
  std::vector<std::string> labels = ids;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto own = std::find_if(endsOf[i].begin(), endsOf[i].end(), [&](const auto& end) { return count[end] == 1; });
    if (!endsOf[i].empty()) labels[i] = own == endsOf[i].end() ? endsOf[i].back() : *own;
  }
  return labels;
}

std::vector<BodyId> bodiesMeant(const Product& product, const std::string& name) {
  std::set<BodyId> ids;
  for (const std::size_t node : product.named(name)) {
    for (BodyId& id : product.bodiesBelow(node)) ids.insert(std::move(id));
  }
  return {ids.begin(), ids.end()};
}

}  // namespace glissade
