#include "app/controllers/picture_files.h"

#include "app/controllers/recent_drawings.h"
#include "app/render/read_picture.h"
#include "engine/base/file.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::controllers {

namespace fs = std::filesystem;

bool is_picture_file(fs::path const& file)
{
    auto ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

std::vector<fs::path> pictures_in(fs::path const& folder, std::size_t most)
{
    constexpr int kDeepest = 2;
    // Maximum number of files examined per folder, as it may be a whole archive.
    constexpr std::size_t kMaxLookedAt = 20'000;
    std::vector<std::pair<std::chrono::sys_seconds, fs::path>> found;
    std::error_code error;
    std::size_t looked_at = 0;
    auto const options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, error), end;
         !error && entry != end && looked_at < kMaxLookedAt; entry.increment(error)) {
        ++looked_at;
        auto const& path = entry->path();
        if (entry.depth() >= kDeepest || path.filename().string().starts_with('.'))
            entry.disable_recursion_pending();
        std::error_code ignored;
        bool const is_hidden = path.filename().string().starts_with('.');
        if (!is_hidden && is_picture_file(path) && entry->is_regular_file(ignored))
            found.emplace_back(modification_time(path), path);
    }
    std::sort(found.begin(), found.end(), [](auto const& one, auto const& other) {
        return one.first != other.first ? one.first > other.first : one.second < other.second;
    });
    found.resize(std::min(found.size(), most));
    std::vector<fs::path> pictures;
    for (auto& [time, path] : found)
        pictures.push_back(std::move(path));
    return pictures;
}

Result<scene::LayPicture> load_back_picture(fs::path const& file, Vec2 const& tablet_mm)
{
    constexpr double kShare = 0.9; // Maximum size of the picture, as a share of the tablet's.
    auto bytes = TRY(read_file(file, scene::kMaxPictureBytes));
    auto const image = render::read_picture(bytes);
    if (!image)
        return fail(Fault::User, fmt::format("{}: {}", file.string(), image.error().message));
    double const aspect = static_cast<double>(image->width()) / image->height();
    scene::LayPicture edit { .name = file.filename().string(), .file = std::move(bytes) };
    edit.place.width_mm = std::clamp(kShare * std::min(tablet_mm.x(), tablet_mm.y() * aspect),
                                     scene::kMinPictureWidth_mm, scene::kGreatestPictureWidth_mm);
    return edit;
}

} // namespace tractus::controllers
