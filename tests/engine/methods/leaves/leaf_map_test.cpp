#include "engine/methods/leaves/leaf_map.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::leaf {
namespace {

Dart add_polygon(LeafMap& map, int edges, FaceId face)
{
    std::vector<Vertex> corners;
    for (int i = 0; i < edges; ++i)
        corners.push_back(map.add_vertex({ std::cos(i), std::sin(i), 0.0 }));
    return map.add_face(corners, face, edge_labels(edges));
}

TEST(LeafMapLabels, ASideIsNumberedFromTheOrigin)
{
    using enum EdgeLabel;
    EXPECT_EQ(edge_labels(3), (std::vector { Origin, side_label(1), Extremity }));
    EXPECT_EQ(edge_labels(4), (std::vector { Origin, side_label(1), Extremity, side_label(2) }));
    EXPECT_EQ(edge_labels(6),
              (std::vector { Origin, side_label(1), side_label(2), Extremity, side_label(3),
                             side_label(4) }));
    for (int edges = 3; edges < 20; ++edges)
        EXPECT_EQ(edge_labels(edges).size(), static_cast<std::size_t>(edges));
    EXPECT_TRUE(has_edge(6, side_label(4)));
    EXPECT_FALSE(has_edge(6, side_label(5)));
    EXPECT_TRUE(has_edge(3, Extremity));
}

TEST(LeafMap, APolygonHasTwoDartsToAnEdge)
{
    for (int edges = 3; edges < 9; ++edges) {
        LeafMap map;
        auto const first = add_polygon(map, edges, 0);
        auto const counts = map.counts();
        auto const n = static_cast<std::size_t>(edges);
        EXPECT_EQ(counts.darts, 2 * n);
        EXPECT_EQ(counts.vertices, n);
        EXPECT_EQ(counts.edges, n);
        EXPECT_EQ(counts.faces, 1U);
        EXPECT_EQ(counts.triangles, n - 2);
        EXPECT_EQ(counts.border_edges, n);
        EXPECT_EQ(counts.euler_characteristic(), 1);
        EXPECT_EQ(map.cycle(first).size(), n);
        EXPECT_EQ(map.fault(), "");
    }
}

TEST(LeafMap, SewingJoinsAnEdgeAndItsVertices)
{
    LeafMap map;
    auto const pentagon = add_polygon(map, 5, 0);
    auto const quad = add_polygon(map, 4, 1);
    EXPECT_EQ(map.counts().components, 2U);
    EXPECT_EQ(map.counts().euler_characteristic(), 2);

    map.sew(LeafMap::a0(pentagon), quad);
    auto const counts = map.counts();
    EXPECT_EQ(counts.darts, 18U);
    EXPECT_EQ(counts.vertices, 7U);
    EXPECT_EQ(counts.edges, 8U);
    EXPECT_EQ(counts.components, 1U);
    EXPECT_EQ(counts.border_edges, 7U);
    EXPECT_EQ(counts.euler_characteristic(), 1);
    EXPECT_EQ(map.fault(), "");
}

TEST(LeafMap, AVertexInASewnEdgeTakesFourDartsAndInAFreeOneTwo)
{
    LeafMap map;
    auto const pentagon = add_polygon(map, 5, 0);
    auto const quad = add_polygon(map, 4, 1);
    map.sew(LeafMap::a0(pentagon), quad);

    map.insert_vertex(pentagon, 0.5);
    EXPECT_EQ(map.counts().darts, 22U);
    EXPECT_EQ(map.counts().vertices, 8U);
    EXPECT_EQ(map.counts().edges, 9U);
    EXPECT_EQ(map.fault(), "");

    map.insert_vertex(pentagon + 4, 0.5);
    EXPECT_EQ(map.counts().darts, 24U);
    EXPECT_EQ(map.counts().vertices, 9U);
    EXPECT_EQ(map.counts().edges, 10U);
    EXPECT_EQ(map.counts().euler_characteristic(), 1);
    EXPECT_EQ(map.fault(), "");
}

TEST(LeafMap, AVertexLiesAtItsShareOfTheEdge)
{
    LeafMap map;
    auto const first = add_polygon(map, 4, 0);
    Vec3 const from = map.position_of(first);
    Vec3 const to = map.position_of(LeafMap::a0(first));
    auto const across = map.insert_vertex(first, 0.25);
    EXPECT_LT((map.position_of(across) - (from + 0.25 * (to - from))).norm(), 1e-12);
    EXPECT_EQ(map.position_of(first), from);
}

TEST(LeafMap, UnsewingPartsAgain)
{
    LeafMap map;
    auto const pentagon = add_polygon(map, 5, 0);
    auto const quad = add_polygon(map, 4, 1);
    map.sew(LeafMap::a0(pentagon), quad);
    map.unsew(pentagon);
    EXPECT_EQ(map.counts().components, 2U);
    EXPECT_EQ(map.counts().edges, 9U);
    EXPECT_EQ(map.fault(), "");
}

TEST(LeafMap, AnEdgeInAFaceMakesTwo)
{
    LeafMap map;
    auto const first = add_polygon(map, 6, 0);
    auto const edges = map.cycle(first);
    map.insert_edge(LeafMap::a0(edges[0]), LeafMap::a0(edges[3]), 1, EdgeLabel::Extremity,
                    EdgeLabel::Origin);
    auto const counts = map.counts();
    EXPECT_EQ(counts.darts, 16U);
    EXPECT_EQ(counts.vertices, 6U);
    EXPECT_EQ(counts.edges, 7U);
    EXPECT_EQ(counts.faces, 2U);
    EXPECT_EQ(counts.triangles, 4U);
    EXPECT_EQ(counts.euler_characteristic(), 1);
    EXPECT_EQ(map.fault(), "");
}

TEST(LeafMap, TheBorderIsOneWayRound)
{
    LeafMap map;
    auto const pentagon = add_polygon(map, 5, 0);
    auto const quad = add_polygon(map, 4, 1);
    map.sew(LeafMap::a0(pentagon), quad);
    auto const border = map.border(pentagon + 2);
    EXPECT_EQ(border.size(), 7U);
    for (std::size_t i = 0; i < border.size(); ++i)
        EXPECT_EQ(map.vertex(LeafMap::a0(border[i])), map.vertex(border[(i + 1) % border.size()]));
}

TEST(LeafMap, WhatWasAddedLastIsTakenAway)
{
    LeafMap map;
    auto const pentagon = add_polygon(map, 5, 0);
    auto const before = map.dart_count();
    auto const quad = add_polygon(map, 4, 1);
    map.sew_in_place(LeafMap::a0(pentagon), quad);
    map.truncate(before);
    EXPECT_EQ(map.counts().darts, 10U);
    EXPECT_EQ(map.counts().border_edges, 5U);
    EXPECT_EQ(map.fault(), "");
}

} // namespace
} // namespace tractus::leaf
