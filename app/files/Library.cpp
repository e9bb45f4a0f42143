// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Library.h"

#include "commands/recipe/Recipe.h"
#include "model/io/FileWriter.h"
#include "model/io/project/ProjectFile.h"

#include <QCollator>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace espalier {

namespace {

const QString kSuffix = QStringLiteral(".espalier");
const QString kRecipeSuffix = QStringLiteral("json");
const QString kTrash = QStringLiteral("Trash");
/// Bytes of a name: the limit of file systems, without the room for a number and the suffix.
constexpr qsizetype kMostBytes = 200;

/// The name without a number at its end, and that number, or 1.
std::pair<QString, int> numbered(const QString& name)
{
    const qsizetype space = name.lastIndexOf(QLatin1Char(' '));
    bool isNumber = false;
    const int number = name.mid(space + 1).toInt(&isNumber);
    if (space > 0 && isNumber && number > 1 && number < 100'000)
        return {name.left(space), number};
    return {name, 1};
}

/// The first of "name", "name 2", "name 3"... that is free in @p folder.
QString freePath(const QDir& folder, const QString& name)
{
    const auto [stem, number] = numbered(name);
    QString path = folder.filePath(name + kSuffix);
    for (int next = number + 1; QFileInfo::exists(path); ++next)
        path = folder.filePath(QStringLiteral("%1 %2").arg(stem).arg(next) + kSuffix);
    return path;
}

bool isRecipe(const QString& fileName)
{
    return QFileInfo(fileName).suffix() == kRecipeSuffix;
}

} // namespace

Library::Library(QString folder)
    : Library(std::move(folder), [](const QString& fileName) {
          QString path;
          return QFile::moveToTrash(fileName, &path) ? std::optional(path) : std::nullopt;
      })
{
}

Library::Library(QString folder, SystemTrash systemTrash)
    : m_folder(QDir::cleanPath(folder)), m_systemTrash(std::move(systemTrash))
{
}

bool Library::holds(const QString& fileName) const
{
    return !fileName.isEmpty() &&
           QFileInfo(fileName).absolutePath() == QFileInfo(m_folder).absoluteFilePath();
}

std::vector<LibraryEntry> Library::trees() const
{
    std::vector<LibraryEntry> found;
    const QDir place(m_folder);
    for (const QFileInfo& file : place.entryInfoList({QLatin1Char('*') + kSuffix}, QDir::Files, QDir::Time))
        found.push_back({file.absoluteFilePath(), file.completeBaseName(), {}, file.lastModified()});
    return found;
}

std::vector<LibraryEntry> Library::species()
{
    std::vector<LibraryEntry> found;
    const QDir place(QStringLiteral(":/recipes"));
    for (const QString& file : place.entryList({QLatin1String("*.") + kRecipeSuffix}, QDir::Files)) {
        const QString path = place.filePath(file);
        if (const Result<Recipe> recipe = readRecipe(path)) {
            const QString name = recipe->name.isEmpty() ? QFileInfo(file).completeBaseName() : recipe->name;
            found.push_back({path, name, recipe->description, {}});
        }
    }
    std::ranges::sort(found, QCollator(), &LibraryEntry::name);
    return found;
}

QString Library::problemWith(const QString& name)
{
    if (name.trimmed().isEmpty())
        return tr("A tree needs a name.");
    if (name.startsWith(QLatin1Char('.')))
        return tr("A name cannot begin with a full stop.");
    for (const QChar character : name) {
        if (QStringLiteral("/\\:*?\"<>|").contains(character) || !character.isPrint())
            return tr("A name cannot contain any of / \\ : * ? \" < > |.");
    }
    if (name.toUtf8().size() > kMostBytes)
        return tr("This name is too long.");
    return {};
}

QString Library::pathFor(const QString& name) const
{
    return QDir(QFileInfo(m_folder).absoluteFilePath()).filePath(name + kSuffix);
}

Result<void> Library::makeFolder(const QString& folder) const
{
    if (QDir().mkpath(folder))
        return {};
    return Error{Error::Kind::Output,
                 tr("The folder %1 cannot be created.").arg(QDir::toNativeSeparators(folder))};
}

Result<QString> Library::newFile(const QString& name) const
{
    if (const Result<void> made = makeFolder(m_folder); !made)
        return made.error();
    const QString wanted = problemWith(name).isEmpty() ? name.trimmed() : tr("Tree");
    return freePath(QFileInfo(pathFor(wanted)).absoluteDir(), wanted);
}

Result<QString> Library::rename(const QString& fileName, const QString& name) const
{
    const QString wanted = name.trimmed();
    if (const QString problem = problemWith(wanted); !problem.isEmpty())
        return Error{Error::Kind::Input, problem};
    const QString path = pathFor(wanted);
    if (path == QFileInfo(fileName).absoluteFilePath())
        return path;
    if (QFileInfo::exists(path))
        return Error{Error::Kind::Input, tr("There is already a tree named %1.").arg(wanted)};
    QFile file(fileName);
    if (!file.rename(path))
        return Error{
            Error::Kind::Output,
            tr("%1 cannot be renamed: %2").arg(QFileInfo(fileName).completeBaseName(), file.errorString())};
    return path;
}

Result<QString> Library::duplicate(const QString& fileName) const
{
    const QFileInfo original(fileName);
    const QString path = freePath(original.absoluteDir(), original.completeBaseName());
    if (const Result<void> copied = copyFile(fileName, path); !copied) {
        return Error{Error::Kind::Output,
                     tr("%1 cannot be copied: %2").arg(original.completeBaseName(), copied.error().message)};
    }
    return path;
}

Result<Library::Trashed> Library::moveToTrash(const QString& fileName) const
{
    const QFileInfo original(fileName);
    const QString name = original.completeBaseName();
    if (!original.exists())
        return Error{Error::Kind::Input, tr("%1 is no longer there.").arg(name)};
    if (const std::optional<QString> path = m_systemTrash(fileName))
        return Trashed{fileName, *path, true};
    const QString trash = QDir(original.absolutePath()).filePath(kTrash);
    if (const Result<void> made = makeFolder(trash); !made)
        return made.error();
    const QString path = freePath(QDir(trash), name);
    QFile file(fileName);
    if (!file.rename(path))
        return Error{Error::Kind::Output,
                     tr("%1 cannot be moved to the trash: %2").arg(name, file.errorString())};
    return Trashed{fileName, path, false};
}

Result<void> Library::restore(const Trashed& trashed) const
{
    const QString name = QFileInfo(trashed.original).completeBaseName();
    if (QFileInfo::exists(trashed.original))
        return Error{Error::Kind::Output, tr("There is another tree named %1 now.").arg(name)};
    QFile file(trashed.path);
    if (trashed.path.isEmpty() || !file.rename(trashed.original))
        return Error{Error::Kind::Output,
                     tr("%1 cannot be taken out of the trash: %2").arg(name, file.errorString())};
    // The note of the system's trash about the file, by the standard of freedesktop.org.
    const QFileInfo place(trashed.path);
    const QDir trash = QFileInfo(place.absolutePath()).dir();
    if (trashed.isSystems)
        QFile::remove(trash.filePath(QStringLiteral("info/%1.trashinfo").arg(place.fileName())));
    return {};
}

Result<QImage> libraryPicture(const QString& fileName)
{
    if (!isRecipe(fileName))
        return readThumbnail(fileName);
    const QFileInfo recipe(fileName);
    return QImage(QStringLiteral(":/thumbnails/%1.jpg").arg(recipe.completeBaseName()));
}

} // namespace espalier
