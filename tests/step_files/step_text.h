#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace glissade::test {

/// Writes a STEP text entity by entity, in millimetres unless a context of another unit is requested. It shares no code
/// with the importer and needs no OpenCASCADE.
class StepText {
 public:
  using Triple = std::array<double, 3>;

  StepText() {
    application_ = add("APPLICATION_CONTEXT('core data')");
    add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000," + application_ + ")");
    productContext_ = add("PRODUCT_CONTEXT(''," + application_ + ",'mechanical')");
    definitionContext_ = add("PRODUCT_DEFINITION_CONTEXT('part definition'," + application_ + ",'design')");
    millimetres_ = context(add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"));
    origin_ = placement({0, 0, 0});
  }

  /// Adds an entity and returns its name, such as "#12".
  std::string add(const std::string& entity) {
    const std::string name = "#" + std::to_string(++last_);
    text_ += name + "=" + entity + ";\n";
    return name;
  }

  std::string str() const {
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
           "FILE_NAME('x','2026-01-01T00:00:00',(''),(''),'','','');\n"
           "FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF'));\nENDSEC;\nDATA;\n" +
           text_ + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

  const std::string& millimetres() const { return millimetres_; }
  const std::string& origin() const { return origin_; }

  std::string inches() {
    const std::string millimetre = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const std::string measure = add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)," + millimetre + ")");
    const std::string exponents = add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    return context(add("(CONVERSION_BASED_UNIT('INCH'," + measure + ")LENGTH_UNIT()NAMED_UNIT(" + exponents + "))"));
  }

  std::string point(const Triple& p) { return add("CARTESIAN_POINT(''," + list(p) + ")"); }
  std::string direction(const Triple& d) { return add("DIRECTION(''," + list(d) + ")"); }
  std::string placement(const Triple& at, const Triple& z = {0, 0, 1}, const Triple& x = {1, 0, 0}) {
    return add("AXIS2_PLACEMENT_3D(''," + point(at) + "," + direction(z) + "," + direction(x) + ")");
  }
  std::string axis(const Triple& at, const Triple& z = {0, 0, 1}) {
    return add("AXIS1_PLACEMENT(''," + point(at) + "," + direction(z) + ")");
  }

  struct Product {
    std::string definition;
    std::string representation;
  };

  Product product(const std::string& name) {
    const std::string product = add("PRODUCT('" + name + "','" + name + "','',(" + productContext_ + "))");
    const std::string formation = add("PRODUCT_DEFINITION_FORMATION('',''," + product + ")");
    return {add("PRODUCT_DEFINITION('',''," + formation + "," + definitionContext_ + ")"), ""};
  }

  void define(Product& product, const std::string& representation) {
    const std::string shape = add("PRODUCT_DEFINITION_SHAPE('',''," + product.definition + ")");
    add("SHAPE_DEFINITION_REPRESENTATION(" + shape + "," + representation + ")");
    product.representation = representation;
  }

  std::string representation(const std::string& items, const std::string& kind = "SHAPE_REPRESENTATION",
                             const std::string& context = "") {
    return add(kind + "('',(" + origin_ + (items.empty() ? "" : ",") + items + ")," +
               (context.empty() ? millimetres_ : context) + ")");
  }

  Product part(const std::string& name, const std::string& items, const std::string& kind = "SHAPE_REPRESENTATION",
               const std::string& context = "") {
    Product made = product(name);
    define(made, representation(items, kind, context));
    return made;
  }

  /// Adds the use of a part in an assembly.
  std::string place(const Product& assembly, const Product& part, const Triple& at, const Triple& z = {0, 0, 1},
                    const Triple& x = {1, 0, 0}) {
    const std::string use =
        add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('','',''," + assembly.definition + "," + part.definition + ",$)");
    const std::string shape = add("PRODUCT_DEFINITION_SHAPE('',''," + use + ")");
    const std::string moved = add("ITEM_DEFINED_TRANSFORMATION('',''," + origin_ + "," + placement(at, z, x) + ")");
    const std::string relation =
        add("(REPRESENTATION_RELATIONSHIP('',''," + part.representation + "," + assembly.representation +
            ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" + moved + ")SHAPE_REPRESENTATION_RELATIONSHIP())");
    add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" + relation + "," + shape + ")");
    return use;
  }

  /// Adds a MANIFOLD_SOLID_BREP with polygons as faces, from the corner nearest to the origin.
  std::string box(const Triple& corner, const Triple& size, const std::string& name = "") {
    std::vector<std::string> at;
    for (int i = 0; i < 8; ++i) {
      at.push_back(point(
          {corner[0] + (i & 1 ? size[0] : 0), corner[1] + (i & 2 ? size[1] : 0), corner[2] + (i & 4 ? size[2] : 0)}));
    }
    std::string faces;
    for (const auto& [corners, normal] : sides()) {
      std::string loop;
      for (const int i : corners) loop += (loop.empty() ? "" : ",") + at[static_cast<std::size_t>(i)];
      const std::string bound = add("FACE_OUTER_BOUND(''," + add("POLY_LOOP('',(" + loop + "))") + ",.T.)");
      const Triple along{normal[1], normal[2], normal[0]};
      const std::string plane = add("PLANE(''," +
                                    add("AXIS2_PLACEMENT_3D(''," + at[static_cast<std::size_t>(corners[0])] + "," +
                                        direction(normal) + "," + direction(along) + ")") +
                                    ")");
      faces += (faces.empty() ? "" : ",") + add("FACE_SURFACE('',(" + bound + ")," + plane + ",.T.)");
    }
    return add("FACETED_BREP('" + name + "'," + add("CLOSED_SHELL('',(" + faces + "))") + ")");
  }

  std::string coordinates(const Triple& corner, const Triple& size) {
    std::string points;
    for (int i = 0; i < 8; ++i) {
      points += (i > 0 ? "," : "") + list({corner[0] + (i & 1 ? size[0] : 0), corner[1] + (i & 2 ? size[1] : 0),
                                           corner[2] + (i & 4 ? size[2] : 0)});
    }
    return add("COORDINATES_LIST('',8,(" + points + "))");
  }

  /// Adds a TRIANGULATED_FACE with all sides of a box; its list of indices is empty.
  std::string triangulatedBox(const std::string& coordinates, const std::string& link = "$") {
    std::string triangles;
    for (const auto& [c, normal] : sides()) {
      triangles += (triangles.empty() ? "" : ",") + corners({c[0], c[1], c[2]}) + "," + corners({c[0], c[2], c[3]});
    }
    return add("TRIANGULATED_FACE(''," + coordinates + ",8,()," + link + ",(),(" + triangles + "))");
  }

  std::string tessellatedBox(const Triple& corner, const Triple& size, const std::string& link = "$",
                             const std::string& name = "") {
    return add("TESSELLATED_SOLID('" + name + "',(" + triangulatedBox(coordinates(corner, size)) + ")," + link + ")");
  }

  /// Adds each side of a box, alternately as a strip and as a fan. The corners are indices of a list that runs
  /// backwards through the coordinates.
  std::string stripsAndFansOfBox(const Triple& corner, const Triple& size) {
    std::string strips;
    std::string fans;
    bool isFan = false;
    for (const auto& [c, normal] : sides()) {
      const auto at = [&c = c](std::size_t i) { return std::to_string(8 - c[i]); };
      std::string& list = isFan ? fans : strips;
      list += (list.empty() ? "(" : ",(") + at(0) + "," + at(1) + "," +
              (isFan ? at(2) + "," + at(3) : at(3) + "," + at(2)) + ")";
      isFan = !isFan;
    }
    return add("COMPLEX_TRIANGULATED_FACE(''," + coordinates(corner, size) + ",8,(),$,(8,7,6,5,4,3,2,1),(" + strips +
               "),(" + fans + "))");
  }

  /// Adds a whole sphere as one face, whose boundary runs along a great circle and back.
  std::string slitSphere(double radius, const Triple& normal = {0, 1, 0}, const Triple& first = {0, 0, -1}) {
    const std::string vertex =
        add("VERTEX_POINT(''," + point({radius * first[0], radius * first[1], radius * first[2]}) + ")");
    const std::string circle =
        add("CIRCLE(''," + placement({0, 0, 0}, normal, first) + "," + std::to_string(radius) + ")");
    const std::string edge = add("EDGE_CURVE(''," + vertex + "," + vertex + "," + circle + ",.T.)");
    const std::string loop = add("EDGE_LOOP('',(" + add("ORIENTED_EDGE('',*,*," + edge + ",.T.)") + "," +
                                 add("ORIENTED_EDGE('',*,*," + edge + ",.F.)") + "))");
    const std::string surface =
        add("SPHERICAL_SURFACE(''," + placement({0, 0, 0}) + "," + std::to_string(radius) + ")");
    const std::string face =
        add("ADVANCED_FACE('',(" + add("FACE_OUTER_BOUND(''," + loop + ",.T.)") + ")," + surface + ",.T.)");
    return add("MANIFOLD_SOLID_BREP(''," + add("CLOSED_SHELL('',(" + face + "))") + ")");
  }

 private:
  using Side = std::pair<std::array<int, 4>, Triple>;

  /// The sides of a box: corners counter-clockwise from outside, and the normal.
  static std::vector<Side> sides() {
    return {{{0, 2, 3, 1}, {0, 0, -1}}, {{4, 5, 7, 6}, {0, 0, 1}},  {{0, 1, 5, 4}, {0, -1, 0}},
            {{2, 6, 7, 3}, {0, 1, 0}},  {{0, 4, 6, 2}, {-1, 0, 0}}, {{1, 3, 7, 5}, {1, 0, 0}}};
  }

  static std::string corners(const std::array<int, 3>& c) {
    return "(" + std::to_string(c[0] + 1) + "," + std::to_string(c[1] + 1) + "," + std::to_string(c[2] + 1) + ")";
  }

  static std::string list(const Triple& p) {
    return "(" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + ")";
  }

  std::string context(const std::string& length) {
    const std::string angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const std::string solidAngle = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const std::string accuracy =
        add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-05)," + length + ",'distance_accuracy_value','')");
    return add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + accuracy +
               "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," + angle + "," + solidAngle +
               "))REPRESENTATION_CONTEXT('','3D'))");
  }

  int last_ = 0;
  std::string text_;
  std::string application_;
  std::string productContext_;
  std::string definitionContext_;
  std::string millimetres_;
  std::string origin_;
};

}  // namespace glissade::test
