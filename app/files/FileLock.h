// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>

namespace espalier {

/// A lock on a file, which the system's kernel holds for this process and frees when the process ends,
/// however it ends. So it says whether the process that took it lives, also where process numbers say
/// nothing: in containers, or after a restart of the machine.
class FileLock {
public:
    /// Takes the lock; the file is made if it is not there. Null if another process, or another FileLock of
    /// this one, holds it, or if the file cannot be made.
    static std::shared_ptr<FileLock> taken(const QString& fileName);
    /// Gives the lock back; the file stays.
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    explicit FileLock(int descriptor) : m_descriptor(descriptor) {}

    int m_descriptor;
};

} // namespace espalier
