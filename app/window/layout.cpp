#include "app/window/layout.h"

#include "app/tools/tool_choices.h"
#include "app/window/height_gauge.h"
#include "app/window/refusal_note.h"
#include "app/window/shortcuts.h"
#include "app/window/skeleton_notes.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace tractus::window {

namespace {

constexpr int kSavedWidth_px = 1600; // Width of the picture that "Save picture" writes.
constexpr int kSavedHeight_px = 1200;
constexpr float kGaugeWidth_px = 88;
// If less width than this remains beside the menu, only the plant is shown there.
constexpr float kMinForAll_px = 460;
constexpr double kAirAroundPad = 1.06;
// Minimum height left below the pad for the strokes to be shown there.
constexpr float kMinStrokes_px = 150;
constexpr float kPadTitle_px = 50; // Height of the title above the pad.
// Width of the list of strokes. The list is shown if the view beside it is at least as wide.
constexpr float kListWidth_px = 460;
constexpr float kTitleRow_px = 44;

using Shown = Workspace::Shown;

constexpr ImGuiWindowFlags kPanelFlags
    = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

} // namespace

WindowPart Layout::whole_window() const
{
    auto const& display = ImGui::GetIO().DisplaySize;
    return { 0, 0, display.x, display.y };
}

WindowPart Layout::above_controls() const
{
    auto part = whole_window();
    part.height = std::max(part.height - controls_.height_px() - tour_panel_.height_px(), 64.0f);
    return part;
}

// Returns the part of the window beside the menu; if the menu is closed, all of the window above
// the bar.
WindowPart Layout::beside_menu() const
{
    auto part = above_controls();
    if (!workspace_.menu_is_open())
        return part;
    float const menu_px = menu_.width_px(part.width);
    part.width -= menu_px;
    if (workspace_.is_left_handed)
        part.left += menu_px;
    return part;
}

// True while a text field receives all keys, even those that otherwise move the surface.
bool Layout::takes_text() const
{
    return ImGui::GetIO().WantTextInput || workspace_.name_request;
}

void Layout::show(view::WindowModel& model, render::Renderer& renderer, PenPointer const& pen,
                  HandInput const& all_input)
{
    auto input = all_input;
    if (takes_text())
        input.held.clear();
    begin_frame(model, input);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        model.calibration() || model.start_page() ? ImGui::GetStyle().WindowPadding
                                                                  : ImVec2(0, 0));
    ImGui::SetNextWindowPos({ 0, 0 });
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("station", nullptr, kPanelFlags | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    if (model.calibration() != nullptr || model.start_page() != nullptr) {
        if (model.calibration() != nullptr)
            show_calibration(model, pen);
        else
            show_start(model);
        ImGui::End();
        return;
    }
    if (workspace_.is_on_stage) {
        show_stage(model, renderer, input);
        ImGui::End();
        show_ring(model, pen);
        apply_view_requests();
        tell_pressing_areas(model);
        return;
    }
    show_views(model, renderer, input);
    ImGui::End();
    bool const is_beside_pen = model.state().has_pen() && workspace_.shown != Shown::All;
    auto const whole = whole_window();
    float const left = is_beside_pen ? std::max(0.0f, pen_area_.left_px()) : 0;
    float const right = is_beside_pen ? std::min(whole.width, pen_area_.right_px()) : whole.width;
    auto const bar = controls_.show(model, workspace_, left, right);
    covered_.push_back(bar);
    if (model.state().tour)
        covered_.push_back(tour_panel_.show(model, controls_, bar));
    else
        tour_panel_.hide();
    workspace_.gizmo_is_seen &= pad_part_.has_value();
    if (pad_part_)
        if (auto const gizmo = gizmo_panel_.show(model, workspace_, controls_, *pad_part_))
            covered_.push_back(*gizmo);
    if (workspace_.edited_number)
        covered_.push_back(number_panel_.show(model, workspace_, controls_, bar));
    if (workspace_.cards_are_shown)
        covered_.push_back(cards_panel_.show(model, workspace_, controls_, bar));
    if (workspace_.name_request)
        covered_.push_back(name_panel_.show(model, workspace_, controls_, bar, input.presses));
    show_menu(model, renderer);
    if (workspace_.keys_are_listed)
        covered_.push_back(show_shortcuts(model.state().tools, kPanelFlags, scale_));
    show_ring(model, pen);
    apply_view_requests();
    follow_angle(model);
    tell_pressing_areas(model);
}

// Shows the stage view: the plant, and what grows along the current stroke. The pen draws anywhere
// in the window.
void Layout::show_stage(view::WindowModel& model, render::Renderer& renderer,
                        HandInput const& input)
{
    auto const& state = model.state();
    auto const whole = whole_window();
    bool const draws = workspace_.draws(state);
    pen_area_ = fit_pen_area(state.volume_mm, { 0, 0 }, { whole.width, whole.height });
    ImGui::SetCursorScreenPos({ 0, 0 });
    plant_.show_on_stage(state, renderer, { whole.width, whole.height }, workspace_.drag, !draws);
    ImGui::SetCursorScreenPos({ 0, 0 });
    ImGui::InvisibleButton("stage", { whole.width, whole.height });
    pad_is_pointed_at_ = ImGui::IsItemHovered();
    if (!draws || !state.mouse_draws)
        mouse_.let_go(model);
    else if (!ring_.is_open())
        mouse_.hold(model, pen_area_, input.mouse);
    apply_surface_request(model, input, draws);
}

// Shows the start page. The pen operates controls in the whole window.
void Layout::show_start(view::WindowModel& model)
{
    auto const whole = whole_window();
    pen_area_ = fit_pen_area(model.state().volume_mm, { 0, 0 }, { whole.width, whole.height });
    mouse_.let_go(model);
    start_.show(*model.start_page(), workspace_, controls_);
    covered_.push_back(whole);
    tell_pressing_areas(model);
}

// Shows the calibration page. The pen operates controls in the whole window; the calibration also
// uses the places where the pen rests on the tablet.
void Layout::show_calibration(view::WindowModel& model, PenPointer const& pen)
{
    auto const whole = whole_window();
    auto const& state = model.state();
    pen_area_ = fit_pen_area(state.volume_mm, { 0, 0 }, { whole.width, whole.height });
    mouse_.let_go(model);
    auto& calibration = *model.calibration();
    bool const is_beside_drawing = state.is_live;
    bool const wants_back = calibration_.show(calibration, is_beside_drawing);
    if (pen.leads() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsAnyItemHovered())
        calibration.perform(calibration::PressWithPen {});
    covered_.push_back(whole);
    tell_pressing_areas(model);
    if (wants_back)
        model.perform(view::CloseCalibration {});
}

void Layout::show_menu(view::WindowModel& model, render::Renderer& renderer)
{
    if (workspace_.menu_is_open())
        covered_.push_back(menu_.show(model, workspace_, controls_, room_for_menu(), [&] {
            return plant_.picture(renderer, kSavedWidth_px, kSavedHeight_px);
        }));
    bool const watches = workspace_.menu == Workspace::MenuPage::Devices;
    if (std::exchange(devices_are_watched_, watches) != watches)
        model.perform(view::WatchDevices { watches });
}

void Layout::apply_view_requests()
{
    double const factor = std::exchange(workspace_.requested_zoom, 1);
    bool const whole = std::exchange(workspace_.is_whole_requested, false);
    if (workspace_.is_shown(Shown::Skeleton)) {
        zoom(workspace_.angle, whole ? 1 / workspace_.angle.zoom : factor);
        if (whole)
            workspace_.angle.moved_mm.setZero();
    }
    if (workspace_.is_shown(Shown::Strokes)) {
        if (whole)
            strokes_.look_at_whole();
        else if (factor != 1)
            strokes_.zoom(factor);
    }
    if (!workspace_.is_shown(Shown::Plant))
        return;
    if (whole)
        plant_.look_at_whole();
    else if (factor != 1)
        plant_.zoom(factor);
}

// Resets the views after the start page was left, and selects the drawing's tool.
void Layout::begin_drawing(view::WindowModel& model)
{
    start_.leave();
    workspace_.shown = Shown::All;
    workspace_.close_menu();
    workspace_.choose(model, model.state().hand);
    plant_.look_at_whole();
    strokes_.look_at_whole();
    workspace_.angle.zoom = 1;
    workspace_.angle.moved_mm.setZero();
    has_begun_ = false;
}

// Prepares a frame and handles its input. If there is a pen tablet, a drawing begins with the pad
// as the only view, unless Workspace::shown_first says otherwise.
void Layout::begin_frame(view::WindowModel& model, HandInput const& input)
{
    auto const& state = model.state();
    auto const* const page = model.start_page();
    bool const is_beside_drawing = page && page->state().is_beside_drawing;
    if (std::exchange(start_is_shown_, page != nullptr) && !page) {
        if (goes_back_to_drawing_)
            start_.leave();
        else
            begin_drawing(model);
    }
    goes_back_to_drawing_ = is_beside_drawing;
    bool const takes_pictures = !model.calibration() && (!page || is_beside_drawing);
    if (takes_pictures && !input.dropped.empty()) {
        if (auto* const pictures = model.start_page())
            pictures->leave();
        model.perform(view::LayPictureFile { input.dropped.front() });
    }
    if (!std::exchange(has_begun_, true))
        workspace_.shown
            = workspace_.shown_first.value_or(state.has_pen() ? Shown::Pad : workspace_.shown);
    workspace_.angle.area_mm
        = (state.volume_mm.max_mm - state.volume_mm.min_mm).head<2>().cwiseMax(1);
    covered_.clear();
    pad_part_.reset();
    pad_is_pointed_at_ = false;
    if (takes_text())
        return;
    for (auto const& press : input.presses)
        if (auto* const start = model.start_page(); start && model.calibration() == nullptr)
            start_.take_key(press, *start, workspace_);
        else if (model.calibration() != nullptr)
            take_calibration_shortcut(press, model, workspace_);
        else
            take_shortcut(press, model, workspace_, ring_);
}

void Layout::show_views(view::WindowModel& model, render::Renderer& renderer,
                        HandInput const& input)
{
    auto const& state = model.state();
    if (!state.mouse_draws || !workspace_.draws(state))
        mouse_.let_go(model);
    if (workspace_.shown != Shown::Collection && std::exchange(collection_is_shown_, false))
        CollectionView::end(model);
    if (workspace_.shown != Shown::All) {
        auto const whole = whole_window();
        pen_area_ = fit_pen_area(state.volume_mm, { 0, 0 }, { whole.width, whole.height });
        if (workspace_.shown == Shown::Pad)
            show_pad(model, renderer, whole, input);
        else if (workspace_.shown == Shown::Strokes)
            show_strokes(model, renderer, beside_menu());
        else if (workspace_.shown == Shown::Skeleton)
            show_skeleton(model, renderer, whole, input);
        else if (workspace_.shown == Shown::Plant)
            show_plant(state, renderer, beside_menu());
        else
            show_collection(model, renderer, beside_menu());
        if (workspace_.shown != Shown::Pad)
            apply_surface_request(model, input, false);
        return;
    }
    auto const room = beside_menu();
    float const gap = ImGui::GetStyle().ItemSpacing.x;
    float const width = std::max(room.width - 2 * gap, 192.0f);
    WindowPart part { room.left, 0, width * 0.37f, room.height };
    // The pen points at places in the whole window, unless a view in which it draws sets another
    // area.
    auto const whole = whole_window();
    pen_area_ = fit_pen_area(state.volume_mm, { 0, 0 }, { whole.width, whole.height });
    if (workspace_.menu_is_open() && room.width < kMinForAll_px * scale_) {
        mouse_.let_go(model);
        return show_plant(state, renderer, room);
    }
    float const strokes_px = strokes_height_px(state, part);
    part.height -= strokes_px;
    show_pad(model, renderer, part, input);
    if (strokes_px > 0)
        show_strokes(model, renderer,
                     { part.left, part.height + gap, part.width, strokes_px - gap });
    part = { part.left + part.width + gap, 0, width * 0.28f, room.height };
    show_skeleton(model, renderer, part, input);
    part = { part.left + part.width + gap, 0, width * 0.35f, room.height };
    show_plant(state, renderer, part);
}

// Returns the height left for the strokes below the pad in a column of the pad's width; 0 if there
// is too little.
float Layout::strokes_height_px(view::WindowState const& state, WindowPart const& column) const
{
    Vec2 const size_mm = state.surface_size_mm().cwiseMax(1);
    auto const aspect = static_cast<float>(size_mm.y() / size_mm.x());
    float const left_px = column.height - column.width * aspect - kPadTitle_px * scale_;
    return left_px < kMinStrokes_px * scale_ ? 0 : left_px;
}

// Shows the drawn strokes. If this view fills the window, a list of the strokes is shown beside it.
void Layout::show_strokes(view::WindowModel& model, render::Renderer& renderer, WindowPart part)
{
    auto const& state = model.state();
    std::optional<std::size_t> pressed;
    auto const whole = part;
    float const list_px = kListWidth_px * scale_;
    bool const has_list = workspace_.shown == Shown::Strokes && part.width >= 2 * list_px;
    if (has_list) {
        float const title_px = kTitleRow_px * scale_;
        float const list_left
            = workspace_.is_left_handed ? part.left + part.width - list_px : part.left;
        ImGui::SetCursorScreenPos({ list_left, part.top + title_px });
        pressed = strokes_.show_list(state, { list_px, part.height - title_px });
        part.width -= list_px;
        if (!workspace_.is_left_handed)
            part.left += list_px;
    }
    ImGui::SetCursorScreenPos({ part.left, part.top });
    if (auto const clicked
        = strokes_.show(state, renderer, { part.width, part.height }, workspace_.drag))
        pressed = clicked;
    show_title(whole, "Strokes",
               state.curves.empty() ? "none yet: what you draw is shown here"
                                    : "click one to choose it, drag to turn");
    strokes_.show_caption(state, { part.left + 14 * scale_, part.top + part.height - 12 * scale_ });
    if (pressed)
        model.perform(view::PickCurve { *pressed });
}

void Layout::show_title(WindowPart const& part, char const* title, char const* detail) const
{
    ImGui::SetCursorScreenPos({ part.left + 14 * scale_, part.top + 10 * scale_ });
    ImGui::PushFont(title_font_);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    ImGui::SameLine();
    float const room = part.left + part.width - ImGui::GetCursorScreenPos().x;
    if (ImGui::CalcTextSize(detail).x > room)
        return ImGui::NewLine();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 4 * scale_);
    ImGui::TextDisabled("%s", detail);
}

void Layout::show_pad(view::WindowModel& model, render::Renderer& renderer, WindowPart const& part,
                      HandInput const& input)
{
    auto const& state = model.state();
    bool const fills_window = workspace_.shown == Shown::Pad;
    auto const area = fit_pen_area(state.volume_mm, { part.left, part.top },
                                   { part.width, part.height }, fills_window ? 1 : kAirAroundPad);
    ImGui::SetCursorScreenPos({ part.left, part.top });
    pad_.show(state, renderer, area, { part.width, part.height });
    ImGui::SetCursorScreenPos({ part.left, part.top });
    ImGui::InvisibleButton("pad", { part.width, part.height });
    bool const draws_here = workspace_.draws(state) && !Workspace::selects(state);
    if (draws_here) {
        pen_area_ = area;
        if (state.mouse_draws && !ring_.is_open())
            mouse_.hold(model, area, input.mouse);
    }
    pad_part_ = part;
    pad_part_->height = std::min(part.height, above_controls().height);
    pad_is_pointed_at_ = ImGui::IsItemHovered();
    apply_surface_request(model, input, pad_is_pointed_at_);
    show_gauge(state, part, area);
    if (draws_here)
        draw_refusal(state, area, { part.left, part.top }, { part.width, pad_part_->height });
    show_title(part, "Drawing pad", state.tool.c_str());
}

// Draws the height gauge inside the visible part of the pad.
void Layout::show_gauge(view::WindowState const& state, WindowPart const& part,
                        PenArea const& area) const
{
    float const width = kGaugeWidth_px * scale_;
    bool const fills_window = workspace_.shown == Shown::Pad;
    float const right = part.left + part.width;
    float left = fills_window ? std::max(part.left, area.left_px()) : part.left;
    if (workspace_.is_left_handed)
        left = (fills_window ? std::min(right, area.right_px()) : right) - width;
    draw_height_gauge(state, { left, part.top + 40 * scale_ },
                      { width, pad_part_->height - 40 * scale_ },
                      workspace_.is_left_handed ? Side::Right : Side::Left);
}

// Returns where the skeleton's view shows the tablet. If the view fills the window, the whole
// tablet is visible. Beside other views, the scale is chosen so that the plant, which may be
// smaller, fills the view.
PenArea Layout::skeleton_area(view::WindowState const& state, WindowPart const& part) const
{
    auto area = fit_pen_area(state.volume_mm, { part.left, part.top }, { part.width, part.height });
    if (workspace_.shown != Shown::All)
        return area;
    auto const plant_mm
        = scene::fit_selection_view(state.skeleton_box_mm, { .area_mm = area.size_mm }).size_mm;
    double const air = 1.15;
    area.px_per_mm = std::min(static_cast<double>(part.height) / area.size_mm.y(),
                              static_cast<double>(part.width) / std::max(1.0, plant_mm.x() * air));
    return area;
}

void Layout::show_skeleton(view::WindowModel& model, render::Renderer& renderer,
                           WindowPart const& part, HandInput const& input)
{
    auto const& state = model.state();
    auto const area = skeleton_area(state, part);
    ImGui::SetCursorScreenPos({ part.left, part.top });
    skeleton_.show(state, renderer, workspace_.angle, area, { part.width, part.height });
    ImGui::SetCursorScreenPos({ part.left, part.top });
    ImGui::InvisibleButton("skeleton", { part.width, part.height });
    bool const selects_here = workspace_.draws(state) && Workspace::selects(state);
    turn_skeleton(workspace_.angle, area, !selects_here, workspace_.drag);
    if (selects_here) {
        pen_area_ = area;
        draw_selecting_ink(state, area);
        draw_refusal(state, area, { part.left, part.top }, { part.width, above_controls().height });
        if (state.mouse_draws && !ring_.is_open())
            mouse_.hold(model, area, input.mouse);
    }
    show_title(part, "Skeleton",
               selects_here ? "draw along a branch to select it" : "drag to turn, wheel to zoom");
    draw_skeleton_legend(skeleton_.states(),
                         { part.left + 14 * scale_, above_controls().height - 12 * scale_ });
}

void Layout::show_plant(view::WindowState const& state, render::Renderer& renderer,
                        WindowPart const& part)
{
    ImGui::SetCursorScreenPos({ part.left, part.top });
    plant_.show(state, renderer, { part.width, part.height }, workspace_.drag);
    show_title(part, "Plant", fmt::format("seed {}", state.seed).c_str());
}

void Layout::show_collection(view::WindowModel& model, render::Renderer& renderer,
                             WindowPart const& part)
{
    if (!std::exchange(collection_is_shown_, true))
        CollectionView::begin(model);
    auto const before = model.state().seed;
    float const title_px = kTitleRow_px * scale_;
    float const gap = ImGui::GetStyle().ItemSpacing.x;
    float const panel_px = individuality_.width_px(part.width);
    float const sheet_px = part.width - panel_px - gap;
    float const sheet_left = part.left + (workspace_.is_left_handed ? panel_px + gap : 0);
    float const panel_left = part.left + (workspace_.is_left_handed ? gap : sheet_px);
    ImGui::SetCursorScreenPos({ sheet_left, part.top + title_px });
    collection_.show(model, renderer, { sheet_px, part.height - title_px });
    individuality_.show(model, controls_,
                        { panel_left, part.top + title_px, panel_px, part.height - title_px },
                        CollectionView::kVariations);
    show_title(part, "Variations", "press one to give the plant its branches and its growth");
    if (model.state().seed != before)
        workspace_.shown = Shown::Plant;
}

// Returns the part of the window in which the menu is shown; the pen can reach all of it.
WindowPart Layout::room_for_menu() const
{
    auto room = above_controls();
    if (workspace_.shown == Shown::All)
        return room;
    room.width = std::min(room.width, pen_area_.right_px());
    if (workspace_.is_left_handed) {
        room.left = std::max(0.0f, pen_area_.left_px());
        room.width -= room.left;
    }
    return room;
}

// Returns the entries of the tool ring: the tools and other frequent commands.
std::vector<RingEntry> Layout::ring_entries(view::WindowModel& model)
{
    std::vector<RingEntry> entries;
    auto const& state = model.state();
    for (auto const& choice : tools::tool_choices(state.tools, workspace_.remembered(state)))
        entries.push_back(
            { choice.text, choice.tool.kind().icon,
              [this, &model, tool = choice.tool] { workspace_.choose(model, tool); } });
    entries.push_back({ "View", "", [this] { workspace_.choose_view_tool(); } });
    entries.push_back({ "Undo", "", [&model] { model.perform(view::Undo {}); } });
    entries.push_back({ "Redo", "", [&model] { model.perform(view::Redo {}); } });
    if (workspace_.is_on_stage)
        entries.push_back({ "Off\nstage", "", [this] { workspace_.is_on_stage = false; } });
    else
        entries.push_back({ "Next\nview", "", [this] { workspace_.show_next(); } });
    return entries;
}

void Layout::show_ring(view::WindowModel& model, PenPointer const& pen)
{
    auto const& state = model.state();
    if (!state.is_live)
        return;
    bool const mouse_asks
        = !pen.leads() && ImGui::IsMouseClicked(ImGuiMouseButton_Right) && pad_is_pointed_at_;
    if (!ring_.is_open() && (mouse_asks || pen.requests_tool_ring())) {
        ring_.open(pen.leads() ? pen.place_px() : ImGui::GetIO().MousePos, scale_);
        // The touch that opened the ring operates the controls, so that it does not draw.
        model.perform(view::PressInstead {});
    }
    bool const let_go
        = pen.leads() ? pen.has_released_barrel() : ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    auto const entries = ring_entries(model);
    auto const chosen = ring_.show(entries, let_go);
    if (ring_.is_open())
        covered_.push_back(whole_window());
    if (chosen)
        entries[*chosen].choose();
}

// Makes the tool select branches from the direction in which the skeleton's view now shows the
// plant.
void Layout::follow_angle(view::WindowModel& model) const
{
    auto const& state = model.state();
    if (!state.is_live || state.is_hand_simulated || !Workspace::selects(state)
        || state.hand.angle() == workspace_.angle || state.pen.touching)
        return;
    model.perform(view::ChooseTool { state.hand.seen_from(workspace_.angle) });
}

void Layout::tell_pressing_areas(view::WindowModel& model)
{
    auto const& state = model.state();
    if (!state.has_pen())
        return;
    if (!workspace_.draws(state))
        covered_.push_back(whole_window());
    std::vector<Eigen::AlignedBox2d> areas;
    for (auto const& part : covered_) {
        Eigen::AlignedBox2d area;
        area.extend(pen_area_.to_mm({ part.left, part.top }));
        area.extend(pen_area_.to_mm({ part.left + part.width, part.top + part.height }));
        areas.push_back(area);
    }
    auto const is_same
        = [](Eigen::AlignedBox2d const& a, Eigen::AlignedBox2d const& b) { return a.isApprox(b); };
    if (std::equal(areas.begin(), areas.end(), last_covered_areas_.begin(),
                   last_covered_areas_.end(), is_same))
        return;
    last_covered_areas_ = areas;
    model.perform(view::SetPressingAreas { std::move(areas) });
}

} // namespace tractus::window
