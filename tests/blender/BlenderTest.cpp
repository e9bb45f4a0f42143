// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/io/export/Exporter.h"
#include "model/mesh/Weld.h"
#include "model/texture/OwnTextures.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"
#include "views/render/OffscreenRenderer.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace espalier;

Q_DECLARE_METATYPE(espalier::TreeParameters)

namespace {

constexpr QSize kPicture(200, 200);
const QString kRecipe = QStringLiteral(SOURCE_DIR "/resources/recipes/linden.json");

QJsonArray toJson(const Vec3& v)
{
    return {double(v.x()), double(v.y()), double(v.z())};
}

QJsonObject describe(const ExportScene& scene)
{
    QJsonObject meshes;
    for (const ExportMesh& mesh : scene.meshes) {
        Box3 box;
        for (const MeshVertex& vertex : mesh.mesh.vertices)
            box.extend(toVec3(vertex.position));
        // OBJ writes each place of the wood once.
        std::size_t places = mesh.mesh.vertices.size();
        if (!scene.materials[mesh.material].isLeaf) {
            const std::vector<VertexIndex> first = firstAtSamePlace(mesh.mesh.vertices);
            places = 0;
            for (std::size_t i = 0; i < first.size(); ++i)
                places += first[i] == i ? 1 : 0;
        }
        meshes[mesh.name] = QJsonObject{{QStringLiteral("triangles"), qint64(mesh.mesh.indices.size() / 3)},
                                        {QStringLiteral("vertices"), qint64(mesh.mesh.vertices.size())},
                                        {QStringLiteral("places"), qint64(places)},
                                        {QStringLiteral("lower"), toJson(box.min())},
                                        {QStringLiteral("upper"), toJson(box.max())}};
    }
    return meshes;
}

QJsonObject describe(const Camera& camera)
{
    return {{QStringLiteral("position"), toJson(camera.position())},
            {QStringLiteral("right"), toJson(camera.right())},
            {QStringLiteral("up"), toJson(camera.up())},
            {QStringLiteral("fieldOfView"), double(Camera::kFieldOfView)},
            {QStringLiteral("size"), QJsonArray{kPicture.width(), kPicture.height()}}};
}

/// Counts of pixels in a picture of a tree without background.
struct Seen {
    int covered = 0; ///< Pixels that are more than half tree
    int both = 0;    ///< Pixels that the other picture covers too
    int either = 0;
    int green = 0;
    int brown = 0;
    int holes = 0; ///< Empty pixels with tree to the left, to the right, above and below
};

Seen look(const QImage& picture, const QImage& other)
{
    const auto covers = [](const QImage& image, int x, int y) { return qAlpha(image.pixel(x, y)) > 127; };
    std::vector<int> first(static_cast<std::size_t>(picture.width()), picture.height());
    std::vector<int> last(first.size(), -1);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (!covers(picture, x, y))
                continue;
            const auto column = static_cast<std::size_t>(x);
            first[column] = std::min(first[column], y);
            last[column] = y;
        }
    }
    Seen seen;
    for (int y = 0; y < picture.height(); ++y) {
        int left = picture.width();
        int right = -1;
        for (int x = 0; x < picture.width(); ++x) {
            if (covers(picture, x, y)) {
                left = std::min(left, x);
                right = x;
            }
        }
        for (int x = 0; x < picture.width(); ++x) {
            const bool here = covers(picture, x, y);
            const bool there = covers(other, x, y);
            seen.covered += here;
            seen.both += here && there;
            seen.either += here || there;
            const auto column = static_cast<std::size_t>(x);
            seen.holes += !here && x > left && x < right && y > first[column] && y < last[column];
            const QColor colour = picture.pixelColor(x, y);
            const int hue = colour.hsvHue();
            const bool isColourful = here && colour.hsvSaturation() > 25;
            seen.green += isColourful && hue > 60 && hue < 160;
            seen.brown += isColourful && hue >= 0 && hue < 60;
        }
    }
    return seen;
}

} // namespace

/// Another program reads the exports, because a reader of our own would repeat our own faults.
class BlenderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void blender_readsAndRendersEveryFormat_data();
    void blender_readsAndRendersEveryFormat();

private:
    QString m_blender;
};

void BlenderTest::initTestCase()
{
    m_blender = QStandardPaths::findExecutable(QStringLiteral("blender"));
    QVERIFY2(!m_blender.isEmpty(),
             "Blender, which reads the exports back, is not installed: scripts/setup.sh test installs it");
}

void BlenderTest::blender_readsAndRendersEveryFormat_data()
{
    // A loose crown of leaves with much empty space on their cards.
    TreeParameters parameters = readRecipe(kRecipe)->parameters;
    parameters.bark.kind = BarkKind::Plated;
    parameters.leaves.shape = LeafShape::Palmate;
    parameters.leaves.aspect = 1.0;
    QTest::addColumn<TreeParameters>("parameters");
    QTest::addColumn<QStringList>("suffixes");
    QTest::newRow("drawn") << parameters
                           << QStringList{QStringLiteral("obj"), QStringLiteral("fbx"),
                                          QStringLiteral("glb")};
    adoptImage(parameters.leaves,
               ImageAsset(test::pngOf(test::drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png")), 0.5);
    parameters.bark.image =
        ImageAsset(test::pngOf(test::repeatingBark(128, 128)), QStringLiteral("bark.png"));
    QTest::newRow("own") << parameters << QStringList{QStringLiteral("fbx"), QStringLiteral("glb")};
}

void BlenderTest::blender_readsAndRendersEveryFormat()
{
    QFETCH(const TreeParameters, parameters);
    QFETCH(const QStringList, suffixes);
    TreeDocument document;
    RecipePlayer(document, *readRecipe(kRecipe)).playAll();
    setParameters(document, parameters);
    const QString name = QStringLiteral("Wild Apple");
    const ExportOptions options{.textureSize = 256};
    const QTemporaryDir folder;
    for (const QString& suffix : suffixes) {
        const QString fileName = folder.filePath(QStringLiteral("tree.") + suffix);
        const Result<void> exported = exportTree(document.tree(), document.index(), name, fileName, options);
        QVERIFY2(exported, exported ? "" : qPrintable(exported.error().message));
    }

    // Drawn larger and scaled down, for edges as fine as those of many samples.
    PictureRequest request;
    request.size = 4 * kPicture;
    request.options.background = QColor(Qt::transparent);
    request.options.view.groundShown = false;
    TreeScene scene(document);
    scene.prepare();
    request.camera = pictureCamera(NamedView::Front, scene, kPicture);
    const Result<QImage> own = renderImage(document, request);
    QVERIFY2(own, own ? "" : qPrintable(own.error().message));
    const QImage ours = own->scaled(kPicture, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    ours.save(QStringLiteral("%1_own.png").arg(QLatin1String(QTest::currentDataTag())));

    const ExportScene exported = buildExportScene(document.tree(), document.index(), name, options);
    const QJsonObject expected{{QStringLiteral("name"), exported.name},
                               {QStringLiteral("suffixes"), QJsonArray::fromStringList(suffixes)},
                               {QStringLiteral("meshes"), describe(exported)},
                               {QStringLiteral("camera"), describe(*request.camera)}};
    QCOMPARE(expected[QLatin1String("meshes")].toObject().keys(),
             (QStringList{QStringLiteral("Wild_Apple_Bark_LOD0"), QStringLiteral("Wild_Apple_Leaves_LOD0")}));
    QFile file(folder.filePath(QStringLiteral("expected.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(expected).toJson());
    file.close();

    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(m_blender,
                  {QStringLiteral("-b"), QStringLiteral("--factory-startup"), QStringLiteral("--python"),
                   QStringLiteral(SOURCE_DIR "/tests/blender/check_exports.py"), QStringLiteral("--"),
                   folder.path()});
    QVERIFY(process.waitForFinished(240'000));
    const QByteArray output = process.readAll();
    QVERIFY2(output.contains("EXPORTS ARE GOOD\n"), output.constData());

    const Seen here = look(ours, ours);
    QVERIFY(here.holes > here.covered / 20);
    for (const char* suffix : {"fbx", "glb"}) {
        const QImage picture(folder.filePath(QLatin1String(suffix) + QStringLiteral(".png")));
        QCOMPARE(picture.size(), kPicture);
        // For a person to look at.
        picture.save(
            QStringLiteral("%1_%2.png").arg(QLatin1String(QTest::currentDataTag()), QLatin1String(suffix)));
        const Seen there = look(picture, ours);
        const auto what =
            QStringLiteral("%1: covered %2 of %3 here, both %4, either %5, holes %6 of %7 here, "
                           "green %8, brown %9")
                .arg(QLatin1String(suffix))
                .arg(there.covered)
                .arg(here.covered)
                .arg(there.both)
                .arg(there.either)
                .arg(there.holes)
                .arg(here.holes)
                .arg(there.green)
                .arg(there.brown)
                .toUtf8();
        qInfo("%s", what.constData());
        // The same tree at the same place, with sky where the alpha of its leaves is 0: whole cards would
        // cover a sixth more, with drawn leaves even a third.
        QVERIFY2(std::abs(there.covered - here.covered) < 0.1 * here.covered, what);
        QVERIFY2(there.both > 0.9 * there.covered, what);
        QVERIFY2(std::abs(there.holes - here.holes) < 0.2 * here.holes, what);
        QVERIFY2(there.green > 0.6 * there.covered, what);
        QVERIFY2(there.brown > 0.01 * there.covered, what);
    }
}

static const test::TestClass<BlenderTest> blenderTest;

#include "BlenderTest.moc"
