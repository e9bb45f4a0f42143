// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/Tree.h"

#include <QCoreApplication>

#include <cmath>

namespace espalier {

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("Tree", text);
}

template <class T>
void appendColumn(QList<T>& column, const QList<T>& rows)
{
    column.append(rows);
}

void append(InternodeColumns& columns, const InternodeColumns& rows)
{
    appendColumn(columns.parent, rows.parent);
    appendColumn(columns.rotation, rows.rotation);
    appendColumn(columns.length, rows.length);
    appendColumn(columns.vigour, rows.vigour);
    appendColumn(columns.slot, rows.slot);
    appendColumn(columns.buds, rows.buds);
    appendColumn(columns.birth, rows.birth);
    appendColumn(columns.death, rows.death);
    appendColumn(columns.present, rows.present);
    appendColumn(columns.parameterSet, rows.parameterSet);
}

bool isUnit(const Rotation& rotation)
{
    const float squaredNorm = rotation.coeffs().squaredNorm();
    return std::abs(squaredNorm - 1.0F) < 1e-3F; // false for NaN
}

bool isLength(float length)
{
    return length > 0.0F && length <= kGreatestLength;
}

/// What is wrong with row @p id, or nothing.
QString faultOf(const InternodeColumns& c, InternodeId id, std::uint32_t parameterSets, Step step)
{
    if (id > 0 && c.parent[id] >= id)
        return tr("its parent does not come before it");
    if (!isUnit(c.rotation[id]))
        return tr("its rotation is not one");
    if (!isLength(c.length[id]))
        return tr("its length is out of range");
    if (!(c.vigour[id] >= 0.0F && c.vigour[id] <= 1.0F))
        return tr("its vigour is out of range");
    if (c.slot[id] != kTerminalSlot && c.slot[id] >= kMaxLaterals)
        return tr("it grows from a bud that does not exist");
    if ((c.buds[id] & ~(kTerminalBud | ((1U << kMaxLaterals) - 1U))) != 0)
        return tr("it has a bud that does not exist");
    if (c.present[id] > 1)
        return tr("it is neither there nor away");
    if (c.parameterSet[id] >= parameterSets)
        return tr("its parameters are missing");
    if (c.birth[id] > step && c.present[id] != 0)
        return tr("it was born in the future");
    if (c.death[id] != kNever && c.death[id] < c.birth[id])
        return tr("it died before it was born");
    return {};
}

} // namespace

bool isFrame(const Rotation& rotation, float length)
{
    return isUnit(rotation) && isLength(length);
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

Tree::Tree(std::uint64_t seed, const TreeParameters& parameters) : m_seed(seed)
{
    m_parameterSets.append(parameters);
    InternodeColumns& c = m_columns;
    c.parent.append(kNoInternode);
    c.rotation.append(Rotation::Identity());
    c.length.append(static_cast<float>(parameters.growth.internodeLength));
    c.vigour.append(1.0F);
    c.slot.append(kTerminalSlot);
    c.buds.append(kTerminalBud);
    c.birth.append(0);
    c.death.append(kNever);
    c.present.append(1);
    c.parameterSet.append(0);
}

Result<Tree> Tree::fromColumns(std::uint64_t seed, Step step, InternodeColumns columns,
                               QList<TreeParameters> parameterSets, std::uint32_t currentParameters,
                               std::vector<WidthConstraint> widths, Lassos lassos)
{
    const std::uint32_t count = columns.size();
    bool equalSizes = true;
    InternodeColumns::visit(columns,
                            [&](const char*, const auto& column) { equalSizes &= column.size() == count; });
    if (!equalSizes)
        return Error{Error::Kind::Input, tr("the columns of the tree have different lengths")};
    if (count == 0 || parameterSets.isEmpty() || currentParameters >= parameterSets.size())
        return Error{Error::Kind::Input, tr("the tree is empty or lacks its parameters")};

    const auto setCount = static_cast<std::uint32_t>(parameterSets.size());
    const auto alive = [&](InternodeId id) {
        return columns.present[id] != 0 && columns.death[id] == kNever;
    };
    std::vector<bool> continued(count, false);
    for (InternodeId id = 0; id < count; ++id) {
        QString fault = faultOf(std::as_const(columns), id, setCount, step);
        if (id == 0 && (columns.parent[0] != kNoInternode || !alive(0)))
            fault = tr("the seedling must stand at the base");
        if (fault.isEmpty() && id > 0 && alive(id)) {
            const InternodeId parent = columns.parent[id];
            if (!alive(parent))
                fault = tr("it lives on a dead internode");
            else if (columns.slot[id] == kTerminalSlot && continued[parent])
                fault = tr("two internodes continue the same axis");
            else if (columns.slot[id] == kTerminalSlot)
                continued[parent] = true;
        }
        if (!fault.isEmpty())
            return Error{Error::Kind::Input, tr("internode %1: %2").arg(id).arg(fault)};
    }
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const auto [id, diameter] = widths[i];
        if (id >= count || (i > 0 && id <= widths[i - 1].id) ||
            !(diameter > 0.0F && diameter <= kGreatestDiameter))
            return Error{Error::Kind::Input, tr("width %1 cannot be").arg(i)};
    }
    for (qsizetype i = 0; i < lassos.strokes.size(); ++i) {
        if (!isLasso(lassos.strokes.at(i)))
            return Error{Error::Kind::Input, tr("lasso %1 cannot be").arg(i)};
    }
    for (std::size_t i = 0; i < lassos.inForce.size(); ++i) {
        if (lassos.inForce[i] >= lassos.strokes.size() ||
            (i > 0 && lassos.inForce[i] <= lassos.inForce[i - 1]))
            return Error{Error::Kind::Input, tr("the lassos in force are out of order")};
    }

    Tree tree;
    tree.m_lassos = std::move(lassos);
    tree.m_widths = std::move(widths);
    tree.m_columns = std::move(columns);
    tree.m_parameterSets = std::move(parameterSets);
    tree.m_currentParameters = currentParameters;
    tree.m_seed = seed;
    tree.m_step = step;
    return tree;
}

std::uint32_t Tree::rememberParameters(const TreeParameters& parameters)
{
    const auto known = m_parameterSets.lastIndexOf(parameters);
    if (known >= 0)
        return static_cast<std::uint32_t>(known);
    Q_ASSERT(m_parameterSets.size() < 0xffff);
    m_parameterSets.append(parameters);
    return static_cast<std::uint32_t>(m_parameterSets.size() - 1);
}

void Tree::forgetLastParameters()
{
    Q_ASSERT(m_currentParameters + 1 < m_parameterSets.size());
    m_parameterSets.removeLast();
}

void Tree::apply(TreeDelta& delta)
{
    Q_ASSERT(m_step == delta.stepBefore);
    if (delta.rows) {
        Q_ASSERT(delta.born.first == size() && delta.born.count == delta.rows->size());
        append(m_columns, *delta.rows);
        delta.rows.reset();
    }
    std::fill_n(m_columns.present.begin() + delta.born.first, delta.born.count, std::uint8_t{1});
    for (const InternodeId id : delta.died)
        m_columns.death[id] = delta.stepAfter;
    for (const TreeDelta::BudChange& change : delta.buds)
        m_columns.buds[change.id] = change.after;
    for (const TreeDelta::FrameChange& change : delta.frames) {
        m_columns.rotation[change.id] = change.after;
        m_columns.length[change.id] = change.lengthAfter;
    }
    for (const TreeDelta::WidthChange& change : delta.widths)
        setWidth(change.id, change.after);
    for (const TreeDelta::LassoChange& change : delta.lassos)
        setLasso(change.index, change.isInForce);
    m_currentParameters = delta.parametersAfter;
    m_step = delta.stepAfter;
}

void Tree::revert(const TreeDelta& delta)
{
    Q_ASSERT(m_step == delta.stepAfter && !delta.rows);
    for (const TreeDelta::LassoChange& change : delta.lassos)
        setLasso(change.index, !change.isInForce);
    for (const TreeDelta::WidthChange& change : delta.widths)
        setWidth(change.id, change.before);
    for (const TreeDelta::FrameChange& change : delta.frames) {
        m_columns.rotation[change.id] = change.before;
        m_columns.length[change.id] = change.lengthBefore;
    }
    for (const TreeDelta::BudChange& change : delta.buds)
        m_columns.buds[change.id] = change.before;
    for (const InternodeId id : delta.died)
        m_columns.death[id] = kNever;
    std::fill_n(m_columns.present.begin() + delta.born.first, delta.born.count, std::uint8_t{0});
    m_currentParameters = delta.parametersBefore;
    m_step = delta.stepBefore;
}

bool Tree::operator==(const Tree& other) const
{
    const InternodeColumns& a = m_columns;
    const InternodeColumns& b = other.m_columns;
    const auto sameRotation = [](const Rotation& r, const Rotation& s) { return r.coeffs() == s.coeffs(); };
    return m_seed == other.m_seed && m_step == other.m_step && m_widths == other.m_widths &&
           m_lassos == other.m_lassos && m_currentParameters == other.m_currentParameters &&
           m_parameterSets == other.m_parameterSets && a.parent == b.parent &&
           std::ranges::equal(a.rotation, b.rotation, sameRotation) && a.length == b.length &&
           a.vigour == b.vigour && a.slot == b.slot && a.buds == b.buds && a.birth == b.birth &&
           a.death == b.death && a.present == b.present && a.parameterSet == b.parameterSet;
}

float Tree::widthConstraint(InternodeId id) const
{
    const auto found = std::ranges::lower_bound(m_widths, id, {}, &WidthConstraint::id);
    return found != m_widths.end() && found->id == id ? found->diameter : 0.0F;
}

void Tree::setWidth(InternodeId id, float diameter)
{
    const auto place = std::ranges::lower_bound(m_widths, id, {}, &WidthConstraint::id);
    const bool isSet = place != m_widths.end() && place->id == id;
    if (diameter <= 0.0F && isSet)
        m_widths.erase(place);
    else if (diameter > 0.0F && isSet)
        place->diameter = diameter;
    else if (diameter > 0.0F)
        m_widths.insert(place, {id, diameter});
}

std::vector<LassoStroke> Tree::lassosInForce() const
{
    std::vector<LassoStroke> strokes;
    for (const std::uint32_t index : m_lassos.inForce)
        strokes.push_back(m_lassos.strokes[index]);
    return strokes;
}

std::uint32_t Tree::rememberLasso(const LassoStroke& stroke)
{
    Q_ASSERT(isLasso(stroke));
    m_lassos.strokes.append(stroke);
    return static_cast<std::uint32_t>(m_lassos.strokes.size() - 1);
}

void Tree::forgetLassosFrom(std::uint32_t count)
{
    Q_ASSERT(m_lassos.inForce.empty() || m_lassos.inForce.back() < count);
    m_lassos.strokes.resize(std::min<qsizetype>(count, m_lassos.strokes.size()));
}

void Tree::setLasso(std::uint32_t index, bool inForce)
{
    const auto place = std::ranges::lower_bound(m_lassos.inForce, index);
    const bool isIn = place != m_lassos.inForce.end() && *place == index;
    if (inForce && !isIn)
        m_lassos.inForce.insert(place, index);
    else if (!inForce && isIn)
        m_lassos.inForce.erase(place);
}

std::size_t Tree::bytes() const
{
    std::size_t sum = m_widths.capacity() * sizeof(WidthConstraint) +
                      static_cast<std::size_t>(m_parameterSets.size()) * sizeof(TreeParameters);
    for (const LassoStroke& stroke : m_lassos.strokes)
        sum += sizeof(stroke) + stroke.points.capacity() * sizeof(Vec2);
    InternodeColumns::visit(m_columns, [&](const char*, const auto& column) {
        sum += static_cast<std::size_t>(column.capacity()) * sizeof(*column.constData());
    });
    return sum;
}

TreeDelta TreeDelta::startingAt(const Tree& tree)
{
    TreeDelta delta;
    delta.stepBefore = delta.stepAfter = tree.step();
    delta.parametersBefore = delta.parametersAfter = tree.currentParameterSet();
    delta.born = {tree.size(), 0};
    return delta;
}

bool TreeDelta::isEmpty() const
{
    return stepBefore == stepAfter && parametersBefore == parametersAfter && born.count == 0 &&
           died.empty() && buds.empty() && frames.empty() && widths.empty() && lassos.empty();
}

std::size_t TreeDelta::bytes() const
{
    return sizeof(*this) + died.capacity() * sizeof(InternodeId) + buds.capacity() * sizeof(BudChange) +
           frames.capacity() * sizeof(FrameChange) + widths.capacity() * sizeof(WidthChange) +
           lassos.capacity() * sizeof(LassoChange);
}

} // namespace espalier
