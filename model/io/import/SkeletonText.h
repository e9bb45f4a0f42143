// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates the messages about skeletons.
struct SkeletonText {
    Q_DECLARE_TR_FUNCTIONS(Skeleton)
};

} // namespace espalier
