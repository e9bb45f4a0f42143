// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/EditTitle.h"

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
#include "commands/recipe/TwistOperation.h"
#include "commands/recipe/VaryOperation.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

struct OperationTitle {
    QLatin1StringView name;
    const char* title;
};

constexpr OperationTitle kTitles[] = {
    {AddBudsOperation::kName, QT_TRANSLATE_NOOP("Commands", "New Buds")},
    {ArrangeOperation::kName, QT_TRANSLATE_NOOP("Commands", "Arrange Leaves")},
    {BendOperation::kName, QT_TRANSLATE_NOOP("Commands", "Bend")},
    {BrushStrokeOperation::kName, QT_TRANSLATE_NOOP("Commands", "Brush Stroke")},
    {EraseOperation::kName, QT_TRANSLATE_NOOP("Commands", "Erase")},
    {FillEnvelopesOperation::kName, QT_TRANSLATE_NOOP("Commands", "Lasso")},
    {GrowOperation::kName, QT_TRANSLATE_NOOP("Commands", "Grow")},
    {ImportOperation::kName, QT_TRANSLATE_NOOP("Commands", "Import")},
    {InferOperation::kName, QT_TRANSLATE_NOOP("Commands", "Give Depth")},
    {InvigorateOperation::kName, QT_TRANSLATE_NOOP("Commands", "Invigorate")},
    {KeepClearOperation::kName, QT_TRANSLATE_NOOP("Commands", "Keep Clear")},
    {LassoOperation::kName, QT_TRANSLATE_NOOP("Commands", "Lasso")},
    {MoveBranchOperation::kName, QT_TRANSLATE_NOOP("Commands", "Move Branch")},
    {MultiplyOperation::kName, QT_TRANSLATE_NOOP("Commands", "Multiply Branch")},
    {PlaceLeafOperation::kName, QT_TRANSLATE_NOOP("Commands", "Place Leaf")},
    {PropagateOperation::kName, QT_TRANSLATE_NOOP("Commands", "Pass On Branch")},
    {PruneOperation::kName, QT_TRANSLATE_NOOP("Commands", "Prune")},
    {ReduceOperation::kName, QT_TRANSLATE_NOOP("Commands", "Reduce")},
    {RegrowOperation::kName, QT_TRANSLATE_NOOP("Commands", "Regrow")},
    {RemoveLassoOperation::kName, QT_TRANSLATE_NOOP("Commands", "Remove Envelope")},
    {ReproduceOperation::kName, QT_TRANSLATE_NOOP("Commands", "Reshape Tree")},
    {SetParametersOperation::kName, QT_TRANSLATE_NOOP("Commands", "Change Parameters")},
    {SetProfileOperation::kName, QT_TRANSLATE_NOOP("Commands", "Draw Profile")},
    {SetWidthOperation::kName, QT_TRANSLATE_NOOP("Commands", "Set Width")},
    {SketchOperation::kName, QT_TRANSLATE_NOOP("Commands", "Sketch")},
    {SketchStrokeOperation::kName, QT_TRANSLATE_NOOP("Commands", "Draw Branch")},
    {ThinOperation::kName, QT_TRANSLATE_NOOP("Commands", "Thin Out")},
    {TwistOperation::kName, QT_TRANSLATE_NOOP("Commands", "Twist")},
    {VaryOperation::kName, QT_TRANSLATE_NOOP("Commands", "Vary Tree")},
};

/// The operation's name in its JSON, which may be long: it is not parsed.
QString nameIn(const QByteArray& operation)
{
    static const QByteArray kBefore = QByteArrayLiteral("\"op\":\"");
    const qsizetype at = operation.indexOf(kBefore);
    if (at < 0)
        return {};
    const qsizetype begin = at + kBefore.size();
    return QString::fromLatin1(operation.mid(begin, operation.indexOf('"', begin) - begin));
}

} // namespace

QString titleOfEdit(const EditRecord& record)
{
    const QString name = nameIn(record.operation);
    const auto found =
        std::ranges::find_if(kTitles, [&](const OperationTitle& title) { return title.name == name; });
    return found == std::end(kTitles) ? QString() : QCoreApplication::translate("Commands", found->title);
}

QString titleOfBrushStroke(const Tree& tree, std::span<const std::shared_ptr<TreeDelta>> deltas)
{
    int branches = 0;
    const Step end = deltas.empty() ? 0 : deltas.back()->stepAfter;
    for (const auto& delta : deltas) {
        for (InternodeId id = delta->born.first; id < delta->born.end(); ++id) {
            // Not those that the growth of the same stroke shed again.
            const bool isShed = tree.columns().death[id] <= end;
            branches += !tree.continuesAxis(id) && !isShed ? 1 : 0;
        }
    }
    return branches > 1
               ? QCoreApplication::translate("Commands", "Brush Stroke, %n branches", nullptr, branches)
               : QCoreApplication::translate("Commands", "Brush Stroke");
}

QString titleOfGrowth(int steps)
{
    if (steps == 0)
        return QCoreApplication::translate("Commands", "Go to Another Time");
    return steps > 1 ? QCoreApplication::translate("Commands", "Grow, %n steps", nullptr, steps)
                     : QCoreApplication::translate("Commands", "Grow");
}

QString titleOfStep(const Tree& tree, const Journal& history, const JournalEdit& edit)
{
    const EditRecord* record = history[edit.first]->record.get();
    const QString name = record ? nameIn(record->operation) : QString();
    const auto deltas = std::span(history).subspan(edit.first, edit.end - edit.first);
    if (name == BrushStrokeOperation::kName)
        return titleOfBrushStroke(tree, deltas);
    if (name == GrowOperation::kName)
        return titleOfGrowth(static_cast<int>(deltas.size()));
    const QString title = record ? titleOfEdit(*record) : QString();
    return title.isEmpty() ? QCoreApplication::translate("Commands", "Earlier Steps") : title;
}

} // namespace espalier
