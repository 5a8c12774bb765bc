#pragma once

namespace tractus {

// Width of ink drawn at full pressure, as displayed on the drawing pad.
constexpr double kInkWidth_mm = 3.5;

// Width of ink as a share of that at full pressure, for a pressure from 0 to 1. The lightest touch
// leaves a visible line.
constexpr double ink_width_share(double pressure)
{
    return 0.35 + 0.65 * pressure;
}

} // namespace tractus
