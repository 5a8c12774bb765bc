#include "app/diagnosis/finding.h"

#include <algorithm>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace tractus::diagnosis {

std::string_view name_of(FindingKind kind)
{
    switch (kind) {
    case FindingKind::Fine:
        return "fine";
    case FindingKind::NoTablet:
        return "no-tablet";
    case FindingKind::NotPermitted:
        return "not-permitted";
    case FindingKind::NoDriver:
        return "no-driver";
    case FindingKind::DriverInTheWay:
        return "driver-in-the-way";
    case FindingKind::MouseMode:
        return "mouse-mode";
    case FindingKind::UnknownTablet:
        return "unknown-tablet";
    case FindingKind::BrokenReports:
        return "broken-reports";
    case FindingKind::PenNeverLifts:
        return "pen-never-lifts";
    case FindingKind::SentTwice:
        return "sent-twice";
    case FindingKind::Silent:
        return "silent";
    case FindingKind::HeightFault:
        return "height-fault";
    case FindingKind::ClockJump:
        return "clock-jump";
    case FindingKind::OldLibrary:
        return "old-library";
    }
    return "fine";
}

bool has_trouble(std::span<Finding const> findings)
{
    return std::ranges::any_of(
        findings, [](Finding const& finding) { return finding.kind != FindingKind::Fine; });
}

std::string print_findings(std::span<Finding const> findings)
{
    std::string text;
    for (auto const& finding : findings) {
        text += fmt::format("{} {}\n    {}\n",
                            finding.kind == FindingKind::Fine ? "ok:     " : "problem:",
                            finding.subject, finding.what);
        for (auto const& line : finding.remedy)
            text += fmt::format("      {}\n", line);
    }
    return text;
}

std::string print_findings_json(std::span<Finding const> findings)
{
    auto list = nlohmann::json::array();
    for (auto const& finding : findings)
        list.push_back({ { "kind", name_of(finding.kind) },
                         { "subject", finding.subject },
                         { "what", finding.what },
                         { "remedy", finding.remedy } });
    // Device names can contain any bytes; invalid UTF-8 is replaced.
    return list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace tractus::diagnosis
