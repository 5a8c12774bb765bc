#include "app/methods/leaves/atlas_channels.h"

#include <array>
#include <vector>

namespace tractus::leaf {

namespace {

using leaf::LeafPicture;
using enum AtlasChannel;

AtlasMap const kColorMap { "color", MapKind::Color, { Red, Green, Blue, Alpha } };
AtlasMap const kNormalMap { "normal", MapKind::Normal, { NormalX, NormalUp, NormalZ } };
AtlasMap const kNormalDownMap { "normal", MapKind::Normal, { NormalX, NormalDown, NormalZ } };
AtlasMap const kOrmMap { "orm", MapKind::Plain, { Occlusion, Roughness, Zero } };
AtlasMap const kUnderColorMap { "under-color",
                                MapKind::Color,
                                { UnderRed, UnderGreen, UnderBlue } };
AtlasMap const kUnderNormalMap { "under-normal", MapKind::Normal, { UnderX, UnderUp, UnderZ } };
AtlasMap const kUnderNormalDownMap { "under-normal",
                                     MapKind::Normal,
                                     { UnderX, UnderDown, UnderZ } };

std::vector<AtlasChannels> const& table()
{
    static std::vector<AtlasChannels> const made {
        { "gltf",
          { kColorMap,
            kNormalMap,
            kOrmMap,
            { "translucency", MapKind::Plain, { Translucency } },
            kUnderColorMap,
            kUnderNormalMap },
          true },
        // Unreal: a single map has the factors of a foliage material: occlusion, roughness and
        // subsurface.
        { "unreal",
          { kColorMap,
            kNormalDownMap,
            { "ort", MapKind::Plain, { Occlusion, Roughness, Translucency } },
            kUnderColorMap,
            kUnderNormalDownMap } },
        // Unity: a mask map (metallic, occlusion, detail, smoothness) and a thickness map.
        { "unity",
          { kColorMap,
            kNormalMap,
            { "mask", MapKind::Plain, { Zero, Occlusion, Zero, Smoothness } },
            { "thickness", MapKind::Plain, { Thickness } },
            kUnderColorMap,
            kUnderNormalMap } },
        { "godot",
          { kColorMap,
            kNormalMap,
            kOrmMap,
            { "backlight", MapKind::Color, { BackRed, BackGreen, BackBlue } },
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

// The values of a channel in a leaf's picture: every `step`-th byte from `first` on.
struct ChannelSource {
    std::uint8_t const* first = nullptr;
    std::size_t step = 0;
    // All bits are set for a channel that stores 255 minus the picture's value.
    std::uint8_t flipped = 0;
    std::uint8_t const* times = nullptr; // Values to multiply by, one per pixel.
};

template<std::size_t N>
ChannelSource source_in(std::vector<std::array<std::uint8_t, N>> const& map, AtlasChannel channel,
                        AtlasChannel first)
{
    return { map.front().data()
                 + (static_cast<std::size_t>(channel) - static_cast<std::size_t>(first)),
             N };
}

ChannelSource flipped(ChannelSource source)
{
    source.flipped = 0xff;
    return source;
}

ChannelSource source_of(AtlasChannel channel, LeafPicture const& p)
{
    static constexpr std::uint8_t kZero = 0;
    switch (channel) {
    case Zero:
        break;
    case Red:
    case Green:
    case Blue:
    case Alpha:
        return source_in(p.color, channel, Red);
    case NormalX:
        return { p.normal.front().data(), 3 };
    case NormalUp:
        return { p.normal.front().data() + 1, 3 };
    case NormalDown:
        return flipped({ p.normal.front().data() + 1, 3 });
    case NormalZ:
        return { p.normal.front().data() + 2, 3 };
    case Occlusion:
    case Roughness:
        return source_in(p.roughness, channel, Occlusion);
    case Smoothness:
        return flipped(source_in(p.roughness, Roughness, Occlusion));
    case Translucency:
        return { p.translucency.data(), 1 };
    case Thickness:
        return flipped({ p.translucency.data(), 1 });
    case BackRed:
    case BackGreen:
    case BackBlue: {
        auto source = source_in(p.color, channel, BackRed);
        source.times = p.translucency.data();
        return source;
    }
    case UnderRed:
    case UnderGreen:
    case UnderBlue:
        return source_in(p.under_color, channel, UnderRed);
    case UnderX:
        return { p.under_normal.front().data(), 3 };
    case UnderUp:
        return { p.under_normal.front().data() + 1, 3 };
    case UnderDown:
        return flipped({ p.under_normal.front().data() + 1, 3 });
    case UnderZ:
        return { p.under_normal.front().data() + 2, 3 };
    }
    return { &kZero, 0 };
}

} // namespace

std::span<AtlasChannels const> atlas_channels()
{
    return table();
}

void place_picture(AtlasMap const& map, leaf::LeafPicture const& picture, std::uint8_t* to,
                   std::size_t row_bytes)
{
    auto const width = static_cast<std::size_t>(picture.side);
    auto const channels = map.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        auto const source = source_of(map.channels[c], picture);
        for (std::size_t y = 0; y < width; ++y) {
            auto const* const from = source.first + y * width * source.step;
            auto* const row = to + y * row_bytes + c;
            if (source.times)
                for (std::size_t x = 0; x < width; ++x)
                    row[x * channels] = times(from[x * source.step], source.times[y * width + x]);
            else
                for (std::size_t x = 0; x < width; ++x)
                    row[x * channels]
                        = static_cast<std::uint8_t>(from[x * source.step] ^ source.flipped);
        }
    }
}

} // namespace tractus::leaf
