#include "app/methods/sketch_lsystem/commands/twig_file.h"

#include "engine/base/file.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tractus::sketch {

namespace {

using nlohmann::json;

Result<std::vector<Vec3>> read_line(json const& value, std::string const& name)
{
    auto const bad = [&] {
        return fail(Fault::User,
                    fmt::format("{} is no line: write [[x, y], [x, y]] in millimetres", name));
    };
    if (!value.is_array())
        return bad();
    std::vector<Vec3> points;
    for (auto const& point : value) {
        bool const is_point = point.is_array() && (point.size() == 2 || point.size() == 3)
            && std::all_of(point.begin(), point.end(),
                           [](json const& part) { return part.is_number(); });
        if (!is_point)
            return bad();
        auto const at = [&](std::size_t i) { return point[i].get<double>(); };
        points.push_back(point.size() == 3 ? Vec3(at(0), at(1), at(2)) : Vec3(at(0), 0, at(1)));
    }
    return points;
}

Result<DrawnTwig> read_twig(json const& file)
{
    if (!file.is_object() || !file.contains("axis") || !file.contains("laterals"))
        return fail(Fault::User,
                    "it is no twig: write {\"axis\": [[x, y], …], \"laterals\": [[[x, y], …], …]}");
    DrawnTwig twig { .axis_mm = TRY(read_line(file["axis"], "axis")), .laterals_mm = {} };
    if (!file["laterals"].is_array())
        return fail(Fault::User, "laterals is no list of lines: write [[[x, y], [x, y]]]");
    for (auto const& lateral : file["laterals"]) {
        if (twig.laterals_mm.size() >= kMaxTwigLaterals)
            return fail(Fault::User,
                        fmt::format("it has more than {} laterals: leave the others out",
                                    kMaxTwigLaterals));
        twig.laterals_mm.push_back(
            TRY(read_line(lateral, fmt::format("lateral {}", twig.laterals_mm.size() + 1))));
    }
    return twig;
}

} // namespace

Result<DrawnTwig> load_twig(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxBytes = std::size_t { 4 } << 20;
    auto const text = TRY(read_text_file(path, kMaxBytes));
    auto const file = json::parse(text, nullptr, false);
    if (file.is_discarded())
        return fail(
            Fault::User,
            fmt::format("{}: this is no JSON: a bracket, comma or quotation mark is missing "
                        "or too many",
                        path.string()));
    auto twig = read_twig(file);
    if (!twig)
        return fail(twig.error().fault, fmt::format("{}: {}", path.string(), twig.error().message));
    return twig;
}

std::string print_rule_file(Rule const& rule)
{
    return fmt::format("k = {}\nl = {:.6g}\nr = {:.6g}\na = {:.6g}\ns = {:.6g}\nT = {:.6g}\nt = "
                       "{:.6g}\nl_min = {:.6g}\n",
                       rule.laterals, rule.first_length_mm, rule.length_ratio, rule.angle_deg,
                       rule.lateral_length, rule.axis_twist_deg, rule.lateral_twist_deg,
                       rule.shortest_mm);
}

std::string print_twig_report(TwigRule const& twig)
{
    auto const& rule = twig.rule;
    nlohmann::ordered_json const report { { "rule",
                                            { { "k", rule.laterals },
                                              { "l", rule.first_length_mm },
                                              { "r", rule.length_ratio },
                                              { "a", rule.angle_deg },
                                              { "s", rule.lateral_length },
                                              { "T", rule.axis_twist_deg },
                                              { "t", rule.lateral_twist_deg },
                                              { "l_min", rule.shortest_mm } } },
                                          { "laterals", rule.laterals },
                                          { "angle", rule.angle_deg },
                                          { "length_ratio", rule.lateral_length },
                                          { "internode", rule.first_length_mm },
                                          { "internode_ratio", rule.length_ratio },
                                          { "divergence", rule.axis_twist_deg },
                                          { "order", twig.order },
                                          { "nodes", twig.nodes },
                                          { "bare_nodes", twig.bare_nodes },
                                          { "deviations",
                                            { { "angle", twig.angle_deviation_deg },
                                              { "length_ratio", twig.length_deviation },
                                              { "internode", twig.spacing_deviation },
                                              { "divergence", twig.twist_deviation_deg } } },
                                          { "misfit", twig.misfit },
                                          { "is_rule", twig.is_rule() } };
    return report.dump() + "\n";
}

} // namespace tractus::sketch
