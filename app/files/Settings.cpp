// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Settings.h"

#include "model/io/FileWriter.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <cmath>

namespace espalier {

namespace {

const QString kRecentFiles = QStringLiteral("files/recent");
const QString kFolder = QStringLiteral("files/folder");
const QString kLibraryFolder = QStringLiteral("library/folder");
const QString kExportSuffix = QStringLiteral("files/exportSuffix");
const QString kLook = QStringLiteral("window/theme");
const QString kToolsRight = QStringLiteral("window/toolsRight");
const QString kPressureExponent = QStringLiteral("hand/pressureExponent");
const QString kMouse = QStringLiteral("hand/mouse");
const QString kUndoSteps = QStringLiteral("hand/undoSteps");
const QString kAutosaveInterval = QStringLiteral("files/autosaveInterval");
const QString kTourSeen = QStringLiteral("help/tourSeen");
const QString kLanguage = QStringLiteral("window/language");
const QString kUnits = QStringLiteral("window/units");
const QString kTreeSize = QStringLiteral("newTree/size");
const QString kWindowGeometry = QStringLiteral("window/geometry");

/// Qt's settings, written only while the disk has room for them: Qt 6.4 replaces their file even if the new
/// one could not be written, so a full disk would empty it.
class Store {
public:
    void setValue(const QString& key, const QVariant& value)
    {
        if (m_hasRoom)
            m_store.setValue(key, value);
    }
    void remove(const QString& key)
    {
        if (m_hasRoom)
            m_store.remove(key);
    }

private:
    static bool hasRoom(const QString& fileName)
    {
        constexpr qsizetype kRoom = 1 << 17; // bytes; more than settings take
        QDir().mkpath(QFileInfo(fileName).path());
        FileWriter probe(fileName);
        return probe.write(QByteArray(kRoom, ' ')) == kRoom;
    }

    QSettings m_store;
    bool m_hasRoom = hasRoom(m_store.fileName());
};

/// Calls @p visit(key, field) for each value that is stored. Whether leaves and fibres show is not stored: a
/// new tree without leaves or bark would be a surprise.
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
    visit(QStringLiteral("view/twistsSubtree"), values.twistsSubtree);
    visit(QStringLiteral("view/secondTree"), values.secondTree);
    visit(QStringLiteral("view/depthHull"), values.depthHull);
    visit(QStringLiteral("view/depthLength"), values.depthLength);
    visit(QStringLiteral("view/depthAngle"), values.depthAngle);
    visit(QStringLiteral("view/variation"), values.variation);
    visit(QStringLiteral("view/newBuds"), values.newBuds);
    visit(QStringLiteral("view/budSpacing"), values.budSpacing);
    visit(QStringLiteral("view/groundShown"), values.groundShown);
    visit(QStringLiteral("view/shadowsShown"), values.shadowsShown);
    visit(QStringLiteral("view/gridShown"), values.gridShown);
    visit(QStringLiteral("view/personShown"), values.personShown);
    visit(QStringLiteral("view/backdrop"), values.backdrop);
    visit(QStringLiteral("view/backgroundColour"), values.backgroundColour);
    visit(QStringLiteral("view/backgroundTop"), values.backgroundTop);
    visit(QStringLiteral("view/sunAzimuth"), values.sunAzimuth);
    visit(QStringLiteral("view/sunElevation"), values.sunElevation);
    visit(QStringLiteral("view/sunPinned"), values.sunPinned);
    visit(QStringLiteral("view/sunShown"), values.sunShown);
    visit(QStringLiteral("view/tracing/file"), values.tracing.file);
    visit(QStringLiteral("view/tracing/right"), values.tracing.right);
    visit(QStringLiteral("view/tracing/up"), values.tracing.up);
    visit(QStringLiteral("view/tracing/height"), values.tracing.height);
    visit(QStringLiteral("view/tracing/opacity"), values.tracing.opacity);
}

} // namespace

Preferences Settings::preferences() const
{
    const QSettings store;
    Preferences values;
    const auto read = [&store](const QString& key, auto& field, int last) {
        bool isNumber = false;
        const int stored = store.value(key, static_cast<int>(field)).toInt(&isNumber);
        if (isNumber && stored >= 0 && stored <= last)
            field = static_cast<std::remove_reference_t<decltype(field)>>(stored);
    };
    read(kLook, values.look, static_cast<int>(Look::System));
    read(kMouse, values.mouse, static_cast<int>(MouseScheme::Maya));
    read(kUnits, values.units, static_cast<int>(Units::Imperial));
    values.areToolsRight = store.value(kToolsRight, values.areToolsRight).toBool();
    bool isNumber = false;
    const double exponent = store.value(kPressureExponent, values.pressureExponent).toDouble(&isNumber);
    if (isNumber && std::isfinite(exponent))
        values.pressureExponent = std::clamp(exponent, Preferences::kSoftest, Preferences::kFirmest);
    values.autosaveInterval = std::clamp(store.value(kAutosaveInterval, values.autosaveInterval).toInt(), 1,
                                         Preferences::kLongestInterval);
    values.undoSteps =
        std::clamp(store.value(kUndoSteps, values.undoSteps).toInt(), 0, Preferences::kMostUndoSteps);
    values.libraryFolder = store.value(kLibraryFolder).toString();
    if (const QString language = store.value(kLanguage).toString();
        Preferences::languages().contains(language))
        values.language = language;
    return values;
}

void Settings::setPreferences(const Preferences& preferences)
{
    Store store;
    store.setValue(kLook, static_cast<int>(preferences.look));
    store.setValue(kToolsRight, preferences.areToolsRight);
    store.setValue(kPressureExponent, preferences.pressureExponent);
    store.setValue(kMouse, static_cast<int>(preferences.mouse));
    store.setValue(kAutosaveInterval, preferences.autosaveInterval);
    store.setValue(kUndoSteps, preferences.undoSteps);
    store.setValue(kLibraryFolder, preferences.libraryFolder);
    store.setValue(kLanguage, preferences.language);
    store.setValue(kUnits, static_cast<int>(preferences.units));
}

ViewValues Settings::viewValues() const
{
    const QSettings store;
    ViewValues values;
    values.brushRadius = sizePreset(treeSize()).brushRadius;
    visitViewValues(values, [&](const QString& key, auto& field) {
        using Field = std::remove_reference_t<decltype(field)>;
        if constexpr (std::is_same_v<Field, Backdrop>) {
            const int stored = store.value(key, static_cast<int>(field)).toInt();
            if (stored >= 0 && stored < kBackdropCount)
                field = static_cast<Backdrop>(stored);
        } else {
            const QVariant stored = store.value(key, QVariant::fromValue(field));
            if (stored.canConvert<Field>())
                field = stored.value<Field>();
        }
    });
    return values;
}

void Settings::setViewValues(const ViewValues& values)
{
    Store store;
    visitViewValues(values, [&](const QString& key, const auto& field) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, Backdrop>)
            store.setValue(key, static_cast<int>(field));
        else
            store.setValue(key, field);
    });
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
    Store().setValue(kRecentFiles, QStringList(files.mid(0, kMaxRecentFiles)));
}

void Settings::clearRecentFiles()
{
    Store().remove(kRecentFiles);
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
    Store().setValue(kFolder, folder);
}

QString Settings::libraryFolder() const
{
    const QString folder = preferences().libraryFolder;
    if (!folder.isEmpty())
        return folder;
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/library");
}

QString Settings::exportSuffix() const
{
    return QSettings().value(kExportSuffix, QStringLiteral("glb")).toString();
}

void Settings::setExportSuffix(const QString& suffix)
{
    Store().setValue(kExportSuffix, suffix);
}

TreeSize Settings::treeSize() const
{
    const QString stored = QSettings().value(kTreeSize).toString();
    for (int i = 0; i < kTreeSizeCount; ++i) {
        if (stored == QLatin1String(sizePreset(static_cast<TreeSize>(i)).key))
            return static_cast<TreeSize>(i);
    }
    return TreeSize::StreetTree;
}

void Settings::setTreeSize(TreeSize size)
{
    Store().setValue(kTreeSize, QString::fromLatin1(sizePreset(size).key));
}

QByteArray Settings::windowGeometry() const
{
    return QSettings().value(kWindowGeometry).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry)
{
    Store().setValue(kWindowGeometry, geometry);
}

bool Settings::isTourSeen() const
{
    return QSettings().value(kTourSeen, false).toBool();
}

void Settings::setTourSeen(bool seen)
{
    Store().setValue(kTourSeen, seen);
}

} // namespace espalier
