#include "engine/lsystem/language/virtual_machine.h"

#include "engine/base/vectors.h"
#include "engine/lsystem/language/arithmetic.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

static constexpr std::uint64_t kMaxRounds = 10'000'000;

// Combines two seeds, so that equal seeds from srand(), from the model and from the caller give
// different random numbers.
static std::uint64_t mix(std::uint64_t seed, std::uint64_t other)
{
    return seed + other * 0x9e3779b97f4a7c15u;
}

VirtualMachine::VirtualMachine(Model const& model, LSystem const& system, std::uint64_t seed)
    : globals(system.globals.size())
    , model_(model)
    , first_seed_(mix(seed, model.seed))
    , seed_(first_seed_)
{
    for (auto const& array : system.arrays)
        arrays.push_back(array.values);
}

VirtualMachine::VirtualMachine(Model const& model, ModuleString const& string)
    : VirtualMachine(model, string.seed)
{
    seed_ = string.seed;
    if (string.globals.size() == globals.size())
        globals = string.globals;
    if (string.arrays.size() == arrays.size())
        arrays = string.arrays;
}

Result<void> VirtualMachine::check() const
{
    if (!has_stopped())
        return {};
    auto const where = step_ == 0    ? std::string("the start")
        : step_ == kHomomorphismStep ? std::string("the homomorphism")
                                     : fmt::format("step {}", step_);
    if (stop_ == Stop::Loop)
        return fail(Fault::User,
                    fmt::format("{}: in {} a loop did not end within 10 million rounds; look "
                                "whether its condition ever becomes 0",
                                model_.name, where));
    if (stop_ == Stop::Memory)
        return fail(Fault::User,
                    fmt::format("{}: in {} rules that rewrite each other's modules need more than "
                                "{} MB; lower the maximum depth, or raise the limit of memory",
                                model_.name, where, memory_limit_ >> 20));
    return fail(Fault::User,
                fmt::format("{}: {} was not done when {} s had passed; derive fewer steps, or "
                            "raise the limit of time",
                            model_.name, where, time_limit_->seconds));
}

void VirtualMachine::share(VirtualMachine const& other)
{
    std::copy_n(other.globals.begin(), static_cast<std::size_t>(GlobalIndex::Count),
                globals.begin());
    seed_ = other.seed_;
}

void VirtualMachine::look_at_clock()
{
    spent_ = 0;
    if (time_limit_ && time_limit_->is_over && time_limit_->is_over())
        stop_too(Stop::Time);
}

void VirtualMachine::run(Block const& block)
{
    auto frame = block.frame;
    run(block.program, frame.data());
}

double VirtualMachine::uniform()
{
    if (words_left_ == 0) {
        words_ = random_block({ .seed = seed_, .stream = step_, .substream = block_++ }, position_);
        words_left_ = 4;
    }
    auto const high = words_[4 - words_left_];
    auto const low = words_[5 - words_left_];
    words_left_ -= 2;
    return unit_number(high, low);
}

// Draws a number from the normal distribution with mean 0 and standard deviation 1, by the
// Box-Muller transform.
double VirtualMachine::normal()
{
    double const radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * kPi * uniform());
}

// Draws a number from the gamma distribution with scale 1, by the method of Marsaglia and Tsang, "A
// simple method for generating gamma variables", ACM TOMS 26(3), 2000.
double VirtualMachine::gamma(double shape)
{
    if (!(shape > 0))
        return 0;
    if (shape < 1)
        return gamma(shape + 1) * std::pow(1 - uniform(), 1 / shape);
    double const d = shape - 1.0 / 3;
    double const c = 1 / std::sqrt(9 * d);
    for (int i = 0; i < 1000; ++i) { // About 19 of 20 attempts are accepted.
        double const x = normal();
        double const v = std::pow(1 + c * x, 3);
        if (v > 0 && std::log(1 - uniform()) < x * x / 2 + d - d * v + d * std::log(v))
            return d * v;
    }
    return d;
}

double VirtualMachine::binomial(double trials, double probability)
{
    constexpr double kMaxCounted = 1000;
    if (!(trials >= 1))
        return 0;
    trials = std::floor(trials);
    if (trials > kMaxCounted) { // For many trials the normal distribution is a good approximation.
        double const mean = trials * probability;
        return std::clamp(std::round(mean + std::sqrt(mean * (1 - probability)) * normal()), 0.0,
                          trials);
    }
    double successes = 0;
    for (double i = 0; i < trials; ++i)
        successes += uniform() < probability;
    return successes;
}

double VirtualMachine::draw(Op op, double left, double right)
{
    switch (op) {
    case Op::Random:
        return left * uniform();
    case Op::Normal:
        return left + right * normal();
    case Op::Binomial:
        return binomial(left, std::clamp(right, 0.0, 1.0));
    case Op::SeedRandom:
        seed_ = mix(first_seed_, static_cast<std::uint64_t>(std::clamp(left, -1e15, 1e15) + 2e15));
        words_left_ = 0;
        return 0;
    default: {
        double const a = gamma(left);
        double const b = gamma(right);
        return a + b > 0 ? a / (a + b) : 0;
    }
    }
}

// Returns an element of an array. As in cpfg, an index out of range selects the first or last
// element.
double& VirtualMachine::array_element(std::uint16_t array, double index)
{
    auto& values = arrays[array];
    auto const last = static_cast<double>(values.size() - 1);
    return values[index > 0 ? static_cast<std::size_t>(std::min(index, last)) : 0];
}

double VirtualMachine::function(double number, double x) const
{
    auto const& functions = model_.view.functions;
    bool const exists = number >= 1 && number < static_cast<double>(functions.size()) + 1;
    return exists ? functions[static_cast<std::size_t>(number) - 1].at(x) : 0;
}

double VirtualMachine::curve(Op op, double number, double t) const
{
    auto const& curves = model_.view.curves;
    if (!(number >= 1) || !(number < static_cast<double>(curves.size()) + 1))
        return 0;
    auto const& curve = curves[static_cast<std::size_t>(number) - 1];
    if (op == Op::CurveLength)
        return curve.length;
    Vec3 const point = curve.at(t);
    return op == Op::CurveX ? point.x() : op == Op::CurveY ? point.y() : point.z();
}

void VirtualMachine::print(Instruction const& instruction, double const* frame) const
{
    if (printer_ && *printer_)
        (*printer_)(lsystem::print(model_.formats[instruction.target],
                                   { frame + instruction.left, instruction.right }));
}

// Evaluates an instruction whose result depends on nothing but its operands, the model and random
// numbers.
double VirtualMachine::evaluate(Op op, double left, double right)
{
    switch (op) {
    case Op::Random:
    case Op::Normal:
    case Op::Beta:
    case Op::Binomial:
    case Op::SeedRandom:
        return draw(op, left, right);
    case Op::Function:
        return function(left, right);
    case Op::CurveX:
    case Op::CurveY:
    case Op::CurveZ:
    case Op::CurveLength:
        return curve(op, left, right);
    default:
        return compute(op, left, right);
    }
}

void VirtualMachine::execute(Program const& program, double* frame)
{
    std::uint64_t rounds = 0;
    auto const* const begin = program.data();
    auto const* const end = begin + program.size();
    for (auto const* i = begin; i < end; ++i) {
        switch (i->op) {
        case Op::Copy:
            frame[i->target] = frame[i->left];
            break;
        case Op::Add:
            frame[i->target] = frame[i->left] + frame[i->right];
            break;
        case Op::Subtract:
            frame[i->target] = frame[i->left] - frame[i->right];
            break;
        case Op::Multiply:
            frame[i->target] = frame[i->left] * frame[i->right];
            break;
        case Op::LoadGlobal:
            frame[i->target] = globals[i->left];
            break;
        case Op::StoreGlobal:
            globals[i->target] = frame[i->left];
            break;
        case Op::LoadArray:
            frame[i->target] = array_element(i->left, frame[i->right]);
            break;
        case Op::StoreArray:
            array_element(i->target, frame[i->left]) = frame[i->right];
            break;
        case Op::JumpIfZero:
            if (frame[i->left] == 0)
                i = begin + i->target - 1;
            break;
        case Op::Jump:
            if (begin + i->target <= i && !may_go_on(++rounds))
                return;
            i = begin + i->target - 1;
            break;
        case Op::Print:
            print(*i, frame);
            break;
        case Op::Halt:
            return;
        default:
            frame[i->target] = evaluate(i->op, frame[i->left], frame[i->right]);
        }
    }
}

// Counts an iteration of a loop. Returns false if the machine must stop.
bool VirtualMachine::may_go_on(std::uint64_t rounds)
{
    spend(1);
    if (rounds > kMaxRounds)
        stop_too(Stop::Loop);
    return !has_stopped();
}

} // namespace tractus::lsystem
