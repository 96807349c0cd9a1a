#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/product/joint_edits.h"
#include "widgets/bridge/sequence_planner.h"

namespace glissade {

/// Who says what of a joint.
enum class JointRowState {
  Recognised,  ///< the shapes do
  Suggested,   ///< shape, name or class hint at it; it does not count in a plan
  Confirmed,   ///< a person does, as it was found
  Made,        ///< a person has made or changed it
  PressedOut,  ///< a person says that the insert comes out along its axis
  Dissolved,   ///< a person says that it is not there
  Opened,      ///< a person says that the unit is taken apart
  Refused      ///< what a person says of it cannot be in this product
};

/// "recognised", "suggested", "confirmed", "made", "pressed-out", "dissolved", "opened", "refused".
const char* jointRowStateName(JointRowState state);

/// One joint as the panel shows it.
struct JointRow {
  Joint joint;   ///< as it counts; of one that does not count, as it was found
  JointKey key;  ///< what a person's word about it names
  JointRowState state = JointRowState::Recognised;
  bool isFound = true;                  ///< by the program; else only a person has made it
  std::optional<Diagnostic> refusal{};  ///< of a refused word: why

  /// It is a joint of the product, be it only suggested.
  bool counts() const;
  /// A person says something of it.
  bool isSaid() const { return state != JointRowState::Recognised && state != JointRowState::Suggested; }
};

/// The joints of a product: what was found, and what a person says of it. Immutable.
class JointTable {
 public:
  JointTable(ProductPtr product, std::shared_ptr<const Joints> found, std::vector<JointEdit> said);

  const AssembledProduct& product() const { return *product_; }
  const std::vector<JointEdit>& said() const { return said_; }
  /// By body, then by kind; refused words last.
  const std::vector<JointRow>& rows() const { return rows_; }
  std::size_t count(JointRowState state) const;
  /// The same found joints with other words of a person.
  JointTable with(std::vector<JointEdit> said) const { return {product_, found_, std::move(said)}; }
  /// What people see of the name of the body; the id where there is no such body.
  QString shown(const std::string& id) const;

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

/// The order of the others makes no difference.
bool isSameJoint(JointKey one, JointKey other);

/// What a person says, with this word in place of what they said of the same joint.
std::vector<JointEdit> withWord(std::vector<JointEdit> said, const JointEdit& word);
/// What a person says, without a word about this joint.
std::vector<JointEdit> withoutWord(std::vector<JointEdit> said, const JointKey& key);
/// The joint of the row is not there: one that only a person has made needs no word for that.
std::vector<JointEdit> withoutJoint(std::vector<JointEdit> said, const JointRow& row);

}  // namespace glissade
