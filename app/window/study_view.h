#pragma once

#include "app/render/gpu_picture.h"
#include "app/view/start_page.h"
#include "app/window/controls.h"

#include <imgui.h>
#include <memory>
#include <optional>
#include <vector>

namespace tractus::window {

// Shows the study of a page: a large picture with details beside it and further pictures below it,
// and sliders that change them. In a narrow window the sliders are below the pictures.
class StudyView {
public:
    explicit StudyView(float scale)
        : scale_(scale)
    {
    }

    // Draws the study into the current ImGui window. The page must have a study.
    void show(view::StartPageModel& page, Controls const& controls);

    // Frees the textures of the pictures.
    void leave() { shown_.clear(); }

private:
    // A texture for a certain place of the study. It is replaced when the page has a new picture
    // for this place.
    struct Shown {
        // The picture that the texture contains. Immutable; shared with the page.
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
