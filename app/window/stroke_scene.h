#pragma once

#include "app/render/camera.h"
#include "app/render/curve.h"
#include "app/view/window_model.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::window {

// What the view of drawn curves (WindowState::curves) shows, without the window. World frame.

// Indices of the highlighted curves: the picked one; if none is picked, those that shape what is
// selected; if there are none, the newest.
std::vector<std::size_t> highlighted_curves(view::WindowState const& state,
                                            std::optional<std::size_t> picked);

// Colour of a curve by its index. Seven colours that differ for all kinds of colour vision are
// repeated in order. sRGB, 0 to 1.
Vec3f curve_color(std::size_t curve);

// The box that the camera frames: all curves, the ground below them and the plant's base, with air
// around; the drawing volume while there is no curve.
Bounds strokes_box(view::WindowState const& state);

// The curves, as wide as they were drawn but never too thin to see, each with a dot at its start.
std::vector<render::Curve> stroke_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted);

// For orientation: a grid on the ground, an upright at the plant's base with a mark at each step of
// the grid, and a line from the start of each highlighted curve down to the ground.
std::vector<render::Curve> ground_curves(view::WindowState const& state,
                                         std::vector<std::size_t> const& highlighted);

// Middle of the grid's front edge, the side on which the user sits.
Vec3f front_mm(view::WindowState const& state);

// Projects points into a picture.
class PictureProjection {
public:
    PictureProjection(render::Camera const& camera, Vec2f const& size_px);

    // Position in pixels from the picture's upper left corner; no value for a point behind the
    // camera.
    std::optional<Vec2f> to_px(Vec3f const& point_mm) const;

private:
    Eigen::Matrix4f clip_of_world_;
    Vec2f size_px_;
};

// Index of the curve nearest to a place in the picture, if one is within `reach_px`.
std::optional<std::size_t> curve_at(std::span<view::DrawnCurveView const> curves,
                                    PictureProjection const& projection, Vec2f const& place_px,
                                    float reach_px);

struct CurveLabel {
    std::size_t curve = 0;
    Vec2f corner_px = Vec2f::Zero(); // Upper left corner of the label.
};

// Places for the curves' numbers, beside their starts. Labels never overlap: where there is no room
// for all, highlighted curves and then newer ones come first.
std::vector<CurveLabel> curve_labels(std::span<view::DrawnCurveView const> curves,
                                     std::vector<std::size_t> const& highlighted,
                                     PictureProjection const& projection, Vec2f const& label_px);

} // namespace tractus::window
