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

// Derivation of a grammar: a leaf's veins as a 2-G-map of faces, and its limb between them.
//
// The frame of the first face is x along it, y to its left and z out of its upper side; the middle
// of its edge O is the origin. Lengths are the grammar's.
class Leaf {
public:
    // How the blade stands in space besides what its grammar says: in degrees, each spread over the
    // veins by their share of the outline's length. Without an outline it changes nothing.
    struct Pose {
        double bend_deg = 0;   // Downwards along main veins.
        double curl_deg = 0;   // Upwards along the veins on their sides.
        double twist_deg = 0;  // About main veins.
        double uneven_deg = 0; // Standard deviation of each side vein's own twist.

        bool operator==(Pose const&) const = default;
    };

    struct Options {
        int final_step = 0; // Value that the grammar reads as `finalstep`.
        double age = 1;     // Value that it reads as `age`, 0 to 1.
        std::uint64_t seed = 1;
        // How far the outline differs from the grammar's: 1 as leaves of a tree do, 0 not at all.
        // The grammar reads it as `variation`.
        double variation = 1;
        Pose pose {};
    };

    // More faces than that are refused.
    static constexpr std::size_t kMostFaces = 100'000;

    // Step 0: the axiom's face. `grammar` must outlive this. Fails, as the user's fault, where an
    // attribute is out of its range; the text is the grammar's file and line.
    static Result<Leaf> begin(Grammar const& grammar, Options const& options);

    // One step: each face that stands takes the first rule that fits, in the order in which they
    // were made; then edges are glued. Takes the limb away first. Fails like begin(), and where the
    // leaf grows beyond all measure.
    Result<void> derive();

    // Fills the limb between the veins: a face between each free extremity and the next. Where the
    // way between them bulges out it is filled in parts. Fails, as the user's fault, where that
    // takes too long.
    Result<void> fill();

    int step() const { return step_; }
    LeafMap const& map() const { return map_; }
    // Numbers of the veins' faces, by their letters.
    std::map<char, std::size_t> face_counts() const;
    // Edges E on the border: vein tips, from which more may grow.
    std::size_t free_extremities() const;
    double variable(std::size_t name) const { return values_[name]; }

    struct Limb {
        std::vector<int> sizes; // Edges of each face, in order of size.
        int cuts = 0;           // Ways that were filled in parts, once for each cut.
    };
    Limb const& limb() const { return limb_; }

    // A vein in the flat leaf, as one of its faces: along its middle, and half its width, in the
    // grammar's lengths.
    struct Vein {
        Vec2 from = Vec2::Zero();
        Vec2 to = Vec2::Zero();
        double half_width_from = 0;
        double half_width_to = 0;
        int order = 1; // 1: main veins; one more where a vein leaves another's side.
    };
    std::vector<Vein> veins() const;
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
        Dart first = 0;       // Starts an edge; of one that was not split, its O.
        int edge_count = 0;   // Edges as made: neighbours that are split may add to them.
        bool is_part = false; // Part of one that was split: it may lack edges.
        int order = 1;        // Order as a vein.
        std::size_t blade = 0;
    };
    // Where an outline lies in the flat leaf: it begins at a stalk's end.
    struct Blade {
        Vec2 base = Vec2::Zero();
        Vec2 axis = Vec2::UnitY(); // The outline's y.
        double scale = 1;

        Vec2 to_outline(Vec2 const& flat) const;
        Vec2 to_flat(Vec2 const& on_outline) const;
    };
    // A child's place on its parent: the way across the edge's end.
    struct Stand {
        Frame frame;
        Vec3 left = Vec3::Zero();  // Left side of the edge O: where it starts,
        Vec3 right = Vec3::Zero(); // and ends.
    };

    Leaf(Grammar const& grammar, Options const& options);

    tl::unexpected<Error> fail_at(TextPlace const& place, std::string const& what) const;
    Result<Attributes> attributes_of(char face, Fields const& fields, TextPlace const& place);
    // Shape as it grows, or as if it neither bent nor twisted.
    enum class Shape { Grown, Flat };
    Vec3 place_of(Dart d, Shape shape) const;
    Stand stand_on(Dart edge, Shape shape) const;
    Stand stand_for(Attributes const& attributes, std::optional<Dart> on, Shape shape) const;
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
    Result<void> fill_way(std::vector<Dart> const& way);
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
    std::vector<double> values_; // Indexed by names' numbers; NaN where nothing has given one.
    // Variables that a face's attributes of the same names hide while a rule is at work.
    std::map<std::size_t, double> hidden_;
    Random random_;
    Outline outline_;
    Pose pose_;
    Random unevenness_; // Its own, so that a pose changes nothing in the flat leaf.
    std::vector<Blade> blades_;
    int step_ = 0;
    std::size_t work_ = 0;                  // Work so far, in darts looked at.
    std::optional<std::size_t> limb_begin_; // The first of its darts, if it is filled.
    FaceId limb_faces_ = 0;
    Limb limb_;
};

} // namespace tractus::leaf
