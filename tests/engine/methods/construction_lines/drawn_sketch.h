#pragma once

#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/edit_ids.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/construction_lines/sketches.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tractus::lines {

// Returns a line as a pen draws it on the tablet, with a point every 4 mm. The surface is 100 mm
// above the desk.
inline Stroke pen_stroke(std::vector<Vec3> const& corners_mm)
{
    Stroke stroke;
    std::int64_t time_ns = 0;
    auto const add = [&](Vec3 const& place_mm) {
        stroke.tips.push_back({ .time = timestamp_ns(time_ns += 5'000'000),
                                .position_mm = place_mm + Vec3(0, 0, 100),
                                .pressure = 0.5,
                                .touching = true });
    };
    add(corners_mm.front());
    for (std::size_t i = 1; i < corners_mm.size(); ++i) {
        Vec3 const way_mm = corners_mm[i] - corners_mm[i - 1];
        int const pieces = static_cast<int>(way_mm.norm() / 4) + 1;
        for (int k = 1; k <= pieces; ++k)
            add(corners_mm[i - 1] + way_mm * k / pieces);
    }
    return stroke;
}

// Returns the stroke of a stem of 120 mm through (0, 0), the middle of the tablet.
inline Stroke stem()
{
    return pen_stroke({ { 0, -60, 0 }, { 0, 60, 0 } });
}
inline Stroke left_boundary()
{
    return pen_stroke({ { -30, -60, 0 }, { -20, 70, 0 } });
}
inline Stroke right_boundary()
{
    return pen_stroke({ { 40, -60, 0 }, { 40, 70, 0 } });
}
inline Stroke low_line()
{
    return pen_stroke({ { -50, -20, 0 }, { 0, -40, 0 }, { 60, -10, 0 } });
}
inline Stroke high_line()
{
    return pen_stroke({ { -50, 60, 0 }, { 0, 30, 0 }, { 60, 70, 0 } });
}
// Returns a short stroke that is far from the stem.
inline Stroke odd_stroke()
{
    return pen_stroke({ { 80, 0, 0 }, { 90, 10, 0 } });
}

// A document to which edits are applied as in a session. Each edit gets an id.
class Drawing {
public:
    void apply(scene::Edit const& edit)
    {
        auto next = scene::apply_edit(scene_, scene::with_id(edit, ++count_));
        ASSERT_TRUE(next) << next.error().message;
        scene_ = *std::move(next);
    }
    void draw(Stroke const& stroke, int nodes = 5)
    {
        apply(AddLine { .plant = scene_.state.active,
                        .stroke = stroke,
                        .nodes = nodes,
                        .pattern = { .kind = Pattern::Kind::Spiral },
                        .stands_at_mm = Vec3(stroke.tips.front().position_mm.x(), 0, 0) });
    }
    std::string refusal(scene::Edit const& edit) const
    {
        auto const next = scene::apply_edit(scene_, edit);
        return next ? "it is done" : next.error().message;
    }

    scene::Scene const& scene() const { return scene_; }
    scene::ItemId plant() const { return scene_.state.active; }
    PenSketch const& sketch() const { return *active_pen_sketch(scene_.state); }
    std::size_t organs() const { return scene_.base->organs.size(); }
    Role newest_role() const { return sketch().lines.back().role; }

private:
    scene::Scene scene_;
    std::uint64_t count_ = 0;
};

inline Drawing whole_sketch()
{
    Drawing drawing;
    for (auto const& stroke :
         { stem(), left_boundary(), right_boundary(), low_line(), high_line() })
        drawing.draw(stroke);
    return drawing;
}

} // namespace tractus::lines
