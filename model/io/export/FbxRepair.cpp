// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxRepair.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QtEndian>

#include <cstring>

namespace espalier {

namespace {

constexpr char kMagic[] = "Kaydara FBX Binary  "; // and its final zero
constexpr qsizetype kVersionOffset = 23;
constexpr qsizetype kHeader = 27;
constexpr std::uint32_t kWideVersion = 7500;
/// Files of this kind are five deep.
constexpr int kDeepest = 64;
/// What ends a file: an identification, zeros up to a multiple of 16 (at least one), then this many bytes
/// with the version.
constexpr qsizetype kFooterId = 16;
constexpr qsizetype kFooterEnd = 144;

/// Where a node's parts are in the file.
struct Node {
    qsizetype body = 0; ///< Where its nested nodes begin
    qsizetype end = 0;  ///< Where it ends; 0 for the record that ends a list
};

class Repair {
public:
    Repair(QByteArrayView content, bool wide) : m_in(content), m_field(wide ? 8 : 4), m_null(3 * m_field + 1)
    {
    }

    /// Whether the file was sound.
    bool run();
    QByteArray takeResult() { return std::move(m_out); }

private:
    qsizetype number(qsizetype offset) const;
    void setNumber(qsizetype offset, qsizetype value);
    bool readNode(qsizetype offset, qsizetype limit, Node& node) const;
    bool copyNode(qsizetype offset, const Node& node, int depth);
    void copyFooter(qsizetype offset);

    QByteArrayView m_in;
    QByteArray m_out;
    qsizetype m_field; ///< Bytes of an offset or a count
    qsizetype m_null;  ///< Bytes of a record of zeros: that of a node without a name
};

qsizetype Repair::number(qsizetype offset) const
{
    if (m_field == 4)
        return qFromLittleEndian<std::uint32_t>(m_in.data() + offset);
    // A number too large for an offset must not become a negative one.
    return static_cast<qsizetype>(std::min<std::uint64_t>(
        qFromLittleEndian<std::uint64_t>(m_in.data() + offset), std::numeric_limits<qsizetype>::max()));
}

void Repair::setNumber(qsizetype offset, qsizetype value)
{
    if (m_field == 4)
        qToLittleEndian(static_cast<std::uint32_t>(value), m_out.data() + offset);
    else
        qToLittleEndian(static_cast<std::uint64_t>(value), m_out.data() + offset);
}

bool Repair::readNode(qsizetype offset, qsizetype limit, Node& node) const
{
    if (limit - offset < m_null)
        return false;
    node.end = number(offset);
    if (node.end == 0)
        return true;
    const qsizetype propertyBytes = number(offset + 2 * m_field);
    const qsizetype properties = offset + m_null + static_cast<uchar>(m_in[offset + 3 * m_field]);
    if (node.end > limit || properties > node.end || propertyBytes > node.end - properties)
        return false;
    node.body = properties + propertyBytes;
    return true;
}

bool Repair::copyNode(qsizetype offset, const Node& node, int depth)
{
    const qsizetype begin = m_out.size();
    m_out.append(m_in.sliced(offset, node.body - offset));
    if (node.body < node.end) {
        if (depth == kDeepest)
            return false;
        for (qsizetype place = node.body; place < node.end;) {
            Node child;
            if (!readNode(place, node.end, child))
                return false;
            if (child.end == 0) {
                if (node.end - place != m_null)
                    return false;
                break;
            }
            if (!copyNode(place, child, depth + 1))
                return false;
            place = child.end;
        }
        m_out.append(m_null, '\0');
    }
    setNumber(begin, m_out.size());
    return true;
}

void Repair::copyFooter(qsizetype offset)
{
    const QByteArrayView footer = m_in.sliced(offset);
    const qsizetype padding = footer.size() - kFooterId - kFooterEnd;
    if (padding < 1 || padding > 16) {
        m_out.append(footer);
        return;
    }
    m_out.append(footer.first(kFooterId));
    m_out.append(16 - m_out.size() % 16, '\0');
    m_out.append(footer.last(kFooterEnd));
}

bool Repair::run()
{
    m_out.reserve(m_in.size() + m_in.size() / 16);
    m_out.append(m_in.first(kHeader));
    qsizetype place = kHeader;
    for (;;) {
        Node node;
        if (!readNode(place, m_in.size(), node))
            return false;
        if (node.end == 0)
            break;
        if (!copyNode(place, node, 0))
            return false;
        place = node.end;
    }
    m_out.append(m_null, '\0');
    copyFooter(place + m_null);
    return m_field == 8 || m_out.size() <= std::numeric_limits<std::uint32_t>::max();
}

} // namespace

Result<QByteArray> repairFbx(QByteArrayView content)
{
    const QByteArrayView magic(kMagic, sizeof kMagic);
    if (content.size() >= kHeader && content.first(magic.size()) == magic) {
        const auto version = qFromLittleEndian<std::uint32_t>(content.data() + kVersionOffset);
        Repair repair(content, version >= kWideVersion);
        if (repair.run())
            return repair.takeResult();
    }
    return inputError({}, QCoreApplication::translate("FbxRepair", "this is no sound binary FBX file"));
}

} // namespace espalier
