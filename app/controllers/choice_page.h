#pragma once

#include "app/controllers/card_pictures.h"
#include "app/view/start_page.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

// Contents of a page on which the user chooses a file, or none.
struct Choices {
    struct Choice {
        std::string title {};
        std::string detail {};
        std::filesystem::path file {}; // The file to choose; empty: the choice "none".
    };
    struct Group {
        std::string title {};
        std::vector<Choice> choices {};
    };
    std::string question {};      // Heading of the page, such as "Which ...?".
    std::vector<Group> groups {}; // Groups of choices; groups without choices are not shown.
    std::string if_none {};       // Heading of the page if there are no choices at all.
};

// Pictures to lay behind the drawing: the newest in each of these folders.
Choices picture_choices(std::vector<std::filesystem::path> const& folders);

// Files of the leaves that were drawn in a document or are worn by its active plant.
struct LeavesInDocument {
    struct Drawn {
        std::filesystem::path file {};
        std::string on_choice {}; // Text on the card that says what choosing it does.
    };
    std::vector<Drawn> drawn {};
    std::vector<Drawn> in_views {}; // Leaves drawn in three views.
    std::filesystem::path kept {};  // File of the current foliage; empty if it is among the others.
    bool takes_views = false;
};

// The leaves that can be chosen for a plant: its own, those of the built-in species, those of
// grammars in the user's folder, those drawn in the document, and its current foliage if that is
// none of these. For plants that accept leaves drawn in three views, also built-in ones, the user's
// and the document's.
Choices leaf_choices(std::filesystem::path const& folder, LeavesInDocument const& document = {});

// A page of cards with pictures, on which a file is chosen. Use from one thread.
class ChoicePage final : public view::StartPageModel {
public:
    // `small_pictures` is the cache folder for the cards' thumbnails; empty: no caching.
    explicit ChoicePage(std::filesystem::path const& small_pictures);

    void open(Choices choices);
    bool is_open() const { return is_open_; }

    // Takes finished pictures from the background thread.
    void advance();
    void settle();

    // Returns the chosen file, after which the page is closed.
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
    // Files of the state's cards, with the same indices.
    std::vector<std::vector<std::filesystem::path>> files_ {};
    std::optional<std::filesystem::path> chosen_ {};
    CardPictures pictures_;
};

} // namespace tractus::controllers
