#include "drivers/tablets/tablet_lookup.h"

#include "drivers/reports/report_descriptor.h"
#include "drivers/tablets/tablet_parameters.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <limits>
#include <map>
#include <mutex>
#include <regex>
#include <set>
#include <tuple>

namespace tractus::drivers {

namespace {

struct Candidate {
    Tablet const* tablet = nullptr;
    TabletIdentifier const* identifier = nullptr;
    std::size_t conditions_held = 0;
    bool is_refuted = false; // True if one of the tablet's strings contradicts the candidate.

    // Returns the properties that decoding depends on: candidates with equal shapes are
    // interchangeable.
    auto shape() const
    {
        return std::tuple(tablet->size_mm.x(), tablet->size_mm.y(), tablet->x_maximum,
                          tablet->y_maximum, tablet->pressure_maximum,
                          std::string_view(identifier->family));
    }
};
using Candidates = std::vector<Candidate>;

// Returns the compiled pattern. Each is compiled once, since that takes longer than the search.
std::regex const& compiled(std::string const& pattern)
{
    static std::mutex mutex;
    static std::map<std::string, std::regex> patterns;
    std::lock_guard const lock(mutex);
    return patterns.try_emplace(pattern, pattern).first->second;
}

// Texts that no USB string descriptor can contain match nothing: a log may hold a text of any
// length, and std::regex needs stack in proportion to it.
bool matches(std::string const& text, std::string const& pattern)
{
    constexpr std::size_t kMaxUnits = 126; // UTF-16 units in a descriptor (USB 2.0, section 9.6.7).
    constexpr std::size_t kMaxBytes = 3 * kMaxUnits; // A unit has at most three bytes in UTF-8.
    return text.size() <= kMaxBytes && std::regex_search(text, compiled(pattern));
}

// Compares a device with a row of the table. No value if the ids or the interface number differ.
std::optional<Candidate> weigh(Tablet const& tablet, TabletIdentifier const& identifier,
                               DeviceInfo const& info)
{
    if (identifier.vendor_id != info.vendor_id
        || (identifier.product_id != info.product_id && !identifier.is_any_product))
        return std::nullopt;
    if (identifier.interface_number && info.interface_number >= 0
        && *identifier.interface_number != info.interface_number)
        return std::nullopt;
    Candidate candidate { &tablet, &identifier };
    for (auto const& condition : identifier.conditions) {
        auto const text = info.strings.find(condition.index);
        if (text == info.strings.end())
            continue;
        if (matches(text->second, condition.pattern))
            ++candidate.conditions_held;
        else
            candidate.is_refuted = true;
    }
    return candidate;
}

// Keeps only the candidates for which `is_better` holds, if there are any.
template<typename Predicate> void prefer(Candidates& candidates, Predicate is_better)
{
    if (std::any_of(candidates.begin(), candidates.end(), is_better))
        std::erase_if(candidates, [&](auto const& candidate) { return !is_better(candidate); });
}

void prefer_most_conditions(Candidates& candidates)
{
    std::size_t most = 0;
    for (auto const& candidate : candidates)
        most = std::max(most, candidate.conditions_held);
    prefer(candidates, [&](auto const& candidate) { return candidate.conditions_held == most; });
}

void prefer_reported_maxima(Candidates& candidates, DeviceInfo const& info)
{
    for (auto const& [index, text] : info.strings)
        if (auto const told = parse_parameters(index, text))
            prefer(candidates, [&](auto const& candidate) {
                return candidate.tablet->x_maximum == told->x_maximum
                    && candidate.tablet->y_maximum == told->y_maximum;
            });
}

// Returns the length of the longest report, counted as in TabletIdentifier; no value if there is no
// such report.
std::optional<std::size_t> longest_report(HidReportDescriptor const& descriptor, HidReportKind kind)
{
    std::optional<std::size_t> longest;
    for (auto const& report : descriptor.reports)
        if (report.kind == kind)
            longest
                = std::max(longest.value_or(0), report.bytes + (report.report_id == 0 ? 1u : 0u));
    return longest;
}

struct LongestReports {
    std::optional<std::size_t> input;
    std::optional<std::size_t> output;
};

LongestReports longest_reports(DeviceInfo const& info)
{
    auto const descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return {};
    return { longest_report(*descriptor, HidReportKind::Input),
             longest_report(*descriptor, HidReportKind::Output) };
}

// Separates pads from pens: an interface is a tablet's pad if, and only if, its reports have the
// pad's lengths.
void tell_pads_from_pens(Candidates& candidates, LongestReports const& longest)
{
    auto const is_pad
        = [](auto const& candidate) { return candidate.identifier->family == kPadFamily; };
    std::erase_if(candidates, [&](auto const& candidate) {
        auto const& [input_size, output_size]
            = std::tie(candidate.identifier->input_size, candidate.identifier->output_size);
        bool const fits = input_size == longest.input
            && (!output_size || *output_size == longest.output.value_or(0));
        return is_pad(candidate) && !fits;
    });
    prefer(candidates, is_pad);
}

// Removes table rows for unknown products if the length of their reports differs from the device's.
void tell_unknown_products(Candidates& candidates, LongestReports const& longest)
{
    std::erase_if(candidates, [&](auto const& candidate) {
        auto const& identifier = *candidate.identifier;
        return identifier.is_any_product && identifier.input_size != longest.input;
    });
    prefer(candidates, [](auto const& candidate) { return !candidate.identifier->is_any_product; });
}

void prefer_report_sizes(Candidates& candidates, LongestReports const& longest)
{
    prefer(candidates, [&](auto const& candidate) {
        return longest.input && candidate.identifier->input_size == longest.input;
    });
    prefer(candidates, [&](auto const& candidate) {
        return longest.output && candidate.identifier->output_size == longest.output;
    });
}

std::string lower_case(std::string_view text)
{
    std::string result(text);
    for (auto& c : result)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

// Returns the name without its maker: "HS610".
std::string model_of(Tablet const& tablet)
{
    auto const blank = tablet.name.find(' ');
    return lower_case(
        std::string_view(tablet.name).substr(blank == std::string::npos ? 0 : blank + 1));
}

void prefer_own_name(Candidates& candidates, DeviceInfo const& info)
{
    auto const name = lower_case(info.name);
    std::size_t longest = 0;
    for (auto const& candidate : candidates)
        if (auto const model = model_of(*candidate.tablet); name.find(model) != std::string::npos)
            longest = std::max(longest, model.size());
    prefer(candidates, [&](auto const& candidate) {
        auto const model = model_of(*candidate.tablet);
        return model.size() == longest && name.find(model) != std::string::npos;
    });
}

std::optional<double> common_proportions(Candidates const& candidates)
{
    constexpr double kAgree = 0.02; // Tolerance, because makers round the sizes that they publish.
    double least = std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (auto const& candidate : candidates) {
        auto const& size_mm = candidate.tablet->size_mm;
        least = std::min(least, size_mm.x() / size_mm.y());
        greatest = std::max(greatest, size_mm.x() / size_mm.y());
    }
    return greatest - least <= kAgree * greatest ? std::optional((least + greatest) / 2)
                                                 : std::nullopt;
}

TabletMatch choose(Candidates const& candidates)
{
    std::map<decltype(candidates.front().shape()), std::size_t> votes;
    for (auto const& candidate : candidates)
        ++votes[candidate.shape()];
    auto const chosen
        = std::max_element(candidates.begin(), candidates.end(), [&](auto const& a, auto const& b) {
              return votes[a.shape()] < votes[b.shape()];
          });
    std::set<std::string_view> others;
    for (auto const& candidate : candidates)
        if (candidate.shape() != chosen->shape() && candidate.tablet != chosen->tablet)
            others.insert(candidate.tablet->name);
    std::size_t const least = chosen->is_refuted ? 1 : 0;
    return { chosen->tablet, chosen->identifier, std::max(others.size(), least),
             common_proportions(candidates) };
}

} // namespace

std::optional<TabletMatch> find_tablet(std::span<Tablet const> tablets, DeviceInfo const& info)
{
    Candidates candidates;
    for (auto const& tablet : tablets)
        for (auto const& identifier : tablet.identifiers)
            if (auto const candidate = weigh(tablet, identifier, info))
                candidates.push_back(*candidate);
    auto const longest = longest_reports(info);
    tell_unknown_products(candidates, longest);
    tell_pads_from_pens(candidates, longest);
    if (candidates.empty())
        return std::nullopt;
    prefer(candidates, [](auto const& candidate) { return !candidate.is_refuted; });
    prefer_most_conditions(candidates);
    prefer_reported_maxima(candidates, info);
    prefer_own_name(candidates, info);
    prefer_report_sizes(candidates, longest);
    return choose(candidates);
}

std::optional<TabletMatch> find_tablet(DeviceInfo const& info)
{
    return find_tablet(known_tablets(), info);
}

std::string tablet_name(TabletMatch const& match)
{
    if (match.alternatives == 0)
        return match.tablet->name;
    if (match.alternatives == 1)
        return match.tablet->name + " (or another one with its ids)";
    return fmt::format("{} (or one of {} others with its ids)", match.tablet->name,
                       match.alternatives);
}

std::vector<int> identifying_strings(std::uint16_t vendor_id, std::uint16_t product_id)
{
    std::set<int> indices;
    for (auto const& tablet : known_tablets())
        for (auto const& identifier : tablet.identifiers)
            if (identifier.vendor_id == vendor_id && identifier.product_id == product_id)
                for (auto const& condition : identifier.conditions)
                    indices.insert(condition.index);
    return { indices.begin(), indices.end() };
}

} // namespace tractus::drivers
