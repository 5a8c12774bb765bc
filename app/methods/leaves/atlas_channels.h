#pragma once

#include "engine/methods/leaves/leaf_mips.h"
#include "engine/methods/leaves/leaf_paint.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::leaf {

// Content of one channel of a map, 0 to 1 unless noted otherwise.
enum class AtlasChannel : std::uint8_t {
    Zero,
    Red, // Red, green and blue are sRGB.
    Green,
    Blue,
    Alpha,
    NormalX, // Normals are in -1 to 1.
    NormalUp,
    NormalDown, // The normal's up component, negated as DirectX expects it.
    NormalZ,
    Occlusion, // Ambient occlusion; 1: fully lit.
    Roughness,
    Smoothness, // Smoothness as 1 - roughness.
    Translucency,
    Thickness, // Thickness as 1 - translucency.
    BackRed,   // Colour times translucency: light that comes through from behind.
    BackGreen,
    BackBlue,
    UnderRed, // Channels named Under… belong to the underside.
    UnderGreen,
    UnderBlue,
    UnderX,
    UnderUp,
    UnderDown,
    UnderZ,
};

struct AtlasMap {
    std::string name; // Becomes part of the file name: page-0-NAME.png.
    leaf::PageKind kind = leaf::PageKind::Plain;
    std::vector<AtlasChannel> channels {};
};

// The maps that a game engine expects, and the content of their channels.
struct AtlasChannels {
    std::string engine;
    std::vector<AtlasMap> maps;
    // True if the maps color, normal and orm suit glTF's materials, so that a .glb may contain
    // them.
    bool is_gltf = false;
};

// The supported engines: gltf, unreal, unity, godot, in this order.
std::span<AtlasChannels const> atlas_channels();

// Draws a leaf's picture into a cell of a page, with the map's channels.
void place_in_cell(AtlasMap const& map, leaf::LeafPicture const& picture, leaf::CellPage& page,
                   std::size_t cell);

} // namespace tractus::leaf
