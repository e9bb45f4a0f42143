// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterPanel.h"

#include "panels/BackgroundPanel.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterValue.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"

#include <QtTest>
#include <QtWidgets>

#include <map>

using namespace espalier;

class ParameterPanelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { theme::apply(*qApp); }
    void everyParameter_hasOneRow();
    void everyRow_showsWhatTheDocumentHas();
    void dragOfASlider_isOneUndoStep();
    void dragOfALook_showsWhileItLasts();
    void dragOfGrowth_isPutInForceWhenItEnds();
    void typedNumber_isPutInForceAndUndone();
    void weightsOfDirection_shareAWhole();
    void radiusSlider_keepsTheRadiusItIsGiven();
    void background_changesTheViewAndFollowsIt();
    void background_offersTheColoursThatAreSeen();
    void background_saysWhichPictureIsShown();
};

namespace {

const ParameterSheet kSheets[] = {ParameterSheet::Architecture, ParameterSheet::Leaves,
                                  ParameterSheet::Branches};

void drag(QSlider& slider, double from, double to)
{
    const auto at = [&](double t) {
        return QPoint(static_cast<int>(t * slider.width()), slider.height() / 2);
    };
    QTest::mousePress(&slider, Qt::LeftButton, {}, at(from));
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(&slider, at(from + (to - from) * i / 5.0));
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, at(to));
}

} // namespace

void ParameterPanelTest::everyParameter_hasOneRow()
{
    std::map<std::string, int> rows;
    for (const ParameterSection& section : parameterSections()) {
        for (const ParameterText& text : section.parameters)
            ++rows[text.key];
    }
    TreeParameters parameters;
    std::size_t count = 0;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto&) {
        ++count;
        QVERIFY2(rows[info.key] == 1, info.key);
    });
    QCOMPARE(rows.size(), count);
}

void ParameterPanelTest::everyRow_showsWhatTheDocumentHas()
{
    TreeDocument document;
    int shown = 0;
    for (const ParameterSheet sheet : kSheets) {
        const ParameterPanel panel(document, sheet);
        visitParameters(document.parameters(), [&](const ParameterInfo& info, const auto& field) {
            if (const ParameterRow* row = panel.row(info.key)) {
                ++shown;
                QCOMPARE(row->value(), surfaceValue(info, field));
                if (const auto* number = row->findChild<QDoubleSpinBox*>())
                    QVERIFY2(number->value() > 0.0 || surfaceValue(info, field) <= 0.0, info.key);
            }
        });
    }
    QVERIFY(shown > 40);
}

void ParameterPanelTest::dragOfASlider_isOneUndoStep()
{
    TreeDocument document;
    for (const char* key : {"leaves.length", "growth.branchingAngle"}) {
        const bool isLeaf = key[0] == 'l';
        ParameterPanel panel(document, isLeaf ? ParameterSheet::Leaves : ParameterSheet::Architecture);
        panel.show();
        const TreeParameters before = document.parameters();
        const int commands = document.undoStack().count();
        drag(*panel.row(key)->findChild<QSlider*>(), 0.1, 0.9);
        QCOMPARE(document.undoStack().count(), commands + 1);
        QVERIFY(document.parameters() != before);
        const TreeParameters after = document.parameters();
        document.undoStack().undo();
        QCOMPARE(document.parameters(), before);
        document.undoStack().redo();
        QCOMPARE(document.parameters(), after);
    }
}

void ParameterPanelTest::dragOfALook_showsWhileItLasts()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    auto* slider = panel.row("leaves.length")->findChild<QSlider*>();
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() - 4, slider->height() / 2));
    const double large = document.parameters().leaves.length;
    QVERIFY(large > 1.0);
    QTest::mouseMove(slider, QPoint(4, slider->height() / 2));
    QVERIFY(document.parameters().leaves.length < 0.02);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(4, slider->height() / 2));
    QCOMPARE(document.undoStack().count(), 1);
}

void ParameterPanelTest::dragOfGrowth_isPutInForceWhenItEnds()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Architecture);
    panel.show();
    const double before = document.parameters().growth.apicalDominance;
    auto* slider = panel.row("growth.apicalDominance")->findChild<QSlider*>();
    const QPoint end(slider->width() - 2, slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, end);
    QCOMPARE(document.parameters().growth.apicalDominance, before);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, end);
    QVERIFY(document.parameters().growth.apicalDominance > 0.9);
}

void ParameterPanelTest::typedNumber_isPutInForceAndUndone()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Architecture);
    panel.show();
    ParameterRow* row = panel.row("growth.branchingAngle");
    auto* number = row->findChild<QDoubleSpinBox*>();
    const double before = row->value();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("75"));
    QTest::keyClick(number, Qt::Key_Return);
    QTRY_COMPARE(document.parameters().growth.branchingAngle, radians(75));
    document.undoStack().undo();
    QCOMPARE(row->value(), before);
    QCOMPARE(number->value(), before);
}

void ParameterPanelTest::weightsOfDirection_shareAWhole()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Architecture);
    panel.show();
    for (const char* key : {"growth.axisWeight", "growth.tropismWeight", "growth.spaceWeight"}) {
        for (const double place : {0.99, 0.01, 0.4}) {
            drag(*panel.row(key)->findChild<QSlider*>(), 0.5, place);
            const GrowthParameters& growth = document.parameters().growth;
            QVERIFY(std::abs(growth.axisWeight + growth.tropismWeight + growth.spaceWeight - 1.0) < 1e-12);
            QVERIFY(growth.axisWeight >= 0.0 && growth.tropismWeight >= 0.0 && growth.spaceWeight >= 0.0);
            QVERIFY(std::abs(panel.row(key)->value() - place) < 0.06);
        }
    }
}

void ParameterPanelTest::radiusSlider_keepsTheRadiusItIsGiven()
{
    RadiusSlider slider(5.0);
    QSignalSpy edits(&slider, &RadiusSlider::radiusEdited);
    for (const double radius : {0.0, 0.0123456, 0.5, 4.99, 5.0}) {
        slider.setRadius(radius);
        QCOMPARE(slider.radius(), radius);
    }
    QVERIFY(edits.empty());
    slider.resize(64, 212);
    slider.show();
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(32, 209));
    QCOMPARE(slider.radius(), 0.0);
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(32, 2));
    QCOMPARE(slider.radius(), 5.0);
    QCOMPARE(edits.size(), 2);
}

void ParameterPanelTest::background_changesTheViewAndFollowsIt()
{
    ViewSettings settings;
    BackgroundPanel panel(settings);
    panel.resize(panel.sizeHint());
    panel.show();
    auto* slider = panel.row("view.sunElevation")->findChild<QSlider*>();
    drag(*slider, 0.5, 0.9);
    QVERIFY(settings.values().sunElevation > radians(70));
    settings.set(&ViewValues::sunAzimuth, radians(200));
    QVERIFY(std::abs(panel.row("view.sunAzimuth")->value() + 160.0) < 1e-6);
    QTest::mouseClick(panel.row("view.gridShown")->findChild<QCheckBox*>(), Qt::LeftButton);
    QVERIFY(settings.values().gridShown);
    settings.set(&ViewValues::backdrop, Backdrop::Horizon);
    QCOMPARE(panel.row("view.backdrop")->findChild<QComboBox*>()->currentIndex(), 1);
}

void ParameterPanelTest::background_offersTheColoursThatAreSeen()
{
    ViewSettings settings;
    BackgroundPanel panel(settings);
    const auto* colour = panel.findChild<QPushButton*>(QStringLiteral("backgroundColour"));
    const auto* top = panel.findChild<QPushButton*>(QStringLiteral("backgroundTop"));
    QVERIFY(!colour->isEnabled() && !top->isEnabled());
    settings.set(&ViewValues::backdrop, Backdrop::Plain);
    QVERIFY(colour->isEnabled() && !top->isEnabled());
    settings.set(&ViewValues::backdrop, Backdrop::Gradient);
    QVERIFY(colour->isEnabled() && top->isEnabled());
}

void ParameterPanelTest::background_saysWhichPictureIsShown()
{
    ViewSettings settings;
    BackgroundPanel panel(settings);
    auto* remove = panel.findChild<QPushButton*>(QStringLiteral("tracingRemove"));
    const auto says = [&](const QString& text) {
        const QList<QLabel*> labels = panel.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->toolTip() == text; });
    };
    QVERIFY(!remove->isEnabled());
    QVERIFY(!panel.row("view.tracing.up")->isEnabled());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("sketch.png"));
    QVERIFY(QImage(8, 8, QImage::Format_RGB32).save(file));
    panel.trace(file);
    QCOMPARE(settings.values().tracing.file, file);
    QVERIFY(says(QStringLiteral("sketch.png")));
    QVERIFY(panel.row("view.tracing.up")->isEnabled());
    panel.trace(folder.filePath(QStringLiteral("none.png")));
    QVERIFY(says(QStringLiteral("none.png cannot be read.")));
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(settings.values().tracing.file.isEmpty());
}

QTEST_MAIN(ParameterPanelTest)
#include "ParameterPanelTest.moc"
