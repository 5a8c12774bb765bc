#pragma once

#include "app/window/controls.h"
#include "app/window/devices_panel.h"
#include "engine/export/glb_writer.h"

#include <functional>
#include <optional>

namespace tractus::window {

// The panel beside the views, for settings and commands that are rarely needed while drawing. Its
// pages are the plant's growth, saving and exporting, the devices, and the window.
class Menu {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    Menu(ImFont* title_font, float scale)
        : scale_(scale)
        , devices_(title_font, scale)
    {
    }

    // Returns the menu's width if menu and views share a width of `room_px`. If that is narrow,
    // some space remains for the plant.
    float width_px(float room_px) const;

    // Shows the menu at the right edge of `room`, or at the left edge for left-handed use. Returns
    // the menu's rectangle. `picture` renders the plant as the view shows it, to be saved.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& room, std::function<render::Image()> const& picture);

private:
    void show_pages(Workspace& workspace, Controls const& controls) const;
    void show_plant(view::WindowModel& model, Controls const& controls);
    void show_season(view::WindowModel& model);
    void show_keeping(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                      std::function<render::Image()> const& picture);
    void show_leaving(view::WindowModel& model, Controls const& controls) const;
    void show_formats(view::WindowModel& model, Controls const& controls) const;
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
    float row_px_ = 0; // Width of the menu's content, in pixels.
    DevicesPanel devices_;
    // Season that the slider is setting; month 0: no season. nullopt: the slider shows the
    // document's season.
    std::optional<scene::Season> wanted_season_;
    // How .glb files store leaves when the plant is exported next.
    exports::GlbOptions::Organs organs_ = exports::GlbOptions::Organs::Merged;
};

} // namespace tractus::window
