#pragma once

#include "app/window/calibration_panel.h"
#include "app/window/cards_panel.h"
#include "app/window/collection_view.h"
#include "app/window/controls.h"
#include "app/window/gizmo_panel.h"
#include "app/window/individuality_panel.h"
#include "app/window/menu.h"
#include "app/window/mouse_hand.h"
#include "app/window/name_panel.h"
#include "app/window/number_panel.h"
#include "app/window/pen_pointer.h"
#include "app/window/start_view.h"
#include "app/window/strokes_view.h"
#include "app/window/tool_ring.h"
#include "app/window/tour_panel.h"
#include "app/window/views.h"

#include <optional>
#include <utility>
#include <vector>

namespace tractus::window {

// The contents of the window: several views side by side or a single view, with the bar of
// controls, the menu and the ring of tools on top. Draws one ImGui frame at a time, and passes
// input to the model at once.
class Layout {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    Layout(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
        , calibration_(title_font, scale)
        , controls_(scale)
        , menu_(title_font, scale)
        , number_panel_(scale)
        , gizmo_panel_(scale)
        , cards_panel_(scale)
        , name_panel_(scale)
        , start_(title_font, scale)
        , individuality_(scale)
        , tour_panel_(title_font, scale)
    {
    }

    // Returns the area that the pen points at, as shown in the last frame.
    PenArea const& pen_area() const { return pen_area_; }

    // Shows a frame. `input` contains the events of mouse and keyboard since the last frame.
    void show(view::WindowModel& model, render::Renderer& renderer, PenPointer const& pen,
              HandInput const& input);

    // True if the user has asked to close the window since the last call.
    bool take_close_request() { return std::exchange(workspace_.is_close_requested, false); }

    Workspace& workspace() { return workspace_; }

private:
    bool takes_text() const;
    void begin_frame(view::WindowModel& model, HandInput const& input);
    void show_calibration(view::WindowModel& model, PenPointer const& pen);
    void show_start(view::WindowModel& model);
    void begin_drawing(view::WindowModel& model);
    void show_stage(view::WindowModel& model, render::Renderer& renderer, HandInput const& input);
    void show_menu(view::WindowModel& model, render::Renderer& renderer);
    void show_views(view::WindowModel& model, render::Renderer& renderer, HandInput const& input);
    void show_pad(view::WindowModel& model, render::Renderer& renderer, WindowPart const& part,
                  HandInput const& input);
    void show_gauge(view::WindowState const& state, WindowPart const& part,
                    PenArea const& area) const;
    float strokes_height_px(view::WindowState const& state, WindowPart const& column) const;
    void show_strokes(view::WindowModel& model, render::Renderer& renderer, WindowPart part);
    void show_skeleton(view::WindowModel& model, render::Renderer& renderer, WindowPart const& part,
                       HandInput const& input);
    void show_plant(view::WindowState const& state, render::Renderer& renderer,
                    WindowPart const& part);
    void show_collection(view::WindowModel& model, render::Renderer& renderer,
                         WindowPart const& part);
    void show_title(WindowPart const& part, char const* title, char const* detail) const;
    void apply_view_requests();
    std::vector<RingEntry> ring_entries(view::WindowModel& model);
    void show_ring(view::WindowModel& model, PenPointer const& pen);
    void tell_pressing_areas(view::WindowModel& model);
    void follow_angle(view::WindowModel& model) const;
    WindowPart above_controls() const;
    WindowPart beside_menu() const;
    WindowPart room_for_menu() const;
    PenArea skeleton_area(view::WindowState const& state, WindowPart const& part) const;
    WindowPart whole_window() const;

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
    Workspace workspace_;
    CalibrationPanel calibration_;
    Controls controls_;
    Menu menu_;
    NumberPanel number_panel_;
    GizmoPanel gizmo_panel_;
    CardsPanel cards_panel_;
    NamePanel name_panel_;
    StartView start_;
    PadView pad_;
    StrokesView strokes_;
    SkeletonView skeleton_;
    PlantView plant_;
    CollectionView collection_;
    IndividualityPanel individuality_;
    TourPanel tour_panel_;
    ToolRing ring_;
    MouseHand mouse_;
    PenArea pen_area_;
    // Panels that are shown in this frame; over them the pen does not draw.
    std::vector<WindowPart> covered_;
    // Areas of those panels, as last passed to the model. World frame.
    std::vector<Eigen::AlignedBox2d> last_covered_areas_;
    std::optional<WindowPart> pad_part_; // Rectangle of the drawing pad in this frame.
    bool pad_is_pointed_at_ = false;     // True if the mouse hovers over the pad in this frame.
    bool collection_is_shown_ = false;
    bool devices_are_watched_ = false;
    bool has_begun_ = false;
    bool start_is_shown_ = false; // True if a start page was shown in the last frame.
    // True if the page that is shown was opened from a drawing, to which the user can return.
    bool goes_back_to_drawing_ = false;
};

} // namespace tractus::window
