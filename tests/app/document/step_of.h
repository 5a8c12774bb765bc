#pragma once

#include "app/document/document.h"

#include <string>
#include <utility>
#include <vector>

namespace tractus::document {

// Returns a step with these edits, independent of the scene.
inline StepRequest step_of(std::vector<scene::Edit> edits, std::string status = "")
{
    return { [change = StepRequest::Change { std::move(edits), std::move(status) }](
                 scene::Scene const&) -> Result<StepRequest::Change> { return change; } };
}

} // namespace tractus::document
