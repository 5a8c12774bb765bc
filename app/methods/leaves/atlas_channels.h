#pragma once

#include "engine/methods/leaves/leaf_mips.h"
#include "engine/methods/leaves/leaf_paint.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::leaf {

// Contents of one channel of a map, 0 to 1 unless it says otherwise.
enum class AtlasChannel : std::uint8_t {
    Zero,
    Red, // sRGB.
    Green,
    Blue,
    Alpha,
    NormalX, // -1 to 1.
    NormalUp,
    NormalDown, // NormalUp turned round, as DirectX takes it.
    NormalZ,
    Occlusion, // 1: nothing keeps light away.
    Roughness,
    Smoothness, // 1 - roughness.
    Translucency,
    Thickness, // 1 - translucency.
    BackRed,   // Colour times translucency: light from behind.
    BackGreen,
    BackBlue,
    UnderRed, // Red of the underside.
    UnderGreen,
    UnderBlue,
    UnderX,
    UnderUp,
    UnderDown,
    UnderZ,
};

struct AtlasMap {
    std::string name; // NAME in the file's: page-0-NAME.png.
    leaf::PageKind kind = leaf::PageKind::Plain;
    std::vector<AtlasChannel> channels {};
};

// Maps that an engine takes, and what it wants in which channel.
struct AtlasChannels {
    std::string engine;
    std::vector<AtlasMap> maps;
    // Whether color, normal and orm are what glTF's materials take, so that a .glb may have them.
    bool is_gltf = false;
};

// glTF's first: gltf, unreal, unity, godot.
std::span<AtlasChannels const> atlas_channels();

// Puts a leaf's picture into a cell of a page that has the map's channels.
void place_in_cell(AtlasMap const& map, leaf::LeafPicture const& picture, leaf::CellPage& page,
                   std::size_t cell);

} // namespace tractus::leaf
