#include "calib/pressure_response.h"

#include <algorithm>
#include <cmath>

namespace tractus::calib {

double respond(PressureResponse const& response, double pressure)
{
    auto const share = (pressure - response.threshold) / (response.full - response.threshold);
    return std::pow(std::clamp(share, 0.0, 1.0), response.exponent);
}

} // namespace tractus::calib
