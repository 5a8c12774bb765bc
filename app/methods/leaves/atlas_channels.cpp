#include "app/methods/leaves/atlas_channels.h"

#include <functional>

namespace tractus::leaf {

namespace {

using leaf::LeafPicture;
using leaf::PageKind;
using enum AtlasChannel;

AtlasMap const kColorMap { "color", PageKind::Color, { Red, Green, Blue, Alpha } };
AtlasMap const kNormalMap { "normal", PageKind::Normal, { NormalX, NormalUp, NormalZ } };
AtlasMap const kNormalDownMap { "normal", PageKind::Normal, { NormalX, NormalDown, NormalZ } };
AtlasMap const kOrmMap { "orm", PageKind::Plain, { Occlusion, Roughness, Zero } };
AtlasMap const kUnderColorMap { "under-color",
                                PageKind::Color,
                                { UnderRed, UnderGreen, UnderBlue } };
AtlasMap const kUnderNormalMap { "under-normal", PageKind::Normal, { UnderX, UnderUp, UnderZ } };
AtlasMap const kUnderNormalDownMap { "under-normal",
                                     PageKind::Normal,
                                     { UnderX, UnderDown, UnderZ } };

std::vector<AtlasChannels> const& table()
{
    static std::vector<AtlasChannels> const made {
        { "gltf",
          { kColorMap,
            kNormalMap,
            kOrmMap,
            { "translucency", PageKind::Plain, { Translucency } },
            kUnderColorMap,
            kUnderNormalMap },
          true },
        // Unreal: a single map has the factors of a foliage material: occlusion, roughness and
        // subsurface.
        { "unreal",
          { kColorMap,
            kNormalDownMap,
            { "ort", PageKind::Plain, { Occlusion, Roughness, Translucency } },
            kUnderColorMap,
            kUnderNormalDownMap } },
        // Unity: a mask map (metallic, occlusion, detail, smoothness) and a thickness map.
        { "unity",
          { kColorMap,
            kNormalMap,
            { "mask", PageKind::Plain, { Zero, Occlusion, Zero, Smoothness } },
            { "thickness", PageKind::Plain, { Thickness } },
            kUnderColorMap,
            kUnderNormalMap } },
        { "godot",
          { kColorMap,
            kNormalMap,
            kOrmMap,
            { "backlight", PageKind::Color, { BackRed, BackGreen, BackBlue } },
            kUnderColorMap,
            kUnderNormalMap },
          true },
    };
    return made;
}

std::uint8_t times(std::uint8_t a, std::uint8_t b)
{
    return static_cast<std::uint8_t>((int(a) * int(b) + 127) / 255);
}

std::uint8_t inverse(std::uint8_t value)
{
    return static_cast<std::uint8_t>(255 - value);
}

std::uint8_t value_of(AtlasChannel channel, LeafPicture const& p, std::size_t i)
{
    switch (channel) {
    case Zero:
        return 0;
    case Red:
    case Green:
    case Blue:
    case Alpha:
        return p.color[i][static_cast<std::size_t>(channel) - static_cast<std::size_t>(Red)];
    case NormalX:
        return p.normal[i][0];
    case NormalUp:
        return p.normal[i][1];
    case NormalDown:
        return inverse(p.normal[i][1]);
    case NormalZ:
        return p.normal[i][2];
    case Occlusion:
        return p.roughness[i][0];
    case Roughness:
        return p.roughness[i][1];
    case Smoothness:
        return inverse(p.roughness[i][1]);
    case Translucency:
        return p.translucency[i];
    case Thickness:
        return inverse(p.translucency[i]);
    case BackRed:
    case BackGreen:
    case BackBlue:
        return times(
            p.color[i][static_cast<std::size_t>(channel) - static_cast<std::size_t>(BackRed)],
            p.translucency[i]);
    case UnderRed:
    case UnderGreen:
    case UnderBlue:
        return p
            .under_color[i][static_cast<std::size_t>(channel) - static_cast<std::size_t>(UnderRed)];
    case UnderX:
        return p.under_normal[i][0];
    case UnderUp:
        return p.under_normal[i][1];
    case UnderDown:
        return inverse(p.under_normal[i][1]);
    case UnderZ:
        return p.under_normal[i][2];
    }
    return 0;
}

} // namespace

std::span<AtlasChannels const> atlas_channels()
{
    return table();
}

void place_in_cell(AtlasMap const& map, leaf::LeafPicture const& picture, leaf::CellPage& page,
                   std::size_t cell)
{
    auto const width = static_cast<std::size_t>(page.cell);
    auto const side = static_cast<std::size_t>(page.side);
    auto const columns = side / width;
    auto const channels = map.channels.size();
    for (std::size_t y = 0; y < width; ++y) {
        auto* to = page.pixels.data()
            + channels * ((cell / columns * width + y) * side + cell % columns * width);
        for (std::size_t x = 0; x < width; ++x)
            for (auto const channel : map.channels)
                *to++ = value_of(channel, picture, y * width + x);
    }
}

} // namespace tractus::leaf
