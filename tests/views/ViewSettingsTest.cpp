// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/ViewSettings.h"

#include <QtTest>

using namespace espalier;

class ViewSettingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void set_tellsOfChangesOnly();
    void values_stayWithinTheirLimits();
    void steppedRadius_goesDownToAnAxisAndUpAgain();
    void studio_followsTheTheme();
};

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
    // What a person has chosen stays.
    values.backdrop = Backdrop::DarkStudio;
    QVERIFY(!isBackdropLight(values));
    values.backdrop = Backdrop::Plain;
    values.backgroundColour = QColor(20, 60, 20);
    QVERIFY(!isBackdropLight(values));
    values.backgroundColour = QColor(240, 230, 200);
    QVERIFY(isBackdropLight(values));
}

QTEST_GUILESS_MAIN(ViewSettingsTest)
#include "ViewSettingsTest.moc"
