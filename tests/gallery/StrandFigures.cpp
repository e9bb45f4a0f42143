// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the pictures that show what strands and sketches do: figures of Strands 2024 and Okabe 2005, one
// sheet each, from the samples. Arguments: a table of sheets (tests/gallery/strand-figures.json), the folder
// that its file names are relative to, and names of sheets if not all of them are wanted. scripts/pictures.sh
// runs it.
#include "app/cli/ParameterOverrides.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/base/Vector.h"
#include "model/io/FileWriter.h"
#include "model/mesh/TreeCounts.h"
#include "views/render/GlResources.h"
#include "views/render/OffscreenRenderer.h"

#include <QApplication>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QSurfaceFormat>

#include <cstdio>

using namespace espalier;

namespace {

constexpr int kQuality = 82; ///< Of JPEG
constexpr int kGap = 2;      ///< Between the pictures of a sheet, px

[[noreturn]] void fail(const QString& message)
{
    std::fprintf(stderr, "strand_figures: %s\n", qPrintable(message));
    std::exit(1);
}

/// One tree, seen from one side.
struct Shot {
    QString recipe;          ///< File
    QStringList sets;        ///< Parameters, as for --set
    int operations = -1;     ///< How many of the recipe's operations are played; all if below 0
    double azimuth = 0.0;    ///< Degrees, 0 from the front
    double elevation = 0.0;  ///< Degrees above the horizon
    std::optional<Box3> box; ///< What the picture frames, m; the whole tree if there is none
};

Shot shotOf(const QJsonObject& json)
{
    Shot shot;
    shot.recipe = json.value(QStringLiteral("recipe")).toString();
    for (const QJsonValue value : json.value(QStringLiteral("set")).toArray())
        shot.sets.append(value.toString());
    shot.operations = json.value(QStringLiteral("operations")).toInt(-1);
    shot.azimuth = json.value(QStringLiteral("azimuth")).toDouble();
    shot.elevation = json.value(QStringLiteral("elevation")).toDouble();
    if (const QJsonArray box = json.value(QStringLiteral("box")).toArray(); box.size() == 6) {
        const auto at = [&box](int i) { return static_cast<float>(box.at(i).toDouble()); };
        shot.box = Box3(Vec3(at(0), at(1), at(2)), Vec3(at(3), at(4), at(5)));
    }
    return shot;
}

/// Keeps the tree that was drawn last: the shots of a sheet often show the same one.
class Painter {
public:
    Painter()
    {
        Result<std::unique_ptr<OffscreenRenderer>> renderer = OffscreenRenderer::create();
        if (!renderer)
            fail(renderer.error().message);
        m_renderer = std::move(*renderer);
    }

    QImage draw(const Shot& shot, const QSize& size)
    {
        show(shot);
        Camera camera = pictureCamera(NamedView::Front, *m_scene, size);
        camera.setAzimuth(static_cast<float>(radians(shot.azimuth)));
        camera.setElevation(static_cast<float>(radians(shot.elevation)));
        camera = camera.framing(shot.box.value_or(treeBounds(m_document->tree(), m_document->index())));
        Result<QImage> picture = m_renderer->render(*m_scene, camera, {});
        if (!picture)
            fail(picture.error().message);
        return *picture;
    }

private:
    void show(const Shot& shot)
    {
        const QString key = shot.recipe + shot.sets.join(QLatin1Char(' ')) + QString::number(shot.operations);
        if (key == m_key)
            return;
        Result<Recipe> recipe = readRecipe(shot.recipe);
        if (!recipe)
            fail(recipe.error().message);
        ParameterOverrides overrides;
        for (const QString& set : shot.sets) {
            if (const Result<void> added = overrides.add(set); !added)
                fail(added.error().message);
        }
        overrides.applyTo(*recipe);
        if (shot.operations >= 0)
            recipe->operations.erase(recipe->operations.begin() + shot.operations, recipe->operations.end());
        m_scene.reset();
        m_document = std::make_unique<TreeDocument>();
        RecipePlayer player(*m_document, std::move(*recipe));
        player.playAll();
        if (!player.warnings().isEmpty())
            fail(shot.recipe + QStringLiteral(": ") + player.warnings().constFirst());
        m_scene = std::make_unique<TreeScene>(*m_document);
        m_scene->prepareStrands();
        m_key = key;
    }

    std::unique_ptr<OffscreenRenderer> m_renderer;
    std::unique_ptr<TreeDocument> m_document;
    std::unique_ptr<TreeScene> m_scene;
    QString m_key; ///< Of the document
};

/// A sheet has `file`, `size` (of each picture, px) and `shots`, from left to right, `columns` in a row: all
/// of them, if it is left out.
void drawSheet(Painter& by, const QJsonObject& sheet)
{
    const QJsonArray sides = sheet.value(QStringLiteral("size")).toArray();
    const QSize size(sides.at(0).toInt(), sides.at(1).toInt());
    const QJsonArray shots = sheet.value(QStringLiteral("shots")).toArray();
    const int count = static_cast<int>(shots.size());
    const int columns = std::max(sheet.value(QStringLiteral("columns")).toInt(count), 1);
    const QSize step = size + QSize(kGap, kGap);
    const int rows = (count + columns - 1) / columns;
    QImage image(columns * step.width() - kGap, rows * step.height() - kGap, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    for (int i = 0; i < count; ++i) {
        const QImage picture = by.draw(shotOf(shots.at(i).toObject()), 2 * size);
        painter.drawImage(i % columns * step.width(), i / columns * step.height(),
                          picture.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    const QString file = sheet.value(QStringLiteral("file")).toString();
    if (!image.save(&buffer, "jpg", kQuality))
        fail(file + QStringLiteral(" could not be compressed"));
    if (const Result<void> written = writeFile(file, bytes); !written)
        fail(written.error().message);
    std::printf("%s %lld\n", qPrintable(file), static_cast<long long>(bytes.size()));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    const QApplication application(argc, argv);
    if (argc < 3) {
        std::fprintf(stderr, "usage: strand_figures TABLE FOLDER [NAME...]\n");
        return 2;
    }
    QFile table(QString::fromLocal8Bit(argv[1]));
    if (!table.open(QIODevice::ReadOnly))
        fail(table.fileName() + QStringLiteral(" cannot be read"));
    QJsonParseError error;
    const QJsonArray sheets = QJsonDocument::fromJson(table.readAll(), &error).array();
    if (sheets.isEmpty())
        fail(table.fileName() + QStringLiteral(": ") + error.errorString());
    if (!QDir::setCurrent(QString::fromLocal8Bit(argv[2])))
        fail(QStringLiteral("the folder does not exist"));
    const QStringList names = QApplication::arguments().mid(3);
    Painter by;
    for (const QJsonValue value : sheets) {
        const QJsonObject sheet = value.toObject();
        const QString file = sheet.value(QStringLiteral("file")).toString();
        if (names.isEmpty() || names.contains(QFileInfo(file).completeBaseName()))
            drawSheet(by, sheet);
    }
    return 0;
}
