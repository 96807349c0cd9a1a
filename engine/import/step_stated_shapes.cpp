#include "engine/import/step_stated_shapes.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "engine/base/printable_text.h"

namespace glissade {
namespace {

using Id = std::uint64_t;

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// True for most entities of a file, which neither are nor use a solid, a shell or a product.
bool isOfBoundary(std::string_view type) {
  static constexpr std::array<std::string_view, 16> kTypes{
      "CARTESIAN_POINT", "DIRECTION",    "VECTOR",        "LINE",
      "CIRCLE",          "VERTEX_POINT", "EDGE_CURVE",    "PCURVE",
      "EDGE_LOOP",       "FACE_BOUND",   "ADVANCED_FACE", "AXIS2_PLACEMENT_3D",
      "ORIENTED_EDGE",   "PLANE",        "STYLED_ITEM",   "FACE_OUTER_BOUND"};
  return holdsTessellation(type) || std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

/// The values of the record with this type, or of the only record; empty if there is none.
std::vector<std::string_view> valuesOfType(const std::vector<StepRecord>& records, std::string_view type) {
  for (const StepRecord& record : records) {
    if (records.size() == 1 || record.type == type) return stepValues(record.arguments);
  }
  return {};
}

Id referenceAt(const std::vector<std::string_view>& values, std::size_t at) {
  return at < values.size() ? stepReference(values[at]) : 0;
}

/// Products, their uses, and the definitions that relate representations to them.
class ShapeGraph {
 public:
  explicit ShapeGraph(const StepEntities& entities) : entities_(entities) {
    for (const StepEntities::Entity& entity : entities.all()) {
      if (!isOfBoundary(entities.typeOf(entity))) take(entity);
    }
    for (const Use& use : uses_) {
      if (products_.count(use.part) > 0) assembliesOf_[use.part].push_back(use.assembly);
      partsOf_[use.assembly].insert(use.part);
    }
    for (const auto& [definition, representation] : shapeDefinitions_) {
      const Id product = productOfShape(definition);
      if (product == 0 || representation == 0) continue;
      ownerOf_.emplace(representation, product);
      shapesOf_[product].push_back(representation);
    }
    for (const Use& relation : relations_) {
      if (placing_.count(relation.entity) > 0) continue;
      relatedTo_[relation.assembly].push_back(relation.part);
      relatedTo_[relation.part].push_back(relation.assembly);
    }
    for (const auto& [definition, of] : definitionOf_) {
      if (stepKindOf(entities.recordsOf(definition)) == "PRODUCT_DEFINITION_SHAPE") withShape_.insert(of);
    }
  }

  StatedShapes stated() {
    StatedShapes stated;
    for (const Id product : products_) addProduct(product, stated);
    addUnknownUses(stated);
    addLooseEnds(stated);
    return stated;
  }

 private:
  struct Use {
    Id entity;
    Id assembly;
    Id part;
  };
  struct Item {
    Id entity;
    Id representation;
    Id count;
  };
  struct Items {
    std::vector<Item> all;
    std::unordered_map<Id, std::size_t> indexOf;
  };
  static constexpr Id kMany = 1'000'000;
  static constexpr int kDeepestNesting = 64;

  void take(const StepEntities::Entity& entity) {
    const std::vector<StepRecord> records = entities_.recordsOf(entity);
    for (const StepRecord& record : records) {
      if (record.type == "PRODUCT_DEFINITION" || record.type == "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS") {
        products_.insert(entity.id);
      } else if (record.type == "NEXT_ASSEMBLY_USAGE_OCCURRENCE") {
        const auto values = valuesOfType(records, "PRODUCT_DEFINITION_RELATIONSHIP");
        uses_.push_back({entity.id, referenceAt(values, 3), referenceAt(values, 4)});
        useIds_.insert(entity.id);
      } else if (record.type == "SHAPE_DEFINITION_REPRESENTATION") {
        const auto values = valuesOfType(records, "PROPERTY_DEFINITION_REPRESENTATION");
        shapeDefinitions_.emplace_back(referenceAt(values, 0), referenceAt(values, 1));
      } else if (record.type == "PROPERTY_DEFINITION_REPRESENTATION" && records.size() == 1) {
        propertyShapes_.insert(referenceAt(stepValues(record.arguments), 1));
      } else if (record.type == "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION") {
        const auto values = stepValues(record.arguments);
        placements_.push_back({entity.id, referenceAt(values, 0), referenceAt(values, 1)});
        placing_.insert(referenceAt(values, 0));
      } else if (record.type == "SHAPE_REPRESENTATION_RELATIONSHIP") {
        const auto values = valuesOfType(records, "REPRESENTATION_RELATIONSHIP");
        relations_.push_back({entity.id, referenceAt(values, 2), referenceAt(values, 3)});
      } else if (record.type == "PRODUCT_DEFINITION_SHAPE" || record.type == "PROPERTY_DEFINITION") {
        const auto values = valuesOfType(records, "PROPERTY_DEFINITION");
        if (values.size() > 2) definitionOf_[entity.id] = stepReference(values[2]);
      }
    }
    takeShape(entity, records);
  }

  /// Collects solids and shells, which may belong to no product.
  void takeShape(const StepEntities::Entity& entity, const std::vector<StepRecord>& records) {
    const std::string kind = stepKindOf(records);
    const bool isShell = kind == "CLOSED_SHELL" || kind == "OPEN_SHELL" || kind == "CONNECTED_FACE_SET";
    const bool isSolid = kind.ends_with("_BREP") || kind == "BREP_WITH_VOIDS" || kind.ends_with("SURFACE_MODEL") ||
                         kind.ends_with("_SOLID") || kind == "TESSELLATED_SHELL" || kind == "BOOLEAN_RESULT" ||
                         kind == "SOLID_REPLICA";
    if (isShell || isSolid) candidates_.emplace(entity.id, Candidate{kind, isSolid, {}});
  }

  Id productOfShape(Id definition) const {
    const auto found = definitionOf_.find(definition);
    const Id of = found == definitionOf_.end() ? definition : found->second;
    return products_.count(of) > 0 ? of : 0;
  }

  /// The representations of a product's shape, along relations that place no other product.
  std::vector<Id> representationsOf(Id product) const {
    std::vector<Id> found;
    const auto add = [&](Id representation) {
      if (std::find(found.begin(), found.end(), representation) == found.end()) found.push_back(representation);
    };
    const auto own = shapesOf_.find(product);
    if (own != shapesOf_.end()) std::for_each(own->second.begin(), own->second.end(), add);
    for (std::size_t next = 0; next < found.size(); ++next) {
      const auto related = relatedTo_.find(found[next]);
      if (related == relatedTo_.end()) continue;
      for (const Id other : related->second) {
        const auto owner = ownerOf_.find(other);
        if (other != 0 && (owner == ownerOf_.end() || owner->second == product)) add(other);
      }
    }
    return found;
  }

  std::vector<Id> itemsOf(Id representation) const {
    const auto values = valuesOfType(entities_.recordsOf(representation), "REPRESENTATION");
    return values.size() > 1 ? stepReferencesIn(values[1]) : std::vector<Id>();
  }

  /// Collects items, including those that mapped items repeat. A mapped shape of a part that the product uses is the
  /// placement of that use.
  void collect(Id product, Id representation, Id count, int depth, Items& found) {
    if (depth > kDeepestNesting || found.all.size() > kMany) return;
    for (const Id item : itemsOf(representation)) {
      const std::vector<StepRecord> records = entities_.recordsOf(item);
      if (stepKindOf(records) == "MAPPED_ITEM") {
        const auto values = valuesOfType(records, "MAPPED_ITEM");
        const auto map =
            valuesOfType(entities_.recordsOf(values.size() < 2 ? 0 : stepReference(values[values.size() - 2])),
                         "REPRESENTATION_MAP");
        const Id mapped = referenceAt(map, 1);
        const auto owner = ownerOf_.find(mapped);
        if (owner == ownerOf_.end() || !uses(product, owner->second)) {
          collect(product, mapped, count, depth + 1, found);
        }
        hasMappedItems_.insert(product);
        continue;
      }
      if (stepShapeRole(entities_, records) == StepShapeRole::NoMaterial) {
        if (stepKindOf(records).ends_with("SET") || stepKindOf(records).ends_with("WIREFRAME_MODEL")) {
          hasCurves_.insert(product);
        }
        continue;
      }
      const auto [known, isNew] = found.indexOf.try_emplace(item, found.all.size());
      if (isNew) {
        found.all.push_back({item, representation, count});
      } else if (depth > 0) {  // two representations of one product may both contain an item
        found.all[known->second].count += count;
      }
    }
  }

  bool uses(Id assembly, Id part) const {
    const auto parts = partsOf_.find(assembly);
    return parts != partsOf_.end() && parts->second.count(part) > 0;
  }

  Id placesOf(Id product, int depth = 0) {
    const auto known = places_.find(product);
    if (known != places_.end()) return known->second;
    const auto in = assembliesOf_.find(product);
    Id sum = in == assembliesOf_.end() ? 1 : 0;
    if (in != assembliesOf_.end() && depth <= kDeepestNesting) {
      for (const Id assembly : in->second) sum = std::min(kMany, sum + placesOf(assembly, depth + 1));
    }
    places_[product] = sum;
    return sum;
  }

  void addProduct(Id product, StatedShapes& stated) {
    Items found;
    const std::vector<Id> representations = representationsOf(product);
    for (const Id representation : representations) {
      reached_.insert(representation);
      collect(product, representation, 1, 0, found);
    }
    const Id places = placesOf(product);
    const std::size_t first = stated.items.size();
    bool hasBoundaries = false;
    for (const Item& item : found.all) {
      const std::vector<StepRecord> records = entities_.recordsOf(item.entity);
      const StepShapeRole role = stepShapeRole(entities_, records);
      hasBoundaries = hasBoundaries || role == StepShapeRole::Boundary;
      reachedItems_.insert(item.entity);
      stated.items.push_back(
          {item.entity, stepKindOf(records), role, product, item.representation, std::min(kMany, places * item.count)});
    }
    for (std::size_t i = first; hasBoundaries && i < stated.items.size(); ++i) {
      StatedShape& item = stated.items[i];
      if (item.role != StepShapeRole::Triangles) continue;
      item.isSecond = isLinked(item.entity, 0);
      item.mayBeSecond = !item.isSecond;
    }
    const bool isAssembly = partsOf_.count(product) > 0;
    const bool isPart = assembliesOf_.count(product) > 0 || !representations.empty() || withShape_.count(product) > 0;
    const bool hasOther = hasCurves_.count(product) > 0 || hasMappedItems_.count(product) > 0;
    if (found.all.empty() && !isAssembly && isPart && !hasOther) {
      stated.shapeless.push_back({product, "PRODUCT_DEFINITION", product, places});
    }
  }

  /// True if the item's geometric or topological link, or that of its faces, names a boundary.
  bool isLinked(Id item, int depth) const {
    const std::vector<StepRecord> records = entities_.recordsOf(item);
    const std::string kind = stepKindOf(records);
    if (kind == "TESSELLATED_SOLID" || kind == "TESSELLATED_SHELL") {
      const auto values = valuesOfType(records, kind);
      if (!values.empty() && stepReference(values.back()) != 0) return true;
      const auto faces = values.size() < 2 ? std::vector<Id>() : stepReferencesIn(values[values.size() - 2]);
      return depth == 0 && !faces.empty() && isLinked(faces.front(), 1);
    }
    if (!kind.ends_with("TRIANGULATED_FACE")) return false;
    const auto values = valuesOfType(records, "TESSELLATED_FACE");
    return std::any_of(values.begin() + std::min<std::ptrdiff_t>(2, static_cast<std::ptrdiff_t>(values.size())),
                       values.end(), [](std::string_view value) { return stepReference(value) != 0; });
  }

  void addUnknownUses(StatedShapes& stated) const {
    for (const Use& use : uses_) {
      const bool isPart = products_.count(use.part) > 0;
      if (isPart && products_.count(use.assembly) > 0) continue;
      const std::string kind = stepKindOf(entities_.recordsOf(use.entity));
      stated.unknownUses.push_back({use.entity, kind, isPart ? use.part : use.assembly, 1});
    }
    for (const Use& placement : placements_) {
      const auto definition = definitionOf_.find(placement.part);
      if (definition != definitionOf_.end() && useIds_.count(definition->second) > 0) {
        addUnknownTransformation(placement.assembly, stated);
        continue;
      }
      const auto of = definition == definitionOf_.end() ? placement.part : definition->second;
      // A placement of a product repeats the statement of its use.
      if (products_.count(of) > 0) continue;
      const auto relation = valuesOfType(entities_.recordsOf(placement.assembly), "REPRESENTATION_RELATIONSHIP");
      const auto owner = ownerOf_.find(referenceAt(relation, 2));
      stated.unknownUses.push_back({of == 0 ? placement.entity : of, stepKindOf(entities_.recordsOf(of)),
                                    owner == ownerOf_.end() ? 0 : owner->second, 1});
    }
  }

  /// Reports a transformation that OpenCASCADE does not understand and ignores.
  void addUnknownTransformation(Id relation, StatedShapes& stated) const {
    const std::vector<StepRecord> records = entities_.recordsOf(relation);
    for (const StepRecord& record : records) {
      if (record.type != "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION") continue;
      const Id transformation =
          records.size() == 1 ? referenceAt(stepValues(record.arguments), 4) : stepReference(record.arguments);
      const std::vector<StepRecord> stating = entities_.recordsOf(transformation);
      const std::string kind = stepKindOf(stating);
      const auto values = valuesOfType(stating, "ITEM_DEFINED_TRANSFORMATION");
      const bool isKnown = kind == "ITEM_DEFINED_TRANSFORMATION" && isPlacement(referenceAt(values, 2)) &&
                           isPlacement(referenceAt(values, 3));
      if (isKnown || kind.starts_with("CARTESIAN_TRANSFORMATION_OPERATOR")) continue;
      const auto owner = ownerOf_.find(referenceAt(valuesOfType(records, "REPRESENTATION_RELATIONSHIP"), 2));
      stated.unknownUses.push_back({transformation, kind, owner == ownerOf_.end() ? 0 : owner->second, 1});
    }
  }

  bool isPlacement(Id id) const {
    const std::vector<StepRecord> records = entities_.recordsOf(id);
    const std::string kind = stepKindOf(records);
    if (kind.starts_with("CARTESIAN_TRANSFORMATION_OPERATOR")) return true;
    if (kind != "AXIS2_PLACEMENT_3D" || records.size() != 1) return false;
    const auto values = stepValues(records.front().arguments);
    const auto isKind = [&](std::size_t at, std::string_view wanted) {
      const Id part = referenceAt(values, at);
      return part == 0 ? at > 1 : stepKindOf(entities_.recordsOf(part)) == wanted;
    };
    return isKind(1, "CARTESIAN_POINT") && isKind(2, "DIRECTION") && isKind(3, "DIRECTION");
  }

  /// True for kinds that refer to a shape without using it.
  static bool onlyPoints(std::string_view kind) {
    return kind.ends_with("STYLED_ITEM") || contains(kind, "PRESENTATION_LAYER") || contains(kind, "USAGE") ||
           contains(kind, "ASSOCIATION") || contains(kind, "ATTRIBUTE") || contains(kind, "TESSELLATED") ||
           contains(kind, "TRIANGULATED") || contains(kind, "INVISIBILITY") || kind.ends_with("_ASSIGNMENT");
  }

  void addLooseEnds(StatedShapes& stated) {
    for (const StepEntities::Entity& entity : entities_.all()) {
      if (isOfBoundary(entities_.typeOf(entity))) continue;
      const std::string_view body = entities_.text().substr(entity.begin, entity.end - entity.begin);
      for (const Id id : stepReferencesIn(body)) {
        const auto candidate = candidates_.find(id);
        if (candidate != candidates_.end() && id != entity.id) candidate->second.referrers.push_back(entity.id);
      }
    }
    for (const auto& [id, candidate] : candidates_) {
      if (reachedItems_.count(id) > 0) continue;
      Id representation = 0;
      bool isUsed = false;
      for (const Id referrer : candidate.referrers) {
        const std::string kind = stepKindOf(entities_.recordsOf(referrer));
        if (onlyPoints(kind)) continue;
        const bool holds = kind.ends_with("REPRESENTATION") && !isClaimed(referrer);
        isUsed = isUsed || !holds;
        if (holds) representation = referrer;
      }
      if (isUsed) continue;
      if (candidate.isSolid) {
        stated.orphans.push_back(
            {id, candidate.kind, stepShapeRole(entities_, entities_.recordsOf(id)), 0, representation});
      } else {
        stated.loose.push_back({id, candidate.kind, 0, 1});
      }
    }
  }

  /// True if a representation belongs to a product or to a part of a shape, or is no shape.
  bool isClaimed(Id representation) const {
    if (reached_.count(representation) > 0 || propertyShapes_.count(representation) > 0) return true;
    if (!stepKindOf(entities_.recordsOf(representation)).ends_with("SHAPE_REPRESENTATION")) return true;
    for (const auto& [definition, of] : shapeDefinitions_) {
      if (of != representation) continue;
      const auto found = definitionOf_.find(definition);
      const std::string kind =
          found == definitionOf_.end() ? std::string() : stepKindOf(entities_.recordsOf(found->second));
      if (contains(kind, "ASPECT") || kind == "NEXT_ASSEMBLY_USAGE_OCCURRENCE") return true;
    }
    return false;
  }

  struct Candidate {
    std::string kind;
    bool isSolid;
    std::vector<Id> referrers;
  };

  const StepEntities& entities_;
  std::set<Id> products_;  ///< PRODUCT_DEFINITIONs
  std::vector<Use> uses_;
  std::unordered_set<Id> useIds_;
  std::unordered_map<Id, std::vector<Id>> assembliesOf_;  ///< assemblies of a part, one entry for each use
  std::unordered_map<Id, std::set<Id>> partsOf_;
  std::vector<std::pair<Id, Id>> shapeDefinitions_;  ///< definition and representation
  std::vector<Use> placements_;                      ///< with their relation and the placed definition
  std::unordered_set<Id> placing_;                   ///< relations of placements
  std::vector<Use> relations_;                       ///< with both representations
  std::unordered_map<Id, Id> definitionOf_;  ///< definition of a PRODUCT_DEFINITION_SHAPE and of other properties
  std::unordered_map<Id, Id> ownerOf_;       ///< product of each representation
  std::unordered_map<Id, std::vector<Id>> shapesOf_;  ///< representations of each product
  std::unordered_map<Id, std::vector<Id>> relatedTo_;
  std::unordered_set<Id> propertyShapes_;  ///< representations of other properties
  std::unordered_set<Id> withShape_;       ///< definitions with a PRODUCT_DEFINITION_SHAPE
  std::unordered_map<Id, Id> places_;
  std::set<Id> hasCurves_;
  std::set<Id> hasMappedItems_;
  std::unordered_set<Id> reached_;  ///< representations of products
  std::unordered_set<Id> reachedItems_;
  std::map<Id, Candidate> candidates_;
};

}  // namespace

StatedShapes statedShapesOf(const StepEntities& entities) { return ShapeGraph(entities).stated(); }

StepNote stepShapeNote(char kind, const StatedShape& item, const Message& what) {
  return {kind, "#" + std::to_string(item.entity) + " (" + printableLine(item.kind) + ")", what};
}

std::uint64_t productOfDefinition(const StepEntities& entities, std::uint64_t definition) {
  const std::vector<StepRecord> records = entities.recordsOf(definition);
  if (records.empty()) return 0;
  const auto values = valuesOfType(records, "PRODUCT_DEFINITION");
  const auto formation = entities.recordsOf(referenceAt(values, 2));
  return formation.empty() ? 0 : referenceAt(valuesOfType(formation, "PRODUCT_DEFINITION_FORMATION"), 2);
}

}  // namespace glissade
