#pragma once

#include "engine/methods/silhouettes/tree_form.h"
#include "engine/scene/fields.h"

namespace tractus::silhouette {

// Hands the fields of a form to a visitor, for edits that have one. What a form has come to have
// later is not written where it is as it always was.
void list(scene::Fields& fields, TreeForm& form);

} // namespace tractus::silhouette
