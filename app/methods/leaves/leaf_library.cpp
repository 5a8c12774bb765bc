#include "app/methods/leaves/leaf_library.h"

#include "app/files/resources.h"
#include "engine/base/file.h"
#include "engine/base/fnv.h"
#include "engine/base/nearest_word.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <system_error>
#include <utility>

namespace tractus::leaf {

namespace fs = std::filesystem;

namespace {

constexpr double kGrownUp = 0.35; // LeafLife::age at which a leaf becomes adult.
constexpr double kDecays = 0.65;

double ease(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

} // namespace

std::vector<std::string> leaf_names()
{
    return files::resource_names("leaves", ".leaf");
}

Result<std::string> read_leaf_text(fs::path const& path)
{
    return read_text_file(path, std::size_t { 1 } << 20);
}

Result<leaf::Grammar> load_leaf_grammar(std::string const& name)
{
    std::error_code error;
    fs::path const path(name);
    bool const is_name = name.find_first_of("/.") == std::string::npos;
    if (is_name && (!fs::exists(path, error) || fs::is_directory(path, error)))
        return load_own_leaf_grammar(name);
    return leaf::parse_grammar(TRY(read_leaf_text(path)), path.string());
}

Result<leaf::Grammar> load_own_leaf_grammar(std::string const& name)
{
    auto const path = TRY(own_leaf_path(name));
    return leaf::parse_grammar(TRY(read_leaf_text(path)), path.string());
}

Result<fs::path> own_leaf_path(std::string const& name)
{
    TRY(lsystem::check_leaf_name(name));
    auto const ours = leaf_names();
    if (std::ranges::find(ours, name) == ours.end())
        return fail(Fault::User,
                    fmt::format("there is no leaf {}{}: give the path of a leaf grammar, or one of "
                                "{}",
                                name, did_you_mean(name, ours), fmt::join(ours, ", ")));
    return TRY(files::find_resource("leaves")) / (name + ".leaf");
}

Result<GrownLeaf> grow_leaf(leaf::Grammar const& grammar, LeafLife const& life)
{
    int const adult = life.steps.value_or(grammar.steps);
    if (adult < 1)
        return fail(Fault::User,
                    fmt::format("{}: how many steps does it take? \"#steps(9)\" says so in the "
                                "grammar, --steps 9 here",
                                grammar.name));
    double const growth = ease(life.age / kGrownUp);
    int const least = std::min(adult, std::max(1, (adult + 1) / 2));
    int const steps = least + static_cast<int>(std::lround((adult - least) * growth));
    auto leaf = TRY(leaf::Leaf::begin(grammar,
                                      { .final_step = steps,
                                        .age = life.age,
                                        .seed = life.seed,
                                        .variation = life.variation,
                                        .pose = pose_at(life.age) }));
    while (leaf.step() < steps)
        TRY(leaf.derive());
    TRY(leaf.fill());
    auto triangles = leaf::triangles_of(leaf);
    return GrownLeaf { std::move(leaf), std::move(triangles) };
}

leaf::Leaf::Pose pose_at(double age)
{
    double const growth = ease(age / kGrownUp);
    double const decay = ease((age - kDecays) / (1 - kDecays));
    // In a bud, the blade is folded over its upper side.
    return { .bend_deg = -60 * (1 - growth) + 20 * growth * (1 - decay) + 70 * decay,
             .curl_deg = 25 * growth + 95 * decay,
             .twist_deg = 40 * decay,
             .uneven_deg = 15 * decay };
}

double color_age(double age)
{
    constexpr double kBegins = 0.55;
    constexpr double kTakes = 0.4;
    return ease((age - kBegins) / kTakes);
}

leaf::PaintOptions paint_options(leaf::Grammar const& grammar, LeafLife const& life)
{
    return { .age = color_age(life.age),
             .young = grammar.young,
             .old = grammar.old,
             .seed = life.seed ^ fnv1a_64(short_leaf_name(grammar.name)) };
}

lsystem::LeafDamage damage_of_leaf(lsystem::LeafDamage const& average, int number)
{
    // Multiples of this number, modulo 1, fill the range from 0 to 1 evenly. It is the inverse of
    // the plastic ratio, so that damage does not correlate with the leaves' ages (leaf_age()),
    // which use multiples of the golden ratio.
    constexpr double kPlastic = 0.7548776662466927;
    double const turned = (number + 0.5) * kPlastic;
    double const times = 2 * (turned - std::floor(turned));
    return { .spots = std::min(1.0, times * average.spots),
             .mildew = std::min(1.0, times * average.mildew),
             .mines = times * average.mines,
             .larvae = times * average.larvae,
             .withered = average.withered };
}

void paint_damage(leaf::PaintOptions& options, lsystem::LeafDamage const& damage)
{
    options.spots = damage.spots;
    options.mildew = damage.mildew;
    options.mines = static_cast<int>(std::lround(damage.mines));
    options.larvae.count = static_cast<int>(std::lround(damage.larvae));
    options.dead_age = damage.withered;
}

std::string short_leaf_name(std::string const& name)
{
    return fs::path(name).stem().string();
}

} // namespace tractus::leaf
