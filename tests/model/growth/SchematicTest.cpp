// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Schematic.h"

#include "tests/support/TestClasses.h"

#include <QTest>

using namespace espalier;

class SchematicTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everySetting_growsInThePlaneWithinBounds();
    void sameParameters_giveTheSameTree();
    void branchingAngle_isThatOfTheDiagram();
    void buds_standOnTheSideThatPhyllotaxisSays();
};

namespace {

/// Direction of an internode, rad from straight up.
double angleBetween(const Schematic& schematic, InternodeId a, InternodeId b)
{
    return std::acos(std::clamp(
        static_cast<double>(schematic.index.heading(a).dot(schematic.index.heading(b))), -1.0, 1.0));
}

} // namespace

void SchematicTest::everySetting_growsInThePlaneWithinBounds()
{
    // Each parameter of growth at either limit.
    TreeParameters parameters;
    std::vector<std::pair<QString, GrowthParameters>> settings{{QString(), parameters.growth}};
    visitParameters(parameters, [&](const ParameterInfo& info, auto& field) {
        if (std::string_view(info.key).substr(0, 7) != "growth.")
            return;
        const auto usual = field;
        for (const double end : {info.minimum, info.maximum}) {
            using Field = std::remove_reference_t<decltype(field)>;
            field = static_cast<Field>(info.quantity == Quantity::Angle ? radians(end) : end);
            GrowthParameters& growth = parameters.growth;
            if (std::abs(growth.ellipseOffset) >= growth.ellipseVertical) // no ellipse around the axis
                growth.ellipseVertical = std::min(3.0, std::abs(growth.ellipseOffset) * 1.1);
            settings.emplace_back(QStringLiteral("%1 %2").arg(QLatin1String(info.key)).arg(end), growth);
            growth.ellipseVertical = 1.0;
        }
        field = usual;
    });
    QVERIFY(settings.size() > 50);
    for (const auto& [name, growth] : settings) {
        const Schematic schematic = growSchematic(growth);
        // Without any apical dominance a seedling's only bud gets nothing.
        QVERIFY2(schematic.tree.size() > 5 || growth.apicalDominance == 0.0, qPrintable(name));
        QVERIFY2(schematic.tree.size() <= kMostOfSchematic + 1, qPrintable(name));
        for (InternodeId id = 0; id < schematic.tree.size(); ++id) {
            const Vec3& node = schematic.index.nodePosition(id);
            QVERIFY(std::isfinite(node.x()) && std::isfinite(node.y()));
            QVERIFY2(std::abs(node.z()) < 1e-3F, qPrintable(name));
        }
    }
}

void SchematicTest::sameParameters_giveTheSameTree()
{
    GrowthParameters growth;
    const Schematic first = growSchematic(growth);
    QVERIFY(first.index.livingCount() > 150);
    QVERIFY(growSchematic(growth).tree == first.tree);
    growth.setPointAngle += radians(1);
    QVERIFY(!(growSchematic(growth).tree == first.tree));
    // Parameters that a diagram does not show leave it unchanged.
    growth = {};
    growth.internodeLength = 0.3;
    growth.irregularity = 1.0;
    QVERIFY(growSchematic(growth).tree == first.tree);
}

void SchematicTest::branchingAngle_isThatOfTheDiagram()
{
    GrowthParameters growth;
    growth.straightening = 0.0;
    growth.axisWeight = 1.0;
    growth.tropismWeight = 0.0;
    growth.spaceWeight = 0.0;
    growth.deflectionAngle = 0.0;
    for (const double psi : {20.0, 60.0, 100.0}) {
        growth.branchingAngle = radians(psi);
        const Schematic schematic = growSchematic(growth);
        int laterals = 0;
        for (InternodeId id = 1; id < schematic.tree.size(); ++id) {
            const double turn = angleBetween(schematic, id, schematic.tree.parent(id));
            const bool isLateral = !schematic.tree.continuesAxis(id);
            laterals += isLateral;
            QVERIFY(std::abs(turn - (isLateral ? radians(psi) : 0.0)) < 1e-3);
        }
        QVERIFY(laterals > 10);
    }
}

void SchematicTest::buds_standOnTheSideThatPhyllotaxisSays()
{
    GrowthParameters growth;
    growth.uprightTrunk = true;
    growth.straightening = 0.0;
    growth.axisWeight = 1.0;
    growth.tropismWeight = 0.0;
    growth.spaceWeight = 0.0;
    const auto sides = [&](double phi) {
        growth.phyllotaxis = radians(phi);
        const Schematic schematic = growSchematic(growth);
        int left = 0;
        int right = 0;
        for (InternodeId id = 1; id < schematic.tree.size(); ++id) {
            if (schematic.tree.continuesAxis(id) || schematic.index.axis(schematic.tree.parent(id)) != 0)
                continue;
            (schematic.index.heading(id).x() < 0.0F ? left : right) += 1;
        }
        return std::pair(left, right);
    };
    const auto [noneLeft, allRight] = sides(0.0);
    QVERIFY(noneLeft == 0 && allRight > 3);
    const auto [left, right] = sides(180.0);
    // The lowest ones on one side may be missing: nothing grows into the ground.
    QVERIFY(left > 3 && right > 3 && std::abs(left - right) <= 4);
}

static const test::TestClass<SchematicTest> schematicTest;

#include "SchematicTest.moc"
