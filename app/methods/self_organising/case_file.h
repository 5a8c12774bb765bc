#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/grow.h"
#include "engine/methods/self_organising/laws.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::self_organising {

// A test case for the growth laws without a habit or a brush: a seedling, markers of free space,
// and a number of steps. Lengths are in a unit that the case chooses; z is up.
struct Case {
    Laws laws {};
    std::vector<Vec3> markers {};
    Vec3 base = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
    int steps = 1;
};

// Reads a case from JSON:
//   {"steps": 9, "markers": [[x, y, z], …], "base": [0, 0, 0], "direction": [0, 0, 1],
//    "parameters": {"environment": "space", "internode": 1, "apical_control": 0.46, …}}
// Parameters have the names of the members of Laws without units; angles are in degrees. Missing
// values default to those of Laws. The keys "name" and "expected" are ignored. Fails with a user
// error that names the file and the place, if the text is not a case or a law is out of range.
Result<Case> parse_case(std::string_view text, std::string const& name);
Result<Case> load_case(std::filesystem::path const& path);

// A case after growth.
struct GrownCase {
    GrowingTree tree {};
    std::vector<StepCount> steps {};
};

// Grows the tree of a case. Fails if a step of growth fails (grow_step()).
Result<GrownCase> grow_case(Case example);

// A grown case as one line of JSON: {"steps": [{"buds", "lit", "grown", "nodes", "markers"}, …],
// "nodes": [{"parent", "at", "order", "step", "diameter"}, …], "total_length", "base_diameter",
// "strahler"}; lengths have nine decimals.
std::string print_case_report(GrownCase const& grown, Laws const& laws);

} // namespace tractus::self_organising
