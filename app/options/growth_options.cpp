#include "app/options/growth_options.h"

#include "app/methods/all_leaves.h"
#include "app/options/checks.h"
#include "engine/variation/growth_preset.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <string>
#include <vector>

namespace tractus::options {

static std::string preset_check(std::string const& name)
{
    auto const preset = variation::growth_preset(name);
    return preset ? "" : preset.error().message;
}

static std::string month_check(std::string const& text)
{
    auto const month = scene::parse_month(text);
    return month ? "" : month.error().message;
}

void add_growth_options(CLI::App& command, batch::GrowthOptions& growth, std::string const& without)
{
    std::vector<std::string> names;
    for (auto const& preset : variation::growth_presets())
        names.emplace_back(preset.name);
    command
        .add_option(
            "--growth", growth.preset,
            fmt::format("How plants grow: {}; without it, {}", fmt::join(names, ", "), without))
        ->type_name("NAME")
        ->check(with_completion_words(names, CLI::Validator(preset_check, "")));
    command
        .add_option(
            "--variability,--liking", growth.variability,
            "How much plants vary: 0 is as drawn, 1 is as the growth's name says, 4 is most; "
            "--liking is its older name")
        ->type_name("X")
        ->check(number(0, 4))
        ->capture_default_str();
    command.add_flag("--along-ground", growth.along_ground,
                     "Bend branches along the ground that would grow into it; roots stay");
    names.clear();
    for (auto const& kind : methods::leaf_kinds())
        names.push_back(kind.name);
    command
        .add_option("--leaves", growth.leaves,
                    fmt::format("Grown leaves in the place of the plant's own: {}, or a .leaf "
                                "file; \"oak+spots=0.3\" with damage",
                                fmt::join(names, ", ")))
        ->type_name("NAME|FILE")
        ->check(suggest(names));
    add_season_options(command, growth.season);
}

static void add_bed_options(CLI::App& command, variation::Individuality& how)
{
    command
        .add_option("--younger", how.age,
                    "Share of its age by which a plant is younger, at most; 0 for all of one age")
        ->type_name("X")
        ->check(number(0, 0.9))
        ->capture_default_str();
    command
        .add_option("--leaf-size", how.organs,
                    "Share by which a plant's leaves and other organs are larger or smaller, at "
                    "most; 0 for none")
        ->type_name("X")
        ->check(number(0, 0.5))
        ->capture_default_str();
    command
        .add_option("--own-seeds", how.seeds,
                    "Share of the plants for which a model's stochastic rules have a seed of their "
                    "own; 0 for none")
        ->type_name("X")
        ->check(number(0, 1))
        ->capture_default_str();
}

void add_individuality_options(CLI::App& command, variation::Individuality& how)
{
    command
        .add_option("--branches", how.branches,
                    "Share of the branches that a plant lacks, and of those that it has twice; "
                    "branches that were drawn stay; 0 for none")
        ->type_name("X")
        ->check(number(0, 0.5))
        ->capture_default_str();
    command
        .add_option("--sizes", how.size,
                    "Share by which plants as wide as high are larger or smaller, at most; narrow "
                    "ones, which turning hardly changes, by up to twice that; 0 for all of "
                    "one size")
        ->type_name("X")
        ->check(number(0, 0.5))
        ->capture_default_str();
    command
        .add_option("--turn", how.turn,
                    "Share of a full turn by which plants are turned, at most; 0 lets all face one "
                    "way")
        ->type_name("X")
        ->check(number(0, 1))
        ->capture_default_str();
    add_bed_options(command, how);
}

void add_season_options(CLI::App& command, std::optional<scene::Season>& season)
{
    auto* const month = command.add_option_function<std::string>(
        "--season",
        [&season](std::string const& text) {
            if (!season)
                season.emplace();
            season->month = *scene::parse_month(text);
        },
        "The time of the year: buds, spring, summer, autumn, winter or bare, a month's name, or "
        "its number, 1 to below 13; without it, as the model or the session has its leaves");
    month->type_name("WHEN")->check(
        with_completion_words(scene::season_words(), CLI::Validator(month_check, "")));
    command
        .add_option_function<double>(
            "--fallen",
            [&season](double share) {
                if (!season)
                    season.emplace();
                season->fallen = share;
            },
            "Share of the leaves fallen by then that lie on the ground, 0 to 1 (0.25)")
        ->type_name("X")
        ->check(number(0, 1))
        ->needs(month);
}

void add_age_option(CLI::App& command, double& age)
{
    command.add_option("--age", age, "How old the plants are: above 0, and 1 is full-grown")
        ->type_name("X")
        ->check(number(0.01, 1))
        ->capture_default_str();
}

} // namespace tractus::options
