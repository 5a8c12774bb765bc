#pragma once

#include "engine/base/random.h"
#include "engine/base/result.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// Position of random numbers that belong to a derivation step instead of to a module.
constexpr std::uint64_t kNoPosition = ~std::uint64_t { 0 };

// Step number for random numbers that are drawn in homomorphism rules.
constexpr std::uint32_t kHomomorphismStep = 0xffffffff;

// Converts two random words to a number in [0, 1), a multiple of 2^-53.
inline double unit_number(std::uint32_t high, std::uint32_t low)
{
    auto const bits = (std::uint64_t { high } << 32 | low) >> 11;
    return static_cast<double>(bits) * 0x1p-53;
}

// Runs compiled programs, and holds a derivation's variables and the state of its random numbers.
//
// A random number depends only on the seed, the step and the position of the module in the string,
// so that the modules of a string may be rewritten in any order.
class VirtualMachine {
public:
    // Makes a machine for the programs of one L-system of the model.
    VirtualMachine(Model const& model, LSystem const& system, std::uint64_t seed);
    // Makes a machine for the programs of the main L-system.
    VirtualMachine(Model const& model, std::uint64_t seed)
        : VirtualMachine(model, model, seed)
    {
    }
    // Continues with the variables and the seed that a derivation has stored in `string`.
    VirtualMachine(Model const& model, ModuleString const& string);

    // Sets the function that receives the output of printf; by default the output is discarded. The
    // printer must outlive the machine.
    using Printer = std::function<void(std::string_view)>;
    void set_printer(Printer const* printer) { printer_ = printer; }
    // Sets the time limit, which must outlive the machine.
    void set_time_limit(TimeLimit const* limit) { time_limit_ = limit; }
    Printer const* printer() const { return printer_; }
    TimeLimit const* time_limit() const { return time_limit_; }
    // Limits the memory for the successor of one module while rules rewrite that successor further.
    void set_memory_limit(std::size_t bytes) { memory_limit_ = bytes; }
    std::size_t memory_limit() const { return memory_limit_; }

    // Starts the sequence of random numbers of one module in one step.
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

    // Draws a random number, uniformly distributed in [0, 1).
    double uniform();

    // Reason why all programs of a derivation must stop at once.
    enum class Stop : std::uint8_t {
        None,
        Loop,   // A loop has not ended within ten million iterations.
        Time,   // The time limit is exceeded.
        Memory, // The memory limit is exceeded while rules rewrite a module's successor further.
    };
    Stop stop() const { return stop_; }
    bool has_stopped() const { return stop_ != Stop::None; }
    // Stops this machine because another machine that works on the same step has stopped.
    void stop_too(Stop reason) { stop_ = std::max(stop_, reason); }
    // Returns a user error if the machine has stopped.
    Result<void> check() const;

    // Counts work, in modules, and checks the time limit every kWorkBetweenLooks.
    void spend(std::size_t work)
    {
        spent_ += work;
        if (spent_ >= kWorkBetweenLooks)
            look_at_clock();
    }

    double& global(GlobalIndex index) { return globals[static_cast<std::size_t>(index)]; }
    // Copies the values that all L-systems share: the predefined variables and the seed.
    void share(VirtualMachine const& other);

    std::vector<double> globals;
    std::vector<std::vector<double>> arrays;
    std::uint64_t seed() const { return seed_; }

private:
    void execute(Program const& program, double* frame);
    double evaluate(Op op, double left, double right);
    bool may_go_on(std::uint64_t rounds);
    double draw(Op op, double left, double right);
    double normal();
    double gamma(double shape);
    double binomial(double trials, double probability);
    double& array_element(std::uint16_t array, double index);
    double function(double number, double x) const;
    double curve(Op op, double number, double t) const;
    void print(Instruction const& instruction, double const* frame) const;
    void look_at_clock();

    static constexpr std::size_t kWorkBetweenLooks = 65'536;

    Model const& model_;
    Printer const* printer_ = nullptr;      // Not owned.
    TimeLimit const* time_limit_ = nullptr; // Not owned.
    std::size_t memory_limit_ = ModelLimits().max_memory_bytes;
    std::uint64_t first_seed_ = 0;
    std::uint64_t seed_ = 0;
    std::uint32_t step_ = 0;
    std::uint64_t position_ = 0;
    std::uint32_t block_ = 0;
    unsigned words_left_ = 0;
    std::array<std::uint32_t, 4> words_ {};
    std::size_t spent_ = 0;
    Stop stop_ = Stop::None;
};

} // namespace tractus::lsystem
