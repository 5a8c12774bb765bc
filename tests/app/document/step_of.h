#pragma once

#include "app/document/document.h"

#include <string>
#include <utility>
#include <vector>

namespace tractus::document {

// Returns a request for a step with the given edits, whatever the scene is.
inline StepRequest step_of(std::vector<scene::Edit> edits, std::string status = "")
{
    return { [change = StepRequest::Change { std::move(edits), std::move(status) }](
                 scene::Scene const&) -> Result<StepRequest::Change> { return change; } };
}

} // namespace tractus::document
