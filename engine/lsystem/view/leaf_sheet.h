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

// The grown leaves that a view requests. They are not grown here: the include reader provides them
// by name, like any file that a model names. A session thus stores the leaves with which it was
// made.
struct LeafOrder {
    std::string grammar {}; // Name of a leaf grammar, or of a file in the model's folder.
    int variants = 16;      // Number of different leaves, 1 to 64.
    double age = 0.5;       // Age of the leaves: 0 bud, 0.35 to 0.65 adult, 1 old.
    double spread = 0;      // Standard deviation of the leaves' ages; 0: all have the same age.

    bool operator==(LeafOrder const&) const = default;
};

// Returns the age of leaf `number` of an order. The difference from the order's age depends only on
// the number and the spread, except near the ends of a leaf's life.
double leaf_age(LeafOrder const& order, int number);

// Returns the name of the sheet for an order: "GRAMMAR VARIANTS AGE.leaf-sheet" or, with a spread,
// "GRAMMAR VARIANTS AGE SPREAD.leaf-sheet".
std::string leaf_sheet_name(LeafOrder const& order);

// Parses the name of a sheet; no value if the text is not such a name.
std::optional<LeafOrder> parse_leaf_sheet_name(std::string_view name);

// Grown leaves as plain data: flat shapes, and a texture page with the pictures of all leaves.
struct LeafSheet {
    std::vector<std::shared_ptr<CutLeaf const>> leaves;
    Vec3f mean_color { 0.3f, 0.45f, 0.2f }; // Mean sRGB colour of the leaves on the page.
    TextureSlot color;  // Page with sRGB colour and alpha; like `normal`, never null.
    TextureSlot normal; // Page with normals, as glTF stores them.
};

// Makes a texture page from the bytes of a PNG file.
TextureSlot leaf_page(std::string png);

// Returns the textures of the material for a sheet's leaves.
MaterialTextures leaf_textures(LeafSheet const& sheet);

// Returns the shape of an organ with its blade replaced by a leaf of a sheet, scaled to the length
// of that blade.
OrganShape leaf_shape(OrganShape const& organ, std::shared_ptr<CutLeaf const> leaf);

// Formats a sheet as text, with pictures in base 64, and parses such a text. Parsing fails with a
// user error of the form "FILE:LINE: ..."; sizes that the text gives are not trusted. A leaf has at
// most 64 corners.
std::string print_leaf_sheet(LeafSheet const& sheet);
Result<LeafSheet> parse_leaf_sheet(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
