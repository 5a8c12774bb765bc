#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <set>
#include <span>
#include <string>

namespace tractus::silhouette {

// All branches that styles go from and to, each once.
std::set<std::string> paths_in(ChosenStyles const& styles);

// Whose style a branch has that somebody chose another one's for: that one's, or whose that one
// has. All are paths (Skeleton::at()).
std::string source_of(ChosenStyles const& styles, std::string branch);

// Chooses styles in addition to those that there are, or in place of them; "" takes a branch's
// away. What a source has from another one is that one's. Fails, as the user's fault, for a branch
// that there is not, a source that bears nothing or is on a deeper level, a branch that others were
// drawn on, and one whose style is taken away and that has none.
Result<void> choose_styles(ChosenStyles& styles, ChosenStyles const& chosen,
                           Skeleton const& skeleton);

// What a stroke chooses that carries a style: that of the branch that it begins on (own_branch.h)
// goes to those that it runs over on the same level, to within 1 % of the outline's diagonal. One
// that runs over no other takes the style away that somebody chose for its branch. The trunk's
// branches are meant, and those of branches that somebody drew on. Fails, as the user's fault,
// where it begins on none. The skeleton and the stroke are in the same millimetres.
Result<ChosenStyles> carried_by(Skeleton const& skeleton, std::span<Vec2 const> stroke);

} // namespace tractus::silhouette
