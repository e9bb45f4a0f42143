// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

#include <QFile>

namespace espalier::test {

/// A recipe in a file, to which operations are added one by one. The file is a complete recipe at any moment,
/// so that the operations before a crash can be played.
class RecipeLog {
public:
    /// Replaces the file.
    RecipeLog(const QString& fileName, const Recipe& beginning);

    /// Whether all has been written so far.
    bool isGood() const { return m_isGood; }
    QString fileName() const { return m_file.fileName(); }
    bool add(const RecipeOperation& operation);
    void remove() { m_file.remove(); }

private:
    void write(const QByteArray& text);

    QFile m_file;
    RecipeWriting m_writing;
    QByteArray m_rest; ///< What follows the operations
    qint64 m_end = 0;  ///< End of the operations
    bool m_isFirst = true;
    bool m_isGood = false;
};

} // namespace espalier::test
