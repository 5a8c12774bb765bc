#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/plant/cut_leaf.h"
#include "engine/plant/material.h"
#include "engine/plant/organ_shape.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Which grown leaves a view asks for. Growing them is others' work: the include reader gives them
// by name, like any file that a model names, so a session holds the leaves that it was made with.
struct LeafOrder {
    std::string grammar {}; // A grammar's name, or a file's in the model's folder.
    int variants = 16;      // 1 to 64.
    double age = 0.5;       // 0 bud, 0.35 to 0.65 grown up, 1 old.
    double spread = 0;      // Standard deviation of the leaves' ages; 0: all have that age.

    bool operator==(LeafOrder const&) const = default;
};

// The age of one leaf of an order: the same for a number, whatever the order's age, at the same
// distance from it, but for the ends of a leaf's life.
double leaf_age(LeafOrder const& order, int number);

// Names such a sheet: "GRAMMAR VARIANTS AGE.leaf-sheet" or "GRAMMAR VARIANTS AGE
// SPREAD.leaf-sheet".
std::string leaf_sheet_name(LeafOrder const& order);

// Returns what was ordered by that name; no value where it is none of a sheet.
std::optional<LeafOrder> parse_leaf_sheet_name(std::string_view name);

// Grown leaves as plain data: flat shapes, and one page with all their pictures.
struct LeafSheet {
    std::vector<std::shared_ptr<CutLeaf const>> leaves;
    Vec3f mean_color { 0.3f, 0.45f, 0.2f }; // sRGB, of the page where leaves are.
    TextureSlot color;                      // sRGB and alpha. Never null, nor is the next one.
    TextureSlot normal;                     // As glTF has them.
};

// A page of a sheet from the bytes of a PNG file.
TextureSlot leaf_page(std::string png);

// What the material of a sheet's leaves shows.
MaterialTextures leaf_textures(LeafSheet const& sheet);

// An organ's shape with a leaf of a sheet in its place, whose blade is as long as its own.
OrganShape leaf_shape(OrganShape const& organ, std::shared_ptr<CutLeaf const> leaf);

// The sheet as a text, pictures in base 64, and back. Parsing fails, as the user's fault, with
// "FILE:LINE: …"; what a sheet says of its sizes is not believed. A leaf has at most 64 corners.
std::string print_leaf_sheet(LeafSheet const& sheet);
Result<LeafSheet> parse_leaf_sheet(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
