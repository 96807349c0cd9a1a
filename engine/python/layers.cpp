#include "engine/python/layers.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/python/arrays.h"
#include "engine/python/failure.h"
#include "engine/python/long_call.h"

namespace glissade::python {
namespace {

/// True and False, numbers and texts, also those of NumPy.
AttributeValue valueOfAttribute(const py::handle& value) {
  if (py::hasattr(value, "item")) return valueOfAttribute(value.attr("item")());
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (PyNumber_Check(value.ptr()) == 0)
    throw py::type_error("the value of an attribute is no truth value, number or text");
  return value.cast<double>();
}

/// Numbers of places may be given by their names, too.
std::size_t numberOfPlace(const Layers& layers, const py::handle& place) {
  if (!py::isinstance<py::str>(place)) return place.cast<std::size_t>();
  const auto name = place.cast<std::string>();
  const std::vector<Place> places = layers.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].name == name) return i;
  }
  throw py::value_error("there is no place '" + name + "'");
}

template <class Task>
Layers layersOf(const Task& task, std::optional<double> cellSize, std::optional<double> memory,
                std::optional<int> topologyLevel, const std::optional<std::string>& identifier) {
  LongCall call;
  const LayerOptions options{cellSize, memory, topologyLevel, identifier, call.stop()};
  return valueOf(call.result([&] {
    if constexpr (std::is_same_v<Task, Scenario>) {
      return Layers::make(task.problem(), options);
    } else {
      return Layers::make(task, options);
    }
  }));
}

template <class Task>
void addInit(py::class_<Layers>& layers) {
  layers.def(py::init(&layersOf<Task>), py::arg("task"), py::kw_only(), py::arg("cell_size") = py::none(),
             py::arg("memory") = py::none(), py::arg("topology_level") = py::none(),
             py::arg("identifier") = py::none());
}

Layers withAttribute(const Layers& layers, const std::string& name, const py::object& compute,
                     const py::object& initial, double minimum, double maximum,
                     const std::vector<std::string>& choices) {
  const AttributeDefinition definition{name, valueOfAttribute(initial), minimum, maximum, choices};
  LongCall call;
  PlaceFunction function;
  if (!compute.is_none()) {
    function = [&](const Place& place) {
      return call.callBack([&] { return valueOfAttribute(compute(place)); }, definition.initial);
    };
  }
  return valueOf(call.result([&] { return layers.withAttribute(definition, function); }));
}

void addCells(py::module_& module) {
  py::class_<OctreeCells>(module, "OctreeCells", "The leaves of the octree, as arrays.")
      .def_property_readonly(
          "centres", [](const OctreeCells& cells) { return arrayOf(cells.centres); }, "Array of shape (n, 3), metres.")
      .def_property_readonly(
          "sizes",
          [](const OctreeCells& cells) {
            return py::array_t<double>(static_cast<py::ssize_t>(cells.sizes.size()), cells.sizes.data());
          },
          "Edges of the cubes, metres.")
      .def_property_readonly(
          "kinds",
          [](const OctreeCells& cells) {
            return py::array_t<std::uint8_t>(static_cast<py::ssize_t>(cells.kinds.size()),
                                             reinterpret_cast<const std::uint8_t*>(cells.kinds.data()));
          },
          "0 free, 1 mobile bodies, 2 static bodies.")
      .def("__len__", [](const OctreeCells& cells) { return cells.sizes.size(); })
      .def("__repr__", [](const OctreeCells& cells) {
        return "<glissade.OctreeCells, " + std::to_string(cells.sizes.size()) + ">";
      });
}

py::tuple cornersOf(const Box& box) { return py::make_tuple(arrayOf(box.lower), arrayOf(box.upper)); }

void addPlaces(py::module_& module) {
  py::class_<Place>(module, "Place", "A region of similar narrowness.")
      .def_readonly("name", &Place::name)
      .def_property_readonly("box", [](const Place& place) { return cornersOf(place.box); })
      .def_property_readonly(
          "boxes",
          [](const Place& place) {
            std::vector<Vector3> corners;
            for (const Box& box : place.boxes) corners.insert(corners.end(), {box.lower, box.upper});
            return arrayOf(corners).reshape(
                std::vector<py::ssize_t>{static_cast<py::ssize_t>(place.boxes.size()), 2, 3});
          },
          "Boxes that cover exactly its cells: array of shape (n, 2, 3), lower and upper corners.")
      .def_property_readonly(
          "anchor", [](const Place& place) { return arrayOf(place.anchor); }, "its widest point")
      .def_readonly("narrowness", &Place::narrowness, "diameter of the largest ball about the anchor, metres")
      .def_readonly("complexity", &Place::complexity)
      .def_readonly("passage", &Place::passage, "True for a doorway.")
      .def_readonly("volume", &Place::volume, "cubic metres")
      .def_readonly("attributes", &Place::attributes, "the values in force, by names")
      .def("__repr__", [](const Place& place) {
        return "<glissade.Place '" + place.name + "', complexity " + std::to_string(place.complexity) +
               (place.passage ? ", passage>" : ">");
      });

  py::class_<Border>(module, "Border", "The overlap of two places.")
      .def_readonly("name", &Border::name)
      .def_readonly("places", &Border::places, "numbers of the two places")
      .def_property_readonly("centre", [](const Border& border) { return arrayOf(border.centre); })
      .def_property_readonly("normal", [](const Border& border) { return arrayOf(border.normal); })
      .def_readonly("opening", &Border::opening, "square metres")
      .def("__repr__", [](const Border& border) { return "<glissade.Border '" + border.name + "'>"; });
}

void addGraph(py::module_& module) {
  py::class_<TopologicalGraph::Node>(module, "GraphNode", "The start, the goal or a border.")
      .def_readonly("name", &TopologicalGraph::Node::name, "'S', 'G' or the name of the border")
      .def_readonly("border", &TopologicalGraph::Node::border, "number of the border; None for 'S' and 'G'")
      .def_property_readonly("position", [](const TopologicalGraph::Node& node) { return arrayOf(node.position); })
      .def_readonly("cost", &TopologicalGraph::Node::cost);
  py::class_<TopologicalGraph::Edge>(module, "GraphEdge", "The crossing of a place between two of its borders.")
      .def_property_readonly("nodes",
                             [](const TopologicalGraph::Edge& edge) { return py::make_tuple(edge.from, edge.to); })
      .def_readonly("place", &TopologicalGraph::Edge::place, "number of the place that is crossed")
      .def_readonly("distance", &TopologicalGraph::Edge::distance, "metres")
      .def_readonly("cost", &TopologicalGraph::Edge::cost);
  py::class_<TopologicalGraph>(module, "TopologicalGraph",
                               "Borders as nodes, crossings of places as edges, with the costs of a strategy.")
      .def_readonly("nodes", &TopologicalGraph::nodes)
      .def_readonly("edges", &TopologicalGraph::edges)
      .def("__repr__", [](const TopologicalGraph& value) {
        return "<glissade.TopologicalGraph of " + std::to_string(value.nodes.size()) + " nodes, " +
               std::to_string(value.edges.size()) + " edges>";
      });
}

void addRules(py::module_& module) {
  py::class_<FineRule>(module, "FineRule", "Chooses the planners that cross a place.")
      .def(py::init([](const std::string& when, const std::string& local, bool geometrical) {
             return FineRule{when, geometrical, local};
           }),
           py::arg("when"), py::arg("local"), py::arg("geometrical") = false)
      .def_readonly("when", &FineRule::when, "condition, such as 'place.complexity > 2'")
      .def_readonly("local", &FineRule::local, "id of the local planner")
      .def_readonly("geometrical", &FineRule::geometrical, "the geometrical planner reduces the place first")
      .def("__repr__", [](const FineRule& rule) {
        return "<glissade.FineRule '" + rule.when + "': " + (rule.geometrical ? "geometrical, " : "") + rule.local +
               ">";
      });

  const Rules usual;
  py::class_<Rules>(module, "Rules", "The rules of a multi-layer strategy: expressions over semantic attributes.")
      .def(py::init([](const std::string& node, const std::string& edge, const std::vector<FineRule>& fine, bool loop,
                       bool fitted) {
             return Rules{node, edge, fine, loop, fitted};
           }),
           py::kw_only(), py::arg("node") = usual.node, py::arg("edge") = usual.edge, py::arg("fine") = usual.fine,
           py::arg("loop") = usual.loop, py::arg("fitted") = usual.fitted)
      .def_readonly("node", &Rules::node, "f of equation (1), over size, a.*, b.* and object.*")
      .def_readonly("edge", &Rules::edge, "g of equation (1), over distance, size, place.* and object.*")
      .def_readonly("fine", &Rules::fine, "the first one that holds decides")
      .def_readonly("loop", &Rules::loop, "after a failed step the next best coarse path is tried")
      .def_readonly("fitted", &Rules::fitted, "passages are crossed in the configuration that fits best")
      .def("__repr__",
           [](const Rules& rules) { return "<glissade.Rules node: " + rules.node + "; edge: " + rules.edge + ">"; });
}

/// "P1 > B1-2 > P2 > G"
std::string wayOf(const CoarsePlan& plan) {
  std::string way;
  for (const CoarseStep& step : plan.steps)
    way += (way.empty() ? "" : " > ") + step.placeName + " > " + step.borderName;
  return way.empty() ? "no way" : way;
}

void addCoarsePlan(py::module_& module) {
  py::class_<CoarseStep>(module, "CoarseStep", "A place to cross and a border to reach.")
      .def_readonly("place", &CoarseStep::place, "number of the place")
      .def_readonly("border", &CoarseStep::border, "number of the border; None: the goal")
      .def_readonly("place_name", &CoarseStep::placeName)
      .def_readonly("border_name", &CoarseStep::borderName, "'G' for the goal")
      .def_readonly("to", &CoarseStep::to, "the milestone; an estimate where it is not decided")
      .def_readonly("decided", &CoarseStep::decided)
      .def_readonly("planner", &CoarseStep::planner, "id of the local planner")
      .def_readonly("geometrical", &CoarseStep::geometrical)
      .def_readonly("reason", &CoarseStep::reason)
      .def("__repr__", [](const CoarseStep& step) {
        return "<glissade.CoarseStep through '" + step.placeName + "' to '" + step.borderName + "' by " + step.planner +
               ">";
      });
  py::class_<CoarsePlan>(module, "CoarsePlan", "The cheapest way through the places.")
      .def_readonly("strategy", &CoarsePlan::strategy)
      .def_readonly("rules", &CoarsePlan::rules)
      .def_readonly("graph", &CoarsePlan::graph)
      .def_readonly("nodes", &CoarsePlan::nodes, "nodes of the graph from 'S' to 'G'; empty: there is no way")
      .def_readonly("cost", &CoarsePlan::cost)
      .def_readonly("steps", &CoarsePlan::steps)
      .def_readonly("closed", &CoarsePlan::closed, "places and borders of infinite cost, where there is no way")
      .def("__repr__", [](const CoarsePlan& plan) { return "<glissade.CoarsePlan " + wayOf(plan) + ">"; });
}

}  // namespace

void addLayers(py::module_& module) {
  addCells(module);
  addPlaces(module);
  addGraph(module);
  addRules(module);
  addCoarsePlan(module);
  py::class_<Layers> layers(module, "Layers",
                            "Octree, places, semantic attributes and rules of a Scenario or a Problem. Immutable.");
  addInit<Scenario>(layers);
  addInit<Problem>(layers);
  layers.def_property_readonly("cells", &Layers::cells)
      .def_property_readonly("places", &Layers::places)
      .def_property_readonly("borders", &Layers::borders)
      .def_property_readonly("object_id", &Layers::objectId)
      .def_property_readonly("problem", &Layers::problem, "The problem with these layers, for plan() and Session.")
      .def(
          "of_body", [](const Layers& value, const std::string& body) { return valueOf(value.ofBody(body)); },
          py::arg("body"), "The values in force of all attributes of a body or of the object.")
      .def(
          "with_place_value",
          [](const Layers& value, const py::object& place, const std::string& name, const py::object& to) {
            return valueOf(value.withPlaceValue(numberOfPlace(value, place), name, valueOfAttribute(to)));
          },
          py::arg("place"), py::arg("name"), py::arg("value"),
          "The layers with an attribute of a place, by its number or name, set.")
      .def(
          "with_body_value",
          [](const Layers& value, const std::string& body, const std::string& name, const py::object& to) {
            const AttributeValue set = valueOfAttribute(to);
            LongCall call;
            return valueOf(call.result([&] { return value.withBodyValue(body, name, set, call.stop()); }));
          },
          py::arg("body"), py::arg("name"), py::arg("value"), "The layers with an attribute of a body set.")
      .def("with_attribute", &withAttribute, py::arg("name"), py::arg("compute") = py::none(), py::kw_only(),
           py::arg("initial") = 0.0, py::arg("minimum") = -1e9, py::arg("maximum") = 1e9,
           py::arg("choices") = std::vector<std::string>(),
           "The layers with an attribute of places. `compute`: a function of a Place that returns its value.")
      .def(
          "with_rules", [](const Layers& value, const Rules& rules) { return valueOf(value.withRules(rules)); },
          py::arg("rules"), "The layers with the rules of the strategy 'own'.")
      .def(
          "rules", [](const Layers& value, const std::string& strategy) { return valueOf(value.rules(strategy)); },
          py::arg("strategy"), "The rules of 'gt', 'gts1', 'gts2', 'gts' or 'own'.")
      .def(
          "coarse_plan",
          [](const Layers& value, const std::string& strategy) { return valueOf(value.coarsePlan(strategy)); },
          py::arg("strategy") = "gts", "The coarse plan that a run of the strategy begins with.")
      .def("__repr__", [](const Layers& value) {
        return "<glissade.Layers of " + std::to_string(value.places().size()) + " places, " +
               std::to_string(value.borders().size()) + " borders>";
      });
}

}  // namespace glissade::python
