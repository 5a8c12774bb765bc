#include "engine/lsystem/turtle/plant_rules.h"

#include "engine/base/check.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <vector>

namespace tractus::lsystem {

namespace {

constexpr double kRuledUnit_mm = 10;

// Converts a vector from the plant's space to cpfg's space, which models use.
Vec3 in_model(Vec3 const& v)
{
    return { v.x(), v.z(), 0 - v.y() };
}

// One segment, as a row of the model's arrays.
struct SegmentRow {
    Vec3 heading = Vec3::Zero();
    double length = 0; // Length in turtle units; widths have the same unit.
    double width = 0;  // Width of the segment at its base.
    double tip = -1;   // Width at the tip of the axis if the segment is its last; otherwise -1.
    // First segment of the first axis that is attached to this segment; -1 if there is none.
    std::int64_t bears = -1;
    // First segment of the next axis that is attached to the same parent segment; -1 if there is
    // none.
    std::int64_t other = -1;
    int depth = 0; // Number of derivation steps until the segment is drawn.
};

// Links an axis to its parent segment, or to the previous axis that is attached to that segment.
// Returns the number of derivation steps until the axis's first segment is drawn.
int stand_on(Axis const& axis, std::vector<SegmentRow>& rows, std::vector<std::int64_t>& last)
{
    if (axis.parent_segment == kNone)
        return 1;
    auto& before = last[axis.parent_segment];
    auto& row = before < 0 ? rows[axis.parent_segment] : rows[static_cast<std::size_t>(before)];
    (before < 0 ? row.bears : row.other) = static_cast<std::int64_t>(axis.first_segment);
    int const steps = before < 0 ? 2 : 1;
    before = static_cast<std::int64_t>(axis.first_segment);
    return row.depth + steps;
}

std::vector<SegmentRow> rows_of(Plant const& plant)
{
    std::vector<SegmentRow> rows(plant.segment_count());
    // For each segment, the first segment of the last axis attached to it so far.
    std::vector<std::int64_t> last(plant.segment_count(), -1);
    for (auto const& axis : plant.axes) {
        int const depth = stand_on(axis, rows, last);
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto& row = rows[axis.first_segment + i];
            auto const node = axis.first_node + i;
            Vec3 const step
                = in_model(plant.node_position_mm[node + 1] - plant.node_position_mm[node])
                / kRuledUnit_mm;
            row.length = step.norm();
            row.heading = row.length > 0 ? Vec3(step / row.length) : Vec3(Vec3::UnitY());
            row.width = 2 * static_cast<double>(plant.node_radius_mm[node]) / kRuledUnit_mm;
            row.depth = depth + static_cast<int>(i);
            if (i + 1 == axis.segment_count)
                row.tip = 2 * static_cast<double>(plant.node_radius_mm[node + 1]) / kRuledUnit_mm;
        }
    }
    return rows;
}

template<typename Value>
void write_array(std::string& text, char const* name, std::vector<SegmentRow> const& rows,
                 Value const& value)
{
    fmt::format_to(std::back_inserter(text), "array {}[{}] = {{", name, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{}{}",
                       i == 0           ? ""
                           : i % 8 == 0 ? ",\n"
                                        : ",",
                       value(rows[i]));
    text += "};\n";
}

} // namespace

std::string rules_of_plant(Plant const& plant)
{
    CHECK(plant.segment_count() <= kMaxRuledSegments);
    auto const rows = rows_of(plant);
    int steps = 0;
    for (auto const& row : rows)
        steps = std::max(steps, row.depth);
    std::string text = fmt::format("/* A plant of {} segments, each a place in these arrays: its\n"
                                   "   heading, length and width, the width of a tip, and which\n"
                                   "   branch it bears. */\n"
                                   "Lsystem: 1\nderivation length: {}\n",
                                   rows.size(), steps);
    if (rows.empty())
        return text + "Axiom: X\nendlsystem\n";
    auto const single = [](double value) { return static_cast<float>(value); };
    text += "Define: {\n";
    write_array(text, "x", rows, [&](auto const& row) { return single(row.heading.x()); });
    write_array(text, "y", rows, [&](auto const& row) { return single(row.heading.y()); });
    write_array(text, "z", rows, [&](auto const& row) { return single(row.heading.z()); });
    write_array(text, "len", rows, [&](auto const& row) { return single(row.length); });
    write_array(text, "wide", rows, [&](auto const& row) { return single(row.width); });
    write_array(text, "tip", rows, [&](auto const& row) { return single(row.tip); });
    write_array(text, "bears", rows, [](auto const& row) { return row.bears; });
    write_array(text, "other", rows, [](auto const& row) { return row.other; });
    text += "}\n";
    std::string axiom;
    for (auto const& axis : plant.axes) {
        if (axis.parent_segment != kNone)
            continue;
        Vec3 const base = in_model(plant.node_position_mm[axis.first_node]) / kRuledUnit_mm;
        axiom += fmt::format("[@M({},{},{})S({})]", single(base.x()), single(base.y()),
                             single(base.z()), axis.first_segment);
    }
    return text + "Axiom: " + axiom
        + "\n/* A segment, the branches on its end, and what follows on the axis. */\n"
          "S(i) : tip[i] < 0 --> !(wide[i])@R(x[i],y[i],z[i])F(len[i])B(bears[i])S(i+1)\n"
          "S(i) --> !(wide[i])@R(x[i],y[i],z[i])F(len[i])!(tip[i])B(bears[i])\n"
          "B(i) : i >= 0 --> [S(i)]B(other[i])\n"
          "B(i) --> *\nendlsystem\n";
}

} // namespace tractus::lsystem
