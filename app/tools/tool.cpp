#include "app/tools/tool.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace tractus::tools {

namespace {

constexpr std::string_view kNow = "now";
constexpr std::string_view kView = "view=";
constexpr std::string_view kBent = "bent";

struct NoOptions { };

Result<std::vector<scene::Edit>> refuse(Tool const&, Stroke const&, scene::Scene const&)
{
    return fail(Fault::User, "this tractus does not know the tool that the stroke was for");
}

constexpr ToolKind kNoTool { .word = "",
                             .label = "",
                             .title = "A tool that this tractus does not know",
                             .done = "",
                             .help = "",
                             .group = "",
                             .options = options_type<NoOptions>(),
                             .edits_for = refuse };

// Collects all options as numbers, for comparisons.
class ValueReader final : public OptionVisitor {
public:
    void word(WordOption const&, int& value) override { values.push_back(value); }
    void number(NumberOption const&, double& value) override { values.push_back(value); }

    std::vector<double> values;
};

std::vector<double> values_of(Tool const& tool)
{
    ValueReader reader;
    tool.show(reader);
    return std::move(reader.values);
}

class OptionReader final : public OptionVisitor {
public:
    void word(WordOption const& option, int& value) override { words.push_back({ option, value }); }
    void number(NumberOption const& option, double& value) override
    {
        numbers.push_back({ option, value });
    }

    std::vector<WordSetting> words;
    std::vector<NumberSetting> numbers;
};

class NumberSetter final : public OptionVisitor {
public:
    NumberSetter(std::size_t option, double value)
        : option_(option)
        , value_(value)
    {
    }

    void word(WordOption const&, int&) override { }
    void number(NumberOption const&, double& value) override
    {
        if (number_++ == option_)
            value = value_;
    }

private:
    std::size_t option_;
    double value_;
    std::size_t number_ = 0;
};

class WordSetter final : public OptionVisitor {
public:
    WordSetter(std::size_t option, int value)
        : option_(option)
        , value_(value)
    {
    }

    void word(WordOption const& option, int& value) override
    {
        if (number_++ != option_)
            return;
        value = value_;
        goes_with_ = option.goes_with;
    }
    void number(NumberOption const&, double&) override { }

    // Side effect of the option that was set; null if it has none.
    auto goes_with() const { return goes_with_; }

private:
    std::size_t option_;
    int value_;
    std::size_t number_ = 0;
    void (*goes_with_)(void* options) = nullptr;
};

// Sets every option to its default in logs, which is the first word of a word option.
class LogDefaults final : public OptionVisitor {
public:
    void word(WordOption const&, int& value) override { value = 0; }
    void number(NumberOption const& option, double& value) override
    {
        value = option.in_logs.value_or(value);
    }
};

// Finds the option to which a word of a log refers, and sets it.
class ArgumentReader final : public OptionVisitor {
public:
    explicit ArgumentReader(std::string_view argument)
        : argument_(argument)
    {
    }

    void word(WordOption const& option, int& value) override
    {
        for (std::size_t i = 0; i < option.words.size(); ++i) {
            known_.emplace_back(option.words[i].word);
            if (argument_ == option.words[i].word) {
                value = static_cast<int>(i);
                is_taken_ = true;
            }
        }
    }

    void number(NumberOption const& option, double& value) override
    {
        auto const start = fmt::format("{}=", option.name);
        known_.push_back(fmt::format("{} with a number from {:g} to {:g}{}{}", start, option.least,
                                     option.greatest, *option.unit ? " " : "", option.unit));
        if (!argument_.starts_with(start))
            return;
        auto const read = read_number(option, argument_.substr(start.size()));
        if (!read)
            return;
        value = *read;
        is_taken_ = true;
    }

    bool is_taken() const { return is_taken_; }
    std::vector<std::string> const& known() const { return known_; }

private:
    std::string_view argument_;
    bool is_taken_ = false;
    std::vector<std::string> known_;
};

// Writes the words by which a log gives all options that differ from their defaults in logs.
class ArgumentWriter final : public OptionVisitor {
public:
    explicit ArgumentWriter(std::vector<double> plain)
        : plain_(std::move(plain))
    {
    }

    void word(WordOption const& option, int& value) override
    {
        if (value != plain_[number_++])
            add(option.words[static_cast<std::size_t>(value)].word);
    }
    void number(NumberOption const& option, double& value) override
    {
        if (value != plain_[number_++])
            add(fmt::format("{}={}", option.name, value));
    }
    void add(std::string_view argument)
    {
        arguments_ += fmt::format("{}{}", arguments_.empty() ? "" : " ", argument);
    }

    std::string take() { return std::move(arguments_); }

private:
    std::vector<double> plain_;
    std::size_t number_ = 0;
    std::string arguments_;
};

std::string view_word(scene::SelectionAngle const& angle)
{
    return fmt::format("{}{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", kView,
                       angle.azimuth_deg, angle.elevation_deg, angle.zoom, angle.moved_mm.x(),
                       angle.moved_mm.y(), angle.area_mm.x(), angle.area_mm.y());
}

Result<scene::SelectionAngle> parse_view(std::string_view word)
{
    std::array<double, 7> numbers {};
    auto rest = word.substr(kView.size());
    bool is_whole = true;
    for (auto& number : numbers) {
        auto const end = std::min(rest.find(','), rest.size());
        auto const parsed = std::from_chars(rest.data(), rest.data() + end, number);
        is_whole = is_whole && parsed.ec == std::errc() && parsed.ptr == rest.data() + end
            && std::isfinite(number);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    auto const [azimuth, elevation, zoom, x, y, width, depth] = numbers;
    if (!is_whole || !rest.empty() || std::abs(elevation) >= 90 || zoom <= 0 || width <= 0
        || depth <= 0)
        return fail(Fault::User,
                    fmt::format("\"{}\" is no view: give azimuth, elevation below 90, zoom, x, y, "
                                "width and depth, for example view=0,0,1,0,0,254,159",
                                word));
    return scene::SelectionAngle { azimuth, elevation, zoom, { x, y }, { width, depth } };
}

// Joins words as "a, b or c".
std::string list_words(std::vector<std::string> const& words)
{
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += fmt::format("{}{}", i == 0 ? "" : i + 1 < words.size() ? ", " : " or ", words[i]);
    return list;
}

Result<void> take_argument(Tool& tool, bool& is_now, std::string_view word)
{
    if (word == kNow) {
        is_now = true;
        return {};
    }
    if (tool.kind().surface == Surface::Skeleton && word.starts_with(kView)) {
        auto angle = TRY(parse_view(word));
        angle.shape = tool.angle().shape;
        tool = tool.seen_from(angle);
        return {};
    }
    if (tool.kind().surface == Surface::Skeleton && word == kBent) {
        auto angle = tool.angle();
        angle.shape = scene::SelectionAngle::Shape::AsBent;
        tool = tool.seen_from(angle);
        return {};
    }
    ArgumentReader reader(word);
    auto const changed = tool.changed_by(reader);
    if (reader.is_taken()) {
        tool = changed;
        return {};
    }
    return fail(
        Fault::User,
        reader.known().empty()
            ? fmt::format("the tool {} takes no \"{}\": leave it out", tool.kind().word, word)
            : fmt::format("the tool {} does not know \"{}\": it knows {}", tool.kind().word, word,
                          list_words(reader.known())));
}

} // namespace

Tool::Tool()
    : Tool(kNoTool)
{
}

Tool::Tool(ToolKind const& kind)
    : Tool(kind, kind.options.make())
{
}

Tool Tool::changed_by(OptionVisitor& visitor) const
{
    auto const options = kind_->options.copy(options_.get());
    kind_->options.visit(visitor, options.get());
    auto changed = *this;
    changed.options_ = options;
    return changed;
}

Gizmo Tool::gizmo() const
{
    return kind_->gizmo->show(options_.get());
}

Tool Tool::dragged(std::size_t handle, Vec2 const& to) const
{
    auto const options = kind_->options.copy(options_.get());
    kind_->gizmo->drag(options.get(), handle, to);
    auto changed = *this;
    changed.options_ = options;
    return changed;
}

Tool Tool::changed_by(void (*change)(void* options)) const
{
    auto const options = kind_->options.copy(options_.get());
    change(options.get());
    auto changed = *this;
    changed.options_ = options;
    return changed;
}

bool Tool::needs_no_stroke() const
{
    auto const words = word_settings(*this);
    return kind_->at_once || std::any_of(words.begin(), words.end(), [](WordSetting const& chosen) {
               return chosen.option.words[static_cast<std::size_t>(chosen.value)].at_once;
           });
}

Tool Tool::done_at_once() const
{
    auto changed = *this;
    changed.at_once_ = true;
    return changed;
}

Tool Tool::seen_from(scene::SelectionAngle const& angle) const
{
    auto changed = *this;
    changed.angle_ = angle;
    return changed;
}

std::string Tool::title() const
{
    char const* title = kind_->title;
    for (auto const& [option, value] : word_settings(*this))
        if (auto const* const own = option.words[static_cast<std::size_t>(value)].title)
            title = own;
    return title;
}

bool Tool::operator==(Tool const& other) const
{
    return kind_ == other.kind_ && at_once_ == other.at_once_ && angle_ == other.angle_
        && (options_ == other.options_ || values_of(*this) == values_of(other));
}

std::vector<WordSetting> word_settings(Tool const& tool)
{
    OptionReader reader;
    tool.show(reader);
    return std::move(reader.words);
}

std::vector<NumberSetting> number_settings(Tool const& tool)
{
    OptionReader reader;
    tool.show(reader);
    return std::move(reader.numbers);
}

Tool with_number(Tool const& tool, std::size_t option, double value)
{
    NumberSetter setter(option, value);
    return tool.changed_by(setter);
}

std::optional<double> read_number(NumberOption const& option, std::string_view text)
{
    double number = 0;
    auto const* const last = text.data() + text.size();
    auto const [end, error] = std::from_chars(text.data(), last, number);
    bool const is_taken = error == std::errc() && end == last && number >= option.least
        && number <= option.greatest;
    return is_taken ? std::optional(number) : std::nullopt;
}

Tool with_word(Tool const& tool, std::size_t option, int value)
{
    WordSetter setter(option, value);
    auto const chosen = tool.changed_by(setter);
    return setter.goes_with() ? chosen.changed_by(setter.goes_with()) : chosen;
}

ToolKind const* find_tool_kind(ToolKinds kinds, std::string_view word)
{
    auto const found = std::find_if(kinds.begin(), kinds.end(), [&](ToolKind const* kind) {
        return std::string_view(kind->word) == word;
    });
    return found == kinds.end() ? nullptr : *found;
}

// Tool(kind) may differ from this tool if the kind has options that older logs lack.
Tool default_tool_of_kind(ToolKind const& kind)
{
    LogDefaults defaults;
    return Tool(kind).changed_by(defaults);
}

std::string words_of_selected_tool(ToolKinds kinds, std::string_view name,
                                   std::string_view arguments)
{
    std::string words(arguments);
    auto const* const kind = find_tool_kind(kinds, name);
    if (!kind)
        return words;
    auto const is_named = [&](OptionWord const& word) {
        return fmt::format(" {} ", arguments).find(fmt::format(" {} ", word.word))
            != std::string::npos;
    };
    for (auto const& [option, value] : word_settings(Tool(*kind)))
        if (option.offered == WordOption::Offered::Never
            && std::none_of(option.words.begin(), option.words.end(), is_named))
            words += fmt::format("{}{}", words.empty() ? "" : " ",
                                 option.words[static_cast<std::size_t>(value)].word);
    return words;
}

Result<Tool> parse_tool(ToolKinds kinds, std::string_view name, std::string_view arguments)
{
    auto const* const kind = find_tool_kind(kinds, name);
    if (!kind) {
        std::vector<std::string> words;
        for (auto const* const known : kinds)
            words.emplace_back(known->word);
        return fail(Fault::User,
                    fmt::format("there is no tool \"{}\": there are {}", name, list_words(words)));
    }
    auto tool = default_tool_of_kind(*kind);
    bool is_now = false;
    while (!arguments.empty()) {
        auto const word = arguments.substr(0, arguments.find(' '));
        arguments.remove_prefix(std::min(word.size() + 1, arguments.size()));
        if (!word.empty())
            TRY(take_argument(tool, is_now, word));
    }
    if (is_now && !tool.needs_no_stroke())
        return fail(Fault::User,
                    fmt::format("the tool {} needs a stroke: leave out \"{}\"", name, kNow));
    return is_now ? tool.done_at_once() : tool;
}

ToolWords words_for(Tool const& tool)
{
    ArgumentWriter writer(values_of(default_tool_of_kind(tool.kind())));
    tool.show(writer);
    if (tool.kind().surface == Surface::Skeleton) {
        auto angle = tool.angle();
        bool const is_bent = angle.shape == scene::SelectionAngle::Shape::AsBent;
        angle.shape = scene::SelectionAngle::Shape::AtRest;
        if (angle != scene::SelectionAngle {})
            writer.add(view_word(angle));
        if (is_bent)
            writer.add(std::string(kBent));
    }
    if (tool.is_done_at_once())
        writer.add(kNow);
    return { tool.kind().word, writer.take() };
}

} // namespace tractus::tools
