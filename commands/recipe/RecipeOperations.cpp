// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/AddBudsOperation.h"
#include "commands/recipe/ArrangeOperation.h"
#include "commands/recipe/BendOperation.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/EraseOperation.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/GrowOperation.h"
#include "commands/recipe/ImportOperation.h"
#include "commands/recipe/InferOperation.h"
#include "commands/recipe/InvigorateOperation.h"
#include "commands/recipe/KeepClearOperation.h"
#include "commands/recipe/LassoOperation.h"
#include "commands/recipe/MoveBranchOperation.h"
#include "commands/recipe/MultiplyOperation.h"
#include "commands/recipe/PlaceLeafOperation.h"
#include "commands/recipe/PropagateOperation.h"
#include "commands/recipe/PruneOperation.h"
#include "commands/recipe/RecipeOperation.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/RedoOperation.h"
#include "commands/recipe/ReduceOperation.h"
#include "commands/recipe/RegrowOperation.h"
#include "commands/recipe/RemoveLassoOperation.h"
#include "commands/recipe/ReproduceOperation.h"
#include "commands/recipe/SetParametersOperation.h"
#include "commands/recipe/SetProfileOperation.h"
#include "commands/recipe/SetWidthOperation.h"
#include "commands/recipe/SketchOperation.h"
#include "commands/recipe/SketchStrokeOperation.h"
#include "commands/recipe/ThinOperation.h"
#include "commands/recipe/TravelOperation.h"
#include "commands/recipe/TwistOperation.h"
#include "commands/recipe/UndoOperation.h"
#include "commands/recipe/VaryOperation.h"

#include <QJsonDocument>

#include <algorithm>

namespace espalier {

namespace {

struct OperationKind {
    QLatin1StringView name;
    RecipeOperation (*read)(JsonReader&, RecipeReading&);
};

template <class Data>
constexpr OperationKind kindOf()
{
    return {Data::kName, [](JsonReader& reader, RecipeReading& reading) {
                return RecipeOperation(Data::read(reader, reading));
            }};
}

/// All kinds of operations.
constexpr OperationKind kKinds[] = {
    kindOf<SetParametersOperation>(), kindOf<BrushStrokeOperation>(), kindOf<GrowOperation>(),
    kindOf<PruneOperation>(),         kindOf<TravelOperation>(),      kindOf<UndoOperation>(),
    kindOf<RedoOperation>(),          kindOf<BendOperation>(),        kindOf<SetWidthOperation>(),
    kindOf<LassoOperation>(),         kindOf<RegrowOperation>(),      kindOf<RemoveLassoOperation>(),
    kindOf<FillEnvelopesOperation>(), kindOf<ImportOperation>(),      kindOf<InvigorateOperation>(),
    kindOf<ReduceOperation>(),        kindOf<TwistOperation>(),       kindOf<AddBudsOperation>(),
    kindOf<SetProfileOperation>(),    kindOf<SketchOperation>(),      kindOf<SketchStrokeOperation>(),
    kindOf<InferOperation>(),         kindOf<PlaceLeafOperation>(),   kindOf<ArrangeOperation>(),
    kindOf<MultiplyOperation>(),      kindOf<PropagateOperation>(),   kindOf<ReproduceOperation>(),
    kindOf<VaryOperation>(),          kindOf<MoveBranchOperation>(),  kindOf<KeepClearOperation>(),
    kindOf<EraseOperation>(),         kindOf<ThinOperation>(),
};

} // namespace

QJsonObject RecipeOperation::write(RecipeWriting& writing) const
{
    QJsonObject json = m_content->write(writing);
    json[QLatin1StringView("op")] = QString(name());
    return json;
}

QByteArray RecipeOperation::record(const TreeParameters& parameters) const
{
    RecipeWriting writing{parameters};
    return QJsonDocument(write(writing)).toJson(QJsonDocument::Compact);
}

QStringList operationNames()
{
    QStringList names;
    for (const OperationKind& kind : kKinds)
        names.append(QString(kind.name));
    return names;
}

Result<RecipeOperation> readOperation(const QJsonValue& value, const QString& place, RecipeReading& reading)
{
    if (!value.isObject())
        return inputError(place, RecipeText::tr("an object is expected"));
    JsonReader reader(value.toObject(), place);
    const QLatin1StringView key("op");
    const QString name = reader.text(key);
    const auto* kind =
        std::ranges::find_if(kKinds, [&](const OperationKind& known) { return name == known.name; });
    if (kind == std::end(kKinds)) {
        reader.fail(key, RecipeText::tr("there is no operation “%1”; there are %2")
                             .arg(name, operationNames().join(QLatin1String(", "))));
        return reader.finish().error();
    }
    RecipeOperation operation = kind->read(reader, reading);
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    return operation;
}

} // namespace espalier
