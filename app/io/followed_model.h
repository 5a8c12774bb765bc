#pragma once

#include "engine/base/result.h"
#include "engine/base/time.h"
#include "engine/scene/edit.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace tractus::io {

// A model that somebody writes while its plant is drawn on: its files are looked at for changes.
// Files that count are the rules, the view and colours of the model's name, and what the model
// included when it was last read without a fault.
class FollowedModel {
public:
    // `drawn_on`: the model as its plant is drawn on; no value: that is another one. Reads nothing:
    // a model's leaves may take a second to grow.
    FollowedModel(std::filesystem::path model, std::optional<scene::LoadModel> drawn_on);

    // The model, where it has been saved since the last call, or why it is none any more. No value
    // where its text is what it was, and while its files change: editors write them in several
    // steps. Looks at them twice a second by the clock `now`; reading them takes milliseconds.
    std::optional<Result<scene::LoadModel>> take_change(Timestamp now);

private:
    // Of a file; no value where there is none.
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
    std::optional<scene::LoadModel> loaded_ {}; // No value after a fault.
    Stamps taken_;                              // Of the files as they were read.
    Stamps last_look_;
    Timestamp next_look_ {};
};

} // namespace tractus::io
