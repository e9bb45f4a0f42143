// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/LookEntry.h"

#include "model/io/JsonReader.h"
#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectText.h"

#include <QJsonDocument>

#include <algorithm>
#include <numbers>

namespace espalier {

namespace {

constexpr char kLookEntry[] = "look.json";
constexpr std::uint64_t kMostLookBytes = 1 << 16;

constexpr double kPi = std::numbers::pi;

QStringList backdropNames()
{
    return QString::fromLatin1(kBackdropNames).split(QLatin1Char(' '));
}

bool readSwitch(JsonReader& reader, const char* key)
{
    const QJsonValue value = reader.value(QLatin1StringView(key));
    if (!value.isBool())
        reader.fail(QLatin1StringView(key), ProjectText::tr("true or false is expected"));
    return value.toBool();
}

QColor readColour(JsonReader& reader, const char* key)
{
    const QString text = reader.text(QLatin1StringView(key));
    const QColor colour(text);
    if (text.size() == 7 && text.startsWith(QLatin1Char('#')) && colour.isValid())
        return QColor(colour.rgb());
    reader.fail(QLatin1StringView(key), ProjectText::tr("a colour such as #5c6268 is expected"));
    return QColor(Qt::black);
}

QJsonObject toJson(const TracingImage& tracing)
{
    QJsonObject json{{QStringLiteral("right"), tracing.right},
                     {QStringLiteral("up"), tracing.up},
                     {QStringLiteral("height"), tracing.height},
                     {QStringLiteral("opacity"), tracing.opacity}};
    if (!tracing.image.isNull()) {
        json[QStringLiteral("image")] = tracing.image.hash();
        json[QStringLiteral("name")] = tracing.image.name();
    }
    return json;
}

QJsonObject toJson(const SceneLook& look)
{
    const QJsonObject sun{{QStringLiteral("azimuth"), look.sunAzimuth},
                          {QStringLiteral("elevation"), look.sunElevation},
                          {QStringLiteral("pinned"), look.sunPinned},
                          {QStringLiteral("shown"), look.sunShown}};
    return {{QStringLiteral("ground"), look.groundShown},
            {QStringLiteral("grid"), look.gridShown},
            {QStringLiteral("shadows"), look.shadowsShown},
            {QStringLiteral("backdrop"), backdropNames().at(static_cast<int>(look.backdrop))},
            {QStringLiteral("colour"), look.backgroundColour.name()},
            {QStringLiteral("topColour"), look.backgroundTop.name()},
            {QStringLiteral("sun"), sun},
            {QStringLiteral("picture"), toJson(look.tracing)}};
}

/// Reads the member "picture"; @p hash and @p name are those of its image, or empty.
TracingImage readTracing(JsonReader& whole, QString& hash, QString& name)
{
    const QLatin1StringView key("picture");
    JsonReader reader(whole.object(key), whole.placeOf(key));
    TracingImage tracing;
    constexpr double kOffset = TracingImage::kMaxOffset;
    tracing.right = reader.number(QLatin1StringView("right"), -kOffset, kOffset);
    tracing.up = reader.number(QLatin1StringView("up"), -kOffset, kOffset);
    tracing.height =
        reader.number(QLatin1StringView("height"), TracingImage::kMinHeight, TracingImage::kMaxHeight);
    tracing.opacity = reader.number(QLatin1StringView("opacity"), 0.0, 1.0);
    hash = reader.text(QLatin1StringView("image"), QString());
    name = reader.text(QLatin1StringView("name"), QString());
    if (const Result<void> end = reader.finish(); !end)
        whole.fail(end.error());
    return tracing;
}

void readSun(JsonReader& whole, SceneLook& look)
{
    const QLatin1StringView key("sun");
    JsonReader reader(whole.object(key), whole.placeOf(key));
    look.sunAzimuth = reader.number(QLatin1StringView("azimuth"), -kPi, kPi);
    look.sunElevation = reader.number(QLatin1StringView("elevation"), kLeastSunElevation, radians(90));
    look.sunPinned = readSwitch(reader, "pinned");
    look.sunShown = readSwitch(reader, "shown");
    if (const Result<void> end = reader.finish(); !end)
        whole.fail(end.error());
}

} // namespace

void addLook(ZipWriter& archive, const SceneLook& look)
{
    archive.add(kLookEntry, QJsonDocument(toJson(look)).toJson());
}

Result<std::optional<ReadLook>> readLook(const ZipReader& archive, std::span<const ImageAsset> known)
{
    if (!archive.contains(kLookEntry))
        return std::optional<ReadLook>();
    const auto fault = [](const QString& message) {
        return inputError(QString::fromLatin1(kLookEntry), message);
    };
    const Result<QByteArray> text = archive.read(kLookEntry, kMostLookBytes);
    if (!text)
        return fault(text.error().message);
    const Result<QJsonObject> json = parseJsonObject(*text, kMostLookBytes);
    if (!json)
        return fault(json.error().message);
    JsonReader reader(*json, {});
    ReadLook read;
    SceneLook& look = read.look;
    look.groundShown = readSwitch(reader, "ground");
    look.gridShown = readSwitch(reader, "grid");
    look.shadowsShown = readSwitch(reader, "shadows");
    const qsizetype backdrop = backdropNames().indexOf(reader.text(QLatin1StringView("backdrop")));
    if (backdrop < 0)
        reader.fail(QLatin1StringView("backdrop"), ProjectText::tr("there is no backdrop of this name"));
    look.backdrop = static_cast<Backdrop>(std::max<qsizetype>(backdrop, 0));
    look.backgroundColour = readColour(reader, "colour");
    look.backgroundTop = readColour(reader, "topColour");
    readSun(reader, look);
    QString hash;
    QString name;
    look.tracing = readTracing(reader, hash, name);
    if (const Result<void> end = reader.finish(); !end)
        return fault(end.error().message);
    if (!hash.isEmpty()) {
        const auto same = std::ranges::find(known, hash, &ImageAsset::hash);
        look.tracing.image =
            same != known.end() ? *same : ProjectImages::read(archive, hash, name).value_or(ImageAsset());
        // Unpacked here, on a worker thread, and not when it is drawn for the first time.
        if (look.tracing.image.pixels().isNull()) {
            look.tracing.image = {};
            read.lostPicture = name.isEmpty() ? hash.first(std::min<qsizetype>(hash.size(), 8)) : name;
        }
    }
    return std::optional(std::move(read));
}

} // namespace espalier
