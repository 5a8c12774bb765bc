#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_grammar.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::leaf {

// The species whose leaf grammars come with the program, in alphabetical order.
std::vector<std::string> leaf_names();

// A grammar that the user named: a file as it is, or else one of ours by its name alone ("oak").
// Fails, as the user's fault, listing ours, or with what is wrong in the text.
Result<leaf::Grammar> load_leaf_grammar(std::string const& name);

// One of ours by its name alone. Fails, as the user's fault, listing them.
Result<leaf::Grammar> load_own_leaf_grammar(std::string const& name);

// The file of one of ours. Fails like load_own_leaf_grammar().
Result<std::filesystem::path> own_leaf_path(std::string const& name);

// The text of a leaf grammar's file. Fails, as the user's fault, for one beyond 1 MiB.
Result<std::string> read_leaf_text(std::filesystem::path const& path);

// How one leaf is to be. Its life goes from bud, 0, over the adult, 0.35 to 0.65, to old age, 1.
struct LeafLife {
    double age = 0.5;
    std::uint64_t seed = 1;
    double variation = 1;        // Variation from leaf to leaf: 0 is none.
    std::optional<int> steps {}; // Steps of an adult; else the grammar's own.
};

// A leaf and its triangles. `grammar` must outlive it.
struct GrownLeaf {
    leaf::Leaf leaf;
    leaf::LeafTriangles triangles;
};
// Fails, as the user's fault, where the grammar names no steps and `life` does not either.
Result<GrownLeaf> grow_leaf(leaf::Grammar const& grammar, LeafLife const& life);

// How the blade of a leaf of that age stands: folded up in the bud, slightly bent as a grown-up,
// hanging, twisted and rolled up in old age.
leaf::Leaf::Pose pose_at(double age);

// How old the colours of a leaf of that age are, 0 to 1.
double color_age(double age);

// How a leaf of that life is painted: its grammar's colours, nothing eaten. Leaves of different
// kinds that have one seed do not have their spots in the same places.
leaf::PaintOptions paint_options(leaf::Grammar const& grammar, LeafLife const& life);

// Damage of one of many leaves that have so much on the average: from none of it to twice as much.
lsystem::LeafDamage damage_of_leaf(lsystem::LeafDamage const& average, int number);

// Paints it on the leaf.
void paint_damage(leaf::PaintOptions& options, lsystem::LeafDamage const& damage);

// Returns what a user called a leaf: its file's name without folders and ending.
std::string short_leaf_name(std::string const& name);

} // namespace tractus::leaf
