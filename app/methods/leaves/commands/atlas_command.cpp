#include "app/methods/leaves/commands/atlas_command.h"

#include "app/methods/leaves/leaf_atlas.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/terminal/console.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::leaf {

namespace {

namespace fs = std::filesystem;

constexpr int kMaxOfEach = 4096;

struct AtlasArguments {
    AtlasOptions options;
    std::string age = "0.5";
    std::string engine = "gltf";
    std::string geometry = "cut";
    bool has_mips = false;
    fs::path output;
};

std::optional<double> age_in(std::string_view text)
{
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    bool const is_age
        = error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= 1;
    return is_age ? std::optional(value) : std::nullopt;
}

// Parses an age, "0.5", or a range of ages, "0.3:0.9".
std::optional<std::pair<double, double>> ages_in(std::string_view text)
{
    auto const colon = text.find(':');
    auto const from = age_in(text.substr(0, colon));
    auto const to = colon == std::string_view::npos ? from : age_in(text.substr(colon + 1));
    if (!from || !to)
        return std::nullopt;
    return std::pair(*from, *to);
}

CLI::Validator age_range()
{
    return { [](std::string const& text) {
                return ages_in(text) ? std::string()
                                     : fmt::format("\"{}\" is no age from 0 to 1, and no two of "
                                                   "them as in 0.3:0.9",
                                                   text);
            },
             "A|A:B" };
}

CLI::Validator power_of_two(int least, int most)
{
    return { [least, most](std::string const& text) {
                int value = 0;
                auto const* const end = text.data() + text.size();
                auto const found = std::from_chars(text.data(), end, value);
                bool const is_one = found.ec == std::errc() && found.ptr == end && value >= least
                    && value <= most && std::has_single_bit(static_cast<unsigned>(value));
                return is_one
                    ? std::string()
                    : fmt::format("\"{}\" is no power of two from {} to {}", text, least, most);
            },
             "PIXELS" };
}

std::vector<std::string> engines()
{
    std::vector<std::string> names;
    for (auto const& channels : atlas_channels())
        names.push_back(channels.engine);
    return names;
}

constexpr std::array<std::string_view, 3> kGeometries { "card", "cut", "modelled" };

Result<void> make_atlas(AtlasArguments arguments)
{
    auto& options = arguments.options;
    if (options.leaves.empty())
        return fail(Fault::User,
                    "which leaves? \"tractus leaves maple -o DIR\" makes pages of them, \"tractus "
                    "leaves --help\" names what else there is");
    if (arguments.output.empty())
        return fail(Fault::User, "where to? -o DIR names the folder for the pages");
    if (options.cell > options.page)
        return fail(Fault::User,
                    fmt::format("a leaf of {} pixels is larger than its page of {}: use a smaller "
                                "--pixels or a larger --page",
                                options.cell, options.page));
    auto const ages = ages_in(arguments.age);
    options.age_from = ages->first;
    options.age_to = ages->second;
    options.mips = arguments.has_mips ? AtlasOptions::Mips::Files : AtlasOptions::Mips::None;
    options.geometry = static_cast<AtlasGeometry>(std::ranges::find(kGeometries, arguments.geometry)
                                                  - kGeometries.begin());
    options.channels
        = *std::ranges::find(atlas_channels(), arguments.engine, &AtlasChannels::engine);
    auto const made = TRY(write_atlas(options, arguments.output));
    return terminal::print_out(fmt::format("wrote {}: leaves {}, pages {}\n",
                                           arguments.output.string(), made.leaves, made.pages));
}

void add_page_options(CLI::App& leaves, AtlasArguments& arguments)
{
    auto& options = arguments.options;
    leaves.add_option("LEAF", options.leaves, "Leaf grammars (.leaf), or ours by name: maple")
        ->type_name("LEAF|FILE")
        ->check(options::suggest(leaf_names()));
    leaves.add_option("-o,--output", arguments.output, "A folder for the pages")->type_name("DIR");
    leaves.add_option("--count", options.count, "How many of each, all different")
        ->type_name("N")
        ->check(options::whole_number(1, kMaxOfEach))
        ->capture_default_str();
    leaves.add_option("--pixels", options.cell, "Each leaf's square is so wide, a power of two")
        ->check(power_of_two(32, 2048))
        ->capture_default_str();
    leaves.add_option("--page", options.page, "Each page is so wide, a power of two")
        ->check(power_of_two(32, 8192))
        ->capture_default_str();
    leaves.add_option("--channels", arguments.engine, "Which maps, for which engine")
        ->type_name("ENGINE")
        ->check(options::one_of(engines()))
        ->capture_default_str();
    leaves
        .add_option("--geometry", arguments.geometry,
                    "A rectangle, a shape cut out along the edge, or bent leaves")
        ->type_name("WEIGHT")
        ->check(options::one_of({ kGeometries.begin(), kGeometries.end() }))
        ->capture_default_str();
    leaves.add_flag("--mips", arguments.has_mips,
                    "Write smaller pictures, too, in which as much of each leaf is left");
}

void add_leaf_options(CLI::App& leaves, AtlasArguments& arguments)
{
    auto& options = arguments.options;
    auto& damage = options.damage;
    leaves
        .add_option("--age", arguments.age,
                    "0: a bud, 0.5: grown up, 1: old; with 0.3:0.9 ages lie between")
        ->check(age_range())
        ->capture_default_str();
    leaves.add_option("--seed", options.seed, "Which leaf; the next ones follow")
        ->type_name("SEED")
        ->check(options::seed_number())
        ->capture_default_str();
    leaves.add_option("--variation", options.variation, "How far leaves differ; 0: not at all")
        ->type_name("V")
        ->check(options::number(0, 3))
        ->capture_default_str();
    leaves.add_option("--larvae", damage.larvae, "How many larvae ate of each")
        ->type_name("N")
        ->check(options::whole_number(0, 100));
    leaves.add_option("--spots", damage.spots, "How much of each has brown spots")
        ->type_name("SHARE")
        ->check(options::number(0, 1));
    leaves.add_option("--mildew", damage.mildew, "How much of each is white with mildew")
        ->type_name("SHARE")
        ->check(options::number(0, 1));
    leaves.add_option("--mines", damage.mines, "How many ways larvae have eaten under its skin")
        ->type_name("N")
        ->check(options::whole_number(0, 100));
    leaves.add_option("--dead", damage.dead, "How far its old colour has become a dead one")
        ->type_name("SHARE")
        ->check(options::number(0, 1));
    leaves.add_flag("--skeleton", damage.is_skeleton, "Leave nothing but veins");
}

} // namespace

void add_atlas_options(CLI::App& leaves, options::Action& action)
{
    auto* const atlas = leaves.add_subcommand("atlas", "Make pages of leaves for game engines");
    for (auto* const command : { &leaves, atlas }) {
        auto arguments = std::make_shared<AtlasArguments>();
        add_page_options(*command, *arguments);
        add_leaf_options(*command, *arguments);
        command->callback([command, arguments, &action] {
            if (command->get_subcommands().empty())
                action = [arguments] { return make_atlas(*arguments); };
        });
    }
    std::string const pages
        = "Each leaf has a square; colours go on round it. The folder gets page-0-color.png and\n"
          "so on, the leaves' shapes in page-0.glb, and leaves.json, which says what lies where.";
    leaves.footer("Without a command: pages of leaves for game engines, as by \"leaves atlas\".\n"
                  + pages);
    atlas->footer(pages);
}

void add_atlas_examples(CLI::App& leaves)
{
    options::add_examples(*leaves.get_subcommand("atlas"),
                          { "leaves atlas maple --count 4 -o maple-leaves",
                            "leaves atlas oak ivy --geometry modelled -o modelled" });
    options::add_examples(leaves, { "leaves maple oak --count 4 -o leaves" });
}

} // namespace tractus::leaf
