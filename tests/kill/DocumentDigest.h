// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/DocumentProject.h"

#include <QCryptographicHash>
#include <QString>

namespace espalier::test {

/// A short text that nearly always differs for documents that differ: of the tree's tables, and of the
/// numbers of kept values, widths and deltas.
inline QString digestOf(const Project& project)
{
    QCryptographicHash hash(QCryptographicHash::Md5);
    const auto add = [&hash](const auto* data, qsizetype count) {
        hash.addData(QByteArrayView(reinterpret_cast<const char*>(data),
                                    count * static_cast<qsizetype>(sizeof *data)));
    };
    const TreeContent& content = project.tree.content();
    const auto addColumn = [&add](const auto&, const auto& column) {
        add(column.constData(), column.size());
    };
    InternodeTable::visit(addColumn, content.internodes);
    LeafTable::visit(addColumn, content.leaves);
    const std::uint64_t numbers[] = {content.seed,
                                     content.step,
                                     content.currentParameters,
                                     static_cast<std::uint64_t>(content.kept.parameters.size()),
                                     static_cast<std::uint64_t>(content.kept.lassos.size()),
                                     content.lassosInForce.size(),
                                     content.sparse.width.cells().size(),
                                     project.journal.size(),
                                     project.ahead};
    add(numbers, static_cast<qsizetype>(std::size(numbers)));
    return QString::fromLatin1(hash.result().toHex());
}

} // namespace espalier::test
