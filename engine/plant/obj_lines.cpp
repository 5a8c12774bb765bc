#include "engine/plant/skeleton_lines.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace tractus {

namespace {

// A file whose coordinates extend over less than this is assumed to be in metres.
constexpr double kLargestInMetres = 100;

// Iterates over the words of a line.
class Words {
public:
    explicit Words(std::string_view text)
        : text_(text)
    {
    }

    std::string_view next()
    {
        constexpr std::string_view kBlanks = " \t\r";
        auto const begin = text_.find_first_not_of(kBlanks);
        if (begin == std::string_view::npos)
            return {};
        text_.remove_prefix(begin);
        auto const word = text_.substr(0, text_.find_first_of(kBlanks));
        text_.remove_prefix(word.size());
        return word;
    }

private:
    std::string_view text_;
};

template<typename T> std::optional<T> number(std::string_view word)
{
    T value {};
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc {} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

class ObjLines {
public:
    explicit ObjLines(std::string const& name)
        : name_(name)
    {
    }

    Result<void> read(std::string_view line)
    {
        ++line_;
        Words words(line);
        auto const kind = words.next();
        if (kind == "v")
            return read_vertex(words);
        if (kind == "l")
            return read_line(words);
        return {};
    }

    Result<std::vector<SkeletonPiece>> take()
    {
        if (lines_.empty())
            return fail(Fault::User,
                        fmt::format("{}: there are no lines (\"l\" elements) in it: export the "
                                    "skeleton as edges, not as faces",
                                    name_));
        Bounds box;
        for (auto const& line : lines_) {
            box.add(line.from_mm);
            box.add(line.to_mm);
        }
        if ((box.max_mm - box.min_mm).maxCoeff() < kLargestInMetres)
            for (auto& line : lines_) {
                line.from_mm *= 1000;
                line.to_mm *= 1000;
            }
        return std::move(lines_);
    }

private:
    Result<void> read_vertex(Words& words)
    {
        Vec3 read;
        for (auto& coordinate : read) {
            auto const word = words.next();
            auto const value = number<double>(word);
            if (!value)
                return fail(Fault::User,
                            fmt::format("{}:{}: \"{}\" is not a coordinate", name_, line_, word));
            coordinate = *value;
        }
        // OBJ files have y up, plants have z up.
        vertices_.push_back({ read.x(), -read.z(), read.y() });
        return {};
    }

    Result<void> read_line(Words& words)
    {
        std::optional<Vec3> before;
        for (auto word = words.next(); !word.empty(); word = words.next()) {
            auto const index = number<long>(word.substr(0, word.find('/')));
            auto const count = static_cast<long>(vertices_.size());
            auto const place = index && *index < 0 ? count + *index : index.value_or(0) - 1;
            if (place < 0 || place >= count)
                return fail(Fault::User,
                            fmt::format("{}:{}: \"{}\" is not one of the {} vertices so far", name_,
                                        line_, word, count));
            auto const& vertex = vertices_[static_cast<std::size_t>(place)];
            if (before)
                lines_.push_back({ *before, vertex });
            before = vertex;
        }
        return {};
    }

    std::string const& name_;
    std::size_t line_ = 0;
    std::vector<Vec3> vertices_;
    std::vector<SkeletonPiece> lines_;
};

} // namespace

Result<std::vector<SkeletonPiece>> parse_obj_lines(std::string const& name, std::string_view text)
{
    ObjLines lines(name);
    while (!text.empty()) {
        auto const end = std::min(text.find('\n'), text.size());
        TRY(lines.read(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines.take();
}

} // namespace tractus
