#pragma once

#include "engine/base/random.h"
#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_grammar.h"
#include "engine/methods/leaves/leaf_map.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tractus::leaf {

// A leaf during the derivation of a grammar: its veins as a 2-G-map of faces (LeafMap), and the
// limb between them. The x axis points along the first face, y to its left and z out of its upper
// side; the origin is the middle of the first face's edge O. Lengths are in the grammar's unit.
class Leaf {
public:
    // Additional deformation of the blade in space, angles in degrees. Bend, curl and twist are the
    // totals over a vein as long as the blade; a shorter vein gets a share in proportion to its
    // length. Without an outline a pose has no effect.
    struct Pose {
        double bend_deg = 0;  // Downward bend along main veins.
        double curl_deg = 0;  // Upward curl along side veins.
        double twist_deg = 0; // Twist about main veins.
        // Standard deviation of the twist that each side vein has of its own.
        double uneven_deg = 0;

        bool operator==(Pose const&) const = default;
    };

    struct Options {
        int final_step = 0; // Value of `finalstep` in the grammar.
        double age = 1;     // Value of `age` in the grammar, 0 to 1.
        std::uint64_t seed = 1;
        // Scale of the random variation of the outline, and value of `variation` in the grammar: 0
        // gives no variation, 1 that between the leaves of a tree.
        double variation = 1;
        Pose pose {};
    };

    // Maximum number of faces of a leaf; derivation fails beyond it.
    static constexpr std::size_t kMaxFaces = 100'000;

    // Begins the derivation: step 0 is the axiom's face. `grammar` must outlive the leaf. Fails
    // with a user error, with file and line of the grammar, if an attribute is out of range.
    static Result<Leaf> begin(Grammar const& grammar, Options const& options);

    // Performs one derivation step: removes the limb, applies to each face, in order of creation,
    // the first rule that matches, and then glues edges. Fails like begin(), or if the leaf grows
    // too large.
    Result<void> derive();

    // Fills the limb: adds a face between each vein tip (free extremity) and the next one along the
    // border. Where the border between two tips bulges outwards, several faces are added. Fails
    // with a user error if the work exceeds a limit.
    Result<void> fill();

    int step() const { return step_; }
    LeafMap const& map() const { return map_; }
    // True for a face to which no limb is attached (Grammar::bare).
    bool is_bare(FaceId face) const;
    // Number of vein faces for each face letter.
    std::map<char, std::size_t> face_counts() const;
    // Number of edges E on the border: vein tips on which more faces can grow.
    std::size_t free_extremities() const;
    double variable(std::size_t name) const { return values_[name]; }

    struct Limb {
        std::vector<int> sizes; // Number of edges of each limb face, in ascending order.
        int cuts = 0;           // Number of places where the border between two tips was divided.
    };
    Limb const& limb() const { return limb_; }

    // A face of a vein in the flat leaf: its centre line and half its width, in the grammar's unit.
    struct Vein {
        Vec2 from = Vec2::Zero();
        Vec2 to = Vec2::Zero();
        double half_width_from = 0;
        double half_width_to = 0;
        // Order of the vein: 1 for a main vein; otherwise one more than that of the vein on whose
        // side it begins.
        int order = 1;
    };
    std::vector<Vein> veins() const;

    // The axis of a blade in the flat leaf, from the end of its stalk to the tip of its outline.
    struct Midrib {
        Vec2 from = Vec2::Zero();
        Vec2 to = Vec2::Zero();
    };
    // The axes of all blades that veins grow in: one, or one for each leaflet. Empty if the grammar
    // has no outline.
    std::vector<Midrib> midribs() const;
    Outline const& outline() const { return outline_; }

private:
    struct Frame {
        Vec3 x = Vec3::UnitX();
        Vec3 y = Vec3::UnitY();
        Vec3 z = Vec3::UnitZ();

        void turn(double alpha_deg, double beta_deg, double gamma_deg);
    };
    struct Face {
        char name = 'A';
        Attributes attributes {};
        Frame frame;
        // Start dart of one of the face's edges: of edge O, unless the face was split.
        Dart first = 0;
        // Number of the face's edges when it was made; splitting neighbours can add more.
        int edge_count = 0;
        bool is_part = false; // True for a part of a split face, which may lack some edges.
        int order = 1;        // Branching order of the vein to which the face belongs.
        std::size_t blade = 0;
    };
    // Position in the flat leaf of a blade's outline, which begins at the end of a petiole.
    struct Blade {
        Vec2 base = Vec2::Zero();
        Vec2 axis = Vec2::UnitY(); // Direction of the outline's y axis.
        double scale = 1;

        Vec2 to_outline(Vec2 const& flat) const;
        Vec2 to_flat(Vec2 const& on_outline) const;
    };
    // Place where a child face is attached to its parent: the child's frame and the ends of the
    // shared edge.
    struct Stand {
        Frame frame;
        Vec3 left = Vec3::Zero();  // Left end of the child's edge O, at which the edge starts.
        Vec3 right = Vec3::Zero(); // Right end of the child's edge O.
    };

    Leaf(Grammar const& grammar, Options const& options);

    tl::unexpected<Error> fail_at(TextPlace const& place, std::string const& what) const;
    Result<Attributes> attributes_of(char face, Fields const& fields, TextPlace const& place);
    // Shape of the leaf: Grown includes bending and twisting, Flat does not.
    enum class Shape { Grown, Flat };
    Vec3 place_of(Dart d, Shape shape) const;
    Stand stand_on(Dart edge, Shape shape) const;
    Stand attachment_for(Attributes const& attributes, std::optional<Dart> on, Shape shape) const;
    Result<FaceId> make_face(char name, Fields const& fields, std::optional<Dart> on,
                             TextPlace const& place);
    std::vector<Vec3> corners_of(Attributes const& attributes, Stand const& stand) const;
    std::optional<Dart> free_edge(FaceId face, EdgeLabel label) const;
    Result<bool> apply(Rule const& rule, FaceId face);
    void run(std::vector<Statement> const& block);
    Result<void> grow(Rule const& rule, Growing const& growing, FaceId face);
    Result<void> grow_children(std::vector<Child> const& children, FaceId parent);
    std::optional<EdgeLabel> opposite(FaceId face, EdgeLabel label) const;
    Dart end_of_first_half(std::vector<Dart> const& chain);
    Result<bool> split(Splitting const& splitting, FaceId face, TextPlace const& place);
    Dart border_start() const;
    Result<void> glue();
    bool glue_one(Gluing const& gluing);
    Result<void> spend(std::size_t work);
    Result<void> fill_along_border(std::vector<Dart> const& way);
    enum class Margin { Outline, Straight };
    void add_limb_face(std::span<Dart const> way, Margin margin);
    bool is_along_outline(std::span<Dart const> way) const;
    void add_margin(std::span<Dart const> way, std::vector<Vertex>& corners,
                    std::vector<EdgeLabel>& labels);
    void remove_limb();
    void begin_blade(FaceId stalk);
    std::size_t blade_on(std::optional<Dart> edge) const;
    void pose(Attributes& attributes, std::optional<Dart> on);
    Result<double> reach(Stand const& start, std::size_t blade);
    std::optional<Vein> vein_of(Face const& face) const;
    int order_on(std::optional<Dart> edge) const;

    Grammar const* grammar_;
    LeafMap map_;
    std::vector<Face> faces_;
    std::vector<double> values_; // Values of the grammar's names by index; NaN: no value yet.
    // Values of variables that are hidden, while a rule is applied, by attributes of the same name.
    std::map<std::size_t, double> hidden_;
    Random random_;
    Outline outline_;
    Pose pose_;
    // Random stream for Pose::uneven_deg. It is separate so that a pose does not change the flat
    // leaf.
    Random unevenness_;
    std::vector<Blade> blades_;
    int step_ = 0;
    std::size_t work_ = 0; // Number of darts visited so far, as a measure of computing time.
    // Index of the first dart of the limb; no value if the limb is not filled.
    std::optional<std::size_t> limb_begin_;
    FaceId limb_faces_ = 0;
    Limb limb_;
};

} // namespace tractus::leaf
