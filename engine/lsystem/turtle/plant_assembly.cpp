#include "engine/lsystem/turtle/plant_assembly.h"

#include "engine/base/bulk_vector.h"
#include "engine/base/parallel.h"
#include "engine/base/random.h"
#include "engine/lsystem/turtle/organ_catalogue.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace tractus::lsystem {

namespace {

// Random stream that selects one of several grown leaves for an organ.
constexpr std::uint32_t kLeafStream = 0x6C66;

// For each array of a plant, a number of elements or an offset.
struct Counts {
    std::size_t axes = 0;
    std::size_t segments = 0;
    std::size_t organs = 0;
    std::size_t polygons = 0;
    std::size_t polygon_vertices = 0;
};

// What a piece draws between two of its gaps: its offsets in the piece and in the plant.
struct Run {
    Counts from;
    Counts to;
};

// Position of a piece's axes and segments among those of the assembled plant.
struct Target {
    std::vector<Run> runs;
    // For each axis of the piece, the number of segments before it; then the total number.
    std::vector<std::uint32_t> segments_before;
    // Branching order of each axis relative to the lowest order in the piece.
    std::vector<std::uint32_t> orders;
    std::vector<AxisId> axis_ids;
    // First segment of each axis, as its number in the plant.
    std::vector<SegmentId> first_segments;
    SegmentId root_segment = kNone;
    AxisId root_axis = kNone;
    std::uint32_t lowest_order = 0;
};

class Assembly {
public:
    Assembly(View const& view, double unit_mm, std::span<DrawnPiece> pieces, Plant drawn)
        : view_(view)
        , pieces_(pieces)
        , catalogue_(view, unit_mm, pieces)
        , targets_(pieces.size())
        , has_segments_(!drawn.axes.empty())
        , plant_(std::move(drawn))
    {
    }

    Plant run()
    {
        for_each_piece([&](std::size_t i) { measure(i); });
        lay_out();
        for_each_piece([&](std::size_t i) { number(i); });
        find_roots();
        allocate();
        for_each_piece([&](std::size_t i) {
            write_axes(i);
            write_segments(i);
            write_organs(i);
            write_polygons(i);
            write_sections(i);
        });
        if (has_segments_)
            set_materials();
        plant_.materials = catalogue_.take_materials();
        plant_.organ_shapes = catalogue_.take_shapes();
        return std::move(plant_);
    }

private:
    template<typename Work> void for_each_piece(Work const& work)
    {
        parallel_for(pieces_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                work(i);
        });
    }

    void measure(std::size_t piece);
    void lay_out();
    void end_run(std::size_t piece, Counts const& end);
    Counts counts_at(std::size_t piece, std::size_t gap) const;
    void number(std::size_t piece);
    void find_roots();
    void allocate();
    void write_axes(std::size_t piece);
    void write_segments(std::size_t piece);
    void write_organs(std::size_t piece);
    void write_polygons(std::size_t piece);
    void write_sections(std::size_t piece);
    void set_materials();

    // Converts the number of a segment in its piece to its number in the plant.
    SegmentId segment_id(std::size_t piece, std::uint32_t segment) const
    {
        auto const& target = targets_[piece];
        if (segment == kNone || has_segments_)
            return segment;
        if (segment == TurtleDrawing::kBelow)
            return target.root_segment;
        auto const& drawn = pieces_[piece].drawing.segments[segment];
        return target.first_segments[drawn.axis] + drawn.index;
    }

    View const& view_;
    std::span<DrawnPiece> pieces_;
    OrganCatalogue catalogue_;
    std::vector<Target> targets_; // Where each piece is placed in the plant.
    Counts total_;
    // True if axes and segments are already in the plant, with turtle colours in place of
    // materials.
    bool has_segments_;
    Plant plant_;
};

void Assembly::measure(std::size_t piece)
{
    auto const& drawing = pieces_[piece].drawing;
    auto& target = targets_[piece];
    target.segments_before.resize(drawing.axes.size() + 1);
    target.orders.resize(drawing.axes.size());
    for (std::size_t i = 0; i < drawing.axes.size(); ++i) {
        auto const& axis = drawing.axes[i];
        target.segments_before[i + 1] = target.segments_before[i] + axis.segment_count;
        if (axis.parent_segment < TurtleDrawing::kBelow)
            target.orders[i] = target.orders[drawing.segments[axis.parent_segment].axis] + 1;
    }
}

// Returns the numbers of elements that a piece has drawn before gap `gap`; after the last gap, in
// total.
Counts Assembly::counts_at(std::size_t piece, std::size_t gap) const
{
    auto const& drawing = pieces_[piece].drawing;
    Counts counts { drawing.axes.size(), 0, drawing.organs.size(), drawing.polygons.size(),
                    drawing.polygon_vertices_mm.size() };
    if (gap < drawing.gaps.size()) {
        auto const& at = drawing.gaps[gap];
        counts.axes = at.axis_count;
        counts.organs = at.organ_count;
        counts.polygons = at.polygon_count;
        if (at.polygon_count < drawing.polygons.size())
            counts.polygon_vertices = drawing.polygons[at.polygon_count].first_vertex;
    }
    counts.segments = targets_[piece].segments_before[counts.axes];
    return counts;
}

// Computes the offsets of each run by visiting the pieces in the order of the string.
void Assembly::lay_out()
{
    struct Visit {
        std::size_t piece = 0;
        std::size_t gap = 0; // Index of the next gap of the piece to visit.
        Counts done;
    };
    std::vector<Visit> visits { {} };
    while (!visits.empty()) {
        auto& visit = visits.back();
        auto const piece = visit.piece;
        auto const& gaps = pieces_[piece].drawing.gaps;
        auto const now = counts_at(piece, visit.gap);
        targets_[piece].runs.push_back({ visit.done, total_ });
        total_.axes += now.axes - visit.done.axes;
        total_.segments += now.segments - visit.done.segments;
        total_.organs += now.organs - visit.done.organs;
        total_.polygons += now.polygons - visit.done.polygons;
        total_.polygon_vertices += now.polygon_vertices - visit.done.polygon_vertices;
        visit.done = now;
        if (visit.gap == gaps.size())
            visits.pop_back();
        else
            // The push invalidates the reference `visit`.
            visits.push_back({ gaps[visit.gap++].piece, 0, {} });
    }
}

void Assembly::number(std::size_t piece)
{
    auto& target = targets_[piece];
    auto const count = pieces_[piece].drawing.axes.size();
    target.axis_ids.resize(count);
    target.first_segments.resize(count);
    for (std::size_t r = 0; r < target.runs.size(); ++r) {
        auto const& run = target.runs[r];
        auto const end = r + 1 < target.runs.size() ? target.runs[r + 1].from.axes : count;
        for (auto i = run.from.axes; i < end; ++i) {
            target.axis_ids[i] = static_cast<AxisId>(run.to.axes + i - run.from.axes);
            target.first_segments[i] = static_cast<SegmentId>(
                run.to.segments + target.segments_before[i] - run.from.segments);
        }
    }
}

void Assembly::find_roots()
{
    for (std::size_t i = 1; i < pieces_.size(); ++i) {
        auto const parent = pieces_[i].parent;
        auto const& below = targets_[parent];
        auto const segment = pieces_[i].root_segment;
        auto& target = targets_[i];
        target.root_segment = segment_id(parent, segment);
        if (segment == TurtleDrawing::kBelow) {
            target.root_axis = below.root_axis;
            target.lowest_order = below.lowest_order;
        } else if (segment != kNone) {
            auto const axis = pieces_[parent].drawing.segments[segment].axis;
            target.root_axis = below.axis_ids[axis];
            target.lowest_order = below.lowest_order + below.orders[axis] + 1;
        }
    }
}

void Assembly::allocate()
{
    if (!has_segments_)
        make_room(plant_, total_.axes, total_.segments);
    resize_empty(plant_.organs, total_.organs);
    resize_empty(plant_.polygons, total_.polygons);
    resize_empty(plant_.polygon_vertices_mm, total_.polygon_vertices);
    if (std::any_of(pieces_.begin(), pieces_.end(),
                    [](auto const& piece) { return !piece.drawing.sections.empty(); })) {
        plant_.node_section.resize(plant_.node_position_mm.size());
        for (auto const& [id, contour] : view_.contours)
            plant_.contours.push_back(contour);
    }
}

void Assembly::write_axes(std::size_t piece)
{
    auto const& drawing = pieces_[piece].drawing;
    auto const& target = targets_[piece];
    for (std::size_t i = 0; i < drawing.axes.size(); ++i) {
        auto const& drawn = drawing.axes[i];
        auto const id = target.axis_ids[i];
        auto& axis = plant_.axes[id];
        axis.first_segment = target.first_segments[i];
        axis.first_node = axis.first_segment + id;
        axis.segment_count = drawn.segment_count;
        axis.parent_segment = segment_id(piece, drawn.parent_segment);
        if (drawn.parent_segment < TurtleDrawing::kBelow)
            axis.parent_axis = target.axis_ids[drawing.segments[drawn.parent_segment].axis];
        else if (drawn.parent_segment == TurtleDrawing::kBelow)
            axis.parent_axis = target.root_axis;
        axis.order = target.lowest_order + target.orders[i];
        plant_.node_position_mm[axis.first_node] = drawn.base_mm;
        plant_.node_radius_mm[axis.first_node + axis.segment_count] = drawn.tip_radius_mm;
    }
}

void Assembly::write_segments(std::size_t piece)
{
    auto const& target = targets_[piece];
    for (auto const& drawn : pieces_[piece].drawing.segments) {
        auto const segment = target.first_segments[drawn.axis] + drawn.index;
        auto const node = segment + target.axis_ids[drawn.axis];
        plant_.node_position_mm[node + 1] = drawn.tip_mm;
        plant_.node_radius_mm[node] = drawn.radius_mm;
        plant_.segment_material[segment] = catalogue_.material(drawn.color);
    }
}

void Assembly::write_organs(std::size_t piece)
{
    auto const& drawing = pieces_[piece].drawing;
    auto const& runs = targets_[piece].runs;
    struct Shapes {
        OrganShapeId first = 0;
        std::size_t count = 1;
    };
    std::vector<Shapes> shapes;
    for (auto const& key : drawing.shape_keys)
        shapes.push_back({ catalogue_.shape(key), catalogue_.variants(key) });
    std::size_t run = 0;
    for (std::size_t i = 0; i < drawing.organs.size(); ++i) {
        while (run + 1 < runs.size() && runs[run + 1].from.organs <= i)
            ++run;
        auto const number = runs[run].to.organs + i - runs[run].from.organs;
        auto& organ = plant_.organs[number];
        organ = drawing.organs[i];
        auto const [first, count] = shapes[organ.shape];
        organ.shape = first;
        if (count > 1)
            organ.shape = static_cast<OrganShapeId>(
                first + random_block({ .stream = kLeafStream }, number)[0] % count);
        organ.segment = segment_id(piece, organ.segment);
    }
}

void Assembly::write_polygons(std::size_t piece)
{
    auto const& drawing = pieces_[piece].drawing;
    auto const& runs = targets_[piece].runs;
    std::size_t run = 0;
    for (std::size_t i = 0; i < drawing.polygons.size(); ++i) {
        while (run + 1 < runs.size() && runs[run + 1].from.polygons <= i)
            ++run;
        auto const& [from, to] = runs[run];
        auto& polygon = plant_.polygons[to.polygons + i - from.polygons];
        polygon = drawing.polygons[i];
        polygon.segment = segment_id(piece, polygon.segment);
        polygon.material = catalogue_.material(static_cast<std::uint8_t>(polygon.material));
        polygon.first_vertex = static_cast<std::uint32_t>(to.polygon_vertices + polygon.first_vertex
                                                          - from.polygon_vertices);
        std::copy_n(drawing.polygon_vertices_mm.begin() + drawing.polygons[i].first_vertex,
                    polygon.vertex_count,
                    plant_.polygon_vertices_mm.begin() + polygon.first_vertex);
    }
}

void Assembly::write_sections(std::size_t piece)
{
    auto const& target = targets_[piece];
    for (auto const& drawn : pieces_[piece].drawing.sections)
        plant_.node_section[target.first_segments[drawn.axis] + target.axis_ids[drawn.axis]
                            + drawn.node]
            = drawn.section;
}

void Assembly::set_materials()
{
    auto& materials = plant_.segment_material;
    parallel_for(materials.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            materials[i] = catalogue_.material(static_cast<std::uint8_t>(materials[i]));
    });
}

} // namespace

// Initialises the arrays in several threads.
void make_room(Plant& plant, std::size_t axis_count, std::size_t segment_count)
{
    auto const nodes = segment_count + axis_count;
    std::array<std::function<void()>, 3> const tasks {
        [&] { resize_empty(plant.node_position_mm, nodes); },
        [&] { resize_empty(plant.axes, axis_count); },
        [&] {
            resize_empty(plant.node_radius_mm, nodes);
            resize_empty(plant.segment_material, segment_count);
        },
    };
    parallel_for(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i)
            tasks[i]();
    });
}

Plant assemble_plant(View const& view, double unit_mm, std::span<DrawnPiece> pieces, Plant drawn)
{
    return Assembly(view, unit_mm, pieces, std::move(drawn)).run();
}

} // namespace tractus::lsystem
