#include "app/controllers/card_pictures.h"

#include "app/batch/picture_thread.h"
#include "app/batch/plant_group.h"
#include "app/batch/session_plant.h"
#include "app/controllers/drawing_file.h"
#include "app/controllers/picture_files.h"
#include "app/controllers/recent_drawings.h"
#include "app/methods/all_leaves.h"
#include "app/methods/all_organs.h"
#include "app/render/read_picture.h"
#include "engine/base/file.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/back_picture.h"

#include <algorithm>
#include <chrono>
#include <fmt/core.h>
#include <functional>
#include <string>
#include <utility>

namespace tractus::controllers {

namespace fs = std::filesystem;

namespace {

// Limits for rendering a thumbnail: the file's size, and the time to build its plants.
constexpr std::uintmax_t kLargestFile_bytes = 32'000'000;
constexpr double kLongest_s = 5;

std::optional<render::Image> read_image(fs::path const& file, std::size_t most_bytes = 4'000'000)
{
    auto const bytes = read_file(file, most_bytes);
    if (!bytes)
        return std::nullopt;
    auto image = render::read_picture(*bytes);
    return image ? std::optional(*std::move(image)) : std::nullopt;
}

// Reads a picture and scales it to the size of a card.
std::optional<render::Image> small_picture(fs::path const& file)
{
    auto const image = read_image(file, scene::kMaxPictureBytes);
    if (!image || image->width() == 0)
        return std::nullopt;
    double const scale
        = std::min(1.0, static_cast<double>(CardPictures::kWidth_px) / image->width());
    auto const side = [&](int length) { return std::max(1, static_cast<int>(scale * length)); };
    return render::resized(*image, side(image->width()), side(image->height()));
}

// Renders a leaf of the grammar in the middle of a white card.
std::optional<render::Image> card_of_grammar(fs::path const& file)
{
    constexpr render::Color kPaper { 250, 250, 248, 255 };
    auto const leaf = methods::picture_of_grammar(file, CardPictures::kHeight_px, kPaper);
    if (!leaf)
        return std::nullopt;
    render::Image card(CardPictures::kWidth_px, CardPictures::kHeight_px, kPaper);
    render::paste(card, *leaf, (card.width() - leaf->width()) / 2, 0);
    return card;
}

bool is_grammar(fs::path const& file)
{
    return file.extension() == ".leaf";
}

// File name of a cached picture. `beginning` identifies the source file; the rest of `whole`
// identifies its version by time and size.
struct KeptName {
    std::string beginning;
    std::string whole;
};

KeptName kept_name(fs::path const& file)
{
    std::error_code ignored;
    auto const beginning = fmt::format(
        "card-{:016x}-", std::hash<std::string>()(fs::absolute(file, ignored).string()));
    return { beginning,
             fmt::format("{}{:x}-{:x}.png", beginning,
                         modification_time(file).time_since_epoch().count(),
                         fs::file_size(file, ignored)) };
}

// Caches a picture and deletes cached pictures of earlier versions of the source file. Errors are
// ignored.
void keep(render::Image const& picture, fs::path const& folder, KeptName const& name)
{
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().filename().string().starts_with(name.beginning)) {
            std::error_code ignored;
            fs::remove(entry->path(), ignored);
        }
    static_cast<void>(write_file(
        folder / name.whole, [&](std::ostream& out) { return render::write_png(out, picture); }));
}

} // namespace

CardPictures::CardPictures(scene::EditKinds kinds, fs::path kept_in)
    : kinds_(kinds)
    , kept_in_(std::move(kept_in))
    , job_([this](fs::path const& file, std::stop_token const& stop) { return make(file, stop); },
           Urgency::Later)
{
}

CardPictures::~CardPictures() = default;

void CardPictures::want(std::deque<fs::path> files)
{
    waiting_ = std::move(files);
}

std::optional<CardPictures::Made> CardPictures::take()
{
    std::optional<Made> made;
    if (is_making_) {
        made = job_.take();
        is_making_ = !made && job_.is_busy();
    }
    if (!is_making_ && !waiting_.empty()) {
        is_making_ = true;
        job_.want(std::move(waiting_.front()));
        waiting_.pop_front();
    }
    return made;
}

CardPictures::Made CardPictures::make(fs::path const& file, std::stop_token const& stop)
{
    Made made { file, nullptr };
    bool const has_none_beside_it = batch::is_session_file(file) || is_picture_file(file)
        || is_grammar(file) || methods::is_organ_file(file);
    auto image
        = has_none_beside_it ? std::nullopt : read_image(fs::path(file).replace_extension(".png"));
    auto const name = kept_name(file);
    if (!image && !kept_in_.empty())
        image = read_image(kept_in_ / name.whole);
    if (!image && !stop.stop_requested()) {
        image = is_picture_file(file) ? small_picture(file)
            : is_grammar(file)        ? card_of_grammar(file)
                                      : draw(file, stop);
        if (image && !kept_in_.empty())
            keep(*image, kept_in_, name);
    }
    if (image)
        made.picture = std::make_shared<render::Image const>(*std::move(image));
    return made;
}

std::optional<render::Image> CardPictures::draw(fs::path const& file, std::stop_token const& stop)
{
    std::error_code error;
    if (fs::file_size(file, error) > kLargestFile_bytes || error || cannot_draw_)
        return std::nullopt;
    if (methods::is_organ_file(file)) {
        auto const leaf = methods::plant_of_organ(file);
        return leaf ? draw(*leaf, stop) : std::nullopt;
    }
    document::ModelCost cost { .max_seconds = kLongest_s };
    using Clock = std::chrono::steady_clock;
    cost.is_stopped = [stop, end = Clock::now() + std::chrono::duration<double>(kLongest_s)] {
        return stop.stop_requested() || Clock::now() >= end;
    };
    auto const scene = scene_of_plant(file, kinds_, cost);
    if (!scene || scene->plants.empty() || stop.stop_requested())
        return std::nullopt;
    auto const plant = batch::shown_plants(*scene);
    if (!plant || plant->segment_count() == 0 || stop.stop_requested())
        return std::nullopt;
    return draw(*plant, stop);
}

std::optional<render::Image> CardPictures::draw(Plant const& plant, std::stop_token const& stop)
{
    auto const mesh = mesh::make_mesh(plant, {}, stop);
    if (stop.stop_requested())
        return std::nullopt;
    if (!drawing_) {
        auto thread = batch::PictureThread::create();
        cannot_draw_ = !thread;
        if (!thread)
            return std::nullopt;
        drawing_ = std::make_unique<batch::PictureThread>(*std::move(thread));
    }
    std::optional<render::Image> picture;
    drawing_->draw([&](batch::PictureMaker& maker) {
        picture = maker.plant(mesh, { .width_px = kWidth_px, .height_px = kHeight_px });
    });
    return picture;
}

} // namespace tractus::controllers
