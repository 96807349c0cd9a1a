#pragma once

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include <functional>
#include <map>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/geometry/plane_section.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The cut face of a mesh in one section, filled and outlined, both in the frame of the mesh; null where the section
/// does not meet it. On any thread.
osg::ref_ptr<osg::Group> makeCap(const TriangleMesh& mesh, const Plane& section, const osg::Vec4& colour,
                                 const ScenePalette& palette);

/// A body that is cut open, where it is drawn.
struct CapBody {
  MeshPtr mesh;
  Pose X_WB;
  osg::Vec4 colour;
  bool shown = true;
};

/// The cut faces of all bodies in all sections. A cut face is made again only where its body and its section have
/// moved against each other. Those of large bodies are left for another thread. GUI thread only, but for the work that
/// work() gives.
class SectionCaps {
 public:
  /// On any thread; what it returns belongs to the GUI thread.
  using Work = std::function<std::function<void()>(const WorkWatch&)>;

  osg::Node* node() const { return root_; }
  /// Sections beyond kMostSections are not drawn.
  void show(const std::vector<Plane>& sections, const std::vector<CapBody>& bodies, const ScenePalette& palette);
  /// Makes all again at the next show(): lines or colours are others.
  void forget();
  bool hasLeft() const;
  /// Makes the cut faces that are left; null: none is.
  Work work();

 private:
  struct Cap {
    MeshPtr mesh;  ///< null: nothing is known
    Plane plane_B;
    bool isLeft = false;
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
  };
  struct Section {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    std::vector<Cap> caps;  ///< per body
  };
  /// What is left to be made.
  struct Order {
    std::size_t section;
    std::size_t body;
    MeshPtr mesh;
    Plane plane_B;
    osg::Vec4 colour;
  };

  void showCap(Cap& cap, const CapBody& body, const Plane& section, std::size_t& triangles);
  bool meets(const TriangleMesh& mesh, const Plane& plane);
  void take(const Order& order, osg::Group* face);

  osg::ref_ptr<osg::Group> root_ = new osg::Group;
  std::vector<Section> sections_;
  std::vector<osg::Vec4> colours_;  ///< per body
  std::map<const TriangleMesh*, Box3> boxes_;
  ScenePalette palette_;
};

}  // namespace glissade
