// NumPy arrays of the public values.
#pragma once

#include <glissade/glissade.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <vector>

namespace glissade::python {

namespace py = pybind11;

/// Three numbers of an array or a sequence. Error: ValueError with the name.
Vector3 vectorOf(const py::handle& numbers, const char* name);

/// A pose of a Pose, of 7 numbers (x y z, quaternion x y z w), of 3 numbers (x y z), or of a 4 x 4 matrix. Error:
/// ValueError with the name.
Pose poseOf(const py::handle& value, const std::string& name);
/// The poses of an array of 7 columns or of a sequence.
std::vector<Pose> posesOf(const py::handle& values, const std::string& name);

/// An array of 3 numbers.
py::array_t<double> arrayOf(const Vector3& vector);
/// One row of 3 numbers for each vector.
py::array_t<double> arrayOf(const std::vector<Vector3>& vectors);
/// The 7 numbers x y z, quaternion x y z w.
py::array_t<double> arrayOf(const Pose& pose);
/// One row of 7 numbers for each pose.
py::array_t<double> arrayOf(const std::vector<Pose>& poses);

/// The vertices of a mesh, and its triangles, without a copy and read-only.
py::array verticesOf(const py::object& mesh);
py::array trianglesOf(const py::object& mesh);
/// A mesh of an array of 3 columns of numbers, and one of 3 columns of indices.
Mesh meshOf(const py::handle& vertices, const py::handle& triangles);

}  // namespace glissade::python
