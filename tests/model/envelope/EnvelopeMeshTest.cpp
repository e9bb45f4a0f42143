// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/EnvelopeMesh.h"

#include "tests/model/envelope/Silhouettes.h"
#include "tests/support/MeshTopology.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class EnvelopeMeshTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mesh_isClosed();
    void mesh_hasTheVolumeOfTheEnvelope();
    void mesh_followsTheSmoothOutline();
    void normals_areUnitAndPointOut();
    void normals_ofABallAreRadial();
    void thinParts_leaveAMesh();
};

namespace {

Envelope envelopeOf(const std::vector<Points>& strokes)
{
    std::vector<LassoStroke> lasso;
    for (const Points& points : strokes)
        lasso.push_back({.origin = {3, 4, 5}, .right = {0, 0, -1}, .up = {0, 1, 0}, .points = points});
    Result<Envelope> envelope = Envelope::fromStrokes(lasso);
    if (!envelope)
        qFatal("%s", qPrintable(envelope.error().message));
    return *envelope;
}

MeshTopology topology(const EnvelopeMesh& mesh)
{
    std::vector<MeshVertex> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i].position = toArray(mesh.positions[i]);
    return topologyOf(vertices, mesh.triangles);
}

struct Case {
    std::vector<Points> strokes;
    int eulerCharacteristic;
};

std::vector<Case> cases()
{
    return {{{circle(2.0)}, 2},
            {{heart()}, 2},
            {{swan()}, 2},
            {{letterE()}, 2},
            {{letterA(), letterAHole()}, 0},
            {{circle(2.0), circle(0.5, -1.0), circle(0.5, 1.0)}, -2},
            {{circle(1.0), circle(1.0, 5.0)}, 4},
            {{circle(2.0), circle(1.2), circle(0.4)}, 2}};
}

} // namespace

void EnvelopeMeshTest::mesh_isClosed()
{
    for (const Case& one : cases()) {
        const Envelope envelope = envelopeOf(one.strokes);
        for (const int stride : {1, 2, 3, 4}) {
            const MeshTopology found = topology(envelopeMesh(envelope, stride));
            QCOMPARE(found.openEdges, 0);
            QCOMPARE(found.nonManifoldEdges, 0);
            QCOMPARE(found.degenerateTriangles, 0);
            QCOMPARE(found.eulerCharacteristic, one.eulerCharacteristic);
        }
    }
}

void EnvelopeMeshTest::mesh_hasTheVolumeOfTheEnvelope()
{
    for (const Case& one : cases()) {
        const Envelope envelope = envelopeOf(one.strokes);
        const EnvelopeMesh mesh = envelopeMesh(envelope);
        double volume = 0.0;
        const auto corner = [&](std::size_t i) {
            return Eigen::Vector3d((mesh.positions[mesh.triangles[i]] - Vec3(3, 4, 5)).cast<double>());
        };
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            volume += corner(i).dot(corner(i + 1).cross(corner(i + 2))) / 6.0;
        QVERIFY2(std::abs(volume / envelope.volume() - 1.0) < 0.02,
                 qPrintable(QString::number(volume / envelope.volume())));
    }
}

void EnvelopeMeshTest::mesh_followsTheSmoothOutline()
{
    const Envelope envelope = envelopeOf({circle(2.0, 0.0, 0.0, 1000)});
    double worst = 0.0;
    int onOutline = 0;
    const EnvelopeMesh mesh = envelopeMesh(envelope);
    for (const Vec3& position : mesh.positions) {
        const Vec3 offset = position - Vec3(3, 4, 5);
        if (std::abs(offset.x()) > 1e-6F)
            continue;
        ++onOutline;
        worst = std::max(worst, std::abs(double{offset.norm()} - 2.0) / envelope.spacing());
    }
    qInfo("%d vertices on the outline, at most %.3f nodes off", onOutline, worst);
    QVERIFY(onOutline > 300);
    QVERIFY(worst < 0.25);
}

void EnvelopeMeshTest::normals_areUnitAndPointOut()
{
    for (const Case& one : cases()) {
        const EnvelopeMesh mesh = envelopeMesh(envelopeOf(one.strokes));
        QCOMPARE(mesh.normals.size(), mesh.positions.size());
        for (const Vec3& normal : mesh.normals)
            QVERIFY(std::abs(normal.norm() - 1.0F) < 1e-4F);
        double area = 0.0;
        double agreeing = 0.0;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            const Vec3& a = mesh.positions[mesh.triangles[i]];
            const Vec3 flat =
                (mesh.positions[mesh.triangles[i + 1]] - a).cross(mesh.positions[mesh.triangles[i + 2]] - a);
            for (std::size_t j = 0; j < 3; ++j) {
                area += double{flat.norm()};
                if (flat.normalized().dot(mesh.normals[mesh.triangles[i + j]]) > 0.7F)
                    agreeing += double{flat.norm()};
            }
        }
        QVERIFY2(agreeing / area > 0.97, qPrintable(QString::number(agreeing / area)));
    }
}

void EnvelopeMeshTest::normals_ofABallAreRadial()
{
    const EnvelopeMesh mesh = envelopeMesh(envelopeOf({circle(2.0)}));
    double worst = 1.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        worst =
            std::min(worst, double{mesh.normals[i].dot((mesh.positions[i] - Vec3(3, 4, 5)).normalized())});
    qInfo("normals of a ball are at most %.1f degrees off", degrees(std::acos(worst)));
    QVERIFY(worst > std::cos(radians(8.0)));
}

void EnvelopeMeshTest::thinParts_leaveAMesh()
{
    // A bar two nodes thick, along a line that a stride of 8 steps over.
    const EnvelopeMesh mesh = envelopeMesh(envelopeOf({{{0, 0}, {128, 0}, {128, 1}, {0, 1}}}), 8);
    QVERIFY(!mesh.triangles.empty());
    QVERIFY(topology(mesh).isClosedManifold());
}

const TestClass<EnvelopeMeshTest> envelopeMeshTest;

} // namespace espalier::test

#include "EnvelopeMeshTest.moc"
