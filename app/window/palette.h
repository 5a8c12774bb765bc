#pragma once

#include "engine/base/vectors.h"

namespace tractus::window::theme {

// Colours that people with any kind of colour vision tell apart (Okabe and Ito 2008, "Color
// universal design"), sRGB, 0 to 1.
struct Palette {
    bool is_light = false;
    Vec3f ink; // Being drawn.
    Vec3f stroke;
    Vec3f indicator;
    Vec3f purple; // Of layers that need one more.
    Vec3f unselected;
    Vec3f undetermined;
    Vec3f selected;
    Vec3f assigned;
    Vec3f grid;
    Vec3f volume;
    Vec3f pad_background;
    Vec3f recording; // The mark that all is recorded.
    Vec3f faint;     // The skeleton where it only helps to find one's way.
    Vec3f growing;   // What grows on stage, until it has bark and leaves.
};

// That of the window now: for a dark room, until a person wants light.
Palette const& palette();
void use_light_palette(bool is_light);

} // namespace tractus::window::theme
