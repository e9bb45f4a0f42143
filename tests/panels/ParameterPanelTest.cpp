// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterPanel.h"

#include "commands/SetParameters.h"
#include "model/settings/Lengths.h"
#include "model/texture/OwnTextures.h"
#include "model/tree/LeafShapes.h"
#include "panels/BackgroundPanel.h"
#include "panels/BrushPanel.h"
#include "panels/BrushPopOut.h"
#include "panels/LookChoice.h"
#include "panels/ParameterEditor.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterValue.h"
#include "panels/PressureCurve.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"
#include "panels/ViewRow.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QApplication>
#include <QChar>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QLatin1String>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QPoint>
#include <QPointF>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <QWidget>

#include <cmath>
#include <map>

using namespace espalier;
using namespace espalier::test;

class ParameterPanelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { theme::apply(*qApp); }
    void everyParameter_hasOneRow();
    void everyRow_showsWhatTheDocumentHas();
    void dragOfASlider_isOneUndoStep();
    void dragOfALook_showsWhileItLasts();
    void escape_takesADragThatShowsBack();
    void doubleClick_bringsTheDefaultBackAsOneStep();
    void keys_stride();
    void drag_isFineFarFromTheTrackAndWithShift();
    void typedNumber_isPutInForceAndUndone();
    void looks_areListedWithSwatchesAndAWayToChooseAnImage();
    void imageOfOnesOwn_isListedUntilADrawnLookIsChosen();
    void leafShape_bringsItsBreadthInOneUndoStep();
    void imageDroppedOnASheet_isAskedFor();
    void typedLength_isTakenInAnyUnit_data();
    void typedLength_isTakenInAnyUnit();
    void feetAndInches_areShownAndStepped();
    void radiusSlider_keepsTheRadiusItIsGiven();
    void brushSheetAndPopOut_shareTheHand();
    void brushSheet_changesParametersAsUndoSteps();
    void pressureCurve_isDrawnByKeys();
    void background_changesTheViewAndFollowsIt();
    void background_offersTheColoursThatAreSeen();
    void background_saysWhichPictureIsShown();
};

namespace {

const ParameterSheet kSheets[] = {ParameterSheet::Leaves, ParameterSheet::Branches};

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
    QVERIFY(shown >= 18);
}

void ParameterPanelTest::dragOfASlider_isOneUndoStep()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    const TreeParameters before = document.parameters();
    drag(*panel.row("leaves.length")->findChild<QSlider*>(), 0.1, 0.9);
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(document.parameters() != before);
    const TreeParameters after = document.parameters();
    document.undoStack().undo();
    QCOMPARE(document.parameters(), before);
    document.undoStack().redo();
    QCOMPARE(document.parameters(), after);
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

void ParameterPanelTest::escape_takesADragThatShowsBack()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    ParameterRow* row = panel.row("leaves.length");
    auto* slider = row->findChild<QSlider*>();
    const TreeParameters before = document.parameters();
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() - 4, slider->height() / 2));
    QVERIFY(document.parameters() != before);
    QTest::keyClick(slider, Qt::Key_Escape);
    QCOMPARE(document.parameters(), before);
    QCOMPARE(row->value(), before.leaves.length);
    QTest::mouseMove(slider, QPoint(20, slider->height() / 2));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(20, slider->height() / 2));
    QCOMPARE(document.parameters(), before);
    QCOMPARE(document.undoStack().count(), 0);
}

void ParameterPanelTest::doubleClick_bringsTheDefaultBackAsOneStep()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    auto* slider = panel.row("leaves.droop")->findChild<QSlider*>();
    drag(*slider, 0.3, 0.9);
    QCOMPARE(document.undoStack().count(), 1);
    // A place on the slider: the second click also restores the value that the first click changed.
    const QPoint place(20, slider->height() / 2);
    QTest::mouseClick(slider, Qt::LeftButton, {}, place);
    QTest::mouseDClick(slider, Qt::LeftButton, {}, place);
    QCOMPARE(document.parameters(), TreeParameters());
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QVERIFY(document.parameters().leaves.droop > 0.8);
}

void ParameterPanelTest::drag_isFineFarFromTheTrackAndWithShift()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    auto* slider = panel.row("leaves.droop")->findChild<QSlider*>();
    // What a drag by 60 px from the middle to the right changes, with the pointer so far below the track.
    const auto dragged = [&](int below, Qt::KeyboardModifiers modifiers) {
        const QPoint middle = slider->rect().center();
        QTest::mousePress(slider, Qt::LeftButton, modifiers, middle);
        const int before = slider->value();
        for (const int x : {0, 20, 40, 60}) {
            const QPoint place = middle + QPoint(x, below);
            QMouseEvent move(QEvent::MouseMove, place, slider->mapToGlobal(place), Qt::NoButton,
                             Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(slider, &move);
        }
        QTest::mouseRelease(slider, Qt::LeftButton, modifiers, middle + QPoint(60, below));
        return slider->value() - before;
    };
    const int near = dragged(0, {});
    QVERIFY(near > 100);
    QVERIFY(std::abs(dragged(30, {}) - near) <= near / 10);
    const int far = dragged(120, {});
    QVERIFY2(far > 0 && far < near / 5, qPrintable(QString::number(far)));
    const int shifted = dragged(0, Qt::ShiftModifier);
    QVERIFY2(shifted > 0 && shifted < near / 5, qPrintable(QString::number(shifted)));
}

void ParameterPanelTest::keys_stride()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    auto* slider = panel.row("leaves.maxTips")->findChild<QSlider*>();
    const auto tips = [&] { return document.parameters().leaves.maxTips; };
    const int before = tips();
    QTest::keyClick(slider, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(tips(), before + 1);
    QTest::keyClick(slider, Qt::Key_PageUp);
    const int coarse = tips();
    QVERIFY(coarse > before + 2);
    QTest::keyClick(slider, Qt::Key_Left);
    QVERIFY(tips() < coarse && tips() > before + 1);
    QTest::keyClick(slider, Qt::Key_Home);
    QCOMPARE(tips(), 1);
    QCOMPARE(document.undoStack().count(), 1);
    QTest::keyClick(slider, Qt::Key_Delete);
    QCOMPARE(tips(), before);
}

void ParameterPanelTest::typedNumber_isPutInForceAndUndone()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    ParameterRow* row = panel.row("leaves.angle");
    auto* number = row->findChild<QDoubleSpinBox*>();
    const double before = row->value();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("75"));
    QTest::keyClick(number, Qt::Key_Return);
    QCOMPARE(document.parameters().leaves.angle, radians(75));
    document.undoStack().undo();
    QCOMPARE(row->value(), before);
    QCOMPARE(number->value(), before);
}

void ParameterPanelTest::looks_areListedWithSwatchesAndAWayToChooseAnImage()
{
    for (const auto& [sheet, key, drawn] :
         {std::tuple(ParameterSheet::Leaves, "leaves.shape", kLeafShapeCount),
          std::tuple(ParameterSheet::Branches, "bark.kind", kBarkKindCount)}) {
        TreeDocument document;
        ParameterPanel panel(document, sheet);
        panel.show();
        LookChoice& look = *panel.row(key)->look();
        QCOMPARE(look.count(), drawn + 1);
        for (int i = 0; i < look.count(); ++i) {
            QVERIFY(!look.itemIcon(i).isNull());
            QVERIFY(look.itemData(i, Qt::SizeHintRole).toSize().height() >= theme::kTarget);
        }
        QVERIFY(!look.accessibleName().isEmpty());
        QVERIFY(look.itemText(drawn).contains(QChar(0x2026)));
        // With the keyboard alone: to the last entry, which asks for a file and changes nothing.
        const QSignalSpy asked(&panel, &ParameterPanel::imageAsked);
        look.setFocus();
        QTest::keyClick(&look, Qt::Key_End);
        QCOMPARE(asked.count(), 1);
        QVERIFY(asked[0][0].value<LookKind>() == *LookChoice::kindOf(key));
        QCOMPARE(look.currentIndex(), 0);
        QCOMPARE(document.undoStack().count(), 0);
    }
}

void ParameterPanelTest::imageOfOnesOwn_isListedUntilADrawnLookIsChosen()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    LookChoice& look = *panel.row("leaves.shape")->look();
    TreeParameters parameters = document.parameters();
    adoptImage(parameters.leaves, ImageAsset(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("ginkgo.png")),
               0.5);
    setParameters(document, parameters);
    QCOMPARE(look.count(), kLeafShapeCount + 2);
    QCOMPARE(look.currentText(), QStringLiteral("ginkgo"));
    QVERIFY(!look.itemIcon(look.currentIndex()).isNull());
    QVERIFY(look.itemData(look.currentIndex(), Qt::AccessibleTextRole)
                .toString()
                .contains(QStringLiteral("ginkgo")));

    QTest::keyClick(&look, Qt::Key_Home);
    QVERIFY(document.parameters().leaves.image.isNull());
    QCOMPARE(document.parameters().leaves.aspect, LeafParameters().aspect);
    QCOMPARE(look.count(), kLeafShapeCount + 1);
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QVERIFY(document.parameters() == parameters);
    QCOMPARE(look.currentText(), QStringLiteral("ginkgo"));
}

void ParameterPanelTest::leafShape_bringsItsBreadthInOneUndoStep()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    panel.show();
    LookChoice& look = *panel.row("leaves.shape")->look();
    const auto leaves = [&] { return document.parameters().leaves; };
    const TreeParameters before = document.parameters();
    int steps = 0;
    look.setFocus();
    QTest::keyClick(&look, Qt::Key_Home);
    for (int shape = 1; shape < kLeafShapeCount; ++shape) {
        QTest::keyClick(&look, Qt::Key_Down);
        QCOMPARE(leaves().shape, static_cast<LeafShape>(shape));
        QCOMPARE(leaves().aspect, usualAspect(leaves().shape));
        QCOMPARE(document.undoStack().count(), ++steps);
    }
    // A willow's leaf is long and narrow, a maple's as broad as long.
    QVERIFY(usualAspect(LeafShape::Willow) < 0.2 && usualAspect(LeafShape::Palmate) > 0.9);
    for (; steps > 0; --steps)
        document.undoStack().undo();
    QVERIFY(document.parameters() == before);

    // A breadth of the user's own holds until another shape is chosen.
    TreeParameters parameters = document.parameters();
    parameters.leaves.aspect = 0.33;
    setParameters(document, parameters);
    setParameter(parameters, "leaves.length", 0.2);
    QCOMPARE(parameters.leaves.aspect, 0.33);
    QTest::keyClick(&look, Qt::Key_Down);
    QCOMPARE(leaves().shape, LeafShape::Lanceolate);
    QCOMPARE(leaves().aspect, usualAspect(LeafShape::Lanceolate));
}

void ParameterPanelTest::imageDroppedOnASheet_isAskedFor()
{
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Branches);
    panel.show();
    const QSignalSpy dropped(&panel, &ParameterPanel::imageDropped);
    const auto drop = [&](QWidget& on, const char* file) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QLatin1String(file))});
        QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&on, &enter);
        QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&on, &event);
        return enter.isAccepted();
    };
    QVERIFY(drop(panel, "/tmp/oak bark.JPG"));
    QCOMPARE(dropped.count(), 1);
    QVERIFY(dropped[0][0].value<LookKind>() == LookKind::Bark);
    QCOMPARE(dropped[0][1].toString(), QStringLiteral("/tmp/oak bark.JPG"));
    QVERIFY(drop(*panel.row("bark.kind")->look(), "/tmp/oak.png"));
    QCOMPARE(dropped.count(), 2);
    QVERIFY(!drop(panel, "/tmp/oak.espalier"));
    QCOMPARE(dropped.count(), 2);
}

void ParameterPanelTest::typedLength_isTakenInAnyUnit_data()
{
    QTest::addColumn<bool>("imperial");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("metres");
    QTest::addColumn<QString>("shown");
    QTest::newRow("as shown") << false << "12" << 0.12 << "12.0 cm";
    QTest::newRow("comma") << false << "12,5" << 0.125 << "12.5 cm";
    QTest::newRow("metres") << false << "0.3m" << 0.3 << "30.0 cm";
    QTest::newRow("inches, exactly") << false << "4 in" << 0.1016 << "10.2 cm";
    QTest::newRow("feet") << false << "1'3" << 0.381 << "38.1 cm";
    QTest::newRow("too much") << false << "9 m" << 2.0 << "200.0 cm";
    QTest::newRow("nonsense") << false << "twig" << 0.09 << "9.0 cm";
    QTest::newRow("inches as shown") << true << "4" << 0.1016 << "4.00 in";
    QTest::newRow("centimetres") << true << "10 cm" << 0.1 << "3.94 in";
}

void ParameterPanelTest::typedLength_isTakenInAnyUnit()
{
    QFETCH(bool, imperial);
    QFETCH(QString, typed);
    QFETCH(double, metres);
    QFETCH(QString, shown);
    setUnits(imperial ? Units::Imperial : Units::Metric);
    TreeDocument document;
    ParameterPanel panel(document, ParameterSheet::Leaves);
    setUnits(Units::Metric);
    panel.show();
    auto* number = panel.row("leaves.length")->findChild<QDoubleSpinBox*>();
    for (const bool unitToo : {false, true}) {
        document.reset(1);
        if (unitToo)
            number->findChild<QLineEdit*>()->selectAll();
        else
            number->selectAll();
        QTest::keyClicks(number, typed);
        QTest::keyClick(number, Qt::Key_Return);
        QVERIFY2(std::abs(document.parameters().leaves.length - metres) < 1e-9,
                 qPrintable(QString::number(document.parameters().leaves.length)));
        QCOMPARE(number->text(), shown);
        // A number that is not edited keeps its exact value.
        QTest::keyClick(number, Qt::Key_Return);
        QVERIFY(std::abs(document.parameters().leaves.length - metres) < 1e-9);
    }
}

void ParameterPanelTest::feetAndInches_areShownAndStepped()
{
    setUnits(Units::Imperial);
    TreeDocument document;
    ParameterPanel leaves(document, ParameterSheet::Leaves);
    ParameterPanel branches(document, ParameterSheet::Branches);
    ViewSettings settings;
    settings.set(&ViewValues::brushRadius, 0.5);
    BrushPopOut brush(document, settings);
    RadiusSlider slider(kMaxBrushRadius);
    slider.setValue(300);
    QStringList shown;
    for (const auto* label : brush.findChildren<QLabel*>())
        shown << label->text();
    setUnits(Units::Metric);
    QVERIFY(shown.contains(QStringLiteral("1 ft 8 in")));
    const auto numberOf = [](ParameterPanel& panel, const char* key) {
        return panel.row(key)->findChild<QDoubleSpinBox*>();
    };
    QCOMPARE(numberOf(leaves, "leaves.length")->text(), QStringLiteral("3.54 in"));
    QCOMPARE(numberOf(branches, "widths.tipDiameter")->text(), QStringLiteral("0.118 in"));
    QCOMPARE(numberOf(branches, "widths.baseDiameter")->text(), QStringLiteral("automatic"));
    QCOMPARE(numberOf(branches, "bark.scale")->text(), QStringLiteral("19.7 in"));
    // Showing a parameter does not change it, and a step is a round number in the shown unit.
    QCOMPARE(document.parameters(), TreeParameters());
    numberOf(leaves, "leaves.length")->stepUp();
    const double inches = document.parameters().leaves.length / kInch;
    QVERIFY(inches > 3.55 && std::abs(inches * 100.0 - std::round(inches * 100.0)) < 1e-4);
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

void ParameterPanelTest::brushSheetAndPopOut_shareTheHand()
{
    TreeDocument document;
    ViewSettings settings;
    BrushPanel sheet(document, settings, 0.25, 4.0);
    BrushPopOut popOut(document, settings);
    auto* here = sheet.findChild<RadiusSlider*>();
    auto* there = popOut.findChild<RadiusSlider*>();
    here->setValue(300);
    QVERIFY(settings.values().brushRadius > 0.5);
    QCOMPARE(there->radius(), settings.values().brushRadius);
    for (const char* name : {"view.pressureScales", "view.markersShown"}) {
        const auto toggle = [name](Bar& bar) {
            return bar.findChild<ViewRow*>(QString::fromLatin1(name))->findChild<QCheckBox*>();
        };
        QVERIFY(toggle(sheet)->isChecked() && toggle(popOut)->isChecked());
        toggle(popOut)->click();
        QVERIFY(!toggle(sheet)->isChecked());
    }
    QVERIFY(!settings.values().pressureScales && !settings.values().markersShown);
    sheet.findChild<ViewRow*>(QStringLiteral("view.planeShown"))->findChild<QCheckBox*>()->click();
    QVERIFY(!settings.values().planeShown);
    QCOMPARE(document.undoStack().count(), 0);
}

void ParameterPanelTest::brushSheet_changesParametersAsUndoSteps()
{
    TreeDocument document;
    ViewSettings settings;
    BrushPanel sheet(document, settings, 0.25, 4.0);
    for (const char* key : {"growth.markerDensity", "growth.markerAge", "growth.tropismFromStroke"})
        QVERIFY2(sheet.row(key), key);
    sheet.row("growth.tropismFromStroke")->findChild<QCheckBox*>()->click();
    QVERIFY(document.parameters().growth.tropismFromStroke);
    QCOMPARE(document.undoStack().count(), 1);
    sheet.setParametersEnabled(false);
    QVERIFY(!sheet.row("growth.markerAge")->isEnabled());
    QVERIFY(sheet.findChild<RadiusSlider*>()->isEnabled());
}

void ParameterPanelTest::pressureCurve_isDrawnByKeys()
{
    PressureCurve curve(0.25, 4.0);
    const QSignalSpy edited(&curve, &PressureCurve::exponentEdited);
    QTest::keyClick(&curve, Qt::Key_Up);
    QVERIFY(curve.exponent() < 1.0);
    QTest::keyClick(&curve, Qt::Key_End);
    QCOMPARE(curve.exponent(), 4.0);
    QTest::keyClick(&curve, Qt::Key_Delete);
    QCOMPARE(curve.exponent(), 1.0);
    QCOMPARE(edited.count(), 3);
    QTest::keyClick(&curve, Qt::Key_Q);
    QCOMPARE(edited.count(), 3);
}

void ParameterPanelTest::background_changesTheViewAndFollowsIt()
{
    ViewSettings settings;
    BackgroundPanel panel(settings);
    panel.resize(panel.sizeHint());
    panel.show();
    auto* right = panel.row("view.tracing.right")->findChild<QSlider*>();
    QCOMPARE(right->value(), (right->minimum() + right->maximum()) / 2);
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
    const TracingImage tracing{.image = ImageAsset("bytes", QStringLiteral("sketch.png")), .height = 2.5};
    settings.set(&ViewValues::tracing, tracing);
    QVERIFY(says(QStringLiteral("sketch.png")));
    QVERIFY(panel.row("view.tracing.up")->isEnabled());
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(settings.values().tracing.image.isNull());
    QCOMPARE(settings.values().tracing.height, 2.5);
    QVERIFY(!panel.row("view.tracing.up")->isEnabled());
}

static const test::TestClass<ParameterPanelTest> parameterPanelTest;

#include "ParameterPanelTest.moc"
