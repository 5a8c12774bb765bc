#include "app/methods/sketch_lsystem/shorten_sketch_tool.h"

#include "app/tools/bent_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/paper.h"
#include "engine/stroke/polyline.h"

#include <optional>

namespace tractus::sketch {

namespace {

// Position at which a point is seen on the tablet or on the paper.
Vec2 seen_at(Vec3 const& point_mm, StrokeSurface surface, scene::Scene const& scene)
{
    return surface == StrokeSurface::Paper ? scene::paper_of(scene.state).sheet_of_world(point_mm)
                                           : Vec2(point_mm.head<2>());
}

double distance_mm(Vec2 const& point_mm, Vec2 const& from_mm, Vec2 const& to_mm)
{
    double const share = nearest_share(point_mm, from_mm, to_mm);
    return (from_mm + share * (to_mm - from_mm) - point_mm).norm();
}

// The segments, in the built plant, of the axis that the stroke drew. The branch may continue
// beyond this axis.
Result<std::vector<SegmentId>> drawn_axis(scene::Scene const& scene, sketch::GrownPart const& grown)
{
    std::vector<SegmentId> axis;
    auto const count = TRY(sketch::drawn_nodes_mm(*grown.sketch)).size() - 1;
    auto const prefix = grown.part == 0 ? PartPrefix {} : part_prefix(grown.part);
    for (std::uint32_t i = 0; i < count; ++i) {
        auto const segment
            = scene.rest->addresses.find_segment(*scene.base, in_part(prefix, { 0, i }));
        if (!segment)
            break;
        axis.push_back(*segment);
    }
    return axis;
}

// Number of the axis's segments before the first one that the eraser touches; no value if it
// touches none.
std::optional<std::size_t> untouched(Stroke const& eraser, std::vector<SegmentId> const& axis,
                                     StrokeSurface surface, scene::Scene const& scene)
{
    tools::BentPlant const bent(scene);
    for (std::size_t i = 0; i < axis.size(); ++i) {
        auto const from_mm = seen_at(bent.begin_of(axis[i]), surface, scene);
        auto const to_mm = seen_at(bent.end_of(axis[i]), surface, scene);
        for (auto const& tip : eraser.tips)
            if (distance_mm(tip.position_mm.head<2>(), from_mm, to_mm)
                <= ShortenSketchTool::kRadius_mm)
                return i;
    }
    return std::nullopt;
}

// The eraser first erases strokes and indicators drawn on the plant. Only if it touches none of
// these does it shorten the plant's stroke.
Result<std::vector<scene::Edit>> shorten(tools::Tool const&, Stroke const& stroke,
                                         scene::Scene const& scene)
{
    if (auto erased = tools::Tool(tools::EraseTool {}).edits_for(stroke, scene))
        return erased;
    auto const grown = sketch::newest_grown(*scene.drawn);
    if (!grown)
        return fail(Fault::User,
                    "the plant that takes what is drawn has not grown along a stroke: choose one "
                    "that has");
    auto const left
        = untouched(stroke, TRY(drawn_axis(scene, *grown)), grown->sketch->surface, scene);
    if (!left)
        return fail(Fault::User,
                    "the eraser touched nothing of the axis that was drawn: move it over the axis");
    if (*left == 0)
        return fail(Fault::User,
                    "nothing of the stroke would be left: remove the plant to take it away");
    auto const tips = TRY(sketch::count_tips(*grown->sketch, *left));
    return std::vector<scene::Edit> { sketch::ShortenSketch { scene.drawn->id, grown->part,
                                                              tips.value_or(0) } };
}

} // namespace

constexpr tools::ToolKind ShortenSketchTool::kKind {
    .word = "shorten_sketch",
    .label = "Shorten",
    .title = "Shorten the stroke of a plant",
    .done = "The plant is that of the shorter stroke",
    .help = "takes the end of the stroke away along which a rule has grown, from where this one "
            "runs over the plant's axis; but first strokes and indicators that it runs over",
    .group = "Sketch",
    .method = "Along a stroke",
    .min_extent_mm = 2,
    .ink = { tools::InkStyle::Look::Eraser, 2 * ShortenSketchTool::kRadius_mm },
    .options = tools::options_type<ShortenSketchTool>(),
    .edits_for = shorten,
    .other_end = { &ShortenSketchTool::kKind },
};

} // namespace tractus::sketch
