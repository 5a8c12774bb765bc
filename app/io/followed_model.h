#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace tractus::io {

// Watches a model for changes while its plant is drawn on. The files are its rules, the view and
// colours with the same name, and everything it included when it was last read successfully.
class FollowedModel {
public:
    // `drawn_on` is the model as the plant was made from it, or no value if the plant has another
    // model. Reads nothing, as a model's leaves may take a second to grow.
    FollowedModel(std::filesystem::path model, std::optional<scene::LoadModel> drawn_on);

    // The model if it has been saved since the last call, or the error in it. No value if its text
    // is unchanged, and while its files are changing, as editors save in several steps. Checks
    // twice a second by the clock `now`; reading takes milliseconds.
    std::optional<Result<scene::LoadModel>> take_change(Timestamp now);

private:
    // Time stamp and size of a file; no value if the file is missing.
    struct Stamp {
        std::filesystem::file_time_type written {};
        std::uintmax_t size = 0;

        bool operator==(Stamp const&) const = default;
    };
    using Stamps = std::vector<std::optional<Stamp>>;

    void list_files(scene::LoadModel const* model);
    Stamps look() const;

    std::filesystem::path model_;
    std::vector<std::filesystem::path> files_;
    std::optional<scene::LoadModel> loaded_ {}; // The model as last read; no value after an error.
    Stamps taken_; // Time stamps of the files when they were last read.
    Stamps last_look_;
    Timestamp next_look_ {};
};

} // namespace tractus::io
