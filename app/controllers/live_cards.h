#pragma once

#include "app/controllers/card_library.h"
#include "app/view/window_model.h"

#include <filesystem>

namespace tractus::controllers {

// A person's own cards as a window shows them, and what is done with them there. States say in the
// status what was done, or why not.
class LiveCards {
public:
    explicit LiveCards(std::filesystem::path const& folder)
        : library_(folder)
        , folder_(folder)
    {
    }

    // Shows the cards of the kind in hand, as the folder has them when that is taken in hand.
    void show(view::WindowState& state);
    void show_again(view::WindowState& state); // Reads the folder anew.

    void perform(view::KeepCard const&, view::WindowState& state);
    void perform(view::RenameCard const& command, view::WindowState& state);
    void perform(view::RemoveCard const& command, view::WindowState& state);

private:
    CardLibrary library_;
    std::filesystem::path folder_;
    tools::ToolKind const* shown_ = nullptr; // The kind whose cards are shown.
};

} // namespace tractus::controllers
