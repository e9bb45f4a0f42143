// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/Jobs.h"

#include "app/files/Outputs.h"
#include "app/files/SafetyCopy.h"
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "model/io/export/ExportFormats.h"
#include "model/io/export/Exporter.h"

#include <QDir>
#include <QFile>

#include <chrono>
#include <utility>

namespace espalier::test {

namespace {

bool isOldOrNew(const Files& found, const Files& before, const Files& after)
{
    return found == before || found == after;
}

} // namespace

Files filesIn(const QString& folder)
{
    Files files;
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden)) {
        QFile bytes(file.filePath());
        files[file.fileName()] = bytes.open(QIODevice::ReadOnly) ? bytes.readAll() : QByteArray("unreadable");
    }
    return files;
}

void put(const QString& folder, const Files& files)
{
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden))
        QFile::remove(file.filePath());
    for (auto file = files.begin(); file != files.end(); ++file) {
        QFile bytes(QDir(folder).filePath(file.key()));
        if (!bytes.open(QIODevice::WriteOnly) || bytes.write(file.value()) != file.value().size())
            qFatal("The test cannot write.");
    }
}

bool isTemporary(const QString& fileName)
{
    return fileName.startsWith(QLatin1String(".espalier-"));
}

Jobs::Jobs(std::size_t internodes, int textureSize) : m_textureSize(textureSize)
{
    m_document.reset(5);
    GrowGesture growing(m_document);
    while (m_document.tree().size() < internodes && growing.step()) {
    }
    growing.finish();
    m_before = projectOf(m_document, QStringLiteral("Oak"));
    m_follower.start();
    GrowGesture gesture(m_document);
    for (int i = 0; i < 2; ++i)
        gesture.step();
    gesture.finish();
    m_after = projectOf(m_document, QStringLiteral("Oak"));
    m_bytes = *packProject(m_after);
    const std::optional<HistoryChange> change = m_follower.collect(std::chrono::seconds(10));
    QSet<QString> images;
    m_change = *packChange(*change, images);
}

std::vector<Job> Jobs::all()
{
    std::vector<Job> all;
    all.push_back({QStringLiteral("save"),
                   [this](const QString& folder) {
                       return writeOutput(m_after, folder + QStringLiteral("/oak.espalier"));
                   },
                   isOldOrNew});
    for (const ExportFormat* format : exportFormats()) {
        all.push_back({QStringLiteral("export .") + format->suffix(),
                       [this, format](const QString& folder) {
                           return exportAfter(folder + QStringLiteral("/oak.") + format->suffix());
                       },
                       isOldOrNew});
    }
    all.push_back({QStringLiteral("begin a safety copy"),
                   [this](const QString& folder) -> Result<void> {
                       const SafetyCopy copy(folder + QStringLiteral("/copy"));
                       if (Result<void> origin = copy.writeOrigin({}); !origin)
                           return origin;
                       const Result<SafetyCopy::Written> written = copy.writeProject(m_after);
                       return written ? Result<void>() : written.error();
                   },
                   [](const Files& found, const Files& before, const Files& after) {
                       const QString project = QStringLiteral("copy.espalier");
                       return found.value(project) == before.value(project) ||
                              found.value(project) == after.value(project);
                   }});
    all.push_back({QStringLiteral("add to a safety copy"),
                   [this](const QString& folder) -> Result<void> {
                       const SafetyCopy copy(folder + QStringLiteral("/copy"));
                       Result<SafetyCopy::Written> written = copy.writeProject(m_before);
                       return written ? copy.addChange(m_change, *written) : written.error();
                   },
                   [this](const Files&, const Files&, const Files&) {
                       const Result<Project> read =
                           SafetyCopy(m_folder.filePath(QStringLiteral("copy"))).read();
                       return read && (read->tree == m_before.tree || read->tree == m_after.tree);
                   },
                   QStringLiteral("copy.changes")});
    return all;
}

Result<void> Jobs::exportAfter(const QString& fileName) const
{
    const Tree tree = shownTree(m_after);
    return exportTree(tree, TreeIndex(tree), m_after.name, fileName, {.textureSize = m_textureSize});
}

Result<void> Jobs::prepare(const Job& job)
{
    put(folder(), {});
    std::swap(m_before, m_after);
    Result<void> done = job.work(folder());
    std::swap(m_before, m_after);
    return done;
}

bool Jobs::hasDocumentChanged() const
{
    const Result<QByteArray> bytes = packProject(projectOf(m_document, QStringLiteral("Oak")));
    return !bytes || *bytes != m_bytes;
}

} // namespace espalier::test
