// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxNodes.h"

#include <QIODevice>
#include <QtEndian>

#include <algorithm>
#include <limits>

namespace espalier {

namespace {

constexpr char kMagic[] = "Kaydara FBX Binary  "; // and its final zero
constexpr qsizetype kVersionOffset = 23;
constexpr qsizetype kHeader = 27;
constexpr std::uint32_t kWideVersion = 7500;
/// FBX files have five levels of nodes.
constexpr int kDeepest = 64;
/// The end of a file: an identification, zeros up to a multiple of 16 (at least one), then this many bytes
/// with the version.
constexpr qsizetype kFooterId = 16;
constexpr qsizetype kFooterEnd = 144;

qsizetype bytesOfField(bool wide)
{
    return wide ? 8 : 4;
}

/// Bytes of a record of zeros: that of a node without a name.
qsizetype bytesOfNull(bool wide)
{
    return 3 * bytesOfField(wide) + 1;
}

/// Bytes of the first property in @p bytes; 0 if it is not valid.
qsizetype propertySize(QByteArrayView bytes)
{
    if (bytes.isEmpty())
        return 0;
    const auto number = [&](qsizetype offset) {
        return static_cast<qsizetype>(qFromLittleEndian<std::uint32_t>(bytes.data() + offset));
    };
    qsizetype size = 0;
    switch (bytes.front()) {
    case 'C':
        size = 2;
        break;
    case 'Y':
        size = 3;
        break;
    case 'F':
    case 'I':
        size = 5;
        break;
    case 'D':
    case 'L':
        size = 9;
        break;
    case 'R':
    case 'S':
        size = bytes.size() < 5 ? 0 : 5 + number(1);
        break;
    case 'b':
    case 'd':
    case 'f':
    case 'i':
    case 'l': {
        // A count, an encoding, and the bytes of a packed array.
        if (bytes.size() < 13)
            return 0;
        const qsizetype element = bytes.front() == 'b'                           ? 1
                                  : bytes.front() == 'd' || bytes.front() == 'l' ? 8
                                                                                 : 4;
        size = 13 + (number(5) == 0 ? element * number(1) : number(9));
        break;
    }
    default:
        break;
    }
    return size <= bytes.size() ? size : 0;
}

class Reader {
public:
    Reader(QByteArrayView content, bool wide) : m_in(content), m_wide(wide) {}

    /// Reads the nodes from @p place on until a record of zeros, or until @p limit if @p mayEnd; false if
    /// they are not valid. @p place is then behind them.
    bool readList(qsizetype& place, qsizetype limit, bool mayEnd, std::vector<FbxNode>& nodes,
                  int depth) const;

private:
    qsizetype number(qsizetype offset) const;
    bool readNode(qsizetype offset, qsizetype end, qsizetype limit, FbxNode& node, int depth) const;
    static void readProperties(QByteArrayView bytes, qsizetype count, FbxNode& node);

    QByteArrayView m_in;
    bool m_wide;
};

qsizetype Reader::number(qsizetype offset) const
{
    if (!m_wide)
        return qFromLittleEndian<std::uint32_t>(m_in.data() + offset);
    // A number that is too large for an offset must not become negative.
    return static_cast<qsizetype>(std::min<std::uint64_t>(
        qFromLittleEndian<std::uint64_t>(m_in.data() + offset), std::numeric_limits<qsizetype>::max()));
}

bool Reader::readList(qsizetype& place, qsizetype limit, bool mayEnd, std::vector<FbxNode>& nodes,
                      int depth) const
{
    const qsizetype null = bytesOfNull(m_wide);
    while (place < limit || !mayEnd) {
        if (limit - place < null)
            return false;
        const qsizetype end = number(place);
        if (end == 0) {
            place += null;
            return true;
        }
        if (!readNode(place, end, limit, nodes.emplace_back(), depth))
            return false;
        place = end;
    }
    return true;
}

bool Reader::readNode(qsizetype offset, qsizetype end, qsizetype limit, FbxNode& node, int depth) const
{
    const qsizetype field = bytesOfField(m_wide);
    const qsizetype propertyBytes = number(offset + 2 * field);
    const qsizetype name = offset + bytesOfNull(m_wide);
    const qsizetype properties = name + static_cast<uchar>(m_in[offset + 3 * field]);
    if (end > limit || properties > end || propertyBytes > end - properties)
        return false;
    node.name = m_in.sliced(name, properties - name).toByteArray();
    readProperties(m_in.sliced(properties, propertyBytes), number(offset + field), node);
    qsizetype place = properties + propertyBytes;
    node.hasList = place < end;
    if (!node.hasList)
        return true;
    return depth < kDeepest && readList(place, end, true, node.children, depth + 1) && place == end;
}

void Reader::readProperties(QByteArrayView bytes, qsizetype count, FbxNode& node)
{
    const auto shared = [](QByteArrayView view) { return QByteArray::fromRawData(view.data(), view.size()); };
    node.opaque = shared(bytes);
    node.opaqueCount = count;
    std::vector<QByteArray> properties;
    while (!bytes.isEmpty()) {
        const qsizetype size = propertySize(bytes);
        if (size == 0)
            return;
        properties.push_back(shared(bytes.first(size)));
        bytes = bytes.sliced(size);
    }
    if (static_cast<qsizetype>(properties.size()) == count) {
        node.properties = std::move(properties);
        node.opaque.clear();
    }
}

/// Bytes of an array property before its elements.
constexpr qsizetype kArrayHeader = 13;

qsizetype bytesOfProperties(const FbxNode& node)
{
    qsizetype bytes = node.opaque.size();
    for (const QByteArray& property : node.properties)
        bytes += property.size();
    if (node.array)
        bytes += kArrayHeader + static_cast<qsizetype>(node.array->count * node.array->elementBytes);
    return bytes;
}

qsizetype bytesOf(const FbxNode& node, bool wide)
{
    qsizetype bytes = bytesOfNull(wide) + node.name.size() + bytesOfProperties(node);
    for (const FbxNode& child : node.children)
        bytes += bytesOf(child, wide);
    return node.hasList ? bytes + bytesOfNull(wide) : bytes;
}

class Writer {
public:
    Writer(bool wide, QIODevice& device) : m_wide(wide), m_device(device) {}

    bool write(const FbxDocument& document);

private:
    void put(const QByteArray& bytes) { m_isTaken = m_isTaken && m_device.write(bytes) == bytes.size(); }
    void putNode(const FbxNode& node);
    void putArray(const FbxArray& array);
    void putFooter(const QByteArray& footer);
    QByteArray number(qsizetype value) const;

    bool m_wide;
    QIODevice& m_device;
    qsizetype m_place = 0; ///< Where the next node begins
    bool m_isTaken = true;
};

bool Writer::write(const FbxDocument& document)
{
    put(document.header);
    m_place = document.header.size();
    for (const FbxNode& node : document.nodes)
        putNode(node);
    put(QByteArray(bytesOfNull(m_wide), '\0'));
    m_place += bytesOfNull(m_wide);
    putFooter(document.footer);
    return m_isTaken;
}

QByteArray Writer::number(qsizetype value) const
{
    QByteArray bytes(bytesOfField(m_wide), '\0');
    if (m_wide)
        qToLittleEndian(static_cast<std::uint64_t>(value), bytes.data());
    else
        qToLittleEndian(static_cast<std::uint32_t>(value), bytes.data());
    return bytes;
}

void Writer::putNode(const FbxNode& node)
{
    const qsizetype end = m_place + bytesOf(node, m_wide);
    const qsizetype count = node.array              ? 1
                            : node.opaque.isEmpty() ? static_cast<qsizetype>(node.properties.size())
                                                    : node.opaqueCount;
    put(number(end) + number(count) + number(bytesOfProperties(node)) +
        QByteArray(1, static_cast<char>(node.name.size())) + node.name + node.opaque);
    for (const QByteArray& property : node.properties)
        put(property);
    if (node.array)
        putArray(*node.array);
    m_place += bytesOfNull(m_wide) + node.name.size() + bytesOfProperties(node);
    for (const FbxNode& child : node.children)
        putNode(child);
    if (node.hasList)
        put(QByteArray(bytesOfNull(m_wide), '\0'));
    m_place = end;
}

void Writer::putArray(const FbxArray& array)
{
    QByteArray header(kArrayHeader, array.type);
    qToLittleEndian(static_cast<std::uint32_t>(array.count), header.data() + 1);
    qToLittleEndian(std::uint32_t{0}, header.data() + 5); // not packed
    qToLittleEndian(static_cast<std::uint32_t>(array.count * array.elementBytes), header.data() + 9);
    put(header);
    m_isTaken = m_isTaken && array.write(m_device);
}

void Writer::putFooter(const QByteArray& footer)
{
    const qsizetype padding = footer.size() - kFooterId - kFooterEnd;
    if (padding < 1 || padding > 16) {
        put(footer);
        return;
    }
    put(footer.first(kFooterId));
    put(QByteArray(16 - (m_place + kFooterId) % 16, '\0'));
    put(footer.last(kFooterEnd));
}

} // namespace

FbxNode* FbxNode::child(QByteArrayView childName)
{
    const auto found =
        std::ranges::find_if(children, [&](const FbxNode& node) { return node.name == childName; });
    return found == children.end() ? nullptr : &*found;
}

std::optional<QByteArray> fbxText(const QByteArray& property)
{
    if (property.size() < 5 || property.front() != 'S')
        return {};
    return property.sliced(5);
}

QByteArray fbxString(const QByteArray& text)
{
    QByteArray property(5, 'S');
    qToLittleEndian(static_cast<std::uint32_t>(text.size()), property.data() + 1);
    return property + text;
}

QByteArray fbxInteger(std::int32_t value)
{
    QByteArray property(5, 'I');
    qToLittleEndian(value, property.data() + 1);
    return property;
}

std::optional<FbxDocument> readFbx(QByteArrayView content)
{
    const QByteArrayView magic(kMagic, sizeof kMagic);
    if (content.size() < kHeader || content.first(magic.size()) != magic)
        return {};
    FbxDocument document;
    document.wide = qFromLittleEndian<std::uint32_t>(content.data() + kVersionOffset) >= kWideVersion;
    document.header = content.first(kHeader).toByteArray();
    qsizetype place = kHeader;
    if (!Reader(content, document.wide).readList(place, content.size(), false, document.nodes, 0))
        return {};
    document.footer = content.sliced(place).toByteArray();
    return document;
}

bool writeFbx(const FbxDocument& document, QIODevice& device)
{
    qsizetype bytes = document.header.size() + document.footer.size();
    for (const FbxNode& node : document.nodes)
        bytes += bytesOf(node, document.wide);
    if (!document.wide && bytes > std::numeric_limits<std::uint32_t>::max())
        return false;
    return Writer(document.wide, device).write(document);
}

} // namespace espalier
