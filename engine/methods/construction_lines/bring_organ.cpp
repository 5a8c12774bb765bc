#include "engine/methods/construction_lines/bring_organ.h"

#include "engine/methods/construction_lines/change_sketch.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/scene/make_edit_kind.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

using Box = Eigen::AlignedBox2d;
// Maximum size of the leaf's sides on the tablet, because there is little room beside a plant.
constexpr double kLongest_mm = 32;
// Scale of the midrib and section beside the leaf, relative to the scale of its sides.
constexpr double kBesideSize = 0.6;
constexpr double kGap_mm = 4; // Gap between the views of the leaf, and around them.

// The lines of a leaf on the tablet. The leaf's base is at (0, 0); its midrib and section are to
// the right of its sides.
struct Layout {
    struct Line {
        OrganView view = OrganView::Side;
        std::vector<Vec2> points_mm {};
    };
    std::vector<Line> lines {};
    Box box {};
};

Layout laid_out(OrganFile const& organ)
{
    auto const& views = organ.views;
    Layout layout;
    Box sides;
    for (auto const* const side : { &views.left, &views.right })
        for (auto const& point : *side)
            sides.extend(point);
    double const scale = std::min(1.0, kLongest_mm / std::max(sides.sizes().maxCoeff(), 1e-6));
    auto const add = [&](OrganView view, std::vector<Vec2> const& points, Vec2 const& begin_mm) {
        if (points.empty())
            return;
        double const size = view == OrganView::Side ? scale : kBesideSize * scale;
        auto& line = layout.lines.emplace_back();
        line.view = view;
        for (auto const& point : points) {
            line.points_mm.emplace_back(begin_mm + size * (point - points.front()));
            layout.box.extend(line.points_mm.back());
        }
    };
    auto const& any = views.left.empty() ? views.right : views.left;
    Vec2 const base = views.left.empty() || views.right.empty()
        ? any.front()
        : Vec2((views.left.front() + views.right.front()) / 2);
    for (auto const* const side : { &views.left, &views.right })
        if (!side->empty())
            add(OrganView::Side, *side, scale * (side->front() - base));
    double const beside_mm = layout.box.max().x() + kGap_mm;
    add(OrganView::Midrib, views.midrib, { beside_mm, layout.box.min().y() });
    add(OrganView::Section, views.section, { beside_mm, layout.box.max().y() });
    return layout;
}

Stroke drawn_through(std::vector<Vec2> const& points_mm, Vec2 const& at_mm)
{
    constexpr std::int64_t kBetween_ns = 5'000'000;
    Stroke stroke;
    std::vector<TipSample> tips;
    for (auto const& point_mm : points_mm)
        tips.push_back({ .time = timestamp_ns(kBetween_ns * static_cast<std::int64_t>(tips.size())),
                         .position_mm = { at_mm.x() + point_mm.x(), at_mm.y() + point_mm.y(), 0 },
                         .pressure = 0.5,
                         .touching = true });
    stroke.tips = std::move(tips);
    return stroke;
}

SketchOrgan drawn_organ(OrganFile const& file, Vec2 const& at_mm, scene::ItemId id,
                        SheetPlacement const& sheet)
{
    SketchOrgan organ { .id = id, .picture = file.picture };
    if (file.picture)
        organ.color = OrganColor::Picture;
    else if (file.color)
        organ.color = nearest_color(*file.color);
    for (auto& line : laid_out(file).lines)
        organ.lines.push_back({ line.view,
                                { .id = id + organ.lines.size() + 1,
                                  .stroke = drawn_through(line.points_mm, at_mm),
                                  .sheet = sheet } });
    return organ;
}

void list(scene::Fields& fields, BringOrgan& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("at_mm", &edit.at_mm);
    fields.id(edit.id);
    fields.bytes(edit.text);
}

Result<scene::DocumentState> applied(scene::DocumentState state, BringOrgan const& edit,
                                     scene::SceneBuilder&)
{
    auto found = TRY(find_sketch(state, edit.plant));
    if (!edit.at_mm.allFinite())
        return fail(Fault::User, "the place for the leaf is not a number");
    auto const file = TRY(parse_organ(edit.text, "the leaf"));
    auto const sheet = sheet_of(*state.plants[found.number], state.scale);
    found.sketch = TRY(
        with_organ(std::move(found.sketch),
                   drawn_organ(file, edit.at_mm.head<2>(), scene::take_id(state, edit.id), sheet)));
    put_sketch(state, std::move(found));
    return state;
}

std::string described(BringOrgan const& edit)
{
    return fmt::format("brings a leaf of {} bytes to plant {}", edit.text.size(),
                       scene::name_of(edit.plant));
}

// Bounding boxes of all drawn lines, in tablet coordinates.
std::vector<Box> drawn_boxes(PenSketch const& sketch, SheetPlacement const& sheet)
{
    std::vector<Box> boxes;
    auto const add = [&](SketchLine const& line) {
        Box box;
        if (auto const points = points_on_sheet(line))
            for (auto const& point : *points)
                box.extend(sheet.on_tablet(point.head<2>()));
        if (!box.isEmpty())
            boxes.push_back(box);
    };
    for (auto const& line : sketch.lines)
        add(line);
    for (auto const& organ : sketch.organs)
        for (auto const& line : organ.lines)
            add(line.line);
    return boxes;
}

} // namespace

Vec3 place_beside(PenSketch const& sketch, SheetPlacement const& sheet, OrganFile const& organ)
{
    constexpr double kStep_mm = 5;
    Box const tablet(Vec2(-100, -60), Vec2(100, 60)); // An area that fits most tablets.
    auto const boxes = drawn_boxes(sketch, sheet);
    Box all;
    for (auto const& box : boxes)
        all.extend(box);
    auto const own = laid_out(organ).box;
    // Position if there is no free place on the tablet: to the right of all lines.
    Vec2 best_mm(all.max().x() + kGap_mm - own.min().x(), all.min().y() - own.min().y());
    double min_mm = std::numeric_limits<double>::infinity();
    for (double y = tablet.min().y(); y + own.sizes().y() <= tablet.max().y(); y += kStep_mm)
        for (double x = tablet.min().x(); x + own.sizes().x() <= tablet.max().x(); x += kStep_mm) {
            Vec2 const corner_mm(x, y);
            Box const place(corner_mm - Vec2::Constant(kGap_mm),
                            corner_mm + own.sizes() + Vec2::Constant(kGap_mm));
            bool const is_free = std::none_of(
                boxes.begin(), boxes.end(), [&](Box const& box) { return box.intersects(place); });
            double const away_mm = (place.center() - all.center()).norm();
            if (is_free && away_mm < min_mm) {
                min_mm = away_mm;
                best_mm = corner_mm - own.min();
            }
        }
    return { best_mm.x(), best_mm.y(), 0 };
}

constexpr scene::EditKind BringOrgan::kKind
    = scene::make_edit_kind<BringOrgan, list, applied, described>("bring_line_organ");

} // namespace tractus::lines
