#include "app/window/shortcuts.h"

#include "app/tools/tool_choices.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::window {

namespace {

constexpr double kWheelStep_mm = 10;
// Distance by which a step of the mouse wheel moves the surface while Shift is held.
constexpr double kFineWheelStep_mm = 1;
constexpr double kKeySpeed_mm_s = 80;

// Does the first of these that applies: closes an open panel, leaves the stage view, leaves full
// screen, or closes the window.
void take_escape(Workspace& workspace, ToolRing& ring)
{
    bool const is_anything_open = ring.is_open() || workspace.menu_is_open()
        || workspace.keys_are_listed || workspace.edited_number;
    ring.close();
    workspace.close_menu();
    workspace.keys_are_listed = false;
    workspace.edited_number.reset();
    if (is_anything_open)
        return;
    if (workspace.is_on_stage)
        workspace.is_on_stage = false;
    else if (workspace.will_fill_display())
        workspace.turn_full_screen();
    else
        workspace.is_close_requested = true;
}

void take_undo_key(view::WindowModel& model, bool is_redo)
{
    if (is_redo)
        model.perform(view::Redo {});
    else
        model.perform(view::Undo {});
}

void take_tool_key(char key, view::WindowModel& model, Workspace& workspace)
{
    auto const& state = model.state();
    if (!state.is_live)
        return;
    if (key == 'T')
        return workspace.choose_view_tool();
    for (auto const* const kind : state.tools)
        if (kind->key == key)
            return workspace.choose(model,
                                    tools::newly_selected_tool(*kind, workspace.remembered(state)));
}

// Returns the keys and the names of the tools that have keys, such as "D C" and "Draw, Select".
std::pair<std::string, std::string> tool_keys(tools::ToolKinds tools)
{
    std::string keys;
    std::string names;
    for (auto const* const kind : tools)
        if (kind->key) {
            keys += fmt::format("{}{}", keys.empty() ? "" : "  ", kind->key);
            names += fmt::format("{}{}", names.empty() ? "" : ", ",
                                 *kind->method ? kind->method : kind->group);
        }
    return { keys, names };
}

} // namespace

void take_shortcut(KeyPress const& press, view::WindowModel& model, Workspace& workspace,
                   ToolRing& ring)
{
    if (press.has_control && press.key == 'Z')
        return take_undo_key(model, press.has_shift);
    if (press.has_control && press.key == 'N')
        return model.perform(view::OpenStartPage {});
    if (press.has_control && press.key != 'Q')
        return;
    switch (press.key) {
    case '?':
        workspace.keys_are_listed = !workspace.keys_are_listed;
        return;
    case KeyPress::kEscape:
        return take_escape(workspace, ring);
    case 'Q':
        workspace.is_close_requested = true;
        return;
    case 'N':
        return model.perform(view::NextVariation {});
    case 'V':
        return workspace.show_next();
    case 'F':
        return workspace.turn_full_screen();
    default:
        return take_tool_key(press.key, model, workspace);
    }
}

void take_calibration_shortcut(KeyPress const& press, view::WindowModel& model,
                               Workspace& workspace)
{
    bool const is_beside_drawing = model.state().is_live;
    if (press.key == KeyPress::kEscape && is_beside_drawing)
        model.perform(view::CloseCalibration {});
    else if (press.key == KeyPress::kEscape || press.key == 'Q')
        workspace.is_close_requested = true;
}

void apply_surface_request(view::WindowModel& model, HandInput const& input, bool wheel_counts)
{
    if (!model.state().mouse_moves_surface)
        return;
    auto const& io = ImGui::GetIO();
    double by_mm = 0;
    if (wheel_counts)
        by_mm += static_cast<double>(io.MouseWheel)
            * (io.KeyShift ? kFineWheelStep_mm : kWheelStep_mm);
    double const step_s = std::min(0.1, static_cast<double>(io.DeltaTime));
    if (input.holds('W'))
        by_mm += kKeySpeed_mm_s * step_s;
    if (input.holds('S'))
        by_mm -= kKeySpeed_mm_s * step_s;
    if (by_mm != 0)
        model.perform(view::MoveSurface { by_mm });
}

WindowPart show_shortcuts(tools::ToolKinds tools, ImGuiWindowFlags flags, float scale)
{
    struct Key {
        char const* key;
        char const* meaning;
    };
    static constexpr std::array<Key, 13> kKeys {
        { { "T", "turn and zoom views" },
          { "V", "the next view" },
          { "F", "full screen, or a window again" },
          { "W  S", "surface up, down (without a height sensor)" },
          { "wheel", "the same over the pad; with Shift finely" },
          { "right button", "ring of tools; turns the skeleton" },
          { "Ctrl+Z", "undo" },
          { "Ctrl+Shift+Z", "redo" },
          { "N", "another one: the next seed" },
          { "Ctrl+N", "closes the drawing, for another one" },
          { "?", "this list" },
          { "Esc", "closes what is open, the stage, full screen, or the window" },
          { "Q", "closes the window" } }
    };
    ImGui::SetNextWindowPos({ 40 * scale, 60 * scale });
    ImGui::Begin("keys", nullptr, flags | ImGuiWindowFlags_AlwaysAutoResize);
    auto const show = [&](char const* key, char const* meaning) {
        ImGui::TextUnformatted(key);
        ImGui::SameLine(190 * scale);
        ImGui::TextDisabled("%s", meaning);
    };
    auto const [keys, names] = tool_keys(tools);
    show(keys.c_str(), names.c_str());
    for (auto const& [key, meaning] : kKeys)
        show(key, meaning);
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    ImGui::End();
    return { corner.x, corner.y, size.x, size.y };
}

} // namespace tractus::window
