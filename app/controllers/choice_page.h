#pragma once

#include "app/controllers/card_pictures.h"
#include "app/view/start_page.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::controllers {

// What a page beside the drawing offers: files, and what stands for none.
struct Choices {
    struct Choice {
        std::string title {};
        std::string detail {};
        std::filesystem::path file {}; // Empty: none.
    };
    struct Group {
        std::string title {};
        std::vector<Choice> choices {};
    };
    std::string question {};      // "Which ...?"
    std::vector<Group> groups {}; // Groups without choices are left out.
    std::string if_none {};       // What is said in place of the question where there is no choice.
};

// The pictures of folders, to be laid behind what is drawn: the newest of each.
Choices picture_choices(std::vector<std::filesystem::path> const& folders);

// Leaves that a plant may have: its own, those of our species, those of the grammars in the user's
// folder, those that are drawn in the document, and what it wears that is none of them, by their
// files. Where it can bear leaves in three views: those of ours, of the user's and of the document,
// too.
struct LeavesInDocument {
    struct Drawn {
        std::filesystem::path file {};
        std::string on_choice {}; // What choosing it does.
    };
    std::vector<Drawn> drawn {};
    std::vector<Drawn> in_views {}; // Those that are drawn in three views.
    std::filesystem::path kept {};  // Empty: nothing else is worn.
    bool takes_views = false;
};
Choices leaf_choices(std::filesystem::path const& folder, LeavesInDocument const& document = {});

// A page on which one of them is chosen, with their pictures. Belongs to one thread.
class ChoicePage final : public view::StartPageModel {
public:
    // `small_pictures` is the folder where pictures for the cards are kept; empty: nowhere.
    explicit ChoicePage(std::filesystem::path const& small_pictures);

    void open(Choices choices);
    bool is_open() const { return is_open_; }

    // Takes what was made in the background.
    void advance();
    void settle();

    // The file of what was chosen: the page is closed then.
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
    std::vector<std::vector<std::filesystem::path>> files_ {}; // As the state's cards are.
    std::optional<std::filesystem::path> chosen_ {};
    CardPictures pictures_;
};

} // namespace tractus::controllers
