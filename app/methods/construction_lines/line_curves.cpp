#include "app/methods/construction_lines/line_curves.h"

#include "app/methods/construction_lines/touched_sketch.h"
#include "engine/methods/construction_lines/bend_lines.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

using lines::Construction;
using lines::StemSide;

constexpr double kLow = -0.9; // Height of the stem's base in the gizmo's frame.
constexpr double kHigh = 0.9; // Height of the stem's tip in the gizmo's frame.
constexpr int kSamples = 60;
// Minimum value at the outer edge of the columns of sizes, as a share of the stem's length.
constexpr double kMinRange = 0.6;

// A column of the gizmo's right half, from x = `from` to `to`. The left half mirrors it. Values
// increase outwards from the gizmo's middle.
struct Column {
    double from = 0;
    double to = 1;
    double range = 1; // Value at the column's outer edge; it is 0 at the inner edge.

    double place(double value) const { return from + (to - from) * value / range; }
    double value(double place) const
    {
        return std::clamp((place - from) / (to - from), 0.0, 1.0) * range;
    }
};

// Half the width of the middle column, which shows the stem's heading.
constexpr double kHeadingHalf = 0.13;
constexpr double kHeadingRange_deg = 90; // Heading at the edge of the middle column.
constexpr Column kAngles { 0.56, 0.98, 150 };
constexpr double kSizesFrom = 0.18;
constexpr double kSizesTo = 0.52;

enum class What { Angle, Size, Fewer, More, Heading, Internode };
constexpr std::size_t kWhats = 6;

// What a handle sets. The handle's id encodes it.
struct HandleName {
    What what = What::Angle;
    StemSide side = StemSide::Left;
    // Index of the inclination line, of the place along the stem, or of the layer, depending on
    // `what`.
    std::size_t number = 0;

    std::size_t id() const
    {
        return (number * kWhats + static_cast<std::size_t>(what)) * 2
            + (side == StemSide::Right ? 1 : 0);
    }
    static HandleName of(std::size_t id)
    {
        return { static_cast<What>(id / 2 % kWhats), id % 2 == 1 ? StemSide::Right : StemSide::Left,
                 id / 2 / kWhats };
    }
};

double sign_of(StemSide side)
{
    return side == StemSide::Right ? 1 : -1;
}

double height_of(double x)
{
    return kLow + (kHigh - kLow) * x;
}

double angle_of(lines::FunctionValues const& values, StemSide side)
{
    return side == StemSide::Left ? values.left_deg : values.right_deg;
}

double size_of(lines::FunctionValues const& values, StemSide side)
{
    return side == StemSide::Left ? values.left_size : values.right_size;
}

// The active plant's sketch, and the values that its curves show.
struct Shown {
    ActiveSketch active;
    Construction construction;
    bool has_sizes = false; // True if the sketch has at least one boundary.
    // True if the sketch has a boundary and at least two inclination lines.
    bool has_angles = false;
    Column sizes;

    double size_seen(double x, StemSide side) const
    {
        return size_of(lines::values_at(construction, x), side);
    }
};

// Value at the outer edge of the columns of sizes, if `largest` is the largest size. It grows in
// steps, so that the scale does not change continually while the user drags a size.
double range_for(double largest)
{
    double range = kMinRange;
    while (range < 1.2 * largest)
        range *= 2;
    return range;
}

Result<Shown> shown_of(scene::Scene const& scene)
{
    auto active = TRY(active_sketch(scene));
    auto construction = TRY(lines::construction_of(active.sketch));
    auto const drawn = TRY(lines::line_sketch(active.sketch));
    double largest = 0;
    for (auto const& node : construction.nodes)
        largest = std::max({ largest, node.left_size, node.right_size });
    bool const has_sizes = lines::has_boundary(drawn);
    return Shown { .active = std::move(active),
                   .construction = std::move(construction),
                   .has_sizes = has_sizes,
                   .has_angles = has_sizes && drawn.inclinations.size() >= 2,
                   .sizes = { kSizesFrom, kSizesTo, range_for(largest) } };
}

tools::Gizmo::Line axis_at(double place)
{
    return { .points = { { place, kLow }, { place, kHigh } }, .width = 0.006 };
}

template<typename Value>
tools::Gizmo::Line curve_of(Value const& value, tools::LayerStyle::Color color)
{
    tools::Gizmo::Line curve { .points = {}, .width = 0.016, .color = color };
    for (int i = 0; i <= kSamples; ++i) {
        double const x = static_cast<double>(i) / kSamples;
        curve.points.emplace_back(value(x), height_of(x));
    }
    return curve;
}

double heading_at(Shown const& shown, double x)
{
    return lines::values_at(shown.construction, x).heading_deg;
}

// Horizontal place of a heading in the middle column; headings outside the column's range are
// placed at its edge.
double place_of_heading(double heading_deg)
{
    return std::clamp(-kHeadingHalf * heading_deg / kHeadingRange_deg, -kHeadingHalf, kHeadingHalf);
}

void add_stem(tools::Gizmo& gizmo, Shown const& shown)
{
    gizmo.lines.push_back(axis_at(0));
    gizmo.lines.push_back(curve_of([&](double x) { return place_of_heading(heading_at(shown, x)); },
                                   tools::LayerStyle::Color::Green));
    for (std::size_t i = 0; i < lines::kHeadingPlaces.size(); ++i) {
        double const x = lines::kHeadingPlaces[i];
        double const heading_deg = heading_at(shown, x);
        gizmo.handles.push_back({ .id = HandleName { What::Heading, StemSide::Left, i }.id(),
                                  .place = { place_of_heading(heading_deg), height_of(x) },
                                  .says = fmt::format("Stem: {:.0f}\u00b0", heading_deg),
                                  .is_small = true });
    }
    constexpr double kTick = 0.03;
    for (auto const& node : shown.construction.nodes)
        gizmo.lines.push_back(
            { .points = { { -kTick, height_of(node.x) }, { kTick, height_of(node.x) } },
              .width = 0.006 });
}

void add_curves(tools::Gizmo& gizmo, Shown const& shown, StemSide side)
{
    double const sign = sign_of(side);
    gizmo.lines.push_back(axis_at(sign * kSizesFrom));
    gizmo.lines.push_back(axis_at(sign * kAngles.from));
    gizmo.lines.push_back(
        curve_of([&](double x) { return sign * shown.sizes.place(shown.size_seen(x, side)); },
                 tools::LayerStyle::Color::Orange));
    gizmo.lines.push_back(curve_of(
        [&](double x) {
            auto const values = lines::values_at(shown.construction, x);
            return sign * std::min(kAngles.place(angle_of(values, side)), kAngles.to);
        },
        tools::LayerStyle::Color::Blue));
}

char const* name_of(StemSide side)
{
    return side == StemSide::Left ? "left" : "right";
}

void add_handles(tools::Gizmo& gizmo, Shown const& shown, StemSide side)
{
    double const sign = sign_of(side);
    auto const& of = shown.construction;
    for (std::size_t i = 0; shown.has_angles && i < of.inclinations.size(); ++i) {
        auto const& line = of.inclinations[i];
        double const angle_deg = side == StemSide::Left ? line.left_deg : line.right_deg;
        gizmo.handles.push_back(
            { .id = HandleName { What::Angle, side, i }.id(),
              .place = { sign * std::min(kAngles.place(angle_deg), kAngles.to), height_of(line.x) },
              .says = fmt::format("Line {}, {}: {:.0f}\u00b0", i + 1, name_of(side), angle_deg),
              .is_small = true });
    }
    auto const places = lines::size_places(of);
    for (std::size_t i = 0; i < places.size(); ++i) {
        double const size = shown.size_seen(places[i], side);
        gizmo.handles.push_back(
            { .id = HandleName { What::Size, side, i }.id(),
              .place = { sign * shown.sizes.place(size), height_of(places[i]) },
              .says = fmt::format("Size {}: {:.0f} % of the stem", name_of(side), 100 * size),
              .is_small = true });
    }
}

// Adds the two buttons of a layer: fewer nodes on the left, more nodes on the right.
void add_layer(tools::Gizmo& gizmo, lines::Layer const& layer, std::size_t number)
{
    constexpr double kBeside = 0.09;
    for (auto const side : { StemSide::Left, StemSide::Right })
        gizmo.handles.push_back(
            { .id
              = HandleName { side == StemSide::Left ? What::Fewer : What::More, side, number }.id(),
              .place = { sign_of(side) * kBeside, height_of((layer.from_x + layer.to_x) / 2) },
              .says = fmt::format("Layer {}: {} nodes", number + 1, layer.nodes),
              .sign = side == StemSide::Left ? "-" : "+",
              .is_button = true,
              .is_small = true });
}

// Adds the handle that sets the internode length of a layer. It is at the height of the layer's
// second node.
void add_internode(tools::Gizmo& gizmo, lines::Layer const& layer, std::size_t number)
{
    constexpr double kBeside = 0.15;
    if (layer.nodes == 0)
        return;
    double const internode = (layer.to_x - layer.from_x) / layer.nodes;
    double const height = height_of(layer.from_x + internode);
    gizmo.lines.push_back({ .points = { { 0, height }, { kBeside, height } }, .width = 0.006 });
    gizmo.handles.push_back({ .id = HandleName { What::Internode, StemSide::Right, number }.id(),
                              .place = { kBeside, height },
                              .says = fmt::format("Layer {}: a node every {:.1f} % of the stem",
                                                  number + 1, 100 * internode),
                              .is_small = true });
}

void add_labels(tools::Gizmo& gizmo)
{
    constexpr double kBelow = kLow - 0.03;
    constexpr double kSizes = (kSizesFrom + kSizesTo) / 2;
    constexpr double kInclinations = (kAngles.from + kAngles.to) / 2;
    gizmo.labels = { { { -kInclinations, kBelow }, "Angle" },
                     { { -kSizes, kBelow }, "Size" },
                     { { 0, kBelow }, "Stem" },
                     { { kSizes, kBelow }, "Size" },
                     { { kInclinations, kBelow }, "Angle" } };
}

std::optional<tools::Gizmo> show(scene::Scene const& scene)
{
    auto const shown = shown_of(scene);
    if (!shown)
        return std::nullopt;
    tools::Gizmo gizmo;
    gizmo.hint = "Drag a curve";
    add_labels(gizmo);
    add_stem(gizmo, *shown);
    if (!shown->has_sizes)
        return gizmo;
    for (auto const side : { StemSide::Left, StemSide::Right }) {
        add_curves(gizmo, *shown, side);
        add_handles(gizmo, *shown, side);
    }
    if (auto const layers = lines::layers_of(shown->active.sketch))
        for (std::size_t i = 0; i < layers->size(); ++i) {
            add_layer(gizmo, (*layers)[i], i);
            add_internode(gizmo, (*layers)[i], i);
        }
    return gizmo;
}

Result<std::vector<scene::Edit>> with_other_count(ActiveSketch const& active, std::size_t number,
                                                  int by)
{
    auto const layers = TRY(lines::layers_of(active.sketch));
    if (number >= layers.size())
        return fail(Fault::User, "the sketch has no such layer any more");
    auto const& layer = layers[number];
    int const nodes = std::clamp(layer.nodes + by, 0, lines::kMaxNodesInLayer);
    return std::vector<scene::Edit> { lines::SetLayerNodes { active.plant, layer.line, nodes } };
}

// Sets the layer's number of nodes to the number that fits if its second node is at the place `x`,
// a share of the stem's length.
Result<std::vector<scene::Edit>> with_internode(ActiveSketch const& active, std::size_t number,
                                                double x)
{
    auto const layers = TRY(lines::layers_of(active.sketch));
    if (number >= layers.size())
        return fail(Fault::User, "the sketch has no such layer any more");
    auto const& layer = layers[number];
    double const length = layer.to_x - layer.from_x;
    double const internode = std::clamp(x - layer.from_x, length / lines::kMaxNodesInLayer, length);
    return std::vector<scene::Edit> { lines::SetLayerNodes {
        active.plant, layer.line, static_cast<int>(std::lround(length / internode)) } };
}

Result<std::vector<scene::Edit>> with_other_heading(Shown const& shown, std::size_t place,
                                                    double to)
{
    if (place >= lines::kHeadingPlaces.size())
        return fail(Fault::User, "the stem has no such place");
    auto const stem = TRY(lines::current_stem(shown.active.sketch));
    double const heading_deg = std::round(-kHeadingRange_deg * to / kHeadingHalf);
    return std::vector<scene::Edit> { lines::BendStem {
        shown.active.plant, lines::first_stem(lines::sketch_of_stem(shown.active.sketch, stem)).id,
        static_cast<int>(place),
        std::clamp(heading_deg, -lines::kGreatestHeading_deg, lines::kGreatestHeading_deg) } };
}

// Edits for a handle that was dragged or pressed. Angles are rounded to whole degrees, sizes to
// hundredths of the stem's length.
Result<std::vector<scene::Edit>> drag(scene::Scene const& scene, std::size_t handle, Vec2 const& to)
{
    auto const shown = TRY(shown_of(scene));
    auto const [what, side, number] = HandleName::of(handle);
    if (what == What::Fewer || what == What::More)
        return with_other_count(shown.active, number, what == What::More ? 1 : -1);
    if (what == What::Heading)
        return with_other_heading(shown, number, to.x());
    if (what == What::Internode)
        return with_internode(shown.active, number, (to.y() - kLow) / (kHigh - kLow));
    double const outwards = sign_of(side) * to.x();
    auto const& sketch = shown.active.sketch;
    auto const bent
        = TRY(what == What::Angle
                  ? lines::with_angle(sketch, number, side,
                                      std::clamp(std::round(kAngles.value(outwards)),
                                                 lines::kMinAngle_deg, lines::kGreatestAngle_deg))
                  : lines::with_size(sketch, number, side,
                                     std::clamp(std::round(100 * shown.sizes.value(outwards)) / 100,
                                                lines::kMinSize, lines::kGreatestSize)));
    return std::vector<scene::Edit> { lines::RedrawLine { shown.active.plant, bent.line,
                                                          bent.stroke } };
}

} // namespace

constexpr tools::DrawnGizmoKind kLineCurves { .title = "Curves", .show = show, .drag = drag };

} // namespace tractus::lines
