#pragma once

#include "app/render/camera.h"
#include "app/render/curve.h"
#include "app/view/window_model.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::window {

// What the view of drawn curves (WindowState::curves) shows, computed without a window. World
// frame.

// Returns the indices of the highlighted curves. This is the curve that the user has picked; if
// none is picked, the curves that shape the selected branches; if there are none, the newest curve.
std::vector<std::size_t> highlighted_curves(view::WindowState const& state,
                                            std::optional<std::size_t> picked);

// Returns the colour of the curve with this index, in sRGB from 0 to 1. Seven colours, which can be
// told apart with any kind of colour vision, take turns.
Vec3f curve_color(std::size_t curve);

// Returns the box that the camera shows: all curves, the ground below them and the plant's base,
// with some space around them. Without curves, it is around the drawing volume.
Bounds strokes_box(view::WindowState const& state);

// Returns the curves as wide as they were drawn, but wide enough to be visible. Each has a dot at
// its beginning.
std::vector<render::Curve> stroke_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted);

// Returns the ink of strokes in progress where it will stand: strokes on paper are upright. It does
// not change the box, so that the view stays still while the pen draws.
std::vector<render::Curve> live_stroke_curves(view::WindowState const& state);

// Returns lines for orientation: a grid on the ground, an upright line at the plant's base with a
// mark at each step of the grid, and for the newest highlighted curves a line from the curve's
// beginning down to the ground.
std::vector<render::Curve> ground_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted);

// Returns the middle of the grid's front edge, on the side where the user sits.
Vec3f front_mm(view::WindowState const& state);

// Projection of points in space to places in a picture.
class PictureProjection {
public:
    PictureProjection(render::Camera const& camera, Vec2f const& size_px);

    // Returns the position in pixels from the picture's upper left corner. No value for a point
    // behind the camera.
    std::optional<Vec2f> to_px(Vec3f const& point_mm) const;

private:
    Eigen::Matrix4f clip_of_world_;
    Vec2f size_px_;
};

// Returns the index of the curve that is nearest to a place in the picture, at most `reach_px`
// away; no value if there is none.
std::optional<std::size_t> curve_at(std::span<view::DrawnCurveView const> curves,
                                    PictureProjection const& projection, Vec2f const& place_px,
                                    float reach_px);

struct CurveLabel {
    std::size_t curve = 0;
    Vec2f corner_px = Vec2f::Zero(); // Upper left corner of the label, in pixels.
};

// Returns places for the numbers of the curves, beside the curves' beginnings. Labels never
// overlap. If there is not room for all labels, highlighted curves come first, then newer curves.
std::vector<CurveLabel> curve_labels(std::span<view::DrawnCurveView const> curves,
                                     std::vector<std::size_t> const& highlighted,
                                     PictureProjection const& projection, Vec2f const& label_px);

} // namespace tractus::window
