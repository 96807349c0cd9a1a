#pragma once

#include <optional>
#include <vector>

#include "engine/planning/tree_planner.h"

namespace glissade {

/// Base of the planners that grow by Add_Tree(q) of paper 1: every component grows straight towards q up to the first
/// obstacle, without a limit of length; then the new nodes are connected with each other.
class AddTreePlanner : public TreePlanner {
 protected:
  explicit AddTreePlanner(const Problem& problem);

  /// Does one step of Add_Tree.
  void addTree(const Pose& q, Author author, PlannerHost& host);
  /// Counts a step in which nothing grows.
  void passStep(Author author);
  /// Delivers a path if start and goal are joined. An edge that cannot be certified is dropped, and the search goes on.
  void deliverPath(PlannerHost& host);

  /// Author of the configuration that was tried last.
  Author lastAuthor() const { return lastAuthor_; }
  /// Length of the longest edge from index `first` on, metres in the metric; 0 where there is none.
  double longestEdge(std::size_t first) const;

 private:
  std::optional<Node> extend(ComponentId component, const Pose& q, Author author, std::optional<Node>& reached,
                             PlannerHost& host);
  void connect(const std::vector<Node>& added, PlannerHost& host);
  bool isDuplicate(ComponentId component, const Pose& q, Author author) const;

  Author lastAuthor_ = Author::Computer;
};

}  // namespace glissade
