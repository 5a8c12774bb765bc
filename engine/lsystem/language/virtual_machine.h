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

// Position of numbers that belong to a step, not to a module.
constexpr std::uint64_t kNoPosition = ~std::uint64_t { 0 };

// Step of what homomorphism rules draw at random.
constexpr std::uint32_t kHomomorphismStep = 0xffffffff;

// [0, 1), in steps of 2^-53, of two random words.
inline double unit_number(std::uint32_t high, std::uint32_t low)
{
    auto const bits = (std::uint64_t { high } << 32 | low) >> 11;
    return static_cast<double>(bits) * 0x1p-53;
}

// Runs compiled programs: what one derivation changes, besides its string.
//
// Random numbers depend on nothing but the seed, the step, and the module's position in the string,
// so a string may be rewritten in any order.
class VirtualMachine {
public:
    // Runs the programs of one L-system of the model.
    VirtualMachine(Model const& model, LSystem const& system, std::uint64_t seed);
    // Runs those of the main one.
    VirtualMachine(Model const& model, std::uint64_t seed)
        : VirtualMachine(model, model, seed)
    {
    }
    // Starts from where the derivation of `string` left it.
    VirtualMachine(Model const& model, ModuleString const& string);

    // Where printf prints; nowhere without it. Must outlive the machine.
    using Printer = std::function<void(std::string_view)>;
    void set_printer(Printer const* printer) { printer_ = printer; }
    // Must outlive the machine, too.
    void set_time_limit(TimeLimit const* limit) { time_limit_ = limit; }
    Printer const* printer() const { return printer_; }
    TimeLimit const* time_limit() const { return time_limit_; }
    // Limits the memory of one module's rules while they rewrite each other's modules.
    void set_memory_limit(std::size_t bytes) { memory_limit_ = bytes; }
    std::size_t memory_limit() const { return memory_limit_; }

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

    // Why programs, and those who run them, must end at once.
    enum class Stop : std::uint8_t {
        None,
        Loop,   // One did not end within ten million rounds.
        Time,   // The time limit has passed.
        Memory, // Rules within rules need more than the limit of memory.
    };
    Stop stop() const { return stop_; }
    bool has_stopped() const { return stop_ != Stop::None; }
    // Takes note that another machine, which ran a part of the same step, has stopped.
    void stop_too(Stop reason) { stop_ = std::max(stop_, reason); }
    // Returns that as an error, the user's fault.
    Result<void> check() const;

    // Takes note of work, in modules, so that the clock is looked at now and then.
    void spend(std::size_t work)
    {
        spent_ += work;
        if (spent_ >= kWorkBetweenLooks)
            look_at_clock();
    }

    double& global(GlobalIndex index) { return globals[static_cast<std::size_t>(index)]; }
    // Takes over what all L-systems share: steps, the derivation length and the seed.
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
