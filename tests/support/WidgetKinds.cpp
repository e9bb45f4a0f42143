// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/WidgetKinds.h"

#include "panels/HelpPage.h"
#include "panels/ParameterRow.h"
#include "panels/PressureCurve.h"
#include "panels/RadiusSlider.h"
#include "panels/RotationStrip.h"
#include "panels/TimeSlider.h"
#include "panels/ViewRow.h"
#include "panels/architecture/Diagram.h"
#include "panels/architecture/DiagramHandle.h"
#include "panels/architecture/ValueField.h"
#include "panels/library/LibraryView.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLatin1String>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QPoint>
#include <QPointF>
#include <QRect>
#include <QScrollBar>
#include <QSize>
#include <QSlider>
#include <QSpinBox>
#include <QStyleHints>
#include <QTest>
#include <QTextBrowser>
#include <QWheelEvent>
#include <QWidget>

#include <array>

namespace espalier::test {

namespace {

template <class Widget>
bool isA(const QWidget& widget)
{
    return qobject_cast<const Widget*>(&widget) != nullptr;
}

void driveButton(WindowHand& hand, QWidget& widget, Way way)
{
    if (way == Way::Keys)
        WindowHand::key(widget, Qt::Key_Space);
    else
        hand.tap(way, widget);
}

/// Presses the track, far from the handle.
void driveSlider(WindowHand& hand, QWidget& widget, Way way)
{
    auto& slider = static_cast<QAbstractSlider&>(widget);
    const double share =
        static_cast<double>(slider.value() - slider.minimum()) / (slider.maximum() - slider.minimum());
    if (way == Way::Keys) {
        WindowHand::key(widget, share > 0.5 ? Qt::Key_Left : Qt::Key_Right);
        return;
    }
    const double along = share > 0.5 ? 0.15 : 0.85;
    const bool isUpright = slider.orientation() == Qt::Vertical;
    hand.tap(way, widget,
             isUpright ? QPoint(widget.width() / 2, static_cast<int>((1.0 - along) * widget.height()))
                       : QPoint(static_cast<int>(along * widget.width()), widget.height() / 2));
}

QString textOf(const QSpinBox& box, int value)
{
    return box.locale().toString(value);
}

QString textOf(const QDoubleSpinBox& box, double value)
{
    return box.locale().toString(value, 'f', box.decimals());
}

/// Types another number, or steps to the next one.
void driveNumber(WindowHand& hand, QWidget& widget, Way way)
{
    const auto typeOver = [&](const QString& text) {
        hand.tap(way, widget);
        WindowHand::key(widget, Qt::Key_A, Qt::ControlModifier);
        WindowHand::type(widget, text);
        WindowHand::key(widget, Qt::Key_Return);
    };
    const auto drive = [&](auto& box) {
        const auto step = box.singleStep();
        const bool goesUp = box.value() + step <= box.maximum();
        const bool goesFar = box.value() + 10 * step <= box.maximum();
        if (way == Way::Keys)
            WindowHand::key(widget, goesUp ? Qt::Key_Up : Qt::Key_Down);
        else
            typeOver(textOf(box, box.value() + (goesFar ? 10 : goesUp ? 1 : -1) * step));
    };
    if (auto* whole = qobject_cast<QSpinBox*>(&widget))
        drive(*whole);
    else
        drive(static_cast<QDoubleSpinBox&>(widget));
}

/// Selects the next entry of the drop-down list.
void driveChoice(WindowHand& hand, QWidget& widget, Way way)
{
    auto& box = static_cast<QComboBox&>(widget);
    const int next = box.currentIndex() + 1 < box.count() ? box.currentIndex() + 1 : box.currentIndex() - 1;
    if (way == Way::Keys) {
        WindowHand::key(widget, next > box.currentIndex() ? Qt::Key_Down : Qt::Key_Up);
        return;
    }
    // A list takes the release of the press that opened it for a choice, unless it comes within a double
    // click.
    const int interval = QApplication::doubleClickInterval();
    QGuiApplication::styleHints()->setMouseDoubleClickInterval(2000);
    hand.tap(way, widget);
    const bool isOpen = QTest::qWaitFor([&] { return box.view()->isVisible(); }, 1000);
    QGuiApplication::styleHints()->setMouseDoubleClickInterval(interval);
    if (!isOpen)
        return;
    // For a moment a list mistakes a release for that of the press which opened it.
    QTest::qWait(30);
    const QRect entry = box.view()->visualRect(box.model()->index(next, 0));
    hand.tap(way, *box.view()->viewport(), entry.center());
}

void driveField(WindowHand& hand, QWidget& widget, Way way)
{
    if (way != Way::Keys)
        hand.tap(way, widget);
    WindowHand::type(widget, QStringLiteral("a"));
}

void driveHandle(WindowHand& hand, QWidget& widget, Way way)
{
    auto& handle = static_cast<DiagramHandle&>(widget);
    if (way == Way::Keys) {
        const ParameterInfo& info = handle.scale().info();
        WindowHand::key(widget,
                        handle.value() < 0.5 * (info.minimum + info.maximum) ? Qt::Key_Plus : Qt::Key_Minus);
        return;
    }
    // Drags toward the middle of the drawing, or away from it.
    const QWidget& diagram = *widget.parentWidget();
    const QPoint from = widget.geometry().center();
    const QPointF way_ = diagram.rect().center() - from;
    const double length = std::hypot(way_.x(), way_.y());
    const QPointF turned = length > 12.0 ? 24.0 / length * (way_ + QPointF(0.4 * way_.y(), -0.4 * way_.x()))
                                         : QPointF(17.0, -17.0);
    hand.drag(way, diagram, from, from + turned.toPoint());
}

void driveCurve(WindowHand& hand, QWidget& widget, Way way)
{
    auto& curve = static_cast<PressureCurve&>(widget);
    const bool isSoft = curve.exponent() < 1.0;
    if (way == Way::Keys)
        WindowHand::key(widget, isSoft ? Qt::Key_Down : Qt::Key_Up);
    else
        hand.tap(way, widget, QPoint(widget.width() / 2, widget.height() * (isSoft ? 3 : 1) / 4));
}

void driveList(WindowHand& hand, QWidget& widget, Way way)
{
    auto& view = static_cast<QAbstractItemView&>(widget);
    const int row = view.currentIndex().row();
    int other = row > 0 ? row - 1 : row + 1;
    // Headings cannot be chosen.
    if (!(view.model()->index(other, 0).flags() & Qt::ItemIsEnabled))
        other = row + 1;
    if (way == Way::Keys) {
        const bool isGrid = isA<CardView>(widget);
        WindowHand::key(widget, other < row ? (isGrid ? Qt::Key_Left : Qt::Key_Up)
                                            : (isGrid ? Qt::Key_Right : Qt::Key_Down));
        if (isA<QListWidget>(widget))
            WindowHand::key(widget, Qt::Key_Return);
        return;
    }
    view.scrollTo(view.model()->index(other, 0));
    const QRect entry = view.visualRect(view.model()->index(other, 0));
    hand.tap(way, *view.viewport(), entry.center());
}

void drivePage(WindowHand& hand, QWidget& widget, Way way)
{
    auto& page = static_cast<QTextBrowser&>(widget);
    QWidget& sheet = *page.viewport();
    page.verticalScrollBar()->setValue(0);
    if (way == Way::Keys) {
        WindowHand::key(widget, Qt::Key_PageDown);
    } else if (way == Way::Mouse) {
        QWheelEvent wheel(sheet.rect().center(), sheet.mapToGlobal(sheet.rect().center()), {}, {0, -240}, {},
                          {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&sheet, &wheel);
    } else {
        hand.drag(way, sheet, {sheet.width() / 2, sheet.height() - 20}, {sheet.width() / 2, 40});
    }
}

/// The strip only shows the scale; a drag there turns the view below.
void driveStrip(WindowHand& hand, QWidget& widget, Way way)
{
    if (way == Way::Keys) {
        widget.parentWidget()->findChild<Viewport*>()->setFocus();
        WindowHand::key(widget, Qt::Key_Right);
    } else {
        hand.drag(way, widget, {widget.width() / 3, widget.height() / 2},
                  {widget.width() / 2, widget.height() / 2});
    }
}

// From the special class to the general one.
constexpr std::array kKinds{
    WidgetKind{"handle", isA<DiagramHandle>, driveHandle},
    WidgetKind{"pressure curve", isA<PressureCurve>, driveCurve},
    WidgetKind{"rotation strip", isA<RotationStrip>, driveStrip},
    WidgetKind{"help page", isA<HelpPage>, drivePage},
    WidgetKind{"button", isA<QAbstractButton>, driveButton},
    WidgetKind{"slider", isA<QSlider>, driveSlider},
    WidgetKind{"radius slider", isA<RadiusSlider>, driveSlider},
    WidgetKind{"time slider", isA<TimeSlider>, driveSlider},
    WidgetKind{"number", isA<QSpinBox>, driveNumber},
    WidgetKind{"decimal number", isA<QDoubleSpinBox>, driveNumber},
    WidgetKind{"choice", isA<QComboBox>, driveChoice},
    WidgetKind{"field", isA<QLineEdit>, driveField},
    WidgetKind{"list", isA<QListView>, driveList},
};

/// Whether the widget is a part of one that is driven as a whole.
bool isPart(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    return isA<QScrollBar>(widget) || isA<QAbstractSpinBox>(*parent) || isA<QLineEdit>(*parent) ||
           isA<QComboBox>(*parent) || isA<QAbstractScrollArea>(*parent) || isA<QScrollBar>(*parent);
}

} // namespace

const WidgetKind* kindOf(const QWidget& widget)
{
    const auto found =
        std::ranges::find_if(kKinds, [&](const WidgetKind& kind) { return kind.isOne(widget); });
    return found == kKinds.end() ? nullptr : &*found;
}

bool isPassive(const QWidget& widget)
{
    if (isPart(widget))
        return true;
    if (widget.focusPolicy() & Qt::TabFocus)
        return false;
    // The words of a label can be selected, without effect.
    static const QStringList kHolders{
        QStringLiteral("espalier::Sideways"), QStringLiteral("espalier::BrushRadius"),
        QStringLiteral("espalier::ParameterRow"), QStringLiteral("espalier::ViewRow"),
        QStringLiteral("espalier::ValueField")};
    const QString name = QString::fromLatin1(widget.metaObject()->className());
    return !name.startsWith(QLatin1String("espalier::")) || isA<Diagram>(widget) || kHolders.contains(name);
}

QList<QWidget*> widgetsToWorkWith(QWidget& pane)
{
    QList<QWidget*> found;
    QList<QWidget*> all = pane.findChildren<QWidget*>();
    all.prepend(&pane);
    for (QWidget* widget : all) {
        if (!widget->isVisible() || widget->window() != pane.window() || (widget != &pane && isPart(*widget)))
            continue;
        if (kindOf(*widget) || (widget != &pane && !isPassive(*widget)))
            found << widget;
    }
    return found;
}

QSize targetOf(const QWidget& widget)
{
    const QWidget* parent = widget.parentWidget();
    const bool isInRow = isA<ParameterRow>(*parent) || isA<ViewRow>(*parent) || isA<ValueField>(*parent);
    return isInRow ? parent->size() : widget.size();
}

} // namespace espalier::test
