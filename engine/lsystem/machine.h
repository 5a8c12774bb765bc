#pragma once

#include "engine/base/random.h"
#include "engine/lsystem/model.h"
#include "engine/lsystem/module_string.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus {

// For numbers that belong to a step, not to a module.
constexpr std::uint64_t kNoPosition = ~std::uint64_t { 0 };

// Runs compiled programs: what one derivation changes, besides its string.
//
// Random numbers depend on nothing but the seed, the step, and the module's position in the string,
// so a string may be rewritten in any order.
class Machine {
public:
    Machine(Model const& model, std::uint64_t seed);
    // As the derivation of `string` left it.
    Machine(Model const& model, ModuleString const& string);

    // The numbers drawn from here on belong to this module of this step.
    void begin_module(std::uint32_t step, std::uint64_t position)
    {
        step_ = step;
        position_ = position;
        words_left_ = 0;
        block_ = 0;
    }

    void run(Program const& program, double* frame)
    {
        if (!program.empty())
            execute(program, frame);
    }
    void run(Block const& block);

    // [0, 1).
    double uniform();

    // A loop that did not end within ten million rounds stops, and from then on this is true.
    bool loop_did_not_end() const { return loop_did_not_end_; }
    // Takes note that one did not end on another machine, which ran a part of the same step.
    void stop_loops() { loop_did_not_end_ = true; }
    // That as an error, the user's fault.
    Result<void> check() const;

    std::vector<double> globals;
    std::vector<std::vector<double>> arrays;
    std::uint64_t seed() const { return seed_; }

private:
    void execute(Program const& program, double* frame);
    double draw(Op op, double left, double right);
    double normal();
    double gamma(double shape);
    double binomial(double trials, double probability);
    double& array_element(std::uint16_t array, double index);

    Model const& model_;
    std::uint64_t first_seed_ = 0;
    std::uint64_t seed_ = 0;
    std::uint32_t step_ = 0;
    std::uint64_t position_ = 0;
    std::uint32_t block_ = 0;
    unsigned words_left_ = 0;
    std::array<std::uint32_t, 4> words_ {};
    bool loop_did_not_end_ = false;
};

} // namespace tractus
