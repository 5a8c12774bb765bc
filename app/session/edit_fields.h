#pragma once

#include "engine/base/result.h"
#include "engine/scene/fields.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::session {

// JSON form of an edit's fields (EditRecord::fields). Keys keep their order.
using Json = nlohmann::ordered_json;

Json written(bool value);
Json written(int value);
Json written(std::uint32_t value);
Json written(std::uint64_t value);
Json written(double value);
Json written(std::string const& value);
Json written(Vec3 const& value);
Json written(PathAddress const& value);
Json written(TipRange const& value);
Json written(std::map<std::string, std::string> const& texts);

template<typename T> Json written(std::optional<T> const& value)
{
    return value ? written(*value) : Json();
}

template<typename T> Json written(std::vector<T> const& values)
{
    auto list = Json::array();
    for (auto const& value : values)
        list.push_back(written(value));
    return list;
}

// The inverse of written(). Returns false if the JSON has another type or its value is out of
// range.
bool read(Json const& json, bool& value);
bool read(Json const& json, int& value);
bool read(Json const& json, std::uint32_t& value);
bool read(Json const& json, std::uint64_t& value);
bool read(Json const& json, double& value);
bool read(Json const& json, std::string& value);
bool read(Json const& json, Vec3& value);
bool read(Json const& json, PathAddress& value);
bool read(Json const& json, TipRange& value);
bool read(Json const& json, std::map<std::string, std::string>& texts);

template<typename T> bool read(Json const& json, std::optional<T>& value)
{
    value.reset();
    return json.is_null() || read(json, value.emplace());
}

template<typename T> bool read(Json const& json, std::vector<T>& values)
{
    values.clear();
    if (!json.is_array())
        return false;
    for (auto const& element : json)
        if (!read(element, values.emplace_back()))
            return false;
    return true;
}

// Convert the bulk numbers of an edit to and from the bytes of EditRecord::numbers.
std::string written_tips(Stroke const& stroke);
std::string written_lines(std::vector<SkeletonPiece> const& lines);
bool read_tips(std::string_view bytes, Stroke& stroke);
bool read_lines(std::string_view bytes, std::vector<SkeletonPiece>& lines);

// Shortens absolute paths to file names in those fields that name a plant's files: "model_name",
// "view_name" and, if `with_name`, "name". Returns true if there was an absolute path.
bool leave_out_folders(Json& fields, bool with_name);

// Converts an edit's fields to JSON, and its bulk numbers to bytes.
class FieldWriter final : public scene::Fields {
public:
    void field(char const* name, scene::FieldRef value) override;
    void sparse_field(char const* name, scene::FieldRef value) override;
    void word(char const* name, int& value, std::span<char const* const> words) override;
    void numbers(Stroke& stroke) override { numbers_ = written_tips(stroke); }
    void numbers(std::vector<SkeletonPiece>& lines) override { numbers_ = written_lines(lines); }
    void bytes(std::string& file) override { numbers_ = file; }

    void leave_out_folders(bool with_name)
    {
        static_cast<void>(session::leave_out_folders(json_, with_name));
    }

    std::string json() const { return json_.dump(); }
    std::string take_numbers() { return std::move(numbers_); }

private:
    Json json_ = Json::object();
    std::string numbers_;
};

// Reads the fields that a FieldWriter wrote. A field that is missing in the JSON keeps its value.
class FieldReader final : public scene::Fields {
public:
    // Keeps references to both arguments, which must outlive this object.
    FieldReader(Json const& json, std::string_view numbers)
        : json_(json)
        , numbers_(numbers)
    {
    }

    void field(char const* name, scene::FieldRef value) override;
    void word(char const* name, int& value, std::span<char const* const> words) override;
    void numbers(Stroke& stroke) override { take_numbers(read_tips(numbers_, stroke)); }
    void numbers(std::vector<SkeletonPiece>& lines) override
    {
        take_numbers(read_lines(numbers_, lines));
    }
    void bytes(std::string& file) override
    {
        file = numbers_;
        take_numbers(true);
    }

    // Fails if a field had the wrong form, or if the JSON has an unknown field. Call it after the
    // last field.
    Result<void> finish() const;

private:
    Json const* find(char const* name);
    void take_numbers(bool were_read);
    void complain_of(std::string const& name);

    Json const& json_;
    std::string_view numbers_;
    std::set<std::string> known_;
    std::string complaint_; // Message about the first field of the wrong form; empty: none.
};

} // namespace tractus::session
