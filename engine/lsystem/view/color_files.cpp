#include "engine/lsystem/view/color_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

constexpr std::size_t kColors = 256;

// Returns the byte at index `at`, converted to a number from 0 to 1.
double share(std::string_view bytes, std::size_t at)
{
    return static_cast<unsigned char>(bytes[at]) / 255.0;
}

// Converts the exponent of a Phong highlight to the roughness that gives a highlight of the same
// width.
double roughness_of(double exponent)
{
    return std::sqrt(2 / (exponent + 2));
}

std::string material_statement(std::string_view record)
{
    enum Field : std::size_t {
        Index,
        Transparency,
        Ambient,
        Diffuse = 5,
        Emitted = 8,
        Reflected = 11,
        Shininess = 14
    };
    std::array<double, 3> color {};
    double reflected = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        color[i] = std::min(1.0, share(record, Diffuse + i) + share(record, Emitted + i));
        reflected = std::max(reflected, share(record, Reflected + i));
    }
    double const rough = 0.9;
    double const shiny = roughness_of(share(record, Shininess) * 255);
    return fmt::format("color: {} {:.4g},{:.4g},{:.4g} roughness={:.3g} translucency={:.3g}\n",
                       static_cast<unsigned char>(record[Index]), color[0], color[1], color[2],
                       rough + reflected * (std::min(shiny, rough) - rough),
                       share(record, Transparency));
}

} // namespace

Result<std::string> color_map_statements(std::string const& name, std::string_view bytes)
{
    if (bytes.size() < 3)
        return fail(Fault::User,
                    fmt::format("{}: found {} bytes, expected a colour map: red, green "
                                "and blue of 256 colours, 768 bytes",
                                name, bytes.size()));
    std::string text;
    for (std::size_t i = 0; i < std::min(kColors, bytes.size() / 3); ++i)
        text += fmt::format("color: {} {:.4g},{:.4g},{:.4g}\n", i, share(bytes, 3 * i),
                            share(bytes, 3 * i + 1), share(bytes, 3 * i + 2));
    return text;
}

Result<std::string> material_file_statements(std::string const& name, std::string_view bytes)
{
    constexpr std::size_t kRecord = 15;
    if (bytes.size() < kRecord)
        return fail(Fault::User,
                    fmt::format("{}: found {} bytes, expected materials: records of {} "
                                "bytes",
                                name, bytes.size(), kRecord));
    std::string text;
    for (std::size_t i = 0; i < std::min(kColors, bytes.size() / kRecord); ++i)
        text += material_statement(bytes.substr(i * kRecord, kRecord));
    return text;
}

} // namespace tractus::lsystem
