#pragma once

#include "app/live/card_pictures.h"
#include "app/station/start_page.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus {

// A page of pictures to be laid behind what is drawn: the newest of each of some folders. Belongs
// to one thread.
class PicturePage final : public StartPageModel {
public:
    static constexpr std::size_t kMostOfFolder = 60;

    // `small_pictures` is the folder where small pictures for the cards are kept; empty: nowhere.
    PicturePage(std::vector<std::filesystem::path> folders,
                std::filesystem::path const& small_pictures);

    void open(); // Shows it, with what there is now.
    bool is_open() const { return is_open_; }

    // Takes what was made in the background.
    void advance();
    void settle();

    // What was chosen: the page is closed then.
    std::optional<std::filesystem::path> take_chosen()
    {
        return std::exchange(chosen_, std::nullopt);
    }

    StartPageState const& state() const override { return state_; }
    void choose(std::size_t group, std::size_t card) override;
    void leave() override;

private:
    void show_picture(CardPictures::Made const& made);

    std::vector<std::filesystem::path> folders_;
    bool is_open_ = false;
    StartPageState state_;
    std::vector<std::vector<std::filesystem::path>> files_ {}; // As the state's cards are.
    std::optional<std::filesystem::path> chosen_ {};
    CardPictures pictures_;
};

} // namespace tractus
