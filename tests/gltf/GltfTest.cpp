// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/io/export/Exporter.h"
#include "model/mesh/UvWrap.h"
#include "model/texture/OwnTextures.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace espalier;

/// Exports to GLB, checked by the Khronos glTF validator.
class GltfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void sample_isValid_data();
    void sample_isValid();
    void imagesOfOnesOwn_areValid();
    void brokenFile_isFound();

private:
    /// What the validator prints about a file.
    QByteArray validate(const QString& fileName) const;

    QString m_node;
};

namespace {

constexpr ExportOptions kSmall{.textureSize = 128};
const QByteArray kValid = "GLTF IS VALID\n";

} // namespace

void GltfTest::initTestCase()
{
    m_node = QStandardPaths::findExecutable(QStringLiteral("node"));
    QVERIFY2(!m_node.isEmpty(), "nodejs is missing; scripts/setup.sh test installs it");
    QVERIFY2(QDir(QStringLiteral(NODE_FOLDER "/node_modules/gltf-validator")).exists(),
             "gltf-validator is missing; scripts/node-packages.sh installs it, as ctest does");
}

QByteArray GltfTest::validate(const QString& fileName) const
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(m_node, {QStringLiteral(SOURCE_DIR "/tests/gltf/validate.js"), QStringLiteral(NODE_FOLDER),
                           fileName});
    if (!process.waitForFinished(120'000))
        return "the validator did not end";
    return process.readAll();
}

void GltfTest::sample_isValid_data()
{
    QTest::addColumn<QString>("recipe");
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    const QStringList names = folder.entryList({QStringLiteral("*.json")});
    QVERIFY(names.size() >= 16);
    // Meshes of strands differ from each other in what glTF does not see: two of them, the smallest, are
    // enough.
    const QStringList strands{QStringLiteral("joshua.json"), QStringLiteral("slabtrunk.json")};
    for (const QString& name : names) {
        const Result<Recipe> recipe = readRecipe(folder.filePath(name));
        QVERIFY2(recipe, qPrintable(name));
        if (recipe->parameters.wood.mesher == WoodMesherKind::Tubes || strands.contains(name))
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
    }
}

void GltfTest::sample_isValid()
{
    QFETCH(const QString, recipe);
    TreeDocument document;
    RecipePlayer(document, *readRecipe(recipe)).playAll();
    const ExportScene scene =
        buildExportScene(document.tree(), document.index(), QStringLiteral("Tree"), kSmall);
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.glb"));
    ExportFiles files(fileName);
    QVERIFY(exportFormatOf(fileName)->write(scene, files));
    QVERIFY(files.commit());
    const QByteArray output = validate(fileName);
    QVERIFY2(output == kValid, output.constData());

    float greatest = 0.0F;
    float highest = 0.0F; // of a triangle
    const TriangleMesh& bark = scene.meshes[0].mesh;
    for (std::size_t i = 0; i < bark.indices.size(); i += 3) {
        const auto v = [&](std::size_t corner) { return bark.vertices[bark.indices[i + corner]].uv[1]; };
        const auto [lower, upper] = std::minmax({v(0), v(1), v(2)});
        greatest = std::max({greatest, -lower, upper});
        highest = std::max(highest, upper - lower);
    }
    qInfo("%zu vertices of bark, v up to %.2f", bark.vertices.size(), double(greatest));
    QVERIFY(greatest <= std::max(kGreatestV, highest / 2.0F + 0.5F));
}

void GltfTest::imagesOfOnesOwn_areValid()
{
    TreeDocument document;
    const Recipe recipe = *readRecipe(QStringLiteral(SOURCE_DIR "/resources/recipes/linden.json"));
    RecipePlayer(document, recipe).playAll();
    TreeParameters parameters = recipe.parameters;
    adoptImage(parameters.leaves,
               ImageAsset(test::pngOf(test::drawnLeaf(Qt::transparent)), QStringLiteral("leaf.png")), 0.5);
    parameters.bark.image = ImageAsset(test::pngOf(test::repeatingBark(100, 90)), QStringLiteral("bark.png"));
    setParameters(document, parameters);
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.glb"));
    QVERIFY(exportTree(document.tree(), document.index(), QStringLiteral("Bäume"), fileName, kSmall));
    // The user's own image keeps its size, which need not be a power of two; the validator mentions that, and
    // nothing else.
    for (const QByteArray& line : validate(fileName).trimmed().split('\n'))
        QVERIFY2(line == kValid.trimmed() || line.contains("information IMAGE_NPOT_DIMENSIONS"), line);
}

void GltfTest::brokenFile_isFound()
{
    TreeDocument document;
    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("tree.glb"));
    QVERIFY(exportTree(document.tree(), document.index(), QStringLiteral("Tree"), fileName, kSmall));
    QFile file(fileName);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray content = file.readAll();
    QVERIFY(content.contains("\"TANGENT\":2"));
    content.replace("\"TANGENT\":2", "\"TANGENT\":3");
    file.seek(0);
    file.write(content);
    file.close();
    const QByteArray output = validate(fileName);
    QVERIFY2(output.contains("error") && output.contains("TANGENT") && !output.contains(kValid),
             output.constData());
}

static const test::TestClass<GltfTest> gltfTest;

#include "GltfTest.moc"
