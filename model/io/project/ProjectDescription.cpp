// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectDescription.h"

#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"

#include <QJsonDocument>

namespace espalier {

namespace {

constexpr QLatin1StringView kFormat("espalier-project");

std::vector<std::uint32_t> readIndices(JsonReader& reader, const char* key)
{
    std::vector<std::uint32_t> indices;
    for (const QJsonValue& value : reader.array(QLatin1StringView(key))) {
        const double index = value.toDouble(-1.0);
        if (!(index >= 0.0 && index < projectLimits::kLassos)) {
            reader.fail(QLatin1StringView(key), ProjectText::tr("indices of strokes are expected"));
            break;
        }
        indices.push_back(static_cast<std::uint32_t>(index));
    }
    return indices;
}

} // namespace

QByteArray describe(const QString& name, const Tree& whole, std::size_t deltas, std::uint32_t ahead,
                    const QJsonObject& foreign)
{
    const TreeContent& tree = whole.content();
    QJsonArray inForce;
    for (const std::uint32_t index : tree.lassosInForce)
        inForce.append(qint64{index});
    QJsonObject json{{QStringLiteral("format"), QString(kFormat)},
                     {QStringLiteral("version"), projectLimits::kVersion},
                     {QStringLiteral("program"), QStringLiteral(ESPALIER_VERSION)},
                     {QStringLiteral("name"), name},
                     {QStringLiteral("seed"), seedToJson(tree.seed)},
                     {QStringLiteral("step"), qint64{tree.step}},
                     {QStringLiteral("internodes"), qint64{tree.internodes.size()}},
                     {QStringLiteral("leaves"), qint64{tree.leaves.size()}},
                     {QStringLiteral("deltas"), static_cast<qint64>(deltas)},
                     {QStringLiteral("ahead"), qint64{ahead}},
                     {QStringLiteral("currentParameters"), qint64{tree.currentParameters}},
                     {QStringLiteral("lassosInForce"), inForce}};
    const QJsonObject images = ProjectImages::names(ProjectImages::of(tree.kept.parameters));
    if (!images.isEmpty())
        json[QStringLiteral("images")] = images;
    for (auto member = foreign.begin(); member != foreign.end(); ++member) {
        if (!json.contains(member.key()))
            json[member.key()] = member.value();
    }
    return QJsonDocument(json).toJson();
}

std::uint32_t readCount(JsonReader& reader, const char* key, std::uint32_t minimum, std::uint32_t maximum)
{
    return static_cast<std::uint32_t>(reader.integer(QLatin1StringView(key), minimum, maximum));
}

Result<int> readVersion(JsonReader& reader)
{
    if (reader.text(QLatin1StringView("format"), QString()) != kFormat)
        return inputError({}, ProjectText::tr("it does not describe an Espalier project"));
    const auto version =
        reader.integer(QLatin1StringView("version"), 1, std::numeric_limits<std::int32_t>::max());
    const QString program = reader.text(QLatin1StringView("program"));
    if (version > projectLimits::kVersion) {
        return inputError(
            {}, ProjectText::tr(
                    "Espalier %1 wrote it in version %2 of the format; this is Espalier %3, which reads "
                    "versions up to %4")
                    .arg(program)
                    .arg(version)
                    .arg(QStringLiteral(ESPALIER_VERSION))
                    .arg(projectLimits::kVersion));
    }
    return static_cast<int>(version);
}

void readCommon(JsonReader& reader, ProjectDescription& description)
{
    description.name = reader.text(QLatin1StringView("name"));
    description.seed = reader.seed(QLatin1StringView("seed"));
    description.step = static_cast<Step>(reader.integer(QLatin1StringView("step"), 0, kNever - 1));
    description.internodes = readCount(reader, "internodes", 1, projectLimits::kInternodes);
    description.currentParameters = readCount(reader, "currentParameters", 0, kMostParameterSets);
    description.imageNames = reader.object(QLatin1StringView("images"));
    if (description.imageNames.size() > qsizetype{projectLimits::kImages})
        reader.fail(QLatin1StringView("images"),
                    ProjectText::tr("at most %1 images are expected").arg(projectLimits::kImages));
}

Result<ProjectDescription> readDescription(JsonReader& reader)
{
    ProjectDescription description;
    description.version = projectLimits::kVersion;
    readCommon(reader, description);
    description.leaves = readCount(reader, "leaves", 0, projectLimits::kLeaves);
    description.deltas = readCount(reader, "deltas", 0, projectLimits::kDeltas);
    description.ahead = readCount(reader, "ahead", 0, description.deltas);
    description.lassosInForce = readIndices(reader, "lassosInForce");
    description.foreign = reader.takeRest();
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    return description;
}

} // namespace espalier
