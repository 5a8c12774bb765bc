#include "engine/export/bark_style.h"

namespace tractus::exports {

namespace {

// Smooth bark of a limb, with pores.
BarkStyle smooth_bark(Vec3 const& color, Vec3 const& other_color, Vec3 const& pores)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.08,
                      .wrinkles = 0.10,
                      .roughness = 0.8 };
    style.lenticels = { .cells = { 14, 22 },
                        .share = 0.45,
                        .length = 0.35,
                        .thickness = 0.16,
                        .height = 0.25,
                        .color = pores };
    style.depth = 0.004;
    return style;
}

// Bark with furrows along the axis.
BarkStyle ridged_bark(Vec3 const& color, Vec3 const& other_color, BarkStyle::Furrows furrows,
                      double depth)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.16,
                      .wrinkles = 0.06,
                      .roughness = 0.92 };
    style.furrows = furrows;
    style.depth = depth;
    return style;
}

// Bark of thin scales.
BarkStyle scaly_bark(Vec3 const& color, Vec3 const& other_color, BarkStyle::Flakes flakes,
                     double depth)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.12,
                      .wrinkles = 0.05,
                      .roughness = 0.85 };
    style.flakes = flakes;
    style.depth = depth;
    return style;
}

BarkStyle birch_bark(BarkAge age)
{
    BarkStyle style;
    style.surface = { .color = { 0.90, 0.88, 0.84 },
                      .other_color = { 0.80, 0.75, 0.69 },
                      .grain = 0.03,
                      .wrinkles = 0.14,
                      .roughness = 0.65 };
    style.lenticels = { .cells = { 9, 46 },
                        .share = 0.42,
                        .length = 0.55,
                        .thickness = 0.17,
                        .height = 0.15,
                        .color = { 0.30, 0.25, 0.22 } };
    style.depth = 0.004;
    if (age == BarkAge::Old) {
        style.clefts
            = { .cells = { 4, 3 }, .share = 0.55, .size = 0.44, .color = { 0.16, 0.14, 0.13 } };
        style.depth = 0.022;
    }
    return style;
}

BarkStyle beech_bark(BarkAge age)
{
    auto style = smooth_bark({ 0.57, 0.57, 0.54 }, { 0.66, 0.67, 0.63 }, { 0.46, 0.45, 0.42 });
    style.surface.wrinkles = age == BarkAge::Old ? 0.13 : 0.07;
    style.surface.grain = 0.05;
    style.lenticels.share = 0.25;
    return style;
}

BarkStyle cherry_bark(BarkAge age)
{
    auto style = smooth_bark({ 0.37, 0.24, 0.20 }, { 0.45, 0.35, 0.31 }, { 0.58, 0.45, 0.36 });
    style.surface.wrinkles = 0.18;
    style.surface.roughness = 0.5;
    style.lenticels = { .cells = { 6, 20 },
                        .share = 0.75,
                        .length = 0.9,
                        .thickness = 0.18,
                        .height = 0.35,
                        .color = { 0.58, 0.45, 0.36 } };
    style.depth = 0.006;
    if (age == BarkAge::Old) {
        style.surface.color = { 0.34, 0.25, 0.22 };
        style.surface.other_color = { 0.30, 0.26, 0.24 };
        style.furrows = { .ridges = { 7, 7 },
                          .width = 0.07,
                          .bridges = 0,
                          .wander = 0.5,
                          .color = { 0.19, 0.15, 0.13 } };
        style.depth = 0.010;
    }
    return style;
}

BarkStyle pine_bark(BarkAge age)
{
    if (age == BarkAge::Young)
        return scaly_bark(
            { 0.76, 0.48, 0.28 }, { 0.69, 0.40, 0.23 },
            { .cells = { 12, 9 }, .height = 0.5, .change = 0.12, .edge = { 0.84, 0.64, 0.44 } },
            0.004);
    auto style = ridged_bark({ 0.50, 0.39, 0.32 }, { 0.56, 0.41, 0.31 },
                             { .ridges = { 9, 5 },
                               .width = 0.17,
                               .bridges = 0.15,
                               .wander = 0.35,
                               .cracks = { 27, 17 },
                               .crack_depth = 0.35,
                               .color = { 0.21, 0.14, 0.11 } },
                             0.026);
    style.flakes
        = { .cells = { 26, 18 }, .height = 0.35, .change = 0.12, .edge = { 0.43, 0.29, 0.21 } };
    return style;
}

BarkStyle plane_bark(BarkAge age)
{
    BarkStyle style;
    style.surface = { .color = { 0.50, 0.48, 0.40 },
                      .other_color = { 0.43, 0.40, 0.34 },
                      .grain = 0.07,
                      .wrinkles = 0.05,
                      .roughness = 0.75 };
    style.patches = { .cells = { 10, 7 },
                      .share = age == BarkAge::Old ? 0.62 : 0.75,
                      .fresh = { 0.82, 0.79, 0.62 } };
    style.depth = 0.004;
    return style;
}

BarkStyle old_bark(BarkKind kind)
{
    using Furrows = BarkStyle::Furrows;
    switch (kind) {
    case BarkKind::Alder:
        return ridged_bark({ 0.40, 0.36, 0.31 }, { 0.45, 0.40, 0.34 },
                           Furrows { .ridges = { 15, 8 },
                                     .width = 0.16,
                                     .bridges = 0.4,
                                     .cracks = { 30, 24 },
                                     .crack_depth = 0.3,
                                     .color = { 0.18, 0.15, 0.13 } },
                           0.014);
    case BarkKind::Apple: {
        auto style = ridged_bark({ 0.48, 0.43, 0.38 }, { 0.55, 0.49, 0.42 },
                                 Furrows { .ridges = { 13, 8 },
                                           .width = 0.12,
                                           .bridges = 0.3,
                                           .cracks = { 26, 20 },
                                           .crack_depth = 0.3,
                                           .color = { 0.25, 0.20, 0.17 } },
                                 0.010);
        style.flakes
            = { .cells = { 18, 13 }, .height = 0.35, .change = 0.14, .edge = { 0.36, 0.31, 0.27 } };
        return style;
    }
    case BarkKind::Ash:
        return ridged_bark({ 0.55, 0.51, 0.45 }, { 0.60, 0.56, 0.50 },
                           Furrows { .ridges = { 13, 4 },
                                     .width = 0.26,
                                     .bridges = 0.9,
                                     .wander = 0.9,
                                     .cracks = { 26, 30 },
                                     .crack_depth = 0.2,
                                     .color = { 0.28, 0.25, 0.21 } },
                           0.018);
    case BarkKind::Fir: {
        auto style = scaly_bark(
            { 0.51, 0.50, 0.47 }, { 0.58, 0.57, 0.54 },
            { .cells = { 14, 11 }, .height = 0.3, .change = 0.08, .edge = { 0.36, 0.34, 0.32 } },
            0.006);
        style.lenticels = { .cells = { 18, 18 },
                            .share = 0.3,
                            .length = 0.4,
                            .thickness = 0.2,
                            .height = 0.35,
                            .color = { 0.60, 0.58, 0.54 } };
        return style;
    }
    case BarkKind::Larch: {
        auto style = ridged_bark({ 0.51, 0.40, 0.34 }, { 0.60, 0.45, 0.38 },
                                 Furrows { .ridges = { 10, 5 },
                                           .width = 0.17,
                                           .bridges = 0.3,
                                           .cracks = { 30, 18 },
                                           .crack_depth = 0.3,
                                           .color = { 0.25, 0.16, 0.13 } },
                                 0.022);
        style.flakes
            = { .cells = { 22, 15 }, .height = 0.35, .change = 0.14, .edge = { 0.44, 0.28, 0.23 } };
        return style;
    }
    case BarkKind::Lime:
        return ridged_bark({ 0.47, 0.44, 0.39 }, { 0.53, 0.50, 0.44 },
                           Furrows { .ridges = { 20, 4 },
                                     .width = 0.24,
                                     .bridges = 0.95,
                                     .wander = 0.7,
                                     .cracks = { 40, 40 },
                                     .crack_depth = 0.15,
                                     .color = { 0.26, 0.23, 0.20 } },
                           0.011);
    case BarkKind::Maple:
        return ridged_bark({ 0.48, 0.45, 0.40 }, { 0.55, 0.51, 0.45 },
                           Furrows { .ridges = { 18, 6 },
                                     .width = 0.16,
                                     .bridges = 0.8,
                                     .cracks = { 36, 26 },
                                     .crack_depth = 0.25,
                                     .color = { 0.28, 0.24, 0.21 } },
                           0.010);
    case BarkKind::Oak:
        return ridged_bark({ 0.47, 0.43, 0.37 }, { 0.53, 0.50, 0.44 },
                           Furrows { .ridges = { 14, 5 },
                                     .width = 0.26,
                                     .bridges = 0.8,
                                     .wander = 0.5,
                                     .cracks = { 30, 30 },
                                     .crack_depth = 0.45,
                                     .color = { 0.18, 0.15, 0.12 } },
                           0.024);
    case BarkKind::Poplar:
        return ridged_bark({ 0.42, 0.40, 0.36 }, { 0.50, 0.48, 0.43 },
                           Furrows { .ridges = { 12, 3 },
                                     .width = 0.28,
                                     .bridges = 0.95,
                                     .wander = 0.6,
                                     .cracks = { 28, 30 },
                                     .crack_depth = 0.3,
                                     .color = { 0.17, 0.15, 0.13 } },
                           0.024);
    case BarkKind::Spruce:
        return scaly_bark(
            { 0.44, 0.35, 0.30 }, { 0.50, 0.42, 0.37 },
            { .cells = { 20, 15 }, .height = 0.8, .change = 0.16, .edge = { 0.29, 0.22, 0.19 } },
            0.008);
    case BarkKind::Willow:
        return ridged_bark({ 0.45, 0.41, 0.35 }, { 0.52, 0.47, 0.40 },
                           Furrows { .ridges = { 10, 4 },
                                     .width = 0.28,
                                     .bridges = 0.85,
                                     .wander = 0.8,
                                     .cracks = { 24, 26 },
                                     .crack_depth = 0.3,
                                     .color = { 0.19, 0.16, 0.13 } },
                           0.026);
    default:
        return ridged_bark({ 0.45, 0.40, 0.34 }, { 0.51, 0.46, 0.39 },
                           Furrows { .ridges = { 14, 5 },
                                     .width = 0.22,
                                     .bridges = 0.8,
                                     .cracks = { 30, 26 },
                                     .crack_depth = 0.3,
                                     .color = { 0.20, 0.17, 0.14 } },
                           0.018);
    }
}

BarkStyle young_bark(BarkKind kind)
{
    switch (kind) {
    case BarkKind::Alder:
        return smooth_bark({ 0.42, 0.39, 0.33 }, { 0.49, 0.46, 0.39 }, { 0.60, 0.55, 0.46 });
    case BarkKind::Apple:
        return smooth_bark({ 0.46, 0.39, 0.34 }, { 0.53, 0.47, 0.41 }, { 0.60, 0.53, 0.45 });
    case BarkKind::Ash:
        return smooth_bark({ 0.56, 0.55, 0.48 }, { 0.61, 0.61, 0.55 }, { 0.68, 0.66, 0.60 });
    case BarkKind::Fir:
        return smooth_bark({ 0.52, 0.51, 0.47 }, { 0.58, 0.57, 0.53 }, { 0.63, 0.61, 0.56 });
    case BarkKind::Larch:
        return scaly_bark(
            { 0.55, 0.47, 0.38 }, { 0.60, 0.51, 0.42 },
            { .cells = { 16, 8 }, .height = 0.4, .change = 0.1, .edge = { 0.45, 0.35, 0.28 } },
            0.005);
    case BarkKind::Oak:
        return smooth_bark({ 0.50, 0.48, 0.43 }, { 0.58, 0.57, 0.52 }, { 0.42, 0.38, 0.33 });
    case BarkKind::Poplar:
        return smooth_bark({ 0.56, 0.55, 0.47 }, { 0.63, 0.62, 0.55 }, { 0.36, 0.34, 0.29 });
    case BarkKind::Spruce:
        return scaly_bark(
            { 0.48, 0.37, 0.29 }, { 0.53, 0.42, 0.34 },
            { .cells = { 24, 16 }, .height = 0.4, .change = 0.08, .edge = { 0.37, 0.27, 0.21 } },
            0.004);
    case BarkKind::Willow:
        return smooth_bark({ 0.52, 0.48, 0.36 }, { 0.58, 0.54, 0.43 }, { 0.42, 0.37, 0.28 });
    default:
        return smooth_bark({ 0.48, 0.44, 0.38 }, { 0.55, 0.51, 0.45 }, { 0.60, 0.55, 0.47 });
    }
}

} // namespace

BarkStyle bark_style(BarkKind kind, BarkAge age)
{
    switch (kind) {
    case BarkKind::Beech:
        return beech_bark(age);
    case BarkKind::Birch:
        return birch_bark(age);
    case BarkKind::Cherry:
        return cherry_bark(age);
    case BarkKind::Pine:
        return pine_bark(age);
    case BarkKind::Plane:
        return plane_bark(age);
    default:
        return age == BarkAge::Young ? young_bark(kind) : old_bark(kind);
    }
}

} // namespace tractus::exports
