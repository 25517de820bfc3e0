// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace kushi {

/// A kind of table of the style file and the keys it may have.
struct TableKeys {
    std::string_view label;  ///< as problems name it
    std::array<std::string_view, 28> slots;

    constexpr std::span<const std::string_view> keys() const {
        std::size_t size = 0;
        while (size < slots.size() && !slots[size].empty())
            ++size;
        return std::span(slots).first(size);
    }
};

namespace tables {

inline constexpr TableKeys top = {
    "the style",
    {"kushi", "name", "seed", "gravity", "head", "collider", "contact", "solver", "part", "scalp",
     "groom", "hair", "force", "cut", "tie", "highlight"}};
inline constexpr TableKeys head = {
    "[head]",
    {"mesh", "unit", "up", "front", "origin", "offset", "landmarks", "collide", "gap", "friction"}};
inline constexpr TableKeys landmarks = {
    "landmarks",
    {"crown", "hairline", "brows", "eyes", "ears", "nose", "lips", "nape", "chin", "shoulders"}};
inline constexpr TableKeys collider = {
    "[[collider]]", {"mesh", "unit", "up", "front", "origin", "offset", "gap", "friction"}};
inline constexpr TableKeys contact = {"[contact]", {"layers", "packing"}};
inline constexpr TableKeys solver = {"[solver]",
                                     {"method", "segments", "grading", "avoidance_steps"}};
inline constexpr TableKeys part = {
    "[[part]]", {"name", "scalp", "groom", "hair", "force", "cut", "tie", "highlight"}};
inline constexpr TableKeys scalp = {
    "[part.scalp]",
    {"ellipsoid", "spacing", "count", "jitter", "regions", "edge", "surface", "groups", "mask"}};
inline constexpr TableKeys ellipsoid = {"ellipsoid", {"center", "semi_axes", "rotate_z"}};
inline constexpr TableKeys regions = {"regions", {"where", "theta", "phi"}};
inline constexpr TableKeys groom = {"groom", {"file", "unit", "up", "front", "offset"}};
inline constexpr TableKeys hair = {"[part.hair]",
                                   {"type",
                                    "length",
                                    "length_variation",
                                    "youngs_modulus",
                                    "diameter",
                                    "density",
                                    "flexural_rigidity",
                                    "stiffness",
                                    "growth",
                                    "color",
                                    "variation",
                                    "shear_modulus",
                                    "taper",
                                    "curl",
                                    "wave",
                                    "set",
                                    "lift",
                                    "towards",
                                    "whorl",
                                    "clump",
                                    "flyaway",
                                    "grey",
                                    "regrowth",
                                    "tips"}};
inline constexpr TableKeys clump = {"clump", {"amount", "size", "variation", "from"}};
inline constexpr TableKeys flyaway = {"flyaway", {"share", "distance"}};
inline constexpr TableKeys whorl = {"whorl", {"theta", "phi", "turn"}};
inline constexpr TableKeys curl = {"curl", {"radius", "pitch", "variation"}};
inline constexpr TableKeys wave = {"wave", {"amplitude", "length", "variation"}};
inline constexpr TableKeys color = {"color", {"melanin", "redness"}};
inline constexpr TableKeys grey = {"grey", {"share", "color"}};
inline constexpr TableKeys regrowth = {"regrowth", {"color", "length", "blend"}};
inline constexpr TableKeys tips = {"tips", {"color", "length", "blend"}};
inline constexpr TableKeys highlight = {"[[part.highlight]]",
                                        {"roots", "color", "share", "foil", "from", "to", "blend"}};
inline constexpr TableKeys force = {"[[part.force]]",
                                    {"roots", "within", "direction", "magnitude", "falloff"}};
inline constexpr TableKeys cut = {"[[part.cut]]", {"roots", "below", "keep", "mode", "falloff"}};
inline constexpr TableKeys tie = {"[[part.tie]]", {"roots", "at", "radius", "slack"}};
inline constexpr TableKeys roots = {"roots", {"where", "theta", "phi"}};
inline constexpr TableKeys within = {"within", {"x", "y", "z"}};
inline constexpr TableKeys falloff = {"falloff", {"degrees", "cm"}};

/// Every kind of table, for "it belongs in ..." and for the test of the manual.
inline constexpr const TableKeys* all[] = {
    &top,     &head,    &landmarks, &solver, &part,     &scalp,   &ellipsoid,
    &regions, &hair,    &curl,      &wave,   &force,    &cut,     &roots,
    &within,  &falloff, &groom,     &tie,    &collider, &contact, &whorl,
    &clump,   &flyaway, &color,     &grey,   &regrowth, &tips,    &highlight};

}  // namespace tables

/// The candidate most like `name`, if it is alike enough to be meant: at most one slip (a letter
/// missing, added, wrong, or two swapped) for every three letters; empty otherwise.
std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace kushi
