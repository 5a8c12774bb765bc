#pragma once

#include <cstddef>
#include <string>

namespace tractus::view {

// The step of the tour that the window shows.
struct TourView {
    std::string task {};   // What the user should do, or what happens: a few words.
    std::string how {};    // How to do it: one or two sentences.
    std::size_t step = 0;  // Number of the step, from 1.
    std::size_t count = 0; // Number of all steps.
    bool is_last = false;  // True if nothing is left to do.

    bool operator==(TourView const&) const = default;
};

} // namespace tractus::view
