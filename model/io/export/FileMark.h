// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace espalier {

/// The mark that an export leaves in the files beside the exported model, so that a later export of the same
/// model may replace them, and nothing else may be replaced. It holds the SHA-256 of the model's file name
/// and the content: a file that was changed since does not have a valid mark any more.
///
/// In a PNG the mark is a text chunk after the header; in any other file it is a comment in the first line,
/// which begins with #.

/// Returns @p content with the mark of the model in the file @p owner (name without folder).
QByteArray marked(const QByteArray& content, const QString& owner);

/// Whether @p content is, byte for byte, something that marked() returned for this owner.
bool isMarked(const QByteArray& content, const QString& owner);

} // namespace espalier
