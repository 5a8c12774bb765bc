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

// Names of the species with a built-in leaf grammar, in alphabetical order.
std::vector<std::string> leaf_names();

// Loads the grammar that the user named: the path of a file, or the bare name of a built-in grammar
// ("oak"). Fails with a user error that lists the built-in grammars or says what is wrong in the
// file.
Result<leaf::Grammar> load_leaf_grammar(std::string const& name);

// Loads a built-in grammar by its bare name. If there is no such grammar, fails with a user error
// that lists the built-in grammars.
Result<leaf::Grammar> load_own_leaf_grammar(std::string const& name);

// Path of a built-in grammar's file. Fails with a user error if there is no such grammar.
Result<std::filesystem::path> own_leaf_path(std::string const& name);

// Reads the text of a leaf grammar's file. Fails with a user error if the file exceeds 1 MiB.
Result<std::string> read_leaf_text(std::filesystem::path const& path);

// Parameters of one leaf. Its age is 0 for a bud, 0.35 to 0.65 for an adult leaf, and 1 for a
// withered leaf.
struct LeafLife {
    double age = 0.5;
    std::uint64_t seed = 1;
    double variation = 1; // Strength of the variation from leaf to leaf; 0: no variation.
    // Growth steps of an adult leaf; no value: the number that the grammar gives.
    std::optional<int> steps {};
};

// A leaf and its triangles. The grammar must outlive it.
struct GrownLeaf {
    leaf::Leaf leaf;
    leaf::LeafTriangles triangles;
};
// Grows a leaf. Fails with a user error if neither the grammar nor `life` gives the number of
// steps.
Result<GrownLeaf> grow_leaf(leaf::Grammar const& grammar, LeafLife const& life);

// Pose of the blade at an age: folded in a bud, slightly bent in an adult leaf, and hanging,
// twisted and rolled in an old leaf.
leaf::Leaf::Pose pose_at(double age);

// Age of a leaf's colours, from 0 (young) to 1 (old), for a leaf of the age `age`.
double color_age(double age);

// Paint options of a leaf with its grammar's colours and without damage. Leaves of different
// grammars have their spots in different places even if they have the same seed.
leaf::PaintOptions paint_options(leaf::Grammar const& grammar, LeafLife const& life);

// Damage of the leaf with this number if the average over many leaves is `average`: between no
// damage and twice the average.
lsystem::LeafDamage damage_of_leaf(lsystem::LeafDamage const& average, int number);

// Adds the damage to the paint options.
void paint_damage(leaf::PaintOptions& options, lsystem::LeafDamage const& damage);

// Short name of a leaf: the name of its file without folder and extension.
std::string short_leaf_name(std::string const& name);

} // namespace tractus::leaf
