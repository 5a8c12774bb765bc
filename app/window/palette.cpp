#include "app/window/palette.h"

namespace tractus::window::theme {

namespace {

Palette const kDark {
    .is_light = false,
    .ink = { 0.96f, 0.80f, 0.38f },
    .stroke = { 0.90f, 0.62f, 0.00f },
    .indicator = { 0.84f, 0.37f, 0.00f },
    .purple = { 0.80f, 0.47f, 0.65f },
    .unselected = { 0.62f, 0.65f, 0.68f },
    .undetermined = { 0.94f, 0.89f, 0.26f },
    .selected = { 0.34f, 0.71f, 0.91f },
    .assigned = { 0.00f, 0.62f, 0.45f },
    .grid = { 0.27f, 0.30f, 0.33f },
    .volume = { 0.22f, 0.245f, 0.27f },
    .pad_background = { 0.095f, 0.105f, 0.12f },
    .recording = { 0.93f, 0.28f, 0.22f },
    .faint = { 0.36f, 0.44f, 0.43f },
    .curves = { Vec3f(0.34f, 0.71f, 0.91f), Vec3f(0.93f, 0.62f, 0.05f), Vec3f(0.10f, 0.70f, 0.52f),
                Vec3f(0.86f, 0.55f, 0.73f), Vec3f(0.94f, 0.89f, 0.26f), Vec3f(0.92f, 0.42f, 0.12f),
                Vec3f(0.42f, 0.55f, 0.95f) },
    .growing = { 0.45f, 0.37f, 0.28f },
};

Palette const kLight {
    .is_light = true,
    .ink = { 0.10f, 0.12f, 0.16f },
    .stroke = { 0.72f, 0.42f, 0.00f },
    .indicator = { 0.84f, 0.37f, 0.00f },
    .purple = { 0.62f, 0.28f, 0.50f },
    .unselected = { 0.47f, 0.47f, 0.46f },
    .undetermined = { 0.80f, 0.47f, 0.65f },
    .selected = { 0.00f, 0.45f, 0.70f },
    .assigned = { 0.00f, 0.55f, 0.40f },
    .grid = { 0.81f, 0.81f, 0.80f },
    .volume = { 0.85f, 0.85f, 0.84f },
    .pad_background = { 0.972f, 0.97f, 0.965f },
    .recording = { 0.80f, 0.10f, 0.08f },
    .faint = { 0.62f, 0.68f, 0.66f },
    .curves = { Vec3f(0.10f, 0.52f, 0.76f), Vec3f(0.76f, 0.47f, 0.00f), Vec3f(0.00f, 0.52f, 0.38f),
                Vec3f(0.64f, 0.30f, 0.52f), Vec3f(0.52f, 0.49f, 0.04f), Vec3f(0.80f, 0.32f, 0.00f),
                Vec3f(0.00f, 0.32f, 0.62f) },
    .growing = { 0.42f, 0.32f, 0.22f },
};

Palette const*& present()
{
    static Palette const* palette = &kDark;
    return palette;
}

} // namespace

Palette const& palette()
{
    return *present();
}

void use_light_palette(bool is_light)
{
    present() = is_light ? &kLight : &kDark;
}

} // namespace tractus::window::theme
