#pragma once

#include "app/render/gpu_picture.h"
#include "app/view/start_page.h"
#include "app/window/card_grid.h"
#include "app/window/controls.h"
#include "app/window/hand_input.h"
#include "app/window/study_view.h"
#include "app/window/workspace.h"

#include <imgui.h>
#include <map>
#include <memory>
#include <optional>

namespace tractus::window {

// The start page, which fills the window: a grid of cards that are chosen with pen, mouse or
// keyboard, with the window's own buttons above it. The page scrolls by the wheel and by dragging,
// which may also begin on a card.
class StartView {
public:
    // `title_font` comes from theme::apply(); `scale` is the display's scale factor.
    StartView(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
        , study_(scale)
    {
    }

    // Draws the page into the current ImGui window.
    void show(view::StartPageModel& page, Workspace& workspace, Controls const& controls);

    // Handles a key. The letter of a card chooses the card; arrow keys move the focus, and Enter
    // chooses the card with the focus.
    void take_key(KeyPress const& press, view::StartPageModel& page, Workspace& workspace);

    // Frees the textures of the cards. Call this when the page is no longer shown.
    void leave();

private:
    struct Texture {
        // The picture that the texture contains. Immutable; shared with the page.
        std::shared_ptr<render::Image const> picture;
        render::GpuPicture on_card;
    };

    void show_head(view::StartPageModel& page, Workspace& workspace,
                   Controls const& controls) const;
    void show_cards(view::StartPageModel& page);
    bool show_card(view::StartCard const& card, ImVec2 const& size_px, bool has_focus);
    void draw_picture(view::StartCard const& card, ImVec2 const& corner);
    void draw_words(view::StartCard const& card, ImVec2 const& corner) const;
    float words_width() const;
    void draw_fitted(std::string const& text, ImVec2 const& place, float size_px,
                     ImU32 color) const;
    GLuint texture_of(std::shared_ptr<render::Image const> const& picture);
    void scroll(bool& presses_count);
    void scroll_to_focus() const;

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
    StudyView study_;
    CardGrid grid_;                    // Arrangement of the cards in the last frame.
    std::optional<std::size_t> focus_; // Index of the card that has the keyboard focus.
    bool focus_has_moved_ = false;     // True if the focus has moved since the last frame.
    bool scrolls_ = false;             // True if the current touch is scrolling the page.
    std::map<render::Image const*, Texture> textures_;
};

} // namespace tractus::window
