#pragma once

#include "app/render/image.h"
#include "engine/base/newest_job.h"
#include "engine/plant/plant.h"
#include "engine/scene/edit_kind.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>

namespace tractus::batch {
class PictureThread;
}

namespace tractus::controllers {

// Thumbnails of models, sessions and pictures for the cards of a page. The thumbnail of MODEL is
// the picture MODEL.png beside it, otherwise a cached picture, otherwise one that is rendered and
// cached. Thumbnails are loaded and rendered in the background, one after another. Use from one
// thread.
class CardPictures {
public:
    static constexpr int kWidth_px = 360;
    static constexpr int kHeight_px = 250;

    // `kept_in` is the cache folder; empty: thumbnails are not cached.
    CardPictures(scene::EditKinds kinds, std::filesystem::path kept_in);
    CardPictures(CardPictures const&) = delete;
    CardPictures& operator=(CardPictures const&) = delete;
    ~CardPictures();

    // Requests thumbnails of these files in this order; replaces earlier requests.
    void want(std::deque<std::filesystem::path> files);

    // A finished thumbnail. The picture is null if the file cannot be read or has nothing drawn in
    // it, if it is too large or takes too long, or if pictures cannot be rendered.
    struct Made {
        std::filesystem::path file;
        std::shared_ptr<render::Image const> picture; // The worker keeps no other reference to it.
    };
    std::optional<Made> take();

    bool is_busy() const { return is_making_ || !waiting_.empty(); }

    // Waits for the thumbnail in progress; take() then returns it.
    void settle() { job_.settle(); }

private:
    Made make(std::filesystem::path const& file, std::stop_token const& stop);
    std::optional<render::Image> draw(std::filesystem::path const& file,
                                      std::stop_token const& stop);
    std::optional<render::Image> draw(Plant const& plant, std::stop_token const& stop);

    scene::EditKinds kinds_;
    std::filesystem::path kept_in_;
    std::deque<std::filesystem::path> waiting_;
    bool is_making_ = false;
    // Renderer used only by the background job; null until a picture must be rendered.
    std::unique_ptr<batch::PictureThread> drawing_;
    // True if pictures cannot be rendered; used only by the background job.
    bool cannot_draw_ = false;
    // Declared last, because its job uses the other members.
    NewestJob<std::filesystem::path, Made> job_;
};

} // namespace tractus::controllers
