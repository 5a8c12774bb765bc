#pragma once

#include "app/tools/tool_cards.h"
#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

// A person's own cards: text files NAME.card in a folder, one for each.
class CardLibrary {
public:
    static constexpr std::size_t kMostCards = 500; // More than a person looks through.

    // The folder need not be there. Empty: nothing can be kept.
    explicit CardLibrary(std::filesystem::path folder = {})
        : folder_(std::move(folder))
    {
    }

    // The cards of a kind by their names, at most kMostCards. Files that are no cards are left out.
    std::vector<tools::ToolCard> cards_of(tools::ToolKinds kinds,
                                          tools::ToolKind const& kind) const;

    // Keeps the card of a hand under a name that no other has: "Rule 3". Returns it. Fails, as the
    // user's fault, where it cannot be written.
    Result<std::string> keep(tools::Tool const& hand) const;

    // Fails, as the user's fault, for a name that no file can have, or another one has.
    Result<void> rename(std::string const& from, std::string const& to) const;

    Result<void> remove(std::string const& name) const;

private:
    std::filesystem::path file_of(std::string const& name) const;

    std::filesystem::path folder_;
};

} // namespace tractus::controllers
