// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"
#include "views/render/FramePacer.h"
#include "views/render/OffscreenRenderer.h"

#include <QBuffer>
#include <QTest>

#include <array>
#include <memory>
#include <span>

using namespace espalier;

namespace {

constexpr QSize kSize(320, 240);

/// A document with a tree of about @p count internodes.
std::unique_ptr<TreeDocument> grownDocument(std::uint32_t count)
{
    auto document = std::make_unique<TreeDocument>();
    document->reset(3);
    while (document->index().livingCount() < count)
        test::apply(*document, test::randomGrowth(document->tree(), 60));
    return document;
}

/// Pixels whose colours differ by more than noise.
int difference(const QImage& a, const QImage& b)
{
    int pixels = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            const int distance = std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                                 std::abs(p.blue() - q.blue()) + std::abs(p.alpha() - q.alpha());
            pixels += distance > 12 ? 1 : 0;
        }
    }
    return pixels;
}

double brightness(const QImage& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            sum += image.pixelColor(x, y).lightnessF();
    }
    return sum / (image.width() * image.height());
}

/// Mean colour of what a picture with a transparent background shows, each 0...1.
std::array<double, 3> meanColour(const QImage& image)
{
    std::array<double, 3> sum{};
    double covered = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, y);
            sum[0] += colour.alphaF() * colour.redF();
            sum[1] += colour.alphaF() * colour.greenF();
            sum[2] += colour.alphaF() * colour.blueF();
            covered += colour.alphaF();
        }
    }
    for (double& channel : sum)
        channel /= covered;
    return sum;
}

/// The options of a picture of the tree alone, at rest or with what a movement saves.
RenderOptions treeAlone(FramePacer::Saving saving = FramePacer::Saving::Nothing, bool isMoving = false)
{
    FramePacer pacer;
    if (isMoving)
        pacer.disturb();
    while (pacer.saving() != saving)
        pacer.frameTook(1.0);
    RenderOptions options;
    pacer.apply(options);
    options.background = Qt::transparent;
    options.view.groundShown = false;
    return options;
}

/// A tree with a round crown of three metres.
std::vector<BrushSample> crownStroke()
{
    return test::strokeAlong(
        std::vector{Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, 1.6F, 0.0F), Vec3(0.4F, 2.2F, 0.2F)}, 0.7F, 3.0);
}

/// The greatest difference of two colours' channels, as a share of the first.
double change(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
    double greatest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i)
        greatest = std::max(greatest, std::abs(to[i] / from[i] - 1.0));
    return greatest;
}

QByteArray toText(const std::array<double, 3>& colour)
{
    return QStringLiteral("%1, %2, %3")
        .arg(255.0 * colour[0])
        .arg(255.0 * colour[1])
        .arg(255.0 * colour[2])
        .toUtf8();
}

} // namespace

class RendererTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();

    void background_isExactlyTheColourAskedFor();
    void transparentBackground_isTransparentAndPremultiplied();
    void tree_isSeenWhereItIsProjected();
    void picture_isTheSameEachTime();
    void picture_doesNotDependOnHowTheTreeCameAbout();
    void scene_followsDeltasBothWays();
    void leavesAndGround_canBeHidden();
    void ground_fillsTheLowerPartFromAnyDistance();
    void shadows_darken();
    void ambientLight_isLessInsideTheCrown();
    void motion_changesNoColours_data();
    void motion_changesNoColours();
    void growth_changesNoColours();
    void samples_smoothEdges();
    void picture_isTheSameAtAnySize();
    void foliage_coversAsMuchFromAfar_data();
    void foliage_coversAsMuchFromAfar();
    void sun_throwsTheShadowToItsOtherSide();
    void backdrops_differ();
    void gradient_goesFromColourToColour();
    void grid_isSeenOnTheGround();
    void tracingImage_standsBehindTheTree();
    void size_beyondTheCardIsAnError();
    void renderImage_drawsADocument();

private:
    QImage draw(TreeScene& scene, const RenderOptions& options = {}, NamedView view = NamedView::Front,
                const QSize& size = kSize);

    std::unique_ptr<OffscreenRenderer> m_renderer;
    std::unique_ptr<TreeDocument> m_document;
    std::unique_ptr<TreeScene> m_scene;
};

void RendererTest::initTestCase()
{
    auto renderer = OffscreenRenderer::create();
    QVERIFY2(bool(renderer), renderer ? "" : qPrintable(renderer.error().message));
    m_renderer = std::move(*renderer);
    m_document = grownDocument(600);
    m_scene = std::make_unique<TreeScene>(*m_document);
}

QImage RendererTest::draw(TreeScene& scene, const RenderOptions& options, NamedView view, const QSize& size)
{
    const auto image = m_renderer->render(scene, pictureCamera(view, scene, size), options);
    return image ? *image : QImage();
}

void RendererTest::background_isExactlyTheColourAskedFor()
{
    RenderOptions options;
    options.background = QColor(12, 34, 56);
    options.view.groundShown = false;
    const QImage image = draw(*m_scene, options);
    QCOMPARE(image.size(), kSize);
    QCOMPARE(image.pixelColor(0, 0), QColor(12, 34, 56));
    QCOMPARE(image.pixelColor(kSize.width() - 1, kSize.height() - 1), QColor(12, 34, 56));
}

void RendererTest::transparentBackground_isTransparentAndPremultiplied()
{
    RenderOptions options;
    options.background = QColor(Qt::transparent);
    options.view.groundShown = false;
    const QImage image = draw(*m_scene, options);
    QCOMPARE(image.pixelColor(0, 0).alpha(), 0);
    int solid = 0;
    for (int y = 0; y < image.height(); ++y) {
        const uchar* line = image.constScanLine(y);
        for (int x = 0; x < image.width(); ++x, line += 4) {
            QVERIFY(line[0] <= line[3] && line[1] <= line[3] && line[2] <= line[3]);
            solid += line[3] == 255 ? 1 : 0;
        }
    }
    QVERIFY2(solid > 300, qPrintable(QString::number(solid)));
}

void RendererTest::tree_isSeenWhereItIsProjected()
{
    RenderOptions options;
    options.background = QColor(Qt::transparent);
    options.view.groundShown = false;
    options.view.leavesShown = false;
    const QImage image = draw(*m_scene, options);
    const Camera camera = pictureCamera(NamedView::Front, *m_scene, kSize);
    int seen = 0;
    int asked = 0;
    for (InternodeId id = 0; id < m_document->tree().size(); id += 7) {
        if (!m_document->tree().isAlive(id))
            continue;
        const Vec3 middle = 0.5F * (m_document->index().nodePosition(id) +
                                    m_document->index().basePosition(m_document->tree(), id));
        // The wood is rounder than the straight lines between its nodes.
        const QPoint place = camera.project(middle)->toPoint();
        bool isSeen = false;
        for (const QPoint& offset : {QPoint(0, 0), QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
            isSeen = isSeen || image.pixelColor(place + offset).alpha() > 0;
        ++asked;
        seen += isSeen ? 1 : 0;
    }
    QVERIFY2(seen > 0.9 * asked, qPrintable(QStringLiteral("%1 of %2").arg(seen).arg(asked)));
}

void RendererTest::picture_isTheSameEachTime()
{
    const QImage first = draw(*m_scene);
    QCOMPARE(draw(*m_scene), first);
    auto other = OffscreenRenderer::create();
    TreeScene scene(*m_document);
    QCOMPARE(*(*other)->render(scene, pictureCamera(NamedView::Front, scene, kSize), {}), first);
    QCOMPARE(draw(*m_scene), first);
}

void RendererTest::picture_doesNotDependOnHowTheTreeCameAbout()
{
    TreeDocument document;
    document.reset(3);
    TreeScene followed(document);
    connect(&document, &TreeDocument::changed, this,
            [&](const TreeChange& change) { followed.follow(change); });
    auto other = OffscreenRenderer::create();
    QImage image;
    while (document.index().livingCount() < 600) {
        test::apply(document, (test::randomGrowth(document.tree(), 60)));
        followed.prepare();
        image = *(*other)->render(followed, pictureCamera(NamedView::Front, followed, kSize), {});
    }
    while (!followed.settleSome()) {
    }
    image = *(*other)->render(followed, pictureCamera(NamedView::Front, followed, kSize), {});
    QVERIFY(document.tree() == m_document->tree());
    QCOMPARE(difference(image, draw(*m_scene)), 0);
}

void RendererTest::scene_followsDeltasBothWays()
{
    const auto document = grownDocument(300);
    TreeScene scene(*document);
    connect(document.get(), &TreeDocument::changed, this,
            [&](const TreeChange& change) { scene.follow(change); });
    const QImage before = draw(scene);
    const Box3 bounds = scene.bounds();
    // A limb from the middle of the tree dies and comes back.
    InternodeId limb = 1;
    for (InternodeId id = 1; id < document->tree().size(); ++id) {
        const std::uint32_t size = document->index().subtreeSize(id);
        if (size > 20 && size < 150)
            limb = id;
    }
    test::apply(*document, test::death(document->tree(), document->index(), limb));
    const QImage pruned = draw(scene);
    QVERIFY(difference(before, pruned) > 50);
    document->undo();
    scene.prepare();
    while (!scene.settleSome()) {
    }
    QVERIFY(scene.bounds().isApprox(bounds));
    QCOMPARE(difference(before, draw(scene)), 0);
}

void RendererTest::leavesAndGround_canBeHidden()
{
    const QImage whole = draw(*m_scene);
    RenderOptions bare;
    bare.view.leavesShown = false;
    QVERIFY(difference(whole, draw(*m_scene, bare)) > 300);
    RenderOptions floating;
    floating.view.groundShown = false;
    QVERIFY(difference(whole, draw(*m_scene, floating)) > 300);
}

void RendererTest::ground_fillsTheLowerPartFromAnyDistance()
{
    RenderOptions floating;
    floating.view.groundShown = false;
    std::vector<int> shown; ///< Pixels of the ground
    for (const float distance : {12.0F, 40.0F, 100.0F}) {
        Camera camera = pictureCamera(NamedView::ThreeQuarter, *m_scene, kSize);
        camera.setDistance(distance);
        const auto whole = m_renderer->render(*m_scene, camera, {});
        const auto bare = m_renderer->render(*m_scene, camera, floating);
        QVERIFY(whole && bare);
        shown.push_back(difference(*whole, *bare));
    }
    QVERIFY2(shown[1] > shown[0] / 2 && shown[2] > shown[0] / 2,
             qPrintable(QStringLiteral("%1 %2 %3 pixels").arg(shown[0]).arg(shown[1]).arg(shown[2])));
}

void RendererTest::shadows_darken()
{
    RenderOptions plain;
    plain.view.shadowsShown = false;
    const double lit = brightness(draw(*m_scene, plain));
    const double shaded = brightness(draw(*m_scene));
    QVERIFY(shaded < lit);
}

void RendererTest::ambientLight_isLessInsideTheCrown()
{
    const LightGrid& light = m_scene->light();
    const auto& size = light.size();
    for (const int edge : size)
        QVERIFY(edge > 0 && edge <= LightGrid::kMaxEdge);
    const VoxelSpace& space = m_document->growthModel().space();
    std::uint8_t darkest = 255;
    for (int z = 0; z < size[2]; ++z) {
        for (int y = 0; y < size[1]; ++y) {
            for (int x = 0; x < size[0]; ++x) {
                const Vec3 centre = light.origin() + light.cellEdge() * Vec3(static_cast<float>(x) + 0.5F,
                                                                             static_cast<float>(y) + 0.5F,
                                                                             static_cast<float>(z) + 0.5F);
                const std::uint8_t cell =
                    light.cells()[static_cast<std::size_t>((z * size[1] + y) * size[0] + x)];
                QVERIFY(std::abs(255.0F * space.lightAt(centre) - static_cast<float>(cell)) < 1.01F);
                darkest = std::min(darkest, cell);
            }
        }
    }
    QVERIFY(darkest < 250);
}

void RendererTest::motion_changesNoColours_data()
{
    QTest::addColumn<bool>("leaves");
    QTest::addColumn<FramePacer::Saving>("saving");
    using enum FramePacer::Saving;
    for (const bool leaves : {true, false}) {
        for (const FramePacer::Saving saving : {Nothing, EarlierShadows, PlainLight, MostPixels})
            QTest::addRow("%s, saving %d", leaves ? "leaves" : "bare", static_cast<int>(saving))
                << leaves << saving;
    }
}

void RendererTest::motion_changesNoColours()
{
    QFETCH(const bool, leaves);
    QFETCH(const FramePacer::Saving, saving);
    RenderOptions resting = treeAlone();
    RenderOptions moving = treeAlone(saving, true);
    resting.view.leavesShown = leaves;
    moving.view.leavesShown = leaves;
    TreeDocument document;
    document.reset(3);
    test::brush(document, crownStroke());
    TreeScene scene(document);
    const auto rest = meanColour(draw(scene, resting, NamedView::Front, 2 * kSize));
    const auto motion = meanColour(draw(scene, moving, NamedView::Front, 2 * kSize));
    QVERIFY2(change(rest, motion) < 0.04, toText(rest) + " at rest, moving " + toText(motion));
}

void RendererTest::growth_changesNoColours()
{
    TreeDocument document;
    document.reset(3);
    TreeScene scene(document);
    connect(&document, &TreeDocument::changed, this, [&](const TreeChange& change) { scene.follow(change); });
    const std::vector<BrushSample> stroke = crownStroke();
    BrushGesture gesture(document, stroke.front());
    RenderOptions moving = treeAlone(FramePacer::Saving::PlainLight, true);
    for (std::size_t i = 1; i < stroke.size(); ++i) {
        gesture.add(stroke[i]);
        if (i % 3 != 0)
            continue;
        moving.keepsShadows = (i / 3 + 2) % FramePacer::kShadowFrames != 0;
        draw(scene, moving, NamedView::Front, 2 * kSize);
    }
    gesture.finish();
    moving.keepsShadows = true;
    const auto motion = meanColour(draw(scene, moving, NamedView::Front, 2 * kSize));
    const auto rest = meanColour(draw(scene, treeAlone(), NamedView::Front, 2 * kSize));
    QVERIFY2(change(rest, motion) < 0.04, toText(rest) + " at rest, moving " + toText(motion));
}

void RendererTest::samples_smoothEdges()
{
    RenderOptions options;
    options.background = QColor(Qt::transparent);
    options.view.groundShown = false;
    const auto partlyCovered = [&](int samples) {
        options.samples = samples;
        const QImage image = draw(*m_scene, options);
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const int alpha = image.pixelColor(x, y).alpha();
                pixels += alpha > 0 && alpha < 255 ? 1 : 0;
            }
        }
        return pixels;
    };
    QCOMPARE(partlyCovered(1), 0);
    QVERIFY(partlyCovered(4) > 500);
}

void RendererTest::picture_isTheSameAtAnySize()
{
    const auto drawn = [&](const QSize& size, NamedView view) {
        return *m_renderer->render(*m_scene, pictureCamera(view, *m_scene, size), {});
    };
    const auto distance = [](const QImage& a, const QImage& b) {
        double sum = 0.0;
        for (int y = 0; y < a.height(); ++y) {
            for (int x = 0; x < a.width(); ++x)
                sum += std::abs(a.pixelColor(x, y).greenF() - b.pixelColor(x, y).greenF());
        }
        return sum / (a.width() * a.height());
    };
    const QImage small = drawn({160, 120}, NamedView::Front);
    const QImage large =
        drawn({480, 360}, NamedView::Front).scaled(160, 120, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QImage other = drawn({160, 120}, NamedView::Side);
    const double off = distance(small, large);
    QVERIFY2(off < 0.012, qPrintable(QString::number(off)));
    QVERIFY(distance(small, other) > 3.0 * off);
}

void RendererTest::foliage_coversAsMuchFromAfar_data()
{
    QTest::addColumn<LeafShape>("shape");
    QTest::addColumn<int>("samples");
    for (const LeafShape shape :
         {LeafShape::Fascicle, LeafShape::Needles, LeafShape::Pinnate, LeafShape::Ovate}) {
        for (const int samples : {1, RenderOptions::kBestSamples})
            QTest::addRow("shape %d, %d samples", static_cast<int>(shape), samples) << shape << samples;
    }
}

void RendererTest::foliage_coversAsMuchFromAfar()
{
    QFETCH(LeafShape, shape);
    QFETCH(int, samples);
    TreeParameters parameters;
    parameters.leaves.shape = shape;
    parameters.leaves.length = 0.3;
    parameters.leaves.perNode = 1;
    TreeDocument document;
    document.reset(3, parameters);
    while (document.index().livingCount() < 60)
        test::apply(document, (test::randomGrowth(document.tree(), 30)));
    TreeScene scene(document);
    RenderOptions options;
    options.background = QColor(Qt::transparent);
    options.view.groundShown = false;
    options.samples = samples;
    // The covered share of the picture, at the size that the leaves were painted for and far smaller.
    const auto covered = [&](int edge) {
        const Camera camera = pictureCamera(NamedView::Front, scene, {edge, edge});
        const QImage image = *m_renderer->render(scene, camera, options);
        image.save(
            QStringLiteral("foliage-%1-%2-%3.png").arg(static_cast<int>(shape)).arg(samples).arg(edge));
        double sum = 0.0;
        for (int y = 0; y < edge; ++y) {
            for (int x = 0; x < edge; ++x)
                sum += qAlpha(image.pixel(x, y)) / 255.0;
        }
        return sum / (edge * edge);
    };
    const double near = covered(1200);
    QVERIFY(near > 0.02);
    for (const int edge : {300, 120}) {
        const double far = covered(edge);
        QVERIFY2(std::abs(far / near - 1.0) < (samples > 1 ? 0.12 : 0.3),
                 qPrintable(QStringLiteral("%1 px: %2 of %3").arg(edge).arg(far).arg(near)));
    }
}

void RendererTest::sun_throwsTheShadowToItsOtherSide()
{
    // How far to the right of the seedling the middle of the shadow lies, px.
    const auto shadow = [&](double azimuth) {
        RenderOptions options;
        options.background = QColor(Qt::transparent);
        options.samples = 1;
        options.view.sunAzimuth = azimuth;
        options.view.sunElevation = radians(40);
        Camera camera = pictureCamera(NamedView::Front, *m_scene, kSize);
        camera.setElevation(static_cast<float>(radians(30)));
        camera.setDistance(2.0F * camera.distance());
        const QImage image = *m_renderer->render(*m_scene, camera, options);
        double sum = 0.0;
        double moment = 0.0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor colour = image.pixelColor(x, y);
                if (colour.alpha() < 20 || colour.value() > 0)
                    continue;
                sum += colour.alpha();
                moment += colour.alpha() * x;
            }
        }
        return moment / sum - camera.project(Vec3::Zero())->x();
    };
    const double fromRight = shadow(radians(90));
    const double fromLeft = shadow(radians(-90));
    QVERIFY2(fromRight < -10.0, qPrintable(QString::number(fromRight)));
    QVERIFY2(fromLeft > 10.0, qPrintable(QString::number(fromLeft)));
}

void RendererTest::backdrops_differ()
{
    RenderOptions horizon;
    horizon.view.backdrop = Backdrop::Horizon;
    const double studio = brightness(draw(*m_scene));
    QVERIFY(brightness(draw(*m_scene, horizon)) > 2.0 * studio);
    // The studio is as light as the theme, unless the user has chosen the other one.
    RenderOptions options;
    options.view.isThemeLight = true;
    const double light = brightness(draw(*m_scene, options));
    QVERIFY(light > 2.0 * studio);
    options.view.backdrop = Backdrop::DarkStudio;
    QCOMPARE(brightness(draw(*m_scene, options)), studio);
    options.view.isThemeLight = false;
    options.view.backdrop = Backdrop::LightStudio;
    QCOMPARE(brightness(draw(*m_scene, options)), light);
}

void RendererTest::gradient_goesFromColourToColour()
{
    RenderOptions options;
    options.samples = 1;
    options.view.groundShown = false;
    options.view.backdrop = Backdrop::Gradient;
    options.view.backgroundColour = QColor(200, 20, 40);
    options.view.backgroundTop = QColor(10, 90, 220);
    const auto isNear = [](const QColor& a, const QColor& b) {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <
               8;
    };
    QImage image = draw(*m_scene, options);
    QVERIFY(isNear(image.pixelColor(0, 0), options.view.backgroundTop));
    QVERIFY(isNear(image.pixelColor(0, kSize.height() - 1), options.view.backgroundColour));
    options.view.backdrop = Backdrop::Plain;
    image = draw(*m_scene, options);
    QVERIFY(isNear(image.pixelColor(0, 0), options.view.backgroundColour));
    QVERIFY(isNear(image.pixelColor(0, kSize.height() - 1), options.view.backgroundColour));
}

void RendererTest::grid_isSeenOnTheGround()
{
    RenderOptions options;
    options.samples = 1;
    options.view.groundShown = false;
    const QImage without = draw(*m_scene, options, NamedView::ThreeQuarter);
    options.view.gridShown = true;
    const QImage with = draw(*m_scene, options, NamedView::ThreeQuarter);
    const int lines = difference(without, with);
    QVERIFY(lines > 100);
    QVERIFY(lines < kSize.width() * kSize.height() / 3);
}

void RendererTest::tracingImage_standsBehindTheTree()
{
    QImage red(40, 20, QImage::Format_RGB32);
    red.fill(Qt::red);
    RenderOptions options;
    options.samples = 1;
    options.view.groundShown = false;
    options.view.leavesShown = false;
    options.view.tracing.up = 1.0;
    options.view.tracing.height = 2.0;
    options.view.tracing.opacity = 1.0;
    const QImage none = draw(*m_scene, options);
    QByteArray png;
    QBuffer buffer(&png);
    QVERIFY(red.save(&buffer, "png"));
    options.view.tracing.image = ImageAsset(png, QStringLiteral("red.png"));
    const QImage image = draw(*m_scene, options);
    const Camera camera = pictureCamera(NamedView::Front, *m_scene, kSize);
    const auto at = [&](const QImage& picture, const Vec3& place) {
        return picture.pixelColor(camera.project(place)->toPoint());
    };
    QCOMPARE(at(image, {1.9F, 1.9F, 0.0F}), QColor(Qt::red));
    QCOMPARE(at(image, {-1.9F, 0.1F, 0.0F}), QColor(Qt::red));
    QCOMPARE(at(image, {2.1F, 1.0F, 0.0F}), at(none, {2.1F, 1.0F, 0.0F}));
    // The trunk stands before it.
    QVERIFY(at(image, {0.0F, 0.05F, 0.0F}) != QColor(Qt::red));
}

void RendererTest::size_beyondTheCardIsAnError()
{
    Camera camera;
    camera.setViewSize({100000, 100});
    const auto image = m_renderer->render(*m_scene, camera, {});
    QVERIFY(!image);
    QVERIFY(image.error().message.contains("100000"));
}

void RendererTest::renderImage_drawsADocument()
{
    PictureRequest request;
    request.size = {200, 300};
    request.view = NamedView::ThreeQuarter;
    const auto image = renderImage(*m_document, request);
    QVERIFY(bool(image));
    QCOMPARE(image->size(), QSize(200, 300));
    TreeDocument seedling;
    QVERIFY(difference(*image, *renderImage(seedling, request)) > 1000);
}

static const test::TestClass<RendererTest> rendererTest;

#include "RendererTest.moc"
