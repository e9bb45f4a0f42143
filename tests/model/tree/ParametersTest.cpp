// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Parameters.h"

#include "tests/support/TestClasses.h"

#include <QTest>

#include <set>
#include <type_traits>

namespace espalier::test {

class ParametersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void defaults_lieWithinTheLimits();
    void keys_areUniqueAndNameTheirGroup();
    void everyField_isVisited();
    void choices_areAsManyAsTheirNames();
    void directionWeights_addUpToOne();
};

void ParametersTest::defaults_lieWithinTheLimits()
{
    TreeParameters parameters;
    visitParameters(parameters, [](const ParameterInfo& info, auto& field) {
        auto value = static_cast<double>(field);
        if (info.quantity == Quantity::Angle)
            value = degrees(value);
        QVERIFY2(value >= info.minimum && value <= info.maximum, info.key);
        QVERIFY2(info.minimum < info.maximum, info.key);
    });
}

void ParametersTest::keys_areUniqueAndNameTheirGroup()
{
    std::set<QString> keys;
    const TreeParameters parameters;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        const QString key = QString::fromLatin1(info.key);
        QVERIFY(keys.insert(key).second);
        QCOMPARE(key.split(u'.').size(), 2);
    });
}

void ParametersTest::everyField_isVisited()
{
    // Parameters that differ in each byte of a field differ.
    TreeParameters parameters;
    std::size_t bytes = 0;
    visitParameters(parameters, [&](const ParameterInfo&, auto& field) { bytes += sizeof(field); });
    visitImages(parameters, [&](const char*, auto& image) { bytes += sizeof(image); });
    // Padding is all that the fields do not fill: less than a word after each switch, count or choice.
    QVERIFY(bytes <= sizeof(TreeParameters));
    QVERIFY(sizeof(TreeParameters) - bytes < 64);
}

void ParametersTest::choices_areAsManyAsTheirNames()
{
    const TreeParameters parameters;
    visitParameters(parameters, [](const ParameterInfo& info, const auto&) {
        QCOMPARE(info.choices != nullptr, info.quantity == Quantity::Choice);
        if (info.choices != nullptr)
            QCOMPARE(QString::fromLatin1(info.choices).split(u' ').size(),
                     static_cast<int>(info.maximum) + 1);
    });
}

void ParametersTest::directionWeights_addUpToOne()
{
    const GrowthParameters p;
    QVERIFY(std::abs(p.axisWeight + p.tropismWeight + p.spaceWeight - 1.0) < 1e-12);
}

const TestClass<ParametersTest> parametersTest;

} // namespace espalier::test

#include "ParametersTest.moc"
