// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

/// The program's log: when it began and ended, which OpenGL it found, what Qt warned of. It has nothing of
/// what is in a document. Several running programs may write into it.
class Log {
public:
    /// Where the platform expects it: $XDG_STATE_HOME/espalier, by default ~/.local/state/espalier.
    static QString folder();
    static QString fileName();

    /// Begins to write, and to write down Qt's warnings. A full log becomes espalier.1.log, that one
    /// espalier.2.log; older ones go.
    static void open();
    /// Ends that.
    static void close();
    /// Adds a line, with the time. Does nothing unless the log is open. Can be called on any thread.
    static void note(const QString& line);
    /// The last lines, of all that was written, up to @p bytes.
    static QString tail(qsizetype bytes);

    /// Writes a fault of the program into the log, with the way that led there, and tells it on the standard
    /// error with @p advice, before the program ends as it would.
    static void catchCrashes(const QString& advice);
};

} // namespace espalier
