// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HelpController.h"
#include "app/MainWindow.h"
#include "app/Tour.h"
#include "commands/GrowGesture.h"
#include "commands/ParameterGesture.h"
#include "commands/SketchStroke.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/io/ImageFile.h"
#include "panels/BackgroundPanel.h"
#include "panels/BendPopOut.h"
#include "panels/BrushPopOut.h"
#include "panels/GrowPopOut.h"
#include "panels/HelpPanel.h"
#include "panels/LassoPopOut.h"
#include "panels/Notice.h"
#include "panels/ParameterRow.h"
#include "panels/RadiusSlider.h"
#include "panels/RotationStrip.h"
#include "panels/SettingsSheet.h"
#include "panels/SketchPopOut.h"
#include "panels/Theme.h"
#include "panels/ViewRow.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/DiagramHandle.h"
#include "panels/architecture/TropismDiagram.h"
#include "panels/architecture/ValueField.h"
#include "panels/library/LibraryPanel.h"
#include "tests/support/AllOperations.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WidgetKinds.h"
#include "tests/support/WindowPanes.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QLatin1String>
#include <QLineEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalSpy>
#include <QStyleHints>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QWidget>

#include <algorithm>
#include <set>

using namespace espalier;
using test::Way;

/// Works with every widget of the window by mouse, finger and keys. A widget of an unknown kind fails the
/// test.
class EveryWidgetTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void widgets_answerToMouseFingerAndKeys_data();
    void widgets_answerToMouseFingerAndKeys();
    void enter_pressesTheButtonThatHasTheKeys();

private:
    using Pane = test::WindowPanes::Pane;
    /// Everything that a widget can change.
    struct State {
        TreeParameters parameters;
        int undoIndex;
        ViewValues view;
        Preferences preferences;
        int interfaceScale;
        QStringList rest;

        bool operator==(const State&) const = default;
    };
    Workspace& workspace() { return m_window->workspace(); }
    TreeDocument& document() { return m_window->document(); }
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    /// A tree with a history: one step can be undone, one be redone.
    void prepareDocument();
    /// A drawing, which has got depth or not.
    void drawFlatTree(bool hasDepth);
    /// Prepares a state in which using @p widget changes something.
    void prepare(QWidget& widget);
    void reveal(QWidget& widget);
    void settle();
    State state(QWidget& pane);
    QWidget* find(const Pane& pane, const QString& name, int number);
    void drive(const Pane& pane, const QString& name, int number, Way way);
    /// The widgets that Tab reaches from the first one.
    std::set<const QWidget*> reachedByTab(QWidget& pane);

    QTemporaryDir m_folder;
    ImageAsset m_picture; ///< To draw after
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<test::WindowPanes> m_panes;
    std::unique_ptr<test::WindowHand> m_hand;
    int m_driven = 0;
};

namespace {

/// Parameters of growth without effect on the schematic tree, which is flat, regular, scaled to fit and grown
/// without a brush.
const QStringList kNotInSchematic{
    QStringLiteral("growth.ellipseParallel"),   QStringLiteral("growth.lateralsPerNode"),
    QStringLiteral("growth.markerDensity"),     QStringLiteral("growth.markerAge"),
    QStringLiteral("growth.tropismFromStroke"), QStringLiteral("growth.irregularity"),
    QStringLiteral("growth.internodeLength"),   QStringLiteral("growth.model")};

/// The parameter that @p widget changes, or nothing.
QString parameterOf(const QWidget& widget)
{
    if (const auto* handle = qobject_cast<const DiagramHandle*>(&widget))
        return QString::fromLatin1(handle->keys().front());
    if (const auto* row = qobject_cast<const ParameterRow*>(widget.parentWidget()))
        return QString::fromLatin1(row->key());
    if (const auto* field = qobject_cast<const ValueField*>(widget.parentWidget()))
        return QString::fromLatin1(field->key());
    return {};
}

bool changesTheView(const QWidget& widget)
{
    return qobject_cast<const ViewRow*>(widget.parentWidget()) ||
           qobject_cast<const RadiusSlider*>(&widget) ||
           qobject_cast<const BendPopOut*>(widget.parentWidget());
}

/// A name of the widget that does not change when its pane is closed and opened again.
QString nameOf(const QWidget& widget)
{
    QString name = widget.objectName();
    if (const auto* button = qobject_cast<const QToolButton*>(&widget); button && button->defaultAction())
        name = button->defaultAction()->objectName();
    if (name.isEmpty() || name.startsWith(QLatin1String("qt_")))
        name = widget.accessibleName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget); button && name.isEmpty())
        name = button->text();
    const QString parameter = parameterOf(widget);
    if (name.isEmpty() && qobject_cast<const ViewRow*>(widget.parentWidget()))
        name = widget.parentWidget()->objectName();
    return QStringLiteral("%1 %2 %3")
        .arg(QString::fromLatin1(widget.metaObject()->className()), name, parameter);
}

constexpr int kMostTabs = 300;

const char* const kWays[] = {"the mouse", "a finger", "keys"};

} // namespace

void EveryWidgetTest::initTestCase()
{
    theme::apply(*qApp);
    // The tests tap the same place quickly several times.
    QGuiApplication::styleHints()->setMouseDoubleClickInterval(5);
    QSettings().clear();
    Preferences preferences;
    preferences.libraryFolder = m_folder.path();
    Settings().setPreferences(preferences);
    Settings().setTourSeen(true);
    const QString picture = m_folder.filePath(QStringLiteral("sketch.png"));
    QVERIFY(QImage(8, 8, QImage::Format_RGB32).save(picture));
    m_picture = *readImageFile(picture);
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1024, 700);
    m_window->workspace().viewport().setBestSamples(1);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_panes = std::make_unique<test::WindowPanes>(*m_window);
    m_hand = std::make_unique<test::WindowHand>();
    // Painting does not matter here and would take most of the time.
    m_window->setUpdatesEnabled(false);
}

void EveryWidgetTest::cleanupTestCase()
{
    m_panes->shutAll();
    m_window->files().file().setUnmodified();
    m_hand.reset();
    m_window.reset();
    QVERIFY2(m_driven > 150, qPrintable(QString::number(m_driven)));
}

void EveryWidgetTest::prepareDocument()
{
    QUndoStack& stack = document().undoStack();
    if (stack.index() > 3)
        stack.setIndex(3);
    if (stack.index() == 3 && stack.count() > 3 && !document().tree().lassoIndicesInForce().empty())
        return;
    m_window->recipeRunner().stop();
    m_window->files().file().setUnmodified();
    if (m_window->files().isAside()) {
        m_window->files().bringBack();
        m_window->files().file().setUnmodified();
    }
    action(ActionId::New)->trigger();
    LassoOperation lasso;
    lasso.stroke.points = {{-0.2, 0.3}, {0.2, 0.3}, {0.2, 0.6}, {-0.2, 0.6}, {-0.2, 0.3}};
    Recipe recipe;
    recipe.operations = {lasso};
    RecipePlayer(document(), recipe).playAll();
    GrowGesture growth(document());
    for (int i = 0; i < 4; ++i)
        growth.step();
    growth.finish();
    TreeParameters parameters = document().parameters();
    parameters.widths.flare = 0.4;
    ParameterGesture(document()).tryOut(parameters, {});
    parameters.widths.flare = 0.3;
    ParameterGesture(document()).tryOut(parameters, {});
    stack.undo();
}

void EveryWidgetTest::drawFlatTree(bool hasDepth)
{
    m_window->files().file().setUnmodified();
    action(ActionId::New)->trigger();
    for (const std::vector<Vec2>& points : std::vector<std::vector<Vec2>>{{{0.0F, 0.0F}, {0.0F, 1.6F}},
                                                                          {{0.0F, 0.5F}, {0.6F, 0.9F}},
                                                                          {{0.0F, 0.7F}, {-0.5F, 1.2F}},
                                                                          {{0.0F, 0.9F}, {0.5F, 1.5F}},
                                                                          {{0.0F, 1.1F}, {-0.4F, 1.6F}},
                                                                          {{0.3F, 0.7F}, {0.5F, 0.7F}}})
        QVERIFY(sketchBranch(document(),
                             {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), points}, .base = {}}));
    if (hasDepth)
        Q_EMIT workspace().sketchPopOut().depthAsked();
}

void EveryWidgetTest::prepare(QWidget& widget)
{
    prepareDocument();
    workspace().viewport().setCamera(workspace().viewport().mainCamera().turnedTo(NamedView::Front));
    // Colours and places can only be set while they are shown.
    ViewValues view;
    view.shadowsShown = false;
    view.backdrop = Backdrop::Gradient;
    view.tracing.image = m_picture;
    m_window->viewSettings().setValues(view);
    workspace().library().showSection(LibraryPanel::Section::Species);
    workspace().library().findChild<QLineEdit*>()->clear();
    auto* button = qobject_cast<QToolButton*>(&widget);
    QAction* own = button ? button->defaultAction() : nullptr;
    // A tool or pane that is active already is deactivated first.
    if (own && own->isChecked() && own->actionGroup()) {
        const QList<QAction*> all = own->actionGroup()->actions();
        if (own->actionGroup()->exclusionPolicy() == QActionGroup::ExclusionPolicy::Exclusive)
            all.at(own == all.first() ? 1 : 0)->trigger();
        else
            own->trigger();
    }
    if (widget.objectName() == QLatin1String("giveDepth") ||
        widget.objectName() == QLatin1String("otherDepth"))
        drawFlatTree(widget.objectName() == QLatin1String("otherDepth"));
    if (widget.objectName() == QLatin1String("lookForNewTrees")) {
        // It shows in a notice only, and can be pressed while the look is another one.
        workspace().background().setLookOfNewTrees({});
        workspace().notice().finish();
    }
    if (widget.objectName() == QLatin1String("lassoStop"))
        workspace().lassoPopOut().setGrowing(true);
    if (auto* sheet = qobject_cast<SettingsSheet*>(widget.window())) {
        Preferences others = sheet->preferences();
        others.undoSteps = 77;
        others.undoMemory = 777;
        others.look = Look::Dark;
        others.areToolsRight = false;
        others.language.clear();
        sheet->setPreferences(others);
        Settings().setPreferences(others);
    }
    settle();
}

void EveryWidgetTest::reveal(QWidget& widget)
{
    for (QWidget* at = widget.parentWidget(); at; at = at->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(at)) {
            area->ensureWidgetVisible(&widget, 20, 0);
            QCoreApplication::processEvents();
        }
    }
}

void EveryWidgetTest::settle()
{
    QCoreApplication::processEvents();
    if (!QTest::qWaitFor([this] { return !m_window->isHandBusy(); }, 300))
        action(ActionId::Cancel)->trigger();
    QVERIFY(!m_window->isHandBusy());
}

EveryWidgetTest::State EveryWidgetTest::state(QWidget& pane)
{
    State now{document().parameters(),  document().undoStack().index(), m_window->viewSettings().values(),
              Settings().preferences(), Settings().interfaceScale(),    {}};
    QStringList& rest = now.rest;
    for (const QWidget* widget : workspace().findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        rest << QString::number(widget->isVisible());
    const Camera& camera = workspace().viewport().mainCamera();
    rest << workspace().viewport().tool().tip() << QString::number(m_hand->closedCount())
         << QString::number(document().tree().step()) << QString::number(document().journal().size())
         << QString::number(document().competitors().areAll()) << workspace().help().page()
         << workspace().library().chosen() << workspace().notice().text() << m_window->windowTitle()
         << QString::number(static_cast<double>(camera.azimuth()), 'f', 3)
         << QString::number(static_cast<double>(camera.position().norm()), 'f', 3)
         << QString::number(m_window->help().tour().isRunning());
    double depth = 0.0;
    for (InternodeId id = 0; id < document().tree().size(); ++id)
        depth += double{document().index().nodePosition(id).z()};
    rest << QString::number(depth);
    for (const QLabel* label : pane.findChildren<QLabel*>())
        rest << label->text();
    for (const QLineEdit* field : pane.findChildren<QLineEdit*>())
        rest << field->text();
    for (const QAbstractSpinBox* number : pane.findChildren<QAbstractSpinBox*>())
        rest << number->text();
    for (const QScrollBar* bar : pane.findChildren<QScrollBar*>())
        rest << QString::number(bar->value());
    for (const QAbstractItemView* view : pane.findChildren<QAbstractItemView*>())
        rest << QString::number(view->currentIndex().row());
    for (const QWidget* part : pane.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        rest << QString::number(part->isVisible());
    rest << QString::number(std::ranges::count_if(pane.findChildren<QWidget*>(),
                                                  [](const QWidget* part) { return part->isVisible(); }));
    return now;
}

QWidget* EveryWidgetTest::find(const Pane& pane, const QString& name, int number)
{
    for (QWidget* widget : test::widgetsToWorkWith(*pane.open())) {
        if (nameOf(*widget) == name && number-- == 0)
            return widget;
    }
    return nullptr;
}

std::set<const QWidget*> EveryWidgetTest::reachedByTab(QWidget& pane)
{
    std::set<const QWidget*> reached;
    for (QWidget* first : test::widgetsToWorkWith(pane)) {
        if (!first->isEnabled() || !(first->focusPolicy() & Qt::TabFocus) || reached.contains(first))
            continue;
        // Tab goes around: the search ends at the first widget again.
        if (!reached.empty())
            break;
        first->setFocus(Qt::ShortcutFocusReason);
        // A page of the help takes several presses of Tab, for its links.
        for (int i = 0; i < kMostTabs && (reached.size() < 2 || QApplication::focusWidget() != first); ++i) {
            reached.insert(QApplication::focusWidget());
            test::WindowHand::key(pane, Qt::Key_Tab);
        }
    }
    return reached;
}

void EveryWidgetTest::drive(const Pane& pane, const QString& name, int number, Way way)
{
    QPointer<QWidget> widget = find(pane, name, number);
    const QByteArray what = QStringLiteral("%1: %2 (%3) by %4")
                                .arg(QLatin1String(pane.name), name)
                                .arg(number)
                                .arg(QLatin1String(kWays[static_cast<int>(way)]))
                                .toUtf8();
    QVERIFY2(widget, what.constData());
    prepare(*widget);
    widget = find(pane, name, number);
    QVERIFY2(widget && widget->isEnabled(), what.constData());
    reveal(*widget);
    if (way == Way::Keys) {
        widget->setFocus(Qt::TabFocusReason);
    } else {
        workspace().viewport().setFocus();
        QTest::qWait(2 * QApplication::doubleClickInterval());
    }
    QPointer<QWidget> root = pane.open();
    const State before = state(*root);
    const Tree schematic = workspace().architecture().schematic().schematic().tree;
    const QString parameter = parameterOf(*widget);
    const bool isView = changesTheView(*widget);
    const bool isStop = widget->objectName() == QLatin1String("lassoStop");
    const QSignalSpy stopped(&workspace().lassoPopOut(), &LassoPopOut::stopAsked);
    test::kindOf(*widget)->drive(*m_hand, *widget, way);
    // Flights and opening panes take a moment; a played history ends in the state where it began.
    const bool isOther = QTest::qWaitFor([&] { return isStop || !root || !(state(*root) == before); }, 600);
    settle();
    const State after = root ? state(*root) : before;
    ++m_driven;

    if (!parameter.isEmpty()) {
        QVERIFY2(after.parameters != before.parameters, what.constData());
        QVERIFY2(after.undoIndex == before.undoIndex + 1, what.constData());
        if (way == Way::Mouse && parameter.startsWith(QLatin1String("growth.")) &&
            !kNotInSchematic.contains(parameter))
            QVERIFY2(!(workspace().architecture().schematic().schematic().tree == schematic),
                     what.constData());
        document().undoStack().undo();
        QVERIFY2(document().parameters() == before.parameters, what.constData());
        return;
    }
    if (isView) {
        QVERIFY2(!(after.view == before.view), what.constData());
        QVERIFY2(after.undoIndex == before.undoIndex, what.constData());
        return;
    }
    if (isStop) {
        workspace().lassoPopOut().setGrowing(false);
        QVERIFY2(stopped.count() == 1, what.constData());
        return;
    }
    QVERIFY2(isOther, what.constData());
    if (qobject_cast<const SettingsSheet*>(root.data()) &&
        qobject_cast<QAbstractButton*>(widget.data()) == nullptr)
        QVERIFY2(!(after.preferences == before.preferences) || after.interfaceScale != before.interfaceScale,
                 what.constData());
}

void EveryWidgetTest::widgets_answerToMouseFingerAndKeys_data()
{
    QTest::addColumn<int>("pane");
    int number = 0;
    for (const Pane& pane : m_panes->all())
        QTest::newRow(pane.name) << number++;
}

/// Whether it is a button of which one of several is down, so that Tab reaches only that one.
static bool isOneOfSeveral(const QWidget& widget)
{
    const auto* button = qobject_cast<const QAbstractButton*>(&widget);
    return button && button->isCheckable() && (button->autoExclusive() || widget.property("choice").toBool());
}

void EveryWidgetTest::widgets_answerToMouseFingerAndKeys()
{
    QFETCH(const int, pane);
    m_panes->shutAll();
    const Pane one = m_panes->all()[static_cast<std::size_t>(pane)];
    QWidget* root = one.open();
    QVERIFY(root && root->isVisible());
    QList<QWidget*> widgets = test::widgetsToWorkWith(*root);
    QVERIFY(!widgets.isEmpty());
    // What a choice of one of several does is tested with its tools.
    widgets.removeIf([](const QWidget* widget) { return isOneOfSeveral(*widget); });
    if (widgets.isEmpty())
        return;
    for (const QWidget* widget : widgets)
        QVERIFY2(test::kindOf(*widget),
                 qPrintable(nameOf(*widget) + QStringLiteral(" is of no kind that is known")));

    QStringList names;
    for (QWidget* widget : widgets)
        names << nameOf(*widget);
    prepare(*widgets.front());
    root = one.open();
    const std::set<const QWidget*> reached = reachedByTab(*root);
    for (const QWidget* widget : test::widgetsToWorkWith(*root)) {
        const bool isReached = reached.contains(widget) || !widget->isEnabled() || isOneOfSeveral(*widget) ||
                               qobject_cast<const RotationStrip*>(widget);
        QVERIFY2(isReached, qPrintable(nameOf(*widget) + QStringLiteral(" is not reached by Tab")));
    }
    for (int i = 0; i < names.size(); ++i) {
        const int number = static_cast<int>(names.mid(0, i).count(names[i]));
        for (const Way way : {Way::Mouse, Way::Finger, Way::Keys}) {
            drive(one, names[i], number, way);
            if (QTest::currentTestFailed())
                return;
            // A button can have opened a pane that covers the others.
            if (!one.open()->isVisible() || action(ActionId::HideInterface)->isChecked() ||
                root == &workspace().topBar())
                m_panes->shutAll();
        }
    }
}

void EveryWidgetTest::enter_pressesTheButtonThatHasTheKeys()
{
    m_panes->shutAll();
    m_panes->have(ActionId::BranchSheet);
    auto* prune = workspace().findChild<SideBar*>()->findChildren<BarButton*>().at(4);
    prune->setFocus();
    test::WindowHand::key(*prune, Qt::Key_Return);
    QTRY_VERIFY(action(ActionId::Prune)->isChecked());
    action(ActionId::Brush)->trigger();
    auto* markers = workspace().findChild<BrushPopOut*>()->findChild<QCheckBox*>();
    const bool before = markers->isChecked();
    markers->setFocus();
    test::WindowHand::key(*markers, Qt::Key_Enter);
    QTRY_COMPARE(markers->isChecked(), !before);
}

static const test::TestClass<EveryWidgetTest> everyWidgetTest;

#include "EveryWidgetTest.moc"
