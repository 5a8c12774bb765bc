#include "app/tools/tool.h"

#include "engine/base/check.h"

#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

constexpr std::array<std::pair<std::string_view, Tool::Kind>, 4> kTools { {
    { "select", Tool::Kind::Select },
    { "draw", Tool::Kind::Draw },
    { "indicate", Tool::Kind::Indicate },
    { "draw_in_order", Tool::Kind::DrawInOrder },
} };

constexpr std::array<std::pair<std::string_view, Propagation>, 3> kPropagations { {
    { "selected", Propagation::Selected },
    { "descendants", Propagation::Descendants },
    { "both", Propagation::Both },
} };

Result<Propagation> parse_propagation(std::string_view word)
{
    if (word.empty())
        return Propagation::Selected;
    for (auto const& [name, propagation] : kPropagations)
        if (name == word)
            return propagation;
    return fail(Fault::User,
                fmt::format("the draw tool cannot reach \"{}\": it can reach selected, "
                            "descendants or both",
                            word));
}

} // namespace

Result<Tool> parse_tool(std::string_view name, std::string_view arguments)
{
    for (auto const& [word, kind] : kTools) {
        if (word != name)
            continue;
        Tool tool { .kind = kind };
        if (kind == Tool::Kind::Draw)
            tool.propagation = TRY(parse_propagation(arguments));
        return tool;
    }
    return fail(Fault::User,
                fmt::format("there is no tool \"{}\": there are select, draw, indicate "
                            "and draw_in_order",
                            name));
}

ToolWords words_for(Tool const& tool)
{
    ToolWords words;
    for (auto const& [word, kind] : kTools)
        if (kind == tool.kind)
            words.name = word;
    if (tool.kind == Tool::Kind::Draw)
        for (auto const& [word, propagation] : kPropagations)
            if (propagation == tool.propagation)
                words.arguments = word;
    return words;
}

Result<std::vector<Edit>> edits_of(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    switch (tool.kind) {
    case Tool::Kind::Select:
        return select_edits(stroke, scene);
    case Tool::Kind::Draw:
        return draw_edits(tool.propagation, stroke, scene);
    case Tool::Kind::Indicate:
        return indicate_edits(stroke);
    case Tool::Kind::DrawInOrder:
        return draw_in_order_edits(stroke, scene);
    }
    CHECK(false);
}

} // namespace tractus
