#pragma once

/// Every tolerance of the engine, with its scale and its reason. Lengths are multiples of the object's radius r
/// (largest distance of a point of the object from its reference point), so that objects of all sizes behave alike.
namespace glissade::tolerance {

/// Contact samples keep this gap to the surface they slide on: large enough for conservative advancement (steps of
/// clearance / speed), small enough to look like contact. 1.5 mm on the L of environment 1.
inline constexpr double kContactGap = 1e-3;

/// Clearance that every delivered motion is proved to keep, unless the user asks for more.
/// 15 micrometres on the L: above the error of double distances (1e-9 relative), below any gap.
inline constexpr double kRequiredClearance = 1e-5;

/// Distance that the reference point of the object keeps from every box of a forbidden place. The boxes are closed:
/// their faces, edges and corners are forbidden. It is as large as the required clearance, for the same reasons.
inline constexpr double kForbiddenMargin = 1e-5;

/// Cosine of 30 degrees, rounded down. Directions within this angle of a forbidden direction of a part are forbidden.
inline constexpr double kForbiddenCone = 0.866;

/// Largest turn of a piece of a motion, radians, for determining the direction in which a part moves.
inline constexpr double kMotionPiece = 0.05;

/// Distance within which parts touch, as a share of the radius of the part that leaves. It is larger than the gaps that
/// CAD systems and triangles leave between coincident faces. Parts whose convex hulls are farther apart are clear of
/// each other.
inline constexpr double kTouching = 1e-3;

/// Sampling step of edges while trees grow, in the metric: the paper's software used 0.05 m on the L. Penetrations of a
/// few millimetres may remain; the delivered path is certified, and an edge that cannot be certified is dropped. A
/// parameter sets finer steps; on environment 1 they cost more nodes.
inline constexpr double kGrowthStep = 0.0325;

/// A blocked extension ends at a multiple of this step, as the paper's ends at one of its validation step. Ending at
/// the last free sample leaves nodes in near contact with obstacles, from which no extension grows: on environment 1
/// that multiplies the nodes needed by more than four. For the operator's samples it is the paper's step (0.05 m on the
/// L); for random ones, which lead anywhere, a step three times as large escapes traps more often.
inline constexpr double kGuidedExtensionStep = 0.0325;
inline constexpr double kRandomExtensionStep = 0.1;

/// Distance within which a node replaces the configuration to which it was to be extended.
inline constexpr double kSameConfiguration = 1e-3;

/// Distance within which two operator or contact samples are one, because an operator who rests must not fill the
/// roadmap.
inline constexpr double kDuplicate = 0.02;

/// Largest deviation of a quaternion's norm from one in a file, absolute; a larger one is refused.
inline constexpr double kQuaternionNorm = 1e-3;

}  // namespace glissade::tolerance
