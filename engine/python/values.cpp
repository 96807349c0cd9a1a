#include "engine/python/values.h"

#include <pybind11/stl.h>

#include <cstdio>

#include "engine/python/arrays.h"
#include "engine/python/failure.h"

namespace glissade::python {
namespace {

const char* nameOf(ProofStatus status) {
  switch (status) {
    case ProofStatus::Certified: return "certified";
    case ProofStatus::Violated: return "violated";
    case ProofStatus::Undecided: break;
  }
  return "undecided";
}

const char* nameOf(PlanEnd end) {
  switch (end) {
    case PlanEnd::Complete: return "complete";
    case PlanEnd::Stuck: return "stuck";
    case PlanEnd::TimeLimit: return "time_limit";
    case PlanEnd::Interrupted: break;
  }
  return "interrupted";
}

/// "1.5 mm"
std::string inMillimetres(double metres) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g mm", 1e3 * metres);
  return text;
}

std::string textOf(const Certificate& certificate) {
  std::string text = nameOf(certificate.status);
  if (certificate.status == ProofStatus::Undecided) return text;
  text += ", clearance " + inMillimetres(certificate.minClearance);
  return certificate.nearest.body.empty() ? text : text + " to '" + certificate.nearest.body + "'";
}

std::vector<std::string> textsOf(const Warnings& warnings) {
  std::vector<std::string> texts;
  for (const Diagnostic& warning : warnings) texts.push_back(warning.text());
  return texts;
}

void addGeometry(py::module_& module) {
  py::class_<Pose>(module, "Pose", "A rigid transform: position in metres, unit quaternion x y z w.")
      .def(py::init([](const py::object& position, const py::object& orientation) {
             Pose pose;
             pose.position = vectorOf(position, "position");
             if (orientation.is_none()) return pose;
             const auto numbers = orientation.cast<std::vector<double>>();
             if (numbers.size() != 4) throw py::value_error("orientation has not four numbers (x y z w)");
             pose.orientation = Quaternion(numbers[3], numbers[0], numbers[1], numbers[2]);
             return pose;
           }),
           py::arg("position") = py::make_tuple(0.0, 0.0, 0.0), py::arg("orientation") = py::none())
      .def_property_readonly(
          "position", [](const Pose& pose) { return arrayOf(pose.position); }, "x y z, metres")
      .def_property_readonly(
          "orientation", [](const Pose& pose) { return py::array_t<double>(4, pose.orientation.coeffs().data()); },
          "unit quaternion x y z w")
      .def("__array__", [](const Pose& pose, const py::args&, const py::kwargs&) { return arrayOf(pose); })
      .def("__repr__",
           [](const Pose& pose) { return "<glissade.Pose " + py::str(arrayOf(pose)).cast<std::string>() + ">"; });

  py::class_<Mesh>(module, "Mesh", "A triangle mesh in metres. Immutable.")
      .def(py::init(&meshOf), py::arg("vertices"), py::arg("triangles"),
           "Vertices of shape (n, 3), metres, and triangles of shape (m, 3), counter-clockwise seen from outside.")
      .def_static(
          "box", [](const py::object& edges) { return valueOf(Mesh::box(vectorOf(edges, "edges"))); }, py::arg("edges"),
          "A box about the origin.")
      .def_property_readonly("vertices", &verticesOf, "Read-only array of shape (n, 3), without a copy.")
      .def_property_readonly("triangles", &trianglesOf, "Read-only array of shape (m, 3), without a copy.")
      .def_property_readonly("closed", &Mesh::isClosed, "True if the surface is closed.")
      .def("__repr__", [](const Mesh& mesh) {
        return "<glissade.Mesh of " + std::to_string(mesh.triangleCount()) + " triangles" +
               (mesh.isClosed() ? ", closed>" : ", open>");
      });

  py::class_<Body>(module, "Body", "A mesh placed in the world.")
      .def(py::init([](std::string id, const Mesh& mesh, const py::object& pose, std::string name) {
             return Body{std::move(id), std::move(name), mesh, pose.is_none() ? Pose() : poseOf(pose, "pose")};
           }),
           py::arg("id"), py::arg("mesh"), py::arg("pose") = py::none(), py::arg("name") = "")
      .def_readonly("id", &Body::id)
      .def_readonly("name", &Body::name)
      .def_readonly("mesh", &Body::mesh)
      .def_readonly("pose", &Body::X_WB, "Pose of the body in the world.")
      .def("__repr__", [](const Body& body) { return "<glissade.Body '" + body.id + "'>"; });
}

void addWorld(py::module_& module) {
  py::class_<Nearest>(module, "Nearest", "Nearest points of the object and an obstacle.")
      .def_readonly("distance", &Nearest::distance, "metres; 0 in contact")
      .def_readonly("body", &Nearest::body, "id of the obstacle; empty: none")
      .def_property_readonly("on_body", [](const Nearest& nearest) { return arrayOf(nearest.p_WO); })
      .def_property_readonly("on_object", [](const Nearest& nearest) { return arrayOf(nearest.p_WN); })
      .def("__repr__", [](const Nearest& nearest) {
        return "<glissade.Nearest " + inMillimetres(nearest.distance) + " to '" + nearest.body + "'>";
      });

  py::class_<Certificate>(module, "Certificate", "A proof about a whole motion.")
      .def_property_readonly(
          "status", [](const Certificate& proof) { return nameOf(proof.status); },
          "'certified', 'violated' or 'undecided'")
      .def_property_readonly("certified", &Certificate::certified)
      .def_readonly("required", &Certificate::required, "metres")
      .def_readonly("proved_clearance", &Certificate::provedClearance, "lower bound, metres")
      .def_readonly("min_clearance", &Certificate::minClearance, "smallest clearance that was met, metres")
      .def_readonly("edge", &Certificate::edge)
      .def_readonly("at", &Certificate::at, "place on the edge, in [0, 1]")
      .def_readonly("nearest", &Certificate::nearest)
      .def("__repr__", [](const Certificate& proof) { return "<glissade.Certificate " + textOf(proof) + ">"; });

  py::class_<Query>(module, "Query", "Questions about a world, for one thread.")
      .def(
          "collides",
          [](Query& query, const py::object& pose) { return valueOf(query.collides(poseOf(pose, "pose"))); },
          py::arg("pose"))
      .def(
          "nearest", [](Query& query, const py::object& pose) { return valueOf(query.nearest(poseOf(pose, "pose"))); },
          py::arg("pose"))
      .def(
          "certify",
          [](Query& query, const py::object& from, const py::object& to, double required) {
            return valueOf(query.certify(poseOf(from, "start"), poseOf(to, "end"), required));
          },
          py::arg("start"), py::arg("end"), py::arg("required"), "Proves or refutes the straight motion.")
      .def(
          "free_share",
          [](Query& query, const py::object& from, const py::object& to, double step) {
            return valueOf(query.freeShare(poseOf(from, "start"), poseOf(to, "end"), step));
          },
          py::arg("start"), py::arg("end"), py::arg("step"), "Sampled share of the straight motion that is free.");

  py::class_<World>(module, "World", "Placed obstacles, and the object that moves among them. Immutable.")
      .def(py::init([](const std::vector<Body>& obstacles, const Mesh& object) {
             return valueOf(World::make(obstacles, object));
           }),
           py::arg("obstacles"), py::arg("object"))
      .def_property_readonly("obstacles", &World::obstacles)
      .def_property_readonly("object", &World::object)
      .def_property_readonly("object_radius", &World::objectRadius, "metres")
      .def("query", &World::query)
      .def("__repr__", [](const World& world) {
        return "<glissade.World of " + std::to_string(world.obstacles().size()) + " obstacles>";
      });
}

void addProblem(py::module_& module) {
  py::class_<Problem>(module, "Problem", "The object has to get from start to goal. Immutable.")
      .def(py::init([](const World& world, const py::object& start, const py::object& goal, const py::object& bounds,
                       const Parameters& parameters) {
             std::optional<Pose> end;
             if (!goal.is_none()) end = poseOf(goal, "goal");
             std::optional<Box> box;
             if (!bounds.is_none()) {
               const auto corners = bounds.cast<std::vector<py::object>>();
               if (corners.size() != 2) throw py::value_error("bounds are not two corners");
               box = Box{vectorOf(corners[0], "bounds[0]"), vectorOf(corners[1], "bounds[1]")};
             }
             return valueOf(Problem::make(world, poseOf(start, "start"), end, box, parameters));
           }),
           py::arg("world"), py::arg("start"), py::arg("goal") = py::none(), py::arg("bounds") = py::none(),
           py::arg("parameters") = Parameters(), "Without a goal, the object has to leave the box of the obstacles.")
      .def_property_readonly("world", &Problem::world)
      .def_property_readonly("start", &Problem::start)
      .def_property_readonly("goal", &Problem::goal, "None: out of the box of the obstacles")
      .def_property_readonly("bounds",
                             [](const Problem& problem) {
                               const Box box = problem.bounds();
                               return py::make_tuple(arrayOf(box.lower), arrayOf(box.upper));
                             })
      .def_property_readonly("parameters", &Problem::parameters)
      .def("__repr__", [](const Problem& problem) {
        return "<glissade.Problem among " + std::to_string(problem.world().obstacles().size()) + " obstacles>";
      });

  py::class_<Path>(module, "Path", "Straight motions between configurations, with their certificate. Immutable.")
      .def(py::init([](const py::object& configurations) {
             return valueOf(Path::make(posesOf(configurations, "configurations")));
           }),
           py::arg("configurations"), "A path that nothing is proved of.")
      .def_property_readonly(
          "configurations", [](const Path& path) { return arrayOf(path.configurations()); },
          "Array of shape (n, 7): x y z, quaternion x y z w.")
      .def_property_readonly("certificate", &Path::certificate)
      .def_property_readonly("length", &Path::length, "metres")
      .def_property_readonly("rotation", &Path::rotation, "radians")
      .def(
          "save",
          [](const Path& path, const std::string& file, const Scenario& scenario) {
            valueOf(path.save(file, scenario));
          },
          py::arg("file"), py::arg("scenario"))
      .def("__len__", [](const Path& path) { return path.configurations().size(); })
      .def("__repr__", [](const Path& path) {
        return "<glissade.Path of " + std::to_string(path.configurations().size()) + " configurations, " +
               textOf(path.certificate()) + ">";
      });

  py::class_<RunCounts>(module, "RunCounts", "The cost of a run.")
      .def_readonly("steps", &RunCounts::steps)
      .def_readonly("nodes", &RunCounts::nodes)
      .def_readonly("random_configurations", &RunCounts::randomConfigurations, "the papers' measure")
      .def_readonly("collision_queries", &RunCounts::collisionQueries)
      .def_readonly("distance_queries", &RunCounts::distanceQueries)
      .def("__repr__", [](const RunCounts& counts) {
        return "<glissade.RunCounts " + std::to_string(counts.steps) + " steps, " + std::to_string(counts.nodes) +
               " nodes, " + std::to_string(counts.randomConfigurations) + " random configurations>";
      });

  py::class_<Run>(module, "Run", "The end of a run that found a path.")
      .def_property_readonly("path", [](const Run& run) { return valueOf(run.path); })
      .def_readonly("counts", &Run::counts)
      .def_readonly("strategy", &Run::strategy)
      .def_readonly("seed", &Run::seed)
      .def_readonly("seconds", &Run::seconds)
      .def("__repr__", [](const Run& run) { return "<glissade.Run of '" + run.strategy + "'>"; });
}

void addProducts(py::module_& module) {
  py::class_<Product>(module, "Product", "The assembled bodies of a product. Immutable.")
      .def(py::init([](const std::vector<Body>& bodies) { return valueOf(Product::make(bodies)); }), py::arg("bodies"))
      .def_property_readonly("bodies", &Product::bodies)
      .def_property_readonly("file", &Product::file)
      .def_property_readonly("warnings", [](const Product& product) { return textsOf(product.warnings()); })
      .def("__repr__", [](const Product& product) {
        return "<glissade.Product of " + std::to_string(product.bodies().size()) + " bodies>";
      });

  py::class_<Scenario>(module, "Scenario", "A loaded scenario. Immutable.")
      .def_property_readonly("name", &Scenario::name)
      .def_property_readonly("file", &Scenario::file)
      .def_property_readonly("strategy", &Scenario::strategy)
      .def_property_readonly("seed", &Scenario::seed)
      .def_property_readonly("warnings", [](const Scenario& scenario) { return textsOf(scenario.warnings()); })
      .def_property_readonly("problem", &Scenario::problem)
      .def_property_readonly("product", [](const Scenario& scenario) { return valueOf(scenario.product()); })
      .def("__repr__", [](const Scenario& scenario) { return "<glissade.Scenario '" + scenario.name() + "'>"; });

  py::class_<Motion>(module, "Motion", "The removal of one body, or of several that move as one.")
      .def_readonly("bodies", &Motion::bodies)
      .def_readonly("method", &Motion::method)
      .def_property_readonly(
          "path", [](const Motion& motion) { return arrayOf(motion.path); }, "Array of shape (n, 7).")
      .def_readonly("certified", &Motion::certified)
      .def_readonly("min_clearance", &Motion::minClearance, "metres")
      .def_readonly("nearest", &Motion::nearest)
      .def("__repr__", [](const Motion& motion) {
        return "<glissade.Motion of '" + motion.bodies.front() + "', " + motion.method +
               (motion.certified ? ", certified>" : ", not certified>");
      });

  py::class_<Step>(module, "Step", "Motions that are carried out one after the other, as of nut, washer and bolt.")
      .def_readonly("bodies", &Step::bodies)
      .def_readonly("motions", &Step::motions, "one or more, in the order of removal")
      .def_readonly("after", &Step::after, "numbers, from 1, of the steps that have to come before")
      .def("__repr__", [](const Step& step) {
        return "<glissade.Step of '" + step.bodies.front() + "', motions: " + std::to_string(step.motions.size()) + ">";
      });

  py::class_<StuckBody>(module, "StuckBody", "A body that no removal was found for.")
      .def_readonly("body", &StuckBody::body)
      .def_readonly("blocked_by", &StuckBody::blockedBy)
      .def_readonly("reason", &StuckBody::reason);

  py::class_<AssemblyPlan>(module, "AssemblyPlan", "An order of removals with certified motions. Immutable.")
      .def_property_readonly("steps", &AssemblyPlan::steps)
      .def_property_readonly(
          "end", [](const AssemblyPlan& plan) { return nameOf(plan.end()); },
          "'complete', 'stuck', 'time_limit' or 'interrupted'")
      .def_property_readonly("parts", &AssemblyPlan::parts)
      .def_property_readonly("removed", &AssemblyPlan::removed)
      .def_property_readonly("staying", &AssemblyPlan::staying)
      .def_property_readonly("stuck", &AssemblyPlan::stuck)
      .def("json", &AssemblyPlan::json, py::arg("product"))
      .def(
          "save",
          [](const AssemblyPlan& plan, const std::string& file, const std::string& product) {
            valueOf(plan.save(file, product));
          },
          py::arg("file"), py::arg("product"))
      .def("__repr__", [](const AssemblyPlan& plan) {
        return "<glissade.AssemblyPlan, " + std::to_string(plan.removed()) + " of " + std::to_string(plan.parts()) +
               " parts removed, " + nameOf(plan.end()) + ">";
      });
}

}  // namespace

void addValues(py::module_& module) {
  addGeometry(module);
  addWorld(module);
  addProducts(module);
  addProblem(module);
}

}  // namespace glissade::python
