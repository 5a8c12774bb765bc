#include "engine/methods/silhouettes/tree_form_fields.h"

#include <array>

namespace tractus::silhouette {

namespace {

// Names of patterns, indexed by Pattern::Kind.
constexpr std::array kPatterns {
    "even", "spiral", "decussate", "whorls", "two-rows", "horizontal"
};

// Field names of a style, by level.
struct StyleNames {
    char const* children;
    char const* children_deviation;
    char const* bare;
    char const* unbranched;
    char const* spacing;
    char const* unevenness;
    char const* spacing_deviation;
    char const* first_angle_deg;
    char const* last_angle_deg;
    char const* angle_deviation_deg;
};

constexpr std::array<StyleNames, 3> kStyleNames { {
    { "trunk_children", "trunk_children_deviation", "trunk_bare", "trunk_unbranched",
      "trunk_spacing", "trunk_unevenness", "trunk_spacing_deviation", "trunk_first_angle_deg",
      "trunk_last_angle_deg", "trunk_angle_deviation_deg" },
    { "branch_children", "branch_children_deviation", "branch_bare", "branch_unbranched",
      "branch_spacing", "branch_unevenness", "branch_spacing_deviation", "branch_first_angle_deg",
      "branch_last_angle_deg", "branch_angle_deviation_deg" },
    { "twig_children", "twig_children_deviation", "twig_bare", "twig_unbranched", "twig_spacing",
      "twig_unevenness", "twig_spacing_deviation", "twig_first_angle_deg", "twig_last_angle_deg",
      "twig_angle_deviation_deg" },
} };

// Lists the fields of a style. They are written only if the style is set, so that forms without
// styles keep their file format.
void list(scene::Fields& fields, StyleNames const& names, BranchStyle& style)
{
    fields.sparse_field(names.children, &style.children);
    fields.sparse_field(names.children_deviation, &style.children_deviation);
    fields.sparse_field(names.bare, &style.bare);
    fields.sparse_field(names.unbranched, &style.unbranched);
    fields.sparse_field(names.spacing, &style.spacing);
    fields.sparse_field(names.unevenness, &style.unevenness);
    fields.sparse_field(names.spacing_deviation, &style.spacing_deviation);
    fields.sparse_field(names.first_angle_deg, &style.first_angle_deg);
    fields.sparse_field(names.last_angle_deg, &style.last_angle_deg);
    fields.sparse_field(names.angle_deviation_deg, &style.angle_deviation_deg);
}

// Lists the number of branches in a whorl. It is written only if it is not three, so that whorls of
// three keep their file format.
void list_whorl(scene::Fields& fields, char const* name, Pattern& pattern)
{
    int whorl = pattern.whorl == kUsualWhorl ? 0 : pattern.whorl;
    fields.sparse_field(name, &whorl);
    pattern.whorl = whorl == 0 ? kUsualWhorl : whorl;
}

// Lists the bark. It is written only if it is of a kind, so that other forms keep their file
// format.
void list_bark(scene::Fields& fields, BarkKind& bark)
{
    std::string name(bark == BarkKind::Furrowed ? "" : bark_name(bark));
    fields.sparse_field("bark", &name);
    bark = bark_kind(name).value_or(BarkKind::Furrowed);
}

} // namespace

void list(scene::Fields& fields, TreeForm& form)
{
    fields.field("levels", &form.levels);
    fields.word("trunk_pattern", form.patterns[0].kind, kPatterns);
    fields.word("branch_pattern", form.patterns[1].kind, kPatterns);
    fields.word("twig_pattern", form.patterns[2].kind, kPatterns);
    list_whorl(fields, "trunk_whorl", form.patterns[0]);
    list_whorl(fields, "branch_whorl", form.patterns[1]);
    list_whorl(fields, "twig_whorl", form.patterns[2]);
    fields.field("density", &form.density);
    fields.field("leaves", &form.leaves);
    fields.field("leaf_width", &form.leaf_width);
    fields.field("seed", &form.seed);
    for (std::size_t level = 0; level < form.styles.size(); ++level)
        list(fields, kStyleNames[level], form.styles[level]);
    fields.sparse_field("whole_nodes", &form.has_whole_nodes);
    fields.sparse_field("plane_branches", &form.plane_branches);
    fields.sparse_field("leaves_reach_outline", &form.leaves_reach_outline);
    fields.sparse_field("base_angle_deg", &form.base_angle_deg);
    fields.sparse_field("tip_angle_deg", &form.tip_angle_deg);
    fields.sparse_field("bases_by_angle", &form.bases_by_angle);
    fields.sparse_field("rise", &form.rise);
    list_bark(fields, form.bark);
}

} // namespace tractus::silhouette
