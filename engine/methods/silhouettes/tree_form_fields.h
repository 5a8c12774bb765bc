#pragma once

#include "engine/methods/silhouettes/tree_form.h"
#include "engine/scene/fields.h"

namespace tractus::silhouette {

// Passes the fields of a form to a visitor, for the edits that contain one. Fields added in later
// versions are written only if they differ from their defaults.
void list(scene::Fields& fields, TreeForm& form);

} // namespace tractus::silhouette
