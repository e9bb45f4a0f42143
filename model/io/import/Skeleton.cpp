// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/import/Skeleton.h"

#include "model/io/FileReader.h"
#include "model/io/JsonReader.h"
#include "model/io/import/SkeletonText.h"
#include "model/tree/TreeTables.h"

#include <QByteArrayView>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <optional>

namespace espalier {

namespace {

constexpr std::array<const char*, 9> kColumns{"id", "parent", "x0", "y0", "z0", "x1", "y1", "z1", "radius"};
/// No line of numbers is longer, bytes.
constexpr qsizetype kLongestLine = 400;
constexpr std::int64_t kFoot = -1;

/// A line of the table, as it stands there.
struct Row {
    std::int64_t id;
    std::int64_t parent; ///< The id of that row
    int line;            ///< Counted from 1
    SkeletonSegment segment;
};

QString lineName(int line)
{
    return SkeletonText::tr("line %1").arg(line);
}

QByteArray heading()
{
    QByteArray text;
    for (const char* const column : kColumns)
        text += (text.isEmpty() ? "" : ",") + QByteArray(column);
    return text;
}

/// Takes the lines off the front of a text, one after another.
class Lines {
public:
    explicit Lines(QByteArrayView text) : m_rest(text)
    {
        constexpr QByteArrayView kByteOrderMark("\xEF\xBB\xBF");
        if (m_rest.startsWith(kByteOrderMark))
            m_rest = m_rest.sliced(kByteOrderMark.size());
    }

    bool areLeft() const { return !m_rest.isEmpty(); }
    /// The next line, without blanks at its ends.
    QByteArrayView next()
    {
        const qsizetype end = m_rest.indexOf('\n');
        const QByteArrayView line = end < 0 ? m_rest : m_rest.first(end);
        m_rest = end < 0 ? QByteArrayView() : m_rest.sliced(end + 1);
        ++m_number;
        return line.trimmed();
    }
    /// Of the line that next() has returned.
    int number() const { return m_number; }

private:
    QByteArrayView m_rest;
    int m_number = 0;
};

template <class Number>
std::optional<Number> numberIn(QByteArrayView text)
{
    Number number{};
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    if (error != std::errc() || end != text.end())
        return {};
    return number;
}

Result<Row> readRow(QByteArrayView line, int number)
{
    if (line.size() > kLongestLine)
        return inputError(lineName(number), SkeletonText::tr("it is too long"));
    std::array<QByteArrayView, kColumns.size()> fields;
    QByteArrayView rest = line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const qsizetype comma = rest.indexOf(',');
        if ((comma < 0) != (i + 1 == fields.size()))
            return inputError(lineName(number),
                              SkeletonText::tr("%1 numbers are expected").arg(fields.size()));
        fields[i] = (comma < 0 ? rest : rest.first(comma)).trimmed();
        rest = comma < 0 ? QByteArrayView() : rest.sliced(comma + 1);
    }
    const auto wrong = [&](std::size_t field) {
        return inputError(lineName(number),
                          SkeletonText::tr("“%1” is not a number for %2")
                              .arg(QString::fromUtf8(fields[field]), QLatin1String(kColumns[field])));
    };
    std::array<std::int64_t, 2> ids;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto id = numberIn<std::int64_t>(fields[i]);
        if (!id)
            return wrong(i);
        ids[i] = *id;
    }
    std::array<float, 7> lengths;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        const auto length = numberIn<float>(fields[i + 2]);
        if (!length)
            return wrong(i + 2);
        lengths[i] = *length;
    }
    // From z up to y up.
    const auto point = [&](std::size_t first) {
        return Vec3(lengths[first], lengths[first + 2], 0.0F - lengths[first + 1]);
    };
    return Row{ids[0], ids[1], number, {kNoInternode, point(0), point(3), lengths[6]}};
}

/// The rows so that parents come before what they carry, otherwise in the table's order.
Result<Skeleton> inOrder(std::vector<Row>& rows)
{
    std::vector<std::uint32_t> byId(rows.size());
    std::iota(byId.begin(), byId.end(), 0U);
    const auto idOf = [&](std::uint32_t row) { return rows[row].id; };
    std::ranges::stable_sort(byId, {}, idOf);
    const auto twice = std::ranges::adjacent_find(byId, {}, idOf);
    if (twice != byId.end())
        return inputError(lineName(rows[twice[1]].line),
                          SkeletonText::tr("its id %1 is already used in line %2")
                              .arg(rows[*twice].id)
                              .arg(rows[*twice].line));

    std::vector<std::uint32_t> ready;                             // rows whose parents come before them
    std::vector<std::pair<std::uint32_t, std::uint32_t>> carried; // parent, row
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
        if (rows[row].parent == kFoot) {
            ready.push_back(row);
            continue;
        }
        const auto parent = std::ranges::lower_bound(byId, rows[row].parent, {}, idOf);
        if (parent == byId.end() || rows[*parent].id != rows[row].parent)
            return inputError(lineName(rows[row].line),
                              SkeletonText::tr("its parent, id %1, does not exist").arg(rows[row].parent));
        carried.emplace_back(*parent, row);
    }
    std::ranges::sort(carried);

    Skeleton skeleton;
    std::vector<bool> isPlaced(rows.size(), false);
    for (std::size_t i = 0; i < ready.size(); ++i) {
        const std::uint32_t row = ready[i];
        isPlaced[row] = true;
        skeleton.push_back(rows[row].segment);
        for (auto place = std::ranges::lower_bound(carried, std::pair(row, 0U));
             place != carried.end() && place->first == row; ++place) {
            rows[place->second].segment.parent = static_cast<std::uint32_t>(i);
            ready.push_back(place->second);
        }
    }
    if (skeleton.size() < rows.size()) {
        const auto left = std::ranges::find(isPlaced, false) - isPlaced.begin();
        return inputError(lineName(rows[static_cast<std::size_t>(left)].line),
                          SkeletonText::tr("it is its own ancestor"));
    }
    return skeleton;
}

} // namespace

QString segmentFault(const SkeletonSegment& segment)
{
    for (const Vec3& end : {segment.base, segment.tip}) {
        if (!end.allFinite() || end.cwiseAbs().maxCoeff() > kFarthestNode)
            return SkeletonText::tr("it lies more than %1 m away").arg(static_cast<double>(kFarthestNode));
    }
    if (!(segment.radius >= 0.0F && segment.radius <= kGreatestDiameter / 2.0F))
        return SkeletonText::tr("its radius is not between 0 and %1 m")
            .arg(static_cast<double>(kGreatestDiameter) / 2.0);
    return {};
}

Result<Skeleton> readSkeleton(const QByteArray& table)
{
    Lines lines(table);
    if (!lines.areLeft() || QByteArray(lines.next().toByteArray()).replace(' ', "") != heading())
        return inputError(lineName(1),
                          SkeletonText::tr("“%1” is expected").arg(QString::fromUtf8(heading())));
    std::vector<Row> rows;
    while (lines.areLeft()) {
        const QByteArrayView line = lines.next();
        if (line.isEmpty())
            continue;
        if (rows.size() == kMostSegments)
            return inputError(
                lineName(lines.number()),
                SkeletonText::tr("a tree of more than %1 segments cannot be imported").arg(kMostSegments));
        Result<Row> row = readRow(line, lines.number());
        if (!row)
            return row.error();
        if (const QString fault = segmentFault(row->segment); !fault.isEmpty())
            return inputError(lineName(lines.number()), fault);
        rows.push_back(*row);
    }
    if (rows.empty())
        return inputError(lineName(lines.number()), SkeletonText::tr("there are no segments"));
    return inOrder(rows);
}

Result<Skeleton> readSkeletonFile(const QString& fileName)
{
    const QString shown = QFileInfo(fileName).fileName();
    constexpr qint64 kMostBytes = qint64{kMostSegments} * kLongestLine;
    const Result<QByteArray> bytes = readFile(fileName, kMostBytes, FileKind::Any);
    if (!bytes)
        return bytes.error();
    Result<Skeleton> skeleton = readSkeleton(*bytes);
    if (!skeleton)
        return inputError(shown, skeleton.error().message);
    return skeleton;
}

} // namespace espalier
