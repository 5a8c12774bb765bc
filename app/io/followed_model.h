#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace tractus::io {

// Watches a model for changes while the user draws on its plant. The watched files are its rules,
// the view and colours of the same name, and the files that it included when it was last read
// successfully.
class FollowedModel {
public:
    // `drawn_on` is the model from which the plant was made, or no value if the plant has another
    // model. The model is not read here, as its leaves may take a second to grow.
    FollowedModel(std::filesystem::path model, std::optional<scene::LoadModel> drawn_on);

    // Returns the model if it was saved since the last call, or the error in it. No value if its
    // text is unchanged, or while its files are still changing, as editors save in several steps.
    // Looks at the files at most twice a second by the clock `now`; reading them takes
    // milliseconds.
    std::optional<Result<scene::LoadModel>> take_change(Timestamp now);

private:
    // Time of the last change and size of a file; no value if the file is missing.
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
    Stamps taken_;                              // Stamps of the files when they were last read.
    Stamps last_look_;
    Timestamp next_look_ {};
};

} // namespace tractus::io
