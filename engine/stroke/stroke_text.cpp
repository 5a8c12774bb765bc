#include "engine/stroke/stroke_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace tractus {

namespace {

class StrokeText {
public:
    explicit StrokeText(std::string const& name)
        : name_(name)
    {
    }

    Result<void> read(std::string_view line)
    {
        ++line_;
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(kBlanks) == std::string_view::npos) {
            end_stroke();
            return {};
        }
        if (line[line.find_first_not_of(kBlanks)] == 'S') {
            end_stroke();
            is_sketch_ = true;
            return {};
        }
        return read_tip(line);
    }

    Result<std::vector<Stroke>> take()
    {
        end_stroke();
        if (strokes_.empty())
            return fail(Fault::User,
                        fmt::format("{}: there is no stroke of two points in it: give a line "
                                    "\"x y z\" for each",
                                    name_));
        return std::move(strokes_);
    }

private:
    static constexpr std::string_view kBlanks = " \t\r,;";

    Result<void> read_tip(std::string_view line)
    {
        std::vector<double> numbers;
        for (auto begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;
             begin = line.find_first_not_of(kBlanks)) {
            line.remove_prefix(begin);
            auto const word = line.substr(0, line.find_first_of(kBlanks));
            line.remove_prefix(word.size());
            double value = 0;
            auto const [end, error]
                = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error != std::errc {} || end != word.data() + word.size() || !std::isfinite(value))
                return fail(Fault::User,
                            fmt::format("{}:{}: \"{}\" is not a number", name_, line_, word));
            numbers.push_back(value);
        }
        if (numbers.size() < 3 || numbers.size() > 5)
            return fail(Fault::User,
                        fmt::format("{}:{}: {} numbers do not make a point: give x y z, and if you "
                                    "like pressure and milliseconds",
                                    name_, line_, numbers.size()));
        add_tip(numbers);
        return {};
    }

    void add_tip(std::vector<double> const& numbers)
    {
        Vec3 const read(numbers[0], numbers[1], numbers[2]);
        TipSample tip { .pressure = 1, .touching = true };
        tip.position_mm = is_sketch_ ? Vec3(100 * Vec3(read.x(), read.z(), read.y())) : read;
        if (numbers.size() > 3)
            tip.pressure = std::clamp(numbers[3], 0.0, 1.0);
        auto const count = static_cast<std::int64_t>(stroke_.tips.size());
        constexpr double kMaxMilliseconds = 1e12;
        double const time_ms = numbers.size() > 4
            ? std::clamp(numbers[4], -kMaxMilliseconds, kMaxMilliseconds)
            : 10.0 * static_cast<double>(count);
        tip.time = timestamp_ns(static_cast<std::int64_t>(time_ms * 1e6));
        stroke_.tips.push_back(tip);
    }

    void end_stroke()
    {
        auto stroke = std::exchange(stroke_, {});
        bool const has_shape
            = std::any_of(stroke.tips.begin(), stroke.tips.end(), [&](TipSample const& tip) {
                  return tip.position_mm != stroke.tips.front().position_mm;
              });
        if (has_shape)
            strokes_.push_back(std::move(stroke));
    }

    std::string const& name_;
    std::size_t line_ = 0;
    bool is_sketch_ = false;
    Stroke stroke_;
    std::vector<Stroke> strokes_;
};

} // namespace

Result<std::vector<Stroke>> parse_strokes(std::string const& name, std::string_view text)
{
    StrokeText strokes(name);
    while (!text.empty()) {
        auto const end = std::min(text.find('\n'), text.size());
        TRY(strokes.read(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return strokes.take();
}

std::string print_strokes(std::span<Stroke const> strokes)
{
    std::string text = "# x y z in mm, pressure, time in ms\n";
    for (auto const& stroke : strokes) {
        for (auto const& tip : stroke.tips)
            fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", tip.position_mm.x(),
                           tip.position_mm.y(), tip.position_mm.z(), tip.pressure,
                           1e3 * to_seconds(tip.time));
        text += "\n";
    }
    return text;
}

} // namespace tractus
