#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/fits/joint_edits.h"
#include "widgets/document/sequence_planner.h"

namespace glissade {

/// The source of a joint, and a person's statement about it.
enum class JointRowState {
  Recognised,  ///< recognised from the shapes
  Suggested,   ///< suggested by shape, name or class; it has no effect on a plan
  Confirmed,   ///< confirmed by a person as it was found
  Made,        ///< made or changed by a person
  PressedOut,  ///< a person states that the insert comes out along its axis
  Dissolved,   ///< a person states that the joint does not exist
  Opened,      ///< a person states that the unit is taken apart
  Refused      ///< a person's statement about it is impossible in this product
};

inline constexpr EnumNames<JointRowState, 8> kJointRowStateNames{
    {"recognised", "suggested", "confirmed", "made", "pressed-out", "dissolved", "opened", "refused"}};

/// One joint as the panel shows it.
struct JointRow {
  Joint joint;   ///< the joint with its edits; a joint without effect as it was found
  JointKey key;  ///< key by which a person's statement names the joint
  JointRowState state = JointRowState::Recognised;
  bool isFound = true;                  ///< found by the program; else only a person has made it
  std::optional<Diagnostic> refusal{};  ///< reason why a statement was refused

  /// Whether it is a joint of the product, including suggested ones.
  bool counts() const;
  /// Whether a person has made a statement about it.
  bool isStated() const { return state != JointRowState::Recognised && state != JointRowState::Suggested; }
};

/// The joints of a product: found joints, and a person's statements about them. Immutable.
class JointTable {
 public:
  JointTable(ProductPtr product, std::shared_ptr<const Joints> found, std::vector<JointEdit> said);

  const AssembledProduct& product() const { return *product_; }
  const std::vector<JointEdit>& said() const { return said_; }
  /// Sorted by body, then by kind; refused statements come last.
  const std::vector<JointRow>& rows() const { return rows_; }
  std::size_t count(JointRowState state) const;
  /// This table with other statements about the same found joints.
  JointTable with(std::vector<JointEdit> said) const { return {product_, found_, std::move(said)}; }
  /// The displayed name of the body; its id if there is no such body.
  QString shown(const BodyId& id) const;

 private:
  void addRows(const Joints& joints, const std::vector<JointEdit>& sound);
  void addDissolved(const std::vector<JointEdit>& sound);
  void addRefused(const JointEdit& edit, const Diagnostic& why);
  const Joint* foundJoint(const JointKey& key) const;

  ProductPtr product_;
  std::shared_ptr<const Joints> found_;
  std::vector<JointEdit> said_;
  std::vector<JointRow> rows_;
};

/// Whether both keys name the same joint; the order of the other bodies makes no difference.
bool isSameJoint(JointKey one, JointKey other);

/// The statements with this one in place of the statement on the same joint.
std::vector<JointEdit> withEdit(std::vector<JointEdit> said, const JointEdit& word);
/// The statements without those on this joint.
std::vector<JointEdit> withoutEdit(std::vector<JointEdit> said, const JointKey& key);
/// The statements by which the joint of the row does not exist. A joint that only a person has made needs no statement
/// for that.
std::vector<JointEdit> withoutJoint(std::vector<JointEdit> said, const JointRow& row);

}  // namespace glissade
