#include "app/document/logged_step.h"

#include "app/session/edit_record.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fmt/core.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace tractus::document {

namespace {

using Json = nlohmann::ordered_json;

// Names of the steps in logs, indexed by LoggedStep::What.
constexpr std::array<std::string_view, 4> kNames { "step", "undo", "redo", "begin_again" };

std::string hex_of(std::string_view bytes)
{
    std::string digits;
    for (char const byte : bytes)
        fmt::format_to(std::back_inserter(digits), "{:02x}", static_cast<unsigned char>(byte));
    return digits;
}

std::optional<std::string> bytes_of(std::string_view digits)
{
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        std::uint8_t byte = 0;
        auto const* const end = digits.data() + std::min(i + 2, digits.size());
        auto const [read, error] = std::from_chars(digits.data() + i, end, byte, 16);
        if (error != std::errc() || read != end || end != digits.data() + i + 2)
            return std::nullopt;
        bytes += static_cast<char>(byte);
    }
    return bytes;
}

std::string print_edits(std::vector<scene::Edit> const& edits)
{
    auto list = Json::array();
    for (auto const& edit : edits) {
        auto const record = session::record_of(edit);
        list.push_back({ { "kind", record.kind },
                         { "fields", Json::parse(record.fields) },
                         { "numbers", hex_of(record.numbers) } });
    }
    return list.dump();
}

std::optional<std::vector<scene::Edit>> read_edits(std::string_view text, scene::EditKinds kinds)
{
    auto const list = Json::parse(text, nullptr, false);
    if (!list.is_array())
        return std::nullopt;
    std::vector<scene::Edit> edits;
    for (auto const& entry : list) {
        if (!entry.is_object() || !entry.contains("kind") || !entry["kind"].is_string()
            || !entry.contains("fields") || !entry.contains("numbers")
            || !entry["numbers"].is_string())
            return std::nullopt;
        auto numbers = bytes_of(entry["numbers"].get<std::string>());
        if (!numbers)
            return std::nullopt;
        edits.push_back(session::edit_or_unknown(
            { entry["kind"].get<std::string>(), entry["fields"].dump(), *std::move(numbers) },
            kinds));
    }
    return edits;
}

Result<LoggedStep> read_step(LoggedStep::What what, std::string_view arguments,
                             scene::EditKinds kinds)
{
    LoggedStep step { .what = what };
    auto const* const end = arguments.data() + arguments.size();
    auto const [read, error] = std::from_chars(arguments.data(), end, step.strokes_before);
    auto const rest = arguments.substr(static_cast<std::size_t>(read - arguments.data()));
    auto const refusal = [&] {
        return fail(Fault::User,
                    fmt::format("\"{} {}\" is not a step: a number of strokes is expected{}",
                                kNames[static_cast<std::size_t>(what)], arguments.substr(0, 40),
                                what == LoggedStep::What::Edits ? ", and edits as JSON" : ""));
    };
    if (error != std::errc())
        return refusal();
    if (what != LoggedStep::What::Edits)
        return rest.empty() ? Result<LoggedStep>(step) : refusal();
    auto edits = read_edits(rest, kinds);
    if (!edits)
        return refusal();
    step.edits = *std::move(edits);
    return step;
}

} // namespace

StepWords words_for(StepOutcome const& step, std::size_t strokes_before)
{
    StepWords words { std::string(kNames[static_cast<std::size_t>(step.what)]),
                      std::to_string(strokes_before) };
    if (step.what == LoggedStep::What::Edits)
        words.arguments += fmt::format(" {}", print_edits(step.edits));
    return words;
}

std::optional<Result<LoggedStep>> parse_step(std::string_view name, std::string_view arguments,
                                             scene::EditKinds kinds)
{
    auto const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end())
        return std::nullopt;
    return read_step(static_cast<LoggedStep::What>(found - kNames.begin()), arguments, kinds);
}

} // namespace tractus::document
