#pragma once

#include "app/window/controls.h"
#include "app/window/devices_panel.h"
#include "engine/export/glb_writer.h"

#include <functional>
#include <optional>

namespace tractus::window {

// The panel beside the views for what is not needed at every stroke, on a few pages: how the plant
// grows, saving and exporting, the devices, the window.
class Menu {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    Menu(ImFont* title_font, float scale)
        : scale_(scale)
        , devices_(title_font, scale)
    {
    }

    // The menu's width in a room of width `room_px`; in a narrow one it leaves some space for the
    // plant.
    float width_px(float room_px) const;

    // Shows the menu at the right edge of `room`, or at the left one for left-handed use; returns
    // its rectangle. `picture` renders the plant from the current view, to be saved.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& room, std::function<render::Image()> const& picture);

private:
    void show_pages(Workspace& workspace, Controls const& controls) const;
    void show_plant(view::WindowModel& model, Controls const& controls);
    void show_season(view::WindowModel& model);
    void show_keeping(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                      std::function<render::Image()> const& picture);
    void show_leaving(view::WindowModel& model, Controls const& controls) const;
    void show_organs(Controls const& controls);
    void show_devices(view::WindowModel& model, Controls const& controls);
    void show_window(view::WindowState const& state, Workspace& workspace,
                     Controls const& controls) const;
    void show_displays(view::WindowState const& state, Workspace& workspace,
                       Controls const& controls) const;
    bool show_slider(char const* name, char const* text, float greatest, double& value,
                     bool& is_released) const;

    float item_px(int count = 1) const;

    float scale_ = 1;
    float row_px_ = 0; // Inner width of the panel.
    DevicesPanel devices_;
    // Season being set by a slider; month 0: no season. nullopt: show the plant's own.
    std::optional<scene::Season> wanted_season_;
    // How the next .glb file stores leaves.
    exports::GlbOptions::Organs organs_ = exports::GlbOptions::Organs::Merged;
};

} // namespace tractus::window
