#pragma once

#include "engine/base/mips.h"
#include "engine/methods/leaves/leaf_paint.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::leaf {

// Content of one channel of a leaf map. Values are in 0 to 1 unless noted otherwise.
enum class AtlasChannel : std::uint8_t {
    Zero,
    Red, // Red, green and blue are in sRGB.
    Green,
    Blue,
    Alpha,
    NormalX, // The components of normals are in -1 to 1.
    NormalUp,
    NormalDown, // The normal's up component with opposite sign, as DirectX expects it.
    NormalZ,
    Occlusion, // Ambient occlusion; 1 is fully lit.
    Roughness,
    Smoothness, // 1 - roughness.
    Translucency,
    Thickness, // 1 - translucency.
    BackRed,   // Colour times translucency: the light that comes through from behind.
    BackGreen,
    BackBlue,
    UnderRed, // Channels named Under… show the leaf's underside.
    UnderGreen,
    UnderBlue,
    UnderX,
    UnderUp,
    UnderDown,
    UnderZ,
};

struct AtlasMap {
    std::string name; // Name of the map in file names: page-0-NAME.png.
    MapKind kind = MapKind::Plain;
    std::vector<AtlasChannel> channels {};
};

// The maps that a game engine expects, with the contents of their channels.
struct AtlasChannels {
    std::string engine;
    std::vector<AtlasMap> maps;
    // True if the maps "color", "normal" and "orm" suit glTF's materials, so that a .glb file may
    // contain them.
    bool is_gltf = false;
};

// The supported engines: gltf, unreal, unity, godot, in this order.
std::span<AtlasChannels const> atlas_channels();

// Copies a leaf's picture to a part of a page, in the channels that the map has. `to` is the part's
// first pixel, and `row_bytes` the size of a row of the page.
void place_picture(AtlasMap const& map, leaf::LeafPicture const& picture, std::uint8_t* to,
                   std::size_t row_bytes);

} // namespace tractus::leaf
