#include "app/methods/construction_lines/construct_report.h"

#include "engine/methods/construction_lines/line_model.h"

#include <nlohmann/json.hpp>

namespace tractus::lines {

using Report = nlohmann::ordered_json;

static Report print_functions(Construction const& construction)
{
    constexpr int kPlaces = 21;
    Report functions;
    for (int i = 0; i < kPlaces; ++i) {
        auto const values = values_at(construction, static_cast<double>(i) / (kPlaces - 1));
        functions["heading"].push_back(values.heading_deg);
        functions["depth"].push_back(values.pitch_deg);
        functions["alpha"].push_back(values.left_deg);
        functions["beta"].push_back(values.right_deg);
        functions["left_size"].push_back(values.left_size);
        functions["right_size"].push_back(values.right_size);
    }
    return functions;
}

// Organ sizes along each boundary in space, at the same places as the values of print_functions().
static Report print_boundaries(Construction const& construction)
{
    constexpr int kPlaces = 21;
    Report list = Report::array();
    for (auto const& side : construction.around) {
        // In this copy, the sizes of the boundary in space replace those of the left boundary.
        auto along = construction;
        for (std::size_t i = 0; i < along.nodes.size(); ++i)
            along.nodes[i].left_size = side.sizes[i];
        Report sizes;
        for (int i = 0; i < kPlaces; ++i)
            sizes.push_back(values_at(along, static_cast<double>(i) / (kPlaces - 1)).left_size);
        list.push_back({ { "azimuth", side.azimuth_deg }, { "size", sizes } });
    }
    return list;
}

// The measurements of one stem.
static Report print_stem(Construction const& construction)
{
    Report lines = Report::array();
    for (auto const& line : construction.inclinations)
        lines.push_back(line.x);
    Report node_x = Report::array();
    for (auto const& node : construction.nodes)
        node_x.push_back(node.x);
    Report report { { "stem_length", construction.stem.length_mm() },
                    { "lines", lines },
                    { "d1", construction.below() },
                    { "d2", construction.above() },
                    { "node_x", node_x },
                    { "functions", print_functions(construction) } };
    if (!construction.around.empty())
        report["boundaries"] = print_boundaries(construction);
    return report;
}

static Report print_stems(std::span<MeasuredStem const> stems)
{
    Report list = Report::array();
    for (auto const& stem : stems) {
        auto report = print_stem(stem.construction);
        report["stands_on"] = stem.parent ? Report(*stem.parent + 1) : Report();
        if (stem.parent)
            report["stands_at"] = stem.foot_x;
        list.push_back(std::move(report));
    }
    return list;
}

static Report print_roles(LineDrawing const& drawing)
{
    Report list = Report::array();
    for (std::size_t i = 0; i < drawing.roles.size(); ++i) {
        if (auto const line = drawing.lines_of_strokes[i])
            list.push_back({ { "role", drawing.roles[i] }, { "of", *line + 1 } });
        else
            list.push_back(drawing.roles[i]);
    }
    return list;
}

std::string print_report(std::span<MeasuredStem const> stems, Plant const& plant,
                         LineDrawing const& drawing)
{
    auto const& first = stems.front().construction;
    Report leaf_tips = Report::array();
    for (auto const& tip : organ_tips(first, plant))
        leaf_tips.push_back({ tip.x(), tip.y(), tip.z() });
    Report notes = Report::array();
    for (auto const& text : { drawing.notes, notes_of(stems) })
        for (auto const& note : text)
            notes.push_back(note);
    auto report = print_stem(first);
    report["leaf_tips"] = leaf_tips;
    report["notes"] = notes;
    if (stems.size() > 1)
        report["stems"] = print_stems(stems);
    if (!drawing.roles.empty()) {
        report["roles"] = print_roles(drawing);
        report["unplaced"] = Report::array();
        for (auto const stroke : drawing.unplaced)
            report["unplaced"].push_back(stroke + 1);
    }
    if (!drawing.roles.empty() && stems.size() > 1)
        for (auto const stem : drawing.stems_of_strokes)
            report["stroke_stems"].push_back(stem + 1);
    return report.dump() + "\n";
}

} // namespace tractus::lines
