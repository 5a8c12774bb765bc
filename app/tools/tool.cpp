#include "app/tools/tool.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

constexpr std::array<std::pair<std::string_view, Tool::Kind>, 11> kTools { {
    { "select", Tool::Kind::Select },
    { "draw", Tool::Kind::Draw },
    { "indicate", Tool::Kind::Indicate },
    { "draw_in_order", Tool::Kind::DrawInOrder },
    { "oversketch", Tool::Kind::Oversketch },
    { "smooth", Tool::Kind::Smooth },
    { "delete", Tool::Kind::Delete },
    { "move_indicator", Tool::Kind::MoveIndicator },
    { "delete_indicator", Tool::Kind::DeleteIndicator },
    { "erase", Tool::Kind::Erase },
    { "press", Tool::Kind::Press },
} };

// A word of a tool's arguments, and what it does to the tool. The first of those that do the same
// kind of thing is what no word means.
struct Argument {
    Tool::Kind kind;
    std::string_view word;
    void (*set)(Tool&);
};

using Reach = Tool::Reach;
using Selecting = Tool::Selecting;
using Erasing = Tool::Erasing;
using IndicatorKind = MotionIndicator::Kind;

constexpr std::array<Argument, 21> kArguments { {
    { Tool::Kind::Select, "path", [](Tool& tool) { tool.selecting = Selecting::Path; } },
    { Tool::Kind::Select, "add", [](Tool& tool) { tool.selecting = Selecting::Add; } },
    { Tool::Kind::Select, "take", [](Tool& tool) { tool.selecting = Selecting::Take; } },
    { Tool::Kind::Select, "ends", [](Tool& tool) { tool.selecting = Selecting::Ends; } },
    { Tool::Kind::Select, "order", [](Tool& tool) { tool.selecting = Selecting::Order; } },
    { Tool::Kind::Select, "alike", [](Tool& tool) { tool.selecting = Selecting::Alike; } },
    { Tool::Kind::Select, "invert", [](Tool& tool) { tool.selecting = Selecting::Invert; } },
    { Tool::Kind::Select, "nothing", [](Tool& tool) { tool.selecting = Selecting::Nothing; } },
    { Tool::Kind::Draw, "selected", [](Tool& tool) { tool.propagation = Propagation::Selected; } },
    { Tool::Kind::Draw, "descendants",
      [](Tool& tool) { tool.propagation = Propagation::Descendants; } },
    { Tool::Kind::Draw, "both", [](Tool& tool) { tool.propagation = Propagation::Both; } },
    { Tool::Kind::Draw, "start", [](Tool& tool) { tool.fit = StrokeFit::Start; } },
    { Tool::Kind::Draw, "chord", [](Tool& tool) { tool.fit = StrokeFit::Chord; } },
    { Tool::Kind::Draw, "world", [](Tool& tool) { tool.fit = StrokeFit::World; } },
    { Tool::Kind::Indicate, "everywhere", [](Tool& tool) { tool.reach = Reach::Everywhere; } },
    { Tool::Kind::Indicate, "below", [](Tool& tool) { tool.reach = Reach::Below; } },
    { Tool::Kind::Indicate, "near", [](Tool& tool) { tool.reach = Reach::Near; } },
    { Tool::Kind::Indicate, "push", [](Tool& tool) { tool.indicator = IndicatorKind::Push; } },
    { Tool::Kind::Indicate, "light", [](Tool& tool) { tool.indicator = IndicatorKind::Light; } },
    { Tool::Kind::Erase, "whole", [](Tool& tool) { tool.erasing = Erasing::Whole; } },
    { Tool::Kind::Erase, "part", [](Tool& tool) { tool.erasing = Erasing::Part; } },
} };

constexpr std::string_view kNow = "now";
constexpr std::string_view kView = "view=";

bool can_be_done_at_once(Tool const& tool)
{
    return tool.kind == Tool::Kind::Smooth || tool.kind == Tool::Kind::Delete
        || (tool.kind == Tool::Kind::Select
            && (tool.selecting == Selecting::Invert || tool.selecting == Selecting::Nothing));
}

std::string view_word(SelectionAngle const& angle)
{
    return fmt::format("{}{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", kView,
                       angle.azimuth_deg, angle.elevation_deg, angle.zoom, angle.moved_mm.x(),
                       angle.moved_mm.y(), angle.area_mm.x(), angle.area_mm.y());
}

Result<SelectionAngle> parse_view(std::string_view word)
{
    std::array<double, 7> numbers {};
    auto rest = word.substr(kView.size());
    bool is_whole = true;
    for (auto& number : numbers) {
        auto const end = std::min(rest.find(','), rest.size());
        auto const parsed = std::from_chars(rest.data(), rest.data() + end, number);
        is_whole = is_whole && parsed.ec == std::errc() && parsed.ptr == rest.data() + end
            && std::isfinite(number);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    auto const [azimuth, elevation, zoom, x, y, width, depth] = numbers;
    if (!is_whole || !rest.empty() || std::abs(elevation) >= 90 || zoom <= 0 || width <= 0
        || depth <= 0)
        return fail(Fault::User,
                    fmt::format("\"{}\" is no view: give azimuth, elevation below 90, zoom, x, y, "
                                "width and depth, for example view=0,0,1,0,0,254,159",
                                word));
    return SelectionAngle { azimuth, elevation, zoom, { x, y }, { width, depth } };
}

// "a, b or c" of the words that `is_listed` accepts.
template<typename Entries, typename Accept>
std::string list_words(Entries const& entries, Accept const& word_of)
{
    std::vector<std::string_view> words;
    for (auto const& entry : entries)
        if (auto const word = word_of(entry); !word.empty())
            words.push_back(word);
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += fmt::format("{}{}", i == 0 ? "" : i + 1 < words.size() ? ", " : " or ", words[i]);
    return list;
}

Result<void> take_argument(Tool& tool, std::string_view name, std::string_view word)
{
    if (word == kNow) {
        tool.at_once = true;
        return {};
    }
    if (tool.kind == Tool::Kind::Select && word.starts_with(kView)) {
        tool.angle = TRY(parse_view(word));
        return {};
    }
    for (auto const& argument : kArguments)
        if (argument.kind == tool.kind && argument.word == word) {
            argument.set(tool);
            return {};
        }
    auto const known = list_words(kArguments, [&](Argument const& argument) {
        return argument.kind == tool.kind ? argument.word : std::string_view {};
    });
    return fail(Fault::User,
                known.empty() ? fmt::format("the tool {} takes no \"{}\": leave it out", name, word)
                              : fmt::format("the tool {} does not know \"{}\": it knows {}", name,
                                            word, known));
}

} // namespace

Tool other_end_of(Tool const& tool, Tool::Erasing erasing)
{
    if (tool.kind == Tool::Kind::Press || tool.kind == Tool::Kind::Unknown)
        return tool;
    if (tool.kind == Tool::Kind::Select)
        return { .kind = Tool::Kind::Select, .selecting = Selecting::Take };
    return { .kind = Tool::Kind::Erase, .erasing = erasing };
}

bool is_tool_name(std::string_view name)
{
    return std::any_of(kTools.begin(), kTools.end(),
                       [&](auto const& tool) { return tool.first == name; });
}

Result<Tool> parse_tool(std::string_view name, std::string_view arguments)
{
    for (auto const& [known, kind] : kTools) {
        if (known != name)
            continue;
        Tool tool { .kind = kind };
        while (!arguments.empty()) {
            auto const word = arguments.substr(0, arguments.find(' '));
            arguments.remove_prefix(std::min(word.size() + 1, arguments.size()));
            if (!word.empty())
                TRY(take_argument(tool, name, word));
        }
        if (tool.at_once && !can_be_done_at_once(tool))
            return fail(Fault::User,
                        fmt::format("the tool {} needs a stroke: leave out \"{}\"", name, kNow));
        return tool;
    }
    return fail(Fault::User,
                fmt::format("there is no tool \"{}\": there are {}", name,
                            list_words(kTools, [](auto const& tool) { return tool.first; })));
}

ToolWords words_for(Tool const& tool)
{
    ToolWords words;
    for (auto const& [word, kind] : kTools)
        if (kind == tool.kind)
            words.name = word;
    // Each word that changes the tool with none, but not the tool itself, belongs to it.
    for (auto const& argument : kArguments) {
        Tool plain { .kind = tool.kind };
        Tool same = tool;
        argument.set(plain);
        argument.set(same);
        if (argument.kind == tool.kind && same == tool && plain != Tool { .kind = tool.kind })
            words.arguments
                += fmt::format("{}{}", words.arguments.empty() ? "" : " ", argument.word);
    }
    auto const add = [&](std::string_view word) {
        words.arguments += fmt::format("{}{}", words.arguments.empty() ? "" : " ", word);
    };
    if (tool.kind == Tool::Kind::Select && tool.angle != SelectionAngle {})
        add(view_word(tool.angle));
    if (tool.at_once)
        add(kNow);
    return words;
}

Result<std::vector<Edit>> edits_of(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    switch (tool.kind) {
    case Tool::Kind::Select:
        return select_edits(tool, stroke, scene);
    case Tool::Kind::Draw:
        return draw_edits(tool, stroke, scene);
    case Tool::Kind::Indicate:
        return indicate_edits(tool, stroke, scene);
    case Tool::Kind::DrawInOrder:
        return draw_in_order_edits(stroke, scene);
    case Tool::Kind::Oversketch:
    case Tool::Kind::Smooth:
    case Tool::Kind::Delete:
        return stroke_edits(tool.kind, stroke, scene);
    case Tool::Kind::MoveIndicator:
    case Tool::Kind::DeleteIndicator:
        return indicator_edits(tool.kind, stroke, scene);
    case Tool::Kind::Erase:
        return erase_edits(tool.erasing, stroke, scene);
    case Tool::Kind::Press:
        return std::vector<Edit> {};
    case Tool::Kind::Unknown:
        return fail(Fault::User, "this tractus does not know the tool that the stroke was for");
    }
    CHECK(false);
}

} // namespace tractus
