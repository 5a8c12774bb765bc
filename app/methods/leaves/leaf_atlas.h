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

// Damage to each leaf of an atlas, as tractus leaves paint has it: numbers of larvae and mines,
// shares of 0 to 1 for the rest.
struct AtlasDamage {
    int larvae = 0;
    double spots = 0;
    double mildew = 0;
    int mines = 0;
    double dead = 0;
    bool is_skeleton = false;
};

struct AtlasOptions {
    std::vector<std::string> leaves {}; // Grammars, as load_leaf_grammar() takes them.
    int count = 16;                     // Number of each.
    int cell = 512;                     // A leaf's square in pixels, and a page's: powers of two.
    int page = 2048;
    // Ages, 0 to 1, lie evenly between the two; a leaf's does not depend on how many there are.
    double age_from = 0.5;
    double age_to = 0.5;
    std::uint64_t seed = 1;
    double variation = 1;
    std::optional<int> steps {};
    AtlasDamage damage {};
    AtlasChannels channels {}; // One of atlas_channels().
    // Whether smaller pictures of each map are written, too, each half as wide.
    enum class Mips { None, Files } mips = Mips::None;
};

struct AtlasSummary {
    std::size_t leaves = 0;
    std::size_t pages = 0;
};

// Writes pages of leaves for game engines into a folder, which is made: page-0-color.png and so on,
// page-0.glb with a flat shape round each leaf, and leaves.json, which says what lies where. The
// stalk's end is below, in the middle of each cell; at least max(8, cell / 32) pixels round each
// leaf are empty. Pages are made one after another; any number of threads writes the same bytes.
// Fails, as the user's fault, where a grammar cannot be read or a leaf has no extent, and like
// write_file().
Result<AtlasSummary> write_atlas(AtlasOptions const& options, std::filesystem::path const& folder);

} // namespace tractus::leaf
