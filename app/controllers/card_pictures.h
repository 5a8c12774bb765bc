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

// Small pictures of models, sessions and pictures, for the cards of a page: the one that lies
// beside a model (MODEL.png), else one that was made before and is kept in a folder, else a new
// one, which is kept there. They are read and made in the background, one after another. Belongs to
// one thread.
class CardPictures {
public:
    static constexpr int kWidth_px = 360;
    static constexpr int kHeight_px = 250;

    // Empty: none is kept.
    CardPictures(scene::EditKinds kinds, std::filesystem::path kept_in);
    CardPictures(CardPictures const&) = delete;
    CardPictures& operator=(CardPictures const&) = delete;
    ~CardPictures();

    // Of these files in this order, and of no others that were wanted before.
    void want(std::deque<std::filesystem::path> files);

    // The next that is there since the last call. Its picture is null where there is none: the file
    // cannot be read, nothing is drawn in it, or it is too much to be looked at in passing.
    struct Made {
        std::filesystem::path file;
        std::shared_ptr<render::Image const> picture; // Shared with nobody.
    };
    std::optional<Made> take();

    bool is_busy() const { return is_making_ || !waiting_.empty(); }

    // Waits for the one that is being made, which take() gives next.
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
    std::unique_ptr<batch::PictureThread>
        drawing_;                                // The job's; null until a picture has to be drawn.
    bool cannot_draw_ = false;                   // Likewise.
    NewestJob<std::filesystem::path, Made> job_; // Last: it uses the others.
};

} // namespace tractus::controllers
