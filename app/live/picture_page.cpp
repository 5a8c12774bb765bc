#include "app/live/picture_page.h"

#include "app/live/picture_files.h"

#include <deque>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

// "~/Pictures": as a person names it.
std::string name_of(fs::path const& folder)
{
    auto const parent = folder.parent_path().filename().string();
    auto const name = folder.filename().string();
    return parent.empty() ? folder.string() : fmt::format("{}/{}", parent, name);
}

std::string where_to_put_one(std::vector<fs::path> const& folders)
{
    std::string places;
    for (auto const& folder : folders)
        places += (places.empty() ? "" : " or ") + folder.string();
    return places.empty()
        ? std::string("There is no folder of pictures: drop a PNG or JPEG file on the window")
        : fmt::format("Put a PNG or JPEG file into {}, or drop one on the window", places);
}

} // namespace

PicturePage::PicturePage(std::vector<fs::path> folders, fs::path const& small_pictures)
    : folders_(std::move(folders))
    , pictures_({}, small_pictures)
{
    state_.title = "Which picture shall lie behind what is drawn?";
    state_.is_beside_drawing = true;
}

void PicturePage::open()
{
    is_open_ = true;
    chosen_.reset();
    state_.groups.clear();
    files_.clear();
    std::deque<fs::path> wanted;
    for (auto const& folder : folders_) {
        auto files = pictures_in(folder, kMostOfFolder);
        if (files.empty())
            continue;
        StartCards cards { .title = name_of(folder) };
        for (auto const& file : files)
            cards.cards.push_back({ .title = file.stem().string(),
                                    .detail = file.parent_path() == folder
                                        ? std::string()
                                        : file.parent_path().filename().string() });
        wanted.insert(wanted.end(), files.begin(), files.end());
        state_.groups.push_back(std::move(cards));
        files_.push_back(std::move(files));
    }
    state_.note = files_.empty() ? where_to_put_one(folders_) : std::string();
    ++state_.revision;
    pictures_.want(std::move(wanted));
}

void PicturePage::advance()
{
    while (auto const made = pictures_.take())
        show_picture(*made);
}

void PicturePage::settle()
{
    while (pictures_.is_busy()) {
        advance();
        pictures_.settle();
    }
    advance();
}

void PicturePage::show_picture(CardPictures::Made const& made)
{
    for (std::size_t group = 0; group < files_.size(); ++group)
        for (std::size_t i = 0; i < files_[group].size(); ++i)
            if (files_[group][i] == made.file)
                state_.groups[group].cards[i].picture = made.picture;
    ++state_.revision;
}

void PicturePage::choose(std::size_t group, std::size_t card)
{
    if (group >= files_.size() || card >= files_[group].size())
        return;
    chosen_ = files_[group][card];
    leave();
}

void PicturePage::leave()
{
    is_open_ = false;
    pictures_.want({}); // Who draws needs the machine.
    ++state_.revision;
}

} // namespace tractus
