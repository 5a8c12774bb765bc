#pragma once

#include "app/controllers/card_library.h"
#include "app/view/window_model.h"

#include <filesystem>

namespace tractus::controllers {

// The user's own cards as the window shows them, and the commands on them. The result of a command,
// or the error, appears in the state's status.
class LiveCards {
public:
    explicit LiveCards(std::filesystem::path const& folder)
        : library_(folder)
        , folder_(folder)
    {
    }

    // Shows the cards for the current tool's kind; reads the folder when the kind changes.
    void show(view::WindowState& state);
    void show_again(view::WindowState& state); // Reads the folder of cards again and shows them.

    void perform(view::KeepCard const&, view::WindowState& state);
    void perform(view::RenameCard const& command, view::WindowState& state);
    void perform(view::RemoveCard const& command, view::WindowState& state);

private:
    CardLibrary library_;
    std::filesystem::path folder_;
    tools::ToolKind const* shown_ = nullptr; // The kind whose cards are shown.
};

} // namespace tractus::controllers
