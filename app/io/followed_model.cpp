#include "app/io/followed_model.h"

#include "app/io/model_file.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace tractus::io {

static bool same_text(scene::LoadModel const& one, scene::LoadModel const& other)
{
    return one.source.text == other.source.text && one.source.view_text == other.source.view_text
        && one.includes == other.includes;
}

FollowedModel::FollowedModel(std::filesystem::path model, std::optional<scene::LoadModel> drawn_on)
    : model_(std::move(model))
    , loaded_(std::move(drawn_on))
{
    list_files(loaded_ ? &*loaded_ : nullptr);
    taken_ = last_look_ = look();
}

// Lists the files to watch: those of the model itself and those that it includes.
void FollowedModel::list_files(scene::LoadModel const* model)
{
    files_ = { model_ };
    for (auto const* ending : { ".v", ".mat", ".map" })
        files_.push_back(std::filesystem::path(model_).replace_extension(ending));
    if (model)
        for (auto const& [name, text] : model->includes)
            files_.push_back(model_.parent_path() / name);
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

std::optional<Result<scene::LoadModel>> FollowedModel::take_change(Timestamp now)
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
    auto model = load_model_edit(model_);
    if (model) {
        loaded_ = *model;
        list_files(&*loaded_);
    }
    taken_ = last_look_ = look();
    if (loaded_ && before && same_text(*loaded_, *before))
        return std::nullopt;
    return model;
}

} // namespace tractus::io
