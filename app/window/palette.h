#pragma once

#include "engine/base/vectors.h"

#include <array>

namespace tractus::window::theme {

// Colours of the window, which can be told apart with any kind of colour vision (Okabe and Ito
// 2008, "Color universal design"). sRGB, 0 to 1.
struct Palette {
    bool is_light = false;
    Vec3f ink; // Colour of the stroke in progress.
    Vec3f stroke;
    Vec3f indicator;
    Vec3f purple; // Colour of layers that need a further colour.
    Vec3f unselected;
    Vec3f undetermined;
    Vec3f selected;
    Vec3f assigned;
    Vec3f grid;
    Vec3f volume;
    Vec3f pad_background;
    Vec3f recording;             // Colour of the mark that shows that a recording is running.
    Vec3f faint;                 // Colour of the skeleton where it only helps orientation.
    std::array<Vec3f, 7> curves; // Colours of drawn curves, which take turns.
    // Colour of growing shoots in the stage view, while they have no bark and leaves yet.
    Vec3f growing;
};

// Returns the palette that the window uses now; at the start, the dark one.
Palette const& palette();
void use_light_palette(bool is_light);

} // namespace tractus::window::theme
