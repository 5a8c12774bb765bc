#include "app/window/menu.h"

#include "app/window/theme.h"
#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::window {

static constexpr float kLastMonth = 12.99f;

namespace {

constexpr float kMenuWidth_px = 460;
constexpr float kMinBeside_px = 140;

} // namespace

// Returns the width of each of `count` items that share the rest of a row.
float Menu::item_px(int count) const
{
    auto const gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
    return (row_px_ - gaps) / static_cast<float>(count) / scale_;
}

float Menu::width_px(float room_px) const
{
    float const left_px = room_px - kMinBeside_px * scale_;
    return std::min(kMenuWidth_px * scale_, std::max(left_px, room_px / 2));
}

WindowPart Menu::show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                      WindowPart const& room, std::function<render::Image()> const& picture)
{
    using Page = Workspace::MenuPage;
    float const width = width_px(room.width);
    float const left = workspace.is_left_handed ? room.left : room.left + room.width - width;
    WindowPart const part { left, room.top, width, room.height };
    ImGui::SetNextWindowPos({ part.left, part.top });
    ImGui::SetNextWindowSize({ part.width, part.height });
    ImGui::Begin("menu", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings);
    row_px_ = ImGui::GetContentRegionAvail().x;
    show_pages(workspace, controls);
    if (workspace.menu == Page::Plant)
        show_plant(model, controls);
    else if (workspace.menu == Page::Keep)
        show_keeping(model, workspace, controls, picture);
    else if (workspace.menu == Page::Devices)
        show_devices(model, controls);
    else
        show_window(model.state(), workspace, controls);
    theme::scroll_by_dragging();
    ImGui::End();
    return part;
}

void Menu::show_pages(Workspace& workspace, Controls const& controls) const
{
    using Page = Workspace::MenuPage;
    constexpr std::array<std::pair<char const*, Page>, 4> kPages { { { "Plant", Page::Plant },
                                                                     { "Keep", Page::Keep },
                                                                     { "Devices", Page::Devices },
                                                                     { "Window", Page::Window } } };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, { 8 * scale_, ImGui::GetStyle().ItemSpacing.y });
    float const width = item_px(static_cast<int>(kPages.size()));
    for (auto const& [name, page] : kPages) {
        if (page != Page::Plant)
            ImGui::SameLine();
        if (controls.button(name, width, workspace.menu == page))
            workspace.open_menu(page);
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({ 1, 8 * scale_ });
}

void Menu::show_keeping(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                        std::function<render::Image()> const& picture)
{
    bool const records = model.state().recording.is_on;
    if (model.state().is_live
        && controls.button(records ? "End recording" : "Record", item_px(), records))
        model.perform(view::SetRecording { !records });
    if (controls.button("Save picture", item_px()))
        model.perform(view::SavePicture { picture() });
    show_formats(model, controls);
    show_organs(controls);
    show_leaving(model, controls);
    if (model.state().may_write_rules && controls.button("Write its rules", item_px()))
        model.perform(view::WriteRules {});
    if (auto const& name = model.state().drawing_name; name && !workspace.name_request) {
        using Of = Workspace::NameRequest::Of;
        if (controls.button("Name ...", item_px(2)))
            workspace.ask_name({ Of::Drawing, *name });
        ImGui::SameLine();
        if (controls.button("Save a copy ...", item_px(2)))
            workspace.ask_name({ Of::Copy, *name + ", a copy" });
    }
}

// Shows a button for each format in rows of four. The first one is as wide as two.
void Menu::show_formats(view::WindowModel& model, Controls const& controls) const
{
    constexpr int kInRow = 4;
    auto const& endings = model.state().export_endings;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        if (i > 0 && (i + 1) % std::size_t { kInRow } != 0)
            ImGui::SameLine();
        auto const text = i == 0 ? "Export " + endings[i] : endings[i];
        if (controls.button(text.c_str(), item_px(i == 0 ? 2 : kInRow)))
            model.perform(view::ExportPlant { endings[i], organs_ });
    }
}

// Shows buttons that close the drawing or discard what was drawn.
void Menu::show_leaving(view::WindowModel& model, Controls const& controls) const
{
    bool const may_begin_anew = model.state().may_begin_anew;
    if (model.state().is_live && controls.button("Start again", item_px(may_begin_anew ? 2 : 1)))
        model.perform(view::Restart {});
    if (!may_begin_anew)
        return;
    ImGui::SameLine();
    if (controls.button("New ...", item_px(2)))
        model.perform(view::OpenStartPage {});
}

// Lets the user choose how a .glb file stores leaves, and says for which programs each choice is
// meant.
void Menu::show_organs(Controls const& controls)
{
    struct Choice {
        char const* text;
        exports::GlbOptions::Organs organs;
        char const* reason;
    };
    using Organs = exports::GlbOptions::Organs;
    constexpr std::array<Choice, 3> kChoices { {
        { "Merged", Organs::Merged, ".glb: leaves in one mesh, which every program opens." },
        { "Instanced", Organs::Instanced,
          ".glb: leaves as instances, small: for three.js, Babylon.js, Blender from 3.6 on." },
        { "Nodes", Organs::Nodes, ".glb: an object for each leaf, to edit single ones; slow." },
    } };
    for (auto const& [text, organs, reason] : kChoices) {
        if (organs != Organs::Merged)
            ImGui::SameLine();
        if (controls.button(text, item_px(static_cast<int>(kChoices.size())), organs_ == organs))
            organs_ = organs;
    }
    for (auto const& choice : kChoices)
        if (choice.organs == organs_)
            ImGui::TextWrapped("%s", choice.reason);
}

void Menu::show_devices(view::WindowModel& model, Controls const& controls)
{
    auto const& state = model.state();
    if (state.may_calibrate && controls.button("Calibrate", item_px()))
        model.perform(view::OpenCalibration {});
    if (state.mouse_draws)
        ImGui::TextWrapped("There is no tablet: the mouse is the pen.");
    if (state.mouse_moves_surface)
        ImGui::TextWrapped("There is no height sensor: wheel, W and S move the surface.");
    if (!state.is_live)
        ImGui::TextWrapped("A recording is replayed: no device is read.");
    else
        devices_.show(state.devices);
}

// Shows a list of displays. The tablet's own display is marked: on it, lines appear under the pen's
// tip.
void Menu::show_displays(view::WindowState const& state, Workspace& workspace,
                         Controls const& controls) const
{
    auto const tablets = state.is_live && !state.mouse_draws
        ? tablet_display(workspace.displays, state.surface_size_mm())
        : std::nullopt;
    bool const is_only_one = workspace.displays.size() == 1;
    for (std::size_t i = 0; i < workspace.displays.size(); ++i) {
        auto const& display = workspace.displays[i];
        bool const is_filled = workspace.filled_display == i;
        auto const text
            = is_only_one ? "Full screen" : fmt::format("Fill {}: {}", i + 1, display.name);
        if (controls.button(text.c_str(), item_px(), is_filled))
            workspace.requested_full_screen = Workspace::FullScreen { !is_filled, i };
        if (tablets == i)
            ImGui::TextWrapped("The tablet's own display: the ink lies under the pen.");
    }
}

void Menu::show_window(view::WindowState const& state, Workspace& workspace,
                       Controls const& controls) const
{
    show_displays(state, workspace, controls);
    if (controls.button("On stage", item_px()))
        workspace.enter_stage();
    if (controls.button(theme::palette().is_light ? "Dark" : "Light", item_px(3)))
        theme::set_light(!theme::palette().is_light);
    ImGui::SameLine();
    if (controls.button("Left hand", item_px(3), workspace.is_left_handed))
        workspace.is_left_handed = !workspace.is_left_handed;
    ImGui::SameLine();
    if (controls.button("Keys", item_px(3), workspace.keys_are_listed))
        workspace.keys_are_listed = !workspace.keys_are_listed;
    if (controls.button("Close", item_px()))
        workspace.is_close_requested = true;
}

void Menu::show_plant(view::WindowModel& model, Controls const& controls)
{
    bool const takes_leaves = model.state().is_live;
    if (controls.button("Another one", item_px(takes_leaves ? 2 : 1)))
        model.perform(view::NextVariation {});
    if (takes_leaves) {
        ImGui::SameLine();
        if (controls.button("Leaves...", item_px(2)))
            model.perform(view::OpenLeaves {});
    }
    view::ChangeGrowth change { .growth = model.state().growth };
    auto& growth = change.growth;
    bool is_released = false;
    bool moves = show_slider("##age", "age %.2f", 1, growth.age, is_released);
    moves
        |= show_slider("##variability", growth.variability < 0.01 ? "as drawn" : "variability %.2f",
                       4, growth.variability, is_released);
    if (moves || is_released) {
        change.slider = is_released ? view::ChangeGrowth::Slider::Released
                                    : view::ChangeGrowth::Slider::Moving;
        model.perform(change);
    }
    bool const is_along = model.state().along_ground;
    if (controls.button("Along the ground", item_px(), is_along))
        model.perform(view::SetAlongGround { !is_along });
    show_season(model);
    bool is_left = true;
    for (auto const& preset : variation::growth_presets()) {
        std::string const name(preset.name);
        if (!std::exchange(is_left, !is_left))
            ImGui::SameLine();
        if (!controls.button(name.c_str(), item_px(2), growth.preset == name))
            continue;
        growth.preset = name;
        change.slider = view::ChangeGrowth::Slider::Released;
        model.perform(change);
    }
    if (model.state().orphans.empty())
        return;
    ImGui::Spacing();
    ImGui::TextWrapped("Without a branch, and kept until it comes back:");
    for (auto const& orphan : model.state().orphans)
        ImGui::TextWrapped("%s: %s", orphan.name.c_str(), orphan.place.c_str());
    if (controls.button("Take them away", item_px()))
        model.perform(view::TakeOrphansAway {});
}

// Shows a slider for the season. At its left end there is no season: leaves look as the models
// define them. After a change the slider keeps its position until the plant is updated, for which
// leaves may have to be grown.
void Menu::show_season(view::WindowModel& model)
{
    scene::Season const none { .month = 0 };
    auto const shown = model.state().season.value_or(none);
    if (wanted_season_ == shown)
        wanted_season_.reset();
    auto season = wanted_season_.value_or(shown);
    bool is_released = false;
    auto const text = season.month < 1 ? std::string("no season") : scene::month_name(season.month);
    bool moves = show_slider("##season", text.c_str(), kLastMonth, season.month, is_released);
    if (season.month >= 1) {
        auto const lie = fmt::format("fallen leaves: {:.0f} %% lie", 100 * season.fallen);
        moves |= show_slider("##fallen", lie.c_str(), 1, season.fallen, is_released);
    }
    if (!moves && !is_released)
        return;
    if (season.month < 1)
        season = none;
    wanted_season_ = season;
    auto const slider
        = is_released ? view::ChangeGrowth::Slider::Released : view::ChangeGrowth::Slider::Moving;
    model.perform(
        view::ChangeSeason { season == none ? std::nullopt : std::optional(season), slider });
}

// Shows a slider. Returns true while the slider is dragged.
bool Menu::show_slider(char const* name, char const* text, float greatest, double& value,
                       bool& is_released) const
{
    auto shown = static_cast<float>(value);
    ImGui::SetNextItemWidth(row_px_);
    theme::push_button_frame(scale_);
    bool const moves
        = ImGui::SliderFloat(name, &shown, 0, greatest, text, ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleVar();
    if (moves)
        value = static_cast<double>(shown);
    is_released |= ImGui::IsItemDeactivatedAfterEdit();
    return moves;
}

} // namespace tractus::window
