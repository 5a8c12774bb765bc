#pragma once

#include "app/methods/leaves/atlas_channels.h"
#include "app/methods/leaves/atlas_shape.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::leaf {

// Damage of each leaf of an atlas, as for `tractus leaves paint`: numbers of larvae and mines, and
// shares from 0 to 1 for the other kinds of damage.
struct AtlasDamage {
    int larvae = 0;
    double spots = 0;
    double mildew = 0;
    int mines = 0;
    double dead = 0;
    bool is_skeleton = false;
};

struct AtlasOptions {
    std::vector<std::string> leaves {}; // Names or files of grammars (load_leaf_grammar()).
    int count = 16;                     // Number of leaves for each grammar.
    // Sides in pixels of a leaf's square cell and of a square page; both are powers of two.
    int cell = 512;
    int page = 2048;
    // Range of the leaves' ages, 0 to 1. The ages are spread evenly over the range; a leaf's age
    // does not depend on the number of leaves.
    double age_from = 0.5;
    double age_to = 0.5;
    std::uint64_t seed = 1;
    double variation = 1;
    std::optional<int> steps {};
    AtlasDamage damage {};
    AtlasChannels channels {}; // Maps for a game engine: one of atlas_channels().
    // Whether mipmap levels of each map are written too, each half as wide as the level before.
    enum class Mips { None, Files } mips = Mips::None;
    AtlasGeometry geometry = AtlasGeometry::Cut;
};

struct AtlasSummary {
    std::size_t leaves = 0;
    std::size_t pages = 0;
};

// Writes pages of leaves for game engines into `folder`, which is created: page-0-color.png and so
// on, page-0.glb with a mesh of each leaf, and leaves.json with the position of each leaf.
// The petiole's end is at the bottom centre of each cell; at least max(8, cell / 32) pixels around
// each leaf are empty. Pages are made one after another. The output does not depend on the number
// of threads. Fails with a user error if a grammar cannot be read, a leaf has no extent, or a file
// cannot be written.
Result<AtlasSummary> write_atlas(AtlasOptions const& options, std::filesystem::path const& folder);

} // namespace tractus::leaf
