#include "app/plants/followed_model.h"

#include "app/plants/model_file.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace tractus {

FollowedModel::FollowedModel(std::filesystem::path model)
    : model_(std::move(model))
{
    auto loaded = load();
    if (loaded)
        loaded_ = *std::move(loaded);
    taken_ = last_look_ = look();
}

// What it includes counts from now on.
Result<LoadModel> FollowedModel::load()
{
    auto model = load_model_edit(model_);
    if (!model && !files_.empty())
        return model;
    files_ = { model_ };
    for (auto const* ending : { ".v", ".mat", ".map" })
        files_.push_back(std::filesystem::path(model_).replace_extension(ending));
    if (model)
        for (auto const& [name, text] : model->includes)
            files_.push_back(model_.parent_path() / name);
    return model;
}

FollowedModel::Stamps FollowedModel::look() const
{
    Stamps stamps;
    for (auto const& file : files_) {
        std::error_code error;
        Stamp stamp { .written = std::filesystem::last_write_time(file, error) };
        if (!error)
            stamp.size = std::filesystem::file_size(file, error);
        stamps.push_back(error ? std::nullopt : std::optional(stamp));
    }
    return stamps;
}

std::optional<Result<LoadModel>> FollowedModel::take_change(Timestamp now)
{
    constexpr Duration kLookEvery = std::chrono::milliseconds(500);
    if (now < next_look_)
        return std::nullopt;
    next_look_ = now + kLookEvery;
    auto stamps = look();
    bool const is_still_written = stamps != std::exchange(last_look_, stamps);
    if (is_still_written || stamps == taken_)
        return std::nullopt;
    auto const before = std::exchange(loaded_, std::nullopt);
    auto model = load();
    taken_ = last_look_ = look();
    if (model)
        loaded_ = *model;
    if (model && loaded_ == before)
        return std::nullopt;
    return model;
}

} // namespace tractus
