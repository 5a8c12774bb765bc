#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <vector>

namespace tractus::calib {

// Numbers that a key accepts; infinities and NaN are never accepted.
enum class NumberRange {
    Any,
    Positive,    // Greater than 0.
    NotNegative, // 0 or more.
};

// One table of a hand-written TOML file, read key by key. All errors are user errors and name the
// file, the line, the key, what was found and what was expected:
//
//   my.rig.toml:7: height.mm_per_count is -0.1, expected a number greater than 0
//
// Reading a key marks it as known; refuse_unknown_keys() then finds misspelt ones.
class TomlTable {
public:
    // `name` identifies the file in errors.
    static Result<TomlTable> parse(std::string_view text, std::string name);

    // Fails unless the file's `version` is 1 to `newest`.
    Result<void> require_version(std::int64_t newest);

    bool has(std::string_view key);

    Result<double> number(std::string_view key, NumberRange range = NumberRange::Any);
    Result<double> number_or(std::string_view key, double fallback,
                             NumberRange range = NumberRange::Any);
    Result<std::int64_t> integer(std::string_view key, NumberRange range = NumberRange::Any);
    Result<std::string> text(std::string_view key);

    // Returns the index in `words` of the key's text.
    Result<std::size_t> word(std::string_view key, std::vector<std::string_view> const& words);

    // Returns an array of exactly two or three numbers.
    Result<Vec2> vec2(std::string_view key, NumberRange range = NumberRange::Any);
    Result<Vec2> vec2_or(std::string_view key, Vec2 const& fallback);
    Result<Vec3> vec3(std::string_view key);

    // Returns an array of any number of numbers.
    Result<std::vector<double>> number_list(std::string_view key);

    // Returns an array of arrays of two, or of three, numbers.
    Result<std::vector<Vec2>> vec2_list(std::string_view key);
    Result<std::vector<Vec3>> vec3_list(std::string_view key);

    Result<TomlTable> table(std::string_view key);

    // Returns the tables [[key]] in their order; at least one. Error messages number them from 1,
    // as in gesture[1].
    Result<std::vector<TomlTable>> tables(std::string_view key);

    // Fails for the first key that was never read.
    Result<void> refuse_unknown_keys() const;

    // Returns the error for a value that the caller rejects: "FILE:LINE: KEY " and `problem`.
    tl::unexpected<Error> wrong(std::string_view key, std::string_view problem) const;

    // Returns "FILE:LINE: TABLE", for errors that are found after parsing.
    std::string place() const;

private:
    struct Document {
        std::string name;
        toml::table root;
    };

    TomlTable(std::shared_ptr<Document const> document, toml::table const& table, std::string path)
        : document_(std::move(document))
        , table_(&table)
        , path_(std::move(path))
    {
    }

    Result<toml::node const*> find(std::string_view key, std::string_view expected);
    std::string path_of(std::string_view key) const;
    Result<std::vector<double>> numbers(std::string_view key, std::size_t count, NumberRange range);
    Result<std::vector<std::vector<double>>> points(std::string_view key, std::size_t dimensions);

    // Shared by all tables of a file, which point into it.
    std::shared_ptr<Document const> document_;
    toml::table const* table_ = nullptr;
    std::string path_; // Path of the table: "height", "gesture[2]"; empty for the whole file.
    std::set<std::string, std::less<>> known_;
};

} // namespace tractus::calib
