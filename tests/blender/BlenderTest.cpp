// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/Exporter.h"
#include "tests/support/TreeBuilder.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace espalier;

namespace {

QJsonObject describe(const ExportScene& scene)
{
    QJsonObject meshes;
    for (const ExportMesh& mesh : scene.meshes) {
        Box3 box;
        for (const MeshVertex& vertex : mesh.mesh.vertices)
            box.extend(toVec3(vertex.position));
        const auto corner = [](const Vec3& v) {
            return QJsonArray{double(v.x()), double(v.y()), double(v.z())};
        };
        meshes[mesh.name] = QJsonObject{{QStringLiteral("triangles"), qint64(mesh.mesh.indices.size() / 3)},
                                        {QStringLiteral("lower"), corner(box.min())},
                                        {QStringLiteral("upper"), corner(box.max())}};
    }
    return {{QStringLiteral("name"), scene.name}, {QStringLiteral("meshes"), meshes}};
}

} // namespace

/// What another program makes of the exports is what counts: a reader of our own would only repeat our own
/// faults.
class BlenderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void blender_readsEveryFormat();
};

void BlenderTest::blender_readsEveryFormat()
{
    const QString blender = QStandardPaths::findExecutable(QStringLiteral("blender"));
    QVERIFY2(!blender.isEmpty(), "this test needs Blender: scripts/setup.sh test");
    TreeParameters parameters;
    parameters.growth.lateralsPerNode = 2;
    const test::TreeBuilder builder = test::randomTree(300, 4, parameters);
    const QString name = QStringLiteral("Wild Apple");
    const ExportOptions options{.textureSize = 256};
    const QTemporaryDir folder;
    for (const char* suffix : {"obj", "fbx", "glb"}) {
        const QString fileName = folder.filePath(QStringLiteral("tree.") + QLatin1String(suffix));
        const Result<void> exported = exportTree(builder.tree, builder.index, name, fileName, options);
        QVERIFY2(exported, exported ? "" : qPrintable(exported.error().message));
    }
    const QJsonObject expected = describe(buildExportScene(builder.tree, builder.index, name, options));
    QCOMPARE(expected[QLatin1String("meshes")].toObject().keys(),
             (QStringList{QStringLiteral("Wild_Apple_LOD0_Bark"), QStringLiteral("Wild_Apple_LOD0_Leaves")}));
    QFile file(folder.filePath(QStringLiteral("expected.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(expected).toJson());
    file.close();

    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(blender,
                  {QStringLiteral("-b"), QStringLiteral("--factory-startup"), QStringLiteral("--python"),
                   QStringLiteral(SOURCE_DIR "/tests/blender/check_exports.py"), QStringLiteral("--"),
                   folder.path()});
    QVERIFY(process.waitForFinished(240'000));
    const QByteArray output = process.readAll();
    QVERIFY2(output.contains("EXPORTS ARE GOOD\n"), output.constData());
}

QTEST_GUILESS_MAIN(BlenderTest)

#include "BlenderTest.moc"
