#pragma once

#include "app/controllers/card_library.h"
#include "app/view/window_model.h"

#include <filesystem>

namespace tractus::controllers {

// The user's own cards, as the window shows them, and the commands that change them. The state's
// status shows the result of a command, or its error.
class LiveCards {
public:
    explicit LiveCards(std::filesystem::path const& folder)
        : library_(folder)
        , folder_(folder)
    {
    }

    // Shows the cards for the current tool's kind. Reads the folder only if the kind has changed.
    void show(view::WindowState& state);
    // Reads the folder of cards again and shows its cards.
    void show_again(view::WindowState& state);

    void perform(view::KeepCard const&, view::WindowState& state);
    void perform(view::RenameCard const& command, view::WindowState& state);
    void perform(view::RemoveCard const& command, view::WindowState& state);

private:
    CardLibrary library_;
    std::filesystem::path folder_;
    tools::ToolKind const* shown_ = nullptr; // Kind of tool whose cards are shown.
};

} // namespace tractus::controllers
