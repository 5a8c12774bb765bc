#pragma once

#include "engine/lsystem/language/turtle_symbols.h"
#include "engine/lsystem/rewriting/rewriter.h"
#include "engine/lsystem/turtle/cylinder.h"
#include "engine/lsystem/turtle/turtle_drawing.h"
#include "engine/lsystem/turtle/turtle_frame.h"
#include "engine/lsystem/turtle/turtle_options.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus::lsystem {

// Returns true if the model's strings may contain symbols for tropisms or for the appearance of
// generalised cylinders.
bool uses_turtle_extras(Model const& model);
// Returns true if the model's strings may define surfaces by points of the turtle. Such surfaces
// are numbered in drawing order.
bool uses_patches(Model const& model);

// Interprets the symbols of a string one after another and draws into a TurtleDrawing.
// fast_drawing/interpret.h describes the effect of each symbol.
class Turtle {
public:
    // The arguments must outlive the turtle.
    Turtle(Model const& model, TurtleOptions const& options);

    // The state that an opening bracket saves.
    struct State {
        TurtleFrame frame;
        double width = 0; // Line width, a diameter in turtle units.
        double scale = 1;
        double elasticity = 0; // Elasticity of the older kind of tropism.
        std::uint8_t color = 0;
        // Which symbols set control points of an open generalised cylinder: OfSteps: steps and
        // dots; OfSymbols: @Gc and dots; None: no cylinder is open.
        enum class Path : std::uint8_t { None, OfSteps, OfSymbols };
        Path path = Path::None;
        TurtleDrawing::Place place;
    };
    // Further state that an opening bracket saves, if the model uses any of it.
    struct Extras {
        Elasticities elasticities {};
        // Frame from which parallel transport carries the sides when a tropism bends the heading.
        TurtleFrame carried;
        CylinderStyle style;
    };
    struct Start {
        State state;
        Extras extras;
    };

    // Returns the initial state that the view specifies.
    Start start() const;

    // Sets the turtle states with which %(x,i) continues. They must outlive the drawing.
    void set_kept(std::span<CutTurtle const> turtles) { kept_ = turtles; }
    // Returns the current state, for a %(x) to store.
    CutTurtle kept() const;

    // Sets the state; from now on draws into `drawing`.
    void begin(Start const& start, TurtleDrawing& drawing);

    // Draws modules up to the first one for which `stops` is true, or that is a cut or begins any
    // symbol of several modules but an @-symbol. All parameters must be finite. `place` is the
    // index in the string of the first module, for warnings. Returns the number of modules drawn,
    // and advances `parameters` past theirs.
    std::size_t draw_plain(std::span<KindId const> kinds, float const*& parameters,
                           std::size_t place, std::array<bool, 256> const& stops);

    // Draws the first symbol of `modules`. Returns the number of modules of that symbol.
    std::size_t draw(Modules const& modules, std::size_t place, bool in_homomorphism);

    // Returns true if a cut was drawn since the last call. The caller must then skip the rest of
    // the branch.
    bool take_cut() { return std::exchange(is_cut_, false); }

    // Returns the initial state of a branch that begins here and that another turtle will draw.
    Start branch_start() const;
    // Returns the current frame, width, scale, colour and place.
    State const& state() const { return state_; }
    // Discards the drawing, for callers that need only the turtle's state.
    void drop_drawing();
    // Returns the segment at whose end the turtle is.
    std::uint32_t segment() const { return state_.place.segment; }
    // Returns the number of brackets that have been opened since begin() and not closed.
    std::size_t depth() const { return depth_; }
    // Returns true if a branch that begins here may be left to another turtle: no polygon or
    // cylinder is open that would continue in it.
    bool may_skip_branch() const { return polygons_.empty() && state_.path == State::Path::None; }
    // Returns true if all brackets and polygons that have begun since begin() have ended, so that
    // another turtle could continue.
    bool is_complete() const { return depth_ == 0 && polygons_.empty() && !has_unpaired_; }

private:
    static constexpr double kMinWidth = 1e-7; // Minimum line width, as in cpfg.
    static constexpr double kMaxReachMm = 1e12;

    // A symbol with its parameters.
    struct Symbol {
        std::array<char, 3> name {}; // Characters of the symbol, padded with 0.
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

    // A generalised cylinder that is being drawn, and the place at which it continues.
    struct OpenCylinder {
        Cylinder cylinder;
        TurtleDrawing::Place place;
        bool is_round = true; // True if the axis at `place` has round sections.
    };

    // A surface whose points @PC sets.
    struct OpenPatch {
        PatchBasis basis = PatchBasis::Bezier;
        std::array<Vec3, 16> control;
        std::uint32_t given = 0; // Bit set of the points that have been set so far.
    };

    // Groups of symbols as draw_quick() distinguishes them.
    enum class Quick : std::uint8_t {
        Other, // A symbol that draw_quick() does not handle.
        Nothing,
        Step,
        Turn,
        Pitch,
        Roll,
        Push,
        Pop,
        Width,
        Level // An @, which draw_quick() handles only if a v follows, as in the symbol @v.
    };
    struct Kind {
        char symbol = 0;
        std::uint8_t parameter_count = 0;
        bool is_single = false; // True for a symbol of one character that is not a cut.
        bool draws = false; // True for a step that draws a segment, not for one that only moves.
        Quick quick = Quick::Other;
        double sign = 1; // Sign of a turn or of a change of width: 1 or -1.
    };

    static Quick quick_case(SymbolAction does);
    static Kind describe(ModuleKind const& kind);
    bool check(Symbol const& symbol);
    // Functions defined in turtle_plain.cpp.
    std::size_t name_at_symbol(std::span<KindId const> kinds, Symbol& symbol) const;
    // Returns true if a step only moves the turtle or draws a segment, without bending or adding
    // control points.
    static bool is_quick(State const& state)
    {
        return state.elasticity == 0 && state.path == State::Path::None;
    }
    std::size_t draw_quick(std::span<KindId const> kinds, float const*& parameters,
                           std::array<bool, 256> const& stops);
    // Takes a step and returns true. If the step leads beyond kMaxReachMm, returns false and
    // changes nothing.
    bool step_quickly(State& state, double length_mm, bool draws)
    {
        Vec3 const base_mm = state.frame.position_mm;
        Vec3 const tip_mm = base_mm + length_mm * state.frame.heading;
        if (!(tip_mm.cwiseAbs().maxCoeff() < kMaxReachMm))
            return false;
        if (length_mm == 0)
            return true;
        state.frame.position_mm = tip_mm;
        if (draws)
            drawing_->add_segment(state.place, base_mm, tip_mm, radius_mm(state), state.color);
        else
            state.place.is_open = false;
        return true;
    }
    // Restores the saved state and returns true. If draw_quick() cannot continue with that state,
    // returns false and changes nothing.
    bool restore_quickly(State& state)
    {
        if (depth_ == 0 || !is_quick(stack_[depth_ - 1]))
            return false;
        state = stack_[--depth_];
        return true;
    }
    void save(State const& state)
    {
        if (depth_ == stack_.size())
            stack_.resize(2 * depth_ + 16);
        stack_[depth_++] = state;
    }
    void draw_symbol(Symbol const& symbol);
    void draw_at_symbol(Symbol const& symbol);
    void step(Symbol const& symbol);
    void push();
    void pop();
    void close_polygon();
    // Sets the width to `value` if the symbol has a parameter; otherwise changes it by `value`
    // steps.
    void set_width(State& state, bool is_given, double value)
    {
        double const change = value * view_.line_width_step * state.scale;
        double const width = is_given ? value * state.scale : state.width + change;
        state.width = std::clamp(width, kMinWidth, 1e6);
        drawing_->set_tip_radius(state.place, radius_mm(state));
    }
    void set_scale(Symbol const& symbol);
    void enter_subsystem(Symbol const& symbol);
    void leave_subsystem();
    void go_on_with(Symbol const& symbol);
    void set_color(Symbol const& symbol, int sign);
    void turn(Vec3& a, Vec3& b, Symbol const& symbol, double sign);
    void set_position(Symbol const& symbol);
    void set_frame(Symbol const& symbol);
    void set_elasticity(Symbol const& symbol);
    void draw_movement_symbol(Symbol const& symbol);
    // Functions defined in turtle_organs.cpp.
    void add_organ(char letter, Symbol const& symbol);
    void add_round(OrganShape::Kind kind, Symbol const& symbol);
    void add_circle(Symbol const& symbol);
    void draw_patch_symbol(Symbol const& symbol);
    void add_patch(OpenPatch const& patch);
    double diameter(Symbol const& symbol) const;
    // Functions defined in turtle_cylinder.cpp.
    void begin_path(Symbol const& symbol);
    void end_path();
    void add_dot(Symbol const& symbol);
    void draw_cylinder_symbol(Symbol const& symbol);
    void begin_cylinder(Cylinder::Path path, int rings);
    void add_control_point(int rings);
    void draw_piece(Cylinder::Piece const& piece);
    void set_contour(Symbol const& symbol);
    void set_sides(Symbol const& symbol);
    void set_radius_tangents(Symbol const& symbol);
    std::size_t tropism_count() const;
    float radius_mm(State const& state) const
    {
        double const width = state.width * view_.width_unit;
        return static_cast<float>(std::min(width * options_.unit_mm / 2, 1e6));
    }
    void warn(std::string warning);

    Model const& model_;
    View const& view_;
    TurtleOptions const& options_;
    std::array<Kind, 256> kinds_ {};
    AngleCache angles_;

    TurtleDrawing* drawing_ = nullptr; // Not owned.
    State state_;
    Extras extras_;
    bool has_extras_ = false;
    std::vector<State> stack_; // Saved states; the first depth_ of them are in use.
    std::size_t depth_ = 0;
    std::vector<Extras> extras_stack_; // Saved extras; only used if the model has extras.
    std::vector<OpenPolygon> polygons_;
    std::span<CutTurtle const> kept_;
    // Scales of the open calls of sub-L-systems, the innermost last.
    std::vector<double> call_scales_;
    OpenCylinder cylinder_; // The open cylinder; only valid while state_.path is not None.
    std::vector<OpenCylinder> cylinder_stack_;
    std::map<float, OpenPatch> patches_;
    std::map<std::array<std::int32_t, 48>, std::uint32_t> patch_numbers_;
    std::map<std::pair<std::uint32_t, std::uint8_t>, OrganShapeId> patch_shapes_;
    std::size_t place_ = 0;
    bool is_cut_ = false;
    bool has_unpaired_ = false; // True after a ] or } whose opening symbol is missing.
};

} // namespace tractus::lsystem
