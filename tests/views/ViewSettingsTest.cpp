// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/ViewSettings.h"

#include "model/settings/Lengths.h"
#include "tests/support/TestClasses.h"

#include <QLocale>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <limits>
#include <optional>

using namespace espalier;

class ViewSettingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void set_tellsOfChangesOnly();
    void values_stayWithinTheirLimits();
    void steppedRadius_goesDownToAnAxisAndUpAgain();
    void lengths_areTypedInAnyUnit_data();
    void lengths_areTypedInAnyUnit();
    void lengths_readAsPeopleWriteThem_data();
    void lengths_readAsPeopleWriteThem();
    void lengths_readAgainAreTheSame();
    void studio_followsTheTheme();
};

void ViewSettingsTest::lengths_areTypedInAnyUnit_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("metres"); // NaN if the text is not a length
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::pair<const char*, double> rows[] = {
        {"12", 0.12},
        {"12 cm", 0.12},
        {"12cm", 0.12},
        {"0.3m", 0.3},
        {"0,3 m", 0.3},
        {"1 m 20", 1.2},
        {"1 m 5 cm", 1.05},
        {"3.5 mm", 0.0035},
        {",5", 0.005},
        {"5.", 0.05},
        {"5 ft 3 in", 1.6002},
        {"5'3", 1.6002},
        {"5' 3\"", 1.6002},
        {"5\u2032 3\u2033", 1.6002},
        {"4 IN", 0.1016},
        {"6 feet", 1.8288},
        {"1.234,5 mm", 1.2345},
        {"1,234.5 mm", 1.2345},
        {"-2 m", -2.0},
        {" 7 ", 0.07},
        {"", none},
        {"cm", none},
        {"5 ft 3 in 2", none},
        {"4 yards", none},
        {"1e5", none},
        {"inf", none},
        {"nan m", none},
        {"12 3", none},
        {"5 m -3 cm", none},
        {"..", none},
    };
    for (const auto& [typed, metres] : rows)
        QTest::newRow(typed) << QString::fromUtf8(typed) << metres;
}

void ViewSettingsTest::lengths_areTypedInAnyUnit()
{
    QFETCH(QString, typed);
    QFETCH(double, metres);
    const std::optional<double> length = parseLength(typed, 0.01);
    QCOMPARE(length.has_value(), !std::isnan(metres));
    if (length)
        QVERIFY2(std::abs(*length - metres) < 1e-12, qPrintable(QString::number(*length, 'g', 15)));
}

void ViewSettingsTest::lengths_readAsPeopleWriteThem_data()
{
    QTest::addColumn<double>("metres");
    QTest::addColumn<QString>("metric");
    QTest::addColumn<QString>("imperial");
    QTest::newRow("nothing") << 0.0 << "0 cm"
                             << "0 in";
    QTest::newRow("twig") << 0.0042 << "0.42 cm"
                          << "0.17 in";
    QTest::newRow("leaf") << 0.09 << "9.0 cm"
                          << "3.5 in";
    QTest::newRow("branch") << 0.254 << "25 cm"
                            << "10 in";
    QTest::newRow("just less than a foot") << 0.3047 << "30 cm"
                                           << "1 ft";
    QTest::newRow("foot") << 0.3048 << "30 cm"
                          << "1 ft";
    QTest::newRow("crown") << 1.25 << "1.25 m"
                           << "4 ft 1 in";
}

void ViewSettingsTest::lengths_readAsPeopleWriteThem()
{
    QFETCH(double, metres);
    QFETCH(QString, metric);
    QFETCH(QString, imperial);
    QCOMPARE(units(), Units::Metric);
    QCOMPARE(lengthText(metres), metric);
    setUnits(Units::Imperial);
    const QString text = lengthText(metres);
    setUnits(Units::Metric);
    QCOMPARE(text, imperial);
    QLocale::setDefault(QLocale(QStringLiteral("de")));
    const QString german = lengthText(metres);
    QLocale::setDefault(QLocale::c());
    QCOMPARE(german, QString(metric).replace(QLatin1Char('.'), QLatin1Char(',')));
}

void ViewSettingsTest::lengths_readAgainAreTheSame()
{
    for (const Units each : {Units::Metric, Units::Imperial}) {
        setUnits(each);
        for (double metres = 0.003; metres < 30.0; metres *= 1.07) {
            const QString text = lengthText(metres);
            const std::optional<double> again = parseLength(text, 1.0);
            QVERIFY2(again && std::abs(*again - metres) < 0.051 * metres, qPrintable(text));
            QCOMPARE(lengthText(*again), text);
            // Rounding twice changes nothing.
            QVERIFY(std::abs(roundedLength(roundedLength(metres)) - roundedLength(metres)) < 1e-12);
        }
    }
    setUnits(Units::Metric);
}

void ViewSettingsTest::set_tellsOfChangesOnly()
{
    ViewSettings settings;
    QSignalSpy changed(&settings, &ViewSettings::changed);
    settings.set(&ViewValues::leavesShown, true);
    QCOMPARE(changed.count(), 0);
    settings.set(&ViewValues::leavesShown, false);
    QCOMPARE(changed.count(), 1);
    QVERIFY(!settings.values().leavesShown);
}

void ViewSettingsTest::values_stayWithinTheirLimits()
{
    ViewSettings settings;
    settings.set(&ViewValues::brushRadius, 99.0);
    QCOMPARE(settings.values().brushRadius, kMaxBrushRadius);
    settings.set(&ViewValues::brushRadius, -1.0);
    QCOMPARE(settings.values().brushRadius, 0.0);
    settings.set(&ViewValues::sunElevation, 0.0);
    QVERIFY(settings.values().sunElevation > 0.0);
    settings.set(&ViewValues::tracing, {.right = -1e9, .height = 0.0, .opacity = 2.0});
    QCOMPARE(settings.values().tracing.right, -TracingImage::kMaxOffset);
    QVERIFY(settings.values().tracing.height > 0.0);
    QCOMPARE(settings.values().tracing.opacity, 1.0);
}

void ViewSettingsTest::steppedRadius_goesDownToAnAxisAndUpAgain()
{
    double radius = kMaxBrushRadius;
    QCOMPARE(steppedBrushRadius(radius, 1.0), kMaxBrushRadius);
    int steps = 0;
    while (radius > 0.0) {
        const double next = steppedBrushRadius(radius, -1.0);
        QVERIFY(next < radius);
        radius = next;
        QVERIFY(++steps < 200);
    }
    QCOMPARE(steppedBrushRadius(0.0, -1.0), 0.0);
    radius = steppedBrushRadius(0.0, 1.0);
    QVERIFY(radius > 0.0);
    QVERIFY(std::abs(steppedBrushRadius(radius, 1.0) - 1.1 * radius) < 1e-12);
}

void ViewSettingsTest::studio_followsTheTheme()
{
    ViewValues values;
    QCOMPARE(shownBackdrop(values), Backdrop::DarkStudio);
    QVERIFY(!isBackdropLight(values));
    values.isThemeLight = true;
    QCOMPARE(shownBackdrop(values), Backdrop::LightStudio);
    QVERIFY(isBackdropLight(values));
    // A backdrop that the user has chosen stays.
    values.backdrop = Backdrop::DarkStudio;
    QVERIFY(!isBackdropLight(values));
    values.backdrop = Backdrop::Plain;
    values.backgroundColour = QColor(20, 60, 20);
    QVERIFY(!isBackdropLight(values));
    values.backgroundColour = QColor(240, 230, 200);
    QVERIFY(isBackdropLight(values));
}

static const test::TestClass<ViewSettingsTest> viewSettingsTest;

#include "ViewSettingsTest.moc"
