#include "app/options/examples.h"

#include <array>
#include <sstream>

namespace tractus::options {

namespace {

constexpr std::array kExamples = std::to_array<Example>({
    { "tour", "tour", false },
    { "tour", "tour --left-handed", false },
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
    { "watch", "watch", false },
    { "devices", "devices" },
    { "devices", "devices --json" },
    { "doctor", "doctor", false },
    { "doctor", "doctor evening.tractus-log", false },
    { "calibrate height", "calibrate height --simulate --rig my.rig.toml" },
    { "calibrate height", "calibrate height --window", false },
    { "calibrate travel", "calibrate travel --simulate --rig my.rig.toml" },
    { "calibrate travel", "calibrate travel", false },
    { "calibrate latency", "calibrate latency --simulate --rig my.rig.toml" },
    { "calibrate latency", "calibrate latency", false },
    { "calibrate tilt", "calibrate tilt --simulate --rig my.rig.toml" },
    { "calibrate tilt", "calibrate tilt", false },
    { "calibrate zero", "calibrate zero --simulate --rig my.rig.toml" },
    { "calibrate zero", "calibrate zero --cause slipped", false },
    { "calibrate check", "calibrate check --simulate --rig my.rig.toml" },
    { "calibrate check", "calibrate check", false },
    { "sim uhid", "sim uhid hand.tractus-log", false },
    { "sim uhid", "sim uhid --simulate hand.toml --repeat", false },
    { "sim serial", "sim serial hand.tractus-log --link height", false },
    { "sim serial", "sim serial hand.tractus-log --rate 100 --repeat", false },
    { "sim gadget", "sim gadget pen hand.tractus-log", false },
    { "sim gadget", "sim gadget pen hand.tractus-log --repeat", false },
    { "sim mcp2221a", "sim mcp2221a hand.tractus-log", false },
    { "sim mcp2221a", "sim mcp2221a hand.tractus-log --stay", false },
    { "sim desk", "sim desk hand.tractus-log", false },
    { "sim desk", "sim desk hand.tractus-log --repeat", false },
    { "sim iio", "sim iio hand.tractus-log", false },
    { "sim iio", "sim iio hand.tractus-log --stay", false },
    { "sim cp2112", "sim cp2112 hand.tractus-log --channel 0", false },
    { "sim cp2112", "sim cp2112 hand.tractus-log --fail-after 3", false },
    { "sim encoder", "sim encoder hand.tractus-log", false },
    { "sim encoder", "sim encoder hand.tractus-log --counts 2400", false },
    { "tools", "tools" },
    { "tools", "tools draw" },
    { "grow", "grow birch -o birch.glb" },
    { "grow", "grow --habit oak --years 12 -o oak.png" },
    { "grow", "grow daisy --animation 6 -o daisy-grows.glb" },
    { "render", "render birch.glb --size 600x800 -o birch.png" },
    { "render", "render daisy-grows.glb -o grown-daisy.png" },
    { "vary", "vary daisy --count 6 -o daisies.glb --sheet daisies.png" },
    { "vary", "vary daisy --count 4 --ages 0.4..1 --spread scatter -o bed" },
    { "replay", "replay hand.tractus-log --plant broadleaf --count 2" },
    { "replay", "replay hand.tractus-log --plant daisy --session kept.tractus -o kept" },
    { "session info", "session info kept.tractus" },
    { "session info", "session info evening.tractus", false },
    { "session log", "session log kept.tractus" },
    { "session log", "session log evening.tractus", false },
    { "session export", "session export kept.tractus -o kept-files" },
    { "session export", "session export evening.tractus", false },
    { "session repair", "session repair kept.tractus -o mended.tractus" },
    { "session repair", "session repair torn.tractus --plant birch -o mended.tractus", false },
    { "lsystem new", "lsystem new mine.l" },
    { "lsystem new", "lsystem new trees/elder.l", false },
    { "lsystem check", "lsystem check mine.l" },
    { "lsystem check", "lsystem check bush.l --dialect book", false },
    { "lsystem import", "lsystem import tree.ls -o tree.l", false },
    { "lsystem import", "lsystem import bush.txt --from book -o bush.l", false },
    { "derive", "derive shrub -n 3 --count" },
    { "derive", "derive shrub -n 1 --string" },
    { "demo", "demo --plant daisy -o daisy-demo" },
    { "demo", "demo", false },
});

// Separates the footer's text from the examples that a method has added.
constexpr std::string_view kHeading = "\nExamples:\n";

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

void add_examples(CLI::App& command, std::vector<std::string> const& lines)
{
    std::string text = command.get_footer();
    text += kHeading;
    for (auto const& line : lines)
        text += "tractus " + line + "\n";
    command.footer(text);
}

std::string footer_of(CLI::App const& command)
{
    auto const text = command.get_footer();
    return text.substr(0, text.find(kHeading));
}

std::vector<std::string> examples_of(CLI::App const& command)
{
    std::vector<std::string> lines;
    auto const footer = command.get_footer();
    if (auto const heading = footer.find(kHeading); heading != std::string::npos) {
        std::istringstream added(footer.substr(heading + kHeading.size()));
        for (std::string line; std::getline(added, line);)
            lines.push_back(line);
    }
    auto const name = full_name(command);
    for (auto const& example : kExamples)
        if (name == example.command)
            lines.push_back(std::string("tractus ") + example.line);
    return lines;
}

} // namespace tractus::options
