// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/Exporter.h"

#include "model/io/JsonReader.h"
#include "model/io/export/ObjWriter.h"
#include "model/io/export/SkeletonWriter.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include <memory>
#include <vector>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Exporter)
};

/// Files that appear together once all of them are written, or not at all.
class FileSet {
public:
    explicit FileSet(const QString& mainFile) : m_main(mainFile) {}

    /// Name of a texture of the main file's: "oak_bark.png". Without spaces, which not every reader of OBJ
    /// files takes.
    QString textureName(const ExportTexture& texture) const
    {
        return safeExportName(m_main.completeBaseName()) + QLatin1Char('_') + texture.name +
               QLatin1String(".png");
    }
    QString materialName() const { return safeExportName(m_main.completeBaseName()) + QLatin1String(".mtl"); }

    /// Adds a file beside the main one and lets @p write write it.
    template <class Write>
    Result<void> addWritten(const QString& name, Write&& write)
    {
        auto file = std::make_unique<QSaveFile>(m_main.dir().filePath(name));
        if (!file->open(QIODevice::WriteOnly) || !write(*file))
            return failure(*file);
        m_files.push_back(std::move(file));
        return {};
    }
    Result<void> add(const QString& name, const QByteArray& content)
    {
        return addWritten(name, [&](QIODevice& file) { return file.write(content) == content.size(); });
    }
    Result<void> addTextures(const ExportScene& scene)
    {
        Result<void> result;
        for (const ExportMaterial& material : scene.materials) {
            for (const ExportTexture* texture : {&material.colour, &material.normal, &material.roughness}) {
                if (result)
                    result = add(textureName(*texture), texture->png);
            }
        }
        return result;
    }
    QString mainName() const { return m_main.fileName(); }

    /// What others refer to comes first.
    Result<void> commit()
    {
        for (const auto& file : m_files) {
            if (!file->commit())
                return failure(*file);
        }
        return {};
    }

private:
    static Error failure(const QSaveFile& file)
    {
        const QString name = QFileInfo(file.fileName()).fileName();
        return {Error::Kind::Output, inputError(name, file.errorString()).message};
    }

    QFileInfo m_main;
    std::vector<std::unique_ptr<QSaveFile>> m_files;
};

Result<void> addPacked(FileSet& files, const Result<QByteArray>& content)
{
    if (!content)
        return Error{Error::Kind::Output, inputError(files.mainName(), content.error().message).message};
    return files.add(files.mainName(), *content);
}

Result<void> addScene(FileSet& files, const ExportScene& scene, const QString& suffix)
{
    const auto textureName = [&](const ExportTexture& texture) { return files.textureName(texture); };
    if (suffix == QLatin1String("glb"))
        return addPacked(files, toGlb(scene));
    if (Result<void> textures = files.addTextures(scene); !textures)
        return textures;
    if (suffix == QLatin1String("fbx"))
        return addPacked(files, toFbx(scene, textureName));
    if (Result<void> materials = files.add(files.materialName(), toMtl(scene, textureName)); !materials)
        return materials;
    return files.addWritten(files.mainName(),
                            [&](QIODevice& device) { return writeObj(device, scene, files.materialName()); });
}

} // namespace

QStringList exportSuffixes()
{
    return {QStringLiteral("glb"), QStringLiteral("fbx"), QStringLiteral("obj"), QStringLiteral("csv")};
}

Result<void> exportTree(const Tree& tree, const TreeIndex& index, const QString& name,
                        const QString& fileName, const ExportOptions& options, const Progress& progress)
{
    const QString suffix = QFileInfo(fileName).suffix().toLower();
    if (!exportSuffixes().contains(suffix)) {
        return Error{Error::Kind::Output,
                     inputError(QFileInfo(fileName).fileName(),
                                Text::tr("there is no export to “.%1”; there are %2")
                                    .arg(suffix, exportSuffixes().join(QLatin1String(", "))))
                         .message};
    }
    const auto goesOn = [&](double done) { return !progress || progress(done); };
    const Error cancelled{Error::Kind::Cancelled, Text::tr("The export was cancelled.")};

    FileSet files(fileName);
    Result<void> added;
    if (!goesOn(0.0))
        return cancelled;
    if (suffix == QLatin1String("csv")) {
        added = files.addWritten(files.mainName(),
                                 [&](QIODevice& device) { return writeSkeleton(device, tree, index); });
    } else {
        const ExportScene scene = buildExportScene(tree, index, name, options);
        if (!goesOn(0.3))
            return cancelled;
        added = addScene(files, scene, suffix);
    }
    if (!added)
        return added;
    if (!goesOn(0.95))
        return cancelled;
    if (Result<void> committed = files.commit(); !committed)
        return committed;
    goesOn(1.0);
    return {};
}

} // namespace espalier
