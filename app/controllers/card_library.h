#pragma once

#include "app/tools/tool_cards.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

// The user's own cards (presets of tools), stored as text files NAME.card in a folder.
class CardLibrary {
public:
    // Maximum number of cards shown for a kind of tool.
    static constexpr std::size_t kMaxCards = 500;

    // `folder` need not exist yet. Empty: no cards can be saved.
    explicit CardLibrary(std::filesystem::path folder = {})
        : folder_(std::move(folder))
    {
    }

    // Returns the cards for a kind of tool, sorted by name, at most kMaxCards. Files that are not
    // valid cards are skipped.
    std::vector<tools::ToolCard> cards_of(tools::ToolKinds kinds,
                                          tools::ToolKind const& kind) const;

    // Saves the tool as a card under an unused name such as "Rule 3", and returns the name. Fails
    // with a user error if the card cannot be written.
    Result<std::string> keep(tools::Tool const& hand) const;

    // Renames a card. Fails with a user error if the new name is not a valid file name or is
    // already used.
    Result<void> rename(std::string const& from, std::string const& to) const;

    Result<void> remove(std::string const& name) const;

private:
    std::filesystem::path file_of(std::string const& name) const;

    std::filesystem::path folder_;
};

} // namespace tractus::controllers
