#pragma once

#include "app/controllers/card_pictures.h"
#include "app/view/start_page.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

// Contents of a page on which the user chooses a file or, if that is offered, no file.
struct Choices {
    struct Choice {
        std::string title {};
        std::string detail {};
        std::filesystem::path file {}; // The file that is chosen; empty: the choice "none".
    };
    struct Group {
        std::string title {};
        std::vector<Choice> choices {};
    };
    std::string question {};      // Heading of the page: a question such as "Which ...?".
    std::vector<Group> groups {}; // Groups of choices; empty groups are not shown.
    std::string if_none {};       // Heading of the page if there are no choices at all.
};

// Returns the pictures to choose from, for laying one behind the drawing: the newest pictures in
// each of the folders.
Choices picture_choices(std::vector<std::filesystem::path> const& folders);

// Files of the leaves that were drawn in a document or that its active plant carries.
struct LeavesInDocument {
    struct Drawn {
        std::filesystem::path file {};
        // Text on the leaf's card that says what choosing it does (Choice::detail).
        std::string on_choice {};
    };
    std::vector<Drawn> drawn {};
    std::vector<Drawn> in_views {}; // Leaves drawn in three views.
    std::filesystem::path kept {};  // File of the current foliage; empty if it is among the others.
    bool takes_views = false;
};

// Returns the leaves that can be chosen for a plant: its own, those of built-in species, those of
// grammars in `folder`, those drawn in the document, and the current foliage if it is none of
// these. Plants that accept leaves drawn in three views can also choose such leaves: built-in ones,
// the user's, and those of the document.
Choices leaf_choices(std::filesystem::path const& folder, LeavesInDocument const& document = {});

// A page of cards with pictures, on which the user chooses a file. Use from one thread.
class ChoicePage final : public view::StartPageModel {
public:
    // `small_pictures` is the cache folder for the cards' thumbnails; empty: they are not cached.
    explicit ChoicePage(std::filesystem::path const& small_pictures);

    void open(Choices choices);
    bool is_open() const { return is_open_; }

    // Shows the thumbnails that the background thread has finished.
    void advance();
    void settle();

    // Returns the chosen file if the user has chosen one since the last call; the page is then
    // closed.
    std::optional<std::filesystem::path> take_chosen()
    {
        return std::exchange(chosen_, std::nullopt);
    }

    view::StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override;
    void leave() override;

private:
    void show_picture(CardPictures::Made const& made);

    bool is_open_ = false;
    view::StartPageState state_;
    // Files of the cards of `state_`, with the same indices.
    std::vector<std::vector<std::filesystem::path>> files_ {};
    std::optional<std::filesystem::path> chosen_ {};
    CardPictures pictures_;
};

} // namespace tractus::controllers
