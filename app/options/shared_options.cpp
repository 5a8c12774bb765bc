#include "app/options/shared_options.h"

#include "app/options/checks.h"
#include "calib/height_scenario.h"

#include <fmt/core.h>

namespace tractus::options {

CLI::Option* add_plant_option(CLI::App& command, std::string& model)
{
    auto* const option
        = command
              .add_option("--plant", model,
                          "The plant's model: an L-system file (.l), a skeleton "
                          "of lines (.obj, .glb), a measured tree (.csv, .txt, .ply, .mtg), a "
                          "session with what was drawn in it (.tractus), or one of ours by its "
                          "name: broadleaf, conifer, daisy, shrub, …; where a drawing is replayed, "
                          "empty is an empty sheet")
              ->type_name("MODEL");
    return model.empty() ? option->required() : option->capture_default_str();
}

CLI::Option* add_rig_option(CLI::App& command, std::string& file)
{
    return command
        .add_option("--rig", file, "The rig's calibration, a .rig.toml; without it, the log's own")
        ->type_name("FILE");
}

CLI::Option* add_height_option(CLI::App& command, std::string& height)
{
    return command
        .add_option("--height", height,
                    "The surface's height in place of the height sensor's: millimetres above "
                    "the desk, or a made-up movement: rise, fall, arch or sway")
        ->type_name("MM|MOVEMENT")
        ->check(height_scenario());
}

Result<double> constant_height_mm(std::string const& height)
{
    auto const scenario = TRY(calib::parse_height_scenario(height));
    if (scenario.kind != calib::HeightScenario::Kind::Constant)
        return fail(Fault::User,
                    fmt::format("--height {}: a made-up movement needs a recording; while devices "
                                "are read, give millimetres",
                                height));
    return scenario.constant_mm;
}

CLI::Option* add_seed_option(CLI::App& command, std::uint64_t& seed)
{
    return command.add_option("--seed", seed, "Chooses the variations: another seed, other plants")
        ->type_name("N")
        ->check(seed_number())
        ->capture_default_str();
}

CLI::Option* add_force_option(CLI::App& command, bool& is_forced)
{
    return command.add_flag("--force", is_forced,
                            "Write over files of the same names that tractus did not make");
}

char const* job_footer()
{
    return "Writes base.png (the plant as its model gives it), strokes.png (what was drawn),\n"
           "varied.png (one variation), collection.png and collection.glb (all of them; the\n"
           "demo also makes index.html, which shows them in a browser) and report.txt, which is\n"
           "printed, too. The same seed gives the same plants.";
}

} // namespace tractus::options
