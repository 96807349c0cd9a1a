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

/// The cut face of a mesh in one section, filled and outlined, both in the frame of the mesh; null if the section does
/// not meet it. May be called on any thread.
osg::ref_ptr<osg::Group> makeCap(const TriangleMesh& mesh, const Plane& section, const osg::Vec4& colour,
                                 const ScenePalette& palette);

/// A body that is cut open, at its drawn pose.
struct CapBody {
  MeshPtr mesh;
  Pose X_WB;
  osg::Vec4 colour;
  bool shown = true;
};

/// The cut faces of all bodies in all sections. A cut face is made again only if its body and its section have moved
/// relative to each other. Cut faces of large bodies are left for another thread. Used on the GUI thread only, apart
/// from the result of work().
class SectionCaps {
 public:
  /// Called on any thread; its result is called on the GUI thread.
  using Work = std::function<std::function<void()>(const WorkWatch&)>;

  osg::Node* node() const { return root_; }
  /// Sections beyond kMostSections are not drawn.
  void show(const std::vector<Plane>& sections, const std::vector<CapBody>& bodies, const ScenePalette& palette);
  /// Makes all cut faces again at the next show(), for other lines or colours.
  void forget();
  bool hasLeft() const;
  /// The work that makes the remaining cut faces; null: none is left.
  Work work();

 private:
  struct Cap {
    MeshPtr mesh;  ///< null: the cap was never made
    Plane plane_B;
    bool isLeft = false;
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
  };
  struct Section {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    std::vector<Cap> caps;  ///< per body
  };
  /// A cut face that has to be made.
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
