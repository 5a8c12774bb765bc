#include "engine/export/bark_style.h"

namespace tractus::exports {

namespace {

// Smooth bark of a limb, with pores.
BarkStyle smooth_bark(Vec3f const& color, Vec3f const& other_color, Vec3f const& pores)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.08F,
                      .wrinkles = 0.10F,
                      .roughness = 0.8F };
    style.lenticels = { .cells = { 14, 22 },
                        .share = 0.45F,
                        .length = 0.35F,
                        .thickness = 0.16F,
                        .height = 0.25F,
                        .color = pores };
    style.depth = 0.004F;
    return style;
}

// Bark with furrows along the axis.
BarkStyle ridged_bark(Vec3f const& color, Vec3f const& other_color,
                      BarkStyle::Furrows const& furrows, float depth)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.16F,
                      .wrinkles = 0.06F,
                      .roughness = 0.92F };
    style.furrows = furrows;
    style.depth = depth;
    return style;
}

// Bark of thin scales.
BarkStyle scaly_bark(Vec3f const& color, Vec3f const& other_color, BarkStyle::Flakes const& flakes,
                     float depth)
{
    BarkStyle style;
    style.surface = { .color = color,
                      .other_color = other_color,
                      .grain = 0.12F,
                      .wrinkles = 0.05F,
                      .roughness = 0.85F };
    style.flakes = flakes;
    style.depth = depth;
    return style;
}

BarkStyle birch_bark(BarkAge age)
{
    BarkStyle style;
    style.surface = { .color = { 0.90F, 0.88F, 0.84F },
                      .other_color = { 0.80F, 0.75F, 0.69F },
                      .grain = 0.03F,
                      .wrinkles = 0.14F,
                      .roughness = 0.65F };
    style.lenticels = { .cells = { 9, 46 },
                        .share = 0.42F,
                        .length = 0.55F,
                        .thickness = 0.17F,
                        .height = 0.15F,
                        .color = { 0.30F, 0.25F, 0.22F } };
    style.depth = 0.004F;
    if (age == BarkAge::Old) {
        style.clefts = {
            .cells = { 4, 3 }, .share = 0.55F, .size = 0.44F, .color = { 0.16F, 0.14F, 0.13F }
        };
        style.depth = 0.022F;
    }
    return style;
}

BarkStyle beech_bark(BarkAge age)
{
    auto style
        = smooth_bark({ 0.57F, 0.57F, 0.54F }, { 0.66F, 0.67F, 0.63F }, { 0.46F, 0.45F, 0.42F });
    style.surface.wrinkles = age == BarkAge::Old ? 0.13F : 0.07F;
    style.surface.grain = 0.05F;
    style.lenticels.share = 0.25F;
    return style;
}

BarkStyle cherry_bark(BarkAge age)
{
    auto style
        = smooth_bark({ 0.37F, 0.24F, 0.20F }, { 0.45F, 0.35F, 0.31F }, { 0.58F, 0.45F, 0.36F });
    style.surface.wrinkles = 0.18F;
    style.surface.roughness = 0.5F;
    style.lenticels = { .cells = { 6, 20 },
                        .share = 0.75F,
                        .length = 0.9F,
                        .thickness = 0.18F,
                        .height = 0.35F,
                        .color = { 0.58F, 0.45F, 0.36F } };
    style.depth = 0.006F;
    if (age == BarkAge::Old) {
        style.surface.color = { 0.34F, 0.25F, 0.22F };
        style.surface.other_color = { 0.30F, 0.26F, 0.24F };
        style.furrows = { .ridges = { 7, 7 },
                          .width = 0.07F,
                          .bridges = 0,
                          .wander = 0.5F,
                          .color = { 0.19F, 0.15F, 0.13F } };
        style.depth = 0.010F;
    }
    return style;
}

BarkStyle pine_bark(BarkAge age)
{
    if (age == BarkAge::Young)
        return scaly_bark({ 0.76F, 0.48F, 0.28F }, { 0.69F, 0.40F, 0.23F },
                          { .cells = { 12, 9 },
                            .height = 0.5F,
                            .change = 0.12F,
                            .edge = { 0.84F, 0.64F, 0.44F } },
                          0.004F);
    auto style = ridged_bark({ 0.50F, 0.39F, 0.32F }, { 0.56F, 0.41F, 0.31F },
                             { .ridges = { 9, 5 },
                               .width = 0.17F,
                               .bridges = 0.15F,
                               .wander = 0.35F,
                               .cracks = { 27, 17 },
                               .crack_depth = 0.35F,
                               .color = { 0.21F, 0.14F, 0.11F } },
                             0.026F);
    style.flakes = {
        .cells = { 26, 18 }, .height = 0.35F, .change = 0.12F, .edge = { 0.43F, 0.29F, 0.21F }
    };
    return style;
}

BarkStyle plane_bark(BarkAge age)
{
    BarkStyle style;
    style.surface = { .color = { 0.50F, 0.48F, 0.40F },
                      .other_color = { 0.43F, 0.40F, 0.34F },
                      .grain = 0.07F,
                      .wrinkles = 0.05F,
                      .roughness = 0.75F };
    style.patches = { .cells = { 10, 7 },
                      .share = age == BarkAge::Old ? 0.62F : 0.75F,
                      .fresh = { 0.82F, 0.79F, 0.62F } };
    style.depth = 0.004F;
    return style;
}

BarkStyle old_alder()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.40F, 0.36F, 0.31F }, { 0.45F, 0.40F, 0.34F },
                       Furrows { .ridges = { 15, 8 },
                                 .width = 0.16F,
                                 .bridges = 0.4F,
                                 .cracks = { 30, 24 },
                                 .crack_depth = 0.3F,
                                 .color = { 0.18F, 0.15F, 0.13F } },
                       0.014F);
}

BarkStyle old_apple()
{
    using Furrows = BarkStyle::Furrows;

    auto style = ridged_bark({ 0.48F, 0.43F, 0.38F }, { 0.55F, 0.49F, 0.42F },
                             Furrows { .ridges = { 13, 8 },
                                       .width = 0.12F,
                                       .bridges = 0.3F,
                                       .cracks = { 26, 20 },
                                       .crack_depth = 0.3F,
                                       .color = { 0.25F, 0.20F, 0.17F } },
                             0.010F);
    style.flakes = {
        .cells = { 18, 13 }, .height = 0.35F, .change = 0.14F, .edge = { 0.36F, 0.31F, 0.27F }
    };
    return style;
}

BarkStyle old_ash()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.55F, 0.51F, 0.45F }, { 0.60F, 0.56F, 0.50F },
                       Furrows { .ridges = { 13, 4 },
                                 .width = 0.26F,
                                 .bridges = 0.9F,
                                 .wander = 0.9F,
                                 .cracks = { 26, 30 },
                                 .crack_depth = 0.2F,
                                 .color = { 0.28F, 0.25F, 0.21F } },
                       0.018F);
}

BarkStyle old_fir()
{

    auto style = scaly_bark(
        { 0.51F, 0.50F, 0.47F }, { 0.58F, 0.57F, 0.54F },
        { .cells = { 14, 11 }, .height = 0.3F, .change = 0.08F, .edge = { 0.36F, 0.34F, 0.32F } },
        0.006F);
    style.lenticels = { .cells = { 18, 18 },
                        .share = 0.3F,
                        .length = 0.4F,
                        .thickness = 0.2F,
                        .height = 0.35F,
                        .color = { 0.60F, 0.58F, 0.54F } };
    return style;
}

BarkStyle old_larch()
{
    using Furrows = BarkStyle::Furrows;

    auto style = ridged_bark({ 0.51F, 0.40F, 0.34F }, { 0.60F, 0.45F, 0.38F },
                             Furrows { .ridges = { 10, 5 },
                                       .width = 0.17F,
                                       .bridges = 0.3F,
                                       .cracks = { 30, 18 },
                                       .crack_depth = 0.3F,
                                       .color = { 0.25F, 0.16F, 0.13F } },
                             0.022F);
    style.flakes = {
        .cells = { 22, 15 }, .height = 0.35F, .change = 0.14F, .edge = { 0.44F, 0.28F, 0.23F }
    };
    return style;
}

BarkStyle old_lime()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.47F, 0.44F, 0.39F }, { 0.53F, 0.50F, 0.44F },
                       Furrows { .ridges = { 20, 4 },
                                 .width = 0.24F,
                                 .bridges = 0.95F,
                                 .wander = 0.7F,
                                 .cracks = { 40, 40 },
                                 .crack_depth = 0.15F,
                                 .color = { 0.26F, 0.23F, 0.20F } },
                       0.011F);
}

BarkStyle old_maple()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.48F, 0.45F, 0.40F }, { 0.55F, 0.51F, 0.45F },
                       Furrows { .ridges = { 18, 6 },
                                 .width = 0.16F,
                                 .bridges = 0.8F,
                                 .cracks = { 36, 26 },
                                 .crack_depth = 0.25F,
                                 .color = { 0.28F, 0.24F, 0.21F } },
                       0.010F);
}

BarkStyle old_oak()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.47F, 0.43F, 0.37F }, { 0.53F, 0.50F, 0.44F },
                       Furrows { .ridges = { 14, 5 },
                                 .width = 0.26F,
                                 .bridges = 0.8F,
                                 .wander = 0.5F,
                                 .cracks = { 30, 30 },
                                 .crack_depth = 0.45F,
                                 .color = { 0.18F, 0.15F, 0.12F } },
                       0.024F);
}

BarkStyle old_poplar()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.42F, 0.40F, 0.36F }, { 0.50F, 0.48F, 0.43F },
                       Furrows { .ridges = { 12, 3 },
                                 .width = 0.28F,
                                 .bridges = 0.95F,
                                 .wander = 0.6F,
                                 .cracks = { 28, 30 },
                                 .crack_depth = 0.3F,
                                 .color = { 0.17F, 0.15F, 0.13F } },
                       0.024F);
}

BarkStyle old_spruce()
{
    return scaly_bark(
        { 0.44F, 0.35F, 0.30F }, { 0.50F, 0.42F, 0.37F },
        { .cells = { 20, 15 }, .height = 0.8F, .change = 0.16F, .edge = { 0.29F, 0.22F, 0.19F } },
        0.008F);
}

BarkStyle old_willow()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.45F, 0.41F, 0.35F }, { 0.52F, 0.47F, 0.40F },
                       Furrows { .ridges = { 10, 4 },
                                 .width = 0.28F,
                                 .bridges = 0.85F,
                                 .wander = 0.8F,
                                 .cracks = { 24, 26 },
                                 .crack_depth = 0.3F,
                                 .color = { 0.19F, 0.16F, 0.13F } },
                       0.026F);
}

BarkStyle old_usual_bark()
{
    using Furrows = BarkStyle::Furrows;
    return ridged_bark({ 0.45F, 0.40F, 0.34F }, { 0.51F, 0.46F, 0.39F },
                       Furrows { .ridges = { 14, 5 },
                                 .width = 0.22F,
                                 .bridges = 0.8F,
                                 .cracks = { 30, 26 },
                                 .crack_depth = 0.3F,
                                 .color = { 0.20F, 0.17F, 0.14F } },
                       0.018F);
}

BarkStyle old_bark(BarkKind kind)
{
    switch (kind) {
    case BarkKind::Alder:
        return old_alder();
    case BarkKind::Apple:
        return old_apple();
    case BarkKind::Ash:
        return old_ash();
    case BarkKind::Fir:
        return old_fir();
    case BarkKind::Larch:
        return old_larch();
    case BarkKind::Lime:
        return old_lime();
    case BarkKind::Maple:
        return old_maple();
    case BarkKind::Oak:
        return old_oak();
    case BarkKind::Poplar:
        return old_poplar();
    case BarkKind::Spruce:
        return old_spruce();
    case BarkKind::Willow:
        return old_willow();
    default:
        return old_usual_bark();
    }
}

BarkStyle young_bark(BarkKind kind)
{
    switch (kind) {
    case BarkKind::Alder:
        return smooth_bark({ 0.42F, 0.39F, 0.33F }, { 0.49F, 0.46F, 0.39F },
                           { 0.60F, 0.55F, 0.46F });
    case BarkKind::Apple:
        return smooth_bark({ 0.46F, 0.39F, 0.34F }, { 0.53F, 0.47F, 0.41F },
                           { 0.60F, 0.53F, 0.45F });
    case BarkKind::Ash:
        return smooth_bark({ 0.56F, 0.55F, 0.48F }, { 0.61F, 0.61F, 0.55F },
                           { 0.68F, 0.66F, 0.60F });
    case BarkKind::Fir:
        return smooth_bark({ 0.52F, 0.51F, 0.47F }, { 0.58F, 0.57F, 0.53F },
                           { 0.63F, 0.61F, 0.56F });
    case BarkKind::Larch:
        return scaly_bark(
            { 0.55F, 0.47F, 0.38F }, { 0.60F, 0.51F, 0.42F },
            { .cells = { 16, 8 }, .height = 0.4F, .change = 0.1F, .edge = { 0.45F, 0.35F, 0.28F } },
            0.005F);
    case BarkKind::Oak:
        return smooth_bark({ 0.50F, 0.48F, 0.43F }, { 0.58F, 0.57F, 0.52F },
                           { 0.42F, 0.38F, 0.33F });
    case BarkKind::Poplar:
        return smooth_bark({ 0.56F, 0.55F, 0.47F }, { 0.63F, 0.62F, 0.55F },
                           { 0.36F, 0.34F, 0.29F });
    case BarkKind::Spruce:
        return scaly_bark({ 0.48F, 0.37F, 0.29F }, { 0.53F, 0.42F, 0.34F },
                          { .cells = { 24, 16 },
                            .height = 0.4F,
                            .change = 0.08F,
                            .edge = { 0.37F, 0.27F, 0.21F } },
                          0.004F);
    case BarkKind::Willow:
        return smooth_bark({ 0.52F, 0.48F, 0.36F }, { 0.58F, 0.54F, 0.43F },
                           { 0.42F, 0.37F, 0.28F });
    default:
        return smooth_bark({ 0.48F, 0.44F, 0.38F }, { 0.55F, 0.51F, 0.45F },
                           { 0.60F, 0.55F, 0.47F });
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
