// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/EditTitle.h"

#include "commands/recipe/AddBudsOperation.h"
#include "commands/recipe/ArrangeOperation.h"
#include "commands/recipe/BendOperation.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/GrowOperation.h"
#include "commands/recipe/ImportOperation.h"
#include "commands/recipe/InferOperation.h"
#include "commands/recipe/InvigorateOperation.h"
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
#include "commands/recipe/TwistOperation.h"
#include "commands/recipe/VaryOperation.h"
#include "model/tree/TreeDelta.h"

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
    {FillEnvelopesOperation::kName, QT_TRANSLATE_NOOP("Commands", "Lasso")},
    {GrowOperation::kName, QT_TRANSLATE_NOOP("Commands", "Grow")},
    {ImportOperation::kName, QT_TRANSLATE_NOOP("Commands", "Import")},
    {InferOperation::kName, QT_TRANSLATE_NOOP("Commands", "Give Depth")},
    {InvigorateOperation::kName, QT_TRANSLATE_NOOP("Commands", "Invigorate")},
    {LassoOperation::kName, QT_TRANSLATE_NOOP("Commands", "Lasso")},
    {MoveBranchOperation::kName, QT_TRANSLATE_NOOP("Commands", "Move Branch")},
    {MultiplyOperation::kName, QT_TRANSLATE_NOOP("Commands", "Multiply Branch")},
    {PlaceLeafOperation::kName, QT_TRANSLATE_NOOP("Commands", "Place Leaf")},
    {PropagateOperation::kName, QT_TRANSLATE_NOOP("Commands", "Propagate Branch")},
    {PruneOperation::kName, QT_TRANSLATE_NOOP("Commands", "Prune")},
    {ReduceOperation::kName, QT_TRANSLATE_NOOP("Commands", "Reduce")},
    {RegrowOperation::kName, QT_TRANSLATE_NOOP("Commands", "Regrow")},
    {RemoveLassoOperation::kName, QT_TRANSLATE_NOOP("Commands", "Remove Envelope")},
    {ReproduceOperation::kName, QT_TRANSLATE_NOOP("Commands", "Reproduce Tree")},
    {SetParametersOperation::kName, QT_TRANSLATE_NOOP("Commands", "Change Parameters")},
    {SetProfileOperation::kName, QT_TRANSLATE_NOOP("Commands", "Profile")},
    {SetWidthOperation::kName, QT_TRANSLATE_NOOP("Commands", "Width")},
    {SketchOperation::kName, QT_TRANSLATE_NOOP("Commands", "Sketch")},
    {SketchStrokeOperation::kName, QT_TRANSLATE_NOOP("Commands", "Draw Branch")},
    {TwistOperation::kName, QT_TRANSLATE_NOOP("Commands", "Twist")},
    {VaryOperation::kName, QT_TRANSLATE_NOOP("Commands", "Vary Tree")},
};

/// The operation's name in its JSON, which may be long: it is not parsed.
QByteArray nameIn(const QByteArray& operation)
{
    static const QByteArray kBefore = QByteArrayLiteral("\"op\":\"");
    const qsizetype at = operation.indexOf(kBefore);
    if (at < 0)
        return {};
    const qsizetype begin = at + kBefore.size();
    return operation.mid(begin, operation.indexOf('"', begin) - begin);
}

} // namespace

QString titleOfEdit(const EditRecord& record)
{
    const QByteArray name = nameIn(record.operation);
    const auto found =
        std::ranges::find_if(kTitles, [&](const OperationTitle& title) { return title.name == name; });
    return found == std::end(kTitles) ? QString() : QCoreApplication::translate("Commands", found->title);
}

} // namespace espalier
