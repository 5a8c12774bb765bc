#pragma once

#include "engine/lsystem/drawing.h"
#include "engine/lsystem/interpret.h"
#include "engine/lsystem/rewriter.h"
#include "engine/lsystem/turtle_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus {

// Draws the symbols of a string, one after the other, into a Drawing. What each symbol does:
// interpret.h.
class Turtle {
public:
    // All must outlive it.
    Turtle(Model const& model, TurtleOptions const& options);

    // What brackets save.
    struct State {
        TurtleFrame frame;
        double width = 0; // Diameter in turtle units.
        double scale = 1;
        double elasticity = 0; // Of the older tropism.
        std::uint8_t color = 0;
        bool is_cylinder = false; // Between @Gs and @Ge.
        Drawing::Place place;
    };
    struct Start {
        State state;
        Elasticities elasticities {};
    };

    // As the view has it.
    Start start() const;

    // From here on draws into `drawing`, beginning as given.
    void begin(Start const& start, Drawing& drawing);

    // Draws modules that are a symbol each and no cut, up to the first that is not or for which
    // `stops` is true. The first stands at `place` in the string (for warnings). Returns how many
    // were drawn and moves `parameters` behind theirs.
    std::size_t draw_single(std::span<KindId const> kinds, float const*& parameters,
                            std::size_t place, std::array<bool, 256> const& stops);

    // Draws the first symbol of `modules`; returns how many modules it had.
    std::size_t draw(Modules const& modules, std::size_t place, bool in_homomorphism);

    // Whether a cut was drawn: the rest of the branch is not to be drawn.
    bool take_cut() { return std::exchange(is_cut_, false); }

    // How a branch begins that is left out here, to be drawn by another turtle.
    Start branch_start() const;
    // Where the turtle is and what it draws with.
    State const& state() const { return state_; }
    // The segment at whose end the turtle is.
    std::uint32_t segment() const { return state_.place.segment; }
    // How many branches were begun since begin() and are open.
    std::size_t depth() const { return stack_.size(); }
    // Whether a branch may be left out: what is open would go on in it.
    bool may_leave_out() const { return polygons_.empty(); }
    // Whether all that was begun since begin() is at its end, as another turtle must find it.
    bool is_complete() const { return stack_.empty() && polygons_.empty() && !has_unpaired_; }

private:
    // One symbol with its parameters.
    struct Symbol {
        std::array<char, 3> name {}; // Filled with 0.
        float const* parameters = nullptr;
        std::size_t count = 0;

        double parameter(std::size_t index, double otherwise) const
        {
            return index < count ? static_cast<double>(parameters[index]) : otherwise;
        }
    };

    struct OpenPolygon {
        std::vector<Vec3> vertices_mm;
        std::uint8_t color = 0;
    };

    bool check(Symbol const& symbol);
    void draw_symbol(Symbol const& symbol);
    void draw_at_symbol(Symbol const& symbol);
    void step(Symbol const& symbol, bool draws, bool sets_vertex);
    void push();
    void pop();
    void close_polygon();
    void set_width(Symbol const& symbol, int sign);
    void set_scale(Symbol const& symbol);
    void enter_subsystem(Symbol const& symbol);
    void leave_subsystem();
    void set_color(Symbol const& symbol, int sign);
    void turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign);
    void set_position(Symbol const& symbol);
    void set_frame(Symbol const& symbol);
    void set_elasticity(Symbol const& symbol);
    void add_organ(char letter, Symbol const& symbol);
    void add_round(OrganShape::Kind kind, Symbol const& symbol);
    std::size_t tropism_count() const;
    float radius_mm() const;
    void warn(std::string warning);

    Model const& model_;
    View const& view_;
    TurtleOptions const& options_;
    std::array<bool, 256> is_single_ {}; // Kinds that are a symbol by themselves, and no cut.
    std::array<char, 256> symbols_ {};
    std::array<std::uint8_t, 256> parameter_counts_ {};
    AngleCache angles_;

    Drawing* drawing_ = nullptr; // Not owned.
    State state_;
    Elasticities elasticities_ {};
    std::vector<State> stack_;
    std::vector<Elasticities> elasticity_stack_; // Used if there are tropisms.
    std::vector<OpenPolygon> polygons_;
    std::vector<double> call_scales_; // Of the calls of sub-L-systems that are open.
    std::size_t place_ = 0;
    bool is_cut_ = false;
    bool has_unpaired_ = false; // A ] or } without its beginning.
};

} // namespace tractus
