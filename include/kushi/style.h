// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <kushi/color.h>
#include <kushi/ellipsoid.h>
#include <kushi/groom_io.h>
#include <kushi/mesh_io.h>
#include <kushi/result.h>

#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kushi {

// A style as the library sees it: SI units and radians, every default filled in. The document that
// people write is TOML in centimetres and degrees; docs/style-file.md lists its keys.

/// A closed range; without limits by default.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

/// Which follicles, by the angles of the part's ellipsoid [rad]; all by default.
struct RootRange {
    Range theta;  ///< within [0, pi]
    Range phi;    ///< within [-2 pi, 2 pi], spanning at most a turn; may run past pi
};

/// The follicles in any of the ranges; RootRanges(1) is all, an empty one none.
using RootRanges = std::vector<RootRange>;

/// Where in space, in world axes [m].
struct Box {
    Range x, y, z;
};

/// A place in the text of a style.
struct TextPlace {
    std::string file;
    int line = 0, column = 0;  ///< from 1; 0 if unknown
};

/// What hair grows from.
enum class ScalpSurface {
    Ellipsoid,
    Head,  ///< the style's head, to which the follicles of the ellipsoid are carried
};

/// Where hair grows (Usami & Anjyo 1992, 2.3).
struct Scalp {
    Ellipsoid ellipsoid;
    std::optional<double> spacing;  ///< m between follicles; exactly one of spacing and count
    std::optional<int> count;       ///< follicles
    double jitter = 0.5;            ///< each follicle moves by up to +-jitter/2 spacings, in [0, 1]
    RootRanges regions = RootRanges(1);
    double edge = 0;  ///< m from the regions' border inwards over which hair becomes less

    ScalpSurface surface = ScalpSurface::Ellipsoid;
    /// Of a head: names of groups, objects or materials; hair grows on their triangles only. All if
    /// empty.
    std::vector<std::string> groups;
    /// Of a head: path of a PNG over its texture coordinates, by whose brightness hair is sparser.
    std::optional<std::string> mask;
    TextPlace surfacePlace, groupsPlace, maskPlace;  ///< where the style says so
};

/// The strands of a file, which become a part as they are.
struct GroomSource {
    std::string path;  ///< for readGroom
    GroomPlacement placement;
    TextPlace place;  ///< where the style names the file
};

/// Direction in which unloaded hair leaves the scalp.
enum class Growth {
    Normal,  ///< along the ellipsoid's outward normal
    Radial,  ///< along the line from the ellipsoid's centre
};

/// Hair whose natural shape is a helix about the direction in which it grows.
struct Curl {
    double radius = 0;        ///< m, > 0
    double pitch = 0;         ///< m from turn to turn along the helix's axis, > 0
    double variation = 0.15;  ///< share by which size and phase vary from strand to strand and lock
                              ///< to lock, in [0, 0.9]
};

/// Hair whose natural shape is a plane wave about the direction in which it grows.
struct Wave {
    double amplitude = 0;     ///< m, from the middle line to a crest, > 0
    double length = 0;        ///< m from crest to crest, > 0
    double variation = 0.15;  ///< as of Curl
};

/// Hair that gathers: strands draw near to one of them, more and more towards their tips.
struct Clump {
    double amount = 0;       ///< share of the way that tips go, in [0, 0.9]; 0: none
    double size = 0.008;     ///< m between the middles of clumps at the scalp, > 0
    double variation = 0.5;  ///< share by which the amount differs from clump to clump, in [0, 1]
    double from = 0.1;       ///< share of a strand's length before which it stays, in [0, 0.9]
};

/// Single strands that stand off.
struct Flyaway {
    double share = 0;        ///< of the strands, in [0, 1]
    double distance = 0.01;  ///< m by which their tips do, about, > 0
};

/// Another colour at an end of the hair.
struct EndColor {
    Rgb color;          ///< linear
    double length = 0;  ///< m from the end, up to which there is any of it, > 0
    double blend = 0;   ///< m of these over which it fades into the hair's, in [0, length]
};

/// White strands among the others.
struct Grey {
    double share = 0;                   ///< of the strands, in [0, 1]
    Rgb color = {0.60F, 0.59F, 0.57F};  ///< linear
};

/// A fixed direction, or one that turns with the place.
struct ForceDirection {
    bool radial = false;  ///< horizontally away from the world's y axis; `vector` is not used
    Vec3d vector;         ///< unit
};

/// A place of the scalp that hair runs away from.
struct Whorl {
    EllipsoidAngles at;  ///< of the scalp's ellipsoid [rad]
    double turn = 0;     ///< by which hair runs counter-clockwise of straight away, seen from
                         ///< outside, in [-pi, pi] [rad]
};

/// What hair leans towards where it leaves the scalp.
struct Lean {
    ForceDirection direction = {false, {0, -1, 0}};
    bool reversed = false;       ///< away from that
    std::optional<Whorl> whorl;  ///< instead of a direction
};

/// What a strand is made of. Lengths, natural shapes and growth are those of hair that grows; the
/// strands of a groom bring their own.
struct Hair {
    double length = 0;                       ///< m
    double lengthVariation = 0;              ///< each strand's length varies by up to +- this share
    double youngsModulus = 3.9e9;            ///< Pa
    double diameter = 75e-6;                 ///< m
    double density = 1320;                   ///< kg/m3
    std::optional<double> flexuralRigidity;  ///< N m2; replaces the value from modulus and diameter
    double shearModulus = 0.89e9;            ///< Pa
    double stiffness = 1;                    ///< times the rigidity
    double taper = 0;          ///< share by which the tip is thinner than the root, in [0, 0.95]
    std::optional<Curl> curl;  ///< at most one of curl and wave
    std::optional<Wave> wave;
    Growth growth = Growth::Normal;
    double lift = std::numbers::pi / 2;  ///< from the surface to the direction of growth, within
                                         ///< [0, pi/2] [rad]
    Lean lean;                           ///< of hair that is lifted less
    Rgb color = {0.06F, 0.032F, 0.02F};  ///< of the hair itself; dark brown
    double set =
        1;  ///< of a groom: share of the shape in its file that stays, in [0, 1]; 0: straight
    double variation = 0.12;  ///< each strand's lightness varies by up to +- this share, in [0, 1]
    Grey grey;
    std::optional<EndColor> regrowth;  ///< at the roots
    std::optional<EndColor> tips;
    Clump clump;
    Flyaway flyaway;

    /// EI of the round section, or what replaces it, times stiffness [N m2].
    double rigidity() const;
    /// GJ of the round section: the rigidity times 2 G / E [N m2].
    double torsionalRigidity() const;
    /// Weight per unit length under the earth's gravity [N/m].
    double weightPerLength() const;
};

/// The earth's gravity [m/s2].
inline constexpr double earthGravity = 9.80665;

/// Softened edges of a force or a cut; hard where 0.
struct Falloff {
    double angle = 0;  ///< width of the ramp across each edge of the root range [rad]
    /// A force's: width of the ramp across each face of the box. A cut's: width over which the ends
    /// of the strands are spread. [m]
    double distance = 0;
};

/// An external force on some strands in some place (Usami & Anjyo 1992, 2.4, figure 7).
struct Force {
    RootRanges roots = RootRanges(1);
    Box within;
    ForceDirection direction;
    double magnitude = 1;  ///< times the hair's own weight; negative reverses
    Falloff falloff;
};

/// A band around hair: strands run close over the scalp to it, go through it, and hang from there.
/// By equilibrium only, and only of hair that grows.
struct HairTie {
    RootRanges roots = RootRanges(1);
    Vec3d at;               ///< the band's middle [m], outside the scalp's ellipsoid
    double radius = 0.008;  ///< of the band: strands go through at this distance at most [m]
    double slack = 0.03;    ///< share by which hair is longer than the shortest way to the band;
                            ///< that of a strand is between half and one and a half of it
};

enum class CutMode {
    Hide,    ///< the paper's: what lies beyond is not shown, the shape stays
    Settle,  ///< the shorter hair is bent anew
};

/// A cut (Usami & Anjyo 1992, 2.4): exactly one of `below` and `keep`.
struct Cut {
    /// Length left on strands whose root lies at height y.
    struct Keep {
        double y = 0;       ///< height of the root [m]
        double length = 0;  ///< m
    };
    RootRanges roots = RootRanges(1);
    std::optional<double> below;  ///< height [m]
    std::vector<Keep> keep;       ///< by ascending y; linear between, constant beyond the ends
    CutMode mode = CutMode::Settle;
    /// Across the edges of `roots` the cut takes less and less of what it would take; and each
    /// strand is cut higher or lower, or longer or shorter, by up to half the distance at random.
    Falloff falloff;
};

/// Strands coloured otherwise, each by itself or in foils.
struct Highlight {
    RootRanges roots = RootRanges(1);
    double share = 0.2;  ///< of the strands, in [0, 1]
    Rgb color;           ///< linear
    double foil = 0;     ///< m; strands that grow within about so much go together; 0: none do
    double from = 0;     ///< m from the root at which it begins, >= 0
    double to = std::numeric_limits<double>::infinity();  ///< m from the root at which it ends
    double blend = 0.01;  ///< m over which it comes and goes, unless it begins at the root, >= 0
};

/// A separately defined body of hair.
struct Part {
    std::string name;  ///< unique in the style, not empty
    Scalp scalp;       ///< where hair grows; of a groom only the ellipsoid counts
    /// Instead of hair that grows. The angles of a root are those of its place about the scalp's
    /// ellipsoid, which is headEllipsoid(); the ellipsoid is in no strand's way.
    std::optional<GroomSource> groom;
    Hair hair;
    std::vector<Force> forces;
    std::vector<Cut> cuts;
    std::vector<Highlight> highlights;  ///< later ones over those before
    std::vector<HairTie> ties;          ///< a strand's is the first that its root meets
};

enum class Method { Cantilever, Equilibrium };

/// How well, not what.
struct Solver {
    Method method = Method::Cantilever;
    int segments = 24;       ///< per strand, 1 to 256
    double grading = 1;      ///< node j of n lies at (j/n)^grading of the length, in [1, 3]
    int avoidanceSteps = 4;  ///< angles tried, 1 to 16
};

/// A body besides the head that hair keeps out of.
struct Collider {
    std::string mesh;         ///< "mannequin", or the path of a file for readMesh
    MeshPlacement placement;  ///< of a file; its origin is the file's own unless the style says so
    double gap = 0;           ///< by which hair stays farther off; below 0 it may sink in [m]
    double friction = 0;      ///< Coulomb's coefficient
};

/// Hair against hair.
struct Contact {
    bool layers = true;             ///< hair lies on the hair that grows below it
    std::optional<double> packing;  ///< share of space that hair may fill, in (0, 0.9]
};

struct Style {
    std::string name;
    std::uint64_t seed = 1;
    Vec3d gravity = {0, -1, 0};          ///< times the earth's
    std::string headMesh = "mannequin";  ///< or "none", or the path of a file for readMesh
    MeshPlacement headPlacement;         ///< of a head from a file
    bool headCollides = true;            ///< whether hair keeps out of the head
    double headGap = 0;                  ///< as of Collider [m]
    double headFriction = 0;             ///< as of Collider
    std::vector<Collider> colliders;     ///< in the order of the file
    Contact contact;
    Solver solver;
    std::vector<Part> parts;
};

/// Reads and validates a style; on failure every problem found, in the order of the text.
Result<Style> readStyle(const std::string& path);

/// The same for text already in memory; `file` stands in the problems, and the files of heads and
/// grooms are found from its folder.
Result<Style> parseStyle(std::string_view text, const std::string& file);

/// A value of the document, in the document's own units.
using StyleValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// The text of a style with one value set: what stood there is replaced, or the key is added at the
/// end of its table; all else (comments, order, spelling of numbers) stays byte for byte.
///
/// key  as in "solver.segments", "gravity" or, counting from 0, "part[0].force[2].magnitude"; a
///      style that keeps its one part at the top takes both "hair.length" and "part[0].hair.length"
/// A text that does not parse, a table that does not exist or a result that is not a valid style is
/// a problem.
Result<std::string> withValue(std::string_view text, std::string_view key, const StyleValue& value);

}  // namespace kushi
