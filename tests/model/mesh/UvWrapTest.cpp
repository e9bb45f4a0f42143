// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/UvWrap.h"

#include "model/mesh/BranchMesher.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

namespace {

/// A straight trunk whose v rises far.
TriangleMesh longTrunk()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 1500, continuing(), 0.02F);
    const Widths widths(builder.tree, builder.index);
    return meshBranches(builder.tree, builder.index, widths);
}

float greatestV(const TriangleMesh& mesh)
{
    float greatest = 0.0F;
    for (const MeshVertex& vertex : mesh.vertices)
        greatest = std::max(greatest, std::abs(vertex.uv[1]));
    return greatest;
}

} // namespace

class UvWrapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void longAxis_keepsSmallV();
    void triangles_moveByWholeRepeatsAndStayOtherwise();
    void smallCoordinates_stayAsTheyAre();
    void highTriangle_isCentred();
};

void UvWrapTest::longAxis_keepsSmallV()
{
    const TriangleMesh trunk = longTrunk();
    QVERIFY(greatestV(trunk) > 40.0F);
    const TriangleMesh wrapped = withSmallV(trunk);
    QVERIFY2(greatestV(wrapped) <= kGreatestV, qPrintable(QString::number(greatestV(wrapped))));
    // Only the rings at which v starts again are doubled.
    QVERIFY(wrapped.vertices.size() < trunk.vertices.size() * 5 / 4);
}

void UvWrapTest::triangles_moveByWholeRepeatsAndStayOtherwise()
{
    const TriangleMesh trunk = longTrunk();
    const TriangleMesh wrapped = withSmallV(trunk);
    QCOMPARE(wrapped.indices.size(), trunk.indices.size());
    for (std::size_t i = 0; i < trunk.indices.size(); i += 3) {
        const float moved =
            trunk.vertices[trunk.indices[i]].uv[1] - wrapped.vertices[wrapped.indices[i]].uv[1];
        QVERIFY(std::abs(moved - std::round(moved)) < 1e-4F);
        for (std::size_t j = i; j < i + 3; ++j) {
            MeshVertex before = trunk.vertices[trunk.indices[j]];
            const MeshVertex& after = wrapped.vertices[wrapped.indices[j]];
            QVERIFY(std::abs(before.uv[1] - after.uv[1] - moved) < 1e-4F);
            before.uv[1] = after.uv[1];
            QVERIFY(before == after);
        }
    }
}

void UvWrapTest::smallCoordinates_stayAsTheyAre()
{
    TriangleMesh mesh;
    for (const float v : {0.0F, 0.5F, 1.0F, 7.9F})
        mesh.vertices.push_back(
            {.position = {v, 0, 0}, .normal = {0, 1, 0}, .tangent = {1, 0, 0, 1}, .uv = {0, v}});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const TriangleMesh wrapped = withSmallV(mesh);
    QVERIFY(wrapped.vertices == mesh.vertices);
    QVERIFY(wrapped.indices == mesh.indices);
}

void UvWrapTest::highTriangle_isCentred()
{
    TriangleMesh mesh;
    for (const float v : {100.25F, 120.25F, 110.25F})
        mesh.vertices.push_back(
            {.position = {v, 0, 0}, .normal = {0, 1, 0}, .tangent = {1, 0, 0, 1}, .uv = {0, v}});
    mesh.indices = {0, 1, 2};
    const TriangleMesh wrapped = withSmallV(mesh);
    QCOMPARE(wrapped.vertices[0].uv[1], -9.75F);
    QCOMPARE(wrapped.vertices[1].uv[1], 10.25F);
}

static const TestClass<UvWrapTest> uvWrapTest;

} // namespace espalier::test

#include "UvWrapTest.moc"
