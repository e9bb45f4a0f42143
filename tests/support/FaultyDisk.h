// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// How many calls there were so far.
    int calls() const;
    /// How many of them came before the first one that gives a file its name.
    int callsBeforeNaming() const;
};

} // namespace espalier::test
