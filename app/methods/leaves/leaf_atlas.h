#pragma once

#include "app/methods/leaves/atlas_channels.h"
#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_cutout.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::leaf {

// Damage of each leaf of an atlas, as in `tractus leaves paint`: counts for larvae and mines,
// shares from 0 to 1 for the rest.
struct AtlasDamage {
    int larvae = 0;
    double spots = 0;
    double mildew = 0;
    int mines = 0;
    double dead = 0;
    bool is_skeleton = false;
};

struct AtlasOptions {
    std::vector<std::string> leaves {}; // Grammars, as load_leaf_grammar() accepts them.
    int count = 16;                     // Number of leaves of each kind.
    // Side of a leaf's square cell in pixels; a power of two, as is the side of a page.
    int cell = 512;
    int page = 2048;
    // Range of the leaves' ages, 0 to 1, over which they spread evenly. A leaf's age does not
    // depend on how many leaves there are.
    double age_from = 0.5;
    double age_to = 0.5;
    std::uint64_t seed = 1;
    double variation = 1;
    std::optional<int> steps {};
    AtlasDamage damage {};
    AtlasChannels channels {}; // Maps for the engine; one of atlas_channels().
    // Whether mipmap levels of each map are written as well, each half as wide as the level before
    // it.
    enum class Mips { None, Files } mips = Mips::None;
};

struct AtlasSummary {
    std::size_t leaves = 0;
    std::size_t pages = 0;
};

// Writes pages of leaves for game engines into `folder`, which is created: page-0-color.png and so
// on, page-0.glb with a flat mesh around each leaf, and leaves.json with the position of each leaf.
// The petiole's end is at the bottom centre of each cell; at least max(8, cell / 32) pixels around
// each leaf are empty. Pages are made one after another; the output does not depend on the number
// of threads. Fails with a user error if a grammar cannot be read or a leaf has no extent, and like
// write_file().
Result<AtlasSummary> write_atlas(AtlasOptions const& options, std::filesystem::path const& folder);

} // namespace tractus::leaf
