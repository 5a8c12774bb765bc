#pragma once

namespace tractus {

// Width at which the drawing pad shows ink that was drawn at full pressure.
constexpr double kInkWidth_mm = 3.5;

// Returns the width of ink at a pressure from 0 to 1, as a share of its width at full pressure.
// Even the lightest touch leaves a visible line.
constexpr double ink_width_share(double pressure)
{
    return 0.35 + 0.65 * pressure;
}

} // namespace tractus
