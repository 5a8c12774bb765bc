#pragma once

#include "app/render/gpu_picture.h"
#include "app/view/start_page.h"
#include "app/window/controls.h"

#include <imgui.h>
#include <memory>
#include <optional>
#include <vector>

namespace tractus::window {

// A page's study: a large picture with details beside it and further pictures below, and sliders
// that change them. In a narrow window the sliders are below the pictures.
class StudyView {
public:
    explicit StudyView(float scale)
        : scale_(scale)
    {
    }

    // Draws into the current ImGui window. The page must have a study.
    void show(view::StartPageModel& page, Controls const& controls);

    // Frees the textures.
    void leave() { shown_.clear(); }

private:
    // A texture for one place of the study; replaced when the page's picture changes.
    struct Shown {
        // The picture in the texture; immutable, shared with the page.
        std::shared_ptr<render::Image const> picture;
        std::optional<render::GpuPicture> texture;
    };

    void show_pictures(view::StartStudy const& study, ImVec2 const& corner, float unit);
    void show_picture(view::StartStudy::Picture const& picture, std::size_t place,
                      ImVec2 const& corner, float side);
    void show_sliders(view::StartPageModel& page, Controls const& controls, float width,
                      float height);
    bool slider(std::size_t number, view::StartStudy::Slider& slider, float width,
                float height) const;

    float scale_ = 1;
    std::vector<Shown> shown_;
};

} // namespace tractus::window
