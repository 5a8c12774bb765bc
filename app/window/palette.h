#pragma once

#include "engine/base/vectors.h"

#include <array>

namespace tractus::window::theme {

// Colours that can be told apart with any kind of colour vision (Okabe and Ito 2008, "Color
// universal design"), sRGB, 0 to 1.
struct Palette {
    bool is_light = false;
    Vec3f ink; // Colour of the stroke being drawn.
    Vec3f stroke;
    Vec3f indicator;
    Vec3f purple; // Colour for layers that need an additional one.
    Vec3f unselected;
    Vec3f undetermined;
    Vec3f selected;
    Vec3f assigned;
    Vec3f grid;
    Vec3f volume;
    Vec3f pad_background;
    Vec3f recording;             // Colour of the mark that shows that input is being recorded.
    Vec3f faint;                 // Colour of the skeleton where it only gives orientation.
    std::array<Vec3f, 7> curves; // Colours of drawn curves, used in turn.
    Vec3f growing; // Colour of what grows in the stage view, before it has bark and leaves.
};

// The window's current palette; dark by default.
Palette const& palette();
void use_light_palette(bool is_light);

} // namespace tractus::window::theme
