// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the pictures of the help: trees before and after, from the recipes of the pages, and parts of the
// real window with a tool at work, by real events. scripts/pictures.sh runs it.
#include "app/MainWindow.h"
#include "model/io/FileWriter.h"
#include "model/mesh/TreeCounts.h"
#include "panels/GrowPopOut.h"
#include "panels/ProfilePanel.h"
#include "panels/Theme.h"
#include "panels/TimeSlider.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"
#include "views/render/OffscreenRenderer.h"

#include <QAbstractButton>
#include <QApplication>
#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <QPoint>
#include <QPointF>
#include <QPolygonF>
#include <QRect>
#include <QSettings>
#include <QSize>
#include <QSurfaceFormat>
#include <QTest>

#include <cstdio>

using namespace espalier;

namespace {

constexpr int kWidth = 640; ///< Of each picture, px
constexpr int kHeight = 400;
constexpr int kLowHeight = 300; ///< Of a picture of three trees, px
constexpr int kQuality = 82;    ///< Of JPEG

Recipe recipeOf(const QString& page)
{
    const Result<Recipe> recipe = readRecipe(QStringLiteral(":/docs/help/recipes/%1.json").arg(page));
    if (!recipe)
        qFatal("%s", qPrintable(recipe.error().message));
    return *recipe;
}

/// Plays the first @p count operations.
void play(TreeDocument& document, Recipe recipe, int count)
{
    recipe.operations.erase(recipe.operations.begin() + count, recipe.operations.end());
    RecipePlayer(document, std::move(recipe)).playAll();
}

void keep(const QImage& picture, const QString& name)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!picture.convertToFormat(QImage::Format_RGB32).save(&buffer, "jpg", kQuality))
        qFatal("%s.jpg could not be compressed", qPrintable(name));
    if (const Result<void> written = writeFile(name + QStringLiteral(".jpg"), bytes); !written)
        qFatal("%s", qPrintable(written.error().message));
    std::printf("%s.jpg\n", qPrintable(name));
}

/// The tree after each of these numbers of operations, side by side, seen by one camera.
void drawStages(const char* name, std::initializer_list<int> counts)
{
    const QString page = QString::fromLatin1(name);
    const QSize size(kWidth / static_cast<int>(counts.size()), counts.size() > 2 ? kLowHeight : kHeight);
    std::vector<std::unique_ptr<TreeDocument>> stages;
    Box3 bounds;
    for (const int count : counts) {
        stages.push_back(std::make_unique<TreeDocument>());
        play(*stages.back(), recipeOf(page), count);
        const Box3 tree = treeBounds(stages.back()->tree(), stages.back()->index());
        const Vec3 leaf = Vec3::Constant(0.06F);
        bounds.extend(Box3(tree.min() - leaf, tree.max() + leaf));
    }
    TreeScene scene(*stages.back());
    PictureRequest request;
    request.size = 2 * size;
    request.camera = pictureCamera(NamedView::Front, scene, request.size).framing(bounds);
    QImage sheet(static_cast<int>(counts.size()) * size.width(), size.height(), QImage::Format_RGB32);
    QPainter painter(&sheet);
    int x = 0;
    for (const auto& stage : stages) {
        const Result<QImage> picture = renderImage(*stage, request);
        if (!picture)
            qFatal("%s", qPrintable(picture.error().message));
        painter.drawImage(x, 0, picture->scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        if (x > 0)
            painter.fillRect(x - 1, 0, 2, size.height(), theme::kEdge);
        x += size.width();
    }
    painter.end();
    keep(sheet, page);
}

/// Works with the window; its pictures show the pointer as well.
class Photographer {
public:
    Photographer()
    {
        m_window.resize(1000, 700);
        m_window.show();
        m_window.activateWindow();
        if (!QTest::qWaitForWindowActive(&m_window))
            qFatal("the window does not come up");
    }
    ~Photographer() { m_window.files().file().setUnmodified(); }

    MainWindow& window() { return m_window; }
    Viewport& viewport() { return m_window.workspace().viewport(); }

    void begin(const char* page, int count, ActionId tool)
    {
        play(m_window.document(), recipeOf(QString::fromLatin1(page)), count);
        m_window.viewSettings().set(&ViewValues::personShown, false);
        m_window.actions()[tool]->trigger();
        look(Box3(Vec3(-0.9F, 0.0F, -0.3F), Vec3(0.9F, 2.3F, 0.3F)));
    }
    /// Looks at the box from the front.
    void look(const Box3& box)
    {
        viewport().setCamera(viewport().mainCamera().turnedTo(NamedView::Front).framing(box));
        rest();
    }
    /// The place at @p up m above the ground and @p right m to the right of the trunk's base.
    QPoint at(double right, double up)
    {
        const Camera& camera = viewport().mainCamera();
        const Vec3 place =
            static_cast<float>(right) * camera.right() + static_cast<float>(up) * Vec3::UnitY();
        return viewport().mapTo(&m_window, camera.project(place).value_or(QPointF()).toPoint());
    }
    void press(const QPoint& place)
    {
        m_pointer = place;
        QTest::mouseMove(m_window.windowHandle(), place);
        QTest::mousePress(m_window.windowHandle(), Qt::LeftButton, {}, place);
    }
    void drag(const QPoint& to, int ms = 500)
    {
        const QPoint from = m_pointer;
        for (int i = 1; i <= 20; ++i) {
            m_pointer = from + (to - from) * i / 20;
            QTest::mouseMove(m_window.windowHandle(), m_pointer);
            QTest::qWait(ms / 20);
        }
    }
    void release()
    {
        QTest::mouseRelease(m_window.windowHandle(), Qt::LeftButton, {}, m_pointer);
        QTest::qWait(50);
    }
    void hover(const QPoint& place)
    {
        for (int i = 3; i >= 0; --i)
            QTest::mouseMove(m_window.windowHandle(), place - QPoint(i, i), 20);
        m_pointer = place;
        QTest::qWait(300);
    }
    void takeBack()
    {
        QTest::keyClick(m_window.windowHandle(), Qt::Key_Escape);
        release();
    }
    void rest()
    {
        QTest::qWait(700);
        if (!QTest::qWaitFor([this] { return viewport().isAtRest(); }, 20000))
            qWarning("the picture does not come to rest");
    }
    /// Takes a part of the window; @p part has the proportions of the picture.
    void shoot(const char* name, const QRect& part, bool showsPointer = true)
    {
        QTest::qWait(400);
        QImage image = m_window.screen()->grabWindow(m_window.winId()).toImage();
        if (showsPointer) {
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            QPainterPath arrow;
            arrow.addPolygon(
                QPolygonF({{0, 0}, {0, 17}, {4.2, 13.2}, {7, 19.5}, {9.6, 18.3}, {6.8, 12.2}, {12.3, 12.2}}));
            arrow.closeSubpath();
            painter.translate(m_pointer);
            painter.setPen(QPen(Qt::black, 1.4));
            painter.setBrush(Qt::white);
            painter.drawPath(arrow);
        }
        keep(image.copy(part).scaledToWidth(kWidth, Qt::SmoothTransformation), QString::fromLatin1(name));
    }
    /// The tree and, at the left edge, the tools.
    static QRect left(int top) { return {0, top, 880, 550}; }

private:
    MainWindow m_window;
    QPoint m_pointer;
};

void drawTrees()
{
    // Numbers of operations of the page's recipe.
    drawStages("brush", {1, 5});
    drawStages("lasso", {1});
    drawStages("grow", {2, 11});
    drawStages("prune", {4, 5});
    drawStages("bend", {2, 3});
    drawStages("width", {3, 5});
    drawStages("selectBud", {2, 3});
    drawStages("addBuds", {8, 11});
    drawStages("history", {3, 5});
    drawStages("architecture", {1, 13});
    drawStages("leafSheet", {4, 5, 6});
    drawStages("branchSheet", {4, 5, 6});
    drawStages("penAndTouch", {2});
}

void shootBrush(Photographer& by)
{
    by.begin("brush", 1, ActionId::Brush);
    by.window().viewSettings().set(&ViewValues::brushRadius, 0.3);
    by.press(by.at(0.03, 1.1));
    by.drag(by.at(-0.1, 1.7), 1400);
    by.shoot("brush-window", by.left(50));
    by.takeBack();
}

void shootLasso(Photographer& by)
{
    by.begin("brush", 1, ActionId::Lasso);
    by.press(by.at(0.0, 1.0));
    // A heart, from its point up the left side, over both arcs, and some of the way back.
    for (double turn = std::numbers::pi; turn < 2.8 * std::numbers::pi; turn += 0.12) {
        const double right = 0.6 * std::pow(std::sin(turn), 3.0);
        const double up = 13.0 * std::cos(turn) - 5.0 * std::cos(2.0 * turn) - 2.0 * std::cos(3.0 * turn);
        by.drag(by.at(right, 1.6 + 0.036 * (up - std::cos(4.0 * turn))), 60);
    }
    by.shoot("lasso-window", by.left(50));
    by.takeBack();
}

void shootGrow(Photographer& by)
{
    by.begin("grow", 2, ActionId::Grow);
    const auto* slider = by.window().workspace().growPopOut().findChild<TimeSlider*>();
    const auto onSlider = [&](int position) {
        return slider->mapTo(&by.window(), slider->placeOf(position).toPoint());
    };
    by.press(onSlider(slider->value()));
    by.drag(onSlider(slider->value() * 7 / 10), 600);
    by.shoot("grow-window", by.left(50));
    by.release();
}

void shootPrune(Photographer& by)
{
    by.begin("prune", 4, ActionId::Prune);
    by.press(by.at(0.1, 1.05));
    by.drag(by.at(0.28, 0.55));
    by.shoot("prune-window", by.left(50));
    by.takeBack();
}

void shootBend(Photographer& by)
{
    by.begin("bend", 2, ActionId::Bend);
    by.press(by.at(0.02, 1.3));
    by.drag(by.at(-0.4, 1.2), 700);
    by.shoot("bend-window", {150, 270, 640, 400});
    by.takeBack();
}

void shootWidth(Photographer& by)
{
    by.begin("width", 5, ActionId::Width);
    by.hover(by.at(0.11, 0.03));
    by.shoot("width-window", by.left(150));
}

void shootProfile(Photographer& by)
{
    by.begin("profile", 4, ActionId::Profile);
    by.press(by.at(0.02, 0.3));
    by.release();
    by.rest();
    QTest::mouseClick(
        by.window().workspace().profilePanel().findChild<QAbstractButton*>(QStringLiteral("shapeFluted")),
        Qt::LeftButton);
    by.rest();
    by.shoot("profile-window", {95, 50, 640, 600});
}

void shootBud(Photographer& by)
{
    by.begin("selectBud", 2, ActionId::SelectBud);
    by.window().viewSettings().set(&ViewValues::leavesShown, false);
    by.look(Box3(Vec3(-0.5F, 0.8F, -0.3F), Vec3(0.5F, 2.2F, 0.3F)));
    by.hover(by.at(0.19, 1.72));
    by.shoot("selectBud-window", by.left(60));
    by.window().viewSettings().set(&ViewValues::leavesShown, true);
}

void shootSketch(Photographer& by)
{
    by.begin("sketch", 9, ActionId::Sketch);
    by.hover(by.at(0.25, 1.85));
    by.shoot("sketch-window", by.left(60));
}

void shootTwist(Photographer& by)
{
    by.begin("twist", 3, ActionId::Twist);
    by.look(Box3(Vec3(-0.5F, 0.0F, -0.3F), Vec3(0.5F, 1.5F, 0.3F)));
    by.press(by.at(0.01, 0.45));
    by.drag(by.at(-0.15, 0.47), 700);
    by.shoot("twist-window", by.left(100));
    by.takeBack();
}

void shootAddBuds(Photographer& by)
{
    by.begin("addBuds", 8, ActionId::AddBuds);
    by.look(Box3(Vec3(-0.4F, 0.4F, -0.2F), Vec3(0.2F, 1.0F, 0.2F)));
    by.hover(by.at(-0.13, 0.76));
    by.shoot("addBuds-window", by.left(100));
}

void shootHistory(Photographer& by)
{
    by.begin("prune", 5, ActionId::Brush);
    by.window().actions()[ActionId::History]->trigger();
    by.rest();
    by.shoot("history-window", {by.window().width() - 800, 0, 800, 500}, false);
    by.window().actions()[ActionId::History]->trigger();
}

void shootView(Photographer& by)
{
    by.begin("brush", 5, ActionId::Brush);
    by.shoot("firstTree", {0, 0, 1000, 700}, false);
    by.window().actions()[ActionId::Prune]->trigger();
    const int bottom = by.window().height();
    const QPoint strip(330, bottom - Viewport::kStripHeight / 2);
    by.press(strip);
    by.drag(strip + QPoint(120, 0));
    by.shoot("navigation", {100, bottom - 460, 800, 460});
    by.release();
}

} // namespace

int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-pictures"));
    if (argc != 2 || !QDir::setCurrent(QString::fromLocal8Bit(argv[1]))) {
        std::fprintf(stderr, "usage: help_pictures FOLDER\n");
        return 2;
    }
    QSettings().clear();
    theme::apply(application);
    drawTrees();
    Photographer photographer;
    for (void (*shoot)(Photographer&) :
         {shootBrush, shootLasso, shootGrow, shootPrune, shootBend, shootWidth, shootProfile, shootBud,
          shootTwist, shootAddBuds, shootSketch, shootHistory, shootView})
        shoot(photographer);
    return 0;
}
