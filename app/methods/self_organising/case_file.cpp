#include "app/methods/self_organising/case_file.h"

#include "engine/base/file.h"
#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace tractus::self_organising {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxBytes = std::size_t { 1 } << 28;
constexpr double kMaxSteps = 1000;

// Reads the values of a JSON object. Error messages contain the object's name and the key.
class ObjectReader {
public:
    ObjectReader(json const& object, std::string name)
        : object_(object)
        , name_(std::move(name))
    {
    }

    Result<void> number(char const* key, double& value)
    {
        known_.emplace_back(key);
        if (!object_.contains(key))
            return {};
        if (!object_[key].is_number() || !std::isfinite(object_[key].get<double>()))
            return fail(Fault::User, fmt::format("{}: {} is no number", name_, key));
        value = object_[key].get<double>();
        return {};
    }

    Result<void> number(char const* key, ByOrder<double>& value)
    {
        double same = value.at(0);
        TRY(number(key, same));
        value = same;
        return {};
    }

    Result<void> number(char const* key, int& value)
    {
        double whole = value;
        TRY(number(key, whole));
        if (whole != std::floor(whole) || std::abs(whole) > 1e6)
            return fail(Fault::User,
                        fmt::format("{}: {} is {}, expected a whole number", name_, key, whole));
        value = static_cast<int>(whole);
        return {};
    }

    Result<void> vector(char const* key, Vec3& value)
    {
        known_.emplace_back(key);
        if (object_.contains(key))
            value = TRY(read_vector(object_[key], key));
        return {};
    }

    Result<void> vectors(char const* key, std::vector<Vec3>& values)
    {
        known_.emplace_back(key);
        if (!object_.contains(key))
            return {};
        if (!object_[key].is_array())
            return fail(Fault::User, fmt::format("{}: {} is no list of places", name_, key));
        for (auto const& value : object_[key])
            values.push_back(TRY(read_vector(value, fmt::format("{}[{}]", key, values.size()))));
        return {};
    }

    void also_known(char const* key) { known_.emplace_back(key); }

    Result<void> refuse_unknown_keys() const
    {
        for (auto const& [key, value] : object_.items())
            if (std::find(known_.begin(), known_.end(), key) == known_.end())
                return fail(Fault::User,
                            fmt::format("{}: {} is unknown; known are {}", name_, key,
                                        fmt::join(known_, ", ")));
        return {};
    }

private:
    Result<Vec3> read_vector(json const& value, std::string const& key) const
    {
        Vec3 read;
        bool is_place_macro = value.is_array() && value.size() == 3;
        for (std::size_t a = 0; is_place_macro && a < 3; ++a) {
            is_place_macro = value[a].is_number();
            if (is_place_macro)
                read[static_cast<Eigen::Index>(a)] = value[a].get<double>();
        }
        if (!is_place_macro || !read.allFinite())
            return fail(Fault::User,
                        fmt::format("{}: {} is no place: write [x, y, z]", name_, key));
        return read;
    }

    json const& object_;
    std::string name_;
    std::vector<std::string> known_;
};

Result<void> read_environment(json const& parameters, std::string const& name, Laws& laws)
{
    if (!parameters.contains("environment"))
        return {};
    auto const& word = parameters["environment"];
    if (word != "space" && word != "light")
        return fail(
            Fault::User,
            fmt::format("{}: environment is {}: write \"space\" or \"light\"", name, word.dump()));
    laws.environment = word == "space" ? Laws::Environment::Space : Laws::Environment::Light;
    return {};
}

Result<Laws> read_laws(json const& parameters, std::string const& name)
{
    Laws laws;
    TRY(read_environment(parameters, name, laws));
    ObjectReader reader(parameters, name + ": parameters");
    reader.also_known("environment");
    TRY(reader.number("internode", laws.internode));
    TRY(reader.number("perception_radius", laws.perception_radius));
    TRY(reader.number("perception_angle", laws.perception_angle_deg));
    TRY(reader.number("occupancy_radius", laws.occupancy_radius));
    TRY(reader.number("cell", laws.cell));
    TRY(reader.number("shade", laws.shade));
    TRY(reader.number("shade_fall", laws.shade_fall));
    TRY(reader.number("shade_depth", laws.shade_depth));
    TRY(reader.number("full_light", laws.full_light));
    TRY(reader.number("apical_control", laws.apical_control));
    TRY(reader.number("vigour", laws.vigour));
    TRY(reader.number("space_weight", laws.space_weight));
    TRY(reader.number("tropism_weight", laws.tropism_weight));
    TRY(reader.vector("tropism_direction", laws.tropism_direction));
    int most_internodes = laws.most_internodes.at(0);
    TRY(reader.number("most_internodes", most_internodes));
    laws.most_internodes = most_internodes;
    TRY(reader.number("longest", laws.longest));
    TRY(reader.number("divergence", laws.divergence_deg));
    TRY(reader.number("branching_angle", laws.branching_angle_deg));
    TRY(reader.number("pipe_exponent", laws.pipe_exponent));
    TRY(reader.number("twig_diameter", laws.twig_diameter));
    TRY(reader.number("shed_below", laws.shed_below));
    TRY(reader.refuse_unknown_keys());
    if (auto const checked = check_laws(laws); !checked)
        return fail(Fault::User, fmt::format("{}: {}", name, checked.error().message));
    return laws;
}

double to_nine_decimals(double value)
{
    constexpr double kNine = 1e9;
    return std::round(value * kNine) / kNine;
}

} // namespace

Result<Case> parse_case(std::string_view text, std::string const& name)
{
    auto const file = json::parse(text, nullptr, false);
    if (!file.is_object())
        return fail(Fault::User,
                    fmt::format("{}: it is no case: expected JSON, {{\"steps\": …, "
                                "\"parameters\": {{…}}}}",
                                name));
    Case example;
    ObjectReader reader(file, name);
    TRY(reader.number("steps", example.steps));
    TRY(reader.vectors("markers", example.markers));
    TRY(reader.vector("base", example.base));
    TRY(reader.vector("direction", example.direction));
    for (auto const* const key : { "parameters", "name", "expected" })
        reader.also_known(key);
    TRY(reader.refuse_unknown_keys());
    if (example.steps < 0 || example.steps > kMaxSteps)
        return fail(Fault::User,
                    fmt::format("{}: steps is {}: give a number from 0 to {}", name, example.steps,
                                kMaxSteps));
    if (file.contains("parameters")) {
        if (!file["parameters"].is_object())
            return fail(
                Fault::User,
                fmt::format("{}: parameters is no object: write {{\"internode\": 1}}", name));
        example.laws = TRY(read_laws(file["parameters"], name));
    }
    return example;
}

Result<Case> load_case(std::filesystem::path const& path)
{
    return parse_case(TRY(read_text_file(path, kMaxBytes)), path.string());
}

Result<GrownCase> grow_case(Case example)
{
    GrownCase grown { plant_seed(example.base, example.direction), {} };
    Surroundings surroundings { .markers = std::move(example.markers) };
    for (int i = 0; i < example.steps; ++i)
        grown.steps.push_back(TRY(grow_step(grown.tree, surroundings, example.laws)));
    return grown;
}

std::string print_case_report(GrownCase const& grown, Laws const& laws)
{
    auto const& tree = grown.tree;
    auto const widths = diameters(tree, laws);
    auto steps = json::array();
    for (auto const& step : grown.steps)
        steps.push_back({ { "buds", step.buds },
                          { "lit", step.lit },
                          { "grown", step.grown },
                          { "nodes", step.nodes },
                          { "markers", step.markers } });
    auto nodes = json::array();
    double length = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        auto const& at = tree.places[i].position;
        auto const& node = tree.links[i];
        nodes.push_back(
            { { "parent", node.parent == kNone ? json() : json(node.parent) },
              { "at",
                { to_nine_decimals(at.x()), to_nine_decimals(at.y()), to_nine_decimals(at.z()) } },
              { "order", node.order },
              { "step", node.step },
              { "diameter", to_nine_decimals(widths[i]) } });
        if (node.parent != kNone)
            length += (at - tree.places[node.parent].position).norm();
    }
    json const report { { "steps", std::move(steps) },
                        { "nodes", std::move(nodes) },
                        { "total_length", to_nine_decimals(length) },
                        { "base_diameter", to_nine_decimals(widths.front()) },
                        { "strahler", strahler_orders(tree).front() } };
    return report.dump() + "\n";
}

} // namespace tractus::self_organising
