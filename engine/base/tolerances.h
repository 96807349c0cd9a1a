#pragma once

/// Every tolerance of the engine, with its scale and its reason. Lengths are multiples of the
/// object's radius r (largest distance of a point of the object from its reference point), so that
/// a watch and a ship behave alike.
namespace glissade::tolerance {

/// Contact samples keep this gap to the surface they slide on: large enough that conservative
/// advancement (steps of clearance / speed) gets through, small enough to look like contact.
/// 1.5 mm on the L of environment 1.
inline constexpr double kContactGap = 1e-3;

/// Clearance that every delivered motion is proved to keep, unless the user asks for more.
/// 15 micrometres on the L: above the error of double distances (1e-9 relative), below any gap.
inline constexpr double kRequiredClearance = 1e-5;

/// The reference point of the object stays farther than this outside of every box of a forbidden place. The boxes are
/// closed: their faces, edges and corners are forbidden. As large as the required clearance, for the same reasons.
inline constexpr double kForbiddenMargin = 1e-5;

/// Cosine of 30 degrees, rounded down: what is so near to a forbidden direction of a part, or nearer, is forbidden.
inline constexpr double kForbiddenCone = 0.866;

/// A motion is taken in pieces that turn by this at most, radians, to see in which direction a part moves.
inline constexpr double kMotionPiece = 0.05;

/// Parts nearer than this to each other touch, as a share of the radius of the one that leaves: above what CAD systems
/// and triangles leave between faces that lie in each other. Convex hulls farther apart are clear of each other.
inline constexpr double kTouching = 1e-3;

/// Sampling step of edges while trees grow, in the metric: the paper's software used 0.05 m on the
/// L. It lets penetrations of a few millimetres through; what is delivered is certified, and an edge
/// that cannot be is dropped. Finer steps are a parameter away; on environment 1 they cost more nodes.
inline constexpr double kGrowthStep = 0.0325;

/// A blocked extension ends at a multiple of this step, as the paper's ends at one of its validation
/// step. Ending at the very last free sample leaves nodes pressed against obstacles, from where
/// nothing grows: on environment 1 that multiplies the nodes needed by more than four. For the
/// operator's samples it is the paper's step (0.05 m on the L); for random ones, which lead anywhere,
/// standing three times farther off escapes traps more often.
inline constexpr double kGuidedExtensionStep = 0.0325;
inline constexpr double kRandomExtensionStep = 0.1;

/// Nearer than this a node stands for the configuration that it was to be extended to.
inline constexpr double kSameConfiguration = 1e-3;

/// Two operator or contact samples nearer than this are one: an operator who rests must not flood
/// the roadmap.
inline constexpr double kDuplicate = 0.02;

/// A unit quaternion read from a file may be off by this much before it is refused (absolute).
inline constexpr double kQuaternionNorm = 1e-3;

}  // namespace glissade::tolerance
