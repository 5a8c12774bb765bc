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

// The grown leaves that a view requests. They are grown elsewhere: the include reader provides them
// by name, like any file that a model names, so a session stores the leaves with which it was made.
struct LeafOrder {
    std::string grammar {}; // Name of a grammar, or of a file in the model's folder.
    int variants = 16;      // Number of different leaves, 1 to 64.
    double age = 0.5;       // Age: 0 bud, 0.35 to 0.65 adult, 1 old.
    double spread = 0;      // Standard deviation of the leaves' ages; 0: all have the same age.

    bool operator==(LeafOrder const&) const = default;
};

// Returns the age of leaf `number`. Its difference from the order's age depends on the number and
// the spread only, except near the ends of a leaf's life.
double leaf_age(LeafOrder const& order, int number);

// Formats the name of a sheet: "GRAMMAR VARIANTS AGE.leaf-sheet" or "GRAMMAR VARIANTS AGE
// SPREAD.leaf-sheet".
std::string leaf_sheet_name(LeafOrder const& order);

// Parses the name of a sheet; no value if it is not one.
std::optional<LeafOrder> parse_leaf_sheet_name(std::string_view name);

// Grown leaves as plain data: flat shapes, and one texture page with all their pictures.
struct LeafSheet {
    std::vector<std::shared_ptr<CutLeaf const>> leaves;
    Vec3f mean_color { 0.3f, 0.45f, 0.2f }; // Mean sRGB colour of the leaves on the page.
    TextureSlot color;  // Page with sRGB colour and alpha. This slot and `normal` are never null.
    TextureSlot normal; // Page with normals, as in glTF.
};

// Makes a texture page from the bytes of a PNG file.
TextureSlot leaf_page(std::string png);

// Returns the textures for the material of a sheet's leaves.
MaterialTextures leaf_textures(LeafSheet const& sheet);

// Replaces an organ's shape by a leaf of a sheet, scaled to the organ's blade length.
OrganShape leaf_shape(OrganShape const& organ, std::shared_ptr<CutLeaf const> leaf);

// Formats a sheet as text, with pictures in base 64, and parses it. Parsing fails with a user error
// of the form "FILE:LINE: ..."; sizes given in the text are not trusted. A leaf has at most 64
// corners.
std::string print_leaf_sheet(LeafSheet const& sheet);
Result<LeafSheet> parse_leaf_sheet(std::string const& name, std::string_view text);

} // namespace tractus::lsystem
