#pragma once

#include "app/window/controls.h"
#include "app/window/devices_panel.h"
#include "engine/export/glb_writer.h"

#include <functional>
#include <optional>

namespace tractus::window {

// The panel beside the views with what is not needed at each stroke, on a few pages: how the plant
// grows, what is kept of the work, the devices, the window itself.
class Menu {
public:
    // `title_font` is theme::apply()'s; `scale` the display's.
    Menu(ImFont* title_font, float scale)
        : scale_(scale)
        , devices_(title_font, scale)
    {
    }

    // In a room of that width: a narrow one is left some for the plant that it changes.
    float width_px(float room_px) const;

    // Shows it at the right edge of `room`, or the left one for a left hand; returns where it is.
    // `picture`: of the plant as it is seen, for a file.
    WindowPart show(view::WindowModel& model, Workbench& bench, Controls const& controls,
                    WindowPart const& room, std::function<render::Image()> const& picture);

private:
    void show_pages(Workbench& bench, Controls const& controls) const;
    void show_plant(view::WindowModel& model, Controls const& controls);
    void show_season(view::WindowModel& model);
    void show_keeping(view::WindowModel& model, Workbench& bench, Controls const& controls,
                      std::function<render::Image()> const& picture);
    void show_leaving(view::WindowModel& model, Controls const& controls) const;
    void show_organs(Controls const& controls);
    void show_devices(view::WindowModel& model, Controls const& controls);
    void show_window(view::WindowState const& state, Workbench& bench,
                     Controls const& controls) const;
    void show_displays(view::WindowState const& state, Workbench& bench,
                       Controls const& controls) const;
    bool show_slider(char const* name, char const* text, float greatest, double& value,
                     bool& is_released) const;

    float item_px(int count = 1) const;

    float scale_ = 1;
    float row_px_ = 0; // As wide as the panel is inside.
    DevicesPanel devices_;
    // Of month 0: none. No value: the one that is shown.
    std::optional<scene::Season> wanted_season_;
    exports::GlbOptions::Organs organs_ = exports::GlbOptions::Organs::Merged; // Of the next .glb.
};

} // namespace tractus::window
