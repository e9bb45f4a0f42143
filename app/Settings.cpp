// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Settings.h"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace espalier {

namespace {

const QString kRecentFiles = QStringLiteral("files/recent");
const QString kFolder = QStringLiteral("files/folder");
const QString kLibraryFolder = QStringLiteral("library/folder");
const QString kExportSuffix = QStringLiteral("files/exportSuffix");
const QString kAutosaveInterval = QStringLiteral("files/autosaveInterval");
const QString kTourSeen = QStringLiteral("help/tourSeen");
const QString kWindowGeometry = QStringLiteral("window/geometry");

/// Calls @p visit(key, field) for each value that is remembered. Backdrop and sun stay as they are at the
/// start.
template <class Values, class Visit>
void visitViewValues(Values& values, Visit&& visit)
{
    visit(QStringLiteral("view/brushRadius"), values.brushRadius);
    visit(QStringLiteral("view/pressureScales"), values.pressureScales);
    visit(QStringLiteral("view/markersShown"), values.markersShown);
    visit(QStringLiteral("view/envelopeShown"), values.envelopeShown);
    visit(QStringLiteral("view/planeShown"), values.planeShown);
    visit(QStringLiteral("view/bendingWeight"), values.bendingWeight);
    visit(QStringLiteral("view/stretchingWeight"), values.stretchingWeight);
    visit(QStringLiteral("view/groundShown"), values.groundShown);
    visit(QStringLiteral("view/shadowsShown"), values.shadowsShown);
}

} // namespace

ViewValues Settings::viewValues() const
{
    const QSettings store;
    ViewValues values;
    visitViewValues(values, [&](const QString& key, auto& field) {
        using Field = std::remove_reference_t<decltype(field)>;
        const QVariant stored = store.value(key, field);
        if (stored.canConvert<Field>())
            field = stored.value<Field>();
    });
    return values;
}

void Settings::setViewValues(const ViewValues& values)
{
    QSettings store;
    visitViewValues(values, [&](const QString& key, const auto& field) { store.setValue(key, field); });
}

QStringList Settings::recentFiles() const
{
    QStringList files = QSettings().value(kRecentFiles).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void Settings::addRecentFile(const QString& fileName)
{
    const QString path = QFileInfo(fileName).absoluteFilePath();
    QStringList files = QSettings().value(kRecentFiles).toStringList();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(kRecentFiles, QStringList(files.mid(0, kMaxRecentFiles)));
}

void Settings::clearRecentFiles()
{
    QSettings().remove(kRecentFiles);
}

QString Settings::folder() const
{
    const QString folder = QSettings().value(kFolder).toString();
    if (!folder.isEmpty() && QFileInfo(folder).isDir())
        return folder;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void Settings::setFolder(const QString& folder)
{
    QSettings().setValue(kFolder, folder);
}

QString Settings::libraryFolder() const
{
    const QString folder = QSettings().value(kLibraryFolder).toString();
    if (!folder.isEmpty())
        return folder;
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/library");
}

void Settings::setLibraryFolder(const QString& folder)
{
    QSettings().setValue(kLibraryFolder, folder);
}

QString Settings::exportSuffix() const
{
    return QSettings().value(kExportSuffix, QStringLiteral("glb")).toString();
}

void Settings::setExportSuffix(const QString& suffix)
{
    QSettings().setValue(kExportSuffix, suffix);
}

QByteArray Settings::windowGeometry() const
{
    return QSettings().value(kWindowGeometry).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry)
{
    QSettings().setValue(kWindowGeometry, geometry);
}

bool Settings::isTourSeen() const
{
    return QSettings().value(kTourSeen, false).toBool();
}

void Settings::setTourSeen(bool seen)
{
    QSettings().setValue(kTourSeen, seen);
}

int Settings::autosaveInterval() const
{
    return std::clamp(QSettings().value(kAutosaveInterval, 20).toInt(), 1, 3600);
}

} // namespace espalier
