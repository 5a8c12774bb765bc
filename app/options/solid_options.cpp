#include "app/options/solid_options.h"

#include "app/options/checks.h"

#include <fmt/format.h>

namespace tractus::options {

void add_solid_options(CLI::App& command, batch::SolidFileOptions& options)
{
    command.add_flag("--watertight", options.is_watertight,
                     "Make one closed shell of the plant, in a .stl or .ply for a 3D printer. "
                     "Without it each branch and leaf of a .stl is closed, and they overlap");
    command
        .add_option("--least-thickness", options.least_thickness_mm,
                    "How thick branches and leaves of a .stl or .ply are at least: thinner ones "
                    "are thickened, for the printer. Details of --watertight are as fine as this")
        ->type_name("MM")
        ->check(number(0.001, 100'000))
        ->default_str(fmt::format("{}", batch::kPrintableThickness_mm));
    command
        .add_option("--print-height", options.height_mm,
                    "Scale the plant of a .stl or .ply to this height; without it, it has its "
                    "natural size")
        ->type_name("MM")
        ->check(number(0.1, 1e6));
    command.add_flag("--without-leaves", options.without_leaves,
                     "Leave leaves, flowers and fruits out of a .stl or closed .ply");
}

Result<void> check_solid_options(batch::SolidFileOptions const& options,
                                 std::filesystem::path const& output)
{
    auto const ending = output.extension();
    if (options.closes() && ending != ".stl" && ending != ".ply")
        return fail(Fault::User,
                    fmt::format("{}: --watertight, --least-thickness, --print-height and "
                                "--without-leaves are for .stl and .ply",
                                output.string()));
    return {};
}

} // namespace tractus::options
