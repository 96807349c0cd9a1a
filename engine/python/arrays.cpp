#include "engine/python/arrays.h"

#include "engine/python/failure.h"

namespace glissade::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

constexpr py::ssize_t kPoseNumbers = 7;

/// The array of a value; an error names the argument.
template <class Array>
Array arrayIn(const py::handle& value, const std::string& name) {
  Array array = Array::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw py::value_error(name + " is no array of numbers");
  }
  return array;
}

template <class Array>
Array rowsIn(const py::handle& value, py::ssize_t columns, const std::string& name) {
  Array array = arrayIn<Array>(value, name);
  if (array.ndim() != 2 || array.shape(1) != columns) {
    throw py::value_error(name + " has not the shape (n, " + std::to_string(columns) + ")");
  }
  return array;
}

Pose poseOfNumbers(const double* n) { return {{n[0], n[1], n[2]}, Quaternion(n[6], n[3], n[4], n[5])}; }

Pose poseOfMatrix(const double* n) {
  Eigen::Matrix3d rotation;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) rotation(row, column) = n[4 * row + column];
  }
  constexpr double kTolerance = 1e-6;
  const bool isRotation = rotation.isUnitary(kTolerance) && rotation.determinant() > 0.0;
  if (!isRotation) throw py::value_error("the matrix of a pose is no rotation");
  return {{n[3], n[7], n[11]}, Quaternion(rotation).normalized()};
}

void write(const Pose& pose, double* n) {
  const Quaternion& q = pose.orientation;
  const double numbers[kPoseNumbers] = {
      pose.position.x(), pose.position.y(), pose.position.z(), q.x(), q.y(), q.z(), q.w()};
  std::copy(std::begin(numbers), std::end(numbers), n);
}

/// An array on the memory of a value that `owner` keeps.
template <class T>
py::array readOnly(const T* data, std::size_t rows, const py::object& owner) {
  py::array_t<T> array({static_cast<py::ssize_t>(rows), py::ssize_t{3}}, data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace

Vector3 vectorOf(const py::handle& numbers, const char* name) {
  const auto array = arrayIn<Numbers>(numbers, name);
  if (array.ndim() != 1 || array.shape(0) != 3) throw py::value_error(std::string(name) + " has not three numbers");
  return {array.at(0), array.at(1), array.at(2)};
}

Pose poseOf(const py::handle& value, const std::string& name) {
  if (py::isinstance<Pose>(value)) return value.cast<Pose>();
  const auto array = arrayIn<Numbers>(value, name);
  if (array.ndim() == 1 && array.shape(0) == kPoseNumbers) return poseOfNumbers(array.data());
  if (array.ndim() == 1 && array.shape(0) == 3)
    return {{array.at(0), array.at(1), array.at(2)}, Quaternion::Identity()};
  if (array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4) return poseOfMatrix(array.data());
  throw py::value_error(name +
                        " is no Pose, no 7 numbers (x y z, quaternion x y z w), no 3 numbers and no 4 x 4 matrix");
}

std::vector<Pose> posesOf(const py::handle& values, const std::string& name) {
  std::vector<Pose> poses;
  if (py::isinstance<py::array>(values)) {
    const auto array = rowsIn<Numbers>(values, kPoseNumbers, name);
    for (py::ssize_t row = 0; row < array.shape(0); ++row) poses.push_back(poseOfNumbers(array.data(row, 0)));
    return poses;
  }
  if (!py::isinstance<py::sequence>(values)) throw py::value_error(name + " is no array and no sequence of poses");
  for (const py::handle value : values) {
    poses.push_back(poseOf(value, name + "[" + std::to_string(poses.size()) + "]"));
  }
  return poses;
}

py::array_t<double> arrayOf(const Vector3& vector) { return py::array_t<double>(3, vector.data()); }

py::array_t<double> arrayOf(const std::vector<Vector3>& vectors) {
  py::array_t<double> array({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
  double* row = array.mutable_data();
  for (const Vector3& vector : vectors) row = std::copy(vector.data(), vector.data() + 3, row);
  return array;
}

py::array_t<double> arrayOf(const Pose& pose) {
  py::array_t<double> array(kPoseNumbers);
  write(pose, array.mutable_data());
  return array;
}

py::array_t<double> arrayOf(const std::vector<Pose>& poses) {
  py::array_t<double> array({static_cast<py::ssize_t>(poses.size()), kPoseNumbers});
  double* row = array.mutable_data();
  for (const Pose& pose : poses) {
    write(pose, row);
    row += kPoseNumbers;
  }
  return array;
}

py::array verticesOf(const py::object& mesh) {
  const auto& value = mesh.cast<const Mesh&>();
  return readOnly(value.vertexData(), value.vertexCount(), mesh);
}

py::array trianglesOf(const py::object& mesh) {
  const auto& value = mesh.cast<const Mesh&>();
  return readOnly(value.triangleData(), value.triangleCount(), mesh);
}

Mesh meshOf(const py::handle& vertices, const py::handle& triangles) {
  const auto points = rowsIn<Numbers>(vertices, 3, "vertices");
  const auto corners = rowsIn<Indices>(triangles, 3, "triangles");
  std::vector<Vector3> places;
  for (py::ssize_t row = 0; row < points.shape(0); ++row) {
    places.emplace_back(points.at(row, 0), points.at(row, 1), points.at(row, 2));
  }
  std::vector<Triangle> indices;
  for (py::ssize_t row = 0; row < corners.shape(0); ++row) {
    Triangle triangle{};
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const std::int64_t index = corners.at(row, corner);
      if (index < 0 || index >= points.shape(0)) throw py::value_error("triangles has an index of no vertex");
      triangle[static_cast<std::size_t>(corner)] = static_cast<std::uint32_t>(index);
    }
    indices.push_back(triangle);
  }
  return valueOf(Mesh::make(places, indices));
}

}  // namespace glissade::python
