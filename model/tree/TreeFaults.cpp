// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Tree.h"

#include <QCoreApplication>

#include <cmath>
#include <vector>

namespace espalier {

namespace {

struct TreeText {
    Q_DECLARE_TR_FUNCTIONS(Tree)
};

/// Checks each value of row @p row by itself; returns the first fault, or an empty text.
template <class Table, class Columns>
QString valueFault(const Columns& columns, std::uint32_t row)
{
    const char* fault = nullptr;
    Table::visit(
        [&](const auto& info, const auto& column) {
            if (fault == nullptr)
                fault = info.faultOf(column[row]);
        },
        columns);
    return fault == nullptr ? QString() : TreeText::tr(fault);
}

template <class Table, class Columns>
bool haveEqualSizes(const Columns& columns)
{
    bool areEqual = true;
    Table::visit(
        [&](const auto&, const auto& column) {
            areEqual = areEqual && static_cast<std::uint32_t>(column.size()) == columns.size();
        },
        columns);
    return areEqual;
}

/// Checks row @p id against other rows.
QString internodeFault(const TreeContent& t, InternodeId id)
{
    const InternodeColumns& c = t.internodes;
    const InternodeId parent = c.parent[id];
    if (parent != kNoInternode && parent >= id)
        return TreeText::tr("its parent does not come before it");
    if (c.parameterSet[id] >= t.kept.parameters.size())
        return TreeText::tr("its parameters are missing");
    if (c.birth[id] > t.step)
        return TreeText::tr("it was born in the future");
    if (c.death[id] != kNever && (c.death[id] < c.birth[id] || c.death[id] > t.step))
        return TreeText::tr("it died before it was born, or in the future");
    if (c.death[id] == kNever && parent != kNoInternode && c.death[parent] != kNever)
        return TreeText::tr("it lives on a dead internode");
    return {};
}

/// The first row whose key an earlier row has as well. Sorts, since a file can hold keys that all fall into
/// one bucket of a hash table.
std::optional<InternodeId> repeatedKey(const InternodeColumns& c)
{
    std::vector<std::pair<InternodeKey, InternodeId>> keys;
    keys.reserve(c.size());
    for (InternodeId id = 0; id < c.size(); ++id)
        keys.emplace_back(c.key[id], id);
    std::ranges::sort(keys);
    std::optional<InternodeId> first;
    for (std::size_t i = 1; i < keys.size(); ++i) {
        if (keys[i].first == keys[i - 1].first && (!first || keys[i].second < *first))
            first = keys[i].second;
    }
    return first;
}

QString faultOfInternode(InternodeId id, const QString& fault)
{
    return TreeText::tr("internode %1: %2").arg(id).arg(fault);
}

QString internodesFault(const TreeContent& t)
{
    const InternodeColumns& c = t.internodes;
    if (!haveEqualSizes<InternodeTable>(c))
        return TreeText::tr("the columns of the tree have different lengths");
    if (c.size() == 0 || t.kept.parameters.isEmpty() || t.currentParameters >= t.kept.parameters.size())
        return TreeText::tr("the tree is empty or lacks its parameters");
    if (t.kept.parameters.size() > kMostParameterSets)
        return TreeText::tr("the tree has more than %1 parameter sets").arg(kMostParameterSets);
    std::vector<bool> continued(c.size(), false);
    for (InternodeId id = 0; id < c.size(); ++id) {
        QString fault = valueFault<InternodeTable>(c, id);
        if (id == 0 && (c.parent[0] != kNoInternode || c.death[0] != kNever))
            fault = TreeText::tr("the seedling must stand at the base");
        if (fault.isEmpty())
            fault = internodeFault(t, id);
        if (const InternodeId parent = c.parent[id]; fault.isEmpty() && parent != kNoInternode &&
                                                     c.death[id] == kNever && c.slot[id] == kTerminalSlot) {
            if (continued[parent])
                fault = TreeText::tr("two internodes continue the same axis");
            continued[parent] = true;
        }
        if (!fault.isEmpty())
            return faultOfInternode(id, fault);
    }
    if (const std::optional<InternodeId> id = repeatedKey(c))
        return faultOfInternode(*id, TreeText::tr("another internode has its key"));
    return {};
}

QString leavesFault(const TreeContent& t)
{
    const LeafColumns& c = t.leaves;
    if (!haveEqualSizes<LeafTable>(c))
        return TreeText::tr("the columns of the placed leaves have different lengths");
    for (LeafId id = 0; id < c.size(); ++id) {
        QString fault = valueFault<LeafTable>(c, id);
        if (fault.isEmpty() && c.internode[id] >= t.internodes.size())
            fault = TreeText::tr("its internode is missing");
        if (fault.isEmpty() &&
            (c.birth[id] > t.step ||
             (c.death[id] != kNever && (c.death[id] < c.birth[id] || c.death[id] > t.step))))
            fault = TreeText::tr("it died before it was born, or in the future");
        if (!fault.isEmpty())
            return TreeText::tr("placed leaf %1: %2").arg(id).arg(fault);
    }
    return {};
}

QString sparseFault(const TreeContent& t)
{
    QString fault;
    SparseTable::visit(
        [&](const auto& info, const auto& column) {
            const auto& cells = column.cells();
            for (std::size_t i = 0; i < cells.size() && fault.isEmpty(); ++i) {
                const char* wrong = nullptr;
                if (cells[i].id >= t.internodes.size())
                    wrong = QT_TRANSLATE_NOOP("Tree", "its internode is missing");
                else if (i > 0 && cells[i].id <= cells[i - 1].id)
                    wrong = QT_TRANSLATE_NOOP("Tree", "it is out of order");
                else
                    wrong = info.faultOf(cells[i].value);
                if (wrong != nullptr)
                    fault = TreeText::tr("entry %1 of “%2”: %3")
                                .arg(i)
                                .arg(QLatin1String(info.name), TreeText::tr(wrong));
            }
        },
        t.sparse);
    return fault;
}

QString lassosFault(const TreeContent& t)
{
    const QList<LassoStroke>& strokes = t.kept.lassos;
    for (qsizetype i = 0; i < strokes.size(); ++i) {
        if (!isLasso(strokes.at(i)))
            return TreeText::tr("lasso %1: its plane or its points are not valid").arg(i);
    }
    for (std::size_t i = 0; i < t.lassosInForce.size(); ++i) {
        if (t.lassosInForce[i] >= strokes.size() || (i > 0 && t.lassosInForce[i] <= t.lassosInForce[i - 1]))
            return TreeText::tr("the lassos in force are out of order");
    }
    return {};
}

QString profilesFault(const TreeContent& t)
{
    for (qsizetype i = 0; i < t.kept.profiles.size(); ++i) {
        if (const QString fault = profileFault(t.kept.profiles.at(i)); !fault.isEmpty())
            return TreeText::tr("profile %1: %2").arg(i).arg(fault);
    }
    for (const auto& cell : t.sparse.profile.cells()) {
        if (cell.value >= t.kept.profiles.size())
            return faultOfInternode(cell.id, TreeText::tr("its profile is missing"));
    }
    return {};
}

} // namespace

namespace faults {

const char* ofShare(const float& value)
{
    return value >= 0.0F && value <= 1.0F
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "its place of attachment is out of range");
}

const char* ofRotation(const Rotation& value)
{
    return std::abs(value.coeffs().squaredNorm() - 1.0F) < 1e-3F // false for NaN
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "its rotation is not valid");
}

const char* ofLength(const float& value)
{
    return value > 0.0F && value <= kGreatestLength ? nullptr
                                                    : QT_TRANSLATE_NOOP("Tree", "its length is out of range");
}

const char* ofVigour(const float& value)
{
    return value >= 0.0F && value <= 1.0F ? nullptr : QT_TRANSLATE_NOOP("Tree", "its vigour is out of range");
}

const char* ofSlot(const std::uint8_t& value)
{
    return isBudSlot(value) ? nullptr : QT_TRANSLATE_NOOP("Tree", "it grows from a bud that does not exist");
}

const char* ofBuds(const BudStates& value)
{
    for (int slot = 0; slot < kBudSlots; ++slot) {
        if (!isBudSlot(slot) && value.state(slot) != BudState::None)
            return QT_TRANSLATE_NOOP("Tree", "it has a bud that does not exist");
    }
    return nullptr;
}

const char* ofLeafLength(const float& value)
{
    return value > 0.0F && value <= kGreatestLeaf ? nullptr
                                                  : QT_TRANSLATE_NOOP("Tree", "its length is out of range");
}

const char* ofLeafKind(const LeafKind& value)
{
    return value <= LeafKind::Fruit ? nullptr : QT_TRANSLATE_NOOP("Tree", "its kind is not known");
}

const char* ofDiameter(const float& value)
{
    return value > 0.0F && value <= kGreatestDiameter
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "its width is out of range");
}

const char* ofRootPosition(const Vec3& value)
{
    return value.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestRoot
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "its root lies too far away");
}

const char* ofTwist(const float& value)
{
    return std::abs(value) <= kGreatestTwist ? nullptr
                                             : QT_TRANSLATE_NOOP("Tree", "its twist is out of range");
}

const char* ofAddedVigour(const float& value)
{
    return value > 0.0F && value <= kMostAddedVigour
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "its added vigour is out of range");
}

const char* ofClearLength(const float& value)
{
    return value > 0.0F && value <= kGreatestClearLength
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "the length that is kept clear is out of range");
}

const char* ofDrawnLength(const float& value)
{
    return value > 0.0F && value <= kGreatestClearLength
               ? nullptr
               : QT_TRANSLATE_NOOP("Tree", "the length that was drawn is out of range");
}

} // namespace faults

bool isFrame(const Rotation& rotation, float length)
{
    return faults::ofRotation(rotation) == nullptr && faults::ofLength(length) == nullptr;
}

bool isLasso(const LassoStroke& stroke)
{
    const auto isUnitVector = [](const Vec3& v) { return std::abs(v.squaredNorm() - 1.0F) < 1e-3F; };
    return stroke.origin.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestLassoPlane &&
           isUnitVector(stroke.right) && isUnitVector(stroke.up) &&
           std::abs(stroke.right.dot(stroke.up)) < 1e-3F && stroke.points.size() <= kMostLassoPoints &&
           std::ranges::all_of(stroke.points, [](const Vec2& point) {
               return point.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestLassoPoint;
           });
}

QString treeFault(const TreeContent& content)
{
    for (QString (*look)(const TreeContent&) :
         {internodesFault, leavesFault, sparseFault, lassosFault, profilesFault}) {
        if (QString fault = look(content); !fault.isEmpty())
            return fault;
    }
    return {};
}

} // namespace espalier
