// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/FillEnvelopesOperation.h"

#include "commands/recipe/LassoJson.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/SetParametersOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kEnvelopesKey("envelopes");
constexpr QLatin1StringView kFillParametersKey("parameters");

} // namespace

FillEnvelopesOperation FillEnvelopesOperation::read(JsonReader& reader, RecipeReading& reading)
{
    FillEnvelopesOperation fill;
    fill.only = BudReference::read(reader);
    fill.steps = readSteps(reader);
    if (reader.has(kFillParametersKey)) {
        const Result<void> read =
            reading.readParameters(reader.object(kFillParametersKey), reader.placeOf(kFillParametersKey));
        if (!read)
            reader.fail(read.error());
        if (!reader.has(kEnvelopesKey))
            reader.fail(kFillParametersKey,
                        RecipeText::tr("“%1” must be given with them").arg(QString(kEnvelopesKey)));
    }
    if (!reader.has(kEnvelopesKey))
        return fill;
    fill.parameters = reading.parameters();
    const QJsonArray array = reader.array(kEnvelopesKey);
    if (array.isEmpty() || array.size() > kMostEnvelopes)
        reader.fail(kEnvelopesKey, RecipeText::tr("1 to %1 envelopes are expected").arg(kMostEnvelopes));
    fill.envelopes.emplace();
    for (qsizetype i = 0; i < std::min(array.size(), kMostEnvelopes); ++i) {
        const QString place = QStringLiteral("%1[%2]").arg(reader.placeOf(kEnvelopesKey)).arg(i);
        if (!array.at(i).isObject()) {
            reader.fail(inputError(place, RecipeText::tr("an object is expected")));
            break;
        }
        JsonReader envelope(array.at(i).toObject(), place);
        fill.envelopes->push_back(readLasso(envelope, reading));
        if (const Result<void> end = envelope.finish(); !end)
            reader.fail(end.error());
    }
    return fill;
}

QJsonObject FillEnvelopesOperation::write(RecipeWriting& writing) const
{
    QJsonObject json;
    only.write(json);
    writeSteps(json, steps);
    if (!envelopes)
        return json;
    QJsonArray array;
    for (const LassoStroke& stroke : *envelopes)
        array.append(lassoToJson(stroke));
    json[kEnvelopesKey] = array;
    if (const QJsonObject changes = parametersToJson(parameters, writing.parameters); !changes.isEmpty())
        json[kFillParametersKey] = changes;
    writing.parameters = parameters;
    return json;
}

} // namespace espalier
