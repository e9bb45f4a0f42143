// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace espalier::test {

/// A disk that becomes faulty: while this object lives, the calls that change files below a folder (write,
/// fsync, rename, link) are counted, and all but the first ones fail. It replaces the system's functions in
/// the whole test program, so that Qt's writes fail as well. Only one object can exist at a time.
class FaultyDisk {
public:
    static constexpr int kNever = -1;

    /// @p goodCalls: how many calls succeed before all others fail with @p error (errno); kNever for a good
    /// disk, which only counts.
    FaultyDisk(const QString& folder, int goodCalls, int error);
    /// One call fails, after @p once.good good ones, and all after it succeed.
    struct Once {
        int good;
    };
    FaultyDisk(const QString& folder, Once once, int error);
    struct Renames {
        int good;
        bool hasLinks = true; ///< Whether files can have second names
    };
    /// The rename after @p renames.good good ones fails, and nothing else.
    FaultyDisk(const QString& folder, Renames renames, int error);
    /// When, during a call, the process is killed. HalfWay: half of the bytes are written; for calls other
    /// than write the same as After.
    enum class Moment { Before, HalfWay, After };
    struct Death {
        int call; ///< From 0; kNever if only the calls are noted
        Moment moment;
    };
    /// The process is killed (SIGKILL) at a call. More calls count here: all that could change what a folder
    /// or a file holds, see trace().
    FaultyDisk(const QString& folder, Death death);
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// How many calls there were so far.
    int calls() const;
    /// How many of them came before the first one that gives a file its name.
    int callsBeforeNaming() const;
    /// With Death: the calls so far in their order, a letter for each one. o: a file is made, w: write, s:
    /// fsync and fdatasync, m: the permissions are set, t: a file is truncated, l: a file gets a name, r:
    /// rename, u: unlink, c: a file that was written to is closed.
    QByteArray trace() const;
};

} // namespace espalier::test
