#include "app/options/examples.h"

#include <array>

namespace tractus::options {

namespace {

constexpr std::array kExamples = std::to_array<Example>({
    { "tour", "tour", false },
    { "window", "window", false },
    { "window", "window --plant birch --height 100", false },
    { "window", "draw --device simulated", false },
    { "record", "record --device simulated --seconds 4 -o hand.tractus-log" },
    { "record", "record -o evening.tractus-log", false },
    { "decode", "decode hand.tractus-log" },
    { "decode", "decode hand.tractus-log --csv -o hand.csv" },
    { "convert", "convert hand.tractus-log -o hand.txt" },
    { "convert", "convert hand.tractus-log --view top -o hand.svg" },
    { "stream", "stream hand.tractus-log --strokes" },
    { "stream", "stream --device simulated --seconds 2" },
    { "watch", "watch simulated --seconds 2" },
    { "devices", "devices" },
    { "devices", "devices --json" },
    { "doctor", "doctor", false },
    { "doctor", "doctor evening.tractus-log", false },
    { "calibrate height", "calibrate height", false },
    { "calibrate check", "calibrate check", false },
    { "sim uhid", "sim uhid hand.tractus-log", false },
    { "tools", "tools" },
    { "tools", "tools draw" },
    { "grow", "grow birch -o birch.glb" },
    { "grow", "grow --habit oak --years 12 -o oak.png" },
    { "grow", "grow daisy --animation 6 -o daisy-grows.glb" },
    { "render", "render birch.glb --size 600x800 -o birch.png" },
    { "vary", "vary daisy --count 6 -o daisies.glb --sheet daisies.png" },
    { "vary", "vary daisy --count 4 --ages 0.4..1 --spread scatter -o bed" },
    { "replay", "replay hand.tractus-log --plant broadleaf --count 2" },
    { "replay", "replay hand.tractus-log --plant daisy --session kept.tractus -o kept" },
    { "session info", "session info kept.tractus" },
    { "session log", "session log kept.tractus" },
    { "session export", "session export kept.tractus -o kept-files" },
    { "lsystem new", "lsystem new mine.l" },
    { "lsystem check", "lsystem check mine.l" },
    { "lsystem import", "lsystem import tree.ls -o tree.l", false },
    { "derive", "derive shrub -n 3 --count" },
    { "derive", "derive shrub -n 1 --string" },
    { "demo", "demo --plant daisy -o daisy-demo" },
});

std::string full_name(CLI::App const& command)
{
    auto const* const parent = command.get_parent();
    if (!parent)
        return {};
    auto const above = full_name(*parent);
    return above.empty() ? command.get_name() : above + " " + command.get_name();
}

} // namespace

std::span<Example const> examples()
{
    return kExamples;
}

std::vector<std::string> examples_of(CLI::App const& command)
{
    std::vector<std::string> lines;
    auto const name = full_name(command);
    for (auto const& example : kExamples)
        if (name == example.command)
            lines.push_back(std::string("tractus ") + example.line);
    return lines;
}

} // namespace tractus::options
