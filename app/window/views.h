#pragma once

#include "app/render/renderer.h"
#include "app/window/window_model.h"

#include <imgui.h>
#include <optional>

namespace tractus {

// A picture inside the window: a canvas that is drawn again only when what it shows has changed.
class ViewCanvas {
public:
    // The canvas in this size; `changed` becomes true if it had another one.
    Canvas& sized(ImVec2 const& size_px, bool& changed);

    // Puts the picture at ImGui's cursor.
    void show() const;

private:
    std::optional<Canvas> canvas_;
};

// Curves on the graphics card that are made again only when they have changed.
class FollowedCurves {
public:
    // True if they were made, by `make`, since the revision is another one than at the last call.
    template<typename Make> bool follow(std::uint64_t revision, Make const& make)
    {
        if (curves_ && revision == revision_)
            return false;
        curves_.emplace(make());
        revision_ = revision;
        return true;
    }

    GpuCurves const* curves() const { return &*curves_; }

private:
    std::optional<GpuCurves> curves_;
    std::uint64_t revision_ = 0;
};

// The three views of Streit 2006 section 3. Each draws itself at ImGui's cursor, `size_px` large,
// with the window's context current.

// Looks from above into the drawing volume through the surface at its present height: nothing above
// the surface is seen, and lines get thinner with the depth below it.
class PadView {
public:
    void show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);

private:
    ViewCanvas canvas_;
    FollowedCurves skeleton_;
    FollowedCurves preview_;
    FollowedCurves strokes_;
    FollowedCurves live_;
};

// Where a person looks from: changed by dragging and the wheel over the last drawn item.
class Orbit {
public:
    // True if the person has changed it.
    bool take_input(float scale);

    // A view of the box from there.
    Camera camera(Bounds const& box, double aspect) const;

private:
    ViewAngles angles_ { .azimuth_rad = 0.45, .elevation_rad = 0.22 };
    double zoom_ = 1; // Above 1: nearer.
};

// The plant's skeleton with the states of its branches; turned by dragging, zoomed by the wheel.
class SkeletonView {
public:
    void show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);

private:
    ViewCanvas canvas_;
    Orbit orbit_;
    FollowedCurves curves_;
    FollowedCurves preview_;
    Bounds box_;
    bool turned_ = false;
};

// The whole plant, lit; turned and zoomed like the skeleton.
class PlantView {
public:
    void show(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);

    // What is seen now, for a file. Empty before the first plant.
    Image picture(Renderer& renderer, int width, int height) const;

private:
    ViewCanvas canvas_;
    Orbit orbit_;
    std::optional<GpuMesh> mesh_;
    std::uint64_t revision_ = 0;
    bool turned_ = false;
};

} // namespace tractus
