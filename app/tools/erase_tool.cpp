#include "app/tools/erase_tool.h"

#include "app/tools/branch_previewer.h"
#include "engine/scene/edit.h"
#include "engine/stroke/erase_tips.h"
#include "engine/stroke/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tractus::tools {

namespace {

constexpr double kRadius_mm = EraseTool::kRadius_mm;

// Option words, in the order of EraseExtent.
constexpr std::array<OptionWord, 2> kErasingWords { {
    { "whole", "Whole strokes", "Erase whole strokes" },
    { "part", "What it touches", "Erase what the pen touches" },
} };

void visit(OptionVisitor& visitor, EraseTool& tool)
{
    visitor.choice({ kErasingWords }, tool.erasing);
}

// The eraser touches lines below the surface, and up to kSeenAbove_mm above it, as these are
// visible. Of a touched stroke it erases the parts down to kEraserDepth_mm below the stroke's
// highest point under the eraser. This depth is the eraser's width, so that erasing the top of a
// vertical stroke does not erase all of it.
constexpr double kSeenAbove_mm = 1;
constexpr double kEraserDepth_mm = 2 * kRadius_mm;

// Finds the greatest height of a polyline under the eraser, ignoring parts that are above the
// surface; no value if the line passes beside the eraser.
class UnderEraser {
public:
    explicit UnderEraser(Vec3 const& eraser_mm)
        : eraser_mm_(eraser_mm)
    {
    }

    void look_at(Vec3 const& from_mm, Vec3 const& to_mm)
    {
        double const share
            = nearest_share<Vec2>(eraser_mm_.head<2>(), from_mm.head<2>(), to_mm.head<2>());
        Vec3 const nearest_mm = from_mm + share * (to_mm - from_mm);
        bool const is_seen = nearest_mm.z() <= eraser_mm_.z() + kSeenAbove_mm;
        bool const is_near = (nearest_mm - eraser_mm_).head<2>().norm() <= kRadius_mm;
        if (is_seen && is_near)
            height_mm_ = std::max(height_mm_.value_or(nearest_mm.z()), nearest_mm.z());
    }

    std::optional<double> height_mm() const { return height_mm_; }

private:
    Vec3 eraser_mm_;
    std::optional<double> height_mm_;
};

std::optional<double> height_under(Vec3 const& eraser_mm, std::vector<TipSample> const& tips)
{
    UnderEraser under(eraser_mm);
    for (std::size_t i = 1; i < tips.size(); ++i)
        under.look_at(tips[i - 1].position_mm, tips[i].position_mm);
    return under.height_mm();
}

std::optional<double> height_under(Vec3 const& eraser_mm,
                                   variation::MotionIndicator const& indicator)
{
    UnderEraser under(eraser_mm);
    under.look_at(indicator.start_mm, indicator.end_mm);
    return under.height_mm();
}

// A stroke that can be erased: its index among the scene's associations, its tips (in memory while
// erasing), and the area in which the eraser can touch it.
struct SeenStroke {
    std::size_t number = 0;
    SharedVector<TipSample> tips;
    Eigen::AlignedBox2d reach_mm;
};

// Strokes visible on the tablet. Fails if the tips of any of these strokes cannot be read.
Result<std::vector<SeenStroke>> strokes_on_pad(scene::Scene const& scene)
{
    std::vector<SeenStroke> strokes;
    // The tablet shows only strokes that shape branches.
    for (auto const number : scene::shaping_numbers(scene)) {
        auto& stroke = strokes.emplace_back();
        stroke.number = number;
        stroke.tips = TRY(scene.associations[number].what.stroke.tips.in_memory());
        for (auto const& tip : stroke.tips) {
            Vec2 const place_mm = tip.position_mm.head<2>();
            stroke.reach_mm.extend(place_mm + Vec2::Constant(kRadius_mm));
            stroke.reach_mm.extend(place_mm - Vec2::Constant(kRadius_mm));
        }
    }
    return strokes;
}

// What the eraser has touched: associations by their index in the scene, each with a flag for every
// tip, and indices of indicators.
struct Touched {
    std::map<std::size_t, std::vector<bool>> associations;
    std::vector<std::size_t> indicators;
};

// Path of the eraser, sampled so densely that a fast eraser skips nothing.
std::vector<Vec3> way_of(Stroke const& eraser)
{
    std::vector<Vec3> way_mm;
    for (auto const& tip : eraser.tips) {
        Vec3 const from_mm = way_mm.empty() ? tip.position_mm : way_mm.back();
        Vec3 const step_mm = tip.position_mm - from_mm;
        // Maximum number of samples between two tips, in case a faulty device reports a huge jump.
        constexpr double kMaxSteps = 1000;
        int const steps
            = static_cast<int>(std::clamp(std::ceil(step_mm.norm() / kRadius_mm), 1.0, kMaxSteps));
        for (int i = 1; i <= steps; ++i)
            way_mm.push_back(from_mm + step_mm * i / steps);
    }
    return way_mm;
}

// Marks the tips of a stroke that are under the eraser and at most kEraserDepth_mm below `top_mm`,
// the height of the stroke's highest point there.
void touch_tips(Vec3 const& eraser_mm, double top_mm, std::vector<TipSample> const& tips,
                std::vector<bool>& touched)
{
    touched.resize(tips.size());
    for (std::size_t i = 0; i < touched.size(); ++i) {
        auto const& tip_mm = tips[i].position_mm;
        bool const is_seen = tip_mm.z() <= eraser_mm.z() + kSeenAbove_mm;
        bool const is_on_top = tip_mm.z() >= top_mm - kEraserDepth_mm;
        bool const is_near = (tip_mm - eraser_mm).head<2>().norm() <= kRadius_mm;
        if (is_seen && is_on_top && is_near)
            touched[i] = true;
    }
}

// Marks what the eraser touches at one place: of several lines above each other, only the topmost,
// like ink on paper, however long the eraser stays. A stroke that shapes several branches is in the
// scene once for each branch; all these copies lose the same tips.
void touch(Vec3 const& eraser_mm, scene::Scene const& scene, std::span<SeenStroke const> strokes,
           Touched& touched)
{
    std::optional<double> top_mm;
    std::vector<std::size_t> seen; // Indices into `strokes`.
    std::vector<std::size_t> indicators;
    auto const take = [&](std::optional<double> height_mm, std::vector<std::size_t>& numbers,
                          std::size_t number) {
        if (!height_mm || (top_mm && *height_mm < *top_mm))
            return;
        if (!top_mm || *height_mm > *top_mm) {
            seen.clear();
            indicators.clear();
        }
        top_mm = height_mm;
        numbers.push_back(number);
    };
    Vec2 const place_mm = eraser_mm.head<2>();
    for (std::size_t i = 0; i < strokes.size(); ++i)
        if (strokes[i].reach_mm.contains(place_mm))
            take(height_under(eraser_mm, strokes[i].tips), seen, i);
    for (std::size_t i = 0; i < scene.indicators.size(); ++i)
        take(height_under(eraser_mm, scene.indicators[i].what), indicators, i);
    for (auto const i : seen)
        touch_tips(eraser_mm, *top_mm, strokes[i].tips, touched.associations[strokes[i].number]);
    for (auto const number : indicators)
        if (std::find(touched.indicators.begin(), touched.indicators.end(), number)
            == touched.indicators.end())
            touched.indicators.push_back(number);
}

std::vector<TipRange> ranges_of(std::vector<bool> const& touched)
{
    std::vector<TipRange> ranges;
    for (std::size_t i = 0; i < touched.size(); ++i)
        if (touched[i] && i > 0 && touched[i - 1])
            ranges.back().last = i;
        else if (touched[i])
            ranges.push_back({ i, i });
    return ranges;
}

// True if the stroke of an association still shapes its branches without the tips in `ranges`. A
// remainder shorter than the eraser's radius does not count: it was not left on purpose, and its
// direction is random.
Result<bool> shapes_without(scene::Scene const& scene, variation::Association association,
                            std::span<TipRange const> ranges)
{
    auto tips = TRY(association.stroke.tips.in_memory());
    auto rest = erase_tips({ std::move(tips) }, ranges);
    if (!rest)
        return false;
    auto const points = stroke_points(*rest);
    if (!points || polyline_length_mm(*points) < kRadius_mm)
        return false;
    association.stroke = *std::move(rest);
    return variation::check_association(*scene.base, association).has_value();
}

// Edits for the touched strokes: first an edit for each group of strokes that lose the same tips,
// then one edit that deletes the strokes to be erased whole.
Result<std::vector<scene::Edit>>
stroke_edits_of(Touched const& touched, EraseTool::EraseExtent erasing, scene::Scene const& scene)
{
    std::vector<scene::EraseTips> parts;
    scene::DeleteStroke whole;
    for (auto const& [number, tips] : touched.associations) {
        auto ranges = ranges_of(tips);
        auto const id = scene.associations[number].id;
        if (erasing == EraseTool::EraseExtent::Whole) {
            whole.strokes.ids.push_back(id);
        } else if (ranges.empty()) { // The eraser passed between two tips, so no tip is erased.
            continue;
        } else if (!TRY(shapes_without(scene, scene.associations[number].what, ranges))) {
            whole.strokes.ids.push_back(id);
        } else {
            auto const same
                = std::find_if(parts.begin(), parts.end(),
                               [&](scene::EraseTips const& part) { return part.ranges == ranges; });
            if (same != parts.end())
                same->strokes.ids.push_back(id);
            else
                parts.push_back({ { { id } }, std::move(ranges) });
        }
    }
    std::vector<scene::Edit> edits(parts.begin(), parts.end());
    if (!whole.strokes.empty())
        edits.push_back(std::move(whole));
    return edits;
}

Result<std::vector<scene::Edit>> erase(Tool const& tool, Stroke const& stroke,
                                       scene::Scene const& scene)
{
    Touched touched;
    auto const strokes = TRY(strokes_on_pad(scene));
    for (auto const& place_mm : way_of(stroke))
        touch(place_mm, scene, strokes, touched);
    auto edits = TRY(stroke_edits_of(touched, tool.get<EraseTool>()->erasing, scene));
    for (auto const number : touched.indicators)
        edits.push_back(scene::DeleteIndicator { scene.indicators[number].id });
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser touched nothing: move it over a stroke or an indicator that is "
                    "seen on the pad");
    return edits;
}

} // namespace

constexpr ToolKind EraseTool::kKind {
    .word = "erase",
    .label = "Erase",
    .title = "Erase",
    .done = "It is erased",
    .help = "takes away what the stroke runs over, whole strokes or only their parts below it; the "
            "pen's other end does as was chosen last",
    .group = "Erase",
    .icon = "37731555 1555 55913373 3355",
    .key = 'E',
    .ink = { InkStyle::Look::Eraser, 2 * EraseTool::kRadius_mm },
    .options = options_type<EraseTool, visit>(),
    .edits_for = erase,
    .previewer = stroke_reading_previewer,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus::tools
