// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Settings.h"

#include "model/io/FileWriter.h"
#include "panels/SettingsSheet.h"

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
const QString kPictureSize = QStringLiteral("picture/size");
const QString kPictureView = QStringLiteral("picture/view");
const QString kPictureTransparent = QStringLiteral("picture/transparent");
const QString kPictureShadow = QStringLiteral("picture/shadow");
const QString kLook = QStringLiteral("window/theme");
const QString kToolsRight = QStringLiteral("window/toolsRight");
const QString kPressureExponent = QStringLiteral("hand/pressureExponent");
const QString kStabiliserDistance = QStringLiteral("hand/stabiliserDistance");
const QString kStabiliserDelay = QStringLiteral("hand/stabiliserDelay");
const QString kMouse = QStringLiteral("hand/mouse");
const QString kUndoSteps = QStringLiteral("hand/undoSteps");
const QString kUndoMemory = QStringLiteral("hand/undoMemory");
const QString kTourSeen = QStringLiteral("help/tourSeen");
const QString kLanguage = QStringLiteral("window/language");
const QString kUnits = QStringLiteral("window/units");
const QString kInterfaceScale = QStringLiteral("window/scale");
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
    visit(QStringLiteral("view/prunesThrough"), values.prunesThrough);
    visit(QStringLiteral("view/eraserThickest"), values.eraserThickest);
    visit(QStringLiteral("view/thinShare"), values.thinShare);
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
    visit(QStringLiteral("view/personShown"), values.personShown);
    visit(QStringLiteral("view/secondViewShown"), values.secondViewShown);
}

/// Calls @p visit(key, field) for each value of a look that is stored. The picture to draw after belongs to
/// one tree.
template <class Look, class Visit>
void visitLook(Look& look, Visit&& visit)
{
    visit(QStringLiteral("view/groundShown"), look.groundShown);
    visit(QStringLiteral("view/shadowsShown"), look.shadowsShown);
    visit(QStringLiteral("view/gridShown"), look.gridShown);
    visit(QStringLiteral("view/backdrop"), look.backdrop);
    visit(QStringLiteral("view/backgroundColour"), look.backgroundColour);
    visit(QStringLiteral("view/backgroundTop"), look.backgroundTop);
    visit(QStringLiteral("view/sunAzimuth"), look.sunAzimuth);
    visit(QStringLiteral("view/sunElevation"), look.sunElevation);
    visit(QStringLiteral("view/sunPinned"), look.sunPinned);
    visit(QStringLiteral("view/sunShown"), look.sunShown);
}

template <class Field>
void readField(const QSettings& store, const QString& key, Field& field)
{
    if constexpr (std::is_same_v<Field, Backdrop>) {
        const int stored = store.value(key, static_cast<int>(field)).toInt();
        if (stored >= 0 && stored < kBackdropCount)
            field = static_cast<Backdrop>(stored);
    } else {
        const QVariant stored = store.value(key, QVariant::fromValue(field));
        if (stored.canConvert<Field>())
            field = stored.value<Field>();
    }
}

template <class Field>
void writeField(Store& store, const QString& key, const Field& field)
{
    if constexpr (std::is_same_v<Field, Backdrop>)
        store.setValue(key, static_cast<int>(field));
    else
        store.setValue(key, field);
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
    const auto readUpTo = [&](const QString& key, double& field, double greatest) {
        const double stored = store.value(key, field).toDouble(&isNumber);
        if (isNumber && std::isfinite(stored))
            field = std::clamp(stored, 0.0, greatest);
    };
    readUpTo(kStabiliserDistance, values.stabilising.distance, Stabilising::kGreatestDistance);
    readUpTo(kStabiliserDelay, values.stabilising.delay, Stabilising::kLongestDelay);
    values.undoSteps =
        std::clamp(store.value(kUndoSteps, values.undoSteps).toInt(), 0, Preferences::kMostUndoSteps);
    values.undoMemory = std::clamp(store.value(kUndoMemory, values.undoMemory).toInt(),
                                   Preferences::kLeastUndoMemory, Preferences::kMostUndoMemory);
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
    store.setValue(kStabiliserDistance, preferences.stabilising.distance);
    store.setValue(kStabiliserDelay, preferences.stabilising.delay);
    store.setValue(kMouse, static_cast<int>(preferences.mouse));
    store.setValue(kUndoSteps, preferences.undoSteps);
    store.setValue(kUndoMemory, preferences.undoMemory);
    store.setValue(kLibraryFolder, preferences.libraryFolder);
    store.setValue(kLanguage, preferences.language);
    store.setValue(kUnits, static_cast<int>(preferences.units));
}

ViewValues Settings::viewValues() const
{
    const QSettings store;
    ViewValues values;
    values.brushRadius = sizePreset(treeSize()).brushRadius;
    visitViewValues(values, [&](const QString& key, auto& field) { readField(store, key, field); });
    return values;
}

void Settings::setViewValues(const ViewValues& values)
{
    Store store;
    visitViewValues(values, [&](const QString& key, const auto& field) { writeField(store, key, field); });
}

SceneLook Settings::lookOfNewTrees() const
{
    const QSettings store;
    SceneLook look;
    visitLook(look, [&](const QString& key, auto& field) { readField(store, key, field); });
    return look;
}

void Settings::setLookOfNewTrees(const SceneLook& look)
{
    Store store;
    visitLook(look, [&](const QString& key, const auto& field) { writeField(store, key, field); });
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

PictureSettings Settings::pictureSettings() const
{
    const QSettings store;
    PictureSettings picture;
    const QSize size = store.value(kPictureSize).toSize();
    const auto isEdge = [](int edge) {
        return edge >= PictureSettings::kLeastEdge && edge <= PictureSettings::kMostEdge;
    };
    if (isEdge(size.width()) && isEdge(size.height()))
        picture.size = size;
    if (const int view = store.value(kPictureView).toInt(); view > 0 && view < PictureSettings::kViewCount)
        picture.view = static_cast<PictureSettings::View>(view);
    picture.transparent = store.value(kPictureTransparent, picture.transparent).toBool();
    picture.shadow = store.value(kPictureShadow, picture.shadow).toBool();
    return picture;
}

void Settings::setPictureSettings(const PictureSettings& picture)
{
    Store store;
    store.setValue(kPictureSize, picture.size);
    store.setValue(kPictureView, static_cast<int>(picture.view));
    store.setValue(kPictureTransparent, picture.transparent);
    store.setValue(kPictureShadow, picture.shadow);
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

void Settings::scaleInterface() const
{
    const int percent = interfaceScale();
    if (percent != 100 && !qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        qputenv("QT_SCALE_FACTOR", QByteArray::number(percent / 100.0));
}

int Settings::interfaceScale() const
{
    const QList<int> scales = SettingsSheet::scales();
    const int stored = QSettings().value(kInterfaceScale, scales.constFirst()).toInt();
    return scales.contains(stored) ? stored : scales.constFirst();
}

void Settings::setInterfaceScale(int percent)
{
    Store().setValue(kInterfaceScale, percent);
}

} // namespace espalier
